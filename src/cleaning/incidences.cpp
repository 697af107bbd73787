// SPDX-License-Identifier: MIT
#include "cleaning/incidences.hpp"

#include <algorithm>
#include <functional>

#include "parallel/per_member.hpp"
#include "platform/take_out_repeats.hpp"
#include "predicates/foot_weights.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

class IncidenceSearch {
  public:
    IncidenceSearch(const SurfacePieces& pieces, const Nearness& near, Team& team,
                    Allocator& allocator)
        : pieces_(pieces),
          near_(near),
          team_(team),
          allocator_(allocator),
          found_(team, allocator, std::ref(allocator)) {}

    Incidences run(StageProgress& progress) {
        find_all(progress);
        Incidences result(allocator_);
        for (const Buffer<Found>& of_member : found_)
            for (const Found& f : of_member) {
                if (f.edge[0] == no_index)
                    result.in_triangles.push_back({f.triangle, f.point});
                else
                    on_edges_.push_back(f);
            }
        Buffer<Incidences::Incidence>& inside = result.in_triangles;
        take_out_repeats(inside);
        sort_along_edges();
        for (const Found& f : on_edges_) {
            const std::uint32_t edge = result.edges.add(f.edge[0], f.edge[1]);
            result.on_edges.push_back({edge, f.point});
        }
        return result;
    }

  private:
    // A point and the edge, the lesser end first, or the triangle that it is in.
    struct Found {
        std::uint32_t edge[2];  // no_index for a triangle
        std::uint32_t triangle;
        std::uint32_t point;
        double share;  // of the way along the edge; 0 if all is exact
    };

    void find_all(StageProgress& progress) {
        const Boundary& boundary = pieces_.boundary;
        const Buffer<BoundingBox> boxes = boxes_of(boundary, near_.distance(), team_, allocator_);
        const BoxTree tree(allocator_, boxes, progress.stop_request());
        tree.for_each_pair(team_, progress, [&](std::uint32_t i, std::uint32_t j, unsigned member) {
            const Simplex a = boundary.simplex(i), b = boundary.simplex(j);
            compare(a, b, i, boxes[i], member);
            compare(b, a, j, boxes[j], member);
        });
        for (std::uint32_t t = 0; t < pieces_.triangle_count(); ++t) add_own_corner(t);
    }

    // Adds the corners of `of` that are in the simplex a, which has the number i.
    void compare(const Simplex& a, const Simplex& of, std::uint32_t i, const BoundingBox& box,
                 unsigned member) {
        if (a.size == 1) return;
        for (int k = 0; k < of.size; ++k) {
            const std::uint32_t p = of.number[k];
            if (!box.overlaps(BoundingBox(of.x[k]))) continue;
            if (std::find(a.number, a.number + a.size, p) != a.number + a.size) continue;
            if (a.size == 3 && near_.is_apart_from_plane(a.x[0], a.x[1], a.x[2], of.x[k])) continue;
            bool is_on_edge = false;
            for (int e = 0; e < (a.size == 3 ? 3 : 1); ++e)
                if (add_if_on_edge(a.number[e], a.number[(e + 1) % a.size], p, member))
                    is_on_edge = true;
            if (!is_on_edge && a.size == 3 && near_.is_in_triangle(a.x[0], a.x[1], a.x[2], of.x[k]))
                found_[member].push_back({{no_index, no_index}, i, p, 0});
        }
    }
    // A corner of a flat triangle is in the opposite edge.
    void add_own_corner(std::uint32_t t) {
        const std::uint32_t* const v = pieces_.triangle(t);
        for (int k = 0; k < 3; ++k) add_if_on_edge(v[(k + 1) % 3], v[(k + 2) % 3], v[k], 0);
    }
    bool add_if_on_edge(std::uint32_t a, std::uint32_t b, std::uint32_t p, unsigned member) {
        if (b < a) std::swap(a, b);
        const double *const from = pieces_.point(a), *const to = pieces_.point(b),
                            *const x = pieces_.point(p);
        if (!near_.is_on_edge(from, to, x)) return false;
        double w[2] = {0, 0};
        if (!near_.is_exact()) foot_weights(from, to, x, w);
        found_[member].push_back({{a, b}, no_index, p, w[1]});
        return true;
    }

    void sort_along_edges() {
        std::sort(on_edges_.begin(), on_edges_.end(), [&](const Found& f, const Found& g) {
            for (int k = 0; k < 2; ++k)
                if (f.edge[k] != g.edge[k]) return f.edge[k] < g.edge[k];
            if (f.share != g.share) return f.share < g.share;
            if (f.point == g.point) return false;
            const int sign = compare_lexicographic(pieces_.point(f.point), pieces_.point(g.point)),
                      along =
                          compare_lexicographic(pieces_.point(f.edge[0]), pieces_.point(f.edge[1]));
            return along < 0 ? sign < 0 : sign > 0;
        });
        const auto is_same = [](const Found& f, const Found& g) {
            return std::equal(f.edge, f.edge + 2, g.edge) && f.point == g.point;
        };
        on_edges_.resize(static_cast<std::size_t>(
            std::unique(on_edges_.begin(), on_edges_.end(), is_same) - on_edges_.begin()));
    }

    const SurfacePieces& pieces_;
    const Nearness& near_;
    Team& team_;
    Allocator& allocator_;
    PerMember<Buffer<Found>> found_;
    Buffer<Found> on_edges_{allocator_};
};

}  // namespace

Incidences find_incidences(const SurfacePieces& pieces, const Nearness& near, Team& team,
                           Allocator& allocator, StageProgress& progress) {
    return IncidenceSearch(pieces, near, team, allocator).run(progress);
}

}  // namespace mgdt
