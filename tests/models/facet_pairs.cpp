// SPDX-License-Identifier: MIT
// Lists by CGAL what `mgdt validate` lists: pairs of triangles of an OFF file that meet elsewhere
// than in common corners and edges, "I K" a line, and triangles that are flat, "I I".
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
using Corners = std::array<std::size_t, 3>;

struct Surface {
    std::vector<Point> points;
    std::vector<Corners> triangles;

    Triangle triangle(std::size_t i) const {
        const Corners& v = triangles[i];
        return Triangle(points[v[0]], points[v[1]], points[v[2]]);
    }
};

Surface read(const char* path) {
    std::ifstream in(path);
    std::string off;
    std::size_t n = 0, m = 0, none = 0, width = 0;
    Surface s;
    in >> off >> n >> m >> none;
    for (std::size_t i = 0; i < n; ++i) {
        double x = 0, y = 0, z = 0;
        in >> x >> y >> z;
        s.points.emplace_back(x, y, z);
    }
    for (std::size_t i = 0; i < m; ++i) {
        Corners v{};
        in >> width >> v[0] >> v[1] >> v[2];
        s.triangles.push_back(v);
    }
    if (!in) s.triangles.clear();
    return s;
}

// Whether two triangles, which are not flat, have more in common than their common corners and
// edges.
bool offend(const Surface& s, std::size_t i, std::size_t k) {
    std::vector<std::size_t> common;
    for (const std::size_t v : s.triangles[i])
        if (std::count(s.triangles[k].begin(), s.triangles[k].end(), v) > 0) common.push_back(v);
    if (common.size() == 3) return true;
    const Triangle a = s.triangle(i), b = s.triangle(k);
    if (common.empty()) return CGAL::do_intersect(a, b);
    const auto meeting = CGAL::intersection(a, b);
    if (!meeting) return true;  // they have a common corner at least
    if (const Point* const p = boost::get<Point>(&*meeting))
        return common.size() != 1 || *p != s.points[common[0]];
    if (const Kernel::Segment_3* const e = boost::get<Kernel::Segment_3>(&*meeting)) {
        if (common.size() != 2) return true;
        const Point &p = s.points[common[0]], &q = s.points[common[1]];
        return !((e->source() == p && e->target() == q) || (e->source() == q && e->target() == p));
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const Surface s = read(argv[1]);
    if (s.triangles.empty()) return 3;
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < s.triangles.size(); ++i) {
        const Triangle t = s.triangle(i);
        if (t.is_degenerate())
            std::printf("%zu %zu\n", i, i);
        else
            boxes.emplace_back(t.bbox(), i);
    }
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
        const std::size_t i = std::min(a.info(), b.info()), k = std::max(a.info(), b.info());
        if (offend(s, i, k)) std::printf("%zu %zu\n", i, k);
    });
    return 0;
}
