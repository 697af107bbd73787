// SPDX-License-Identifier: MIT
#include "improvement/vertex_classes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mgdt {
namespace {

// Makes a vector a unit vector. Returns its length; if it is 0, the vector stays.
double normalize(double (&v)[3]) {
    const double length = std::sqrt((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]);
    if (length > 0)
        for (double& c : v) c /= length;
    return length;
}

// What is known of a vertex while faces and edges are read.
struct Surroundings {
    std::uint32_t label = no_index;                // of the faces at the vertex
    bool has_labels = false;                       // whether there are several
    std::uint32_t edges = 0;                       // their number at the vertex
    std::uint32_t ends[2] = {no_index, no_index};  // the other ends of the first two
};

// The unit vector from one end of two edges to the other, if the vertex between them is on the
// line: if the angle between them differs from a straight one by rounding alone.
bool find_line(const FlexibleMesh& mesh, std::uint32_t v, const std::uint32_t (&ends)[2],
               double (&direction)[3]) {
    constexpr double rounding = 0x1p-48;  // of coordinates, which are at most 1
    double to[2][3], shortest = 1;
    for (int e = 0; e < 2; ++e) {
        for (int k = 0; k < 3; ++k) to[e][k] = mesh.point(ends[e])[k] - mesh.point(v)[k];
        shortest = std::min(shortest, normalize(to[e]));
    }
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        sum += (to[0][k] + to[1][k]) * (to[0][k] + to[1][k]);
        direction[k] = to[1][k] - to[0][k];
    }
    return std::sqrt(sum) * shortest < rounding && normalize(direction) > 0;
}

}  // namespace

void classify_vertices(FlexibleMesh& mesh, const Buffer<Permission>& permissions, bool slides) {
    const std::size_t count = mesh.x.size() / 3;
    Buffer<Surroundings> around(mesh.allocator());
    around.resize(count, {});
    // The largest face of each label gives the normal of its plane.
    struct Plane {
        double normal[3];
        double size;
    };
    Buffer<Plane> planes(mesh.allocator());
    planes.resize(mesh.labels.size(), {{0, 0, 0}, 0});
    for (const FlexibleMesh::Tetrahedron& t : mesh.tetrahedra) {
        for (unsigned i = 0; i < 4 && !t.is_dead(); ++i) {
            if (t.facets[i] == no_index) continue;
            const std::uint32_t label = FlexibleMesh::label_of(t.facets[i]);
            const double* p[3];
            for (unsigned k = 0; k < 3; ++k) {
                const std::uint32_t v = t.v[outer_face[i][k]];
                p[k] = mesh.point(v);
                Surroundings& s = around[v];
                if (s.label == no_index)
                    s.label = label;
                else if (s.label != label)
                    s.has_labels = true;
            }
            double n[3], size = 0;
            for (int k = 0; k < 3; ++k) {
                const int l = (k + 1) % 3, m = (k + 2) % 3;
                n[k] = (p[1][l] - p[0][l]) * (p[2][m] - p[0][m]) -
                       (p[1][m] - p[0][m]) * (p[2][l] - p[0][l]);
                size += n[k] * n[k];
            }
            if (size > planes[label].size) planes[label] = {{n[0], n[1], n[2]}, size};
        }
    }
    mesh.edges.for_each([&](std::uint32_t a, std::uint32_t b, const KeptEdges::Origin&) {
        for (const auto& [v, w] : {std::make_pair(a, b), std::make_pair(b, a)}) {
            Surroundings& s = around[v];
            if (s.edges < 2) s.ends[s.edges] = w;
            ++s.edges;
        }
    });
    for (std::uint32_t v = 0; v < count; ++v) {
        const Surroundings& s = around[v];
        VertexClass& c = mesh.classes[v];
        c = {Freedom::fixed, permissions[v] == Permission::to_leave, {0, 0, 0}};
        if (permissions[v] == Permission::none || mesh.hints[v] == no_tetrahedron) continue;
        if (s.edges == 0 && s.label == no_index) {
            c.freedom = Freedom::free;
        } else if (!slides) {
            continue;
        } else if (s.edges == 0 && !s.has_labels) {
            for (int k = 0; k < 3; ++k) c.direction[k] = planes[s.label].normal[k];
            if (normalize(c.direction) > 0) c.freedom = Freedom::in_plane;
        } else if (s.edges == 2 && find_line(mesh, v, s.ends, c.direction)) {
            c.freedom = Freedom::on_line;
        }
    }
}

}  // namespace mgdt
