/* SPDX-License-Identifier: MIT
 * How parts exchange bytes by MPI. */
#ifndef MGDT_SRC_MPI_TRANSPORT_H
#define MGDT_SRC_MPI_TRANSPORT_H

#include <mpi.h>

#include "mgdt/mgdt_parts.h"

/* The largest message in bytes. The counts of MPI are int, so longer messages are sent in pieces.
 * Tests use a smaller limit. */
#ifndef MGDT_MPI_LARGEST_MESSAGE
#define MGDT_MPI_LARGEST_MESSAGE (1 << 30)
#endif

/* A communicator, and memory for the operations in progress. */
struct mgdt_mpi_transport {
    MPI_Comm communicator;
    int ranks, rank;
    int *counts, *places;  /* one for each rank */
    MPI_Request* requests; /* two for each rank */
};

/* On success, the transport owns `communicator`. Returns NULL without memory or if MPI fails. */
struct mgdt_mpi_transport* mgdt_mpi_transport_new(MPI_Comm communicator);
/* Frees the transport, and its communicator unless MPI is finalised. */
void mgdt_mpi_transport_free(struct mgdt_mpi_transport* t);
/* The functions for mgdt_parts_create_with_transport(), the last of which frees `t`. */
mgdt_transport mgdt_mpi_transport_functions(struct mgdt_mpi_transport* t);

#endif
