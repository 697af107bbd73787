// SPDX-License-Identifier: MIT
// Every function with an output parameter, and what it writes. canary_test.py compares the table
// with the header.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "../property/handle.hpp"

namespace canaries {

struct Wanted {
    std::int64_t elements;
    std::size_t element_size;
    bool has_capacity;
    bool may_be_null;
    bool says_size = false;  // of another array, also where that is too small
};

constexpr std::int64_t queries = 37;
inline const double* query_points() {
    static const std::vector<double> xyz = [] {
        std::vector<double> all(3 * queries);
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = std::fmod(0.618 * static_cast<double>(i), 1.2);
        return all;
    }();
    return xyz.data();
}

// What a call is made with: its output arrays and their capacities.
struct Given {
    void* array[3];
    std::int64_t capacity[3];
};

struct Function {
    const char* name;
    std::vector<Wanted> (*wants)(const mgdt_triangulation*);
    mgdt_status (*call)(mgdt_triangulation*, const Given&);
};

using T = const mgdt_triangulation*;

template <class Int, std::int64_t (*Count)(T), std::int64_t Times>
std::vector<Wanted> of_count(T t) {
    return {{Times * Count(t), sizeof(Int), true, false}};
}
template <class Int>
std::vector<Wanted> of_vertices(T t) {
    return {{mgdt_point_count(t) + 1, sizeof(Int), true, false},
            {mgdt_vertex_tetrahedra_count(t), sizeof(Int), true, false}};
}
template <class Int>
std::vector<Wanted> of_neighbors(T t) {
    return {{mgdt_point_count(t) + 1, sizeof(Int), true, false},
            {mgdt_vertex_neighbors_count(t), sizeof(Int), true, false}};
}
template <class Int, mgdt_status (*Get)(T, std::int64_t, Int*, Int*)>
std::vector<Wanted> of_graph(T t) {
    Int count = 0;
    (void)Get(t, 0, nullptr, &count);
    return {{2 * static_cast<std::int64_t>(count), sizeof(Int), true, false},
            {1, sizeof(Int), false, false, true}};
}
template <class Int>
std::vector<Wanted> of_surface(T t) {
    return {{3 * mgdt_hull_facet_count(t), sizeof(Int), true, false},
            {1, sizeof(Int), false, false, true}};
}
// The capacity is that of both arrays, in tetrahedra.
inline std::vector<Wanted> of_circumcenters(T t) {
    const std::int64_t n = mgdt_tetrahedron_count(t);
    return {{3 * n, sizeof(double), false, false}, {n, sizeof(double), false, true}};
}
template <class Int>
std::vector<Wanted> of_queries(T) {
    return {{queries, sizeof(Int), false, false}, {4 * queries, sizeof(double), false, true}};
}
// Rows of the nearest vertex each.
inline std::int64_t row_count(T t) {
    return mgdt_vertex_count(t) > 0 ? queries : 0;
}
template <class Int>
std::vector<Wanted> of_rows(T t) {
    return {{queries + 1, sizeof(Int), true, false},
            {row_count(t), sizeof(Int), false, false},
            {row_count(t), sizeof(double), false, false}};
}
constexpr double segment[6] = {-0.5, -0.4, -0.3, 1.2, 1.3, 1.4};
template <class Int, mgdt_status (*Traverse)(T, const double*, const double*, std::int64_t, Int*,
                                             double*, Int*)>
std::vector<Wanted> of_segment(T t) {
    Int count = 0;
    (void)Traverse(t, segment, segment + 3, 0, nullptr, nullptr, &count);
    return {{count, sizeof(Int), true, false},
            {count == 0 ? 0 : count + 1, sizeof(double), false, true},
            {1, sizeof(Int), false, false, true}};
}
template <class Int>
std::vector<Wanted> of_places(T) {
    return {{queries, sizeof(Int), false, false}};
}
template <class Value>
std::vector<Wanted> of_one(T) {
    return {{1, sizeof(Value), false, false}};
}

#define EXPORT(name, count, times)                                                         \
    {"mgdt_get_" #name, of_count<std::int64_t, count, times>,                              \
     [](mgdt_triangulation* t, const Given& g) {                                           \
         return mgdt_get_##name(t, g.capacity[0], static_cast<std::int64_t*>(g.array[0])); \
     }},                                                                                   \
    {                                                                                      \
        "mgdt_get_" #name "_i32", of_count<std::int32_t, count, times>,                    \
            [](mgdt_triangulation* t, const Given& g) {                                    \
                return mgdt_get_##name##_i32(t, g.capacity[0],                             \
                                             static_cast<std::int32_t*>(g.array[0]));      \
            }                                                                              \
    }

#define GRAPH(function, Int)                                           \
    {                                                                  \
#function, of_graph<Int, function>,                                  \
            [](mgdt_triangulation* t, const Given& g) {                      \
                return function(t, g.capacity[0], static_cast<Int*>(g.array[0]), \
                                static_cast<Int*>(g.array[1]));              \
            } \
    }

#define SEGMENT(function, Int)                                                         \
    {                                                                                  \
#function, of_segment<Int, function>,                                                \
            [](mgdt_triangulation* t, const Given& g) {                              \
                return function(t, segment, segment + 3, g.capacity[0],              \
                                static_cast<Int*>(g.array[0]),                       \
                                static_cast<double*>(g.array[1]),                    \
                                static_cast<Int*>(g.array[2]));                      \
            } \
    }

#define SURFACE(function, Int)                                         \
    {                                                                  \
#function, of_surface<Int>,                                          \
            [](mgdt_triangulation* t, const Given& g) {                      \
                return function(t, 1e300, g.capacity[0], static_cast<Int*>(g.array[0]), \
                                static_cast<Int*>(g.array[1]));              \
            } \
    }

const Function functions[] = {
    EXPORT(tetrahedra, mgdt_tetrahedron_count, 4),
    EXPORT(neighbors, mgdt_tetrahedron_count, 4),
    EXPORT(hull_facets, mgdt_hull_facet_count, 3),
    EXPORT(edges, mgdt_edge_count, 2),
    EXPORT(point_map, mgdt_point_count, 1),
    {"mgdt_get_vertex_tetrahedra", of_vertices<std::int64_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_vertex_tetrahedra(t, g.capacity[0], static_cast<std::int64_t*>(g.array[0]),
                                           g.capacity[1], static_cast<std::int64_t*>(g.array[1]));
     }},
    {"mgdt_get_vertex_tetrahedra_i32", of_vertices<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_vertex_tetrahedra_i32(
             t, g.capacity[0], static_cast<std::int32_t*>(g.array[0]), g.capacity[1],
             static_cast<std::int32_t*>(g.array[1]));
     }},
    {"mgdt_get_vertex_neighbors", of_neighbors<std::int64_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_vertex_neighbors(t, g.capacity[0], static_cast<std::int64_t*>(g.array[0]),
                                          g.capacity[1], static_cast<std::int64_t*>(g.array[1]));
     }},
    {"mgdt_get_vertex_neighbors_i32", of_neighbors<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_vertex_neighbors_i32(t, g.capacity[0],
                                              static_cast<std::int32_t*>(g.array[0]), g.capacity[1],
                                              static_cast<std::int32_t*>(g.array[1]));
     }},
    GRAPH(mgdt_get_gabriel_edges, std::int64_t),
    GRAPH(mgdt_get_gabriel_edges_i32, std::int32_t),
    GRAPH(mgdt_get_spanning_tree, std::int64_t),
    GRAPH(mgdt_get_spanning_tree_i32, std::int32_t),
    {"mgdt_get_circumcenters", of_circumcenters,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_circumcenters(t, mgdt_tetrahedron_count(t),
                                       static_cast<double*>(g.array[0]),
                                       static_cast<double*>(g.array[1]));
     }},
    {"mgdt_get_tetrahedron_measures",
     [](T t) {
         return std::vector<Wanted>{{mgdt_tetrahedron_count(t), sizeof(double), false, false}};
     },
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE,
                                              g.capacity[0], static_cast<double*>(g.array[0]));
     }},
    {"mgdt_get_alphas",
     [](T t) {
         return std::vector<Wanted>{{4 * mgdt_tetrahedron_count(t), sizeof(double), false, false}};
     },
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_alphas(t, 2, 4 * mgdt_tetrahedron_count(t),
                                static_cast<double*>(g.array[0]));
     }},
    SURFACE(mgdt_get_alpha_surface, std::int64_t),
    SURFACE(mgdt_get_alpha_surface_i32, std::int32_t),
    {"mgdt_get_solid_alpha",
     [](T t) {
         const bool is_flat = mgdt_dimension(t) >= 0 && mgdt_dimension(t) < 3;
         return std::vector<Wanted>{{is_flat ? 0 : 1, sizeof(double), false, false}};
     },
     [](mgdt_triangulation* t, const Given& g) {
         const mgdt_status status = mgdt_get_solid_alpha(t, static_cast<double*>(g.array[0]));
         return status == MGDT_ERR_INVALID_ARGUMENT ? MGDT_OK : status;
     }},
    {"mgdt_get_cell_measures",
     [](T t) {
         // Points in one plane have no cells.
         const std::int64_t cells = mgdt_dimension(t) == 3 ? mgdt_point_count(t) : 0;
         return std::vector<Wanted>{{3 * cells, sizeof(double), false, false}};
     },
     [](mgdt_triangulation* t, const Given& g) {
         const mgdt_status status =
             mgdt_get_cell_measures(t, MGDT_MEASURE_CENTROID, 0, nullptr, 3 * mgdt_point_count(t),
                                    static_cast<double*>(g.array[0]));
         return mgdt_dimension(t) < 3 && status == MGDT_ERR_INVALID_ARGUMENT ? MGDT_OK : status;
     }},
    {"mgdt_interpolate",
     [](T) {
         return std::vector<Wanted>{{2 * queries, sizeof(double), false, false}};
     },
     [](mgdt_triangulation* t, const Given& g) {
         const std::vector<double> values(2 * static_cast<std::size_t>(mgdt_point_count(t)), 1.0);
         return mgdt_interpolate(t, MGDT_INTERPOLATE_NEAREST, MGDT_OUTSIDE_LINEAR, 2, values.data(),
                                 queries, query_points(), static_cast<double*>(g.array[0]));
     }},
    {"mgdt_get_interpolation_weights", of_rows<std::int64_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_interpolation_weights(
             t, MGDT_INTERPOLATE_NEAREST, MGDT_OUTSIDE_NEAREST, queries, query_points(),
             g.capacity[0], static_cast<std::int64_t*>(g.array[0]), row_count(t),
             static_cast<std::int64_t*>(g.array[1]), static_cast<double*>(g.array[2]));
     }},
    {"mgdt_get_interpolation_weights_i32", of_rows<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_interpolation_weights_i32(
             t, MGDT_INTERPOLATE_NEAREST, MGDT_OUTSIDE_NEAREST, queries, query_points(),
             g.capacity[0], static_cast<std::int32_t*>(g.array[0]), row_count(t),
             static_cast<std::int32_t*>(g.array[1]), static_cast<double*>(g.array[2]));
     }},
    {"mgdt_get_gradients",
     [](T t) {
         const std::int64_t points = mgdt_dimension(t) == 3 ? mgdt_point_count(t) : 0;
         return std::vector<Wanted>{{3 * points, sizeof(double), false, false}};
     },
     [](mgdt_triangulation* t, const Given& g) {
         const std::vector<double> values(static_cast<std::size_t>(mgdt_point_count(t)), 1.0);
         const mgdt_status status =
             mgdt_get_gradients(t, 1, values.data(), static_cast<double*>(g.array[0]));
         return mgdt_dimension(t) < 3 && status == MGDT_ERR_INVALID_ARGUMENT ? MGDT_OK : status;
     }},
    {"mgdt_locate", of_one<std::int64_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_locate(t, query_points(), static_cast<std::int64_t*>(g.array[0]));
     }},
    {"mgdt_locate_i32", of_one<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_locate_i32(t, query_points(), static_cast<std::int32_t*>(g.array[0]));
     }},
    {"mgdt_locate_points", of_queries<std::int64_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_locate_points(t, queries, query_points(),
                                   static_cast<std::int64_t*>(g.array[0]),
                                   static_cast<double*>(g.array[1]));
     }},
    {"mgdt_locate_points_i32", of_queries<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_locate_points_i32(t, queries, query_points(),
                                       static_cast<std::int32_t*>(g.array[0]),
                                       static_cast<double*>(g.array[1]));
     }},
    SEGMENT(mgdt_traverse_segment, std::int64_t),
    SEGMENT(mgdt_traverse_segment_i32, std::int32_t),
    {"mgdt_nearest_vertex", of_one<std::int64_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_nearest_vertex(t, query_points(), static_cast<std::int64_t*>(g.array[0]));
     }},
    {"mgdt_nearest_vertex_i32", of_one<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_nearest_vertex_i32(t, query_points(), static_cast<std::int32_t*>(g.array[0]));
     }},
    {"mgdt_nearest_vertices", of_places<std::int64_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_nearest_vertices(t, queries, query_points(),
                                      static_cast<std::int64_t*>(g.array[0]));
     }},
    {"mgdt_nearest_vertices_i32", of_places<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_nearest_vertices_i32(t, queries, query_points(),
                                          static_cast<std::int32_t*>(g.array[0]));
     }},
    {"mgdt_renumber_points", of_count<std::int64_t, mgdt_point_count, 1>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_renumber_points(t, g.capacity[0], static_cast<std::int64_t*>(g.array[0]));
     }},
    {"mgdt_renumber_points_i32", of_count<std::int32_t, mgdt_point_count, 1>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_renumber_points_i32(t, g.capacity[0], static_cast<std::int32_t*>(g.array[0]));
     }},
    {"mgdt_get_order_scheme", of_one<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_order_scheme(t, static_cast<std::int32_t*>(g.array[0]));
     }},
    {"mgdt_get_threads", of_one<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_threads(t, static_cast<std::int32_t*>(g.array[0]));
     }},
    {"mgdt_get_index_base", of_one<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_index_base(t, static_cast<std::int32_t*>(g.array[0]));
     }},
    {"mgdt_get_compact", of_one<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_compact(t, static_cast<std::int32_t*>(g.array[0]));
     }},
    {"mgdt_get_read_progress", of_one<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_read_progress(t, static_cast<std::int32_t*>(g.array[0]));
     }},
    {"mgdt_get_canonical_output", of_one<std::int32_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_canonical_output(t, static_cast<std::int32_t*>(g.array[0]));
     }},
    {"mgdt_get_memory_limit", of_one<std::int64_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_memory_limit(t, static_cast<std::int64_t*>(g.array[0]));
     }},
    {"mgdt_get_seed", of_one<std::uint64_t>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_seed(t, static_cast<std::uint64_t*>(g.array[0]));
     }},
    {"mgdt_get_order_parameter", of_one<double>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_order_parameter(t, MGDT_PARAMETER_THRESHOLD,
                                         static_cast<double*>(g.array[0]));
     }},
    {"mgdt_get_progress",
     [](T) {
         return std::vector<Wanted>{{1, sizeof(mgdt_progress_fn), false, false},
                                    {1, sizeof(void*), false, true}};
     },
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_progress(t, static_cast<mgdt_progress_fn*>(g.array[0]),
                                  static_cast<void**>(g.array[1]));
     }},
    {"mgdt_get_stat", of_one<double>,
     [](mgdt_triangulation* t, const Given& g) {
         return mgdt_get_stat(t, MGDT_STAT_WALK_STEPS, static_cast<double*>(g.array[0]));
     }},
    {"mgdt_order_scheme_from_name", of_one<std::int32_t>,
     [](mgdt_triangulation*, const Given& g) {
         return mgdt_order_scheme_from_name("brio", static_cast<std::int32_t*>(g.array[0]));
     }},
    {"mgdt_order_scheme_at", of_one<std::int32_t>,
     [](mgdt_triangulation*, const Given& g) {
         return mgdt_order_scheme_at(3, static_cast<std::int32_t*>(g.array[0]));
     }},
    {"mgdt_create", of_one<void*>,
     [](mgdt_triangulation*, const Given& g) {
         auto** out = static_cast<mgdt_triangulation**>(g.array[0]);
         const mgdt_status status = mgdt_create(out);
         if (status == MGDT_OK) mgdt_destroy(*out);
         return status;
     }},
    {"mgdt_create_with_allocator", of_one<void*>,
     [](mgdt_triangulation*, const Given& g) {
         auto** out = static_cast<mgdt_triangulation**>(g.array[0]);
         const mgdt_status status = mgdt_create_with_allocator(nullptr, nullptr, nullptr, out);
         if (status == MGDT_OK) mgdt_destroy(*out);
         return status;
     }},
    // Writes what there is room for: tested by itself below.
    {"mgdt_get_error", nullptr, nullptr},
};

}  // namespace canaries
