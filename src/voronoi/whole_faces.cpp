// SPDX-License-Identifier: MIT
#include "voronoi/whole_faces.hpp"

#include <algorithm>
#include <functional>
#include <limits>

#include "platform/objects.hpp"
#include "query/edge_lists.hpp"
#include "voronoi/ring.hpp"

namespace mgdt {

namespace {

constexpr std::size_t rings_at_once = 8;

// The tetrahedra around an edge.
struct Ring {
    explicit Ring(Allocator& allocator) : steps(allocator) {}
    VertexId a, b;  // the ends of the edge, the first one with the lesser index
    bool is_complete;
    Buffer<RingStep> steps;
};

}  // namespace

// The search of one thread.
class WholeFaces::Finder {
  public:
    Finder(const WholeFaces& of, FoundFaces& found)
        : mesh_(of.view_.mesh),
          indices_(of.indices_),
          centers_(of.centers_),
          found_(found),
          rings_(of.view_.allocator, rings_at_once, std::ref(of.view_.allocator)),
          corners_(of.view_.allocator),
          points_(of.view_.allocator),
          half_spaces_(of.view_.allocator) {}

    // Adds the face of an edge, now or in a later call.
    void add(TetId t, unsigned i, unsigned j);
    // Adds the faces that have not been added yet.
    void finish();

  private:
    void gather_rings();
    bool turn(Ring& ring) const;
    void set_corners(const Ring& ring);
    void add_face(Ring& ring);
    FaceMeasure measure(const Ring& ring, const FacePlane& plane);

    const Mesh& mesh_;
    const VertexIndices& indices_;
    const Circumcenters& centers_;
    FoundFaces& found_;
    Objects<Ring> rings_;
    std::size_t count_ = 0;  // of the rings in use
    Buffer<std::uint32_t> corners_;
    Buffer<const SplitPoint*> points_;
    HalfSpaces half_spaces_;
};

// Each step around an edge waits for a tetrahedron from memory, so several rings are gathered at
// the same time. To count each edge once, a ring is kept only if it was started from the least of
// its slots.
void WholeFaces::Finder::gather_rings() {
    Ring* active[rings_at_once];
    std::size_t left = count_;
    for (std::size_t r = 0; r < left; ++r) active[r] = &rings_[r];
    while (left > 0)
        for (std::size_t r = 0; r < left;) {
            Ring& ring = *active[r];
            const TetId first = ring.steps[0].t;
            const RingStep next = ring.steps.back().next(mesh_);
            if (next.t > first) {
                centers_.prefetch(next.t);
                ring.steps.push_back(next);
                ++r;
                continue;
            }
            ring.is_complete = next.t == first;
            active[r] = active[--left];
        }
}

// Turns the ring so that its beginning does not depend on the order of the slots: behind the vertex
// at infinity if the edge is on the hull, otherwise behind the vertex with the least index. Returns
// whether the face is bounded.
bool WholeFaces::Finder::turn(Ring& ring) const {
    Buffer<RingStep>& steps = ring.steps;
    std::size_t least = 0;
    const auto rank = [&](const RingStep& step) {
        const VertexId v = mesh_.tetrahedra[step.t].v[step.k];
        return v == infinite_vertex ? 0 : std::uint64_t{indices_[v]} + 1;
    };
    std::uint64_t of_least = rank(steps[0]);
    for (std::size_t i = 1; i < steps.size(); ++i)
        if (const std::uint64_t of_i = rank(steps[i]); of_i < of_least) {
            of_least = of_i;
            least = i;
        }
    const bool is_bounded = of_least != 0;
    std::rotate(steps.begin(), steps.begin() + least + (is_bounded ? 0 : 1), steps.end());
    return is_bounded;
}

// Of several consecutive tetrahedra with the same circumcentre, only the first one gives a corner.
void WholeFaces::Finder::set_corners(const Ring& ring) {
    corners_.clear();
    std::uint32_t before = no_tetrahedron, first = no_tetrahedron;
    for (const RingStep& step : ring.steps) {
        const std::uint32_t of_step = centers_.first_equal(step.t);
        if (of_step == before) continue;
        if (corners_.empty()) first = of_step;
        before = of_step;
        corners_.push_back(step.t);
    }
    if (corners_.size() > 1 && before == first) corners_.resize(corners_.size() - 1);
}

FaceMeasure WholeFaces::Finder::measure(const Ring& ring, const FacePlane& plane) {
    points_.clear();
    for (const std::uint32_t slot : corners_) points_.push_back(&centers_[slot]);
    const double* const a = mesh_.point(ring.a);
    return measure_accurately(
        half_spaces_, a, plane, points_, 1 / centers_.factor(), mesh_.scale, [&] {
            half_spaces_.add_nearer_side(mesh_.point(ring.b));
            for (const RingStep& step : ring.steps)
                half_spaces_.add_nearer_side(mesh_.point(mesh_.tetrahedra[step.t].v[step.l]));
            return ring.steps.size();
        });
}

void WholeFaces::Finder::add(TetId t, unsigned i, unsigned j) {
    const Tetrahedron& first = mesh_.tetrahedra[t];
    if (indices_[first.v[i]] > indices_[first.v[j]]) std::swap(i, j);
    Ring& ring = rings_[count_++];
    ring.a = first.v[i];
    ring.b = first.v[j];
    ring.steps.clear();
    ring.steps.push_back(RingStep::first(t, i, j));
    if (count_ == rings_.size()) finish();
}

void WholeFaces::Finder::finish() {
    gather_rings();
    for (std::size_t r = 0; r < count_; ++r)
        if (rings_[r].is_complete) add_face(rings_[r]);
    count_ = 0;
}

void WholeFaces::Finder::add_face(Ring& ring) {
    const bool is_bounded = turn(ring);
    set_corners(ring);
    if (corners_.size() < 3) return;
    const FacePlane plane = bisector(mesh_.point(ring.a), mesh_.point(ring.b));
    FoundFace face;
    face.sides[0] = indices_[ring.a];
    face.sides[1] = indices_[ring.b];
    face.set_corners(found_.corners.size(), corners_.size());
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr Vector<double> nowhere = {{infinite, infinite, infinite}};
    face.set_measure(is_bounded ? measure(ring, plane)
                                : FaceMeasure{infinite, infinite, nowhere, infinite, infinite,
                                              infinite, nowhere},
                     plane);
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
                             progress_.step(id, begin, end, member);
                             const Tetrahedron& t = mesh.tetrahedra[id];
                             mesh.tetrahedra.prefetch(id + ahead);
                             if (id + ahead / 4 < end)
                                 for (const FacetCode code : mesh.tetrahedra[id + ahead / 4].n)
                                     mesh.tetrahedra.prefetch(tetrahedron_of(code));
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
                         finder.finish();
                     });
}

}  // namespace mgdt
