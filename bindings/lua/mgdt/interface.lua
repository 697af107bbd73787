-- SPDX-License-Identifier: MIT
-- Generated from mgdt/mgdt.h by bindings/interface/generate.py.
--- The C interface of mgdt, declared.

require("ffi").cdef [[
typedef struct mgdt_triangulation mgdt_triangulation;
typedef void *(*mgdt_alloc_fn)(size_t size, size_t align, void *user);
typedef void (*mgdt_free_fn)(void *p, size_t size, size_t align, void *user);
typedef int32_t (*mgdt_progress_fn)(double fraction, void *user);
int32_t mgdt_create(mgdt_triangulation **out);
int32_t mgdt_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release, void *user,
                                   mgdt_triangulation **out);
void mgdt_destroy(mgdt_triangulation *t);
int32_t mgdt_clear(mgdt_triangulation *t);
int32_t mgdt_reserve(mgdt_triangulation *t, int64_t n_points);
int32_t mgdt_set_order_scheme(mgdt_triangulation *t, int32_t scheme);
int32_t mgdt_set_order_parameter(mgdt_triangulation *t, int32_t key, double value);
int32_t mgdt_set_seed(mgdt_triangulation *t, uint64_t seed);
int32_t mgdt_set_threads(mgdt_triangulation *t, int32_t n);
int32_t mgdt_set_index_base(mgdt_triangulation *t, int32_t base);
int32_t mgdt_set_memory_limit(mgdt_triangulation *t, int64_t bytes);
int32_t mgdt_set_compact(mgdt_triangulation *t, int32_t on);
int32_t mgdt_set_progress(mgdt_triangulation *t, mgdt_progress_fn fn, void *user);
int32_t mgdt_cancel(mgdt_triangulation *t);
int32_t mgdt_set_canonical_output(mgdt_triangulation *t, int32_t on);
int32_t mgdt_set_isa(mgdt_triangulation *t, const char *name);
int32_t mgdt_insert_points(mgdt_triangulation *t, int64_t n, const double *xyz);
int32_t mgdt_insert_points_strided(mgdt_triangulation *t, int64_t n, const double *x,
                                   const double *y, const double *z, int64_t stride);
int64_t mgdt_point_count(const mgdt_triangulation *t);
int64_t mgdt_vertex_count(const mgdt_triangulation *t);
int32_t mgdt_dimension(const mgdt_triangulation *t);
int64_t mgdt_tetrahedron_count(const mgdt_triangulation *t);
int64_t mgdt_hull_facet_count(const mgdt_triangulation *t);
int64_t mgdt_edge_count(const mgdt_triangulation *t);
int64_t mgdt_vertex_tetrahedra_count(const mgdt_triangulation *t);
int32_t mgdt_get_tetrahedra(const mgdt_triangulation *t, int64_t capacity, int64_t *v);
int32_t mgdt_get_tetrahedra_i32(const mgdt_triangulation *t, int64_t capacity, int32_t *v);
int32_t mgdt_get_neighbors(const mgdt_triangulation *t, int64_t capacity, int64_t *v);
int32_t mgdt_get_neighbors_i32(const mgdt_triangulation *t, int64_t capacity, int32_t *v);
int32_t mgdt_get_hull_facets(const mgdt_triangulation *t, int64_t capacity, int64_t *v);
int32_t mgdt_get_hull_facets_i32(const mgdt_triangulation *t, int64_t capacity, int32_t *v);
int32_t mgdt_get_edges(const mgdt_triangulation *t, int64_t capacity, int64_t *v);
int32_t mgdt_get_edges_i32(const mgdt_triangulation *t, int64_t capacity, int32_t *v);
int32_t mgdt_get_point_map(const mgdt_triangulation *t, int64_t capacity, int64_t *v);
int32_t mgdt_get_point_map_i32(const mgdt_triangulation *t, int64_t capacity, int32_t *v);
int32_t mgdt_get_vertex_tetrahedra(const mgdt_triangulation *t, int64_t offset_capacity,
                                   int64_t *offsets, int64_t capacity, int64_t *list);
int32_t mgdt_get_vertex_tetrahedra_i32(const mgdt_triangulation *t, int64_t offset_capacity,
                                       int32_t *offsets, int64_t capacity, int32_t *list);
int32_t mgdt_locate(const mgdt_triangulation *t, const double *xyz, int64_t *tetrahedron);
int32_t mgdt_locate_i32(const mgdt_triangulation *t, const double *xyz, int32_t *tetrahedron);
int32_t mgdt_locate_points(const mgdt_triangulation *t, int64_t n, const double *xyz,
                           int64_t *tetrahedra, double *weights);
int32_t mgdt_locate_points_i32(const mgdt_triangulation *t, int64_t n, const double *xyz,
                               int32_t *tetrahedra, double *weights);
int32_t mgdt_nearest_vertex(const mgdt_triangulation *t, const double *xyz, int64_t *vertex);
int32_t mgdt_check(const mgdt_triangulation *t, int32_t level);
int32_t mgdt_get_stat(const mgdt_triangulation *t, int32_t key, double *value);
const char *mgdt_stat_name(int32_t key);
const char *mgdt_status_string(int32_t s);
int32_t mgdt_get_error(const mgdt_triangulation *t, int64_t capacity, char *buffer);
const char *mgdt_order_scheme_name(int32_t scheme);
int32_t mgdt_order_scheme_from_name(const char *name, int32_t *scheme);
int32_t mgdt_order_scheme_at(int32_t index, int32_t *scheme);
const char *mgdt_version_string(void);
int32_t mgdt_abi_version(void);
const char *mgdt_isa_name(const mgdt_triangulation *t);
]]
