// SPDX-License-Identifier: MIT
// The perturbation is CGAL's: on degenerate points the tetrahedra whose perturbed spheres are
// empty are CGAL's tetrahedra. CGAL is GPL; nothing that is installed may include it.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "point_families.hpp"
#include "predicates/predicates.hpp"

namespace {

using families::Random;
using reference::Point;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using Tetrahedron = std::array<Point, 4>;  // sorted

std::set<Tetrahedron> of_cgal(const std::vector<Point>& points) {
    Triangulation t;
    for (const Point& p : points) t.insert(Triangulation::Point(p[0], p[1], p[2]));
    std::set<Tetrahedron> out;
    if (t.dimension() < 3) return out;
    for (auto cell = t.finite_cells_begin(); cell != t.finite_cells_end(); ++cell) {
        Tetrahedron vertices;
        for (int i = 0; i < 4; ++i) {
            const auto& p = cell->vertex(i)->point();
            vertices[static_cast<std::size_t>(i)] = {p.x(), p.y(), p.z()};
        }
        std::sort(vertices.begin(), vertices.end());
        out.insert(vertices);
    }
    return out;
}

std::set<Tetrahedron> by_definition(const std::vector<Point>& p) {
    std::set<Tetrahedron> out;
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < j; ++k) {
                for (std::size_t l = 0; l < k; ++l) {
                    const double *a = p[i].data(), *b = p[j].data(), *c = p[k].data(),
                                 *d = p[l].data();
                    const int o = mgdt::orientation(a, b, c, d);
                    if (o == 0) continue;
                    if (o < 0) std::swap(a, b);
                    const bool empty = std::none_of(p.begin(), p.end(), [&](const Point& q) {
                        return mgdt::side_of_sphere_perturbed(a, b, c, d, q.data()) > 0;
                    });
                    if (!empty) continue;
                    Tetrahedron t = {p[i], p[j], p[k], p[l]};
                    std::sort(t.begin(), t.end());
                    out.insert(t);
                }
            }
        }
    }
    return out;
}

void shuffle(Random& r, std::vector<Point>& points) {
    for (std::size_t k = points.size(); k > 1; --k) {
        std::swap(points[k - 1], points[static_cast<std::size_t>(r.integer(0, int(k) - 1))]);
    }
}

void expect_same(Random& r, std::vector<Point> points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    shuffle(r, points);
    EXPECT_EQ(of_cgal(points), by_definition(points));
}

TEST(PerturbationIsThatOfCgal, OnLatticeSubsets) {
    Random r(21);
    for (int i = 0; i < reference::cases(100); ++i) {
        const int side = r.integer(2, 4);
        std::vector<Point> points;
        for (int k = 0; k < 18; ++k) {
            points.push_back({double(r.integer(0, side - 1)), double(r.integer(0, side - 1)),
                              double(r.integer(0, side - 1))});
        }
        expect_same(r, points);
    }
}

TEST(PerturbationIsThatOfCgal, OnAWholeLattice) {
    Random r(22);
    std::vector<Point> points;
    for (int i = 0; i < 27; ++i)
        points.push_back({double(i % 3), double(i / 3 % 3), double(i / 9)});
    EXPECT_GE(of_cgal(points).size(), 8U * 5U);  // five tetrahedra a cube, or six
    expect_same(r, points);
}

TEST(PerturbationIsThatOfCgal, OnIntegerPointsOfASphere) {
    Random r(23);
    for (int i = 0; i < reference::cases(40); ++i) {
        const int radius_squared = std::array<int, 4>{9, 14, 26, 81}[std::size_t(r.integer(0, 3))];
        std::vector<Point> all, points;
        for (int x = -9; x <= 9; ++x) {
            for (int y = -9; y <= 9; ++y) {
                for (int z = -9; z <= 9; ++z) {
                    if (x * x + y * y + z * z == radius_squared) {
                        all.push_back({double(x), double(y), double(z)});
                    }
                }
            }
        }
        shuffle(r, all);
        points.assign(all.begin(), all.begin() + 16);
        expect_same(r, points);
    }
}

TEST(PerturbationIsThatOfCgal, OnAPlanarLatticeWithApexes) {
    Random r(24);
    for (int i = 0; i < reference::cases(40); ++i) {
        std::vector<Point> points = {{1, 1, double(r.integer(1, 3))}};
        if (r.integer(0, 1)) points.push_back({2, 1, double(-r.integer(1, 3))});
        for (int k = 0; k < 14; ++k) {
            points.push_back({double(r.integer(0, 3)), double(r.integer(0, 3)), 0});
        }
        expect_same(r, points);
    }
}

}  // namespace
