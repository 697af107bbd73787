/* SPDX-License-Identifier: MIT
 * A lattice of tetrahedra as a mesh, and what tests of meshes ask of one. */
#ifndef MGDT_TESTS_GIVEN_LATTICE_H
#define MGDT_TESTS_GIVEN_LATTICE_H

#include <mgdt/mgdt_mesh.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"

enum {
    side = 4,
    n_points = (side + 1) * (side + 1) * (side + 1),
    n_tetrahedra = 6 * side * side * side
};

/* The cubes of a lattice, each divided into six tetrahedra. Inner points are moved, and the
 * orientations of tetrahedra differ. The upper half has the marker 7, the lower one -2. */
static double lattice_points[3 * n_points];
static int64_t lattice[4 * n_tetrahedra];
static int32_t lattice_markers[n_tetrahedra];

static inline void make_lattice(void) {
    static const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                     {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static const int steps[3] = {1, side + 1, (side + 1) * (side + 1)};
    uint64_t seed = 5;
    int i, k, t = 0;
    for (i = 0; i < n_points; ++i)
        for (k = 0; k < 3; ++k) {
            const int at = i / steps[k] % (side + 1);
            const int is_inner = at > 0 && at < side && (k < 2 || at != side / 2);
            const double move = .4 * (random_double(&seed) - .5);
            lattice_points[3 * i + k] = at + (is_inner ? move : 0);
        }
    for (i = 0; i < n_points; ++i) {
        if (i % steps[1] == side || i / steps[1] % (side + 1) == side || i / steps[2] == side)
            continue;
        for (k = 0; k < 6; ++k, ++t) {
            const int first = i + steps[orders[k][0]], second = first + steps[orders[k][1]];
            lattice[4 * t] = i;
            lattice[4 * t + 1] = first;
            lattice[4 * t + 2] = second;
            lattice[4 * t + 3] = second + steps[orders[k][2]];
            lattice_markers[t] = i / steps[2] < side / 2 ? -2 : 7;
        }
    }
}

static inline mgdt_mesh* mesh_of(int64_t points, const double* xyz, int64_t tetrahedra,
                                 const int64_t* corners, const int32_t* markers) {
    mgdt_mesh* m = NULL;
    CHECK_EQUAL(mgdt_mesh_create(&m), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_points(m, points, xyz), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_set_tetrahedra(m, tetrahedra, corners, markers), MGDT_OK);
    CHECK_EQUAL(mgdt_mesh_build(m), MGDT_OK);
    return m;
}

static inline mgdt_mesh* lattice_mesh(void) {
    return mesh_of(n_points, lattice_points, n_tetrahedra, lattice, lattice_markers);
}

static inline int64_t stat_of(const mgdt_mesh* m, int32_t key) {
    int64_t value = -1;
    CHECK_EQUAL(mgdt_mesh_get_stat(m, key, &value), MGDT_OK);
    return value;
}

static inline int64_t size_of(const mgdt_mesh* m, int32_t array) {
    int64_t size = -1;
    CHECK_EQUAL(mgdt_mesh_get_size(m, array, &size), MGDT_OK);
    return size;
}

static inline int64_t* array_of(const mgdt_mesh* m, int32_t key) {
    const int64_t size = size_of(m, key);
    int64_t* const values = malloc((size_t)(size + 1) * sizeof *values);
    CHECK_EQUAL(mgdt_mesh_get_array(m, key, size, values), MGDT_OK);
    return values;
}

static inline double* doubles_of(const mgdt_mesh* m, int32_t key) {
    const int64_t size = size_of(m, key);
    double* const values = malloc((size_t)(size + 1) * sizeof *values);
    CHECK_EQUAL(mgdt_mesh_get_doubles(m, key, size, values), MGDT_OK);
    return values;
}

static inline int check_message(const mgdt_mesh* m, const char* text) {
    char message[256] = "";
    CHECK_EQUAL(mgdt_mesh_get_error(m, sizeof message, message), MGDT_OK);
    if (strstr(message, text) == NULL) printf("the message is: %s\n", message);
    return CHECK(strstr(message, text) != NULL);
}

static inline void set(mgdt_mesh* m, int32_t option, int64_t value) {
    CHECK_EQUAL(mgdt_mesh_set_option(m, option, value), MGDT_OK);
}

/* Least dihedral angle in radians. */
static inline double least_angle(const mgdt_mesh* m) {
    const int64_t n = stat_of(m, MGDT_MESH_STAT_TETRAHEDRA);
    double* const x = malloc((size_t)n * sizeof *x);
    double least = 9;
    int64_t i;
    CHECK_EQUAL(mgdt_mesh_get_tetrahedron_measures(m, MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE, n, x),
                MGDT_OK);
    for (i = 0; i < n; ++i) least = x[i] < least ? x[i] : least;
    free(x);
    return least;
}

/* Whether two meshes have the same points, tetrahedra and faces, to the last bit. */
static inline int are_same(const mgdt_mesh* a, const mgdt_mesh* b) {
    static const int32_t keys[] = {MGDT_MESH_ARRAY_TETRAHEDRA, MGDT_MESH_ARRAY_NEIGHBORS,
                                   MGDT_MESH_ARRAY_FACES,      MGDT_MESH_ARRAY_FACE_MARKERS,
                                   MGDT_MESH_ARRAY_EDGES,      MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS,
                                   MGDT_MESH_ARRAY_REASONS,    MGDT_MESH_ARRAY_ANGLE_HISTOGRAM};
    double *x, *y;
    int same;
    size_t k;
    if (size_of(a, MGDT_MESH_ARRAY_POINTS) != size_of(b, MGDT_MESH_ARRAY_POINTS)) return 0;
    x = doubles_of(a, MGDT_MESH_ARRAY_POINTS);
    y = doubles_of(b, MGDT_MESH_ARRAY_POINTS);
    same = memcmp(x, y, (size_t)size_of(a, MGDT_MESH_ARRAY_POINTS) * sizeof *x) == 0;
    free(x);
    free(y);
    for (k = 0; k < sizeof keys / sizeof *keys && same; ++k) {
        const int64_t size = size_of(a, keys[k]);
        int64_t *v, *w;
        if (size != size_of(b, keys[k])) return 0;
        v = array_of(a, keys[k]);
        w = array_of(b, keys[k]);
        same = memcmp(v, w, (size_t)size * sizeof *v) == 0;
        free(v);
        free(w);
    }
    return same;
}

#endif
