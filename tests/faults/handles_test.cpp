// SPDX-License-Identifier: MIT
// The allocators of domains, meshes, boxes, parts and diagrams refuse: every request of every call.
#include <mgdt/mgdt_domain.h>
#include <mgdt/mgdt_parts.h>
#include <mgdt/mgdt_periodic.h>
#include <mgdt/mgdt_voronoi.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "refusal.hpp"

namespace faults {
namespace {

struct Step {
    const char* name;
    std::function<mgdt_status(void*)> make;
    bool asks_for_memory = true;
};

struct Kind {
    const char* name;
    std::function<mgdt_status(void**)> create;
    std::function<void(void*)> destroy;
    std::vector<Step> steps;
};

// The first status that is neither success nor due to a key of another kind.
struct Statuses {
    mgdt_status worst = MGDT_OK;
    bool add(mgdt_status s) {
        if (s == MGDT_ERR_OUT_OF_MEMORY) worst = s;
        return s == MGDT_OK;
    }
};

constexpr std::int32_t most_keys = 400;

// Reads all arrays of integers and of doubles that a handle has.
template <class Size, class Integers, class Doubles>
mgdt_status read_arrays(const Size& size, const Integers& integers, const Doubles& doubles) {
    Statuses found;
    for (std::int32_t key = 0; key < most_keys; ++key) {
        std::int64_t n = 0;
        if (!found.add(size(key, &n))) continue;
        std::vector<std::int64_t> values(static_cast<std::size_t>(n) + 1);
        std::vector<double> numbers(static_cast<std::size_t>(n) + 1);
        found.add(integers(key, n, values.data()));
        found.add(doubles(key, n, numbers.data()));
    }
    return found.worst;
}

// The same by the functions of a kind of handle.
template <class Handle>
mgdt_status read_arrays_of(
    const Handle* h, mgdt_status (*size)(const Handle*, std::int32_t, std::int64_t*),
    mgdt_status (*integers)(const Handle*, std::int32_t, std::int64_t, std::int64_t*),
    mgdt_status (*doubles)(const Handle*, std::int32_t, std::int64_t, double*)) {
    return read_arrays([&](auto k, auto* n) { return size(h, k, n); },
                       [&](auto k, auto n, auto* x) { return integers(h, k, n, x); },
                       [&](auto k, auto n, auto* x) { return doubles(h, k, n, x); });
}

template <class Read>
mgdt_status read_measures(std::int64_t n, const Read& read) {
    Statuses found;
    std::vector<double> values(3 * static_cast<std::size_t>(n));
    for (std::int32_t key = 0; key < most_keys; ++key)
        found.add(read(key, static_cast<std::int64_t>(values.size()), values.data()));
    return found.worst;
}

// Makes a mesh, checks it and reads it. A refusal leaves no mesh.
mgdt_status make_mesh(mgdt_domain* d) {
    mgdt_mesh* m = nullptr;
    const mgdt_status status = mgdt_domain_build(d, &m);
    if (status != MGDT_OK) {
        EXPECT_EQ(m, nullptr);
        return status;
    }
    Statuses found;
    found.add(mgdt_mesh_check(m));
    found.add(mgdt_domain_check(d, m));
    found.add(read_arrays_of<mgdt_mesh>(m, mgdt_mesh_get_size, mgdt_mesh_get_array,
                                        mgdt_mesh_get_doubles));
    found.add(read_measures(100, [&](auto k, auto n, auto* x) {
        return mgdt_mesh_get_tetrahedron_measures(m, k, n, x);
    }));
    mgdt_mesh_destroy(m);
    return found.worst;
}

Kind domain() {
    static const double points[] = {0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0, 0, 0, 4, 4, 0,
                                    4, 4, 4, 4, 0, 4, 4, 1, 1, 2, 3, 1, 2, 1, 3, 2};
    static const std::int64_t offsets[] = {0, 4, 8, 12, 16, 20, 24, 27};
    static const std::int64_t corners[] = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 2, 3,
                                           7, 6, 0, 4, 7, 3, 1, 2, 6, 5, 8, 9, 10};
    static const std::int32_t markers[] = {1, 2, 3, 4, 5, 6, 7};
    static const std::int64_t segment[] = {0, 6};
    static const double place[] = {1, 1, 1}, nowhere[] = {9, 9, 9};
    const auto d = [](void* h) { return static_cast<mgdt_domain*>(h); };
    return {
        "domain",
        [](void** out) {
            return mgdt_domain_create_with_allocator(handle_take, handle_give, nullptr,
                                                     reinterpret_cast<mgdt_domain**>(out));
        },
        [d](void* h) { mgdt_domain_destroy(d(h)); },
        {{"set_points", [d](void* h) { return mgdt_domain_set_points(d(h), 11, points); }},
         {"set_facets",
          [d](void* h) { return mgdt_domain_set_facets(d(h), 7, offsets, corners, markers); }},
         {"set_segments",
          [d](void* h) { return mgdt_domain_set_segments(d(h), 1, segment, markers); }},
         {"set_regions", [d](void* h) { return mgdt_domain_set_regions(d(h), 1, place, markers); }},
         {"set_holes", [d](void* h) { return mgdt_domain_set_holes(d(h), 1, nowhere); }},
         {"clean", [d](void* h) { return mgdt_domain_clean(d(h)); }},
         // The segment crosses the triangle.
         {"validate",
          [d](void* h) {
              const mgdt_status s = mgdt_domain_validate(d(h));
              return s == MGDT_ERR_INVALID_BOUNDARY ? MGDT_OK : s;
          }},
         {"set no segments",
          [d](void* h) { return mgdt_domain_set_segments(d(h), 0, nullptr, nullptr); }, false},
         {"mesh", [d](void* h) { return make_mesh(d(h)); }},
         {"clear", [d](void* h) { return mgdt_domain_clear(d(h)); }, false}}};
}

// The cubes of a lattice with a moved point, each of six tetrahedra.
Kind mesh() {
    static const std::int64_t side = 3, layer = side * side;
    static const Points points = [] {
        Points all;
        for (int i = 0; i < side * layer; ++i)
            for (const std::int64_t step : {std::int64_t{1}, side, layer})
                all.push_back(double(i / step % side) + (i == side * layer / 2 ? 0.4 : 0.0));
        return all;
    }();
    static const std::vector<std::int64_t> corners = [] {
        std::vector<std::int64_t> all;
        for (std::int64_t i = 0; i < (side - 1) * layer; ++i) {
            if (i % side == side - 1 || i / side % side == side - 1) continue;
            std::array<std::int64_t, 3> steps = {1, side, layer};
            do {
                std::int64_t v = i;
                all.push_back(v);
                for (const std::int64_t step : steps) all.push_back(v += step);
            } while (std::next_permutation(steps.begin(), steps.end()));
        }
        return all;
    }();
    static const std::vector<std::int32_t> markers(corners.size() / 4, 3);
    static const std::int64_t edge[] = {0, 1 + side + layer}, fixed[] = {0, 5};
    const auto m = [](void* h) { return static_cast<mgdt_mesh*>(h); };
    return {
        "mesh",
        [](void** out) {
            return mgdt_mesh_create_with_allocator(handle_take, handle_give, nullptr,
                                                   reinterpret_cast<mgdt_mesh**>(out));
        },
        [m](void* h) { mgdt_mesh_destroy(m(h)); },
        {{"set_points",
          [m](void* h) { return mgdt_mesh_set_points(m(h), side * layer, points.data()); }},
         {"set_tetrahedra",
          [m](void* h) {
              return mgdt_mesh_set_tetrahedra(m(h), static_cast<std::int64_t>(markers.size()),
                                              corners.data(), markers.data());
          }},
         {"set_faces",
          [m](void* h) { return mgdt_mesh_set_faces(m(h), 1, corners.data(), markers.data()); }},
         {"set_edges", [m](void* h) { return mgdt_mesh_set_edges(m(h), 1, edge, markers.data()); }},
         {"set_fixed_points", [m](void* h) { return mgdt_mesh_set_fixed_points(m(h), 2, fixed); }},
         {"build",
          [m](void* h) {
              // Once it is built, there is nothing to build.
              std::int64_t n = 0;
              const mgdt_status s = mgdt_mesh_get_stat(m(h), MGDT_MESH_STAT_TETRAHEDRA, &n);
              return s != MGDT_OK || n > 0 ? s : mgdt_mesh_build(m(h));
          }},
         {"check", [m](void* h) { return mgdt_mesh_check(m(h)); }},
         {"locate",
          [m](void* h) {
              std::int64_t found[2];
              double weights[8];
              const double places[] = {0.5, 0.5, 0.5, 9, 9, 9};
              return mgdt_mesh_locate_points(m(h), MGDT_OUTSIDE_BOUNDARY, 2, places, found,
                                             weights);
          }},
         {"interpolate",
          [m](void* h) {
              double values[27] = {}, out[2];
              const double places[] = {0.5, 0.5, 0.5, 9, 9, 9};
              return mgdt_mesh_interpolate(m(h), MGDT_OUTSIDE_BOUNDARY, 1, values, 2, places, out);
          }},
         {"summary",
          [m](void* h) { return mgdt_mesh_get_shape_summary(m(h), nullptr, nullptr, nullptr); }},
         {"improve",
          [m](void* h) {
              mgdt_status s = mgdt_mesh_set_option(m(h), MGDT_MESH_OPTION_GOAL, 35);
              if (s == MGDT_OK) s = mgdt_mesh_set_option(m(h), MGDT_MESH_OPTION_MOST_PASSES, 2);
              if (s == MGDT_OK) s = mgdt_mesh_improve(m(h));
              return s;
          }},
         {"set_size_field",
          [m](void* h) {
              const double places[] = {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 2, 2, 2},
                           sizes[] = {0.9, 1.2, 1.3, 1.4, 1.5};
              return mgdt_mesh_set_size_field(m(h), 5, places, sizes);
          }},
         {"refine in space", [m](void* h) { return mgdt_mesh_refine(m(h)); }},
         {"refine",
          [m](void* h) {
              const double size = 0.8;
              mgdt_status s = mgdt_mesh_set_size_field(m(h), 0, nullptr, nullptr);
              if (s == MGDT_OK) s = mgdt_mesh_set_option(m(h), MGDT_MESH_OPTION_BOUNDARY, 0);
              if (s == MGDT_OK) s = mgdt_mesh_set_double_option(m(h), MGDT_MESH_OPTION_SIZE, 0.9);
              if (s == MGDT_OK) s = mgdt_mesh_set_sizes(m(h), MGDT_SIZES_OF_REGIONS, 1, &size);
              if (s == MGDT_OK) s = mgdt_mesh_refine(m(h));
              return s;
          }},
         {"refine the boundary",
          [m](void* h) {
              mgdt_status s = mgdt_mesh_set_option(m(h), MGDT_MESH_OPTION_BOUNDARY, 1);
              if (s == MGDT_OK) s = mgdt_mesh_refine(m(h));
              return s;
          }},
         {"arrays",
          [m](void* h) {
              return read_arrays_of<mgdt_mesh>(m(h), mgdt_mesh_get_size, mgdt_mesh_get_array,
                                               mgdt_mesh_get_doubles);
          },
          false}}};
}

mgdt_status read_diagram(mgdt_voronoi* v) {
    Statuses found;
    found.add(read_arrays_of<mgdt_voronoi>(v, mgdt_voronoi_get_size, mgdt_voronoi_get_array,
                                           mgdt_voronoi_get_doubles));
    found.add(mgdt_voronoi_drop_small_faces(v, 1e-3, 0));
    return found.worst;
}

// Makes a diagram and reads it. A refusal leaves no diagram.
template <class Create>
mgdt_status make_diagram(const Create& create) {
    mgdt_voronoi* v = nullptr;
    const mgdt_status status = create(&v);
    if (status != MGDT_OK) {
        EXPECT_EQ(v, nullptr);
        return status;
    }
    const mgdt_status read = read_diagram(v);
    mgdt_voronoi_destroy(v);
    return read;
}

Kind box() {
    static const double vectors[] = {1, 0, 0, 0.25, 1, 0, 0, 0.5, 1},
                        other_vectors[] = {1.1, 0, 0, 0.25, 1, 0, 0, 0.5, 1};
    static const Points points = random_points(5, 3), moved = random_points(5, 4);
    const auto p = [](void* h) { return static_cast<mgdt_periodic*>(h); };
    return {
        "periodic box",
        [](void** out) {
            return mgdt_periodic_create_with_allocator(handle_take, handle_give, nullptr,
                                                       reinterpret_cast<mgdt_periodic**>(out));
        },
        [p](void* h) { mgdt_periodic_destroy(p(h)); },
        {{"set_vectors", [p](void* h) { return mgdt_periodic_set_vectors(p(h), 3, vectors); },
          false},
         {"insert_points",
          [p](void* h) {
              std::int64_t n = 0;
              const mgdt_status s = mgdt_periodic_get_stat(p(h), MGDT_PERIODIC_STAT_POINTS, &n);
              return s != MGDT_OK || n > 0 ? s
                                           : mgdt_periodic_insert_points(p(h), 5, points.data());
          }},
         {"build", [p](void* h) { return mgdt_periodic_build(p(h)); }},
         {"move_points",
          [p](void* h) { return mgdt_periodic_move_points(p(h), 5, nullptr, moved.data()); },
          false},
         {"build again", [p](void* h) { return mgdt_periodic_build(p(h)); }},
         {"other vectors",
          [p](void* h) { return mgdt_periodic_set_vectors(p(h), 3, other_vectors); }, false},
         {"build with them", [p](void* h) { return mgdt_periodic_build(p(h)); }},
         {"check", [p](void* h) { return mgdt_periodic_check(p(h)); }},
         {"arrays",
          [p](void* h) {
              return read_arrays_of<mgdt_periodic>(
                  p(h), mgdt_periodic_get_size, mgdt_periodic_get_array, mgdt_periodic_get_doubles);
          }},
         {"measures",
          [p](void* h) {
              return read_measures(5, [&](auto k, auto n, auto* x) {
                  return mgdt_periodic_get_cell_measures(p(h), k, n, x);
              });
          }},
         {"diagram",
          [p](void* h) {
              return make_diagram(
                  [&](mgdt_voronoi** v) { return mgdt_periodic_create_voronoi(p(h), v); });
          }},
         {"clear", [p](void* h) { return mgdt_periodic_clear(p(h)); }, false}}};
}

Kind parts() {
    static const Points points = random_points(40, 3);
    const auto p = [](void* h) { return static_cast<mgdt_parts*>(h); };
    return {"parts",
            [](void** out) {
                return mgdt_parts_create_with_allocator(2, handle_take, handle_give, nullptr,
                                                        reinterpret_cast<mgdt_parts**>(out));
            },
            [p](void* h) { mgdt_parts_destroy(p(h)); },
            {{"insert_points",
              [p](void* h) {
                  // A build after a refused insertion fails once, unless all points are removed.
                  const mgdt_status s = mgdt_parts_clear(p(h));
                  return s != MGDT_OK
                             ? s
                             : mgdt_parts_insert_points(p(h), 0, 40, points.data(), nullptr);
              }},
             {"build", [p](void* h) { return mgdt_parts_build(p(h)); }},
             {"check", [p](void* h) { return mgdt_parts_check(p(h), 2); }},
             {"arrays",
              [p](void* h) {
                  Statuses found;
                  for (std::int32_t part = 0; part < 2; ++part)
                      found.add(read_arrays(
                          [&](auto k, auto* n) { return mgdt_parts_get_size(p(h), part, k, n); },
                          [&](auto k, auto n, auto* x) {
                              return mgdt_parts_get_array(p(h), part, k, n, x);
                          },
                          [&](auto, auto n, auto* x) {
                              return mgdt_parts_get_coordinates(p(h), part, n, x);
                          }));
                  return found.worst;
              },
              false},
             {"clear", [p](void* h) { return mgdt_parts_clear(p(h)); }, false}}};
}

Kind triangulation() {
    static const Points points = random_points(7, 3);
    static const double planes[] = {1, 0,  0, 1, -1, 0, 0, 0, 0, 1, 0,  1,
                                    0, -1, 0, 0, 0,  0, 1, 1, 0, 0, -1, 0};
    const auto t = [](void* h) { return static_cast<mgdt_triangulation*>(h); };
    return {"triangulation",
            [](void** out) {
                return mgdt_create_with_allocator(handle_take, handle_give, nullptr,
                                                  reinterpret_cast<mgdt_triangulation**>(out));
            },
            [t](void* h) { mgdt_destroy(t(h)); },
            {{"insert_points",
              [t](void* h) {
                  // A refused insertion keeps what is in.
                  mgdt_status s = mgdt_clear(t(h));
                  if (s == MGDT_OK) s = mgdt_insert_points(t(h), 7, points.data());
                  return s;
              }},
             {"measures",
              [t](void* h) {
                  return read_measures(7, [&](auto k, auto n, auto* x) {
                      return mgdt_get_cell_measures(t(h), k, 0, nullptr, n, x);
                  });
              }},
             {"measures in a region",
              [t](void* h) {
                  return read_measures(7, [&](auto k, auto n, auto* x) {
                      return mgdt_get_cell_measures(t(h), k, 6, planes, n, x);
                  });
              }},
             {"diagram",
              [t](void* h) {
                  return make_diagram(
                      [&](mgdt_voronoi** v) { return mgdt_voronoi_create(t(h), 0, nullptr, v); });
              }},
             {"diagram in a region", [t](void* h) {
                  return make_diagram(
                      [&](mgdt_voronoi** v) { return mgdt_voronoi_create(t(h), 6, planes, v); });
              }}}};
}

void PrintTo(const Kind& kind, std::ostream* out) {
    *out << kind.name;
}

class EveryHandle : public testing::TestWithParam<Kind> {
  protected:
    // Whether step i came to its nth request, which was refused, alone or with all behind it.
    bool refuse(const Kind& kind, std::size_t i, std::int64_t nth, bool all, std::int64_t& failed) {
        void* handle = nullptr;
        EXPECT_EQ(kind.create(&handle), MGDT_OK);
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_EQ(kind.steps[k].make(handle), MGDT_OK) << kind.steps[k].name;
        fault_arm(fault_handle, nth, all ? INT64_MAX : nth + 1);
        const mgdt_status status = kind.steps[i].make(handle);
        const bool reached = fault_disarm() >= nth;
        EXPECT_TRUE(status == MGDT_OK || status == MGDT_ERR_OUT_OF_MEMORY) << status;
        failed += status != MGDT_OK;
        // The handle stays valid: the same call works then, and all others, of which not each time.
        std::size_t k = status == MGDT_OK ? i + 1 : i;
        for (; k < (nth % 16 == 1 ? kind.steps.size() : i + 1); ++k)
            EXPECT_EQ(kind.steps[k].make(handle), MGDT_OK) << kind.steps[k].name;
        kind.destroy(handle);
        return reached;
    }
};

TEST_P(EveryHandle, RunsOutOfMemory) {
    const Kind& kind = GetParam();
    const std::int64_t balance = fault_balance();
    for (std::size_t i = 0; i < kind.steps.size(); ++i)
        for (const bool all : {false, true}) {
            std::int64_t failed = 0;
            for (std::int64_t nth = 1; !testing::Test::HasFailure(); nth += step) {
                SCOPED_TRACE(std::string(kind.name) + ", " + kind.steps[i].name +
                             (all ? ", all from " : ", only ") + std::to_string(nth));
                const bool reached = refuse(kind, i, nth, all, failed);
                EXPECT_EQ(fault_balance(), balance);
                if (!reached) break;
            }
            if (kind.steps[i].asks_for_memory) {
                EXPECT_GT(failed, 0) << kind.name << ", " << kind.steps[i].name;
            }
        }
    EXPECT_EQ(handle_errors(), 0);
}

TEST_P(EveryHandle, RefusesTheHandleItself) {
    const Kind& kind = GetParam();
    const std::int64_t balance = fault_balance();
    for (std::int64_t nth = 1;; ++nth) {
        void* handle = &handle;
        fault_arm(fault_handle, nth, nth + 1);
        const mgdt_status status = kind.create(&handle);
        const bool reached = fault_disarm() >= nth;
        if (status == MGDT_OK) {
            kind.destroy(handle);
        } else {
            EXPECT_EQ(status, MGDT_ERR_OUT_OF_MEMORY);
            EXPECT_EQ(handle, nullptr);
        }
        EXPECT_EQ(fault_balance(), balance);
        if (!reached) break;
    }
}

INSTANTIATE_TEST_SUITE_P(Allocator, EveryHandle,
                         testing::Values(triangulation(), domain(), mesh(), box(), parts()),
                         [](const auto& info) {
                             std::string name;
                             for (const char c : std::string(info.param.name))
                                 name += c == ' ' ? '_' : c;
                             return name;
                         });

}  // namespace
}  // namespace faults
