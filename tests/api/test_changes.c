/* SPDX-License-Identifier: MIT
 * Points that leave, move and get other indices: after any history the arrays are, byte for byte,
 * those of a handle that is given the points that are in, where they are. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

/* The points that a handle should have. */
typedef struct {
    int64_t n;
    double* xyz;
    char* is_in;
} state;

static state start(int64_t most) {
    state s = {0, NULL, NULL};
    s.xyz = calloc((size_t)(3 * most), sizeof *s.xyz);
    s.is_in = calloc((size_t)most, 1);
    return s;
}

static void finish(state* s) {
    free(s->xyz);
    free(s->is_in);
}

static void insert(mgdt_triangulation* t, state* s, int64_t n, const double* xyz) {
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    memcpy(s->xyz + 3 * s->n, xyz, (size_t)(3 * n) * sizeof *xyz);
    memset(s->is_in + s->n, 1, (size_t)n);
    s->n += n;
}

/* Every point that is in with this chance, in a random order. */
static int64_t choose(const state* s, int64_t* list, double chance, uint64_t* random) {
    int64_t n = 0, i;
    for (i = 0; i < s->n; ++i)
        if (s->is_in[i] && random_double(random) < chance) list[n++] = i;
    for (i = n - 1; i > 0; --i) {
        const int64_t j = (int64_t)(random_double(random) * (double)(i + 1)), kept = list[i];
        list[i] = list[j];
        list[j] = kept;
    }
    return n;
}

static int32_t* narrow(const int64_t* list, int64_t n) {
    int32_t* const result = malloc((size_t)(n + 1) * sizeof *result);
    int64_t k;
    for (k = 0; k < n; ++k) result[k] = (int32_t)list[k];
    return result;
}

static void expect_as_fresh(const mgdt_triangulation* t, const state* s, int base) {
    static const get_fn arrays[] = {mgdt_get_tetrahedra, mgdt_get_neighbors, mgdt_get_hull_facets,
                                    mgdt_get_edges};
    double* const xyz = malloc((size_t)(3 * s->n + 1) * sizeof *xyz);
    int64_t* const index = malloc((size_t)(s->n + 1) * sizeof *index);
    int64_t *map, *fresh_map, n = 0, i;
    mgdt_triangulation* fresh;
    int a, good = 1;
    for (i = 0; i < s->n; ++i) {
        if (!s->is_in[i]) continue;
        memcpy(xyz + 3 * n, s->xyz + 3 * i, 3 * sizeof *xyz);
        index[n++] = i;
    }
    fresh = make(n, xyz);
    CHECK_EQUAL(mgdt_set_canonical_output(fresh, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    CHECK_EQUAL(mgdt_point_count(t), s->n);
    CHECK_EQUAL(mgdt_vertex_count(t), mgdt_vertex_count(fresh));
    CHECK_EQUAL(mgdt_dimension(t), mgdt_dimension(fresh));
    for (a = 0; a < 4; ++a) {
        const int64_t rows[] = {mgdt_tetrahedron_count(fresh), mgdt_tetrahedron_count(fresh),
                                mgdt_hull_facet_count(fresh), mgdt_edge_count(fresh)};
        const int64_t found[] = {mgdt_tetrahedron_count(t), mgdt_tetrahedron_count(t),
                                 mgdt_hull_facet_count(t), mgdt_edge_count(t)};
        static const int width[] = {4, 4, 3, 2};
        const int64_t size = rows[a] * width[a];
        int64_t *expected, *v;
        if (!CHECK_EQUAL(found[a], rows[a])) continue;
        expected = get_array(arrays[a], fresh, size);
        v = get_array(arrays[a], t, size);
        for (i = 0; i < size && expected && v; ++i)
            good &= v[i] - base == (a == 1 ? expected[i] : index[expected[i]]);
        free(expected);
        free(v);
    }
    CHECK(good);
    map = get_array(mgdt_get_point_map, t, s->n);
    fresh_map = get_array(mgdt_get_point_map, fresh, n);
    for (i = 0, n = 0; i < s->n && map && fresh_map; ++i)
        good &= map[i] - base == (s->is_in[i] ? index[fresh_map[n++]] : -1);
    CHECK(good);
    free(map);
    free(fresh_map);
    free(xyz);
    free(index);
    mgdt_destroy(fresh);
}

static void histories(int grid, int compact, uint64_t seed) {
    const int64_t n = is_small() ? 40 : 150, most = 12 * n;
    int64_t* const list = malloc((size_t)most * sizeof *list);
    double* const places = malloc((size_t)(3 * most) * sizeof *places);
    state s = start(most);
    mgdt_triangulation* t = NULL;
    double put_back = 0, removed = 0, link = 0;
    int round;
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK_EQUAL(mgdt_set_compact(t, compact), MGDT_OK);
    CHECK_EQUAL(mgdt_set_canonical_output(t, 1), MGDT_OK);
    for (round = 0; round < 10; ++round) {
        const int base = round % 2, is_narrow = round / 2 % 2;
        double* const xyz = random_points(n, grid, seed + (uint64_t)round);
        int64_t count, k;
        int32_t* narrowed;
        insert(t, &s, n, xyz);
        free(xyz);
        CHECK_EQUAL(mgdt_set_index_base(t, base), MGDT_OK);
        count = choose(&s, list, round == 5 ? 2 : random_double(&seed) * 0.7, &seed);
        for (k = 0; k < count; ++k) {
            s.is_in[list[k]] = 0;
            list[k] += base;
        }
        narrowed = narrow(list, count);
        CHECK_EQUAL(is_narrow ? mgdt_remove_points_i32(t, count, narrowed)
                              : mgdt_remove_points(t, count, list),
                    MGDT_OK);
        free(narrowed);
        expect_as_fresh(t, &s, base);
        count = choose(&s, list, round % 3 == 0 ? 0.03 : 0.6, &seed);
        for (k = 0; k < count; ++k) {
            const double* const from = s.xyz + 3 * list[k];
            const double* const other = s.xyz + 3 * list[(k + 1) % count];
            int axis;
            /* A little, onto another point, and anywhere. */
            for (axis = 0; axis < 3; ++axis)
                places[3 * k + axis] = k % 3 == 0   ? from[axis] + 0.01 * random_double(&seed)
                                       : k % 3 == 1 ? other[axis]
                                                    : 2 * random_double(&seed) - 0.5;
        }
        for (k = 0; k < count; ++k) {
            memcpy(s.xyz + 3 * list[k], places + 3 * k, 3 * sizeof *places);
            list[k] += base;
        }
        narrowed = narrow(list, count);
        CHECK_EQUAL(is_narrow ? mgdt_move_points_i32(t, count, narrowed, places)
                              : mgdt_move_points(t, count, list, places),
                    MGDT_OK);
        free(narrowed);
        expect_as_fresh(t, &s, base);
        /* All of them, those that are out to nowhere. */
        for (k = 0; k < 3 * s.n; ++k) {
            if (s.is_in[k / 3]) s.xyz[k] = s.xyz[k] * 0.99 + 0.001 * random_double(&seed);
            places[k] = s.is_in[k / 3] ? s.xyz[k] : NAN;
        }
        CHECK_EQUAL(mgdt_move_points(t, s.n, NULL, places), MGDT_OK);
        expect_as_fresh(t, &s, base);
    }
    mgdt_get_stat(t, MGDT_STAT_POINTS_REMOVED, &removed);
    mgdt_get_stat(t, MGDT_STAT_PUT_BACK, &put_back);
    mgdt_get_stat(t, MGDT_STAT_LINK_VERTICES, &link);
    CHECK(removed > 0 && put_back > 0 && link > 3 * put_back);
    mgdt_destroy(t);
    finish(&s);
    free(list);
    free(places);
}

static void renumbering(void) {
    const int64_t n = 60;
    double* const xyz = random_points(n, 4, 77); /* with repeats */
    int64_t* const list = malloc((size_t)n * sizeof *list);
    int64_t* const index = malloc((size_t)(n + 1) * sizeof *index);
    int32_t* const index32 = malloc((size_t)(n + 1) * sizeof *index32);
    state s = start(2 * n);
    mgdt_triangulation *t = NULL, *twin = NULL;
    uint64_t seed = 5;
    int64_t count, next = 0, i;
    int good = 1, k;
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK_EQUAL(mgdt_create(&twin), MGDT_OK);
    CHECK_EQUAL(mgdt_renumber_points(t, 0, NULL), MGDT_OK);
    insert(t, &s, n, xyz);
    CHECK_EQUAL(mgdt_insert_points(twin, n, xyz), MGDT_OK);
    count = choose(&s, list, 0.5, &seed);
    for (i = 0; i < count; ++i) s.is_in[list[i]] = 0;
    CHECK_EQUAL(mgdt_remove_points(t, count, list), MGDT_OK);
    CHECK_EQUAL(mgdt_remove_points(twin, count, list), MGDT_OK);
    CHECK_EQUAL(mgdt_set_index_base(t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_renumber_points(t, n - 1, index), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_renumber_points(t, n, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_renumber_points(t, -1, index), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_point_count(t), n);
    index[n] = 99, index32[n] = 99;
    CHECK_EQUAL(mgdt_renumber_points(t, n, index), MGDT_OK);
    CHECK_EQUAL(mgdt_renumber_points_i32(twin, n, index32), MGDT_OK);
    for (i = 0; i < n; ++i) {
        good &= index[i] == (s.is_in[i] ? next + 1 : 0);
        good &= index32[i] == (int32_t)index[i] - 1;
        if (!s.is_in[i]) continue;
        for (k = 0; k < 3; ++k) s.xyz[3 * next + k] = s.xyz[3 * i + k];
        ++next;
    }
    CHECK(good && index[n] == 99 && index32[n] == 99);
    memset(s.is_in, 1, (size_t)next);
    s.n = next;
    CHECK_EQUAL(mgdt_set_canonical_output(t, 1), MGDT_OK);
    expect_as_fresh(t, &s, 1);
    insert(t, &s, n, xyz);
    expect_as_fresh(t, &s, 1);
    mgdt_destroy(t);
    mgdt_destroy(twin);
    finish(&s);
    free(index);
    free(index32);
    free(list);
    free(xyz);
}

static void arguments(void) {
    const int64_t n = 20;
    double* const xyz = random_points(n, 0, 78);
    int64_t list[3] = {3, 4, 3}, *before, *after;
    int32_t list32[3] = {3, 4, INT32_MIN};
    mgdt_triangulation* const t = make(n, xyz);
    double removed = -1;
    CHECK_EQUAL(mgdt_remove_points(t, 1, list), MGDT_OK);
    before = get_array(mgdt_get_point_map, t, n);
    CHECK_EQUAL(mgdt_remove_points(t, -1, list), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_remove_points(t, INT64_MAX, list),
                sizeof(size_t) < 8 ? MGDT_ERR_TOO_LARGE : MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_remove_points(t, 1, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_remove_points(t, 0, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_remove_points(t, 1, list), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "point 3 is not in the triangulation");
    list[0] = 5, list[2] = 5;
    CHECK_EQUAL(mgdt_remove_points(t, 3, list), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "point 5 is to be removed twice");
    list[2] = n;
    CHECK_EQUAL(mgdt_remove_points(t, 3, list), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "there is no point 20: 20 were given");
    list[2] = INT64_MIN;
    CHECK_EQUAL(mgdt_remove_points(t, 3, list), MGDT_ERR_INVALID_ARGUMENT);
    list32[0] = 5;
    CHECK_EQUAL(mgdt_remove_points_i32(t, 3, list32), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "-2147483648");
    CHECK_EQUAL(mgdt_move_points(t, -1, list, xyz), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_move_points(t, 2, list, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_move_points(t, 0, NULL, NULL), MGDT_OK);
    CHECK_EQUAL(mgdt_move_points(t, n - 1, NULL, xyz), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "19 places for 20 points");
    list[2] = 3;
    CHECK_EQUAL(mgdt_move_points(t, 3, list, xyz), MGDT_ERR_INVALID_ARGUMENT);
    list[2] = 4;
    CHECK_EQUAL(mgdt_move_points(t, 3, list, xyz), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "point 4 is to be moved twice");
    CHECK_EQUAL(mgdt_set_index_base(t, 1), MGDT_OK);
    list[0] = list32[0] = 6;
    list[1] = list32[1] = 5;
    xyz[4] = NAN;
    CHECK_EQUAL(mgdt_move_points(t, 2, list, xyz), MGDT_ERR_NOT_FINITE);
    CHECK_ERROR(t, "coordinate y of point 5 is NaN");
    xyz[4] = -INFINITY;
    CHECK_EQUAL(mgdt_move_points_i32(t, 2, list32, xyz), MGDT_ERR_NOT_FINITE);
    CHECK_ERROR(t, "coordinate y of point 5 is infinite");
    CHECK_EQUAL(mgdt_move_points(t, n, NULL, xyz), MGDT_ERR_NOT_FINITE);
    CHECK_EQUAL(mgdt_set_index_base(t, 0), MGDT_OK);
    after = get_array(mgdt_get_point_map, t, n);
    CHECK(before && after && memcmp(before, after, (size_t)n * sizeof *before) == 0);
    CHECK_EQUAL(mgdt_get_stat(t, MGDT_STAT_POINTS_REMOVED, &removed), MGDT_OK);
    CHECK(removed == 1);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    free(before);
    free(after);
    free(xyz);
    mgdt_destroy(t);
}

/* A request that comes before a call stops it, and it alone. */
static void cancelling(void) {
    const int64_t n = 100;
    double* const xyz = random_points(n, 0, 79);
    const int64_t list[2] = {7, 8};
    mgdt_triangulation* const t = make(n, xyz);
    CHECK_EQUAL(mgdt_cancel(t), MGDT_OK);
    CHECK_EQUAL(mgdt_remove_points(t, 2, list), MGDT_ERR_CANCELLED);
    CHECK_ERROR(t, "cancelled after 0 of 2 points");
    CHECK_EQUAL(mgdt_cancel(t), MGDT_OK);
    CHECK_EQUAL(mgdt_move_points(t, 2, list, xyz), MGDT_ERR_CANCELLED);
    CHECK_ERROR(t, "cancelled after 0 of 2 points");
    CHECK_EQUAL(mgdt_vertex_count(t), n);
    CHECK_EQUAL(mgdt_move_points(t, 2, list, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_vertex_count(t), n - 2);
    CHECK_EQUAL(mgdt_remove_points(t, 2, list), MGDT_OK);
    CHECK_EQUAL(mgdt_vertex_count(t), n - 2);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    free(xyz);
    mgdt_destroy(t);
}

void test_changes(void) {
    histories(0, 0, 1);
    histories(5, 0, 2); /* ties and repeats */
    histories(3, 1, 3);
    renumbering();
    arguments();
    cancelling();
}
