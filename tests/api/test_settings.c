/* SPDX-License-Identifier: MIT
 * Each setting is read back as it was set, and as its default before. */
#include <string.h>

#include "check.h"

static int32_t never(double fraction, void* user) {
    (void)fraction;
    (void)user;
    return 0;
}

/* What all getters give; a getter that fails is counted and leaves its -7. */
typedef struct {
    int32_t scheme, threads, base, compact, canonical;
    int64_t limit;
    uint64_t seed;
    double per_cell, threshold, separation, ratio;
    mgdt_progress_fn fn;
    void* user;
} seen;

static seen look(const mgdt_triangulation* t) {
    static int mark;
    seen s = {-7, -7, -7, -7, -7, -7, 7, -7, -7, -7, -7, NULL, NULL};
    s.fn = never;
    s.user = &mark;
    CHECK_EQUAL(mgdt_get_order_scheme(t, &s.scheme), MGDT_OK);
    CHECK_EQUAL(mgdt_get_threads(t, &s.threads), MGDT_OK);
    CHECK_EQUAL(mgdt_get_index_base(t, &s.base), MGDT_OK);
    CHECK_EQUAL(mgdt_get_compact(t, &s.compact), MGDT_OK);
    CHECK_EQUAL(mgdt_get_canonical_output(t, &s.canonical), MGDT_OK);
    CHECK_EQUAL(mgdt_get_memory_limit(t, &s.limit), MGDT_OK);
    CHECK_EQUAL(mgdt_get_seed(t, &s.seed), MGDT_OK);
    CHECK_EQUAL(mgdt_get_order_parameter(t, MGDT_PARAMETER_POINTS_PER_CELL, &s.per_cell), MGDT_OK);
    CHECK_EQUAL(mgdt_get_order_parameter(t, MGDT_PARAMETER_THRESHOLD, &s.threshold), MGDT_OK);
    CHECK_EQUAL(mgdt_get_order_parameter(t, MGDT_PARAMETER_SEPARATION, &s.separation), MGDT_OK);
    CHECK_EQUAL(mgdt_get_order_parameter(t, MGDT_PARAMETER_ROUND_RATIO, &s.ratio), MGDT_OK);
    CHECK_EQUAL(mgdt_get_progress(t, &s.fn, &s.user), MGDT_OK);
    return s;
}

static void expect_defaults(const mgdt_triangulation* t) {
    const seen s = look(t);
    CHECK_EQUAL(s.scheme, MGDT_ORDER_AUTO);
    CHECK_EQUAL(s.threads, 1);
    CHECK_EQUAL(s.base, 0);
    CHECK_EQUAL(s.compact, 0);
    CHECK_EQUAL(s.canonical, 0);
    CHECK_EQUAL(s.limit, 0);
    CHECK(s.seed == 0);
    CHECK(s.per_cell == 0 && s.threshold == 0 && s.ratio == 7.5);
    CHECK(s.separation == MGDT_SEPARATION_ROUNDS);
    CHECK(s.fn == NULL && s.user == NULL);
}

static void expect_set(const mgdt_triangulation* t, void* user) {
    const seen s = look(t);
    CHECK_EQUAL(s.scheme, MGDT_ORDER_KD_TREE);
    CHECK_EQUAL(s.threads, 300);
    CHECK_EQUAL(s.base, 1);
    CHECK_EQUAL(s.compact, 1);
    CHECK_EQUAL(s.canonical, 1);
    /* Where there is no such memory, it is all that there is. */
    CHECK_EQUAL(s.limit, SIZE_MAX < UINT64_C(1) << 40 ? (int64_t)SIZE_MAX : INT64_C(1) << 40);
    CHECK(s.seed == UINT64_MAX);
    CHECK(s.per_cell == 12.5 && s.threshold == 99 && s.ratio == 3);
    CHECK(s.separation == MGDT_SEPARATION_PASSES);
    CHECK(s.fn == never && s.user == user);
}

static void set(mgdt_triangulation* t, void* user) {
    CHECK_EQUAL(mgdt_set_order_scheme(t, MGDT_ORDER_KD_TREE), MGDT_OK);
    CHECK_EQUAL(mgdt_set_threads(t, 300), MGDT_OK);
    CHECK_EQUAL(mgdt_set_index_base(t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_compact(t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_canonical_output(t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_set_memory_limit(t, INT64_C(1) << 40), MGDT_OK);
    CHECK_EQUAL(mgdt_set_seed(t, UINT64_MAX), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_POINTS_PER_CELL, 12.5), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_THRESHOLD, 99), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_SEPARATION, MGDT_SEPARATION_PASSES),
                MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_ROUND_RATIO, 3), MGDT_OK);
    CHECK_EQUAL(mgdt_set_progress(t, never, user), MGDT_OK);
}

/* Settings that are refused, whose getters go on to say what they said. */
static void refuse(mgdt_triangulation* t) {
    CHECK(mgdt_set_order_scheme(t, 1) != MGDT_OK);
    CHECK(mgdt_set_threads(t, -1) != MGDT_OK);
    CHECK(mgdt_set_index_base(t, 2) != MGDT_OK);
    CHECK(mgdt_set_compact(t, 2) != MGDT_OK);
    CHECK_EQUAL(mgdt_set_read_progress(t, 2), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_set_read_progress(NULL, 1), MGDT_ERR_NULL_POINTER);
    CHECK(mgdt_set_canonical_output(t, 2) != MGDT_OK);
    CHECK(mgdt_set_memory_limit(t, -1) != MGDT_OK);
    CHECK(mgdt_set_order_parameter(t, MGDT_PARAMETER_POINTS_PER_CELL, -1) != MGDT_OK);
    CHECK(mgdt_set_order_parameter(t, MGDT_PARAMETER_SEPARATION, 3) != MGDT_OK);
}

static void bad_calls(const mgdt_triangulation* t) {
    double d = -7;
    int32_t i = -7;
    int64_t n = -7;
    uint64_t u = 7;
    mgdt_progress_fn fn = never;
    void* user = &d;
    CHECK_EQUAL(mgdt_get_order_parameter(t, 11, &d), MGDT_ERR_UNKNOWN_KEY);
    CHECK_ERROR(t, "11");
    CHECK_EQUAL(mgdt_get_order_scheme(t, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_threads(t, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_index_base(t, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_compact(t, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_read_progress(t, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_canonical_output(t, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_memory_limit(t, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_seed(t, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_order_parameter(t, MGDT_PARAMETER_THRESHOLD, NULL), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_progress(t, NULL, &user), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_progress(t, &fn, NULL), MGDT_OK);
    CHECK(fn == NULL);
    fn = never;
    CHECK_EQUAL(mgdt_get_order_scheme(NULL, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_threads(NULL, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_index_base(NULL, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_compact(NULL, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_read_progress(NULL, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_canonical_output(NULL, &i), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_memory_limit(NULL, &n), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_seed(NULL, &u), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_order_parameter(NULL, MGDT_PARAMETER_THRESHOLD, &d),
                MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_get_progress(NULL, &fn, &user), MGDT_ERR_NULL_POINTER);
    CHECK(d == -7 && i == -7 && n == -7 && u == 7 && fn == never && user == &d);
}

void test_settings(void) {
    mgdt_triangulation* t = make(0, NULL);
    int mark = 0;
    expect_defaults(t);
    bad_calls(t);
    expect_defaults(t);
    set(t, &mark);
    expect_set(t, &mark);
    refuse(t);
    expect_set(t, &mark);
    /* They stay when the points go. */
    CHECK_EQUAL(mgdt_clear(t), MGDT_OK);
    CHECK_EQUAL(mgdt_shrink(t), MGDT_OK);
    expect_set(t, &mark);
    /* 0 gives a default back. */
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_POINTS_PER_CELL, 0), MGDT_OK);
    CHECK_EQUAL(mgdt_set_order_parameter(t, MGDT_PARAMETER_ROUND_RATIO, 0), MGDT_OK);
    CHECK(look(t).per_cell == 0 && look(t).ratio == 7.5);
    mgdt_destroy(t);
}
