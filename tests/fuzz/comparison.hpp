// SPDX-License-Identifier: MIT
// The tetrahedra are a function of the set of points: what a handle has after any calls against
// other ways to the same set, and for a few points against trying every quadruple.
#pragma once

#include <memory>

#include "../property/oracle.hpp"
#include "../support/schemes.hpp"
#include "exports.hpp"
#include "points.hpp"

namespace fuzz {

struct Destroy {
    void operator()(mgdt_triangulation* t) const noexcept { mgdt_destroy(t); }
};
using Handle = std::unique_ptr<mgdt_triangulation, Destroy>;

inline const char* isa_of(unsigned n) {
#if defined(__aarch64__)
    static constexpr const char* names[] = {nullptr, "baseline", "neon", "baseline"};
#else
    static constexpr const char* names[] = {nullptr, "baseline", "avx2", "avx512"};
#endif
    return names[n % 4];
}

// A processor may lack a set; nothing else may go wrong.
inline void set_isa(mgdt_triangulation* t, unsigned n) {
    const mgdt_status status = mgdt_set_isa(t, isa_of(n));
    FUZZ_REQUIRE(status == MGDT_OK || (status == MGDT_ERR_INVALID_ARGUMENT && n % 4 >= 2),
                 error_of(t));
}

inline std::vector<double> flat(const std::vector<Point>& points, const Indices& which) {
    std::vector<double> xyz;
    for (const std::int64_t i : which) {
        const Point& p = points[static_cast<std::size_t>(i)];
        xyz.insert(xyz.end(), p.begin(), p.end());
    }
    return xyz;
}

// The points in one go, with settings of the input's choice, in canonical order.
inline Exports made_at_once(Input& in, const std::vector<Point>& points, const Indices& which) {
    mgdt_triangulation* made = nullptr;
    FUZZ_REQUIRE(mgdt_create(&made) == MGDT_OK, "mgdt_create");
    const Handle t(made);
    FUZZ_REQUIRE(
        mgdt_set_order_scheme(
            made, order_schemes[in.below(static_cast<unsigned>(order_schemes.size()))]) == MGDT_OK,
        error_of(made));
    FUZZ_REQUIRE(mgdt_set_seed(made, in.byte()) == MGDT_OK, error_of(made));
    FUZZ_REQUIRE(mgdt_set_canonical_output(made, 1) == MGDT_OK, error_of(made));
    set_isa(made, in.byte());
    const std::vector<double> xyz = flat(points, which);
    const auto n = static_cast<std::int64_t>(which.size());
    FUZZ_REQUIRE(mgdt_insert_points(made, n, xyz.data()) == MGDT_OK, error_of(made));
    return Exports(made, 0, 0);
}

// `which` ascends, so that numbering the points anew keeps the canonical order.
inline void compare_at_once(Input& in, const Exports& grown, const std::vector<Point>& points,
                            const Indices& which) {
    const Exports whole = made_at_once(in, points, which);
    const auto renamed = [&](Indices values) {
        for (std::int64_t& v : values) v = which[static_cast<std::size_t>(v)];
        return values;
    };
    FUZZ_REQUIRE(whole.dimension == grown.dimension, std::to_string(whole.dimension));
    FUZZ_REQUIRE(renamed(whole.tetrahedra) == grown.tetrahedra, "other tetrahedra in one go");
    FUZZ_REQUIRE(whole.neighbors == grown.neighbors, "other neighbours in one go");
    FUZZ_REQUIRE(renamed(whole.hull) == grown.hull, "another hull in one go");
    FUZZ_REQUIRE(renamed(whole.edges) == grown.edges, "other edges in one go");
    for (std::size_t i = 0; i < which.size(); ++i)
        FUZZ_REQUIRE(which[static_cast<std::size_t>(whole.map[i])] ==
                         grown.map[static_cast<std::size_t>(which[i])],
                     "another point map in one go");
}

using Keys = std::set<std::array<std::int64_t, 4>>;

inline Keys keys(const Indices& tetrahedra, const Indices& names) {
    Keys out;
    for (std::size_t t = 0; t < tetrahedra.size(); t += 4) {
        std::array<std::int64_t, 4> key{};
        for (std::size_t k = 0; k < 4; ++k)
            key[k] = names[static_cast<std::size_t>(tetrahedra[t + k])];
        std::sort(key.begin(), key.end());
        FUZZ_REQUIRE(out.insert(key).second, "a tetrahedron comes twice");
    }
    return out;
}

// The vertices alone, last first.
inline void compare_backwards(Input& in, const Exports& grown, const std::vector<Point>& points,
                              Indices vertices) {
    std::reverse(vertices.begin(), vertices.end());
    const Exports whole = made_at_once(in, points, vertices);
    Indices same(points.size());
    for (std::size_t i = 0; i < same.size(); ++i) same[i] = static_cast<std::int64_t>(i);
    FUZZ_REQUIRE(keys(whole.tetrahedra, vertices) == keys(grown.tetrahedra, same),
                 "other tetrahedra in another order");
}

inline void compare_with_oracle(const Exports& grown, const std::vector<Point>& points,
                                const Indices& vertices) {
    const std::vector<double> xyz = flat(points, vertices);
    if (vertices.size() > (oracle::fits_small(xyz) ? 9u : 6u)) return;
    const oracle::Triangulation expected = oracle::triangulate(xyz);
    FUZZ_REQUIRE(expected.dimension == grown.dimension, std::to_string(expected.dimension));
    Indices tetrahedra, same(points.size());
    for (const oracle::Quadruple& q : expected.tetrahedra)
        for (const std::size_t v : q) tetrahedra.push_back(static_cast<std::int64_t>(v));
    for (std::size_t i = 0; i < same.size(); ++i) same[i] = static_cast<std::int64_t>(i);
    FUZZ_REQUIRE(keys(tetrahedra, vertices) == keys(grown.tetrahedra, same),
                 "other tetrahedra than by trying every quadruple");
}

// Six times the volume of small integer points, once by tetrahedra and once by hull facets.
inline void compare_volumes(const Exports& grown, const std::vector<Point>& points) {
    Indices all(points.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int64_t>(i);
    const std::vector<double> xyz = flat(points, all);
    if (!oracle::fits_small(xyz)) return;
    const auto p = oracle::small_points(xyz);
    const auto at = [&](std::int64_t v) { return p[static_cast<std::size_t>(v)]; };
    std::int64_t inside = 0, outside = 0;
    const Indices &t = grown.tetrahedra, &h = grown.hull;
    for (std::size_t i = 0; i < t.size(); i += 4)
        inside += oracle::volume(at(t[i]), at(t[i + 1]), at(t[i + 2]), at(t[i + 3]));
    for (std::size_t i = 0; i < h.size(); i += 3)
        outside += oracle::dot(oracle::cross(at(h[i]), at(h[i + 1])), at(h[i + 2]));
    FUZZ_REQUIRE(inside == outside, "the tetrahedra do not fill the hull");
}

}  // namespace fuzz
