// SPDX-License-Identifier: MIT
// The flips that recover a boundary: an edge is removed, or a face, so that crossings become fewer.
#pragma once

#include "recovery/edge_ring.hpp"
#include "recovery/plane_center.hpp"
#include "recovery/ring_filling.hpp"
#include "solid/pair_table.hpp"

namespace mgdt {

class Flips {
  public:
    // `kept` has the edges that are never removed: those of the boundary.
    Flips(FlipMesh& mesh, const PairTable& kept, Allocator& allocator)
        : mesh_(mesh),
          kept_(kept),
          levels_{Level(allocator), Level(allocator), Level(allocator)},
          filling_(mesh, allocator),
          part_(allocator),
          center_(allocator),
          added_(allocator),
          removed_(allocator),
          failed_(allocator) {}

    static constexpr unsigned most_depth = 2;

    // How many rings may be looked at before edges are no longer removed.
    void set_budget(std::size_t rings) noexcept { budget_ = rings; }
    // How many of them are left.
    std::size_t budget() const noexcept { return budget_; }

    // Removes the edge between p and q if the number of crossings then changes by at most `limit`.
    // The tetrahedra around the edge are replaced as RingFilling says. Where that is impossible,
    // and `depth` is above 0, an edge that joins p or q with the ring is removed first. Returns
    // whether the edge has gone, and adds the change to `change`.
    bool remove_edge(std::uint32_t p, std::uint32_t q, const Crossings& crossings, int limit,
                     unsigned depth, int& change);

    // Replaces the two tetrahedra at a face by three around a new edge, if these are positive and
    // the number of crossings then changes by at most `limit`.
    bool remove_face(std::uint32_t code, const Crossings& crossings, int limit, int& change);

    // Replaces the edge between p and q by one between two vertices of its ring, if these four are
    // the corners of a convex quadrilateral in a plane, and the number of crossings then changes by
    // at most `limit`. A side of the plane that has no filling receives a point in its inside.
    bool turn_edge(std::uint32_t p, std::uint32_t q, const Crossings& crossings, int limit);

    bool is_kept(std::uint32_t p, std::uint32_t q) const noexcept {
        return kept_.find(p, q) != no_index;
    }

  private:
    // The filling of a ring takes time that grows with the cube of its size.
    static constexpr std::size_t most_ring = 40;

    // Working memory of a depth of remove_edge().
    struct Level {
        explicit Level(Allocator& allocator) : ring(allocator), spokes(allocator) {}
        EdgeRing ring;
        Buffer<std::uint32_t> spokes;
    };

    // Remembers that a ring has no filling with `most` crossings or fewer.
    struct Failure {
        std::uint64_t ring;  // a hash of the ring and of what is missing
        int most;
    };
    static constexpr std::size_t failures = 1 << 13;

    int crossings_of(const EdgeRing& ring, const Crossings& crossings) const;
    bool find_filling(const EdgeRing& ring, const Crossings& crossings, int most);
    bool fill_side(const EdgeRing& ring, std::size_t from, std::size_t to,
                   const Crossings& crossings, int& count);
    bool add_point_beside(const EdgeRing& ring, const Crossings& crossings, int& count);

    FlipMesh& mesh_;
    const PairTable& kept_;
    Level levels_[most_depth + 1];
    RingFilling filling_;
    Buffer<std::uint32_t> part_;  // the vertices of a part of a ring
    PlaneCenter center_;
    Buffer<FlipMesh::Corners> added_;
    Buffer<std::uint32_t> removed_;
    std::size_t budget_ = 0;
    Buffer<Failure> failed_;  // by the lowest bits of the hash
};

}  // namespace mgdt
