// SPDX-License-Identifier: MIT
// The stack of every call and of every thread that a call starts stays below the bound that mgdt.h
// states, whatever the points: first measured on large stacks, then run on stacks that end there.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "../property/handle.hpp"
#include "../support/small.h"
#include "degenerate_sets.hpp"
#include "mgdt/mgdt_domain.h"
#include "mgdt/mgdt_parts.h"
#include "mgdt/mgdt_periodic.h"
#include "painted_stack.hpp"

namespace faults {
namespace {

using property::create;
using property::Handle;

// As mgdt.h and docs/trust.md say.
constexpr std::size_t bound = 32 * 1024;

std::int64_t count(const Points& xyz) {
    return static_cast<std::int64_t>(xyz.size() / 3);
}

Points joined(Points a, const Points& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// ------------------------------------------------------------------------------------------ points

// Towards the origin, a few points for each of 2,000 powers of two: every cell of a grid that is
// refined has one that is to be refined again.
Points nested(std::size_t n) {
    Random random(11);
    Points xyz;
    while (xyz.size() < 3 * n) {
        const int exponent = 900 - static_cast<int>(random() % 2000);
        for (int k = 0; k < 3; ++k) xyz.push_back(std::ldexp(uniform(random), exponent));
    }
    return xyz;
}

// Coordinates of which many differences have all the bits that there are: ties of spheres and of
// planes that the widest integers alone can tell.
Points widest_ties(std::size_t n) {
    Points xyz;
    Random random(12);
    while (xyz.size() < 3 * n) {
        std::array<double, 3> p = {0x1p1000, 0x1.8p1, 0x1p-1074};
        for (double& x : p)
            if (random() % 2) x = -x;
        std::shuffle(p.begin(), p.end(), random);
        xyz.insert(xyz.end(), p.begin(), p.end());
    }
    return xyz;
}

Points lattice(std::size_t n) {
    Points xyz;
    for (std::size_t i = 0; xyz.size() < 3 * n; ++i)
        for (const std::size_t k : {i % 10, i / 10 % 10, i / 100})
            xyz.push_back(static_cast<double>(k));
    return xyz;
}

Points random_points(std::size_t n) {
    return from_coordinates(n, 13, uniform);
}

// The hull and what is next to it take the widest integers, all else the filter.
Points random_points_among_extremes(std::size_t n) {
    Points xyz = random_points(n);
    const Points extremes = joined(any_doubles(8), ends_of_range(8));
    for (std::size_t i = 0; i < extremes.size(); ++i)
        xyz[3 * (n / 16 * (i / 3)) + i % 3] = extremes[i];
    return xyz;
}

struct Set {
    const char* name;
    Points (*points)(std::size_t n);
    std::size_t n;
};
const Set sets[] = {
    {"nested", nested, 300},
    {"widest ties", widest_ties, 60},
    {"ends of range", ends_of_range, 45},
    {"any doubles", any_doubles, 45},
    {"subnormals and units", subnormals_and_units, 70},
    {"spread of 2000", [](std::size_t n) { return exponent_spread(n, 2000, true); }, 45},
    {"lattice", lattice, 1000},
    {"cospherical", [](std::size_t n) { return integer_sphere(n, 231); }, 1000},
    {"moment curve", moment_curve, 200},
    {"layers", layers, 600},
    {"one plane",
     [](std::size_t n) {
         Points xyz = nested(n);
         for (std::size_t i = 2; i < xyz.size(); i += 3) xyz[i] = 0x1p-1074;
         return xyz;
     },
     300},
    {"uniform", random_points, 2000},
};

// ----------------------------------------------------------------------------------------- measure

// Makes calls, each on a thread of its own, and keeps the most that those of a kind took.
class Meter {
  public:
    template <class Call>
    void operator()(const std::string& kind, Call call, mgdt_status expected = MGDT_OK) {
        mgdt_status status = MGDT_ERR_INTERNAL;
        auto made = [&] { status = call(); };
        const StackUse use = stack_use_of(made);
        EXPECT_EQ(status, expected) << kind;
        EXPECT_LT(use.of_caller, bound) << kind;
        EXPECT_LT(use.of_worker, bound) << kind;
        StackUse& most = most_[kind];
        most.of_caller = std::max(most.of_caller, use.of_caller);
        most.of_worker = std::max(most.of_worker, use.of_worker);
        most.workers = std::max(most.workers, use.workers);
    }
    bool has_measured_workers(const std::string& kind) const {
        const auto found = most_.find(kind);
        return found != most_.end() && found->second.workers > 0;
    }
    void print() const {
        std::printf("%-34s %8s %8s\n", "bytes of stack at most", "caller", "workers");
        for (const auto& [kind, use] : most_)
            std::printf("%-34s %8zu %8zu\n", kind.c_str(), use.of_caller, use.of_worker);
    }

  private:
    std::map<std::string, StackUse> most_;
};

// -------------------------------------------------------------------------------------- what calls

struct Order {
    std::int32_t scheme;
    int separation = -1;
};
std::vector<Order> orders() {
    std::vector<Order> all;
    for (const std::int32_t scheme : order_schemes) {
        if (scheme != MGDT_ORDER_REGULAR_GRID && scheme != MGDT_ORDER_MULTI_GRID) {
            all.push_back({scheme});
            continue;
        }
        for (int separation = 0; separation < 3; ++separation) all.push_back({scheme, separation});
    }
    return all;
}

Handle handle_with(const Order& order, std::int32_t threads) {
    Handle t = create();
    EXPECT_EQ(mgdt_set_order_scheme(t.get(), order.scheme), MGDT_OK);
    EXPECT_EQ(mgdt_set_threads(t.get(), threads), MGDT_OK);
    if (order.separation >= 0) {
        EXPECT_EQ(mgdt_set_order_parameter(t.get(), MGDT_PARAMETER_SEPARATION, order.separation),
                  MGDT_OK);
    }
    return t;
}

// All that reads, and changes nothing.
void read_all(Meter& meter, const mgdt_triangulation* t, const Points& queries) {
    const std::int64_t tetrahedra = mgdt_tetrahedron_count(t), points = mgdt_point_count(t);
    const std::int64_t size = 4 * tetrahedra + 4 * points + 6 * mgdt_edge_count(t) + 16;
    std::vector<std::int64_t> v(static_cast<std::size_t>(size)), list(v.size());
    std::vector<std::int32_t> v32(v.size()), list32(v.size());
    Points weights(4 * queries.size());
    const std::int64_t n = std::min(count(queries), size);
    meter("counts", [&] {
        mgdt_hull_facet_count(t), mgdt_edge_count(t), mgdt_vertex_tetrahedra_count(t);
        return MGDT_OK;
    });
    meter("mgdt_get_tetrahedra", [&] { return mgdt_get_tetrahedra(t, size, v.data()); });
    meter("mgdt_get_tetrahedra", [&] { return mgdt_get_tetrahedra_i32(t, size, v32.data()); });
    meter("mgdt_get_neighbors", [&] { return mgdt_get_neighbors(t, size, v.data()); });
    meter("mgdt_get_neighbors", [&] { return mgdt_get_neighbors_i32(t, size, v32.data()); });
    meter("mgdt_get_hull_facets", [&] { return mgdt_get_hull_facets(t, size, v.data()); });
    meter("mgdt_get_hull_facets", [&] { return mgdt_get_hull_facets_i32(t, size, v32.data()); });
    meter("mgdt_get_edges", [&] { return mgdt_get_edges(t, size, v.data()); });
    meter("mgdt_get_edges", [&] { return mgdt_get_edges_i32(t, size, v32.data()); });
    meter("mgdt_get_point_map", [&] { return mgdt_get_point_map(t, size, v.data()); });
    meter("mgdt_get_point_map", [&] { return mgdt_get_point_map_i32(t, size, v32.data()); });
    meter("mgdt_get_vertex_tetrahedra",
          [&] { return mgdt_get_vertex_tetrahedra(t, size, v.data(), size, list.data()); });
    meter("mgdt_get_vertex_tetrahedra",
          [&] { return mgdt_get_vertex_tetrahedra_i32(t, size, v32.data(), size, list32.data()); });
    meter("mgdt_get_vertex_neighbors",
          [&] { return mgdt_get_vertex_neighbors(t, size, v.data(), size, list.data()); });
    meter("mgdt_get_gabriel_edges",
          [&] { return mgdt_get_gabriel_edges(t, size, v.data(), list.data()); });
    meter("mgdt_get_spanning_tree",
          [&] { return mgdt_get_spanning_tree(t, size, v.data(), list.data()); });
    Points centers(static_cast<std::size_t>(3 * tetrahedra)),
        squares(static_cast<std::size_t>(tetrahedra));
    meter("mgdt_get_circumcenters",
          [&] { return mgdt_get_circumcenters(t, tetrahedra, centers.data(), squares.data()); });
    for (const std::int32_t measure : {MGDT_TETRAHEDRON_VOLUME, MGDT_TETRAHEDRON_RADIUS_RATIO,
                                       MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE})
        meter("mgdt_get_tetrahedron_measures", [&] {
            return mgdt_get_tetrahedron_measures(t, measure, tetrahedra, squares.data());
        });
    if (mgdt_dimension(t) == 3) {
        Points alphas(static_cast<std::size_t>(4 * tetrahedra));
        meter("mgdt_get_alphas",
              [&] { return mgdt_get_alphas(t, 2, 4 * tetrahedra, alphas.data()); });
        meter("mgdt_get_alphas",
              [&] { return mgdt_get_alphas(t, 1, mgdt_edge_count(t), alphas.data()); });
        meter("mgdt_get_alpha_surface",
              [&] { return mgdt_get_alpha_surface(t, 1e300, size, v.data(), list.data()); });
        meter("mgdt_get_solid_alpha", [&] { return mgdt_get_solid_alpha(t, squares.data()); });
        mgdt_voronoi* voronoi = nullptr;
        meter("mgdt_voronoi_create", [&] { return mgdt_voronoi_create(t, 0, nullptr, &voronoi); });
        meter("mgdt_voronoi_drop_small_faces",
              [&] { return mgdt_voronoi_drop_small_faces(voronoi, 0, 1e-12); });
        mgdt_voronoi_destroy(voronoi);
        Points volumes(static_cast<std::size_t>(mgdt_point_count(t)));
        meter("mgdt_get_cell_measures", [&] {
            return mgdt_get_cell_measures(t, MGDT_MEASURE_VOLUME, 0, nullptr, mgdt_point_count(t),
                                          volumes.data());
        });
    }
    if (mgdt_dimension(t) == 3) {
        const Points values(static_cast<std::size_t>(mgdt_point_count(t)), 1.0);
        Points out(3 * values.size());
        for (const std::int32_t method :
             {MGDT_INTERPOLATE_LINEAR, MGDT_INTERPOLATE_LAPLACE, MGDT_INTERPOLATE_SIBSON_C1})
            meter("mgdt_interpolate", [&] {
                return mgdt_interpolate(t, method, MGDT_OUTSIDE_LINEAR, 1, values.data(), n,
                                        queries.data(), weights.data());
            });
        meter("mgdt_get_interpolation_weights", [&] {
            return mgdt_get_interpolation_weights(t, MGDT_INTERPOLATE_SIBSON, MGDT_OUTSIDE_LINEAR,
                                                  n, queries.data(), size, v.data(), 0, nullptr,
                                                  nullptr);
        });
        meter("mgdt_get_gradients",
              [&] { return mgdt_get_gradients(t, 1, values.data(), out.data()); });
    }
    meter("mgdt_locate_points",
          [&] { return mgdt_locate_points(t, n, queries.data(), v.data(), weights.data()); });
    meter("mgdt_locate_points",
          [&] { return mgdt_locate_points_i32(t, n, queries.data(), v32.data(), nullptr); });
    meter("mgdt_nearest_vertices",
          [&] { return mgdt_nearest_vertices(t, n, queries.data(), v.data()); });
    for (std::size_t i = 0; i < queries.size(); i += 3 * (1 + queries.size() / 45)) {
        meter("mgdt_locate", [&] { return mgdt_locate(t, &queries[i], v.data()); });
        meter("mgdt_traverse_segment", [&] {
            return mgdt_traverse_segment(t, &queries[i], queries.data(), size, v.data(), nullptr,
                                         list.data());
        });
        meter("mgdt_nearest_vertex", [&] { return mgdt_nearest_vertex(t, &queries[i], v.data()); });
    }
    meter("mgdt_check", [&] { return mgdt_check(t, MGDT_CHECK_CANONICAL); });
    if (tetrahedra > 0)
        meter(
            "a call that fails", [&] { return mgdt_get_tetrahedra(t, 1, v.data()); },
            MGDT_ERR_BUFFER_TOO_SMALL);
}

void read_all_settings(Meter& meter, mgdt_triangulation* t, const Points& queries) {
    for (const int canonical : {0, 1}) {
        ASSERT_EQ(mgdt_set_canonical_output(t, canonical), MGDT_OK);
        read_all(meter, t, queries);
    }
}

// Each set with each order, in one call, in two halves and a few points at a time, for each
// instruction set, with spheres kept and computed.
void small_sets(Meter& meter) {
    const std::string best = mgdt_isa_name(create().get());
    for (const Set& set : sets) {
        SCOPED_TRACE(set.name);
        const Points xyz = set.points(set.n);
        for (const Order& order : orders()) {
            SCOPED_TRACE(mgdt_order_scheme_name(order.scheme));
            const Handle t = handle_with(order, 1);
            meter("mgdt_insert_points",
                  [&] { return mgdt_insert_points(t.get(), count(xyz), xyz.data()); });
        }
        for (const char* isa : {"baseline", "avx2", "avx512", "neon"})
            for (const int compact : {0, 1}) {
                SCOPED_TRACE(isa);
                const Handle t = create();
                if (mgdt_set_isa(t.get(), isa) != MGDT_OK) continue;
                ASSERT_EQ(mgdt_set_compact(t.get(), compact), MGDT_OK);
                const std::int64_t half = count(xyz) / 2;
                meter("mgdt_insert_points", [&] {
                    return mgdt_insert_points_strided(t.get(), half, xyz.data(), xyz.data() + 1,
                                                      xyz.data() + 2, 3);
                });
                std::int64_t k = half;
                for (std::int64_t batch = 1; k + batch <= count(xyz) && k < half + 300;
                     batch = batch % 17 + 1) {
                    meter("mgdt_insert_points, 1 to 17",
                          [&] { return mgdt_insert_points(t.get(), batch, xyz.data() + 3 * k); });
                    k += batch;
                }
                meter("mgdt_insert_points", [&] {
                    return mgdt_insert_points(t.get(), count(xyz) - k, xyz.data() + 3 * k);
                });
                meter("mgdt_set_compact", [&] {
                    const mgdt_status status = mgdt_set_compact(t.get(), !compact);
                    return status == MGDT_OK ? mgdt_set_compact(t.get(), compact) : status;
                });
                if (isa == best || compact) read_all_settings(meter, t.get(), xyz);
                meter("mgdt_clear", [&] { return mgdt_clear(t.get()); });
            }
    }
}

// One point after another, then many with a call; around the last of them are all others.
void changes(Meter& meter) {
    for (const Set& set : sets)
        for (const char* isa : {"baseline", "avx2", "avx512", "neon"}) {
            SCOPED_TRACE(std::string(set.name) + ", " + isa);
            const Handle t = create();
            if (mgdt_set_isa(t.get(), isa) != MGDT_OK) continue;
            Points xyz = set.points(set.n);
            ASSERT_EQ(mgdt_insert_points(t.get(), count(xyz), xyz.data()), MGDT_OK);
            for (std::int64_t i = 0; i + 1 < std::min<std::int64_t>(100, count(xyz)); i += 2) {
                meter("mgdt_remove_points", [&] { return mgdt_remove_points(t.get(), 1, &i); });
                const std::int64_t next = i + 1;
                const double* const place = xyz.data() + 3 * i;
                meter("mgdt_move_points",
                      [&] { return mgdt_move_points(t.get(), 1, &next, place); });
            }
            meter("mgdt_move_points, all",
                  [&] { return mgdt_move_points(t.get(), count(xyz), nullptr, xyz.data()); });
        }
    Points hub(3, 0.0);
    const Points around = random_points(2000);
    for (std::size_t i = 0; i < around.size(); i += 3) {
        double p[3], square = 0;
        for (std::size_t k = 0; k < 3; ++k) p[k] = around[i + k] - 0.5, square += p[k] * p[k];
        for (const double x : p) hub.push_back(x / std::sqrt(square));
    }
    // Ties that take the widest integers.
    Points wide(3, 0.0);
    for (int k = 1; k <= 40; ++k)
        for (int signs = 0; signs < 8; ++signs)
            for (const double x :
                 {signs & 1 ? 0x1p1000 : -0x1p1000, signs & 2 ? 0x1.8p1 * k : -0x1.8p1 * k,
                  signs & 4 ? 0x1p-1074 * k : -0x1p-1074 * k})
                wide.push_back(x);
    for (const Points& xyz : {hub, wide}) {
        const Handle t = create();
        ASSERT_EQ(mgdt_insert_points(t.get(), count(xyz), xyz.data()), MGDT_OK);
        const std::int64_t centre = 0;
        const double place[3] = {0.1, 0, 0};
        meter("mgdt_move_points, large link",
              [&] { return mgdt_move_points(t.get(), 1, &centre, place); });
        meter("mgdt_remove_points, large link",
              [&] { return mgdt_remove_points(t.get(), 1, &centre); });
        double link_sizes;
        ASSERT_EQ(mgdt_get_stat(t.get(), MGDT_STAT_LINK_VERTICES, &link_sizes), MGDT_OK);
        EXPECT_GT(link_sizes, 2 * 128.0);
    }
}

// Blocks of cubes with all sides, and triangles of each set, most of which cross.
void domains(Meter& meter) {
    const auto meter_domain = [&](const Points& xyz, const std::vector<std::int64_t>& corners) {
        mgdt_domain* d = nullptr;
        ASSERT_EQ(mgdt_domain_create(&d), MGDT_OK);
        meter("mgdt_domain_set_points",
              [&] { return mgdt_domain_set_points(d, count(xyz), xyz.data()); });
        const auto facets = static_cast<std::int64_t>(corners.size() / 3);
        meter("mgdt_domain_set_facets",
              [&] { return mgdt_domain_set_facets(d, facets, nullptr, corners.data(), nullptr); });
        const mgdt_status status = mgdt_domain_validate(d);
        meter(
            "mgdt_domain_validate", [&] { return mgdt_domain_validate(d); }, status);
        mgdt_mesh* m = nullptr;
        const mgdt_status built = mgdt_domain_build(d, &m);
        meter(
            "mgdt_domain_build",
            [&] {
                mgdt_mesh_destroy(m);
                return mgdt_domain_build(d, &m);
            },
            built);
        if (built == MGDT_OK) {
            meter("mgdt_mesh_check", [&] { return mgdt_mesh_check(m); });
            meter("mgdt_domain_check", [&] { return mgdt_domain_check(d, m); });
        }
        mgdt_mesh_destroy(m);
        // Hundreds of points and triangles in one plane would take long with such coordinates.
        const auto few = std::min<std::int64_t>(count(xyz), 20);
        ASSERT_EQ(mgdt_domain_set_points(d, few, xyz.data()), MGDT_OK);
        if (facets >= few) {
            ASSERT_EQ(mgdt_domain_set_facets(d, few - 2, nullptr, corners.data(), nullptr),
                      MGDT_OK);
        }
        meter("mgdt_domain_clean", [&] { return mgdt_domain_clean(d); });
        mgdt_domain_destroy(d);
        EXPECT_EQ(status == MGDT_OK, built == MGDT_OK || built == MGDT_ERR_RESOLUTION ||
                                         built == MGDT_ERR_OPEN_BOUNDARY);
    };
    for (const Set& set : sets) {
        SCOPED_TRACE(set.name);
        const Points xyz = set.points(set.n);
        std::vector<std::int64_t> corners;
        for (std::int64_t i = 0; i + 2 < count(xyz) && i < 300; ++i)
            for (std::int64_t k = 0; k < 3; ++k) corners.push_back(i + k);
        meter_domain(xyz, corners);
        meter_domain(xyz, {});
    }
    // The sides of cubes are squares of a lattice; every third cube is twisted.
    Points xyz;
    std::vector<std::int64_t> corners;
    for (int cube = 0; cube < 60; ++cube) {
        const std::int64_t first = count(xyz);
        for (int z = 0; z < 2; ++z)
            for (int i = 0; i < 3; ++i) {
                const double turn = 2.0943951023931953 * i - (cube % 3 == 0 ? 0.5 : 0.0) * z;
                for (const double x : {4.0 * cube + std::cos(turn), std::sin(turn), double(z)})
                    xyz.push_back(x);
            }
        for (const int v : {0, 2, 1, 3, 4, 5, 0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 2, 0, 5, 0, 3, 5})
            corners.push_back(first + v);
    }
    meter_domain(xyz, corners);
}

// The first points of each set in boxes of one to three vectors. Points too far away are refused.
void periodic_boxes(Meter& meter) {
    const double vectors[9] = {1, 0, 0, 0.5, 1, 0, 0, 0.25, 1};
    for (const Set& set : sets) {
        SCOPED_TRACE(set.name);
        const Points xyz = set.points(set.n);
        const std::int64_t n = std::min<std::int64_t>(count(xyz), 300);
        for (std::int32_t dimensions = 1; dimensions <= 3; ++dimensions) {
            mgdt_periodic* p = nullptr;
            meter("mgdt_periodic_create", [&] {
                mgdt_periodic_destroy(p);
                return mgdt_periodic_create(&p);
            });
            meter("mgdt_periodic_set_vectors",
                  [&] { return mgdt_periodic_set_vectors(p, dimensions, vectors); });
            ASSERT_EQ(mgdt_periodic_insert_points(p, n, xyz.data()), MGDT_OK);
            const mgdt_status built = mgdt_periodic_build(p);
            meter(
                "mgdt_periodic_build", [&] { return mgdt_periodic_build(p); }, built);
            if (built == MGDT_OK) {
                meter("mgdt_periodic_check", [&] { return mgdt_periodic_check(p); });
                std::vector<double> x(static_cast<std::size_t>(n));
                const mgdt_status status =
                    mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_AREA, n, x.data());
                meter(
                    "mgdt_periodic_get_cell_measures",
                    [&] {
                        return mgdt_periodic_get_cell_measures(p, MGDT_MEASURE_AREA, n, x.data());
                    },
                    status);
                meter(
                    "mgdt_periodic_create_voronoi",
                    [&] {
                        mgdt_voronoi* v = nullptr;
                        const mgdt_status made = mgdt_periodic_create_voronoi(p, &v);
                        mgdt_voronoi_destroy(v);
                        return made;
                    },
                    status);
                meter("mgdt_periodic_move_points",
                      [&] { return mgdt_periodic_move_points(p, n, nullptr, xyz.data()); });
            }
            mgdt_periodic_destroy(p);
        }
    }
}

// Calls that are given up: deep in an insertion, and for what they were given.
void failures(Meter& meter) {
    const Points xyz = nested(300);
    const Points uniform_ones = random_points(20000);
    for (const Order& order : orders()) {
        SCOPED_TRACE(mgdt_order_scheme_name(order.scheme));
        for (const std::int64_t limit : {200 * 1024, 3 * 1024 * 1024}) {
            const Handle t = handle_with(order, 1);
            ASSERT_EQ(mgdt_set_memory_limit(t.get(), limit), MGDT_OK);
            meter(
                "out of memory",
                [&] { return mgdt_insert_points(t.get(), 20000, uniform_ones.data()); },
                MGDT_ERR_OUT_OF_MEMORY);
        }
    }
    meter("mgdt_create to mgdt_destroy", [] {
        mgdt_triangulation* t = nullptr;
        mgdt_status status = mgdt_create(&t);
        if (status == MGDT_OK) status = mgdt_reserve(t, 100000);
        mgdt_destroy(t);
        return status;
    });
    const Handle t = create();
    ASSERT_EQ(mgdt_set_progress(
                  t.get(), [](double fraction, void*) { return fraction > 0.5 ? 1 : 0; }, nullptr),
              MGDT_OK);
    meter(
        "cancelled", [&] { return mgdt_insert_points(t.get(), count(xyz), xyz.data()); },
        MGDT_ERR_CANCELLED);
    Points with_nan = xyz;
    with_nan[600] = std::numeric_limits<double>::quiet_NaN();
    meter(
        "a call that fails",
        [&] { return mgdt_insert_points(t.get(), count(with_nan), with_nan.data()); },
        MGDT_ERR_NOT_FINITE);
}

// Sets so large that orders, insertions and calls have work for several threads.
void large_sets(Meter& meter) {
    const auto insert = [&](const Order& order, std::int32_t threads, const Points& xyz) {
        SCOPED_TRACE(mgdt_order_scheme_name(order.scheme));
        Handle t = handle_with(order, threads);
        meter("mgdt_insert_points, many",
              [&] { return mgdt_insert_points(t.get(), count(xyz), xyz.data()); });
        return t;
    };
    // Cancelled at the first points, when the order is made.
    const auto order_only = [&](const Order& order, std::int32_t threads, const Points& xyz) {
        SCOPED_TRACE(mgdt_order_scheme_name(order.scheme));
        const Handle t = handle_with(order, threads);
        ASSERT_EQ(
            mgdt_set_progress(
                t.get(), [](double fraction, void*) { return fraction > 0 ? 1 : 0; }, nullptr),
            MGDT_OK);
        meter(
            "mgdt_insert_points, cancelled",
            [&] { return mgdt_insert_points(t.get(), count(xyz), xyz.data()); },
            MGDT_ERR_CANCELLED);
    };
    const Points many_nested = nested(140000), many = random_points(140000);
    for (const Order& order : orders()) order_only(order, 4, many);
    for (const std::int32_t scheme : {MGDT_ORDER_HILBERT, MGDT_ORDER_MULTI_GRID})
        order_only({scheme}, 4, many_nested);
    order_only({MGDT_ORDER_HILBERT}, 1, random_points(600000));

    const Handle t = insert({MGDT_ORDER_AUTO}, 4, many);
    read_all_settings(meter, t.get(), many);
    std::vector<std::int64_t> found(many_nested.size() / 3);
    meter("mgdt_locate_points", [&] {
        return mgdt_locate_points(t.get(), count(many_nested), many_nested.data(), found.data(),
                                  nullptr);
    });
    meter("mgdt_nearest_vertices", [&] {
        return mgdt_nearest_vertices(t.get(), count(many_nested), many_nested.data(), found.data());
    });
    const Handle ties = insert({MGDT_ORDER_AUTO}, 4, integer_sphere(33000, 4389));
    meter("mgdt_check", [&] { return mgdt_check(ties.get(), MGDT_CHECK_CANONICAL); });
    const Handle extreme = insert({MGDT_ORDER_AUTO}, 2, random_points_among_extremes(20000));
    meter("mgdt_check", [&] { return mgdt_check(extreme.get(), MGDT_CHECK_CANONICAL); });
}

// In parts, with all of it in one and dealt out, and a part at a time.
void parts(Meter& meter) {
    const auto look = [](const mgdt_parts* p, std::int32_t part, void*) -> std::int32_t {
        std::vector<std::int64_t> corners(1000000);
        return mgdt_parts_get_array(p, part, MGDT_PARTS_LOCAL_CORNERS, 1000000, corners.data());
    };
    for (const Set& set : sets) {
        SCOPED_TRACE(set.name);
        const Points xyz = set.points(set.n);
        mgdt_parts* p = nullptr;
        meter("mgdt_parts_create", [&] { return mgdt_parts_create(5, &p); });
        std::vector<std::int64_t> ids(xyz.size() / 3), values(1000000);
        for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<std::int64_t>(i);
        for (int way = 0; way < 2; ++way) {
            for (std::int32_t part = 0; part < 5; ++part) {
                const std::int64_t n = count(xyz), first = way == 0 ? 0 : n * part / 5,
                                   last = way == 0 ? (part == 4 ? n : 0) : n * (part + 1) / 5;
                meter("mgdt_parts_insert_points", [&] {
                    return mgdt_parts_insert_points(p, part, last - first, xyz.data() + 3 * first,
                                                    way == 0 ? nullptr : ids.data() + first);
                });
            }
            // Equal points with several ids are none that clash.
            meter("mgdt_parts_build", [&] { return mgdt_parts_build(p); });
            meter("mgdt_parts_check", [&] { return mgdt_parts_check(p, MGDT_CHECK_CANONICAL); });
            for (std::int32_t array = MGDT_PARTS_POINT_MAP; array <= MGDT_PARTS_NEIGHBORS;
                 ++array) {
                std::int64_t size = 0;
                if (mgdt_parts_get_size(p, 0, array, &size) != MGDT_OK) continue;
                meter("mgdt_parts_get_array",
                      [&] { return mgdt_parts_get_array(p, 0, array, 1000000, values.data()); });
            }
            meter("mgdt_parts_build_each", [&] { return mgdt_parts_build_each(p, look, nullptr); });
            meter("mgdt_parts_clear", [&] { return mgdt_parts_clear(p); });
        }
        mgdt_parts_destroy(p);
    }
}

void make_all_calls(Meter& meter) {
    parts(meter);
    small_sets(meter);
    changes(meter);
    domains(meter);
    periodic_boxes(meter);
    failures(meter);
    large_sets(meter);
}

TEST(Stack, IsBounded) {
    make_stacks(256 * 1024);
    Meter meter;
    make_all_calls(meter);
    meter.print();
    for (const char* kind :
         {"mgdt_insert_points, many", "mgdt_insert_points, cancelled", "mgdt_get_tetrahedra",
          "mgdt_get_edges", "mgdt_locate_points", "mgdt_nearest_vertices", "mgdt_check"})
        EXPECT_TRUE(meter.has_measured_workers(kind)) << kind;
}

// Where the page after the bound is nobody's.
TEST(Stack, EndsThere) {
    make_stacks(256 * 1024);
    auto nothing = [] {};
    stack_use_of(nothing);
    make_stacks(bound + caller_stack.above());
    Meter meter;
    if (is_small()) {
        parts(meter);
        domains(meter);
        periodic_boxes(meter);
        failures(meter);
    } else {
        make_all_calls(meter);
    }
}

}  // namespace
}  // namespace faults
