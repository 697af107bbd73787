/* SPDX-License-Identifier: MIT
 * Canonical output is the same on every machine: hashes of it, of points that are the same on every
 * machine, as integers and single operations of IEEE arithmetic make them.
 *
 *   canonical_hashes [--write]   what they are here, for the table below */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mgdt/mgdt.h"

enum { N = 4000 };

static uint64_t state;
static uint64_t next_bits(void) { /* splitmix64 */
    uint64_t z = state += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
}
static double uniform(void) {
    return (double)(next_bits() >> 11) * (1.0 / 9007199254740992.0);
}

static void uniform_point(double* x, int i) {
    int k;
    (void)i;
    for (k = 0; k < 3; ++k) x[k] = uniform();
}
static void lattice_point(double* x, int i) {
    x[0] = i % 16;
    x[1] = i / 16 % 16;
    x[2] = i / 256;
}
static void repeated_point(double* x, int i) {
    int k;
    (void)i;
    for (k = 0; k < 3; ++k) x[k] = (double)(next_bits() % 12);
}
static void line_point(double* x, int i) {
    int k;
    const double t = uniform();
    (void)i;
    for (k = 0; k < 3; ++k) {
        const double noise = uniform() * 1e-6;
        x[k] = t + noise;
    }
}
static void cluster_point(double* x, int i) {
    int k;
    (void)i;
    for (k = 0; k < 3; ++k) {
        const double u = 2 * uniform() - 1, square = u * u, fourth = square * square;
        x[k] = u * fourth;
    }
}
/* On a paraboloid: no five of a hull's points are on one sphere for certain. */
static void surface_point(double* x, int i) {
    (void)i;
    x[0] = uniform();
    x[1] = uniform();
    {
        const double a = x[0] * x[0], b = x[1] * x[1];
        x[2] = a + b;
    }
}
static void tiny_point(double* x, int i) {
    int k;
    (void)i;
    for (k = 0; k < 3; ++k) x[k] = uniform() * 1e-150;
}
static void unequal_point(double* x, int i) {
    (void)i;
    x[0] = uniform() * 1e100;
    x[1] = uniform();
    x[2] = uniform() * 1e-100;
}

static const struct kind {
    const char* name;
    void (*point)(double* x, int i);
    uint64_t hash, changed; /* of all points; after a third is removed and a third has moved */
} kinds[] = {
    {"uniform", uniform_point, 0xADDAAB51E1CA536Du, 0x7532ADBA431E94F9u},
    {"lattice", lattice_point, 0xF39310DE42279D45u, 0xACC8F5F7E3DC60D0u},
    {"repeated", repeated_point, 0xF5B14EB2E203C739u, 0x32C120C80C2E7B40u},
    {"line", line_point, 0x909638C9D1F703FDu, 0xAFC9744C5BC394ACu},
    {"cluster", cluster_point, 0x91769DFE14B62B83u, 0x00028D915DA6EDBCu},
    {"surface", surface_point, 0xA7D013DA650A5E0Cu, 0x22EA67AE87DE59F2u},
    {"tiny", tiny_point, 0xADDAAB51E1CA536Du, 0x7532ADBA431E94F9u},
    {"unequal", unequal_point, 0x415C04C432591681u, 0x7D18BD175272ABC1u},
};

static uint64_t hash_of(mgdt_triangulation* t) {
    const int64_t n = 4 * mgdt_tetrahedron_count(t);
    int64_t* const v = malloc((size_t)(n + 1) * sizeof *v);
    uint64_t hash = 0xCBF29CE484222325u;
    int64_t i;
    if (v == NULL || mgdt_get_tetrahedra(t, n, v) != MGDT_OK) abort();
    for (i = 0; i < n; ++i) {
        int byte;
        for (byte = 0; byte < 8; ++byte)
            hash = (hash ^ ((uint64_t)v[i] >> 8 * byte & 0xFF)) * 0x100000001B3u;
    }
    free(v);
    return hash;
}

static void require(mgdt_status status) {
    if (status == MGDT_OK) return;
    printf("failed: %s\n", mgdt_status_string(status));
    exit(1);
}

static void hashes(const struct kind* kind, int32_t threads, uint64_t* whole, uint64_t* changed) {
    static double xyz[3 * N];
    static int64_t points[N];
    mgdt_triangulation* t = NULL;
    int i, third = N / 3;
    state = 1;
    for (i = 0; i < N; ++i) kind->point(xyz + 3 * i, i);
    require(mgdt_create(&t));
    require(mgdt_set_canonical_output(t, 1));
    require(mgdt_set_threads(t, threads));
    require(mgdt_insert_points(t, N, xyz));
    *whole = hash_of(t);
    for (i = 0; i < third; ++i) points[i] = 3 * i;
    require(mgdt_remove_points(t, third, points));
    for (i = 0; i < third; ++i) points[i] = 3 * i + 1;
    for (i = 0; i < third; ++i) kind->point(xyz + 3 * i, N - i);
    require(mgdt_move_points(t, third, points, xyz));
    *changed = hash_of(t);
    mgdt_destroy(t);
}

int main(int argc, char** argv) {
    const int writes = argc > 1 && strcmp(argv[1], "--write") == 0;
    int failures = 0, passes = 0;
    size_t i;
    int32_t threads;
    for (i = 0; i < sizeof kinds / sizeof *kinds; ++i)
        for (threads = 1; threads <= (writes ? 1 : 2); ++threads) {
            const struct kind* const k = kinds + i;
            uint64_t whole, changed;
            hashes(k, threads, &whole, &changed);
            if (writes) {
                printf("{\"%s\", %s_point, 0x%08lX%08lXu, 0x%08lX%08lXu},\n", k->name, k->name,
                       (unsigned long)(whole >> 32), (unsigned long)(whole & 0xFFFFFFFFu),
                       (unsigned long)(changed >> 32), (unsigned long)(changed & 0xFFFFFFFFu));
            } else if (whole == k->hash && changed == k->changed) {
                ++passes;
            } else {
                ++failures;
                printf("failed: %s, %d threads\n", k->name, (int)threads);
            }
        }
    if (!writes) printf("%d passed, %d failed\n", passes, failures);
    return failures == 0 ? 0 : 1;
}
