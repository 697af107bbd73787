// SPDX-License-Identifier: MIT
// The check of meshes from elsewhere: the library's tetrahedra damaged in some way, or any at all,
// on a few points. What it says is compared with a judgement from the definition: the tetrahedra
// are solid and all turned one way, do not overlap, fill the hull, share whole facets, have no
// point inside a circumsphere and leave no point out.
#include <algorithm>
#include <map>
#include <set>

#include "../property/oracle.hpp"
#include "cli/mesh_check.hpp"
#include "cli/program_triangulation.hpp"
#include "points.hpp"

namespace fuzz {
namespace {

using mgdt::cli::Mesh;
using Vector = oracle::Point<std::int64_t>;
using Solid = std::array<Vector, 4>;

struct Judge {
    const Mesh& mesh;
    const oracle::Triangulation truth;
    const std::vector<Vector> points;
    std::vector<oracle::Quadruple> tetrahedra;  // by vertices of distinct places, turned positive

    explicit Judge(const Mesh& m)
        : mesh(m), truth(oracle::triangulate(m.points)), points(oracle::small_points(m.points)) {
        for (std::size_t i = 0; i < m.tetrahedra.size(); i += 4) {
            oracle::Quadruple v;
            for (std::size_t k = 0; k < 4; ++k)
                v[k] = truth.representative[static_cast<std::size_t>(m.tetrahedra[i + k])];
            tetrahedra.push_back(v);
        }
    }

    bool is_valid() {
        return turn() && is_whole() && !overlaps() && shares_facets() && is_delaunay() &&
               uses_points() && has_its_neighbors();
    }

    // Tetrahedra that may be in a Delaunay triangulation and do not overlap, as many as fit, in an
    // order of the input's choice. Mostly they fill the hull, and not always facet to facet.
    std::vector<mgdt::cli::MeshIndex> pack(Input& in) const {
        std::vector<oracle::Quadruple> candidates, chosen;
        const std::size_t n = points.size();
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < i; ++j)
                for (std::size_t k = 0; k < j; ++k)
                    for (std::size_t l = 0; l < k; ++l) {
                        oracle::Quadruple v = {i, j, k, l};
                        if (volume(solid(v)) < 0) std::swap(v[2], v[3]);
                        if (volume(solid(v)) != 0 && has_empty_sphere(v)) candidates.push_back(v);
                    }
        while (!candidates.empty()) {
            const auto next =
                candidates.begin() + static_cast<std::ptrdiff_t>(in.byte() % candidates.size());
            const Solid s = solid(*next);
            if (std::all_of(chosen.begin(), chosen.end(),
                            [&](const auto& v) { return are_apart(solid(v), s); }))
                chosen.push_back(*next);
            candidates.erase(next);
        }
        std::vector<mgdt::cli::MeshIndex> out;
        for (const auto& v : chosen)
            for (const std::size_t p : v) out.push_back(static_cast<mgdt::cli::MeshIndex>(p));
        return out;
    }

  private:
    Solid solid(const oracle::Quadruple& v) const {
        return {points[v[0]], points[v[1]], points[v[2]], points[v[3]]};
    }
    static std::int64_t volume(const Solid& s) { return oracle::volume(s[0], s[1], s[2], s[3]); }

    bool turn() {
        int sign = 0;
        for (oracle::Quadruple& v : tetrahedra) {
            const int s = oracle::sign(volume(solid(v)));
            if (s == 0 || s == -sign) return false;
            sign = s;
            if (s < 0) std::swap(v[2], v[3]);
        }
        return true;
    }

    bool is_whole() const {
        std::int64_t sum = 0, hull = 0;
        for (const auto& v : tetrahedra) sum += volume(solid(v));
        for (const auto& v : truth.tetrahedra) hull += volume(solid(v));
        return sum == hull;
    }

    // Convex bodies that do not overlap are kept apart by a plane, and among such planes is one
    // along a facet of either or along an edge of each.
    static bool are_apart(const Solid& a, const Solid& b) {
        std::vector<Vector> normals, edges[2];
        const Solid* const both[2] = {&a, &b};
        for (std::size_t s = 0; s < 2; ++s)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = i + 1; j < 4; ++j)
                    edges[s].push_back(oracle::minus((*both[s])[j], (*both[s])[i]));
        for (const auto& side : edges)
            for (const Vector& e : side)
                for (const Vector& f : side) normals.push_back(oracle::cross(e, f));
        for (const Vector& e : edges[0])
            for (const Vector& f : edges[1]) normals.push_back(oracle::cross(e, f));
        return std::any_of(normals.begin(), normals.end(), [&](const Vector& n) {
            if (n == Vector{}) return false;
            std::int64_t low[2], high[2];
            for (std::size_t s = 0; s < 2; ++s) {
                low[s] = high[s] = oracle::dot(n, (*both[s])[0]);
                for (const Vector& p : *both[s]) {
                    low[s] = std::min(low[s], oracle::dot(n, p));
                    high[s] = std::max(high[s], oracle::dot(n, p));
                }
            }
            return high[0] <= low[1] || high[1] <= low[0];
        });
    }

    bool overlaps() const {
        for (std::size_t i = 0; i < tetrahedra.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (!are_apart(solid(tetrahedra[i]), solid(tetrahedra[j]))) return true;
        return false;
    }

    using Facet = std::array<std::size_t, 3>;
    static Facet facet(const oracle::Quadruple& v, std::size_t opposite) {
        Facet f{};
        for (std::size_t k = 0, m = 0; k < 4; ++k)
            if (k != opposite) f[m++] = v[k];
        std::sort(f.begin(), f.end());
        return f;
    }

    std::map<Facet, std::vector<std::size_t>> owners() const {
        std::map<Facet, std::vector<std::size_t>> all;
        for (std::size_t t = 0; t < tetrahedra.size(); ++t)
            for (std::size_t i = 0; i < 4; ++i) all[facet(tetrahedra[t], i)].push_back(t);
        return all;
    }

    // Two tetrahedra to a facet, or one and all points on one side.
    bool shares_facets() const {
        for (const auto& [f, owner] : owners()) {
            if (owner.size() == 2) continue;
            bool above = false, below = false;
            for (const Vector& p : points) {
                const int s = oracle::orientation(points[f[0]], points[f[1]], points[f[2]], p);
                above = above || s > 0;
                below = below || s < 0;
            }
            if (owner.size() > 2 || (above && below)) return false;
        }
        return true;
    }

    // No point inside: the sphere of the lifted points, without the perturbation.
    bool has_empty_sphere(const oracle::Quadruple& v) const {
        const Solid s = solid(v);
        const Vector b = oracle::minus(s[1], s[0]), c = oracle::minus(s[2], s[0]),
                     d = oracle::minus(s[3], s[0]);
        return std::none_of(points.begin(), points.end(), [&](const Vector& q) {
            const Vector p = oracle::minus(q, s[0]);
            return oracle::dot(oracle::cross(b, c), d) * oracle::dot(p, p) <
                   oracle::dot(oracle::cross(p, c), d) * oracle::dot(b, b) +
                       oracle::dot(oracle::cross(b, p), d) * oracle::dot(c, c) +
                       oracle::dot(oracle::cross(b, c), p) * oracle::dot(d, d);
        });
    }

    bool is_delaunay() const {
        return std::all_of(tetrahedra.begin(), tetrahedra.end(),
                           [&](const auto& v) { return has_empty_sphere(v); });
    }

    bool uses_points() const {
        if (truth.tetrahedra.empty()) return tetrahedra.empty();
        std::set<std::size_t> used;
        for (const auto& v : tetrahedra) used.insert(v.begin(), v.end());
        return std::all_of(truth.representative.begin(), truth.representative.end(),
                           [&](std::size_t v) { return used.count(v) != 0; });
    }

    bool has_its_neighbors() const {
        if (mesh.neighbors.empty()) return true;
        const auto all = owners();
        for (std::size_t code = 0; code < mesh.tetrahedra.size(); ++code) {
            const std::size_t t = code / 4;
            // By the file's order of the vertices.
            oracle::Quadruple v;
            for (std::size_t k = 0; k < 4; ++k)
                v[k] = truth.representative[static_cast<std::size_t>(mesh.tetrahedra[4 * t + k])];
            const auto& owner = all.at(facet(v, code % 4));
            const std::int64_t other =
                owner.size() == 1 ? -1
                                  : static_cast<std::int64_t>(owner[0] == t ? owner[1] : owner[0]);
            if (mesh.neighbors[code] != other) return false;
        }
        return true;
    }
};

// Changes one thing.
void damage(Input& in, Mesh& mesh) {
    auto& t = mesh.tetrahedra;
    const auto points = static_cast<unsigned>(mesh.point_count());
    const auto vertex = [&] { return static_cast<mgdt::cli::MeshIndex>(in.below(points)); };
    const std::size_t count = t.size() / 4;
    const std::size_t at = count == 0 ? 0 : 4 * (in.byte() % count);
    const auto begin = t.begin() + static_cast<std::ptrdiff_t>(at);
    const unsigned what = in.below(9);
    if (what == 0) {
        for (int k = 0; k < 4; ++k) t.push_back(vertex());
        if (!mesh.neighbors.empty()) mesh.neighbors.insert(mesh.neighbors.end(), 4, -1);
        return;
    }
    if (count == 0) return;
    switch (what) {
        case 1:  // taken out
            t.erase(begin, begin + 4);
            if (!mesh.neighbors.empty()) mesh.neighbors.resize(t.size());
            break;
        case 2:  // twice
            t.insert(t.end(), {t[at], t[at + 1], t[at + 2], t[at + 3]});
            if (!mesh.neighbors.empty()) mesh.neighbors.insert(mesh.neighbors.end(), 4, -1);
            break;
        case 3:
            t[at + in.below(4)] = vertex();
            break;
        case 4:
            std::swap(t[at + in.below(4)], t[at + in.below(4)]);
            break;
        case 5:  // all turned round
            for (std::size_t i = 0; i < t.size(); i += 4) {
                std::swap(t[i], t[i + 1]);
                if (!mesh.neighbors.empty()) std::swap(mesh.neighbors[i], mesh.neighbors[i + 1]);
            }
            break;
        case 6:  // an edge between two tetrahedra for a facet, where that fits
        case 7: {
            const std::size_t other = 4 * (in.byte() % count);
            std::swap(t[at + in.below(4)], t[other + in.below(4)]);
            break;
        }
        default:
            if (!mesh.neighbors.empty())
                mesh.neighbors[at + in.below(4)] =
                    static_cast<mgdt::cli::MeshIndex>(in.below(static_cast<unsigned>(count) + 1)) -
                    1;
            break;
    }
}

void run(Input& in) {
    const unsigned b = in.byte();
    const bool is_small = (b & 1) != 0 || (b & 2) != 0;
    PointSource source;
    std::vector<Point> places;
    for (unsigned n = in.below(10); n > 0; --n) {
        const unsigned kinds = is_small ? PointSource::first_after_small : PointSource::kinds;
        Point p = source.draw(in, in.below(kinds), places);
        for (double& x : p)
            if (!std::isfinite(x)) x = 0;
        places.push_back(p);
    }
    Mesh mesh;
    mesh.has_tetrahedra = true;
    for (const Point& p : places) mesh.points.insert(mesh.points.end(), p.begin(), p.end());

    mgdt::Triangulation triangulation;
    triangulation.insert(mesh.points);
    const mgdt::cli::Reference reference{mgdt::cli::tetrahedra(triangulation),
                                         triangulation.point_map<mgdt::cli::MeshIndex>()};
    // The ties of mirrored points are broken in another way: a mesh that is valid, and not the
    // library's.
    mgdt::Triangulation mirrored;
    std::vector<double> mirror = mesh.points;
    for (double& x : mirror) x = -x;
    mirrored.insert(mirror);
    const mgdt::Triangulation& from = (b & 4) != 0 ? mirrored : triangulation;
    mesh.tetrahedra = mgdt::cli::tetrahedra(from);
    if ((b & 8) != 0) mesh.neighbors = mgdt::cli::neighbors(from);
    const auto judgement = [&] {
        const mgdt::cli::MeshReport report = mgdt::cli::check_mesh(mesh, reference);
        bool good = true;
        for (const mgdt::cli::Finding& f : report.findings) good = good && f.good;
        FUZZ_REQUIRE(good == report.valid, "the report disagrees with its findings");
        return report.valid;
    };
    FUZZ_REQUIRE(judgement(), "a valid mesh is refused");

    if (is_small && (b & 16) != 0 && places.size() <= 8) {
        mesh.tetrahedra = Judge(mesh).pack(in);
        mesh.neighbors.clear();
    } else {
        for (unsigned n = in.below(6); n > 0 && !places.empty(); --n) damage(in, mesh);
    }
    const bool said = judgement();
    if (!is_small) return;
    const bool is_valid = Judge(mesh).is_valid();
    FUZZ_REQUIRE(said == is_valid,
                 said ? "a broken mesh is called valid" : "a valid mesh is called broken");
}

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    fuzz::run(in);
    return 0;
}
