/* SPDX-License-Identifier: MIT
 *
 * A mesh of tetrahedra, as mgdt_domain_build() makes it of a domain (mgdt_domain.h).
 *
 * A mesh is a snapshot: it does not change with the domain that it was made from, and outlives it.
 * It takes its memory from the functions of that domain, has the same memory limit for itself, and
 * begins with the same index base and number of threads.
 *
 * Every facet of the domain is a union of faces of the mesh, and every segment a union of edges,
 * exactly. The mesh is the constrained Delaunay triangulation of its points: no point that is
 * visible from inside of a tetrahedron is in its circumsphere. All tetrahedra have a positive
 * volume with the coordinates that are returned, exactly.
 *
 * The points are those of the caller, with the indices that they had, and Steiner points. The
 * library computes with coordinates that are rounded once, to multiples of 2^-36 of the largest
 * coordinate or finer, rarely coarser (MGDT_MESH_STAT_GRID_BITS). The caller's coordinates are
 * returned as they were given, bit by bit, if all tetrahedra have a positive volume with them, and
 * otherwise rounded (MGDT_MESH_STAT_IS_ROUNDED); with the rounded ones, Steiner points are on their
 * segments exactly.
 *
 * The mesh is a function of the points, facets and segments: the order of the facets and the number
 * of threads do not change it.
 *
 * The conventions are those of mgdt.h: status and message, capacities in elements, callbacks, the
 * ranges of keys, the thread rule.
 *
 * @since 1.3
 */
#ifndef MGDT_MGDT_MESH_H
#define MGDT_MGDT_MESH_H

#include "mgdt.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A handle of a mesh. The struct is opaque; mgdt_domain_build() makes one. */
typedef struct mgdt_mesh mgdt_mesh;

/** Options of mgdt_mesh_set_option(). Values are integers. */
enum {
    /** 0 or 1, at first that of the domain. It applies to indices that are read later. */
    MGDT_MESH_OPTION_INDEX_BASE = 10,
    /** Threads, see mgdt_set_threads(), at first those of the domain; 0 for all cores. */
    MGDT_MESH_OPTION_THREADS = 20,
    /** Bytes that the handle may hold, at first the limit of the domain; 0 for no limit. */
    MGDT_MESH_OPTION_MEMORY_LIMIT = 30
};

/** Keys of mgdt_mesh_get_stat(). */
enum {
    MGDT_MESH_STAT_POINTS = 100,         /**< Points, Steiner points included. */
    MGDT_MESH_STAT_STEINER_POINTS = 101, /**< Points that the library has added. */
    MGDT_MESH_STAT_TETRAHEDRA = 102,     /**< Tetrahedra. */
    MGDT_MESH_STAT_REGIONS = 103,        /**< Regions. */
    MGDT_MESH_STAT_FACES = 104,          /**< Faces that are parts of facets. */
    MGDT_MESH_STAT_EDGES = 105,        /**< Edges that are parts of segments or of facets' edges. */
    MGDT_MESH_STAT_MEMORY_BYTES = 110, /**< Memory that the handle holds. */
    MGDT_MESH_STAT_IS_ROUNDED = 120,   /**< 1 if the points that are returned are rounded. */
    /** Coordinates are rounded to multiples of 2^-bits of the largest one: 36, or 44 or 40 for a
     *  surface with finer details, or 24 to 32 for one whose edges have to be divided very finely.
     */
    MGDT_MESH_STAT_GRID_BITS = 121,
    /** Points that were set and are neither a corner of a tetrahedron nor equal to one. */
    MGDT_MESH_STAT_UNUSED_POINTS = 130,
    /** Faces at which there is no tetrahedron: their facets bound nothing and are outside. */
    MGDT_MESH_STAT_UNUSED_FACES = 131,
    /** Places of mgdt_domain_set_regions() that are in no region of the mesh. */
    MGDT_MESH_STAT_UNUSED_REGIONS = 132,
    /** Places of mgdt_domain_set_holes() that are in nothing that the facets enclose. */
    MGDT_MESH_STAT_UNUSED_HOLES = 133,
    /** Facets, where those in one plane are joined. This number and the next three describe steps
     *  of the algorithm; they may be 0 in later versions. */
    MGDT_MESH_STAT_PLANAR_FACETS = 140,
    /** Joined facets that the Delaunay triangulation of all points lacks. */
    MGDT_MESH_STAT_MISSING_FACETS = 141,
    MGDT_MESH_STAT_CAVITIES = 142,      /**< Parts of that triangulation that were filled anew. */
    MGDT_MESH_STAT_LARGEST_CAVITY = 143 /**< The most tetrahedra in one of them. */
};

/** Arrays of a mesh, of integers for mgdt_mesh_get_array() and of doubles for
 *  mgdt_mesh_get_doubles(). Points, facets, segments, tetrahedra and regions are numbered from the
 *  index base. Where there is none, the number is the index base - 1. */
enum {
    /** For each point the point of the domain that it is, of equal ones the first; none for a
     *  Steiner point. */
    MGDT_MESH_ARRAY_POINT_ORIGINS = 200,
    /** Four corners for each tetrahedron, positively oriented as in mgdt_get_tetrahedra(). The
     *  tetrahedra are sorted by their corners. */
    MGDT_MESH_ARRAY_TETRAHEDRA = 210,
    /** For each tetrahedron the numbers of the four tetrahedra opposite its corners. None means
     *  that the domain ends there. */
    MGDT_MESH_ARRAY_NEIGHBORS = 211,
    MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS = 212, /**< The region of each tetrahedron. */
    /** The marker of each region: that of the last place of mgdt_domain_set_regions() inside of
     *  it, or 0. */
    MGDT_MESH_ARRAY_REGION_MARKERS = 220,
    /** Three corners for each face of the mesh that is a part of a facet. They turn in the same
     *  direction as those of the facet. */
    MGDT_MESH_ARRAY_FACES = 230,
    /** The two tetrahedra at each face: first the one from which the corners appear
     *  counter-clockwise, then the other one. */
    MGDT_MESH_ARRAY_FACE_TETRAHEDRA = 231,
    /** The facet that each face is a part of; of facets that are joined, the first one. */
    MGDT_MESH_ARRAY_FACE_FACETS = 232,
    MGDT_MESH_ARRAY_FACE_MARKERS = 233, /**< The marker of this facet. */
    /** Two ends for each edge of the mesh that is a part of a segment, or of an edge of facets that
     *  does not lie inside of a joined facet. */
    MGDT_MESH_ARRAY_EDGES = 240,
    /** The segment that the caller has set and that each of these edges is a part of, or none. */
    MGDT_MESH_ARRAY_EDGE_SEGMENTS = 241,
    MGDT_MESH_ARRAY_EDGE_MARKERS = 242, /**< The marker of this segment, or 0. */
    /** For each Steiner point the two points a and b that it is between. Later versions may add
     *  Steiner points that are between no two points: then a and b are none. */
    MGDT_MESH_ARRAY_STEINER_EDGES = 250,
    /** Three coordinates of each point: first the points that were set, then the Steiner points. */
    MGDT_MESH_ARRAY_POINTS = 300,
    /** For each Steiner point the number t for which it is a + t (b - a). */
    MGDT_MESH_ARRAY_STEINER_PARAMETERS = 310
};

/* ------------------------------------------------------------------------------- life --- */

/** Frees the mesh. NULL is allowed. While another call is running on the handle, this function does
 *  nothing, as mgdt_destroy().
 *  @since 1.3 */
MGDT_API void mgdt_mesh_destroy(mgdt_mesh* m);

/* --------------------------------------------------------------------------- settings --- */

/** Sets an option.
 *  @param option  an MGDT_MESH_OPTION_ value, which documents its values
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_set_option(mgdt_mesh* m, int32_t option, int64_t value);
/** The value of an option.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_get_option(const mgdt_mesh* m, int32_t option, int64_t* value);

/** Sets the callback that receives the progress of mgdt_mesh_check() and
 *  mgdt_mesh_get_tetrahedron_measures() and may cancel them, as that of mgdt_set_progress() does.
 *  @param fn    the callback; NULL for none (default)
 *  @param user  passed to the callback
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_set_progress(mgdt_mesh* m, mgdt_progress_fn fn, void* user);
/** The progress callback, or NULL, and what is passed to it.
 *  @param[out] user  may be NULL
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_get_progress(const mgdt_mesh* m, mgdt_progress_fn* fn, void** user);

/** Asks the running mgdt_mesh_check() or mgdt_mesh_get_tetrahedron_measures() to stop soon. That
 *  call then returns MGDT_ERR_CANCELLED. If none is running, the request stays pending and stops
 *  the next one. Any thread and any signal handler may call this function.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_cancel(mgdt_mesh* m);

/* ---------------------------------------------------------------------------- results --- */

/** Gives one number of the mesh.
 *  @param key  an MGDT_MESH_STAT_ value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_get_stat(const mgdt_mesh* m, int32_t key, int64_t* value);

/** Gives the shape of an array, which is the same for all meshes.
 *  @param array           an MGDT_MESH_ARRAY_ value
 *  @param[out] columns    how many elements belong together, such as 4 for tetrahedra; may be NULL
 *  @param[out] is_double  1 for mgdt_mesh_get_doubles(), 0 for mgdt_mesh_get_array(); may be NULL
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER (both), MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_array_info(int32_t array, int32_t* columns, int32_t* is_double);
/** Gives the number of elements of an array.
 *  @param array  an MGDT_MESH_ARRAY_ value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_get_size(const mgdt_mesh* m, int32_t array, int64_t* size);

/** Writes an array of integers.
 *  @param array     an MGDT_MESH_ARRAY_ value of integers
 *  @param capacity  at least what mgdt_mesh_get_size() gives
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT,
 *  MGDT_ERR_BUFFER_TOO_SMALL, MGDT_ERR_INDEX_RANGE (32 bits: a number does not fit; the elements of
 *  `values` are undefined then)
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_get_array(const mgdt_mesh* m, int32_t array, int64_t capacity,
                                         int64_t* values);
/** mgdt_mesh_get_array() with 32-bit integers.
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_get_array_i32(const mgdt_mesh* m, int32_t array, int64_t capacity,
                                             int32_t* values);

/** Writes an array of doubles.
 *  @param array     an MGDT_MESH_ARRAY_ value of doubles
 *  @param capacity  at least what mgdt_mesh_get_size() gives
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT,
 *  MGDT_ERR_BUFFER_TOO_SMALL
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_get_doubles(const mgdt_mesh* m, int32_t array, int64_t capacity,
                                           double* values);

/** Measures each tetrahedron, as mgdt_get_tetrahedron_measures() does, with the coordinates that
 *  MGDT_MESH_ARRAY_POINTS has.
 *  @param measure   an MGDT_TETRAHEDRON_ value
 *  @param capacity  elements in x, at least the number of tetrahedra
 *  @param[out] x    a number for each tetrahedron
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT,
 *  MGDT_ERR_BUFFER_TOO_SMALL, MGDT_ERR_CANCELLED
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_get_tetrahedron_measures(const mgdt_mesh* m, int32_t measure,
                                                        int64_t capacity, double* x);

/** Checks the mesh by itself, with exact arithmetic: all tetrahedra are positive, neighbours share
 *  faces, tetrahedra do not overlap, regions end at faces, Steiner points are on their edges, and
 *  the mesh is constrained Delaunay (docs/theory.md, "Meshes of domains"). mgdt_domain_check()
 *  compares it with what was set.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_CHECK_FAILED (the message says what is wrong
 *  and where), MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_check(const mgdt_mesh* m);

/** Copies the message of the last call that failed on the handle, as mgdt_get_error().
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (a capacity below 1)
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_get_error(const mgdt_mesh* m, int64_t capacity, char* buffer);

#ifdef __cplusplus
}
#endif

#endif /* MGDT_MGDT_MESH_H */
