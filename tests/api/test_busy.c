/* SPDX-License-Identifier: MIT
 * Calls on a handle that is inside a call, which callbacks make: they get MGDT_ERR_BUSY, change
 * nothing and touch no output. */
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { n = 400, size = 8 };

/* What a callback has to work with. */
typedef struct {
    mgdt_triangulation* t;
    int is_read;  /* inside a call that only reads, where others that read may enter */
    int is_armed; /* an allocator that calls the handle */
    int depth, visits;
    int64_t tetrahedra; /* of the handle, before the call */
    const char* inside; /* the call that the message must name */
    double xyz[3 * n];
} guest;

/* ------------------------------------------------------------------------- what a callback calls
 */

static void change(guest* g) {
    static const double point[12] = {0.5, 0.5, 0.5, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1};
    mgdt_triangulation* const t = g->t;
    int k;
    static const int64_t first = 0;
    static const int32_t narrow = 0;
    int64_t index[n];
    int32_t narrow_index[n];
    for (k = 0; k < 22; ++k) {
        const mgdt_status status =
            k == 0    ? mgdt_insert_points(t, 4, point)
            : k == 1  ? mgdt_insert_points_strided(t, 4, point, point + 1, point + 2, 3)
            : k == 2  ? mgdt_insert_points(t, 0, NULL)
            : k == 3  ? mgdt_clear(t)
            : k == 4  ? mgdt_reserve(t, 100000)
            : k == 5  ? mgdt_set_order_scheme(t, MGDT_ORDER_INPUT)
            : k == 6  ? mgdt_set_order_parameter(t, MGDT_PARAMETER_SEPARATION, 0)
            : k == 7  ? mgdt_set_seed(t, 5)
            : k == 8  ? mgdt_set_threads(t, 3)
            : k == 9  ? mgdt_set_index_base(t, 1)
            : k == 10 ? mgdt_set_memory_limit(t, 1)
            : k == 11 ? mgdt_set_compact(t, 1)
            : k == 12 ? mgdt_set_progress(t, NULL, NULL)
            : k == 13 ? mgdt_remove_points(t, 1, &first)
            : k == 14 ? mgdt_move_points(t, 1, &first, point)
            : k == 15 ? mgdt_renumber_points(t, n, index)
            : k == 16 ? mgdt_remove_points_i32(t, 1, &narrow)
            : k == 17 ? mgdt_move_points_i32(t, 1, &narrow, point)
            : k == 18 ? mgdt_renumber_points_i32(t, n, narrow_index)
            : k == 19 ? mgdt_shrink(t)
            : k == 20 ? mgdt_set_read_progress(t, 1)
                      : mgdt_set_canonical_output(t, 1);
        CHECK_EQUAL(status, MGDT_ERR_BUSY);
        CHECK_ERROR(t, "mgdt_");
        CHECK_ERROR(t, "is refused: the handle is busy in ");
        CHECK_ERROR(t, g->inside);
    }
    CHECK_EQUAL(mgdt_set_isa(t, "baseline"), MGDT_ERR_BUSY);
    CHECK_ERROR(t, "mgdt_set_isa() is refused");
    /* Before its arguments are looked at. */
    CHECK_EQUAL(mgdt_set_threads(t, -1), MGDT_ERR_BUSY);
    CHECK_EQUAL(mgdt_insert_points(t, -1, NULL), MGDT_ERR_BUSY);
    /* Ignored, which the message tells. */
    mgdt_destroy(t);
    CHECK_ERROR(t, "mgdt_destroy() is refused");
    mgdt_destroy(t);
}

static void expect_refused(guest* g, mgdt_status status, const char* name) {
    CHECK_EQUAL(status, MGDT_ERR_BUSY);
    CHECK_ERROR(g->t, name);
    CHECK_ERROR(g->t, g->inside);
}

static void read_while_it_changes(guest* g) {
    const mgdt_triangulation* const t = g->t;
    int64_t a[size], b[size];
    int32_t c[size], d[size];
    double w[4] = {7, 7, 7, 7}, value = 7;
    uint64_t seed = 7;
    mgdt_progress_fn progress = NULL;
    void* user = g;
    int k;
    for (k = 0; k < size; ++k) {
        a[k] = b[k] = -77;
        c[k] = d[k] = -77;
    }
    CHECK_EQUAL(mgdt_point_count(t), 0);
    CHECK_EQUAL(mgdt_vertex_count(t), 0);
    CHECK_EQUAL(mgdt_dimension(t), -1);
    CHECK_EQUAL(mgdt_tetrahedron_count(t), 0);
    CHECK_EQUAL(mgdt_hull_facet_count(t), 0);
    CHECK_EQUAL(mgdt_edge_count(t), 0);
    CHECK_EQUAL(mgdt_vertex_tetrahedra_count(t), 0);
    CHECK_EQUAL(mgdt_vertex_neighbors_count(t), 0);
    CHECK(strcmp(mgdt_isa_name(t), "") == 0);
    expect_refused(g, mgdt_get_tetrahedra(t, size, a), "mgdt_get_tetrahedra()");
    expect_refused(g, mgdt_get_tetrahedra_i32(t, size, c), "mgdt_get_tetrahedra_i32()");
    expect_refused(g, mgdt_get_neighbors(t, size, a), "mgdt_get_neighbors()");
    expect_refused(g, mgdt_get_neighbors_i32(t, size, c), "mgdt_get_neighbors_i32()");
    expect_refused(g, mgdt_get_hull_facets(t, size, a), "mgdt_get_hull_facets()");
    expect_refused(g, mgdt_get_hull_facets_i32(t, size, c), "mgdt_get_hull_facets_i32()");
    expect_refused(g, mgdt_get_edges(t, size, a), "mgdt_get_edges()");
    expect_refused(g, mgdt_get_edges_i32(t, size, c), "mgdt_get_edges_i32()");
    expect_refused(g, mgdt_get_point_map(t, size, a), "mgdt_get_point_map()");
    expect_refused(g, mgdt_get_point_map_i32(t, size, c), "mgdt_get_point_map_i32()");
    expect_refused(g, mgdt_get_vertex_tetrahedra(t, size, a, size, b),
                   "mgdt_get_vertex_tetrahedra()");
    expect_refused(g, mgdt_get_vertex_tetrahedra_i32(t, size, c, size, d),
                   "mgdt_get_vertex_tetrahedra_i32()");
    expect_refused(g, mgdt_get_vertex_neighbors(t, size, a, size, b),
                   "mgdt_get_vertex_neighbors()");
    expect_refused(g, mgdt_get_vertex_neighbors_i32(t, size, c, size, d),
                   "mgdt_get_vertex_neighbors_i32()");
    expect_refused(g, mgdt_get_gabriel_edges(t, size, a, b), "mgdt_get_gabriel_edges()");
    expect_refused(g, mgdt_get_gabriel_edges_i32(t, size, c, d), "mgdt_get_gabriel_edges_i32()");
    expect_refused(g, mgdt_get_spanning_tree(t, size, a, b), "mgdt_get_spanning_tree()");
    expect_refused(g, mgdt_get_spanning_tree_i32(t, size, c, d), "mgdt_get_spanning_tree_i32()");
    expect_refused(g, mgdt_get_circumcenters(t, 1, w, NULL), "mgdt_get_circumcenters()");
    expect_refused(g, mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_VOLUME, 1, w),
                   "mgdt_get_tetrahedron_measures()");
    expect_refused(g, mgdt_get_alphas(t, 3, 1, w), "mgdt_get_alphas()");
    expect_refused(g, mgdt_get_alpha_surface(t, 1, size, a, b), "mgdt_get_alpha_surface()");
    expect_refused(g, mgdt_get_alpha_surface_i32(t, 1, size, c, d), "mgdt_get_alpha_surface_i32()");
    expect_refused(g, mgdt_get_solid_alpha(t, w), "mgdt_get_solid_alpha()");
    expect_refused(g, mgdt_get_cell_measures(t, MGDT_MEASURE_AREA, 0, NULL, 1, w),
                   "mgdt_get_cell_measures()");
    expect_refused(
        g, mgdt_interpolate(t, MGDT_INTERPOLATE_LINEAR, MGDT_OUTSIDE_NONE, 1, w, 1, g->xyz, w),
        "mgdt_interpolate()");
    expect_refused(g,
                   mgdt_get_interpolation_weights(t, MGDT_INTERPOLATE_LINEAR, MGDT_OUTSIDE_NONE, 1,
                                                  g->xyz, 2, a, 1, a, w),
                   "mgdt_get_interpolation_weights()");
    expect_refused(g,
                   mgdt_get_interpolation_weights_i32(t, MGDT_INTERPOLATE_LINEAR, MGDT_OUTSIDE_NONE,
                                                      1, g->xyz, 2, c, 1, c, w),
                   "mgdt_get_interpolation_weights_i32()");
    expect_refused(g, mgdt_get_gradients(t, 1, w, w), "mgdt_get_gradients()");
    expect_refused(g, mgdt_locate(t, g->xyz, a), "mgdt_locate()");
    expect_refused(g, mgdt_locate_i32(t, g->xyz, c), "mgdt_locate_i32()");
    expect_refused(g, mgdt_traverse_segment(t, g->xyz, g->xyz + 3, 1, a, w, b),
                   "mgdt_traverse_segment()");
    expect_refused(g, mgdt_traverse_segment_i32(t, g->xyz, g->xyz + 3, 1, c, w, d),
                   "mgdt_traverse_segment_i32()");
    expect_refused(g, mgdt_locate_points(t, 1, g->xyz, a, w), "mgdt_locate_points()");
    expect_refused(g, mgdt_locate_points_i32(t, 1, g->xyz, c, w), "mgdt_locate_points_i32()");
    expect_refused(g, mgdt_nearest_vertex(t, g->xyz, a), "mgdt_nearest_vertex()");
    expect_refused(g, mgdt_nearest_vertex_i32(t, g->xyz, c), "mgdt_nearest_vertex_i32()");
    expect_refused(g, mgdt_nearest_vertices(t, 1, g->xyz, a), "mgdt_nearest_vertices()");
    expect_refused(g, mgdt_nearest_vertices_i32(t, 1, g->xyz, c), "mgdt_nearest_vertices_i32()");
    expect_refused(g, mgdt_get_order_scheme(t, c), "mgdt_get_order_scheme()");
    expect_refused(g, mgdt_get_order_parameter(t, MGDT_PARAMETER_THRESHOLD, w),
                   "mgdt_get_order_parameter()");
    expect_refused(g, mgdt_get_threads(t, c), "mgdt_get_threads()");
    expect_refused(g, mgdt_get_seed(t, &seed), "mgdt_get_seed()");
    expect_refused(g, mgdt_get_progress(t, &progress, &user), "mgdt_get_progress()");
    expect_refused(g, mgdt_get_index_base(t, c), "mgdt_get_index_base()");
    expect_refused(g, mgdt_get_memory_limit(t, a), "mgdt_get_memory_limit()");
    expect_refused(g, mgdt_get_compact(t, c), "mgdt_get_compact()");
    expect_refused(g, mgdt_get_read_progress(t, c), "mgdt_get_read_progress()");
    expect_refused(g, mgdt_get_canonical_output(t, c), "mgdt_get_canonical_output()");
    expect_refused(g, mgdt_check(t, MGDT_CHECK_COMBINATORIAL), "mgdt_check()");
    expect_refused(g, mgdt_get_stat(t, MGDT_STAT_MEMORY_BYTES, &value), "mgdt_get_stat()");
    for (k = 0; k < size; ++k) CHECK(a[k] == -77 && b[k] == -77 && c[k] == -77 && d[k] == -77);
    for (k = 0; k < 4; ++k) CHECK(w[k] == 7);
    CHECK(value == 7);
    CHECK(seed == 7 && progress == NULL && user == g);
}

/* From within a call that reads, others that read are as good as from another thread. */
static void read_while_it_is_read(guest* g) {
    const mgdt_triangulation* const t = g->t;
    double value = 0;
    int64_t vertex = -1, *map = get_array(mgdt_get_point_map, t, mgdt_point_count(t));
    CHECK_EQUAL(mgdt_point_count(t), n);
    CHECK_EQUAL(mgdt_tetrahedron_count(t), g->tetrahedra);
    CHECK_EQUAL(mgdt_dimension(t), 3);
    CHECK(map != NULL && map[n - 1] == n - 1);
    free(map);
    CHECK_EQUAL(mgdt_nearest_vertex(t, g->xyz + 3 * 17, &vertex), MGDT_OK);
    CHECK_EQUAL(vertex, 17);
    CHECK_EQUAL(mgdt_get_stat(t, MGDT_STAT_POINTS_INSERTED, &value), MGDT_OK);
    CHECK(value == n);
    CHECK(strcmp(mgdt_isa_name(t), "") != 0);
}

static void visit(guest* g) {
    mgdt_triangulation* other = NULL;
    if (g->depth++ == 0) {
        ++g->visits;
        if (g->is_read)
            read_while_it_is_read(g);
        else
            read_while_it_changes(g);
        change(g);
        /* Other handles are independent. */
        other = make(5, g->xyz);
        CHECK_EQUAL(mgdt_check(other, MGDT_CHECK_CANONICAL), MGDT_OK);
        mgdt_destroy(other);
    }
    --g->depth;
}

static int32_t report(double fraction, void* user) {
    (void)fraction;
    visit(user);
    return 0;
}

static void* take(size_t bytes, size_t align, void* user) {
    guest* const g = user;
    char* p;
    if (g->is_armed) visit(g);
    /* Alignments are at most a page. */
    p = malloc(bytes + align + sizeof(void*));
    if (p == NULL) return NULL;
    {
        char* const aligned =
            p + sizeof(void*) + (align - (size_t)((uintptr_t)(p + sizeof(void*)) % align)) % align;
        memcpy(aligned - sizeof(void*), &p, sizeof(void*));
        return aligned;
    }
}

static void give(void* p, size_t bytes, size_t align, void* user) {
    guest* const g = user;
    void* whole;
    (void)bytes;
    (void)align;
    /* The last block is the handle. */
    if (g->is_armed && p != (void*)g->t) visit(g);
    memcpy(&whole, (char*)p - sizeof(void*), sizeof(void*));
    free(whole);
}

/* --------------------------------------------------------------------------------------- the tests
 */

static guest* make_guest(void) {
    guest* const g = calloc(1, sizeof *g);
    double* const xyz = random_points(n, 0, 31);
    if (g == NULL) abort();
    memcpy(g->xyz, xyz, sizeof g->xyz);
    free(xyz);
    return g;
}

/* Nothing of what was refused has had an effect. */
static void expect_unharmed(guest* g, const mgdt_triangulation* expected) {
    double threads = 0, rounds = 0;
    const int was_armed = g->is_armed;
    g->is_armed = 0;
    CHECK_EQUAL(mgdt_check(g->t, MGDT_CHECK_CANONICAL), MGDT_OK);
    CHECK_EQUAL(mgdt_point_count(g->t) % n, 0);
    CHECK(same_tetrahedra(g->t, expected, NULL));
    CHECK_EQUAL(mgdt_get_stat(g->t, MGDT_STAT_THREADS, &threads), MGDT_OK);
    CHECK_EQUAL(mgdt_get_stat(g->t, MGDT_STAT_ROUNDS, &rounds), MGDT_OK);
    CHECK(threads == 1 && rounds > 1);
    g->is_armed = was_armed;
}

static void from_progress(const mgdt_triangulation* expected) {
    guest* const g = make_guest();
    int64_t indices[n];
    int k;
    CHECK_EQUAL(mgdt_create(&g->t), MGDT_OK);
    CHECK_EQUAL(mgdt_set_progress(g->t, report, g), MGDT_OK);
    for (k = 0; k < 2; ++k) {
        g->inside = k == 0 ? "in mgdt_insert_points()" : "in mgdt_insert_points_strided()";
        g->visits = 0;
        if (k == 0)
            CHECK_EQUAL(mgdt_insert_points(g->t, n, g->xyz), MGDT_OK);
        else
            CHECK_EQUAL(mgdt_insert_points_strided(g->t, n, g->xyz, g->xyz + 1, g->xyz + 2, 3),
                        MGDT_OK);
        CHECK(g->visits > 10);
        expect_unharmed(g, expected);
    }
    /* The second copies of the points leave, and the others move to where they are. */
    for (k = 0; k < n; ++k) indices[k] = n + k;
    g->inside = "in mgdt_remove_points()";
    g->visits = 0;
    CHECK_EQUAL(mgdt_remove_points(g->t, n, indices), MGDT_OK);
    CHECK(g->visits > 0);
    expect_unharmed(g, expected);
    for (k = 0; k < n; ++k) indices[k] = k;
    g->inside = "in mgdt_move_points()";
    g->visits = 0;
    CHECK_EQUAL(mgdt_move_points(g->t, n, indices, g->xyz), MGDT_OK);
    CHECK(g->visits > 0);
    expect_unharmed(g, expected);
    mgdt_destroy(g->t);
    free(g);
}

static mgdt_status run(guest* g, int k) {
    int64_t found[2];
    const int64_t many = 100 * n;
    mgdt_status status = MGDT_OK;
    int64_t* const out = malloc((size_t)many * sizeof *out);
    int64_t* const offsets = malloc((size_t)many * sizeof *out);
    if (out == NULL || offsets == NULL) abort();
    switch (k) {
        case 0:
            status = mgdt_get_tetrahedra(g->t, many, out);
            break;
        case 1:
            status = mgdt_get_edges(g->t, many, out);
            break;
        case 2:
            status = mgdt_get_vertex_tetrahedra(g->t, many, offsets, many, out);
            break;
        case 3:
            status = mgdt_check(g->t, MGDT_CHECK_CANONICAL);
            break;
        case 4:
            status = mgdt_locate_points(g->t, 2, g->xyz, found, NULL);
            break;
        default: /* numbers the tetrahedra, which takes memory */
            status = mgdt_locate(g->t, g->xyz, found);
            break;
    }
    free(out);
    free(offsets);
    return status;
}

static void from_the_allocator(const mgdt_triangulation* expected) {
    guest* const g = make_guest();
    int k;
    CHECK_EQUAL(mgdt_create_with_allocator(take, give, g, &g->t), MGDT_OK);
    g->is_armed = 1;
    g->inside = "in mgdt_insert_points()";
    CHECK_EQUAL(mgdt_insert_points(g->t, n, g->xyz), MGDT_OK);
    CHECK(g->visits > 3);
    g->tetrahedra = mgdt_tetrahedron_count(g->t);
    g->is_armed = 0;
    expect_unharmed(g, expected);
    for (k = 0; k < 6; ++k) {
        /* The numbers are forgotten, so that each call makes them. */
        CHECK_EQUAL(mgdt_set_canonical_output(g->t, 1), MGDT_OK);
        CHECK_EQUAL(mgdt_set_canonical_output(g->t, 0), MGDT_OK);
        g->is_armed = g->is_read = 1;
        g->inside = "in calls that read it";
        g->visits = 0;
        CHECK_EQUAL(run(g, k), MGDT_OK);
        CHECK(g->visits > 0);
        g->is_armed = g->is_read = 0;
    }
    expect_unharmed(g, expected);

    g->is_armed = 1;
    g->visits = 0;
    g->inside = "in mgdt_reserve()";
    CHECK_EQUAL(mgdt_reserve(g->t, 10 * n), MGDT_OK);
    g->inside = "in mgdt_set_compact()";
    CHECK_EQUAL(mgdt_set_compact(g->t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_compact(g->t, 0), MGDT_OK);
    CHECK(g->visits > 2);
    expect_unharmed(g, expected);
    g->inside = "in mgdt_clear()";
    CHECK_EQUAL(mgdt_clear(g->t), MGDT_OK);
    CHECK_EQUAL(mgdt_point_count(g->t), 0);
    g->visits = 0;
    g->inside = "in mgdt_destroy()";
    mgdt_destroy(g->t);
    CHECK(g->visits > 0);
    free(g);
}

/* What a callback may do: ask to stop, and read the last message. */
static int32_t may(double fraction, void* user) {
    guest* const g = user;
    char text[256] = "?";
    (void)fraction;
    CHECK_EQUAL(mgdt_get_error(g->t, sizeof text, text), MGDT_OK);
    CHECK(strcmp(text, g->inside) == 0);
    CHECK_EQUAL(mgdt_get_error(g->t, 0, text), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_cancel(g->t), MGDT_OK);
    ++g->visits;
    return 0;
}

static void allowed(void) {
    guest* const g = make_guest();
    CHECK_EQUAL(mgdt_create(&g->t), MGDT_OK);
    CHECK_EQUAL(mgdt_set_progress(g->t, may, g), MGDT_OK);
    g->inside = "";
    CHECK_EQUAL(mgdt_insert_points(g->t, n, g->xyz), MGDT_ERR_CANCELLED);
    CHECK_EQUAL(g->visits, 1);
    CHECK_ERROR(g->t, "cancelled after 0 of 400 points");
    mgdt_destroy(g->t);
    free(g);
}

void test_busy(void) {
    guest* const g = make_guest();
    mgdt_triangulation* const expected = make(n, g->xyz);
    from_progress(expected);
    from_the_allocator(expected);
    allowed();
    mgdt_destroy(expected);
    free(g);
}
