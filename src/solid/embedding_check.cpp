// SPDX-License-Identifier: MIT
#include "solid/embedding_check.hpp"

#include <algorithm>

#include "boundary/boundary.hpp"
#include "boundary/box_tree.hpp"
#include "boundary/simplex_pair.hpp"
#include "mesh/tetrahedron.hpp"
#include "parallel/disjoint_sets.hpp"
#include "platform/atomic.hpp"
#include "platform/error.hpp"
#include "predicates/predicates.hpp"
#include "solid/pair_table.hpp"

namespace mgdt {
namespace {

// Finds the connected sheets of boundary faces: faces that have no tetrahedron on at least one
// side, which is their free side. Two faces are of one sheet if one can go from the free side of
// one to that of the other without passing through a face with one free side.
class Sheets {
  public:
    Sheets(const SolidMesh& mesh, Allocator& allocator)
        : mesh_(mesh), edges_(allocator), sets_(allocator, mesh.face_facets.size()) {
        for (std::uint32_t f = 0; f < mesh.face_facets.size(); ++f) {
            if (free_sides(f) == 0) continue;
            // The face, oriented so that it is counter-clockwise seen from a free side.
            std::uint32_t v[3];
            std::copy_n(mesh.faces.begin() + 3 * std::size_t{f}, 3, v);
            if (mesh.face_tetrahedra[2 * std::size_t{f}] != no_index) std::swap(v[1], v[2]);
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t from = v[i], to = v[(i + 1) % 3];
                edges_.push_back({std::min(from, to), std::max(from, to), f, from < to});
            }
        }
        std::sort(edges_.begin(), edges_.end());
        for (std::size_t i = 0, end = 0; i < edges_.size(); i = end) {
            while (end < edges_.size() && edges_[end].a == edges_[i].a &&
                   edges_[end].b == edges_[i].b)
                ++end;
            join(i, end);
        }
    }

    // Calls f for one face of each sheet.
    template <class F>
    void for_each(F f) {
        for (std::uint32_t face = 0; face < mesh_.face_facets.size(); ++face)
            if (free_sides(face) > 0 && sets_.least(face) == face) f(face);
    }

  private:
    struct Edge {
        std::uint32_t a, b, face;
        bool ascends;

        friend bool operator<(const Edge& e, const Edge& f) {
            return e.a != f.a ? e.a < f.a : e.b != f.b ? e.b < f.b : e.face < f.face;
        }
    };

    int free_sides(std::uint32_t face) const {
        const std::uint32_t* const sides = mesh_.face_tetrahedra.begin() + 2 * std::size_t{face};
        return (sides[0] == no_index ? 1 : 0) + (sides[1] == no_index ? 1 : 0);
    }
    // Joins faces at an edge: all of them if none has a tetrahedron; and two faces with one free
    // side each, if they pass the edge in opposite directions, so that their free sides face each
    // other. Faces that are not joined are tested separately, which costs only time.
    void join(std::size_t begin, std::size_t end) {
        std::size_t bounding = 0;
        for (std::size_t i = begin; i < end; ++i)
            bounding += free_sides(edges_[i].face) == 1 ? 1 : 0;
        const bool is_pair =
            end - begin == 2 && bounding == 2 && edges_[begin].ascends != edges_[begin + 1].ascends;
        if (bounding != 0 && !is_pair) return;
        for (std::size_t i = begin + 1; i < end; ++i)
            sets_.join(edges_[begin].face, edges_[i].face);
    }

    const SolidMesh& mesh_;
    Buffer<Edge> edges_;
    DisjointSets sets_;
};

class EmbeddingCheck {
  public:
    EmbeddingCheck(const SolidMesh& mesh, std::int32_t base, Allocator& allocator,
                   StageProgress& progress)
        : mesh_(mesh), allocator_(allocator), base_(base), progress_(progress) {}

    void run() {
        progress_.enter(0, 0.2);
        Buffer<Simplex> outside(allocator_);
        collect_outside(outside);
        Buffer<BoundingBox> boxes(allocator_);
        for (std::size_t t = 0; t < mesh_.tetrahedron_count(); ++t) {
            const std::uint32_t* const v = mesh_.tetrahedra.begin() + 4 * t;
            boxes.push_back(box_of(simplex(v, 3)));
            boxes.back().include(BoundingBox(exact(v[3])));
        }
        const BoxTree tree(allocator_, boxes, progress_.stop_request());
        progress_.enter(0.2, 1);
        for (std::size_t i = 0; i < outside.size(); ++i) {
            progress_.step(i, 0, outside.size());
            const Simplex& s = outside[i];
            tree.for_each_at(box_of(s), [&](std::uint32_t t) {
                if (is_met(t, s))
                    fail(MGDT_ERR_CHECK_FAILED,
                         "tetrahedron %lld meets the surroundings of the domain at point %lld",
                         number(t), number(s.number[0]));
            });
        }
    }

  private:
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

    // Collects the simplices that no tetrahedron may meet.
    void collect_outside(Buffer<Simplex>& outside) {
        Sheets(mesh_, allocator_).for_each([&](std::uint32_t f) {
            outside.push_back(simplex(mesh_.faces.begin() + 3 * std::size_t{f}, 3));
        });
        Buffer<std::uint8_t> is_corner(allocator_);
        is_corner.resize(mesh_.points.size() / 3, std::uint8_t{0});
        PairTable segments(allocator_);
        for (std::size_t s = 0; s < mesh_.edges.size(); s += 2)
            segments.add(mesh_.edges[s], mesh_.edges[s + 1]);
        Buffer<std::uint8_t> is_edge(allocator_);
        is_edge.resize(segments.size(), std::uint8_t{0});
        for (std::size_t t = 0; t < mesh_.tetrahedra.size(); t += 4) {
            progress_.step(t, 0, mesh_.tetrahedra.size());
            const std::uint32_t* const v = mesh_.tetrahedra.begin() + t;
            for (int i = 0; i < 4; ++i) {
                is_corner[v[i]] = 1;
                for (int k = 0; k < i; ++k)
                    if (const std::uint32_t s = segments.find(v[i], v[k]); s != no_index)
                        is_edge[s] = 1;
            }
        }
        for (std::size_t s = 0; s < mesh_.edges.size(); s += 2)
            if (is_edge[segments.find(mesh_.edges[s], mesh_.edges[s + 1])] == 0)
                outside.push_back(simplex(mesh_.edges.begin() + s, 2));
        // A mesh that has been changed may have lost points.
        for (std::uint32_t p = 0; p < is_corner.size() && mesh_.is_of_domain; ++p) {
            // Equal points are tested once.
            const std::uint32_t origin = mesh_.point_origins[p];
            const bool is_first = origin == p || origin == no_index;
            if (is_corner[p] == 0 && is_first) outside.push_back(simplex(&p, 1));
        }
    }

    // Whether a plane separates the tetrahedron and a simplex: the plane of a face of the
    // tetrahedron, or of the simplex if it is a triangle. Only common corners are in the plane.
    // Most pairs are separated in this way.
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
            is_inside = mesh_.side(mesh_.exact_points, t, s.x[k]) > 0 ||
                        std::find(v, v + 4, s.number[k]) != v + 4;
        return is_inside && std::find(v, v + 4, s.number[0]) == v + 4;
    }

    const SolidMesh& mesh_;
    Allocator& allocator_;
    std::int32_t base_;
    StageProgress& progress_;
};

}  // namespace

bool is_embedded(const SolidMesh& mesh, Team& team, Allocator& allocator, StageProgress& progress) {
    Buffer<std::uint32_t> faces(allocator);  // 3 corners of each that has a free side
    for (std::size_t f = 0; f < mesh.face_facets.size(); ++f)
        if (mesh.face_tetrahedra[2 * f] == no_index || mesh.face_tetrahedra[2 * f + 1] == no_index)
            for (std::size_t k = 0; k < 3; ++k) faces.push_back(mesh.faces[3 * f + k]);
    const auto simplex = [&](std::size_t f) {
        Simplex s = {3, {}, {}};
        for (std::size_t k = 0; k < 3; ++k) {
            s.number[k] = faces[3 * f + k];
            s.x[k] = mesh.points.begin() + 3 * std::size_t{s.number[k]};
        }
        return s;
    };
    Buffer<BoundingBox> boxes(allocator, faces.size() / 3);
    for (std::size_t f = 0; f < boxes.size(); ++f) boxes[f] = box_of(simplex(f));
    const BoxTree tree(allocator, boxes, progress.stop_request());
    Atomic<bool> is_simple{true};
    tree.for_each_pair(team, progress, [&](std::uint32_t i, std::uint32_t j, unsigned) {
        if (!is_simple.load(std::memory_order_relaxed)) return;
        const Simplex a = simplex(i), b = simplex(j);
        const bool are_equal = std::is_permutation(a.number, a.number + 3, b.number);
        if (are_equal || !meet_in_common_face(a, b))
            is_simple.store(false, std::memory_order_relaxed);
    });
    if (!is_simple.load(std::memory_order_relaxed)) return false;
    std::size_t sheets = 0;
    Sheets(mesh, allocator).for_each([&](std::uint32_t) { ++sheets; });
    if (sheets < 2) return true;
    try {
        check_embedding(mesh, 0, allocator, progress);
    } catch (const Error& error) {
        if (error.status != MGDT_ERR_CHECK_FAILED) throw;
        return false;
    }
    return true;
}

void check_embedding(const SolidMesh& mesh, std::int32_t index_base, Allocator& allocator,
                     StageProgress& progress) {
    EmbeddingCheck(mesh, index_base, allocator, progress).run();
}

}  // namespace mgdt
