/* SPDX-License-Identifier: MIT
 * The floating-point environment in every combination: subnormals flushed or taken for zero, traps
 * armed, rounding modes, the precision of the x87 unit. The results are the same to the byte, and
 * the registers come back as they were, flags included.
 *
 * Built twice: as usual, and with -ffast-math, which compiles this file by other rules and sets
 * flush-to-zero when the program is loaded. */
#define _GNU_SOURCE
#include <fenv.h>
#include <mgdt/mgdt.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "../support/small.h"

static int failures;

static void expect(int condition, const char* what, const char* where) {
    if (condition) return;
    ++failures;
    fprintf(stderr, "failed: %s (%s)\n", what, where);
}

/* ------------------------------------------------------------------------------- the registers */

typedef struct {
    uint64_t control, status, x87;
} registers;

static registers registers_now(void) {
    registers r = {0, 0, 0};
#if defined(__x86_64__)
    uint16_t control, status;
    __asm__ volatile("fnstcw %0" : "=m"(control));
    __asm__ volatile("fnstsw %0" : "=m"(status));
    r.control = _mm_getcsr();
    r.x87 = (uint64_t)control << 16 | status;
#elif defined(__aarch64__)
    __asm__ volatile("mrs %0, fpcr" : "=r"(r.control));
    __asm__ volatile("mrs %0, fpsr" : "=r"(r.status));
#else
    r.control = (uint64_t)fegetround();
    r.status = (uint64_t)fetestexcept(FE_ALL_EXCEPT);
#endif
    return r;
}

static int same_registers(const registers* a, const registers* b) {
    return a->control == b->control && a->status == b->status && a->x87 == b->x87;
}

/* One setting of all that can be set. */
typedef struct {
    int rounding, flush, traps, raised;
    unsigned precision; /* of the x87 unit: 0 single, 2 double, 3 extended */
} setting;

static void set(const setting* s) {
    fesetenv(FE_DFL_ENV);
    fesetround(s->rounding);
    /* Raised before traps are armed; underflow and inexact are what computing would raise. */
    if (s->raised != 0) feraiseexcept(s->raised);
#if defined(__x86_64__)
    {
        uint16_t control;
        __asm__ volatile("fnstcw %0" : "=m"(control));
        control = (uint16_t)((control & ~0x0300u) | s->precision << 8);
        __asm__ volatile("fldcw %0" : : "m"(control));
        if (s->flush) _mm_setcsr(_mm_getcsr() | 0x8040u);
        /* Not by feenableexcept(): raised flags would trap in the x87 unit at once. */
        if (s->traps) _mm_setcsr(_mm_getcsr() & ~0x1F80u);
    }
#elif defined(__aarch64__)
    if (s->flush) {
        uint64_t control;
        __asm__ volatile("mrs %0, fpcr" : "=r"(control));
        control |= UINT64_C(1) << 24;
        __asm__ volatile("msr fpcr, %0" : : "r"(control));
    }
#elif defined(__GLIBC__)
    if (s->traps) feenableexcept(FE_ALL_EXCEPT);
#endif
}

/* ---------------------------------------------------------------------------------- the points */

static uint64_t state = 1;

static uint64_t random_bits(void) { /* splitmix64 */
    uint64_t z = (state += UINT64_C(0x9E3779B97F4A7C15));
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

/* By their bits: this file may be compiled by rules under which subnormals are zero. Some in
 * [1, 2), some on a lattice in it, the sign at random, and every eighth subnormal. */
static void make_points(size_t n, double* xyz, int subnormals) {
    size_t i;
    for (i = 0; i < 3 * n; ++i) {
        const uint64_t r = random_bits(), sign = r << 63;
        uint64_t bits = sign | UINT64_C(1023) << 52;
        if (subnormals && i / 3 % 8 == 0)
            bits = sign | (r >> 40 & 7);
        else if (i / 3 % 2 == 0)
            bits |= r >> 12;
        else
            bits |= (r >> 12) & UINT64_C(0xC000000000000);
        memcpy(&xyz[i], &bits, sizeof bits);
    }
}

/* --------------------------------------------------------------------------------- the outcome */

enum { queries = 64 };

/* All that is computed, as bytes. */
typedef struct {
    size_t size;
    unsigned char* bytes;
} outcome;

static void append(outcome* o, const void* data, size_t size) {
    o->bytes = realloc(o->bytes, o->size + size);
    if (o->bytes == NULL) abort();
    memcpy(o->bytes + o->size, data, size);
    o->size += size;
}

/* Makes one call in the setting and compares the registers. */
#define IN(s, call)                                                  \
    do {                                                             \
        registers before, after;                                     \
        mgdt_status status;                                          \
        set(s);                                                      \
        before = registers_now();                                    \
        status = (call);                                             \
        after = registers_now();                                     \
        fesetenv(FE_DFL_ENV);                                        \
        expect(status == MGDT_OK, #call, "status");                  \
        expect(same_registers(&before, &after), #call, "registers"); \
    } while (0)

static outcome compute(const setting* s, int32_t threads, size_t n, const double* xyz,
                       const double* where) {
    outcome o = {0, NULL};
    mgdt_triangulation* t = NULL;
    int64_t size, found[queries], *v, *list;
    double weights[4 * queries];
    size_t half = n / 2;
    int k;
    IN(s, mgdt_create(&t));
    IN(s, mgdt_set_threads(t, threads));
    IN(s, mgdt_set_canonical_output(t, 1));
    IN(s, mgdt_set_order_parameter(t, MGDT_PARAMETER_ROUND_RATIO, 3.5));
    IN(s, mgdt_reserve(t, (int64_t)n));
    IN(s, mgdt_insert_points(t, (int64_t)half, xyz));
    IN(s, mgdt_insert_points_strided(t, (int64_t)(n - half), xyz + 3 * half, xyz + 3 * half + 1,
                                     xyz + 3 * half + 2, 3));
    size = 4 * mgdt_tetrahedron_count(t) + mgdt_point_count(t) + 1;
    v = malloc((size_t)size * sizeof *v);
    list = malloc((size_t)size * sizeof *list);
    if (v == NULL || list == NULL) abort();
#define GET(function, count)                \
    memset(v, 0, (size_t)size * sizeof *v); \
    IN(s, function(t, size, v));            \
    append(&o, v, (size_t)(count) * sizeof *v)
    GET(mgdt_get_tetrahedra, 4 * mgdt_tetrahedron_count(t));
    GET(mgdt_get_neighbors, 4 * mgdt_tetrahedron_count(t));
    GET(mgdt_get_hull_facets, 3 * mgdt_hull_facet_count(t));
    GET(mgdt_get_point_map, mgdt_point_count(t));
    IN(s, mgdt_get_edges(t, size, v));
    IN(s, mgdt_get_vertex_tetrahedra(t, size, v, size, list));
    append(&o, v, (n + 1) * sizeof *v);
    append(&o, list, (size_t)mgdt_vertex_tetrahedra_count(t) * sizeof *list);
    IN(s, mgdt_get_vertex_neighbors(t, size, v, size, list));
    append(&o, list, (size_t)mgdt_vertex_neighbors_count(t) * sizeof *list);
    IN(s, mgdt_locate_points(t, queries, where, found, weights));
    append(&o, found, sizeof found);
    append(&o, weights, sizeof weights);
    for (k = 0; k < queries; ++k) {
        IN(s, mgdt_locate(t, where + 3 * k, found + k));
        IN(s, mgdt_nearest_vertex(t, where + 3 * k, found));
        append(&o, found, sizeof *found);
    }
    IN(s, mgdt_check(t, MGDT_CHECK_CANONICAL));
    {
        double value = 0;
        registers before, after;
        IN(s, mgdt_get_stat(t, MGDT_STAT_WALK_STEPS, &value));
        IN(s, mgdt_clear(t));
        set(s);
        before = registers_now();
        mgdt_destroy(t);
        after = registers_now();
        fesetenv(FE_DFL_ENV);
        expect(same_registers(&before, &after), "mgdt_destroy", "registers");
    }
    free(v);
    free(list);
    return o;
}

static void every_setting(int32_t threads, size_t n, int subnormals, int few) {
    static const int roundings[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    static const unsigned precisions[] = {3, 0, 2};
    const setting usual = {FE_TONEAREST, 0, 0, 0, 3};
    double *xyz = malloc(3 * n * sizeof *xyz), *where = malloc(3 * queries * sizeof *where);
    outcome expected;
    int r, flush, traps, p, settings = 0;
    if (xyz == NULL || where == NULL) abort();
    make_points(n, xyz, subnormals);
    make_points(queries, where, subnormals);
    expected = compute(&usual, threads, n, xyz, where);
    expect(expected.size > n * 40, "there is an outcome", "size");
    for (r = 0; r < 4; ++r)
        for (flush = 0; flush < 2; ++flush)
            for (traps = 0; traps < 2; ++traps)
                for (p = 0; p < 3; ++p) {
                    /* Some flags are up before, others not. */
                    const setting s = {roundings[r], flush, traps,
                                       p == 0   ? 0
                                       : p == 1 ? FE_DIVBYZERO
                                                : FE_ALL_EXCEPT,
                                       precisions[p]};
                    outcome o;
                    char where_from[80];
                    if (few && (r + flush + traps + p) % 3 != 0) continue;
                    o = compute(&s, threads, n, xyz, where);
                    snprintf(where_from, sizeof where_from,
                             "%d threads: rounding %d, flush %d, traps %d, precision %u",
                             (int)threads, roundings[r], flush, traps, precisions[p]);
                    expect(o.size == expected.size && memcmp(o.bytes, expected.bytes, o.size) == 0,
                           "the same outcome", where_from);
                    free(o.bytes);
                    ++settings;
                }
    printf("%d threads, %d points: %d settings, %d bytes each\n", (int)threads, (int)n, settings,
           (int)expected.size);
    free(expected.bytes);
    free(xyz);
    free(where);
}

/* ----------------------------------------------------------------- callbacks that do not care */

static void wreck_environment(void) {
#if defined(__x86_64__)
    _mm_setcsr(0x1F80u | 0x8040u | _MM_ROUND_UP);
#else
    fesetround(FE_UPWARD);
#endif
}

static int32_t wreck(double fraction, void* user) {
    (void)fraction;
    (void)user;
    wreck_environment();
    return 0;
}

static void* wreck_and_take(size_t size, size_t align, void* user) {
    void* p = NULL;
    (void)user;
    wreck_environment();
    return posix_memalign(&p, align < sizeof p ? sizeof p : align, size) == 0 ? p : NULL;
}

static void wreck_and_give(void* p, size_t size, size_t align, void* user) {
    (void)size;
    (void)align;
    (void)user;
    free(p);
    wreck_environment();
}

/* What a callback does to the environment stays with the callback. */
static void callbacks(void) {
    enum { n = 3000 };
    static double xyz[3 * n];
    const setting usual = {FE_TONEAREST, 0, 0, 0, 3};
    mgdt_triangulation* t[2] = {NULL, NULL};
    int64_t size, *v[2];
    int k;
    make_points(n, xyz, 1);
    IN(&usual, mgdt_create(&t[0]));
    IN(&usual, mgdt_create_with_allocator(wreck_and_take, wreck_and_give, NULL, &t[1]));
    IN(&usual, mgdt_set_progress(t[1], wreck, NULL));
    for (k = 0; k < 2; ++k) {
        IN(&usual, mgdt_set_canonical_output(t[k], 1));
        IN(&usual, mgdt_insert_points(t[k], n, xyz));
    }
    size = 4 * mgdt_tetrahedron_count(t[0]);
    expect(size == 4 * mgdt_tetrahedron_count(t[1]), "as many tetrahedra", "callbacks");
    for (k = 0; k < 2; ++k) {
        v[k] = malloc((size_t)size * sizeof **v);
        if (v[k] == NULL) abort();
        IN(&usual, mgdt_get_tetrahedra(t[k], size, v[k]));
    }
    expect(memcmp(v[0], v[1], (size_t)size * sizeof **v) == 0, "the same outcome", "callbacks");
    IN(&usual, mgdt_check(t[1], MGDT_CHECK_CANONICAL));
    for (k = 0; k < 2; ++k) {
        mgdt_destroy(t[k]);
        free(v[k]);
    }
    fesetenv(FE_DFL_ENV);
}

int main(void) {
    const int few = is_small();
#if defined(__FAST_MATH__) && defined(__x86_64__)
    /* Else this program would test nothing that the usual one does not. */
    expect((_mm_getcsr() & 0x8040u) == 0x8040u, "-ffast-math has set flush-to-zero", "load");
    puts("with -ffast-math");
#endif
    every_setting(1, few ? 60 : 300, 1, few);
    /* A thread takes 8192 points. */
    if (!few) every_setting(2, 33000, 0, 1);
    callbacks();
    printf("%d failed\n", failures);
    return failures != 0;
}
