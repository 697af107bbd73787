// SPDX-License-Identifier: MIT
#include "cli/mesh_check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/opening.hpp"
#include "predicates/interior_point.hpp"

namespace mgdt::cli {
namespace {

using Index = std::uint32_t;
using Quad = std::array<Index, 4>;
using Triple = std::array<Index, 3>;

constexpr Index none = 0xFFFFFFFFu;

// The facet opposite vertex i of a positively oriented tetrahedron, counter-clockwise seen from
// outside.
constexpr int outward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

// Sorts three indices. Returns whether the permutation is odd.
bool sort3(Triple& f) {
    bool odd = false;
    const auto order = [&](std::size_t a, std::size_t b) {
        if (f[a] > f[b]) {
            std::swap(f[a], f[b]);
            odd = !odd;
        }
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    return odd;
}

class MeshChecker {
  public:
    MeshChecker(const Mesh& mesh, const Reference& reference) : mesh_(mesh), reference_(reference) {
        if (mesh.point_count() >= none || mesh.tetrahedron_count() >= (std::size_t{1} << 30)) {
            throw Error(exit_memory, "too many points or tetrahedra to check; at most 2^30");
        }
    }

    MeshReport run() {
        load();
        check_orientation();
        // The other tests need tetrahedra of positive volume.
        if (report_.valid) {
            match_facets();
            check_facets();
            check_hull();
            check_cover();
        }
        check_vertices();
        if (!mesh_.neighbors.empty()) check_neighbors();
        compare();
        return std::move(report_);
    }

    ConstrainedReport run_constrained() {
        load();
        check_orientation();
        std::vector<MeshIndex> boundary;
        if (report_.valid) {
            match_facets();
            check_sharing();
            count_other_facets();
            boundary = check_boundary();
            check_cover();
        }
        return {std::move(report_), std::move(boundary)};
    }

  private:
    const double* point(Index v) const { return mesh_.points.data() + 3 * std::size_t{v}; }

    // Vertices with equal coordinates are the same vertex.
    Quad load_quad(const MeshIndex* v) const {
        Quad q;
        for (std::size_t k = 0; k < 4; ++k) {
            q[k] = static_cast<Index>(reference_.point_map[static_cast<std::size_t>(v[k])]);
        }
        return q;
    }

    void add(const char* what, bool good, std::string detail) {
        report_.findings.push_back({what, good, std::move(detail)});
        report_.valid = report_.valid && good;
    }

    void load() {
        for (std::size_t i = 0; i < mesh_.point_count(); ++i) {
            const auto vertex = static_cast<Index>(reference_.point_map[i]);
            if (compare_lexicographic(point(static_cast<Index>(i)), point(vertex)) != 0) {
                add("points", false,
                    fmt::format("mgdt takes point {} for a repeat of point {}", i, vertex));
                break;
            }
        }
        tetrahedra_.reserve(mesh_.tetrahedron_count());
        for (std::size_t i = 0; i < mesh_.tetrahedra.size(); i += 4) {
            tetrahedra_.push_back(load_quad(&mesh_.tetrahedra[i]));
        }
    }

    void check_orientation() {
        std::size_t positive = 0, negative = 0, flat = 0, first_flat = 0, first_negative = 0;
        for (std::size_t t = 0; t < tetrahedra_.size(); ++t) {
            if ((t & 0xFFFF) == 0) check_interrupt();
            const Quad& v = tetrahedra_[t];
            const int sign = orientation(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
            if (sign > 0) ++positive;
            if (sign < 0 && negative++ == 0) first_negative = t;
            if (sign == 0 && flat++ == 0) first_flat = t;
        }
        const char* what = "orientation";
        if (flat > 0) {
            add(what, false,
                fmt::format("{} no volume, the first is number {} (counted from 0)",
                            counted(flat, "tetrahedron has", "tetrahedra have"), first_flat));
        } else if (negative > 0 && positive > 0) {
            add(what, false,
                fmt::format("{} positively oriented and {} negatively, the first "
                            "is number {} (counted from 0)",
                            counted(positive, "tetrahedron is", "tetrahedra are"), negative,
                            first_negative));
        } else if (negative > 0) {
            for (Quad& v : tetrahedra_) std::swap(v[2], v[3]);
            turned_ = true;
            add(what, true, fmt::format("all {} tetrahedra are negatively oriented", negative));
        } else {
            add(what, true, fmt::format("all {} tetrahedra are positively oriented", positive));
        }
    }

    Triple facet(std::size_t t, int i) const {
        const Quad& v = tetrahedra_[t];
        return {v[static_cast<std::size_t>(outward[i][0])],
                v[static_cast<std::size_t>(outward[i][1])],
                v[static_cast<std::size_t>(outward[i][2])]};
    }

    // Finds the two tetrahedra that share each facet: facets are grouped by their least vertex,
    // then sorted.
    void match_facets() {
        struct Entry {
            Index b, c;  // the other two vertices
            Index code;  // 4 * tetrahedron + face
        };
        std::vector<std::size_t> begin(mesh_.point_count() + 1, 0);
        const std::size_t count = 4 * tetrahedra_.size();
        for (std::size_t code = 0; code < count; ++code) {
            Triple f = facet(code / 4, static_cast<int>(code % 4));
            ++begin[std::min({f[0], f[1], f[2]}) + std::size_t{1}];
        }
        for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
        std::vector<Entry> entries(count);
        std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
        for (std::size_t code = 0; code < count; ++code) {
            Triple f = facet(code / 4, static_cast<int>(code % 4));
            sort3(f);
            entries[end[f[0]]++] = {f[1], f[2], static_cast<Index>(code)};
        }
        check_interrupt();
        partner_.assign(count, none);
        for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
            const auto first = entries.begin() + static_cast<std::ptrdiff_t>(begin[v]);
            const auto last = entries.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]);
            std::sort(first, last, [](const Entry& l, const Entry& r) {
                return std::tie(l.b, l.c, l.code) < std::tie(r.b, r.c, r.code);
            });
            for (auto e = first; e != last;) {
                auto stop = e;
                while (stop != last && stop->b == e->b && stop->c == e->c) ++stop;
                if (stop - e == 2) {
                    pair(e->code, (e + 1)->code);
                } else if (stop - e > 2 && crowded_++ == 0) {
                    first_crowded_ = e->code;
                }
                e = stop;
            }
        }
    }

    void pair(Index a, Index b) {
        partner_[a] = b;
        partner_[b] = a;
        Triple f = facet(a / 4, static_cast<int>(a % 4));
        Triple g = facet(b / 4, static_cast<int>(b % 4));
        if (sort3(f) == sort3(g) && folded_++ == 0) first_folded_ = a;
    }

    void check_sharing() {
        if (crowded_ > 0) {
            add("facets", false,
                fmt::format("{} to more than two tetrahedra, the first to number {}",
                            counted(crowded_, "facet belongs", "facets belong"),
                            first_crowded_ / 4));
        } else if (folded_ > 0) {
            add("facets", false,
                fmt::format("{} both tetrahedra on one side, the first of number {}",
                            counted(folded_, "facet has", "facets have"), first_folded_ / 4));
        } else {
            add("facets", true, "every facet has one or two tetrahedra, two on opposite sides");
        }
    }

    // Calls visit(code, side) for each shared facet: whether the vertex opposite it in the other
    // tetrahedron is inside the circumsphere.
    template <class Visit>
    void visit_shared(const Visit& visit) const {
        for (std::size_t code = 0; code < partner_.size(); ++code) {
            if ((code & 0xFFFF) == 0) check_interrupt();
            const Index other = partner_[code];
            if (other == none || other < code) continue;
            const Quad& v = tetrahedra_[code / 4];
            const Index q = tetrahedra_[other / 4][other % 4];
            visit(code,
                  side_of_sphere(point(v[0]), point(v[1]), point(v[2]), point(v[3]), point(q)));
        }
    }

    void check_facets() {
        check_sharing();
        std::size_t shared = 0, bad = 0, first = 0, ties = 0;
        visit_shared([&](std::size_t code, int side) {
            ++shared;
            if (side == 0) ++ties;
            if (side > 0 && bad++ == 0) first = code;
        });
        if (bad > 0) {
            add("spheres", false,
                fmt::format("at {} of {} shared facets the opposite vertex is inside the "
                            "circumsphere, first between numbers {} and {}",
                            bad, shared, first / 4, partner_[first] / 4));
        } else {
            add("spheres", true,
                fmt::format("no opposite vertex inside a circumsphere at {} shared facets, {} of "
                            "them cospherical",
                            shared, ties));
        }
    }

    Triple sorted_facet(std::size_t code) const {
        Triple f = facet(code / 4, static_cast<int>(code % 4));
        sort3(f);
        return f;
    }

    void count_other_facets() {
        std::vector<Triple> constrained;
        const FileFacets& facets = mesh_.facets;
        for (std::size_t f = 0; f < facets.size(); ++f) {
            const auto begin = static_cast<std::size_t>(facets.begin[f]);
            if (facets.begin[f + 1] - facets.begin[f] != 3) continue;
            Triple t;
            for (std::size_t k = 0; k < 3; ++k)
                t[k] = static_cast<Index>(
                    reference_.point_map[static_cast<std::size_t>(facets.corners[begin + k])]);
            sort3(t);
            constrained.push_back(t);
        }
        std::sort(constrained.begin(), constrained.end());
        std::size_t shared = 0, held = 0, others = 0;
        visit_shared([&](std::size_t code, int side) {
            ++shared;
            if (std::binary_search(constrained.begin(), constrained.end(), sorted_facet(code)))
                ++held;
            else if (side > 0)
                ++others;
        });
        add("Delaunay", true,
            fmt::format("{} of {} shared facets that are not constrained{}",
                        others == 0 ? "all" : fmt::format("all but {}", others), shared - held,
                        held == 0 ? "" : fmt::format("; {} are", held)));
    }

    // Checks that an even number of boundary facets meet at each edge, and returns these facets.
    std::vector<MeshIndex> check_boundary() {
        std::vector<MeshIndex> boundary;
        std::vector<std::array<Index, 2>> edges;
        for (std::size_t code = 0; code < partner_.size(); ++code) {
            if (partner_[code] != none) continue;
            const Triple f = facet(code / 4, static_cast<int>(code % 4));
            for (std::size_t i = 0; i < 3; ++i) {
                boundary.push_back(static_cast<MeshIndex>(f[i]));
                const Index a = f[i], b = f[(i + 1) % 3];
                edges.push_back({std::min(a, b), std::max(a, b)});
            }
        }
        std::sort(edges.begin(), edges.end());
        std::size_t odd = 0;
        const std::array<Index, 2>* first = nullptr;
        for (auto e = edges.begin(); e != edges.end();) {
            const auto stop = std::upper_bound(e, edges.end(), *e);
            if ((stop - e) % 2 != 0 && odd++ == 0) first = &*e;
            e = stop;
        }
        add("boundary", odd == 0,
            odd == 0 ? fmt::format("{} facets, an even number at each edge", boundary.size() / 3)
                     : fmt::format("an odd number of facets at {}, the first from point {} to {}",
                                   counted(odd, "edge", "edges"), (*first)[0], (*first)[1]));
        return boundary;
    }

    InteriorPoint inside_of_first() const {
        const Quad& v = tetrahedra_[0];
        return {point(v[0]), point(v[1]), point(v[2]), point(v[3])};
    }

    // Checks that each boundary edge has two facets, neither beyond the plane of the other, and
    // that a point inside the first tetrahedron is on the inner side of all facets.
    void check_hull() {
        if (tetrahedra_.empty()) return;
        struct Edge {
            Index a, b;      // ascending
            Index code;      // of the boundary facet
            Index opposite;  // the facet's third vertex
        };
        std::vector<Edge> edges;
        std::size_t single = 0, outside = 0, first_outside = 0;
        const InteriorPoint inside = inside_of_first();
        for (std::size_t code = 0; code < partner_.size(); ++code) {
            if (partner_[code] != none) continue;
            ++single;
            const Triple f = facet(code / 4, static_cast<int>(code % 4));
            for (std::size_t i = 0; i < 3; ++i) {
                const Index a = f[i], b = f[(i + 1) % 3];
                edges.push_back(
                    {std::min(a, b), std::max(a, b), static_cast<Index>(code), f[(i + 2) % 3]});
            }
            // (a, b, c, q) is negative for q inside.
            if (inside.orientation_from(point(f[0]), point(f[1]), point(f[2])) >= 0 &&
                outside++ == 0)
                first_outside = code;
        }
        check_interrupt();
        std::sort(edges.begin(), edges.end(), [](const Edge& l, const Edge& r) {
            return std::tie(l.a, l.b, l.code) < std::tie(r.a, r.b, r.code);
        });
        std::size_t count = 0, crowded = 0, concave = 0;
        const Edge *first_crowded = nullptr, *first_concave = nullptr;
        for (auto e = edges.begin(); e != edges.end(); ++count) {
            auto stop = e;
            while (stop != edges.end() && stop->a == e->a && stop->b == e->b) ++stop;
            if (stop - e != 2) {
                if (crowded++ == 0) first_crowded = &*e;
            } else {
                const Triple f = facet(e->code / 4, static_cast<int>(e->code % 4));
                if (orientation(point(f[0]), point(f[1]), point(f[2]), point((e + 1)->opposite)) >
                        0 &&
                    concave++ == 0)
                    first_concave = &*e;
            }
            e = stop;
        }
        if (concave > 0) {
            add("hull", false,
                fmt::format("the boundary is concave at {} of {} edges, first at points {} and {} "
                            "of number {}",
                            concave, count, first_concave->a, first_concave->b,
                            first_concave->code / 4));
        } else if (crowded > 0) {
            add("hull", false,
                fmt::format("{} of {} boundary edges do not have two boundary facets, first points "
                            "{} and {} of number {}",
                            crowded, count, first_crowded->a, first_crowded->b,
                            first_crowded->code / 4));
        } else if (outside > 0) {
            add("hull", false,
                fmt::format("{} of {} boundary facets have number 0 beyond them, the first is "
                            "opposite vertex {} of number {}",
                            outside, single, first_outside % 4, first_outside / 4));
        } else {
            add("hull", true, fmt::format("the boundary, {} facets, is convex", single));
        }
    }

    // Checks that a point inside the first tetrahedron is in no other one.
    void check_cover() {
        if (tetrahedra_.empty()) return;
        const InteriorPoint inside = inside_of_first();
        std::size_t others = 0, first = 0;
        for (std::size_t t = 1; t < tetrahedra_.size(); ++t) {
            if ((t & 0xFFFF) == 0) check_interrupt();
            const Quad& v = tetrahedra_[t];
            if (inside.is_in({point(v[0]), point(v[1]), point(v[2]), point(v[3])}) && others++ == 0)
                first = t;
        }
        add("cover", others == 0,
            others == 0 ? "a point inside number 0 is in no other tetrahedron"
                        : fmt::format("a point inside number 0 is in {} other tetrahedra too, the "
                                      "first is number {}",
                                      others, first));
    }

    void check_vertices() {
        std::vector<bool> used(mesh_.point_count(), false);
        for (const Quad& t : tetrahedra_) {
            for (const Index v : t) used[v] = true;
        }
        std::size_t missing = 0, first = 0, vertices = 0;
        for (std::size_t i = 0; i < used.size(); ++i) {
            if (static_cast<std::size_t>(reference_.point_map[i]) != i) continue;
            ++vertices;
            if (!used[i] && missing++ == 0) first = i;
        }
        if (tetrahedra_.empty() && reference_.tetrahedra.empty()) {
            add("vertices", true, "the points do not span space: no tetrahedra are possible");
        } else if (missing > 0) {
            add("vertices", false,
                fmt::format("{} of {} distinct points are in no tetrahedron, the first is number "
                            "{} (counted from 0)",
                            missing, vertices, first));
        } else {
            add("vertices", true, fmt::format("all {} distinct points are vertices", vertices));
        }
    }

    // Compares the neighbours in the file with those that share facets.
    void check_neighbors() {
        if (partner_.empty()) return;
        std::size_t bad = 0, first = 0;
        for (std::size_t code = 0; code < partner_.size(); ++code) {
            // Reversing the orientation exchanged the last two vertices, and so their facets.
            const std::size_t k = code % 4;
            const std::size_t file = turned_ && k >= 2 ? code - k + (5 - k) : code;
            const std::int64_t found =
                partner_[code] == none ? -1 : static_cast<std::int64_t>(partner_[code] / 4);
            if (mesh_.neighbors[file] != found && bad++ == 0) first = code / 4;
        }
        add("neighbours", bad == 0,
            bad == 0 ? "the file's neighbours are those that share facets"
                     : fmt::format("{} neighbours in the file are wrong, the first of number {}",
                                   bad, first));
    }

    void compare() {
        std::vector<Quad> ours;
        ours.reserve(reference_.tetrahedra.size() / 4);
        for (std::size_t i = 0; i < reference_.tetrahedra.size(); i += 4) {
            ours.push_back(load_quad(&reference_.tetrahedra[i]));
        }
        for (std::vector<Quad>* set : {&ours, &tetrahedra_}) {
            for (Quad& v : *set) std::sort(v.begin(), v.end());
            std::sort(set->begin(), set->end());
            check_interrupt();
        }
        auto a = ours.begin();
        for (const Quad& t : tetrahedra_) {
            while (a != ours.end() && *a < t) ++a;
            if (a != ours.end() && *a == t) {
                ++report_.in_common;
                ++a;
            }
        }
    }

    const Mesh& mesh_;
    const Reference& reference_;
    MeshReport report_;
    std::vector<Quad> tetrahedra_;
    std::vector<Index> partner_;  // code of the same facet in the other tetrahedron
    std::size_t crowded_ = 0, folded_ = 0;
    Index first_crowded_ = 0, first_folded_ = 0;
    bool turned_ = false;
};

}  // namespace

MeshReport check_mesh(const Mesh& mesh, const Reference& reference) {
    return MeshChecker(mesh, reference).run();
}

ConstrainedReport check_constrained_mesh(const Mesh& mesh, const Reference& reference) {
    return MeshChecker(mesh, reference).run_constrained();
}

}  // namespace mgdt::cli
