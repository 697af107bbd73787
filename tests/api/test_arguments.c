/* SPDX-License-Identifier: MIT
 * What wrong arguments get: a status, a message that says what was wrong, and no change. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

static const double simplex[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};

static void null_handles(void) {
    double d = 0;
    int64_t i = 0;
    int32_t j = 0;
    char c[4];
    CHECK_EQUAL(mgdt_create(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_create_with_allocator(NULL, NULL, NULL, NULL), MGDT_ERR_NULL_POINTER);
    mgdt_destroy(NULL);
    CHECK_EQUAL(mgdt_clear(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_reserve(NULL, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_set_order_scheme(NULL, MGDT_ORDER_BRIO), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_set_order_parameter(NULL, MGDT_PARAMETER_THRESHOLD, 100),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_set_seed(NULL, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_set_threads(NULL, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_set_index_base(NULL, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_set_memory_limit(NULL, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_set_compact(NULL, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_set_progress(NULL, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_cancel(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_set_canonical_output(NULL, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_insert_points(NULL, 4, simplex), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_insert_points_strided(NULL, 4, simplex, simplex, simplex, 3),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_remove_points(NULL, 1, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_remove_points_i32(NULL, 1, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_move_points(NULL, 1, &i, simplex), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_move_points_i32(NULL, 1, &j, simplex), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_renumber_points(NULL, 1, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_renumber_points_i32(NULL, 1, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_point_count(NULL), 0);
    CHECK_EQUAL(mgdt_vertex_count(NULL), 0);
    CHECK_EQUAL(mgdt_dimension(NULL), -1);
    CHECK_EQUAL(mgdt_tetrahedron_count(NULL), 0);
    CHECK_EQUAL(mgdt_hull_facet_count(NULL), 0);
    CHECK_EQUAL(mgdt_edge_count(NULL), 0);
    CHECK_EQUAL(mgdt_vertex_tetrahedra_count(NULL), 0);
    CHECK_EQUAL(mgdt_vertex_neighbors_count(NULL), 0);
    CHECK_EQUAL(mgdt_get_tetrahedra(NULL, 1, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_tetrahedra_i32(NULL, 1, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_neighbors(NULL, 1, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_neighbors_i32(NULL, 1, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_hull_facets(NULL, 1, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_hull_facets_i32(NULL, 1, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_edges(NULL, 1, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_edges_i32(NULL, 1, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_point_map(NULL, 1, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_point_map_i32(NULL, 1, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra(NULL, 1, &i, 1, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra_i32(NULL, 1, &j, 1, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_vertex_neighbors(NULL, 1, &i, 1, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_vertex_neighbors_i32(NULL, 1, &j, 1, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_circumcenters(NULL, 1, &d, &d), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_tetrahedron_measures(NULL, MGDT_TETRAHEDRON_VOLUME, 1, &d),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_alphas(NULL, 3, 1, &d), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_alpha_surface(NULL, 1, 1, &i, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_alpha_surface_i32(NULL, 1, 1, &j, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_solid_alpha(NULL, &d), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_cell_measures(NULL, MGDT_MEASURE_AREA, 0, NULL, 1, &d),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(
        mgdt_interpolate(NULL, MGDT_INTERPOLATE_LINEAR, MGDT_OUTSIDE_NONE, 1, &d, 1, simplex, &d),
        MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_interpolation_weights(NULL, MGDT_INTERPOLATE_LINEAR, MGDT_OUTSIDE_NONE, 1,
                                               simplex, 2, &i, 0, NULL, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_interpolation_weights_i32(NULL, MGDT_INTERPOLATE_LINEAR, MGDT_OUTSIDE_NONE,
                                                   1, simplex, 2, &j, 0, NULL, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_gradients(NULL, 1, &d, &d), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_gabriel_edges(NULL, 1, &i, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_gabriel_edges_i32(NULL, 1, &j, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_spanning_tree(NULL, 1, &i, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_spanning_tree_i32(NULL, 1, &j, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_locate(NULL, simplex, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_traverse_segment(NULL, simplex, simplex, 1, &i, NULL, &i),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_traverse_segment_i32(NULL, simplex, simplex, 1, &j, NULL, &j),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_locate_points(NULL, 1, simplex, &i, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_locate_points_i32(NULL, 1, simplex, &j, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertex(NULL, simplex, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertex_i32(NULL, simplex, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertices(NULL, 1, simplex, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertices_i32(NULL, 1, simplex, &j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_shrink(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_check(NULL, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_stat(NULL, MGDT_STAT_ROUNDS, &d), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_error(NULL, 4, c), MGDT_ERR_NULL_POINTER);
}

static void null_arrays(const mgdt_triangulation* t) {
    double d = 0;
    int64_t i[4] = {0};
    int32_t j[4] = {0};
    const int64_t many = 1000;
    CHECK_EQUAL(mgdt_get_tetrahedra(t, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_tetrahedra_i32(t, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_neighbors(t, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_neighbors_i32(t, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_hull_facets(t, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_hull_facets_i32(t, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_edges(t, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_edges_i32(t, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_point_map(t, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_point_map_i32(t, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra(t, many, NULL, 4, i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra(t, many, i, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra_i32(t, many, NULL, 4, j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra_i32(t, many, j, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_vertex_neighbors(t, many, NULL, 4, i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_vertex_neighbors(t, many, i, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_vertex_neighbors_i32(t, many, NULL, 4, j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_vertex_neighbors_i32(t, many, j, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_circumcenters(t, many, NULL, &d), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_VOLUME, many, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_alphas(t, 3, many, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_alpha_surface(t, 9, many, NULL, i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_alpha_surface(t, 9, many, i, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_alpha_surface_i32(t, 9, many, NULL, j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_alpha_surface_i32(t, 9, many, j, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_solid_alpha(t, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_AREA, 0, NULL, many, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_AREA, 1, NULL, many, &d),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_gabriel_edges(t, many, NULL, i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_gabriel_edges(t, many, i, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_gabriel_edges_i32(t, many, NULL, j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_gabriel_edges_i32(t, many, j, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_spanning_tree(t, many, NULL, i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_spanning_tree(t, many, i, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_spanning_tree_i32(t, many, NULL, j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_spanning_tree_i32(t, many, j, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_locate(t, NULL, i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_locate(t, simplex, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_locate_i32(t, NULL, j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_locate_i32(t, simplex, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_locate_i32(NULL, simplex, j), MGDT_ERR_NULL_POINTER);
    {
        const double *const a = simplex, *const b = simplex + 3;
        CHECK_EQUAL(mgdt_traverse_segment(t, NULL, b, 4, i, &d, i), MGDT_ERR_NULL_POINTER);
        CHECK_EQUAL(mgdt_traverse_segment(t, a, NULL, 4, i, &d, i), MGDT_ERR_NULL_POINTER);
        CHECK_EQUAL(mgdt_traverse_segment(t, a, b, 4, NULL, &d, i), MGDT_ERR_NULL_POINTER);
        CHECK_EQUAL(mgdt_traverse_segment(t, a, b, 4, i, NULL, NULL), MGDT_ERR_NULL_POINTER);
        CHECK_EQUAL(mgdt_traverse_segment_i32(t, NULL, b, 4, j, &d, j), MGDT_ERR_NULL_POINTER);
        CHECK_EQUAL(mgdt_traverse_segment_i32(t, a, NULL, 4, j, &d, j), MGDT_ERR_NULL_POINTER);
        CHECK_EQUAL(mgdt_traverse_segment_i32(t, a, b, 4, NULL, &d, j), MGDT_ERR_NULL_POINTER);
        CHECK_EQUAL(mgdt_traverse_segment_i32(t, a, b, 4, j, NULL, NULL), MGDT_ERR_NULL_POINTER);
    }
    CHECK_EQUAL(mgdt_locate_points(t, 1, NULL, i, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_locate_points(t, 1, simplex, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_locate_points_i32(t, 1, NULL, j, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_locate_points_i32(t, 1, simplex, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertex(t, NULL, i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertex(t, simplex, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertex_i32(t, NULL, j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertex_i32(t, simplex, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertices(t, 1, NULL, i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertices(t, 1, simplex, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertices_i32(t, 1, NULL, j), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertices_i32(t, 1, simplex, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_nearest_vertices(t, -1, simplex, i), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_nearest_vertices(t, INT64_MAX, simplex, i), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_nearest_vertices(t, 0, NULL, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_get_stat(t, MGDT_STAT_ROUNDS, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_error(t, 4, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_stat(t, MGDT_STAT_ROUNDS, &d), MGDT_OK);
    CHECK_EQUAL(mgdt_locate_points(t, 0, NULL, NULL, NULL), MGDT_OK);
}

/* Settings out of range leave the setting as it was, which the next lines would show. */
static void settings(mgdt_triangulation* t) {
    static const double bad_points[] = {-1, 0.5, 1.1e6, NAN, INFINITY};
    static const double bad_ratios[] = {1, 0.5, -2, 1.1e6, NAN, INFINITY};
    size_t k;
    CHECK_EQUAL(mgdt_set_order_scheme(t, 1), MGDT_ERR_UNKNOWN_SCHEME);
    CHECK_ERROR(t, "1");
    CHECK_EQUAL(mgdt_set_order_scheme(t, -10), MGDT_ERR_UNKNOWN_SCHEME);
    CHECK_ERROR(t, "-10");
    CHECK_EQUAL(mgdt_set_order_parameter(t, 0, 1), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_set_order_parameter(t, 11, 1), MGDT_ERR_UNKNOWN_KEY);
    CHECK_ERROR(t, "11");
    for (k = 0; k < sizeof bad_points / sizeof bad_points[0]; ++k)
        CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_POINTS_PER_CELL, bad_points[k]),
                    MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_THRESHOLD, -1),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_THRESHOLD, 1.1e9),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_THRESHOLD, NAN),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_SEPARATION, 3),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_SEPARATION, 0.5),
                MGDT_ERR_INVALID_ARGUMENT);
    for (k = 0; k < sizeof bad_ratios / sizeof bad_ratios[0]; ++k)
        CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_ROUND_RATIO, bad_ratios[k]),
                    MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_POINTS_PER_CELL, 20), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_POINTS_PER_CELL, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_THRESHOLD, 50), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_THRESHOLD, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_SEPARATION, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_SEPARATION, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_SEPARATION, 2), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_ROUND_RATIO, 3), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_ROUND_RATIO, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_set_threads(t, -1), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_set_threads(t, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_set_threads(t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_index_base(t, 2), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_set_index_base(t, -1), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_set_memory_limit(t, -1), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_set_canonical_output(t, 2), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_set_canonical_output(t, -1), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_check(t, 0), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_check(t, 4), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_reserve(t, -1), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_reserve(t, INT64_MAX), MGDT_ERR_TOO_LARGE);
    CHECK_EQUAL(mgdt_reserve(t, INT64_C(1) << 33), MGDT_ERR_TOO_LARGE);
}

/* The handle still holds the simplex and nothing else. */
static void still_simplex(const mgdt_triangulation* t) {
    int64_t v[4] = {-7, -7, -7, -7};
    CHECK_EQUAL(mgdt_point_count(t), 4);
    CHECK_EQUAL(mgdt_vertex_count(t), 4);
    CHECK_EQUAL(mgdt_dimension(t), 3);
    CHECK_EQUAL(mgdt_tetrahedron_count(t), 1);
    CHECK_EQUAL(mgdt_get_tetrahedra(t, 4, v), MGDT_OK);
    CHECK_EQUAL(v[0] + v[1] + v[2] + v[3], 6);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
}

static void not_finite(mgdt_triangulation* t) {
    static const double bad[] = {NAN, -NAN, INFINITY, -INFINITY};
    const int64_t n = 2000;
    double* xyz = random_points(n, 0, 11);
    size_t b;
    int64_t k;
    for (b = 0; b < sizeof bad / sizeof bad[0]; ++b)
        for (k = 0; k < 3; ++k) {
            const int64_t point = k == 0 ? 0 : k == 1 ? 1234 : n - 1;
            const double kept = xyz[3 * point + k];
            char expected[32];
            xyz[3 * point + k] = bad[b];
            /* The index is the one that the point would have had: four are in. */
            snprintf(expected, sizeof expected, "%lld", (long long)(point + 4));
            CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_ERR_NOT_FINITE);
            CHECK_ERROR(t, expected);
            CHECK_EQUAL(mgdt_insert_points_strided(t, n, xyz, xyz + 1, xyz + 2, 3),
                        MGDT_ERR_NOT_FINITE);
            CHECK_ERROR(t, expected);
            xyz[3 * point + k] = kept;
        }
    still_simplex(t);
    free(xyz);
    for (b = 0; b < sizeof bad / sizeof bad[0]; ++b) {
        const double q[6] = {0.1, 0.1, 0.1, 0.1, bad[b], 0.1};
        int64_t out[2] = {-7, -7};
        int32_t out32[2] = {-7, -7};
        double weights[8] = {-7, -7, -7, -7, -7, -7, -7, -7};
        CHECK_EQUAL(mgdt_locate(t, q + 3, out), MGDT_ERR_NOT_FINITE);
        CHECK_EQUAL(mgdt_locate_i32(t, q + 3, out32), MGDT_ERR_NOT_FINITE);
        CHECK_EQUAL(mgdt_nearest_vertex(t, q + 3, out), MGDT_ERR_NOT_FINITE);
        CHECK_EQUAL(mgdt_nearest_vertices(t, 2, q, out), MGDT_ERR_NOT_FINITE);
        CHECK_ERROR(t, "point 1");
        CHECK_EQUAL(mgdt_traverse_segment(t, q + 3, q, 1, out, weights, out), MGDT_ERR_NOT_FINITE);
        CHECK_ERROR(t, "coordinate y of a is not finite");
        CHECK_EQUAL(mgdt_traverse_segment_i32(t, q, q + 3, 1, out32, weights, out32),
                    MGDT_ERR_NOT_FINITE);
        CHECK_ERROR(t, "of b is not finite");
        CHECK_EQUAL(mgdt_locate_points(t, 2, q, out, weights), MGDT_ERR_NOT_FINITE);
        CHECK_ERROR(t, "1");
        CHECK_EQUAL(mgdt_locate_points_i32(t, 2, q, out32, weights), MGDT_ERR_NOT_FINITE);
        CHECK(out[0] == -7 && out[1] == -7 && out32[0] == -7 && out32[1] == -7);
        CHECK(weights[0] == -7 && weights[7] == -7);
    }
}

static void counts(mgdt_triangulation* t) {
    int64_t out = -7;
    CHECK_EQUAL(mgdt_insert_points(t, -1, simplex), MGDT_ERR_INVALID_ARGUMENT);
    /* Whatever else is wrong, and in every function the same. */
    CHECK_EQUAL(mgdt_insert_points(t, -1, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_insert_points_strided(t, -1, NULL, NULL, NULL, 3), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_locate_points(t, -1, NULL, NULL, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "-1");
    CHECK_EQUAL(mgdt_insert_points(t, INT64_MIN, simplex), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_insert_points_strided(t, -1, simplex, simplex, simplex, 1),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_insert_points(t, 1, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_insert_points_strided(t, 1, NULL, simplex, simplex, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_insert_points_strided(t, 1, simplex, NULL, simplex, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_insert_points_strided(t, 1, simplex, simplex, NULL, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_insert_points(t, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points_strided(t, 0, NULL, NULL, NULL, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_locate_points(t, -1, simplex, &out, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_traverse_segment(t, simplex, simplex + 3, -1, &out, NULL, &out),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "-1");
    /* More points than can be numbered; the count must be looked at before the points are. */
    CHECK_EQUAL(mgdt_insert_points(t, INT64_MAX, simplex), MGDT_ERR_TOO_LARGE);
    CHECK_EQUAL(mgdt_insert_points(t, INT64_C(1) << 33, simplex), MGDT_ERR_TOO_LARGE);
    CHECK_EQUAL(mgdt_insert_points_strided(t, INT64_MAX, simplex, simplex, simplex, 0),
                MGDT_ERR_TOO_LARGE);
    CHECK_EQUAL(mgdt_get_tetrahedra(t, -1, &out), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(out, -7);
    still_simplex(t);
}

static void messages(mgdt_triangulation* t) {
    char whole[256], cut[9];
    memset(cut, 'x', sizeof cut);
    CHECK_EQUAL(mgdt_set_index_base(t, 77), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_get_error(t, (int64_t)sizeof whole, whole), MGDT_OK);
    CHECK(strlen(whole) > 8 && strstr(whole, "77") != NULL);
    CHECK_EQUAL(mgdt_get_error(t, 8, cut), MGDT_OK);
    CHECK(strlen(cut) == 7 && strncmp(cut, whole, 7) == 0 && cut[8] == 'x');
    CHECK_EQUAL(mgdt_get_error(t, 1, cut), MGDT_OK);
    CHECK(cut[0] == '\0' && cut[1] == whole[1]);
    CHECK_EQUAL(mgdt_get_error(t, 0, cut), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_get_error(t, -4, cut), MGDT_ERR_INVALID_ARGUMENT);
}

static void half_allocators(void) {
    mgdt_triangulation* t = (mgdt_triangulation*)&t;
    CHECK_EQUAL(mgdt_create_with_allocator(NULL, (mgdt_free_fn)(size_t)1, NULL, &t),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK(t == NULL);
    t = (mgdt_triangulation*)&t;
    CHECK_EQUAL(mgdt_create_with_allocator((mgdt_alloc_fn)(size_t)1, NULL, NULL, &t),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK(t == NULL);
}

/* A handle without points answers every question. */
static void empty(void) {
    mgdt_triangulation* t = NULL;
    char text[256] = "x";
    int64_t out = 5, offsets[1] = {5};
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK_EQUAL(mgdt_get_error(t, (int64_t)sizeof text, text), MGDT_OK);
    CHECK_EQUAL(text[0], 0);
    CHECK_EQUAL(mgdt_dimension(t), -1);
    CHECK_EQUAL(mgdt_point_count(t), 0);
    CHECK_EQUAL(mgdt_vertex_count(t), 0);
    CHECK_EQUAL(mgdt_tetrahedron_count(t), 0);
    CHECK_EQUAL(mgdt_hull_facet_count(t), 0);
    CHECK_EQUAL(mgdt_edge_count(t), 0);
    CHECK_EQUAL(mgdt_get_tetrahedra(t, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_get_neighbors(t, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_get_hull_facets(t, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_get_edges(t, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_get_point_map(t, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_get_vertex_tetrahedra(t, 1, offsets, 0, NULL), MGDT_OK);
    CHECK_EQUAL(offsets[0], 0);
    offsets[0] = 5;
    CHECK_EQUAL(mgdt_get_vertex_neighbors(t, 1, offsets, 0, NULL), MGDT_OK);
    CHECK_EQUAL(offsets[0], 0);
    CHECK_EQUAL(mgdt_get_circumcenters(t, 0, NULL, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_VOLUME, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_get_tetrahedron_measures(t, 11, 0, NULL), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 0, NULL, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_get_alphas(t, 1, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_get_alpha_surface(t, 1, 0, NULL, &out), MGDT_OK);
    CHECK_EQUAL(out, 0);
    CHECK_EQUAL(mgdt_get_gabriel_edges(t, 0, NULL, &out), MGDT_OK);
    CHECK_EQUAL(out, 0);
    CHECK_EQUAL(mgdt_get_spanning_tree(t, 0, NULL, &out), MGDT_OK);
    CHECK_EQUAL(out, 0);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    CHECK_EQUAL(mgdt_locate(t, simplex, &out), MGDT_OK);
    CHECK_EQUAL(out, -1);
    CHECK_EQUAL(mgdt_traverse_segment(t, simplex, simplex + 3, 0, NULL, NULL, &out), MGDT_OK);
    CHECK_EQUAL(out, 0);
    out = 5;
    CHECK_EQUAL(mgdt_nearest_vertex(t, simplex, &out), MGDT_OK);
    CHECK_EQUAL(out, -1);
    CHECK_EQUAL(mgdt_insert_points(t, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK_EQUAL(mgdt_dimension(t), -1);
    mgdt_destroy(t);
}

void test_arguments(void) {
    mgdt_triangulation* t = make(4, simplex);
    null_handles();
    half_allocators();
    empty();
    if (t == NULL) return;
    null_arrays(t);
    settings(t);
    not_finite(t);
    counts(t);
    messages(t);
    still_simplex(t);
    mgdt_destroy(t);
}
