/* SPDX-License-Identifier: MIT
 * The floating-point environment: hosts come with subnormals flushed, with another rounding mode
 * or with traps armed, get the same result, and find their environment as they left it. */
#define _GNU_SOURCE
#include <fenv.h>
#include <stdio.h>
#include <stdlib.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "check.h"

/* Points that need all of it: random ones, a lattice, and subnormals. */
static double* mixed_points(int64_t n) {
    double *xyz = random_points(n, 0, 61), *lattice = random_points(n, 6, 62);
    int64_t i;
    for (i = 0; i < 3 * n; ++i)
        if (i / 3 % 3 == 1)
            xyz[i] = lattice[i];
        else if (i / 3 % 3 == 2)
            xyz[i] = lattice[i] * 6 * 4.9406564584124654e-324;
    free(lattice);
    return xyz;
}

/* Everything that computes, in the caller's environment. */
static void run(int64_t n, const double* xyz, const mgdt_triangulation* expected) {
    const double q[3] = {0.4, 0.3, 0.2};
    mgdt_triangulation* t = make(n, xyz);
    int64_t tetrahedron = -1, vertex = -1, expected_vertex = -2;
    double weights[4];
    CHECK(same_tetrahedra(t, expected, NULL));
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    CHECK_EQUAL(mgdt_locate_points(t, 1, q, &tetrahedron, weights), MGDT_OK);
    CHECK(tetrahedron >= 0);
    CHECK_EQUAL(mgdt_nearest_vertex(t, q, &vertex), MGDT_OK);
    CHECK_EQUAL(mgdt_nearest_vertex(expected, q, &expected_vertex), MGDT_OK);
    CHECK_EQUAL(vertex, expected_vertex);
    mgdt_destroy(t);
}

static void rounding_modes(int64_t n, const double* xyz, const mgdt_triangulation* expected) {
    static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    size_t k;
    for (k = 0; k < sizeof modes / sizeof modes[0]; ++k) {
        int mode;
        fesetround(modes[k]);
        run(n, xyz, expected);
        mode = fegetround();
        fesetround(FE_TONEAREST);
        CHECK_EQUAL(mode, modes[k]);
    }
}

/* Flags that were clear stay clear and flags that were raised stay raised. */
static void flags(int64_t n, const double* xyz) {
    mgdt_triangulation* t = NULL;
    int raised, before;
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    feclearexcept(FE_ALL_EXCEPT);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    raised = fetestexcept(FE_ALL_EXCEPT);
    CHECK_EQUAL(raised, 0);
    CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    raised = fetestexcept(FE_ALL_EXCEPT);
    CHECK_EQUAL(raised, 0);
    feraiseexcept(FE_DIVBYZERO);
    before = fetestexcept(FE_ALL_EXCEPT); /* an emulator may not have the flags */
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    raised = fetestexcept(FE_ALL_EXCEPT);
    CHECK_EQUAL(raised, before);
    feclearexcept(FE_ALL_EXCEPT);
    mgdt_destroy(t);
}

#if defined(__SSE2__)
static void flush_to_zero(int64_t n, const double* xyz, const mgdt_triangulation* expected) {
    enum { ftz = 0x8000, daz = 0x0040 };
    const unsigned before = _mm_getcsr();
    unsigned set, after;
    _mm_setcsr(before | ftz | daz);
    set = _mm_getcsr(); /* an emulator may not have the bits */
    run(n, xyz, expected);
    after = _mm_getcsr();
    _mm_setcsr(before);
    CHECK_EQUAL(after & (ftz | daz), set & (ftz | daz));
    CHECK_EQUAL(after & 0x7f80, set & 0x7f80); /* masks and rounding */
}
#endif

#if defined(__GLIBC__)
static void traps(int64_t n, const double* xyz, const mgdt_triangulation* expected) {
    const int armed = FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW | FE_INEXACT;
    mgdt_triangulation* t = NULL;
    mgdt_status inserted, checked;
    int before, after;
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(armed);
    before = fegetexcept();
    inserted = mgdt_insert_points(t, n, xyz); /* no code of this test computes in between */
    checked = mgdt_check(t, MGDT_CHECK_CANONICAL);
    after = fegetexcept();
    fedisableexcept(FE_ALL_EXCEPT);
    CHECK_EQUAL(inserted, MGDT_OK);
    CHECK_EQUAL(checked, MGDT_OK);
    CHECK_EQUAL(after, before);
    CHECK(same_tetrahedra(t, expected, NULL));
    mgdt_destroy(t);
}
#endif

void test_environment(void) {
    const int64_t n = is_small() ? 60 : 600;
    double* xyz = mixed_points(n);
    mgdt_triangulation* expected = make(n, xyz);
    rounding_modes(n, xyz, expected);
    flags(n, xyz);
#if defined(__SSE2__)
    flush_to_zero(n, xyz, expected);
#endif
#if defined(__GLIBC__)
    traps(n, xyz, expected);
#endif
    mgdt_destroy(expected);
    free(xyz);
}
