// SPDX-License-Identifier: MIT
// A kernel that stands before the library's: of some insertions it first takes, from the same mesh,
// every walk from every start, and then lets the library insert the point as it does.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "query/location_tree.hpp"
#include "walk_kinds.hpp"

namespace bench {

using mgdt::VertexId;

enum StartKind {
    in_star,       // the best of four tetrahedra of the last star
    last,          // the last insertion's tetrahedron
    cell_last,     // the last vertex in the same cell of the grids, or `last` if there is none
    cell_nearest,  // the nearest of the last eight there, or `last`
    nearest,       // the nearest of all vertices
    tree,          // near the vertex that a kd-tree over one vertex in sixteen gives
    jump,          // the nearest of n^(1/4) random vertices
    anywhere,      // a random vertex
    start_kinds
};
enum WalkKind {
    power_conflict,  // the library's
    power_base,
    random_conflict,  // by orientation; faces in random order
    random_base,
    ordered_base,   // faces in their order
    farthest_base,  // the face of the most negative volume coordinate
    walk_kinds
};

// How many kinds of walk are taken from a start.
inline unsigned walks_from(unsigned start) {
    return start < tree ? walk_kinds : 1;
}

// Sums over the insertions looked at.
struct Sums {
    std::size_t count = 0, starts[start_kinds] = {};
    double steps[start_kinds][walk_kinds] = {}, tests[start_kinds][walk_kinds] = {};
    double visited = 0, removed = 0;  // by the library
    // Of the tetrahedra removed: whose newest vertex is of the last hundred; with an edge five
    // times as long as another; ghosts.
    double young = 0, elongated = 0, ghosts = 0;
};

class Probe {
  public:
    // Looks at one insertion in `every`. `cells` gives each point's cell in the grids. In a hurry,
    // the others start nearby: for an order whose consecutive points are far apart, so that it
    // does not matter which of a star's tetrahedra the next walk starts from.
    Probe(const mgdt::Kernel& kernel, const std::vector<std::uint32_t>& cells, std::uint32_t every,
          bool hurries)
        : kernel_(kernel), cells_(cells), every_(every), hurries_(hurries), random_(1) {
        std::uint32_t count = 0;
        for (const std::uint32_t c : cells) count = std::max(count, c + 1);
        recent_.resize(count, {});
    }

    const Sums& sums() const { return sums_; }

    mgdt::Insertion insert(Mesh& mesh, mgdt::Workspace& w, VertexId q, TetId start) {
        for (; known_ < q; ++known_) remember(mesh, known_);
        if (mgdt::Random::at(7, q) % every_ != 0) {
            if (!hurries_) return kernel_.with_spheres.insert(mesh, w, q, start);
            const Query query(mesh.point(q));
            const TetId near = start_of(cell_nearest, mesh, w, query, q, start).tetrahedron;
            return kernel_.with_spheres.insert(mesh, w, q, near);
        }
        const bool is_new = look(mesh, w, q, start);
        const mgdt::Counters before = w.counters;
        const mgdt::Insertion result = kernel_.with_spheres.insert(mesh, w, q, start);
        if (!is_new) return result;
        const std::size_t removed = w.counters.removed - before.removed;
        if (removed != cavity_.size())
            throw std::runtime_error("the cavity of vertex " + std::to_string(q) + " has " +
                                     std::to_string(cavity_.size()) + " tetrahedra, removed are " +
                                     std::to_string(removed));
        sums_.removed += static_cast<double>(removed);
        sums_.visited += static_cast<double>(w.counters.walk_steps - before.walk_steps);
        return result;
    }

  private:
    struct Recent {
        std::array<VertexId, 8> vertices;
        std::uint32_t count;
    };

    // q's predecessor is in.
    void remember(const Mesh& mesh, VertexId v) {
        Recent& r = recent_[cells_[mesh.vertices[v].index]];
        r.vertices[r.count++ % r.vertices.size()] = v;
        if (v >= 2 * tree_made_ && v >= mgdt::LocationTree::smallest) {
            tree_.emplace(allocator_, mesh, v + std::size_t{1});
            tree_made_ = v;
        } else if (tree_ && v % mgdt::LocationTree::stride == 0) {
            tree_->add(mesh, v, v + std::size_t{1});
        }
    }

    // False for a repeat, of which there is nothing to learn.
    bool look(Mesh& mesh, const mgdt::Workspace& w, VertexId v, TetId start) {
        const Query q(mesh.point(v));
        mgdt::Counters counters;
        const mgdt::WalkResult found =
            walk(mgdt::SerialAccess<mgdt::KeptSpheres>{mesh}, mesh,
                 start_at(mgdt::KeptSpheres(mesh), start, q, counters), q, counters, no_ghost);
        if (found.duplicate != infinite_vertex) return false;
        const Path to = power_to_conflict(mesh, {start, 0}, q);
        dig(mesh, to.end, q, v);
        // Walks from afar are long: a few of one kind will do.
        const unsigned starts = sums_.count++ % 8 == 0 ? start_kinds : tree;
        for (unsigned s = 0; s < starts; ++s) {
            ++sums_.starts[s];
            const Start from = start_of(static_cast<StartKind>(s), mesh, w, q, v, start);
            for (unsigned k = 0; k < walks_from(s); ++k) {
                const auto kind = static_cast<WalkKind>(k);
                const Path path = take(kind, mesh, from, q);
                if (!is_end(kind, mesh, path.end, q))
                    throw std::runtime_error("walk " + std::to_string(k) + " from start " +
                                             std::to_string(s) + " ends wrongly for vertex " +
                                             std::to_string(v));
                sums_.steps[s][k] += static_cast<double>(path.steps);
                sums_.tests[s][k] += static_cast<double>(path.tests);
            }
        }
        return true;
    }

    Path take(WalkKind kind, Mesh& mesh, Start from, const Query& q) {
        switch (kind) {
            case power_conflict:
                return power_to_conflict(mesh, from, q);
            case power_base:
                return power_to_base(mesh, from, q);
            case random_conflict:
                return by_orientation(mesh, from, q, conflict, at_random, random_);
            case random_base:
                return by_orientation(mesh, from, q, base, at_random, random_);
            case ordered_base:
                return by_orientation(mesh, from, q, base, in_order, random_);
            default:
                return by_orientation(mesh, from, q, base, farthest, random_);
        }
    }

    static bool is_end(WalkKind kind, const Mesh& mesh, TetId end, const Query& q) {
        const Tetrahedron& t = mesh.tetrahedra[end];
        const bool to_conflict = kind == power_conflict || kind == random_conflict;
        return to_conflict ? is_conflict_exact(mesh, t, q.point) : contains(mesh, t, q.point);
    }

    Start start_of(StartKind kind, const Mesh& mesh, const mgdt::Workspace& w, const Query& q,
                   VertexId v, TetId start) {
        // Before the first insertion there is no star.
        const TetId last_one = w.slot_count != 0 ? w.slots.data[0] >> 2 : start;
        // A repeat's vertex is nowhere, and has no place in the mesh when the batch is in.
        const auto at = [&](VertexId near) {
            const bool is_in =
                near != infinite_vertex && mesh.vertex_hint[near] != mgdt::no_tetrahedron;
            return Start{is_in ? mesh.live_from(mesh.vertex_hint[near]) : last_one, 0};
        };
        switch (kind) {
            case in_star: {
                if (w.slot_count == 0) return {start, 0};
                mgdt::Counters counters;
                const TetId best =
                    start_in_star(mgdt::KeptSpheres(mesh), w, q, counters).tetrahedron;
                return {best, static_cast<unsigned>(counters.walk_tests)};
            }
            case last:
                return {last_one, 0};
            case cell_last: {
                const Recent& r = recent_[cells_[mesh.vertices[v].index]];
                return at(r.count == 0 ? infinite_vertex
                                       : r.vertices[(r.count - 1) % r.vertices.size()]);
            }
            case cell_nearest: {
                const Recent& r = recent_[cells_[mesh.vertices[v].index]];
                VertexId best = infinite_vertex;
                for (std::size_t i = 0; i < r.vertices.size() && i < r.count; ++i)
                    best = nearer(mesh, best, r.vertices[i], q);
                return at(best);
            }
            case tree:
                return at(tree_ ? tree_->near(q.point) : infinite_vertex);
            case nearest:
                return at(nearest_);
            default: {
                VertexId best = infinite_vertex;
                std::size_t draws = 1;
                if (kind == jump)
                    while (draws * draws * draws * draws < v) ++draws;
                while (draws-- > 0) best = nearer(mesh, best, 1 + random_.below(v - 1), q);
                return at(best);
            }
        }
    }

    static VertexId nearer(const Mesh& mesh, VertexId a, VertexId b, const Query& q) {
        if (a == infinite_vertex) return b;
        return mgdt::compare_distance(q.point, mesh.point(a), mesh.point(b)) <= 0 ? a : b;
    }

    // The cavity, and the nearest vertex: it will be q's neighbour, so it is one of the cavity's.
    void dig(const Mesh& mesh, TetId start, const Query& q, VertexId v) {
        constexpr VertexId recent = 100;
        seen_.resize(mesh.tetrahedra.size(), 0);
        cavity_.assign(1, start);
        seen_[start] = v;
        nearest_ = infinite_vertex;
        for (std::size_t i = 0; i < cavity_.size(); ++i) {
            const Tetrahedron& t = mesh.tetrahedra[cavity_[i]];
            for (const mgdt::FacetCode code : t.n) {
                if (seen_[code >> 2] == v) continue;
                seen_[code >> 2] = v;
                if (is_in_conflict(mesh, code >> 2, q)) cavity_.push_back(code >> 2);
            }
            for (const VertexId corner : t.v)
                if (corner != infinite_vertex) nearest_ = nearer(mesh, nearest_, corner, q);
            sums_.young += v - t.v[0] <= recent;
            if (t.is_ghost())
                ++sums_.ghosts;
            else
                sums_.elongated += is_elongated(mesh, t);
        }
    }

    static bool is_elongated(const Mesh& mesh, const Tetrahedron& t) {
        constexpr double ratio = 5;
        double least = mgdt::infinity, most = 0;
        for (unsigned i = 0; i < 4; ++i) {
            for (unsigned j = 0; j < i; ++j) {
                double square = 0;
                for (unsigned k = 0; k < 3; ++k) {
                    const double d = mesh.point(t.v[i])[k] - mesh.point(t.v[j])[k];
                    square += d * d;
                }
                least = std::min(least, square);
                most = std::max(most, square);
            }
        }
        return most > ratio * ratio * least;
    }

    const mgdt::Kernel& kernel_;
    const std::vector<std::uint32_t>& cells_;
    const std::uint32_t every_;
    const bool hurries_;
    mgdt::Random random_;
    Sums sums_;
    VertexId known_ = 1;  // the first vertex that the starts do not know yet
    std::vector<Recent> recent_;
    mgdt::Allocator allocator_;
    std::optional<mgdt::LocationTree> tree_;
    VertexId tree_made_ = 0;
    std::vector<TetId> cavity_;
    std::vector<VertexId> seen_;  // by tetrahedron: the last vertex for which it was tested
    VertexId nearest_ = infinite_vertex;
};

}  // namespace bench
