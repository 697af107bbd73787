/* SPDX-License-Identifier: MIT
 * One triangulation of points on all ranks, against that of one handle, and what all ranks say
 * where one has failed. */
#include <math.h>
#include <mgdt/mgdt_mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../support/small.h"

static int rank, ranks, failures;

static int check_that(int condition, const char* what, int line) {
    if (!condition) {
        fprintf(stderr, "rank %d of %d, line %d: failed: %s\n", rank, ranks, line, what);
        ++failures;
    }
    return condition;
}
#define CHECK(condition) check_that((condition) ? 1 : 0, #condition, __LINE__)

static uint64_t mixed(uint64_t z) { /* splitmix64 */
    z += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
}

static double uniform(int64_t i) {
    return (double)(mixed((uint64_t)i) >> 11) * (1.0 / 9007199254740992.0);
}

static void* room(int64_t n, size_t size) {
    void* const p = malloc((size_t)(n > 0 ? n : 1) * size);
    if (p == NULL) abort();
    return p;
}

/* The sets of points; each rank knows all of them. */
enum { CUBE, LATTICE, SPHERE, SPIRAL, TWO_LINES, REPEATS, EXTREMES, FLAT, LINE, FEW, SETS };

static int64_t size_of(int set) {
    return set == FEW ? 5 : set == TWO_LINES || is_small() ? 200 : 3000;
}

static double* points_of(int set) {
    const int64_t n = size_of(set);
    const double sizes[] = {1e-300, 1e-100, 1, 1e100, 1e300};
    double* xyz = room(3 * n, sizeof *xyz);
    int64_t i;
    for (i = 0; i < n; ++i) {
        double *x = xyz + 3 * i, length = 0;
        int k;
        for (k = 0; k < 3; ++k) x[k] = uniform(3 * i + k);
        switch (set) {
            case LATTICE:
                for (k = 0; k < 3; ++k) x[k] = floor(16 * x[k]);
                break;
            case SPHERE:
                for (k = 0; k < 3; ++k) x[k] -= 0.5, length += x[k] * x[k];
                for (k = 0; k < 3; ++k) x[k] /= sqrt(length);
                break;
            case SPIRAL:
                x[1] = x[0] * cos(25 * x[0]) + 1e-4 * x[1];
                x[2] = x[0] * sin(25 * x[0]) + 1e-4 * x[2];
                break;
            case TWO_LINES:
                x[1] = i % 2 == 0 ? 0 : x[0];
                x[2] = i % 2 == 0 ? 0 : 1;
                if (i % 2 != 0) x[0] = 0;
                break;
            case REPEATS:
                for (k = 0; k < 3; ++k) x[k] = uniform(3 * (i % 50) + k);
                break;
            case EXTREMES:
                for (k = 0; k < 3; ++k) x[k] = (x[k] - 0.5) * sizes[(i + k) % 5];
                break;
            case FLAT:
                x[2] = 0.25;
                break;
            case LINE:
                x[1] = x[2] = x[0];
                break;
            default:
                break;
        }
    }
    return xyz;
}

static int compare(const void* a, const void* b) {
    const int64_t x = *(const int64_t*)a, y = *(const int64_t*)b;
    return (x > y) - (x < y);
}

/* Of a set of tetrahedra, whatever their order: a sum. */
static uint64_t hash_of(int64_t* v, int64_t count) {
    uint64_t sum = (uint64_t)count;
    int64_t i;
    for (i = 0; i < count; ++i) {
        uint64_t hash = 0;
        int k;
        qsort(v + 4 * i, 4, sizeof *v, compare);
        for (k = 0; k < 4; ++k) hash = mixed(hash ^ (uint64_t)v[4 * i + k]);
        sum += hash;
    }
    return sum;
}

static uint64_t hash_of_one(int64_t n, const double* xyz) {
    mgdt_triangulation* t;
    int64_t count, i, *v, *map;
    uint64_t hash;
    CHECK(mgdt_create(&t) == MGDT_OK);
    CHECK(mgdt_insert_points(t, n, xyz) == MGDT_OK);
    count = mgdt_tetrahedron_count(t);
    v = room(4 * count, sizeof *v);
    CHECK(mgdt_get_tetrahedra(t, 4 * count, v) == MGDT_OK);
    map = room(n, sizeof *map);
    CHECK(mgdt_get_point_map(t, n, map) == MGDT_OK);
    for (i = 0; i < 4 * count; ++i) v[i] = map[v[i]];
    hash = hash_of(v, count);
    free(v);
    free(map);
    mgdt_destroy(t);
    return hash;
}

static int64_t stat(const mgdt_parts* m, int32_t key) {
    int64_t value = -1;
    CHECK(mgdt_parts_get_stat(m, MGDT_PARTS_THIS_PART, key, &value) == MGDT_OK);
    return value;
}

static int64_t* array(const mgdt_parts* m, int32_t which) {
    int64_t n = 0, *v;
    CHECK(mgdt_parts_get_size(m, MGDT_PARTS_THIS_PART, which, &n) == MGDT_OK);
    v = room(n, sizeof *v);
    CHECK(mgdt_parts_get_array(m, MGDT_PARTS_THIS_PART, which, n, v) == MGDT_OK);
    return v;
}

/* Of the tetrahedra that all ranks own, by the ids of their corners. */
static uint64_t hash_of_all(const mgdt_parts* m) {
    const int64_t owned = stat(m, MGDT_PARTS_OWN_TETRAHEDRA);
    int64_t *corners = array(m, MGDT_PARTS_LOCAL_CORNERS), *ids = array(m, MGDT_PARTS_VERTEX_IDS),
            i;
    uint64_t hash;
    for (i = 0; i < 4 * owned; ++i) corners[i] = ids[corners[i]];
    hash = hash_of(corners, owned);
    free(corners);
    free(ids);
    MPI_Allreduce(MPI_IN_PLACE, &hash, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
    return hash;
}

/* Where this rank's points begin: evenly; all on the last rank; none on rank 0. */
static int64_t share(int64_t n, int way, int r) {
    if (way == 1) return r < ranks ? 0 : n;
    if (way == 2 && ranks > 1) return r < 1 ? 0 : n * (r - 1) / (ranks - 1);
    return n * r / ranks;
}

static mgdt_parts* make(void) {
    mgdt_parts* m = NULL;
    if (!CHECK(mgdt_mpi_create(MPI_COMM_WORLD, &m) == MGDT_OK)) MPI_Abort(MPI_COMM_WORLD, 1);
    return m;
}

static void has_the_tetrahedra_of_one(void) {
    int set, way;
    for (set = 0; set < SETS; ++set) {
        const int64_t n = size_of(set);
        double* xyz = points_of(set);
        const uint64_t expected = hash_of_one(n, xyz);
        int64_t *ids = room(n, sizeof *ids), i;
        for (i = 0; i < n; ++i) ids[i] = i;
        /* With more ranks than processors a build takes its time: one way for each set. */
        for (way = is_small() ? set % 3 : 0; way < (is_small() ? set % 3 + 1 : 3); ++way) {
            const int64_t first = share(n, way, rank), last = share(n, way, rank + 1);
            mgdt_parts* m = make();
            int64_t most, sum;
            CHECK(mgdt_parts_insert_points(m, MGDT_PARTS_THIS_PART, last - first, xyz + 3 * first,
                                           way == 0 ? NULL : ids + first) == MGDT_OK);
            CHECK(mgdt_parts_build(m) == MGDT_OK);
            CHECK(hash_of_all(m) == expected);
            CHECK(mgdt_parts_check(m, MGDT_CHECK_CANONICAL) == MGDT_OK);
            /* Each has its share. */
            most = sum = stat(m, MGDT_PARTS_OWN_VERTICES);
            MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_INT64_T, MPI_MAX, MPI_COMM_WORLD);
            MPI_Allreduce(MPI_IN_PLACE, &sum, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
            CHECK(sum == stat(m, MGDT_PARTS_ALL_VERTICES));
            if (set == CUBE) CHECK((double)most <= 1.01 * (double)sum / ranks + 2);
            mgdt_parts_destroy(m);
        }
        free(ids);
        free(xyz);
    }
}

/* What all ranks have for each of the numbers in their ranges: `width` of a type of 8 bytes. */
static void gather(const void* mine, void* all, int width, MPI_Datatype type,
                   const int64_t* ranges) {
    int *counts = room(ranks, sizeof *counts), *places = room(ranks, sizeof *places), r;
    for (r = 0; r < ranks; ++r) {
        counts[r] = (int)(width * (ranges[r + 1] - ranges[r]));
        places[r] = (int)(width * ranges[r]);
    }
    MPI_Allgatherv(mine, counts[rank], type, all, counts, places, type, MPI_COMM_WORLD);
    free(counts);
    free(places);
}

/* Coordinates of the ghosts are those of the vertices with their numbers; a round of messages asks
 * their owners. */
static void has_the_ghosts_of_others(void) {
    const int64_t n = size_of(CUBE);
    double *xyz = points_of(CUBE), *mine, *all;
    const int64_t first = share(n, 0, rank), last = share(n, 0, rank + 1);
    mgdt_parts* m = make();
    int64_t own, vertices, i, *numbers, *owners, *ranges;
    CHECK(mgdt_parts_insert_points(m, MGDT_PARTS_THIS_PART, last - first, xyz + 3 * first, NULL) ==
          MGDT_OK);
    CHECK(mgdt_parts_build(m) == MGDT_OK);
    own = stat(m, MGDT_PARTS_OWN_VERTICES);
    vertices = stat(m, MGDT_PARTS_VERTICES);
    numbers = array(m, MGDT_PARTS_VERTEX_NUMBERS);
    owners = array(m, MGDT_PARTS_VERTEX_OWNERS);
    ranges = array(m, MGDT_PARTS_VERTEX_RANGES);
    mine = room(3 * vertices, sizeof *mine);
    all = room(3 * n, sizeof *all);
    CHECK(mgdt_parts_get_coordinates(m, MGDT_PARTS_THIS_PART, 3 * vertices, mine) == MGDT_OK);
    CHECK(ranges[rank + 1] - ranges[rank] == own);
    gather(mine, all, 3, MPI_DOUBLE, ranges);
    for (i = 0; i < vertices; ++i) {
        CHECK(memcmp(mine + 3 * i, all + 3 * numbers[i], 3 * sizeof *all) == 0);
        CHECK((owners[i] == rank) == (i < own));
        CHECK(ranges[owners[i]] <= numbers[i] && numbers[i] < ranges[owners[i] + 1]);
    }
    free(numbers);
    free(owners);
    free(ranges);
    free(mine);
    free(all);
    free(xyz);
    mgdt_parts_destroy(m);
}

/* Neighbours are mutual, across ranks too: each tells its own to all. */
static void has_neighbors_across_ranks(void) {
    const int64_t n = size_of(SPHERE);
    double* xyz = points_of(SPHERE);
    const int64_t first = share(n, 0, rank), last = share(n, 0, rank + 1);
    mgdt_parts* m = make();
    int64_t owned, count, i, *mine, *all, *ranges;
    CHECK(mgdt_parts_insert_points(m, MGDT_PARTS_THIS_PART, last - first, xyz + 3 * first, NULL) ==
          MGDT_OK);
    CHECK(mgdt_parts_build(m) == MGDT_OK);
    owned = stat(m, MGDT_PARTS_OWN_TETRAHEDRA);
    count = stat(m, MGDT_PARTS_ALL_TETRAHEDRA);
    mine = array(m, MGDT_PARTS_NEIGHBORS);
    ranges = array(m, MGDT_PARTS_TETRAHEDRON_RANGES);
    all = room(4 * count, sizeof *all);
    CHECK(ranges[rank + 1] - ranges[rank] == owned);
    gather(mine, all, 4, MPI_INT64_T, ranges);
    for (i = 0; i < 4 * count; ++i) {
        int k, found = 0;
        if (all[i] == -1) continue;
        for (k = 0; k < 4; ++k) found += all[4 * all[i] + k] == i / 4;
        CHECK(found == 1);
    }
    free(mine);
    free(all);
    free(ranges);
    free(xyz);
    mgdt_parts_destroy(m);
}

static int32_t stop(double fraction, void* user) {
    (void)user;
    return fraction > 0.3;
}

/* What is wrong on the last rank is said on all, with its number; then they go on. */
static void fails_together(void) {
    const int64_t n = size_of(CUBE);
    double* xyz = points_of(CUBE);
    const int64_t first = share(n, 0, rank), last = share(n, 0, rank + 1), clash[] = {7, 7};
    const double bad[] = {0, 0, 0, 1, 1, NAN};
    const int is_last = rank == ranks - 1;
    char expected[64];
    int way;
    expected[0] = '\0';
    if (ranks > 1) sprintf(expected, "part %d: ", ranks - 1);
    for (way = 0; way < 4; ++way) {
        mgdt_status status = MGDT_OK;
        const mgdt_status wanted[] = {MGDT_ERR_NOT_FINITE, MGDT_ERR_CANCELLED,
                                      MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_INVALID_ARGUMENT};
        mgdt_parts* m = make();
        char message[256];
        CHECK(mgdt_parts_set_option(m, MGDT_PARTS_INDEX_BASE, 1) == MGDT_OK);
        if (way < 3)
            CHECK(mgdt_parts_insert_points(m, MGDT_PARTS_THIS_PART, last - first, xyz + 3 * first,
                                           NULL) == MGDT_OK);
        else
            CHECK(mgdt_parts_insert_points(m, MGDT_PARTS_THIS_PART, 1, xyz + 3 * rank, clash) ==
                  MGDT_OK);
        if (is_last && way == 0)
            CHECK(mgdt_parts_insert_points(m, MGDT_PARTS_THIS_PART, 2, bad, NULL) ==
                  MGDT_ERR_NOT_FINITE);
        if (is_last && way == 1) CHECK(mgdt_parts_set_progress(m, stop, NULL) == MGDT_OK);
        if (is_last && way == 2)
            CHECK(mgdt_parts_set_option(m, MGDT_PARTS_MEMORY_LIMIT, 100000) == MGDT_OK);
        if (is_last && way == 3)
            CHECK(mgdt_parts_insert_points(m, MGDT_PARTS_THIS_PART, 1, xyz + 3 * ranks, clash) ==
                  MGDT_OK);
        status = mgdt_parts_build(m);
        CHECK(status == wanted[way]);
        CHECK(mgdt_parts_get_error(m, sizeof message, message) == MGDT_OK);
        if (way < 3)
            CHECK(strncmp(message, expected, strlen(expected)) == 0);
        else
            CHECK(strstr(message, "id 7 is given to two points: (") != NULL);
        CHECK(stat(m, MGDT_PARTS_ALL_VERTICES) == 0);
        if (way == 3) CHECK(mgdt_parts_clear(m) == MGDT_OK);
        CHECK(mgdt_parts_set_progress(m, NULL, NULL) == MGDT_OK);
        CHECK(mgdt_parts_set_option(m, MGDT_PARTS_MEMORY_LIMIT, 0) == MGDT_OK);
        CHECK(mgdt_parts_build(m) == MGDT_OK);
        CHECK(stat(m, MGDT_PARTS_ALL_VERTICES) == (way == 3 ? 0 : n));
        mgdt_parts_destroy(m);
    }
    free(xyz);
}

static void refuses_arguments(void) {
    mgdt_parts* m = (mgdt_parts*)&rank;
    int64_t value;
    CHECK(mgdt_mpi_create(MPI_COMM_WORLD, NULL) == MGDT_ERR_NULL_POINTER);
    CHECK(mgdt_mpi_create_f(MPI_Comm_c2f(MPI_COMM_WORLD), NULL) == MGDT_ERR_NULL_POINTER);
    CHECK(mgdt_mpi_create(MPI_COMM_NULL, &m) == MGDT_ERR_INVALID_ARGUMENT);
    CHECK(m == NULL);
    CHECK(mgdt_mpi_create_f(MPI_Comm_c2f(MPI_COMM_NULL), &m) == MGDT_ERR_INVALID_ARGUMENT);
    mgdt_parts_destroy(NULL);
    CHECK(mgdt_parts_build(NULL) == MGDT_ERR_NULL_POINTER);
    CHECK(mgdt_parts_get_stat(NULL, MGDT_PARTS_THIS_PART, MGDT_PARTS_POINTS, &value) ==
          MGDT_ERR_NULL_POINTER);
    CHECK(mgdt_mpi_create_f(MPI_Comm_c2f(MPI_COMM_WORLD), &m) == MGDT_OK);
    CHECK(stat(m, MGDT_PARTS_PARTS) == ranks);
    CHECK(stat(m, MGDT_PARTS_FIRST_LOCAL) == rank);
    CHECK(stat(m, MGDT_PARTS_LOCAL_PARTS) == 1);
    CHECK(mgdt_parts_check(m, 7) == MGDT_ERR_INVALID_ARGUMENT);
    CHECK(mgdt_parts_cancel(m) == MGDT_OK);
    CHECK(mgdt_parts_build(m) == MGDT_ERR_CANCELLED);
    CHECK(mgdt_parts_set_option(m, MGDT_PARTS_THREADS, 2) == MGDT_OK);
    CHECK(mgdt_parts_get_option(m, MGDT_PARTS_THREADS, &value) == MGDT_OK && value == 2);
    mgdt_parts_destroy(m);
}

int main(int argc, char** argv) {
    mgdt_parts *early, *late;
    char version[MPI_MAX_LIBRARY_VERSION_STRING];
    int length;
    /* Before MPI is there and after it is gone. */
    CHECK(mgdt_mpi_create(MPI_COMM_WORLD, &early) == MGDT_ERR_INVALID_ARGUMENT && early == NULL);
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    /* As many as were asked for, of the MPI that was. */
    CHECK(argc == 3 && atoi(argv[1]) == ranks);
    MPI_Get_library_version(version, &length);
    CHECK(argc == 3 && strstr(version, argv[2]) != NULL);
    has_the_tetrahedra_of_one();
    has_the_ghosts_of_others();
    has_neighbors_across_ranks();
    fails_together();
    refuses_arguments();
    late = make();
    MPI_Allreduce(MPI_IN_PLACE, &failures, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    if (rank == 0) printf("%d ranks: %d failures\n", ranks, failures);
    MPI_Finalize();
    mgdt_parts_destroy(late);
    return failures != 0;
}
