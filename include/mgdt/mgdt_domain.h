/* SPDX-License-Identifier: MIT
 *
 * A mesh of tetrahedra that fills a domain: what closed surfaces enclose.
 *
 * A caller gives points, facets and segments. A facet is a polygon with a marker; a segment is an
 * edge that the mesh has to have. mgdt_domain_build() makes a mesh in which every facet is a union
 * of faces and every segment a union of edges, exactly. Several surfaces, surfaces inside of
 * others, surfaces between two materials and facets that bound nothing are allowed. What facets
 * enclose is filled, unless the caller puts a hole in it (mgdt_domain_add_hole()).
 *
 * Facets, segments and points have to meet in common corners and edges only. A facet that crosses
 * another one, or a corner in the middle of a facet's edge, is refused: mgdt_domain_validate()
 * finds all such pairs, exactly. Equal points are one point. Facets with the same marker that share
 * an edge and are in one plane, exactly, after rounding, are one facet.
 *
 * The mesh is the constrained Delaunay triangulation of its points: no point that is visible from
 * inside of a tetrahedron is in its circumsphere. The points are those of the caller, with the
 * indices that they had, and Steiner points on segments and on edges of facets. The library
 * computes with coordinates that are rounded once, to multiples of 2^-36 of the largest coordinate
 * or finer, rarely coarser (MGDT_DOMAIN_GRID_BITS). The caller's coordinates are returned as they
 * were given, bit by bit, if all tetrahedra have a positive volume with them, and otherwise rounded
 * (MGDT_DOMAIN_IS_ROUNDED); with the rounded ones, Steiner points are on their segments exactly.
 * All tetrahedra that are returned have a positive volume, exactly.
 *
 * The mesh is a function of the points, facets and segments: the order of the facets and the number
 * of threads do not change it.
 *
 * The conventions are those of mgdt.h: status and message, capacities in elements, callbacks, the
 * thread rule.
 *
 * @since 1.3
 */
#ifndef MGDT_MGDT_DOMAIN_H
#define MGDT_MGDT_DOMAIN_H

#include "mgdt.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A handle of a domain and its mesh. The struct is opaque; mgdt_domain_create() makes one. */
typedef struct mgdt_domain mgdt_domain;

/** What an element of MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS is. */
enum {
    MGDT_DOMAIN_KIND_FACET = 0,
    MGDT_DOMAIN_KIND_SEGMENT = 1,
    MGDT_DOMAIN_KIND_POINT = 2 /**< A point that is a corner of no facet and of no segment. */
};

/** Options of mgdt_domain_set_option(). Values are integers. */
enum {
    MGDT_DOMAIN_INDEX_BASE = 10, /**< 0 (default) or 1. It applies to indices that are given or
                                      read later. */
    MGDT_DOMAIN_THREADS = 20,    /**< Threads, see mgdt_set_threads(); default 1, 0 for all
                                      cores. */
    /** Bytes that the handle may hold; 0 (default) for no limit. */
    MGDT_DOMAIN_MEMORY_LIMIT = 30,
    /** 1 to return rounded points always, so that facets and segments are covered exactly by what
     *  is returned; 0 (default) to return the caller's points where possible. */
    MGDT_DOMAIN_ROUND_POINTS = 40,
    /** 1 to refuse a mesh that leaves out a part of what was set; 0 (default) to count what is left
     *  out (MGDT_DOMAIN_UNUSED_POINTS and the numbers after it). */
    MGDT_DOMAIN_STRICT = 50
};

/** Keys of mgdt_domain_get_stat(). Those from MGDT_DOMAIN_STEINER_POINTS on are 0 until there is a
 *  mesh. */
enum {
    MGDT_DOMAIN_GIVEN_POINTS = 10,   /**< Points that were set. */
    MGDT_DOMAIN_GIVEN_FACETS = 11,   /**< Facets that were set. */
    MGDT_DOMAIN_GIVEN_SEGMENTS = 12, /**< Segments that were set. */
    MGDT_DOMAIN_MEMORY_BYTES = 15,   /**< Memory that the handle holds. */
    /** Edges that one facet alone has: see MGDT_DOMAIN_ARRAY_OPEN_EDGES. */
    MGDT_DOMAIN_OPEN_EDGES = 16,
    MGDT_DOMAIN_STEINER_POINTS = 20, /**< Points that the build has added. */
    MGDT_DOMAIN_TETRAHEDRA = 21,     /**< Tetrahedra of the mesh. */
    MGDT_DOMAIN_REGIONS = 22,        /**< Regions of the mesh. */
    MGDT_DOMAIN_FACES = 23,          /**< Faces of the mesh that are parts of facets. */
    MGDT_DOMAIN_IS_ROUNDED = 24,     /**< 1 if the points that are returned are rounded. */
    /** Coordinates are rounded to multiples of 2^-bits of the largest one: 36, or 44 or 40 for a
     *  surface with finer details, or 24 to 32 for one whose edges have to be divided very finely.
     */
    MGDT_DOMAIN_GRID_BITS = 25,
    /** Points that were set and are neither a corner of a tetrahedron nor equal to one. */
    MGDT_DOMAIN_UNUSED_POINTS = 26,
    /** Faces at which there is no tetrahedron: their facets bound nothing and are outside. */
    MGDT_DOMAIN_UNUSED_FACES = 27,
    /** Calls of mgdt_domain_add_region() with a place in no region of the mesh. */
    MGDT_DOMAIN_UNUSED_REGIONS = 28,
    /** Calls of mgdt_domain_add_hole() with a place in nothing that the facets enclose. */
    MGDT_DOMAIN_UNUSED_HOLES = 29,
    MGDT_DOMAIN_PLANAR_FACETS = 30,  /**< Facets, where those in one plane are joined. */
    MGDT_DOMAIN_MISSING_FACETS = 31, /**< Of these, those that the Delaunay triangulation of all
                                          points lacks. */
    MGDT_DOMAIN_CAVITIES = 32,       /**< Parts of it that were filled anew. */
    MGDT_DOMAIN_LARGEST_CAVITY = 33  /**< The most tetrahedra in one of them. */
};

/** Arrays of a domain. Those up to MGDT_DOMAIN_ARRAY_STEINER_EDGES have integers, for
 *  mgdt_domain_get_array(); the others have doubles, for mgdt_domain_get_doubles(). Points, facets,
 *  segments, tetrahedra and regions are numbered from the index base. Where there is none, the
 *  number is the index base - 1. Until there is a mesh, calls that ask for another array than the
 *  first two fail with MGDT_ERR_NOT_BUILT. */
enum {
    /** Four elements for each pair that mgdt_domain_validate() or mgdt_domain_build() has found: a
     *  kind (MGDT_DOMAIN_KIND_FACET and so on) and a number, twice. What is bad by itself is paired
     *  with itself: a facet that is flat or no polygon, or a segment without length. */
    MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS = 10,
    /** Three elements for each edge that one facet alone has, where a surface is open: the two ends
     *  and the facet. mgdt_domain_validate() and mgdt_domain_build() find them if there are no
     *  offending pairs. Facets that bound nothing have such edges too. */
    MGDT_DOMAIN_ARRAY_OPEN_EDGES = 11,
    /** Four corners for each tetrahedron, positively oriented as in mgdt_get_tetrahedra(). The
     *  tetrahedra are sorted by their corners. */
    MGDT_DOMAIN_ARRAY_TETRAHEDRA = 20,
    /** For each tetrahedron the numbers of the four tetrahedra opposite its corners. None means
     *  that the domain ends there. */
    MGDT_DOMAIN_ARRAY_NEIGHBORS = 21,
    MGDT_DOMAIN_ARRAY_REGIONS = 22, /**< The region of each tetrahedron. */
    /** The marker of each region: that of the last mgdt_domain_add_region() with a place inside of
     *  it, or 0. */
    MGDT_DOMAIN_ARRAY_REGION_MARKERS = 23,
    /** Three corners for each face of the mesh that is a part of a facet. They turn in the same
     *  direction as those of the facet. */
    MGDT_DOMAIN_ARRAY_FACES = 30,
    /** The two tetrahedra at each face: first the one from which the corners appear
     *  counter-clockwise, then the other one. */
    MGDT_DOMAIN_ARRAY_FACE_TETRAHEDRA = 31,
    /** The facet that each face is a part of; of facets that are joined, the first one. */
    MGDT_DOMAIN_ARRAY_FACE_FACETS = 32,
    MGDT_DOMAIN_ARRAY_FACE_MARKERS = 33, /**< The marker of this facet. */
    /** Two ends for each edge of the mesh that is a part of a segment, or of an edge of facets that
     *  does not lie inside of a joined facet. */
    MGDT_DOMAIN_ARRAY_SEGMENTS = 40,
    /** The segment that the caller has set and that each of these is a part of, or none. */
    MGDT_DOMAIN_ARRAY_SEGMENT_SOURCES = 41,
    MGDT_DOMAIN_ARRAY_SEGMENT_MARKERS = 42, /**< The marker of this segment, or 0. */
    /** The two ends a and b of the edge that each Steiner point divides. */
    MGDT_DOMAIN_ARRAY_STEINER_EDGES = 50,
    /** Three coordinates of each point: first the points that were set, then the Steiner points. */
    MGDT_DOMAIN_ARRAY_POINTS = 60,
    /** For each Steiner point the number t for which it is a + t (b - a). */
    MGDT_DOMAIN_ARRAY_STEINER_PARAMETERS = 61
};

/* ------------------------------------------------------------------------------- life --- */

/** Makes a domain without points.
 *  @param[out] out  the handle; NULL if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_create(mgdt_domain** out);

/** Makes a domain that takes all its memory from `alloc`.
 *  @param alloc, release, user  as for mgdt_create_with_allocator()
 *  @return as mgdt_domain_create(), and MGDT_ERR_INVALID_ARGUMENT (one function without the other)
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release,
                                                       void* user, mgdt_domain** out);

/** Frees the domain. NULL is allowed. While another call is running on the handle, this function
 *  does nothing, as mgdt_destroy().
 *  @since 1.3 */
MGDT_API void mgdt_domain_destroy(mgdt_domain* d);

/** Removes points, facets, segments, regions, holes and the mesh. The options stay. A pending
 *  cancellation is withdrawn.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_clear(mgdt_domain* d);

/* --------------------------------------------------------------------------- settings --- */

/** Sets an option.
 *  @param option  MGDT_DOMAIN_INDEX_BASE to MGDT_DOMAIN_STRICT, which document their values
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_option(mgdt_domain* d, int32_t option, int64_t value);
/** The value of an option.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_option(const mgdt_domain* d, int32_t option, int64_t* value);

/** Sets the callback that receives the progress of mgdt_domain_build() and may cancel it.
 *  @param fn    the callback; NULL for none (default)
 *  @param user  passed to the callback
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_progress(mgdt_domain* d, mgdt_progress_fn fn, void* user);

/** Asks the running mgdt_domain_build() or mgdt_domain_validate() to stop soon. That call then
 *  returns MGDT_ERR_CANCELLED. If none is running, the request stays pending and stops the next
 *  one, unless mgdt_domain_clear() comes first. Any thread and any signal handler may call this
 *  function.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_cancel(mgdt_domain* d);

/* ------------------------------------------------------------------------------ input --- */

/** Sets the points, which are copied. Facets and segments that were set before are removed, and so
 *  is the mesh; regions and holes stay. A call that fails changes nothing.
 *  @param n    number of points, at least 0
 *  @param xyz  3 n coordinates; may be NULL if n is 0
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n), MGDT_ERR_NOT_FINITE (the
 *  message names the point), MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_points(mgdt_domain* d, int64_t n, const double* xyz);

/** Sets the facets, which are copied, in place of those that were set before. The mesh is removed.
 *  A call that fails changes nothing.
 *
 *  A facet is a triangle, or a polygon that is divided into triangles. A polygon need not be
 *  planar; where its triangles are not in one plane, the edges between them are edges of the mesh.
 *  A polygon with holes may walk to a hole along an edge and back along the same edge.
 *  @param n        number of facets, at least 0
 *  @param offsets  n + 1 ascending numbers: the corners of facet i begin at element offsets[i] of
 *                  `corners` and end before element offsets[i + 1], both counted from the index
 *                  base. NULL if all facets are triangles
 *  @param corners  the points at the corners of the facets, in order around each
 *  @param markers  n markers, or NULL: then all are 0
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n, a facet with fewer than
 *  three corners, offsets that do not ascend, or a corner that is no point; the message names it),
 *  MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_facets(mgdt_domain* d, int64_t n, const int64_t* offsets,
                                            const int64_t* corners, const int32_t* markers);

/** Sets the segments, which are copied, in place of those that were set before. The mesh is
 *  removed. Edges of facets are in the mesh without being set. A call that fails changes nothing.
 *  @param n        number of segments, at least 0
 *  @param ends     2 n points
 *  @param markers  n markers, or NULL: then all are 0
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n, or an end that is no
 *  point), MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_segments(mgdt_domain* d, int64_t n, const int64_t* ends,
                                              const int32_t* markers);

/** Gives the region that contains a place a marker. The mesh is removed. A place outside of the
 *  domain has no effect, and MGDT_DOMAIN_UNUSED_REGIONS counts it; a place on a facet is in the
 *  regions on both of its sides.
 *  @param xyz  the 3 coordinates of a place inside of the region
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_NOT_FINITE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_add_region(mgdt_domain* d, const double* xyz, int32_t marker);

/** Makes what facets enclose around a place a hole, which is not filled. The mesh is removed. A
 *  place on a facet makes both of its sides holes. A place in nothing that facets enclose has no
 *  effect, and MGDT_DOMAIN_UNUSED_HOLES counts it.
 *  @param xyz  the 3 coordinates of a place inside of the hole
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_NOT_FINITE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_add_hole(mgdt_domain* d, const double* xyz);

/* ------------------------------------------------------------------------------ calls --- */

/** Finds all pairs of facets, segments and points that do not meet in common corners and edges,
 *  facets that are flat or no polygons, and segments without length: exactly, without tolerances.
 *  The array MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS has them afterwards. An earlier mesh is removed.
 *  @return MGDT_OK if there are none, MGDT_ERR_INVALID_BOUNDARY (the message names the first pair),
 *  MGDT_ERR_NULL_POINTER, MGDT_ERR_TOO_LARGE, MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_validate(mgdt_domain* d);

/** Makes the mesh, in place of an earlier one. Facets that enclose nothing are refused; if all that
 *  they enclose are holes, the mesh has no tetrahedra.
 *  @return MGDT_OK or MGDT_ERR_NULL_POINTER. After any other status there is no mesh:
 *  MGDT_ERR_INVALID_BOUNDARY as for mgdt_domain_validate(), MGDT_ERR_OPEN_BOUNDARY (the facets
 *  enclose nothing; the message names an edge where they are open, and
 *  MGDT_DOMAIN_ARRAY_OPEN_EDGES has all), MGDT_ERR_RESOLUTION (points or facets
 *  are nearer to each other than the grid to which points are rounded, or an edge would have to be
 *  divided more finely than doubles can), MGDT_ERR_TOO_LARGE, MGDT_ERR_CANCELLED,
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_build(mgdt_domain* d);

/** Checks the mesh, with exact arithmetic, against what was set: all tetrahedra are positive and do
 *  not overlap; every facet is covered by faces, once, and every segment by edges; regions end at
 *  facets, have the markers of the places in them and contain no holes; and the mesh is constrained
 *  Delaunay (docs/theory.md, "Meshes of domains"). It does not find anew which of the parts that
 *  facets enclose have to be filled.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_NOT_BUILT,
 *  MGDT_ERR_CHECK_FAILED (the message says what is wrong and where), MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_check(const mgdt_domain* d);

/* ---------------------------------------------------------------------------- results --- */

/** Gives one number of the domain.
 *  @param key  MGDT_DOMAIN_GIVEN_POINTS to MGDT_DOMAIN_LARGEST_CAVITY
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_stat(const mgdt_domain* d, int32_t key, int64_t* value);

/** Gives the number of elements of an array.
 *  @param array  an MGDT_DOMAIN_ARRAY_ value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_NOT_BUILT
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_size(const mgdt_domain* d, int32_t array, int64_t* size);

/** Writes an array of integers.
 *  @param array     MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS to MGDT_DOMAIN_ARRAY_STEINER_EDGES
 *  @param capacity  at least what mgdt_domain_get_size() gives
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT,
 *  MGDT_ERR_NOT_BUILT, MGDT_ERR_BUFFER_TOO_SMALL, MGDT_ERR_INDEX_RANGE (32 bits: a number does not
 *  fit)
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_array(const mgdt_domain* d, int32_t array, int64_t capacity,
                                           int64_t* values);
/** mgdt_domain_get_array() with 32-bit integers.
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_array_i32(const mgdt_domain* d, int32_t array,
                                               int64_t capacity, int32_t* values);

/** Writes an array of doubles.
 *  @param array     MGDT_DOMAIN_ARRAY_POINTS or MGDT_DOMAIN_ARRAY_STEINER_PARAMETERS
 *  @param capacity  at least what mgdt_domain_get_size() gives
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT,
 *  MGDT_ERR_NOT_BUILT, MGDT_ERR_BUFFER_TOO_SMALL
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_doubles(const mgdt_domain* d, int32_t array, int64_t capacity,
                                             double* values);

/** Copies the message of the last call that failed on the handle, as mgdt_get_error().
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (a capacity below 1)
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_error(const mgdt_domain* d, int64_t capacity, char* buffer);

#ifdef __cplusplus
}
#endif

#endif /* MGDT_MGDT_DOMAIN_H */
