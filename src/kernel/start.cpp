// SPDX-License-Identifier: MIT
#include "kernel/start.hpp"

#include <cmath>
#include <cstring>

namespace mgdt {
namespace {

double square_distance(const double* a, const double* b) {
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z;
}

}  // namespace

TetId jump(const Mesh& mesh, std::size_t vertices, const double* q, TetId last) {
    VertexId nearest = last == no_tetrahedron ? 1 : mesh.tetrahedra[last].v[0];
    double least = square_distance(mesh.point(nearest), q);
    std::uint64_t random = vertices;
    for (int k = 0; k < 3; ++k) {
        std::uint64_t bits;
        std::memcpy(&bits, &q[k], sizeof bits);
        random = (random ^ bits) * 0x9E3779B97F4A7C15u;
        random ^= random >> 32;
    }
    const unsigned samples =
        static_cast<unsigned>(std::sqrt(std::sqrt(static_cast<double>(vertices))));
    for (unsigned i = 0; i < samples; ++i) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        const VertexId v = static_cast<VertexId>(1 + (random >> 32) * vertices / 4294967296u);
        const double square = square_distance(mesh.point(v), q);
        if (square < least) {
            least = square;
            nearest = v;
        }
    }
    return mesh.live_from(mesh.vertices[nearest].near);
}

}  // namespace mgdt
