/* SPDX-License-Identifier: MIT
 * Running out of memory: the N-th allocation fails, for every N; a limit is met; and all that was
 * taken from the caller's allocator is given back as it was taken. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

/* ---------------------------------------------------------- an allocator that checks and fails */

typedef struct {
    int64_t calls, live, bytes, peak;
    int64_t fail_from, fail_to; /* the calls that get NULL, counted from 1 */
    int wrong;                  /* memory given back with another size or alignment, or twice */
} source;

typedef struct {
    void* raw;
    size_t size, align;
    uint64_t magic;
} header;

static const uint64_t living = UINT64_C(0x6D67647420697321);

static void* take(size_t size, size_t align, void* user) {
    source* s = user;
    header h;
    unsigned char *raw, *p;
    ++s->calls;
    if (s->calls >= s->fail_from && s->calls < s->fail_to) return NULL;
    if (size == 0 || align == 0 || (align & (align - 1)) != 0) s->wrong = 1;
    raw = malloc(size + align + sizeof h);
    if (raw == NULL) return NULL;
    p = raw + sizeof h;
    p += (align - (size_t)((uintptr_t)p & (align - 1))) & (align - 1);
    h.raw = raw;
    h.size = size;
    h.align = align;
    h.magic = living;
    memcpy(p - sizeof h, &h, sizeof h);
    memset(p, 0xA5, size); /* nobody may count on zeros */
    ++s->live;
    s->bytes += (int64_t)size;
    if (s->bytes > s->peak) s->peak = s->bytes;
    return p;
}

static void give(void* p, size_t size, size_t align, void* user) {
    source* s = user;
    header h;
    memcpy(&h, (unsigned char*)p - sizeof h, sizeof h);
    if (h.magic != living || h.size != size || h.align != align) {
        s->wrong = 1;
        return;
    }
    h.magic = 0;
    memcpy((unsigned char*)p - sizeof h, &h, sizeof h);
    memset(p, 0x5A, size);
    --s->live;
    s->bytes -= (int64_t)size;
    free(h.raw);
}

static source working(void) {
    source s;
    memset(&s, 0, sizeof s);
    return s;
}

static void fail(source* s, int64_t from, int64_t to) {
    s->fail_from = from;
    s->fail_to = to;
}

/* ------------------------------------------------------------------------------ the scenario */

enum { batch_count = 4, point_count = 240 };
/* A line, a plane, then space, with repeats inside and across batches. */
static const int64_t batch_begin[batch_count + 1] = {0, 12, 60, 150, point_count};

static double* scenario(void) {
    double* xyz = random_points(point_count, 12, 71);
    int64_t i;
    for (i = 0; i < batch_begin[2]; ++i) {
        xyz[3 * i + 2] = 0.5;
        if (i < batch_begin[1]) xyz[3 * i + 1] = 0.25;
    }
    return xyz;
}

/* Which point of the scenario each point of a handle is. */
typedef struct {
    int64_t origin[2 * point_count], count;
} history;

/* Inserts points [first, last) of the scenario. A call that runs out of memory has taken all of
 * its indices, or none: mgdt_point_count() says which. */
static mgdt_status insert(mgdt_triangulation* t, int64_t first, int64_t last, const double* xyz,
                          history* h) {
    const mgdt_status status = mgdt_insert_points(t, last - first, xyz + 3 * first);
    const int64_t given = mgdt_point_count(t) - h->count;
    CHECK(given == last - first || (given == 0 && status == MGDT_ERR_OUT_OF_MEMORY));
    if (given != 0)
        for (; first < last; ++first) h->origin[h->count++] = first;
    return status;
}

/* Every point that the map says is in stands for itself or for an equal one. */
static void consistent(const mgdt_triangulation* t, const double* xyz, const history* h) {
    int64_t *map = get_array(mgdt_get_point_map, t, h->count), i, vertices = 0;
    int good = 1;
    for (i = 0; i < h->count; ++i) {
        const double* p = xyz + 3 * h->origin[i];
        vertices += map[i] == i;
        if (map[i] == -1) continue;
        good &= map[i] >= 0 && map[i] <= i && map[map[i]] == map[i];
        if (good) {
            const double* q = xyz + 3 * h->origin[map[i]];
            good &= p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
        }
    }
    CHECK(good);
    CHECK_EQUAL(vertices, mgdt_vertex_count(t));
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    free(map);
}

/* The scenario with the nth call of the allocator failing; 0 if it has fewer calls. With
 * `all`, every call fails from the nth to the end of the function that met it. With `switching`,
 * storage becomes compact, or no longer so, before each batch. */
static int with_failure(int64_t nth, int all, int switching, int32_t scheme, const double* xyz,
                        const mgdt_triangulation* expected) {
    source s = working();
    mgdt_triangulation* t = (mgdt_triangulation*)&s;
    history h;
    mgdt_status status;
    int b, failures = 0, reached;
    h.count = 0;
    fail(&s, nth, all ? INT64_MAX : nth + 1);
    status = mgdt_create_with_allocator(take, give, &s, &t);
    if (status != MGDT_OK) {
        CHECK_EQUAL(status, MGDT_ERR_OUT_OF_MEMORY);
        CHECK(t == NULL);
        CHECK_EQUAL(s.live, 0);
        return 1;
    }
    CHECK_EQUAL(mgdt_set_order_scheme(t, scheme), MGDT_OK);
    for (b = 0; b < batch_count; ++b) {
        if (switching) {
            status = mgdt_set_compact(t, b % 2 == 0);
            if (status != MGDT_OK) {
                CHECK_EQUAL(status, MGDT_ERR_OUT_OF_MEMORY);
                CHECK(b % 2 == 1); /* it only gives memory back */
                ++failures;
                fail(&s, 0, 0);
                consistent(t, xyz, &h);
            }
        }
        status = insert(t, batch_begin[b], batch_begin[b + 1], xyz, &h);
        if (status == MGDT_OK) continue;
        CHECK_EQUAL(status, MGDT_ERR_OUT_OF_MEMORY);
        ++failures;
        fail(&s, 0, 0);
        consistent(t, xyz, &h);
    }
    reached = s.calls >= nth;
    /* The library may do without one allocation, but not without all. */
    CHECK(failures <= 1);
    if (all && reached) CHECK_EQUAL(failures, 1);
    fail(&s, 0, 0);
    consistent(t, xyz, &h);
    CHECK_EQUAL(insert(t, 0, point_count, xyz, &h), MGDT_OK);
    CHECK_EQUAL(mgdt_vertex_count(t), mgdt_vertex_count(expected));
    consistent(t, xyz, &h);
    CHECK(same_tetrahedra(t, expected, h.origin));
    mgdt_destroy(t);
    CHECK_EQUAL(s.live, 0);
    CHECK_EQUAL(s.bytes, 0);
    CHECK(!s.wrong);
    return reached;
}

static void every_allocation(int32_t scheme, const double* xyz,
                             const mgdt_triangulation* expected) {
    int all, switching;
    for (all = 0; all < 2; ++all)
        for (switching = 0; switching < 2; ++switching) {
            int64_t nth = 1;
            while (with_failure(nth, all, switching, scheme, xyz, expected))
                nth += is_smallest() ? 17 : is_small() ? 5 : 1;
            CHECK(nth > 5); /* the scenario does allocate */
        }
}

/* ------------------------------------------------------------------- calls that do not insert */

static mgdt_status export_all(const mgdt_triangulation* t, int64_t* v, int64_t* list) {
    static const double q[6] = {0.3, 0.4, 0.5, 9, 9, 9};
    const int64_t size = 4 * mgdt_tetrahedron_count(t);
    double weights[8];
    mgdt_status status = MGDT_OK;
#define TRY(call) \
    if (status == MGDT_OK) status = (call)
    TRY(mgdt_get_tetrahedra(t, size, v));
    TRY(mgdt_get_neighbors(t, size, v));
    TRY(mgdt_get_hull_facets(t, size, v));
    TRY(mgdt_get_edges(t, size, v));
    TRY(mgdt_get_point_map(t, size, v));
    TRY(mgdt_get_vertex_tetrahedra(t, size, v, size, list));
    TRY(mgdt_get_vertex_neighbors(t, size, v, size, list));
    TRY(mgdt_get_gabriel_edges(t, size, v, list));
    TRY(mgdt_get_spanning_tree(t, size, v, list));
    TRY(mgdt_locate(t, q, v));
    TRY(mgdt_locate_points(t, 2, q, v, weights));
    TRY(mgdt_traverse_segment(t, q, q + 3, size, v, NULL, list));
    TRY(mgdt_nearest_vertex(t, q, v));
    TRY(mgdt_nearest_vertices(t, 2, q, v));
    TRY(mgdt_check(t, MGDT_CHECK_CANONICAL));
    return status;
}

/* Apart, since each refusal makes all calls before it again. */
static mgdt_status export_dual(const mgdt_triangulation* t, int64_t* v, int64_t* list) {
    const int64_t size = 4 * mgdt_tetrahedron_count(t);
    double* const x = malloc((size_t)(3 * size) * sizeof *x);
    mgdt_status status = MGDT_OK;
    if (x == NULL) abort();
    TRY(mgdt_get_circumcenters(t, size, x, NULL));
    TRY(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_RADIUS_RATIO, size, x));
    TRY(mgdt_get_alphas(t, 3, size, x));
    TRY(mgdt_get_alphas(t, 2, size, x));
    TRY(mgdt_get_alphas(t, 1, size, x));
    TRY(mgdt_get_alphas(t, 0, size, x));
    TRY(mgdt_get_solid_alpha(t, x));
    TRY(mgdt_get_alpha_surface(t, 1e9, size, v, list));
    TRY(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 0, NULL, 3 * size, x));
    free(x);
    return status;
}

/* Of few points: those of a lattice are measured with a hundred bits. */
static mgdt_status export_cells(const mgdt_triangulation* t, int64_t* v, int64_t* list) {
    static const double box[24] = {1, 0,  0, 2, -1, 0, 0, 1, 0, 1, 0,  2,
                                   0, -1, 0, 1, 0,  0, 1, 2, 0, 0, -1, 1};
    double x[3 * 12];
    mgdt_status status = MGDT_OK;
    (void)v;
    (void)list;
    TRY(mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 6, box, 3 * 12, x));
    TRY(mgdt_get_cell_measures(t, MGDT_MEASURE_CENTROID, 6, box, 3 * 12, x));
    TRY(mgdt_interpolate(t, MGDT_INTERPOLATE_SIBSON_C1, MGDT_OUTSIDE_LINEAR, 1, box, 2, box, x));
    TRY(mgdt_get_gradients(t, 1, box, x));
#undef TRY
    return status;
}

typedef mgdt_status (*exporter)(const mgdt_triangulation* t, int64_t* v, int64_t* list);

/* Refuses each of its allocations, alone and with all after it. */
static void refuse_each(source* s, const mgdt_triangulation* t, exporter export, int64_t* v,
                        int64_t* list) {
    mgdt_status status;
    int64_t nth, before;
    for (nth = 1;; nth += is_smallest() ? 23 : is_small() ? 7 : 1) {
        /* One refusal: an array that wanted to grow generously may do with less. */
        before = s->calls;
        fail(s, before + nth, before + nth + 1);
        status = export(t, v, list);
        CHECK(status == MGDT_ERR_OUT_OF_MEMORY || status == MGDT_OK);
        /* From there on nothing but refusals. */
        before = s->calls;
        fail(s, before + nth, INT64_MAX);
        status = export(t, v, list);
        fail(s, 0, 0);
        if (s->calls < before + nth) break;
        CHECK_EQUAL(status, MGDT_ERR_OUT_OF_MEMORY);
    }
    CHECK_EQUAL(status, MGDT_OK);
    before = s->bytes; /* what a const call computes once may stay, but does not grow */
    CHECK_EQUAL(export(t, v, list), MGDT_OK);
    CHECK_EQUAL(s->bytes, before);
}

static void exports(const double* xyz) {
    source s = working();
    double* const corners = random_points(12, 0, 3);
    mgdt_triangulation *t = NULL, *few = NULL;
    int64_t before, size, *v, *list;
    int on;
    CHECK_EQUAL(mgdt_create_with_allocator(take, give, &s, &t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, point_count, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_create_with_allocator(take, give, &s, &few), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(few, 12, corners), MGDT_OK);
    size = 4 * mgdt_tetrahedron_count(t);
    v = malloc((size_t)size * sizeof *v);
    list = malloc((size_t)size * sizeof *list);
    for (on = 0; on < 2; ++on) {
        CHECK_EQUAL(mgdt_set_canonical_output(t, on), MGDT_OK);
        refuse_each(&s, t, export_all, v, list);
        refuse_each(&s, t, export_dual, v, list);
        refuse_each(&s, few, export_cells, NULL, NULL);
    }
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);

    before = s.calls;
    fail(&s, before + 1, INT64_MAX);
    CHECK_EQUAL(mgdt_reserve(t, 1000000), MGDT_ERR_OUT_OF_MEMORY);
    CHECK_EQUAL(mgdt_set_compact(t, 1), MGDT_OK); /* gives memory back, so takes none */
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_COMBINATORIAL), MGDT_ERR_OUT_OF_MEMORY);
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK); /* promises no such error */
    fail(&s, 0, 0);
    CHECK_EQUAL(mgdt_insert_points(t, point_count, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    mgdt_destroy(few);
    mgdt_destroy(t);
    CHECK_EQUAL(s.live, 0);
    CHECK(!s.wrong);
    free(corners);
    free(v);
    free(list);
}

/* --------------------------------------------------------------------------------- the limit */

static int64_t memory_of(const mgdt_triangulation* t, int32_t key) {
    double value = -1;
    CHECK_EQUAL(mgdt_get_stat(t, key, &value), MGDT_OK);
    return (int64_t)value;
}

static void limits(void) {
    const int64_t n = is_small() ? 400 : 5000;
    double* xyz = random_points(n, 0, 72);
    mgdt_triangulation* expected = make(n, xyz);
    const int64_t needed = memory_of(expected, MGDT_STAT_PEAK_MEMORY_BYTES);
    int64_t limit;
    int refused = 0;
    for (limit = 1; limit < 2 * needed; limit = limit * 3 / 2 + 1) {
        mgdt_triangulation* t = NULL;
        mgdt_status status;
        CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
        {
            const int64_t at_birth = memory_of(t, MGDT_STAT_MEMORY_BYTES);
            CHECK_EQUAL(mgdt_set_memory_limit(t, limit), MGDT_OK);
            status = mgdt_insert_points(t, n, xyz);
            CHECK(memory_of(t, MGDT_STAT_PEAK_MEMORY_BYTES) <=
                  (limit > at_birth ? limit : at_birth));
        }
        if (status != MGDT_OK) {
            ++refused;
            CHECK_EQUAL(status, MGDT_ERR_OUT_OF_MEMORY);
            CHECK(mgdt_point_count(t) == n || mgdt_point_count(t) == 0);
            CHECK_EQUAL(mgdt_set_memory_limit(t, 0), MGDT_OK);
            CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
            CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
        }
        CHECK_EQUAL(mgdt_set_memory_limit(t, 0), MGDT_OK);
        CHECK(same_tetrahedra(t, expected, NULL));
        /* A limit below what is held takes nothing away. */
        CHECK_EQUAL(mgdt_set_memory_limit(t, 1), MGDT_OK);
        CHECK_EQUAL(mgdt_vertex_count(t), n);
        CHECK_EQUAL(mgdt_reserve(t, 10 * n), MGDT_ERR_OUT_OF_MEMORY);
        CHECK_EQUAL(mgdt_set_memory_limit(t, 0), MGDT_OK);
        CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
        mgdt_destroy(t);
    }
    CHECK(refused > 3);
    mgdt_destroy(expected);
    free(xyz);
}

/* A limit below what is held takes nothing away. What needs more memory is refused and has changed
 * nothing; what needs none works; and without the limit all goes on. */
static void below_what_is_held(void) {
    const int64_t n = 3000;
    double *xyz = random_points(n, 0, 73), *more = random_points(n, 0, 74);
    mgdt_triangulation *t = make(n, xyz), *expected = make(n, xyz);
    const int64_t count = mgdt_tetrahedron_count(t);
    int64_t *const before = get_array(mgdt_get_tetrahedra, t, 4 * count), *after;
    int64_t held, found = -7;
    /* No numbers of tetrahedra are there to answer with; the nearest vertex needs none. */
    CHECK_EQUAL(mgdt_insert_points(t, 1, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(expected, 1, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_set_memory_limit(t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_locate(t, more, &found), MGDT_ERR_OUT_OF_MEMORY);
    CHECK_EQUAL(mgdt_nearest_vertex(t, more, &found), MGDT_OK);
    CHECK_EQUAL(mgdt_set_memory_limit(t, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_locate(t, more, &found), MGDT_OK); /* makes them, and the tree */
    held = memory_of(t, MGDT_STAT_MEMORY_BYTES);
    CHECK_EQUAL(mgdt_set_memory_limit(t, held / 2), MGDT_OK);
    CHECK_EQUAL(memory_of(t, MGDT_STAT_MEMORY_BYTES), held);
    CHECK_EQUAL(mgdt_tetrahedron_count(t), count);

    CHECK_EQUAL(mgdt_insert_points(t, n, more), MGDT_ERR_OUT_OF_MEMORY);
    CHECK_EQUAL(mgdt_point_count(t), n + 1);
    CHECK_EQUAL(mgdt_reserve(t, 10 * n), MGDT_ERR_OUT_OF_MEMORY);
    /* Working memory of calls that read counts too. */
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_ERR_OUT_OF_MEMORY);
    CHECK_EQUAL(mgdt_get_tetrahedra(t, 4 * count, before), MGDT_ERR_OUT_OF_MEMORY);
    CHECK_EQUAL(mgdt_locate(t, more, &found), MGDT_OK);
    CHECK_EQUAL(memory_of(t, MGDT_STAT_MEMORY_BYTES), held);

    CHECK_EQUAL(mgdt_set_memory_limit(t, 0), MGDT_OK);
    after = get_array(mgdt_get_tetrahedra, t, 4 * count);
    CHECK(before != NULL && after != NULL &&
          memcmp(before, after, (size_t)(4 * count) * sizeof *after) == 0);
    free(after);
    CHECK(same_tetrahedra(t, expected, NULL));
    CHECK_EQUAL(mgdt_insert_points(t, n, more), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(expected, n, more), MGDT_OK);
    CHECK(same_tetrahedra(t, expected, NULL));
    mgdt_destroy(t);
    mgdt_destroy(expected);
    free(before);
    free(xyz);
    free(more);
}

/* What the statistics say is what the caller's allocator saw. */
static void accounting(const double* xyz) {
    source s = working();
    mgdt_triangulation* t = NULL;
    CHECK_EQUAL(mgdt_create_with_allocator(take, give, &s, &t), MGDT_OK);
    CHECK_EQUAL(memory_of(t, MGDT_STAT_MEMORY_BYTES), s.bytes);
    CHECK_EQUAL(mgdt_insert_points(t, point_count, xyz), MGDT_OK);
    CHECK_EQUAL(memory_of(t, MGDT_STAT_MEMORY_BYTES), s.bytes);
    CHECK_EQUAL(mgdt_set_compact(t, 1), MGDT_OK);
    CHECK_EQUAL(memory_of(t, MGDT_STAT_MEMORY_BYTES), s.bytes);
    CHECK_EQUAL(mgdt_set_compact(t, 0), MGDT_OK);
    CHECK_EQUAL(memory_of(t, MGDT_STAT_MEMORY_BYTES), s.bytes);
    CHECK(memory_of(t, MGDT_STAT_PEAK_MEMORY_BYTES) >= s.peak - 64);
    CHECK(memory_of(t, MGDT_STAT_PEAK_MEMORY_BYTES) <= s.peak + 64);
    mgdt_destroy(t);
    CHECK_EQUAL(s.live, 0);
    CHECK(!s.wrong);
    /* Both NULL: the default allocator. */
    CHECK_EQUAL(mgdt_create_with_allocator(NULL, NULL, NULL, &t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, point_count, xyz), MGDT_OK);
    mgdt_destroy(t);
}

/* What is kept for speed alone goes, and comes back when it is wanted; all else stays. */
static void shrunk(void) {
    const int64_t n = is_small() ? 3000 : 20000, half = n / 2;
    double* xyz = random_points(n, 0, 12);
    int kind;
    for (kind = 0; kind < 4; ++kind) { /* compact or not, canonical or not */
        source s = working();
        mgdt_triangulation* t = NULL;
        int64_t size, held, found[2], again[2], *v, *w;
        CHECK_EQUAL(mgdt_create_with_allocator(take, give, &s, &t), MGDT_OK);
        CHECK_EQUAL(mgdt_set_compact(t, kind & 1), MGDT_OK);
        CHECK_EQUAL(mgdt_set_canonical_output(t, kind >> 1), MGDT_OK);
        CHECK_EQUAL(mgdt_shrink(t), MGDT_OK); /* of nothing */
        CHECK_EQUAL(mgdt_reserve(t, 2 * n), MGDT_OK);
        CHECK_EQUAL(mgdt_insert_points(t, half, xyz), MGDT_OK);
        size = 4 * mgdt_tetrahedron_count(t);
        v = get_array(mgdt_get_tetrahedra, t, size);
        CHECK_EQUAL(mgdt_locate(t, xyz + 3 * half, &found[0]), MGDT_OK);
        CHECK_EQUAL(mgdt_nearest_vertex(t, xyz + 3 * half, &found[1]), MGDT_OK);
        held = memory_of(t, MGDT_STAT_MEMORY_BYTES);
        CHECK_EQUAL(mgdt_shrink(t), MGDT_OK);
        CHECK_EQUAL(memory_of(t, MGDT_STAT_MEMORY_BYTES), s.bytes);
        /* Tetrahedra, some 6.8 a point with ghosts, vertices and the point map; no more than a
         * tenth besides, of free slots and the handle. */
        CHECK((double)s.bytes < 1.1 * (double)half * (6.8 * (kind & 1 ? 32 : 48) + 40));
        CHECK(2 * s.bytes < held);
        w = get_array(mgdt_get_tetrahedra, t, size);
        CHECK(v != NULL && w != NULL && memcmp(v, w, (size_t)size * sizeof *v) == 0);
        CHECK_EQUAL(mgdt_locate(t, xyz + 3 * half, &again[0]), MGDT_OK);
        CHECK_EQUAL(mgdt_nearest_vertex(t, xyz + 3 * half, &again[1]), MGDT_OK);
        CHECK(found[0] == again[0] && found[1] == again[1]);
        free(v);
        free(w);
        /* Where the allocator refuses smaller blocks the larger ones stay. */
        fail(&s, s.calls + 1, INT64_MAX);
        CHECK_EQUAL(mgdt_shrink(t), MGDT_OK);
        CHECK_EQUAL(mgdt_reserve(t, n), MGDT_ERR_OUT_OF_MEMORY);
        fail(&s, 0, 0);
        CHECK_EQUAL(mgdt_reserve(t, n), MGDT_OK);
        fail(&s, s.calls + 1, INT64_MAX);
        CHECK_EQUAL(mgdt_shrink(t), MGDT_OK);
        fail(&s, 0, 0);
        CHECK_EQUAL(mgdt_insert_points(t, n - half, xyz + 3 * half), MGDT_OK);
        CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
        CHECK_EQUAL(mgdt_vertex_count(t), n);
        CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
        CHECK_EQUAL(mgdt_shrink(t), MGDT_OK);
        CHECK(s.bytes < 100000); /* a handle */
        mgdt_destroy(t);
        CHECK_EQUAL(s.live, 0);
        CHECK(!s.wrong);
    }
    free(xyz);
}

/* A block that compact storage was refused to make smaller is no room for more tetrahedra. */
static void shrunk_after_refusals(void) {
    const int64_t n = 2000;
    double *xyz = random_points(n, 0, 13), before;
    source s = working();
    mgdt_triangulation* t = NULL;
    CHECK_EQUAL(mgdt_create_with_allocator(take, give, &s, &t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    fail(&s, s.calls + 1, INT64_MAX);
    CHECK_EQUAL(mgdt_set_compact(t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_shrink(t), MGDT_OK);
    /* The spheres fit the block that they were in. */
    CHECK_EQUAL(mgdt_set_compact(t, 0), MGDT_OK);
    fail(&s, 0, 0);
    before = (double)s.bytes;
    CHECK_EQUAL(mgdt_shrink(t), MGDT_OK);
    CHECK((double)s.bytes < before);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    mgdt_destroy(t);
    CHECK_EQUAL(s.live, 0);
    CHECK(!s.wrong);
    free(xyz);
}

/* Points one by one from nothing to space, with repeats, shrunk after each. */
static void shrunk_between(void) {
    static const double xyz[] = {0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 0, 0, 0,   1, 0,
                                 3, 4, 0, 0, 1, 0, 2, 5, 7, 1, 1, 1, 2, 5, 7, 0.5, 1, 2};
    mgdt_triangulation *t = make(0, NULL), *expected = make(12, xyz);
    int k;
    for (k = 0; k < 12; ++k) {
        CHECK_EQUAL(mgdt_insert_points(t, 1, xyz + 3 * k), MGDT_OK);
        CHECK_EQUAL(mgdt_shrink(t), MGDT_OK);
        CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    }
    CHECK_EQUAL(mgdt_vertex_count(t), 8);
    CHECK(same_tetrahedra(t, expected, NULL));
    mgdt_destroy(t);
    mgdt_destroy(expected);
}

/* Storage grows generously where it may, and by what is needed where a limit is near. */
static void near_the_limit(void) {
    const int64_t n = is_small() ? 10000 : 100000;
    double* xyz = random_points(n + 1, 0, 11);
    mgdt_triangulation* t = make(n, xyz);
    double bytes = 0;
    CHECK_EQUAL(mgdt_get_stat(t, MGDT_STAT_MEMORY_BYTES, &bytes), MGDT_OK);
#if defined(__linux__)
    CHECK_EQUAL(mgdt_set_memory_limit(t, (int64_t)bytes + 1500000), MGDT_OK);
#else /* a block that grows is copied, and for a moment there are two */
    CHECK_EQUAL(mgdt_set_memory_limit(t, (int64_t)(2 * bytes)), MGDT_OK);
#endif
    CHECK_EQUAL(mgdt_insert_points(t, 1, xyz + 3 * n), MGDT_OK);
    CHECK_EQUAL(mgdt_vertex_count(t), n + 1);
    mgdt_destroy(t);
    free(xyz);
}

void test_memory(void) {
    double* xyz = scenario();
    mgdt_triangulation* expected = make(point_count, xyz);
    int32_t s, scheme = 0;
    for (s = 0; s < (is_small() ? 1 : INT32_MAX); ++s) {
        if (mgdt_order_scheme_at(s, &scheme) != MGDT_OK) break;
        every_allocation(scheme, xyz, expected);
    }
    exports(xyz);
    limits();
    below_what_is_held();
    accounting(xyz);
    shrunk();
    shrunk_after_refusals();
    shrunk_between();
    mgdt_destroy(expected);
    free(xyz);
    near_the_limit();
}
