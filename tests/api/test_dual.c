/* SPDX-License-Identifier: MIT
 * The neighbours of vertices, and the circumspheres of tetrahedra. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

static const double canary = -7;

static mgdt_triangulation* triangulated(int64_t n, const double* xyz) {
    mgdt_triangulation* t = NULL;
    CHECK_EQUAL(mgdt_create(&t), MGDT_OK);
    CHECK_EQUAL(mgdt_set_canonical_output(t, 1), MGDT_OK);
    CHECK_EQUAL(mgdt_insert_points(t, n, xyz), MGDT_OK);
    return t;
}

/* An octahedron and its middle: four tetrahedra more than one cannot be told from the points, but
 * the neighbours of the middle are all, and opposite vertices are no neighbours. */
static void neighbors(void) {
    static const double xyz[24] = {1, 0, 0, -1, 0, 0,  0, 1, 0, 0, -1, 0,
                                   0, 0, 1, 0,  0, -1, 0, 0, 0, 1, 0,  0};
    static const int64_t expected[30] = {2, 3, 4, 5, 6, 2, 3, 4, 5, 6, 0, 1, 4, 5, 6,
                                         0, 1, 4, 5, 6, 0, 1, 2, 3, 6, 0, 1, 2, 3, 6};
    mgdt_triangulation* t = triangulated(8, xyz);
    int64_t offsets[10], list[37], k;
    int32_t offsets32[9], list32[36];
    int base;
    CHECK_EQUAL(mgdt_vertex_neighbors_count(t), 36);
    CHECK_EQUAL(mgdt_get_vertex_neighbors(t, 8, offsets, 36, list), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_get_vertex_neighbors(t, 9, offsets, 35, list), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(mgdt_get_vertex_neighbors(t, -1, offsets, 36, list), MGDT_ERR_INVALID_ARGUMENT);
    for (base = 0; base < 2; ++base) {
        CHECK_EQUAL(mgdt_set_index_base(t, base), MGDT_OK);
        CHECK_EQUAL(mgdt_get_vertex_neighbors(t, 9, offsets, 36, list), MGDT_OK);
        CHECK_EQUAL(mgdt_get_vertex_neighbors_i32(t, 9, offsets32, 36, list32), MGDT_OK);
        for (k = 0; k < 7; ++k) CHECK_EQUAL(offsets[k], 5 * k + base);
        CHECK_EQUAL(offsets[7], 36 + base);
        CHECK_EQUAL(offsets[8], 36 + base); /* the repeat has none */
        for (k = 0; k < 30; ++k) CHECK_EQUAL(list[k], expected[k] + base);
        for (k = 0; k < 6; ++k) CHECK_EQUAL(list[30 + k], k + base);
        for (k = 0; k < 36; ++k) CHECK_EQUAL(list32[k], list[k]);
        for (k = 0; k < 9; ++k) CHECK_EQUAL(offsets32[k], offsets[k]);
    }
    mgdt_destroy(t);
}

/* All tetrahedra of a cube have its middle, whatever the cube is scaled by. */
static void lattice(void) {
    static const double edges[4] = {1, 3, 0x1p-1070, 0x1p1000};
    int e;
    for (e = 0; e < 4; ++e) {
        double xyz[81], centers[300], squares[100];
        mgdt_triangulation* t;
        int64_t k, n;
        int i, exact = 1;
        for (i = 0; i < 81; ++i)
            xyz[i] = edges[e] * (i / 3 / (i % 3 == 0 ? 1 : i % 3 == 1 ? 3 : 9) % 3);
        t = triangulated(27, xyz);
        n = mgdt_tetrahedron_count(t);
        CHECK(n >= 40 && n <= 48);
        CHECK_EQUAL(mgdt_get_circumcenters(t, n, centers, squares), MGDT_OK);
        for (k = 0; k < n; ++k) {
            for (i = 0; i < 3; ++i)
                exact &=
                    centers[3 * k + i] == 0.5 * edges[e] || centers[3 * k + i] == 1.5 * edges[e];
            exact &= squares[k] == 0.75 * edges[e] * edges[e];
        }
        CHECK(exact);
        mgdt_destroy(t);
    }
}

/* The tetrahedra of a unit cube fill it; other measures have known values. */
static void measures(void) {
    static const double pi = 3.14159265358979323846;
    double xyz[24], x[12], sum = 0;
    int64_t k, n;
    mgdt_triangulation* t;
    for (k = 0; k < 24; ++k) xyz[k] = (double)(k / 3 >> k % 3 & 1);
    t = triangulated(8, xyz);
    n = mgdt_tetrahedron_count(t);
    CHECK(n >= 5 && n <= 6);
    CHECK_EQUAL(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_VOLUME, n, x), MGDT_OK);
    for (k = 0; k < n; ++k) sum += x[k];
    CHECK(fabs(sum - 1) < 1e-15);
    CHECK_EQUAL(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_LONGEST_EDGE, n, x), MGDT_OK);
    for (k = 0; k < n; ++k) CHECK(x[k] == sqrt(2) || x[k] == sqrt(3));
    CHECK_EQUAL(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_LARGEST_DIHEDRAL_ANGLE, n, x),
                MGDT_OK);
    for (k = 0; k < n; ++k)
        CHECK(fabs(x[k] - pi / 2) < 1e-15 || fabs(x[k] - acos(1.0 / 3)) < 1e-15 ||
              fabs(x[k] - acos(-sqrt(1.0 / 3))) < 1e-15);
    CHECK_EQUAL(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE, n, x),
                MGDT_OK);
    for (k = 0; k < n; ++k) CHECK(x[k] > 0.61 && x[k] < 1.24);
    CHECK_EQUAL(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_RADIUS_RATIO, n, x), MGDT_OK);
    for (k = 0; k < n; ++k) CHECK(x[k] > 0.5 && x[k] < 1 + 1e-15);
    x[n - 1] = canary;
    CHECK_EQUAL(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_VOLUME, n - 1, x),
                MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_ERROR(t, "needed");
    CHECK(x[n - 1] == canary);
    CHECK_EQUAL(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_VOLUME, -1, x),
                MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(mgdt_get_tetrahedron_measures(t, 11, n, x), MGDT_ERR_UNKNOWN_KEY);
    CHECK_ERROR(t, "there is no measure 11 of tetrahedra");
    mgdt_destroy(t);
}

/* One element too few touches nothing, enough writes that many and not one more; vertices are on
 * their sphere. */
static void arrays(void) {
    double xyz[300], *centers, *squares;
    int64_t *v, n, k;
    mgdt_triangulation* t;
    int i, good = 1;
    uint64_t state = 5;
    for (i = 0; i < 300; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        xyz[i] = (double)(state >> 11) * 0x1p-53;
    }
    t = triangulated(100, xyz);
    n = mgdt_tetrahedron_count(t);
    centers = malloc((size_t)(3 * n + 1) * sizeof *centers);
    squares = malloc((size_t)(n + 1) * sizeof *squares);
    v = malloc((size_t)(4 * n) * sizeof *v);
    if (!centers || !squares || !v) abort();
    for (k = 0; k <= 3 * n; ++k) centers[k] = canary;
    for (k = 0; k <= n; ++k) squares[k] = canary;
    CHECK_EQUAL(mgdt_get_circumcenters(t, n - 1, centers, squares), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_ERROR(t, "have room for");
    CHECK_EQUAL(mgdt_get_circumcenters(t, -1, centers, squares), MGDT_ERR_INVALID_ARGUMENT);
    for (k = 0; k < 3 * n; ++k) good &= centers[k] == canary;
    CHECK(good);
    CHECK_EQUAL(mgdt_get_circumcenters(t, n, centers, NULL), MGDT_OK);
    CHECK(squares[0] == canary && centers[0] != canary);
    CHECK_EQUAL(mgdt_get_circumcenters(t, n + 1, centers, squares), MGDT_OK);
    CHECK(squares[n] == canary && centers[3 * n] == canary);
    CHECK_EQUAL(mgdt_get_tetrahedra(t, 4 * n, v), MGDT_OK);
    for (k = 0; k < 4 * n; ++k) {
        double square = 0;
        for (i = 0; i < 3; ++i) {
            const double d = xyz[3 * v[k] + i] - centers[3 * (k / 4) + i];
            square += d * d;
        }
        good &= fabs(square - squares[k / 4]) <= 1e-9 * (1 + squares[k / 4]);
    }
    CHECK(good);
    free(v);
    free(squares);
    free(centers);
    mgdt_destroy(t);
}

typedef mgdt_status (*graph)(const mgdt_triangulation*, int64_t, int64_t*, int64_t*);
typedef mgdt_status (*graph32)(const mgdt_triangulation*, int64_t, int32_t*, int32_t*);

/* A tetrahedron whose longest edge has the others' ends inside its diametral sphere, and a repeat.
 */
static void one_graph(graph get, graph32 get32, int64_t size, const int64_t* expected) {
    static const double xyz[15] = {-5, 0, 0, 5, 0, 0, 0, 1, 0, 0, 0, 2, 5, 0, 0};
    mgdt_triangulation* t = triangulated(5, xyz);
    int64_t v[13], count = -7, k;
    int32_t v32[13], count32 = -7;
    int base;
    for (k = 0; k < 13; ++k) v[k] = v32[k] = -7;
    CHECK_EQUAL(get(t, -1, v, &count), MGDT_ERR_INVALID_ARGUMENT);
    CHECK_EQUAL(count, -7);
    CHECK_EQUAL(get(t, 2 * size - 1, v, &count), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK_EQUAL(get32(t, 2 * size - 1, v32, &count32), MGDT_ERR_BUFFER_TOO_SMALL);
    CHECK(count == size && count32 == size && v[0] == -7 && v32[0] == -7);
    for (base = 0; base < 2; ++base) {
        CHECK_EQUAL(mgdt_set_index_base(t, base), MGDT_OK);
        CHECK_EQUAL(get(t, 12, v, &count), MGDT_OK);
        CHECK_EQUAL(get32(t, 2 * size, v32, &count32), MGDT_OK);
        for (k = 0; k < 2 * size; ++k) CHECK_EQUAL(v[k], expected[k] + base);
        for (k = 0; k < 2 * size; ++k) CHECK_EQUAL(v32[k], v[k]);
        CHECK(v[2 * size] == -7 && v32[2 * size] == -7 && count == size && count32 == size);
    }
    mgdt_destroy(t);
}

static void graphs(void) {
    static const int64_t gabriel[10] = {0, 2, 0, 3, 1, 2, 1, 3, 2, 3}, tree[6] = {0, 2, 1, 2, 2, 3};
    one_graph(mgdt_get_gabriel_edges, mgdt_get_gabriel_edges_i32, 5, gabriel);
    one_graph(mgdt_get_spanning_tree, mgdt_get_spanning_tree_i32, 3, tree);
}

void test_dual(void) {
    neighbors();
    graphs();
    lattice();
    measures();
    arrays();
}
