// SPDX-License-Identifier: MIT
#include "predicates/predicates.hpp"
#include "query/locate.hpp"

namespace mgdt {
namespace {

// A set of numbers that keeps the order in which they came: a queue of what is still to visit.
class VisitQueue {
  public:
    explicit VisitQueue(Allocator& allocator) : items_(allocator), table_(allocator) {
        items_.reserve(least / 2);
    }
    void clear() {
        items_.clear();
        table_.clear();
        table_.resize(least, no_index);
    }
    std::size_t size() const { return items_.size(); }
    std::uint32_t operator[](std::size_t i) const { return items_[i]; }
    void push(std::uint32_t item) {
        if (2 * items_.size() >= table_.size()) {
            const std::size_t larger = 4 * table_.size();
            table_.clear();
            table_.resize(larger, no_index);
            for (const std::uint32_t old : items_) table_[slot(old)] = old;
        }
        const std::size_t at = slot(item);
        if (table_[at] == item) return;
        table_[at] = item;
        items_.push_back(item);
    }

  private:
    static constexpr std::size_t least = 128;  // a vertex has 27 tetrahedra in the mean

    std::size_t slot(std::uint32_t item) const {
        const std::size_t mask = table_.size() - 1;
        std::size_t h = (item * 0x9E3779B1u) & mask;
        while (table_[h] != no_index && table_[h] != item) h = (h + 1) & mask;
        return h;
    }
    Buffer<std::uint32_t> items_;
    Buffer<std::uint32_t> table_;
};

// Calls f for the finite neighbours of v, some more than once, with a tetrahedron that has both;
// the first one of v's is given.
template <class F>
void for_each_neighbor(const Mesh& mesh, VertexId v, TetId first, VisitQueue& star, F f) {
    star.clear();
    star.push(first);
    for (std::size_t i = 0; i < star.size(); ++i) {
        const Tetrahedron& t = mesh.tetrahedra[star[i]];
        for (int face = 0; face < 4; ++face) {
            if (t.v[face] == v) continue;
            if (t.v[face] != infinite_vertex) f(t.v[face], star[i]);
            star.push(t.n[face] >> 2);
        }
    }
}

}  // namespace

// Distances of vertices from a point, exactly compared.
class NearestVertex {
  public:
    NearestVertex(const Locator& locator, const double* q)
        : locator_(locator), mesh_(locator.mesh), q_(q) {
        has_place_ = locator.scale_exactly(q, p_);
    }

    // The square of a vertex's distance in doubles, infinity if it is too large; 0, which tells
    // nothing, if q has no place in the mesh's scale.
    double estimate(VertexId v) const {
        if (!has_place_) return 0;
        const double* const x = mesh_.point(v);
        const double d[3] = {x[0] - p_[0], x[1] - p_[1], x[2] - p_[2]};
        return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    }
    // Whether a vertex is certainly farther than another, by their estimates (docs/theory.md, "The
    // nearest vertex").
    static bool is_farther(double estimate, double than) {
        return than > 0x1p-900 && than < 0x1p900 && estimate > than * (1 + 0x1p-40);
    }
    // The sign of a's distance less b's.
    int compare(VertexId a, VertexId b) const {
        // Scaling by a power of two changes no comparison, where it is exact.
        if (has_place_) return compare_distance(p_, mesh_.point(a), mesh_.point(b));
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

    // In a Delaunay triangulation some neighbour of a vertex is nearer to q unless no vertex is, so
    // descending from neighbour to neighbour ends at a nearest vertex. `near` is a tetrahedron of
    // v, then of the vertex returned. `is_only`: no neighbour of that is as near.
    VertexId descend(VertexId v, TetId& near, VisitQueue& star, bool& is_only) const {
        for (;;) {
            VertexId better = v;
            double least = estimate(v);
            is_only = true;
            for_each_neighbor(mesh_, v, near, star, [&](VertexId other, TetId t) {
                if (other == better) return;
                const double square = estimate(other);
                if (is_farther(square, least)) return;
                const int comparison = compare(other, better);
                if (comparison == 0) is_only = false;
                if (comparison >= 0) return;
                better = other;
                least = square;
                near = t;
            });
            if (better == v) return v;
            v = better;
        }
    }

    // Several as near lie on an empty sphere about q; their hull is a face of the Delaunay
    // complex, which the triangulation refines, so their edges connect them.
    VertexId first_of_equals(VertexId v, TetId near, VisitQueue& star, Allocator& allocator) const {
        VisitQueue equals(allocator);
        Buffer<TetId> tetrahedra(allocator);  // one of each vertex in the queue
        const auto push = [&](VertexId equal, TetId t) {
            equals.push(equal);
            if (equals.size() > tetrahedra.size()) tetrahedra.push_back(t);
        };
        equals.clear();
        push(v, near);
        for (std::size_t i = 0; i < equals.size(); ++i) {
            if (is_better(equals[i], v)) v = equals[i];
            for_each_neighbor(mesh_, equals[i], tetrahedra[i], star, [&](VertexId other, TetId t) {
                if (compare(other, v) == 0) push(other, t);
            });
        }
        return v;
    }

  private:
    const Locator& locator_;
    const Mesh& mesh_;
    const double* const q_;
    double p_[3];  // q in the mesh's scale
    bool has_place_;
};

VertexId Locator::nearest_vertex(const double* q, Allocator& allocator) const {
    if (mesh.vertices.size() == 1) return infinite_vertex;
    const NearestVertex to(*this, q);
    if (mesh.live_count() == 0) {
        VertexId nearest = 1;
        for (VertexId v = 2; v < mesh.vertices.size(); ++v)
            if (to.is_better(v, nearest)) nearest = v;
        return nearest;
    }
    TetId near = no_tetrahedron;
    locate(q, near);
    // Among the vertices of where q is first: that is often the nearest already.
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
