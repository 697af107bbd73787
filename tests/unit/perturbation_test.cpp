// SPDX-License-Identifier: MIT
// The perturbation makes one triangulation out of many: whatever the points, the tetrahedra
// whose spheres are empty fill the hull once.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "exact_reference.hpp"
#include "point_families.hpp"
#include "predicates/predicates.hpp"
#include "predicates/stages.hpp"

namespace {

using families::Five;
using families::Random;
using reference::Point;

std::vector<Point> distinct(std::vector<Point> points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

std::vector<Point> lattice_subset(Random& r, int side, int count) {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        points.push_back({double(r.integer(0, side - 1)), double(r.integer(0, side - 1)),
                          double(r.integer(0, side - 1))});
    }
    return distinct(points);
}

using Tetrahedron = std::array<std::size_t, 4>;  // positively oriented

// By definition: every positively oriented tetrahedron with all other points outside.
std::vector<Tetrahedron> empty_tetrahedra(const std::vector<Point>& p) {
    std::vector<Tetrahedron> found;
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < j; ++k) {
                for (std::size_t l = 0; l < k; ++l) {
                    Tetrahedron t = {i, j, k, l};
                    const int o =
                        mgdt::orientation(p[i].data(), p[j].data(), p[k].data(), p[l].data());
                    if (o == 0) continue;
                    if (o < 0) std::swap(t[0], t[1]);
                    bool empty = true;
                    for (std::size_t q = 0; q < p.size() && empty; ++q) {
                        if (std::find(t.begin(), t.end(), q) != t.end()) continue;
                        empty = mgdt::side_of_sphere_perturbed(p[t[0]].data(), p[t[1]].data(),
                                                               p[t[2]].data(), p[t[3]].data(),
                                                               p[q].data()) < 0;
                    }
                    if (empty) found.push_back(t);
                }
            }
        }
    }
    return found;
}

// Facets inside lie in two tetrahedra, on opposite sides; the others have no point beyond.
void expect_triangulation(const std::vector<Point>& p) {
    const std::vector<Tetrahedron> tetrahedra = empty_tetrahedra(p);
    bool solid = false;
    for (std::size_t i = 3; i < p.size() && !solid; ++i) {
        for (std::size_t j = 2; j < i; ++j) {
            for (std::size_t k = 1; k < j; ++k) {
                solid |= mgdt::orientation(p[0].data(), p[k].data(), p[j].data(), p[i].data()) != 0;
            }
        }
    }
    EXPECT_EQ(solid, !tetrahedra.empty());
    std::map<std::array<std::size_t, 3>, std::vector<std::size_t>> opposite;
    for (const Tetrahedron& t : tetrahedra) {
        for (std::size_t f = 0; f < 4; ++f) {
            std::array<std::size_t, 3> facet{};
            for (std::size_t v = 0, n = 0; v < 4; ++v) {
                if (v != f) facet[n++] = t[v];
            }
            std::sort(facet.begin(), facet.end());
            opposite[facet].push_back(t[f]);
        }
    }
    for (const auto& [facet, apex] : opposite) {
        ASSERT_LE(apex.size(), 2U);
        const auto side = [&, &f = facet](std::size_t q) {
            return mgdt::orientation(p[f[0]].data(), p[f[1]].data(), p[f[2]].data(), p[q].data());
        };
        if (apex.size() == 2) {
            EXPECT_EQ(side(apex[0]), -side(apex[1]));
        } else {
            for (std::size_t q = 0; q < p.size(); ++q) EXPECT_NE(side(q), -side(apex[0]));
        }
    }
}

TEST(Perturbation, MakesATriangulationOfLatticePoints) {
    Random r(11);
    for (int i = 0; i < reference::cases(60); ++i) {
        expect_triangulation(lattice_subset(r, r.integer(2, 4), 16));
    }
    expect_triangulation(lattice_subset(r, 2, 100));  // a cube
}

TEST(Perturbation, MakesATriangulationOfCosphericalPoints) {
    Random r(12);
    const auto& family = *std::find_if(families::all().begin(), families::all().end(),
                                       [](auto& f) { return f.name == "integers on a sphere"; });
    for (int i = 0; i < reference::cases(60); ++i) {
        const Five first = family.make(r);
        std::vector<Point> points(first.begin(), first.end());
        for (int k = 0; k < 7; ++k) {
            Point p = points[static_cast<std::size_t>(r.integer(0, 4))];
            std::swap(p[0], p[static_cast<std::size_t>(r.integer(0, 2))]);
            p[static_cast<std::size_t>(r.integer(0, 2))] *= -1;
            points.push_back(p);
        }
        expect_triangulation(distinct(points));
    }
}

// The sign as its definition has it: the lifts with polynomials in e, e^2, ... for the ranks, in
// descending order of the points; the first nonzero coefficient decides.
int by_definition(const Five& p) {
    const int s = reference::side_of_sphere(p[0], p[1], p[2], p[3], p[4]);
    if (s != 0) return s;
    std::array<std::size_t, 5> order = {0, 1, 2, 3, 4};
    std::sort(order.begin(), order.end(), [&](auto i, auto j) { return p[i] > p[j]; });
    for (std::size_t row : order) {
        // The cofactor of that row's lift in -det(x, y, z, lift, 1).
        reference::Matrix m;
        const auto integer = reference::scaled({p.begin(), p.end()});
        for (std::size_t i = 0; i < 5; ++i) {
            m.push_back({integer[i][0], integer[i][1], integer[i][2], i == row ? 1 : 0, 1});
        }
        const int cofactor = -reference::sign_of_determinant(m);
        if (cofactor != 0) return cofactor;
    }
    return 0;
}

TEST(Perturbation, AgreesWithItsDefinition) {
    Random r(13);
    int ties = 0;
    for (const auto& family : families::all()) {
        SCOPED_TRACE(family.name);
        for (int i = 0; i < reference::cases(400); ++i) {
            Five p = family.make(r);
            const int o = mgdt::orientation(p[0].data(), p[1].data(), p[2].data(), p[3].data());
            if (o == 0 || std::find(p.begin(), p.begin() + 4, p[4]) != p.begin() + 4) continue;
            if (o < 0) std::swap(p[0], p[1]);
            ties += reference::side_of_sphere(p[0], p[1], p[2], p[3], p[4]) == 0;
            const int s = mgdt::side_of_sphere_perturbed(p[0].data(), p[1].data(), p[2].data(),
                                                         p[3].data(), p[4].data());
            EXPECT_EQ(s, by_definition(p));
            EXPECT_NE(s, 0);
        }
    }
    EXPECT_GT(ties, 5);
}

// All say 0 of a vertex, and integers of 64 bits nothing of what they cannot hold.
TEST(Perturbation, OfWholeNumbers) {
    if (mgdt::exact::widest_bits < 127) GTEST_SKIP() << "no native integers of 128 bits";
    const double a[3] = {0, 0, 0}, b[3] = {4, 0, 0}, c[3] = {0, 4, 0}, d[3] = {0, 0, 4};
    for (const double* v : {a, b, c, d}) {
        EXPECT_EQ(mgdt::exact::perturbed_native(a, b, c, d, v), 0);
        EXPECT_EQ(mgdt::exact::perturbed_by_parts(a, b, c, d, v), 0);
    }
    const double inside[3] = {1, 1, 1}, far[3] = {0x1p300, 1, 0x1p-300};
    EXPECT_EQ(mgdt::exact::perturbed_native(a, b, c, d, inside), 1);
    EXPECT_EQ(mgdt::exact::perturbed_native(a, b, c, d, far), mgdt::exact::undecided);
}

// The answer depends on the tetrahedron, not on how its vertices are numbered.
TEST(Perturbation, IgnoresEvenPermutations) {
    Random r(14);
    for (int i = 0; i < reference::cases(300); ++i) {
        const std::vector<Point> p = lattice_subset(r, 3, 8);
        if (p.size() < 5) continue;
        const double *a = p[0].data(), *b = p[1].data(), *c = p[2].data(), *d = p[3].data(),
                     *q = p[4].data();
        const int o = mgdt::orientation(a, b, c, d);
        if (o == 0) continue;
        if (o < 0) std::swap(a, b);
        const int s = mgdt::side_of_sphere_perturbed(a, b, c, d, q);
        EXPECT_NE(s, 0);
        EXPECT_EQ(mgdt::side_of_sphere_perturbed(b, c, a, d, q), s);
        EXPECT_EQ(mgdt::side_of_sphere_perturbed(b, a, d, c, q), s);
        EXPECT_EQ(mgdt::side_of_sphere_perturbed(c, d, a, b, q), s);
        EXPECT_EQ(mgdt::side_of_sphere_perturbed(a, b, c, d, b), 0);
    }
}

// For q in the plane of a facet abc the vertex d beyond it has no say: any other apex on the
// same side gives the same answer, which is what a hull facet asks for.
TEST(Perturbation, CoplanarQueriesDoNotDependOnTheApex) {
    Random r(15);
    int asked = 0;
    for (int i = 0; i < reference::cases(4000); ++i) {
        const std::vector<Point> p = lattice_subset(r, 3, 9);
        if (p.size() < 6) continue;
        std::vector<std::size_t> pick(p.size());
        for (std::size_t k = 0; k < pick.size(); ++k) pick[k] = k;
        for (std::size_t k = pick.size(); k > 1; --k) {
            std::swap(pick[k - 1], pick[static_cast<std::size_t>(r.integer(0, int(k) - 1))]);
        }
        const double *a = p[pick[0]].data(), *b = p[pick[1]].data(), *c = p[pick[2]].data();
        const double *d = p[pick[3]].data(), *e = p[pick[4]].data(), *q = p[pick[5]].data();
        if (mgdt::orientation(a, b, c, q) != 0) continue;
        if (mgdt::orientation(a, b, c, d) < 0) std::swap(a, b);
        if (mgdt::orientation(a, b, c, d) <= 0 || mgdt::orientation(a, b, c, e) <= 0) continue;
        ++asked;
        EXPECT_EQ(mgdt::side_of_sphere_perturbed(a, b, c, d, q),
                  mgdt::side_of_sphere_perturbed(a, b, c, e, q));
    }
    EXPECT_GT(asked, 0);
}

}  // namespace
