/* SPDX-License-Identifier: MIT
 *
 * mgdt: exact 3D Delaunay triangulation of any set of points.
 *
 * This header is the C interface of one triangulation and can be read from top to bottom as a
 * manual; mgdt_parts.h has that of a triangulation in parts, mgdt_mpi.h that with MPI.
 * It is C99, and C++ may include it as it stands.
 *
 * Conventions, for every function:
 *
 * - A function that can fail returns an mgdt_status: MGDT_OK (0) or one of the errors below.
 *   mgdt_get_error() gives a message that says what was wrong and where.
 * - A call that fails on its arguments changes nothing. One that is cancelled or runs out of
 *   memory leaves a valid Delaunay triangulation of the points that got in.
 * - The library never prints, exits, throws, installs a signal handler, or writes to an array
 *   that is not documented as output. It restores the floating-point environment.
 *   Callbacks run in the default environment, and their changes to it are undone.
 * - No call is a cancellation point of POSIX threads, whatever its callbacks do: pthread_cancel()
 *   of the calling thread acts after the call. Cancellation is disabled during the call, and its
 *   state comes back as it was. A thread of the asynchronous type (PTHREAD_CANCEL_ASYNCHRONOUS) is
 *   cancelled as the call ends; the handle then has all that the call did.
 * - Coordinates are in any one unit of length; every finite double is accepted.
 * - Indices start at the handle's index base (0, or 1 for Fortran): the k-th point ever given
 *   to the handle, k = 0, 1, ..., has index k + base, and tetrahedra are numbered likewise.
 *   "None" is base - 1. A point keeps its index until mgdt_clear() or mgdt_renumber_points().
 *   Numbers of tetrahedra hold until the next insertion, removal or move, mgdt_clear(),
 *   mgdt_renumber_points(), mgdt_set_index_base() or mgdt_set_canonical_output().
 * - Output arrays are the caller's. Their capacity is counted in array elements, not bytes
 *   and not tetrahedra; one that is too small gets MGDT_ERR_BUFFER_TOO_SMALL and is not touched.
 * - Functions ending in _i32 are their 64-bit namesakes with 32-bit integers in the arrays; an
 *   index that does not fit gets MGDT_ERR_INDEX_RANGE.
 * - Thread rule: calls that take a `const mgdt_triangulation *` may run on one handle from many
 *   threads at once. A call that takes a non-const handle needs that handle to itself, except
 *   mgdt_cancel(). Different handles are independent.
 * - Callbacks (progress and allocator) must not call the handle that they serve, except
 *   mgdt_cancel() and mgdt_get_error().
 * - A call that breaks one of these two rules gets MGDT_ERR_BUSY, changes nothing and writes no
 *   output; the message names the call that is running on the handle. While a call with a non-const
 *   handle runs, every other call but mgdt_cancel() and mgdt_get_error() is refused. Functions that
 *   return no status then answer as for an empty handle: counts are 0, the dimension is -1,
 *   mgdt_isa_name() gives an empty string, and mgdt_destroy() does nothing. While a call with a
 *   const handle runs, calls with a non-const handle are refused, and mgdt_destroy() does nothing.
 *   One case is not detected: a call with a non-const handle from another thread while
 *   mgdt_locate(), mgdt_nearest_vertex(), their _i32 forms, a getter of a setting, mgdt_get_stat()
 *   or a count runs. (Since 1.2; before, all of this was undefined.)
 * - Callbacks must return: no longjmp(), no pthread_exit(). They should not throw; an exception of
 *   the progress callback counts as a nonzero result, one of an mgdt_alloc_fn as NULL, and one of
 *   an mgdt_free_fn is dropped.
 * - A call takes less than 32 KiB of stack, of its own thread and of each that it starts, whatever
 *   the points; callbacks take theirs on top of that.
 */
#ifndef MGDT_MGDT_H
#define MGDT_MGDT_H

#include <stddef.h>
#include <stdint.h>

#define MGDT_VERSION_MAJOR 1
#define MGDT_VERSION_MINOR 2
#define MGDT_VERSION_PATCH 0

/** Whether this header is of at least that version: `#if MGDT_VERSION_AT_LEAST(1, 2)`. In headers
 *  before 1.2 it is not defined.
 *  @since 1.2 */
#define MGDT_VERSION_AT_LEAST(major, minor) \
    (MGDT_VERSION_MAJOR > (major) ||        \
     (MGDT_VERSION_MAJOR == (major) && MGDT_VERSION_MINOR >= (minor)))

/* clang-format off */
#if defined(_WIN32)
#  if defined(MGDT_BUILDING)
#    define MGDT_API __declspec(dllexport)
#  elif defined(MGDT_STATIC)
#    define MGDT_API
#  else
#    define MGDT_API __declspec(dllimport)
#  endif
#elif defined(__GNUC__)
#  define MGDT_API __attribute__((visibility("default")))
#else
#  define MGDT_API
#endif
/* clang-format on */

#ifdef __cplusplus
extern "C" {
#endif

/* ---------------------------------------------------------------- types and constants --- */

/** A triangulation that grows as points are inserted. Opaque; made by mgdt_create(). */
typedef struct mgdt_triangulation mgdt_triangulation;

/** The outcome of a call: one of the MGDT_OK / MGDT_ERR_ values. */
typedef int32_t mgdt_status;

/** Values of mgdt_status. New ones may be added; existing ones never change. */
enum {
    MGDT_OK = 0,                    /**< Success. */
    MGDT_ERR_NULL_POINTER = 10,     /**< A pointer that must not be NULL is NULL. */
    MGDT_ERR_INVALID_ARGUMENT = 11, /**< A value out of its documented range. */
    MGDT_ERR_NOT_FINITE = 12,       /**< A coordinate is NaN or infinite. */
    MGDT_ERR_UNKNOWN_SCHEME = 13,   /**< Not an MGDT_ORDER_ value or name. */
    MGDT_ERR_UNKNOWN_KEY = 14,      /**< Not an MGDT_STAT_ or MGDT_PARAMETER_ key. */
    MGDT_ERR_BUFFER_TOO_SMALL = 20, /**< The capacity is less than what must be written. */
    MGDT_ERR_INDEX_RANGE = 21,      /**< An index does not fit a 32-bit integer. */
    MGDT_ERR_OUT_OF_MEMORY = 30,    /**< The allocator or the memory limit refused. */
    MGDT_ERR_TOO_LARGE = 31,        /**< More points or tetrahedra than the format can number. */
    MGDT_ERR_CANCELLED = 40,        /**< mgdt_cancel() or the progress callback asked to stop. */
    MGDT_ERR_BUSY = 41, /**< Another call is running on the handle: a callback called its
                         *   own handle, or two threads broke the thread rule. Every
                         *   function that takes a handle may return it, except
                         *   mgdt_cancel() and mgdt_get_error(). Since 1.2. */
    /** A transport of mgdt_parts said that it failed. Since 1.2. */
    MGDT_ERR_TRANSPORT = 50,
    MGDT_ERR_CHECK_FAILED = 60, /**< mgdt_check() found a defect. */
    MGDT_ERR_INTERNAL = 90      /**< A defect in mgdt itself; please report it. */
};

/** Order schemes: in which order the points of one call are inserted. The tetrahedra do not
 *  depend on it, the time does. Scheme names, for mgdt_order_scheme_name(), are the same in
 *  lower case with hyphens. Section numbers are those of S.H. Lo, Finite Elements in Analysis
 *  and Design 90 (2014) 113-130. */
enum {
    MGDT_ORDER_AUTO = 0,           /**< Multi-grid with its defaults; the default. */
    MGDT_ORDER_INPUT = 10,         /**< As given (2.1). */
    MGDT_ORDER_RANDOM = 20,        /**< Shuffled (2.1). */
    MGDT_ORDER_LEXICOGRAPHIC = 30, /**< By x, then y, then z (2.1). */
    MGDT_ORDER_BRIO = 40,          /**< Random rounds of growing size, each along a curve (2.2). */
    MGDT_ORDER_HILBERT = 50,       /**< Along a Hilbert curve (2.3). */
    MGDT_ORDER_REGULAR_GRID = 60,  /**< Along a path through a regular grid (4.1). */
    MGDT_ORDER_KD_TREE = 70,       /**< Squarish kd-tree, cell-pivot-cell (3). */
    MGDT_ORDER_ENHANCED_KD_TREE = 80, /**< A kd-tree with a regular grid in each cell (3.4). */
    MGDT_ORDER_MULTI_GRID = 90        /**< Regular grids within the cells of grids (4.2). */
};

/** Parameters of the order schemes, for mgdt_set_order_parameter(). Each scheme uses those that
 *  concern it. */
enum {
    /** Mean number of points in a cell. Default 8 (grids), 10 (kd-tree), 1000 (enhanced kd-tree's
     *  tree cells; its inner grids use 8). Range 1 to 1e6; 0 gives the default back. With
     *  MGDT_SEPARATION_ROUNDS, its default, multi-grid ignores this value and makes its cells as
     *  small as its sort keys can number. */
    MGDT_PARAMETER_POINTS_PER_CELL = 10,
    /** Multi-grid: a cell with more points than this gets a grid of its own. Default 8, or
     *  200 without MGDT_SEPARATION_ROUNDS; range 1 to 1e9; 0 gives the default back. */
    MGDT_PARAMETER_THRESHOLD = 20,
    /** Regular grid and multi-grid: how points of a cell are kept apart, an MGDT_SEPARATION_ value.
     *  The default is MGDT_SEPARATION_ROUNDS; with it multi-grid follows a Hilbert curve. */
    MGDT_PARAMETER_SEPARATION = 30,
    /** BRIO: each round holds this many times the points of all rounds before it, plus one.
     *  Default 7.5, range above 1 to 1e6; 0 gives the default back. */
    MGDT_PARAMETER_ROUND_RATIO = 40
};

/** Values of MGDT_PARAMETER_SEPARATION. Names since 1.2. */
enum {
    MGDT_SEPARATION_NONE = 0,   /**< A cell is emptied before the next one. */
    MGDT_SEPARATION_PASSES = 1, /**< One point from each cell at a time, as in the paper (4.3). */
    /** The points along the path are divided into rounds. Of each twelve consecutive points one
     * goes to an earlier round, those are divided again, and so on; at most 4,096 points are
     * divided by four. */
    MGDT_SEPARATION_ROUNDS = 2
};

/** Keys of mgdt_get_stat(). Counts and seconds add up since mgdt_create() or mgdt_clear(); seconds
 *  are wall-clock time. The first two count what is in now. Levels, rounds and threads are those of
 *  the last insertion. mgdt_clear() does not reset the memory figures. */
enum {
    MGDT_STAT_POINTS_INSERTED = 10, /**< Points that became vertices. */
    MGDT_STAT_DUPLICATES = 11,      /**< Points equal to an earlier vertex. */
    MGDT_STAT_POINTS_REMOVED = 12,  /**< Points taken out. Since 1.2. */
    MGDT_STAT_POINTS_MOVED = 13,    /**< Moves to other coordinates. Since 1.2. */
    MGDT_STAT_PUT_BACK = 14,        /**< Moves that were a removal and an insertion. Since 1.2. */
    MGDT_STAT_REBUILDS = 15,        /**< Removals and moves that triangulated anew. Since 1.2. */
    MGDT_STAT_WALK_STEPS = 20,      /**< Tetrahedra visited by walks (the paper's NP, summed). */
    MGDT_STAT_WALK_TESTS = 21,      /**< Circumspheres evaluated by walks. */
    MGDT_STAT_CONFLICT_TESTS = 22,  /**< Circumspheres evaluated while cavities grew. */
    MGDT_STAT_TETRAHEDRA_REMOVED = 30, /**< Tetrahedra removed by insertions (NR, summed). */
    MGDT_STAT_TETRAHEDRA_CREATED = 31, /**< Tetrahedra created by insertions. */
    /** Vertices around those that removals and moves took out, summed. Since 1.2. */
    MGDT_STAT_LINK_VERTICES = 32,
    MGDT_STAT_EXACT_CALLS = 40,    /**< Decisions that the floating-point filter left open. */
    MGDT_STAT_PUT_OFF = 45,        /**< Insertions that met another thread and were tried again. */
    MGDT_STAT_INSERTED_ALONE = 46, /**< Points inserted while other threads had no work. */
    MGDT_STAT_ORDER_SECONDS = 50,  /**< Time spent on schedules, of more than 16 points. */
    MGDT_STAT_INSERT_SECONDS = 51, /**< Time spent inserting, to triangulate anew as well. */
    MGDT_STAT_REMOVE_SECONDS = 52, /**< Time spent in mgdt_remove_points(). Since 1.2. */
    MGDT_STAT_MOVE_SECONDS = 53,   /**< Time spent in mgdt_move_points(). Since 1.2. */
    MGDT_STAT_GRID_LEVELS = 60,    /**< Deepest level of grids or trees in the last schedule. */
    MGDT_STAT_ROUNDS = 61,         /**< Rounds in the last schedule. */
    MGDT_STAT_THREADS = 62,        /**< Threads of the last insertion. */
    MGDT_STAT_MEMORY_BYTES = 70,   /**< Memory held by the handle now. */
    MGDT_STAT_PEAK_MEMORY_BYTES = 71 /**< The most it held so far. */
};

/** Levels of mgdt_check(). Each includes those below it. */
enum {
    MGDT_CHECK_COMBINATORIAL = 1, /**< Adjacency, shared facets, Euler, all points accounted for. */
    MGDT_CHECK_GEOMETRIC = 2,     /**< Exact positive orientation, exact local Delaunay. */
    MGDT_CHECK_CANONICAL = 3      /**< Convex hull, and ties broken by the perturbation. */
};

/** What mgdt_get_cell_measures() measures. Since 1.2. */
enum {
    MGDT_MEASURE_VOLUME = 10,   /**< Volume of the cell. */
    MGDT_MEASURE_AREA = 20,     /**< Area of its surface. */
    MGDT_MEASURE_CENTROID = 30, /**< Its centre of mass, 3 numbers. */
    MGDT_MEASURE_FACES = 40     /**< Number of its faces that have an area. */
};

/** How a value between points is made; in what follows, of values at the vertices.
 *  @since 1.2 */
enum {
    MGDT_INTERPOLATE_LINEAR = 10,   /**< Linear in each tetrahedron: continuous. */
    MGDT_INTERPOLATE_NEAREST = 20,  /**< The value of the nearest vertex. */
    MGDT_INTERPOLATE_SIBSON = 30,   /**< By natural neighbours: each weighs what its Voronoi cell
                                         would lose. Smooth but at the points. */
    MGDT_INTERPOLATE_LAPLACE = 40,  /**< By natural neighbours: areas of faces over distances. */
    MGDT_INTERPOLATE_SIBSON_C1 = 50 /**< Sibson's with the gradients of mgdt_get_gradients(): smooth
                                         at the points too. */
};

/** What a value outside the convex hull is.
 *  @since 1.2 */
enum {
    MGDT_OUTSIDE_NONE = 10,     /**< None: NaN, and no weights. */
    MGDT_OUTSIDE_NEAREST = 20,  /**< That of the nearest vertex. */
    MGDT_OUTSIDE_BOUNDARY = 30, /**< That of the nearest place of the hull, linear in its facet. */
    MGDT_OUTSIDE_LINEAR = 40    /**< The same, and on with the gradient there: the mean of those of
                                     mgdt_get_gradients() at the corners of the facet. */
};

/** Gives `size` bytes aligned to `align` (a power of two), or NULL. May be called from any thread
 *  that the library runs, several at once. */
typedef void* (*mgdt_alloc_fn)(size_t size, size_t align, void* user);
/** Takes memory back; `size` and `align` are those of the allocation. */
typedef void (*mgdt_free_fn)(void* p, size_t size, size_t align, void* user);
/** Progress of the running insertion, removal or move, `fraction` from 0 to 1, on the calling
 *  thread. A nonzero return value cancels. It must not call the handle, except mgdt_cancel()
 *  and mgdt_get_error(). */
typedef int32_t (*mgdt_progress_fn)(double fraction, void* user);

/* ------------------------------------------------------------------------------- life --- */

/** Makes an empty triangulation.
 *  @param[out] out  the handle; NULL if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_create(mgdt_triangulation** out);

/** Makes an empty triangulation all of whose memory comes from `alloc`.
 *  @param alloc, release  both functions, or both NULL for the default allocator
 *  @param user  passed to them
 *  @param[out] out  the handle; NULL if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (one function without the
 *  other), MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release,
                                                void* user, mgdt_triangulation** out);

/** Frees the handle and all it holds. NULL is fine. While a call is running on the handle, as in
 *  a callback, it does nothing: the handle stays and has to be destroyed after that call.
 *  @since 1.0 */
MGDT_API void mgdt_destroy(mgdt_triangulation* t);

/** Takes all points out; settings stay, statistics start again at zero. Withdraws a pending
 *  cancellation, see mgdt_cancel().
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_clear(mgdt_triangulation* t);

/** Announces how many points will be given in all, so that storage grows once. Optional.
 *  @param n_points  at least 0
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_TOO_LARGE,
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_reserve(mgdt_triangulation* t, int64_t n_points);

/** Frees memory that the handle keeps only for speed: spare room for points, working arrays, the
 *  numbering of tetrahedra and the search tree of locations. The triangulation and all its numbers
 *  stay. Later calls allocate that memory again when they need it. The order in which later
 *  insertions store tetrahedra may differ (mgdt_set_canonical_output()). Memory that the allocator
 *  does not take back stays; the default one moves blocks within the memory limit.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_shrink(mgdt_triangulation* t);

/* --------------------------------------------------------------------------- settings --- */

/** Chooses the order scheme of later insertions.
 *  @param scheme  an MGDT_ORDER_ value; default MGDT_ORDER_AUTO
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_SCHEME
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_order_scheme(mgdt_triangulation* t, int32_t scheme);
/** The order scheme that is set.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_order_scheme(const mgdt_triangulation* t, int32_t* scheme);

/** Sets a parameter of the order schemes.
 *  @param key  an MGDT_PARAMETER_ key, which documents its range and default
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_order_parameter(mgdt_triangulation* t, int32_t key, double value);
/** The value of a parameter; 0 where each scheme has a default of its own.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_order_parameter(const mgdt_triangulation* t, int32_t key,
                                              double* value);

/** Sets the seed of the schemes that shuffle. The same seed gives the same run; the tetrahedra
 *  are the same for every seed. Default 0.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_seed(mgdt_triangulation* t, uint64_t seed);
/** The seed that is set.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_seed(const mgdt_triangulation* t, uint64_t* seed);

/** Sets how many threads a call may use: insertions, exports, checks, and the location and nearest
 *  vertices of many points. The tetrahedra do not depend on it. If it is not 1, the order of
 *  storage, in which tetrahedra are exported unless output is canonical, may differ from run to
 *  run. A call that has work for several threads starts them and joins them before it returns; the
 *  calling thread is one of them. If the system refuses threads, the call runs with those it has.
 *  @param n  at least 1, or 0 for all cores; default 1. More than 254 count as 254
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_threads(mgdt_triangulation* t, int32_t n);
/** The number of threads as it was set, 0 for all cores. MGDT_STAT_THREADS is the number of threads
 *  of the last insertion.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_threads(const mgdt_triangulation* t, int32_t* n);

/** Sets the number that the first point and the first tetrahedron have in all calls.
 *  @param base  0 (default) or 1
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_index_base(mgdt_triangulation* t, int32_t base);
/** The index base that is set.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_index_base(const mgdt_triangulation* t, int32_t* base);

/** Limits the memory that the handle may hold; a call that would exceed the limit gets
 *  MGDT_ERR_OUT_OF_MEMORY. The working memory of a call counts while the call runs. A limit below
 *  what is held frees nothing: the next call that needs more memory, an insertion or an export, is
 *  refused, and the handle stays as it is.
 *  @param bytes  at least 0; 0 (default) for no limit
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_memory_limit(mgdt_triangulation* t, int64_t bytes);
/** The memory limit that is set, 0 for none.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_memory_limit(const mgdt_triangulation* t, int64_t* bytes);

/** Chooses between speed and memory. A triangulation keeps the circumsphere of every tetrahedron,
 *  which is three tenths of its memory. In compact storage spheres are computed from the vertices
 *  when they are needed: insertions and locations take longer (docs/performance.md), the tetrahedra
 *  are the same, and so are the calls; the order in which later insertions store them may
 *  differ (mgdt_set_canonical_output()). May be called between any two calls: with 1 after the last
 *  insertion it gives that memory back, where the allocator can shrink a block within the memory
 *  limit; with 0 it computes the spheres again. Neither moves a tetrahedron: their numbers hold,
 *  and exports are the same byte for byte.
 *  @param on  1 for compact storage, 0 (default) for spheres that are kept
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_OUT_OF_MEMORY (for
 *          0; nothing has changed then)
 *  @since 1.1 */
MGDT_API mgdt_status mgdt_set_compact(mgdt_triangulation* t, int32_t on);
/** Whether storage is compact, 0 or 1.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_compact(const mgdt_triangulation* t, int32_t* on);

/** Sets the callback that receives progress and may cancel. mgdt_insert_points(),
 *  mgdt_insert_points_strided(), mgdt_remove_points() and mgdt_move_points() call it if they are
 *  given points: with 0 before the first point, about a hundred times on the way (less often for
 *  fewer points), and with 1 when all are done, where it is too late to cancel. No other function
 *  calls it: exports, locations, mgdt_check(), mgdt_reserve() and mgdt_set_compact() cannot be
 *  cancelled.
 *  @param fn  NULL for none (default)
 *  @param user  passed to it
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_progress(mgdt_triangulation* t, mgdt_progress_fn fn, void* user);
/** The callback that is set and what is passed to it, so that it can be put back after another one.
 *  @param[out] fn    NULL if there is none
 *  @param[out] user  may be NULL: then it is not written
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_progress(const mgdt_triangulation* t, mgdt_progress_fn* fn,
                                       void** user);

/** Asks the insertion, removal or move that is running on the handle to stop soon; it returns
 *  MGDT_ERR_CANCELLED. If it finishes first, the request is dropped. If none is running, the
 *  request stays pending and stops the next one of any points, unless mgdt_clear() comes first.
 *  Safe from any thread and from signal handlers.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_cancel(mgdt_triangulation* t);

/** Makes the exported arrays depend, byte for byte, on the points, their indices and the index base
 *  alone, not on the order scheme, the threads or the division into calls: tetrahedra are sorted,
 *  the least vertex index of each first and the next least second; hull facets are sorted, the
 *  least index first; edges are sorted. Off, they come in the order of storage, which is faster.
 *  @param on  0 (default) or 1
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_canonical_output(mgdt_triangulation* t, int32_t on);
/** Whether output is canonical, 0 or 1.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_canonical_output(const mgdt_triangulation* t, int32_t* on);

/** Chooses the instruction set of the kernel; for tests and measurements. The tetrahedra are the
 *  same for each. Without this call it is the best that the processor has, or the one that the
 *  environment variable MGDT_ISA names when the handle is made.
 *  @param name  "baseline", on x86-64 "avx2" or "avx512", on arm64 "neon"; NULL for the best
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER (t), MGDT_ERR_INVALID_ARGUMENT (an unknown name, or a
 *  set that this processor does not have). mgdt_isa_name() says which it is
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_isa(mgdt_triangulation* t, const char* name);

/* ----------------------------------------------------------------------------- points --- */

/** Inserts points. They may be given in any number of calls, with the same result. Points with
 *  the coordinates of an earlier one (0 equals -0) share its vertex: see mgdt_get_point_map().
 *  Fewer than four points, or all on a plane, are kept until they span space.
 *  @param n    number of points, at least 0
 *  @param xyz  3 n coordinates, x y z of each point in turn; copied; may be NULL if n is 0
 *  @return MGDT_OK; MGDT_ERR_INVALID_ARGUMENT (n is negative, whatever xyz is),
 *  MGDT_ERR_NULL_POINTER, MGDT_ERR_NOT_FINITE (the message names the index) or MGDT_ERR_TOO_LARGE,
 *  with nothing changed; MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY or MGDT_ERR_TOO_LARGE with a
 *  valid triangulation of the points that got in. The others have no vertex in the point map; they
 *  may be given again, under new indices. mgdt_point_count() shows whether the points of the call
 *  were counted at all: running out of memory before that changes nothing. Points that were kept
 *  because they did not span space are inserted by the first call that spans it; cancelling does
 *  not lose them, running out of memory then may
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_insert_points(mgdt_triangulation* t, int64_t n, const double* xyz);

/** The same for coordinates in separate arrays or inside records.
 *  @param x, y, z  the first point's coordinates
 *  @param stride   distance from one point's x (y, z) to the next one's, in doubles, any sign. A
 *                  record with aligned doubles is a whole number of them long; coordinates that
 *                  are not aligned, as in packed records, must be copied
 *  @return as mgdt_insert_points(); MGDT_ERR_INVALID_ARGUMENT also if the stride takes the points
 *  beyond all memory
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_insert_points_strided(mgdt_triangulation* t, int64_t n, const double* x,
                                                const double* y, const double* z, int64_t stride);

/** Takes points out. The tetrahedra are then those of the points that remain. Of several points at
 *  one place the vertex stays until the last of them goes; the first that remains stands for it.
 *  Points that no longer span space are kept until others span it with them. Every other point
 *  keeps its index; one that is out is not in the point map, counts in mgdt_point_count() until
 *  mgdt_renumber_points(), and can come back as a new point alone.
 *  @param n       number of points, at least 0
 *  @param points  n indices, in any order, each once; may be NULL if n is 0
 *  @return MGDT_OK; MGDT_ERR_INVALID_ARGUMENT (n is negative, whatever points is; an index of no
 *  point, of one that is not in, or one that is there twice: the message names it) or
 *  MGDT_ERR_NULL_POINTER, with nothing changed; MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY or
 *  MGDT_ERR_TOO_LARGE with a valid triangulation: as many points as the message says are out (none
 *  where it does not say), and the others are in; the point map says which
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_remove_points(mgdt_triangulation* t, int64_t n, const int64_t* points);
/** @copydoc mgdt_remove_points
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_remove_points_i32(mgdt_triangulation* t, int64_t n,
                                            const int32_t* points);

/** Moves points to other places. They keep their indices, and the tetrahedra are then those of all
 *  points where they are. Of several points at one place each can go elsewhere, and a point that
 *  comes to another shares its vertex; the first of them stands for it. Points may come to span
 *  space, or cease to. A point that does not change costs little.
 *  @param n       number of points: at least 0; 0 or mgdt_point_count(t) if points is NULL
 *  @param points  n indices, in any order, each once; or NULL for all points in their order, where
 *                 those that are not in stay out, whatever their coordinates
 *  @param xyz     3 n coordinates, x y z of each point in turn; copied; may be NULL if n is 0
 *  @return MGDT_OK; MGDT_ERR_INVALID_ARGUMENT (as mgdt_remove_points(), and an n other than
 *  mgdt_point_count(t) without a list), MGDT_ERR_NULL_POINTER or MGDT_ERR_NOT_FINITE (the message
 *  names the index), with nothing changed; MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY or
 *  MGDT_ERR_TOO_LARGE with a valid triangulation: the first points of the list have moved, as
 *  many as the message says (none where it does not say), and the others are where they were.
 *  Without a list, points that are not in do not count there
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_move_points(mgdt_triangulation* t, int64_t n, const int64_t* points,
                                      const double* xyz);
/** @copydoc mgdt_move_points
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_move_points_i32(mgdt_triangulation* t, int64_t n, const int32_t* points,
                                          const double* xyz);

/** Numbers the points that are in anew, in their order, from the index base on, and forgets those
 *  that are not: mgdt_point_count() is then the number of points that are in. Nothing is renumbered
 *  without this call.
 *  @param capacity        elements in new_index, at least mgdt_point_count(t) before the call
 *  @param[out] new_index  for each point its new index, or none if it was not in; may be NULL if
 *                         there are no points
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_BUFFER_TOO_SMALL
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_renumber_points(mgdt_triangulation* t, int64_t capacity,
                                          int64_t* new_index);
/** @copydoc mgdt_renumber_points
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_renumber_points_i32(mgdt_triangulation* t, int64_t capacity,
                                              int32_t* new_index);

/* ----------------------------------------------------------------------------- counts --- */

/** Number of points ever given to the handle, those refused whole and those that
 *  mgdt_renumber_points() forgot left out; 0 for NULL.
 *  @since 1.0 */
MGDT_API int64_t mgdt_point_count(const mgdt_triangulation* t);

/** Number of vertices: distinct points that are in; 0 for NULL.
 *  @since 1.0 */
MGDT_API int64_t mgdt_vertex_count(const mgdt_triangulation* t);

/** Dimension of the points' affine hull: -1 empty (or NULL), 0 one point, 1 a line, 2 a plane,
 *  3 space. There are tetrahedra only at 3.
 *  @since 1.0 */
MGDT_API int32_t mgdt_dimension(const mgdt_triangulation* t);

/** Number of tetrahedra; 0 for NULL.
 *  @since 1.0 */
MGDT_API int64_t mgdt_tetrahedron_count(const mgdt_triangulation* t);

/** Number of triangles on the convex hull; 0 for NULL.
 *  @since 1.0 */
MGDT_API int64_t mgdt_hull_facet_count(const mgdt_triangulation* t);

/** Number of edges of the tetrahedra; 0 for NULL.
 *  @since 1.0 */
MGDT_API int64_t mgdt_edge_count(const mgdt_triangulation* t);

/** Length of the list of mgdt_get_vertex_tetrahedra(): 4 times the tetrahedra; 0 for NULL.
 *  @since 1.0 */
MGDT_API int64_t mgdt_vertex_tetrahedra_count(const mgdt_triangulation* t);

/** Length of the list of mgdt_get_vertex_neighbors(): twice the edges; 0 for NULL.
 *  @since 1.2 */
MGDT_API int64_t mgdt_vertex_neighbors_count(const mgdt_triangulation* t);

/* ----------------------------------------------------------------------------- export --- */

/** Writes the vertices of each tetrahedron, 4 per tetrahedron, positively oriented:
 *  (v1 - v0) x (v2 - v0) . (v3 - v0) > 0, exactly. A vertex is the index of the first point
 *  that is in at its place.
 *  @param capacity  elements in v, at least 4 mgdt_tetrahedron_count(t)
 *  @param[out] v    may be NULL if there are no tetrahedra
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_BUFFER_TOO_SMALL,
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_tetrahedra(const mgdt_triangulation* t, int64_t capacity, int64_t* v);
/** @copydoc mgdt_get_tetrahedra
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_tetrahedra_i32(const mgdt_triangulation* t, int64_t capacity,
                                             int32_t* v);

/** Writes the neighbours of each tetrahedron, 4 per tetrahedron, in the order of
 *  mgdt_get_tetrahedra(): neighbour i shares the facet opposite vertex i; none on the hull.
 *  @param capacity  elements in v, at least 4 mgdt_tetrahedron_count(t)
 *  @return as mgdt_get_tetrahedra()
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_neighbors(const mgdt_triangulation* t, int64_t capacity, int64_t* v);
/** @copydoc mgdt_get_neighbors
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_neighbors_i32(const mgdt_triangulation* t, int64_t capacity,
                                            int32_t* v);

/** Writes the triangles of the convex hull, 3 vertices each, counter-clockwise seen from outside.
 *  Coplanar parts of the hull come as the triangles of the perturbed triangulation.
 *  @param capacity  elements in v, at least 3 mgdt_hull_facet_count(t)
 *  @return as mgdt_get_tetrahedra()
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_hull_facets(const mgdt_triangulation* t, int64_t capacity,
                                          int64_t* v);
/** @copydoc mgdt_get_hull_facets
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_hull_facets_i32(const mgdt_triangulation* t, int64_t capacity,
                                              int32_t* v);

/** Writes the edges, 2 vertices each, the lesser index first; each edge once.
 *  @param capacity  elements in v, at least 2 mgdt_edge_count(t)
 *  @return as mgdt_get_tetrahedra()
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_edges(const mgdt_triangulation* t, int64_t capacity, int64_t* v);
/** @copydoc mgdt_get_edges
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_edges_i32(const mgdt_triangulation* t, int64_t capacity, int32_t* v);

/** Writes for each point of mgdt_point_count() the index of the point that stands for it as a
 *  vertex: its own, or that of the first point that is in at the same place, or none if it is not
 *  in.
 *  @param capacity  elements in v, at least mgdt_point_count(t)
 *  @return as mgdt_get_tetrahedra()
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_point_map(const mgdt_triangulation* t, int64_t capacity, int64_t* v);
/** @copydoc mgdt_get_point_map
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_point_map_i32(const mgdt_triangulation* t, int64_t capacity,
                                            int32_t* v);

/** Writes the tetrahedra around each vertex as a compressed list. Those of point k (counted from
 *  0) are list[offsets[k] - base] to list[offsets[k + 1] - base - 1], ascending. A point that is
 *  no vertex has none.
 *  @param offset_capacity  elements in offsets, at least mgdt_point_count(t) + 1
 *  @param[out] offsets     positions in list, in the handle's index base
 *  @param capacity         elements in list, at least mgdt_vertex_tetrahedra_count(t)
 *  @param[out] list        numbers of tetrahedra
 *  @return as mgdt_get_tetrahedra()
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_vertex_tetrahedra(const mgdt_triangulation* t,
                                                int64_t offset_capacity, int64_t* offsets,
                                                int64_t capacity, int64_t* list);
/** @copydoc mgdt_get_vertex_tetrahedra
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_vertex_tetrahedra_i32(const mgdt_triangulation* t,
                                                    int64_t offset_capacity, int32_t* offsets,
                                                    int64_t capacity, int32_t* list);

/** Writes the neighbours of each vertex, the vertices that edges join it to, as a compressed list.
 *  Those of point k (counted from 0) are list[offsets[k] - base] to list[offsets[k + 1] - base -
 * 1], ascending. A point that is no vertex has none, and there are none without tetrahedra.
 *  @param offset_capacity  elements in offsets, at least mgdt_point_count(t) + 1
 *  @param[out] offsets     positions in list, in the handle's index base
 *  @param capacity         elements in list, at least mgdt_vertex_neighbors_count(t)
 *  @param[out] list        indices of points; may be NULL if there are no tetrahedra
 *  @return as mgdt_get_tetrahedra()
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_vertex_neighbors(const mgdt_triangulation* t, int64_t offset_capacity,
                                               int64_t* offsets, int64_t capacity, int64_t* list);
/** @copydoc mgdt_get_vertex_neighbors
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_vertex_neighbors_i32(const mgdt_triangulation* t,
                                                   int64_t offset_capacity, int32_t* offsets,
                                                   int64_t capacity, int32_t* list);

/** Writes the Gabriel graph: the edges that are the diameter of a sphere with no vertex inside,
 *  decided exactly. Of those that cross in the middle of one sphere, as the diagonals of a square,
 *  it has the one that is an edge of tetrahedra. 2 vertices each, the lesser index first, in the
 *  order of these; each edge once. There are none without tetrahedra. With threads
 *  (mgdt_set_threads()).
 *  @param capacity    elements in v, at least 2 count; 2 mgdt_edge_count(t) is always enough
 *  @param[out] v      may be NULL if there are none
 *  @param[out] count  how many edges there are, also where v is too small for them
 *  @return as mgdt_get_tetrahedra()
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_gabriel_edges(const mgdt_triangulation* t, int64_t capacity,
                                            int64_t* v, int64_t* count);
/** @copydoc mgdt_get_gabriel_edges
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_gabriel_edges_i32(const mgdt_triangulation* t, int64_t capacity,
                                                int32_t* v, int32_t* count);

/** Writes the edges of the Euclidean minimum spanning tree, which joins all vertices and has the
 *  least length, decided exactly; of trees that are equally long it has the edges that come first
 *  among those of one length. 2 vertices each, the lesser index first, in the order of these. There
 *  are none without tetrahedra.
 *  @param capacity    elements in v, at least 2 (mgdt_vertex_count(t) - 1)
 *  @param[out] v      may be NULL if there are none
 *  @param[out] count  how many edges there are, also where v is too small for them
 *  @return as mgdt_get_tetrahedra()
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_spanning_tree(const mgdt_triangulation* t, int64_t capacity,
                                            int64_t* v, int64_t* count);
/** @copydoc mgdt_get_spanning_tree
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_spanning_tree_i32(const mgdt_triangulation* t, int64_t capacity,
                                                int32_t* v, int32_t* count);

/** Writes the centre of each tetrahedron's circumsphere, a vertex of the Voronoi diagram, and the
 *  square of its radius, in the order of mgdt_get_tetrahedra(). Each number is the double nearest
 *  to the exact one, and infinite beyond the largest double. So tetrahedra with one circumsphere,
 *  as in a lattice, have the same numbers. With threads (mgdt_set_threads()).
 *  @param capacity      tetrahedra that there is room for, at least mgdt_tetrahedron_count(t)
 *  @param[out] xyz      3 capacity elements: x y z of each centre; may be NULL if there are no
 *                       tetrahedra
 *  @param[out] radius2  capacity elements; or NULL
 *  @return as mgdt_get_tetrahedra()
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_circumcenters(const mgdt_triangulation* t, int64_t capacity,
                                            double* xyz, double* radius2);

/** Measures the Voronoi cell of each point: what is nearer to it than to any other point. Without
 *  planes, cells of hull vertices have no end: their volumes, areas and centroids are infinite, and
 *  their faces are counted. With planes, which have to bound a convex region, cells are clipped to
 *  it, and together they fill it. A point that is no vertex has 0. The same numbers whatever the
 *  order of insertion and the number of threads (mgdt_set_threads()).
 *
 *  Volumes and areas are off by less than 1e-12 of themselves, and centroids by less than 1e-12
 *  of the distance of the cell's farthest corner from the point. Faces are counted exactly: cells
 *  of a cubic lattice have 6. Numbers beyond the largest double are infinite.
 *  docs/theory.md, "Cells".
 *  @param measure   an MGDT_MEASURE_ value
 *  @param n_planes  number of planes, at least 0
 *  @param planes    4 n_planes elements, a b c d each: the region is where a x + b y + c z <= d. No
 *                   point may be outside by more than rounding. Planes may be needless or come
 *                   twice. May be NULL if there are none
 *  @param capacity  elements in x, at least mgdt_point_count(t), or three times that for centroids
 *  @param[out] x    a number, or x y z of a centroid, for each point
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_NOT_FINITE (a plane),
 *  MGDT_ERR_BUFFER_TOO_SMALL, MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_INVALID_ARGUMENT (a negative number;
 *  points that are all in one plane, unless there are none; a point outside; planes that do not
 *  bound a region; the message says which)
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_cell_measures(const mgdt_triangulation* t, int32_t measure,
                                            int64_t n_planes, const double* planes,
                                            int64_t capacity, double* x);

/** Writes the alpha of each simplex of a dimension, the square of the radius at which it joins the
 *  alpha shape: that of the least sphere through its vertices if no vertex is inside it, which is
 *  decided exactly, and otherwise the least alpha of the simplices that it is a face of. So a face
 *  never has a larger alpha than what it is a face of. Alphas of tetrahedra are those of
 *  mgdt_get_circumcenters(), others have a relative error below 2e-14. With threads
 *  (mgdt_set_threads()).
 *  @param dimension    3: of the tetrahedra, in the order of mgdt_get_tetrahedra(). 2: of facets, 4
 *                      a tetrahedron, the i-th opposite its vertex i; those that are shared come
 *                      twice. 1: of the edges, in the order of mgdt_get_edges(). 0: of the
 *                      points, 0 of a vertex and infinite of one that is none
 *  @param capacity     elements in alpha2, at least mgdt_tetrahedron_count(t), 4 times that,
 *                      mgdt_edge_count(t), or mgdt_point_count(t)
 *  @param[out] alpha2  may be NULL if there are none
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_BUFFER_TOO_SMALL,
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_alphas(const mgdt_triangulation* t, int32_t dimension,
                                     int64_t capacity, double* alpha2);

/** Writes the surface of an alpha shape: the facets between the tetrahedra whose alpha is at most
 *  alpha2 and all others. It is closed and oriented: each facet counter-clockwise seen from
 *  outside, its least vertex first, and at each edge as many turn one way as the other. Facets with
 *  no such tetrahedron at all are left out. In ascending order.
 *  @param alpha2      the square of a radius, at least 0; infinite for the convex hull
 *  @param capacity    elements in v, at least 3 count; 12 mgdt_tetrahedron_count(t) always do
 *  @param[out] v      3 vertices of each facet; may be NULL if there are none
 *  @param[out] count  how many facets there are, also where v is too small for them
 *  @return as mgdt_get_tetrahedra(), and MGDT_ERR_INVALID_ARGUMENT for an alpha2 below 0 or NaN
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_alpha_surface(const mgdt_triangulation* t, double alpha2,
                                            int64_t capacity, int64_t* v, int64_t* count);
/** @copydoc mgdt_get_alpha_surface
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_alpha_surface_i32(const mgdt_triangulation* t, double alpha2,
                                                int64_t capacity, int32_t* v, int32_t* count);

/** The least alpha whose tetrahedra are one solid, each reached from any other through facets, that
 *  has all vertices.
 *  @param[out] alpha2  the square of a radius; 0 if there are no points
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_INVALID_ARGUMENT (the
 *  points are all in one plane)
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_solid_alpha(const mgdt_triangulation* t, double* alpha2);

/* ---------------------------------------------------------------------------- queries --- */

/** Finds the tetrahedron that contains a point, its boundary included; none outside the hull. On
 *  a shared facet, edge or vertex it is one of those that share it.
 *  @param xyz                3 coordinates
 *  @param[out] tetrahedron   its number, or none
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_NOT_FINITE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_locate(const mgdt_triangulation* t, const double* xyz,
                                 int64_t* tetrahedron);
/** @copydoc mgdt_locate
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_locate_i32(const mgdt_triangulation* t, const double* xyz,
                                     int32_t* tetrahedron);

/** The same for many points, in any order: much faster than single calls.
 *  @param n                number of points, at least 0
 *  @param xyz              3 n coordinates
 *  @param[out] tetrahedra  n numbers
 *  @param[out] weights     4 n barycentric coordinates, in the order of the tetrahedron's
 *                          vertices in mgdt_get_tetrahedra(), for interpolation; zeros where
 *                          there is no tetrahedron; or NULL. Each is between 0 and 1, has a
 *                          relative error of at most 3.01 * 2^-53, plus 2^-1075 if it is
 *                          subnormal, and is 0 if the point is on the facet opposite. So the
 *                          weighted sum of the vertices, computed in doubles, is the point:
 *                          along each axis it differs by at most 7.01 * 2^-53 times the largest
 *                          magnitude among the vertices, plus 2^-1073, in every tetrahedron,
 *                          however flat
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_NOT_FINITE (the
 *  message names the point; nothing is written), MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_locate_points(const mgdt_triangulation* t, int64_t n, const double* xyz,
                                        int64_t* tetrahedra, double* weights);
/** @copydoc mgdt_locate_points
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_locate_points_i32(const mgdt_triangulation* t, int64_t n,
                                            const double* xyz, int32_t* tetrahedra,
                                            double* weights);

/** Finds the vertex nearest to a point, exactly; of several that are equally near, the one with the
 *  lowest index. Works in
 *  every dimension.
 *  @param xyz          3 coordinates
 *  @param[out] vertex  its index; none if the triangulation is empty
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_NOT_FINITE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_nearest_vertex(const mgdt_triangulation* t, const double* xyz,
                                         int64_t* vertex);
/** @copydoc mgdt_nearest_vertex
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_nearest_vertex_i32(const mgdt_triangulation* t, const double* xyz,
                                             int32_t* vertex);

/** The same for many points, in any order, and with threads (mgdt_set_threads()): much faster than
 *  single calls. Where there are no tetrahedra, each point is compared with every vertex.
 *  @param n              number of points, at least 0
 *  @param xyz            3 n coordinates
 *  @param[out] vertices  n indices of vertices; none if the triangulation is empty
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_NOT_FINITE (the
 *  message names the point; nothing is written), MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_nearest_vertices(const mgdt_triangulation* t, int64_t n,
                                           const double* xyz, int64_t* vertices);
/** @copydoc mgdt_nearest_vertices
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_nearest_vertices_i32(const mgdt_triangulation* t, int64_t n,
                                               const double* xyz, int32_t* vertices);

/* --------------------------------------------------------------- values between points --- */

/** Values at any places from values at the points. Within the convex hull, its boundary included,
 *  each place has a value, also where the points are all in one plane, which allows
 *  MGDT_INTERPOLATE_NEAREST alone. Every other method gives a linear function again. At a point the
 *  value is that of the point; of equal points, that of the vertex, the least index among them. The
 *  value of a point that is not in is not read. The result depends neither on the number of threads
 *  nor on the order of the places. Weights of natural neighbours, whose sum is 1, are off by less
 *  than 2^-30, and on ordinary points by some 1e-13.
 *  @param method    an MGDT_INTERPOLATE_ value
 *  @param outside   an MGDT_OUTSIDE_ value
 *  @param n_fields  numbers for each point and each place, at least 0
 *  @param values    n_fields numbers for each of mgdt_point_count() points, those of a point one
 *                   behind the other
 *  @param n         number of places, at least 0
 *  @param xyz       3 n coordinates
 *  @param[out] out  n_fields numbers for each place; NaN where there is no value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (also: the points are all in
 *  one plane, where the method is not MGDT_INTERPOLATE_NEAREST), MGDT_ERR_UNKNOWN_KEY,
 *  MGDT_ERR_NOT_FINITE (the message names the place; nothing is written), MGDT_ERR_TOO_LARGE,
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_interpolate(const mgdt_triangulation* t, int32_t method, int32_t outside,
                                      int64_t n_fields, const double* values, int64_t n,
                                      const double* xyz, double* out);

/** The same as weights, for as many fields as you like later: the value at place i, counted from
 *  0, is the sum of weights[k] times the value of point points[k], for k + base from offsets[i] to
 *  before offsets[i + 1]. Points ascend within a place. Their weights add up to 1; where there is
 *  no value, there are none. A place has at most 4 for the linear method; those of
 *  MGDT_INTERPOLATE_SIBSON_C1 and of MGDT_OUTSIDE_LINEAR have the neighbours of neighbours too, and
 *  may be negative.
 *  @param method           an MGDT_INTERPOLATE_ value
 *  @param outside          an MGDT_OUTSIDE_ value
 *  @param n                number of places, at least 0
 *  @param xyz              3 n coordinates
 *  @param offset_capacity  elements in offsets, at least n + 1
 *  @param[out] offsets     where each place's weights begin; written also if the capacity is too
 *                          small
 *  @param capacity         elements in points, and in weights
 *  @param[out] points      indices of points; with NULL for it and for weights, offsets are all
 *                          that is wanted
 *  @param[out] weights     a weight for each
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_UNKNOWN_KEY,
 *  MGDT_ERR_NOT_FINITE, MGDT_ERR_BUFFER_TOO_SMALL (offsets are written; nothing else),
 *  MGDT_ERR_OUT_OF_MEMORY; as mgdt_interpolate()
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_interpolation_weights(const mgdt_triangulation* t, int32_t method,
                                                    int32_t outside, int64_t n, const double* xyz,
                                                    int64_t offset_capacity, int64_t* offsets,
                                                    int64_t capacity, int64_t* points,
                                                    double* weights);
/** @copydoc mgdt_get_interpolation_weights
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_interpolation_weights_i32(const mgdt_triangulation* t, int32_t method,
                                                        int32_t outside, int64_t n,
                                                        const double* xyz, int64_t offset_capacity,
                                                        int32_t* offsets, int64_t capacity,
                                                        int32_t* points, double* weights);

/** Gradients of values at the points: of the linear function through a vertex's value that is
 *  nearest to those of its neighbours, in the sense of least squares of differences divided by
 *  distances. A linear function has its gradient everywhere.
 *  @param n_fields  numbers for each point, at least 0
 *  @param values    as mgdt_interpolate()
 *  @param[out] out  3 numbers, the derivatives by x, y and z, for each field of each point; equal
 *                   points have the same; NaN for a point that is not in
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (also: the points are all in
 *  one plane), MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_gradients(const mgdt_triangulation* t, int64_t n_fields,
                                        const double* values, double* out);

/* ------------------------------------------------------------------------------ trust --- */

/** Proves that the triangulation is what it claims to be, by exact arithmetic, in linear time.
 *  @param level  an MGDT_CHECK_ value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_CHECK_FAILED (the
 *  message says what and where), MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_check(const mgdt_triangulation* t, int32_t level);

/* ---------------------------------------------------------------------------- figures --- */

/** Gives one figure about the handle.
 *  @param key  an MGDT_STAT_ key
 *  @param[out] value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_stat(const mgdt_triangulation* t, int32_t key, double* value);

/** Name of a statistic ("walk steps"); NULL for an unknown key.
 *  @since 1.0 */
MGDT_API const char* mgdt_stat_name(int32_t key);

/* ------------------------------------------------------------------------------- text --- */

/** One line that describes a status; never NULL. The string is static.
 *  @since 1.0 */
MGDT_API const char* mgdt_status_string(mgdt_status s);

/** Copies the message of the last call that failed on the handle, NUL-terminated and cut to
 *  capacity; an empty string if none has failed. Calls that succeed leave it. With calls from
 * several threads it is the last of any of them. Never busy: callbacks and other threads may call
 * it at any time.
 *  @param capacity     bytes in buffer, at least 1
 *  @param[out] buffer  256 bytes hold every message
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_error(const mgdt_triangulation* t, int64_t capacity, char* buffer);

/** Name of an order scheme ("multi-grid"); NULL for an unknown one. The string is static.
 *  @since 1.0 */
MGDT_API const char* mgdt_order_scheme_name(int32_t scheme);

/** The order scheme of a name.
 *  @param[out] scheme  an MGDT_ORDER_ value; not touched if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_SCHEME
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_order_scheme_from_name(const char* name, int32_t* scheme);

/** The order schemes one by one, so that all can be listed: the default first, then by number.
 *  @param index  from 0, whatever the index base of a handle
 *  @param[out] scheme  an MGDT_ORDER_ value; not touched if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_SCHEME from the number of schemes on
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_order_scheme_at(int32_t index, int32_t* scheme);

/** Version of the library that is running, for example "1.2.0". The string is static.
 *  @since 1.0 */
MGDT_API const char* mgdt_version_string(void);

/** Version of the binary interface: 1. Programs built for it run with every library that says 1.
 *  @since 1.0 */
MGDT_API int32_t mgdt_abi_version(void);

/** Instruction set of the kernel that the handle uses ("baseline", see mgdt_set_isa()). The
 *  string is static; an empty one for NULL.
 *  @since 1.0 */
MGDT_API const char* mgdt_isa_name(const mgdt_triangulation* t);

#ifdef __cplusplus
}
#endif

#endif /* MGDT_MGDT_H */
