/* SPDX-License-Identifier: MIT
 * A program as it was compiled for version 1.3: what the client of 1.0 does, compiled with the
 * headers of 1.3, and what 1.3 added. Frozen like the headers. */
#include "mgdt-1.3.h"

/* The header of 1.0, which this includes, has the same guard and is left out. */
#define main client_of_1_0
int client_of_1_0(void);
#include "client-1.0.c"
#undef main

#define NEAR(a, b) (fabs((a) - (b)) <= 1e-12)

/* The corners of a cube of length 2, and its centre. */
static const double cube[27] = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1,
                                1,  1,  -1, 1, -1, 1,  1,  1, 1,  1, 0, 0,  0};
/* The planes of the cube. */
static const double planes[24] = {1, 0,  0, 1, -1, 0, 0, 1, 0, 1, 0,  1,
                                  0, -1, 0, 1, 0,  0, 1, 1, 0, 0, -1, 1};
/* The squares of the cube, whose corners turn counter-clockwise seen from outside. */
static const int64_t offsets[7] = {0, 4, 8, 12, 16, 20, 24};
static const int64_t squares[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                    2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
static const int32_t markers[6] = {1, 2, 3, 4, 5, 6};
static const int64_t diagonal[2] = {0, 7};

static mgdt_progress_fn fn;
static void* user;
static char message[256];
static int64_t number, size, many[512];
static int32_t few[512], columns, is_double;
static double real[512];

static mgdt_triangulation* of_points(int64_t n, const double* xyz) {
    mgdt_triangulation* t = NULL;
    CHECK(mgdt_create(&t) == MGDT_OK);
    CHECK(mgdt_set_canonical_output(t, 1) == MGDT_OK);
    CHECK(mgdt_insert_points(t, n, xyz) == MGDT_OK);
    return t;
}

static int32_t no_progress(double fraction, void* data) {
    (void)fraction, (void)data;
    return 0;
}

static void of_triangulations(void) {
    mgdt_triangulation* t = of_points(9, cube);
    mgdt_parts* p = NULL;
    double fraction = -1;
    int32_t on = -1, count = -1;
    CHECK(MGDT_VERSION_AT_LEAST(1, 3) && !MGDT_VERSION_AT_LEAST(1, 4));
    CHECK(mgdt_set_progress(t, hear, &fraction) == MGDT_OK);
    CHECK(mgdt_check(t, MGDT_CHECK_CANONICAL) == MGDT_OK && fraction == -1);
    CHECK(mgdt_set_read_progress(t, 1) == MGDT_OK);
    CHECK(mgdt_get_read_progress(t, &on) == MGDT_OK && on == 1);
    CHECK(mgdt_check(t, MGDT_CHECK_CANONICAL) == MGDT_OK && fraction == 1);
    CHECK(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_VOLUME, 12, real) == MGDT_OK);
    CHECK(NEAR(real[0], 8.0 / 12) && NEAR(real[11], 8.0 / 12));
    CHECK(mgdt_get_tetrahedron_measures(t, 41, 12, real) == MGDT_ERR_UNKNOWN_KEY);
    CHECK(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_LONGEST_EDGE, 12, real) == MGDT_OK);
    CHECK(NEAR(real[0], sqrt(8)));
    CHECK(mgdt_traverse_segment(t, cube, cube + 21, 512, many, real, &number) == MGDT_OK);
    CHECK(number == 2 && real[0] == 0 && real[1] == 0.5 && real[2] == 1);
    CHECK(mgdt_traverse_segment_i32(t, cube, cube + 21, 1, few, real, &count) ==
          MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK(count == 2);
    mgdt_destroy(t);

    CHECK(mgdt_parts_create(2, &p) == MGDT_OK);
    CHECK(mgdt_parts_set_progress(p, hear, &fraction) == MGDT_OK);
    CHECK(mgdt_parts_get_progress(p, &fn, &user) == MGDT_OK && fn == hear && user == &fraction);
    CHECK(mgdt_parts_set_option(p, MGDT_PARTS_READ_PROGRESS, 1) == MGDT_OK);
    CHECK(mgdt_parts_array_info(MGDT_PARTS_CORNERS, &columns, &is_double) == MGDT_OK);
    CHECK(columns == 4 && is_double == 0);
    mgdt_parts_destroy(p);
}

static void diagrams(void) {
    mgdt_triangulation* t = of_points(9, cube);
    mgdt_voronoi* v = NULL;
    CHECK(mgdt_voronoi_create(t, 6, planes, &v) == MGDT_OK && v != NULL);
    mgdt_destroy(t);
    CHECK(mgdt_voronoi_get_stat(v, MGDT_VORONOI_STAT_POINTS, &number) == MGDT_OK && number == 9);
    CHECK(mgdt_voronoi_get_stat(v, MGDT_VORONOI_STAT_FACES, &number) == MGDT_OK);
    CHECK(mgdt_voronoi_array_info(MGDT_VORONOI_ARRAY_FACE_SIDES, &columns, &is_double) == MGDT_OK);
    CHECK(columns == 2 && is_double == 0);
    CHECK(mgdt_voronoi_get_size(v, MGDT_VORONOI_ARRAY_FACE_SIDES, &size) == MGDT_OK);
    CHECK(size == 2 * number && size <= 512);
    CHECK(mgdt_voronoi_get_array(v, MGDT_VORONOI_ARRAY_FACE_SIDES, 512, many) == MGDT_OK);
    CHECK(mgdt_voronoi_get_array_i32(v, MGDT_VORONOI_ARRAY_FACE_SIDES, 512, few) == MGDT_OK);
    CHECK(many[0] == few[0] && many[1] == few[1]);
    CHECK(mgdt_voronoi_get_array(v, MGDT_VORONOI_ARRAY_CELL_BOUNDED, 512, many) == MGDT_OK);
    CHECK(many[0] == 1 && many[8] == 1);
    CHECK(mgdt_voronoi_get_doubles(v, MGDT_VORONOI_ARRAY_CELL_VOLUMES, 512, real) == MGDT_OK);
    CHECK(NEAR(8 * real[0] + real[8], 8));
    CHECK(mgdt_voronoi_get_doubles(v, MGDT_VORONOI_ARRAY_FACE_SIDES, 512, real) ==
          MGDT_ERR_UNKNOWN_KEY);
    CHECK(mgdt_voronoi_get_error(v, 256, message) == MGDT_OK && message[0] != '\0');
    CHECK(mgdt_voronoi_drop_small_faces(v, 1e9, 0) == MGDT_OK);
    CHECK(mgdt_voronoi_get_stat(v, MGDT_VORONOI_STAT_FACES, &number) == MGDT_OK && number == 0);
    mgdt_voronoi_destroy(v);
}

static void options_of_domain(mgdt_domain* d) {
    int32_t key;
    for (key = MGDT_DOMAIN_OPTION_INDEX_BASE; key <= MGDT_DOMAIN_OPTION_STRICT; key += 10) {
        CHECK(mgdt_domain_set_option(d, key, 1) == MGDT_OK);
        CHECK(mgdt_domain_get_option(d, key, &number) == MGDT_OK && number == 1);
        CHECK(mgdt_domain_set_option(d, key, 0) == MGDT_OK);
    }
    CHECK(mgdt_domain_set_option(d, MGDT_DOMAIN_STAT_POINTS, 1) == MGDT_ERR_UNKNOWN_KEY);
    CHECK(mgdt_domain_set_progress(d, no_progress, real) == MGDT_OK);
    CHECK(mgdt_domain_get_progress(d, &fn, &user) == MGDT_OK && fn == no_progress && user == real);
}

static void arrays_of_mesh(mgdt_mesh* m) {
    int64_t k;
    CHECK(mgdt_mesh_get_stat(m, MGDT_MESH_STAT_TETRAHEDRA, &number) == MGDT_OK && number == 12);
    CHECK(mgdt_mesh_get_stat(m, MGDT_MESH_STAT_STEINER_POINTS, &number) == MGDT_OK && number == 0);
    CHECK(mgdt_mesh_get_stat(m, MGDT_MESH_STAT_REGIONS, &number) == MGDT_OK && number == 1);
    CHECK(mgdt_mesh_array_info(MGDT_MESH_ARRAY_FACES, &columns, &is_double) == MGDT_OK);
    CHECK(columns == 3 && is_double == 0);
    CHECK(mgdt_mesh_array_info(MGDT_MESH_ARRAY_POINTS, &columns, &is_double) == MGDT_OK);
    CHECK(columns == 3 && is_double == 1);
    CHECK(mgdt_mesh_get_size(m, MGDT_MESH_ARRAY_TETRAHEDRA, &size) == MGDT_OK && size == 48);
    CHECK(mgdt_mesh_get_array(m, MGDT_MESH_ARRAY_TETRAHEDRA, 48, many) == MGDT_OK);
    CHECK(mgdt_mesh_get_array_i32(m, MGDT_MESH_ARRAY_TETRAHEDRA, 48, few) == MGDT_OK);
    for (k = 0; k < 48; ++k) CHECK(many[k] == few[k] && few[k] >= 1 && few[k] <= 9);
    CHECK(mgdt_mesh_get_array(m, MGDT_MESH_ARRAY_NEIGHBORS, 48, many) == MGDT_OK);
    for (k = 0; k < 48; ++k) CHECK(many[k] >= 0 && many[k] <= 12);
    CHECK(mgdt_mesh_get_array(m, MGDT_MESH_ARRAY_REGION_MARKERS, 1, many) == MGDT_OK);
    CHECK(many[0] == 77);
    CHECK(mgdt_mesh_get_size(m, MGDT_MESH_ARRAY_FACE_MARKERS, &size) == MGDT_OK && size == 12);
    CHECK(mgdt_mesh_get_array(m, MGDT_MESH_ARRAY_FACE_MARKERS, 12, many) == MGDT_OK);
    for (number = k = 0; k < 12; ++k) number += many[k];
    CHECK(number == 42);
    CHECK(mgdt_mesh_get_array(m, MGDT_MESH_ARRAY_EDGE_MARKERS, 512, many) == MGDT_OK);
    CHECK(mgdt_mesh_get_doubles(m, MGDT_MESH_ARRAY_POINTS, 27, real) == MGDT_OK);
    CHECK(memcmp(real, cube, sizeof cube) == 0);
    CHECK(mgdt_mesh_get_tetrahedron_measures(m, MGDT_TETRAHEDRON_VOLUME, 12, real) == MGDT_OK);
    CHECK(NEAR(real[0], 8.0 / 12) && NEAR(real[11], 8.0 / 12));
}

static void options_of_mesh(mgdt_mesh* m) {
    double fraction = -1;
    CHECK(mgdt_mesh_get_option(m, MGDT_MESH_OPTION_INDEX_BASE, &number) == MGDT_OK && number == 1);
    CHECK(mgdt_mesh_set_option(m, MGDT_MESH_OPTION_THREADS, 2) == MGDT_OK);
    CHECK(mgdt_mesh_get_option(m, MGDT_MESH_OPTION_THREADS, &number) == MGDT_OK && number == 2);
    CHECK(mgdt_mesh_set_progress(m, hear, &fraction) == MGDT_OK);
    CHECK(mgdt_mesh_get_progress(m, &fn, &user) == MGDT_OK && fn == hear && user == &fraction);
    CHECK(mgdt_mesh_check(m) == MGDT_OK && fraction == 1);
    CHECK(mgdt_mesh_cancel(m) == MGDT_OK);
    CHECK(mgdt_mesh_check(m) == MGDT_ERR_CANCELLED);
    CHECK(mgdt_mesh_get_error(m, 256, message) == MGDT_OK && message[0] != '\0');
    CHECK(mgdt_mesh_set_progress(m, NULL, NULL) == MGDT_OK);
}

static void domains_and_meshes(void) {
    static const double centre[3] = {0.1, 0.2, 0.3}, outside[3] = {9, 9, 9};
    static const int32_t region[1] = {77}, of_segment[1] = {5};
    int32_t offsets_i32[7], corners_i32[24], ends_i32[2] = {1, 8}, i;
    int64_t corners[24], offsets_1[7], ends[2];
    mgdt_domain* d = NULL;
    mgdt_mesh* m = NULL;
    for (i = 0; i < 7; ++i) offsets_1[i] = 1 + (offsets_i32[i] = (int32_t)offsets[i]);
    for (i = 0; i < 24; ++i) corners[i] = 1 + (corners_i32[i] = (int32_t)squares[i]);
    for (i = 0; i < 2; ++i) ends[i] = 1 + diagonal[i];
    CHECK(mgdt_domain_create_with_allocator(take, give, &live_bytes, &d) == MGDT_OK);
    mgdt_domain_destroy(d);
    CHECK(live_bytes == 0);
    CHECK(mgdt_domain_create(&d) == MGDT_OK);
    options_of_domain(d);
    CHECK(mgdt_domain_set_points(d, 9, cube) == MGDT_OK);
    CHECK(mgdt_domain_set_facets_i32(d, 6, offsets_i32, corners_i32, markers) == MGDT_OK);
    CHECK(mgdt_domain_set_facets(d, 5, offsets, squares, NULL) == MGDT_OK);
    CHECK(mgdt_domain_build(d, &m) == MGDT_ERR_OPEN_BOUNDARY && m == NULL);
    CHECK(mgdt_domain_get_error(d, 256, message) == MGDT_OK && message[0] != '\0');
    CHECK(mgdt_domain_array_info(MGDT_DOMAIN_ARRAY_OPEN_EDGES, &columns, NULL) == MGDT_OK);
    CHECK(mgdt_domain_get_size(d, MGDT_DOMAIN_ARRAY_OPEN_EDGES, &size) == MGDT_OK);
    CHECK(columns == 3 && size == 12);
    CHECK(mgdt_domain_get_array(d, MGDT_DOMAIN_ARRAY_OPEN_EDGES, 12, many) == MGDT_OK);
    CHECK(mgdt_domain_get_array_i32(d, MGDT_DOMAIN_ARRAY_OPEN_EDGES, 12, few) == MGDT_OK);
    CHECK(many[0] == few[0] && many[11] == few[11]);

    CHECK(mgdt_domain_set_option(d, MGDT_DOMAIN_OPTION_INDEX_BASE, 1) == MGDT_OK);
    CHECK(mgdt_domain_set_facets(d, 6, offsets_1, corners, markers) == MGDT_OK);
    CHECK(mgdt_domain_set_segments(d, 1, ends, of_segment) == MGDT_OK);
    CHECK(mgdt_domain_validate(d) == MGDT_ERR_INVALID_BOUNDARY); /* it meets the ninth point */
    CHECK(mgdt_domain_get_stat(d, MGDT_DOMAIN_STAT_OFFENDING_PAIRS, &number) == MGDT_OK);
    CHECK(number == 1);
    CHECK(mgdt_domain_get_array(d, MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS, 4, many) == MGDT_OK);
    CHECK((many[0] == MGDT_DOMAIN_KIND_SEGMENT && many[2] == MGDT_DOMAIN_KIND_POINT) ||
          (many[0] == MGDT_DOMAIN_KIND_POINT && many[2] == MGDT_DOMAIN_KIND_SEGMENT));
    ends_i32[1] = 9;
    CHECK(mgdt_domain_set_segments_i32(d, 1, ends_i32, of_segment) == MGDT_OK);
    CHECK(mgdt_domain_set_regions(d, 1, centre, region) == MGDT_OK);
    CHECK(mgdt_domain_set_holes(d, 1, outside) == MGDT_OK);
    CHECK(mgdt_domain_cancel(d) == MGDT_OK);
    CHECK(mgdt_domain_build(d, &m) == MGDT_ERR_CANCELLED && m == NULL);
    CHECK(mgdt_domain_validate(d) == MGDT_OK);
    CHECK(mgdt_domain_build(d, &m) == MGDT_OK && m != NULL);
    CHECK(mgdt_domain_check(d, m) == MGDT_OK);
    CHECK(mgdt_mesh_get_stat(m, MGDT_MESH_STAT_UNUSED_HOLES, &number) == MGDT_OK && number == 1);
    CHECK(mgdt_domain_clear(d) == MGDT_OK);
    CHECK(mgdt_domain_get_stat(d, MGDT_DOMAIN_STAT_POINTS, &number) == MGDT_OK && number == 0);
    CHECK(mgdt_domain_check(d, m) == MGDT_ERR_CHECK_FAILED);
    mgdt_domain_destroy(d);
    arrays_of_mesh(m);
    options_of_mesh(m);
    mgdt_mesh_destroy(m);
}

static void arrays_of_box(mgdt_periodic* p) {
    int64_t k;
    CHECK(mgdt_periodic_get_stat(p, MGDT_PERIODIC_STAT_TETRAHEDRA, &number) == MGDT_OK);
    CHECK(number == 12);
    CHECK(mgdt_periodic_array_info(MGDT_PERIODIC_ARRAY_TETRAHEDRON_SHIFTS, &columns, &is_double) ==
          MGDT_OK);
    CHECK(columns == 12 && is_double == 0);
    CHECK(mgdt_periodic_get_size(p, MGDT_PERIODIC_ARRAY_TETRAHEDRA, &size) == MGDT_OK);
    CHECK(size == 48);
    CHECK(mgdt_periodic_get_array(p, MGDT_PERIODIC_ARRAY_TETRAHEDRA, 48, many) == MGDT_OK);
    CHECK(mgdt_periodic_get_array_i32(p, MGDT_PERIODIC_ARRAY_TETRAHEDRA, 48, few) == MGDT_OK);
    for (k = 0; k < 48; ++k) CHECK(many[k] == few[k] && few[k] >= 0 && few[k] <= 1);
    CHECK(mgdt_periodic_get_array(p, MGDT_PERIODIC_ARRAY_TETRAHEDRON_SHIFTS, 144, many) == MGDT_OK);
    for (k = 0; k < 12; ++k) CHECK(many[12 * k] == 0 && many[12 * k + 2] == 0);
    CHECK(mgdt_periodic_get_doubles(p, MGDT_PERIODIC_ARRAY_VECTORS, 9, real) == MGDT_OK);
    CHECK(real[0] == 2 && real[1] == 0 && real[8] == 2);
    CHECK(mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_VOLUME, 2, real) == MGDT_OK);
    CHECK(NEAR(real[0], 4) && NEAR(real[1], 4));
}

/* The body-centred lattice, whose cells are truncated octahedra. */
static void boxes(void) {
    static const double vectors[9] = {2, 0, 0, 0, 2, 0, 0, 0, 2}, two[6] = {0, 0, 0, 1, 1, 1};
    static const int64_t second[1] = {1};
    static const int32_t first_i32[1] = {0};
    double distance = -1;
    mgdt_periodic* p = NULL;
    mgdt_voronoi* v = NULL;
    CHECK(mgdt_periodic_create_with_allocator(take, give, &live_bytes, &p) == MGDT_OK);
    mgdt_periodic_destroy(p);
    CHECK(live_bytes == 0);
    CHECK(mgdt_periodic_create(&p) == MGDT_OK);
    CHECK(mgdt_periodic_set_vectors(p, 3, vectors) == MGDT_OK);
    CHECK(mgdt_periodic_set_option(p, MGDT_PERIODIC_OPTION_THREADS, 2) == MGDT_OK);
    CHECK(mgdt_periodic_get_option(p, MGDT_PERIODIC_OPTION_THREADS, &number) == MGDT_OK);
    CHECK(number == 2);
    CHECK(mgdt_periodic_set_merge_distance(p, 1e-9) == MGDT_OK);
    CHECK(mgdt_periodic_get_merge_distance(p, &distance) == MGDT_OK && distance == 1e-9);
    CHECK(mgdt_periodic_set_progress(p, no_progress, real) == MGDT_OK);
    CHECK(mgdt_periodic_get_progress(p, &fn, &user) == MGDT_OK && fn == no_progress);
    CHECK(mgdt_periodic_insert_points(p, 2, two) == MGDT_OK);
    CHECK(mgdt_periodic_get_size(p, MGDT_PERIODIC_ARRAY_TETRAHEDRA, &size) == MGDT_ERR_NOT_BUILT);
    CHECK(mgdt_periodic_get_error(p, 256, message) == MGDT_OK && message[0] != '\0');
    CHECK(mgdt_periodic_build(p) == MGDT_OK);
    CHECK(mgdt_periodic_check(p) == MGDT_OK);
    arrays_of_box(p);
    CHECK(mgdt_periodic_create_voronoi(p, &v) == MGDT_OK && v != NULL);
    CHECK(mgdt_voronoi_get_doubles(v, MGDT_VORONOI_ARRAY_CELL_VOLUMES, 2, real) == MGDT_OK);
    CHECK(NEAR(real[0], 4));
    mgdt_voronoi_destroy(v);
    CHECK(mgdt_periodic_move_points(p, 1, second, two) == MGDT_OK);
    CHECK(mgdt_periodic_move_points_i32(p, 1, first_i32, two + 3) == MGDT_OK);
    CHECK(mgdt_periodic_cancel(p) == MGDT_OK);
    CHECK(mgdt_periodic_build(p) == MGDT_ERR_CANCELLED);
    CHECK(mgdt_periodic_build(p) == MGDT_OK && mgdt_periodic_check(p) == MGDT_OK);
    CHECK(mgdt_periodic_clear(p) == MGDT_OK);
    CHECK(mgdt_periodic_get_stat(p, MGDT_PERIODIC_STAT_POINTS, &number) == MGDT_OK && number == 0);
    mgdt_periodic_destroy(p);
}

int main(void) {
    of_triangulations();
    diagrams();
    domains_and_meshes();
    boxes();
    return client_of_1_0();
}
