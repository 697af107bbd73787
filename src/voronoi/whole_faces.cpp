// SPDX-License-Identifier: MIT
#include "voronoi/whole_faces.hpp"

#include <algorithm>
#include <limits>

#include "query/edge_lists.hpp"
#include "voronoi/ring.hpp"

namespace mgdt {

// What one thread needs.
class WholeFaces::Finder {
  public:
    Finder(const WholeFaces& of, FoundFaces& found)
        : mesh_(of.view_.mesh),
          indices_(of.indices_),
          centers_(of.centers_),
          found_(found),
          ring_(of.view_.allocator),
          corners_(of.view_.allocator),
          points_(of.view_.allocator),
          half_spaces_(of.view_.allocator) {}

    void add(TetId t, unsigned i, unsigned j);

  private:
    bool gather_ring(TetId t, unsigned i, unsigned j);
    void turn_ring();
    void set_corners();
    FaceMeasure measure(const FacePlane& plane);

    const Mesh& mesh_;
    const VertexIndices& indices_;
    const Circumcenters& centers_;
    FoundFaces& found_;
    VertexId a_ = 0, b_ = 0;  // the ends of the edge, the first one with the lesser index
    bool is_bounded_ = true;
    Buffer<RingStep> ring_;
    Buffer<std::uint32_t> corners_;
    Buffer<const SplitPoint*> points_;
    HalfSpaces half_spaces_;
};

// Gathers the tetrahedra around an edge. Returns false if t is not in the first of their slots, so
// that each edge counts once.
bool WholeFaces::Finder::gather_ring(TetId t, unsigned i, unsigned j) {
    ring_.clear();
    RingStep step = RingStep::first(t, i, j);
    do {
        ring_.push_back(step);
        centers_.prefetch(step.t);
        step = step.next(mesh_);
        if (step.t < t) return false;
    } while (step.t != t);
    return true;
}

// Turns the ring so that its beginning does not depend on the order of the slots: behind the vertex
// at infinity if the edge is on the hull, otherwise behind the vertex with the least index.
void WholeFaces::Finder::turn_ring() {
    std::size_t least = 0;
    const auto rank = [&](const RingStep& step) {
        const VertexId v = mesh_.tetrahedra[step.t].v[step.k];
        return v == infinite_vertex ? 0 : std::uint64_t{indices_[v]} + 1;
    };
    std::uint64_t of_least = rank(ring_[0]);
    for (std::size_t i = 1; i < ring_.size(); ++i)
        if (const std::uint64_t of_i = rank(ring_[i]); of_i < of_least) {
            of_least = of_i;
            least = i;
        }
    is_bounded_ = of_least != 0;
    std::rotate(ring_.begin(), ring_.begin() + least + (is_bounded_ ? 0 : 1), ring_.end());
}

// Of several consecutive tetrahedra with the same circumcentre, only the first one gives a corner.
void WholeFaces::Finder::set_corners() {
    corners_.clear();
    std::uint32_t before = no_tetrahedron, first = no_tetrahedron;
    for (const RingStep& step : ring_) {
        const std::uint32_t of_step = centers_.first_equal(step.t);
        if (of_step == before) continue;
        if (corners_.empty()) first = of_step;
        before = of_step;
        corners_.push_back(step.t);
    }
    if (corners_.size() > 1 && before == first) corners_.resize(corners_.size() - 1);
}

FaceMeasure WholeFaces::Finder::measure(const FacePlane& plane) {
    if (!is_bounded_) {
        constexpr double infinite = std::numeric_limits<double>::infinity();
        return {infinite, infinite, {{infinite, infinite, infinite}}, infinite};
    }
    points_.clear();
    for (const std::uint32_t slot : corners_) points_.push_back(&centers_[slot]);
    const double* const a = mesh_.point(a_);
    return measure_accurately(half_spaces_, a, plane, points_, 1 / centers_.factor(), [&] {
        half_spaces_.add_nearer_side(mesh_.point(b_));
        for (const RingStep& step : ring_)
            half_spaces_.add_nearer_side(mesh_.point(mesh_.tetrahedra[step.t].v[step.l]));
        return ring_.size();
    });
}

void WholeFaces::Finder::add(TetId t, unsigned i, unsigned j) {
    const Tetrahedron& first = mesh_.tetrahedra[t];
    if (indices_[first.v[i]] > indices_[first.v[j]]) std::swap(i, j);
    a_ = first.v[i];
    b_ = first.v[j];
    if (!gather_ring(t, i, j)) return;
    turn_ring();
    set_corners();
    if (corners_.size() < 3) return;
    const FacePlane plane = bisector(mesh_.point(a_), mesh_.point(b_));
    FoundFace face;
    face.sides[0] = indices_[a_];
    face.sides[1] = indices_[b_];
    face.set_corners(found_.corners.size(), corners_.size());
    face.set_measure(measure(plane), plane);
    found_.faces.push_back(face);
    for (const std::uint32_t slot : corners_)
        found_.corners.push_back(mesh_.tetrahedra[slot].is_ghost() ? slot | ghost_corner
                                                                   : centers_.first_equal(slot));
}

void WholeFaces::find(PerMember<FoundFaces>& found) {
    const Mesh& mesh = view_.mesh;
    constexpr std::size_t slots_per_thread = 4096, ahead = 16;
    view_.team.split(mesh.tetrahedra.size(), slots_per_thread,
                     [&](std::size_t begin, std::size_t end, unsigned member) {
                         Finder finder(*this, found[member]);
                         found[member].make_room(end - begin);
                         for (std::size_t id = begin; id < end; ++id) {
                             stop_.poll_in_step(id);
                             const Tetrahedron& t = mesh.tetrahedra[id];
                             mesh.tetrahedra.prefetch(id + ahead);
                             unsigned left = owned_edges(t, static_cast<TetId>(id));
                             for (; left != 0; left &= left - 1) {
                                 const unsigned char* const at = edge_ends[lowest_bit(left)];
                                 const auto cut = [&](unsigned i) {
                                     return is_cut_[t.v[i]].load(std::memory_order_relaxed) != 0;
                                 };
                                 if (!cut(at[0]) || !cut(at[1]))
                                     finder.add(static_cast<TetId>(id), at[0], at[1]);
                             }
                         }
                     });
}

}  // namespace mgdt
