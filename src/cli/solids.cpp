// SPDX-License-Identifier: MIT
#include "cli/solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mgdt::cli {
namespace {

using Vector = std::array<double, 3>;

// The corners of the facet opposite each vertex of a positively oriented tetrahedron,
// counter-clockwise seen from outside.
constexpr std::size_t facet_corners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

Vector between(const std::vector<double>& points, MeshIndex from, MeshIndex to) {
    const double* a = points.data() + 3 * static_cast<std::size_t>(from);
    const double* b = points.data() + 3 * static_cast<std::size_t>(to);
    return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

Vector cross(const Vector& u, const Vector& v) {
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double dot(const Vector& u, const Vector& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

}  // namespace

Solids find_solids(const std::vector<bool>& is_in_body, const std::vector<MeshIndex>& neighbors) {
    Solids solids;
    solids.of_tetrahedron.assign(is_in_body.size(), -1);
    std::vector<std::size_t> waiting;
    const auto enter = [&](std::size_t t) {
        solids.of_tetrahedron[t] = static_cast<MeshIndex>(solids.count);
        waiting.push_back(t);
    };
    for (std::size_t first = 0; first < is_in_body.size(); ++first) {
        if (!is_in_body[first] || solids.of_tetrahedron[first] >= 0) continue;
        enter(first);
        while (!waiting.empty()) {
            const std::size_t t = waiting.back();
            waiting.pop_back();
            for (std::size_t k = 0; k < 4; ++k) {
                if (neighbors[4 * t + k] < 0) continue;
                const auto next = static_cast<std::size_t>(neighbors[4 * t + k]);
                if (is_in_body[next] && solids.of_tetrahedron[next] < 0) enter(next);
            }
        }
        ++solids.count;
    }
    return solids;
}

std::vector<double> volumes_of(const Solids& solids, const Mesh& mesh) {
    std::vector<double> volumes(solids.count, 0.0);
    for (std::size_t t = 0; t < solids.of_tetrahedron.size(); ++t) {
        if (solids.of_tetrahedron[t] < 0) continue;
        const MeshIndex* v = mesh.tetrahedra.data() + 4 * t;
        const auto edge = [&](int k) { return between(mesh.points, v[0], v[k]); };
        volumes[static_cast<std::size_t>(solids.of_tetrahedron[t])] +=
            dot(cross(edge(1), edge(2)), edge(3)) / 6;
    }
    return volumes;
}

std::vector<MeshIndex> surface_of(const std::vector<bool>& is_in_body, const Mesh& mesh,
                                  const std::vector<MeshIndex>& neighbors) {
    std::vector<std::array<MeshIndex, 3>> facets;
    for (std::size_t t = 0; t < is_in_body.size(); ++t) {
        if (!is_in_body[t]) continue;
        const MeshIndex* v = mesh.tetrahedra.data() + 4 * t;
        for (std::size_t k = 0; k < 4; ++k) {
            const MeshIndex next = neighbors[4 * t + k];
            if (next >= 0 && is_in_body[static_cast<std::size_t>(next)]) continue;
            std::array<MeshIndex, 3> corners;
            for (std::size_t c = 0; c < 3; ++c) corners[c] = v[facet_corners[k][c]];
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                        corners.end());
            facets.push_back(corners);
        }
    }
    std::sort(facets.begin(), facets.end());
    std::vector<MeshIndex> triangles;
    triangles.reserve(3 * facets.size());
    for (const auto& f : facets) triangles.insert(triangles.end(), f.begin(), f.end());
    return triangles;
}

Surface with_own_points(const std::vector<MeshIndex>& triangles,
                        const std::vector<double>& points) {
    std::vector<MeshIndex> numbers(points.size() / 3, -1);
    for (const MeshIndex v : triangles) numbers[static_cast<std::size_t>(v)] = 0;
    Surface surface;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] < 0) continue;
        numbers[i] = static_cast<MeshIndex>(surface.point_count());
        surface.points.insert(surface.points.end(), points.data() + 3 * i,
                              points.data() + 3 * i + 3);
    }
    surface.triangles.reserve(triangles.size());
    for (const MeshIndex v : triangles)
        surface.triangles.push_back(numbers[static_cast<std::size_t>(v)]);
    return surface;
}

std::size_t count_edges_that_are_not_manifold(const Surface& surface) {
    std::vector<std::pair<MeshIndex, MeshIndex>> edges;
    edges.reserve(surface.triangles.size());
    for (std::size_t i = 0; i < surface.triangles.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const MeshIndex a = surface.triangles[i + k], b = surface.triangles[i + (k + 1) % 3];
            edges.emplace_back(std::min(a, b), std::max(a, b));
        }
    }
    std::sort(edges.begin(), edges.end());
    std::size_t count = 0;
    for (auto begin = edges.begin(); begin != edges.end();) {
        const auto end =
            std::find_if(begin, edges.end(), [&](const auto& e) { return e != *begin; });
        count += end - begin > 2 ? 1 : 0;
        begin = end;
    }
    return count;
}

double volume_inside(const Surface& surface) {
    double volume = 0;
    for (std::size_t i = 0; i < surface.triangles.size(); i += 3) {
        const MeshIndex* v = surface.triangles.data() + i;
        // Cones to the first point, which keeps the terms small.
        const auto from_first = [&](int k) { return between(surface.points, 0, v[k]); };
        volume += dot(cross(from_first(0), from_first(1)), from_first(2)) / 6;
    }
    return volume;
}

double area_of(const Surface& surface) {
    double area = 0;
    for (std::size_t i = 0; i < surface.triangles.size(); i += 3) {
        const MeshIndex* v = surface.triangles.data() + i;
        const Vector n =
            cross(between(surface.points, v[0], v[1]), between(surface.points, v[0], v[2]));
        area += std::hypot(n[0], n[1], n[2]) / 2;
    }
    return area;
}

}  // namespace mgdt::cli
