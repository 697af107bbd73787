// SPDX-License-Identifier: MIT
//
// One pass bisects every edge that is longer than the spacing wanted at its midpoint, and all
// tetrahedra around it. Inside a tetrahedron the longest marked edge goes first. Since that order
// is one of edges, not of tetrahedra, the two sides of a face cut it alike, and the mesh stays
// conforming. The spacing shrinks from pass to pass.
#include "cli/point_sets/refinement.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace mgdt::cli {
namespace {

using Index = std::uint32_t;
using Tetrahedron = std::array<Index, 4>;

constexpr Index no_node = std::numeric_limits<Index>::max();
constexpr double shrink_factor = 0.8;  // each pass roughly doubles the number of nodes
constexpr std::size_t edge_ends[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

double squared_distance(const Point& a, const Point& b) {
    const double x = a[0] - b[0];
    const double y = a[1] - b[1];
    const double z = a[2] - b[2];
    return x * x + y * y + z * z;
}

Point midpoint(const Point& a, const Point& b) {
    return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2])};
}

struct Edge {
    Index a, b;              // a < b
    double length;           // squared
    double excess;           // squared ratio of the length to the wanted spacing at size 1
    Index middle = no_node;  // the node at its midpoint
    Index next = no_node;    // the next marked edge with the same b

    // Total orders: longer, more excessive edges first, equal ones by their nodes.
    bool longer(const Edge& other) const {
        return std::tie(other.length, a, b) < std::tie(length, other.a, other.b);
    }
    bool more_excessive(const Edge& other) const {
        return std::tie(other.excess, a, b) < std::tie(excess, other.a, other.b);
    }
};

// The edges that a pass bisects, chained at their higher nodes: a node has few, and tetrahedra
// that follow one another share nodes, so this stays in the cache where a hash table does not.
class MarkedEdges {
  public:
    explicit MarkedEdges(std::size_t node_count) : first_(node_count, no_node) {}

    std::vector<Edge>& list() { return list_; }

    void insert(const Edge& edge) {
        if (find(edge.a, edge.b) != nullptr) return;
        list_.push_back(edge);
        list_.back().next = first_[edge.b];
        first_[edge.b] = static_cast<Index>(list_.size() - 1);
    }

    const Edge* find(Index a, Index b) const {
        for (Index i = first_[b]; i != no_node; i = list_[i].next) {
            if (list_[i].a == a) return &list_[i];
        }
        return nullptr;
    }

  private:
    std::vector<Edge> list_;
    std::vector<Index> first_;  // the first marked edge of each node
};

class Refiner {
  public:
    Refiner(ElementMesh&& mesh, const Focus& focus) : mesh_(std::move(mesh)), focus_(focus) {}

    std::vector<Point>& nodes() { return mesh_.nodes; }

    // A spacing at which no edge is bisected.
    double coarsest() const {
        double most = 0;
        for (const Tetrahedron& t : mesh_.tetrahedra) {
            for (const auto& ends : edge_ends) {
                most = std::max(most, edge(t[ends[0]], t[ends[1]]).excess);
            }
        }
        return std::sqrt(most);
    }

    // Marks the edges that are longer than `size` wants.
    MarkedEdges mark(double size) {
        MarkedEdges marked(mesh_.nodes.size());
        masks_.assign(mesh_.tetrahedra.size(), 0);
        for (std::size_t i = 0; i < mesh_.tetrahedra.size(); ++i) {
            const Tetrahedron& t = mesh_.tetrahedra[i];
            for (std::size_t e = 0; e < 6; ++e) {
                const Edge candidate = edge(t[edge_ends[e][0]], t[edge_ends[e][1]]);
                if (!(candidate.excess > size * size)) continue;
                marked.insert(candidate);
                masks_[i] = static_cast<std::uint8_t>(masks_[i] | 1U << e);
            }
        }
        return marked;
    }

    // Makes the midpoints of the first `count` edges into nodes.
    void add_midpoints(std::vector<Edge>& edges, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            edges[i].middle = static_cast<Index>(mesh_.nodes.size());
            mesh_.nodes.push_back(midpoint(mesh_.nodes[edges[i].a], mesh_.nodes[edges[i].b]));
        }
    }

    void bisect_tetrahedra(const MarkedEdges& marked, std::size_t marked_count) {
        const std::vector<Tetrahedron> whole = std::move(mesh_.tetrahedra);
        mesh_.tetrahedra.clear();
        mesh_.tetrahedra.reserve(whole.size() + 6 * marked_count);  // roughly
        for (std::size_t i = 0; i < whole.size(); ++i) {
            Piece piece{whole[i], {}};
            for (std::size_t e = 0; masks_[i] >> e != 0; ++e) {
                if ((masks_[i] >> e & 1) == 0) continue;
                const Index a = piece.vertices[edge_ends[e][0]];
                const Index b = piece.vertices[edge_ends[e][1]];
                piece.edges[e] = marked.find(std::min(a, b), std::max(a, b));
            }
            bisect(piece);
        }
    }

  private:
    struct Piece {
        Tetrahedron vertices;
        std::array<const Edge*, 6> edges;  // edges still to be bisected, or nullptr
    };

    Edge edge(Index a, Index b) const {
        if (a > b) std::swap(a, b);
        const Point& p = mesh_.nodes[a];
        const Point& q = mesh_.nodes[b];
        const double length = squared_distance(p, q);
        const double wanted =
            1 + squared_distance(midpoint(p, q), focus_.centre) / (focus_.radius * focus_.radius);
        return {a, b, length, length / (wanted * wanted)};
    }

    void bisect(const Piece& piece) {
        std::size_t longest = 6;
        for (std::size_t e = 0; e < 6; ++e) {
            if (piece.edges[e] == nullptr) continue;
            if (longest == 6 || piece.edges[e]->longer(*piece.edges[longest])) longest = e;
        }
        if (longest == 6) {
            mesh_.tetrahedra.push_back(piece.vertices);
            return;
        }
        for (const std::size_t end : edge_ends[longest]) {
            Piece half = piece;
            half.vertices[end] = piece.edges[longest]->middle;
            for (std::size_t e = 0; e < 6; ++e) {
                if (edge_ends[e][0] == end || edge_ends[e][1] == end) half.edges[e] = nullptr;
            }
            bisect(half);
        }
    }

    ElementMesh mesh_;
    Focus focus_;
    std::vector<std::uint8_t> masks_;  // the marked edges of each tetrahedron, as bits
};

}  // namespace

std::vector<Point> refine(ElementMesh mesh, const Focus& focus, std::size_t n) {
    if (n >= no_node) throw std::runtime_error("a refined mesh has at most 2^32 - 2 nodes");
    if (n <= mesh.nodes.size()) {
        mesh.nodes.resize(n);
        return std::move(mesh.nodes);
    }
    mesh.nodes.reserve(n);
    Refiner refiner(std::move(mesh), focus);
    std::vector<Point>& nodes = refiner.nodes();
    const double coarsest = refiner.coarsest();
    if (!(coarsest > 0)) throw std::runtime_error("the mesh to refine has no edges");
    for (double size = shrink_factor * coarsest;; size *= shrink_factor) {
        MarkedEdges marked = refiner.mark(size);
        std::vector<Edge>& edges = marked.list();
        const std::size_t missing = n - nodes.size();
        if (edges.size() >= missing) {
            // The last pass bisects the edges with the greatest excess; tetrahedra are not needed
            // any more.
            std::sort(edges.begin(), edges.end(),
                      [](const Edge& a, const Edge& b) { return a.more_excessive(b); });
            refiner.add_midpoints(edges, missing);
            return std::move(nodes);
        }
        refiner.add_midpoints(edges, edges.size());
        refiner.bisect_tetrahedra(marked, edges.size());
    }
}

}  // namespace mgdt::cli
