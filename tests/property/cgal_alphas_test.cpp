// SPDX-License-Identifier: MIT
// Alphas of tetrahedra, facets, edges and vertices beside CGAL's Alpha_shape_3, which compares
// alphas exactly, on every distribution.
#include <CGAL/Alpha_shape_3.h>
#include <CGAL/Alpha_shape_cell_base_3.h>
#include <CGAL/Alpha_shape_vertex_base_3.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "handle.hpp"
#include "rows.hpp"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Tag_true;
using VertexBase = CGAL::Alpha_shape_vertex_base_3<
    Kernel, CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>, Exact>;
using CellBase =
    CGAL::Alpha_shape_cell_base_3<Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>, Exact>;
using Delaunay =
    CGAL::Delaunay_triangulation_3<Kernel,
                                   CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using AlphaShape = CGAL::Alpha_shape_3<Delaunay, Exact>;

// The vertices of a simplex, ascending; -1 stands for none.
using Simplex = std::array<std::int64_t, 4>;
using Alphas = std::map<Simplex, double>;

Simplex simplex(std::initializer_list<std::int64_t> vertices) {
    Simplex s = {-1, -1, -1, -1};
    std::copy(vertices.begin(), vertices.end(), s.begin());
    std::sort(s.begin(), s.end());
    return s;
}

// By dimension, as CGAL has them.
using Expected = std::array<Alphas, 4>;

double in_double(const AlphaShape::FT& alpha) {
    return CGAL::to_double(alpha.exact());
}

// The library's alpha of a simplex whose status is CGAL's: that of the smallest sphere if this has
// no vertex inside, otherwise the least one of the simplices around it.
template <class Status>
double alpha_of(const Status& status) {
    return in_double(status.is_Gabriel() ? status.alpha_min() : status.alpha_mid());
}

Expected alphas_by_cgal(const std::vector<double>& xyz, const std::vector<std::int64_t>& map) {
    std::vector<std::pair<Delaunay::Point, int>> points;
    for (std::size_t i = 0; i < map.size(); ++i)
        if (map[i] == static_cast<std::int64_t>(i))
            points.emplace_back(Delaunay::Point(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]),
                                static_cast<int>(i));
    Delaunay delaunay(points.begin(), points.end());
    Expected expected;
    if (delaunay.dimension() < 3) return expected;
    AlphaShape shape(delaunay, 0, AlphaShape::GENERAL);
    for (auto c = shape.finite_cells_begin(); c != shape.finite_cells_end(); ++c)
        expected[3][simplex({c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(),
                             c->vertex(3)->info()})] = in_double(c->get_alpha());
    for (auto f = shape.finite_facets_begin(); f != shape.finite_facets_end(); ++f) {
        const auto vertex = [&](int k) { return f->first->vertex((f->second + k) & 3)->info(); };
        expected[2][simplex({vertex(1), vertex(2), vertex(3)})] =
            alpha_of(shape.get_alpha_status(*f));
    }
    for (auto e = shape.finite_edges_begin(); e != shape.finite_edges_end(); ++e) {
        expected[1][simplex(
            {e->first->vertex(e->second)->info(), e->first->vertex(e->third)->info()})] =
            alpha_of(shape.get_alpha_status(*e));
    }
    return expected;
}

// CGAL cuts the exact number off. The header says how exact ours are.
constexpr double error_of_tetrahedra = 5e-16, error_of_others = 2e-14;

void expect_near(double alpha, double expected, double tolerance) {
    // Where the square of a radius leaves the range of doubles, both are 0 or infinite, or nearly
    // so.
    if (alpha == expected || (alpha < 1e-300 && expected < 1e-300)) return;
    EXPECT_LE(std::abs(alpha - expected), tolerance * expected);
}

class AlphasOfCgal : public testing::TestWithParam<property::Row> {};

TEST_P(AlphasOfCgal, AreTheSame) {
    const std::vector<double> xyz = property::points(GetParam(), is_small() ? 100 : 1000);
    const property::Handle t = property::create();
    ASSERT_EQ(property::insert(t.get(), xyz, {0}), MGDT_OK);
    const Expected expected = alphas_by_cgal(xyz, property::point_map(t.get()));
    const auto tetrahedra = property::tetrahedra(t.get());
    const std::size_t n = tetrahedra.size() / 4;
    ASSERT_EQ(n, expected[3].size());
    std::vector<double> of_tetrahedra(n), of_facets(4 * n);
    const auto get = [&](std::int32_t dimension, std::vector<double>& alphas) {
        ASSERT_EQ(mgdt_get_alphas(t.get(), dimension, static_cast<std::int64_t>(alphas.size()),
                                  alphas.data()),
                  MGDT_OK);
    };
    get(3, of_tetrahedra);
    get(2, of_facets);
    for (std::size_t i = 0; i < n; ++i) {
        const std::int64_t* v = tetrahedra.data() + 4 * i;
        const auto whole = expected[3].find(simplex({v[0], v[1], v[2], v[3]}));
        ASSERT_TRUE(whole != expected[3].end());
        expect_near(of_tetrahedra[i], whole->second, error_of_tetrahedra);
        for (std::size_t k = 0; k < 4; ++k) {
            const auto facet =
                expected[2].find(simplex({v[(k + 1) % 4], v[(k + 2) % 4], v[(k + 3) % 4]}));
            ASSERT_TRUE(facet != expected[2].end());
            expect_near(of_facets[4 * i + k], facet->second, error_of_others);
        }
    }
    std::vector<std::int64_t> edges(2 * static_cast<std::size_t>(mgdt_edge_count(t.get())));
    if (expected[1].empty()) return;
    ASSERT_EQ(edges.size(), 2 * expected[1].size());
    ASSERT_EQ(mgdt_get_edges(t.get(), static_cast<std::int64_t>(edges.size()), edges.data()),
              MGDT_OK);
    std::vector<double> of_edges(edges.size() / 2);
    get(1, of_edges);
    for (std::size_t i = 0; i < of_edges.size(); ++i) {
        const auto edge = expected[1].find(simplex({edges[2 * i], edges[2 * i + 1]}));
        ASSERT_TRUE(edge != expected[1].end());
        expect_near(of_edges[i], edge->second, error_of_others);
    }
}

INSTANTIATE_TEST_SUITE_P(Rows, AlphasOfCgal, testing::ValuesIn(property::rows),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
