// SPDX-License-Identifier: MIT
// Calls that must be refused, with the status that is documented and without touching an output:
// for their arguments, or because the handle is inside another call.
#pragma once

#include <limits>

#include "exports.hpp"

namespace fuzz {

// The caller compares the handle before and after.
inline void wrong_call(Input& in, mgdt_triangulation* t) {
    const double xyz[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double infinity = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
    constexpr std::int64_t huge = std::numeric_limits<std::int64_t>::max();
    const std::int64_t tetrahedra = mgdt_tetrahedron_count(t), points = mgdt_point_count(t);
    Exact<std::int64_t> out(8, 2);
    Exact<std::int32_t> narrow(8, 2);
    Exact<double> weights(8, 2);
    std::int64_t* const o = out.data();
    mgdt_status status = MGDT_OK, expected = MGDT_ERR_INVALID_ARGUMENT;
    const auto expect = [&](mgdt_status wanted, mgdt_status got) {
        status = got;
        expected = wanted;
    };
    const std::int64_t negative = -1 - static_cast<std::int64_t>(in.byte());
    const std::int32_t unknown = 1000 + static_cast<std::int32_t>(in.byte());
    switch (in.below(36)) {
        case 0:
            expect(MGDT_ERR_NULL_POINTER, mgdt_insert_points(t, 1, nullptr));
            break;
        case 1:
            expect(expected, mgdt_insert_points(t, negative, xyz));
            break;
        case 2:
            expect(MGDT_ERR_TOO_LARGE, mgdt_insert_points(t, huge, xyz));
            break;
        case 3:
            expect(MGDT_ERR_TOO_LARGE, mgdt_insert_points(t, huge / 24, xyz));
            break;
        case 4:
            expect(MGDT_ERR_NULL_POINTER, mgdt_insert_points_strided(t, 1, xyz, nullptr, xyz, 1));
            break;
        case 5:
            expect(expected, mgdt_insert_points_strided(t, negative, xyz, xyz, xyz, 1));
            break;
        case 6:
            expect(MGDT_ERR_TOO_LARGE, mgdt_insert_points_strided(t, huge, xyz, xyz, xyz, huge));
            break;
        case 7:
            expect(expected, mgdt_reserve(t, negative));
            break;
        case 8:
            expect(MGDT_ERR_TOO_LARGE, mgdt_reserve(t, huge));
            break;
        case 9:
            expect(MGDT_ERR_UNKNOWN_SCHEME, mgdt_set_order_scheme(t, unknown));
            break;
        case 10:
            expect(MGDT_ERR_UNKNOWN_KEY, mgdt_set_order_parameter(t, unknown, 1));
            break;
        case 11:
            expect(expected, mgdt_set_order_parameter(t, MGDT_PARAMETER_POINTS_PER_CELL, nan));
            break;
        case 12:
            expect(expected, mgdt_set_order_parameter(t, MGDT_PARAMETER_THRESHOLD, -infinity));
            break;
        case 13:
            expect(expected, mgdt_set_order_parameter(t, MGDT_PARAMETER_ROUND_RATIO, 1));
            break;
        case 14:
            expect(expected, mgdt_set_order_parameter(t, MGDT_PARAMETER_SEPARATION, 3));
            break;
        case 15:
            expect(expected, mgdt_set_threads(t, static_cast<std::int32_t>(negative)));
            break;
        case 16:
            expect(expected, mgdt_set_index_base(t, unknown));
            break;
        case 17:
            expect(expected, mgdt_set_memory_limit(t, negative));
            break;
        case 18:
            expect(expected, mgdt_set_canonical_output(t, unknown));
            expect(expected, mgdt_set_compact(t, unknown));
            break;
        case 19:
            expect(expected, mgdt_set_isa(t, "pentium"));
            break;
        case 20:
            expect(expected, mgdt_get_tetrahedra(t, negative, o));
            break;
        case 21:
            if (tetrahedra == 0) return;
            expect(MGDT_ERR_BUFFER_TOO_SMALL, mgdt_get_neighbors(t, 4 * tetrahedra - 1, o));
            break;
        case 22:
            if (tetrahedra == 0) return;
            expect(MGDT_ERR_BUFFER_TOO_SMALL,
                   mgdt_get_edges_i32(t, 2 * mgdt_edge_count(t) - 1, narrow.data()));
            break;
        case 23:
            if (points == 0) return;
            expect(MGDT_ERR_NULL_POINTER, mgdt_get_point_map(t, points, nullptr));
            break;
        case 24:
            expect(MGDT_ERR_BUFFER_TOO_SMALL,
                   mgdt_get_vertex_tetrahedra(t, points, o, 4 * tetrahedra, o + 4));
            break;
        case 25:
            if (tetrahedra == 0) return;
            expect(MGDT_ERR_BUFFER_TOO_SMALL,
                   mgdt_get_hull_facets(t, 3 * mgdt_hull_facet_count(t) - 1, o));
            break;
        case 26:
            expect(MGDT_ERR_NULL_POINTER, mgdt_locate(t, nullptr, o));
            break;
        case 27:
            expect(expected, mgdt_locate_points(t, negative, xyz, o, nullptr));
            break;
        case 28: {
            const double bad[6] = {0, 0, 0, 0, in.flag() ? nan : infinity, 0};
            expect(MGDT_ERR_NOT_FINITE, mgdt_locate_points(t, 2, bad, o, weights.data()));
            break;
        }
        case 29: {
            const double bad[3] = {0, -infinity, 0};
            expect(MGDT_ERR_NOT_FINITE, mgdt_nearest_vertex(t, bad, o));
            break;
        }
        case 32: {
            const double bad[6] = {0, 0, 0, 0, in.flag() ? nan : infinity, 0};
            expect(MGDT_ERR_NOT_FINITE, mgdt_nearest_vertices(t, 2, bad, o));
            break;
        }
        case 33:
            expect(expected, mgdt_nearest_vertices_i32(t, negative, xyz, narrow.data()));
            break;
        case 34:
            expect(MGDT_ERR_UNKNOWN_KEY, mgdt_get_order_parameter(t, unknown, weights.data()));
            break;
        case 30:
            expect(expected, mgdt_check(t, 4 + static_cast<std::int32_t>(in.byte())));
            break;
        case 31:
            expect(MGDT_ERR_UNKNOWN_KEY, mgdt_get_stat(t, unknown, weights.data()));
            break;
        default:
            expect(MGDT_ERR_NULL_POINTER, mgdt_nearest_vertex(t, xyz, nullptr));
            break;
    }
    FUZZ_REQUIRE(status == expected, mgdt_status_string(status));
    FUZZ_REQUIRE(!error_of(t).empty(), "no message");
    FUZZ_REQUIRE(out.is_untouched() && narrow.is_untouched() && weights.is_untouched(),
                 "an output is touched");
}

// What a callback must not call on the handle that it serves. Any of these would change it.
inline void busy_call(unsigned which, mgdt_triangulation* t) {
    const double xyz[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    mgdt_status status = MGDT_ERR_BUSY;
    std::int64_t first = 0;
    switch (which % 14) {
        case 0:
            status = mgdt_insert_points(t, 4, xyz);
            break;
        case 11:
            status = mgdt_remove_points(t, 1, &first);
            break;
        case 12:
            status = mgdt_move_points(t, 1, &first, xyz);
            break;
        case 13:
            status = mgdt_renumber_points(t, 1, &first);
            break;
        case 1:
            status = mgdt_insert_points_strided(t, -1, xyz, nullptr, xyz, 1);
            break;
        case 2:
            status = mgdt_clear(t);
            break;
        case 3:
            status = mgdt_reserve(t, 1000);
            break;
        case 4:
            status = mgdt_set_compact(t, static_cast<std::int32_t>(which / 10 % 2));
            break;
        case 5:
            status = mgdt_set_index_base(t, static_cast<std::int32_t>(which / 10 % 2));
            break;
        case 6:
            status = mgdt_set_canonical_output(t, static_cast<std::int32_t>(which / 10 % 2));
            break;
        case 7:
            status = mgdt_set_progress(t, nullptr, nullptr);
            break;
        case 8:
            status = mgdt_set_memory_limit(t, 1);
            break;
        case 9:
            status = mgdt_shrink(t);
            break;
        default:
            mgdt_destroy(t);
            break;
    }
    FUZZ_REQUIRE(status == MGDT_ERR_BUSY, mgdt_status_string(status));
    FUZZ_REQUIRE(!error_of(t).empty(), "no message");
}

// What a callback must not read of a handle that is being changed.
inline void busy_query(unsigned which, const mgdt_triangulation* t) {
    const double xyz[3] = {0, 0, 0};
    Exact<std::int64_t> out(8, 2);
    Exact<double> value(1, 2);
    mgdt_status status = MGDT_ERR_BUSY;
    switch (which % 9) {
        case 0:
            status = mgdt_get_tetrahedra(t, 8, out.data());
            break;
        case 1:
            status = mgdt_get_vertex_tetrahedra(t, 4, out.data(), 4, out.data() + 4);
            break;
        case 2:
            status = mgdt_locate(t, xyz, out.data());
            break;
        case 3:
            status = mgdt_nearest_vertex(t, xyz, out.data());
            break;
        case 4:
            status = mgdt_check(t, MGDT_CHECK_CANONICAL);
            break;
        case 6:
            status = mgdt_nearest_vertices(t, 1, xyz, out.data());
            break;
        case 7:
            status = mgdt_get_order_parameter(t, MGDT_PARAMETER_THRESHOLD, value.data());
            break;
        case 5:
            status = mgdt_get_stat(t, MGDT_STAT_MEMORY_BYTES, value.data());
            break;
        default:
            FUZZ_REQUIRE(mgdt_point_count(t) == 0 && mgdt_vertex_count(t) == 0 &&
                             mgdt_tetrahedron_count(t) == 0 && mgdt_edge_count(t) == 0 &&
                             mgdt_hull_facet_count(t) == 0 && mgdt_dimension(t) == -1,
                         "a count of a handle that is being changed");
            break;
    }
    FUZZ_REQUIRE(status == MGDT_ERR_BUSY, mgdt_status_string(status));
    FUZZ_REQUIRE(out.is_untouched() && value.is_untouched(), "an output is touched");
}

}  // namespace fuzz
