// SPDX-License-Identifier: MIT
#include "interpolation/gradient.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/star_traversal.hpp"

namespace mgdt {
namespace {

// The gradient is 0 along a direction in which the extent of the neighbours is less than this
// fraction of their largest extent.
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

namespace {

Twofold twofold(double x) {
    return {x, 0};
}
Twofold twofold(const Twofold& x) {
    return x;
}

double root(double x) {
    return std::sqrt(x);
}
Twofold root(const Twofold& x) {
    const double r = std::sqrt(x.high);
    if (r == 0) return {0, 0};
    return Twofold{r, 0} + (x - Twofold::product(r, r)) / Twofold{2 * r, 0};
}

}  // namespace

// Computes the pseudo-inverse of A, the matrix whose rows are unit vectors to the neighbours.
// Rotations in the plane of two axes make the columns of A V orthogonal (Hestenes, Inversion of
// matrices by biorthogonalization and related results, Journal of the SIAM 6, 1958): A V = U S, and
// the pseudo-inverse is V S^-1 U^T.
template <class Real>
double Gradient::set_directions(const Mesh& mesh, VertexId v, Buffer<Real>& columns) {
    const std::size_t n = neighbors_.size();
    columns.clear();
    columns.resize(3 * n);
    Real* const a[3] = {columns.data(), columns.data() + n, columns.data() + 2 * n};
    const Real zero = to_real<Real>(0), one = to_real<Real>(1);
    for (std::size_t j = 0; j < n; ++j) {
        const double *const to = mesh.point(neighbors_[j]), *const from = mesh.point(v);
        Vector<Real> d;
        double largest = 0;
        const auto set = [&](double part) {
            largest = 0;
            for (int k = 0; k < 3; ++k) {
                set_difference(d.x[k], part * to[k], part * from[k]);
                largest = std::max(largest, std::fabs(nearest_double(d.x[k])));
            }
        };
        double part = 1;
        set(part);
        if (!std::isfinite(largest)) set(part = 0.25);
        // Scales by a power of two, so that lengths are near 1.
        const int exponent = std::ilogb(largest);
        for (Real& x : d.x)
            x = scaled_by(scaled_by(x, std::ldexp(1.0, -exponent / 2)),
                          std::ldexp(1.0, -exponent + exponent / 2));
        const Real length = root(dot(d, d));
        for (int k = 0; k < 3; ++k) a[k][j] = d.x[k] / length;
        rows_[j].distance = std::ldexp(nearest_double(length), exponent) / part;
    }
    Real rotation[3][3] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
    const auto product = [n, zero](const Real* x, const Real* y) {
        Real sum = zero;
        for (std::size_t j = 0; j < n; ++j) sum = sum + x[j] * y[j];
        return sum;
    };
    constexpr int most_sweeps = 16;  // each sweep squares the remaining error
    constexpr double least_cosine = 2 * rounding_of<Real>;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        bool is_orthogonal = true;
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                const Real pp = product(a[p], a[p]), qq = product(a[q], a[q]),
                           pq = product(a[p], a[q]);
                if (!(std::fabs(nearest_double(pq)) >
                      least_cosine * std::sqrt(nearest_double(pp) * nearest_double(qq))))
                    continue;
                is_orthogonal = false;
                // The angle may be rounded, but the rotation must be orthogonal to the last bits.
                const double zeta = nearest_double(qq - pp) / (2 * nearest_double(pq));
                const double t =
                    std::copysign(1 / (std::fabs(zeta) + std::sqrt(1 + zeta * zeta)), zeta);
                const Real tangent = to_real<Real>(t), c = one / root(one + tangent * tangent),
                           s = c * tangent;
                const auto rotate = [c, s](Real& x, Real& y) {
                    const Real old = x;
                    x = c * old - s * y;
                    y = s * old + c * y;
                };
                for (std::size_t j = 0; j < n; ++j) rotate(a[p][j], a[q][j]);
                for (int k = 0; k < 3; ++k) rotate(rotation[k][p], rotation[k][q]);
            }
        if (is_orthogonal) break;
    }
    Real square[3];
    double largest = 0, least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        square[k] = product(a[k], a[k]);
        largest = std::max(largest, nearest_double(square[k]));
        least = std::min(least, nearest_double(square[k]));
    }
    const auto counts = [&](const Real& x) {
        return nearest_double(x) > least_extent * least_extent * largest;
    };
    for (std::size_t j = 0; j < n; ++j)
        for (int k = 0; k < 3; ++k) {
            Real x = zero;
            for (int i = 0; i < 3; ++i)
                if (counts(square[i])) x = x + rotation[k][i] * (a[i][j] / square[i]);
            rows_[j].direction.x[k] = twofold(x);
        }
    return n == 0 ? 1 : std::sqrt(least / largest);
}

// The distance of the nearest neighbour divided by the distance of the farthest neighbour. The
// slope towards a very close neighbour is steep, and the rounding of this slope affects all
// directions.
double Gradient::nearness() const {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const Row& row : rows_) {
        least = std::min(least, row.distance);
        most = std::max(most, row.distance);
    }
    return rows_.empty() ? 1 : least / most;
}

void Gradient::find(const Locator& where, VertexId v) {
    gather(where, v);
    rows_.clear();
    rows_.resize(neighbors_.size());
    constexpr double thin = 0x1p-10;
    is_thin_ = set_directions(where.mesh, v, columns_) < thin || nearness() < thin;
    if (is_thin_) set_directions(where.mesh, v, twofold_columns_);
}

}  // namespace mgdt
