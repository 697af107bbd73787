// SPDX-License-Identifier: MIT
#include "query/segment_walk.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>

#include "predicates/predicates.hpp"
#include "predicates/segment.hpp"
#include "query/star.hpp"

namespace mgdt {
namespace {

constexpr unsigned no_face = 4;

// A vertex, with its coordinates in the caller's scale.
struct Corner {
    VertexId v;
    double x[3];
};

// The line through a and b, displaced by an infinitesimal vector: by e (d0 - a) + e^2 (d1 - a) +
// e^3 (d2 - a) + e^4 (d3 - a), where d0, d1, d2 and d3 are the vertices of a tetrahedron near a.
class DisplacedLine {
  public:
    DisplacedLine(const Locator& where, const double* a, const double* b, Allocator& allocator)
        : where_(where), a_(a), b_(b), allocator_(allocator) {}

    // The sign of orientation(a, b, p, q) for the displaced line; 0 only if the line is parallel to
    // the edge pq. If the line itself meets the line of the edge, the result is -2, 0 or 2.
    int side(const Corner& p, const Corner& q) {
        const int known = orientation(a_, b_, p.x, q.x);
        return known != 0 ? known : 2 * side_of_displacement(p, q);
    }

  private:
    MGDT_NOT_INLINE int side_of_displacement(const Corner& p, const Corner& q) {
        if (!has_directions_) set_directions();
        for (const auto& d : directions_)
            if (const int side = change_of_orientation(a_, b_, d, p.x, q.x)) return side;
        return 0;
    }
    // Chooses, of the tetrahedra at the vertex nearest to a, the one with the least indices: a
    // choice that depends on the points alone.
    void set_directions();

    const Locator& where_;
    const double *const a_, *const b_;
    Allocator& allocator_;
    bool has_directions_ = false;
    double directions_[4][3];
};

void DisplacedLine::set_directions() {
    const Mesh& mesh = where_.mesh;
    const VertexId nearest = where_.nearest_vertex(a_, allocator_);
    VertexId best[4];
    std::uint32_t least[4] = {no_index, no_index, no_index, no_index};
    VisitQueue star(allocator_);
    gather_star(where_, nearest, star);
    for (std::size_t i = 0; i < star.size(); ++i) {
        const Tetrahedron& t = mesh.tetrahedra[star[i]];
        if (t.is_ghost()) continue;
        VertexId v[4];
        std::copy_n(t.v, 4, v);
        std::sort(v, v + 4, [&](VertexId one, VertexId other) {
            return mesh.vertices[one].index < mesh.vertices[other].index;
        });
        std::uint32_t indices[4];
        for (int k = 0; k < 4; ++k) indices[k] = mesh.vertices[v[k]].index;
        if (!std::lexicographical_compare(indices, indices + 4, least, least + 4)) continue;
        std::copy_n(indices, 4, least);
        std::copy_n(v, 4, best);
    }
    for (int k = 0; k < 4; ++k) where_.unscaled(best[k], directions_[k]);
    has_directions_ = true;
}

// A tetrahedron on the way, and the sides of its edges, which are found when they are needed.
class Station {
  public:
    Station(const Locator& where, DisplacedLine& line) : where_(where), line_(line) {}

    TetId tetrahedron() const { return t_; }
    const Corner& corner(unsigned i) const { return corner_[i]; }
    // Goes to a finite tetrahedron.
    void set(TetId t) {
        t_ = t;
        for (unsigned i = 0; i < 4; ++i) set_corner(i);
        for (auto& row : side_) std::fill(row, row + 4, unknown);
    }
    // Goes to the neighbour behind a facet, and returns the face of the neighbour that is the
    // facet.
    unsigned cross(FacetCode facet) {
        const Corner old[4] = {corner_[0], corner_[1], corner_[2], corner_[3]};
        signed char old_side[4][4];
        std::copy_n(&side_[0][0], 16, &old_side[0][0]);
        t_ = mgdt::tetrahedron_of(facet);
        const unsigned entry = face_of(facet);
        const VertexId* const v = where_.mesh.tetrahedra[t_].v;
        unsigned from[4];
        for (unsigned i = 0; i < 4; ++i) {
            if (i == entry) {
                set_corner(i);
                continue;
            }
            unsigned k = 0;
            while (old[k].v != v[i]) ++k;
            corner_[i] = old[k];
            from[i] = k;
        }
        for (unsigned i = 0; i < 4; ++i)
            for (unsigned j = 0; j < 4; ++j)
                side_[i][j] = i == entry || j == entry ? unknown : old_side[from[i]][from[j]];
        return entry;
    }
    // Whether the line passes through a face in the direction of `sense`: -1 outward, +1 inward.
    bool passes(unsigned face, int sense) {
        const unsigned char* const f = outer_face[face];
        return sense * side(f[0], f[1]) > 0 && sense * side(f[1], f[2]) > 0 &&
               sense * side(f[2], f[0]) > 0;
    }
    // The face through which the line leaves the tetrahedron, or no_face if it misses it.
    unsigned exit(unsigned entry) {
        for (unsigned face = 0; face < 4; ++face)
            if (face != entry && passes(face, -1)) return face;
        return no_face;
    }
    // DisplacedLine::side() of the edge from corner i to corner j.
    int side(unsigned i, unsigned j) {
        if (side_[i][j] == unknown) {
            side_[i][j] = static_cast<signed char>(line_.side(corner_[i], corner_[j]));
            side_[j][i] = static_cast<signed char>(-side_[i][j]);
        }
        return side_[i][j];
    }
    // Whether the line passes through two faces at one place, where it meets the line of their
    // common edge.
    bool is_one_place(unsigned face, unsigned other) {
        unsigned ends[2], n = 0;
        for (unsigned i = 0; i < 4; ++i)
            if (i != face && i != other) ends[n++] = i;
        return std::abs(side(ends[0], ends[1])) == 2;
    }
    // Positive if q is strictly beyond a face, 0 if it is in its plane.
    int beyond(unsigned face, const double* q) const {
        const unsigned char* const f = outer_face[face];
        return orientation(q, corner_[f[0]].x, corner_[f[1]].x, corner_[f[2]].x);
    }

  private:
    static constexpr signed char unknown = 3;

    void set_corner(unsigned i) {
        corner_[i].v = where_.mesh.tetrahedra[t_].v[i];
        where_.unscaled(corner_[i].v, corner_[i].x);
    }

    const Locator& where_;
    DisplacedLine& line_;
    TetId t_ = no_tetrahedron;
    Corner corner_[4];
    signed char side_[4][4];
};

class SegmentWalk {
  public:
    SegmentWalk(const Locator& where, const double* a, const double* b, Allocator& allocator)
        : where_(where),
          mesh_(where.mesh),
          a_(a),
          b_(b),
          allocator_(allocator),
          line_(where, a, b, allocator),
          at_(where, line_) {}

    // Calls passed(tetrahedron, entry, exit) with the parameters of each tetrahedron that the
    // segment passes through.
    template <class Passed>
    void run(Passed passed);

  private:
    // Goes to the first tetrahedron. Returns false if the segment passes through none.
    bool start_inside(TetId containing, unsigned& exit);
    bool start_outside(TetId ghost, unsigned& entry);
    // Goes to the tetrahedron behind the hull facet of a ghost, and returns its face there.
    unsigned look_at(TetId ghost);
    double parameter(unsigned face) const {
        const unsigned char* const f = outer_face[face];
        return crossing_parameter(a_, b_,
                                  {at_.corner(f[0]).x, at_.corner(f[1]).x, at_.corner(f[2]).x});
    }

    const Locator& where_;
    const Mesh& mesh_;
    const double *const a_, *const b_;
    Allocator& allocator_;
    DisplacedLine line_;
    Station at_;
};

template <class Passed>
void SegmentWalk::run(Passed passed) {
    TetId near = no_tetrahedron;
    const TetId containing = where_.locate(a_, near);
    if (std::equal(a_, a_ + 3, b_)) {
        if (containing != no_tetrahedron) passed(containing, 0, 1);
        return;
    }
    if (near == no_tetrahedron) return;  // there are no tetrahedra
    unsigned entry = no_face, exit = no_face;
    double reached = 0;
    if (containing != no_tetrahedron) {
        if (!start_inside(containing, exit)) return;
    } else {
        if (!start_outside(near, entry)) return;
        reached = parameter(entry);
        exit = at_.exit(entry);
    }
    for (;;) {
        assert(exit != no_face && "a line that enters a tetrahedron leaves it");
        const bool is_left = at_.beyond(exit, b_) > 0;
        if (entry == no_face || !at_.is_one_place(entry, exit)) {
            const double left = is_left ? parameter(exit) : 1;
            passed(at_.tetrahedron(), reached, left);
            reached = left;
        }
        if (!is_left) return;
        const FacetCode next = mesh_.tetrahedra[at_.tetrahedron()].n[exit];
        if (mesh_.tetrahedra[tetrahedron_of(next)].is_ghost()) return;
        entry = at_.cross(next);
        exit = at_.exit(entry);
    }
}

// a may be on the boundary of the tetrahedron, and the segment may begin in another one that
// contains a, or in none if it leaves the hull at a.
bool SegmentWalk::start_inside(TetId containing, unsigned& exit) {
    VisitQueue around(allocator_);
    around.clear();
    around.push(containing);
    for (std::size_t i = 0; i < around.size(); ++i) {
        at_.set(around[i]);
        exit = at_.exit(no_face);
        if (exit != no_face && at_.beyond(exit, a_) < 0) return true;
        for (unsigned face = 0; face < 4; ++face) {
            const TetId next = tetrahedron_of(mesh_.tetrahedra[around[i]].n[face]);
            if (at_.beyond(face, a_) == 0 && !mesh_.tetrahedra[next].is_ghost()) around.push(next);
        }
    }
    return false;
}

unsigned SegmentWalk::look_at(TetId ghost) {
    const Tetrahedron& g = mesh_.tetrahedra[ghost];
    const FacetCode facet = g.n[g.infinite_slot()];
    at_.set(tetrahedron_of(facet));
    return face_of(facet);
}

// Walks over the hull facets that face a, towards the place where the line enters. The walk visits
// no facet twice. If the neighbour beyond an edge does not face a, the line misses the hull.
bool SegmentWalk::start_outside(TetId ghost, unsigned& entry) {
    entry = look_at(ghost);
    for (std::size_t steps = 0;; ++steps) {
        assert(steps < mesh_.ghost_count && "the walk over the hull visits a facet twice");
        if (at_.passes(entry, 1)) return at_.beyond(entry, b_) < 0;
        const unsigned char* const f = outer_face[entry];
        unsigned from = 0;  // the corner opposite the edge that the walk crosses
        while (from < 2 && at_.side(f[(from + 1) % 3], f[(from + 2) % 3]) >= 0) ++from;
        assert(at_.side(f[(from + 1) % 3], f[(from + 2) % 3]) < 0 && "all edges are on one side");
        const Tetrahedron& here = mesh_.tetrahedra[ghost];
        const VertexId opposite = at_.corner(f[from]).v;
        ghost = tetrahedron_of(here.n[std::find(here.v, here.v + 4, opposite) - here.v]);
        entry = look_at(ghost);
        if (at_.beyond(entry, a_) <= 0) return false;
    }
}

}  // namespace

Traversal traverse_segment(const Locator& where, const double* a, const double* b,
                           Allocator& allocator) {
    Traversal way(allocator);
    constexpr std::size_t few = 64;
    way.tetrahedra.reserve(few);
    way.parameters.reserve(few);
    SegmentWalk(where, a, b, allocator).run([&](TetId t, double entry, double exit) {
        if (way.tetrahedra.empty()) way.parameters.push_back(entry);
        way.tetrahedra.push_back(t);
        way.parameters.push_back(exit);
    });
    return way;
}

}  // namespace mgdt
