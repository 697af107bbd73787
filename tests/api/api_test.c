/* SPDX-License-Identifier: MIT
 * The C interface from plain C99: every function, every error path. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

static int passed, failed;

int check_that(int condition, const char* what, const char* file, int line) {
    if (condition) {
        ++passed;
    } else {
        ++failed;
        fprintf(stderr, "%s:%d: failed: %s\n", file, line, what);
    }
    return condition;
}

int check_equal(int64_t a, int64_t b, const char* what, const char* file, int line) {
    if (a != b)
        fprintf(stderr, "%s:%d: %lld is not %lld\n", file, line, (long long)a, (long long)b);
    return check_that(a == b, what, file, line);
}

int check_error(const mgdt_triangulation* t, const char* text, const char* file, int line) {
    char message[256] = "";
    const int found = mgdt_get_error(t, (int64_t)sizeof message, message) == MGDT_OK &&
                      strstr(message, text) != NULL;
    if (!found)
        fprintf(stderr, "%s:%d: no \"%s\" in the message \"%s\"\n", file, line, text, message);
    return check_that(found, "the message", file, line);
}

double random_double(uint64_t* state) { /* splitmix64 */
    uint64_t z = (*state += UINT64_C(0x9E3779B97F4A7C15));
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    z ^= z >> 31;
    return (double)(z >> 11) * (1.0 / 9007199254740992.0);
}

double* random_points(int64_t n, int grid, uint64_t seed) {
    double* xyz = malloc((size_t)(3 * n + 1) * sizeof *xyz);
    int64_t i;
    if (xyz == NULL) abort();
    for (i = 0; i < 3 * n; ++i) {
        const double u = random_double(&seed);
        xyz[i] = grid == 0 ? u : (double)(int64_t)(u * grid) / grid;
    }
    return xyz;
}

mgdt_triangulation* make(int64_t n, const double* xyz) {
    mgdt_triangulation* t = NULL;
    if (!CHECK_EQUAL(mgdt_create(&t), MGDT_OK)) return NULL;
    if (CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK)) return t;
    mgdt_destroy(t);
    return NULL;
}

int64_t* get_array(get_fn get, const mgdt_triangulation* t, int64_t size) {
    int64_t* v = malloc((size_t)(size + 1) * sizeof *v);
    if (v == NULL) abort();
    if (CHECK_EQUAL(get(t, size, v), MGDT_OK)) return v;
    free(v);
    return NULL;
}

static int compare_indices(const void* a, const void* b) {
    const int64_t x = *(const int64_t*)a, y = *(const int64_t*)b;
    return (x > y) - (x < y);
}

static int compare_quadruples(const void* a, const void* b) {
    int k;
    for (k = 0; k < 4; ++k) {
        const int c = compare_indices((const int64_t*)a + k, (const int64_t*)b + k);
        if (c != 0) return c;
    }
    return 0;
}

void sort_tetrahedra(int64_t* v, int64_t count) {
    int64_t i;
    for (i = 0; i < count; ++i) qsort(v + 4 * i, 4, sizeof *v, compare_indices);
    qsort(v, (size_t)count, 4 * sizeof *v, compare_quadruples);
}

/* Sorted, each vertex as the least of `names`' points at the place of origin[vertex]. */
static int64_t* renamed(const mgdt_triangulation* t, const mgdt_triangulation* names,
                        const int64_t* origin) {
    const int64_t count = mgdt_tetrahedron_count(t), n = mgdt_point_count(names);
    int64_t *v = get_array(mgdt_get_tetrahedra, t, 4 * count),
            *map = get_array(mgdt_get_point_map, names, n), i;
    if (v == NULL || map == NULL) abort();
    for (i = 0; i < 4 * count; ++i) v[i] = map[origin != NULL ? origin[v[i]] : v[i] % n];
    sort_tetrahedra(v, count);
    free(map);
    return v;
}

int same_tetrahedra(const mgdt_triangulation* t, const mgdt_triangulation* expected,
                    const int64_t* origin) {
    const int64_t count = mgdt_tetrahedron_count(t);
    int64_t *a, *b;
    int same;
    if (count != mgdt_tetrahedron_count(expected)) return 0;
    a = renamed(t, expected, origin);
    b = renamed(expected, expected, NULL);
    same = memcmp(a, b, (size_t)(4 * count) * sizeof *a) == 0;
    free(a);
    free(b);
    return same;
}

double volume(const double* a, const double* b, const double* c, const double* d) {
    double u[3], v[3], w[3];
    int k;
    for (k = 0; k < 3; ++k) {
        u[k] = b[k] - a[k];
        v[k] = c[k] - a[k];
        w[k] = d[k] - a[k];
    }
    return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
           (u[0] * v[1] - u[1] * v[0]) * w[2];
}

int main(void) {
    static const struct {
        const char* name;
        void (*run)(void);
    } groups[] = {{"text", test_text},
                  {"arguments", test_arguments},
                  {"settings", test_settings},
                  {"insertion", test_insertion},
                  {"export", test_export},
                  {"queries", test_queries},
                  {"changes", test_changes},
                  {"cells", test_cells},
                  {"dual", test_dual},
                  {"interpolation", test_interpolation},
                  {"memory", test_memory},
                  {"parts", test_parts},
                  {"progress", test_progress},
                  {"long calls", test_long_calls},
                  {"environment", test_environment},
                  {"isa", test_isa},
                  {"compact", test_compact},
                  {"busy", test_busy},
                  {"voronoi", test_voronoi},
                  {"cleaning", test_cleaning},
                  {"domain", test_domain},
                  {"domain_limits", test_domain_limits},
                  {"mesh", test_mesh},
                  {"given mesh", test_given_mesh},
                  {"improvement", test_improvement},
                  {"refinement", test_refinement},
                  {"periodic", test_periodic},
                  {"periodic_limits", test_periodic_limits}};
    size_t g;
    for (g = 0; g < sizeof groups / sizeof groups[0]; ++g) {
        const int passed_before = passed, failed_before = failed;
        groups[g].run();
        printf("%-14s %6d passed, %d failed\n", groups[g].name, passed - passed_before,
               failed - failed_before);
        fflush(stdout);
    }
    printf("%d passed, %d failed\n", passed, failed);
    return failed != 0 || passed == 0;
}
