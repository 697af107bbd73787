// SPDX-License-Identifier: MIT
// Calls of the interface of parts in any order, with any points: what is built is what one handle
// has, and what fails says so.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mgdt/mgdt_parts.h"
#include "points.hpp"

namespace fuzz {
namespace {

using Tetrahedra = std::vector<std::array<std::int64_t, 4>>;

struct Given {
    Point x;
    std::int64_t id;
    std::int32_t part;
};

// By the least id of the points at a place, sorted.
Tetrahedra of_one(const std::vector<Given>& given) {
    mgdt_triangulation* t = nullptr;
    FUZZ_REQUIRE(mgdt_create(&t) == MGDT_OK, "create");
    // Ascending ids, so that the first point at a place has the least.
    std::vector<Given> sorted = given;
    std::sort(sorted.begin(), sorted.end(),
              [](const Given& a, const Given& b) { return a.id < b.id; });
    for (const Given& g : sorted)
        FUZZ_REQUIRE(mgdt_insert_points(t, 1, g.x.data()) == MGDT_OK, "insert");
    const auto count = static_cast<std::size_t>(mgdt_tetrahedron_count(t));
    std::vector<std::int64_t> v(4 * count);
    FUZZ_REQUIRE(mgdt_get_tetrahedra(t, static_cast<std::int64_t>(v.size()), v.data()) == MGDT_OK,
                 "get");
    mgdt_destroy(t);
    Tetrahedra all(count);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < 4; ++k)
            all[i][k] = sorted[static_cast<std::size_t>(v[4 * i + k])].id;
        std::sort(all[i].begin(), all[i].end());
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::vector<std::int64_t> array(const mgdt_parts* p, std::int32_t part, std::int32_t which) {
    std::int64_t size = -1;
    FUZZ_REQUIRE(mgdt_parts_get_size(p, part, which, &size) == MGDT_OK, "size");
    std::vector<std::int64_t> values(static_cast<std::size_t>(size));
    FUZZ_REQUIRE(mgdt_parts_get_array(p, part, which, size, values.data()) == MGDT_OK, "array");
    return values;
}

// Those that a part owns.
void append(const mgdt_parts* p, std::int32_t part, std::int64_t base, Tetrahedra& all) {
    std::int64_t owned = -1;
    FUZZ_REQUIRE(mgdt_parts_get_stat(p, part, MGDT_PARTS_OWN_TETRAHEDRA, &owned) == MGDT_OK,
                 "stat");
    const std::vector<std::int64_t> corners = array(p, part, MGDT_PARTS_LOCAL_CORNERS),
                                    ids = array(p, part, MGDT_PARTS_VERTEX_IDS);
    for (std::size_t i = 0; i < static_cast<std::size_t>(owned); ++i) {
        std::array<std::int64_t, 4> v;
        for (std::size_t k = 0; k < 4; ++k)
            v[k] = ids[static_cast<std::size_t>(corners[4 * i + k] - base)];
        std::sort(v.begin(), v.end());
        all.push_back(v);
    }
}

struct Look {
    std::int64_t base;
    Tetrahedra all;
};

class Session {
  public:
    explicit Session(Input& in) : in_(in), parts_(static_cast<std::int32_t>(1 + in.below(9))) {
        FUZZ_REQUIRE(mgdt_parts_create(parts_, &p_) == MGDT_OK, "create");
        source_.choose_sphere(in.below(4));
        has_ids_ = in.flag();
    }
    ~Session() { mgdt_parts_destroy(p_); }

    void run() {
        for (int calls = 0; calls < 40 && !in_.empty(); ++calls) switch (in_.below(8)) {
                case 0:
                    base_ = in_.below(2);
                    FUZZ_REQUIRE(mgdt_parts_set_option(p_, MGDT_PARTS_INDEX_BASE, base_) == MGDT_OK,
                                 "base");
                    break;
                case 1:
                    FUZZ_REQUIRE(mgdt_parts_clear(p_) == MGDT_OK, "clear");
                    given_.clear();
                    points_.clear();
                    next_id_ = 0;
                    expected_ = MGDT_OK;
                    break;
                case 2:
                    build(false);
                    break;
                case 3:
                    build(true);
                    break;
                default:
                    insert();
            }
        build(false);
    }

  private:
    void insert() {
        const unsigned kind = in_.below(PointSource::kinds), n = in_.below(24);
        const auto part = static_cast<std::int32_t>(in_.below(static_cast<unsigned>(parts_)));
        std::vector<double> xyz;
        std::vector<std::int64_t> ids;
        bool is_finite = true;
        const std::size_t before = points_.size();
        for (unsigned i = 0; i < n; ++i) {
            points_.push_back(source_.draw(in_, kind, points_));
            for (const double x : points_.back()) {
                is_finite = is_finite && std::isfinite(x);
                xyz.push_back(x);
            }
            // Without order, and one of a kind.
            ids.push_back((next_id_ + static_cast<std::int64_t>(i)) * 7919 % 10007 - 5000);
        }
        const mgdt_status status =
            mgdt_parts_insert_points(p_, part, n, xyz.data(), has_ids_ ? ids.data() : nullptr);
        FUZZ_REQUIRE(status == (is_finite ? MGDT_OK : MGDT_ERR_NOT_FINITE), "insert");
        if (!is_finite) {
            expected_ = status;
            points_.resize(before);
            return;
        }
        for (unsigned i = 0; i < n; ++i) given_.push_back({points_[before + i], ids[i], part});
        next_id_ += n;
    }
    // Without ids points are numbered through the parts, in the order that each got them.
    std::vector<Given> numbered() const {
        std::vector<Given> all = given_;
        if (has_ids_) return all;
        std::int64_t next = base_;
        for (std::int32_t part = 0; part < parts_; ++part)
            for (Given& g : all)
                if (g.part == part) g.id = next++;
        return all;
    }

    void build(bool one_at_a_time) {
        Look look{base_, {}};
        const auto see = [](const mgdt_parts* p, std::int32_t part, void* user) -> std::int32_t {
            auto& l = *static_cast<Look*>(user);
            append(p, part, l.base, l.all);
            return 0;
        };
        const mgdt_status status =
            one_at_a_time ? mgdt_parts_build_each(p_, see, &look) : mgdt_parts_build(p_);
        FUZZ_REQUIRE(status == expected_, "build");
        expected_ = MGDT_OK;
        if (status != MGDT_OK) return;
        if (!one_at_a_time) {
            FUZZ_REQUIRE(mgdt_parts_check(p_, MGDT_CHECK_CANONICAL) == MGDT_OK, "check");
            for (std::int32_t part = 0; part < parts_; ++part) {
                append(p_, part, base_, look.all);
                for (const std::int64_t n : array(p_, part, MGDT_PARTS_NEIGHBORS))
                    FUZZ_REQUIRE(n >= base_ - 1, "neighbour");
            }
        }
        std::sort(look.all.begin(), look.all.end());
        FUZZ_REQUIRE(look.all == of_one(numbered()), "the tetrahedra of one");
    }

    Input& in_;
    std::int32_t parts_;
    mgdt_parts* p_ = nullptr;
    PointSource source_;
    std::vector<Given> given_;
    std::vector<Point> points_;
    std::int64_t next_id_ = 0, base_ = 0;
    bool has_ids_;
    mgdt_status expected_ = MGDT_OK;  // of the next build
};

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    fuzz::Session(in).run();
    return 0;
}
