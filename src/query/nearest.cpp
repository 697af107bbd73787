// SPDX-License-Identifier: MIT
// The vertex nearest to a place.
#include <algorithm>
#include <cmath>

#include "mesh/star_traversal.hpp"
#include "predicates/predicates.hpp"
#include "query/locate.hpp"
#include "query/visit_queue.hpp"

namespace mgdt {
namespace {

// Calls f(u, t) for each finite neighbour u of v, where t is a tetrahedron of both; for some
// neighbours more than once. `near` is a tetrahedron of v.
template <class F>
void for_each_neighbor(const Mesh& mesh, VertexId v, TetId near, VisitQueue& star, F f) {
    // The finite tetrahedra around v are connected through facets, since the hull is convex.
    const Tetrahedron& given = mesh.tetrahedra[near];
    const TetId first = given.is_ghost() ? tetrahedron_of(given.n[given.infinite_slot()]) : near;
    for (const VertexId other : mesh.tetrahedra[first].v)
        if (other != v) f(other, first);
    star.clear();
    star.push(first);
    traverse_star(mesh, v, star, [&](FacetCode facet) {
        const Tetrahedron& next = mesh.tetrahedra[tetrahedron_of(facet)];
        // Only the vertex of `next` that is opposite the facet can be a new neighbour.
        if (!next.is_ghost() && star.push(tetrahedron_of(facet)))
            f(next.v[face_of(facet)], tetrahedron_of(facet));
    });
}

}  // namespace

// Compares distances of vertices from a point, exactly.
class NearestVertex {
  public:
    NearestVertex(const Locator& locator, const double* q)
        : locator_(locator), mesh_(locator.mesh), q_(q) {
        has_place_ = locator.scale_exactly(q, p_);
    }

    // An approximate squared distance of a vertex; infinity if it overflows. If q has no exact
    // coordinates in the mesh's scale, the estimate is 0, for which is_farther() returns false.
    double estimate(VertexId v) const {
        if (!has_place_) return 0;
        const double* const x = mesh_.point(v);
        const double d[3] = {x[0] - p_[0], x[1] - p_[1], x[2] - p_[2]};
        return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    }
    // Whether the estimates prove that a vertex is farther than another (docs/theory.md, "The
    // nearest vertex").
    static bool is_farther(double estimate, double than) {
        return than > 0x1p-900 && than < 0x1p900 && estimate > than * (1 + 0x1p-40);
    }
    // Negative if a is nearer than b, positive if b is nearer than a, 0 if their distances are
    // equal.
    int compare(VertexId a, VertexId b) const {
        // Exact scaling by a power of two changes no comparison.
        if (has_place_) {
            double squares[2];
            if (has_exact_square(a, squares[0]) && has_exact_square(b, squares[1]))
                return (squares[0] > squares[1]) - (squares[0] < squares[1]);
            return compare_distance(p_, mesh_.point(a), mesh_.point(b));
        }
        double pa[3], pb[3];
        locator_.unscaled(a, pa);
        locator_.unscaled(b, pb);
        return compare_distance(q_, pa, pb);
    }
    bool is_better(VertexId a, VertexId b) const {
        const int comparison = compare(a, b);
        return comparison < 0 ||
               (comparison == 0 && mesh_.vertices[a].index < mesh_.vertices[b].index);
    }

    // Descends from neighbour to neighbour to a nearest vertex: in a Delaunay triangulation, a
    // vertex that is not nearest to q has a neighbour that is nearer. `near` is a tetrahedron of v,
    // and becomes a tetrahedron of the result. `is_only` becomes true if no neighbour of the result
    // is as near as the result.
    VertexId descend(VertexId v, TetId& near, VisitQueue& star, bool& is_only) const {
        for (;;) {
            VertexId better = v;
            double least = estimate(v);
            is_only = true;
            const auto look = [&](VertexId other, TetId t) {
                if (other == better) return;
                const double square = estimate(other);
                if (is_farther(square, least)) return;
                const int comparison = compare(other, better);
                if (comparison == 0) is_only = false;
                if (comparison >= 0) return;
                better = other;
                least = square;
                near = t;
            };
            for_each_neighbor(mesh_, v, near, star, look);
            if (better == v) return v;
            v = better;
        }
    }

    // Of all nearest vertices, of which v is one, the vertex with the least index. The nearest
    // vertices lie on an empty sphere around q. Their convex hull is a cell of the Delaunay
    // complex, which the triangulation subdivides, so edges connect the nearest vertices.
    VertexId first_of_equals(VertexId v, TetId near, VisitQueue& star, Allocator& allocator) const {
        VisitQueue equals(allocator);
        Buffer<TetId> tetrahedra(allocator);  // a tetrahedron of each vertex in the queue
        const auto push = [&](VertexId equal, TetId t) {
            equals.push(equal);
            if (equals.size() > tetrahedra.size()) tetrahedra.push_back(t);
        };
        equals.clear();
        push(v, near);
        for (std::size_t i = 0; i < equals.size(); ++i) {
            if (is_better(equals[i], v)) v = equals[i];
            const VertexId equal = equals[i];
            const double square = estimate(equal);
            for_each_neighbor(mesh_, equal, tetrahedra[i], star, [&](VertexId other, TetId t) {
                if (!is_farther(estimate(other), square) && compare(other, v) == 0) push(other, t);
            });
        }
        return v;
    }

  private:
    // Computes the squared distance of a vertex. Returns whether the result is exact. It is exact
    // for coordinates with few digits, such as those of a lattice, where ties are frequent.
    bool has_exact_square(VertexId v, double& square) const {
        const double* const x = mesh_.point(v);
        double squares[3];
        for (int k = 0; k < 3; ++k) {
            const double d = x[k] - p_[k];
            // Return false unless the subtraction was exact and d has 24 bits, so that d * d is
            // exact.
            if (static_cast<double>(static_cast<float>(d)) != d || x[k] - d != p_[k] ||
                p_[k] + d != x[k])
                return false;
            squares[k] = d * d;
        }
        const double two = squares[0] + squares[1];
        square = two + squares[2];
        return two - squares[0] == squares[1] && two - squares[1] == squares[0] &&
               square - two == squares[2] && square - squares[2] == two;
    }

    const Locator& locator_;
    const Mesh& mesh_;
    const double* const q_;
    double p_[3];  // q in the mesh's scale
    bool has_place_;
};

VertexId Locator::nearest_vertex(const double* q, Allocator& allocator) const {
    TetId near = no_tetrahedron;
    if (mesh.live_count() != 0) locate(q, near, false);
    return nearest_vertex(q, near, allocator);
}

VertexId Locator::nearest_vertex(const double* q, TetId near, Allocator& allocator) const {
    if (mesh.vertices.size() == 1) return infinite_vertex;
    const NearestVertex to(*this, q);
    if (mesh.live_count() == 0) {
        VertexId nearest = 1;
        double least = to.estimate(nearest);
        for (VertexId v = 2; v < mesh.vertices.size(); ++v) {
            const double square = to.estimate(v);
            if (NearestVertex::is_farther(square, least) || !to.is_better(v, nearest)) continue;
            nearest = v;
            least = square;
        }
        return nearest;
    }
    // The search starts at the nearest vertex of the tetrahedron near q, which is often the result.
    VertexId nearest = infinite_vertex;
    for (const VertexId v : mesh.tetrahedra[near].v)
        if (v != infinite_vertex && (nearest == infinite_vertex || to.compare(v, nearest) < 0))
            nearest = v;
    VisitQueue star(allocator);
    bool is_only;
    nearest = to.descend(nearest, near, star, is_only);
    return is_only ? nearest : to.first_of_equals(nearest, near, star, allocator);
}

}  // namespace mgdt
