/* SPDX-License-Identifier: MIT
 * Points in periodic boxes, through the C interface. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "periodic_box.h"

/* The caller frees the arrays. */
static int64_t* integers(const mgdt_periodic* p, int32_t array) {
    const int64_t n = size_of(p, array);
    int64_t* const all = malloc((size_t)(n + 1) * sizeof *all);
    int32_t* const small = malloc((size_t)(n + 1) * sizeof *small);
    int64_t i;
    if (all == NULL || small == NULL) abort();
    CHECK_EQUAL(mgdt_periodic_get_array(p, array, n, all), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_get_array_i32(p, array, n, small), MGDT_OK);
    for (i = 0; i < n; ++i) CHECK_EQUAL(all[i], small[i]);
    free(small);
    return all;
}

static double* doubles(const mgdt_periodic* p, int32_t array) {
    const int64_t n = size_of(p, array);
    double* const all = malloc((size_t)(n + 1) * sizeof *all);
    if (all == NULL) abort();
    CHECK_EQUAL(mgdt_periodic_get_doubles(p, array, n, all), MGDT_OK);
    return all;
}

/* The place of an image. */
static void place(const double* points, const double* vectors, int64_t point, const int64_t* shift,
                  int32_t dimensions, double* x) {
    int32_t c, k;
    for (c = 0; c < 3; ++c) {
        x[c] = points[3 * point + c];
        for (k = 0; k < dimensions; ++k) x[c] += (double)shift[k] * vectors[3 * k + c];
    }
}

static double six_volumes(double x[4][3]) {
    double v[3][3];
    int k, c;
    for (k = 0; k < 3; ++k)
        for (c = 0; c < 3; ++c) v[k][c] = x[k + 1][c] - x[0][c];
    return v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) -
           v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
           v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
}

/* What the arrays say of each other, with an index base. */
static void arrays_agree(int32_t dimensions, int64_t base) {
    enum { n = 200 };
    mgdt_periodic* const p = make_periodic(dimensions, oblique, n);
    int64_t *map, *point_shifts, *tetrahedra, *shifts, *neighbors, *neighbor_shifts, *starts, *list,
        *list_shifts;
    double *points, *vectors, volume = 0, x[4][3];
    int64_t i, k, l, m, count, edges = 0;
    CHECK_EQUAL(mgdt_periodic_set_option(p, MGDT_PERIODIC_OPTION_INDEX_BASE, base), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_check(p), MGDT_OK);
    map = integers(p, MGDT_PERIODIC_ARRAY_POINT_MAP);
    point_shifts = integers(p, MGDT_PERIODIC_ARRAY_POINT_SHIFTS);
    tetrahedra = integers(p, MGDT_PERIODIC_ARRAY_TETRAHEDRA);
    shifts = integers(p, MGDT_PERIODIC_ARRAY_TETRAHEDRON_SHIFTS);
    neighbors = integers(p, MGDT_PERIODIC_ARRAY_NEIGHBORS);
    neighbor_shifts = integers(p, MGDT_PERIODIC_ARRAY_NEIGHBOR_SHIFTS);
    starts = integers(p, MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS);
    list = integers(p, MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS);
    list_shifts = integers(p, MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_SHIFTS);
    points = doubles(p, MGDT_PERIODIC_ARRAY_POINTS);
    vectors = doubles(p, MGDT_PERIODIC_ARRAY_VECTORS);
    count = stat_of(p, MGDT_PERIODIC_STAT_TETRAHEDRA);
    CHECK_EQUAL(size_of(p, MGDT_PERIODIC_ARRAY_TETRAHEDRA), 4 * count);
    CHECK_EQUAL(size_of(p, MGDT_PERIODIC_ARRAY_VECTORS), 3 * dimensions);
    CHECK_EQUAL(stat_of(p, MGDT_PERIODIC_STAT_DIMENSIONS), dimensions);
    CHECK_EQUAL(stat_of(p, MGDT_PERIODIC_STAT_POINTS), n);
    CHECK_EQUAL(stat_of(p, MGDT_PERIODIC_STAT_VERTICES), n);
    CHECK(stat_of(p, MGDT_PERIODIC_STAT_IMAGES) > 50 && stat_of(p, MGDT_PERIODIC_STAT_ROUNDS) > 0);
    CHECK(stat_of(p, MGDT_PERIODIC_STAT_MEMORY_BYTES) > 100000);
    for (i = 0; i < 3 * dimensions; ++i) CHECK(vectors[i] == oblique[i]);
    for (i = 0; i < n; ++i) {
        CHECK_EQUAL(map[i], i + base);
        for (k = 0; k < 3; ++k) CHECK_EQUAL(point_shifts[3 * i + k], 0);
    }
    for (i = 0; i < count; ++i) {
        for (k = 0; k < 4; ++k) {
            const int64_t neighbor = neighbors[4 * i + k] - base;
            int64_t shared = 0;
            place(points, vectors, tetrahedra[4 * i + k] - base, shifts + 12 * i + 3 * k,
                  dimensions, x[k]);
            for (l = dimensions; l < 3; ++l) CHECK_EQUAL(shifts[12 * i + 3 * k + l], 0);
            if (neighbor < 0) {
                CHECK(dimensions < 3);
                continue;
            }
            for (l = 0; l < 4; ++l)
                for (m = 0; m < 4; ++m) {
                    const int64_t *const a = shifts + 12 * i + 3 * l,
                                         *const b = shifts + 12 * neighbor + 3 * m,
                                         *const by = neighbor_shifts + 12 * i + 3 * k;
                    shared += l != k && tetrahedra[4 * i + l] == tetrahedra[4 * neighbor + m] &&
                              a[0] == b[0] + by[0] && a[1] == b[1] + by[1] && a[2] == b[2] + by[2];
                }
            CHECK_EQUAL(shared, 3);
        }
        for (k = 0; k < 3; ++k) CHECK_EQUAL(shifts[12 * i + k], 0);
        CHECK(six_volumes(x) > 0);
        volume += six_volumes(x) / 6;
    }
    if (dimensions == 3) CHECK(volume > 30 - 1e-11 && volume < 30 + 1e-11);
    /* Every edge of a tetrahedron is in the lists of its ends, and every entry has its opposite. */
    CHECK_EQUAL(starts[0], base);
    CHECK_EQUAL(starts[n] - base, size_of(p, MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS));
    CHECK_EQUAL(starts[n] - base, 2 * stat_of(p, MGDT_PERIODIC_STAT_EDGES));
    for (i = 0; i < n; ++i)
        for (k = starts[i] - base; k < starts[i + 1] - base; ++k) {
            const int64_t other = list[k] - base;
            int64_t found = 0;
            for (l = starts[other] - base; l < starts[other + 1] - base; ++l)
                found += list[l] == i + base && list_shifts[3 * l] == -list_shifts[3 * k] &&
                         list_shifts[3 * l + 1] == -list_shifts[3 * k + 1] &&
                         list_shifts[3 * l + 2] == -list_shifts[3 * k + 2];
            CHECK_EQUAL(found, 1);
            ++edges;
        }
    if (dimensions == 3) CHECK_EQUAL(edges / 2, n + count);
    free(map);
    free(point_shifts);
    free(tetrahedra);
    free(shifts);
    free(neighbors);
    free(neighbor_shifts);
    free(starts);
    free(list);
    free(list_shifts);
    free(points);
    free(vectors);
    mgdt_periodic_destroy(p);
}

/* One point of a face-centred lattice, whose cell has twelve faces, all shared with itself. */
static void cells(void) {
    const double vectors[9] = {0, 1, 1, 1, 0, 1, 1, 1, 0}, at[3] = {10.25, -3, 0.5};
    mgdt_periodic* p = NULL;
    mgdt_voronoi* v = NULL;
    double measure[3], normals[36], distances[12], areas[12];
    int64_t images[36], sides[24], faces[12], neighbors[12], of_cells[36], size = 0, i;
    CHECK_EQUAL(new_box(3, vectors, &p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, 1, at), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_VOLUME, 1, measure), MGDT_OK);
    CHECK(measure[0] > 2 - 1e-12 && measure[0] < 2 + 1e-12);
    CHECK_EQUAL(mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_FACES, 1, measure), MGDT_OK);
    CHECK(measure[0] == 12);
    CHECK_EQUAL(mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_CENTROID, 3, measure), MGDT_OK);
    for (i = 0; i < 3; ++i) CHECK(measure[i] > -1e-12 && measure[i] < 1e-12);
    CHECK_EQUAL(mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_CENTROID, 2, measure),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_periodic_get_cell_measures(p, 11, 3, measure), MGDT_ERR_UNKNOWN_KEY);
    CHECK_EQUAL(mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_AREA, 1, NULL),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_periodic_create_voronoi(p, &v), MGDT_OK);
    mgdt_periodic_destroy(p); /* the diagram stays */
    CHECK_EQUAL(mgdt_voronoi_get_size(v, MGDT_VORONOI_ARRAY_FACE_SHIFTS, &size), MGDT_OK);
    CHECK_EQUAL(size, 36);
    CHECK_EQUAL(mgdt_voronoi_get_array(v, MGDT_VORONOI_ARRAY_FACE_SHIFTS, 36, images), MGDT_OK);
    CHECK_EQUAL(mgdt_voronoi_get_array(v, MGDT_VORONOI_ARRAY_FACE_SIDES, 24, sides), MGDT_OK);
    CHECK_EQUAL(mgdt_voronoi_get_array(v, MGDT_VORONOI_ARRAY_CELL_FACES, 12, faces), MGDT_OK);
    CHECK_EQUAL(mgdt_voronoi_get_doubles(v, MGDT_VORONOI_ARRAY_FACE_NORMALS, 36, normals), MGDT_OK);
    CHECK_EQUAL(mgdt_voronoi_get_array(v, MGDT_VORONOI_ARRAY_CELL_NEIGHBORS, 12, neighbors),
                MGDT_OK);
    CHECK_EQUAL(mgdt_voronoi_get_array(v, MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_SHIFTS, 36, of_cells),
                MGDT_OK);
    CHECK_EQUAL(
        mgdt_voronoi_get_doubles(v, MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES, 12, distances),
        MGDT_OK);
    for (i = 0; i < 12; ++i) {
        double way[3], product = 0, square = 0;
        int64_t c, k;
        CHECK_EQUAL(sides[2 * i], 0);
        CHECK_EQUAL(sides[2 * i + 1], 0);
        CHECK_EQUAL(faces[i], i);
        CHECK_EQUAL(neighbors[i], 0);
        CHECK(distances[i] > 1.4142135 && distances[i] < 1.4142136);
        for (c = 0; c < 3; ++c) CHECK_EQUAL(of_cells[3 * i + c], images[3 * i + c]);
        for (c = 0; c < 3; ++c) {
            way[c] = 0;
            for (k = 0; k < 3; ++k) way[c] += (double)images[3 * i + k] * vectors[3 * k + c];
            product += way[c] * normals[3 * i + c];
            square += way[c] * way[c];
        }
        CHECK(square == 2);
        CHECK(product * product > 2 - 1e-12 && product > 0);
    }
    /* A face and its image go together. */
    CHECK_EQUAL(mgdt_voronoi_drop_small_faces(v, 0.1, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_voronoi_get_doubles(v, MGDT_VORONOI_ARRAY_FACE_AREAS, 12, areas), MGDT_OK);
    CHECK_EQUAL(mgdt_voronoi_drop_small_faces(v, 2 * areas[0], 0), MGDT_OK);
    CHECK_EQUAL(mgdt_voronoi_get_size(v, MGDT_VORONOI_ARRAY_FACE_SHIFTS, &size), MGDT_OK);
    CHECK_EQUAL(size, 0);
    mgdt_voronoi_destroy(v);
    /* The diagram of a triangulation has no images. */
    {
        double* const xyz = random_points(20, 0, 1);
        mgdt_triangulation* const t = make(20, xyz);
        CHECK_EQUAL(mgdt_voronoi_create(t, 0, NULL, &v), MGDT_OK);
        CHECK_EQUAL(mgdt_voronoi_get_size(v, MGDT_VORONOI_ARRAY_FACE_SHIFTS, &size), MGDT_OK);
        CHECK_EQUAL(size, 0);
        CHECK_EQUAL(mgdt_voronoi_get_array(v, MGDT_VORONOI_ARRAY_FACE_SHIFTS, 0, NULL), MGDT_OK);
        mgdt_voronoi_destroy(v);
        mgdt_destroy(t);
        free(xyz);
    }
}

/* A hexagonal close packing, whose height is irrational: 12 faces, once the tiny ones that rounding
 * leaves are dropped. */
static void close_packing(void) {
    const double height = 1.632993161855452, half = 0.8660254037844386;
    const double vectors[9] = {1, 0, 0, -0.5, 0.8660254037844386, 0, 0, 0, 1.632993161855452};
    double points[6], volumes[2];
    mgdt_periodic* p = NULL;
    mgdt_voronoi* v = NULL;
    int64_t starts[3] = {0}, size = 0;
    points[0] = points[1] = points[2] = 0;
    points[3] = 0.5;
    points[4] = half / 3;
    points[5] = height / 2;
    CHECK_EQUAL(new_box(3, vectors, &p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, 2, points), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_VOLUME, 2, volumes), MGDT_OK);
    CHECK(volumes[0] > 0.7071067811865 && volumes[0] < 0.7071067811866);
    CHECK(volumes[1] > 0.7071067811865 && volumes[1] < 0.7071067811866);
    CHECK_EQUAL(mgdt_periodic_create_voronoi(p, &v), MGDT_OK);
    CHECK_EQUAL(mgdt_voronoi_drop_small_faces(v, 1e-9, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_voronoi_get_size(v, MGDT_VORONOI_ARRAY_CELL_OFFSETS, &size), MGDT_OK);
    CHECK_EQUAL(size, 3);
    CHECK_EQUAL(mgdt_voronoi_get_array(v, MGDT_VORONOI_ARRAY_CELL_OFFSETS, 3, starts), MGDT_OK);
    CHECK_EQUAL(starts[1] - starts[0], 12);
    CHECK_EQUAL(starts[2] - starts[1], 12);
    mgdt_voronoi_destroy(v);
    mgdt_periodic_destroy(p);
}

/* Equal images are one vertex; moved points are where they are. */
static void equal_and_moved_points(void) {
    const double xyz[9] = {0.25, 0.5, 0.75, 3.25, -1.5, 0.75, 0.5, 0.5, 0.125};
    const int64_t second = 2, bad = 4;
    double nan = 0, x[9];
    mgdt_periodic* p = NULL;
    int64_t *map, *shifts;
    CHECK_EQUAL(new_box(3, cube, &p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_set_option(p, MGDT_PERIODIC_OPTION_INDEX_BASE, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_insert_points(p, 3, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
    CHECK_EQUAL(stat_of(p, MGDT_PERIODIC_STAT_VERTICES), 2);
    map = integers(p, MGDT_PERIODIC_ARRAY_POINT_MAP);
    shifts = integers(p, MGDT_PERIODIC_ARRAY_POINT_SHIFTS);
    CHECK(map[0] == 1 && map[1] == 1 && map[2] == 3);
    CHECK(shifts[3] == 3 && shifts[4] == -2 && shifts[5] == 0);
    free(map);
    free(shifts);
    CHECK_EQUAL(mgdt_periodic_move_points(p, 1, &bad, xyz), MGDT_ERR_INVALID_ARGUMENT);
    CHECK(says(p, "there is no point 4; there are 3"));
    nan /= nan;
    CHECK_EQUAL(mgdt_periodic_move_points(p, 1, &second, &nan), MGDT_ERR_NOT_FINITE);
    CHECK(says(p, "point 2"));
    CHECK_EQUAL(mgdt_periodic_move_points(p, 2, NULL, xyz), MGDT_ERR_INVALID_ARGUMENT);
    CHECK(says(p, "2 places are given for all points, which are 3"));
    CHECK_EQUAL(mgdt_periodic_check(p), MGDT_OK); /* nothing has changed */
    CHECK_EQUAL(mgdt_periodic_move_points(p, 1, &second, xyz + 3), MGDT_OK);
    no_results(p);
    CHECK_EQUAL(mgdt_periodic_move_points(p, 1, &second, xyz + 6), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
    map = integers(p, MGDT_PERIODIC_ARRAY_POINT_MAP);
    CHECK(map[0] == 1 && map[1] == 2 && map[2] == 2);
    free(map);
    CHECK_EQUAL(mgdt_periodic_move_points(p, 3, NULL, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
    CHECK_EQUAL(mgdt_periodic_get_doubles(p, MGDT_PERIODIC_ARRAY_POINTS, 9, x), MGDT_OK);
    CHECK(memcmp(x, xyz, sizeof x) == 0);
    mgdt_periodic_destroy(p);
}

/* A box that changes at every step, and keeps its points: the result is that of a new one. */
static void other_vectors(void) {
    double vectors[9] = {4, 0, 0, 1.5, 3, 0, -0.75, 0.5, 2.5};
    mgdt_periodic *const p = make_periodic(3, vectors, 100), *fresh = NULL;
    double* const at = malloc(300 * sizeof *at);
    int step;
    CHECK_EQUAL(mgdt_periodic_get_doubles(p, MGDT_PERIODIC_ARRAY_POINTS, 300, at), MGDT_OK);
    for (step = 0; step < 6; ++step) {
        const int32_t dimensions = step == 4 ? 2 : 3;
        int32_t key;
        int64_t k;
        /* Small steps, then a basis of the same lattice that is longer, and fewer vectors. */
        for (k = 0; k < 3; ++k) {
            if (step < 3) vectors[4 * k] *= 1.01;
            if (step == 3) vectors[6 + k] += 3 * vectors[k] - 2 * vectors[3 + k];
        }
        CHECK_EQUAL(mgdt_periodic_set_vectors(p, dimensions, vectors), MGDT_OK);
        CHECK_EQUAL(stat_of(p, MGDT_PERIODIC_STAT_TETRAHEDRA), 0);
        CHECK_EQUAL(mgdt_periodic_get_size(p, MGDT_PERIODIC_ARRAY_TETRAHEDRA, &k),
                    MGDT_ERR_NOT_BUILT);
        CHECK_EQUAL(mgdt_periodic_build(p), MGDT_OK);
        CHECK_EQUAL(mgdt_periodic_check(p), MGDT_OK);
        CHECK_EQUAL(stat_of(p, MGDT_PERIODIC_STAT_DIMENSIONS), dimensions);
        CHECK_EQUAL(new_box(dimensions, vectors, &fresh), MGDT_OK);
        CHECK_EQUAL(mgdt_periodic_insert_points(fresh, 100, at), MGDT_OK);
        CHECK_EQUAL(mgdt_periodic_build(fresh), MGDT_OK);
        for (key = MGDT_PERIODIC_ARRAY_POINT_MAP; key <= MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_SHIFTS;
             ++key) {
            int64_t n = 0, *ours, *theirs;
            if (mgdt_periodic_get_size(fresh, key, &n) != MGDT_OK) continue;
            ours = integers(p, key);
            theirs = integers(fresh, key);
            CHECK_EQUAL(size_of(p, key), n);
            CHECK(memcmp(ours, theirs, (size_t)n * sizeof *ours) == 0);
            free(ours);
            free(theirs);
        }
        mgdt_periodic_destroy(fresh);
    }
    free(at);
    mgdt_periodic_destroy(p);
}

void test_periodic(void) {
    int32_t dimensions;
    for (dimensions = 1; dimensions <= 3; ++dimensions) {
        arrays_agree(dimensions, 0);
        arrays_agree(dimensions, 1);
    }
    cells();
    close_packing();
    equal_and_moved_points();
    other_vectors();
}
