// SPDX-License-Identifier: MIT
// Calls of the interface of periodic boxes in any order, with any vectors and points: what is built
// passes the check, has the numbers of a torus, fills the box with cells, and does not depend on
// the calls before; and what fails says so.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../support/messages.hpp"
#include "mgdt/mgdt_periodic.h"
#include "points.hpp"

namespace fuzz {
namespace {

std::vector<std::int64_t> array(const mgdt_periodic* p, std::int32_t which) {
    std::int64_t size = -1;
    FUZZ_REQUIRE(mgdt_periodic_get_size(p, which, &size) == MGDT_OK, "size");
    std::vector<std::int64_t> values(static_cast<std::size_t>(size));
    FUZZ_REQUIRE(mgdt_periodic_get_array(p, which, size, values.data()) == MGDT_OK, "array");
    return values;
}

std::int64_t number(const mgdt_periodic* p, std::int32_t key) {
    std::int64_t value = -1;
    FUZZ_REQUIRE(mgdt_periodic_get_stat(p, key, &value) == MGDT_OK, "stat");
    return value;
}

std::string message_of(const mgdt_periodic* p) {
    return mgdt_tests::message_of(p, mgdt_periodic_get_error);
}

class Session {
  public:
    explicit Session(Input& in) : in_(in) {}
    ~Session() { mgdt_periodic_destroy(p_); }

    void run() {
        FUZZ_REQUIRE(mgdt_periodic_create(&p_) == MGDT_OK, "create");
        if (!set_vectors()) return;
        source_.choose_sphere(in_.below(4));
        for (int calls = 0; calls < 24 && !in_.empty(); ++calls) switch (in_.below(9)) {
                case 0:
                    base_ = in_.below(2);
                    FUZZ_REQUIRE(mgdt_periodic_set_option(p_, MGDT_PERIODIC_OPTION_INDEX_BASE,
                                                          base_) == MGDT_OK,
                                 "base");
                    break;
                case 1:
                    FUZZ_REQUIRE(mgdt_periodic_clear(p_) == MGDT_OK, "clear");
                    points_.clear();
                    break;
                case 2:
                    build();
                    break;
                case 3:
                case 4:
                    move();
                    break;
                case 5:
                    set_vectors();
                    break;
                case 6:
                    mgdt_periodic_cancel(p_);
                    FUZZ_REQUIRE(mgdt_periodic_build(p_) != MGDT_OK, "cancelled");
                    break;
                default:
                    insert();
            }
        build();
    }

  private:
    // Vectors of few bits, so that boxes are cubes, oblique, flat or none; or any.
    void draw_vectors() {
        dimensions_ = static_cast<std::int32_t>(in_.below(5));
        const unsigned kind = in_.below(4);
        static constexpr double scales[8] = {1, 1, 0.1, 3, 1e-3, 0x1p-600, 0x1p600, 1e5};
        const double scale = scales[in_.below(8)];
        vectors_.resize(9);
        for (std::size_t i = 0; i < 9; ++i) {
            const unsigned b = kind == 0 ? 0 : in_.byte();
            vectors_[i] = i % 4 == 0 ? 4 : 0;
            if (kind == 2) vectors_[i] += static_cast<int>(b % 8) - 4;
            if (kind == 1 && i % 4 == 0) vectors_[i] = static_cast<int>(b % 16) + 1;
            if (kind == 3) vectors_[i] = PointSource().draw(in_, b % PointSource::kinds, {})[0];
            vectors_[i] *= scale;
        }
    }
    // Sets the vectors, or others, and keeps the former ones if they are refused.
    bool set_vectors() {
        const std::vector<double> before = vectors_;
        const std::int32_t dimensions = dimensions_;
        draw_vectors();
        const mgdt_status status = mgdt_periodic_set_vectors(p_, dimensions_, vectors_.data());
        FUZZ_REQUIRE(status == MGDT_OK || status == MGDT_ERR_INVALID_ARGUMENT ||
                         status == MGDT_ERR_NOT_FINITE,
                     message_of(p_));
        if (status == MGDT_OK) return true;
        vectors_ = before;
        dimensions_ = dimensions;
        return false;
    }
    std::vector<double> draw(unsigned n, std::vector<Point>& points, bool& is_finite) {
        const unsigned kind = in_.below(PointSource::kinds);
        const bool in_units = in_.flag();
        std::vector<double> xyz;
        is_finite = true;
        for (unsigned i = 0; i < n; ++i) {
            Point x = source_.draw(in_, kind, points);
            // Points of few bits are multiples of a quarter of the vectors.
            if (in_units && kind < PointSource::first_after_small) {
                const Point s = x;
                for (std::size_t c = 0; c < 3; ++c)
                    x[c] =
                        (s[0] * vectors_[c] + s[1] * vectors_[3 + c] + s[2] * vectors_[6 + c]) / 4;
            }
            points.push_back(x);
            for (const double c : x) {
                is_finite = is_finite && std::isfinite(c);
                xyz.push_back(c);
            }
        }
        return xyz;
    }
    void insert() {
        const std::size_t before = points_.size();
        bool is_finite;
        const unsigned n = in_.below(12);
        const std::vector<double> xyz = draw(n, points_, is_finite);
        const mgdt_status status = mgdt_periodic_insert_points(p_, n, xyz.data());
        FUZZ_REQUIRE(status == (is_finite ? MGDT_OK : MGDT_ERR_NOT_FINITE), "insert");
        if (!is_finite) points_.resize(before);
    }
    void move() {
        if (points_.empty()) return;
        bool is_finite;
        const unsigned n = 1 + in_.below(4);
        std::vector<Point> places = points_;
        const std::vector<double> xyz = draw(n, places, is_finite);
        std::vector<std::int64_t> which;
        for (unsigned i = 0; i < n; ++i)
            which.push_back(static_cast<std::int64_t>(in_.byte() % points_.size()) + base_);
        std::vector<std::int64_t> sorted = which;
        std::sort(sorted.begin(), sorted.end());
        const bool is_twice = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
        const mgdt_status status = mgdt_periodic_move_points(p_, n, which.data(), xyz.data());
        FUZZ_REQUIRE(status == (!is_finite ? MGDT_ERR_NOT_FINITE
                                : is_twice ? MGDT_ERR_INVALID_ARGUMENT
                                           : MGDT_OK),
                     "move");
        if (status != MGDT_OK) return;
        for (unsigned i = 0; i < n; ++i)
            points_[static_cast<std::size_t>(which[i] - base_)] = {xyz[3 * i], xyz[3 * i + 1],
                                                                   xyz[3 * i + 2]};
    }
    void build() {
        const mgdt_status status = mgdt_periodic_build(p_);
        FUZZ_REQUIRE(status == MGDT_OK || status == MGDT_ERR_INVALID_ARGUMENT, message_of(p_));
        mgdt_periodic* other = nullptr;
        FUZZ_REQUIRE(mgdt_periodic_create(&other) == MGDT_OK, "create");
        FUZZ_REQUIRE(mgdt_periodic_set_vectors(other, dimensions_, vectors_.data()) == MGDT_OK,
                     "vectors");
        if (in_.flag())
            FUZZ_REQUIRE(
                mgdt_periodic_set_option(other, MGDT_PERIODIC_OPTION_THREADS, 2) == MGDT_OK,
                "threads");
        FUZZ_REQUIRE(
            mgdt_periodic_set_option(other, MGDT_PERIODIC_OPTION_INDEX_BASE, base_) == MGDT_OK,
            "base");
        if (!points_.empty())
            FUZZ_REQUIRE(
                mgdt_periodic_insert_points(other, static_cast<std::int64_t>(points_.size()),
                                            points_[0].data()) == MGDT_OK,
                "insert");
        FUZZ_REQUIRE(mgdt_periodic_build(other) == status, message_of(other));
        if (status != MGDT_OK) {
            FUZZ_REQUIRE(!message_of(p_).empty(), "message");
            std::int64_t size;
            FUZZ_REQUIRE(mgdt_periodic_get_size(p_, MGDT_PERIODIC_ARRAY_TETRAHEDRA, &size) ==
                             MGDT_ERR_NOT_BUILT,
                         "no triangulation");
        } else {
            for (std::int32_t which = MGDT_PERIODIC_ARRAY_POINT_MAP;
                 which <= MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_SHIFTS; ++which) {
                std::int64_t size;
                const mgdt_status known = mgdt_periodic_get_size(p_, which, &size);
                FUZZ_REQUIRE(known == MGDT_OK || known == MGDT_ERR_UNKNOWN_KEY, message_of(p_));
                if (known != MGDT_OK) continue;
                FUZZ_REQUIRE(array(p_, which) == array(other, which), "what a fresh box has");
            }
            examine();
        }
        mgdt_periodic_destroy(other);
    }
    void examine() {
        FUZZ_REQUIRE(mgdt_periodic_check(p_) == MGDT_OK, message_of(p_));
        const std::int64_t vertices = number(p_, MGDT_PERIODIC_STAT_VERTICES),
                           tetrahedra = number(p_, MGDT_PERIODIC_STAT_TETRAHEDRA);
        if (dimensions_ == 3)
            FUZZ_REQUIRE(number(p_, MGDT_PERIODIC_STAT_EDGES) == vertices + tetrahedra, "Euler");
        mgdt_voronoi* diagram = nullptr;
        const mgdt_status status = mgdt_periodic_create_voronoi(p_, &diagram);
        const bool has_cells = tetrahedra > 0 || points_.empty();
        FUZZ_REQUIRE(status == (has_cells ? MGDT_OK : MGDT_ERR_INVALID_ARGUMENT), message_of(p_));
        mgdt_voronoi_destroy(diagram);
        if (dimensions_ < 3 || !has_cells || points_.empty()) return;
        std::vector<double> volumes(points_.size());
        FUZZ_REQUIRE(mgdt_periodic_get_cell_measures(p_, MGDT_MEASURE_VOLUME,
                                                     static_cast<std::int64_t>(volumes.size()),
                                                     volumes.data()) == MGDT_OK,
                     "volumes");
        double v[9], sum = 0;
        FUZZ_REQUIRE(mgdt_periodic_get_doubles(p_, MGDT_PERIODIC_ARRAY_VECTORS, 9, v) == MGDT_OK,
                     "vectors");
        const double box =
            std::fabs(v[0] * (v[4] * v[8] - v[5] * v[7]) - v[1] * (v[3] * v[8] - v[5] * v[6]) +
                      v[2] * (v[3] * v[7] - v[4] * v[6]));
        double longest = 0;
        for (const double x : v) longest = std::fmax(longest, std::fabs(x));
        for (const double x : volumes) sum += x;
        // Where cells are needles or volumes are no doubles, little can be said of a sum.
        if (box > 1e-3 * longest * longest * longest && longest > 1e-90 && longest < 1e90)
            FUZZ_REQUIRE(std::fabs(sum - box) <= 1e-6 * box, std::to_string(sum / box));
    }

    Input& in_;
    std::int32_t dimensions_ = 0;
    std::vector<double> vectors_;
    mgdt_periodic* p_ = nullptr;
    PointSource source_;
    std::vector<Point> points_;
    std::int64_t base_ = 0;
};

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    fuzz::Session(in).run();
    return 0;
}
