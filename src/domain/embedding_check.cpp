// SPDX-License-Identifier: MIT
#include "domain/embedding_check.hpp"

#include <algorithm>

#include "domain/pair_table.hpp"
#include "platform/error.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

class EmbeddingCheck {
  public:
    EmbeddingCheck(const Complex& complex, const DomainMesh& mesh, std::int32_t base,
                   unsigned threads, Allocator& allocator)
        : complex_(complex), mesh_(mesh), allocator_(allocator), base_(base), threads_(threads) {}

    void run() {
        const std::size_t n = mesh_.tetrahedron_count();
        Buffer<Simplex> outside(allocator_);
        collect_outside(outside);
        Buffer<BoundingBox> boxes(allocator_);
        for (std::size_t t = 0; t < n; ++t) {
            const std::uint32_t* const v = mesh_.tetrahedra.begin() + 4 * t;
            boxes.push_back(box_of(simplex(v, 3)));
            boxes.back().include(BoundingBox(exact(v[3])));
        }
        for (const Simplex& s : outside) boxes.push_back(box_of(s));
        const Atomic<bool> never{false};
        const BoxTree tree(allocator_, boxes, StopRequest(never));
        Team team(threads_);
        tree.for_each_pair(team, [&](std::uint32_t i, std::uint32_t j, unsigned) {
            if (i >= n || j < n) return;
            const Simplex& s = outside[j - n];
            if (is_met(i, s))
                fail(MGDT_ERR_CHECK_FAILED,
                     "tetrahedron %lld meets the surroundings of the domain at point %lld",
                     number(i), number(s.number[0]));
        });
    }

  private:
    static constexpr std::uint32_t none = DomainMesh::none;

    long long number(std::size_t i) const { return static_cast<long long>(i) + base_; }
    const double* exact(std::uint32_t v) const {
        return mesh_.exact_points.begin() + 3 * std::size_t{v};
    }
    Simplex simplex(const std::uint32_t* v, int size) const {
        Simplex s = {};
        s.size = size;
        for (int k = 0; k < size; ++k) {
            s.x[k] = exact(v[k]);
            s.number[k] = v[k];
        }
        return s;
    }

    // What no tetrahedron may meet.
    void collect_outside(Buffer<Simplex>& outside) {
        for (std::size_t f = 0; f < mesh_.face_facets.size(); ++f)
            if (mesh_.face_tetrahedra[2 * f] == none || mesh_.face_tetrahedra[2 * f + 1] == none)
                outside.push_back(simplex(mesh_.faces.begin() + 3 * f, 3));
        Buffer<std::uint8_t> is_corner(allocator_);
        is_corner.resize(mesh_.points.size() / 3, std::uint8_t{0});
        PairTable segments(allocator_);
        for (std::size_t s = 0; s < mesh_.segments.size(); s += 2)
            segments.add(mesh_.segments[s], mesh_.segments[s + 1]);
        Buffer<std::uint8_t> is_edge(allocator_);
        is_edge.resize(segments.size(), std::uint8_t{0});
        for (std::size_t t = 0; t < mesh_.tetrahedra.size(); t += 4) {
            const std::uint32_t* const v = mesh_.tetrahedra.begin() + t;
            for (int i = 0; i < 4; ++i) {
                is_corner[v[i]] = 1;
                for (int k = 0; k < i; ++k)
                    if (const std::uint32_t s = segments.find(v[i], v[k]); s != PairTable::none)
                        is_edge[s] = 1;
            }
        }
        for (std::size_t s = 0; s < mesh_.segments.size(); s += 2)
            if (is_edge[segments.find(mesh_.segments[s], mesh_.segments[s + 1])] == 0)
                outside.push_back(simplex(mesh_.segments.begin() + s, 2));
        for (std::uint32_t p = 0; p < is_corner.size(); ++p) {
            // Of equal points, the first one stands for all.
            const bool is_first = p >= complex_.number_of_point.size() ||
                                  complex_.point_of_number[complex_.number_of_point[p]] == p;
            if (is_corner[p] == 0 && is_first) outside.push_back(simplex(&p, 1));
        }
    }

    // Whether the plane of a face of the tetrahedron, or of a triangle, has the two on its sides
    // and only common corners in it. Most pairs are apart in this way.
    bool is_apart(const std::uint32_t* v, const Simplex& s) const {
        const auto is_common = [&](std::uint32_t corner) {
            return std::find(v, v + 4, corner) != v + 4;
        };
        for (unsigned i = 0; i < 4; ++i) {
            const unsigned char* const f = outer_face[i];
            int k = 0;
            while (k < s.size &&
                   (is_common(s.number[k])
                        ? s.number[k] != v[i]
                        : orientation(s.x[k], exact(v[f[0]]), exact(v[f[1]]), exact(v[f[2]])) > 0))
                ++k;
            if (k == s.size) return true;
        }
        if (s.size < 3) return false;
        int sides[4];
        for (int i = 0; i < 4; ++i) {
            const bool is_corner = std::find(s.number, s.number + 3, v[i]) != s.number + 3;
            sides[i] = orientation(s.x[0], s.x[1], s.x[2], exact(v[i]));
            if (sides[i] == 0 && !is_corner) return false;
        }
        return *std::max_element(sides, sides + 4) <= 0 || *std::min_element(sides, sides + 4) >= 0;
    }

    // Whether a tetrahedron meets a simplex elsewhere than in a common corner, edge or face.
    bool is_met(std::uint32_t t, const Simplex& s) const {
        const std::uint32_t* const v = mesh_.tetrahedra.begin() + 4 * std::size_t{t};
        if (is_apart(v, s)) return false;
        bool is_inside = true;
        for (unsigned i = 0; i < 4; ++i) {
            const unsigned char* const f = outer_face[i];
            const std::uint32_t corner[3] = {v[f[0]], v[f[1]], v[f[2]]};
            if (!meet_in_common_face(simplex(corner, 3), s)) return true;
        }
        for (int k = 0; k < s.size && is_inside; ++k)
            is_inside = mesh_.side(t, s.x[k]) > 0 || std::find(v, v + 4, s.number[k]) != v + 4;
        return is_inside && std::find(v, v + 4, s.number[0]) == v + 4;
    }

    const Complex& complex_;
    const DomainMesh& mesh_;
    Allocator& allocator_;
    std::int32_t base_;
    unsigned threads_;
};

}  // namespace

void check_embedding(const Complex& complex, const DomainMesh& mesh, std::int32_t index_base,
                     unsigned threads, Allocator& allocator) {
    EmbeddingCheck(complex, mesh, index_base, threads, allocator).run();
}

}  // namespace mgdt
