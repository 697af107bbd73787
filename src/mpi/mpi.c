/* SPDX-License-Identifier: MIT
 * The functions of mgdt_mpi.h, which create one part on each rank. */
#include "mgdt/mgdt_mpi.h"
#include "mpi/transport.h"

/* Whether MPI can be called. */
static int is_running(void) {
    int initialized = 0, finalized = 0;
    return MPI_Initialized(&initialized) == MPI_SUCCESS && initialized &&
           MPI_Finalized(&finalized) == MPI_SUCCESS && !finalized;
}

/* The largest status of all ranks. */
static mgdt_status agree(mgdt_status mine, MPI_Comm communicator) {
    int32_t worst = mine;
    if (MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_INT32_T, MPI_MAX, communicator) != MPI_SUCCESS)
        return MGDT_ERR_TRANSPORT;
    return worst;
}

/* Creates the handle of this rank's part. On success the handle owns the communicator. */
static mgdt_status create(MPI_Comm communicator, mgdt_parts** out) {
    struct mgdt_mpi_transport* const t = mgdt_mpi_transport_new(communicator);
    mgdt_transport functions;
    mgdt_status status;
    *out = NULL;
    if (t == NULL) return MGDT_ERR_OUT_OF_MEMORY;
    functions = mgdt_mpi_transport_functions(t);
    status = mgdt_parts_create_with_transport(&functions, out);
    if (status != MGDT_OK) {
        t->communicator = MPI_COMM_NULL; /* the caller still owns the communicator */
        mgdt_mpi_transport_free(t);
    }
    return status;
}

mgdt_status mgdt_mpi_create(MPI_Comm communicator, mgdt_parts** out) {
    MPI_Comm own;
    mgdt_parts* p = NULL;
    mgdt_status status;
    int between_groups;
    if (out != NULL) *out = NULL;
    if (!is_running() || communicator == MPI_COMM_NULL)
        return out == NULL ? MGDT_ERR_NULL_POINTER : MGDT_ERR_INVALID_ARGUMENT;
    if (MPI_Comm_test_inter(communicator, &between_groups) != MPI_SUCCESS || between_groups)
        return MGDT_ERR_INVALID_ARGUMENT;
    if (MPI_Comm_dup(communicator, &own) != MPI_SUCCESS) return MGDT_ERR_TRANSPORT;
    MPI_Comm_set_errhandler(own, MPI_ERRORS_RETURN);
    status = out == NULL ? MGDT_ERR_NULL_POINTER : create(own, &p);
    status = agree(status, own);
    if (status == MGDT_OK) {
        *out = p;
        return MGDT_OK;
    }
    if (p != NULL)
        mgdt_parts_destroy(p);
    else
        MPI_Comm_free(&own);
    return status;
}

mgdt_status mgdt_mpi_create_f(MPI_Fint communicator, mgdt_parts** out) {
    if (out == NULL) return MGDT_ERR_NULL_POINTER;
    *out = NULL;
    if (!is_running()) return MGDT_ERR_INVALID_ARGUMENT;
    return mgdt_mpi_create(MPI_Comm_f2c(communicator), out);
}
