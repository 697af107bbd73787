/* SPDX-License-Identifier: MIT
 * A host with MPI: two processes or more, each of which triangulates with two threads of its own
 * while messages are under way, from the thread that alone may call MPI. All get the same
 * tetrahedra. */
#include <limits.h>
#include <mpi.h>

#include "linked.h"

enum { ranks_wanted = 2, tag = 1 };

/* The tetrahedra in canonical order; *threads is how many threads inserted. */
static int64_t* tetrahedra(struct points p, int32_t scheme, int32_t wanted, int* threads,
                           int64_t* count) {
    mgdt_triangulation* t = NULL;
    double inserting = 0;
    int64_t* v;
    REQUIRE(mgdt_create(&t) == MGDT_OK);
    REQUIRE(mgdt_set_threads(t, wanted) == MGDT_OK);
    REQUIRE(mgdt_set_order_scheme(t, scheme) == MGDT_OK);
    REQUIRE(mgdt_set_canonical_output(t, 1) == MGDT_OK);
    REQUIRE(mgdt_insert_points(t, p.n, p.xyz) == MGDT_OK);
    REQUIRE(mgdt_get_stat(t, MGDT_STAT_THREADS, &inserting) == MGDT_OK);
    *threads = is_small() ? wanted : (int)inserting;
    *count = 4 * mgdt_tetrahedron_count(t);
    REQUIRE(*count > 0 && *count <= INT_MAX);
    v = malloc((size_t)*count * sizeof *v);
    REQUIRE(v != NULL && mgdt_get_tetrahedra(t, *count, v) == MGDT_OK);
    mgdt_destroy(t);
    return v;
}

/* The tetrahedra of the rank before are those of this one, number for number. */
static void compare_with_neighbour(int rank, int ranks, const int64_t* v, int64_t count) {
    int64_t* other = malloc((size_t)count * sizeof *other);
    MPI_Status status;
    int received = 0;
    REQUIRE(other != NULL);
    REQUIRE(MPI_Sendrecv(v, (int)count, MPI_INT64_T, (rank + 1) % ranks, tag, other, (int)count,
                         MPI_INT64_T, (rank + ranks - 1) % ranks, tag, MPI_COMM_WORLD,
                         &status) == MPI_SUCCESS);
    REQUIRE(MPI_Get_count(&status, MPI_INT64_T, &received) == MPI_SUCCESS);
    REQUIRE(received == count);
    REQUIRE(memcmp(v, other, (size_t)count * sizeof *v) == 0);
    free(other);
}

int main(int argc, char** argv) {
    const int32_t schemes[ranks_wanted] = {MGDT_ORDER_AUTO, MGDT_ORDER_BRIO};
    int provided = 0, rank = 0, ranks = 0, before, threads = 0, alone = 0;
    int64_t count = 0, count_alone = 0, extremes[2] = {0, 0};
    int64_t *v, *v_alone;
    struct points p;
    double* incoming;
    MPI_Request requests[2];

    REQUIRE(MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided) == MPI_SUCCESS);
    REQUIRE(provided >= MPI_THREAD_FUNNELED);
    REQUIRE(MPI_Comm_rank(MPI_COMM_WORLD, &rank) == MPI_SUCCESS);
    REQUIRE(MPI_Comm_size(MPI_COMM_WORLD, &ranks) == MPI_SUCCESS);
    REQUIRE(ranks >= ranks_wanted);

    /* The points of the first rank, at all of them. */
    p = make_points(point_count);
    if (rank != 0) memset(p.xyz, 0, (size_t)(3 * p.n) * sizeof *p.xyz);
    REQUIRE(MPI_Bcast(p.xyz, (int)(3 * p.n), MPI_DOUBLE, 0, MPI_COMM_WORLD) == MPI_SUCCESS);
    REQUIRE(p.xyz[0] != 0 && p.xyz[3 * p.n - 1] != 0);

    /* A message of each rank to the next is on its way while both triangulate. */
    incoming = calloc((size_t)(3 * p.n), sizeof *incoming);
    REQUIRE(incoming != NULL);
    REQUIRE(MPI_Irecv(incoming, (int)(3 * p.n), MPI_DOUBLE, (rank + ranks - 1) % ranks, tag,
                      MPI_COMM_WORLD, &requests[0]) == MPI_SUCCESS);
    REQUIRE(MPI_Isend(p.xyz, (int)(3 * p.n), MPI_DOUBLE, (rank + 1) % ranks, tag, MPI_COMM_WORLD,
                      &requests[1]) == MPI_SUCCESS);
    before = thread_count();
    v = tetrahedra(p, schemes[rank % ranks_wanted], 2, &threads, &count);
    REQUIRE(threads == 2);
    REQUIRE(thread_count() == before);
    REQUIRE(MPI_Waitall(2, requests, MPI_STATUSES_IGNORE) == MPI_SUCCESS);
    REQUIRE(memcmp(incoming, p.xyz, (size_t)(3 * p.n) * sizeof *incoming) == 0);

    /* As many everywhere, then the same ones, which one thread makes too. */
    REQUIRE(MPI_Allreduce(&count, &extremes[0], 1, MPI_INT64_T, MPI_MIN, MPI_COMM_WORLD) ==
            MPI_SUCCESS);
    REQUIRE(MPI_Allreduce(&count, &extremes[1], 1, MPI_INT64_T, MPI_MAX, MPI_COMM_WORLD) ==
            MPI_SUCCESS);
    REQUIRE(extremes[0] == count && extremes[1] == count);
    compare_with_neighbour(rank, ranks, v, count);
    v_alone = tetrahedra(p, MGDT_ORDER_AUTO, 1, &alone, &count_alone);
    REQUIRE(alone == 1 && count_alone == count);
    REQUIRE(memcmp(v, v_alone, (size_t)count * sizeof *v) == 0);

    free(v_alone);
    free(v);
    free(incoming);
    free_points(p);
    REQUIRE(MPI_Finalize() == MPI_SUCCESS);
    return 0;
}
