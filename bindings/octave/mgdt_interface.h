/* SPDX-License-Identifier: MIT
 * Generated from the headers of mgdt by bindings/interface/generate.py. */
#ifndef MGDT_OCTAVE_INTERFACE_H
#define MGDT_OCTAVE_INTERFACE_H

/* Every function, by the name that it has after "mgdt_". */
#define MGDT_FUNCTIONS(F)              \
    F(create);                         \
    F(create_with_allocator);          \
    F(destroy);                        \
    F(clear);                          \
    F(reserve);                        \
    F(shrink);                         \
    F(set_order_scheme);               \
    F(get_order_scheme);               \
    F(set_order_parameter);            \
    F(get_order_parameter);            \
    F(set_seed);                       \
    F(get_seed);                       \
    F(set_threads);                    \
    F(get_threads);                    \
    F(set_index_base);                 \
    F(get_index_base);                 \
    F(set_memory_limit);               \
    F(get_memory_limit);               \
    F(set_compact);                    \
    F(get_compact);                    \
    F(set_progress);                   \
    F(get_progress);                   \
    F(cancel);                         \
    F(set_read_progress);              \
    F(get_read_progress);              \
    F(set_canonical_output);           \
    F(get_canonical_output);           \
    F(set_isa);                        \
    F(insert_points);                  \
    F(insert_points_strided);          \
    F(remove_points);                  \
    F(remove_points_i32);              \
    F(move_points);                    \
    F(move_points_i32);                \
    F(renumber_points);                \
    F(renumber_points_i32);            \
    F(point_count);                    \
    F(vertex_count);                   \
    F(dimension);                      \
    F(tetrahedron_count);              \
    F(hull_facet_count);               \
    F(edge_count);                     \
    F(vertex_tetrahedra_count);        \
    F(vertex_neighbors_count);         \
    F(get_tetrahedra);                 \
    F(get_tetrahedra_i32);             \
    F(get_neighbors);                  \
    F(get_neighbors_i32);              \
    F(get_hull_facets);                \
    F(get_hull_facets_i32);            \
    F(get_edges);                      \
    F(get_edges_i32);                  \
    F(get_point_map);                  \
    F(get_point_map_i32);              \
    F(get_vertex_tetrahedra);          \
    F(get_vertex_tetrahedra_i32);      \
    F(get_vertex_neighbors);           \
    F(get_vertex_neighbors_i32);       \
    F(get_gabriel_edges);              \
    F(get_gabriel_edges_i32);          \
    F(get_spanning_tree);              \
    F(get_spanning_tree_i32);          \
    F(get_circumcenters);              \
    F(get_tetrahedron_measures);       \
    F(get_cell_measures);              \
    F(get_alphas);                     \
    F(get_alpha_surface);              \
    F(get_alpha_surface_i32);          \
    F(get_solid_alpha);                \
    F(locate);                         \
    F(locate_i32);                     \
    F(locate_points);                  \
    F(locate_points_i32);              \
    F(traverse_segment);               \
    F(traverse_segment_i32);           \
    F(nearest_vertex);                 \
    F(nearest_vertex_i32);             \
    F(nearest_vertices);               \
    F(nearest_vertices_i32);           \
    F(interpolate);                    \
    F(get_interpolation_weights);      \
    F(get_interpolation_weights_i32);  \
    F(get_gradients);                  \
    F(check);                          \
    F(get_stat);                       \
    F(stat_name);                      \
    F(status_string);                  \
    F(get_error);                      \
    F(order_scheme_name);              \
    F(order_scheme_from_name);         \
    F(order_scheme_at);                \
    F(version_string);                 \
    F(abi_version);                    \
    F(isa_name);                       \
    F(voronoi_create);                 \
    F(voronoi_destroy);                \
    F(voronoi_get_stat);               \
    F(voronoi_array_info);             \
    F(voronoi_get_size);               \
    F(voronoi_get_array);              \
    F(voronoi_get_array_i32);          \
    F(voronoi_get_doubles);            \
    F(voronoi_drop_small_faces);       \
    F(voronoi_get_error);              \
    F(mesh_create);                    \
    F(mesh_create_with_allocator);     \
    F(mesh_destroy);                   \
    F(mesh_set_option);                \
    F(mesh_get_option);                \
    F(mesh_set_double_option);         \
    F(mesh_get_double_option);         \
    F(mesh_set_progress);              \
    F(mesh_get_progress);              \
    F(mesh_cancel);                    \
    F(mesh_set_points);                \
    F(mesh_set_tetrahedra);            \
    F(mesh_set_tetrahedra_i32);        \
    F(mesh_set_faces);                 \
    F(mesh_set_faces_i32);             \
    F(mesh_set_edges);                 \
    F(mesh_set_edges_i32);             \
    F(mesh_set_fixed_points);          \
    F(mesh_set_fixed_points_i32);      \
    F(mesh_set_sizes);                 \
    F(mesh_set_size_field);            \
    F(mesh_set_size_function);         \
    F(mesh_get_size_function);         \
    F(mesh_build);                     \
    F(mesh_refine);                    \
    F(mesh_improve);                   \
    F(mesh_get_stat);                  \
    F(mesh_array_info);                \
    F(mesh_get_size);                  \
    F(mesh_get_array);                 \
    F(mesh_get_array_i32);             \
    F(mesh_get_doubles);               \
    F(mesh_get_tetrahedron_measures);  \
    F(mesh_get_shape_summary);         \
    F(mesh_locate_points);             \
    F(mesh_locate_points_i32);         \
    F(mesh_interpolate);               \
    F(mesh_check);                     \
    F(mesh_get_error);                 \
    F(domain_create);                  \
    F(domain_create_with_allocator);   \
    F(domain_destroy);                 \
    F(domain_clear);                   \
    F(domain_set_option);              \
    F(domain_get_option);              \
    F(domain_set_double_option);       \
    F(domain_get_double_option);       \
    F(domain_set_progress);            \
    F(domain_get_progress);            \
    F(domain_cancel);                  \
    F(domain_set_points);              \
    F(domain_set_facets);              \
    F(domain_set_facets_i32);          \
    F(domain_set_segments);            \
    F(domain_set_segments_i32);        \
    F(domain_set_regions);             \
    F(domain_set_holes);               \
    F(domain_clean);                   \
    F(domain_validate);                \
    F(domain_build);                   \
    F(domain_check);                   \
    F(domain_get_stat);                \
    F(domain_array_info);              \
    F(domain_get_size);                \
    F(domain_get_array);               \
    F(domain_get_array_i32);           \
    F(domain_get_doubles);             \
    F(domain_get_error);               \
    F(periodic_create);                \
    F(periodic_create_with_allocator); \
    F(periodic_destroy);               \
    F(periodic_clear);                 \
    F(periodic_set_vectors);           \
    F(periodic_set_option);            \
    F(periodic_get_option);            \
    F(periodic_set_merge_distance);    \
    F(periodic_get_merge_distance);    \
    F(periodic_set_progress);          \
    F(periodic_get_progress);          \
    F(periodic_cancel);                \
    F(periodic_insert_points);         \
    F(periodic_move_points);           \
    F(periodic_move_points_i32);       \
    F(periodic_build);                 \
    F(periodic_check);                 \
    F(periodic_get_stat);              \
    F(periodic_array_info);            \
    F(periodic_get_size);              \
    F(periodic_get_array);             \
    F(periodic_get_array_i32);         \
    F(periodic_get_doubles);           \
    F(periodic_get_cell_measures);     \
    F(periodic_create_voronoi);        \
    F(periodic_get_error);

/* Every error, by its name after "MGDT_ERR_", large and small. */
#define MGDT_ERRORS(E)                    \
    E(NULL_POINTER, null_pointer)         \
    E(INVALID_ARGUMENT, invalid_argument) \
    E(NOT_FINITE, not_finite)             \
    E(UNKNOWN_SCHEME, unknown_scheme)     \
    E(UNKNOWN_KEY, unknown_key)           \
    E(NOT_BUILT, not_built)               \
    E(BUFFER_TOO_SMALL, buffer_too_small) \
    E(INDEX_RANGE, index_range)           \
    E(OUT_OF_MEMORY, out_of_memory)       \
    E(TOO_LARGE, too_large)               \
    E(CANCELLED, cancelled)               \
    E(BUSY, busy)                         \
    E(TRANSPORT, transport)               \
    E(CHECK_FAILED, check_failed)         \
    E(INVALID_BOUNDARY, invalid_boundary) \
    E(RESOLUTION, resolution)             \
    E(OPEN_BOUNDARY, open_boundary)       \
    E(INTERNAL, internal)

#endif /* MGDT_OCTAVE_INTERFACE_H */
