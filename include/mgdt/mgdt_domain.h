/* SPDX-License-Identifier: MIT
 *
 * A domain, which closed surfaces enclose, to be filled with a mesh of tetrahedra.
 *
 * A caller gives points, facets and segments. A facet is a polygon with a marker; a segment is an
 * edge that the mesh has to have. mgdt_domain_build() makes a mesh (mgdt_mesh.h) in which every
 * facet is a union of faces and every segment a union of edges, exactly. Several surfaces, surfaces
 * inside of others, surfaces between two materials and facets that bound nothing are allowed. What
 * facets enclose is filled, unless the caller puts a hole in it (mgdt_domain_set_holes()).
 *
 * Facets, segments and points have to meet in common corners and edges only. A facet that crosses
 * another one, or a corner in the middle of a facet's edge, is refused: mgdt_domain_validate()
 * finds all such pairs, exactly, and mgdt_domain_clean() mends those that need no new points. Equal
 * points are one point. Facets with the same marker that share an edge and are in one plane,
 * exactly, after rounding, are one facet.
 *
 * The conventions are those of mgdt.h: status and message, capacities in elements, callbacks, the
 * ranges of keys, the thread rule.
 *
 * @since 1.3
 */
#ifndef MGDT_MGDT_DOMAIN_H
#define MGDT_MGDT_DOMAIN_H

#include "mgdt_mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A handle of a domain. The struct is opaque; mgdt_domain_create() makes one. */
typedef struct mgdt_domain mgdt_domain;

/** What an element of MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS is. */
enum {
    MGDT_DOMAIN_KIND_FACET = 0,
    MGDT_DOMAIN_KIND_SEGMENT = 1,
    MGDT_DOMAIN_KIND_POINT = 2 /**< A point that is a corner of no facet and of no segment. */
};

/** Options of mgdt_domain_set_option(), whose values are integers, and, where that is said, of
 *  mgdt_domain_set_double_option(), whose values are doubles. */
enum {
    /** 0 (default) or 1. It applies to indices that are given or read later. */
    MGDT_DOMAIN_OPTION_INDEX_BASE = 10,
    /** Threads, see mgdt_set_threads(); default 1, 0 for all cores. */
    MGDT_DOMAIN_OPTION_THREADS = 20,
    /** Bytes that the handle may hold; 0 (default) for no limit. */
    MGDT_DOMAIN_OPTION_MEMORY_LIMIT = 30,
    /** 1 to return rounded points always, so that facets and segments are covered exactly by what
     *  is returned; 0 (default) to return the caller's points where possible (mgdt_mesh.h). */
    MGDT_DOMAIN_OPTION_ROUND_POINTS = 40,
    /** 1 to refuse a mesh that leaves out a part of what was set; 0 (default) to count what is left
     *  out (MGDT_MESH_STAT_UNUSED_POINTS and the statistics after it). */
    MGDT_DOMAIN_OPTION_STRICT = 50,
    /** 1 to keep the boundary as it is: each triangle of a facet is one face, each segment and each
     *  edge of a facet one edge, with the caller's coordinates, and Steiner points are inside of
     *  the domain only. 0 (default) to divide segments where that is necessary. Since 1.4. */
    MGDT_DOMAIN_OPTION_KEEP_BOUNDARY = 60,
    /** A double: the distance within which mgdt_domain_clean() takes places for one place, as a
     *  share of the size of the points, which is the diagonal of their box. 0 (default) for equal
     *  places only, otherwise less than 0.1. Since 1.4. */
    MGDT_DOMAIN_OPTION_WELD = 70,
    /** A double: the distance within which mgdt_domain_clean() takes facets of one marker for
     *  facets in one plane, as a share of the same size. 0 (default) for facets that are exactly in
     *  one plane, otherwise less than 0.1. Since 1.4. */
    MGDT_DOMAIN_OPTION_FLATNESS = 80
};

/** Keys of mgdt_domain_get_stat(). */
enum {
    MGDT_DOMAIN_STAT_POINTS = 100, /**< Points that were set. */
    /** Facets and segments that were set, or that mgdt_domain_clean() has made of them. */
    MGDT_DOMAIN_STAT_FACETS = 101,
    MGDT_DOMAIN_STAT_SEGMENTS = 102,
    MGDT_DOMAIN_STAT_REGIONS = 103,      /**< Places of regions that were set. */
    MGDT_DOMAIN_STAT_HOLES = 104,        /**< Places of holes that were set. */
    MGDT_DOMAIN_STAT_MEMORY_BYTES = 110, /**< Memory that the handle holds. */
    /** Pairs in MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS. */
    MGDT_DOMAIN_STAT_OFFENDING_PAIRS = 120,
    /** Edges in MGDT_DOMAIN_ARRAY_OPEN_EDGES. */
    MGDT_DOMAIN_STAT_OPEN_EDGES = 121,
    /* What the last mgdt_domain_clean() has done; 0 after a change of points or facets. */
    MGDT_DOMAIN_STAT_MOVED_POINTS = 130,     /**< Points that were moved to others. Since 1.4. */
    MGDT_DOMAIN_STAT_REPEATED_CORNERS = 131, /**< Corners that were left out. Since 1.4. */
    /** Facets of which nothing is left, because their corners are on a line. Since 1.4. */
    MGDT_DOMAIN_STAT_COLLAPSED_FACETS = 132,
    /** Pairs in MGDT_DOMAIN_ARRAY_COVERED_FACETS. Since 1.4. */
    MGDT_DOMAIN_STAT_COVERED_FACETS = 133,
    /** Pairs of an edge and a point in it that has divided it. Since 1.4. */
    MGDT_DOMAIN_STAT_POINTS_IN_EDGES = 134,
    /** Pairs of a triangle of a facet and a point inside of it that has divided it. Since 1.4. */
    MGDT_DOMAIN_STAT_POINTS_IN_FACETS = 135,
    /** Edges of other facets, and segments, that facets have taken in. Since 1.4. */
    MGDT_DOMAIN_STAT_EDGES_IN_FACETS = 136,
    /** Edges between two triangles in one plane that the other diagonal has replaced. Since 1.4. */
    MGDT_DOMAIN_STAT_EXCHANGED_EDGES = 137
};

/** Arrays of a domain, of integers for mgdt_domain_get_array() and of doubles for
 *  mgdt_domain_get_doubles(). Points, facets and segments are numbered from the index base.
 *
 *  mgdt_domain_validate() and mgdt_domain_build() set the offending pairs and the open edges, and a
 *  change of points, facets or segments empties them. The other arrays, which exist since 1.4, have
 *  what was set, or what mgdt_domain_clean() has made of it. */
enum {
    /** Four elements for each offending pair: a kind (MGDT_DOMAIN_KIND_FACET and so on) and a
     *  number, twice. What is bad by itself is paired with itself: a facet that is flat or no
     *  polygon, or a segment without length. */
    MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS = 200,
    /** Three elements for each edge that one facet alone has, where a surface is open: the two ends
     *  and the facet. They are found if there are no offending pairs. Facets that bound nothing
     *  have such edges too. */
    MGDT_DOMAIN_ARRAY_OPEN_EDGES = 210,
    /** Offsets and corners of the facets, as mgdt_domain_set_facets() takes them. */
    MGDT_DOMAIN_ARRAY_FACET_OFFSETS = 220,
    MGDT_DOMAIN_ARRAY_FACET_CORNERS = 221,
    MGDT_DOMAIN_ARRAY_FACET_MARKERS = 222, /**< The marker of each facet. */
    /** For each facet the one of the facets that were set that it is, or is a part of. Where edges
     *  between facets in one plane were exchanged, it is one of these facets. */
    MGDT_DOMAIN_ARRAY_FACET_ORIGINS = 223,
    /** Two elements for each pair of facets that were set: one that is covered by another facet,
     *  wholly or in part, and that other facet, which stays in its place. */
    MGDT_DOMAIN_ARRAY_COVERED_FACETS = 224,
    MGDT_DOMAIN_ARRAY_SEGMENTS = 230,        /**< Two points for each segment. */
    MGDT_DOMAIN_ARRAY_SEGMENT_MARKERS = 231, /**< The marker of each segment. */
    /** For each segment the one that was set that it is, or is a part of. */
    MGDT_DOMAIN_ARRAY_SEGMENT_ORIGINS = 232,
    MGDT_DOMAIN_ARRAY_POINTS = 300 /**< Doubles: three coordinates for each point. */
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

/** Removes points, facets, segments, regions and holes. The options stay. A pending cancellation is
 *  withdrawn.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_clear(mgdt_domain* d);

/* --------------------------------------------------------------------------- settings --- */

/** Sets an option.
 *  @param option  an MGDT_DOMAIN_OPTION_ value, which documents its values
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_option(mgdt_domain* d, int32_t option, int64_t value);
/** The value of an option.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_option(const mgdt_domain* d, int32_t option, int64_t* value);

/** Sets an option whose value is a double.
 *  @param option  an MGDT_DOMAIN_OPTION_ value that documents a double
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_domain_set_double_option(mgdt_domain* d, int32_t option, double value);
/** The value of an option that is a double.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_domain_get_double_option(const mgdt_domain* d, int32_t option,
                                                   double* value);

/** Sets the callback that receives the progress of mgdt_domain_clean(), mgdt_domain_validate(),
 *  mgdt_domain_build() and mgdt_domain_check() and may cancel them; see mgdt_set_progress().
 *  @param fn    the callback; NULL for none (default)
 *  @param user  passed to the callback
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_progress(mgdt_domain* d, mgdt_progress_fn fn, void* user);
/** The progress callback, or NULL, and what is passed to it.
 *  @param[out] user  may be NULL
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_progress(const mgdt_domain* d, mgdt_progress_fn* fn,
                                              void** user);

/** Asks the running call to stop soon, if it is one that mgdt_domain_set_progress() names. It then
 *  returns MGDT_ERR_CANCELLED. If none is running, the request stays pending and stops the next
 *  one, unless mgdt_domain_clear() comes first. Any thread and any signal handler may call this
 *  function.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_cancel(mgdt_domain* d);

/* ------------------------------------------------------------------------------ input --- */

/** Sets the points, which are copied. Facets and segments that were set before are removed; regions
 *  and holes stay. A call that fails changes nothing.
 *  @param n    number of points, at least 0
 *  @param xyz  3 n coordinates; may be NULL if n is 0
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n), MGDT_ERR_NOT_FINITE (the
 *  message names the point), MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_points(mgdt_domain* d, int64_t n, const double* xyz);

/** Sets the facets, which are copied, in place of those that were set before. A call that fails
 *  changes nothing.
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
/** mgdt_domain_set_facets() with 32-bit integers.
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_facets_i32(mgdt_domain* d, int64_t n, const int32_t* offsets,
                                                const int32_t* corners, const int32_t* markers);

/** Sets the segments, which are copied, in place of those that were set before. Edges of facets are
 *  in the mesh without being set. A call that fails changes nothing.
 *  @param n        number of segments, at least 0
 *  @param ends     2 n points
 *  @param markers  n markers, or NULL: then all are 0
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n, or an end that is no
 *  point), MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_segments(mgdt_domain* d, int64_t n, const int64_t* ends,
                                              const int32_t* markers);
/** mgdt_domain_set_segments() with 32-bit integers.
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_segments_i32(mgdt_domain* d, int64_t n, const int32_t* ends,
                                                  const int32_t* markers);

/** Gives regions of the mesh their markers, in place of what was set before. A region has the
 *  marker of the last place in it. A place outside of the domain has no effect, and
 *  MGDT_MESH_STAT_UNUSED_REGIONS counts it; a place on a facet is in the regions on both of its
 *  sides. A call that fails changes nothing.
 *  @param n        number of places, at least 0
 *  @param xyz      3 n coordinates of places inside of regions; may be NULL if n is 0
 *  @param markers  n markers, or NULL: then all are 0
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n), MGDT_ERR_NOT_FINITE,
 *  MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_regions(mgdt_domain* d, int64_t n, const double* xyz,
                                             const int32_t* markers);

/** Makes what facets enclose around places holes, which are not filled, in place of what was set
 *  before. A place on a facet makes both of its sides holes. A place in nothing that facets enclose
 *  has no effect, and MGDT_MESH_STAT_UNUSED_HOLES counts it. A call that fails changes nothing.
 *  @param n    number of places, at least 0
 *  @param xyz  3 n coordinates of places inside of holes; may be NULL if n is 0
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n), MGDT_ERR_NOT_FINITE,
 *  MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_set_holes(mgdt_domain* d, int64_t n, const double* xyz);

/* ------------------------------------------------------------------------------ calls --- */

/** Cleans facets and segments: mends what needs no new points. The result takes the place of what
 *  was set. Points keep their numbers. In meshes and in the arrays of the domain, facets and
 *  segments have the numbers of those that were set.
 *
 *  - Points within the distance MGDT_DOMAIN_OPTION_WELD of each other get the coordinates of one of
 *    them. No point moves farther than that.
 *  - A corner of a facet that repeats the one before it is left out. So is a facet whose corners
 *    are on a line, and a segment without length.
 *  - Points in edges, in segments and inside of facets, exactly or within that distance, become
 *    corners: what they are in is divided.
 *  - Facets in one plane take in the edges of other facets, and segments, that are in them from one
 *    of their points to another.
 *  - Where two facets cover the same place, the smaller facet stays there, so that a facet that
 *    marks a part of another one keeps its marker. Of facets of equal size the first one stays.
 *    MGDT_DOMAIN_ARRAY_COVERED_FACETS has both.
 *  - If MGDT_DOMAIN_OPTION_FLATNESS is not 0, facets of one marker that share an edge and are in
 *    one plane, within that distance, become Delaunay triangles in it, as far as edges may be
 *    exchanged. The mesh then needs fewer Steiner points. What the facets cover moves by at most
 *    twice that distance.
 *
 *  Facets that need no change stay as they are. Facets that cross each other need new points: they
 *  stay too, and mgdt_domain_validate() finds them. With both distances 0 all decisions are exact,
 *  and the facets cover the same places as before.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_TOO_LARGE, MGDT_ERR_CANCELLED,
 *  MGDT_ERR_OUT_OF_MEMORY. A call that fails changes nothing
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_domain_clean(mgdt_domain* d);

/** Finds all pairs of facets, segments and points that do not meet in common corners and edges,
 *  facets that are flat or no polygons, and segments without length: exactly, without tolerances.
 *  The array MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS has them afterwards.
 *  @return MGDT_OK if there are none, MGDT_ERR_INVALID_BOUNDARY (the message names the first pair),
 *  MGDT_ERR_NULL_POINTER, MGDT_ERR_TOO_LARGE, MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_validate(mgdt_domain* d);

/** Makes a mesh. Facets that enclose nothing are refused; if all that they enclose are holes, the
 *  mesh has no tetrahedra. The domain stays as it is, and may be changed and built again.
 *  @param[out] out  the handle of the mesh; NULL if the call fails. The message of a failure is
 *                   that of the domain (mgdt_domain_get_error())
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_BOUNDARY as for mgdt_domain_validate(),
 *  MGDT_ERR_OPEN_BOUNDARY (the facets enclose nothing; the message names an edge where they are
 *  open, and MGDT_DOMAIN_ARRAY_OPEN_EDGES has all), MGDT_ERR_RESOLUTION (points or facets are
 *  nearer to each other than the grid to which points are rounded, or an edge would have to be
 *  divided more finely than doubles can, or the boundary cannot be kept; the message names an
 *  edge), MGDT_ERR_INVALID_ARGUMENT (with
 *  MGDT_DOMAIN_OPTION_STRICT: what the mesh leaves out), MGDT_ERR_TOO_LARGE, MGDT_ERR_CANCELLED,
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_build(mgdt_domain* d, mgdt_mesh** out);

/** Compares a mesh with what was set, with exact arithmetic: the points are those of the domain;
 *  every facet is covered by faces, once, and every segment by edges; regions have the markers of
 *  the places in them and contain no holes. It does not find anew which of the parts that facets
 *  enclose have to be filled. mgdt_mesh_check() checks all else of the mesh, and both together
 *  prove it (docs/theory.md, "Meshes of domains").
 *  @param mesh  a mesh that mgdt_mesh_check() accepts, and that mgdt_mesh_improve() has not changed
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_CHECK_FAILED (the message says what is wrong
 *  and where), MGDT_ERR_INVALID_ARGUMENT (since 1.4: the mesh has been improved, or was made by
 *  mgdt_mesh_build()), MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_BUSY (the domain or the
 *  mesh)
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_check(const mgdt_domain* d, const mgdt_mesh* mesh);

/* ---------------------------------------------------------------------------- results --- */

/** Gives one number of the domain.
 *  @param key  an MGDT_DOMAIN_STAT_ value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_stat(const mgdt_domain* d, int32_t key, int64_t* value);

/** Gives the shape of an array, which is the same for all domains.
 *  @param array           an MGDT_DOMAIN_ARRAY_ value
 *  @param[out] columns    how many elements belong together, such as 4 for a pair; may be NULL
 *  @param[out] is_double  1 for mgdt_domain_get_doubles(), 0 for mgdt_domain_get_array(); may be
 *                         NULL
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER (both), MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_array_info(int32_t array, int32_t* columns, int32_t* is_double);
/** Gives the number of elements of an array.
 *  @param array  an MGDT_DOMAIN_ARRAY_ value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_size(const mgdt_domain* d, int32_t array, int64_t* size);

/** Writes an array of integers.
 *  @param array     an MGDT_DOMAIN_ARRAY_ value
 *  @param capacity  at least what mgdt_domain_get_size() gives
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT,
 *  MGDT_ERR_BUFFER_TOO_SMALL, MGDT_ERR_INDEX_RANGE (32 bits: a number does not fit; the elements of
 *  `values` are undefined then)
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_array(const mgdt_domain* d, int32_t array, int64_t capacity,
                                           int64_t* values);
/** mgdt_domain_get_array() with 32-bit integers.
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_domain_get_array_i32(const mgdt_domain* d, int32_t array,
                                               int64_t capacity, int32_t* values);

/** Writes an array of doubles.
 *  @param array     an MGDT_DOMAIN_ARRAY_ value of doubles
 *  @param capacity  at least what mgdt_domain_get_size() gives
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT,
 *  MGDT_ERR_BUFFER_TOO_SMALL
 *  @since 1.4 */
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
