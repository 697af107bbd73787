// SPDX-License-Identifier: MIT
// Cells, alphas and interpolation of any points, in regions of any planes and at any places: they
// are refused with a status, or are numbers that can be and that two handles agree on to the last
// bit, one of which had the points in another order and had more of them for a while.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "comparison.hpp"

namespace fuzz {
namespace {

using Numbers = std::vector<double>;

// Sums and products of a few are in the range of doubles.
bool is_ordinary(const Numbers& x) {
    return std::all_of(x.begin(), x.end(), [](double v) {
        return v == 0 || (std::fabs(v) > 1e-50 && std::fabs(v) < 1e50);
    });
}

// NaN is NaN.
bool is_same(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

class Measured {
  public:
    explicit Measured(Input& in) : in_(in) {
        const unsigned b = in.byte();
        source_.choose_sphere(b);
        const bool may_be_wide = (b & 12) == 0;
        unsigned kind = draw_kind(may_be_wide);
        const bool is_mixed = in.flag();
        const std::size_t n = 4 + (in.byte() & (may_be_wide ? 7 : 31));
        while (points_.size() < n && !in_.empty()) {
            if (is_mixed) kind = draw_kind(may_be_wide);
            const Point p = source_.draw(in, kind, points_);
            if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
                points_.push_back(p);
        }
        for (const Point& p : points_) xyz_.insert(xyz_.end(), p.begin(), p.end());
        one_ = made(0, 1);
        other_ = made(order_schemes[in.below(static_cast<unsigned>(order_schemes.size()))], 3);
        insert(one_, xyz_);
        insert_with_others();
    }

    void run() {
        if (points_.empty()) return;
        measure_cells();
        measure_alphas();
        interpolate();
    }

  private:
    unsigned draw_kind(bool may_be_wide) {
        return in_.below(may_be_wide ? PointSource::kinds : PointSource::exponents);
    }
    static Handle made(std::int32_t scheme, std::int32_t threads) {
        mgdt_triangulation* t = nullptr;
        FUZZ_REQUIRE(mgdt_create(&t) == MGDT_OK, "create");
        Handle handle(t);
        FUZZ_REQUIRE(scheme == 0 || mgdt_set_order_scheme(t, scheme) == MGDT_OK, error_of(t));
        FUZZ_REQUIRE(mgdt_set_threads(t, threads) == MGDT_OK, error_of(t));
        FUZZ_REQUIRE(mgdt_set_canonical_output(t, 1) == MGDT_OK, error_of(t));
        return handle;
    }
    static void insert(const Handle& t, const Numbers& xyz) {
        FUZZ_REQUIRE(mgdt_insert_points(t.get(), static_cast<std::int64_t>(xyz.size() / 3),
                                        xyz.data()) == MGDT_OK,
                     error_of(t.get()));
    }
    // The same points with some more behind them, which leave again. Where sizes are extreme, more
    // points might change the power of two by which the handle scales all, and so the stage that
    // ends up to measure something.
    void insert_with_others() {
        insert(other_, xyz_);
        if (!is_ordinary(xyz_)) return;
        Numbers more;
        Indices out;
        for (unsigned i = in_.below(4); i > 0; --i) {
            const Point p = source_.draw(in_, PointSource::tiny, points_);
            more.insert(more.end(), p.begin(), p.end());
            out.push_back(static_cast<std::int64_t>(points_.size() + out.size()));
        }
        insert(other_, more);
        FUZZ_REQUIRE(mgdt_remove_points(other_.get(), static_cast<std::int64_t>(out.size()),
                                        out.data()) == MGDT_OK,
                     error_of(other_.get()));
        FUZZ_REQUIRE(mgdt_renumber_points(other_.get(), mgdt_point_count(other_.get()),
                                          Indices(points_.size() + out.size()).data()) == MGDT_OK,
                     error_of(other_.get()));
    }
    // What a call writes, the same from both handles; nothing where it is refused. `call` takes a
    // handle and the numbers.
    template <class Call>
    bool agreed(std::size_t size, Numbers& x, const Call& call) const {
        Numbers y(size, -7);
        x.assign(size, -7);
        const mgdt_status status = call(one_.get(), x), same = call(other_.get(), y);
        FUZZ_REQUIRE(status == same, error_of(one_.get()) + " / " + error_of(other_.get()));
        for (std::size_t i = 0; i < size; ++i)
            FUZZ_REQUIRE(is_same(x[i], y[i]), std::to_string(i) + " of " + std::to_string(size) +
                                                  ": " + std::to_string(x[i]) + " and " +
                                                  std::to_string(y[i]));
        if (status == MGDT_OK) return true;
        FUZZ_REQUIRE(status == MGDT_ERR_INVALID_ARGUMENT || status == MGDT_ERR_NOT_FINITE,
                     error_of(one_.get()));
        FUZZ_REQUIRE(std::all_of(x.begin(), x.end(), [](double v) { return v == -7; }),
                     "written, and refused");
        return false;
    }

    // ---------------------------------------------------------------------------------- cells

    // A box that has the points inside or on it, and planes that have them inside but for
    // rounding; of any size.
    Numbers draw_planes(bool& is_box) {
        Numbers planes;
        const unsigned b = in_.byte();
        is_box = (b & 3) != 0;
        const double margin = (b & 4) != 0 ? 0 : std::ldexp(1.0, static_cast<int>(b >> 3) - 16);
        for (std::size_t k = 0; k < (is_box ? 3u : 0u); ++k) {
            double low = points_[0][k], high = low;
            for (const Point& p : points_) {
                low = std::min(low, p[k]);
                high = std::max(high, p[k]);
            }
            for (const double sign : {1.0, -1.0}) {
                Numbers plane = {0, 0, 0, margin + (sign > 0 ? high : -low)};
                plane[k] = sign;
                planes.insert(planes.end(), plane.begin(), plane.end());
            }
        }
        for (unsigned i = in_.below(4); i > 0; --i) {
            const Point normal = source_.draw(in_, PointSource::plane, points_);
            double top = -std::numeric_limits<double>::infinity();
            for (const Point& p : points_)
                top = std::max(top, normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2]);
            planes.insert(planes.end(), normal.begin(), normal.end());
            planes.push_back(top + margin);
            is_box = false;
        }
        return planes;
    }

    // The arrays of the diagram of a handle; nothing if there is none.
    static std::vector<Numbers> diagram(const Handle& t, const Numbers& planes) {
        mgdt_voronoi* v = nullptr;
        const mgdt_status status = mgdt_voronoi_create(
            t.get(), static_cast<std::int64_t>(planes.size() / 4), planes.data(), &v);
        FUZZ_REQUIRE((status == MGDT_OK) == (v != nullptr), "a handle of a failed call");
        if (status != MGDT_OK) return {};
        std::vector<Numbers> all;
        constexpr std::int32_t arrays[] = {
            MGDT_VORONOI_ARRAY_FACE_OFFSETS,   MGDT_VORONOI_ARRAY_FACE_CORNERS,
            MGDT_VORONOI_ARRAY_FACE_SIDES,     MGDT_VORONOI_ARRAY_RAY_VERTICES,
            MGDT_VORONOI_ARRAY_CELL_OFFSETS,   MGDT_VORONOI_ARRAY_CELL_FACES,
            MGDT_VORONOI_ARRAY_CELL_BOUNDED,   MGDT_VORONOI_ARRAY_VERTICES,
            MGDT_VORONOI_ARRAY_RAY_DIRECTIONS, MGDT_VORONOI_ARRAY_FACE_AREAS,
            MGDT_VORONOI_ARRAY_FACE_NORMALS,   MGDT_VORONOI_ARRAY_FACE_CENTROIDS,
            MGDT_VORONOI_ARRAY_CELL_VOLUMES,   MGDT_VORONOI_ARRAY_CELL_CENTROIDS};
        for (const std::int32_t array : arrays) {
            std::int64_t size = -1;
            FUZZ_REQUIRE(mgdt_voronoi_get_size(v, array, &size) == MGDT_OK && size >= 0, "size");
            Numbers x(static_cast<std::size_t>(size));
            if (array < MGDT_VORONOI_ARRAY_VERTICES) {
                Indices integers(x.size());
                FUZZ_REQUIRE(mgdt_voronoi_get_array(v, array, size, integers.data()) == MGDT_OK,
                             "array");
                for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(integers[i]);
            } else {
                FUZZ_REQUIRE(mgdt_voronoi_get_doubles(v, array, size, x.data()) == MGDT_OK,
                             "doubles");
            }
            all.push_back(x);
        }
        FUZZ_REQUIRE(mgdt_voronoi_drop_small_faces(v, 0, 1e-6) == MGDT_OK, "small faces");
        mgdt_voronoi_destroy(v);
        return all;
    }
    // Diagrams agree to the last bit, and with the measures of cells.
    void diagrams(const Numbers& planes, const Numbers* volumes, const Numbers& faces) {
        const std::vector<Numbers> one = diagram(one_, planes), other = diagram(other_, planes);
        FUZZ_REQUIRE(one.empty() == (volumes == nullptr), "a diagram, and no measures");
        FUZZ_REQUIRE(one.size() == other.size(), "a diagram of one handle");
        for (std::size_t a = 0; a < one.size(); ++a) {
            FUZZ_REQUIRE(one[a].size() == other[a].size(), "sizes of array " + std::to_string(a));
            for (std::size_t i = 0; i < one[a].size(); ++i)
                FUZZ_REQUIRE(is_same(one[a][i], other[a][i]),
                             "element " + std::to_string(i) + " of array " + std::to_string(a) +
                                 ": " + std::to_string(one[a][i]) + " and " +
                                 std::to_string(other[a][i]));
        }
        if (one.empty() || one[4].size() <= 1) return;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            FUZZ_REQUIRE(one[4][i + 1] - one[4][i] == faces[i], "faces of a cell");
            const double a = one[12][i], b = (*volumes)[i];
            FUZZ_REQUIRE(a == b || std::fabs(a - b) <= 2e-12 * b + 1e-300,
                         "volumes " + std::to_string(a) + " and " + std::to_string(b));
        }
    }

    void measure_cells() {
        bool is_box = false;
        const Numbers planes = draw_planes(is_box);
        const std::size_t n = points_.size();
        const auto measured = [&](std::int32_t measure, std::size_t width, Numbers& x) {
            return agreed(width * n, x, [&](const mgdt_triangulation* t, Numbers& to) {
                return mgdt_get_cell_measures(
                    t, measure, static_cast<std::int64_t>(planes.size() / 4), planes.data(),
                    static_cast<std::int64_t>(to.size()), to.data());
            });
        };
        Numbers volumes, areas, centroids, faces;
        const bool is_taken = measured(MGDT_MEASURE_VOLUME, 1, volumes);
        FUZZ_REQUIRE(measured(MGDT_MEASURE_AREA, 1, areas) == is_taken, "areas");
        FUZZ_REQUIRE(measured(MGDT_MEASURE_CENTROID, 3, centroids) == is_taken, "centroids");
        FUZZ_REQUIRE(measured(MGDT_MEASURE_FACES, 1, faces) == is_taken, "faces");
        diagrams(planes, is_taken ? &volumes : nullptr, faces);
        if (!is_taken) return;
        double sum = 0;
        for (std::size_t i = 0; i < n; ++i) {
            FUZZ_REQUIRE(volumes[i] >= 0 && areas[i] >= 0, "a measure is negative or NaN");
            FUZZ_REQUIRE(faces[i] == std::floor(faces[i]) && faces[i] >= 0, "a number of faces");
            FUZZ_REQUIRE(!(volumes[i] > 0) || std::isinf(volumes[i]) || faces[i] >= 4,
                         "a cell with few faces");
            sum += volumes[i];
        }
        if (!is_ordinary(xyz_) || !is_ordinary(planes)) return;
        for (std::size_t i = 0; i < n; ++i) {
            if (!std::isfinite(volumes[i]) || volumes[i] < 1e-100) continue;
            // No body has less surface than a ball.
            FUZZ_REQUIRE(
                113 * volumes[i] * volumes[i] <= areas[i] * areas[i] * areas[i] * (1 + 1e-9),
                "less surface than a ball");
            for (std::size_t p = 0; p < planes.size(); p += 4) {
                double height = -planes[p + 3], terms = std::fabs(planes[p + 3]);
                for (std::size_t k = 0; k < 3; ++k) {
                    height += planes[p + k] * centroids[3 * i + k];
                    terms += std::fabs(planes[p + k] * centroids[3 * i + k]);
                }
                FUZZ_REQUIRE(height <= 1e-11 * terms, "a centroid is outside");
            }
        }
        if (!is_box) return;
        const double volume =
            (planes[3] + planes[7]) * (planes[11] + planes[15]) * (planes[19] + planes[23]);
        if (volume > 1e-100 && std::isfinite(sum))
            FUZZ_REQUIRE(std::fabs(sum - volume) <= 1e-11 * volume, "cells do not fill the box");
    }

    // --------------------------------------------------------------------------------- alphas

    void measure_alphas() {
        const mgdt_triangulation* const t = one_.get();
        const auto tetrahedra = static_cast<std::size_t>(mgdt_tetrahedron_count(t));
        const std::size_t sizes[4] = {points_.size(), static_cast<std::size_t>(mgdt_edge_count(t)),
                                      4 * tetrahedra, tetrahedra};
        Numbers alphas[4];
        for (int dimension = 0; dimension < 4; ++dimension)
            agreed(sizes[dimension], alphas[dimension],
                   [&](const mgdt_triangulation* of, Numbers& to) {
                       return mgdt_get_alphas(of, dimension, static_cast<std::int64_t>(to.size()),
                                              to.data());
                   });
        if (tetrahedra == 0) return;
        for (std::size_t i = 0; i < 4 * tetrahedra; ++i)
            FUZZ_REQUIRE(alphas[2][i] >= 0 && alphas[2][i] <= alphas[3][i / 4],
                         "the alpha of a facet is above that of its tetrahedron");
        Numbers solid;
        agreed(1, solid, [](const mgdt_triangulation* of, Numbers& to) {
            return mgdt_get_solid_alpha(of, to.data());
        });
        require_closed(alphas[3][in_.byte() % tetrahedra]);
    }

    void require_closed(double alpha2) const {
        std::int64_t count = -1;
        mgdt_get_alpha_surface(one_.get(), alpha2, 0, nullptr, &count);
        Indices v(3 * static_cast<std::size_t>(count));
        FUZZ_REQUIRE(mgdt_get_alpha_surface(one_.get(), alpha2, static_cast<std::int64_t>(v.size()),
                                            v.data(), &count) == MGDT_OK,
                     error_of(one_.get()));
        std::map<std::pair<std::int64_t, std::int64_t>, int> turns;
        for (std::size_t i = 0; i < v.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int64_t a = v[i + k], b = v[i + (k + 1) % 3];
                turns[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
            }
        for (const auto& [edge, sum] : turns) FUZZ_REQUIRE(sum == 0, "a surface is open");
    }

    // -------------------------------------------------------------------------- interpolation

    void interpolate() {
        Numbers places;
        for (int i = 0; i < 6; ++i) {
            const unsigned b = in_.byte();
            const unsigned kind = b < 64    ? PointSource::repeat
                                  : b < 192 ? PointSource::between
                                            : b % PointSource::exponents;
            const Point q = source_.draw(in_, kind, points_);
            places.insert(places.end(), q.begin(), q.end());
        }
        const std::size_t n = points_.size();
        Numbers values(n);
        for (std::size_t i = 0; i < n; ++i) values[i] = static_cast<double>(i % 5) - 2;
        for (const std::int32_t method :
             {MGDT_INTERPOLATE_LINEAR, MGDT_INTERPOLATE_NEAREST, MGDT_INTERPOLATE_SIBSON,
              MGDT_INTERPOLATE_LAPLACE, MGDT_INTERPOLATE_SIBSON_C1}) {
            const std::int32_t outside = 10 * static_cast<std::int32_t>(1 + in_.below(4));
            Numbers results;
            const bool is_taken = agreed(6, results, [&](const mgdt_triangulation* t, Numbers& to) {
                return mgdt_interpolate(t, method, outside, 1, values.data(), 6, places.data(),
                                        to.data());
            });
            // Gradients between points that are next to each other in extreme units overflow.
            const bool has_gradients =
                method == MGDT_INTERPOLATE_SIBSON_C1 || outside == MGDT_OUTSIDE_LINEAR;
            if (is_taken && (!has_gradients || is_ordinary(xyz_)))
                compare_with_weights(method, outside, places, values, results);
        }
    }

    void compare_with_weights(std::int32_t method, std::int32_t outside, const Numbers& places,
                              const Numbers& values, const Numbers& results) const {
        const mgdt_triangulation* const t = one_.get();
        Indices offsets(7);
        FUZZ_REQUIRE(mgdt_get_interpolation_weights(t, method, outside, 6, places.data(), 7,
                                                    offsets.data(), 0, nullptr, nullptr) == MGDT_OK,
                     error_of(t));
        Indices points(static_cast<std::size_t>(offsets[6]));
        Numbers weights(points.size());
        FUZZ_REQUIRE(
            mgdt_get_interpolation_weights(t, method, outside, 6, places.data(), 7, offsets.data(),
                                           offsets[6], points.data(), weights.data()) == MGDT_OK,
            error_of(t));
        const bool is_positive =
            method != MGDT_INTERPOLATE_SIBSON_C1 && outside != MGDT_OUTSIDE_LINEAR;
        for (std::size_t i = 0; i < 6; ++i) {
            const auto begin = static_cast<std::size_t>(offsets[i]),
                       end = static_cast<std::size_t>(offsets[i + 1]);
            FUZZ_REQUIRE((begin == end) == std::isnan(results[i]), "weights and no value");
            double sum = 0, mean = 0, size = 0;
            for (std::size_t k = begin; k < end; ++k) {
                const double value = values[static_cast<std::size_t>(points[k])];
                sum += weights[k];
                mean += weights[k] * value;
                size += std::fabs(weights[k]);
                FUZZ_REQUIRE(!is_positive || weights[k] >= 0, "a weight is negative");
            }
            if (begin == end || !(size < 1e6)) continue;
            FUZZ_REQUIRE(std::fabs(sum - 1) <= 1e-13 * size, std::to_string(sum));
            FUZZ_REQUIRE(std::fabs(mean - results[i]) <= 1e-9 * size,
                         std::to_string(mean) + " and " + std::to_string(results[i]));
        }
    }

    Input& in_;
    PointSource source_;
    std::vector<Point> points_;
    Numbers xyz_;
    Handle one_, other_;
};

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    fuzz::Measured(in).run();
    return 0;
}
