-- SPDX-License-Identifier: MIT
-- Generated from the headers of mgdt by bindings/interface/generate.py.
--- The C interface of mgdt, declared.

require("ffi").cdef [[
typedef struct mgdt_triangulation mgdt_triangulation;
typedef struct mgdt_voronoi mgdt_voronoi;
typedef struct mgdt_mesh mgdt_mesh;
typedef struct mgdt_domain mgdt_domain;
typedef struct mgdt_periodic mgdt_periodic;
typedef void *(*mgdt_alloc_fn)(size_t size, size_t align, void *user);
typedef void (*mgdt_free_fn)(void *p, size_t size, size_t align, void *user);
typedef int32_t (*mgdt_progress_fn)(double fraction, void *user);
typedef int32_t (*mgdt_size_fn)(int64_t n, const double *xyz, double *sizes, void *user);
int32_t mgdt_create(mgdt_triangulation **out);
int32_t mgdt_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release, void *user,
                                   mgdt_triangulation **out);
void mgdt_destroy(mgdt_triangulation *t);
int32_t mgdt_clear(mgdt_triangulation *t);
int32_t mgdt_reserve(mgdt_triangulation *t, int64_t n_points);
int32_t mgdt_shrink(mgdt_triangulation *t);
int32_t mgdt_set_order_scheme(mgdt_triangulation *t, int32_t scheme);
int32_t mgdt_get_order_scheme(const mgdt_triangulation *t, int32_t *scheme);
int32_t mgdt_set_order_parameter(mgdt_triangulation *t, int32_t key, double value);
int32_t mgdt_get_order_parameter(const mgdt_triangulation *t, int32_t key, double *value);
int32_t mgdt_set_seed(mgdt_triangulation *t, uint64_t seed);
int32_t mgdt_get_seed(const mgdt_triangulation *t, uint64_t *seed);
int32_t mgdt_set_threads(mgdt_triangulation *t, int32_t n);
int32_t mgdt_get_threads(const mgdt_triangulation *t, int32_t *n);
int32_t mgdt_set_index_base(mgdt_triangulation *t, int32_t base);
int32_t mgdt_get_index_base(const mgdt_triangulation *t, int32_t *base);
int32_t mgdt_set_memory_limit(mgdt_triangulation *t, int64_t bytes);
int32_t mgdt_get_memory_limit(const mgdt_triangulation *t, int64_t *bytes);
int32_t mgdt_set_compact(mgdt_triangulation *t, int32_t on);
int32_t mgdt_get_compact(const mgdt_triangulation *t, int32_t *on);
int32_t mgdt_set_progress(mgdt_triangulation *t, mgdt_progress_fn fn, void *user);
int32_t mgdt_get_progress(const mgdt_triangulation *t, mgdt_progress_fn *fn, void **user);
int32_t mgdt_cancel(mgdt_triangulation *t);
int32_t mgdt_set_read_progress(mgdt_triangulation *t, int32_t on);
int32_t mgdt_get_read_progress(const mgdt_triangulation *t, int32_t *on);
int32_t mgdt_set_canonical_output(mgdt_triangulation *t, int32_t on);
int32_t mgdt_get_canonical_output(const mgdt_triangulation *t, int32_t *on);
int32_t mgdt_set_isa(mgdt_triangulation *t, const char *name);
int32_t mgdt_insert_points(mgdt_triangulation *t, int64_t n, const double *xyz);
int32_t mgdt_insert_points_strided(mgdt_triangulation *t, int64_t n, const double *x,
                                   const double *y, const double *z, int64_t stride);
int32_t mgdt_remove_points(mgdt_triangulation *t, int64_t n, const int64_t *points);
int32_t mgdt_remove_points_i32(mgdt_triangulation *t, int64_t n, const int32_t *points);
int32_t mgdt_move_points(mgdt_triangulation *t, int64_t n, const int64_t *points,
                         const double *xyz);
int32_t mgdt_move_points_i32(mgdt_triangulation *t, int64_t n, const int32_t *points,
                             const double *xyz);
int32_t mgdt_renumber_points(mgdt_triangulation *t, int64_t capacity, int64_t *new_index);
int32_t mgdt_renumber_points_i32(mgdt_triangulation *t, int64_t capacity, int32_t *new_index);
int64_t mgdt_point_count(const mgdt_triangulation *t);
int64_t mgdt_vertex_count(const mgdt_triangulation *t);
int32_t mgdt_dimension(const mgdt_triangulation *t);
int64_t mgdt_tetrahedron_count(const mgdt_triangulation *t);
int64_t mgdt_hull_facet_count(const mgdt_triangulation *t);
int64_t mgdt_edge_count(const mgdt_triangulation *t);
int64_t mgdt_vertex_tetrahedra_count(const mgdt_triangulation *t);
int64_t mgdt_vertex_neighbors_count(const mgdt_triangulation *t);
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
int32_t mgdt_get_vertex_neighbors(const mgdt_triangulation *t, int64_t offset_capacity,
                                  int64_t *offsets, int64_t capacity, int64_t *list);
int32_t mgdt_get_vertex_neighbors_i32(const mgdt_triangulation *t, int64_t offset_capacity,
                                      int32_t *offsets, int64_t capacity, int32_t *list);
int32_t mgdt_get_gabriel_edges(const mgdt_triangulation *t, int64_t capacity, int64_t *v,
                               int64_t *count);
int32_t mgdt_get_gabriel_edges_i32(const mgdt_triangulation *t, int64_t capacity, int32_t *v,
                                   int32_t *count);
int32_t mgdt_get_spanning_tree(const mgdt_triangulation *t, int64_t capacity, int64_t *v,
                               int64_t *count);
int32_t mgdt_get_spanning_tree_i32(const mgdt_triangulation *t, int64_t capacity, int32_t *v,
                                   int32_t *count);
int32_t mgdt_get_circumcenters(const mgdt_triangulation *t, int64_t capacity, double *xyz,
                               double *radius2);
int32_t mgdt_get_tetrahedron_measures(const mgdt_triangulation *t, int32_t measure,
                                      int64_t capacity, double *x);
int32_t mgdt_get_cell_measures(const mgdt_triangulation *t, int32_t measure, int64_t n_planes,
                               const double *planes, int64_t capacity, double *x);
int32_t mgdt_get_alphas(const mgdt_triangulation *t, int32_t dimension, int64_t capacity,
                        double *alpha2);
int32_t mgdt_get_alpha_surface(const mgdt_triangulation *t, double alpha2, int64_t capacity,
                               int64_t *v, int64_t *count);
int32_t mgdt_get_alpha_surface_i32(const mgdt_triangulation *t, double alpha2, int64_t capacity,
                                   int32_t *v, int32_t *count);
int32_t mgdt_get_solid_alpha(const mgdt_triangulation *t, double *alpha2);
int32_t mgdt_locate(const mgdt_triangulation *t, const double *xyz, int64_t *tetrahedron);
int32_t mgdt_locate_i32(const mgdt_triangulation *t, const double *xyz, int32_t *tetrahedron);
int32_t mgdt_locate_points(const mgdt_triangulation *t, int64_t n, const double *xyz,
                           int64_t *tetrahedra, double *weights);
int32_t mgdt_locate_points_i32(const mgdt_triangulation *t, int64_t n, const double *xyz,
                               int32_t *tetrahedra, double *weights);
int32_t mgdt_traverse_segment(const mgdt_triangulation *t, const double *a, const double *b,
                              int64_t capacity, int64_t *tetrahedra, double *parameters,
                              int64_t *count);
int32_t mgdt_traverse_segment_i32(const mgdt_triangulation *t, const double *a, const double *b,
                                  int64_t capacity, int32_t *tetrahedra, double *parameters,
                                  int32_t *count);
int32_t mgdt_nearest_vertex(const mgdt_triangulation *t, const double *xyz, int64_t *vertex);
int32_t mgdt_nearest_vertex_i32(const mgdt_triangulation *t, const double *xyz, int32_t *vertex);
int32_t mgdt_nearest_vertices(const mgdt_triangulation *t, int64_t n, const double *xyz,
                              int64_t *vertices);
int32_t mgdt_nearest_vertices_i32(const mgdt_triangulation *t, int64_t n, const double *xyz,
                                  int32_t *vertices);
int32_t mgdt_interpolate(const mgdt_triangulation *t, int32_t method, int32_t outside,
                         int64_t n_fields, const double *values, int64_t n, const double *xyz,
                         double *out);
int32_t mgdt_get_interpolation_weights(const mgdt_triangulation *t, int32_t method,
                                       int32_t outside, int64_t n, const double *xyz,
                                       int64_t offset_capacity, int64_t *offsets, int64_t capacity,
                                       int64_t *points, double *weights);
int32_t mgdt_get_interpolation_weights_i32(const mgdt_triangulation *t, int32_t method,
                                           int32_t outside, int64_t n, const double *xyz,
                                           int64_t offset_capacity, int32_t *offsets,
                                           int64_t capacity, int32_t *points, double *weights);
int32_t mgdt_get_gradients(const mgdt_triangulation *t, int64_t n_fields, const double *values,
                           double *out);
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
int32_t mgdt_voronoi_create(const mgdt_triangulation *t, int64_t n_planes, const double *planes,
                            mgdt_voronoi **out);
void mgdt_voronoi_destroy(mgdt_voronoi *v);
int32_t mgdt_voronoi_get_stat(const mgdt_voronoi *v, int32_t key, int64_t *value);
int32_t mgdt_voronoi_array_info(int32_t array, int32_t *columns, int32_t *is_double);
int32_t mgdt_voronoi_get_size(const mgdt_voronoi *v, int32_t array, int64_t *size);
int32_t mgdt_voronoi_get_array(const mgdt_voronoi *v, int32_t array, int64_t capacity,
                               int64_t *values);
int32_t mgdt_voronoi_get_array_i32(const mgdt_voronoi *v, int32_t array, int64_t capacity,
                                   int32_t *values);
int32_t mgdt_voronoi_get_doubles(const mgdt_voronoi *v, int32_t array, int64_t capacity,
                                 double *values);
int32_t mgdt_voronoi_drop_small_faces(mgdt_voronoi *v, double least_area, double least_share);
int32_t mgdt_voronoi_get_error(const mgdt_voronoi *v, int64_t capacity, char *buffer);
int32_t mgdt_mesh_create(mgdt_mesh **out);
int32_t mgdt_mesh_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release, void *user,
                                        mgdt_mesh **out);
void mgdt_mesh_destroy(mgdt_mesh *m);
int32_t mgdt_mesh_set_option(mgdt_mesh *m, int32_t option, int64_t value);
int32_t mgdt_mesh_get_option(const mgdt_mesh *m, int32_t option, int64_t *value);
int32_t mgdt_mesh_set_double_option(mgdt_mesh *m, int32_t option, double value);
int32_t mgdt_mesh_get_double_option(const mgdt_mesh *m, int32_t option, double *value);
int32_t mgdt_mesh_set_progress(mgdt_mesh *m, mgdt_progress_fn fn, void *user);
int32_t mgdt_mesh_get_progress(const mgdt_mesh *m, mgdt_progress_fn *fn, void **user);
int32_t mgdt_mesh_cancel(mgdt_mesh *m);
int32_t mgdt_mesh_set_points(mgdt_mesh *m, int64_t n, const double *xyz);
int32_t mgdt_mesh_set_tetrahedra(mgdt_mesh *m, int64_t n, const int64_t *corners,
                                 const int32_t *markers);
int32_t mgdt_mesh_set_tetrahedra_i32(mgdt_mesh *m, int64_t n, const int32_t *corners,
                                     const int32_t *markers);
int32_t mgdt_mesh_set_faces(mgdt_mesh *m, int64_t n, const int64_t *corners,
                            const int32_t *markers);
int32_t mgdt_mesh_set_faces_i32(mgdt_mesh *m, int64_t n, const int32_t *corners,
                                const int32_t *markers);
int32_t mgdt_mesh_set_edges(mgdt_mesh *m, int64_t n, const int64_t *ends, const int32_t *markers);
int32_t mgdt_mesh_set_edges_i32(mgdt_mesh *m, int64_t n, const int32_t *ends,
                                const int32_t *markers);
int32_t mgdt_mesh_set_fixed_points(mgdt_mesh *m, int64_t n, const int64_t *points);
int32_t mgdt_mesh_set_fixed_points_i32(mgdt_mesh *m, int64_t n, const int32_t *points);
int32_t mgdt_mesh_set_sizes(mgdt_mesh *m, int32_t of, int64_t n, const double *sizes);
int32_t mgdt_mesh_set_size_field(mgdt_mesh *m, int64_t n, const double *xyz, const double *sizes);
int32_t mgdt_mesh_set_size_function(mgdt_mesh *m, mgdt_size_fn fn, void *user);
int32_t mgdt_mesh_get_size_function(const mgdt_mesh *m, mgdt_size_fn *fn, void **user);
int32_t mgdt_mesh_build(mgdt_mesh *m);
int32_t mgdt_mesh_refine(mgdt_mesh *m);
int32_t mgdt_mesh_improve(mgdt_mesh *m);
int32_t mgdt_mesh_get_stat(const mgdt_mesh *m, int32_t key, int64_t *value);
int32_t mgdt_mesh_array_info(int32_t array, int32_t *columns, int32_t *is_double);
int32_t mgdt_mesh_get_size(const mgdt_mesh *m, int32_t array, int64_t *size);
int32_t mgdt_mesh_get_array(const mgdt_mesh *m, int32_t array, int64_t capacity, int64_t *values);
int32_t mgdt_mesh_get_array_i32(const mgdt_mesh *m, int32_t array, int64_t capacity,
                                int32_t *values);
int32_t mgdt_mesh_get_doubles(const mgdt_mesh *m, int32_t array, int64_t capacity, double *values);
int32_t mgdt_mesh_get_tetrahedron_measures(const mgdt_mesh *m, int32_t measure, int64_t capacity,
                                           double *x);
int32_t mgdt_mesh_get_shape_summary(const mgdt_mesh *m, double *shapes, int64_t *angles,
                                    int64_t *tetrahedra_below);
int32_t mgdt_mesh_locate_points(const mgdt_mesh *m, int32_t outside, int64_t n, const double *xyz,
                                int64_t *tetrahedra, double *weights);
int32_t mgdt_mesh_locate_points_i32(const mgdt_mesh *m, int32_t outside, int64_t n,
                                    const double *xyz, int32_t *tetrahedra, double *weights);
int32_t mgdt_mesh_interpolate(const mgdt_mesh *m, int32_t outside, int64_t n_fields,
                              const double *values, int64_t n, const double *xyz, double *out);
int32_t mgdt_mesh_check(const mgdt_mesh *m);
int32_t mgdt_mesh_get_error(const mgdt_mesh *m, int64_t capacity, char *buffer);
int32_t mgdt_domain_create(mgdt_domain **out);
int32_t mgdt_domain_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release, void *user,
                                          mgdt_domain **out);
void mgdt_domain_destroy(mgdt_domain *d);
int32_t mgdt_domain_clear(mgdt_domain *d);
int32_t mgdt_domain_set_option(mgdt_domain *d, int32_t option, int64_t value);
int32_t mgdt_domain_get_option(const mgdt_domain *d, int32_t option, int64_t *value);
int32_t mgdt_domain_set_double_option(mgdt_domain *d, int32_t option, double value);
int32_t mgdt_domain_get_double_option(const mgdt_domain *d, int32_t option, double *value);
int32_t mgdt_domain_set_progress(mgdt_domain *d, mgdt_progress_fn fn, void *user);
int32_t mgdt_domain_get_progress(const mgdt_domain *d, mgdt_progress_fn *fn, void **user);
int32_t mgdt_domain_cancel(mgdt_domain *d);
int32_t mgdt_domain_set_points(mgdt_domain *d, int64_t n, const double *xyz);
int32_t mgdt_domain_set_facets(mgdt_domain *d, int64_t n, const int64_t *offsets,
                               const int64_t *corners, const int32_t *markers);
int32_t mgdt_domain_set_facets_i32(mgdt_domain *d, int64_t n, const int32_t *offsets,
                                   const int32_t *corners, const int32_t *markers);
int32_t mgdt_domain_set_segments(mgdt_domain *d, int64_t n, const int64_t *ends,
                                 const int32_t *markers);
int32_t mgdt_domain_set_segments_i32(mgdt_domain *d, int64_t n, const int32_t *ends,
                                     const int32_t *markers);
int32_t mgdt_domain_set_regions(mgdt_domain *d, int64_t n, const double *xyz,
                                const int32_t *markers);
int32_t mgdt_domain_set_holes(mgdt_domain *d, int64_t n, const double *xyz);
int32_t mgdt_domain_clean(mgdt_domain *d);
int32_t mgdt_domain_validate(mgdt_domain *d);
int32_t mgdt_domain_build(mgdt_domain *d, mgdt_mesh **out);
int32_t mgdt_domain_check(const mgdt_domain *d, const mgdt_mesh *mesh);
int32_t mgdt_domain_get_stat(const mgdt_domain *d, int32_t key, int64_t *value);
int32_t mgdt_domain_array_info(int32_t array, int32_t *columns, int32_t *is_double);
int32_t mgdt_domain_get_size(const mgdt_domain *d, int32_t array, int64_t *size);
int32_t mgdt_domain_get_array(const mgdt_domain *d, int32_t array, int64_t capacity,
                              int64_t *values);
int32_t mgdt_domain_get_array_i32(const mgdt_domain *d, int32_t array, int64_t capacity,
                                  int32_t *values);
int32_t mgdt_domain_get_doubles(const mgdt_domain *d, int32_t array, int64_t capacity,
                                double *values);
int32_t mgdt_domain_get_error(const mgdt_domain *d, int64_t capacity, char *buffer);
int32_t mgdt_periodic_create(mgdt_periodic **out);
int32_t mgdt_periodic_create_with_allocator(mgdt_alloc_fn alloc, mgdt_free_fn release, void *user,
                                            mgdt_periodic **out);
void mgdt_periodic_destroy(mgdt_periodic *p);
int32_t mgdt_periodic_clear(mgdt_periodic *p);
int32_t mgdt_periodic_set_vectors(mgdt_periodic *p, int32_t dimensions, const double *vectors);
int32_t mgdt_periodic_set_option(mgdt_periodic *p, int32_t option, int64_t value);
int32_t mgdt_periodic_get_option(const mgdt_periodic *p, int32_t option, int64_t *value);
int32_t mgdt_periodic_set_merge_distance(mgdt_periodic *p, double distance);
int32_t mgdt_periodic_get_merge_distance(const mgdt_periodic *p, double *distance);
int32_t mgdt_periodic_set_progress(mgdt_periodic *p, mgdt_progress_fn fn, void *user);
int32_t mgdt_periodic_get_progress(const mgdt_periodic *p, mgdt_progress_fn *fn, void **user);
int32_t mgdt_periodic_cancel(mgdt_periodic *p);
int32_t mgdt_periodic_insert_points(mgdt_periodic *p, int64_t n, const double *xyz);
int32_t mgdt_periodic_move_points(mgdt_periodic *p, int64_t n, const int64_t *points,
                                  const double *xyz);
int32_t mgdt_periodic_move_points_i32(mgdt_periodic *p, int64_t n, const int32_t *points,
                                      const double *xyz);
int32_t mgdt_periodic_build(mgdt_periodic *p);
int32_t mgdt_periodic_check(const mgdt_periodic *p);
int32_t mgdt_periodic_get_stat(const mgdt_periodic *p, int32_t key, int64_t *value);
int32_t mgdt_periodic_array_info(int32_t array, int32_t *columns, int32_t *is_double);
int32_t mgdt_periodic_get_size(const mgdt_periodic *p, int32_t array, int64_t *size);
int32_t mgdt_periodic_get_array(const mgdt_periodic *p, int32_t array, int64_t capacity,
                                int64_t *values);
int32_t mgdt_periodic_get_array_i32(const mgdt_periodic *p, int32_t array, int64_t capacity,
                                    int32_t *values);
int32_t mgdt_periodic_get_doubles(const mgdt_periodic *p, int32_t array, int64_t capacity,
                                  double *values);
int32_t mgdt_periodic_get_cell_measures(const mgdt_periodic *p, int32_t measure, int64_t capacity,
                                        double *x);
int32_t mgdt_periodic_create_voronoi(const mgdt_periodic *p, mgdt_voronoi **out);
int32_t mgdt_periodic_get_error(const mgdt_periodic *p, int64_t capacity, char *buffer);
]]

return {
    status = { ok = 0, null_pointer = 10, invalid_argument = 11, not_finite = 12,
        unknown_scheme = 13, unknown_key = 14, not_built = 15, buffer_too_small = 20,
        index_range = 21, out_of_memory = 30, too_large = 31, cancelled = 40, busy = 41,
        transport = 50, check_failed = 60, invalid_boundary = 70, resolution = 71,
        open_boundary = 72, internal = 90 },
    order = { auto = 0, input = 10, random = 20, lexicographic = 30, brio = 40, hilbert = 50,
        regular_grid = 60, kd_tree = 70, enhanced_kd_tree = 80, multi_grid = 90 },
    parameter = { points_per_cell = 10, threshold = 20, separation = 30, round_ratio = 40 },
    separation = { none = 0, passes = 1, rounds = 2 },
    statistic = { points_inserted = 10, duplicates = 11, points_removed = 12, points_moved = 13,
        put_back = 14, rebuilds = 15, walk_steps = 20, walk_tests = 21, conflict_tests = 22,
        tetrahedra_removed = 30, tetrahedra_created = 31, link_vertices = 32, exact_calls = 40,
        put_off = 45, inserted_alone = 46, order_seconds = 50, insert_seconds = 51,
        remove_seconds = 52, move_seconds = 53, grid_levels = 60, rounds = 61, threads = 62,
        memory_bytes = 70, peak_memory_bytes = 71 },
    check = { combinatorial = 1, geometric = 2, canonical = 3 },
    measure = { volume = 10, area = 20, centroid = 30, faces = 40 },
    tetrahedron = { volume = 10, radius_ratio = 20, volume_length = 21, edge_ratio = 22,
        least_dihedral_angle = 30, largest_dihedral_angle = 31, longest_edge = 40 },
    method = { linear = 10, nearest = 20, sibson = 30, laplace = 40, sibson_c1 = 50 },
    outside = { none = 10, nearest = 20, boundary = 30, linear = 40 },
    voronoi_stat = { vertices = 100, rays = 101, faces = 102, points = 103, memory_bytes = 110 },
    voronoi_array = { face_offsets = 200, face_corners = 201, face_sides = 202, face_shifts = 203,
        ray_vertices = 210, cell_offsets = 220, cell_faces = 221, cell_bounded = 222,
        cell_neighbors = 223, cell_neighbor_shifts = 224, vertices = 300, ray_directions = 310,
        face_areas = 320, face_normals = 321, face_centroids = 322, cell_volumes = 330,
        cell_centroids = 331, cell_face_areas = 332, cell_neighbor_distances = 333 },
    mesh_option = { index_base = 10, threads = 20, memory_limit = 30, goal = 40, boundary = 41,
        points = 42, mean_passes = 43, most_passes = 44, most_points = 45, sizes_of_surface = 46,
        size = 61, gradation = 62, radius_edge = 63, volume = 64 },
    sizes = { of_points = 0, of_tetrahedra = 1, of_regions = 2 },
    boundary = { fixed = 0, slide = 1 },
    points = { keep = 0, move = 1, remove = 2 },
    mesh_stat = { points = 100, steiner_points = 101, tetrahedra = 102, regions = 103, faces = 104,
        edges = 105, memory_bytes = 110, is_rounded = 120, is_delaunay = 122, is_of_domain = 123,
        keeps_boundary = 124, grid_bits = 121, unused_points = 130, unused_faces = 131,
        unused_regions = 132, unused_holes = 133, planar_facets = 140, missing_facets = 141,
        cavities = 142, largest_cavity = 143, below_goal = 150, passes = 151, moved_points = 152,
        removed_points = 153, inserted_points = 160, refused = 161 },
    refusal = { none = 0, hidden = 1, near_point = 2, near_facet = 3, no_cavity = 4,
        most_points = 5 },
    reason = { none = 0, input_angle = 1, thin_face = 2, fixed_corners = 3, other = 4 },
    mesh_array = { point_origins = 200, tetrahedra = 210, neighbors = 211,
        tetrahedron_regions = 212, region_markers = 220, faces = 230, face_tetrahedra = 231,
        face_facets = 232, face_markers = 233, edges = 240, edge_segments = 241, edge_markers = 242,
        steiner_edges = 250, reasons = 260, angle_histogram = 261, tetrahedra_below = 262,
        refusals = 270, points = 300, steiner_parameters = 310, shapes = 320, sizes = 330 },
    domain_kind = { facet = 0, segment = 1, point = 2 },
    domain_option = { index_base = 10, threads = 20, memory_limit = 30, round_points = 40,
        strict = 50, keep_boundary = 60, weld = 70, flatness = 80 },
    domain_stat = { points = 100, facets = 101, segments = 102, regions = 103, holes = 104,
        memory_bytes = 110, offending_pairs = 120, open_edges = 121, moved_points = 130,
        repeated_corners = 131, collapsed_facets = 132, covered_facets = 133, points_in_edges = 134,
        points_in_facets = 135, edges_in_facets = 136, exchanged_edges = 137 },
    domain_array = { offending_pairs = 200, open_edges = 210, facet_offsets = 220,
        facet_corners = 221, facet_markers = 222, facet_origins = 223, covered_facets = 224,
        segments = 230, segment_markers = 231, segment_origins = 232, points = 300 },
    periodic_option = { index_base = 10, threads = 20, memory_limit = 30 },
    periodic_stat = { points = 100, vertices = 101, tetrahedra = 102, edges = 103, dimensions = 104,
        memory_bytes = 110, images = 120, rounds = 121 },
    periodic_array = { point_map = 200, point_shifts = 201, tetrahedra = 210,
        tetrahedron_shifts = 211, neighbors = 212, neighbor_shifts = 213,
        vertex_neighbor_offsets = 220, vertex_neighbors = 221, vertex_neighbor_shifts = 222,
        points = 300, vectors = 301 },
}
