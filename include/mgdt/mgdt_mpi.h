/* SPDX-License-Identifier: MIT
 *
 * mgdt with MPI: one triangulation of points that are spread over the ranks of a communicator.
 *
 * mgdt_mpi_create() makes a handle of mgdt_parts.h with one part on each rank, of the rank's
 * number. All other calls are those of mgdt_parts.h, which take MGDT_PARTS_THIS_PART for the part
 * of this rank. These two functions are in a library of their own, libmgdt_mpi, which is built for
 * one MPI.
 *
 * MPI has to be initialised, for calls from the thread that made it (MPI_THREAD_FUNNELED) at least.
 * The library neither initialises nor finalises it, and never calls MPI_Abort().
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

/** Makes the part of this rank. Collective over the communicator, which is duplicated. So is the
 *  mgdt_parts_destroy() of the handle, which frees the duplicate, unless MPI is finalised.
 *  @param[out] out  the handle; NULL if the call fails, which it does on all ranks alike
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (MPI is not initialised, or is
 *  finalised; no communicator of at most 2^20 ranks, or one between groups),
 *  MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_TRANSPORT (where the communicator returns errors)
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_create(MPI_Comm communicator, mgdt_parts** out);
/** The same for a communicator of Fortran's: an integer, or the MPI_VAL of a type(MPI_Comm).
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_create_f(MPI_Fint communicator, mgdt_parts** out);

#ifdef __cplusplus
}
#endif

#endif /* MGDT_MGDT_MPI_H */
