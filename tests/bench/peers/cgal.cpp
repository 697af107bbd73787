// SPDX-License-Identifier: MIT
// Times CGAL: insertion of the whole range, which sorts it along a Hilbert curve in rounds.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

#include <optional>

#include "runner.hpp"

#define MGDT_TEXT(x) #x
#define MGDT_TEXT_OF(x) MGDT_TEXT(x)

namespace {

using Triangulation =
    CGAL::Delaunay_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel>;

void run() {
    std::vector<Triangulation::Point> points;
    {
        const std::vector<double> xyz = peer::read_points();
        points.reserve(xyz.size() / 3);
        for (std::size_t i = 0; i < xyz.size(); i += 3)
            points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
    }
    std::optional<Triangulation> t;
    peer::measure(
        MGDT_TEXT_OF(CGAL_VERSION), [&] { t.emplace(points.begin(), points.end()); },
        [&] { return t->number_of_finite_cells(); });
}

}  // namespace

int main() {
    return peer::guarded(run);
}
