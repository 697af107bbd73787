// SPDX-License-Identifier: MIT
#include "interpolation/gradient.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/star_traversal.hpp"

namespace mgdt {
namespace {

// Directions in which neighbours are no farther apart than this, of the largest extent, have no
// slope.
constexpr double least_extent = 0x1p-48;

struct VisitedStar {
    std::size_t size() const { return numbers.size(); }
    TetId operator[](std::size_t i) const { return numbers.name(static_cast<std::uint32_t>(i)); }
    const Numbers& numbers;
};

}  // namespace

void Gradient::gather(const Locator& where, VertexId v) {
    const Mesh& mesh = where.mesh;
    tetrahedra_.clear();
    vertices_.clear();
    vertices_.number(infinite_vertex);
    vertices_.number(v);
    const auto add = [&](TetId t) {
        const std::uint32_t known = tetrahedra_.size();
        if (tetrahedra_.number(t) != known) return;
        for (const VertexId u : mesh.tetrahedra[t].v) vertices_.number(u);
    };
    add(where.tetrahedron_of(v));
    traverse_star(mesh, v, VisitedStar{tetrahedra_},
                  [&](FacetCode facet) { add(tetrahedron_of(facet)); });
    neighbors_.clear();
    for (std::uint32_t k = 2; k < vertices_.size(); ++k) neighbors_.push_back(vertices_.name(k));
    std::sort(neighbors_.begin(), neighbors_.end(), [&](VertexId a, VertexId b) {
        return mesh.vertices[a].index < mesh.vertices[b].index;
    });
}

// With A the rows of unit vectors to the neighbours, the pseudo-inverse of A. Rotations in the
// plane of two axes make the columns of A V orthogonal (Hestenes, Inversion of matrices by
// biorthogonalization and related results, Journal of the SIAM 6, 1958): A V = U S, and the
// pseudo-inverse is V S^-1 U^T.
void Gradient::find(const Locator& where, VertexId v) {
    gather(where, v);
    const Mesh& mesh = where.mesh;
    const std::size_t n = neighbors_.size();
    rows_.clear();
    rows_.resize(n);
    columns_.clear();
    columns_.resize(3 * n);
    double* const a[3] = {columns_.data(), columns_.data() + n, columns_.data() + 2 * n};
    for (std::size_t j = 0; j < n; ++j) {
        double d[3], largest = 0;
        const auto set = [&](double part) {
            largest = 0;
            for (int k = 0; k < 3; ++k) {
                d[k] = part * mesh.point(neighbors_[j])[k] - part * mesh.point(v)[k];
                largest = std::max(largest, std::fabs(d[k]));
            }
        };
        double part = 1;
        set(part);
        if (!std::isfinite(largest)) set(part = 0.25);
        for (double& x : d) x /= largest;
        const double length = std::sqrt((d[0] * d[0] + d[1] * d[1]) + d[2] * d[2]);
        for (int k = 0; k < 3; ++k) a[k][j] = d[k] / length;
        rows_[j].distance = largest * length / part;
    }
    double rotation[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto product = [n](const double* x, const double* y) {
        double sum = 0;
        for (std::size_t j = 0; j < n; ++j) sum += x[j] * y[j];
        return sum;
    };
    constexpr int most_sweeps = 12;  // each squares what is left
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        bool is_orthogonal = true;
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                const double pp = product(a[p], a[p]), qq = product(a[q], a[q]),
                             pq = product(a[p], a[q]);
                if (!(std::fabs(pq) > 0x1p-52 * std::sqrt(pp * qq))) continue;
                is_orthogonal = false;
                const double zeta = (qq - pp) / (2 * pq);
                const double t =
                    std::copysign(1 / (std::fabs(zeta) + std::sqrt(1 + zeta * zeta)), zeta);
                const double c = 1 / std::sqrt(1 + t * t), s = c * t;
                const auto rotate = [c, s](double& x, double& y) {
                    const double old = x;
                    x = c * old - s * y;
                    y = s * old + c * y;
                };
                for (std::size_t j = 0; j < n; ++j) rotate(a[p][j], a[q][j]);
                for (int k = 0; k < 3; ++k) rotate(rotation[k][p], rotation[k][q]);
            }
        if (is_orthogonal) break;
    }
    double square[3], largest = 0;
    for (int k = 0; k < 3; ++k) {
        square[k] = product(a[k], a[k]);
        largest = std::max(largest, square[k]);
    }
    for (std::size_t j = 0; j < n; ++j)
        for (int k = 0; k < 3; ++k) {
            double x = 0;
            for (int i = 0; i < 3; ++i)
                if (square[i] > least_extent * least_extent * largest)
                    x += rotation[k][i] * (a[i][j] / square[i]);
            rows_[j].x[k] = x;
        }
}

}  // namespace mgdt
