/* SPDX-License-Identifier: MIT
 *
 * The Voronoi diagram of the points of an mgdt_triangulation, or of an mgdt_periodic
 * (mgdt_periodic_create_voronoi()): its vertices, faces and cells.
 *
 * The cell of a point has all places that are nearer to the point than to any other one. A diagram
 * is a snapshot: it does not change with the triangulation that it was made from, and outlives it.
 * The cells are clipped to a convex region that the caller gives by planes, or not clipped; then
 * the cells of the points on the hull are unbounded.
 *
 * A vertex is a point of space where at least four cells meet, or where faces meet the boundary of
 * the region. However many tetrahedra have the same circumcentre, it is one vertex. A face lies
 * between two cells, or between a cell and a plane of the region. Its area is positive, so it has
 * at least three corners. The corners are vertices, or rays: an unbounded face begins and ends with
 * an edge that is a ray from its last or first vertex to infinity. All of this is decided exactly,
 * so a lattice of points has the cells that theory gives it.
 *
 * The diagram depends on the points alone: the order in which they were inserted and the number of
 * threads change no bit of it.
 *
 * The conventions are those of mgdt.h: status and message, capacities in elements, ranges of keys,
 * the thread rule.
 *
 * @since 1.3
 */
#ifndef MGDT_MGDT_VORONOI_H
#define MGDT_MGDT_VORONOI_H

#include "mgdt.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A handle of a Voronoi diagram. The struct is opaque; mgdt_voronoi_create() makes one. */
typedef struct mgdt_voronoi mgdt_voronoi;

/** Keys of mgdt_voronoi_get_stat(). */
enum {
    MGDT_VORONOI_STAT_VERTICES = 100, /**< Vertices. */
    MGDT_VORONOI_STAT_RAYS = 101,     /**< Rays. */
    MGDT_VORONOI_STAT_FACES = 102,    /**< Faces, without those that were dropped. */
    /** Points that were inserted: the arrays of cells have a row for each. */
    MGDT_VORONOI_STAT_POINTS = 103,
    MGDT_VORONOI_STAT_MEMORY_BYTES = 110 /**< Memory that the handle holds. */
};

/** Arrays of a diagram. Keys from 200 have integers, for mgdt_voronoi_get_array(); keys from 300
 *  have doubles, for mgdt_voronoi_get_doubles(). Vertices, rays and faces are numbered from the
 *  index base that the triangulation had. Cells have the indices of the points. An array of offsets
 *  has one element more than there are lists: list k is from element offsets[k] to element
 *  offsets[k + 1] - 1 of the array that has the lists, counted from the index base. */
enum {
    /** Offsets of the faces' lists of corners. */
    MGDT_VORONOI_ARRAY_FACE_OFFSETS = 200,
    /** The corners of each face, counter-clockwise about its normal. A corner that is at least the
     *  index base is a vertex. A negative one is a ray: ray k, counted from 0, is -1 - k. The two
     *  rays of an unbounded face come last: first the ray from the last vertex, then the ray from
     *  the first one. */
    MGDT_VORONOI_ARRAY_FACE_CORNERS = 201,
    /** Two elements for each face: the lesser index of the two points that the face separates, then
     *  the other one. A face in a plane of the region has the index of the point, then -1 - k for
     *  plane k, counted from 0. */
    MGDT_VORONOI_ARRAY_FACE_SIDES = 202,
    /** Three elements for each face of a diagram of mgdt_periodic_create_voronoi(), a shift: how
     *  often each vector of the box has to be added to the second side to get the image that the
     *  face is between. Empty for other diagrams. */
    MGDT_VORONOI_ARRAY_FACE_SHIFTS = 203,
    MGDT_VORONOI_ARRAY_RAY_VERTICES = 210, /**< The vertex where each ray begins. */
    /** Offsets of the cells' lists of faces, for each point that was inserted. A point that is no
     *  vertex of the triangulation has no cell and an empty list. */
    MGDT_VORONOI_ARRAY_CELL_OFFSETS = 220,
    MGDT_VORONOI_ARRAY_CELL_FACES = 221, /**< The faces of each cell, in ascending order. */
    /** For each point 1 if it has a cell and this cell is bounded, otherwise 0. */
    MGDT_VORONOI_ARRAY_CELL_BOUNDED = 222,
    /** For each element of MGDT_VORONOI_ARRAY_CELL_FACES what is on the other side of the face: a
     *  point, or -1 - k for plane k. With MGDT_VORONOI_ARRAY_CELL_OFFSETS,
     *  MGDT_VORONOI_ARRAY_CELL_FACE_AREAS and MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES this is a
     *  list of neighbours with weights; a point may be in the list of a cell of a periodic box
     *  several times, as different images. */
    MGDT_VORONOI_ARRAY_CELL_NEIGHBORS = 223,
    /** Three elements for each of these, a shift: how often each vector of the box has to be added
     *  to the point to get the image that is the neighbour. Empty if there is no box. */
    MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_SHIFTS = 224,
    /** 3 coordinates of each vertex, rounded to the nearest doubles. A coordinate beyond the range
     *  of doubles is infinite. */
    MGDT_VORONOI_ARRAY_VERTICES = 300,
    /** 3 coordinates of the direction of each ray, of length 1, with errors of at most 1e-15. */
    MGDT_VORONOI_ARRAY_RAY_DIRECTIONS = 310,
    /** The area of each face; infinite for an unbounded face, or beyond the range of doubles. The
     *  error is at most 1e-12 times the area, plus 1e-14 times the square of the distance between
     *  the two points that the face separates. */
    MGDT_VORONOI_ARRAY_FACE_AREAS = 320,
    /** 3 coordinates of the unit normal of each face, with errors of at most 1e-15. It points from
     *  the first side to the second one: out of the cell of the first point. */
    MGDT_VORONOI_ARRAY_FACE_NORMALS = 321,
    /** 3 coordinates of the centroid of each face; infinite for an unbounded face. Besides the
     *  rounding of the coordinates, the error is at most 1e-12 times the distance of the farthest
     *  corner from the first side. If the area is at most 1e-14 times the square of the distance
     *  between the two points, the centroid may be a corner instead. */
    MGDT_VORONOI_ARRAY_FACE_CENTROIDS = 322,
    /** The volume of each cell, as mgdt_get_cell_measures() gives it, but perhaps with other
     *  roundings. 0 for a point without a cell. */
    MGDT_VORONOI_ARRAY_CELL_VOLUMES = 330,
    /** 3 coordinates of the centroid of each cell, with the accuracy of mgdt_get_cell_measures();
     *  infinite for an unbounded cell, and 0 for a point without a cell. */
    MGDT_VORONOI_ARRAY_CELL_CENTROIDS = 331,
    /** For each element of MGDT_VORONOI_ARRAY_CELL_FACES the area of the face. */
    MGDT_VORONOI_ARRAY_CELL_FACE_AREAS = 332,
    /** For each element of MGDT_VORONOI_ARRAY_CELL_FACES the distance of the cell's point from the
     *  point on the other side, with an error of at most 1e-15 times the distance; or from the
     *  plane there, with an error of at most 1e-15 times the sum of the distance and the point's
     *  largest coordinate. */
    MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES = 333
};

/** Makes the Voronoi diagram of the points in a triangulation. It uses as many threads as the
 *  triangulation (mgdt_set_threads()), takes its memory from the same functions and has the same
 *  memory limit for itself. It reports progress to the callback of mgdt_set_progress(), and
 *  mgdt_cancel() stops it.
 *  @param t         without planes, its points span space, or it has none
 *  @param n_planes  number of planes; 0 to clip nothing
 *  @param planes    4 numbers a b c d for each plane: the region is where a x + b y + c z <= d. The
 *                   region is bounded and contains all points, as for mgdt_get_cell_measures()
 *  @param[out] out  the handle; NULL if the call fails. The message of a failure is that of the
 *                   triangulation (mgdt_get_error())
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (without planes, points that
 *  do not span space; a plane without a normal, a point outside the region, planes that bound no
 *  region), MGDT_ERR_NOT_FINITE (a plane), MGDT_ERR_TOO_LARGE, MGDT_ERR_CANCELLED,
 *  MGDT_ERR_OUT_OF_MEMORY, MGDT_ERR_BUSY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_voronoi_create(const mgdt_triangulation* t, int64_t n_planes,
                                         const double* planes, mgdt_voronoi** out);

/** Frees the diagram. NULL is allowed. While another call is running on the handle, this function
 *  does nothing, as mgdt_destroy().
 *  @since 1.3 */
MGDT_API void mgdt_voronoi_destroy(mgdt_voronoi* v);

/** Gives one number of the diagram.
 *  @param key  an MGDT_VORONOI_STAT_ value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_voronoi_get_stat(const mgdt_voronoi* v, int32_t key, int64_t* value);

/** Gives the shape of an array, which is the same for all diagrams.
 *  @param array           an MGDT_VORONOI_ARRAY_ value
 *  @param[out] columns    how many elements belong together, such as 2 for the sides of faces; may
 *                         be NULL
 *  @param[out] is_double  1 for mgdt_voronoi_get_doubles(), 0 for mgdt_voronoi_get_array(); may be
 *                         NULL
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER (both), MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_voronoi_array_info(int32_t array, int32_t* columns, int32_t* is_double);
/** Gives the number of elements of an array.
 *  @param array  an MGDT_VORONOI_ARRAY_ value
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_voronoi_get_size(const mgdt_voronoi* v, int32_t array, int64_t* size);

/** Writes an array of integers.
 *  @param array     an MGDT_VORONOI_ARRAY_ value of integers
 *  @param capacity  at least what mgdt_voronoi_get_size() gives
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT,
 *  MGDT_ERR_BUFFER_TOO_SMALL, MGDT_ERR_INDEX_RANGE (32 bits: a number does not fit)
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_voronoi_get_array(const mgdt_voronoi* v, int32_t array, int64_t capacity,
                                            int64_t* values);
/** mgdt_voronoi_get_array() with 32-bit integers.
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_voronoi_get_array_i32(const mgdt_voronoi* v, int32_t array,
                                                int64_t capacity, int32_t* values);

/** Writes an array of doubles.
 *  @param array     an MGDT_VORONOI_ARRAY_ value of doubles
 *  @param capacity  at least what mgdt_voronoi_get_size() gives
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_UNKNOWN_KEY, MGDT_ERR_INVALID_ARGUMENT,
 *  MGDT_ERR_BUFFER_TOO_SMALL
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_voronoi_get_doubles(const mgdt_voronoi* v, int32_t array,
                                              int64_t capacity, double* values);

/** Leaves out the faces whose area is less than `least_area`, or, for each of the cells that they
 *  separate, less than `least_share` times the total area of the cell's bounded faces. A face
 *  belongs to both of its cells, so it leaves both. The faces that stay are numbered again, in
 *  their order; vertices, rays, volumes and centroids stay. Points of a lattice that was rotated,
 *  and so rounded, have tiny faces beside the large ones; without them the cells have the faces of
 *  the lattice.
 *  @param least_area   at least 0
 *  @param least_share  at least 0 and less than 1
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT, MGDT_ERR_OUT_OF_MEMORY (with
 *  nothing changed), MGDT_ERR_BUSY
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_voronoi_drop_small_faces(mgdt_voronoi* v, double least_area,
                                                   double least_share);

/** Copies the message of the last call that failed on the handle, as mgdt_get_error().
 *  @return MGDT_OK, MGDT_ERR_NULL_POINTER, MGDT_ERR_INVALID_ARGUMENT (a capacity below 1)
 *  @since 1.3 */
MGDT_API mgdt_status mgdt_voronoi_get_error(const mgdt_voronoi* v, int64_t capacity, char* buffer);

#ifdef __cplusplus
}
#endif

#endif /* MGDT_MGDT_VORONOI_H */
