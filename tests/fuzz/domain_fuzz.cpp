// SPDX-License-Identifier: MIT
// Domains of any points, facets and segments: what offends is left out, the rest is meshed, and the
// mesh passes its check and does not depend on the order of the facets.
#include <algorithm>
#include <cmath>
#include <vector>

#include "../support/messages.hpp"
#include "mgdt/mgdt_domain.h"
#include "points.hpp"

namespace fuzz {
namespace {

using Integers = std::vector<std::int64_t>;

struct Facets {
    std::vector<Integers> corners;
    std::vector<std::int32_t> markers;
};

// A handle that is freed at the end.
class Handle {
  public:
    Handle() { FUZZ_REQUIRE(mgdt_domain_create(&d_) == MGDT_OK, "create"); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() {
        mgdt_mesh_destroy(m_);
        mgdt_domain_destroy(d_);
    }
    operator mgdt_domain*() const { return d_; }

    Integers pairs() const { return own(MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS); }
    // An array of the domain.
    Integers own(std::int32_t key) const {
        std::int64_t size = -1;
        FUZZ_REQUIRE(mgdt_domain_get_size(d_, key, &size) == MGDT_OK && size >= 0, "size");
        Integers values(static_cast<std::size_t>(size));
        FUZZ_REQUIRE(mgdt_domain_get_array(d_, key, size, values.data()) == MGDT_OK, "own array");
        return values;
    }
    mgdt_status build() {
        mgdt_mesh_destroy(m_);
        const mgdt_status status = mgdt_domain_build(d_, &m_);
        FUZZ_REQUIRE((m_ != nullptr) == (status == MGDT_OK), "a mesh");
        return status;
    }
    // Checks the mesh of the last build.
    void check() const {
        FUZZ_REQUIRE(mgdt_mesh_check(m_) == MGDT_OK,
                     mgdt_tests::message_of(m_, mgdt_mesh_get_error));
        FUZZ_REQUIRE(mgdt_domain_check(d_, m_) == MGDT_OK,
                     mgdt_tests::message_of(d_, mgdt_domain_get_error));
    }
    // An array of the mesh; nothing if there is none.
    Integers array(std::int32_t key) const {
        std::int64_t size = -1;
        if (!m_) return {};
        FUZZ_REQUIRE(mgdt_mesh_get_size(m_, key, &size) == MGDT_OK && size >= 0, "size");
        Integers values(static_cast<std::size_t>(size));
        FUZZ_REQUIRE(mgdt_mesh_get_array(m_, key, size, values.data()) == MGDT_OK, "array");
        return values;
    }
    void set_facets(const Facets& facets) const {
        Integers offsets = {0}, corners;
        for (const Integers& f : facets.corners) {
            corners.insert(corners.end(), f.begin(), f.end());
            offsets.push_back(static_cast<std::int64_t>(corners.size()));
        }
        const auto n = static_cast<std::int64_t>(facets.corners.size());
        FUZZ_REQUIRE(mgdt_domain_set_facets(d_, n, offsets.data(), corners.data(),
                                            facets.markers.data()) == MGDT_OK,
                     "facets");
    }

  private:
    mgdt_domain* d_ = nullptr;
    mgdt_mesh* m_ = nullptr;
};

class Session {
  public:
    explicit Session(Input& in) : in_(in) { source_.choose_sphere(in.below(4)); }

    void run() {
        draw_points();
        const mgdt_status status = mgdt_domain_set_points(first_, count(), coordinates_.data());
        FUZZ_REQUIRE(status == (is_finite_ ? MGDT_OK : MGDT_ERR_NOT_FINITE), "points");
        if (!is_finite_) return;
        draw_facets();
        draw_segments();
        clean();
        leave_out_offences();
        for (unsigned k = in_.below(3); k > 0; --k) {
            const Point place = source_.draw(in_, PointSource::lattice, points_);
            holes_.insert(holes_.end(), place.begin(), place.end());
        }
        set_holes(first_);
        compare_builds();
    }

  private:
    std::int64_t count() const { return static_cast<std::int64_t>(points_.size()); }
    std::int64_t index() { return static_cast<std::int64_t>(in_.byte() % points_.size()); }

    void draw_points() {
        const unsigned n = 4 + in_.below(24);
        unsigned kind = in_.below(PointSource::kinds);
        for (unsigned i = 0; i < n; ++i) {
            if (in_.below(8) == 0) kind = in_.below(PointSource::kinds);
            points_.push_back(source_.draw(in_, kind, points_));
            for (const double x : points_.back()) {
                is_finite_ = is_finite_ && std::isfinite(x);
                coordinates_.push_back(x);
            }
        }
    }

    // The hull of the points, so that something is enclosed, and any other facets.
    void draw_facets() {
        if (in_.flag()) {
            mgdt_triangulation* t = nullptr;
            FUZZ_REQUIRE(mgdt_create(&t) == MGDT_OK, "create");
            FUZZ_REQUIRE(mgdt_insert_points(t, count(), coordinates_.data()) == MGDT_OK, "insert");
            const std::int64_t n = mgdt_hull_facet_count(t);
            Integers v(static_cast<std::size_t>(3 * n));
            FUZZ_REQUIRE(mgdt_get_hull_facets(t, 3 * n, v.data()) == MGDT_OK, "hull");
            mgdt_destroy(t);
            for (std::size_t i = 0; i < v.size(); i += 3) {
                facets_.corners.push_back({v[i], v[i + 1], v[i + 2]});
                facets_.markers.push_back(0);
            }
        }
        for (unsigned k = in_.below(24); k > 0; --k) {
            const unsigned b = in_.byte();
            Integers f(3 + (b & 7) / 6);
            for (std::int64_t& v : f) v = index();
            facets_.corners.push_back(f);
            facets_.markers.push_back(static_cast<std::int32_t>(b >> 3 & 1));
        }
    }

    void draw_segments() {
        for (unsigned k = 2 * in_.below(6); k > 0; --k) segments_.push_back(index());
    }

    void set(const Handle& d, const Facets& facets) const {
        d.set_facets(facets);
        FUZZ_REQUIRE(mgdt_domain_set_segments(d, static_cast<std::int64_t>(segments_.size() / 2),
                                              segments_.data(), nullptr) == MGDT_OK,
                     "segments");
    }

    // Cleans in two ways, exactly and by a distance. A second time there is nothing to do.
    void clean() const {
        for (const double distance : {0.0, 1e-3}) {
            set(first_, facets_);
            for (const std::int32_t option : {MGDT_DOMAIN_OPTION_WELD, MGDT_DOMAIN_OPTION_FLATNESS})
                FUZZ_REQUIRE(mgdt_domain_set_double_option(first_, option, distance) == MGDT_OK,
                             "a double option");
            FUZZ_REQUIRE(mgdt_domain_clean(first_) == MGDT_OK, "clean");
            const Integers origins = first_.own(MGDT_DOMAIN_ARRAY_FACET_ORIGINS),
                           segments = first_.own(MGDT_DOMAIN_ARRAY_SEGMENTS);
            for (const std::int64_t f : origins)
                FUZZ_REQUIRE(f >= 0 && static_cast<std::size_t>(f) < facets_.corners.size(),
                             "origins");
            if (distance > 0) break;
            const Integers corners = first_.own(MGDT_DOMAIN_ARRAY_FACET_CORNERS);
            FUZZ_REQUIRE(mgdt_domain_clean(first_) == MGDT_OK, "clean again");
            FUZZ_REQUIRE(first_.own(MGDT_DOMAIN_ARRAY_FACET_CORNERS) == corners &&
                             first_.own(MGDT_DOMAIN_ARRAY_FACET_ORIGINS) == origins &&
                             first_.own(MGDT_DOMAIN_ARRAY_SEGMENTS) == segments,
                         "a clean domain");
        }
        FUZZ_REQUIRE(mgdt_domain_set_points(first_, count(), coordinates_.data()) == MGDT_OK,
                     "points");
    }

    // Removes the second of each pair until none is left. Points that belong to nothing cannot be
    // removed; then the first is.
    void leave_out_offences() {
        for (int round = 0;; ++round) {
            FUZZ_REQUIRE(round < 64, "offences stay");
            set(first_, facets_);
            const mgdt_status status = mgdt_domain_validate(first_);
            const Integers pairs = first_.pairs();
            FUZZ_REQUIRE(pairs.size() % 4 == 0, "pairs");
            FUZZ_REQUIRE(status == (pairs.empty() ? MGDT_OK : MGDT_ERR_INVALID_BOUNDARY),
                         "validate");
            if (pairs.empty()) return;
            FUZZ_REQUIRE(first_.build() == MGDT_ERR_INVALID_BOUNDARY, "build");
            FUZZ_REQUIRE(first_.pairs() == pairs, "same pairs");
            std::vector<std::size_t> facets, segments;
            for (std::size_t i = 0; i < pairs.size(); i += 4) {
                const std::size_t at = pairs[i + 2] == MGDT_DOMAIN_KIND_POINT ? i : i + 2;
                FUZZ_REQUIRE(pairs[at] != MGDT_DOMAIN_KIND_POINT, "two points");
                (pairs[at] == MGDT_DOMAIN_KIND_FACET ? facets : segments)
                    .push_back(static_cast<std::size_t>(pairs[at + 1]));
            }
            const auto erase = [](std::vector<std::size_t>& which, const auto& at) {
                std::sort(which.begin(), which.end());
                which.erase(std::unique(which.begin(), which.end()), which.end());
                for (std::size_t k = which.size(); k > 0; --k) at(which[k - 1]);
            };
            const auto offset = [](std::size_t k) { return static_cast<std::ptrdiff_t>(k); };
            erase(facets, [&](std::size_t k) {
                facets_.corners.erase(facets_.corners.begin() + offset(k));
                facets_.markers.erase(facets_.markers.begin() + offset(k));
            });
            erase(segments, [&](std::size_t k) {
                segments_.erase(segments_.begin() + offset(2 * k),
                                segments_.begin() + offset(2 * k + 2));
            });
        }
    }

    void set_holes(mgdt_domain* d) const {
        FUZZ_REQUIRE(mgdt_domain_set_holes(d, static_cast<std::int64_t>(holes_.size() / 3),
                                           holes_.data()) == MGDT_OK,
                     "holes");
    }

    void compare_builds() {
        // Polygons of more than three corners may be divided otherwise if they begin elsewhere.
        bool has_polygons = false;
        for (const Integers& f : facets_.corners) has_polygons = has_polygons || f.size() > 3;
        Handle second;
        std::reverse(facets_.corners.begin(), facets_.corners.end());
        std::reverse(facets_.markers.begin(), facets_.markers.end());
        for (Integers& f : facets_.corners) std::reverse(f.begin(), f.end());
        FUZZ_REQUIRE(mgdt_domain_set_points(second, count(), coordinates_.data()) == MGDT_OK,
                     "points");
        set(second, facets_);
        set_holes(second);
        for (const std::int64_t keeps : {0, 1}) {
            for (const Handle* d : {&first_, &second})
                FUZZ_REQUIRE(
                    mgdt_domain_set_option(*d, MGDT_DOMAIN_OPTION_KEEP_BOUNDARY, keeps) == MGDT_OK,
                    "an option");
            const mgdt_status status = first_.build();
            FUZZ_REQUIRE(status == MGDT_OK || status == MGDT_ERR_RESOLUTION ||
                             status == MGDT_ERR_OPEN_BOUNDARY,
                         "build");
            if (status == MGDT_OK) first_.check();
            if (!has_polygons) compare_with(second, status);
        }
    }

    void compare_with(Handle& second, mgdt_status status) const {
        FUZZ_REQUIRE(second.build() == status, "the order of the facets");
        for (const std::int32_t key : {MGDT_MESH_ARRAY_TETRAHEDRA,
                                       MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS, MGDT_MESH_ARRAY_EDGES})
            FUZZ_REQUIRE(first_.array(key) == second.array(key), "the order of the facets");
    }

    Input& in_;
    PointSource source_;
    Handle first_;
    std::vector<Point> points_;
    std::vector<double> coordinates_, holes_;
    bool is_finite_ = true;
    Facets facets_;
    Integers segments_;
};

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    fuzz::Session(in).run();
    return 0;
}
