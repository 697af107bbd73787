// SPDX-License-Identifier: MIT
// No function writes outside the arrays that it is given, or into any of them when it fails; none
// reads outside the arrays that it is given. The table has every function with an output
// parameter: canary_test.py compares it with the header.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "../property/handle.hpp"

namespace {

using property::Handle;

// An array of its own pages. What is around it is inaccessible on one side and known on the other.
class Array {
  public:
    enum Place { at_the_end, at_the_begin, off_by_one };
    static constexpr unsigned char known = 0xC5;

    Array(std::size_t elements, std::size_t element_size, Place place)
        : size_(elements * element_size) {
        const std::size_t page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        inner_ = (size_ + element_size + page) / page * page;
        mapped_ = inner_ + 2 * page;
        void* const p = mmap(nullptr, mapped_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (p == MAP_FAILED) throw std::bad_alloc();
        whole_ = static_cast<unsigned char*>(p);
        begin_ = whole_ + page;
        if (mprotect(begin_, inner_, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
        std::memset(begin_, known, inner_);
        data_ = place == at_the_end     ? begin_ + inner_ - size_
                : place == at_the_begin ? begin_
                                        : begin_ + element_size;
    }
    Array(Array&& other) noexcept { *this = std::move(other); }
    Array& operator=(Array&& other) noexcept {
        std::swap(whole_, other.whole_);
        std::swap(begin_, other.begin_);
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(inner_, other.inner_);
        std::swap(mapped_, other.mapped_);
        return *this;
    }
    ~Array() {
        if (whole_) munmap(whole_, mapped_);
    }
    void* data() const { return data_; }
    // Nothing outside was written.
    bool is_whole() const {
        for (const unsigned char* p = begin_; p != begin_ + inner_; ++p)
            if ((p < data_ || p >= data_ + size_) && *p != known) return false;
        return true;
    }
    bool is_untouched() const {
        for (std::size_t i = 0; i < size_; ++i)
            if (data_[i] != known) return false;
        return is_whole();
    }
    // Every element was written: none has all its bytes as they were.
    bool is_written(std::size_t element_size) const {
        for (std::size_t i = 0; i < size_; i += element_size) {
            bool differs = false;
            for (std::size_t k = 0; k < element_size; ++k) differs |= data_[i + k] != known;
            if (!differs) return false;
        }
        return true;
    }

  private:
    unsigned char *whole_ = nullptr, *begin_ = nullptr, *data_ = nullptr;
    std::size_t size_ = 0, inner_ = 0, mapped_ = 0;
};

struct Wanted {
    std::int64_t elements;
    std::size_t element_size;
    bool has_capacity;
    bool may_be_null;
    bool says_size = false;  // of another array, also where that is too small
};

constexpr std::int64_t queries = 37;
const double* query_points() {
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
std::vector<Wanted> of_circumcenters(T t) {
    const std::int64_t n = mgdt_tetrahedron_count(t);
    return {{3 * n, sizeof(double), false, false}, {n, sizeof(double), false, true}};
}
template <class Int>
std::vector<Wanted> of_queries(T) {
    return {{queries, sizeof(Int), false, false}, {4 * queries, sizeof(double), false, true}};
}
// Rows of the nearest vertex each.
std::int64_t row_count(T t) {
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

std::vector<Handle> handles() {
    std::vector<Handle> all;
    std::mt19937_64 random(4);
    for (const std::size_t n : {0u, 1u, 3u, 20u, 4u, 5u, 33u, 700u}) {
        std::vector<double> xyz(3 * n);
        for (double& x : xyz) x = static_cast<double>(random() % 1000) / 1000;
        // Points 20 are flat.
        for (std::size_t i = 2; n == 20 && i < xyz.size(); i += 3) xyz[i] = 0;
        Handle t = property::create();
        EXPECT_EQ(mgdt_insert_points(t.get(), static_cast<std::int64_t>(n), xyz.data()), MGDT_OK);
        all.push_back(std::move(t));
    }
    return all;
}

struct Arrays {
    Arrays(const std::vector<Wanted>& wanted, Array::Place place) {
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            arrays.emplace_back(static_cast<std::size_t>(wanted[k].elements),
                                wanted[k].element_size, place);
            given.array[k] = arrays[k].data();
            given.capacity[k] = wanted[k].elements;
            says_size.push_back(wanted[k].says_size);
        }
    }
    void expect_whole() const {
        for (const Array& a : arrays) EXPECT_TRUE(a.is_whole());
    }
    void expect_untouched() const {
        for (std::size_t k = 0; k < arrays.size(); ++k)
            EXPECT_TRUE(says_size[k] ? arrays[k].is_whole() : arrays[k].is_untouched());
    }
    std::vector<Array> arrays;
    std::vector<bool> says_size;
    Given given = {};
};

void expect_bounds(const Function& f, mgdt_triangulation* t, Array::Place place) {
    const std::vector<Wanted> wanted = f.wants(t);
    {
        const Arrays exact(wanted, place);
        EXPECT_EQ(f.call(t, exact.given), MGDT_OK) << property::error_of(t);
        exact.expect_whole();
        for (std::size_t k = 0; k < wanted.size(); ++k)
            EXPECT_TRUE(exact.arrays[k].is_written(wanted[k].element_size)) << k;
    }
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        const bool is_needed = wanted[k].elements > 0 && !wanted[k].may_be_null;
        {
            Arrays none(wanted, place);
            none.given.array[k] = nullptr;
            EXPECT_EQ(f.call(t, none.given), is_needed ? MGDT_ERR_NULL_POINTER : MGDT_OK) << k;
            if (is_needed) none.expect_untouched();
            none.expect_whole();
        }
        if (!wanted[k].has_capacity) continue;
        for (const std::int64_t capacity :
             {wanted[k].elements - 1, std::int64_t{0}, std::int64_t{-1},
              std::numeric_limits<std::int64_t>::min()}) {
            if (capacity >= wanted[k].elements) continue;
            Arrays small(wanted, place);
            small.given.capacity[k] = capacity;
            EXPECT_EQ(f.call(t, small.given),
                      capacity < 0 ? MGDT_ERR_INVALID_ARGUMENT : MGDT_ERR_BUFFER_TOO_SMALL)
                << capacity;
            small.expect_untouched();
        }
        // More than it needs is not used.
        Arrays large(wanted, place);
        large.given.capacity[k] = std::numeric_limits<std::int64_t>::max();
        EXPECT_EQ(f.call(t, large.given), MGDT_OK);
        large.expect_whole();
    }
}

TEST(Canary, NothingOutsideTheArrays) {
    for (const Handle& t : handles())
        for (const std::int32_t base : {0, 1})
            for (const std::int32_t canonical : {0, 1}) {
                ASSERT_EQ(mgdt_set_index_base(t.get(), base), MGDT_OK);
                ASSERT_EQ(mgdt_set_canonical_output(t.get(), canonical), MGDT_OK);
                for (const Function& f : functions) {
                    if (!f.call) continue;
                    SCOPED_TRACE(std::string(f.name) + " of " +
                                 std::to_string(mgdt_point_count(t.get())) + " points");
                    for (const Array::Place place :
                         {Array::at_the_end, Array::at_the_begin, Array::off_by_one})
                        expect_bounds(f, t.get(), place);
                }
            }
}

TEST(Canary, NoHandle) {
    for (const Function& f : functions) {
        if (!f.call || std::string(f.name).find("create") != std::string::npos ||
            std::string(f.name).find("order_scheme") != std::string::npos)
            continue;
        const Arrays arrays({{8, 8, true, false}, {8, 8, true, false}}, Array::at_the_end);
        EXPECT_EQ(f.call(nullptr, arrays.given), MGDT_ERR_NULL_POINTER) << f.name;
        arrays.expect_untouched();
    }
}

TEST(Canary, Message) {
    const Handle t = property::create();
    ASSERT_EQ(mgdt_reserve(t.get(), -1), MGDT_ERR_INVALID_ARGUMENT);
    const std::string whole = property::error_of(t.get());
    ASSERT_GT(whole.size(), 10u);
    for (std::size_t capacity = 1; capacity < 300; ++capacity)
        for (const Array::Place place :
             {Array::at_the_end, Array::at_the_begin, Array::off_by_one}) {
            const Array a(capacity, 1, place);
            char* const text = static_cast<char*>(a.data());
            ASSERT_EQ(mgdt_get_error(t.get(), static_cast<std::int64_t>(capacity), text), MGDT_OK);
            EXPECT_TRUE(a.is_whole());
            EXPECT_EQ(std::string(text), whole.substr(0, capacity - 1));
        }
    const Array a(8, 1, Array::at_the_end);
    for (const std::int64_t capacity :
         {std::int64_t{0}, std::int64_t{-1}, std::numeric_limits<std::int64_t>::min()})
        EXPECT_EQ(mgdt_get_error(t.get(), capacity, static_cast<char*>(a.data())),
                  MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_TRUE(a.is_untouched());
}

// A query that is refused: nothing is written, wherever it stands.
TEST(Canary, RefusedQueries) {
    const std::vector<Handle> all = handles();
    mgdt_triangulation* const t = all.back().get();
    for (std::size_t bad = 0; bad < 3 * queries; bad += 11) {
        std::vector<double> xyz(query_points(), query_points() + 3 * queries);
        xyz[bad] = std::numeric_limits<double>::quiet_NaN();
        const Array found(queries, 8, Array::at_the_end),
            weights(4 * queries, 8, Array::at_the_end);
        EXPECT_EQ(
            mgdt_locate_points(t, queries, xyz.data(), static_cast<std::int64_t*>(found.data()),
                               static_cast<double*>(weights.data())),
            MGDT_ERR_NOT_FINITE);
        EXPECT_EQ(
            mgdt_nearest_vertices(t, queries, xyz.data(), static_cast<std::int64_t*>(found.data())),
            MGDT_ERR_NOT_FINITE);
        EXPECT_TRUE(found.is_untouched());
        EXPECT_TRUE(weights.is_untouched());
    }
}

// Points are read where they are and nowhere else, and stay as they are.
TEST(Canary, Input) {
    std::mt19937_64 random(5);
    for (const std::size_t n : {1u, 2u, 3u, 4u, 5u, 7u, 8u, 64u, 65u, 1000u, 1001u})
        for (const Array::Place place : {Array::at_the_end, Array::at_the_begin}) {
            const Array a(3 * n, sizeof(double), place);
            double* const xyz = static_cast<double*>(a.data());
            for (std::size_t i = 0; i < 3 * n; ++i) xyz[i] = static_cast<double>(random() % 4096);
            const std::vector<double> copy(xyz, xyz + 3 * n);
            const std::int64_t count = static_cast<std::int64_t>(n);
            const Handle t = property::create(), reversed = property::create();
            EXPECT_EQ(mgdt_insert_points(t.get(), count, xyz), MGDT_OK);
            const double* const last = xyz + 3 * (n - 1);
            EXPECT_EQ(
                mgdt_insert_points_strided(reversed.get(), count, last, last + 1, last + 2, -3),
                MGDT_OK);
            EXPECT_EQ(mgdt_tetrahedron_count(t.get()), mgdt_tetrahedron_count(reversed.get()));
            std::vector<std::int64_t> found(n);
            EXPECT_EQ(mgdt_locate_points(t.get(), count, xyz, found.data(), nullptr), MGDT_OK);
            EXPECT_EQ(mgdt_nearest_vertex(t.get(), last, found.data()), MGDT_OK);
            EXPECT_EQ(mgdt_nearest_vertices(t.get(), count, xyz, found.data()), MGDT_OK);
            EXPECT_EQ(std::memcmp(copy.data(), xyz, copy.size() * sizeof(double)), 0);
            const Array list(n, sizeof(std::int64_t), place),
                list32(n, sizeof(std::int32_t), place);
            auto* const points = static_cast<std::int64_t*>(list.data());
            auto* const points32 = static_cast<std::int32_t*>(list32.data());
            for (std::size_t i = 0; i < n; ++i) {
                points[i] = static_cast<std::int64_t>(n - 1 - i);
                points32[i] = static_cast<std::int32_t>(points[i]);
            }
            EXPECT_EQ(mgdt_move_points(t.get(), count, points, xyz), MGDT_OK);
            EXPECT_EQ(mgdt_move_points_i32(reversed.get(), count, points32, xyz), MGDT_OK);
            EXPECT_EQ(mgdt_move_points(t.get(), count, nullptr, xyz), MGDT_OK);
            EXPECT_EQ(std::memcmp(copy.data(), xyz, copy.size() * sizeof(double)), 0);
            EXPECT_EQ(mgdt_remove_points(t.get(), count, points), MGDT_OK);
            EXPECT_EQ(mgdt_remove_points_i32(reversed.get(), count, points32), MGDT_OK);
            for (std::size_t i = 0; i < n; ++i) {
                EXPECT_EQ(points[i], static_cast<std::int64_t>(n - 1 - i));
                EXPECT_EQ(points32[i], static_cast<std::int32_t>(n - 1 - i));
            }
        }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string(argv[1]) == "--list") {
        for (const Function& f : functions) std::puts(f.name);
        return 0;
    }
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
