// SPDX-License-Identifier: MIT
// Zones: regions in which threads insert without synchronisation.
//
// Every round of a schedule follows the same curve through space. The points at the same fraction
// of each round lie in the same region, so the zone of a vertex follows from its number. A
// tetrahedron with vertices of two zones is *between* zones. While threads insert in zones, such
// tetrahedra are *closed*: they are not removed, and a point that would remove one is deferred.
// Every other tetrahedron has the vertices of one zone. Two adjacent tetrahedra share three
// vertices, so neighbours that are not closed belong to the same zone. The vertex at infinity
// counts as a vertex of every zone. Hence a thread writes only to tetrahedra of its zone, and to
// the neighbour entries of closed tetrahedra at facets of its zone, which no other thread touches.
//
// The sphere of a closed tetrahedron is changed so that the conflict filter leaves every test
// undecided (KeptSphere::close). The kernel handles undecided tests anyway, so recognising closed
// tetrahedra costs nothing.
#pragma once

#include <cassert>

#include "mesh/mesh.hpp"
#include "order/schedule.hpp"
#include "parallel/per_member.hpp"
#include "parallel/team.hpp"

namespace mgdt {

// The number of a mesh's first finite vertex.
inline constexpr VertexId first_vertex = infinite_vertex + 1;

class Zones {
  public:
    // Zones for a batch of `n` points, which are the first finite vertices of the mesh.
    Zones(Team& team, Allocator& allocator, const Schedule& schedule, std::size_t n);
    Zones(const Zones&) = delete;
    Zones& operator=(const Zones&) = delete;

    // The positions of a round in the schedule. `before` is where the previous round begins; it
    // equals `begin` if there is no previous round, or if a part of this round is inserted already.
    struct Round {
        std::size_t begin, end, before;
        std::size_t size() const noexcept { return end - begin; }
    };
    // Divides space into `count` zones, at most 254, and finds the border for the round, which is
    // not inserted yet. Throws std::bad_alloc.
    void divide(unsigned count, const Round& round, const Mesh& mesh);
    unsigned of(VertexId v) const noexcept {
        assert(count_ > 0 && "space is not divided");
        return zone_[v];
    }
    // The first position of the round in a zone. For `zone` == count, the end of the round.
    std::size_t first(const Round& round, unsigned zone) const noexcept {
        assert(zone <= count_ && "there is no such zone");
        return round.begin + Team::part(round.size(), zone, count_);
    }
    // Whether the point at position k is likely to remove a tetrahedron between zones. It is if a
    // nearby vertex of the previous round had such a tetrahedron.
    bool is_at_border(std::size_t k) const noexcept {
        assert(k >= begin_ && "a position of an earlier round");
        const auto offset = static_cast<std::size_t>(static_cast<double>(k - begin_) * share_);
        return at_border_[offset + 1] != 0;
    }

    // Closes the tetrahedra that are between zones now. Throws std::bad_alloc, with none closed.
    void close(Mesh& mesh);
    // Opens the tetrahedra that close() has closed.
    void open(Mesh& mesh) noexcept;
    // Frees the memory of the zones.
    void forget() noexcept;

  private:
    struct Closed {
        TetId tetrahedron;
        std::uint32_t bound;  // the error bound of its sphere, which close() overwrites
    };
    struct Part {
        explicit Part(Allocator* allocator) : closed(*allocator) {}
        Buffer<Closed> closed;
    };
    void find_between(const Mesh& mesh);
    bool is_between(const Tetrahedron& t) const noexcept;

    Team& team_;
    const Buffer<std::uint32_t>& rounds_;
    const std::size_t n_;
    unsigned count_ = 0;              // the number of zones; 0 before divide()
    Buffer<std::uint8_t> zone_;       // the zone of each vertex
    Buffer<std::uint8_t> at_border_;  // per vertex of the previous round; one more at each end
    PerMember<Part> between_;         // the tetrahedra between zones, by the thread that found them
    std::size_t begin_ = 0;           // the first position of the round
    double share_ = 0;                // the size of the previous round over that of the round
};

}  // namespace mgdt
