/* SPDX-License-Identifier: MIT
 * The constants of the C headers as enum classes, and their names. Part of mgdt/mgdt.hpp, which
 * includes it. */
#ifndef MGDT_CXX_CONSTANTS_HPP
#define MGDT_CXX_CONSTANTS_HPP

#include <cstdint>

#include "../mgdt.h"
#include "../mgdt_domain.h"
#include "../mgdt_mesh.h"
#include "../mgdt_parts.h"
#include "../mgdt_periodic.h"
#include "../mgdt_voronoi.h"

namespace mgdt {
inline namespace cxx1 {

/** Order schemes; see MGDT_ORDER_AUTO and its neighbours. */
enum class Order : std::int32_t {
    automatic = MGDT_ORDER_AUTO,
    input = MGDT_ORDER_INPUT,
    random = MGDT_ORDER_RANDOM,
    lexicographic = MGDT_ORDER_LEXICOGRAPHIC,
    brio = MGDT_ORDER_BRIO,
    hilbert = MGDT_ORDER_HILBERT,
    regular_grid = MGDT_ORDER_REGULAR_GRID,
    kd_tree = MGDT_ORDER_KD_TREE,
    enhanced_kd_tree = MGDT_ORDER_ENHANCED_KD_TREE,
    multi_grid = MGDT_ORDER_MULTI_GRID
};

/** Parameters of the order schemes; see MGDT_PARAMETER_POINTS_PER_CELL and its neighbours. */
enum class Parameter : std::int32_t {
    points_per_cell = MGDT_PARAMETER_POINTS_PER_CELL,
    threshold = MGDT_PARAMETER_THRESHOLD,
    separation = MGDT_PARAMETER_SEPARATION,
    round_ratio = MGDT_PARAMETER_ROUND_RATIO
};

/** Values of Parameter::separation; see MGDT_SEPARATION_NONE and its neighbours. @since 1.2 */
enum class Separation : std::int32_t {
    none = MGDT_SEPARATION_NONE,
    passes = MGDT_SEPARATION_PASSES,
    rounds = MGDT_SEPARATION_ROUNDS
};

/** Statistics; see MGDT_STAT_POINTS_INSERTED and its neighbours. */
enum class Statistic : std::int32_t {
    points_inserted = MGDT_STAT_POINTS_INSERTED,
    duplicates = MGDT_STAT_DUPLICATES,
    points_removed = MGDT_STAT_POINTS_REMOVED,
    points_moved = MGDT_STAT_POINTS_MOVED,
    put_back = MGDT_STAT_PUT_BACK,
    rebuilds = MGDT_STAT_REBUILDS,
    walk_steps = MGDT_STAT_WALK_STEPS,
    walk_tests = MGDT_STAT_WALK_TESTS,
    conflict_tests = MGDT_STAT_CONFLICT_TESTS,
    tetrahedra_removed = MGDT_STAT_TETRAHEDRA_REMOVED,
    tetrahedra_created = MGDT_STAT_TETRAHEDRA_CREATED,
    link_vertices = MGDT_STAT_LINK_VERTICES,
    exact_calls = MGDT_STAT_EXACT_CALLS,
    put_off = MGDT_STAT_PUT_OFF,
    inserted_alone = MGDT_STAT_INSERTED_ALONE,
    order_seconds = MGDT_STAT_ORDER_SECONDS,
    insert_seconds = MGDT_STAT_INSERT_SECONDS,
    remove_seconds = MGDT_STAT_REMOVE_SECONDS,
    move_seconds = MGDT_STAT_MOVE_SECONDS,
    grid_levels = MGDT_STAT_GRID_LEVELS,
    rounds = MGDT_STAT_ROUNDS,
    threads = MGDT_STAT_THREADS,
    memory_bytes = MGDT_STAT_MEMORY_BYTES,
    peak_memory_bytes = MGDT_STAT_PEAK_MEMORY_BYTES
};

/** Levels of check(); see MGDT_CHECK_COMBINATORIAL and its neighbours. */
enum class Check : std::int32_t {
    combinatorial = MGDT_CHECK_COMBINATORIAL,
    geometric = MGDT_CHECK_GEOMETRIC,
    canonical = MGDT_CHECK_CANONICAL
};

/** What is measured of a cell; see MGDT_MEASURE_VOLUME and its neighbours. @since 1.2 */
enum class Measure : std::int32_t {
    volume = MGDT_MEASURE_VOLUME,
    area = MGDT_MEASURE_AREA,
    centroid = MGDT_MEASURE_CENTROID,
    faces = MGDT_MEASURE_FACES
};

/** What is measured of a tetrahedron; see MGDT_TETRAHEDRON_VOLUME and its neighbours. @since 1.3 */
enum class TetrahedronMeasure : std::int32_t {
    volume = MGDT_TETRAHEDRON_VOLUME,
    radius_ratio = MGDT_TETRAHEDRON_RADIUS_RATIO,
    least_dihedral_angle = MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE,
    largest_dihedral_angle = MGDT_TETRAHEDRON_LARGEST_DIHEDRAL_ANGLE,
    longest_edge = MGDT_TETRAHEDRON_LONGEST_EDGE,
    volume_length = MGDT_TETRAHEDRON_VOLUME_LENGTH, /**< @since 1.4 */
    edge_ratio = MGDT_TETRAHEDRON_EDGE_RATIO        /**< @since 1.4 */
};

/** How a value between points is made; see MGDT_INTERPOLATE_LINEAR and its neighbours. @since 1.2
 */
enum class Method : std::int32_t {
    linear = MGDT_INTERPOLATE_LINEAR,
    nearest = MGDT_INTERPOLATE_NEAREST,
    sibson = MGDT_INTERPOLATE_SIBSON,
    laplace = MGDT_INTERPOLATE_LAPLACE,
    sibson_c1 = MGDT_INTERPOLATE_SIBSON_C1
};

/** What a value outside the hull is; see MGDT_OUTSIDE_NONE and its neighbours. @since 1.2 */
enum class Outside : std::int32_t {
    none = MGDT_OUTSIDE_NONE,
    nearest = MGDT_OUTSIDE_NEAREST,
    boundary = MGDT_OUTSIDE_BOUNDARY,
    linear = MGDT_OUTSIDE_LINEAR
};

/** Statistics of a Voronoi diagram; see MGDT_VORONOI_STAT_VERTICES and its neighbours. @since 1.3
 */
enum class VoronoiStatistic : std::int32_t {
    vertices = MGDT_VORONOI_STAT_VERTICES,
    rays = MGDT_VORONOI_STAT_RAYS,
    faces = MGDT_VORONOI_STAT_FACES,
    points = MGDT_VORONOI_STAT_POINTS,
    memory_bytes = MGDT_VORONOI_STAT_MEMORY_BYTES
};

/** Arrays of integers of a Voronoi diagram; see MGDT_VORONOI_ARRAY_FACE_OFFSETS and its neighbours.
 *  @since 1.3 */
enum class VoronoiArray : std::int32_t {
    face_offsets = MGDT_VORONOI_ARRAY_FACE_OFFSETS,
    face_corners = MGDT_VORONOI_ARRAY_FACE_CORNERS,
    face_sides = MGDT_VORONOI_ARRAY_FACE_SIDES,
    face_shifts = MGDT_VORONOI_ARRAY_FACE_SHIFTS,
    ray_vertices = MGDT_VORONOI_ARRAY_RAY_VERTICES,
    cell_offsets = MGDT_VORONOI_ARRAY_CELL_OFFSETS,
    cell_faces = MGDT_VORONOI_ARRAY_CELL_FACES,
    cell_bounded = MGDT_VORONOI_ARRAY_CELL_BOUNDED,
    cell_neighbors = MGDT_VORONOI_ARRAY_CELL_NEIGHBORS,
    cell_neighbor_shifts = MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_SHIFTS
};

/** Arrays of doubles of a Voronoi diagram; see MGDT_VORONOI_ARRAY_VERTICES and its neighbours.
 *  @since 1.3 */
enum class VoronoiDoubles : std::int32_t {
    vertices = MGDT_VORONOI_ARRAY_VERTICES,
    ray_directions = MGDT_VORONOI_ARRAY_RAY_DIRECTIONS,
    face_areas = MGDT_VORONOI_ARRAY_FACE_AREAS,
    face_normals = MGDT_VORONOI_ARRAY_FACE_NORMALS,
    face_centroids = MGDT_VORONOI_ARRAY_FACE_CENTROIDS,
    cell_volumes = MGDT_VORONOI_ARRAY_CELL_VOLUMES,
    cell_centroids = MGDT_VORONOI_ARRAY_CELL_CENTROIDS,
    cell_face_areas = MGDT_VORONOI_ARRAY_CELL_FACE_AREAS,
    cell_neighbor_distances = MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES
};

/** What an element of the offending pairs of a domain is; see MGDT_DOMAIN_KIND_FACET.
 *  @since 1.3 */
enum class DomainKind : std::int32_t {
    facet = MGDT_DOMAIN_KIND_FACET,
    segment = MGDT_DOMAIN_KIND_SEGMENT,
    point = MGDT_DOMAIN_KIND_POINT
};

/** Options of a domain; see MGDT_DOMAIN_OPTION_INDEX_BASE and its neighbours. @since 1.3 */
enum class DomainOption : std::int32_t {
    index_base = MGDT_DOMAIN_OPTION_INDEX_BASE,
    threads = MGDT_DOMAIN_OPTION_THREADS,
    memory_limit = MGDT_DOMAIN_OPTION_MEMORY_LIMIT,
    round_points = MGDT_DOMAIN_OPTION_ROUND_POINTS,
    strict = MGDT_DOMAIN_OPTION_STRICT,
    keep_boundary = MGDT_DOMAIN_OPTION_KEEP_BOUNDARY /**< @since 1.4 */
};

/** Options of a domain whose values are doubles; see MGDT_DOMAIN_OPTION_WELD and its neighbour.
 *  @since 1.4 */
enum class DomainDoubleOption : std::int32_t {
    weld = MGDT_DOMAIN_OPTION_WELD,
    flatness = MGDT_DOMAIN_OPTION_FLATNESS
};

/** Statistics of a domain; see MGDT_DOMAIN_STAT_POINTS and its neighbours. @since 1.3 */
enum class DomainStatistic : std::int32_t {
    points = MGDT_DOMAIN_STAT_POINTS,
    facets = MGDT_DOMAIN_STAT_FACETS,
    segments = MGDT_DOMAIN_STAT_SEGMENTS,
    regions = MGDT_DOMAIN_STAT_REGIONS,
    holes = MGDT_DOMAIN_STAT_HOLES,
    memory_bytes = MGDT_DOMAIN_STAT_MEMORY_BYTES,
    offending_pairs = MGDT_DOMAIN_STAT_OFFENDING_PAIRS,
    open_edges = MGDT_DOMAIN_STAT_OPEN_EDGES,
    moved_points = MGDT_DOMAIN_STAT_MOVED_POINTS,         /**< @since 1.4 */
    repeated_corners = MGDT_DOMAIN_STAT_REPEATED_CORNERS, /**< @since 1.4 */
    collapsed_facets = MGDT_DOMAIN_STAT_COLLAPSED_FACETS, /**< @since 1.4 */
    covered_facets = MGDT_DOMAIN_STAT_COVERED_FACETS,     /**< @since 1.4 */
    points_in_edges = MGDT_DOMAIN_STAT_POINTS_IN_EDGES,   /**< @since 1.4 */
    points_in_facets = MGDT_DOMAIN_STAT_POINTS_IN_FACETS, /**< @since 1.4 */
    edges_in_facets = MGDT_DOMAIN_STAT_EDGES_IN_FACETS,   /**< @since 1.4 */
    exchanged_edges = MGDT_DOMAIN_STAT_EXCHANGED_EDGES    /**< @since 1.4 */
};

/** Arrays of integers of a domain; see MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS and its neighbours.
 *  @since 1.3 */
enum class DomainArray : std::int32_t {
    offending_pairs = MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS,
    open_edges = MGDT_DOMAIN_ARRAY_OPEN_EDGES,
    facet_offsets = MGDT_DOMAIN_ARRAY_FACET_OFFSETS,     /**< @since 1.4 */
    facet_corners = MGDT_DOMAIN_ARRAY_FACET_CORNERS,     /**< @since 1.4 */
    facet_markers = MGDT_DOMAIN_ARRAY_FACET_MARKERS,     /**< @since 1.4 */
    facet_origins = MGDT_DOMAIN_ARRAY_FACET_ORIGINS,     /**< @since 1.4 */
    covered_facets = MGDT_DOMAIN_ARRAY_COVERED_FACETS,   /**< @since 1.4 */
    segments = MGDT_DOMAIN_ARRAY_SEGMENTS,               /**< @since 1.4 */
    segment_markers = MGDT_DOMAIN_ARRAY_SEGMENT_MARKERS, /**< @since 1.4 */
    segment_origins = MGDT_DOMAIN_ARRAY_SEGMENT_ORIGINS  /**< @since 1.4 */
};

/** Arrays of doubles of a domain. @since 1.4 */
enum class DomainDoubles : std::int32_t { points = MGDT_DOMAIN_ARRAY_POINTS };

/** Options of a mesh; see MGDT_MESH_OPTION_INDEX_BASE and its neighbours. @since 1.3 */
enum class MeshOption : std::int32_t {
    index_base = MGDT_MESH_OPTION_INDEX_BASE,
    threads = MGDT_MESH_OPTION_THREADS,
    memory_limit = MGDT_MESH_OPTION_MEMORY_LIMIT,
    goal = MGDT_MESH_OPTION_GOAL,                        /**< @since 1.4 */
    boundary = MGDT_MESH_OPTION_BOUNDARY,                /**< @since 1.4 */
    points = MGDT_MESH_OPTION_POINTS,                    /**< @since 1.4 */
    mean_passes = MGDT_MESH_OPTION_MEAN_PASSES,          /**< @since 1.4 */
    most_passes = MGDT_MESH_OPTION_MOST_PASSES,          /**< @since 1.4 */
    most_points = MGDT_MESH_OPTION_MOST_POINTS,          /**< @since 1.4 */
    sizes_of_surface = MGDT_MESH_OPTION_SIZES_OF_SURFACE /**< @since 1.4 */
};

/** Options of a mesh that are doubles; see MGDT_MESH_OPTION_SIZE and its neighbours. @since 1.4 */
enum class MeshDoubleOption : std::int32_t {
    size = MGDT_MESH_OPTION_SIZE,
    gradation = MGDT_MESH_OPTION_GRADATION,
    radius_edge = MGDT_MESH_OPTION_RADIUS_EDGE,
    volume = MGDT_MESH_OPTION_VOLUME
};

/** What Mesh::set_sizes() sets sizes of. @since 1.4 */
enum class Sizes : std::int32_t {
    of_points = MGDT_SIZES_OF_POINTS,
    of_tetrahedra = MGDT_SIZES_OF_TETRAHEDRA,
    of_regions = MGDT_SIZES_OF_REGIONS
};

/** Statistics of a mesh; see MGDT_MESH_STAT_POINTS and its neighbours. @since 1.3 */
enum class MeshStatistic : std::int32_t {
    points = MGDT_MESH_STAT_POINTS,
    steiner_points = MGDT_MESH_STAT_STEINER_POINTS,
    tetrahedra = MGDT_MESH_STAT_TETRAHEDRA,
    regions = MGDT_MESH_STAT_REGIONS,
    faces = MGDT_MESH_STAT_FACES,
    edges = MGDT_MESH_STAT_EDGES,
    memory_bytes = MGDT_MESH_STAT_MEMORY_BYTES,
    is_rounded = MGDT_MESH_STAT_IS_ROUNDED,
    is_delaunay = MGDT_MESH_STAT_IS_DELAUNAY,
    is_of_domain = MGDT_MESH_STAT_IS_OF_DOMAIN,     /**< @since 1.4 */
    keeps_boundary = MGDT_MESH_STAT_KEEPS_BOUNDARY, /**< @since 1.4 */
    grid_bits = MGDT_MESH_STAT_GRID_BITS,
    unused_points = MGDT_MESH_STAT_UNUSED_POINTS,
    unused_faces = MGDT_MESH_STAT_UNUSED_FACES,
    unused_regions = MGDT_MESH_STAT_UNUSED_REGIONS,
    unused_holes = MGDT_MESH_STAT_UNUSED_HOLES,
    planar_facets = MGDT_MESH_STAT_PLANAR_FACETS,
    missing_facets = MGDT_MESH_STAT_MISSING_FACETS,
    cavities = MGDT_MESH_STAT_CAVITIES,
    largest_cavity = MGDT_MESH_STAT_LARGEST_CAVITY,
    below_goal = MGDT_MESH_STAT_BELOW_GOAL,           /**< @since 1.4 */
    passes = MGDT_MESH_STAT_PASSES,                   /**< @since 1.4 */
    moved_points = MGDT_MESH_STAT_MOVED_POINTS,       /**< @since 1.4 */
    removed_points = MGDT_MESH_STAT_REMOVED_POINTS,   /**< @since 1.4 */
    inserted_points = MGDT_MESH_STAT_INSERTED_POINTS, /**< @since 1.4 */
    refused = MGDT_MESH_STAT_REFUSED                  /**< @since 1.4 */
};

/** Arrays of integers of a mesh; see MGDT_MESH_ARRAY_POINT_ORIGINS and its neighbours. @since 1.3
 */
enum class MeshArray : std::int32_t {
    point_origins = MGDT_MESH_ARRAY_POINT_ORIGINS,
    tetrahedra = MGDT_MESH_ARRAY_TETRAHEDRA,
    neighbors = MGDT_MESH_ARRAY_NEIGHBORS,
    tetrahedron_regions = MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS,
    region_markers = MGDT_MESH_ARRAY_REGION_MARKERS,
    faces = MGDT_MESH_ARRAY_FACES,
    face_tetrahedra = MGDT_MESH_ARRAY_FACE_TETRAHEDRA,
    face_facets = MGDT_MESH_ARRAY_FACE_FACETS,
    face_markers = MGDT_MESH_ARRAY_FACE_MARKERS,
    edges = MGDT_MESH_ARRAY_EDGES,
    edge_segments = MGDT_MESH_ARRAY_EDGE_SEGMENTS,
    edge_markers = MGDT_MESH_ARRAY_EDGE_MARKERS,
    steiner_edges = MGDT_MESH_ARRAY_STEINER_EDGES,
    reasons = MGDT_MESH_ARRAY_REASONS,                   /**< @since 1.4 */
    angle_histogram = MGDT_MESH_ARRAY_ANGLE_HISTOGRAM,   /**< @since 1.4 */
    tetrahedra_below = MGDT_MESH_ARRAY_TETRAHEDRA_BELOW, /**< @since 1.4 */
    refusals = MGDT_MESH_ARRAY_REFUSALS                  /**< @since 1.4 */
};

/** Arrays of doubles of a mesh; see MGDT_MESH_ARRAY_POINTS and its neighbours. @since 1.3 */
enum class MeshDoubles : std::int32_t {
    points = MGDT_MESH_ARRAY_POINTS,
    steiner_parameters = MGDT_MESH_ARRAY_STEINER_PARAMETERS,
    shapes = MGDT_MESH_ARRAY_SHAPES, /**< @since 1.4 */
    sizes = MGDT_MESH_ARRAY_SIZES    /**< @since 1.4 */
};

/** Options of a periodic box; see MGDT_PERIODIC_OPTION_INDEX_BASE and its neighbours. @since 1.3 */
enum class PeriodicOption : std::int32_t {
    index_base = MGDT_PERIODIC_OPTION_INDEX_BASE,
    threads = MGDT_PERIODIC_OPTION_THREADS,
    memory_limit = MGDT_PERIODIC_OPTION_MEMORY_LIMIT
};

/** Statistics of a periodic box; see MGDT_PERIODIC_STAT_POINTS and its neighbours. @since 1.3 */
enum class PeriodicStatistic : std::int32_t {
    points = MGDT_PERIODIC_STAT_POINTS,
    vertices = MGDT_PERIODIC_STAT_VERTICES,
    tetrahedra = MGDT_PERIODIC_STAT_TETRAHEDRA,
    edges = MGDT_PERIODIC_STAT_EDGES,
    dimensions = MGDT_PERIODIC_STAT_DIMENSIONS,
    memory_bytes = MGDT_PERIODIC_STAT_MEMORY_BYTES,
    images = MGDT_PERIODIC_STAT_IMAGES,
    rounds = MGDT_PERIODIC_STAT_ROUNDS
};

/** Arrays of integers of a periodic box; see MGDT_PERIODIC_ARRAY_POINT_MAP and its neighbours.
 *  @since 1.3 */
enum class PeriodicArray : std::int32_t {
    point_map = MGDT_PERIODIC_ARRAY_POINT_MAP,
    point_shifts = MGDT_PERIODIC_ARRAY_POINT_SHIFTS,
    tetrahedra = MGDT_PERIODIC_ARRAY_TETRAHEDRA,
    tetrahedron_shifts = MGDT_PERIODIC_ARRAY_TETRAHEDRON_SHIFTS,
    neighbors = MGDT_PERIODIC_ARRAY_NEIGHBORS,
    neighbor_shifts = MGDT_PERIODIC_ARRAY_NEIGHBOR_SHIFTS,
    vertex_neighbor_offsets = MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS,
    vertex_neighbors = MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS,
    vertex_neighbor_shifts = MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_SHIFTS
};

/** Arrays of doubles of a periodic box; see MGDT_PERIODIC_ARRAY_POINTS and its neighbour.
 *  @since 1.3 */
enum class PeriodicDoubles : std::int32_t {
    points = MGDT_PERIODIC_ARRAY_POINTS,
    vectors = MGDT_PERIODIC_ARRAY_VECTORS
};

/** Options of parts; see MGDT_PARTS_INDEX_BASE and its neighbours. @since 1.2 */
enum class PartsOption : std::int32_t {
    index_base = MGDT_PARTS_INDEX_BASE,
    threads = MGDT_PARTS_THREADS,
    memory_limit = MGDT_PARTS_MEMORY_LIMIT,
    read_progress = MGDT_PARTS_READ_PROGRESS
};

/** Numbers of parts; see MGDT_PARTS_PARTS and its neighbours. @since 1.2 */
enum class PartsNumber : std::int32_t {
    parts = MGDT_PARTS_PARTS,
    first_local = MGDT_PARTS_FIRST_LOCAL,
    local_parts = MGDT_PARTS_LOCAL_PARTS,
    points = MGDT_PARTS_POINTS,
    own_vertices = MGDT_PARTS_OWN_VERTICES,
    vertices = MGDT_PARTS_VERTICES,
    all_vertices = MGDT_PARTS_ALL_VERTICES,
    own_tetrahedra = MGDT_PARTS_OWN_TETRAHEDRA,
    tetrahedra = MGDT_PARTS_TETRAHEDRA,
    all_tetrahedra = MGDT_PARTS_ALL_TETRAHEDRA,
    received = MGDT_PARTS_RECEIVED,
    memory_bytes = MGDT_PARTS_MEMORY_BYTES
};

/** Arrays of a part; see MGDT_PARTS_POINT_MAP and its neighbours. @since 1.2 */
enum class PartsArray : std::int32_t {
    point_map = MGDT_PARTS_POINT_MAP,
    vertex_numbers = MGDT_PARTS_VERTEX_NUMBERS,
    vertex_ids = MGDT_PARTS_VERTEX_IDS,
    vertex_owners = MGDT_PARTS_VERTEX_OWNERS,
    vertex_ranges = MGDT_PARTS_VERTEX_RANGES,
    corners = MGDT_PARTS_CORNERS,
    local_corners = MGDT_PARTS_LOCAL_CORNERS,
    tetrahedron_numbers = MGDT_PARTS_TETRAHEDRON_NUMBERS,
    tetrahedron_owners = MGDT_PARTS_TETRAHEDRON_OWNERS,
    tetrahedron_ranges = MGDT_PARTS_TETRAHEDRON_RANGES,
    neighbors = MGDT_PARTS_NEIGHBORS
};

/** Name of an order scheme ("multi-grid"); NULL for an unknown one. */
[[nodiscard]] inline const char* name(Order scheme) noexcept {
    return mgdt_order_scheme_name(static_cast<std::int32_t>(scheme));
}
/** Name of a statistic ("walk steps"); NULL for an unknown one. */
[[nodiscard]] inline const char* name(Statistic key) noexcept {
    return mgdt_stat_name(static_cast<std::int32_t>(key));
}

}  // namespace cxx1
}  // namespace mgdt

#endif /* MGDT_CXX_CONSTANTS_HPP */
