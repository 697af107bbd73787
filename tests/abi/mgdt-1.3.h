/* SPDX-License-Identifier: MIT
 * The declarations of mgdt.h, mgdt_parts.h, mgdt_voronoi.h, mgdt_mesh.h, mgdt_domain.h and
 * mgdt_periodic.h as version 1.3 has them, without the comments. Frozen: programs were compiled
 * with these. See docs/abi.md. */
#ifndef MGDT_MGDT_H
#define MGDT_MGDT_H

#include <stddef.h>
#include <stdint.h>

#define MGDT_VERSION_MAJOR 1
#define MGDT_VERSION_MINOR 3
#define MGDT_VERSION_PATCH 0

#define MGDT_VERSION_AT_LEAST(major, minor) \
    (MGDT_VERSION_MAJOR > (major) ||        \
     (MGDT_VERSION_MAJOR == (major) && MGDT_VERSION_MINOR >= (minor)))

#if defined(_WIN32)
#if defined(MGDT_BUILDING)
#define MGDT_API __declspec(dllexport)
#elif defined(MGDT_STATIC)
#define MGDT_API
#else
#define MGDT_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define MGDT_API __attribute__((visibility("default")))
#else
#define MGDT_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct mgdt_triangulation mgdt_triangulation;

typedef int32_t mgdt_status;

enum {
    MGDT_OK = 0,
    MGDT_ERR_NULL_POINTER = 10,
    MGDT_ERR_INVALID_ARGUMENT = 11,
    MGDT_ERR_NOT_FINITE = 12,
    MGDT_ERR_UNKNOWN_SCHEME = 13,
    MGDT_ERR_UNKNOWN_KEY = 14,
    MGDT_ERR_NOT_BUILT = 15,
    MGDT_ERR_BUFFER_TOO_SMALL = 20,
    MGDT_ERR_INDEX_RANGE = 21,
    MGDT_ERR_OUT_OF_MEMORY = 30,
    MGDT_ERR_TOO_LARGE = 31,
    MGDT_ERR_CANCELLED = 40,
    MGDT_ERR_BUSY = 41,
    MGDT_ERR_TRANSPORT = 50,
    MGDT_ERR_CHECK_FAILED = 60,
    MGDT_ERR_INVALID_BOUNDARY = 70,
    MGDT_ERR_RESOLUTION = 71,
    MGDT_ERR_OPEN_BOUNDARY = 72,
    MGDT_ERR_INTERNAL = 90
};

enum {
    MGDT_ORDER_AUTO = 0,
    MGDT_ORDER_INPUT = 10,
    MGDT_ORDER_RANDOM = 20,
    MGDT_ORDER_LEXICOGRAPHIC = 30,
    MGDT_ORDER_BRIO = 40,
    MGDT_ORDER_HILBERT = 50,
    MGDT_ORDER_REGULAR_GRID = 60,
    MGDT_ORDER_KD_TREE = 70,
    MGDT_ORDER_ENHANCED_KD_TREE = 80,
    MGDT_ORDER_MULTI_GRID = 90
};

enum {
    MGDT_PARAMETER_POINTS_PER_CELL = 10,
    MGDT_PARAMETER_THRESHOLD = 20,
    MGDT_PARAMETER_SEPARATION = 30,
    MGDT_PARAMETER_ROUND_RATIO = 40
};

enum { MGDT_SEPARATION_NONE = 0, MGDT_SEPARATION_PASSES = 1, MGDT_SEPARATION_ROUNDS = 2 };

enum {
    MGDT_STAT_POINTS_INSERTED = 10,
    MGDT_STAT_DUPLICATES = 11,
    MGDT_STAT_POINTS_REMOVED = 12,
    MGDT_STAT_POINTS_MOVED = 13,
    MGDT_STAT_PUT_BACK = 14,
    MGDT_STAT_REBUILDS = 15,
    MGDT_STAT_WALK_STEPS = 20,
    MGDT_STAT_WALK_TESTS = 21,
    MGDT_STAT_CONFLICT_TESTS = 22,
    MGDT_STAT_TETRAHEDRA_REMOVED = 30,
    MGDT_STAT_TETRAHEDRA_CREATED = 31,
    MGDT_STAT_LINK_VERTICES = 32,
    MGDT_STAT_EXACT_CALLS = 40,
    MGDT_STAT_PUT_OFF = 45,
    MGDT_STAT_INSERTED_ALONE = 46,
    MGDT_STAT_ORDER_SECONDS = 50,
    MGDT_STAT_INSERT_SECONDS = 51,
    MGDT_STAT_REMOVE_SECONDS = 52,
    MGDT_STAT_MOVE_SECONDS = 53,
    MGDT_STAT_GRID_LEVELS = 60,
    MGDT_STAT_ROUNDS = 61,
    MGDT_STAT_THREADS = 62,
    MGDT_STAT_MEMORY_BYTES = 70,
    MGDT_STAT_PEAK_MEMORY_BYTES = 71
};

enum { MGDT_CHECK_COMBINATORIAL = 1, MGDT_CHECK_GEOMETRIC = 2, MGDT_CHECK_CANONICAL = 3 };

enum {
    MGDT_MEASURE_VOLUME = 10,
    MGDT_MEASURE_AREA = 20,
    MGDT_MEASURE_CENTROID = 30,
    MGDT_MEASURE_FACES = 40
};

enum {
    MGDT_TETRAHEDRON_VOLUME = 10,
    MGDT_TETRAHEDRON_RADIUS_RATIO = 20,
    MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE = 30,
    MGDT_TETRAHEDRON_LARGEST_DIHEDRAL_ANGLE = 31,
    MGDT_TETRAHEDRON_LONGEST_EDGE = 40
};

enum {
    MGDT_INTERPOLATE_LINEAR = 10,
    MGDT_INTERPOLATE_NEAREST = 20,
    MGDT_INTERPOLATE_SIBSON = 30,
    MGDT_INTERPOLATE_LAPLACE = 40,
    MGDT_INTERPOLATE_SIBSON_C1 = 50
};

enum {
    MGDT_OUTSIDE_NONE = 10,
    MGDT_OUTSIDE_NEAREST = 20,
    MGDT_OUTSIDE_BOUNDARY = 30,
    MGDT_OUTSIDE_LINEAR = 40
};

typedef void* (*mgdt_alloc_fn)(size_t size, size_t align, void* user);

typedef void (*mgdt_free_fn)(void* p, size_t size, size_t align, void* user);

typedef int32_t (*mgdt_progress_fn)(double fraction, void* user);

MGDT_API mgdt_status mgdt_create(mgdt_triangulation** out);

MGDT_API mgdt_status mgdt_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release,
                                                void* user, mgdt_triangulation** out);

MGDT_API void mgdt_destroy(mgdt_triangulation* t);

MGDT_API mgdt_status mgdt_clear(mgdt_triangulation* t);

MGDT_API mgdt_status mgdt_reserve(mgdt_triangulation* t, int64_t n_points);

MGDT_API mgdt_status mgdt_shrink(mgdt_triangulation* t);

MGDT_API mgdt_status mgdt_set_order_scheme(mgdt_triangulation* t, int32_t scheme);

MGDT_API mgdt_status mgdt_get_order_scheme(const mgdt_triangulation* t, int32_t* scheme);

MGDT_API mgdt_status mgdt_set_order_parameter(mgdt_triangulation* t, int32_t key, double value);

MGDT_API mgdt_status mgdt_get_order_parameter(const mgdt_triangulation* t, int32_t key,
                                              double* value);

MGDT_API mgdt_status mgdt_set_seed(mgdt_triangulation* t, uint64_t seed);

MGDT_API mgdt_status mgdt_get_seed(const mgdt_triangulation* t, uint64_t* seed);

MGDT_API mgdt_status mgdt_set_threads(mgdt_triangulation* t, int32_t n);

MGDT_API mgdt_status mgdt_get_threads(const mgdt_triangulation* t, int32_t* n);

MGDT_API mgdt_status mgdt_set_index_base(mgdt_triangulation* t, int32_t base);

MGDT_API mgdt_status mgdt_get_index_base(const mgdt_triangulation* t, int32_t* base);

MGDT_API mgdt_status mgdt_set_memory_limit(mgdt_triangulation* t, int64_t bytes);

MGDT_API mgdt_status mgdt_get_memory_limit(const mgdt_triangulation* t, int64_t* bytes);

MGDT_API mgdt_status mgdt_set_compact(mgdt_triangulation* t, int32_t on);

MGDT_API mgdt_status mgdt_get_compact(const mgdt_triangulation* t, int32_t* on);

MGDT_API mgdt_status mgdt_set_progress(mgdt_triangulation* t, mgdt_progress_fn fn, void* user);

MGDT_API mgdt_status mgdt_get_progress(const mgdt_triangulation* t, mgdt_progress_fn* fn,
                                       void** user);

MGDT_API mgdt_status mgdt_cancel(mgdt_triangulation* t);

MGDT_API mgdt_status mgdt_set_read_progress(mgdt_triangulation* t, int32_t on);

MGDT_API mgdt_status mgdt_get_read_progress(const mgdt_triangulation* t, int32_t* on);

MGDT_API mgdt_status mgdt_set_canonical_output(mgdt_triangulation* t, int32_t on);

MGDT_API mgdt_status mgdt_get_canonical_output(const mgdt_triangulation* t, int32_t* on);

MGDT_API mgdt_status mgdt_set_isa(mgdt_triangulation* t, const char* name);

MGDT_API mgdt_status mgdt_insert_points(mgdt_triangulation* t, int64_t n, const double* xyz);

MGDT_API mgdt_status mgdt_insert_points_strided(mgdt_triangulation* t, int64_t n, const double* x,
                                                const double* y, const double* z, int64_t stride);

MGDT_API mgdt_status mgdt_remove_points(mgdt_triangulation* t, int64_t n, const int64_t* points);

MGDT_API mgdt_status mgdt_remove_points_i32(mgdt_triangulation* t, int64_t n,
                                            const int32_t* points);

MGDT_API mgdt_status mgdt_move_points(mgdt_triangulation* t, int64_t n, const int64_t* points,
                                      const double* xyz);

MGDT_API mgdt_status mgdt_move_points_i32(mgdt_triangulation* t, int64_t n, const int32_t* points,
                                          const double* xyz);

MGDT_API mgdt_status mgdt_renumber_points(mgdt_triangulation* t, int64_t capacity,
                                          int64_t* new_index);

MGDT_API mgdt_status mgdt_renumber_points_i32(mgdt_triangulation* t, int64_t capacity,
                                              int32_t* new_index);

MGDT_API int64_t mgdt_point_count(const mgdt_triangulation* t);

MGDT_API int64_t mgdt_vertex_count(const mgdt_triangulation* t);

MGDT_API int32_t mgdt_dimension(const mgdt_triangulation* t);

MGDT_API int64_t mgdt_tetrahedron_count(const mgdt_triangulation* t);

MGDT_API int64_t mgdt_hull_facet_count(const mgdt_triangulation* t);

MGDT_API int64_t mgdt_edge_count(const mgdt_triangulation* t);

MGDT_API int64_t mgdt_vertex_tetrahedra_count(const mgdt_triangulation* t);

MGDT_API int64_t mgdt_vertex_neighbors_count(const mgdt_triangulation* t);

MGDT_API mgdt_status mgdt_get_tetrahedra(const mgdt_triangulation* t, int64_t capacity, int64_t* v);

MGDT_API mgdt_status mgdt_get_tetrahedra_i32(const mgdt_triangulation* t, int64_t capacity,
                                             int32_t* v);

MGDT_API mgdt_status mgdt_get_neighbors(const mgdt_triangulation* t, int64_t capacity, int64_t* v);

MGDT_API mgdt_status mgdt_get_neighbors_i32(const mgdt_triangulation* t, int64_t capacity,
                                            int32_t* v);

MGDT_API mgdt_status mgdt_get_hull_facets(const mgdt_triangulation* t, int64_t capacity,
                                          int64_t* v);

MGDT_API mgdt_status mgdt_get_hull_facets_i32(const mgdt_triangulation* t, int64_t capacity,
                                              int32_t* v);

MGDT_API mgdt_status mgdt_get_edges(const mgdt_triangulation* t, int64_t capacity, int64_t* v);

MGDT_API mgdt_status mgdt_get_edges_i32(const mgdt_triangulation* t, int64_t capacity, int32_t* v);

MGDT_API mgdt_status mgdt_get_point_map(const mgdt_triangulation* t, int64_t capacity, int64_t* v);

MGDT_API mgdt_status mgdt_get_point_map_i32(const mgdt_triangulation* t, int64_t capacity,
                                            int32_t* v);

MGDT_API mgdt_status mgdt_get_vertex_tetrahedra(const mgdt_triangulation* t,
                                                int64_t offset_capacity, int64_t* offsets,
                                                int64_t capacity, int64_t* list);

MGDT_API mgdt_status mgdt_get_vertex_tetrahedra_i32(const mgdt_triangulation* t,
                                                    int64_t offset_capacity, int32_t* offsets,
                                                    int64_t capacity, int32_t* list);

MGDT_API mgdt_status mgdt_get_vertex_neighbors(const mgdt_triangulation* t, int64_t offset_capacity,
                                               int64_t* offsets, int64_t capacity, int64_t* list);

MGDT_API mgdt_status mgdt_get_vertex_neighbors_i32(const mgdt_triangulation* t,
                                                   int64_t offset_capacity, int32_t* offsets,
                                                   int64_t capacity, int32_t* list);

MGDT_API mgdt_status mgdt_get_gabriel_edges(const mgdt_triangulation* t, int64_t capacity,
                                            int64_t* v, int64_t* count);

MGDT_API mgdt_status mgdt_get_gabriel_edges_i32(const mgdt_triangulation* t, int64_t capacity,
                                                int32_t* v, int32_t* count);

MGDT_API mgdt_status mgdt_get_spanning_tree(const mgdt_triangulation* t, int64_t capacity,
                                            int64_t* v, int64_t* count);

MGDT_API mgdt_status mgdt_get_spanning_tree_i32(const mgdt_triangulation* t, int64_t capacity,
                                                int32_t* v, int32_t* count);

MGDT_API mgdt_status mgdt_get_circumcenters(const mgdt_triangulation* t, int64_t capacity,
                                            double* xyz, double* radius2);

MGDT_API mgdt_status mgdt_get_tetrahedron_measures(const mgdt_triangulation* t, int32_t measure,
                                                   int64_t capacity, double* x);

MGDT_API mgdt_status mgdt_get_cell_measures(const mgdt_triangulation* t, int32_t measure,
                                            int64_t n_planes, const double* planes,
                                            int64_t capacity, double* x);

MGDT_API mgdt_status mgdt_get_alphas(const mgdt_triangulation* t, int32_t dimension,
                                     int64_t capacity, double* alpha2);

MGDT_API mgdt_status mgdt_get_alpha_surface(const mgdt_triangulation* t, double alpha2,
                                            int64_t capacity, int64_t* v, int64_t* count);

MGDT_API mgdt_status mgdt_get_alpha_surface_i32(const mgdt_triangulation* t, double alpha2,
                                                int64_t capacity, int32_t* v, int32_t* count);

MGDT_API mgdt_status mgdt_get_solid_alpha(const mgdt_triangulation* t, double* alpha2);

MGDT_API mgdt_status mgdt_locate(const mgdt_triangulation* t, const double* xyz,
                                 int64_t* tetrahedron);

MGDT_API mgdt_status mgdt_locate_i32(const mgdt_triangulation* t, const double* xyz,
                                     int32_t* tetrahedron);

MGDT_API mgdt_status mgdt_locate_points(const mgdt_triangulation* t, int64_t n, const double* xyz,
                                        int64_t* tetrahedra, double* weights);

MGDT_API mgdt_status mgdt_locate_points_i32(const mgdt_triangulation* t, int64_t n,
                                            const double* xyz, int32_t* tetrahedra,
                                            double* weights);

MGDT_API mgdt_status mgdt_traverse_segment(const mgdt_triangulation* t, const double* a,
                                           const double* b, int64_t capacity, int64_t* tetrahedra,
                                           double* parameters, int64_t* count);

MGDT_API mgdt_status mgdt_traverse_segment_i32(const mgdt_triangulation* t, const double* a,
                                               const double* b, int64_t capacity,
                                               int32_t* tetrahedra, double* parameters,
                                               int32_t* count);

MGDT_API mgdt_status mgdt_nearest_vertex(const mgdt_triangulation* t, const double* xyz,
                                         int64_t* vertex);

MGDT_API mgdt_status mgdt_nearest_vertex_i32(const mgdt_triangulation* t, const double* xyz,
                                             int32_t* vertex);

MGDT_API mgdt_status mgdt_nearest_vertices(const mgdt_triangulation* t, int64_t n,
                                           const double* xyz, int64_t* vertices);

MGDT_API mgdt_status mgdt_nearest_vertices_i32(const mgdt_triangulation* t, int64_t n,
                                               const double* xyz, int32_t* vertices);

MGDT_API mgdt_status mgdt_interpolate(const mgdt_triangulation* t, int32_t method, int32_t outside,
                                      int64_t n_fields, const double* values, int64_t n,
                                      const double* xyz, double* out);

MGDT_API mgdt_status mgdt_get_interpolation_weights(const mgdt_triangulation* t, int32_t method,
                                                    int32_t outside, int64_t n, const double* xyz,
                                                    int64_t offset_capacity, int64_t* offsets,
                                                    int64_t capacity, int64_t* points,
                                                    double* weights);

MGDT_API mgdt_status mgdt_get_interpolation_weights_i32(const mgdt_triangulation* t, int32_t method,
                                                        int32_t outside, int64_t n,
                                                        const double* xyz, int64_t offset_capacity,
                                                        int32_t* offsets, int64_t capacity,
                                                        int32_t* points, double* weights);

MGDT_API mgdt_status mgdt_get_gradients(const mgdt_triangulation* t, int64_t n_fields,
                                        const double* values, double* out);

MGDT_API mgdt_status mgdt_check(const mgdt_triangulation* t, int32_t level);

MGDT_API mgdt_status mgdt_get_stat(const mgdt_triangulation* t, int32_t key, double* value);

MGDT_API const char* mgdt_stat_name(int32_t key);

MGDT_API const char* mgdt_status_string(mgdt_status s);

MGDT_API mgdt_status mgdt_get_error(const mgdt_triangulation* t, int64_t capacity, char* buffer);

MGDT_API const char* mgdt_order_scheme_name(int32_t scheme);

MGDT_API mgdt_status mgdt_order_scheme_from_name(const char* name, int32_t* scheme);

MGDT_API mgdt_status mgdt_order_scheme_at(int32_t index, int32_t* scheme);

MGDT_API const char* mgdt_version_string(void);

MGDT_API int32_t mgdt_abi_version(void);

MGDT_API const char* mgdt_isa_name(const mgdt_triangulation* t);

typedef struct mgdt_parts mgdt_parts;

enum { MGDT_PARTS_THIS_PART = -1 };

typedef int32_t (*mgdt_gather_fn)(const void* mine, void* all, const int64_t* begin, void* user);

typedef int32_t (*mgdt_exchange_numbers_fn)(const uint64_t* out, uint64_t* in, void* user);

typedef int32_t (*mgdt_exchange_fn)(const void* out, const int64_t* out_begin, void* in,
                                    const int64_t* in_begin, void* user);

typedef int32_t (*mgdt_sum_fn)(uint64_t* numbers, int64_t n, void* user);

typedef int32_t (*mgdt_least_fn)(double* numbers, int64_t n, void* user);

typedef void (*mgdt_destroy_transport_fn)(void* user);

typedef struct mgdt_transport {
    size_t size;
    int32_t processes;
    int32_t process;
    mgdt_gather_fn gather;
    mgdt_exchange_numbers_fn exchange_numbers;
    mgdt_exchange_fn exchange;
    mgdt_sum_fn sum;
    mgdt_least_fn least;
    mgdt_destroy_transport_fn destroy;
    void* user;
} mgdt_transport;

enum {
    MGDT_PARTS_INDEX_BASE = 10,
    MGDT_PARTS_THREADS = 20,
    MGDT_PARTS_MEMORY_LIMIT = 30,
    MGDT_PARTS_READ_PROGRESS = 40
};

enum {
    MGDT_PARTS_PARTS = 10,
    MGDT_PARTS_FIRST_LOCAL = 11,
    MGDT_PARTS_LOCAL_PARTS = 12,
    MGDT_PARTS_POINTS = 20,
    MGDT_PARTS_OWN_VERTICES = 30,
    MGDT_PARTS_VERTICES = 31,
    MGDT_PARTS_ALL_VERTICES = 32,
    MGDT_PARTS_OWN_TETRAHEDRA = 40,
    MGDT_PARTS_TETRAHEDRA = 41,
    MGDT_PARTS_ALL_TETRAHEDRA = 42,
    MGDT_PARTS_RECEIVED = 50,
    MGDT_PARTS_MEMORY_BYTES = 60
};

enum {
    MGDT_PARTS_POINT_MAP = 10,
    MGDT_PARTS_VERTEX_NUMBERS = 20,
    MGDT_PARTS_VERTEX_IDS = 21,
    MGDT_PARTS_VERTEX_OWNERS = 22,
    MGDT_PARTS_VERTEX_RANGES = 23,
    MGDT_PARTS_CORNERS = 30,
    MGDT_PARTS_LOCAL_CORNERS = 31,
    MGDT_PARTS_TETRAHEDRON_NUMBERS = 32,
    MGDT_PARTS_TETRAHEDRON_OWNERS = 33,
    MGDT_PARTS_TETRAHEDRON_RANGES = 34,
    MGDT_PARTS_NEIGHBORS = 40
};

MGDT_API mgdt_status mgdt_parts_create(int32_t parts, mgdt_parts** out);

MGDT_API mgdt_status mgdt_parts_create_with_allocator(int32_t parts, mgdt_alloc_fn alloc,
                                                      mgdt_free_fn release, void* user,
                                                      mgdt_parts** out);

MGDT_API mgdt_status mgdt_parts_create_with_transport(const mgdt_transport* transport,
                                                      mgdt_parts** out);

MGDT_API void mgdt_parts_destroy(mgdt_parts* p);

MGDT_API mgdt_status mgdt_parts_clear(mgdt_parts* p);

MGDT_API mgdt_status mgdt_parts_set_option(mgdt_parts* p, int32_t option, int64_t value);

MGDT_API mgdt_status mgdt_parts_get_option(const mgdt_parts* p, int32_t option, int64_t* value);

MGDT_API mgdt_status mgdt_parts_set_progress(mgdt_parts* p, mgdt_progress_fn fn, void* user);

MGDT_API mgdt_status mgdt_parts_get_progress(const mgdt_parts* p, mgdt_progress_fn* fn,
                                             void** user);

MGDT_API mgdt_status mgdt_parts_cancel(mgdt_parts* p);

MGDT_API mgdt_status mgdt_parts_insert_points(mgdt_parts* p, int32_t part, int64_t n,
                                              const double* xyz, const int64_t* ids);

MGDT_API mgdt_status mgdt_parts_build(mgdt_parts* p);

typedef int32_t (*mgdt_part_fn)(const mgdt_parts* p, int32_t part, void* user);

MGDT_API mgdt_status mgdt_parts_build_each(mgdt_parts* p, mgdt_part_fn look, void* user);

MGDT_API mgdt_status mgdt_parts_get_stat(const mgdt_parts* p, int32_t part, int32_t key,
                                         int64_t* value);

MGDT_API mgdt_status mgdt_parts_array_info(int32_t array, int32_t* columns, int32_t* is_double);

MGDT_API mgdt_status mgdt_parts_get_size(const mgdt_parts* p, int32_t part, int32_t array,
                                         int64_t* size);

MGDT_API mgdt_status mgdt_parts_get_array(const mgdt_parts* p, int32_t part, int32_t array,
                                          int64_t capacity, int64_t* values);

MGDT_API mgdt_status mgdt_parts_get_coordinates(const mgdt_parts* p, int32_t part, int64_t capacity,
                                                double* xyz);

MGDT_API mgdt_status mgdt_parts_check(mgdt_parts* p, int32_t level);

MGDT_API mgdt_status mgdt_parts_get_error(const mgdt_parts* p, int64_t capacity, char* buffer);

typedef struct mgdt_voronoi mgdt_voronoi;

enum {
    MGDT_VORONOI_STAT_VERTICES = 100,
    MGDT_VORONOI_STAT_RAYS = 101,
    MGDT_VORONOI_STAT_FACES = 102,
    MGDT_VORONOI_STAT_POINTS = 103,
    MGDT_VORONOI_STAT_MEMORY_BYTES = 110
};

enum {
    MGDT_VORONOI_ARRAY_FACE_OFFSETS = 200,
    MGDT_VORONOI_ARRAY_FACE_CORNERS = 201,
    MGDT_VORONOI_ARRAY_FACE_SIDES = 202,
    MGDT_VORONOI_ARRAY_FACE_SHIFTS = 203,
    MGDT_VORONOI_ARRAY_RAY_VERTICES = 210,
    MGDT_VORONOI_ARRAY_CELL_OFFSETS = 220,
    MGDT_VORONOI_ARRAY_CELL_FACES = 221,
    MGDT_VORONOI_ARRAY_CELL_BOUNDED = 222,
    MGDT_VORONOI_ARRAY_CELL_NEIGHBORS = 223,
    MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_SHIFTS = 224,
    MGDT_VORONOI_ARRAY_VERTICES = 300,
    MGDT_VORONOI_ARRAY_RAY_DIRECTIONS = 310,
    MGDT_VORONOI_ARRAY_FACE_AREAS = 320,
    MGDT_VORONOI_ARRAY_FACE_NORMALS = 321,
    MGDT_VORONOI_ARRAY_FACE_CENTROIDS = 322,
    MGDT_VORONOI_ARRAY_CELL_VOLUMES = 330,
    MGDT_VORONOI_ARRAY_CELL_CENTROIDS = 331,
    MGDT_VORONOI_ARRAY_CELL_FACE_AREAS = 332,
    MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES = 333
};

MGDT_API mgdt_status mgdt_voronoi_create(const mgdt_triangulation* t, int64_t n_planes,
                                         const double* planes, mgdt_voronoi** out);

MGDT_API void mgdt_voronoi_destroy(mgdt_voronoi* v);

MGDT_API mgdt_status mgdt_voronoi_get_stat(const mgdt_voronoi* v, int32_t key, int64_t* value);

MGDT_API mgdt_status mgdt_voronoi_array_info(int32_t array, int32_t* columns, int32_t* is_double);

MGDT_API mgdt_status mgdt_voronoi_get_size(const mgdt_voronoi* v, int32_t array, int64_t* size);

MGDT_API mgdt_status mgdt_voronoi_get_array(const mgdt_voronoi* v, int32_t array, int64_t capacity,
                                            int64_t* values);

MGDT_API mgdt_status mgdt_voronoi_get_array_i32(const mgdt_voronoi* v, int32_t array,
                                                int64_t capacity, int32_t* values);

MGDT_API mgdt_status mgdt_voronoi_get_doubles(const mgdt_voronoi* v, int32_t array,
                                              int64_t capacity, double* values);

MGDT_API mgdt_status mgdt_voronoi_drop_small_faces(mgdt_voronoi* v, double least_area,
                                                   double least_share);

MGDT_API mgdt_status mgdt_voronoi_get_error(const mgdt_voronoi* v, int64_t capacity, char* buffer);

typedef struct mgdt_mesh mgdt_mesh;

enum {
    MGDT_MESH_OPTION_INDEX_BASE = 10,
    MGDT_MESH_OPTION_THREADS = 20,
    MGDT_MESH_OPTION_MEMORY_LIMIT = 30
};

enum {
    MGDT_MESH_STAT_POINTS = 100,
    MGDT_MESH_STAT_STEINER_POINTS = 101,
    MGDT_MESH_STAT_TETRAHEDRA = 102,
    MGDT_MESH_STAT_REGIONS = 103,
    MGDT_MESH_STAT_FACES = 104,
    MGDT_MESH_STAT_EDGES = 105,
    MGDT_MESH_STAT_MEMORY_BYTES = 110,
    MGDT_MESH_STAT_IS_ROUNDED = 120,
    MGDT_MESH_STAT_GRID_BITS = 121,
    MGDT_MESH_STAT_UNUSED_POINTS = 130,
    MGDT_MESH_STAT_UNUSED_FACES = 131,
    MGDT_MESH_STAT_UNUSED_REGIONS = 132,
    MGDT_MESH_STAT_UNUSED_HOLES = 133,
    MGDT_MESH_STAT_PLANAR_FACETS = 140,
    MGDT_MESH_STAT_MISSING_FACETS = 141,
    MGDT_MESH_STAT_CAVITIES = 142,
    MGDT_MESH_STAT_LARGEST_CAVITY = 143
};

enum {
    MGDT_MESH_ARRAY_POINT_ORIGINS = 200,
    MGDT_MESH_ARRAY_TETRAHEDRA = 210,
    MGDT_MESH_ARRAY_NEIGHBORS = 211,
    MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS = 212,
    MGDT_MESH_ARRAY_REGION_MARKERS = 220,
    MGDT_MESH_ARRAY_FACES = 230,
    MGDT_MESH_ARRAY_FACE_TETRAHEDRA = 231,
    MGDT_MESH_ARRAY_FACE_FACETS = 232,
    MGDT_MESH_ARRAY_FACE_MARKERS = 233,
    MGDT_MESH_ARRAY_EDGES = 240,
    MGDT_MESH_ARRAY_EDGE_SEGMENTS = 241,
    MGDT_MESH_ARRAY_EDGE_MARKERS = 242,
    MGDT_MESH_ARRAY_STEINER_EDGES = 250,
    MGDT_MESH_ARRAY_POINTS = 300,
    MGDT_MESH_ARRAY_STEINER_PARAMETERS = 310
};

MGDT_API void mgdt_mesh_destroy(mgdt_mesh* m);

MGDT_API mgdt_status mgdt_mesh_set_option(mgdt_mesh* m, int32_t option, int64_t value);

MGDT_API mgdt_status mgdt_mesh_get_option(const mgdt_mesh* m, int32_t option, int64_t* value);

MGDT_API mgdt_status mgdt_mesh_set_progress(mgdt_mesh* m, mgdt_progress_fn fn, void* user);

MGDT_API mgdt_status mgdt_mesh_get_progress(const mgdt_mesh* m, mgdt_progress_fn* fn, void** user);

MGDT_API mgdt_status mgdt_mesh_cancel(mgdt_mesh* m);

MGDT_API mgdt_status mgdt_mesh_get_stat(const mgdt_mesh* m, int32_t key, int64_t* value);

MGDT_API mgdt_status mgdt_mesh_array_info(int32_t array, int32_t* columns, int32_t* is_double);

MGDT_API mgdt_status mgdt_mesh_get_size(const mgdt_mesh* m, int32_t array, int64_t* size);

MGDT_API mgdt_status mgdt_mesh_get_array(const mgdt_mesh* m, int32_t array, int64_t capacity,
                                         int64_t* values);

MGDT_API mgdt_status mgdt_mesh_get_array_i32(const mgdt_mesh* m, int32_t array, int64_t capacity,
                                             int32_t* values);

MGDT_API mgdt_status mgdt_mesh_get_doubles(const mgdt_mesh* m, int32_t array, int64_t capacity,
                                           double* values);

MGDT_API mgdt_status mgdt_mesh_get_tetrahedron_measures(const mgdt_mesh* m, int32_t measure,
                                                        int64_t capacity, double* x);

MGDT_API mgdt_status mgdt_mesh_check(const mgdt_mesh* m);

MGDT_API mgdt_status mgdt_mesh_get_error(const mgdt_mesh* m, int64_t capacity, char* buffer);

typedef struct mgdt_domain mgdt_domain;

enum { MGDT_DOMAIN_KIND_FACET = 0, MGDT_DOMAIN_KIND_SEGMENT = 1, MGDT_DOMAIN_KIND_POINT = 2 };

enum {
    MGDT_DOMAIN_OPTION_INDEX_BASE = 10,
    MGDT_DOMAIN_OPTION_THREADS = 20,
    MGDT_DOMAIN_OPTION_MEMORY_LIMIT = 30,
    MGDT_DOMAIN_OPTION_ROUND_POINTS = 40,
    MGDT_DOMAIN_OPTION_STRICT = 50
};

enum {
    MGDT_DOMAIN_STAT_POINTS = 100,
    MGDT_DOMAIN_STAT_FACETS = 101,
    MGDT_DOMAIN_STAT_SEGMENTS = 102,
    MGDT_DOMAIN_STAT_REGIONS = 103,
    MGDT_DOMAIN_STAT_HOLES = 104,
    MGDT_DOMAIN_STAT_MEMORY_BYTES = 110,
    MGDT_DOMAIN_STAT_OFFENDING_PAIRS = 120,
    MGDT_DOMAIN_STAT_OPEN_EDGES = 121
};

enum { MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS = 200, MGDT_DOMAIN_ARRAY_OPEN_EDGES = 210 };

MGDT_API mgdt_status mgdt_domain_create(mgdt_domain** out);

MGDT_API mgdt_status mgdt_domain_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release,
                                                       void* user, mgdt_domain** out);

MGDT_API void mgdt_domain_destroy(mgdt_domain* d);

MGDT_API mgdt_status mgdt_domain_clear(mgdt_domain* d);

MGDT_API mgdt_status mgdt_domain_set_option(mgdt_domain* d, int32_t option, int64_t value);

MGDT_API mgdt_status mgdt_domain_get_option(const mgdt_domain* d, int32_t option, int64_t* value);

MGDT_API mgdt_status mgdt_domain_set_progress(mgdt_domain* d, mgdt_progress_fn fn, void* user);

MGDT_API mgdt_status mgdt_domain_get_progress(const mgdt_domain* d, mgdt_progress_fn* fn,
                                              void** user);

MGDT_API mgdt_status mgdt_domain_cancel(mgdt_domain* d);

MGDT_API mgdt_status mgdt_domain_set_points(mgdt_domain* d, int64_t n, const double* xyz);

MGDT_API mgdt_status mgdt_domain_set_facets(mgdt_domain* d, int64_t n, const int64_t* offsets,
                                            const int64_t* corners, const int32_t* markers);

MGDT_API mgdt_status mgdt_domain_set_facets_i32(mgdt_domain* d, int64_t n, const int32_t* offsets,
                                                const int32_t* corners, const int32_t* markers);

MGDT_API mgdt_status mgdt_domain_set_segments(mgdt_domain* d, int64_t n, const int64_t* ends,
                                              const int32_t* markers);

MGDT_API mgdt_status mgdt_domain_set_segments_i32(mgdt_domain* d, int64_t n, const int32_t* ends,
                                                  const int32_t* markers);

MGDT_API mgdt_status mgdt_domain_set_regions(mgdt_domain* d, int64_t n, const double* xyz,
                                             const int32_t* markers);

MGDT_API mgdt_status mgdt_domain_set_holes(mgdt_domain* d, int64_t n, const double* xyz);

MGDT_API mgdt_status mgdt_domain_validate(mgdt_domain* d);

MGDT_API mgdt_status mgdt_domain_build(mgdt_domain* d, mgdt_mesh** out);

MGDT_API mgdt_status mgdt_domain_check(const mgdt_domain* d, const mgdt_mesh* mesh);

MGDT_API mgdt_status mgdt_domain_get_stat(const mgdt_domain* d, int32_t key, int64_t* value);

MGDT_API mgdt_status mgdt_domain_array_info(int32_t array, int32_t* columns, int32_t* is_double);

MGDT_API mgdt_status mgdt_domain_get_size(const mgdt_domain* d, int32_t array, int64_t* size);

MGDT_API mgdt_status mgdt_domain_get_array(const mgdt_domain* d, int32_t array, int64_t capacity,
                                           int64_t* values);

MGDT_API mgdt_status mgdt_domain_get_array_i32(const mgdt_domain* d, int32_t array,
                                               int64_t capacity, int32_t* values);

MGDT_API mgdt_status mgdt_domain_get_error(const mgdt_domain* d, int64_t capacity, char* buffer);

typedef struct mgdt_periodic mgdt_periodic;

enum {
    MGDT_PERIODIC_OPTION_INDEX_BASE = 10,
    MGDT_PERIODIC_OPTION_THREADS = 20,
    MGDT_PERIODIC_OPTION_MEMORY_LIMIT = 30
};

enum {
    MGDT_PERIODIC_STAT_POINTS = 100,
    MGDT_PERIODIC_STAT_VERTICES = 101,
    MGDT_PERIODIC_STAT_TETRAHEDRA = 102,
    MGDT_PERIODIC_STAT_EDGES = 103,
    MGDT_PERIODIC_STAT_DIMENSIONS = 104,
    MGDT_PERIODIC_STAT_MEMORY_BYTES = 110,
    MGDT_PERIODIC_STAT_IMAGES = 120,
    MGDT_PERIODIC_STAT_ROUNDS = 121
};

enum {
    MGDT_PERIODIC_ARRAY_POINT_MAP = 200,
    MGDT_PERIODIC_ARRAY_POINT_SHIFTS = 201,
    MGDT_PERIODIC_ARRAY_TETRAHEDRA = 210,
    MGDT_PERIODIC_ARRAY_TETRAHEDRON_SHIFTS = 211,
    MGDT_PERIODIC_ARRAY_NEIGHBORS = 212,
    MGDT_PERIODIC_ARRAY_NEIGHBOR_SHIFTS = 213,
    MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS = 220,
    MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS = 221,
    MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_SHIFTS = 222,
    MGDT_PERIODIC_ARRAY_POINTS = 300,
    MGDT_PERIODIC_ARRAY_VECTORS = 301
};

MGDT_API mgdt_status mgdt_periodic_create(mgdt_periodic** out);

MGDT_API mgdt_status mgdt_periodic_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release,
                                                         void* user, mgdt_periodic** out);

MGDT_API void mgdt_periodic_destroy(mgdt_periodic* p);

MGDT_API mgdt_status mgdt_periodic_clear(mgdt_periodic* p);

MGDT_API mgdt_status mgdt_periodic_set_vectors(mgdt_periodic* p, int32_t dimensions,
                                               const double* vectors);

MGDT_API mgdt_status mgdt_periodic_set_option(mgdt_periodic* p, int32_t option, int64_t value);

MGDT_API mgdt_status mgdt_periodic_get_option(const mgdt_periodic* p, int32_t option,
                                              int64_t* value);

MGDT_API mgdt_status mgdt_periodic_set_merge_distance(mgdt_periodic* p, double distance);

MGDT_API mgdt_status mgdt_periodic_get_merge_distance(const mgdt_periodic* p, double* distance);

MGDT_API mgdt_status mgdt_periodic_set_progress(mgdt_periodic* p, mgdt_progress_fn fn, void* user);

MGDT_API mgdt_status mgdt_periodic_get_progress(const mgdt_periodic* p, mgdt_progress_fn* fn,
                                                void** user);

MGDT_API mgdt_status mgdt_periodic_cancel(mgdt_periodic* p);

MGDT_API mgdt_status mgdt_periodic_insert_points(mgdt_periodic* p, int64_t n, const double* xyz);

MGDT_API mgdt_status mgdt_periodic_move_points(mgdt_periodic* p, int64_t n, const int64_t* points,
                                               const double* xyz);

MGDT_API mgdt_status mgdt_periodic_move_points_i32(mgdt_periodic* p, int64_t n,
                                                   const int32_t* points, const double* xyz);

MGDT_API mgdt_status mgdt_periodic_build(mgdt_periodic* p);

MGDT_API mgdt_status mgdt_periodic_check(const mgdt_periodic* p);

MGDT_API mgdt_status mgdt_periodic_get_stat(const mgdt_periodic* p, int32_t key, int64_t* value);

MGDT_API mgdt_status mgdt_periodic_array_info(int32_t array, int32_t* columns, int32_t* is_double);

MGDT_API mgdt_status mgdt_periodic_get_size(const mgdt_periodic* p, int32_t array, int64_t* size);

MGDT_API mgdt_status mgdt_periodic_get_array(const mgdt_periodic* p, int32_t array,
                                             int64_t capacity, int64_t* values);

MGDT_API mgdt_status mgdt_periodic_get_array_i32(const mgdt_periodic* p, int32_t array,
                                                 int64_t capacity, int32_t* values);

MGDT_API mgdt_status mgdt_periodic_get_doubles(const mgdt_periodic* p, int32_t array,
                                               int64_t capacity, double* values);

MGDT_API mgdt_status mgdt_periodic_get_cell_measures(const mgdt_periodic* p, int32_t measure,
                                                     int64_t capacity, double* x);

MGDT_API mgdt_status mgdt_periodic_create_voronoi(const mgdt_periodic* p, mgdt_voronoi** out);

MGDT_API mgdt_status mgdt_periodic_get_error(const mgdt_periodic* p, int64_t capacity,
                                             char* buffer);

#ifdef __cplusplus
}
#endif

#endif
