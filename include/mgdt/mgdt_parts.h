/* SPDX-License-Identifier: MIT
 *
 * mgdt in parts: one triangulation of points that are spread over parts, in one process or in many.
 *
 * Points are inserted into the parts where they happen to be. mgdt_parts_build() gives each point a
 * home, the part whose region it is in, so that all parts own as many vertices, and triangulates.
 * Then each part has its own vertices, all tetrahedra that have one of these as a corner, and
 * the vertices of others at the corners of those, its ghosts. The tetrahedra are those of one
 * mgdt_triangulation of all points, for every number of parts. Each belongs to one part: the home
 * of its lexicographically least vertex.
 *
 * The parts are in one process (mgdt_parts_create()), which goes beyond the points that one handle
 * can number, or one in each of several processes. These exchange bytes by MPI (mgdt_mpi_create()
 * in mgdt_mpi.h) or by functions of the caller's (mgdt_parts_create_with_transport()). The other
 * functions are the same for all.
 *
 * The conventions are those of mgdt.h: status and message, capacities in elements, callbacks, the
 * thread rule. Beyond these:
 *
 * - Parts are numbered from 0, as the ranks of MPI are, whatever the index base. A call that is
 *   given a part wants one of this process. MGDT_PARTS_THIS_PART stands for the part of a process
 *   that has one only.
 * - Vertices and tetrahedra are numbered through all parts, from the index base on: those that
 *   part 0 owns, then those of part 1, and so on.
 * - A collective call is made by all processes, in the same order. If it fails on one, it
 *   fails on all, with the same status, and a message that names the part. Arguments that have to
 *   be the same on all are said to be. A call that is refused as MGDT_ERR_BUSY, or for a NULL
 *   handle, was not made: the others wait for it.
 *
 * @since 1.2
 */
#ifndef MGDT_MGDT_PARTS_H
#define MGDT_MGDT_PARTS_H

#include "mgdt.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Points in parts and their triangulation. Opaque; made by mgdt_parts_create(),
 *  mgdt_parts_create_with_transport() and mgdt_mpi_create(). */
typedef struct mgdt_parts mgdt_parts;

/** A part, for the calls that are given one. */
enum {
    /** The part of this process. A process with several parts has to say which:
     *  MGDT_ERR_INVALID_ARGUMENT. */
    MGDT_PARTS_THIS_PART = -1
};

/* How processes with one part each exchange bytes: the functions of an mgdt_transport. Each is
 * collective, is called on the thread that calls mgdt_parts_, returns 0 for success, and must not
 * call the handle. After one has failed none is called again in that call, which returns
 * MGDT_ERR_TRANSPORT on this process; what the others do is up to the transport. Offsets are in
 * bytes, one for each process and their end, the first of them 0. Arrays without elements may be
 * NULL. */

/** Gives all processes the bytes of all: what process p has at `mine` goes to all + begin[p], up to
 *  all + begin[p + 1]. `begin` is the same on all.
 *  @since 1.2 */
typedef int32_t (*mgdt_gather_fn)(const void* mine, void* all, const int64_t* begin, void* user);
/** Sends the number out[p] to process p, and receives in[p] from it, for all p.
 *  @since 1.2 */
typedef int32_t (*mgdt_exchange_numbers_fn)(const uint64_t* out, uint64_t* in, void* user);
/** Sends the bytes from out + out_begin[p] to out + out_begin[p + 1] to process p, and receives
 * those that it sends at in + in_begin[p]. Both sides know the numbers.
 *  @since 1.2 */
typedef int32_t (*mgdt_exchange_fn)(const void* out, const int64_t* out_begin, void* in,
                                    const int64_t* in_begin, void* user);
/** Replaces each of n numbers by the sum of all processes' numbers there, modulo 2^64.
 *  @since 1.2 */
typedef int32_t (*mgdt_sum_fn)(uint64_t* numbers, int64_t n, void* user);
/** Replaces each of n numbers by the least of all processes' numbers there; none is NaN.
 *  @since 1.2 */
typedef int32_t (*mgdt_least_fn)(double* numbers, int64_t n, void* user);
/** Frees what the transport holds. Not collective for mgdt: it is called once, at the end of the
 *  mgdt_parts_destroy() that frees the handle.
 *  @since 1.2 */
typedef void (*mgdt_destroy_transport_fn)(void* user);

/** How the processes exchange bytes, for mgdt_parts_create_with_transport(), which copies it. Later
 *  versions may add members at its end. A caller sets all members that it does not use to 0, and
 *  `size`.
 *  @since 1.2 */
typedef struct mgdt_transport {
    size_t size;       /**< sizeof(mgdt_transport). */
    int32_t processes; /**< How many there are, 1 to 2^20; the same on all. */
    int32_t process;   /**< This one, from 0: the number of its part. */
    mgdt_gather_fn gather;
    mgdt_exchange_numbers_fn exchange_numbers;
    mgdt_exchange_fn exchange;
    mgdt_sum_fn sum;
    mgdt_least_fn least;
    mgdt_destroy_transport_fn destroy; /**< NULL if there is nothing to free. */
    void* user;                        /**< Passed to these; it has to live until `destroy`. */
} mgdt_transport;

/** Options, for mgdt_parts_set_option(). Values are integers. */
enum {
    MGDT_PARTS_INDEX_BASE = 10, /**< 0 (default) or 1; the same on all processes. */
    /** Threads of each triangulation, see mgdt_set_threads(); default 1, 0 for all cores. */
    MGDT_PARTS_THREADS = 20,
    /** Bytes that this process may hold for points, and for triangulations from the next build on;
     *  0 (default) for no limit. */
    MGDT_PARTS_MEMORY_LIMIT = 30
};

/** Numbers, for mgdt_parts_get_stat(). Those of a triangulation are 0 until one is built. */
enum {
    MGDT_PARTS_PARTS = 10,          /**< Parts in all. */
    MGDT_PARTS_FIRST_LOCAL = 11,    /**< The first part of this process. */
    MGDT_PARTS_LOCAL_PARTS = 12,    /**< How many parts this process has. */
    MGDT_PARTS_POINTS = 20,         /**< Points inserted into the part. */
    MGDT_PARTS_OWN_VERTICES = 30,   /**< Vertices that the part owns. */
    MGDT_PARTS_VERTICES = 31,       /**< These and its ghosts. */
    MGDT_PARTS_ALL_VERTICES = 32,   /**< Vertices of all parts. */
    MGDT_PARTS_OWN_TETRAHEDRA = 40, /**< Tetrahedra that the part owns. */
    MGDT_PARTS_TETRAHEDRA = 41,     /**< These and the others with a corner that it owns. */
    MGDT_PARTS_ALL_TETRAHEDRA = 42, /**< Tetrahedra of all parts. */
    MGDT_PARTS_RECEIVED = 50,       /**< Points of other parts that the part was sent. */
    MGDT_PARTS_MEMORY_BYTES = 60    /**< Memory held by all parts of this process. */
};

/** Arrays of a part, for mgdt_parts_get_array(). The part's vertices are in a fixed order: its own,
 *  which have consecutive numbers, then its ghosts, in ascending order of their numbers. So are its
 *  tetrahedra: its own, which have consecutive numbers, then the others, in no order. */
enum {
    /** For each point inserted into the part, in that order, the number of its vertex. Equal points
     *  have the same. */
    MGDT_PARTS_POINT_MAP = 10,
    MGDT_PARTS_VERTEX_NUMBERS = 20, /**< The number of each vertex. */
    /** The id of each vertex: the least that was given with a point there. */
    MGDT_PARTS_VERTEX_IDS = 21,
    MGDT_PARTS_VERTEX_OWNERS = 22, /**< The part that owns each vertex. */
    /** For each part the number of its first vertex, and one more, the end of the last part's: as
     *  many as there are parts, and one. */
    MGDT_PARTS_VERTEX_RANGES = 23,
    /** For each tetrahedron the numbers of its 4 corners, positively oriented as those of
     *  mgdt_get_tetrahedra(). */
    MGDT_PARTS_CORNERS = 30,
    /** The same, by places of the vertices in the part's order, from the index base on. */
    MGDT_PARTS_LOCAL_CORNERS = 31,
    MGDT_PARTS_TETRAHEDRON_NUMBERS = 32, /**< The number of each tetrahedron. */
    MGDT_PARTS_TETRAHEDRON_OWNERS = 33,  /**< The part that owns each tetrahedron. */
    /** As MGDT_PARTS_VERTEX_RANGES, for tetrahedra; in mgdt_parts_build_each() up to the part. */
    MGDT_PARTS_TETRAHEDRON_RANGES = 34,
    /** For each tetrahedron that the part owns, 4 numbers: of the tetrahedra opposite its corners,
     *  or the index base - 1 where there is none. */
    MGDT_PARTS_NEIGHBORS = 40
};

/* ------------------------------------------------------------------------------- life --- */

/** Makes parts in this process. A build takes some 25 bytes times the square of their number
 *  besides all else: thousands are many.
 *  @param parts  how many, at least 1 and at most 2^20
 *  @param[out] out  the handle; NULL if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_create(int32_t parts, mgdt_parts** out);

/** Makes parts in this process, all of whose memory comes from `alloc`.
 *  @param alloc, release, user  as for mgdt_create_with_allocator()
 *  @return as mgdt_parts_create()
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_create_with_allocator(int32_t parts, mgdt_alloc_fn alloc,
                                                      mgdt_free_fn release, void* user,
                                                      mgdt_parts** out);

/** Makes the part of this process, of as many as there are processes. Not collective.
 *  @param transport  how they exchange bytes. If the call fails it is still the caller's, and its
 *                    `destroy` is not called
 *  @param[out] out   the handle; NULL if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER (also a function that is missing),
 *  MGDT_ERR_INVALID_ARGUMENT (the numbers of processes; a size that is too small, or larger than
 *  this version's with members set that it does not know), MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_create_with_transport(const mgdt_transport* transport,
                                                      mgdt_parts** out);

/** Frees the handle and all it holds, with its transport. NULL is fine. In a callback of its own,
 *  or while another thread is in a call, it frees nothing, as mgdt_destroy(). Not collective, but
 *  for handles of mgdt_mpi_create().
 *  @since 1.2 */
MGDT_API void mgdt_parts_destroy(mgdt_parts* p);

/** Takes all points of this process out, and the triangulation. Options stay. Withdraws a pending
 *  cancellation. Not collective.
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

/** Sets the callback that receives the progress of mgdt_parts_build() on this process, and may
 *  cancel, which stops all.
 *  @param fn  NULL for none (default)
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_set_progress(mgdt_parts* p, mgdt_progress_fn fn, void* user);

/** Asks mgdt_parts_build() to stop soon; it returns MGDT_ERR_CANCELLED on all processes. If none is
 *  running, the request stays pending and stops the next one, unless mgdt_parts_clear() comes
 *  first; one that fails for another reason ends it too. Safe from any thread and from signal
 * handlers. Not collective.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_cancel(mgdt_parts* p);

/* ----------------------------------------------------------------------------- points --- */

/** Inserts points into a part. They are copied. A call that fails inserts none of its points, and
 *  the next mgdt_parts_build() fails on all processes with its status and message, once: so
 *  every process may go on to that call. Not collective.
 *  @param part  a part of this process, or MGDT_PARTS_THIS_PART; so in all calls
 *  @param n     at least 0
 *  @param xyz   3 n coordinates; may be NULL if n is 0
 *  @param ids   n numbers for the points, or NULL. Different points have different ids; equal ones
 *               may share theirs. All points of all parts have ids, or none; without, they
 *               are numbered from the index base on, those of part 0 first
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (the part, n, ids for some
 *  points alone), MGDT_ERR_NOT_FINITE, MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_insert_points(mgdt_parts* p, int32_t part, int64_t n,
                                              const double* xyz, const int64_t* ids);

/** Triangulates all points that were inserted. Collective. The triangulation of an earlier call is
 *  gone from the beginning on; the points stay, and more may be inserted for a later call.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER; MGDT_ERR_INVALID_ARGUMENT (ids for some points alone,
 * two different points with one id, which the message names), MGDT_ERR_TOO_LARGE (a part has more
 * than it can number: take more parts), MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_CANCELLED,
 *  MGDT_ERR_TRANSPORT, and what mgdt_parts_insert_points() returned. There is no triangulation then
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_build(mgdt_parts* p);

/** Looks at a part whose triangulation is finished, on the thread that called
 *  mgdt_parts_build_each(). It may make calls with `const mgdt_parts *` on the handle, from several
 *  threads too; all others are refused. A nonzero result ends the call.
 *  @since 1.2 */
typedef int32_t (*mgdt_part_fn)(const mgdt_parts* p, int32_t part, void* user);

/** Triangulates all points as mgdt_parts_build() does, with one triangulation in memory at a time:
 *  for more than memory holds. All parts are in this process. Each part is triangulated twice.
 *  `look` is called for each part in ascending order and finds the arrays of that part, but for
 *  those that other parts would have to tell, which are MGDT_PARTS_TETRAHEDRON_NUMBERS,
 *  MGDT_PARTS_TETRAHEDRON_OWNERS and MGDT_PARTS_NEIGHBORS: they get MGDT_ERR_INVALID_ARGUMENT. The
 *  tetrahedra that the part owns are numbered from its place in MGDT_PARTS_TETRAHEDRON_RANGES on.
 *  After the call there are no tetrahedra, but the numbers of vertices (MGDT_PARTS_POINT_MAP).
 *  @param user  passed to `look`
 *  @return as mgdt_parts_build(), MGDT_ERR_INVALID_ARGUMENT (parts in several processes),
 *  MGDT_ERR_CANCELLED where `look` ends it
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_build_each(mgdt_parts* p, mgdt_part_fn look, void* user);

/* ---------------------------------------------------------------------------- results --- */

/** A number of a part, or of all.
 *  @param part  a part of this process; numbers that are not of a part do not depend on it
 *  @param key   an MGDT_PARTS_ number
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (the part),
 *  MGDT_ERR_UNKNOWN_KEY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_get_stat(const mgdt_parts* p, int32_t part, int32_t key,
                                         int64_t* value);

/** How many elements an array has. 0 until a triangulation is built.
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
/** Writes the coordinates of a part's vertices, in their order.
 *  @param capacity  at least 3 times the number MGDT_PARTS_VERTICES
 *  @param[out] xyz  3 for each vertex
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_BUFFER_TOO_SMALL
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_get_coordinates(const mgdt_parts* p, int32_t part, int64_t capacity,
                                                double* xyz);

/** Proves the triangulation by local tests: each part's as mgdt_check() does, and that
 *  the parts fit together (docs/theory.md, "Parts"). Collective.
 *  @param level  an MGDT_CHECK_ value; the same on all processes
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (the level, or nothing is
 *  built), MGDT_ERR_CHECK_FAILED (the message says what is wrong and where),
 *  MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_TRANSPORT
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_check(mgdt_parts* p, int32_t level);

/** The message of the last failed call on the handle, which calls that succeed leave, as
 *  mgdt_get_error().
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (a capacity below 1)
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_parts_get_error(const mgdt_parts* p, int64_t capacity, char* buffer);

#ifdef __cplusplus
}
#endif

#endif /* MGDT_MGDT_PARTS_H */
