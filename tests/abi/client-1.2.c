/* SPDX-License-Identifier: MIT
 * A program as it was compiled for version 1.2: what the client of 1.0 does, compiled with the
 * header of 1.2, and what 1.1 and 1.2 added. Frozen like the header. */
#include "mgdt-1.2.h"

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

static mgdt_triangulation* of_points(int64_t n, const double* xyz) {
    mgdt_triangulation* t = NULL;
    CHECK(mgdt_create(&t) == MGDT_OK);
    CHECK(mgdt_set_canonical_output(t, 1) == MGDT_OK);
    CHECK(mgdt_insert_points(t, n, xyz) == MGDT_OK);
    return t;
}

static int32_t no_progress(double fraction, void* user) {
    (void)fraction, (void)user;
    return 0;
}

static void settings_as_set(void) {
    mgdt_triangulation* t = of_points(6, six);
    mgdt_progress_fn fn = NULL;
    void* user = NULL;
    int32_t value = -1;
    uint64_t seed = 0;
    int64_t bytes = -1;
    double parameter = -1;
    CHECK(MGDT_VERSION_AT_LEAST(1, 2) && !MGDT_VERSION_AT_LEAST(1, 3));
    CHECK(mgdt_set_compact(t, 1) == MGDT_OK);
    CHECK(mgdt_get_compact(t, &value) == MGDT_OK && value == 1);
    CHECK(mgdt_shrink(t) == MGDT_OK);
    CHECK(mgdt_set_order_scheme(t, MGDT_ORDER_BRIO) == MGDT_OK);
    CHECK(mgdt_get_order_scheme(t, &value) == MGDT_OK && value == MGDT_ORDER_BRIO);
    CHECK(mgdt_set_order_parameter(t, MGDT_PARAMETER_ROUND_RATIO, 3) == MGDT_OK);
    CHECK(mgdt_get_order_parameter(t, MGDT_PARAMETER_ROUND_RATIO, &parameter) == MGDT_OK);
    CHECK(NEAR(parameter, 3));
    CHECK(mgdt_set_seed(t, 17) == MGDT_OK);
    CHECK(mgdt_get_seed(t, &seed) == MGDT_OK && seed == 17);
    CHECK(mgdt_set_threads(t, 2) == MGDT_OK);
    CHECK(mgdt_get_threads(t, &value) == MGDT_OK && value == 2);
    CHECK(mgdt_set_index_base(t, 1) == MGDT_OK);
    CHECK(mgdt_get_index_base(t, &value) == MGDT_OK && value == 1);
    CHECK(mgdt_set_memory_limit(t, 1 << 20) == MGDT_OK);
    CHECK(mgdt_get_memory_limit(t, &bytes) == MGDT_OK && bytes == 1 << 20);
    CHECK(mgdt_set_progress(t, no_progress, &value) == MGDT_OK);
    CHECK(mgdt_get_progress(t, &fn, &user) == MGDT_OK && fn == no_progress && user == &value);
    CHECK(mgdt_get_canonical_output(t, &value) == MGDT_OK && value == 1);
    CHECK(mgdt_order_scheme_at(0, &value) == MGDT_OK && value == MGDT_ORDER_AUTO);
    CHECK(mgdt_order_scheme_at(1000, &value) == MGDT_ERR_UNKNOWN_SCHEME);
    CHECK(mgdt_get_order_scheme(NULL, &value) == MGDT_ERR_NULL_POINTER);
    mgdt_destroy(t);
}

static void removal_and_motion(void) {
    mgdt_triangulation* t = of_points(9, cube);
    const int64_t centre[1] = {8};
    const int32_t corner[1] = {0}, second[1] = {1};
    const double farther[3] = {-2, -2, -2};
    int64_t new_index[9];
    int32_t new_index_i32[7];
    double removed = 0;
    CHECK(mgdt_tetrahedron_count(t) == 12);
    CHECK(mgdt_move_points_i32(t, 1, corner, farther) == MGDT_OK);
    CHECK(mgdt_move_points(t, 1, centre, farther) == MGDT_OK);
    CHECK(mgdt_vertex_count(t) == 8);
    CHECK(mgdt_remove_points(t, 1, centre) == MGDT_OK);
    CHECK(mgdt_remove_points(t, 1, centre) == MGDT_ERR_INVALID_ARGUMENT);
    CHECK(mgdt_check(t, MGDT_CHECK_CANONICAL) == MGDT_OK);
    CHECK(mgdt_point_count(t) == 9);
    CHECK(mgdt_renumber_points(t, 9, new_index) == MGDT_OK);
    CHECK(new_index[7] == 7 && new_index[8] == -1 && mgdt_point_count(t) == 8);
    CHECK(mgdt_remove_points_i32(t, 1, second) == MGDT_OK);
    CHECK(mgdt_renumber_points_i32(t, 7, new_index_i32) == MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK(mgdt_get_stat(t, MGDT_STAT_POINTS_REMOVED, &removed) == MGDT_OK && removed == 2);
    CHECK(mgdt_check(t, MGDT_CHECK_CANONICAL) == MGDT_OK);
    mgdt_destroy(t);
}

static void graphs(void) {
    static const int64_t tree[16] = {0, 8, 1, 8, 2, 8, 3, 8, 4, 8, 5, 8, 6, 8, 7, 8};
    mgdt_triangulation* t = of_points(9, cube);
    int64_t offsets[10], list[64], edges[64], count = 0, i;
    int32_t offsets_i32[10], list_i32[64], edges_i32[64], count_i32 = 0;
    CHECK(mgdt_vertex_neighbors_count(t) == 2 * mgdt_edge_count(t));
    CHECK(mgdt_get_vertex_neighbors(t, 10, offsets, 64, list) == MGDT_OK);
    CHECK(mgdt_get_vertex_neighbors_i32(t, 10, offsets_i32, 64, list_i32) == MGDT_OK);
    CHECK(offsets[9] == mgdt_vertex_neighbors_count(t) && offsets[9] - offsets[8] == 8);
    for (i = 0; i < 8; ++i) CHECK(list[offsets[8] + i] == i && list_i32[offsets_i32[8] + i] == i);
    /* Each edge of the cube is a diameter of an empty sphere, and so is each half diagonal. */
    CHECK(mgdt_get_gabriel_edges(t, 64, edges, &count) == MGDT_OK && count == 20);
    CHECK(mgdt_get_gabriel_edges_i32(t, 1, edges_i32, &count_i32) == MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK(count_i32 == 20);
    CHECK(mgdt_get_spanning_tree(t, 64, edges, &count) == MGDT_OK && count == 8);
    CHECK(memcmp(edges, tree, sizeof tree) == 0);
    CHECK(mgdt_get_spanning_tree_i32(t, 64, edges_i32, &count_i32) == MGDT_OK && count_i32 == 8);
    CHECK(edges_i32[1] == 8 && edges_i32[14] == 7);
    mgdt_destroy(t);
}

static void dual(void) {
    mgdt_triangulation* t = of_points(9, cube);
    double centers[36], radius2[12], measures[27], alphas[64], alpha2 = 0, volume = 0;
    int64_t surface[36 * 4], count = 0, i;
    int32_t surface_i32[36 * 4], count_i32 = 0;
    CHECK(mgdt_get_circumcenters(t, 12, centers, radius2) == MGDT_OK);
    /* Each tetrahedron joins the centre to half of a face, whose corners are as far from it. */
    for (i = 0; i < 12; ++i) {
        CHECK(radius2[i] == 2.25);
        CHECK(fabs(centers[3 * i]) + fabs(centers[3 * i + 1]) + fabs(centers[3 * i + 2]) == 1.5);
    }
    CHECK(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 6, planes, 27, measures) == MGDT_OK);
    for (i = 0; i < 9; ++i) volume += measures[i];
    CHECK(NEAR(volume, 8));
    CHECK(mgdt_get_cell_measures(t, MGDT_MEASURE_AREA, 0, NULL, 27, measures) == MGDT_OK);
    CHECK(isinf(measures[0]) && measures[8] > 0 && !isinf(measures[8]));
    CHECK(mgdt_get_cell_measures(t, MGDT_MEASURE_CENTROID, 6, planes, 27, measures) == MGDT_OK);
    CHECK(NEAR(measures[24], 0) && NEAR(measures[25], 0) && NEAR(measures[26], 0));
    CHECK(mgdt_get_cell_measures(t, MGDT_MEASURE_FACES, 0, NULL, 27, measures) == MGDT_OK);
    CHECK(measures[8] == 8);
    CHECK(mgdt_get_alphas(t, 3, 64, alphas) == MGDT_OK && alphas[0] == 2.25);
    CHECK(mgdt_get_alphas(t, 0, 64, alphas) == MGDT_OK && alphas[0] == 0);
    CHECK(mgdt_get_alpha_surface(t, INFINITY, 144, surface, &count) == MGDT_OK && count == 12);
    CHECK(mgdt_get_alpha_surface_i32(t, 1, 144, surface_i32, &count_i32) == MGDT_OK);
    CHECK(count_i32 == 0);
    CHECK(mgdt_get_solid_alpha(t, &alpha2) == MGDT_OK && alpha2 == 2.25);
    mgdt_destroy(t);
}

static void queries_and_values(void) {
    static const double where[6] = {0.9, 0.9, 0.8, -0.9, -0.9, -0.8};
    mgdt_triangulation* t = of_points(9, cube);
    int32_t tetrahedron = -2, vertex = -2, vertices_i32[2];
    int64_t vertices[2], offsets[3], points[32];
    int32_t offsets_i32[3], points_i32[32];
    double values[9], out[2], weights[32], gradients[27];
    int i;
    for (i = 0; i < 9; ++i) values[i] = 2 * cube[3 * i] - cube[3 * i + 1] + cube[3 * i + 2] + 5;
    CHECK(mgdt_locate_i32(t, where, &tetrahedron) == MGDT_OK);
    CHECK(tetrahedron >= 0 && tetrahedron < 12);
    CHECK(mgdt_nearest_vertex_i32(t, where, &vertex) == MGDT_OK && vertex == 7);
    CHECK(mgdt_nearest_vertices(t, 2, where, vertices) == MGDT_OK);
    CHECK(vertices[0] == 7 && vertices[1] == 0);
    CHECK(mgdt_nearest_vertices_i32(t, 2, where, vertices_i32) == MGDT_OK && vertices_i32[1] == 0);
    CHECK(mgdt_interpolate(t, MGDT_INTERPOLATE_SIBSON, MGDT_OUTSIDE_NONE, 1, values, 2, where,
                           out) == MGDT_OK);
    CHECK(NEAR(out[0], 6.7) && NEAR(out[1], 3.3));
    CHECK(mgdt_get_interpolation_weights(t, MGDT_INTERPOLATE_LINEAR, MGDT_OUTSIDE_NEAREST, 2, where,
                                         3, offsets, 32, points, weights) == MGDT_OK);
    CHECK(offsets[0] == 0 && offsets[2] <= 8);
    CHECK(mgdt_get_interpolation_weights_i32(t, MGDT_INTERPOLATE_NEAREST, MGDT_OUTSIDE_BOUNDARY, 2,
                                             where, 3, offsets_i32, 32, points_i32,
                                             weights) == MGDT_OK);
    CHECK(offsets_i32[2] == 2 && points_i32[0] == 7 && weights[0] == 1);
    CHECK(mgdt_get_gradients(t, 1, values, gradients) == MGDT_OK);
    CHECK(NEAR(gradients[0], 2) && NEAR(gradients[1], -1) && NEAR(gradients[26], 1));
    mgdt_destroy(t);
}

/* A process that is alone. */
static int32_t gather(const void* mine, void* all, const int64_t* begin, void* user) {
    (void)user;
    if (begin[1] > 0) memcpy(all, mine, (size_t)begin[1]);
    return 0;
}
static int32_t exchange_numbers(const uint64_t* out, uint64_t* in, void* user) {
    (void)user;
    in[0] = out[0];
    return 0;
}
static int32_t exchange(const void* out, const int64_t* out_begin, void* in,
                        const int64_t* in_begin, void* user) {
    (void)out_begin, (void)user;
    if (in_begin[1] > 0) memcpy(in, out, (size_t)in_begin[1]);
    return 0;
}
static int32_t sum(uint64_t* numbers, int64_t n, void* user) {
    (void)numbers, (void)n, (void)user;
    return 0;
}
static int32_t least(double* numbers, int64_t n, void* user) {
    (void)numbers, (void)n, (void)user;
    return 0;
}
static void forget(void* user) {
    ++*(int*)user;
}

static int32_t count_parts(const mgdt_parts* p, int32_t part, void* user) {
    int64_t own = -1;
    CHECK(mgdt_parts_get_stat(p, part, MGDT_PARTS_OWN_TETRAHEDRA, &own) == MGDT_OK);
    *(int64_t*)user += own;
    return 0;
}

static void parts(void) {
    static const int64_t ids[9] = {10, 11, 12, 13, 14, 15, 16, 17, 18};
    mgdt_parts* p = NULL;
    int64_t value = -1, owned = 0, numbers[64];
    double xyz[27];
    char message[256] = "x";
    int32_t part;
    CHECK(mgdt_parts_create(2, &p) == MGDT_OK);
    CHECK(mgdt_parts_set_option(p, MGDT_PARTS_INDEX_BASE, 1) == MGDT_OK);
    CHECK(mgdt_parts_get_option(p, MGDT_PARTS_INDEX_BASE, &value) == MGDT_OK && value == 1);
    CHECK(mgdt_parts_set_progress(p, no_progress, NULL) == MGDT_OK);
    CHECK(mgdt_parts_insert_points(p, 0, 9, cube, ids) == MGDT_OK);
    CHECK(mgdt_parts_build(p) == MGDT_OK);
    CHECK(mgdt_parts_check(p, MGDT_CHECK_CANONICAL) == MGDT_OK);
    for (part = 0; part < 2; ++part) {
        CHECK(mgdt_parts_get_stat(p, part, MGDT_PARTS_OWN_TETRAHEDRA, &value) == MGDT_OK);
        owned += value;
    }
    CHECK(owned == 12);
    CHECK(mgdt_parts_get_size(p, 0, MGDT_PARTS_POINT_MAP, &value) == MGDT_OK && value == 9);
    CHECK(mgdt_parts_get_array(p, 0, MGDT_PARTS_POINT_MAP, 64, numbers) == MGDT_OK);
    CHECK(numbers[0] >= 1 && numbers[0] <= 9);
    CHECK(mgdt_parts_get_coordinates(p, 0, 27, xyz) == MGDT_OK);
    owned = 0;
    CHECK(mgdt_parts_build_each(p, count_parts, &owned) == MGDT_OK && owned == 12);
    CHECK(mgdt_parts_cancel(p) == MGDT_OK);
    CHECK(mgdt_parts_build(p) == MGDT_ERR_CANCELLED);
    CHECK(mgdt_parts_get_error(p, 256, message) == MGDT_OK && message[0] != '\0');
    CHECK(mgdt_parts_clear(p) == MGDT_OK);
    CHECK(mgdt_parts_build(p) == MGDT_OK);
    CHECK(mgdt_parts_get_stat(p, 0, MGDT_PARTS_ALL_VERTICES, &value) == MGDT_OK && value == 0);
    mgdt_parts_destroy(p);

    CHECK(mgdt_parts_create_with_allocator(1, take, give, &live_bytes, &p) == MGDT_OK);
    CHECK(live_bytes > 0);
    mgdt_parts_destroy(p);
    CHECK(live_bytes == 0);
}

static void transport(void) {
    int destroyed = 0;
    int64_t value = -1;
    mgdt_parts* p = NULL;
    mgdt_transport alone;
    memset(&alone, 0, sizeof alone);
    alone.size = sizeof alone;
    alone.processes = 1;
    alone.gather = gather;
    alone.exchange_numbers = exchange_numbers;
    alone.exchange = exchange;
    alone.sum = sum;
    alone.least = least;
    alone.destroy = forget;
    alone.user = &destroyed;
    CHECK(mgdt_parts_create_with_transport(&alone, &p) == MGDT_OK);
    CHECK(mgdt_parts_insert_points(p, MGDT_PARTS_THIS_PART, 9, cube, NULL) == MGDT_OK);
    CHECK(mgdt_parts_build(p) == MGDT_OK);
    CHECK(mgdt_parts_get_stat(p, MGDT_PARTS_THIS_PART, MGDT_PARTS_ALL_TETRAHEDRA, &value) ==
          MGDT_OK);
    CHECK(value == 12 && destroyed == 0);
    mgdt_parts_destroy(p);
    CHECK(destroyed == 1);
}

int main(void) {
    settings_as_set();
    removal_and_motion();
    graphs();
    dual();
    queries_and_values();
    parts();
    transport();
    return client_of_1_0();
}
