/* SPDX-License-Identifier: MIT
 * Meshes of the caller's tetrahedra: what is refused, places in them, and their shapes. */
#include <math.h>

#include "given_lattice.h"

/* Tetrahedra keep their numbers; regions, faces and neighbours are found. */
static void build(void) {
    mgdt_mesh* const m = lattice_mesh();
    int64_t *v, *regions, *markers, *origins, *facets;
    int64_t i, j, k;
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_TETRAHEDRA), n_tetrahedra);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_POINTS), n_points);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_STEINER_POINTS), 0);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_REGIONS), 2);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_IS_DELAUNAY), 0);
    /* Six sides, and the plane between the regions; four of the sides belong to both regions. */
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_FACES), 7 * 2 * side * side);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_PLANAR_FACETS), 11);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_REASONS), 0);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_SHAPES), 0);
    v = array_of(m, MGDT_MESH_ARRAY_TETRAHEDRA);
    regions = array_of(m, MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS);
    markers = array_of(m, MGDT_MESH_ARRAY_REGION_MARKERS);
    origins = array_of(m, MGDT_MESH_ARRAY_POINT_ORIGINS);
    facets = array_of(m, MGDT_MESH_ARRAY_FACE_FACETS);
    for (i = 0; i < n_tetrahedra; ++i) {
        for (j = 0; j < 4; ++j) {
            for (k = 0; k < 4 && v[4 * i + k] != lattice[4 * i + j];) ++k;
            CHECK(k < 4);
        }
        CHECK_EQUAL(markers[regions[i]], lattice_markers[i]);
    }
    for (i = 0; i < n_points; ++i) CHECK_EQUAL(origins[i], i);
    CHECK_EQUAL(facets[0], 0);
    free(v);
    free(regions);
    free(markers);
    free(origins);
    free(facets);
    /* What was set is gone, and the mesh stays. */
    CHECK_EQUAL(mgdt_mesh_build(m), MGDT_ERR_INVALID_ARGUMENT);
    check_message(m, "no tetrahedra have been set since the last build");
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_TETRAHEDRA), n_tetrahedra);
    mgdt_mesh_destroy(m);
}

/* The numbers that the caller counts from 1, in 32 bits, and the faces and edges with markers. */
static void listed_items(void) {
    static const double xyz[5 * 3] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    static const int32_t tetrahedra[8] = {1, 2, 3, 4, 2, 3, 4, 5};
    static const int32_t faces[6] = {4, 2, 3, 5, 3, 2}, face_markers[2] = {9, -9};
    static const int32_t edges[2] = {4, 3}, edge_markers[1] = {5};
    mgdt_mesh* m = NULL;
    int64_t *v, *of_faces, *tetrahedra_at, *segments;
    CHECK_EQUAL(mgdt_mesh_create(&m), MGDT_OK);
    set(m, MGDT_MESH_OPTION_INDEX_BASE, 1);
    CHECK_EQUAL(mgdt_mesh_set_points(m, 5, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra_i32(m, 2, tetrahedra, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_faces_i32(m, 2, faces, face_markers), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_edges_i32(m, 1, edges, edge_markers), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_fixed_points_i32(m, 1, tetrahedra), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_build(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_FACES), 7);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_REGIONS), 1);
    v = array_of(m, MGDT_MESH_ARRAY_FACES);
    CHECK(v[0] == 4 && v[1] == 2 && v[2] == 3 && v[3] == 5 && v[4] == 3 && v[5] == 2);
    free(v);
    v = array_of(m, MGDT_MESH_ARRAY_EDGES);
    CHECK(v[0] == 4 && v[1] == 3);
    free(v);
    segments = array_of(m, MGDT_MESH_ARRAY_EDGE_SEGMENTS);
    CHECK(segments[0] == 1 && segments[1] == 0);
    free(segments);
    of_faces = array_of(m, MGDT_MESH_ARRAY_FACE_MARKERS);
    CHECK(of_faces[0] == 9 && of_faces[1] == -9 && of_faces[2] == 0);
    free(of_faces);
    tetrahedra_at = array_of(m, MGDT_MESH_ARRAY_FACE_TETRAHEDRA);
    CHECK(tetrahedra_at[0] == 2 && tetrahedra_at[1] == 1);
    CHECK(tetrahedra_at[2] == 2 && tetrahedra_at[3] == 0);
    free(tetrahedra_at);
    mgdt_mesh_destroy(m);
}

static void refusals(void) {
    static const double xyz[6 * 3] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0, -1};
    static const int64_t flat[8] = {0, 1, 2, 3, 0, 1, 2, 4}, twice[8] = {0, 1, 2, 3, 3, 1, 0, 2},
                         beyond[4] = {0, 1, 2, 6}, negative[4] = {0, 1, 2, -1},
                         good[8] = {0, 1, 2, 3, 0, 1, 2, 5}, corner[4] = {0, 1, 1, 3};
    double bad[3] = {0, NAN, 0};
    mgdt_mesh* m = NULL;
    CHECK_EQUAL(mgdt_mesh_create(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_create(&m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_build(m), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra(m, 1, good, NULL), MGDT_ERR_INVALID_ARGUMENT);
    check_message(m, "tetrahedron 0 has the corner 0; there are 0 points");
    CHECK_EQUAL(mgdt_mesh_set_points(m, -1, xyz), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_mesh_set_points(m, 1, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_points(m, 1, bad), MGDT_ERR_NOT_FINITE);
    check_message(m, "coordinate y of point 0");
    CHECK_EQUAL(mgdt_mesh_set_points(m, INT64_MAX / 3, xyz), MGDT_ERR_TOO_LARGE);
    CHECK_EQUAL(mgdt_mesh_set_points(m, 6, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra(m, 1, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra(m, 1, beyond, NULL), MGDT_ERR_INVALID_ARGUMENT);
    check_message(m, "tetrahedron 0 has the corner 6; there are 6 points");
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra(m, 1, negative, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_mesh_set_faces(m, 2, beyond + 1, NULL), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_mesh_set_edges(m, 1, beyond + 2, NULL), MGDT_ERR_INVALID_ARGUMENT);
    check_message(m, "edge 0 has the corner 6");
    CHECK_EQUAL(mgdt_mesh_set_fixed_points(m, 1, beyond + 3), MGDT_ERR_INVALID_ARGUMENT);
    check_message(m, "fixed point 0 is 6; there are");
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra(m, 2, flat, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_build(m), MGDT_ERR_INVALID_ARGUMENT);
    check_message(m, "tetrahedron 1 is flat");
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra(m, 2, twice, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_build(m), MGDT_ERR_INVALID_ARGUMENT);
    check_message(m, "tetrahedra 0 and 1 have the same corners");
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra(m, 1, corner, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_build(m), MGDT_ERR_INVALID_ARGUMENT);
    check_message(m, "tetrahedron 0 has a corner twice");
    /* The points are still there. */
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra(m, 2, good, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_faces(m, 1, flat + 5, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_build(m), MGDT_ERR_INVALID_ARGUMENT);
    check_message(m, "face 0 is no face of a tetrahedron");
    CHECK_EQUAL(mgdt_mesh_set_faces(m, 0, NULL, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_build(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_UNUSED_POINTS), 1);
    /* A failed build leaves the mesh. */
    CHECK_EQUAL(mgdt_mesh_set_points(m, 5, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra(m, 2, flat, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_build(m), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_POINTS), 6);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_TETRAHEDRA), 2);
    mgdt_mesh_destroy(m);
    CHECK_EQUAL(mgdt_mesh_set_points(NULL, 0, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra(NULL, 0, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra_i32(NULL, 0, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_faces(NULL, 0, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_faces_i32(NULL, 0, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_edges(NULL, 0, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_edges_i32(NULL, 0, NULL, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_fixed_points(NULL, 0, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_set_fixed_points_i32(NULL, 0, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_build(NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_improve(NULL), MGDT_ERR_NULL_POINTER);
}

/* Places inside, on faces, and outside; values between points. */
static void places(void) {
    static const double xyz[4 * 3] = {1.25, 1.5, 1.75, 0, 0, 0, -1, 1.5, 1.5, 2, 5.5, 1};
    mgdt_mesh* const m = lattice_mesh();
    int64_t found[4], wide[4];
    int32_t narrow[4];
    double weights[16], nearest[16], out[8], *values = malloc(2 * n_points * sizeof *values);
    int64_t *v = array_of(m, MGDT_MESH_ARRAY_TETRAHEDRA), i, k, j;
    for (i = 0; i < n_points; ++i) {
        values[2 * i] = 1 + lattice_points[3 * i] - 2 * lattice_points[3 * i + 1];
        values[2 * i + 1] = lattice_points[3 * i + 2];
    }
    CHECK_EQUAL(mgdt_mesh_locate_points(m, MGDT_OUTSIDE_NONE, 4, xyz, found, weights), MGDT_OK);
    CHECK(found[0] >= 0 && found[1] == 0 && found[2] == -1 && found[3] == -1);
    for (k = 8; k < 16; ++k) CHECK(weights[k] == 0);
    CHECK_EQUAL(mgdt_mesh_locate_points_i32(m, MGDT_OUTSIDE_NONE, 4, xyz, narrow, NULL), MGDT_OK);
    for (i = 0; i < 4; ++i) CHECK_EQUAL(narrow[i], found[i]);
    set(m, MGDT_MESH_OPTION_INDEX_BASE, 1);
    CHECK_EQUAL(mgdt_mesh_locate_points(m, MGDT_OUTSIDE_BOUNDARY, 4, xyz, wide, nearest), MGDT_OK);
    for (i = 0; i < 2; ++i) CHECK_EQUAL(wide[i], found[i] + 1);
    for (i = 2; i < 4; ++i) {
        double x[3] = {0, 0, 0};
        CHECK(wide[i] >= 1);
        for (k = 0; k < 4; ++k)
            for (j = 0; j < 3; ++j)
                x[j] += nearest[4 * i + k] * lattice_points[3 * v[4 * (wide[i] - 1) + k] + j];
        for (j = 0; j < 3; ++j) {
            const double at = xyz[3 * i + j];
            CHECK(fabs(x[j] - (at < 0 ? 0 : at > side ? side : at)) < 1e-14);
        }
    }
    set(m, MGDT_MESH_OPTION_INDEX_BASE, 0);
    CHECK_EQUAL(mgdt_mesh_interpolate(m, MGDT_OUTSIDE_NONE, 2, values, 4, xyz, out), MGDT_OK);
    CHECK(fabs(out[0] - (1 + 1.25 - 3)) < 1e-13 && fabs(out[1] - 1.75) < 1e-13);
    CHECK(out[4] != out[4] && out[7] != out[7]);
    CHECK_EQUAL(mgdt_mesh_interpolate(m, MGDT_OUTSIDE_BOUNDARY, 2, values, 4, xyz, out), MGDT_OK);
    CHECK(fabs(out[4] - (1 - 3)) < 1e-13 && fabs(out[5] - 1.5) < 1e-13);
    CHECK(fabs(out[6] - (1 + 2 - 8)) < 1e-13 && fabs(out[7] - 1) < 1e-13);
    CHECK_EQUAL(mgdt_mesh_interpolate(m, MGDT_OUTSIDE_NONE, 0, NULL, 4, xyz, NULL), MGDT_OK);

    /* What finds places does not outlive the mesh that it is for. */
    set(m, MGDT_MESH_OPTION_GOAL, 30);
    CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_locate_points(m, MGDT_OUTSIDE_NONE, 1, xyz, found, weights), MGDT_OK);
    free(v);
    v = array_of(m, MGDT_MESH_ARRAY_TETRAHEDRA);
    {
        double* const points = doubles_of(m, MGDT_MESH_ARRAY_POINTS);
        for (j = 0; j < 3; ++j) {
            double x = 0;
            for (k = 0; k < 4; ++k) x += weights[k] * points[3 * v[4 * found[0] + k] + j];
            CHECK(fabs(x - xyz[j]) < 1e-14);
        }
        free(points);
    }

    CHECK_EQUAL(mgdt_mesh_locate_points(m, MGDT_OUTSIDE_NEAREST, 1, xyz, found, NULL),
                MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_mesh_locate_points(m, MGDT_OUTSIDE_NONE, -1, xyz, found, NULL),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_mesh_locate_points(m, MGDT_OUTSIDE_NONE, 1, NULL, found, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_locate_points(m, MGDT_OUTSIDE_NONE, 1, xyz, NULL, NULL),
                MGDT_ERR_NULL_POINTER);
    out[0] = NAN;
    CHECK_EQUAL(mgdt_mesh_locate_points(m, MGDT_OUTSIDE_NONE, 1, out, found, NULL),
                MGDT_ERR_NOT_FINITE);
    CHECK_EQUAL(mgdt_mesh_interpolate(m, MGDT_OUTSIDE_NONE, 1, NULL, 1, xyz, out),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_interpolate(m, MGDT_OUTSIDE_NONE, -1, values, 1, xyz, out),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_mesh_interpolate(m, MGDT_OUTSIDE_LINEAR, 1, values, 1, xyz, out),
                MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_mesh_locate_points(NULL, MGDT_OUTSIDE_NONE, 0, NULL, NULL, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_locate_points_i32(NULL, MGDT_OUTSIDE_NONE, 0, NULL, NULL, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_mesh_interpolate(NULL, MGDT_OUTSIDE_NONE, 0, NULL, 0, NULL, NULL),
                MGDT_ERR_NULL_POINTER);
    free(v);
    free(values);
    mgdt_mesh_destroy(m);
    /* A mesh without tetrahedra has nothing inside. */
    {
        mgdt_mesh* empty = NULL;
        CHECK_EQUAL(mgdt_mesh_create(&empty), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_locate_points(empty, MGDT_OUTSIDE_BOUNDARY, 4, xyz, found, weights),
                    MGDT_OK);
        for (i = 0; i < 4; ++i) CHECK_EQUAL(found[i], -1);
        mgdt_mesh_destroy(empty);
    }
}

/* The summary of a mesh is that of the improvement that has made it. */
static void shape_summary(void) {
    mgdt_mesh* const m = lattice_mesh();
    double found[3], *shapes;
    int64_t angles[18], below[6], *histogram, *counts, i;
    CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_get_shape_summary(m, found, angles, below), MGDT_OK);
    shapes = doubles_of(m, MGDT_MESH_ARRAY_SHAPES);
    histogram = array_of(m, MGDT_MESH_ARRAY_ANGLE_HISTOGRAM);
    counts = array_of(m, MGDT_MESH_ARRAY_TETRAHEDRA_BELOW);
    for (i = 0; i < 3; ++i) CHECK(found[i] == shapes[2 * i + 1]);
    for (i = 0; i < 18; ++i) CHECK_EQUAL(angles[i], histogram[2 * i + 1]);
    for (i = 0; i < 6; ++i) CHECK_EQUAL(below[i], counts[2 * i + 1]);
    free(shapes);
    free(histogram);
    free(counts);
    CHECK_EQUAL(mgdt_mesh_get_shape_summary(m, NULL, NULL, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_get_shape_summary(NULL, found, NULL, NULL), MGDT_ERR_NULL_POINTER);
    mgdt_mesh_destroy(m);
    /* A cube's angles are multiples of 15 degrees, which rounding does not move. */
    {
        static const double cube[8 * 3] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0,
                                           0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1};
        static const int64_t corners[24] = {0, 1, 3, 7, 0, 1, 5, 7, 0, 2, 3, 7,
                                            0, 2, 6, 7, 0, 4, 5, 7, 0, 4, 6, 7};
        mgdt_mesh* const c = mesh_of(8, cube, 6, corners, NULL);
        CHECK_EQUAL(mgdt_mesh_get_shape_summary(c, found, angles, below), MGDT_OK);
        CHECK(fabs(found[0] - 45) < 1e-12 && fabs(found[1] - 90) < 1e-12);
        CHECK(angles[4] == 12 && angles[6] == 6 && angles[9] == 18);
        mgdt_mesh_destroy(c);
    }
}

void test_given_mesh(void) {
    make_lattice();
    build();
    listed_items();
    refusals();
    places();
    shape_summary();
}
