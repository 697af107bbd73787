// SPDX-License-Identifier: MIT
// Everything that a handle exports, taken in both widths into buffers of the exact size, and what
// must hold between the arrays whatever the points.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <type_traits>
#include <vector>

#include "../support/messages.hpp"
#include "input.hpp"
#include "mgdt/mgdt.h"
#include "mgdt/mgdt_voronoi.h"
#include "predicates/predicates.hpp"

namespace fuzz {

using Indices = std::vector<std::int64_t>;

using mgdt_tests::error_of;

// An array of exactly so many elements: the sanitizer sees a step beyond it. With a margin, values
// that nothing may change stand on both sides, and are looked at.
template <class T>
class Exact {
  public:
    Exact(std::size_t size, std::size_t margin)
        : size_(size), margin_(margin), values_(size + 2 * margin, guard) {}
    T* data() { return values_.data() + margin_; }
    std::int64_t capacity() const { return static_cast<std::int64_t>(size_); }
    bool is_untouched() const {
        return std::all_of(values_.begin(), values_.end(), [](T v) { return v == guard; });
    }
    std::vector<T> take() const {
        for (std::size_t i = 0; i < margin_; ++i)
            FUZZ_REQUIRE(values_[i] == guard && values_[values_.size() - 1 - i] == guard,
                         "a value beside the buffer is overwritten");
        const auto begin = values_.begin() + static_cast<std::ptrdiff_t>(margin_);
        return {begin, begin + static_cast<std::ptrdiff_t>(size_)};
    }

  private:
    static constexpr T guard = static_cast<T>(-77);
    std::size_t size_, margin_;
    std::vector<T> values_;
};

template <class Int>
using Get = mgdt_status (*)(const mgdt_triangulation*, std::int64_t, Int*);

inline Indices get(Get<std::int64_t> wide, Get<std::int32_t> narrow, const mgdt_triangulation* t,
                   std::int64_t size, std::size_t margin) {
    Exact<std::int64_t> a(static_cast<std::size_t>(size), margin);
    Exact<std::int32_t> b(static_cast<std::size_t>(size), margin);
    FUZZ_REQUIRE(wide(t, size, a.data()) == MGDT_OK, error_of(t));
    FUZZ_REQUIRE(narrow(t, size, b.data()) == MGDT_OK, error_of(t));
    const Indices values = a.take();
    const std::vector<std::int32_t> same = b.take();
    FUZZ_REQUIRE(std::equal(values.begin(), values.end(), same.begin()), "64 and 32 bits differ");
    return values;
}

struct Exports {
    int base = 0, dimension = -1;
    std::int64_t points = 0, vertices = 0;
    Indices tetrahedra, neighbors, hull, edges, map, offsets, list, neighbor_offsets, neighbor_list;
    Indices gabriel, tree, segment;
    std::vector<double> centers, squares, volumes, faces, alphas;

    Exports(const mgdt_triangulation* t, int index_base, std::size_t margin)
        : base(index_base),
          dimension(mgdt_dimension(t)),
          points(mgdt_point_count(t)),
          vertices(mgdt_vertex_count(t)) {
        const std::int64_t count = mgdt_tetrahedron_count(t);
        tetrahedra = get(mgdt_get_tetrahedra, mgdt_get_tetrahedra_i32, t, 4 * count, margin);
        neighbors = get(mgdt_get_neighbors, mgdt_get_neighbors_i32, t, 4 * count, margin);
        hull = get(mgdt_get_hull_facets, mgdt_get_hull_facets_i32, t, 3 * mgdt_hull_facet_count(t),
                   margin);
        edges = get(mgdt_get_edges, mgdt_get_edges_i32, t, 2 * mgdt_edge_count(t), margin);
        map = get(mgdt_get_point_map, mgdt_get_point_map_i32, t, points, margin);
        take_list(t, mgdt_get_vertex_tetrahedra, mgdt_get_vertex_tetrahedra_i32,
                  mgdt_vertex_tetrahedra_count(t), margin, offsets, list);
        take_list(t, mgdt_get_vertex_neighbors, mgdt_get_vertex_neighbors_i32,
                  mgdt_vertex_neighbors_count(t), margin, neighbor_offsets, neighbor_list);
        gabriel = take_graph(t, mgdt_get_gabriel_edges, mgdt_get_gabriel_edges_i32, margin);
        tree = take_graph(t, mgdt_get_spanning_tree, mgdt_get_spanning_tree_i32, margin);
        take_circumcenters(t, margin);
        take_measures(t, margin);
        take_segment(t, margin);
        take_cells(t, margin);
        take_values(t, margin);
        for (Indices* array : {&tetrahedra, &neighbors, &hull, &edges, &map, &offsets, &list,
                               &neighbor_offsets, &neighbor_list})
            for (std::int64_t& v : *array) v -= base;
    }

    bool operator==(const Exports& o) const {
        return dimension == o.dimension && points == o.points && vertices == o.vertices &&
               tetrahedra == o.tetrahedra && neighbors == o.neighbors && hull == o.hull &&
               edges == o.edges && map == o.map && offsets == o.offsets && list == o.list &&
               neighbor_offsets == o.neighbor_offsets && neighbor_list == o.neighbor_list &&
               centers == o.centers && squares == o.squares && volumes == o.volumes &&
               faces == o.faces && alphas == o.alphas && gabriel == o.gabriel && tree == o.tree &&
               segment == o.segment;
    }
    std::size_t count() const { return tetrahedra.size() / 4; }
    bool is_in(std::size_t point) const { return map[point] >= 0; }

    // What the arrays say of each other.
    void verify() const {
        verify_map();
        verify_neighbors();
        verify_edges();
        verify_list();
        verify_vertex_neighbors();
        FUZZ_REQUIRE(dimension != 3 || static_cast<std::int64_t>(tree.size()) == 2 * (vertices - 1),
                     "the tree does not join all");
        FUZZ_REQUIRE(contains(gabriel, tree), "an edge of the tree is not in Gabriel's graph");
        FUZZ_REQUIRE((dimension == 3) == !tetrahedra.empty(), std::to_string(dimension));
        if (dimension != 3) return;
        const auto v = static_cast<std::int64_t>(vertices), e = size(edges) / 2, h = size(hull) / 3,
                   t = size(tetrahedra) / 4;
        FUZZ_REQUIRE(2 * (v - e - t) + 4 * t + h == 2, "Euler's relation");  // V - E + F - T = 1
        const std::set<std::int64_t> on_hull(hull.begin(), hull.end());
        FUZZ_REQUIRE(h == 2 * static_cast<std::int64_t>(on_hull.size()) - 4,
                     "the hull is no sphere");
    }

    // What they say of space.
    void verify_geometry(const std::vector<std::array<double, 3>>& xyz) const {
        for (std::size_t i = 0; i < map.size(); ++i)
            if (is_in(i))
                FUZZ_REQUIRE(xyz[i] == xyz[static_cast<std::size_t>(map[i])], std::to_string(i));
        const auto at = [&](std::int64_t v) { return xyz[static_cast<std::size_t>(v)].data(); };
        for (std::size_t t = 0; t < tetrahedra.size(); t += 4) {
            const std::int64_t* v = &tetrahedra[t];
            FUZZ_REQUIRE(mgdt::orientation(at(v[0]), at(v[1]), at(v[2]), at(v[3])) > 0,
                         "tetrahedron " + std::to_string(t / 4));
        }
        // Convex, and seen from outside.
        for (std::size_t h = 0; h < hull.size(); h += 3)
            for (std::size_t q = 0; q < xyz.size(); ++q)
                FUZZ_REQUIRE(!is_in(q) || mgdt::orientation(at(hull[h]), at(hull[h + 1]),
                                                            at(hull[h + 2]), at(size(q))) <= 0,
                             "hull facet " + std::to_string(h / 3));
    }

  private:
    static std::int64_t size(const Indices& array) {
        return static_cast<std::int64_t>(array.size());
    }
    static std::int64_t size(std::size_t n) { return static_cast<std::int64_t>(n); }

    template <class Wide, class Narrow>
    void take_list(const mgdt_triangulation* t, Wide wide, Narrow narrow, std::int64_t length,
                   std::size_t margin, Indices& to_offsets, Indices& to_list) const {
        const auto n = static_cast<std::size_t>(points) + 1, m = static_cast<std::size_t>(length);
        Exact<std::int64_t> o(n, margin), l(m, margin);
        Exact<std::int32_t> o32(n, margin), l32(m, margin);
        FUZZ_REQUIRE(wide(t, o.capacity(), o.data(), l.capacity(), l.data()) == MGDT_OK,
                     error_of(t));
        FUZZ_REQUIRE(narrow(t, o.capacity(), o32.data(), l.capacity(), l32.data()) == MGDT_OK,
                     error_of(t));
        to_offsets = o.take();
        to_list = l.take();
        const std::vector<std::int32_t> a = o32.take(), b = l32.take();
        FUZZ_REQUIRE(std::equal(a.begin(), a.end(), to_offsets.begin()), "64 and 32 bits differ");
        FUZZ_REQUIRE(std::equal(b.begin(), b.end(), to_list.begin()), "64 and 32 bits differ");
    }

    template <class Wide, class Narrow>
    Indices take_graph(const mgdt_triangulation* t, Wide wide, Narrow narrow,
                       std::size_t margin) const {
        std::int64_t size = -1;
        std::int32_t size32 = -1;
        (void)wide(t, 0, nullptr, &size);
        FUZZ_REQUIRE(size >= 0 && 2 * size <= static_cast<std::int64_t>(edges.size()),
                     std::to_string(size));
        Exact<std::int64_t> a(2 * static_cast<std::size_t>(size), margin);
        Exact<std::int32_t> b(2 * static_cast<std::size_t>(size), margin);
        FUZZ_REQUIRE(wide(t, a.capacity(), a.data(), &size) == MGDT_OK, error_of(t));
        FUZZ_REQUIRE(narrow(t, b.capacity(), b.data(), &size32) == MGDT_OK, error_of(t));
        Indices v = a.take();
        const std::vector<std::int32_t> same = b.take();
        FUZZ_REQUIRE(size == size32 && std::equal(v.begin(), v.end(), same.begin()),
                     "64 and 32 bits differ");
        for (std::int64_t& k : v) k -= base;
        return v;
    }

    void take_circumcenters(const mgdt_triangulation* t, std::size_t margin) {
        Exact<double> xyz(3 * count(), margin), radius2(count(), margin);
        FUZZ_REQUIRE(mgdt_get_circumcenters(t, static_cast<std::int64_t>(count()), xyz.data(),
                                            radius2.data()) == MGDT_OK,
                     error_of(t));
        centers = xyz.take();
        squares = radius2.take();
        for (const double x : centers) FUZZ_REQUIRE(!std::isnan(x), "a centre");
        for (const double x : squares) FUZZ_REQUIRE(x >= 0, "a radius");
    }

    void take_measures(const mgdt_triangulation* t, std::size_t margin) {
        const auto measured = [&](std::int32_t measure) {
            Exact<double> x(count(), margin);
            FUZZ_REQUIRE(mgdt_get_tetrahedron_measures(
                             t, measure, static_cast<std::int64_t>(count()), x.data()) == MGDT_OK,
                         error_of(t));
            return x.take();
        };
        for (const double x : measured(MGDT_TETRAHEDRON_VOLUME)) FUZZ_REQUIRE(x >= 0, "a volume");
        for (const double x : measured(MGDT_TETRAHEDRON_LONGEST_EDGE))
            FUZZ_REQUIRE(x > 0, "the length of an edge");
        for (const double x : measured(MGDT_TETRAHEDRON_RADIUS_RATIO))
            FUZZ_REQUIRE(x >= 0 && x <= 1 + 1e-12, "a ratio of radii");
        const std::vector<double> least = measured(MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE),
                                  largest = measured(MGDT_TETRAHEDRON_LARGEST_DIHEDRAL_ANGLE);
        // Of a regular tetrahedron both are acos(1/3).
        for (std::size_t i = 0; i < least.size(); ++i)
            FUZZ_REQUIRE(least[i] >= 0 && least[i] <= 1.2309595 && largest[i] >= 1.2309594 &&
                             largest[i] <= 3.1415927,
                         "angles");
    }

    // A segment between two centres of circumspheres.
    void take_segment(const mgdt_triangulation* t, std::size_t margin) {
        if (count() == 0) return;
        const double a[3] = {centers[0], centers[1], centers[2]},
                     b[3] = {centers[centers.size() - 3], centers[centers.size() - 2],
                             centers[centers.size() - 1]};
        for (const double x : {a[0], a[1], a[2], b[0], b[1], b[2]})
            if (!std::isfinite(x)) return;
        std::int64_t found = -1;
        const mgdt_status short_of = mgdt_traverse_segment(t, a, b, 0, nullptr, nullptr, &found);
        FUZZ_REQUIRE(short_of == (found > 0 ? MGDT_ERR_BUFFER_TOO_SMALL : MGDT_OK), error_of(t));
        if (found == 0) return;
        Exact<std::int64_t> way(static_cast<std::size_t>(found), margin);
        Exact<double> parameters(static_cast<std::size_t>(found) + 1, margin);
        FUZZ_REQUIRE(
            mgdt_traverse_segment(t, a, b, found, way.data(), parameters.data(), &found) == MGDT_OK,
            error_of(t));
        const Indices passed = way.take();
        const std::vector<double> at = parameters.take();
        FUZZ_REQUIRE(at.front() >= 0 && at.back() <= 1 && std::is_sorted(at.begin(), at.end()),
                     "the parameters of a segment");
        for (const std::int64_t k : passed)
            FUZZ_REQUIRE(k >= base && k < base + static_cast<std::int64_t>(count()),
                         "a tetrahedron of a segment");
        segment = passed;
    }

    // Faces have no larger alphas than what they are faces of, and the hull is the last surface.
    void take_alphas(const mgdt_triangulation* t, std::size_t margin) {
        Exact<double> of_facets(4 * count(), margin);
        FUZZ_REQUIRE(mgdt_get_alphas(t, 2, static_cast<std::int64_t>(4 * count()),
                                     of_facets.data()) == MGDT_OK,
                     error_of(t));
        alphas = of_facets.take();
        for (std::size_t k = 0; k < alphas.size(); ++k)
            FUZZ_REQUIRE(alphas[k] >= 0 && alphas[k] <= squares[k / 4], "the alpha of a facet");
        std::int64_t facets = -1;
        Exact<std::int64_t> surface(static_cast<std::size_t>(3 * mgdt_hull_facet_count(t)), margin);
        FUZZ_REQUIRE(mgdt_get_alpha_surface(t, std::numeric_limits<double>::infinity(),
                                            3 * mgdt_hull_facet_count(t), surface.data(),
                                            &facets) == MGDT_OK,
                     error_of(t));
        FUZZ_REQUIRE(facets == mgdt_hull_facet_count(t), "facets of the hull");
    }

    // Cells in themselves, and in a box that all points are in.
    void take_cells(const mgdt_triangulation* t, std::size_t margin) {
        const auto take = [&](std::int32_t measure, const std::vector<double>& planes) {
            const std::int64_t count = measure == MGDT_MEASURE_CENTROID ? 3 * points : points;
            Exact<double> x(static_cast<std::size_t>(count), margin);
            const mgdt_status status =
                mgdt_get_cell_measures(t, measure, static_cast<std::int64_t>(planes.size() / 4),
                                       planes.data(), count, x.data());
            FUZZ_REQUIRE(
                status == (vertices > 0 && dimension < 3 ? MGDT_ERR_INVALID_ARGUMENT : MGDT_OK),
                error_of(t));
            return status == MGDT_OK ? x.take() : std::vector<double>{};
        };
        volumes = take(MGDT_MEASURE_VOLUME, {});
        faces = take(MGDT_MEASURE_FACES, {});
        take_alphas(t, margin);
        const std::vector<double> centroids = take(MGDT_MEASURE_CENTROID, {});
        for (const double x : take(MGDT_MEASURE_AREA, {})) FUZZ_REQUIRE(x >= 0, "an area");
        for (const double x : centroids) FUZZ_REQUIRE(!std::isnan(x), "a centroid");
        for (std::size_t k = 0; k < volumes.size(); ++k) {
            FUZZ_REQUIRE(volumes[k] >= 0, "a volume");
            const bool is_vertex = is_in(k) && map[k] - base == static_cast<std::int64_t>(k);
            FUZZ_REQUIRE((faces[k] >= 3) == is_vertex, "number of faces");
        }
    }

    // A constant at some centres of circumspheres, of which many are outside, and far away.
    void take_values(const mgdt_triangulation* t, std::size_t margin) {
        std::vector<double> xyz = {0, 0, 0, 1e308, -1e308, 1, 1e-308, 0x1p-1074, 0};
        for (std::size_t k = 0; k < centers.size() && k < 24; ++k)
            xyz.push_back(std::isfinite(centers[k]) ? centers[k] : 0);
        xyz.resize(xyz.size() / 3 * 3);
        const std::vector<double> ones(static_cast<std::size_t>(points), 1.0);
        const bool is_flat = vertices > 0 && dimension < 3;
        for (const std::int32_t method :
             {MGDT_INTERPOLATE_LINEAR, MGDT_INTERPOLATE_NEAREST, MGDT_INTERPOLATE_SIBSON,
              MGDT_INTERPOLATE_LAPLACE, MGDT_INTERPOLATE_SIBSON_C1})
            for (const std::int32_t outside : {MGDT_OUTSIDE_NONE, MGDT_OUTSIDE_NEAREST,
                                               MGDT_OUTSIDE_BOUNDARY, MGDT_OUTSIDE_LINEAR}) {
                // Each method with one of them a time.
                if ((method + outside) / 10 % 4 != (points + vertices) % 4) continue;
                const std::size_t places = xyz.size() / 3;
                Exact<double> out(places, margin);
                const mgdt_status status =
                    mgdt_interpolate(t, method, outside, 1, ones.data(),
                                     static_cast<std::int64_t>(places), xyz.data(), out.data());
                FUZZ_REQUIRE(status == (is_flat && method != MGDT_INTERPOLATE_NEAREST
                                            ? MGDT_ERR_INVALID_ARGUMENT
                                            : MGDT_OK),
                             error_of(t));
                if (status != MGDT_OK) continue;
                for (const double x : out.take())
                    FUZZ_REQUIRE(std::abs(x - 1) < 1e-9 || (vertices == 0 && std::isnan(x)) ||
                                     (outside == MGDT_OUTSIDE_NONE && std::isnan(x)),
                                 std::to_string(x));
            }
        Exact<double> gradients(3 * static_cast<std::size_t>(points), margin);
        const mgdt_status status = mgdt_get_gradients(t, 1, ones.data(), gradients.data());
        FUZZ_REQUIRE(status == (is_flat ? MGDT_ERR_INVALID_ARGUMENT : MGDT_OK), error_of(t));
    }

    // Whether the edges, sorted, have all of some others.
    static bool contains(const Indices& all, const Indices& some) {
        using Pairs = std::set<std::array<std::int64_t, 2>>;
        Pairs have, wanted;
        for (std::size_t e = 0; e < all.size(); e += 2) have.insert({all[e], all[e + 1]});
        for (std::size_t e = 0; e < some.size(); e += 2) wanted.insert({some[e], some[e + 1]});
        return std::includes(have.begin(), have.end(), wanted.begin(), wanted.end());
    }

    // Each edge from both of its ends.
    void verify_vertex_neighbors() const {
        FUZZ_REQUIRE(neighbor_list.size() == edges.size(), std::to_string(edges.size()));
        std::set<std::array<std::int64_t, 2>> ends;
        for (std::size_t e = 0; e < edges.size(); e += 2) {
            ends.insert({edges[e], edges[e + 1]});
            ends.insert({edges[e + 1], edges[e]});
        }
        for (std::size_t k = 0; k + 1 < neighbor_offsets.size(); ++k)
            for (auto i = neighbor_offsets[k]; i < neighbor_offsets[k + 1]; ++i) {
                const std::int64_t other = neighbor_list[static_cast<std::size_t>(i)];
                FUZZ_REQUIRE(ends.count({size(k), other}) == 1, std::to_string(k));
                FUZZ_REQUIRE(i == neighbor_offsets[k] ||
                                 neighbor_list[static_cast<std::size_t>(i) - 1] < other,
                             std::to_string(k));
            }
    }

    void verify_map() const {
        std::int64_t own = 0;
        for (std::size_t i = 0; i < map.size(); ++i) {
            FUZZ_REQUIRE(map[i] >= -1 && map[i] <= size(i), std::to_string(i));
            if (!is_in(i)) continue;
            FUZZ_REQUIRE(map[static_cast<std::size_t>(map[i])] == map[i], std::to_string(i));
            own += map[i] == size(i) ? 1 : 0;
        }
        FUZZ_REQUIRE(own == vertices, std::to_string(own));
        for (const std::int64_t v : tetrahedra)
            FUZZ_REQUIRE(v >= 0 && v < points && map[static_cast<std::size_t>(v)] == v,
                         std::to_string(v));
    }

    std::array<std::int64_t, 3> facet(std::size_t code) const {
        std::array<std::int64_t, 3> f{};
        for (std::size_t k = 0, m = 0; k < 4; ++k)
            if (k != code % 4) f[m++] = tetrahedra[code - code % 4 + k];
        std::sort(f.begin(), f.end());
        return f;
    }

    void verify_neighbors() const {
        std::map<std::array<std::int64_t, 3>, Indices> owners;
        for (std::size_t code = 0; code < tetrahedra.size(); ++code)
            owners[facet(code)].push_back(size(code) / 4);
        std::set<std::array<std::int64_t, 3>> expected, found;
        for (std::size_t code = 0; code < tetrahedra.size(); ++code) {
            const Indices& o = owners[facet(code)];
            FUZZ_REQUIRE(o.size() <= 2, "a facet of three tetrahedra");
            const std::int64_t other = o.size() == 1 ? -1 : (o[0] == size(code) / 4 ? o[1] : o[0]);
            FUZZ_REQUIRE(neighbors[code] == other, "a neighbour of " + std::to_string(code / 4));
            if (other < 0) expected.insert(facet(code));
        }
        for (std::size_t h = 0; h < hull.size(); h += 3) {
            std::array<std::int64_t, 3> f = {hull[h], hull[h + 1], hull[h + 2]};
            std::sort(f.begin(), f.end());
            FUZZ_REQUIRE(found.insert(f).second, "a facet of the hull comes twice");
        }
        FUZZ_REQUIRE(found == expected, "the hull is not the boundary");
    }

    void verify_edges() const {
        std::set<std::array<std::int64_t, 2>> expected, found;
        for (std::size_t t = 0; t < tetrahedra.size(); t += 4)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j)
                    if (tetrahedra[t + i] < tetrahedra[t + j])
                        expected.insert({tetrahedra[t + i], tetrahedra[t + j]});
        for (std::size_t e = 0; e < edges.size(); e += 2)
            FUZZ_REQUIRE(found.insert({edges[e], edges[e + 1]}).second, "an edge comes twice");
        FUZZ_REQUIRE(found == expected, "edges");
    }

    void verify_list() const {
        std::vector<Indices> around(map.size());
        for (std::size_t i = 0; i < tetrahedra.size(); ++i)
            around[static_cast<std::size_t>(tetrahedra[i])].push_back(size(i) / 4);
        Indices whole;
        for (std::size_t i = 0; i < around.size(); ++i) {
            FUZZ_REQUIRE(offsets[i] == size(whole), "offset " + std::to_string(i));
            whole.insert(whole.end(), around[i].begin(), around[i].end());
        }
        FUZZ_REQUIRE(offsets.back() == size(whole) && list == whole, "tetrahedra around vertices");
    }
};

}  // namespace fuzz
