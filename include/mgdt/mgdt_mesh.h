/* SPDX-License-Identifier: MIT
 *
 * A mesh of tetrahedra. mgdt_domain_build() makes one of a domain (mgdt_domain.h), and
 * mgdt_mesh_build() of tetrahedra that the caller has. mgdt_mesh_refine() inserts points where
 * sizes want them, and mgdt_mesh_improve() makes the shapes of tetrahedra better; the other
 * functions read the mesh.
 *
 * A mesh of a domain is a snapshot: it does not change with the domain that it was made from, and
 * outlives it. It takes its memory from the functions of that domain, has the same memory limit for
 * itself, and begins with the same index base and number of threads.
 *
 * Every facet of the domain is a union of faces of the mesh, and every segment a union of edges,
 * exactly. Until it is improved, the mesh has few Steiner points. Where that takes no more of them,
 * it is the constrained Delaunay triangulation of its points: no point that is visible from inside
 * of a tetrahedron is in its circumsphere (MGDT_MESH_STAT_IS_DELAUNAY). All tetrahedra have a
 * positive volume with the coordinates that are returned, exactly.
 *
 * The points are those of the caller, with the indices that they had, and Steiner points. The
 * library computes with coordinates that are rounded once, to multiples of 2^-36 of the largest
 * coordinate or finer, rarely coarser (MGDT_MESH_STAT_GRID_BITS), unless the boundary is kept as it
 * is (MGDT_MESH_STAT_KEEPS_BOUNDARY). The caller's coordinates are
 * returned as they were given, bit by bit, if all tetrahedra have a positive volume with them, and
 * otherwise rounded (MGDT_MESH_STAT_IS_ROUNDED); with the rounded ones, Steiner points are on their
 * segments exactly.
 *
 * The mesh is a function of the points, facets and segments: the order of the facets and the number
 * of threads do not change it. A refined or improved mesh is a function of the mesh before, the
 * sizes and the options, to the last bit.
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

/** A handle of a mesh. The struct is opaque; mgdt_domain_build() and mgdt_mesh_create() make one.
 */
typedef struct mgdt_mesh mgdt_mesh;

/** Gives sizes of edges at places: writes n numbers, which are zeros before, for the n places
 *  `xyz`, of three coordinates each. A size is at least 0; 0 and infinity stand for none. It is
 *  called on the thread that called mgdt_mesh_refine(), with at most 65536 places at a time. A
 *  nonzero return value cancels that call. The function must not use the handle, except for
 *  mgdt_mesh_cancel() and mgdt_mesh_get_error().
 *  @since 1.4 */
typedef int32_t (*mgdt_size_fn)(int64_t n, const double* xyz, double* sizes, void* user);

/** Options of mgdt_mesh_set_option(), whose values are integers, and, where that is said, of
 *  mgdt_mesh_set_double_option(), whose values are doubles. */
enum {
    /** 0 or 1, at first that of the domain, or 0. It applies to indices that are passed later. */
    MGDT_MESH_OPTION_INDEX_BASE = 10,
    /** Threads, see mgdt_set_threads(), at first those of the domain, or 1; 0 for all cores. */
    MGDT_MESH_OPTION_THREADS = 20,
    /** Bytes that the handle may hold, at first the limit of the domain; 0 for no limit. */
    MGDT_MESH_OPTION_MEMORY_LIMIT = 30,
    /** The goal g of mgdt_mesh_improve() in degrees, from 0 to 70, at first 25: no dihedral angle
     *  should be below g, and no sine of an obtuse one below sin(g) / 0.7, so that the largest
     *  angle is 142.9 degrees for g = 25. Most meshes reach 25 soon and 30 later; few reach 35.
     *  Since 1.4. */
    MGDT_MESH_OPTION_GOAL = 40,
    /** What mgdt_mesh_improve() and mgdt_mesh_refine() may do to faces and edges that the mesh
     *  lists: an MGDT_BOUNDARY_ value, at first MGDT_BOUNDARY_FIXED. Since 1.4. */
    MGDT_MESH_OPTION_BOUNDARY = 41,
    /** What mgdt_mesh_improve() may do to the points that were set: an MGDT_POINTS_ value, at first
     *  MGDT_POINTS_KEEP for a mesh of a domain, and MGDT_POINTS_MOVE for one of the caller's
     *  tetrahedra. Since 1.4. */
    MGDT_MESH_OPTION_POINTS = 42,
    /** How often mgdt_mesh_improve() moves all points, after the goal, to improve the mean of the
     *  shapes: from 0 to 1000, at first 0. Three passes do most of what can be done. Since 1.4. */
    MGDT_MESH_OPTION_MEAN_PASSES = 43,
    /** The most passes of mgdt_mesh_improve() over the tetrahedra below the goal, from 0 to 10000,
     *  at first 100. Few of them suffice for most meshes. Exchanges of edges and faces, which come
     *  first, and one pass of moves are not counted. Since 1.4. */
    MGDT_MESH_OPTION_MOST_PASSES = 44,
    /** The most points that one mgdt_mesh_refine() inserts; 0 (at first) for no limit. Since 1.4.
     */
    MGDT_MESH_OPTION_MOST_POINTS = 45,
    /** 1 if mgdt_mesh_refine() is to take the mean length of the edges of faces at a point, of
     *  those that the mesh lists, for a size that is wanted there; 0 at first. Since 1.4. */
    MGDT_MESH_OPTION_SIZES_OF_SURFACE = 46,
    /** A double: the length that edges should have everywhere; 0 (at first) for none. Since 1.4. */
    MGDT_MESH_OPTION_SIZE = 61,
    /** A double: how fast sizes may grow with the distance, at first 0.3, and less than 1e6: a size
     *  at one point is at most that at another plus this times their distance. Since 1.4. */
    MGDT_MESH_OPTION_GRADATION = 62,
    /** A double: the most that the radius of a circumsphere should be, in shortest edges of its
     *  tetrahedron, at first 1.4; 0 for no bound. Since 1.4. */
    MGDT_MESH_OPTION_RADIUS_EDGE = 63,
    /** A double: the most volume that a tetrahedron should have; 0 (at first) for no bound. Since
     *  1.4. */
    MGDT_MESH_OPTION_VOLUME = 64
};

/** What mgdt_mesh_set_sizes() sets sizes of.
 *  @since 1.4 */
enum {
    MGDT_SIZES_OF_POINTS = 0,     /**< At each point of the mesh. */
    MGDT_SIZES_OF_TETRAHEDRA = 1, /**< In each tetrahedron. */
    MGDT_SIZES_OF_REGIONS = 2     /**< In each region. */
};

/** Values of MGDT_MESH_OPTION_BOUNDARY.
 *  @since 1.4 */
enum {
    /** Faces and edges that the mesh lists stay as they are. */
    MGDT_BOUNDARY_FIXED = 0,
    /** The surface stays, but its points move: within the facet that they are inside of, or along a
     *  straight line of edges, but for rounding; and other faces may divide the facet. If a facet
     *  whose faces are not quite in one plane would run into another part of the surface so, the
     *  improvement is as with MGDT_BOUNDARY_FIXED. A refinement inserts points inside of facets and
     *  in the middle of edges, without moving any. These are exact if the coordinates
     *  of the facet's corners are whole numbers of a power of two that is at least 2^-36 of the
     *  largest coordinate; others are rounded. */
    MGDT_BOUNDARY_SLIDE = 1
};

/** Values of MGDT_MESH_OPTION_POINTS. Points of mgdt_mesh_set_fixed_points() stay where they are in
 *  any case.
 *  @since 1.4 */
enum {
    MGDT_POINTS_KEEP = 0,  /**< They stay where they are. */
    MGDT_POINTS_MOVE = 1,  /**< They may move. Points that are equal stay equal. */
    MGDT_POINTS_REMOVE = 2 /**< They may move, and may become points of no tetrahedron. */
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
    /** 1 if the mesh is the constrained Delaunay triangulation of its points. mgdt_domain_build()
     *  makes that mesh unless another mesh needs fewer Steiner points. Since 1.4. */
    MGDT_MESH_STAT_IS_DELAUNAY = 122,
    /** 1 if the mesh is as mgdt_domain_build() has made it, so that mgdt_domain_check() can compare
     *  it with the domain. Since 1.4. */
    MGDT_MESH_STAT_IS_OF_DOMAIN = 123,
    /** 1 if the domain's boundary is kept in such a mesh: each triangle of a facet is one face, and
     *  no Steiner point is on a facet or on a segment (MGDT_DOMAIN_OPTION_KEEP_BOUNDARY). Since
     *  1.4. */
    MGDT_MESH_STAT_KEEPS_BOUNDARY = 124,
    /** Coordinates are rounded to multiples of 2^-bits of the largest one: 36, or 44 or 40 for a
     *  surface with finer details, or 24 to 32 for one whose edges have to be divided very finely.
     *  0 if points are not rounded, because the boundary is kept. */
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
    MGDT_MESH_STAT_CAVITIES = 142,       /**< Parts of that triangulation that were filled anew. */
    MGDT_MESH_STAT_LARGEST_CAVITY = 143, /**< The most tetrahedra in one of them. */
    /** Tetrahedra that the last mgdt_mesh_improve() has left below the goal. This number and the
     *  next three are 0 before. Since 1.4. */
    MGDT_MESH_STAT_BELOW_GOAL = 150,
    MGDT_MESH_STAT_PASSES = 151,       /**< Passes over tetrahedra below the goal. Since 1.4. */
    MGDT_MESH_STAT_MOVED_POINTS = 152, /**< Points that were set and have moved. Since 1.4. */
    /** Points that were set and have lost all of their tetrahedra. Since 1.4. */
    MGDT_MESH_STAT_REMOVED_POINTS = 153,
    /** Points that the last mgdt_mesh_refine() has inserted. Since 1.4. */
    MGDT_MESH_STAT_INSERTED_POINTS = 160,
    /** Tetrahedra that it has left beyond the sizes and bounds (MGDT_MESH_ARRAY_REFUSALS). Both are
     *  0 after mgdt_mesh_build() and mgdt_mesh_improve(). Since 1.4. */
    MGDT_MESH_STAT_REFUSED = 161
};

/** Elements of MGDT_MESH_ARRAY_REFUSALS: why mgdt_mesh_refine() has not divided a tetrahedron.
 *  @since 1.4 */
enum {
    MGDT_REFUSAL_NONE = 0, /**< It is within the sizes and bounds. */
    /** A face of a facet is between it and the point that would divide it. */
    MGDT_REFUSAL_HIDDEN = 1,
    MGDT_REFUSAL_NEAR_POINT = 2, /**< That point is too near to another one. */
    /** That point is near a facet, and would leave as many tetrahedra beyond the bounds. */
    MGDT_REFUSAL_NEAR_FACET = 3,
    /** Around that point is no place for tetrahedra with a positive volume. */
    MGDT_REFUSAL_NO_CAVITY = 4,
    MGDT_REFUSAL_MOST_POINTS = 5 /**< MGDT_MESH_OPTION_MOST_POINTS were inserted. */
};

/** Elements of MGDT_MESH_ARRAY_REASONS: why a tetrahedron is below the goal. Where several apply,
 *  it is the first one.
 *  @since 1.4 */
enum {
    MGDT_REASON_NONE = 0, /**< It reaches the goal. */
    /** Two of its faces are parts of facets with a smaller angle between them. */
    MGDT_REASON_INPUT_ANGLE = 1,
    /** It is at a corner of a face of a facet that has a smaller angle itself. */
    MGDT_REASON_THIN_FACE = 2,
    MGDT_REASON_FIXED_CORNERS = 3, /**< None of its corners may move. */
    MGDT_REASON_OTHER = 4
};

/** Arrays of a mesh, of integers for mgdt_mesh_get_array() and of doubles for
 *  mgdt_mesh_get_doubles(). Points, facets, segments, tetrahedra and regions are numbered from the
 *  index base. Where there is none, the number is the index base - 1. */
enum {
    /** For each point the point that was set and that it is, of equal ones of a domain the first;
     *  none for a Steiner point. */
    MGDT_MESH_ARRAY_POINT_ORIGINS = 200,
    /** Four corners for each tetrahedron, positively oriented as in mgdt_get_tetrahedra(). The
     *  tetrahedra of mgdt_domain_build() and mgdt_mesh_improve() are sorted by their corners; those
     *  of mgdt_mesh_build() have the caller's order. */
    MGDT_MESH_ARRAY_TETRAHEDRA = 210,
    /** For each tetrahedron the numbers of the four tetrahedra opposite its corners. None means
     *  that the domain ends there. */
    MGDT_MESH_ARRAY_NEIGHBORS = 211,
    MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS = 212, /**< The region of each tetrahedron. */
    /** The marker of each region: that of the last place of mgdt_domain_set_regions() inside of
     *  it, or 0; or that of the caller's tetrahedra, of which those with one marker are a region.
     */
    MGDT_MESH_ARRAY_REGION_MARKERS = 220,
    /** Three corners for each face of the mesh that is a part of a facet. They turn in the same
     *  direction as those of the facet. mgdt_mesh_build() lists the caller's faces first. */
    MGDT_MESH_ARRAY_FACES = 230,
    /** The two tetrahedra at each face: first the one from which the corners appear
     *  counter-clockwise, then the other one. */
    MGDT_MESH_ARRAY_FACE_TETRAHEDRA = 231,
    /** The facet that each face is a part of; of facets that are joined, the first one. Of a mesh
     *  of the caller's tetrahedra facets are what its faces form in one plane; they are numbered in
     *  the order of their first faces. */
    MGDT_MESH_ARRAY_FACE_FACETS = 232,
    MGDT_MESH_ARRAY_FACE_MARKERS = 233, /**< The marker of this facet. */
    /** Two ends for each edge of the mesh that is a part of a segment, or of an edge of facets that
     *  does not lie inside of a joined facet. mgdt_mesh_build() lists the caller's edges first. */
    MGDT_MESH_ARRAY_EDGES = 240,
    /** The segment, or the edge of mgdt_mesh_set_edges(), that each of these edges is a part of, or
     *  none. */
    MGDT_MESH_ARRAY_EDGE_SEGMENTS = 241,
    MGDT_MESH_ARRAY_EDGE_MARKERS = 242, /**< The marker of this segment, or 0. */
    /** For each Steiner point the two points a and b that it is between, or none and none for one
     *  that is inside of the domain. */
    MGDT_MESH_ARRAY_STEINER_EDGES = 250,
    /** For each tetrahedron an MGDT_REASON_ value: why mgdt_mesh_improve() has left it below the
     *  goal. Empty before. Since 1.4. */
    MGDT_MESH_ARRAY_REASONS = 260,
    /** 18 rows of two numbers, before and after mgdt_mesh_improve(): how many dihedral angles are
     *  at least 10 i and below 10 (i + 1) degrees, for i from 0 to 17; each tetrahedron has six.
     *  Empty before. Since 1.4. */
    MGDT_MESH_ARRAY_ANGLE_HISTOGRAM = 261,
    /** Six rows of two numbers, before and after mgdt_mesh_improve(): how many tetrahedra have a
     *  dihedral angle below 5, 10, 15, 20, 25 and 30 degrees. Empty before. Since 1.4. */
    MGDT_MESH_ARRAY_TETRAHEDRA_BELOW = 262,
    /** For each tetrahedron an MGDT_REFUSAL_ value: why mgdt_mesh_refine() has left it beyond the
     *  sizes and bounds. Empty before, and after mgdt_mesh_build() and mgdt_mesh_improve(). Since
     *  1.4. */
    MGDT_MESH_ARRAY_REFUSALS = 270,
    /** Three coordinates of each point: first the points that were set, then the Steiner points. */
    MGDT_MESH_ARRAY_POINTS = 300,
    /** For each Steiner point the number t for which it is a + t (b - a); 0 if it is between no two
     *  points. */
    MGDT_MESH_ARRAY_STEINER_PARAMETERS = 310,
    /** Three rows of two numbers, before and after mgdt_mesh_improve(): the least and the largest
     *  dihedral angle, in degrees, and the mean of MGDT_TETRAHEDRON_VOLUME_LENGTH. Empty before.
     *  Since 1.4. */
    MGDT_MESH_ARRAY_SHAPES = 320,
    /** For each point the length of edges that the last mgdt_mesh_refine() was asked for there, or
     *  0 if it was asked for none. Empty when MGDT_MESH_ARRAY_REFUSALS is. Since 1.4. */
    MGDT_MESH_ARRAY_SIZES = 330
};

/* ------------------------------------------------------------------------------- life --- */

/** Makes a mesh without tetrahedra, for mgdt_mesh_set_points() and so on.
 *  @param[out] out  the handle; NULL if the call fails
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_create(mgdt_mesh** out);

/** Makes a mesh without tetrahedra, which takes all its memory from `alloc`.
 *  @param alloc, release, user  as for mgdt_create_with_allocator()
 *  @return as mgdt_mesh_create(), and MGDT_ERR_INVALID_ARGUMENT (one function without the other)
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release,
                                                     void* user, mgdt_mesh** out);

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

/** Sets an option whose value is a double.
 *  @param option  an MGDT_MESH_OPTION_ value that documents a double
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_double_option(mgdt_mesh* m, int32_t option, double value);
/** The value of an option that is a double.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_get_double_option(const mgdt_mesh* m, int32_t option, double* value);

/** Sets the callback that receives the progress of mgdt_mesh_build(), mgdt_mesh_refine(),
 *  mgdt_mesh_improve(), mgdt_mesh_check() and the calls that measure, summarize, locate and
 *  interpolate, and may cancel them, as that of mgdt_set_progress() does.
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

/** Asks the running call of those that mgdt_mesh_set_progress() names to stop soon. That call then
 *  returns MGDT_ERR_CANCELLED. If none is running, the request stays pending and stops the next
 *  one. Any thread and any signal handler may call this function.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_mesh_cancel(mgdt_mesh* m);

/* ------------------------------------------------------------------------------ input --- */

/** Sets the points of a mesh that mgdt_mesh_build() is to make; they are copied. Tetrahedra, faces,
 *  edges and fixed points that were set before are removed. The mesh that there is stays until
 *  mgdt_mesh_build(). A call that fails changes nothing.
 *  @param n    number of points, at least 0
 *  @param xyz  3 n coordinates; may be NULL if n is 0
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n), MGDT_ERR_NOT_FINITE (the
 *  message names the point), MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_points(mgdt_mesh* m, int64_t n, const double* xyz);

/** Sets the tetrahedra, which are copied, in place of those that were set before. A call that fails
 *  changes nothing.
 *  @param n        number of tetrahedra, at least 0
 *  @param corners  4 n points. The corners of a tetrahedron may have any order
 *  @param markers  n markers, or NULL: then all are 0. Tetrahedra with one marker form a region
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n, or a corner that is no
 *  point; the message names it), MGDT_ERR_TOO_LARGE, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_tetrahedra(mgdt_mesh* m, int64_t n, const int64_t* corners,
                                              const int32_t* markers);
/** mgdt_mesh_set_tetrahedra() with 32-bit integers.
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_tetrahedra_i32(mgdt_mesh* m, int64_t n, const int32_t* corners,
                                                  const int32_t* markers);

/** Sets the faces that the mesh is to keep, which are copied, in place of those that were set
 *  before: triangles of its surface that have markers, and triangles inside of it. The other faces
 *  of the surface, and those between regions, are kept without being set. A call that fails changes
 *  nothing.
 *  @param n        number of faces, at least 0
 *  @param corners  3 n points
 *  @param markers  n markers, or NULL: then all are 0
 *  @return as mgdt_mesh_set_tetrahedra()
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_faces(mgdt_mesh* m, int64_t n, const int64_t* corners,
                                         const int32_t* markers);
/** mgdt_mesh_set_faces() with 32-bit integers.
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_faces_i32(mgdt_mesh* m, int64_t n, const int32_t* corners,
                                             const int32_t* markers);

/** Sets the edges that the mesh is to keep, which are copied, in place of those that were set
 *  before. The edges at which planar facets end are kept without being set. A call that fails
 *  changes nothing.
 *  @param n        number of edges, at least 0
 *  @param ends     2 n points
 *  @param markers  n markers, or NULL: then all are 0
 *  @return as mgdt_mesh_set_tetrahedra()
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_edges(mgdt_mesh* m, int64_t n, const int64_t* ends,
                                         const int32_t* markers);
/** mgdt_mesh_set_edges() with 32-bit integers.
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_edges_i32(mgdt_mesh* m, int64_t n, const int32_t* ends,
                                             const int32_t* markers);

/** Sets which of the points that were set mgdt_mesh_improve() leaves where they are, in place of
 *  those that it was told before. A mesh of a domain takes them too. A call that fails changes
 *  nothing.
 *  @param n       number of points that are fixed, at least 0
 *  @param points  n points, in any order
 *  @return as mgdt_mesh_set_tetrahedra()
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_fixed_points(mgdt_mesh* m, int64_t n, const int64_t* points);
/** mgdt_mesh_set_fixed_points() with 32-bit integers.
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_fixed_points_i32(mgdt_mesh* m, int64_t n, const int32_t* points);

/** Sets sizes of edges for the next mgdt_mesh_refine(), in place of those that were set of the
 *  same. They are copied. Those of points and tetrahedra are removed when the mesh changes, since
 *  these have other numbers then; those of regions stay until mgdt_mesh_build(). A call that
 *  fails changes nothing.
 *  @param of     an MGDT_SIZES_ value
 *  @param n      the number of points, tetrahedra or regions of the mesh; or 0 to remove sizes
 *  @param sizes  n sizes, at least 0; 0 and infinity stand for none
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY (of), MGDT_ERR_INVALID_ARGUMENT
 *  (n, or a size that is negative or no number; the message names it), MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_sizes(mgdt_mesh* m, int32_t of, int64_t n, const double* sizes);

/** Sets sizes of edges that vary in space, in place of those that were set by this function: at
 *  points of the caller's, which need not be in the mesh. They are copied. Between the points, a
 *  size is linear in each tetrahedron of their Delaunay triangulation. A place outside of their
 *  convex hull has the size of the nearest place of the hull. If all points are in one plane, each
 *  place has the size of the nearest point. Of equal points the first one counts. The sizes stay
 *  for every mgdt_mesh_refine() until others are set. A call that fails changes nothing.
 *  @param n      number of points, at least 0; 0 removes the sizes
 *  @param xyz    3 n coordinates; may be NULL if n is 0
 *  @param sizes  n sizes, above 0 and finite; may be NULL if n is 0
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n or a size; the message
 *  names it), MGDT_ERR_NOT_FINITE (the message names the point), MGDT_ERR_TOO_LARGE,
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_size_field(mgdt_mesh* m, int64_t n, const double* xyz,
                                              const double* sizes);

/** Sets the function that gives sizes of edges that vary in space. mgdt_mesh_refine() asks it for
 *  the points of the mesh and for places in and near the mesh that are the closer to each other
 *  the smaller the sizes are, but not for each new point: a size that grows faster than the
 *  distance may be missed (docs/theory.md, "Sizes that vary in space").
 *  @param fn    the function; NULL for none (default)
 *  @param user  passed to the function
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_set_size_function(mgdt_mesh* m, mgdt_size_fn fn, void* user);
/** The function that gives sizes, or NULL, and what is passed to it.
 *  @param[out] user  may be NULL
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_get_size_function(const mgdt_mesh* m, mgdt_size_fn* fn, void** user);

/* ------------------------------------------------------------------------------ build --- */

/** Makes the mesh of what was set, in place of the one that there is, and gives the memory of what
 *  was set back. Tetrahedra keep their numbers; the last two corners of one that is negatively
 *  oriented are exchanged. Points keep their numbers too, whether a tetrahedron uses them or not.
 *  Faces that continue each other in one plane, but for 2^-20, with one marker and the same regions
 *  on their sides form a facet.
 *
 *  Nothing is repaired: what is no mesh is refused. That tetrahedra overlap without having a common
 *  face is not noticed; mgdt_mesh_check() notices it. A call that fails changes neither the mesh
 *  nor what was set.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (no tetrahedra were set; a
 *  tetrahedron is flat, exactly, or has a corner twice; two have the same corners; tetrahedra at a
 *  face are more than two, or on one side of it; a face or an edge is none of a tetrahedron, or was
 *  set twice; the message has the numbers), MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_build(mgdt_mesh* m);

/** Inserts points until the tetrahedra have the wanted sizes and shapes: until no circumsphere
 *  has a radius above 0.8 times the size of edges, which is the mean of those at the corners, or
 *  above MGDT_MESH_OPTION_RADIUS_EDGE times the shortest edge, and no volume is above
 *  MGDT_MESH_OPTION_VOLUME. The size at a point is the least one that is set for it, by
 *  MGDT_MESH_OPTION_SIZE, MGDT_MESH_OPTION_SIZES_OF_SURFACE, mgdt_mesh_set_sizes(),
 *  mgdt_mesh_set_size_field() and mgdt_mesh_set_size_function(); MGDT_MESH_OPTION_GRADATION limits
 *  how fast sizes grow. A tetrahedron sets the size of its corners. Sizes at points of the mesh are
 *  interpolated for new points.
 *
 *  Facets, segments, regions and markers stay. With MGDT_BOUNDARY_FIXED the faces and edges that
 *  the mesh lists stay, too, and new points are inside of the domain. With MGDT_BOUNDARY_SLIDE,
 *  faces and edges are divided where they are too large for the sizes, or in the way of a better
 *  shape. New points are Steiner points, which come after the others. All tetrahedra have a
 *  positive volume, exactly. Where edges of facets are longer or shorter than the sizes want, and
 *  stay, or angles between facets are small, tetrahedra stay beyond the bounds:
 *  MGDT_MESH_STAT_REFUSED counts them, and MGDT_MESH_ARRAY_REFUSALS says why. The call always
 *  ends: new points keep a distance from others, and near facets each one inside lessens the
 *  number of tetrahedra beyond the bounds (docs/theory.md, "Refining meshes"). The next step is
 *  mgdt_mesh_improve(), which removes flat tetrahedra; it moves and removes points of the
 *  refinement.
 *  docs/refinement.md has examples.
 *
 *  The result does not depend on the number of threads. A call that fails or is cancelled leaves
 *  the mesh as it was.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (the size function gives a
 *  size that is negative or no number; the message names the place), MGDT_ERR_TOO_LARGE (such as
 *  for sizes that would take more than 2^27 points), MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_refine(mgdt_mesh* m);

/** Improves the shapes of the tetrahedra until all reach the goal, or nothing helps any more:
 *  exchanges edges and faces, moves points, contracts edges and inserts points, as the options
 *  allow. The worst tetrahedron never becomes worse. Regions, facets, segments and markers stay.
 *  All tetrahedra have a positive volume, exactly. Points that were set keep their numbers; new
 *  ones are Steiner points, which come after them. docs/improvement.md has examples;
 *  docs/theory.md, "Improving meshes", says how it works.
 *
 *  A mesh that reaches the goal stays as it is, to the last bit; with the goal 0, points are moved
 *  for the mean of the shapes alone. A goal that cannot be reached is no failure:
 *  MGDT_MESH_STAT_BELOW_GOAL counts what is left, and MGDT_MESH_ARRAY_REASONS says why. The result
 *  does not depend on the number of threads.
 *
 *  A call that is cancelled leaves the valid mesh of the last complete round. If memory runs out,
 *  the mesh stays as it was.
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_CANCELLED, MGDT_ERR_TOO_LARGE,
 *  MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_improve(mgdt_mesh* m);

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

/** Describes the shapes of all tetrahedra in a few numbers. Each array may be NULL. An angle
 *  that is a multiple of 5 degrees but for rounding counts as that multiple.
 *  @param[out] shapes            3 numbers: the least and the largest dihedral angle, in degrees,
 *                                and the mean of MGDT_TETRAHEDRON_VOLUME_LENGTH; 0 without any
 *  @param[out] angles            18 counts of dihedral angles: from 0 to 10 degrees, 10 to 20 and
 *                                so on; each tetrahedron has six
 *  @param[out] tetrahedra_below  6 counts of tetrahedra with a dihedral angle below 5, 10, 15, 20,
 *                                25 and 30 degrees
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER (the handle), MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_get_shape_summary(const mgdt_mesh* m, double* shapes,
                                                 int64_t* angles, int64_t* tetrahedra_below);

/** Finds the tetrahedra that contain points, exactly, with the coordinates of
 *  MGDT_MESH_ARRAY_POINTS, also where the mesh is not convex. The first call makes a tree of the
 *  tetrahedra in O(n log n), which the mesh keeps until it changes. Many points in one call
 *  are much faster than one at a time.
 *  @param outside  MGDT_OUTSIDE_NONE, or MGDT_OUTSIDE_BOUNDARY to take for a point outside of the
 *                  mesh the nearest place of its boundary, but for rounding
 *  @param n        number of points, at least 0
 *  @param xyz      3 n coordinates
 *  @param[out] tetrahedra  n numbers of tetrahedra; of several ones whose common boundary has the
 *                          point, the first one; none for a point outside
 *  @param[out] weights     NULL, or 4 n barycentric coordinates as those of mgdt_locate_points(),
 *                          in the order of the corners in MGDT_MESH_ARRAY_TETRAHEDRA. With
 *                          MGDT_OUTSIDE_BOUNDARY they are those of the nearest place, which is the
 *                          weighted sum of the corners
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (n), MGDT_ERR_UNKNOWN_KEY
 *  (outside), MGDT_ERR_NOT_FINITE (the message names the point; nothing is written),
 *  MGDT_ERR_CANCELLED, MGDT_ERR_OUT_OF_MEMORY
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_locate_points(const mgdt_mesh* m, int32_t outside, int64_t n,
                                             const double* xyz, int64_t* tetrahedra,
                                             double* weights);
/** mgdt_mesh_locate_points() with 32-bit integers.
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_locate_points_i32(const mgdt_mesh* m, int32_t outside, int64_t n,
                                                 const double* xyz, int32_t* tetrahedra,
                                                 double* weights);

/** Interpolates values that are given at the points of the mesh: linearly in each tetrahedron, as
 *  finite elements of the first order do. Places are found as mgdt_mesh_locate_points() does.
 *  @param outside   MGDT_OUTSIDE_NONE: NaN for a place outside of the mesh; MGDT_OUTSIDE_BOUNDARY:
 *                   the value at the nearest place of its boundary
 *  @param n_fields  how many numbers a point has, and a place gets; at least 0
 *  @param values    n_fields numbers for each of the MGDT_MESH_STAT_POINTS points; those of one
 *                   point are consecutive
 *  @param n         number of places, at least 0
 *  @param xyz       3 n coordinates of the places
 *  @param[out] out  n_fields numbers for each place
 *  @return as mgdt_mesh_locate_points(), and MGDT_ERR_TOO_LARGE
 *  @since 1.4 */
MGDT_API mgdt_status mgdt_mesh_interpolate(const mgdt_mesh* m, int32_t outside, int64_t n_fields,
                                           const double* values, int64_t n, const double* xyz,
                                           double* out);

/** Checks the mesh by itself, with exact arithmetic: all tetrahedra are positive, neighbours share
 *  faces, tetrahedra do not overlap, and regions end at faces; if MGDT_MESH_STAT_IS_OF_DOMAIN is 1,
 *  that Steiner points are on their edges; and if MGDT_MESH_STAT_IS_DELAUNAY is 1, that the mesh is
 *  constrained Delaunay (docs/theory.md, "Meshes of domains"). mgdt_domain_check() compares it with
 *  what was set.
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
