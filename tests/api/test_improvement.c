/* SPDX-License-Identifier: MIT
 * Meshes of the caller's tetrahedra, and their improvement. */
#include <math.h>
#include <mgdt/mgdt_domain.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum {
    side = 4,
    n_points = (side + 1) * (side + 1) * (side + 1),
    n_tetrahedra = 6 * side * side * side
};

/* The cubes of a lattice, each divided into six tetrahedra. Inner points are moved, and the
 * orientations of tetrahedra differ. The upper half has the marker 7, the lower one -2. */
static double lattice_points[3 * n_points];
static int64_t lattice[4 * n_tetrahedra];
static int32_t lattice_markers[n_tetrahedra];

static void make_lattice(void) {
    static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                     {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static const int steps[3] = {1, side + 1, (side + 1) * (side + 1)};
    uint64_t seed = 5;
    int i, k, t = 0;
    for (i = 0; i < n_points; ++i)
        for (k = 0; k < 3; ++k) {
            const int at = i / steps[k] % (side + 1);
            const int is_inner = at > 0 && at < side && (k < 2 || at != side / 2);
            const double move = .4 * (random_double(&seed) - .5);
            lattice_points[3 * i + k] = at + (is_inner ? move : 0);
        }
    for (i = 0; i < n_points; ++i) {
        if (i % steps[1] == side || i / steps[1] % (side + 1) == side || i / steps[2] == side)
            continue;
        for (k = 0; k < 6; ++k, ++t) {
            const int first = i + steps[orders[k][0]], second = first + steps[orders[k][1]];
            lattice[4 * t] = i;
            lattice[4 * t + 1] = first;
            lattice[4 * t + 2] = second;
            lattice[4 * t + 3] = second + steps[orders[k][2]];
            lattice_markers[t] = i / steps[2] < side / 2 ? -2 : 7;
        }
    }
}

static mgdt_mesh* lattice_mesh(void) {
    mgdt_mesh* m = NULL;
    CHECK_EQUAL(mgdt_mesh_create(&m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_points(m, n_points, lattice_points), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra(m, n_tetrahedra, lattice, lattice_markers), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_build(m), MGDT_OK);
    return m;
}

static int64_t stat_of(const mgdt_mesh* m, int32_t key) {
    int64_t value = -1;
    CHECK_EQUAL(mgdt_mesh_get_stat(m, key, &value), MGDT_OK);
    return value;
}

static int64_t size_of(const mgdt_mesh* m, int32_t array) {
    int64_t size = -1;
    CHECK_EQUAL(mgdt_mesh_get_size(m, array, &size), MGDT_OK);
    return size;
}

static int64_t* array_of(const mgdt_mesh* m, int32_t key) {
    const int64_t size = size_of(m, key);
    int64_t* const values = malloc((size_t)(size + 1) * sizeof *values);
    CHECK_EQUAL(mgdt_mesh_get_array(m, key, size, values), MGDT_OK);
    return values;
}

static double* doubles_of(const mgdt_mesh* m, int32_t key) {
    const int64_t size = size_of(m, key);
    double* const values = malloc((size_t)(size + 1) * sizeof *values);
    CHECK_EQUAL(mgdt_mesh_get_doubles(m, key, size, values), MGDT_OK);
    return values;
}

static int check_message(const mgdt_mesh* m, const char* text) {
    char message[256] = "";
    CHECK_EQUAL(mgdt_mesh_get_error(m, sizeof message, message), MGDT_OK);
    if (strstr(message, text) == NULL) printf("the message is: %s\n", message);
    return CHECK(strstr(message, text) != NULL);
}

static void set(mgdt_mesh* m, int32_t option, int64_t value) {
    CHECK_EQUAL(mgdt_mesh_set_option(m, option, value), MGDT_OK);
}

/* Least dihedral angle in radians. */
static double least_angle(const mgdt_mesh* m) {
    const int64_t n = stat_of(m, MGDT_MESH_STAT_TETRAHEDRA);
    double* const x = malloc((size_t)n * sizeof *x);
    double least = 9;
    int64_t i;
    CHECK_EQUAL(mgdt_mesh_get_tetrahedron_measures(m, MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE, n, x),
                MGDT_OK);
    for (i = 0; i < n; ++i) least = x[i] < least ? x[i] : least;
    free(x);
    return least;
}

/* Whether two meshes have the same points, tetrahedra and faces, to the last bit. */
static int are_same(const mgdt_mesh* a, const mgdt_mesh* b) {
    static const int32_t keys[] = {MGDT_MESH_ARRAY_TETRAHEDRA, MGDT_MESH_ARRAY_NEIGHBORS,
                                   MGDT_MESH_ARRAY_FACES,      MGDT_MESH_ARRAY_FACE_MARKERS,
                                   MGDT_MESH_ARRAY_EDGES,      MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS,
                                   MGDT_MESH_ARRAY_REASONS,    MGDT_MESH_ARRAY_ANGLE_HISTOGRAM};
    double *x, *y;
    int same;
    size_t k;
    if (size_of(a, MGDT_MESH_ARRAY_POINTS) != size_of(b, MGDT_MESH_ARRAY_POINTS)) return 0;
    x = doubles_of(a, MGDT_MESH_ARRAY_POINTS);
    y = doubles_of(b, MGDT_MESH_ARRAY_POINTS);
    same = memcmp(x, y, (size_t)size_of(a, MGDT_MESH_ARRAY_POINTS) * sizeof *x) == 0;
    free(x);
    free(y);
    for (k = 0; k < sizeof keys / sizeof *keys && same; ++k) {
        const int64_t size = size_of(a, keys[k]);
        int64_t *v, *w;
        if (size != size_of(b, keys[k])) return 0;
        v = array_of(a, keys[k]);
        w = array_of(b, keys[k]);
        same = memcmp(v, w, (size_t)size * sizeof *v) == 0;
        free(v);
        free(w);
    }
    return same;
}

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
    check_message(m, "fixed point 0 has the corner 6");
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

static void options(void) {
    static const struct {
        int32_t key;
        int64_t first, most;
    } all[] = {{MGDT_MESH_OPTION_GOAL, 25, 70},
               {MGDT_MESH_OPTION_BOUNDARY, MGDT_BOUNDARY_FIXED, MGDT_BOUNDARY_SLIDE},
               {MGDT_MESH_OPTION_POINTS, MGDT_POINTS_MOVE, MGDT_POINTS_REMOVE},
               {MGDT_MESH_OPTION_MEAN_PASSES, 0, 1000},
               {MGDT_MESH_OPTION_MOST_PASSES, 100, 10000}};
    mgdt_mesh* m = NULL;
    int64_t value = -1;
    size_t k;
    CHECK_EQUAL(mgdt_mesh_create_with_allocator(NULL, NULL, NULL, &m), MGDT_OK);
    for (k = 0; k < sizeof all / sizeof *all; ++k) {
        CHECK_EQUAL(mgdt_mesh_get_option(m, all[k].key, &value), MGDT_OK);
        CHECK_EQUAL(value, all[k].first);
        CHECK_EQUAL(mgdt_mesh_set_option(m, all[k].key, -1), MGDT_ERR_INVALID_ARGUMENT);
        CHECK_EQUAL(mgdt_mesh_set_option(m, all[k].key, all[k].most + 1),
                    MGDT_ERR_INVALID_ARGUMENT);
        set(m, all[k].key, all[k].most);
        CHECK_EQUAL(mgdt_mesh_get_option(m, all[k].key, &value), MGDT_OK);
        CHECK_EQUAL(value, all[k].most);
    }
    mgdt_mesh_destroy(m);
}

/* The arrays that describe an improvement agree with each other and with the mesh. */
static void report(const mgdt_mesh* m, int64_t tetrahedra_before) {
    const int64_t n = stat_of(m, MGDT_MESH_STAT_TETRAHEDRA);
    int64_t* const histogram = array_of(m, MGDT_MESH_ARRAY_ANGLE_HISTOGRAM);
    int64_t* const below = array_of(m, MGDT_MESH_ARRAY_TETRAHEDRA_BELOW);
    int64_t* const reasons = array_of(m, MGDT_MESH_ARRAY_REASONS);
    double* const shapes = doubles_of(m, MGDT_MESH_ARRAY_SHAPES);
    int64_t sums[2] = {0, 0}, left = 0, i;
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_ANGLE_HISTOGRAM), 36);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_TETRAHEDRA_BELOW), 12);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_SHAPES), 6);
    CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_REASONS), n);
    for (i = 0; i < 36; ++i) sums[i % 2] += histogram[i];
    CHECK_EQUAL(sums[0], 6 * tetrahedra_before);
    CHECK_EQUAL(sums[1], 6 * n);
    CHECK(fabs(shapes[1] - least_angle(m) * 180 / 3.14159265358979) < 1e-9);
    CHECK(shapes[0] <= shapes[1]);
    CHECK(shapes[2] < 180 && shapes[3] < 180 && shapes[3] > 60);
    CHECK(shapes[4] > 0 && shapes[4] < shapes[5] && shapes[5] < 1);
    /* Tetrahedra with an angle below 5 i + 5 degrees. */
    for (i = 0; i < 6; ++i) CHECK_EQUAL(below[2 * i + 1] > 0, shapes[1] < 5 * (double)i + 5 - 1e-9);
    for (i = 0; i < n; ++i) left += reasons[i] != MGDT_REASON_NONE ? 1 : 0;
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_BELOW_GOAL), left);
    free(histogram);
    free(below);
    free(reasons);
    free(shapes);
}

static int is_on_surface(int64_t p) {
    int k;
    int is = 0;
    for (k = 0; k < 3; ++k) {
        const double x = lattice_points[3 * p + k];
        is |= x == 0 || x == side || (k == 2 && x == side / 2);
    }
    return is;
}

/* The mesh reaches the goal; what may not move does not, and a second call changes nothing. */
static void improve(int64_t boundary, int64_t points) {
    static const int64_t fixed[2] = {31, 62};
    mgdt_mesh* const m = lattice_mesh();
    mgdt_mesh* const other = lattice_mesh();
    const double before = least_angle(m);
    double* xyz;
    int64_t i, k, moved = 0;
    mgdt_mesh* both[2];
    both[0] = m;
    both[1] = other;
    for (i = 0; i < 2; ++i) {
        set(both[i], MGDT_MESH_OPTION_BOUNDARY, boundary);
        set(both[i], MGDT_MESH_OPTION_POINTS, points);
        set(both[i], MGDT_MESH_OPTION_THREADS, 1 + 3 * i);
        CHECK_EQUAL(mgdt_mesh_set_fixed_points(both[i], 2, fixed), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_improve(both[i]), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_check(both[i]), MGDT_OK);
        report(both[i], n_tetrahedra);
    }
    CHECK(are_same(m, other));
    CHECK(least_angle(m) > before);
    if (points != MGDT_POINTS_KEEP) CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_BELOW_GOAL), 0);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_REGIONS), 2);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_POINTS) - stat_of(m, MGDT_MESH_STAT_STEINER_POINTS),
                n_points);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_UNUSED_POINTS),
                stat_of(m, MGDT_MESH_STAT_REMOVED_POINTS));
    if (points != MGDT_POINTS_REMOVE) CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_UNUSED_POINTS), 0);
    xyz = doubles_of(m, MGDT_MESH_ARRAY_POINTS);
    for (i = 0; i < n_points; ++i) {
        const int is_fixed = points == MGDT_POINTS_KEEP || i == fixed[0] || i == fixed[1] ||
                             (boundary == MGDT_BOUNDARY_FIXED && is_on_surface(i));
        int moves = 0;
        for (k = 0; k < 3; ++k) {
            const double x = lattice_points[3 * i + k];
            moves |= xyz[3 * i + k] != x;
            if (x == 0 || x == side || (k == 2 && x == side / 2))
                CHECK(fabs(xyz[3 * i + k] - x) < 1e-13);
        }
        moved += moves;
        if (is_fixed) CHECK(!moves);
    }
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_MOVED_POINTS), moved);
    free(xyz);
    if (points == MGDT_POINTS_MOVE) {
        CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
        CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_MOVED_POINTS), 0);
        report(other, n_tetrahedra);
        CHECK_EQUAL(size_of(m, MGDT_MESH_ARRAY_TETRAHEDRA),
                    size_of(other, MGDT_MESH_ARRAY_TETRAHEDRA));
        xyz = doubles_of(m, MGDT_MESH_ARRAY_POINTS);
        {
            double* const same = doubles_of(other, MGDT_MESH_ARRAY_POINTS);
            CHECK(memcmp(xyz, same, (size_t)size_of(m, MGDT_MESH_ARRAY_POINTS) * sizeof *xyz) == 0);
            free(same);
        }
        free(xyz);
    }
    mgdt_mesh_destroy(m);
    mgdt_mesh_destroy(other);
}

/* A goal that no mesh reaches leaves reasons; the worst tetrahedron is no worse. */
static void unreachable_goal(void) {
    mgdt_mesh* const m = lattice_mesh();
    const double before = least_angle(m);
    set(m, MGDT_MESH_OPTION_GOAL, 65);
    set(m, MGDT_MESH_OPTION_MOST_PASSES, 5);
    CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK(least_angle(m) >= before);
    CHECK(stat_of(m, MGDT_MESH_STAT_BELOW_GOAL) > 0);
    CHECK(stat_of(m, MGDT_MESH_STAT_PASSES) > 0);
    report(m, n_tetrahedra);
    mgdt_mesh_destroy(m);
}

static struct {
    mgdt_mesh* mesh;
    double last;
    int reports, most;
} watched;

static int32_t watch(double fraction, void* user) {
    CHECK(user == &watched);
    CHECK(fraction >= watched.last && fraction <= 1);
    watched.last = fraction;
    return ++watched.reports > watched.most;
}

/* Wherever it is cancelled, an improvement leaves a valid mesh that is no worse. */
static void cancel(void) {
    int is_finished = 0, most;
    for (most = 0; most < 400 && !is_finished; most += 1 + most / 4) {
        mgdt_mesh* const m = lattice_mesh();
        const double before = least_angle(m);
        mgdt_status status;
        watched.mesh = m;
        watched.last = 0;
        watched.reports = 0;
        watched.most = most;
        CHECK_EQUAL(mgdt_mesh_set_progress(m, watch, &watched), MGDT_OK);
        set(m, MGDT_MESH_OPTION_GOAL, 40);
        set(m, MGDT_MESH_OPTION_MOST_PASSES, 4);
        status = mgdt_mesh_improve(m);
        is_finished = status == MGDT_OK;
        if (!is_finished) {
            CHECK_EQUAL(status, MGDT_ERR_CANCELLED);
            check_message(m, "cancelled");
        }
        CHECK_EQUAL(mgdt_mesh_set_progress(m, NULL, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
        CHECK(least_angle(m) >= before);
        mgdt_mesh_destroy(m);
    }
    CHECK(is_finished);
    CHECK(watched.last == 1);
    {
        mgdt_mesh* const m = lattice_mesh();
        CHECK_EQUAL(mgdt_mesh_cancel(m), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_ERR_CANCELLED);
        CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
        mgdt_mesh_destroy(m);
    }
}

/* The mesh of a domain keeps the points of the domain, and is Delaunay no more. */
static void domain_mesh(void) {
    static const double prism[6 * 3] = {8, 0, 0, -4, 7, 0, -4, -7, 0, 7, 4, 8, -7, 4, 8, 0, -8, 8};
    static const int64_t triangles[8 * 3] = {0, 2, 1, 3, 4, 5, 0, 1, 4, 0, 4, 3,
                                             1, 2, 5, 1, 5, 4, 2, 0, 3, 2, 3, 5};
    mgdt_domain* d = NULL;
    mgdt_mesh* m = NULL;
    char message[256];
    int64_t value = -1;
    double* xyz;
    CHECK_EQUAL(mgdt_domain_create(&d), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_points(d, 6, prism), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_set_facets(d, 8, NULL, triangles, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_domain_build(d, &m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_get_option(m, MGDT_MESH_OPTION_POINTS, &value), MGDT_OK);
    CHECK_EQUAL(value, MGDT_POINTS_KEEP);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_IS_DELAUNAY), 1);
    set(m, MGDT_MESH_OPTION_BOUNDARY, MGDT_BOUNDARY_SLIDE);
    CHECK_EQUAL(mgdt_mesh_improve(m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_check(m), MGDT_OK);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_IS_DELAUNAY), 0);
    CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_MOVED_POINTS), 0);
    CHECK_EQUAL(mgdt_domain_check(d, m), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_domain_get_error(d, sizeof message, message), MGDT_OK);
    CHECK(strstr(message, "has been improved") != NULL);
    xyz = doubles_of(m, MGDT_MESH_ARRAY_POINTS);
    CHECK(memcmp(xyz, prism, sizeof prism) == 0);
    free(xyz);
    mgdt_mesh_destroy(m);
    mgdt_domain_destroy(d);
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
        mgdt_mesh* c = NULL;
        CHECK_EQUAL(mgdt_mesh_create(&c), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_set_points(c, 8, cube), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_set_tetrahedra(c, 6, corners, NULL), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_build(c), MGDT_OK);
        CHECK_EQUAL(mgdt_mesh_get_shape_summary(c, found, angles, below), MGDT_OK);
        CHECK(fabs(found[0] - 45) < 1e-12 && fabs(found[1] - 90) < 1e-12);
        CHECK(angles[4] == 12 && angles[6] == 6 && angles[9] == 18);
        mgdt_mesh_destroy(c);
    }
}

/* An improvement that needs more memory than allowed changes nothing. */
static void memory_limit(void) {
    mgdt_mesh* const m = lattice_mesh();
    mgdt_mesh* const other = lattice_mesh();
    const int64_t bytes = stat_of(m, MGDT_MESH_STAT_MEMORY_BYTES);
    int64_t more;
    for (more = 0; more < 99 * bytes; more += bytes / 4) {
        mgdt_status status;
        set(m, MGDT_MESH_OPTION_MEMORY_LIMIT, bytes + more);
        status = mgdt_mesh_improve(m);
        if (status == MGDT_OK) break;
        CHECK_EQUAL(status, MGDT_ERR_OUT_OF_MEMORY);
        CHECK_EQUAL(stat_of(m, MGDT_MESH_STAT_MEMORY_BYTES), bytes);
        CHECK(are_same(m, other));
    }
    CHECK(more > 0);
    CHECK_EQUAL(mgdt_mesh_improve(other), MGDT_OK);
    CHECK(are_same(m, other));
    mgdt_mesh_destroy(m);
    mgdt_mesh_destroy(other);
}

void test_improvement(void) {
    int64_t boundary, points;
    make_lattice();
    build();
    listed_items();
    refusals();
    options();
    for (boundary = 0; boundary < 2; ++boundary)
        for (points = 0; points < 3; ++points) improve(boundary, points);
    unreachable_goal();
    cancel();
    domain_mesh();
    places();
    shape_summary();
    memory_limit();
}
