// SPDX-License-Identifier: MIT
#include "query/graphs.hpp"

#include <algorithm>
#include <cmath>

#include "parallel/disjoint_sets.hpp"
#include "predicates/predicates.hpp"
#include "query/vertex_indices.hpp"

namespace mgdt {
namespace {

EdgeLists all_edges(const MeshView& view, std::size_t points, const VertexIndices& indices) {
    return EdgeLists(view, points,
                     edges_from_lesser(view.mesh, [&](VertexId v) { return indices[v]; }));
}

// A squared length is rounded five times, so a sum of three squared lengths has an error below 8
// units in the last place. Between these limits, no underflow or overflow occurs.
constexpr double least_length = 0x1p-900, most_length = 0x1p900, length_error = 16 * 0x1p-53;

double rough_length(const double* a, const double* b) {
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z;
}

}  // namespace

unsigned obtuse_corner(const double* const (&p)[3]) {
    const double opposite[3] = {rough_length(p[1], p[2]), rough_length(p[2], p[0]),
                                rough_length(p[0], p[1])};
    const double sum = opposite[0] + opposite[1] + opposite[2];
    const double error = sum > least_length && sum < most_length ? length_error * sum : sum;
    for (unsigned i = 0; i < 3; ++i) {
        const double excess = 2 * opposite[i] - sum;
        if (excess < -error) continue;
        if (excess > error || side_of_diametral_sphere(p[(i + 1) % 3], p[(i + 2) % 3], p[i]) > 0)
            return i;
    }
    return 3;
}

// An edge is a Gabriel edge if its midpoint is in the dual Voronoi face of the edge. The third
// vertices of the facets at the edge bound this face, so an edge opposite an obtuse corner of a
// facet is removed: docs/theory.md, "Graphs of neighbours".
EdgeLists gabriel_edges(const MeshView& view, std::size_t points, StageProgress& progress) {
    const Mesh& mesh = view.mesh;
    const VertexIndices indices(view.team, mesh, view.allocator);
    progress.enter(0, 0.4);
    EdgeLists edges = all_edges(view, points, indices);
    progress.enter(0.4, 1);
    const StopRequest stop = progress.stop_request();
    edges.subtract(EdgeLists(view, points, [&](std::size_t begin, std::size_t end, auto f) {
        for (std::size_t id = begin; id < end; ++id) {
            stop.poll_in_step(id);
            const Tetrahedron& t = mesh.tetrahedra[id];
            if (t.is_dead()) continue;
            for (unsigned face = 0; face < 4; ++face) {
                // Visit each facet once, from the first of its two tetrahedra.
                if (tetrahedron_of(t.n[face]) < id) continue;
                if (t.is_ghost() && t.v[face] != infinite_vertex) continue;
                const unsigned char* const corner = outer_face[face];
                const VertexId v[3] = {t.v[corner[0]], t.v[corner[1]], t.v[corner[2]]};
                const unsigned i =
                    obtuse_corner({mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])});
                if (i == 3) continue;
                const std::uint32_t a = indices[v[(i + 1) % 3]], b = indices[v[(i + 2) % 3]];
                f(std::min(a, b), std::max(a, b));
            }
        }
    }));
    return edges;
}

namespace {

struct Length {
    double square;           // the squared length, rounded five times
    std::uint32_t position;  // the position of the edge among all edges
};

}  // namespace

// Kruskal's algorithm: takes the edges by length, and skips edges whose ends are connected already.
// The edges of the tetrahedra contain every minimum spanning tree.
Buffer<std::uint32_t> spanning_tree(const MeshView& view, const Buffer<VertexId>& point_map,
                                    StageProgress& progress) {
    progress.enter(0, 0.3);
    const VertexIndices indices(view.team, view.mesh, view.allocator);
    Buffer<std::uint32_t> ends(view.allocator), tree(view.allocator);
    Buffer<Length> lengths(view.allocator);
    const auto point = [&](std::uint32_t end) { return view.mesh.point(point_map[ends[end]]); };
    {
        const EdgeLists edges = all_edges(view, point_map.size(), indices);
        ends.resize(2 * edges.size());
        lengths.resize(edges.size());
        edges.write([&](std::size_t k, std::size_t position, const std::uint32_t* others,
                        std::size_t size) {
            const double* const p = view.mesh.point(point_map[k]);
            for (std::size_t i = 0; i < size; ++i) {
                const double* const q = view.mesh.point(point_map[others[i]]);
                ends[2 * (position + i)] = static_cast<std::uint32_t>(k);
                ends[2 * (position + i) + 1] = others[i];
                lengths[position + i] = {rough_length(p, q),
                                         static_cast<std::uint32_t>(position + i)};
            }
        });
    }
    // Edges of the same length are taken in the order of their ends.
    progress.enter(0.3, 0.8);
    const StopRequest stop = progress.stop_request();
    std::size_t steps = 0;
    std::sort(lengths.begin(), lengths.end(), [&](const Length& a, const Length& b) {
        stop.poll_in_step(steps++);
        const double larger = std::max(a.square, b.square), difference = a.square - b.square;
        if (larger > least_length && larger < most_length &&
            std::fabs(difference) > length_error * larger)
            return difference < 0;
        const int s = compare_lengths(point(2 * a.position), point(2 * a.position + 1),
                                      point(2 * b.position), point(2 * b.position + 1));
        return s != 0 ? s < 0 : a.position < b.position;
    });
    progress.enter(0.8, 1);
    DisjointSets parts(view.allocator, point_map.size());
    Buffer<bool> is_taken(view.allocator);
    is_taken.resize(lengths.size(), false);
    std::size_t left = lengths.empty() ? 0 : view.mesh.vertices.size() - 2;
    tree.reserve(2 * left);
    for (const Length* edge = lengths.begin(); left > 0; ++edge) {
        is_taken[edge->position] =
            parts.join(ends[2 * edge->position], ends[2 * edge->position + 1]);
        left -= is_taken[edge->position];
    }
    for (std::size_t e = 0; e < is_taken.size(); ++e) {
        if (!is_taken[e]) continue;
        tree.push_back(ends[2 * e]);
        tree.push_back(ends[2 * e + 1]);
    }
    return tree;
}

}  // namespace mgdt
