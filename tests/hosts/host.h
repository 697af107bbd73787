/* SPDX-License-Identifier: MIT
 * What the hosts share. A host is a program that does something besides calling the library: it has
 * threads of its own, forks, unloads the library, has timers that interrupt it, or few resources.
 * Each ends with 0, or says what was not so and ends with 1. */
#ifndef MGDT_TESTS_HOSTS_HOST_H
#define MGDT_TESTS_HOSTS_HOST_H

#include <dirent.h>
#include <mgdt/mgdt.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define REQUIRE(condition)                                                                  \
    do {                                                                                    \
        if (!(condition)) {                                                                 \
            fprintf(stderr, "%s:%d: this is not so: %s\n", __FILE__, __LINE__, #condition); \
            _exit(1);                                                                       \
        }                                                                                   \
    } while (0)

/* Smaller sets, for Valgrind. */
static inline int is_small(void) {
    const char* value = getenv("MGDT_TEST_SMALL");
    return value != NULL && *value != '\0' && strcmp(value, "0") != 0;
}

/* Threads of the process, as the system counts them. */
static inline int thread_count(void) {
    DIR* const tasks = opendir("/proc/self/task");
    const struct dirent* entry;
    int count = 0;
    REQUIRE(tasks != NULL);
    while ((entry = readdir(tasks)) != NULL) count += entry->d_name[0] != '.';
    closedir(tasks);
    return count;
}

/* The functions of the library that hosts call, which may come from dlsym(). */
struct library {
    mgdt_status (*create)(mgdt_triangulation**);
    void (*destroy)(mgdt_triangulation*);
    mgdt_status (*set_threads)(mgdt_triangulation*, int32_t);
    mgdt_status (*set_canonical_output)(mgdt_triangulation*, int32_t);
    mgdt_status (*insert_points)(mgdt_triangulation*, int64_t, const double*);
    int64_t (*tetrahedron_count)(const mgdt_triangulation*);
    mgdt_status (*get_tetrahedra)(const mgdt_triangulation*, int64_t, int64_t*);
    mgdt_status (*locate_points)(const mgdt_triangulation*, int64_t, const double*, int64_t*,
                                 double*);
    mgdt_status (*get_stat)(const mgdt_triangulation*, int32_t, double*);
};

/* Points to triangulate and to locate. Enough of each for two threads; when small, to locate only.
 */
enum { point_count = 16384, small_point_count = 300, location_count = 8192 };

struct points {
    int64_t n;
    double *xyz, *queries;
};

static inline struct points make_points(int64_t n) {
    struct points p;
    uint64_t state = 1;
    int64_t i;
    p.n = is_small() ? small_point_count : n;
    p.xyz = malloc((size_t)(3 * p.n) * sizeof *p.xyz);
    p.queries = malloc(3 * location_count * sizeof *p.queries);
    REQUIRE(p.xyz != NULL && p.queries != NULL);
    for (i = 0; i < 3 * (p.n + location_count); ++i) {
        double u;
        state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
        u = (double)(state >> 11) / 9007199254740992.0;
        *(i < 3 * p.n ? p.xyz + i : p.queries + (i - 3 * p.n)) = u;
    }
    return p;
}

static inline void free_points(struct points p) {
    free(p.xyz);
    free(p.queries);
}

static inline uint64_t digest(uint64_t h, const int64_t* v, int64_t count) {
    int64_t i;
    for (i = 0; i < count; ++i) h = (h ^ (uint64_t)v[i]) * UINT64_C(0x100000001B3);
    return h;
}

/* Inserts the points into a handle that is empty or has them, and locates the others. Returns a
 * number that stands for all that came of it; *threads is how many inserted, 0 when small. */
static inline uint64_t fill_and_locate(const struct library* lib, mgdt_triangulation* t,
                                       struct points p, int* threads) {
    int64_t count;
    int64_t *v, *places = malloc(location_count * sizeof *places);
    double inserting = 0;
    uint64_t h;
    REQUIRE(places != NULL);
    REQUIRE(lib->insert_points(t, p.n, p.xyz) == MGDT_OK);
    REQUIRE(lib->get_stat(t, MGDT_STAT_THREADS, &inserting) == MGDT_OK);
    if (threads != NULL) *threads = is_small() ? 0 : (int)inserting;
    count = 4 * lib->tetrahedron_count(t);
    v = malloc((size_t)count * sizeof *v);
    REQUIRE(v != NULL && lib->get_tetrahedra(t, count, v) == MGDT_OK);
    REQUIRE(lib->locate_points(t, location_count, p.queries, places, NULL) == MGDT_OK);
    h = digest(digest(UINT64_C(0xCBF29CE484222325), v, count), places, location_count);
    free(v);
    free(places);
    return h;
}

/* The same with a handle of its own and so many threads. */
static inline uint64_t triangulate(const struct library* lib, struct points p, int32_t threads,
                                   int* inserting) {
    mgdt_triangulation* t = NULL;
    uint64_t h;
    REQUIRE(lib->create(&t) == MGDT_OK);
    REQUIRE(lib->set_threads(t, threads) == MGDT_OK);
    REQUIRE(lib->set_canonical_output(t, 1) == MGDT_OK);
    h = fill_and_locate(lib, t, p, inserting);
    lib->destroy(t);
    return h;
}

#endif
