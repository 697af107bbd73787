/* SPDX-License-Identifier: MIT
 *
 * mgdt with MPI: one triangulation of points that are distributed over the ranks of a communicator.
 *
 * mgdt_mpi_create() makes a handle of mgdt_parts.h with one part on each rank; the number of the
 * part is the rank. All other functions are those of mgdt_parts.h, which accept
 * MGDT_PARTS_THIS_PART for the part of the calling rank. The two functions below are in a separate
 * library, libmgdt_mpi, which is built for one MPI implementation.
 *
 * The caller has to initialise MPI, with MPI_THREAD_FUNNELED if the program has threads. The
 * library neither initialises nor finalises MPI, and never calls MPI_Abort().
 *
 * @since 1.2
 */
#ifndef MGDT_MGDT_MPI_H
#define MGDT_MGDT_MPI_H

#include <mpi.h>

#include "mgdt_parts.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Makes the part of the calling rank, and duplicates the communicator. Collective over the
 *  communicator. mgdt_parts_destroy() of the handle is also collective, since it frees the
 *  duplicate; after MPI_Finalize() it frees the rest alone.
 *  @param[out] out  the handle; NULL if the call fails, which it does on all ranks or on none
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (MPI is not initialised or is
 *  finalised; the communicator is none, has more than 2^20 ranks or is an intercommunicator),
 *  MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_TRANSPORT (if the communicator's error handler returns errors)
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_create(MPI_Comm communicator, mgdt_parts** out);
/** The same with the communicator as Fortran has it: an integer, or the MPI_VAL of a
 *  type(MPI_Comm).
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_create_f(MPI_Fint communicator, mgdt_parts** out);

#ifdef __cplusplus
}
#endif

#endif /* MGDT_MGDT_MPI_H */
