/* SPDX-License-Identifier: MIT
 * Instruction sets: the same arrays from each. */
#include <stdlib.h>
#include <string.h>

#include "check.h"

static const char* const sets[] = {"baseline", "avx2", "avx512", "neon"};

/* Canonical tetrahedra and neighbours by one instruction set, in two batches; NULL where the
 * processor does not have it. */
static int64_t* arrays_by(const char* isa, int64_t n, const double* xyz, int64_t* count) {
    mgdt_triangulation* t = NULL;
    int64_t* v = NULL;
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    if (mgdt_set_isa(t, isa) == MGDT_OK) {
        CHECK(strcmp(mgdt_isa_name(t), isa) == 0);
        CHECK_EQUAL(mgdt_set_canonical_output(t, 1), MGDT_OK);
        CHECK_EQUAL(mgdt_insert_points(t, n / 2, xyz), MGDT_OK);
        CHECK_EQUAL(mgdt_insert_points(t, n - n / 2, xyz + 3 * (n / 2)), MGDT_OK);
        CHECK_EQUAL(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
        *count = 8 * mgdt_tetrahedron_count(t);
        v = malloc((size_t)(*count + 1) * sizeof *v);
        if (v == NULL) abort();
        CHECK_EQUAL(mgdt_get_tetrahedra(t, *count / 2, v), MGDT_OK);
        CHECK_EQUAL(mgdt_get_neighbors(t, *count / 2, v + *count / 2), MGDT_OK);
    } else {
        CHECK(strcmp(isa, "baseline") != 0);
    }
    mgdt_destroy(t);
    return v;
}

static void same_arrays(int64_t n, const double* xyz) {
    int64_t expected_count = 0, count = 0;
    int64_t* expected = arrays_by(sets[0], n, xyz, &expected_count);
    size_t i;
    for (i = 1; i < sizeof sets / sizeof sets[0]; ++i) {
        int64_t* v = arrays_by(sets[i], n, xyz, &count);
        if (v == NULL) continue;
        CHECK_EQUAL(count, expected_count);
        CHECK(memcmp(v, expected, (size_t)expected_count * sizeof *v) == 0);
        free(v);
    }
    free(expected);
}

void test_isa(void) {
    static const double scales[] = {1, 1e-290, 1e300};
    mgdt_triangulation* t = NULL;
    size_t s;
    int64_t i, n = is_small() ? 500 : 5000;
    for (s = 0; s < 3; ++s) {
        double* uniform = random_points(n, 0, 1);
        double* lattice = random_points(n, 12, 2);
        double* shell = random_points(n, 0, 3); /* large cavities: a hub in a sphere's middle */
        for (i = 0; i < n; ++i) {
            double* p = shell + 3 * i;
            const double x = p[0] - 0.5, y = p[1] - 0.5, z = p[2] - 0.5;
            const double d = (x < 0 ? -x : x) + (y < 0 ? -y : y) + (z < 0 ? -z : z) + 1e-3;
            p[0] = x / d;
            p[1] = y / d;
            p[2] = i == n - 1 ? 0.01 : z / d;
        }
        for (i = 0; i < 3 * n; ++i) {
            uniform[i] *= scales[s];
            lattice[i] *= scales[s];
            shell[i] *= scales[s];
        }
        same_arrays(n, uniform);
        same_arrays(n, lattice);
        same_arrays(n, shell);
        free(uniform);
        free(lattice);
        free(shell);
    }
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK_EQUAL(mgdt_set_isa(NULL, "baseline"), MGDT_ERR_NULL_POINTER);
    CHECK_EQUAL(mgdt_set_isa(t, "sse5"), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_ERROR(t, "sse5");
    CHECK_EQUAL(mgdt_set_isa(t, NULL), MGDT_OK);
    mgdt_destroy(t);
}
