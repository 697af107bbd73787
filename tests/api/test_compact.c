/* SPDX-License-Identifier: MIT
 * Compact storage: the same arrays, locations and nearest vertices with and without spheres beside
 * the tetrahedra, whenever the one is changed into the other; and the memory that it is for. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum { batches = 4, queries = 50 };

/* Points given in batches; a plan says how they are stored: before the first batch, between
 * batches, and after the last. Settings that no result may depend on. */
typedef struct {
    int32_t compact[batches + 1];
    int32_t threads;
    int32_t scheme;
    const char* isa; /* NULL for the best */
} plan;

static const plan with_spheres = {{0, 0, 0, 0, 0}, 1, MGDT_ORDER_AUTO, NULL};

/* Everything that can be asked of the points, canonical. */
typedef struct {
    int64_t size;
    int64_t* v; /* counts, arrays, located and nearest */
    double weights[4 * queries];
} answers;

static void append(answers* a, int64_t size, const int64_t* v) {
    a->v = realloc(a->v, (size_t)(a->size + size + 1) * sizeof *v);
    if (a->v == NULL) abort();
    if (size > 0) memcpy(a->v + a->size, v, (size_t)size * sizeof *v);
    a->size += size;
}

static void append_array(answers* a, get_fn get, const mgdt_triangulation* t, int64_t size) {
    int64_t* v = get_array(get, t, size);
    if (v == NULL) abort();
    append(a, size, v);
    free(v);
}

/* One in four a point that was given; others between two of them or in the box of all, where by
 * their random coordinates they are on no facet. */
static void query_points(int64_t n, const double* xyz, double* q) {
    uint64_t seed = 7;
    double least[3], most[3];
    int64_t i;
    int k, axis;
    for (axis = 0; axis < 3; ++axis) {
        least[axis] = most[axis] = xyz[axis];
        for (i = 1; i < n; ++i) {
            least[axis] = fmin(least[axis], xyz[3 * i + axis]);
            most[axis] = fmax(most[axis], xyz[3 * i + axis]);
        }
    }
    for (k = 0; k < queries; ++k) {
        const double* p = xyz + 3 * ((int64_t)(random_double(&seed) * (double)n) % n);
        const double* r = xyz + 3 * ((int64_t)(random_double(&seed) * (double)n) % n);
        if (k % 2 == 1 || p[0] == r[0] || p[1] == r[1] || p[2] == r[2]) {
            if (k % 4 != 0) {
                p = least;
                r = most;
            }
        }
        for (axis = 0; axis < 3; ++axis) {
            const double u = random_double(&seed);
            q[3 * k + axis] = k % 4 == 0 ? p[axis] : p[axis] * u + r[axis] * (1 - u);
        }
    }
}

static answers ask(mgdt_triangulation* t, int64_t n, const double* xyz) {
    answers a;
    int64_t counts[6], found[queries], one = 0, size;
    double q[3 * queries];
    int k;
    memset(&a, 0, sizeof a);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    CHECK_EQUAL(mgdt_set_canonical_output(t, 1), MGDT_OK);
    size = 4 * mgdt_tetrahedron_count(t);
    counts[0] = mgdt_point_count(t);
    counts[1] = mgdt_vertex_count(t);
    counts[2] = mgdt_dimension(t);
    counts[3] = size;
    counts[4] = 3 * mgdt_hull_facet_count(t);
    counts[5] = 2 * mgdt_edge_count(t);
    append(&a, 6, counts);
    append_array(&a, mgdt_get_tetrahedra, t, size);
    append_array(&a, mgdt_get_neighbors, t, size);
    append_array(&a, mgdt_get_hull_facets, t, counts[4]);
    append_array(&a, mgdt_get_edges, t, counts[5]);
    append_array(&a, mgdt_get_point_map, t, counts[0]);
    query_points(n, xyz, q);
    CHECK_EQUAL(mgdt_locate_points(t, queries, q, found, a.weights), MGDT_OK);
    for (k = 0; k < queries; ++k) {
        CHECK_EQUAL(mgdt_locate(t, q + 3 * k, &one), MGDT_OK);
        if (k % 4 != 0) { /* a vertex is in several tetrahedra; any of them will do */
            append(&a, 1, &found[k]);
            append(&a, 1, &one);
        } else {
            int i;
            for (i = 0; i < 4; ++i) a.weights[4 * k + i] = 0;
            one = (one >= 0) + 2 * (found[k] >= 0);
            append(&a, 1, &one);
        }
        CHECK_EQUAL(mgdt_nearest_vertex(t, q + 3 * k, &one), MGDT_OK);
        append(&a, 1, &one);
    }
    return a;
}

/* By the plan; NULL where the processor does not have the instruction set. */
static mgdt_triangulation* make_by(const plan* p, int64_t n, const double* xyz) {
    mgdt_triangulation* t = NULL;
    int b;
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK_EQUAL(mgdt_set_threads(t, p->threads), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_scheme(t, p->scheme), MGDT_OK);
    if (mgdt_set_isa(t, p->isa) != MGDT_OK) {
        CHECK(strcmp(p->isa, "baseline") != 0);
        mgdt_destroy(t);
        return NULL;
    }
    for (b = 0; b <= batches; ++b) {
        /* The first batch of few points, the second spans space where any do, unequal others. */
        static const int part[batches + 1] = {0, 1, 10, 50, 100};
        const int64_t begin = n * part[b] / 100, end = b < batches ? n * part[b + 1] / 100 : n;
        CHECK_EQUAL(mgdt_set_compact(t, p->compact[b]), MGDT_OK);
        if (b > 0) CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
        CHECK_EQUAL(mgdt_insert_points(t, end - begin, xyz + 3 * begin), MGDT_OK);
    }
    return t;
}

static void expect_same(const plan* p, int64_t n, const double* xyz, const answers* expected) {
    mgdt_triangulation* t = make_by(p, n, xyz);
    answers a;
    int k;
    if (t == NULL) return;
    a = ask(t, n, xyz);
    if (CHECK_EQUAL(a.size, expected->size))
        CHECK(memcmp(a.v, expected->v, (size_t)a.size * sizeof *a.v) == 0);
    /* Rounded in the order of storage, which threads and schemes change, and compactness does not.
     */
    if (p->threads == 1 && p->scheme == with_spheres.scheme)
        CHECK(memcmp(a.weights, expected->weights, sizeof a.weights) == 0);
    free(a.v);
    /* And what was made one way is the same when it has become the other, there and back. */
    for (k = 0; k < 2; ++k) {
        CHECK_EQUAL(mgdt_set_compact(t, p->compact[batches] == k), MGDT_OK);
        a = ask(t, n, xyz);
        if (CHECK_EQUAL(a.size, expected->size))
            CHECK(memcmp(a.v, expected->v, (size_t)a.size * sizeof *a.v) == 0);
        free(a.v);
    }
    mgdt_destroy(t);
}

/* ------------------------------------------------------------------------------------ the sets */

static double* uniform(int64_t n) {
    return random_points(n, 0, 31);
}
static double* lattice(int64_t n) {
    return random_points(n, 8, 32);
}
static double* repeats(int64_t n) {
    return random_points(n, 4, 33);
}

/* A hub in the middle of a sphere: cavities and stars of hundreds of tetrahedra. */
static double* shell(int64_t n) {
    double* xyz = random_points(n, 0, 34);
    int64_t i;
    int k;
    for (i = 0; i < n; ++i) {
        double* p = xyz + 3 * i;
        double square = 0, scale;
        for (k = 0; k < 3; ++k) {
            p[k] -= 0.5;
            square += p[k] * p[k];
        }
        scale = i == n - 1 ? 0 : 1 / sqrt(square + 1e-30);
        for (k = 0; k < 3; ++k) p[k] *= scale;
    }
    return xyz;
}

/* A line, then a plane, then space. */
static double* rising(int64_t n) {
    double* xyz = random_points(n, 16, 35);
    int64_t i;
    for (i = 0; i < n / 2; ++i) {
        xyz[3 * i + 2] = 0.5;
        if (i < n / 20) xyz[3 * i + 1] = 0.25;
    }
    return xyz;
}

/* Never space: a plane, a line, one point again and again. */
static double* plane(int64_t n) {
    double* xyz = random_points(n, 0, 36);
    int64_t i;
    for (i = 0; i < n; ++i) xyz[3 * i + 2] = 1.5;
    return xyz;
}
static double* line(int64_t n) {
    double* xyz = plane(n);
    int64_t i;
    for (i = 0; i < n; ++i) xyz[3 * i + 1] = -2;
    return xyz;
}
static double* place(int64_t n) {
    double* xyz = line(n);
    int64_t i;
    for (i = 0; i < n; ++i) xyz[3 * i] = 3;
    return xyz;
}

/* Numbers of which the filter can say nothing, some of them beside ordinary ones; the last change
 * the scale of all that were there. */
static double* mixed(int64_t n) {
    double* xyz = random_points(n, 0, 37);
    int64_t i;
    for (i = 0; i < 3 * n; ++i) {
        if (i % 5 == 1) xyz[i] *= 1e-300;
        if (i % 7 == 2 && i > 3 * n / 2) xyz[i] *= 1e300;
    }
    return xyz;
}
static double* tiny(int64_t n) {
    double* xyz = random_points(n, 0, 38);
    int64_t i;
    for (i = 0; i < 3 * n; ++i) xyz[i] *= 1e-300;
    return xyz;
}
static double* huge(int64_t n) {
    double* xyz = random_points(n, 0, 39);
    int64_t i;
    for (i = 0; i < 3 * n; ++i) xyz[i] *= 1e300;
    return xyz;
}
/* Of ordinary size to one batch's end, then larger and larger. */
static double* growing(int64_t n) {
    double* xyz = random_points(n, 0, 40);
    int64_t i;
    for (i = 0; i < 3 * n; ++i) xyz[i] *= i < 3 * n / 2 ? 1 : 1e60;
    return xyz;
}

static void same_by_every_plan(int64_t n, const double* xyz) {
    static const plan plans[] = {{{1, 1, 1, 1, 1}, 1, MGDT_ORDER_AUTO, NULL},
                                 {{1, 0, 1, 0, 1}, 1, MGDT_ORDER_AUTO, NULL},
                                 {{0, 1, 0, 1, 0}, 1, MGDT_ORDER_AUTO, NULL},
                                 {{0, 0, 1, 1, 0}, 1, MGDT_ORDER_BRIO, NULL},
                                 {{1, 1, 0, 0, 1}, 1, MGDT_ORDER_INPUT, NULL},
                                 {{1, 1, 1, 1, 1}, 1, MGDT_ORDER_AUTO, "baseline"},
                                 {{1, 1, 1, 1, 1}, 1, MGDT_ORDER_AUTO, "avx2"},
                                 {{1, 1, 1, 1, 1}, 1, MGDT_ORDER_AUTO, "avx512"},
                                 {{1, 1, 1, 1, 1}, 1, MGDT_ORDER_AUTO, "neon"},
                                 {{0, 1, 0, 1, 0}, 1, MGDT_ORDER_AUTO, "baseline"},
                                 {{0, 1, 0, 1, 0}, 1, MGDT_ORDER_AUTO, "avx2"},
                                 {{0, 1, 0, 1, 0}, 1, MGDT_ORDER_AUTO, "avx512"},
                                 {{0, 1, 0, 1, 0}, 1, MGDT_ORDER_AUTO, "neon"}};
    mgdt_triangulation* t = make_by(&with_spheres, n, xyz);
    answers expected = ask(t, n, xyz);
    size_t k;
    mgdt_destroy(t);
    for (k = 0; k < sizeof plans / sizeof plans[0]; k += is_small() ? 2 : 1)
        expect_same(&plans[k], n, xyz, &expected);
    free(expected.v);
}

static void sets(void) {
    static const struct {
        double* (*make)(int64_t n);
        int64_t n, small;
    } all[] = {{uniform, 3000, 300}, {lattice, 1500, 200}, {repeats, 800, 200}, {shell, 1000, 100},
               {rising, 1200, 200},  {plane, 300, 100},    {line, 200, 50},     {place, 100, 50},
               {mixed, 60, 40},      {tiny, 500, 100},     {huge, 500, 100},    {growing, 200, 60}};
    size_t s;
    for (s = 0; s < sizeof all / sizeof all[0]; ++s) {
        const int64_t n = is_small() ? all[s].small : all[s].n;
        double* xyz = all[s].make(n);
        same_by_every_plan(n, xyz);
        free(xyz);
    }
}

/* ---------------------------------------------------------------------------------- several
 * threads */

static void threads(void) {
    static const plan plans[] = {{{1, 1, 1, 1, 1}, 3, MGDT_ORDER_AUTO, NULL},
                                 {{0, 1, 0, 1, 0}, 2, MGDT_ORDER_AUTO, NULL},
                                 {{1, 0, 1, 0, 1}, 4, MGDT_ORDER_HILBERT, NULL}};
    /* The last batch has half of the points, and a thread takes no fewer than 8192. */
    const int64_t n = 40000;
    double* xyz = random_points(n, 0, 41);
    mgdt_triangulation* t = make_by(&with_spheres, n, xyz);
    answers expected = ask(t, n, xyz);
    double used = 0;
    size_t k;
    mgdt_destroy(t);
    t = make_by(&plans[0], n, xyz);
    CHECK_EQUAL(mgdt_get_stat(t, MGDT_STAT_THREADS, &used), MGDT_OK);
    CHECK(used > 1);
    mgdt_destroy(t);
    for (k = 0; k < sizeof plans / sizeof plans[0]; ++k) expect_same(&plans[k], n, xyz, &expected);
    free(expected.v);
    free(xyz);
}

/* -------------------------------------------------------------------------------------- memory */

static double memory_of(const mgdt_triangulation* t) {
    double value = -1;
    CHECK_EQUAL(mgdt_get_stat(t, MGDT_STAT_MEMORY_BYTES, &value), MGDT_OK);
    return value;
}

static mgdt_triangulation* of_one_call(int32_t compact, int64_t n, const double* xyz) {
    mgdt_triangulation* t = NULL;
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK_EQUAL(mgdt_set_compact(t, compact), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    return t;
}

static void memory(void) {
    const int64_t n = is_small() ? 10000 : 100000;
    const double points = (double)n;
    double* xyz = random_points(n, 0, 42);
    mgdt_triangulation *kept = of_one_call(0, n, xyz), *compact = of_one_call(1, n, xyz);
    const double before = memory_of(kept), small = memory_of(compact);
    double after, numbers;
    int64_t limit;
    printf("  bytes a point: %.0f, compact %.0f\n", before / points, small / points);
    CHECK(small < 300 * points);
    CHECK(before > small + 100 * points);
    /* After the fact. */
    CHECK_EQUAL(mgdt_set_compact(kept, 1), MGDT_OK);
    after = memory_of(kept);
    CHECK(after <= before - 100 * points);
    CHECK(after < 300 * points);
    CHECK_EQUAL(mgdt_set_compact(kept, 1), MGDT_OK);
    CHECK(memory_of(kept) == after);
    CHECK(same_tetrahedra(kept, compact, NULL));
    numbers = memory_of(kept) - after; /* those of tetrahedra, which exports keep */
    after += numbers;

    /* No room for spheres: nothing has changed, whatever the room is short of. */
    for (limit = 1; limit < (int64_t)before; limit = limit * 2 + 1000000) {
        CHECK_EQUAL(mgdt_set_memory_limit(kept, limit), MGDT_OK);
        if (mgdt_set_compact(kept, 0) == MGDT_OK) break;
        CHECK_EQUAL(mgdt_set_compact(kept, 0), MGDT_ERR_OUT_OF_MEMORY);
        CHECK_ERROR(kept, "memory");
        CHECK(memory_of(kept) == after); /* still compact */
    }
    CHECK(limit > (int64_t)after); /* some limits refused that had room for what there was */
    CHECK_EQUAL(mgdt_set_memory_limit(kept, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_check(kept, MGDT_CHECK_CANONICAL), MGDT_OK);
    CHECK_EQUAL(mgdt_set_compact(kept, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_memory_limit(kept, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_compact(kept, 0), MGDT_ERR_OUT_OF_MEMORY);
    CHECK_EQUAL(mgdt_set_memory_limit(kept, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(kept, 0, NULL), MGDT_OK);
    CHECK(same_tetrahedra(kept, compact, NULL));
    CHECK_EQUAL(mgdt_set_compact(kept, 0), MGDT_OK);
    CHECK(memory_of(kept) > after + 100 * points);
    CHECK(memory_of(kept) == before + numbers);
    CHECK(same_tetrahedra(kept, compact, NULL));

    /* Under a limit that is too small for spheres, all points get in without. */
    CHECK_EQUAL(mgdt_clear(compact), MGDT_OK);
    mgdt_destroy(compact);
    limit = (int64_t)(0.85 * before);
    CHECK_EQUAL(mgdt_create(&compact), MGDT_OK);
    CHECK_EQUAL(mgdt_set_memory_limit(compact, limit), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(compact, n, xyz), MGDT_ERR_OUT_OF_MEMORY);
    CHECK_EQUAL(mgdt_clear(compact), MGDT_OK);
    CHECK_EQUAL(mgdt_set_compact(compact, 1), MGDT_OK);
#if !defined(__linux__) /* a block that grows is copied, and for a moment there are two */
    CHECK_EQUAL(mgdt_set_memory_limit(compact, 2 * limit), MGDT_OK);
#endif
    CHECK_EQUAL(mgdt_insert_points(compact, n, xyz), MGDT_OK);
    CHECK(same_tetrahedra(kept, compact, NULL));
    mgdt_destroy(compact);
    mgdt_destroy(kept);
    free(xyz);
}

/* A setting: an empty handle has it, clearing leaves it, storage that was announced is of its kind,
 * and wrong values change nothing. */
static void setting(void) {
    static const int32_t wrong[] = {2, -1, 256, INT32_MAX, INT32_MIN};
    const int64_t n = 2000;
    double* xyz = random_points(n, 0, 43);
    mgdt_triangulation *t = NULL, *expected = make(n, xyz);
    double held;
    size_t k;
    CHECK_EQUAL(mgdt_set_compact(NULL, 1), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_set_compact(NULL, 2), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK_EQUAL(mgdt_set_compact(t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_reserve(t, n), MGDT_OK);
    held = memory_of(t);
    CHECK(held < 400.0 * (double)n);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    for (k = 0; k < sizeof wrong / sizeof wrong[0]; ++k) {
        held = memory_of(t);
        CHECK_EQUAL(mgdt_set_compact(t, wrong[k]), MGDT_ERR_INVALID_ARGUMENT);
        CHECK_ERROR(t, "compact storage");
        CHECK(memory_of(t) == held);
    }
    CHECK(same_tetrahedra(t, expected, NULL));
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    CHECK(same_tetrahedra(t, expected, NULL));
    held = memory_of(t);
    CHECK_EQUAL(mgdt_set_compact(t, 0), MGDT_OK);
    CHECK(memory_of(t) > held); /* it was still compact */
    CHECK(same_tetrahedra(t, expected, NULL));
    /* What was announced stays announced in either storage. */
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK_EQUAL(mgdt_reserve(t, n), MGDT_OK);
    CHECK_EQUAL(mgdt_set_compact(t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_compact(t, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    CHECK(same_tetrahedra(t, expected, NULL));
    mgdt_destroy(t);
    mgdt_destroy(expected);
    free(xyz);
}

static int64_t* all_numbers(const mgdt_triangulation* t, int64_t count, const double* q) {
    int64_t* const v = malloc((size_t)(8 * count + queries) * sizeof *v);
    int k;
    if (v == NULL) abort();
    CHECK_EQUAL(mgdt_get_tetrahedra(t, 4 * count, v), MGDT_OK);
    CHECK_EQUAL(mgdt_get_neighbors(t, 4 * count, v + 4 * count), MGDT_OK);
    CHECK_EQUAL(mgdt_locate_points(t, queries, q, v + 8 * count, NULL), MGDT_OK);
    for (k = 0; k < queries; k += 4) v[8 * count + k] = 0; /* a vertex is in several */
    return v;
}

/* Numbers of tetrahedra hold while storage changes, whether or not output is canonical: the arrays
 * are the same, byte for byte. */
static void numbers(void) {
    const int64_t n = is_small() ? 500 : 5000;
    double *xyz = random_points(n, 20, 44), q[3 * queries];
    int canonical, threads, step;
    query_points(n, xyz, q);
    for (canonical = 0; canonical < 2; ++canonical)
        for (threads = 1; threads < 3; ++threads)
            for (step = 0; step < 4; ++step) {
                mgdt_triangulation* t = NULL;
                int64_t count, *before, *after;
                /* Begins in either storage, with numbers that were made before or were not. */
                const int32_t compact = step % 2;
                CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
                CHECK_EQUAL(mgdt_set_threads(t, threads), MGDT_OK);
                CHECK_EQUAL(mgdt_set_canonical_output(t, canonical), MGDT_OK);
                CHECK_EQUAL(mgdt_set_compact(t, compact), MGDT_OK);
                CHECK_EQUAL(mgdt_insert_points(t, n / 2, xyz), MGDT_OK);
                CHECK_EQUAL(mgdt_insert_points(t, n - n / 2, xyz + 3 * (n / 2)), MGDT_OK);
                if (step / 2 == 1) CHECK_EQUAL(mgdt_set_compact(t, !compact), MGDT_OK);
                count = mgdt_tetrahedron_count(t);
                before = all_numbers(t, count, q);
                CHECK_EQUAL(mgdt_set_compact(t, step / 2 == 1 ? compact : !compact), MGDT_OK);
                after = all_numbers(t, count, q);
                CHECK(memcmp(before, after, (size_t)(8 * count + queries) * sizeof *after) == 0);
                free(after);
                CHECK_EQUAL(mgdt_set_compact(t, step / 2 == 1 ? !compact : compact), MGDT_OK);
                after = all_numbers(t, count, q);
                CHECK(memcmp(before, after, (size_t)(8 * count + queries) * sizeof *after) == 0);
                free(after);
                free(before);
                mgdt_destroy(t);
            }
    free(xyz);
}

void test_compact(void) {
    numbers();
    setting();
    sets();
    if (!is_small()) threads(); /* those of zones_test and threads_test need fewer points */
    memory();
}
