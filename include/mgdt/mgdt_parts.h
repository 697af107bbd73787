/* SPDX-License-Identifier: MIT
 *
 * mgdt in parts: one triangulation of points that are distributed over parts, in one process or in
 * several.
 *
 * A caller inserts points into any part. mgdt_parts_build() divides space into one region per part,
 * so that all parts own about equally many vertices, and triangulates. A part owns the vertices in
 * its region. It has all tetrahedra with at least one vertex that it owns; the vertices of these
 * tetrahedra that other parts own are its ghosts. For every number of parts the tetrahedra are
 * those of one mgdt_triangulation of all points. Each tetrahedron is owned by one part: the owner
 * of its lexicographically least vertex.
 *
 * Either all parts are in one process (mgdt_parts_create()), which allows more points than one
 * mgdt_triangulation can number, or each of several processes has one part. The processes exchange
 * bytes by MPI (mgdt_mpi_create() in mgdt_mpi.h) or by functions of the caller
 * (mgdt_parts_create_with_transport()). The other functions are the same for all.
 *
 * The conventions are those of mgdt.h: status and message, capacities in elements, callbacks, the
 * thread rule. In addition:
 *
 * - Parts are numbered from 0, as the ranks of MPI are, whatever the index base is. An argument
 *   `part` has to be a part of the calling process. If the process has one part only,
 *   MGDT_PARTS_THIS_PART stands for it.
 * - Vertices and tetrahedra have numbers that are unique over all parts. They start at the index
 *   base: first those that part 0 owns, then those that part 1 owns, and so on.
 * - All processes make a collective call, in the same order of calls. If the call fails on one
 *   process, it fails on all with the same status and a message that names the part. Where an
 *   argument has to be the same on all processes, its description says so. A call that returns
 *   MGDT_ERR_BUSY, or that is given a NULL handle, does not count as made: the other processes
 *   wait.
 *
 * @since 1.2
 */
#ifndef MGDT_MGDT_PARTS_H
#define MGDT_MGDT_PARTS_H

#include "mgdt.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A handle of points in parts and their triangulation. The struct is opaque; mgdt_parts_create(),
 *  mgdt_parts_create_with_transport() and mgdt_mpi_create() make one. */
typedef struct mgdt_parts mgdt_parts;

/** A value of the argument `part`. */
enum {
    /** The only part of the calling process. If the process has several parts, a call with this
     *  value returns MGDT_ERR_INVALID_ARGUMENT. */
    MGDT_PARTS_THIS_PART = -1
};

/* The functions of an mgdt_transport exchange bytes between processes with one part each. The
 * library calls them on the thread that called it. Each function is collective, returns 0 for
 * success, and must not use the handle. After a function has failed, the library does not call
 * another one; its call returns MGDT_ERR_TRANSPORT on this process, and the transport decides what
 * happens on the others. Arrays of offsets, in bytes, have one element per process and one more for
 * the end; the first element is 0. Arrays without elements may be NULL. */

/** Sends the bytes of each process to all processes: those at `mine` on process p go to
 *  all + begin[p], up to all + begin[p + 1], on every process. `begin` is the same on all.
 *  @since 1.2 */
typedef int32_t (*mgdt_gather_fn)(const void* mine, void* all, const int64_t* begin, void* user);
/** Sends the number out[p] to process p, and receives in[p] from it, for all p.
 *  @since 1.2 */
typedef int32_t (*mgdt_exchange_numbers_fn)(const uint64_t* out, uint64_t* in, void* user);
/** Sends the bytes from out + out_begin[p] to out + out_begin[p + 1] to process p, and receives the
 *  bytes from process p at in + in_begin[p], for all p. Sender and receiver have the same number of
 *  bytes.
 *  @since 1.2 */
typedef int32_t (*mgdt_exchange_fn)(const void* out, const int64_t* out_begin, void* in,
                                    const int64_t* in_begin, void* user);
/** Replaces each of n numbers by the sum of the numbers that all processes have at its index,
 *  modulo 2^64.
 *  @since 1.2 */
typedef int32_t (*mgdt_sum_fn)(uint64_t* numbers, int64_t n, void* user);
/** Replaces each of n numbers by the least of the numbers that all processes have at its index.
 *  None is NaN.
 *  @since 1.2 */
typedef int32_t (*mgdt_least_fn)(double* numbers, int64_t n, void* user);
/** Frees what the transport holds. mgdt_parts_destroy() calls it once, after all else is freed.
 *  @since 1.2 */
typedef void (*mgdt_destroy_transport_fn)(void* user);

/** How processes exchange bytes, for mgdt_parts_create_with_transport(), which copies the struct.
 *  Later versions may add members at the end. A caller sets `size`, and sets the members that it
 *  does not use to 0.
 *  @since 1.2 */
typedef struct mgdt_transport {
    size_t size;       /**< sizeof(mgdt_transport). */
    int32_t processes; /**< Number of processes, 1 to 2^20; the same on all. */
    int32_t process;   /**< Number of this process and of its part, from 0. */
    mgdt_gather_fn gather;
    mgdt_exchange_numbers_fn exchange_numbers;
    mgdt_exchange_fn exchange;
    mgdt_sum_fn sum;
    mgdt_least_fn least;
    mgdt_destroy_transport_fn destroy; /**< NULL if there is nothing to free. */
    void* user;                        /**< Passed to the functions; has to live until `destroy`. */
} mgdt_transport;

/** Options of mgdt_parts_set_option(). Values are integers. */
enum {
    MGDT_PARTS_INDEX_BASE = 10, /**< 0 (default) or 1; the same on all processes. */
    /** Threads that triangulate each part, see mgdt_set_threads(); default 1, 0 for all cores. */
    MGDT_PARTS_THREADS = 20,
    /** Bytes that this process may hold for points and triangulations; 0 (default) for no limit.
     *  For triangulations a new limit applies from the next build on. */
    MGDT_PARTS_MEMORY_LIMIT = 30,
    /** 1 if mgdt_parts_check() reports progress and can be cancelled, as mgdt_parts_build();
     *  default 0. The same on all processes. Since 1.3. */
    MGDT_PARTS_READ_PROGRESS = 40
};

/** Keys of mgdt_parts_get_stat(). Numbers of vertices and tetrahedra are 0 until the first
 *  build. */
enum {
    MGDT_PARTS_PARTS = 10,          /**< Number of parts of all processes. */
    MGDT_PARTS_FIRST_LOCAL = 11,    /**< The first part of this process. */
    MGDT_PARTS_LOCAL_PARTS = 12,    /**< Number of parts of this process. */
    MGDT_PARTS_POINTS = 20,         /**< Points inserted into the part. */
    MGDT_PARTS_OWN_VERTICES = 30,   /**< Vertices that the part owns. */
    MGDT_PARTS_VERTICES = 31,       /**< Vertices of the part, ghosts included. */
    MGDT_PARTS_ALL_VERTICES = 32,   /**< Vertices of all parts. */
    MGDT_PARTS_OWN_TETRAHEDRA = 40, /**< Tetrahedra that the part owns. */
    MGDT_PARTS_TETRAHEDRA = 41,     /**< Tetrahedra of the part. */
    MGDT_PARTS_ALL_TETRAHEDRA = 42, /**< Tetrahedra of all parts. */
    MGDT_PARTS_RECEIVED = 50,       /**< Points that other parts sent to the part. */
    MGDT_PARTS_MEMORY_BYTES = 60    /**< Memory held by all parts of this process. */
};

/** Arrays of a part, for mgdt_parts_get_array(). The vertices of a part have an order: first the
 *  vertices that it owns, which have consecutive numbers, then its ghosts by ascending number. Its
 *  tetrahedra also have an order: first those that it owns, which have consecutive numbers, then
 *  the others, which are not sorted. */
enum {
    /** For each point inserted into the part, in the order of insertion, the number of its vertex.
     *  Equal points have the same vertex. */
    MGDT_PARTS_POINT_MAP = 10,
    MGDT_PARTS_VERTEX_NUMBERS = 20, /**< The number of each vertex. */
    /** The id of each vertex: the least id of the points that share it. */
    MGDT_PARTS_VERTEX_IDS = 21,
    MGDT_PARTS_VERTEX_OWNERS = 22, /**< The part that owns each vertex. */
    /** For each part the number of the first vertex that it owns, and one element more: the end of
     *  the last part's numbers. */
    MGDT_PARTS_VERTEX_RANGES = 23,
    /** For each tetrahedron the numbers of its 4 vertices, positively oriented as in
     *  mgdt_get_tetrahedra(). */
    MGDT_PARTS_CORNERS = 30,
    /** For each tetrahedron its 4 vertices, each as its index in the part's order of vertices, from
     *  the index base on. */
    MGDT_PARTS_LOCAL_CORNERS = 31,
    MGDT_PARTS_TETRAHEDRON_NUMBERS = 32, /**< The number of each tetrahedron. */
    MGDT_PARTS_TETRAHEDRON_OWNERS = 33,  /**< The part that owns each tetrahedron. */
    /** For each part the number of the first tetrahedron that it owns, and one element more: the
     *  end of the last part's numbers. During mgdt_parts_build_each() the array ends with the part
     *  that was finished last. */
    MGDT_PARTS_TETRAHEDRON_RANGES = 34,
    /** For each tetrahedron that the part owns, the numbers of the 4 tetrahedra opposite its
     *  vertices. On the hull the number is the index base - 1. */
    MGDT_PARTS_NEIGHBORS = 40
};

/* ------------------------------------------------------------------------------- life --- */

/** Makes parts in this process. A build needs additional memory of about 25 bytes times the square
 *  of the number of parts, so some thousand parts are the most that is sensible.
 *  @param parts  number of parts, at least 1 and at most 2^20
 *  @param[out] out  the handle; NULL if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_create(int32_t parts, mgdt_parts** out);

/** Makes parts in this process that take all their memory from `alloc`.
 *  @param alloc, release, user  as for mgdt_create_with_allocator()
 *  @return as mgdt_parts_create()
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_create_with_allocator(int32_t parts, mgdt_alloc_fn alloc,
                                                      mgdt_free_fn release, void* user,
                                                      mgdt_parts** out);

/** Makes the part of this process; each other process makes its own. Not collective.
 *  @param transport  how the processes exchange bytes. If the call fails, the library does not call
 *                    the transport's `destroy`
 *  @param[out] out   the handle; NULL if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER (also if a function is missing),
 *  MGDT_ERR_INVALID_ARGUMENT (`processes` or `process` is out of range; `size` is too small, or is
 *  that of a later version and a member that this version does not know is not 0),
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_create_with_transport(const mgdt_transport* transport,
                                                      mgdt_parts** out);

/** Frees the handle and all that it holds, the transport included. NULL is allowed. While another
 *  call is running on the handle, as in a callback, this function does nothing, as mgdt_destroy().
 *  It is collective for handles of mgdt_mpi_create(), and for no others.
 *  @since 1.2 */
MGDT_API void mgdt_parts_destroy(mgdt_parts* p);

/** Removes all points of this process, and the triangulation. The options stay. A pending
 *  cancellation is withdrawn. Not collective.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_clear(mgdt_parts* p);

/* --------------------------------------------------------------------------- settings --- */

/** Sets an option, for later calls.
 *  @param option  an MGDT_PARTS_ option, which documents its values
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_set_option(mgdt_parts* p, int32_t option, int64_t value);
/** The value of an option.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_get_option(const mgdt_parts* p, int32_t option, int64_t* value);

/** Sets the callback that receives the progress of mgdt_parts_build() on this process, and that of
 *  mgdt_parts_check() with MGDT_PARTS_READ_PROGRESS. It may cancel, which stops the call on all
 *  processes.
 *  @param fn  the callback; NULL for none (default)
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_set_progress(mgdt_parts* p, mgdt_progress_fn fn, void* user);
/** The progress callback, or NULL, and what is passed to it.
 *  @param[out] user  may be NULL
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_parts_get_progress(const mgdt_parts* p, mgdt_progress_fn* fn,
                                             void** user);

/** Asks mgdt_parts_build(), or mgdt_parts_check() with MGDT_PARTS_READ_PROGRESS, to stop soon. That
 *  call then returns MGDT_ERR_CANCELLED on all processes. If none is running, the request stays
 *  pending and stops the next one, unless mgdt_parts_clear() comes first; it also ends with a call
 *  that fails for another reason. Any thread and any signal handler may call this function. Not
 *  collective.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_cancel(mgdt_parts* p);

/* ----------------------------------------------------------------------------- points --- */

/** Inserts points into a part. The points are copied. A call that fails inserts none of its points,
 *  and the next mgdt_parts_build() fails once on all processes with the same status and message. So
 *  a process whose insertion failed may go on to that build, and no other process waits. Not
 *  collective.
 *  @param part  a part of this process, or MGDT_PARTS_THIS_PART, as in all calls
 *  @param n     number of points, at least 0
 *  @param xyz   3 n coordinates, copied; may be NULL if n is 0
 *  @param ids   n ids of the points, or NULL. Different points have different ids; equal points may
 *               share an id. Either all points of all parts have ids or none has. Without ids the
 *               points are numbered from the index base on, those of part 0 first
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (the part, n, or ids for some
 *  points only), MGDT_ERR_NOT_FINITE, MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_insert_points(mgdt_parts* p, int32_t part, int64_t n,
                                              const double* xyz, const int64_t* ids);

/** Triangulates all points that were inserted. Collective. An earlier triangulation is freed first;
 *  the points stay, and more may be inserted for a later build.
 *  @return MGDT_OK or MGDT_ERR_NULL_POINTER. After any other status there is no triangulation:
 *  MGDT_ERR_INVALID_ARGUMENT (only some points have ids, or two different points have the same id,
 *  which the message names), MGDT_ERR_TOO_LARGE (a part has more points than it can number, so that
 *  more parts are needed), MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_CANCELLED, MGDT_ERR_TRANSPORT, or the
 *  status of an mgdt_parts_insert_points() that failed
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_build(mgdt_parts* p);

/** Receives a part whose triangulation is finished. It is called on the thread that called
 *  mgdt_parts_build_each(). It may use the handle in calls that take a `const mgdt_parts *`, also
 *  from several threads; all other calls are refused. A nonzero return value cancels the build.
 *  @since 1.2 */
typedef int32_t (*mgdt_part_fn)(const mgdt_parts* p, int32_t part, void* user);

/** Triangulates all points as mgdt_parts_build() does, but keeps the triangulation of one part at a
 *  time in memory, so that the whole may be larger than memory. All parts have to be in this
 *  process. Each part is triangulated twice. The callback `look` is called for each part in
 *  ascending order and can read the arrays of that part, except for MGDT_PARTS_TETRAHEDRON_NUMBERS,
 *  MGDT_PARTS_TETRAHEDRON_OWNERS and MGDT_PARTS_NEIGHBORS: they depend on other parts, and reading
 *  them returns MGDT_ERR_INVALID_ARGUMENT. The numbers of the tetrahedra that the part owns start
 *  at its element of MGDT_PARTS_TETRAHEDRON_RANGES. After the call there are no tetrahedra; the
 *  vertices keep their numbers, and MGDT_PARTS_POINT_MAP can be read.
 *  @param user  passed to `look`
 *  @return as mgdt_parts_build(), MGDT_ERR_INVALID_ARGUMENT (parts in several processes),
 *  MGDT_ERR_CANCELLED (`look` returned a nonzero value)
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_build_each(mgdt_parts* p, mgdt_part_fn look, void* user);

/* ---------------------------------------------------------------------------- results --- */

/** Gives one number of a part or of all parts.
 *  @param part  a part of this process; has no effect on numbers of all parts
 *  @param key   a key: MGDT_PARTS_PARTS to MGDT_PARTS_MEMORY_BYTES
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (the part),
 *  MGDT_ERR_UNKNOWN_KEY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_get_stat(const mgdt_parts* p, int32_t part, int32_t key,
                                         int64_t* value);

/** Gives the shape of an array, which is the same for all parts.
 *  @param array         an MGDT_PARTS_ array
 *  @param[out] columns  how many elements belong together, such as 4 for MGDT_PARTS_CORNERS; may be
 *                       NULL
 *  @param[out] is_double  0, since all arrays of parts have integers; may be NULL
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER (both), MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_parts_array_info(int32_t array, int32_t* columns, int32_t* is_double);
/** Gives the number of elements of an array. It is 0 until a triangulation is built.
 *  @param array  an MGDT_PARTS_ array
 *  @return as mgdt_parts_get_stat()
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_get_size(const mgdt_parts* p, int32_t part, int32_t array,
                                         int64_t* size);
/** Writes an array.
 *  @param array     an MGDT_PARTS_ array
 *  @param capacity  at least what mgdt_parts_get_size() gives
 *  @return as mgdt_parts_get_stat(), and MGDT_ERR_BUFFER_TOO_SMALL, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_get_array(const mgdt_parts* p, int32_t part, int32_t array,
                                          int64_t capacity, int64_t* values);
/** Writes the coordinates of the vertices of a part, in the part's order of vertices.
 *  @param capacity  elements in xyz, at least 3 times the number MGDT_PARTS_VERTICES
 *  @param[out] xyz  x y z of each vertex
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_BUFFER_TOO_SMALL
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_get_coordinates(const mgdt_parts* p, int32_t part, int64_t capacity,
                                                double* xyz);

/** Checks that the triangulation is valid: each part as mgdt_check() does, and that the parts fit
 *  together (docs/theory.md, "Parts"). Collective.
 *  @param level  an MGDT_CHECK_ value; the same on all processes
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (the level, or nothing is
 *  built), MGDT_ERR_CHECK_FAILED (the message says what is wrong and where), MGDT_ERR_CANCELLED,
 *  MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_TRANSPORT
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_check(mgdt_parts* p, int32_t level);

/** Copies the message of the last call that failed on the handle, as mgdt_get_error().
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (a capacity below 1)
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_get_error(const mgdt_parts* p, int64_t capacity, char* buffer);

#ifdef __cplusplus
}
#endif

#endif /* MGDT_MGDT_PARTS_H */
