/* SPDX-License-Identifier: MIT
 *
 * mgdt with MPI: one triangulation of points that are spread over the ranks of a communicator.
 *
 * These are the functions of mgdt_parts.h, which explains them, with one part on each rank, of the
 * rank's number. They are in a library of their own, libmgdt_mpi, which is built for one MPI. The
 * constants are those of mgdt_parts.h too.
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

/** Points on ranks and their triangulation. Opaque; made by mgdt_mpi_create(). */
typedef struct mgdt_mpi mgdt_mpi;

/** Makes the part of this rank. Collective over the communicator, which is duplicated.
 *  @param[out] out  the handle; NULL if the call fails, which it does on all ranks alike
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (MPI is not initialised, or is
 *  finalised; no communicator of at most 2^20 ranks, or one between groups),
 *  MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_TRANSPORT (where the communicator returns errors)
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_create(MPI_Comm communicator, mgdt_mpi** out);
/** The same for a communicator of Fortran's: an integer, or the MPI_VAL of a type(MPI_Comm).
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_create_f(MPI_Fint communicator, mgdt_mpi** out);
/** Frees the handle and all it holds. NULL is fine. Collective, unless MPI is finalised.
 *  @since 1.2 */
MGDT_API void mgdt_mpi_destroy(mgdt_mpi* m);

/** As mgdt_parts_clear().
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_clear(mgdt_mpi* m);
/** As mgdt_parts_set_option().
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_set_option(mgdt_mpi* m, int32_t option, int64_t value);
/** As mgdt_parts_get_option().
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_get_option(const mgdt_mpi* m, int32_t option, int64_t* value);
/** As mgdt_parts_set_progress().
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_set_progress(mgdt_mpi* m, mgdt_progress_fn fn, void* user);
/** As mgdt_parts_cancel().
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_cancel(mgdt_mpi* m);

/** As mgdt_parts_insert_points(), into the part of this rank.
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_insert_points(mgdt_mpi* m, int64_t n, const double* xyz,
                                            const int64_t* ids);
/** As mgdt_parts_build(). Collective.
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_build(mgdt_mpi* m);

/** As mgdt_parts_get_stat(), for the part of this rank.
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_get_stat(const mgdt_mpi* m, int32_t key, int64_t* value);
/** As mgdt_parts_get_size(), for the part of this rank.
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_get_size(const mgdt_mpi* m, int32_t array, int64_t* size);
/** As mgdt_parts_get_array(), for the part of this rank.
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_get_array(const mgdt_mpi* m, int32_t array, int64_t capacity,
                                        int64_t* values);
/** As mgdt_parts_get_coordinates(), for the part of this rank.
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_get_coordinates(const mgdt_mpi* m, int64_t capacity, double* xyz);
/** As mgdt_parts_check(). Collective.
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_check(mgdt_mpi* m, int32_t level);
/** As mgdt_parts_get_error(): the message of the last call that failed, which calls that succeed
 * leave.
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_mpi_get_error(const mgdt_mpi* m, int64_t capacity, char* buffer);

#ifdef __cplusplus
}
#endif

#endif /* MGDT_MGDT_MPI_H */
