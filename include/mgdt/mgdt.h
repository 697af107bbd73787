/* SPDX-License-Identifier: MIT
 *
 * mgdt: exact 3D Delaunay triangulation of any set of points.
 *
 * This header is the C interface of one triangulation. It can be read from top to bottom as a
 * manual. The headers are C99, and C++ may include them. The others include this one and follow
 * its conventions:
 *
 * - mgdt_voronoi.h: Voronoi diagrams as objects
 * - mgdt_domain.h: surfaces, segments and regions that a mesh of tetrahedra has to have
 * - mgdt_mesh.h: these meshes
 * - mgdt_periodic.h: points in periodic boxes, slabs and wires
 * - mgdt_parts.h: triangulations in parts
 * - mgdt_mpi.h: triangulations whose parts are on the ranks of an MPI communicator
 * - mgdt.hpp: all of these for C++17
 *
 * Conventions, for every function:
 *
 * - A function that can fail returns an mgdt_status: MGDT_OK (0) or one of the errors below.
 *   mgdt_get_error() gives a message that says what was wrong and where.
 * - A call that fails because of its arguments changes nothing. A call that is cancelled or runs
 *   out of memory leaves a valid Delaunay triangulation of the points that were inserted.
 * - The library never prints, exits, throws, installs a signal handler, or writes to an array
 *   that is not documented as output. It restores the floating-point environment.
 *   Callbacks run in the default environment, and the library undoes their changes to it.
 * - No call is a cancellation point of POSIX threads, whatever its callbacks do: pthread_cancel()
 *   of the calling thread acts after the call. The call disables cancellation and restores its
 *   state at the end. A thread of the asynchronous type (PTHREAD_CANCEL_ASYNCHRONOUS) is cancelled
 *   as the call ends; the handle then has everything that the call did.
 * - Coordinates are in one unit of length, which the caller chooses. Every finite double is
 *   accepted.
 * - Indices start at the handle's index base (0, or 1 for Fortran): the k-th point ever given
 *   to the handle, k = 0, 1, ..., has index k + base, and tetrahedra are numbered likewise.
 *   "None" is base - 1. A point keeps its index until mgdt_clear() or mgdt_renumber_points().
 *   Numbers of tetrahedra are valid until the next insertion, removal or move, mgdt_clear(),
 *   mgdt_renumber_points(), mgdt_set_index_base() or mgdt_set_canonical_output().
 * - The caller allocates output arrays and passes their capacity, in array elements (not in bytes,
 *   not in tetrahedra). If an array is too small, the call returns MGDT_ERR_BUFFER_TOO_SMALL and
 *   does not write to the array.
 * - Handles of mgdt_voronoi.h, mgdt_domain.h, mgdt_mesh.h and mgdt_periodic.h have keys: options
 *   are 1 to 99, statistics 100 to 199, arrays of integers 200 to 299, and arrays of doubles 300
 *   to 399, in all later versions too. A key of another kind is MGDT_ERR_UNKNOWN_KEY.
 * - A function whose name ends in _i32 does what its namesake does, with 32-bit integers in the
 *   arrays. If an index does not fit, it returns MGDT_ERR_INDEX_RANGE.
 * - Thread rule: calls that take a `const mgdt_triangulation *` may run on one handle from many
 *   threads at once. While a call that takes a non-const handle runs, no other call may use that
 *   handle, except mgdt_cancel(). Different handles are independent.
 * - Callbacks (progress and allocator) must not call functions with the handle that they serve,
 *   except mgdt_cancel() and mgdt_get_error().
 * - A call that breaks one of these two rules returns MGDT_ERR_BUSY, changes nothing and writes no
 *   output; the message names the call that is running on the handle. While a call with a non-const
 *   handle runs, every other call but mgdt_cancel() and mgdt_get_error() is refused. Functions that
 *   return no status then answer as for an empty handle: counts are 0, the dimension is -1,
 *   mgdt_isa_name() returns an empty string, and mgdt_destroy() does nothing. While a call with a
 *   const handle runs, calls with a non-const handle are refused, and mgdt_destroy() does nothing.
 *   One case is not detected: a call with a non-const handle from another thread while
 *   mgdt_locate(), mgdt_nearest_vertex(), their _i32 forms, a getter of a setting, mgdt_get_stat()
 *   or a count runs. (Since 1.2. Earlier versions did not detect any of this.) Calls that read
 *   the handle are not refused to an allocator callback of a call that reads it.
 * - Callbacks must return: no longjmp(), no pthread_exit(). They should not throw. An exception
 *   from the progress callback counts as a nonzero result, one from an mgdt_alloc_fn as NULL, and
 *   one from an mgdt_free_fn is dropped.
 * - A call uses less than 32 KiB of stack on its own thread and on each thread that it starts,
 *   whatever the points are. The stack that callbacks use comes on top of that.
 */
#ifndef MGDT_MGDT_H
#define MGDT_MGDT_H

#include <stddef.h>
#include <stdint.h>

#define MGDT_VERSION_MAJOR 1
#define MGDT_VERSION_MINOR 4
#define MGDT_VERSION_PATCH 0

/** Whether this header has at least the given version: `#if MGDT_VERSION_AT_LEAST(1, 2)`. Headers
 *  before 1.2 do not define this macro.
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

/** A handle of a triangulation. The struct is opaque; mgdt_create() makes one. */
typedef struct mgdt_triangulation mgdt_triangulation;

/** The outcome of a call: one of the MGDT_OK / MGDT_ERR_ values. */
typedef int32_t mgdt_status;

/** Values of mgdt_status. New ones may be added; existing ones never change. */
enum {
    MGDT_OK = 0,                    /**< Success. */
    MGDT_ERR_NULL_POINTER = 10,     /**< A pointer that must not be NULL is NULL. */
    MGDT_ERR_INVALID_ARGUMENT = 11, /**< A value is out of its documented range. */
    MGDT_ERR_NOT_FINITE = 12,       /**< A coordinate is NaN or infinite. */
    MGDT_ERR_UNKNOWN_SCHEME = 13,   /**< No MGDT_ORDER_ value, or no name of one. */
    MGDT_ERR_UNKNOWN_KEY = 14,      /**< There is no such key of what is asked for: a statistic, a
                                     *   parameter, an option, an array or a measure. */
    /** A result is asked for before the call that makes it, or after a change that has removed it.
     *  Nothing is written. Since 1.3. */
    MGDT_ERR_NOT_BUILT = 15,
    MGDT_ERR_BUFFER_TOO_SMALL = 20, /**< The capacity is less than what must be written. */
    MGDT_ERR_INDEX_RANGE = 21,      /**< An index does not fit a 32-bit integer. */
    MGDT_ERR_OUT_OF_MEMORY = 30,    /**< The allocator or the memory limit refused. */
    MGDT_ERR_TOO_LARGE = 31,        /**< More points or tetrahedra than can be numbered. */
    MGDT_ERR_CANCELLED = 40,        /**< mgdt_cancel() or the progress callback asked to stop. */
    MGDT_ERR_BUSY = 41, /**< Another call is running on the handle: a callback called its
                         *   own handle, or two threads broke the thread rule. Every
                         *   function that takes a handle may return it, except
                         *   mgdt_cancel() and mgdt_get_error(). Since 1.2. */
    /** A function of an mgdt_transport reported a failure. Since 1.2. */
    MGDT_ERR_TRANSPORT = 50,
    MGDT_ERR_CHECK_FAILED = 60, /**< A check, such as mgdt_check(), found a defect. */
    /** Facets, segments or points of a domain cross or touch where they must not, or are flat.
     *  Since 1.3. */
    MGDT_ERR_INVALID_BOUNDARY = 70,
    /** The mesh of a domain needs points nearer to each other than double precision allows, or so
     *  many on its segments that the build gives up. Since 1.3. */
    MGDT_ERR_RESOLUTION = 71,
    /** The facets of a domain enclose nothing. Since 1.3. */
    MGDT_ERR_OPEN_BOUNDARY = 72,
    MGDT_ERR_INTERNAL = 90 /**< A defect of mgdt itself; please report it. */
};

/** Order schemes: in which order the points of one call are inserted. The time depends on the
 *  scheme, the tetrahedra do not. mgdt_order_scheme_name() returns the names below in lower case
 *  with hyphens. Section numbers are those of S.H. Lo, Finite Elements in Analysis and Design 90
 *  (2014) 113-130. */
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

/** Parameters of the order schemes, for mgdt_set_order_parameter(). A scheme ignores the parameters
 *  of other schemes. */
enum {
    /** Mean number of points in a cell. Default 8 (grids), 10 (kd-tree), 1000 (cells of the
     *  enhanced kd-tree; its inner grids use 8). Range 1 to 1e6; 0 restores the default. With
     *  MGDT_SEPARATION_ROUNDS, which is its default, multi-grid ignores this value and makes its
     *  cells as small as its sort keys can number. */
    MGDT_PARAMETER_POINTS_PER_CELL = 10,
    /** Multi-grid: a cell with more points than this gets a grid of its own. Default 8, or
     *  200 without MGDT_SEPARATION_ROUNDS; range 1 to 1e9; 0 restores the default. */
    MGDT_PARAMETER_THRESHOLD = 20,
    /** Regular grid and multi-grid: an MGDT_SEPARATION_ value, which says how the points of one
     *  cell are kept apart in the order. The default is MGDT_SEPARATION_ROUNDS, with which
     *  multi-grid follows a Hilbert curve. */
    MGDT_PARAMETER_SEPARATION = 30,
    /** BRIO: each round holds this many times the points of all rounds before it, plus one.
     *  Default 7.5, range above 1 to 1e6; 0 restores the default. */
    MGDT_PARAMETER_ROUND_RATIO = 40
};

/** Values of MGDT_PARAMETER_SEPARATION. Names since 1.2. */
enum {
    MGDT_SEPARATION_NONE = 0,   /**< All points of a cell come before those of the next cell. */
    MGDT_SEPARATION_PASSES = 1, /**< Each pass takes one point of each cell (4.3). */
    /** The points along the path are divided into rounds. One of each 12 consecutive points goes
     *  to an earlier round, whose points are divided in the same way, and so on. If at most 4,096
     *  points are divided, one of each 4 goes to an earlier round. */
    MGDT_SEPARATION_ROUNDS = 2
};

/** Keys of mgdt_get_stat(). Counts and seconds add up since mgdt_create() or mgdt_clear(); seconds
 *  are wall-clock time. MGDT_STAT_POINTS_INSERTED and MGDT_STAT_DUPLICATES count the points that
 *  are in the triangulation now. Levels, rounds and threads are those of the last insertion.
 *  mgdt_clear() does not reset the memory figures. */
enum {
    MGDT_STAT_POINTS_INSERTED = 10,    /**< Points that became vertices. */
    MGDT_STAT_DUPLICATES = 11,         /**< Points equal to an earlier vertex. */
    MGDT_STAT_POINTS_REMOVED = 12,     /**< Points removed. Since 1.2. */
    MGDT_STAT_POINTS_MOVED = 13,       /**< Points moved to other coordinates. Since 1.2. */
    MGDT_STAT_PUT_BACK = 14,           /**< Moves that inserted the point anew. Since 1.2. */
    MGDT_STAT_REBUILDS = 15,           /**< Removals and moves that rebuilt all. Since 1.2. */
    MGDT_STAT_WALK_STEPS = 20,         /**< Tetrahedra visited by walks (the paper's NP, summed). */
    MGDT_STAT_WALK_TESTS = 21,         /**< Circumspheres evaluated by walks. */
    MGDT_STAT_CONFLICT_TESTS = 22,     /**< Circumspheres evaluated while cavities grew. */
    MGDT_STAT_TETRAHEDRA_REMOVED = 30, /**< Tetrahedra removed by insertions (NR, summed). */
    MGDT_STAT_TETRAHEDRA_CREATED = 31, /**< Tetrahedra created by insertions. */
    /** Neighbours of the vertices that removals and moves took out, summed. Since 1.2. */
    MGDT_STAT_LINK_VERTICES = 32,
    MGDT_STAT_EXACT_CALLS = 40,    /**< Decisions that the floating-point filter left open. */
    MGDT_STAT_PUT_OFF = 45,        /**< Insertions that met another thread and were tried again. */
    MGDT_STAT_INSERTED_ALONE = 46, /**< Points inserted while other threads had no work. */
    MGDT_STAT_ORDER_SECONDS = 50,  /**< Time spent ordering more than 16 points. */
    MGDT_STAT_INSERT_SECONDS = 51, /**< Time spent inserting, rebuilds included. */
    MGDT_STAT_REMOVE_SECONDS = 52, /**< Time spent in mgdt_remove_points(). Since 1.2. */
    MGDT_STAT_MOVE_SECONDS = 53,   /**< Time spent in mgdt_move_points(). Since 1.2. */
    MGDT_STAT_GRID_LEVELS = 60,    /**< Deepest level of grids or trees in the last schedule. */
    MGDT_STAT_ROUNDS = 61,         /**< Rounds in the last schedule. */
    MGDT_STAT_THREADS = 62,        /**< Threads of the last insertion. */
    MGDT_STAT_MEMORY_BYTES = 70,   /**< Memory that the handle holds. */
    MGDT_STAT_PEAK_MEMORY_BYTES = 71 /**< The most memory that it has held. */
};

/** Levels of mgdt_check(). Each includes those below it. */
enum {
    MGDT_CHECK_COMBINATORIAL = 1, /**< Adjacency, shared facets, Euler's formula, all points. */
    MGDT_CHECK_GEOMETRIC = 2,     /**< Positive orientation and the Delaunay property, exactly. */
    MGDT_CHECK_CANONICAL = 3      /**< Convex hull, and ties broken by the perturbation. */
};

/** What mgdt_get_cell_measures() measures. Since 1.2. */
enum {
    MGDT_MEASURE_VOLUME = 10,   /**< Volume of the cell. */
    MGDT_MEASURE_AREA = 20,     /**< Area of the cell's surface. */
    MGDT_MEASURE_CENTROID = 30, /**< The cell's centre of mass, 3 numbers. */
    MGDT_MEASURE_FACES = 40     /**< Number of the cell's faces that have an area. */
};

/** What mgdt_get_tetrahedron_measures() measures. Angles are in radians. Since 1.3. */
enum {
    MGDT_TETRAHEDRON_VOLUME = 10, /**< Volume of the tetrahedron. */
    /** 3 times the radius of the inscribed sphere over that of the circumsphere: 1 for a regular
     *  tetrahedron, near 0 for a flat one. */
    MGDT_TETRAHEDRON_RADIUS_RATIO = 20,
    /** 6 sqrt(2) times the volume over the third power of the root mean square of the six edges: 1
     *  for a regular tetrahedron, near 0 for a flat one (Parthasarathy, Graichen and Hathaway,
     *  Finite Elements in Analysis and Design 15, 1994). Since 1.4. */
    MGDT_TETRAHEDRON_VOLUME_LENGTH = 21,
    /** Length of the longest edge over that of the shortest one, at least 1. Since 1.4. */
    MGDT_TETRAHEDRON_EDGE_RATIO = 22,
    MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE = 30,   /**< Least of the six dihedral angles. */
    MGDT_TETRAHEDRON_LARGEST_DIHEDRAL_ANGLE = 31, /**< Largest of the six dihedral angles. */
    MGDT_TETRAHEDRON_LONGEST_EDGE = 40            /**< Length of the longest edge. */
};

/** Methods of interpolation: how a value anywhere is computed from values at the vertices.
 *  @since 1.2 */
enum {
    MGDT_INTERPOLATE_LINEAR = 10,   /**< Linear in each tetrahedron; continuous. */
    MGDT_INTERPOLATE_NEAREST = 20,  /**< The value of the nearest vertex. */
    MGDT_INTERPOLATE_SIBSON = 30,   /**< By natural neighbours. The weight of a neighbour is
                                         the volume that a new point would take from its Voronoi
                                         cell. Smooth except at the points. */
    MGDT_INTERPOLATE_LAPLACE = 40,  /**< By natural neighbours. The weight of a neighbour is the
                                         area of the face that the two cells would share, divided
                                         by the distance. */
    MGDT_INTERPOLATE_SIBSON_C1 = 50 /**< Sibson's method with the gradients of
                                         mgdt_get_gradients(). Smooth at the points too. */
};

/** Values outside the convex hull.
 *  @since 1.2 */
enum {
    MGDT_OUTSIDE_NONE = 10,     /**< There is no value: NaN, and no weights. */
    MGDT_OUTSIDE_NEAREST = 20,  /**< The value of the nearest vertex. */
    MGDT_OUTSIDE_BOUNDARY = 30, /**< The value at the nearest point of the hull, linear in the
                                     hull facet. */
    MGDT_OUTSIDE_LINEAR = 40    /**< The value of MGDT_OUTSIDE_BOUNDARY, continued linearly. The
                                     gradient is the mean of those of mgdt_get_gradients() at the
                                     corners of the hull facet. */
};

/** Allocates `size` bytes aligned to `align` (a power of two), or returns NULL. Any thread that the
 *  library runs may call it, several at once. */
typedef void* (*mgdt_alloc_fn)(size_t size, size_t align, void* user);
/** Frees memory; `size` and `align` are those of the allocation. */
typedef void (*mgdt_free_fn)(void* p, size_t size, size_t align, void* user);
/** Receives the progress of a long call: a `fraction` from 0 to 1, which does not decrease. It is
 *  called on the thread that made the call, so several threads may be in it if they make calls that
 *  read the handle at the same time. A nonzero return value cancels the call. The function must not
 *  use the handle, except for mgdt_cancel() and mgdt_get_error(). */
typedef int32_t (*mgdt_progress_fn)(double fraction, void* user);

/* ------------------------------------------------------------------------------- life --- */

/** Makes an empty triangulation.
 *  @param[out] out  the handle; NULL if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_create(mgdt_triangulation** out);

/** Makes an empty triangulation that takes all its memory from `alloc`.
 *  @param alloc, release  two functions, or NULL for both to use the default allocator
 *  @param user  passed to the two functions
 *  @param[out] out  the handle; NULL if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (one function without the
 *  other), MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release,
                                                void* user, mgdt_triangulation** out);

/** Frees the handle and all that it holds. NULL is allowed. While another call is running on the
 *  handle, as in a callback, this function does nothing: the handle has to be destroyed after that
 *  call.
 *  @since 1.0 */
MGDT_API void mgdt_destroy(mgdt_triangulation* t);

/** Removes all points and sets the statistics to zero. The settings stay. A pending cancellation is
 *  withdrawn, see mgdt_cancel().
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_clear(mgdt_triangulation* t);

/** Reserves storage for a total number of points, so that later insertions need not grow it.
 *  Optional.
 *  @param n_points  at least 0
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_TOO_LARGE,
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_reserve(mgdt_triangulation* t, int64_t n_points);

/** Frees memory that the handle keeps only for speed: spare capacity for points, working arrays,
 *  the numbering of tetrahedra and the search tree for locations. The triangulation and the numbers
 *  of its tetrahedra stay. Later calls allocate that memory again when they need it. The order in
 *  which later insertions store tetrahedra may differ (mgdt_set_canonical_output()). A block that
 *  can only be made smaller by a copy keeps its size if the memory limit does not allow the copy.
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
/** The value of a parameter; 0 if it has not been set and each scheme uses its own default.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_order_parameter(const mgdt_triangulation* t, int32_t key,
                                              double* value);

/** Sets the seed of the schemes that shuffle. Runs with the same seed insert in the same order; the
 *  tetrahedra are the same for every seed. Default 0.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_seed(mgdt_triangulation* t, uint64_t seed);
/** The seed that is set.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_seed(const mgdt_triangulation* t, uint64_t* seed);

/** Sets how many threads a call may use: insertions, exports, checks, and queries of many points.
 *  The tetrahedra do not depend on this number. If it is not 1, the order of storage may differ
 *  from run to run; exports have that order unless output is canonical. A call that has work for
 *  several threads starts them and joins them before it returns; the calling thread is one of them.
 *  If the system refuses to start threads, the call runs with fewer.
 *  @param n  at least 1, or 0 for all cores; default 1. A number above 254 counts as 254
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_threads(mgdt_triangulation* t, int32_t n);
/** The number of threads that is set, 0 for all cores. The statistic MGDT_STAT_THREADS is the
 *  number that the last insertion used.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_threads(const mgdt_triangulation* t, int32_t* n);

/** Sets the index base: the index of the first point and of the first tetrahedron in all calls.
 *  @param base  0 (default) or 1
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_index_base(mgdt_triangulation* t, int32_t base);
/** The index base that is set.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_index_base(const mgdt_triangulation* t, int32_t* base);

/** Limits the memory that the handle may hold. A call that would exceed the limit returns
 *  MGDT_ERR_OUT_OF_MEMORY. The working memory of a call counts while the call runs. A limit below
 *  the memory that is held frees nothing: the next call that needs more memory, an insertion or an
 *  export, is refused, and the handle stays as it is.
 *  @param bytes  at least 0; 0 (default) for no limit
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_memory_limit(mgdt_triangulation* t, int64_t bytes);
/** The memory limit that is set, 0 for none.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_memory_limit(const mgdt_triangulation* t, int64_t* bytes);

/** Chooses between speed and memory. By default a triangulation stores the circumsphere of every
 *  tetrahedron, which takes three tenths of its memory. In compact storage each sphere is computed
 *  from the vertices when it is needed: insertions and locations take longer (docs/performance.md),
 *  and the tetrahedra are the same. The order in which later insertions store tetrahedra may differ
 *  (mgdt_set_canonical_output()). This function may be called at any time. With 1 it frees the
 *  memory of the spheres, as mgdt_shrink() frees memory; with 0 it computes the spheres again.
 *  Tetrahedra keep their numbers, and exports are the same byte for byte.
 *  @param on  1 for compact storage, 0 (default) for stored spheres
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_OUT_OF_MEMORY (with
 *          0; nothing has changed then)
 *  @since 1.1 */
MGDT_API mgdt_status mgdt_set_compact(mgdt_triangulation* t, int32_t on);
/** Whether storage is compact, 0 or 1.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_compact(const mgdt_triangulation* t, int32_t* on);

/** Sets the callback that receives the progress of long calls and may cancel them. A long call
 *  calls it with 0 at the beginning, about a hundred times in all (less often for few points), and
 *  with 1 at the end, when it is too late to cancel. Long calls are mgdt_voronoi_create(), and
 *  those of mgdt_insert_points(), mgdt_insert_points_strided(), mgdt_remove_points() and
 *  mgdt_move_points() that are given points. With mgdt_set_read_progress() others are long calls,
 *  too.
 *  @param fn  the callback; NULL for none (default)
 *  @param user  passed to the callback
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_progress(mgdt_triangulation* t, mgdt_progress_fn fn, void* user);
/** The callback that is set and the pointer that is passed to it. A caller that sets another one
 *  for a time can restore it.
 *  @param[out] fn    NULL if there is none
 *  @param[out] user  may be NULL: then it is not written
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_progress(const mgdt_triangulation* t, mgdt_progress_fn* fn,
                                       void** user);

/** Asks the long calls (see mgdt_set_progress()) that are running on the handle to stop soon. They
 *  then return MGDT_ERR_CANCELLED; if they finish first, the request is dropped. If none is
 *  running, the request stays pending: it stops the next long call, unless mgdt_clear() comes
 *  first. Any thread and any signal handler may call this function.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_cancel(mgdt_triangulation* t);

/** Makes calls that only read the handle long calls, which report to the callback of
 *  mgdt_set_progress() and which mgdt_cancel() stops: mgdt_check(), measures of cells and of
 *  tetrahedra, circumcentres, alpha values and alpha shapes, the Gabriel graph and the spanning
 *  tree, interpolation, gradients, mgdt_locate_points() and mgdt_nearest_vertices(). If such a call
 *  is cancelled, the contents of its output arrays are unspecified. Calls that only copy arrays of
 *  the handle are never long calls. The setting is off by default, because up to version 1.2 only
 *  insertions, removals and moves called the callback: a program may have set one that must not be
 *  called at other times.
 *  @param on  1, or 0 (default)
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_set_read_progress(mgdt_triangulation* t, int32_t on);
/** Whether calls that read report progress, 0 or 1.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_get_read_progress(const mgdt_triangulation* t, int32_t* on);

/** Makes exports canonical: byte for byte, they depend only on the points, their indices and the
 *  index base, not on the order scheme, the threads or the division into calls. Each tetrahedron
 *  starts with its two lowest vertex indices in ascending order, each hull facet with its lowest,
 *  and tetrahedra, hull facets and edges are sorted. Without this setting they come in the order of
 *  storage, which is faster.
 *  @param on  0 (default) or 1
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_canonical_output(mgdt_triangulation* t, int32_t on);
/** Whether output is canonical, 0 or 1.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_canonical_output(const mgdt_triangulation* t, int32_t* on);

/** Chooses the instruction set of the kernel, for tests and measurements. The tetrahedra are the
 *  same with each. The default is the best instruction set that the processor has, or the one that
 *  the environment variable MGDT_ISA names when the handle is made. mgdt_isa_name() returns the one
 *  in use.
 *  @param name  "baseline", on x86-64 "avx2" or "avx512", on arm64 "neon"; NULL for the best
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER (t), MGDT_ERR_INVALID_ARGUMENT (an unknown name, or an
 *  instruction set that this processor does not have)
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_set_isa(mgdt_triangulation* t, const char* name);

/* ----------------------------------------------------------------------------- points --- */

/** Inserts points. The points may be given in any number of calls, with the same result. A point
 *  with the coordinates of an earlier point (0 equals -0) shares the vertex of that point, see
 *  mgdt_get_point_map(). Points that do not span space, fewer than four or all on a plane, are kept
 *  until a later call adds points with which they do.
 *  @param n    number of points, at least 0
 *  @param xyz  3 n coordinates, x y z of each point in turn; copied; may be NULL if n is 0
 *  @return MGDT_OK; MGDT_ERR_INVALID_ARGUMENT (n is negative, whatever xyz is),
 *  MGDT_ERR_NULL_POINTER, MGDT_ERR_NOT_FINITE (the message names the index) or MGDT_ERR_TOO_LARGE,
 *  with nothing changed; MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY or MGDT_ERR_TOO_LARGE with a
 *  valid triangulation of the points that were inserted. The other points of the call have indices
 *  but no vertex in the point map; the caller may insert them again, under new indices. If memory
 *  ran out before the points got indices, nothing has changed: mgdt_point_count() shows which.
 *  Points that did not span space are inserted by the first call with which they do; if that call
 *  is cancelled they stay, if it runs out of memory they may be lost
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_insert_points(mgdt_triangulation* t, int64_t n, const double* xyz);

/** Inserts points as mgdt_insert_points() does, from coordinates in separate arrays or in records.
 *  @param x, y, z  the coordinates of the first point
 *  @param stride   distance from the x (y, z) of one point to that of the next, in doubles; it may
 *                  be negative. The length of a record with aligned doubles is a multiple of
 *                  theirs; a caller whose doubles are not aligned, as in packed records, copies
 *                  them
 *  @return as mgdt_insert_points(); MGDT_ERR_INVALID_ARGUMENT also if the stride leads out of the
 *  address space
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_insert_points_strided(mgdt_triangulation* t, int64_t n, const double* x,
                                                const double* y, const double* z, int64_t stride);

/** Removes points. The tetrahedra are then those of the remaining points. A vertex that several
 *  equal points share stays until the last of them is removed; the first that remains represents
 *  it. If the remaining points do not span space, they are kept until a later call adds points with
 *  which they do. The remaining points keep their indices. The index of a removed point is not used
 *  again and counts in mgdt_point_count() until mgdt_renumber_points(); the point map has none for
 *  it. To bring a removed point back, insert it as a new point.
 *  @param n       number of points, at least 0
 *  @param points  n indices, in any order, each once; may be NULL if n is 0
 *  @return MGDT_OK; MGDT_ERR_INVALID_ARGUMENT (n is negative, whatever points is; an index that is
 *  out of range, is of a removed point, or is given twice: the message names it) or
 *  MGDT_ERR_NULL_POINTER, with nothing changed; MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY or
 *  MGDT_ERR_TOO_LARGE with a valid triangulation, from which as many of the points are removed as
 *  the message says (none if it names no number); the point map says which
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_remove_points(mgdt_triangulation* t, int64_t n, const int64_t* points);
/** @copydoc mgdt_remove_points
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_remove_points_i32(mgdt_triangulation* t, int64_t n,
                                            const int32_t* points);

/** Moves points to new coordinates. The points keep their indices, and the tetrahedra are then
 *  those of the points at their new positions. Equal points can be moved apart, and a point that is
 *  moved onto another one shares its vertex; the first of them represents it. Points that span
 *  space may be moved so that they no longer do, and the reverse. A point whose coordinates do not
 *  change takes little time.
 *  @param n       number of points: at least 0; 0 or mgdt_point_count(t) if points is NULL
 *  @param points  n indices, in any order, each once; or NULL for all points in the order of their
 *                 indices. Without a list, the coordinates of removed points are ignored
 *  @param xyz     3 n coordinates, x y z of each point in turn; copied; may be NULL if n is 0
 *  @return MGDT_OK; MGDT_ERR_INVALID_ARGUMENT (as mgdt_remove_points(); also an n other than
 *  mgdt_point_count(t) without a list), MGDT_ERR_NULL_POINTER or MGDT_ERR_NOT_FINITE (the message
 *  names the index), with nothing changed; MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY or
 *  MGDT_ERR_TOO_LARGE with a valid triangulation: the message says how many points have moved (none
 *  if it names no number). They are the first of the list, or the first that are in the
 *  triangulation if there is no list. The others are where they were
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_move_points(mgdt_triangulation* t, int64_t n, const int64_t* points,
                                      const double* xyz);
/** @copydoc mgdt_move_points
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_move_points_i32(mgdt_triangulation* t, int64_t n, const int32_t* points,
                                          const double* xyz);

/** Gives the points that are in the triangulation new indices, in their order, from the index base
 *  on, and drops the indices of removed points: mgdt_point_count() is then the number of points in
 *  the triangulation. No other call renumbers points.
 *  @param capacity        elements in new_index, at least mgdt_point_count(t) before the call
 *  @param[out] new_index  for each point its new index, or none if it is not in the triangulation;
 *                         may be NULL if there are no points
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_BUFFER_TOO_SMALL
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_renumber_points(mgdt_triangulation* t, int64_t capacity,
                                          int64_t* new_index);
/** @copydoc mgdt_renumber_points
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_renumber_points_i32(mgdt_triangulation* t, int64_t capacity,
                                              int32_t* new_index);

/* ----------------------------------------------------------------------------- counts --- */

/** Number of points that have an index: all that were ever given to the handle, except those of
 *  calls that changed nothing and those that mgdt_renumber_points() dropped. 0 for NULL.
 *  @since 1.0 */
MGDT_API int64_t mgdt_point_count(const mgdt_triangulation* t);

/** Number of vertices, which is the number of distinct points in the triangulation; 0 for NULL.
 *  @since 1.0 */
MGDT_API int64_t mgdt_vertex_count(const mgdt_triangulation* t);

/** Dimension of the affine hull of the points: -1 if there are none (or for NULL), 0 for one point,
 *  1 for a line, 2 for a plane, 3 for space. There are tetrahedra only at 3.
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
 *  (v1 - v0) x (v2 - v0) . (v3 - v0) > 0, exactly. A vertex is given by the lowest index of the
 *  points that share it.
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
 *  mgdt_get_tetrahedra(). Neighbour i shares the facet opposite vertex i; it is none if that facet
 *  is on the hull.
 *  @param capacity  elements in v, at least 4 mgdt_tetrahedron_count(t)
 *  @return as mgdt_get_tetrahedra()
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_neighbors(const mgdt_triangulation* t, int64_t capacity, int64_t* v);
/** @copydoc mgdt_get_neighbors
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_neighbors_i32(const mgdt_triangulation* t, int64_t capacity,
                                            int32_t* v);

/** Writes the triangles of the convex hull, 3 vertices each, counter-clockwise seen from outside.
 *  A face of the hull with more than three vertices is divided as the perturbed points divide it
 *  (docs/theory.md).
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

/** Writes the vertex of each of the mgdt_point_count(t) points: the lowest index of the points that
 *  share the vertex, or none if the point is not in the triangulation.
 *  @param capacity  elements in v, at least mgdt_point_count(t)
 *  @return as mgdt_get_tetrahedra()
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_point_map(const mgdt_triangulation* t, int64_t capacity, int64_t* v);
/** @copydoc mgdt_get_point_map
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_point_map_i32(const mgdt_triangulation* t, int64_t capacity,
                                            int32_t* v);

/** Writes the tetrahedra around each vertex as a compressed list. Those of point k (counted from
 *  0) are list[offsets[k] - base] to list[offsets[k + 1] - base - 1], ascending. A point that does
 *  not represent a vertex has none.
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
 *  Those of point k (counted from 0) are list[offsets[k] - base] to
 *  list[offsets[k + 1] - base - 1], ascending. A point that does not represent a vertex has none,
 *  and there are none without tetrahedra.
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

/** Writes the Gabriel graph: the edges of tetrahedra that are the diameter of a sphere with no
 *  vertex inside, decided exactly. (Two vertices that no edge joins may also have such a sphere if
 *  its surface has other vertices, as the second diagonal of a square has; they are not in the
 *  graph.) Each edge is written once, as 2 vertices with the lesser index first, and the edges are
 *  sorted. There are none without tetrahedra. Uses the threads of mgdt_set_threads().
 *  @param capacity    elements in v, at least 2 count; 2 mgdt_edge_count(t) is always enough
 *  @param[out] v      may be NULL if there are no edges
 *  @param[out] count  the number of edges; written also if v is too small for them
 *  @return as mgdt_get_tetrahedra(), and MGDT_ERR_CANCELLED
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_gabriel_edges(const mgdt_triangulation* t, int64_t capacity,
                                            int64_t* v, int64_t* count);
/** @copydoc mgdt_get_gabriel_edges
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_gabriel_edges_i32(const mgdt_triangulation* t, int64_t capacity,
                                                int32_t* v, int32_t* count);

/** Writes the edges of the Euclidean minimum spanning tree, which joins all vertices and has the
 *  least total length, decided exactly. If several trees have that length, the edges that come
 *  first in the order of their vertices are taken. Each edge is written as 2 vertices with the
 *  lesser index first, and the edges are sorted. There are none without tetrahedra.
 *  @param capacity    elements in v, at least 2 (mgdt_vertex_count(t) - 1)
 *  @param[out] v      may be NULL if there are no edges
 *  @param[out] count  the number of edges; written also if v is too small for them
 *  @return as mgdt_get_tetrahedra(), and MGDT_ERR_CANCELLED
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_spanning_tree(const mgdt_triangulation* t, int64_t capacity,
                                            int64_t* v, int64_t* count);
/** @copydoc mgdt_get_spanning_tree
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_spanning_tree_i32(const mgdt_triangulation* t, int64_t capacity,
                                                int32_t* v, int32_t* count);

/** Writes the centre of each tetrahedron's circumsphere, a vertex of the Voronoi diagram, and the
 *  square of its radius, in the order of mgdt_get_tetrahedra(). Each number is the double nearest
 *  to the exact value, and infinite beyond the largest double. So tetrahedra with the same
 *  circumsphere, as in a lattice, have the same numbers. Uses the threads of mgdt_set_threads().
 *  @param capacity      number of tetrahedra that the arrays have room for, at least
 *                       mgdt_tetrahedron_count(t)
 *  @param[out] xyz      3 capacity elements: x y z of each centre; may be NULL if there are no
 *                       tetrahedra
 *  @param[out] radius2  capacity elements; or NULL
 *  @return as mgdt_get_tetrahedra(), and MGDT_ERR_CANCELLED
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_circumcenters(const mgdt_triangulation* t, int64_t capacity,
                                            double* xyz, double* radius2);

/** Measures each tetrahedron, in the order of mgdt_get_tetrahedra(). The relative error is below
 *  1e-12, and so is the error of an angle, however flat the tetrahedron is: volumes and radius
 *  ratios are positive. Numbers beyond the largest double are infinite, and numbers below the least
 *  normal one are rounded to subnormal ones or to 0. A number depends on the four points alone.
 *  Uses the threads of mgdt_set_threads(). The derivation is in docs/theory.md, "Measures of
 *  tetrahedra".
 *  @param measure   an MGDT_TETRAHEDRON_ value
 *  @param capacity  elements in x, at least mgdt_tetrahedron_count(t)
 *  @param[out] x    may be NULL if there are no tetrahedra
 *  @return as mgdt_get_tetrahedra(), and MGDT_ERR_UNKNOWN_KEY and MGDT_ERR_CANCELLED
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_get_tetrahedron_measures(const mgdt_triangulation* t, int32_t measure,
                                                   int64_t capacity, double* x);

/** Measures the Voronoi cell of each point, the region that is nearer to it than to any other
 *  point. Without planes, the cells of hull vertices are unbounded: their volumes, areas and
 *  centroids are infinite, and their faces are counted. With planes, which have to bound a convex
 *  region, the cells are clipped to that region and fill it. A point that does not represent a
 *  vertex has 0. The numbers depend neither on the order of insertion nor on the number of threads
 *  (mgdt_set_threads()).
 *
 *  Volumes and areas have a relative error below 1e-12. The error of a centroid is below 1e-12
 *  times the distance from the point to the farthest corner of its cell. Faces are counted exactly:
 *  a cell of a cubic lattice has 6. Numbers beyond the largest double are infinite. The derivation
 *  is in docs/theory.md, "Cells".
 *  @param measure   an MGDT_MEASURE_ value
 *  @param n_planes  number of planes, at least 0
 *  @param planes    4 n_planes elements, a b c d each: the region is where a x + b y + c z <= d. No
 *                   point may be outside by more than rounding. Redundant and repeated planes are
 *                   allowed. May be NULL if there are none
 *  @param capacity  elements in x, at least mgdt_point_count(t), or three times that for centroids
 *  @param[out] x    for each point a number, or x y z of a centroid
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_NOT_FINITE (a plane),
 *  MGDT_ERR_BUFFER_TOO_SMALL, MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_INVALID_ARGUMENT
 *  (a negative number; points that are all in one plane, unless there are none or, since 1.3,
 *  planes; a point outside; planes that do not bound a region; the message says which)
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_cell_measures(const mgdt_triangulation* t, int32_t measure,
                                            int64_t n_planes, const double* planes,
                                            int64_t capacity, double* x);

/** Writes the alpha of each simplex of a dimension: the square of the radius at which the simplex
 *  joins the alpha shape. If the smallest sphere through its vertices has no vertex inside, which
 *  is decided exactly, alpha is the square of that sphere's radius. Otherwise it is the least alpha
 *  of the simplices that have it as a face. So a face never has a larger alpha than a simplex that
 *  it is a face of. Alphas of tetrahedra are those of mgdt_get_circumcenters(); others have a
 *  relative error below 2e-14. Uses the threads of mgdt_set_threads().
 *  @param dimension    3: tetrahedra, in the order of mgdt_get_tetrahedra(). 2: facets, 4 per
 *                      tetrahedron, the i-th opposite vertex i; a shared facet is written for both
 *                      tetrahedra. 1: edges, in the order of mgdt_get_edges(). 0: points; 0 for a
 *                      point that represents a vertex, infinite for any other
 *  @param capacity     elements in alpha2, at least mgdt_tetrahedron_count(t), 4 times that,
 *                      mgdt_edge_count(t), or mgdt_point_count(t)
 *  @param[out] alpha2  may be NULL if there is nothing to write
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_BUFFER_TOO_SMALL,
 *  MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_alphas(const mgdt_triangulation* t, int32_t dimension,
                                     int64_t capacity, double* alpha2);

/** Writes the surface of an alpha shape: the facets between a tetrahedron whose alpha is at most
 *  alpha2 and one whose alpha is larger, or the outside. The surface is closed and oriented. Each
 *  facet is counter-clockwise seen from outside and starts with its lowest index; at each edge, the
 *  numbers of facets in either orientation are equal. The facets are sorted.
 *  @param alpha2      the square of a radius, at least 0; infinite for the convex hull
 *  @param capacity    elements in v, at least 3 count; 12 mgdt_tetrahedron_count(t) is always
 *                     enough
 *  @param[out] v      3 vertices of each facet; may be NULL if there are none
 *  @param[out] count  the number of facets; written also if v is too small for them
 *  @return as mgdt_get_tetrahedra(), and MGDT_ERR_INVALID_ARGUMENT for an alpha2 below 0 or NaN,
 *  and MGDT_ERR_CANCELLED
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_alpha_surface(const mgdt_triangulation* t, double alpha2,
                                            int64_t capacity, int64_t* v, int64_t* count);
/** @copydoc mgdt_get_alpha_surface
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_alpha_surface_i32(const mgdt_triangulation* t, double alpha2,
                                                int64_t capacity, int32_t* v, int32_t* count);

/** Computes the least alpha at which the alpha shape is one solid with all vertices: each
 *  tetrahedron can be reached from any other through facets.
 *  @param[out] alpha2  the square of a radius; 0 if there are no points
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY,
 *  MGDT_ERR_INVALID_ARGUMENT (all points are in one plane)
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_solid_alpha(const mgdt_triangulation* t, double* alpha2);

/* ---------------------------------------------------------------------------- queries --- */

/** Finds the tetrahedron that contains a point, its boundary included. For a point on a facet, edge
 *  or vertex that several tetrahedra share, it is one of them.
 *  @param xyz                3 coordinates
 *  @param[out] tetrahedron   the number of the tetrahedron; none if the point is outside the hull
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_NOT_FINITE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_locate(const mgdt_triangulation* t, const double* xyz,
                                 int64_t* tetrahedron);
/** @copydoc mgdt_locate
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_locate_i32(const mgdt_triangulation* t, const double* xyz,
                                     int32_t* tetrahedron);

/** Finds the tetrahedra that contain many points, which may be in any order. Much faster than a
 *  call of mgdt_locate() for each. Uses the threads of mgdt_set_threads().
 *  @param n                number of points, at least 0
 *  @param xyz              3 n coordinates
 *  @param[out] tetrahedra  n numbers of tetrahedra; none for a point outside the hull
 *  @param[out] weights     NULL, or 4 n barycentric coordinates for interpolation, in the order of
 *                          the tetrahedron's vertices in mgdt_get_tetrahedra(); zeros for a point
 *                          outside the hull. Each coordinate is between 0 and 1 and has a relative
 *                          error of at most 3.01 * 2^-53, plus 2^-1075 if it is subnormal; it is 0
 *                          if the point is on the opposite facet. The weighted sum of the vertices,
 *                          computed in doubles, differs from the point by at most 7.01 * 2^-53
 *                          times the largest magnitude among the vertices, plus 2^-1073, along each
 *                          axis and however flat the tetrahedron is
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_NOT_FINITE (the
 *  message names the point; nothing is written), MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_locate_points(const mgdt_triangulation* t, int64_t n, const double* xyz,
                                        int64_t* tetrahedra, double* weights);
/** @copydoc mgdt_locate_points
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_locate_points_i32(const mgdt_triangulation* t, int64_t n,
                                            const double* xyz, int32_t* tetrahedra,
                                            double* weights);

/** Finds the tetrahedra that the segment from a to b passes through, in order, exactly. This serves
 *  to track particles and to cast rays. Tetrahedron i is entered at a + parameters[i] (b - a) and
 *  left at a + parameters[i + 1] (b - a). The part of the segment inside the hull runs from
 *  parameters[0], which is 0 if a is inside, to parameters[count], which is 1 if b is inside. Each
 *  parameter is correctly rounded, so consecutive ones may be equal.
 *
 *  A tetrahedron that the segment meets in one point is left out; where the segment passes through
 *  a vertex or an edge, consecutive tetrahedra need not be neighbours. Where the segment runs in a
 *  facet or an edge, the result names a tetrahedron beside it, chosen as if the segment were
 *  displaced by an infinitesimal vector; the choice depends on the points and their indices alone.
 *  If a and b are equal, the result is the tetrahedron that mgdt_locate() finds, with the
 *  parameters 0 and 1.
 *
 *  The time is that of a location and about half a microsecond per tetrahedron. At a vertex, all
 *  tetrahedra around it are visited.
 *  @param a, b             3 coordinates each
 *  @param capacity         elements in tetrahedra, at least 0. With 0 the call asks for the count
 *                          alone and returns MGDT_ERR_BUFFER_TOO_SMALL, unless the count is 0
 *  @param[out] tetrahedra  the numbers of the tetrahedra; may be NULL if capacity or the count is 0
 *  @param[out] parameters  NULL, or capacity + 1 elements, of which count + 1 are written, or none
 *                          if count is 0 or capacity is too small
 *  @param[out] count       the number of tetrahedra; written also if capacity is too small. It is 0
 *                          if the segment misses the hull, if different a and b have one point in
 *                          the hull (for example because a is on the hull and b outside), or if the
 *                          points do not span space
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (capacity is negative),
 *  MGDT_ERR_NOT_FINITE, MGDT_ERR_BUFFER_TOO_SMALL, MGDT_ERR_INDEX_RANGE (the numbers of all
 *  tetrahedra do not fit), MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_traverse_segment(const mgdt_triangulation* t, const double* a,
                                           const double* b, int64_t capacity, int64_t* tetrahedra,
                                           double* parameters, int64_t* count);
/** @copydoc mgdt_traverse_segment
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_traverse_segment_i32(const mgdt_triangulation* t, const double* a,
                                               const double* b, int64_t capacity,
                                               int32_t* tetrahedra, double* parameters,
                                               int32_t* count);

/** Finds the vertex nearest to a point, exactly. If several are equally near, it is the one with
 *  the lowest index. The vertices need not span space.
 *  @param xyz          3 coordinates
 *  @param[out] vertex  the index of the vertex; none if the triangulation is empty
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_NOT_FINITE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_nearest_vertex(const mgdt_triangulation* t, const double* xyz,
                                         int64_t* vertex);
/** @copydoc mgdt_nearest_vertex
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_nearest_vertex_i32(const mgdt_triangulation* t, const double* xyz,
                                             int32_t* vertex);

/** Finds the vertices nearest to many points, which may be in any order. Much faster than a call of
 *  mgdt_nearest_vertex() for each, unless there are no tetrahedra: then each point is compared with
 *  every vertex. Uses the threads of mgdt_set_threads().
 *  @param n              number of points, at least 0
 *  @param xyz            3 n coordinates
 *  @param[out] vertices  n indices of vertices; none if the triangulation is empty
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_NOT_FINITE (the
 *  message names the point; nothing is written), MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_nearest_vertices(const mgdt_triangulation* t, int64_t n,
                                           const double* xyz, int64_t* vertices);
/** @copydoc mgdt_nearest_vertices
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_nearest_vertices_i32(const mgdt_triangulation* t, int64_t n,
                                               const double* xyz, int32_t* vertices);

/* --------------------------------------------------------------- values between points --- */

/** Interpolates values that are given at the points. Each place in the convex hull, its boundary
 *  included, gets a value. If all points are in one plane, MGDT_INTERPOLATE_NEAREST is the only
 *  method. Every other method reproduces linear functions. At a point the result is the value of
 *  the point; if several points are equal, it is the value of the one that represents the vertex.
 *  Values of points that are not in the triangulation are not read. The result depends neither on
 *  the number of threads nor on the order of the places. The weights of natural neighbours have the
 *  sum 1 and an error below 2^-30, for ordinary points about 1e-13.
 *  @param method    an MGDT_INTERPOLATE_ value
 *  @param outside   an MGDT_OUTSIDE_ value
 *  @param n_fields  how many numbers a point has, and a place gets; at least 0
 *  @param values    n_fields numbers for each of the mgdt_point_count(t) points; those of one point
 *                   are consecutive
 *  @param n         number of places, at least 0
 *  @param xyz       3 n coordinates of the places
 *  @param[out] out  n_fields numbers for each place; NaN if there is no value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (also if all points are in one
 *  plane and the method is not MGDT_INTERPOLATE_NEAREST), MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_NOT_FINITE
 *  (the message names the place; nothing is written), MGDT_ERR_TOO_LARGE, MGDT_ERR_CANCELLED,
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_interpolate(const mgdt_triangulation* t, int32_t method, int32_t outside,
                                      int64_t n_fields, const double* values, int64_t n,
                                      const double* xyz, double* out);

/** Writes the weights with which mgdt_interpolate() combines values, so that a caller can apply
 *  them to any number of fields: the value at place i, counted from 0, is the sum of weights[k]
 *  times the value of point points[k], for k from offsets[i] - base to offsets[i + 1] - base - 1.
 *  The points of a place ascend, and their weights add up to 1; a place without a value has none.
 *  The linear method has at most 4 weights per place. MGDT_INTERPOLATE_SIBSON_C1 and
 *  MGDT_OUTSIDE_LINEAR also give weights to neighbours of neighbours, and these may be negative.
 *  @param method           an MGDT_INTERPOLATE_ value
 *  @param outside          an MGDT_OUTSIDE_ value
 *  @param n                number of places, at least 0
 *  @param xyz              3 n coordinates of the places
 *  @param offset_capacity  elements in offsets, at least n + 1
 *  @param[out] offsets     where the weights of each place begin; written also if the capacity of
 *                          points and weights is too small
 *  @param capacity         elements in points, and in weights
 *  @param[out] points      indices of points. NULL, together with weights, for the offsets alone
 *  @param[out] weights     the weight of each of these points
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_UNKNOWN_KEY,
 *  MGDT_ERR_NOT_FINITE, MGDT_ERR_BUFFER_TOO_SMALL (offsets are written; nothing else),
 *  MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY; as mgdt_interpolate()
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

/** Estimates the gradients of values at the points. The gradient at a vertex is that of the linear
 *  function that has the value of the vertex and is the best fit to the values of its neighbours:
 *  it minimises the sum of squares of their differences, each divided by the distance. The estimate
 *  is exact for linear functions, up to rounding.
 *  @param n_fields  how many numbers a point has, at least 0
 *  @param values    as mgdt_interpolate()
 *  @param[out] out  for each field of each point 3 numbers, the derivatives by x, y and z. Equal
 *                   points have the same; a point that is not in the triangulation has NaN
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (also if all points are in one
 *  plane), MGDT_ERR_TOO_LARGE, MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_get_gradients(const mgdt_triangulation* t, int64_t n_fields,
                                        const double* values, double* out);

/* ------------------------------------------------------------------------------ trust --- */

/** Checks that the triangulation is valid, by exact arithmetic and in linear time.
 *  @param level  an MGDT_CHECK_ value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_CHECK_FAILED (the
 *  message says what and where), MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_check(const mgdt_triangulation* t, int32_t level);

/* ---------------------------------------------------------------------------- figures --- */

/** Gives one figure about the handle.
 *  @param key  an MGDT_STAT_ key
 *  @param[out] value  the figure, in the unit that the key documents
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
 *  capacity; an empty string if none has failed. Calls that succeed do not change the message. If
 *  several threads use the handle, it is the message of the last call that failed on any of them.
 *  Callbacks and other threads may call this function at any time; it never returns MGDT_ERR_BUSY.
 *  @param capacity     bytes in buffer, at least 1
 *  @param[out] buffer  256 bytes hold every message
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_get_error(const mgdt_triangulation* t, int64_t capacity, char* buffer);

/** Name of an order scheme ("multi-grid"); NULL for an unknown one. The string is static.
 *  @since 1.0 */
MGDT_API const char* mgdt_order_scheme_name(int32_t scheme);

/** Finds the order scheme with a name.
 *  @param[out] scheme  an MGDT_ORDER_ value; not touched if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_SCHEME
 *  @since 1.0 */
MGDT_API mgdt_status mgdt_order_scheme_from_name(const char* name, int32_t* scheme);

/** Lists the order schemes one by one: the default first, then the others by ascending value.
 *  @param index  counted from 0
 *  @param[out] scheme  an MGDT_ORDER_ value; not touched if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_SCHEME (no scheme has this index)
 *  @since 1.2 */
MGDT_API mgdt_status mgdt_order_scheme_at(int32_t index, int32_t* scheme);

/** Version of the library that is running, for example "1.2.0". The string is static.
 *  @since 1.0 */
MGDT_API const char* mgdt_version_string(void);

/** Version of the binary interface: 1. A program that was built with one version 1 runs with every
 *  later library of version 1.
 *  @since 1.0 */
MGDT_API int32_t mgdt_abi_version(void);

/** Name of the instruction set that the handle's kernel uses, see mgdt_set_isa(); an empty string
 *  for NULL. The string is static.
 *  @since 1.0 */
MGDT_API const char* mgdt_isa_name(const mgdt_triangulation* t);

#ifdef __cplusplus
}
#endif

#endif /* MGDT_MGDT_H */
