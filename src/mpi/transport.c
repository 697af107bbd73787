/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L /* sched_yield() */
#include "mpi/transport.h"

#include <sched.h>
#include <stdlib.h>
#include <string.h>

/* Whether an MPI call failed. The communicator has MPI_ERRORS_RETURN, so calls return errors. */
static int failed(int code) {
    return code != MPI_SUCCESS;
}

/* Waits for a request that a call with the result `code` has begun. Returns whether it failed.
 * MPI_Wait() would keep the processor busy, which delays other ranks if there are more ranks than
 * processors. */
static int fails(int code, MPI_Request* request) {
    int is_done = 0;
    while (code == MPI_SUCCESS) {
        code = MPI_Test(request, &is_done, MPI_STATUS_IGNORE);
        if (is_done) break;
        sched_yield();
    }
    return failed(code);
}

/* The size of the next message, after `done` of `bytes`. */
static int piece(int64_t bytes, int64_t done) {
    const int64_t left = bytes - done;
    return (int)(left < MGDT_MPI_LARGEST_MESSAGE ? left : MGDT_MPI_LARGEST_MESSAGE);
}

/* Gathers the bytes of all ranks by one call of MPI. If there are more bytes than one call can
 * gather, each rank broadcasts its own. All ranks know the number of bytes of each rank, so all
 * ranks take the same branch. */
static int32_t gather(const void* mine, void* all, const int64_t* begin, void* user) {
    struct mgdt_mpi_transport* const t = user;
    char* const to = all;
    const int64_t own = begin[t->rank + 1] - begin[t->rank];
    int rank;
    if (begin[t->ranks] <= MGDT_MPI_LARGEST_MESSAGE) {
        for (rank = 0; rank < t->ranks; ++rank) {
            t->counts[rank] = (int)(begin[rank + 1] - begin[rank]);
            t->places[rank] = (int)begin[rank];
        }
        return fails(MPI_Iallgatherv(mine, (int)own, MPI_BYTE, all, t->counts, t->places, MPI_BYTE,
                                     t->communicator, t->requests),
                     t->requests);
    }
    for (rank = 0; rank < t->ranks; ++rank) {
        const int64_t bytes = begin[rank + 1] - begin[rank];
        int64_t done;
        if (rank == t->rank && own > 0) memcpy(to + begin[rank], mine, (size_t)own);
        for (done = 0; done < bytes; done += piece(bytes, done))
            if (fails(MPI_Ibcast(to + begin[rank] + done, piece(bytes, done), MPI_BYTE, rank,
                                 t->communicator, t->requests),
                      t->requests))
                return 1;
    }
    return 0;
}

static int32_t exchange_numbers(const uint64_t* out, uint64_t* in, void* user) {
    struct mgdt_mpi_transport* const t = user;
    return fails(
        MPI_Ialltoall(out, 1, MPI_UINT64_T, in, 1, MPI_UINT64_T, t->communicator, t->requests),
        t->requests);
}

/* Sends a message, or several in sequence, between each two ranks that have something for each
 * other. A part has few neighbours, while MPI_Alltoallv() would look at all ranks. */
static int32_t exchange(const void* out, const int64_t* out_begin, void* in,
                        const int64_t* in_begin, void* user) {
    struct mgdt_mpi_transport* const t = user;
    int64_t done = 0;
    int pending;
    do {
        int step;
        pending = 0;
        /* In each step, no two ranks receive from the same rank. */
        for (step = 0; step < t->ranks; ++step) {
            const int from = (t->rank + step) % t->ranks;
            const int64_t bytes = in_begin[from + 1] - in_begin[from];
            if (done < bytes &&
                failed(MPI_Irecv((char*)in + in_begin[from] + done, piece(bytes, done), MPI_BYTE,
                                 from, 0, t->communicator, t->requests + pending++)))
                return 1;
        }
        for (step = 0; step < t->ranks; ++step) {
            const int to = (t->rank + t->ranks - step) % t->ranks;
            const int64_t bytes = out_begin[to + 1] - out_begin[to];
            if (done < bytes &&
                failed(MPI_Isend((const char*)out + out_begin[to] + done, piece(bytes, done),
                                 MPI_BYTE, to, 0, t->communicator, t->requests + pending++)))
                return 1;
        }
        for (step = 0; step < pending; ++step)
            if (fails(MPI_SUCCESS, t->requests + step)) return 1;
        done += MGDT_MPI_LARGEST_MESSAGE;
    } while (pending > 0);
    return 0;
}

/* Reduces in place, a limited number of elements at a time. */
static int32_t reduce(void* numbers, int64_t n, MPI_Datatype type, MPI_Op operation,
                      struct mgdt_mpi_transport* t) {
    int64_t done;
    for (done = 0; done < n; done += piece(n, done))
        if (fails(MPI_Iallreduce(MPI_IN_PLACE, (char*)numbers + 8 * done, piece(n, done), type,
                                 operation, t->communicator, t->requests),
                  t->requests))
            return 1;
    return 0;
}

static int32_t sum(uint64_t* numbers, int64_t n, void* user) {
    return reduce(numbers, n, MPI_UINT64_T, MPI_SUM, user);
}

static int32_t least(double* numbers, int64_t n, void* user) {
    return reduce(numbers, n, MPI_DOUBLE, MPI_MIN, user);
}

struct mgdt_mpi_transport* mgdt_mpi_transport_new(MPI_Comm communicator) {
    struct mgdt_mpi_transport* const t = calloc(1, sizeof *t);
    size_t ranks;
    if (t == NULL) return NULL;
    t->communicator = MPI_COMM_NULL;
    if (failed(MPI_Comm_size(communicator, &t->ranks)) ||
        failed(MPI_Comm_rank(communicator, &t->rank))) {
        free(t);
        return NULL;
    }
    ranks = (size_t)t->ranks;
    t->counts = malloc(ranks * sizeof *t->counts);
    t->places = malloc(ranks * sizeof *t->places);
    t->requests = malloc(2 * ranks * sizeof(MPI_Request));
    if (t->counts == NULL || t->places == NULL || t->requests == NULL) {
        mgdt_mpi_transport_free(t);
        return NULL;
    }
    t->communicator = communicator;
    return t;
}

void mgdt_mpi_transport_free(struct mgdt_mpi_transport* t) {
    int finalized = 0;
    free(t->counts);
    free(t->places);
    free(t->requests);
    MPI_Finalized(&finalized);
    if (!finalized && t->communicator != MPI_COMM_NULL) MPI_Comm_free(&t->communicator);
    free(t);
}

static void destroy(void* user) {
    mgdt_mpi_transport_free(user);
}

mgdt_transport mgdt_mpi_transport_functions(struct mgdt_mpi_transport* t) {
    const mgdt_transport functions = {sizeof functions, t->ranks, t->rank, gather,
                                      exchange_numbers, exchange, sum,     least,
                                      destroy,          t};
    return functions;
}
