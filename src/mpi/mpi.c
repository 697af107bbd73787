/* SPDX-License-Identifier: MIT
 * The functions of mgdt_mpi.h: those of mgdt_parts.h, for the part of this rank. */
#include <stdlib.h>

#include "mgdt/mgdt_mpi.h"
#include "mpi/transport.h"

struct mgdt_mpi {
    struct mgdt_mpi_transport transport;
    mgdt_parts* parts;
};

/* Whether MPI can be called. */
static int is_running(void) {
    int initialized = 0, finalized = 0;
    return MPI_Initialized(&initialized) == MPI_SUCCESS && initialized &&
           MPI_Finalized(&finalized) == MPI_SUCCESS && !finalized;
}

/* The worst status of all ranks: the largest. */
static mgdt_status agree(mgdt_status mine, MPI_Comm communicator) {
    int32_t worst = mine;
    if (MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_INT32_T, MPI_MAX, communicator) != MPI_SUCCESS)
        return MGDT_ERR_TRANSPORT;
    return worst;
}

/* What this rank needs for itself. The communicator is the handle's, if there is one. */
static mgdt_status make(MPI_Comm communicator, mgdt_mpi** out) {
    mgdt_mpi* const m = malloc(sizeof *m);
    *out = NULL;
    if (m == NULL) return MGDT_ERR_OUT_OF_MEMORY;
    m->parts = NULL;
    if (mgdt_mpi_transport_begin(&m->transport, communicator) != 0) {
        free(m);
        return MGDT_ERR_OUT_OF_MEMORY;
    }
    *out = m;
    return mgdt_mpi_transport_parts(&m->transport, &m->parts);
}

mgdt_status mgdt_mpi_create(MPI_Comm communicator, mgdt_mpi** out) {
    MPI_Comm own;
    mgdt_mpi* m = NULL;
    mgdt_status status;
    int between_groups;
    if (out != NULL) *out = NULL;
    if (!is_running() || communicator == MPI_COMM_NULL)
        return out == NULL ? MGDT_ERR_NULL_POINTER : MGDT_ERR_INVALID_ARGUMENT;
    if (MPI_Comm_test_inter(communicator, &between_groups) != MPI_SUCCESS || between_groups)
        return MGDT_ERR_INVALID_ARGUMENT;
    if (MPI_Comm_dup(communicator, &own) != MPI_SUCCESS) return MGDT_ERR_TRANSPORT;
    MPI_Comm_set_errhandler(own, MPI_ERRORS_RETURN);
    status = out == NULL ? MGDT_ERR_NULL_POINTER : make(own, &m);
    status = agree(status, own);
    if (status == MGDT_OK) {
        *out = m;
        return MGDT_OK;
    }
    if (m != NULL)
        mgdt_mpi_destroy(m);
    else
        MPI_Comm_free(&own);
    return status;
}

mgdt_status mgdt_mpi_create_f(MPI_Fint communicator, mgdt_mpi** out) {
    if (out == NULL) return MGDT_ERR_NULL_POINTER;
    *out = NULL;
    if (!is_running()) return MGDT_ERR_INVALID_ARGUMENT;
    return mgdt_mpi_create(MPI_Comm_f2c(communicator), out);
}

void mgdt_mpi_destroy(mgdt_mpi* m) {
    int64_t value;
    if (m == NULL) return;
    /* While a call is inside the handle nothing is freed, as mgdt_parts_destroy() has it. */
    if (mgdt_parts_get_option(m->parts, MGDT_PARTS_THREADS, &value) == MGDT_ERR_BUSY ||
        mgdt_parts_set_option(m->parts, MGDT_PARTS_THREADS, value) == MGDT_ERR_BUSY)
        return;
    mgdt_parts_destroy(m->parts);
    mgdt_mpi_transport_end(&m->transport);
    free(m);
}

/* The handle in the handle; NULL gets its status from there. */
static mgdt_parts* of(const mgdt_mpi* m) {
    return m != NULL ? m->parts : NULL;
}
/* The part of this rank. */
static int32_t own(const mgdt_mpi* m) {
    return m != NULL ? m->transport.rank : 0;
}

mgdt_status mgdt_mpi_clear(mgdt_mpi* m) {
    return mgdt_parts_clear(of(m));
}

mgdt_status mgdt_mpi_set_option(mgdt_mpi* m, int32_t option, int64_t value) {
    return mgdt_parts_set_option(of(m), option, value);
}

mgdt_status mgdt_mpi_get_option(const mgdt_mpi* m, int32_t option, int64_t* value) {
    return mgdt_parts_get_option(of(m), option, value);
}

mgdt_status mgdt_mpi_set_progress(mgdt_mpi* m, mgdt_progress_fn fn, void* user) {
    return mgdt_parts_set_progress(of(m), fn, user);
}

mgdt_status mgdt_mpi_cancel(mgdt_mpi* m) {
    return mgdt_parts_cancel(of(m));
}

mgdt_status mgdt_mpi_insert_points(mgdt_mpi* m, int64_t n, const double* xyz, const int64_t* ids) {
    return mgdt_parts_insert_points(of(m), own(m), n, xyz, ids);
}

mgdt_status mgdt_mpi_build(mgdt_mpi* m) {
    return mgdt_parts_build(of(m));
}

mgdt_status mgdt_mpi_get_stat(const mgdt_mpi* m, int32_t key, int64_t* value) {
    return mgdt_parts_get_stat(of(m), own(m), key, value);
}

mgdt_status mgdt_mpi_get_size(const mgdt_mpi* m, int32_t array, int64_t* size) {
    return mgdt_parts_get_size(of(m), own(m), array, size);
}

mgdt_status mgdt_mpi_get_array(const mgdt_mpi* m, int32_t array, int64_t capacity,
                               int64_t* values) {
    return mgdt_parts_get_array(of(m), own(m), array, capacity, values);
}

mgdt_status mgdt_mpi_get_coordinates(const mgdt_mpi* m, int64_t capacity, double* xyz) {
    return mgdt_parts_get_coordinates(of(m), own(m), capacity, xyz);
}

mgdt_status mgdt_mpi_check(mgdt_mpi* m, int32_t level) {
    return mgdt_parts_check(of(m), level);
}

mgdt_status mgdt_mpi_get_error(const mgdt_mpi* m, int64_t capacity, char* buffer) {
    return mgdt_parts_get_error(of(m), capacity, buffer);
}
