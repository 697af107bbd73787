// SPDX-License-Identifier: MIT
// Zones in which threads insert without a look at each other.
//
// Each round of a schedule goes along one curve through all of the batch's space, so the same share
// of every round lies in the same place: a vertex's zone is found from its number. A tetrahedron
// with vertices of two zones is between them. While threads insert in zones it is closed: it stays,
// and a point that would remove it is put off. All other tetrahedra are of one zone, and so are
// those of their neighbours that are not closed, since two neighbours have three vertices in
// common. The vertex at infinity is in every zone. So what a thread changes is its own, but for the
// link of a closed tetrahedron through a facet of the zone, which is the zone's alone.
//
// The sphere of a closed tetrahedron leaves every test open (KeptSphere::close). So threads have
// nothing to ask about the tetrahedra that they come to: the filter that every insertion has tells
// the closed ones from the others.
#pragma once

#include "mesh/mesh.hpp"
#include "order/schedule.hpp"
#include "parallel/per_member.hpp"
#include "parallel/team.hpp"

namespace mgdt {

// The number of a mesh's first finite vertex.
inline constexpr VertexId first_vertex = infinite_vertex + 1;

class Zones {
  public:
    // For a batch of `n` points that are the mesh's first.
    Zones(Team& team, Allocator& allocator, const Schedule& schedule, std::size_t n);
    Zones(const Zones&) = delete;
    Zones& operator=(const Zones&) = delete;

    // A round of the schedule by its positions, and where the round before begins; where there is
    // none, or some of the round is in, that is `begin`.
    struct Round {
        std::size_t begin, end, before;
        std::size_t size() const noexcept { return end - begin; }
    };
    // Divides space into `count` zones, at most 254, before the round is inserted. Throws
    // std::bad_alloc.
    void divide(unsigned count, const Round& round, const Mesh& mesh);
    unsigned of(VertexId v) const noexcept { return zone_[v]; }
    // The first position of the round in a zone; its end for the number of zones.
    std::size_t first(const Round& round, unsigned zone) const noexcept {
        return round.begin + Team::part(round.size(), zone, count_);
    }
    // Whether the point at a position of the round is likely to remove a tetrahedron between zones:
    // whether there was one at a vertex of the round before that is near.
    bool is_at_border(std::size_t k) const noexcept {
        const auto offset = static_cast<std::size_t>(static_cast<double>(k - begin_) * share_);
        return at_border_[offset + 1] != 0;
    }

    // Closes what is between zones now. Throws std::bad_alloc, with nothing closed.
    void close(Mesh& mesh);
    void open(Mesh& mesh) noexcept;
    // Gives the memory back that all this takes.
    void forget() noexcept;

  private:
    struct Closed {
        TetId tetrahedron;
        std::uint32_t bound;  // that of its sphere
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
    unsigned count_ = 0;              // of zones, if they are divided
    Buffer<std::uint8_t> zone_;       // by vertex
    Buffer<std::uint8_t> at_border_;  // by vertex of the round before
    PerMember<Part> between_;         // zones, as each member of the team found it
    std::size_t begin_ = 0;           // of the round
    double share_ = 0;                // the round before, of the round
};

}  // namespace mgdt
