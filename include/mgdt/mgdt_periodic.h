/* SPDX-License-Identifier: MIT
 *
 * The Delaunay triangulation and the Voronoi cells of points in a periodic box.
 *
 * A box is given by one, two or three independent period vectors of any shape. Each point stands
 * for all its images: the point plus integral multiples of the vectors. The triangulation is that
 * of the infinite set of all images. With one vector the set is a wire, with two a slab. One point
 * is enough if there are three vectors, and points may lie anywhere, also outside of the box.
 *
 * Tetrahedra that differ by a multiple of the vectors are one class, and each class is listed once.
 * A corner is a point and a *shift*: three integers, how often each vector has to be added to the
 * point, where the caller has put it, to get the image that is the corner. The third integer of a
 * slab is 0, and so are the second and the third of a wire.
 *
 * The result is exact and canonical. Coordinates and vectors are rounded once
 * (MGDT_PERIODIC_ARRAY_POINTS has the rounded ones): for each axis to multiples of at most 2^-47 of
 * the size of the box; for a slab or a wire whose points reach farther than the box, of their
 * extent. The size of the box is measured along each axis: it is the sum of the magnitudes of that
 * coordinate over the shortest vectors of the lattice. Then all images are exact: each is the
 * rounded point plus multiples of the rounded vectors, however oblique these are. So the tetrahedra
 * do not depend on which images of the points are given, nor on the number of threads. Points with
 * the same images are one vertex.
 *
 * The conventions are those of mgdt.h: status and message, capacities in elements, callbacks,
 * ranges of keys, the thread rule.
 *
 * @since 1.3
 */
#ifndef MGDT_MGDT_PERIODIC_H
#define MGDT_MGDT_PERIODIC_H

#include "mgdt_voronoi.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A handle of points in a periodic box and their triangulation. The struct is opaque;
 *  mgdt_periodic_create() makes one. */
typedef struct mgdt_periodic mgdt_periodic;

/** Options of mgdt_periodic_set_option(). Values are integers. */
enum {
    MGDT_PERIODIC_OPTION_INDEX_BASE = 10, /**< 0 (default) or 1. It applies to indices that are
                                               given or read later. */
    MGDT_PERIODIC_OPTION_THREADS = 20,    /**< Threads, see mgdt_set_threads(); default 1, 0 for
                                               all cores. */
    /** Bytes that the handle may hold; 0 (default) for no limit. */
    MGDT_PERIODIC_OPTION_MEMORY_LIMIT = 30
};

/** Keys of mgdt_periodic_get_stat(). All but those of points, dimensions and memory are 0 until
 *  there is a triangulation. */
enum {
    MGDT_PERIODIC_STAT_POINTS = 100,   /**< Points that were inserted. */
    MGDT_PERIODIC_STAT_VERTICES = 101, /**< Points without equal images. */
    /** Classes of tetrahedra. With three vectors, a set has as many edges as vertices and
     *  tetrahedra together. */
    MGDT_PERIODIC_STAT_TETRAHEDRA = 102,
    MGDT_PERIODIC_STAT_EDGES = 103,        /**< Classes of edges. */
    MGDT_PERIODIC_STAT_DIMENSIONS = 104,   /**< The number of vectors; 0 before they are set. */
    MGDT_PERIODIC_STAT_MEMORY_BYTES = 110, /**< Memory that the handle holds. */
    /** Images that were triangulated with the points. May be 0 in later versions. */
    MGDT_PERIODIC_STAT_IMAGES = 120,
    MGDT_PERIODIC_STAT_ROUNDS = 121 /**< Rounds in which these were found. May be 0 in later
                                         versions. */
};

/** Arrays of a periodic triangulation. Keys from 200 have integers, for mgdt_periodic_get_array();
 *  keys from 300 have doubles, for mgdt_periodic_get_doubles(). Points and tetrahedra are numbered
 *  from the index base. Arrays of shifts have three elements for each shift. Until there is a
 *  triangulation, calls that ask for an array fail with MGDT_ERR_NOT_BUILT. The list of the
 *  tetrahedra and those of the neighbours of vertices are made when they, or their sizes, are first
 *  asked for. */
enum {
    /** For each point the vertex that has its images: the least point that has them. */
    MGDT_PERIODIC_ARRAY_POINT_MAP = 200,
    /** The shift of that vertex's image that is the point. 0 for a point that is its own vertex. */
    MGDT_PERIODIC_ARRAY_POINT_SHIFTS = 201,
    /** Four corners for each class of tetrahedra, positively oriented as in mgdt_get_tetrahedra().
     *  The first is the one whose image has the lexicographically least coordinates, and the
     *  tetrahedra are sorted by their first corners. Empty if a slab or a wire does not span space.
     */
    MGDT_PERIODIC_ARRAY_TETRAHEDRA = 210,
    /** The shift of each corner, 12 elements for a tetrahedron. The first corner's is 0. */
    MGDT_PERIODIC_ARRAY_TETRAHEDRON_SHIFTS = 211,
    /** For each tetrahedron the numbers of the four tetrahedra opposite its corners. The index base
     *  - 1 means that there is none: the facet is on the hull of a slab or a wire. */
    MGDT_PERIODIC_ARRAY_NEIGHBORS = 212,
    /** For each of these the shift by which the neighbour is moved to be there, 12 elements for a
     *  tetrahedron. It is added to the shifts of the neighbour's corners. */
    MGDT_PERIODIC_ARRAY_NEIGHBOR_SHIFTS = 213,
    /** Offsets of the lists of each point's neighbours, one more than there are points: the list of
     *  point i is from element offsets[i] to element offsets[i + 1] - 1, counted from the index
     *  base. A point that is no vertex has an empty list. */
    MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS = 220,
    /** The points at the other ends of the edges at each vertex, sorted. A vertex may have several
     *  images of one point as neighbours, and images of itself. */
    MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS = 221,
    /** The shift of each of these images. */
    MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_SHIFTS = 222,
    /** Three coordinates of each point: where the caller has put it, rounded. */
    MGDT_PERIODIC_ARRAY_POINTS = 300,
    /** Three coordinates of each vector, rounded. */
    MGDT_PERIODIC_ARRAY_VECTORS = 301
};

/* ------------------------------------------------------------------------------- life --- */

/** Makes a box without vectors and without points.
 *  @param[out] out  the handle; NULL if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_create(mgdt_periodic** out);

/** Makes a box that takes all its memory from `alloc`.
 *  @param alloc, release, user  as for mgdt_create_with_allocator()
 *  @return as mgdt_periodic_create(), and MGDT_ERR_INVALID_ARGUMENT (one function without the
 *  other)
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release,
                                                         void* user, mgdt_periodic** out);

/** Frees the box. NULL is allowed. While another call is running on the handle, this function does
 *  nothing, as mgdt_destroy().
 *  @since 1.3 */
MGDT_API void mgdt_periodic_destroy(mgdt_periodic* p);

/** Removes the points and the triangulation. Vectors and options stay. A pending cancellation is
 *  withdrawn.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_clear(mgdt_periodic* p);

/* --------------------------------------------------------------------------- settings --- */

/** Sets the vectors of the box, in place of earlier ones. The triangulation is removed, and the
 *  points stay where they are. The next mgdt_periodic_build() starts with the images that the last
 *  one needed, so that a box that changes a little at every step, as under constant pressure, is
 *  triangulated as soon as points that move. A call that fails changes nothing.
 *  @param dimensions  the number of vectors, 1 to 3
 *  @param vectors     3 coordinates of each. Neither their order nor their handedness matters
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (dimensions, or vectors that
 *  do not span: they are on a line or in a plane, or so oblique that a basis of short vectors has
 *  multiples above 2^31), MGDT_ERR_NOT_FINITE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_set_vectors(mgdt_periodic* p, int32_t dimensions,
                                               const double* vectors);

/** Sets an option.
 *  @param option  an MGDT_PERIODIC_OPTION_ value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_set_option(mgdt_periodic* p, int32_t option, int64_t value);
/** The value of an option.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_get_option(const mgdt_periodic* p, int32_t option,
                                              int64_t* value);
/** Sets the distance within which later builds merge points; 0 (default) merges none. Points
 *  are taken in their order. A point is merged with the first earlier, unmerged point of which
 *  an image is within the distance: MGDT_PERIODIC_ARRAY_POINT_MAP names that point, and
 *  MGDT_PERIODIC_ARRAY_POINT_SHIFTS the image. The coordinates that are returned for a merged
 *  point do not change. Merging helps where points are given on both sides of an oblique box,
 *  such as a crystal's at the fractional coordinates 0 and 1, whose images differ by rounding.
 *  @param distance  finite and at least 0; it is compared with rounded distances. A build fails
 *                   with MGDT_ERR_INVALID_ARGUMENT if it is more than an eighth of the least
 *                   distance between opposite faces of the reduced box
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_set_merge_distance(mgdt_periodic* p, double distance);
/** The distance within which points are merged.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_get_merge_distance(const mgdt_periodic* p, double* distance);

/** Sets the callback that receives the progress of mgdt_periodic_build(), mgdt_periodic_check(),
 *  mgdt_periodic_create_voronoi() and mgdt_periodic_get_cell_measures() and may cancel them, as
 *  that of mgdt_set_progress() does.
 *  @param fn    the callback; NULL for none (default)
 *  @param user  passed to the callback
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_set_progress(mgdt_periodic* p, mgdt_progress_fn fn, void* user);
/** The progress callback, or NULL, and what is passed to it.
 *  @param[out] user  may be NULL
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_get_progress(const mgdt_periodic* p, mgdt_progress_fn* fn,
                                                void** user);

/** Asks the running mgdt_periodic_build(), mgdt_periodic_check(), mgdt_periodic_create_voronoi() or
 *  mgdt_periodic_get_cell_measures() to stop soon. That call then returns MGDT_ERR_CANCELLED. If
 *  none is running, the request stays pending and stops the next one, unless mgdt_periodic_clear()
 *  comes first. Any thread and any signal handler may call this function.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_cancel(mgdt_periodic* p);

/* ----------------------------------------------------------------------------- points --- */

/** Inserts points, which are copied and numbered on. The triangulation is removed. A call that
 *  fails changes nothing.
 *  @param n    number of points, at least 0
 *  @param xyz  3 n coordinates; may be NULL if n is 0
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n), MGDT_ERR_NOT_FINITE (the
 *  message names the point), MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_insert_points(mgdt_periodic* p, int64_t n, const double* xyz);

/** Moves points, as in a time step. The triangulation is removed; the next mgdt_periodic_build()
 *  starts with the images that it needed. A call that fails changes nothing.
 *  @param n       number of points, at least 0
 *  @param points  n points; may be NULL, then all points are moved, and n is their number
 *  @param xyz     3 n coordinates: where they are now
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n, or a point that does not
 *  exist or is given twice; the message names it), MGDT_ERR_NOT_FINITE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_move_points(mgdt_periodic* p, int64_t n, const int64_t* points,
                                               const double* xyz);
/** mgdt_periodic_move_points() with 32-bit integers.
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_move_points_i32(mgdt_periodic* p, int64_t n,
                                                   const int32_t* points, const double* xyz);

/* ------------------------------------------------------------------------------ calls --- */

/** Triangulates the points, in place of an earlier triangulation.
 *  @return MGDT_OK or MGDT_ERR_NULL_POINTER. After any other status there is no triangulation:
 *  MGDT_ERR_INVALID_ARGUMENT (the box has no vectors; a point is more than 2^29 boxes away, or,
 *  from a slab or a wire, more than 2^38 times the least distance of its images; or the vectors do
 *  not span after rounding, or are so small or so large that the rounded coordinates are no
 *  doubles; the message says which), MGDT_ERR_TOO_LARGE, MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_build(mgdt_periodic* p);

/** Checks the triangulation, with exact arithmetic and without what the build has used besides: all
 *  tetrahedra are positive, fill space once with their images, and are Delaunay, with ties broken
 *  by the perturbation (docs/theory.md, "Periodic boxes").
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_NOT_BUILT,
 *  MGDT_ERR_CHECK_FAILED (the message says what is wrong and where), MGDT_ERR_CANCELLED,
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_check(const mgdt_periodic* p);

/* ---------------------------------------------------------------------------- results --- */

/** Gives one number of the box.
 *  @param key  an MGDT_PERIODIC_STAT_ value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_get_stat(const mgdt_periodic* p, int32_t key, int64_t* value);

/** Gives the shape of an array, which is the same for all boxes.
 *  @param array           an MGDT_PERIODIC_ARRAY_ value
 *  @param[out] columns    how many elements belong together, such as 4 for tetrahedra; may be NULL
 *  @param[out] is_double  1 for mgdt_periodic_get_doubles(), 0 for mgdt_periodic_get_array(); may
 *                         be NULL
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER (both), MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_array_info(int32_t array, int32_t* columns, int32_t* is_double);
/** Gives the number of elements of an array.
 *  @param array  an MGDT_PERIODIC_ARRAY_ value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_NOT_BUILT,
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_get_size(const mgdt_periodic* p, int32_t array, int64_t* size);

/** Writes an array of integers.
 *  @param array     an MGDT_PERIODIC_ARRAY_ value of integers
 *  @param capacity  at least what mgdt_periodic_get_size() gives
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT,
 *  MGDT_ERR_NOT_BUILT, MGDT_ERR_BUFFER_TOO_SMALL, MGDT_ERR_INDEX_RANGE (32 bits: a number does not
 *  fit), MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_get_array(const mgdt_periodic* p, int32_t array,
                                             int64_t capacity, int64_t* values);
/** mgdt_periodic_get_array() with 32-bit integers.
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_get_array_i32(const mgdt_periodic* p, int32_t array,
                                                 int64_t capacity, int32_t* values);

/** Writes an array of doubles.
 *  @param array     an MGDT_PERIODIC_ARRAY_ value of doubles
 *  @param capacity  at least what mgdt_periodic_get_size() gives
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT,
 *  MGDT_ERR_NOT_BUILT, MGDT_ERR_BUFFER_TOO_SMALL
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_get_doubles(const mgdt_periodic* p, int32_t array,
                                               int64_t capacity, double* values);

/** Measures the Voronoi cell of each point, as mgdt_get_cell_measures() does, with the same errors.
 *  A centroid is relative to its point, so it does not depend on which image the point is. With
 *  three vectors the volumes add up to that of the box. A point that is no vertex has 0.
 *  @param measure   an MGDT_MEASURE_ value
 *  @param capacity  elements in x, at least the number of points, or three times that for centroids
 *  @param[out] x    for each point a number, or x y z of a centroid
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_BUFFER_TOO_SMALL,
 *  MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_NOT_BUILT, MGDT_ERR_INVALID_ARGUMENT (a
 *  negative capacity, or points of a slab or a wire that do not span space)
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_get_cell_measures(const mgdt_periodic* p, int32_t measure,
                                                     int64_t capacity, double* x);

/** Makes the Voronoi diagram of the points, a handle as mgdt_voronoi_create() makes it. Each point
 *  has its cell where the caller has put it. Two cells share a face if they meet as they are. A
 *  cell that meets an image of another one, or of itself, has a face of its own: such a face
 *  appears once for each side, as two faces whose shifts are opposite. The first side of each of
 *  them is the point of the cell, the second one the point whose image is on the other side, and
 *  MGDT_VORONOI_ARRAY_FACE_SHIFTS has the shifts. The diagram takes its memory from the same
 *  functions and has the same memory limit for itself.
 *  @param[out] out  the handle; NULL if the call fails. The message of a failure is that of the box
 *                   (mgdt_periodic_get_error())
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_NOT_BUILT, MGDT_ERR_INVALID_ARGUMENT (the
 *  points of a slab or a wire do not span space), MGDT_ERR_TOO_LARGE, MGDT_ERR_CANCELLED,
 *  MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_BUSY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_create_voronoi(const mgdt_periodic* p, mgdt_voronoi** out);

/** Copies the message of the last call that failed on the handle, as mgdt_get_error().
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (a capacity below 1)
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_periodic_get_error(const mgdt_periodic* p, int64_t capacity,
                                             char* buffer);

#ifdef __cplusplus
}
#endif

#endif /* MGDT_MGDT_PERIODIC_H */
