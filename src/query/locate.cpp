// SPDX-License-Identifier: MIT
#include "query/locate.hpp"

#include "kernel/walk.hpp"
#include "mesh/scale.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

bool Locator::scale_exactly(const double* q, double* to) const {
    for (int k = 0; k < 3; ++k) {
        if (mesh.scale != 0 && !scales_exactly(q[k], mesh.scale)) return false;
        to[k] = mesh.scale == 0 ? q[k] : scaled(q[k], mesh.scale);
    }
    return true;
}

void Locator::unscaled(VertexId v, double* to) const {
    for (int k = 0; k < 3; ++k) to[k] = scaled(mesh.vertices[v].x[k], -mesh.scale);
}

TetId Locator::locate(const double* q, TetId& hint) const {
    if (mesh.live_count() == 0) return no_tetrahedron;
    LocationWalk walk;
    if (begin(q, hint, walk))
        while (kernel.locate_step(mesh, walk)) {
        }
    return end(q, walk, hint);
}

bool Locator::begin(const double* q, TetId hint, LocationWalk& walk) const {
    walk.is_certain = false;
    walk.tetrahedron = hint;
    if (!scale_exactly(q, walk.q)) {
        if (hint == no_tetrahedron) walk.tetrahedron = mesh.live_from(0);
        return false;
    }
    if (hint == no_tetrahedron)
        walk.tetrahedron = start_of_walk(mesh, tree, no_tetrahedron, walk.q);
    kernel.locate_begin(mesh, walk);
    return true;
}

TetId Locator::end(const double* q, const LocationWalk& walk, TetId& hint) const {
    hint = walk.tetrahedron;
    if (walk.is_certain) return hint;
    Counters unused;
    const auto anywhere = [](const Tetrahedron&) { return true; };
    double p[3];
    if (scale_exactly(q, p))
        hint = walk_exact(mesh, hint, p, unused, anywhere,
                          [&](VertexId v, double*) { return mesh.point(v); });
    else  // it has no exact scaled place: walk on the caller's coordinates
        hint = walk_exact(mesh, hint, q, unused, anywhere, [&](VertexId v, double* room) {
            unscaled(v, room);
            return static_cast<const double*>(room);
        });
    return mesh.tetrahedra[hint].is_ghost() ? no_tetrahedron : hint;
}

void Locator::weights(TetId t, const double* q, double w[4]) const {
    // Volumes of the tetrahedra in which q replaces a vertex, relative to a base near q so that
    // large offsets cancel first. Halves keep differences of huge coordinates finite.
    double d[4][3];
    for (int i = 0; i < 4; ++i) {
        double p[3];
        unscaled(mesh.tetrahedra[t].v[i], p);
        for (int k = 0; k < 3; ++k) d[i][k] = p[k] * 0.5 - q[k] * 0.5;
    }
    double largest = 0;
    for (const auto& row : d) largest = std::fmax(largest, max_magnitude(row[0], row[1], row[2]));
    if (largest > 0) {
        int exponent;
        std::frexp(largest, &exponent);
        for (auto& row : d)
            for (double& x : row) x = scaled(x, -exponent);
    }
    const auto volume = [&](int a, int b, int c) {
        return d[a][0] * (d[b][1] * d[c][2] - d[b][2] * d[c][1]) +
               d[a][1] * (d[b][2] * d[c][0] - d[b][0] * d[c][2]) +
               d[a][2] * (d[b][0] * d[c][1] - d[b][1] * d[c][0]);
    };
    w[0] = volume(1, 2, 3);
    w[1] = volume(0, 3, 2);
    w[2] = volume(0, 1, 3);
    w[3] = volume(0, 2, 1);
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        if (!(w[i] > 0)) w[i] = 0;  // q is in the closed tetrahedron: negatives are rounding
        sum += w[i];
    }
    if (sum > 0) {
        for (int i = 0; i < 4; ++i) w[i] /= sum;
    } else {
        // Too flat for its volume to be a double: the nearest vertex.
        int nearest = 0;
        double least = infinity;
        for (int i = 0; i < 4; ++i) {
            const double square = d[i][0] * d[i][0] + d[i][1] * d[i][1] + d[i][2] * d[i][2];
            if (square < least) {
                least = square;
                nearest = i;
            }
        }
        w[nearest] = 1;
    }
}

namespace {

// A set of numbers that keeps the order in which they came: a queue of what is still to visit.
class VisitQueue {
  public:
    explicit VisitQueue(Allocator& allocator) : items_(allocator), table_(allocator) {}
    void clear() {
        items_.clear();
        table_.clear();
        table_.resize(64, no_index);
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

int Locator::compare(VertexId a, VertexId b, const double* q) const {
    // Scaling by a power of two changes no comparison, where it is exact.
    double p[3];
    if (scale_exactly(q, p)) return compare_distance(p, mesh.point(a), mesh.point(b));
    double pa[3], pb[3];
    unscaled(a, pa);
    unscaled(b, pb);
    return compare_distance(q, pa, pb);
}

// In a Delaunay triangulation some neighbour of a vertex is nearer to q unless none is, so
// descending from neighbour to neighbour ends at a nearest vertex. Several as near lie on an
// empty sphere about q; their hull is a face of the Delaunay complex, which the triangulation
// refines, so their edges connect them.
VertexId Locator::nearest_vertex(const double* q, Allocator& allocator) const {
    const auto is_better = [&](VertexId a, VertexId b) {
        const int comparison = compare(a, b, q);
        return comparison < 0 ||
               (comparison == 0 && mesh.vertices[a].index < mesh.vertices[b].index);
    };
    if (mesh.vertices.size() == 1) return infinite_vertex;
    VertexId nearest = 1;
    if (mesh.live_count() == 0) {
        for (VertexId v = 2; v < mesh.vertices.size(); ++v)
            if (is_better(v, nearest)) nearest = v;
        return nearest;
    }
    TetId near = no_tetrahedron;
    locate(q, near);
    // Among the vertices of where q is first: that is often the nearest already.
    const Tetrahedron& around = mesh.tetrahedra[near];
    nearest = around.v[0];
    for (const VertexId v : around.v)
        if (v != infinite_vertex && compare(v, nearest, q) < 0) nearest = v;
    VisitQueue star(allocator), equals(allocator);
    for (bool descends = true; descends;) {
        VertexId better = nearest;
        for_each_neighbor(mesh, nearest, near, star, [&](VertexId v, TetId t) {
            if (v == better || compare(v, better, q) >= 0) return;
            better = v;
            near = t;
        });
        descends = better != nearest;
        nearest = better;
    }
    Buffer<TetId> tetrahedra(allocator);  // one of each vertex in the queue
    const auto push = [&](VertexId v, TetId t) {
        equals.push(v);
        if (equals.size() > tetrahedra.size()) tetrahedra.push_back(t);
    };
    equals.clear();
    push(nearest, near);
    for (std::size_t i = 0; i < equals.size(); ++i) {
        if (is_better(equals[i], nearest)) nearest = equals[i];
        for_each_neighbor(mesh, equals[i], tetrahedra[i], star, [&](VertexId v, TetId t) {
            if (compare(v, nearest, q) == 0) push(v, t);
        });
    }
    return nearest;
}

}  // namespace mgdt
