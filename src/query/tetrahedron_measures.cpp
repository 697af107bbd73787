// SPDX-License-Identifier: MIT
#include "query/tetrahedron_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "parallel/watched_split.hpp"
#include "predicates/bounded_numbers.hpp"
#include "predicates/vector.hpp"

namespace mgdt {
namespace {

// What all measures are made of. B is double, or a number with a bound on its error.
template <class B>
struct Shape {
    // The edges, named by their two vertices.
    Vector<B> e01, e02, e03, e12, e13, e23;
    // Twice the area of the facet opposite each vertex times its normal; all point outward or all
    // point inward.
    Vector<B> normal[4];
    B volume6;  // six times the volume, positive or negative

    template <class Difference>
    void set(const double* const (&p)[4], const Difference& difference) {
        e01 = difference(p[1], p[0]);
        e02 = difference(p[2], p[0]);
        e03 = difference(p[3], p[0]);
        e12 = difference(p[2], p[1]);
        e13 = difference(p[3], p[1]);
        e23 = difference(p[3], p[2]);
        normal[0] = cross(e13, e12);
        normal[1] = cross(e02, e03);
        normal[2] = cross(e03, e01);
        normal[3] = cross(e01, e02);
        volume6 = dot(e01, normal[1]);
    }
    std::array<const Vector<B>*, 6> edges() const { return {&e01, &e02, &e03, &e12, &e13, &e23}; }
    // The edge between the two vertices other than i and j, which is common to their facets.
    const Vector<B>& edge_of_facets(int i, int j) const {
        const Vector<B>* const edges[] = {&e23, &e13, &e12, &e03, &e02, &e01};
        return *edges[i == 0 ? j - 1 : i + j];
    }
    // 12 times the volume times the position of the circumcentre relative to vertex 0.
    Vector<B> center_numerator() const {
        return (dot(e01, e01) * normal[1] + dot(e02, e02) * normal[2]) + dot(e03, e03) * normal[3];
    }
};

// Sorts the vertices, so that the rounding of a measure does not depend on their order.
void sort_vertices(const double* (&p)[4]) {
    std::sort(p, p + 4, [](const double* a, const double* b) {
        return std::lexicographical_compare(a, a + 3, b, b + 3);
    });
}

double angle_in_doubles(const Shape<double>& shape, int i, int j) {
    return std::atan2(length(shape.edge_of_facets(i, j)) * std::fabs(shape.volume6),
                      -dot(shape.normal[i], shape.normal[j]));
}

template <class Angle>
double extreme_angle(bool is_largest, const Angle& angle) {
    double extreme = angle(0, 1);
    for (int i = 0; i < 4; ++i) {
        for (int j = i + 1; j < 4; ++j)
            extreme = is_largest ? std::max(extreme, angle(i, j)) : std::min(extreme, angle(i, j));
    }
    return extreme;
}

// For 6 sqrt(2) V / (S/6)^(3/2), where S is the sum of the squares of the edges, and 6 V is known.
constexpr double volume_length_factor = 20.784609690826527522;  // 12 sqrt(3)

WideDouble root(const WideDouble& x) {
    return x.mantissa == 0 ? x : over_root(x, x);
}

// A measure in numbers with bounds. Returns false if the bounds do not determine it well enough.
template <class Numbers>
bool measure_in(Numbers& numbers, const double* const (&p)[4], int scale,
                TetrahedronMeasure measure, double& x) {
    using B = typename Numbers::B;
    const WideDouble tolerance(0x1p-44);
    bool is_known = true;
    const auto known = [&](const B& number) {
        is_known &= number.wide_error() < tolerance * magnitude(number.wide());
        return magnitude(number.wide());
    };
    Shape<B> shape;
    shape.set(p, [&](const double* a, const double* b) {
        Vector<B> d;
        for (int k = 0; k < 3; ++k) d.x[k] = numbers.difference(a[k], b[k]);
        return d;
    });
    const auto squares = [&] {
        std::array<WideDouble, 6> all;
        std::size_t i = 0;
        for (const Vector<B>* edge : shape.edges()) all[i++] = known(dot(*edge, *edge));
        return all;
    };
    if (measure == TetrahedronMeasure::longest_edge || measure == TetrahedronMeasure::edge_ratio) {
        const auto all = squares();
        const auto [shortest, longest] = std::minmax_element(all.begin(), all.end());
        x = measure == TetrahedronMeasure::longest_edge
                ? (root(*longest) * WideDouble(1, -scale)).in_double()
                : (root(*longest) / root(*shortest)).in_double();
        return is_known;
    }
    const WideDouble volume6 = known(shape.volume6);
    if (measure == TetrahedronMeasure::volume_length) {
        WideDouble sum;
        for (const WideDouble& square : squares()) sum = sum + square;
        x = (WideDouble(volume_length_factor) * volume6 / (sum * root(sum))).in_double();
        return is_known;
    }
    if (measure == TetrahedronMeasure::volume) {
        x = (volume6 * WideDouble(1, -3 * std::int64_t{scale}) / WideDouble(6)).in_double();
        return is_known;
    }
    WideDouble square[4];  // of four times the areas
    for (int i = 0; i < 4; ++i) square[i] = known(dot(shape.normal[i], shape.normal[i]));
    if (measure == TetrahedronMeasure::radius_ratio) {
        WideDouble areas;
        for (const WideDouble& s : square) areas = areas + root(s);
        const Vector<B> center = shape.center_numerator();
        x = (WideDouble(6) * volume6 * volume6 / (areas * root(known(dot(center, center)))))
                .in_double();
        return is_known;
    }
    x = extreme_angle(measure == TetrahedronMeasure::largest_dihedral_angle, [&](int i, int j) {
        const Vector<B>& edge = shape.edge_of_facets(i, j);
        const B cosine = dot(shape.normal[i], shape.normal[j]);
        const WideDouble size = root(square[i] * square[j]);
        is_known &= cosine.wide_error() < tolerance * size;
        return std::atan2((root(known(dot(edge, edge))) * volume6 / size).in_double(),
                          -(cosine.wide() / size).in_double());
    });
    return is_known;
}

}  // namespace

bool exact::measure_in_doubles(const double* const (&p)[4], int scale, TetrahedronMeasure measure,
                               double& x, double flatness) {
    // The edges are multiplied by a power of two that brings the largest coordinate near 1. So
    // nothing overflows, what underflows is far below the rounding errors, and the result does not
    // depend on the scale of the mesh.
    double largest = 0;
    for (int i = 1; i < 4; ++i)
        for (int k = 0; k < 3; ++k) largest = std::max(largest, std::fabs(p[i][k] - p[0][k]));
    const int exponent = 1 + (std::isinf(largest) ? 1024 : std::ilogb(largest));
    Shape<double> shape;
    shape.set(p, [exponent](const double* a, const double* b) {
        Vector<double> d;
        for (int k = 0; k < 3; ++k) {
            const double whole = a[k] - b[k];
            d.x[k] = std::isinf(whole) ? std::ldexp(0.5 * a[k] - 0.5 * b[k], 1 - exponent)
                                       : std::ldexp(whole, -exponent);
        }
        return d;
    });
    const int unscaled = exponent - scale;
    double square = 0, least_square = HUGE_VAL, sum = 0;
    for (const Vector<double>* edge : shape.edges()) {
        const double length2 = dot(*edge, *edge);
        square = std::max(square, length2);
        least_square = std::min(least_square, length2);
        sum += length2;
    }
    const double longest = std::sqrt(square), volume6 = std::fabs(shape.volume6);
    if (measure == TetrahedronMeasure::longest_edge) {
        x = std::ldexp(longest, unscaled);
        return true;
    }
    if (measure == TetrahedronMeasure::edge_ratio) {
        // A shorter edge may have lost digits to underflow.
        constexpr double least = 0x1p-900;
        x = longest / std::sqrt(least_square);
        return least_square > least;
    }
    if (!(volume6 > flatness * (longest * square))) return false;
    switch (measure) {
        case TetrahedronMeasure::radius_ratio: {
            double areas = 0;
            for (const Vector<double>& normal : shape.normal) areas += length(normal);
            x = 6 * (volume6 * volume6) / (areas * length(shape.center_numerator()));
            break;
        }
        case TetrahedronMeasure::volume_length:
            x = volume_length_factor * volume6 / (sum * std::sqrt(sum));
            break;
        case TetrahedronMeasure::least_dihedral_angle:
        case TetrahedronMeasure::largest_dihedral_angle:
            x = extreme_angle(measure == TetrahedronMeasure::largest_dihedral_angle,
                              [&](int i, int j) { return angle_in_doubles(shape, i, j); });
            break;
        default:
            x = std::ldexp(volume6 / 6, 3 * unscaled);
    }
    return true;
}

double measure_tetrahedron(const double* const (&p)[4], int scale, TetrahedronMeasure measure,
                           Allocator& allocator) {
    const double* sorted[4] = {p[0], p[1], p[2], p[3]};
    sort_vertices(sorted);
    double x = 0;
    const double least = measure == TetrahedronMeasure::volume ? exact::least_volume_for_volumes
                                                               : exact::least_volume_in_doubles;
    if (exact::measure_in_doubles(sorted, scale, measure, x, least)) return x;
    BoundedFloats<Twofold> twofold;
    if (measure_in(twofold, sorted, scale, measure, x)) return x;
    constexpr std::size_t any_number_of_limbs = 0;
    BoundedLongs exact_numbers(allocator, any_number_of_limbs);
    measure_in(exact_numbers, sorted, scale, measure, x);
    return x;
}

void export_tetrahedron_measures(const MeshView& view, TetrahedronMeasure measure,
                                 StageProgress& progress, double* x) {
    const Mesh& mesh = view.mesh;
    const Numbering& numbering = *view.numbering;
    constexpr std::size_t stretches_per_thread = 64, ahead = 16;
    watched_split(view.team, progress, numbering.stretches(), stretches_per_thread,
                  [&](std::size_t begin, std::size_t end) {
                      numbering.for_each(begin, end, [&](TetId id, std::size_t number) {
                          const Tetrahedron& t = mesh.tetrahedra[id];
                          mesh.tetrahedra.prefetch(id + ahead);
                          x[number] = measure_tetrahedron({mesh.point(t.v[0]), mesh.point(t.v[1]),
                                                           mesh.point(t.v[2]), mesh.point(t.v[3])},
                                                          mesh.scale, measure, view.allocator);
                      });
                  });
}

}  // namespace mgdt
