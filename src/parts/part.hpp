// SPDX-License-Identifier: MIT
// One part: its own points, some points of other parts, and the triangulation of all these points.
// When the part has received the points that it needs, the tetrahedra at its own points are the
// tetrahedra of the triangulation of all parts' points (docs/theory.md, "Parts").
#pragma once

#include <optional>

#include "core/triangulation.hpp"
#include "parts/boxes.hpp"
#include "parts/part_point.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

// Lexicographic order.
inline bool precedes(const double* a, const double* b) {
    return a[0] != b[0] ? a[0] < b[0] : a[1] != b[1] ? a[1] < b[1] : a[2] < b[2];
}

class Part {
  public:
    Part(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user)
        : allocator_(alloc, release, user), points_(allocator_), known_(allocator_) {
        forget_triangulation();
    }

    // Takes the part's own points, whose vertices get the numbers from `first` on. This call comes
    // before insert().
    void begin(PartId self, std::int64_t first, const PartPoint* own, std::size_t n);
    // Inserts points of other parts; some of these points may be known already. The progress of
    // the insertion is share i of `shares` of the current stage.
    void insert(const PartPoint* points, std::size_t n, StageProgress& progress, std::size_t i,
                std::size_t shares);
    // Frees the triangulation. The next insertion triangulates all points again.
    void forget_triangulation() {
        const std::int32_t threads = triangulation_ ? settings().threads : 1;
        triangulation_.emplace(allocator_.allocate_function(), allocator_.release_function(),
                               allocator_.user());
        settings().threads = threads;
    }
    // Finds the own points of this part that each other part needs, and writes the points to `out`.
    void push(const Boxes& boxes, PartId parts, Mail& out);

    // Calls visit(t, v, own, is_owned) for each tetrahedron with at least one of this part's own
    // points as a vertex. v has the indices of the four vertices in points(), `own` is the number
    // of own points among the vertices, and is_owned says whether this part owns the tetrahedron.
    // The owner of a tetrahedron is the home of its lexicographically least vertex.
    template <class Visit>
    void each_tetrahedron(const Visit& visit) const {
        const Mesh& mesh = triangulation().mesh();
        for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
            if (mesh.tetrahedra[t].is_dead() || mesh.tetrahedra[t].is_ghost()) continue;
            std::uint32_t v[4];
            const unsigned own = corners(t, v);
            if (own > 0) visit(t, v, own, owns(v, own));
        }
    }
    // Whether slot t has a tetrahedron that the part owns.
    bool owns(TetId t) const {
        const Tetrahedron& tetrahedron = triangulation().mesh().tetrahedra[t];
        if (tetrahedron.is_dead() || tetrahedron.is_ghost()) return false;
        std::uint32_t v[4];
        const unsigned own = corners(t, v);
        return own > 0 && owns(v, own);
    }
    const PartPoint& point(std::uint32_t i) const { return points_[i]; }
    // The points of the part, own points first.
    const PartPoint* points() const { return points_.data(); }
    std::size_t own_count() const { return own_; }
    std::size_t point_count() const { return points_.size(); }
    const Triangulation& triangulation() const { return *triangulation_; }
    Settings& settings() { return triangulation_->settings(); }
    // The memory that the part holds.
    std::size_t bytes() const { return allocator_.bytes() + triangulation().allocator().bytes(); }

  private:
    struct OwnVertices {
        std::uint32_t index[4];
        unsigned count;
    };
    // Calls visit(t, own, sphere) for each finite tetrahedron that has own vertices and a
    // circumball that is not within the box of the part. Calls visit_ghost(t, own) for each ghost
    // that has own vertices.
    template <class Visit, class VisitGhost>
    void each_at_border(const Visit& visit, const VisitGhost& visit_ghost) const;
    // Sets v to the indices of the corners of t in points(). Returns the number of own corners.
    unsigned corners(TetId t, std::uint32_t (&v)[4]) const {
        const Mesh& mesh = triangulation().mesh();
        unsigned own = 0;
        for (int i = 0; i < 4; ++i) {
            v[i] = mesh.vertices[mesh.tetrahedra[t].v[i]].index;
            own += v[i] < own_ ? 1 : 0;
        }
        return own;
    }
    bool owns(const std::uint32_t (&v)[4], unsigned own) const {
        return own == 4 || least_of(v) < own_;
    }
    std::uint32_t least_of(const std::uint32_t (&v)[4]) const;

    Allocator allocator_;
    PartId self_ = 0;
    std::optional<Triangulation> triangulation_;
    Buffer<PartPoint> points_;    // in the order of the triangulation's indices; own points first
    Buffer<std::int64_t> known_;  // the numbers of the other points, sorted
    std::size_t own_ = 0;
    BoundingBox box_ = BoundingBox::empty();
};

}  // namespace mgdt
