/* SPDX-License-Identifier: MIT
 * The declarations of mgdt.h as version 1.1 has them, without the comments. Frozen: programs were
 * compiled with these. See docs/abi.md. */
#ifndef MGDT_MGDT_H
#define MGDT_MGDT_H

#include <stddef.h>
#include <stdint.h>

#define MGDT_VERSION_MAJOR 1
#define MGDT_VERSION_MINOR 1
#define MGDT_VERSION_PATCH 0

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
    MGDT_ERR_BUFFER_TOO_SMALL = 20,
    MGDT_ERR_INDEX_RANGE = 21,
    MGDT_ERR_OUT_OF_MEMORY = 30,
    MGDT_ERR_TOO_LARGE = 31,
    MGDT_ERR_CANCELLED = 40,
    MGDT_ERR_CHECK_FAILED = 60,
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

enum {
    MGDT_STAT_POINTS_INSERTED = 10,
    MGDT_STAT_DUPLICATES = 11,
    MGDT_STAT_WALK_STEPS = 20,
    MGDT_STAT_WALK_TESTS = 21,
    MGDT_STAT_CONFLICT_TESTS = 22,
    MGDT_STAT_TETRAHEDRA_REMOVED = 30,
    MGDT_STAT_TETRAHEDRA_CREATED = 31,
    MGDT_STAT_EXACT_CALLS = 40,
    MGDT_STAT_PUT_OFF = 45,
    MGDT_STAT_INSERTED_ALONE = 46,
    MGDT_STAT_ORDER_SECONDS = 50,
    MGDT_STAT_INSERT_SECONDS = 51,
    MGDT_STAT_GRID_LEVELS = 60,
    MGDT_STAT_ROUNDS = 61,
    MGDT_STAT_THREADS = 62,
    MGDT_STAT_MEMORY_BYTES = 70,
    MGDT_STAT_PEAK_MEMORY_BYTES = 71
};

enum {
    MGDT_CHECK_COMBINATORIAL = 1,
    MGDT_CHECK_GEOMETRIC = 2,
    MGDT_CHECK_CANONICAL = 3
};

typedef void *(*mgdt_alloc_fn)(size_t size, size_t align, void *user);

typedef void (*mgdt_free_fn)(void *p, size_t size, size_t align, void *user);

typedef int32_t (*mgdt_progress_fn)(double fraction, void *user);

MGDT_API mgdt_status mgdt_create(mgdt_triangulation **out);

MGDT_API mgdt_status mgdt_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release,
                                                void *user, mgdt_triangulation **out);

MGDT_API void mgdt_destroy(mgdt_triangulation *t);

MGDT_API mgdt_status mgdt_clear(mgdt_triangulation *t);

MGDT_API mgdt_status mgdt_reserve(mgdt_triangulation *t, int64_t n_points);

MGDT_API mgdt_status mgdt_set_order_scheme(mgdt_triangulation *t, int32_t scheme);

MGDT_API mgdt_status mgdt_set_order_parameter(mgdt_triangulation *t, int32_t key, double value);

MGDT_API mgdt_status mgdt_set_seed(mgdt_triangulation *t, uint64_t seed);

MGDT_API mgdt_status mgdt_set_threads(mgdt_triangulation *t, int32_t n);

MGDT_API mgdt_status mgdt_set_index_base(mgdt_triangulation *t, int32_t base);

MGDT_API mgdt_status mgdt_set_memory_limit(mgdt_triangulation *t, int64_t bytes);

MGDT_API mgdt_status mgdt_set_compact(mgdt_triangulation *t, int32_t on);

MGDT_API mgdt_status mgdt_set_progress(mgdt_triangulation *t, mgdt_progress_fn fn, void *user);

MGDT_API mgdt_status mgdt_cancel(mgdt_triangulation *t);

MGDT_API mgdt_status mgdt_set_canonical_output(mgdt_triangulation *t, int32_t on);

MGDT_API mgdt_status mgdt_set_isa(mgdt_triangulation *t, const char *name);

MGDT_API mgdt_status mgdt_insert_points(mgdt_triangulation *t, int64_t n, const double *xyz);

MGDT_API mgdt_status mgdt_insert_points_strided(mgdt_triangulation *t, int64_t n, const double *x,
                                                const double *y, const double *z, int64_t stride);

MGDT_API int64_t mgdt_point_count(const mgdt_triangulation *t);

MGDT_API int64_t mgdt_vertex_count(const mgdt_triangulation *t);

MGDT_API int32_t mgdt_dimension(const mgdt_triangulation *t);

MGDT_API int64_t mgdt_tetrahedron_count(const mgdt_triangulation *t);

MGDT_API int64_t mgdt_hull_facet_count(const mgdt_triangulation *t);

MGDT_API int64_t mgdt_edge_count(const mgdt_triangulation *t);

MGDT_API int64_t mgdt_vertex_tetrahedra_count(const mgdt_triangulation *t);

MGDT_API mgdt_status mgdt_get_tetrahedra(const mgdt_triangulation *t, int64_t capacity, int64_t *v);

MGDT_API mgdt_status mgdt_get_tetrahedra_i32(const mgdt_triangulation *t, int64_t capacity,
                                             int32_t *v);

MGDT_API mgdt_status mgdt_get_neighbors(const mgdt_triangulation *t, int64_t capacity, int64_t *v);

MGDT_API mgdt_status mgdt_get_neighbors_i32(const mgdt_triangulation *t, int64_t capacity,
                                            int32_t *v);

MGDT_API mgdt_status mgdt_get_hull_facets(const mgdt_triangulation *t, int64_t capacity,
                                          int64_t *v);

MGDT_API mgdt_status mgdt_get_hull_facets_i32(const mgdt_triangulation *t, int64_t capacity,
                                              int32_t *v);

MGDT_API mgdt_status mgdt_get_edges(const mgdt_triangulation *t, int64_t capacity, int64_t *v);

MGDT_API mgdt_status mgdt_get_edges_i32(const mgdt_triangulation *t, int64_t capacity, int32_t *v);

MGDT_API mgdt_status mgdt_get_point_map(const mgdt_triangulation *t, int64_t capacity, int64_t *v);

MGDT_API mgdt_status mgdt_get_point_map_i32(const mgdt_triangulation *t, int64_t capacity,
                                            int32_t *v);

MGDT_API mgdt_status mgdt_get_vertex_tetrahedra(const mgdt_triangulation *t,
                                                int64_t offset_capacity, int64_t *offsets,
                                                int64_t capacity, int64_t *list);

MGDT_API mgdt_status mgdt_get_vertex_tetrahedra_i32(const mgdt_triangulation *t,
                                                    int64_t offset_capacity, int32_t *offsets,
                                                    int64_t capacity, int32_t *list);

MGDT_API mgdt_status mgdt_locate(const mgdt_triangulation *t, const double *xyz,
                                 int64_t *tetrahedron);

MGDT_API mgdt_status mgdt_locate_points(const mgdt_triangulation *t, int64_t n, const double *xyz,
                                        int64_t *tetrahedra, double *weights);

MGDT_API mgdt_status mgdt_locate_points_i32(const mgdt_triangulation *t, int64_t n,
                                            const double *xyz, int32_t *tetrahedra,
                                            double *weights);

MGDT_API mgdt_status mgdt_nearest_vertex(const mgdt_triangulation *t, const double *xyz,
                                         int64_t *vertex);

MGDT_API mgdt_status mgdt_check(const mgdt_triangulation *t, int32_t level);

MGDT_API mgdt_status mgdt_get_stat(const mgdt_triangulation *t, int32_t key, double *value);

MGDT_API const char *mgdt_stat_name(int32_t key);

MGDT_API const char *mgdt_status_string(mgdt_status s);

MGDT_API mgdt_status mgdt_get_error(const mgdt_triangulation *t, int64_t capacity, char *buffer);

MGDT_API const char *mgdt_order_scheme_name(int32_t scheme);

MGDT_API mgdt_status mgdt_order_scheme_from_name(const char *name, int32_t *scheme);

MGDT_API const char *mgdt_version_string(void);

MGDT_API int32_t mgdt_abi_version(void);

MGDT_API const char *mgdt_isa_name(const mgdt_triangulation *t);

#ifdef __cplusplus
}
#endif

#endif
