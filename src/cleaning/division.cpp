// SPDX-License-Identifier: MIT
#include "cleaning/division.hpp"

#include <algorithm>

namespace mgdt {
namespace {

// The parts of one triangle, as a tree. A node has a triangle, and the parts of which it consists.
class TriangleParts {
  public:
    TriangleParts(const Buffer<double>& points, Allocator& allocator)
        : points_(points), nodes_(allocator) {}

    void start(const std::uint32_t* corners, const Projection& projection) {
        nodes_.clear();
        add(corners[0], corners[1], corners[2]);
        projection_ = projection;
        turn_ = turn(corners[0], corners[1], corners[2]);
    }
    // Divides the edge from a to b of the triangle at points that are given in this order.
    template <class PointAt>
    void divide_edge(std::uint32_t a, std::uint32_t b, std::size_t count, PointAt point_at) {
        std::uint32_t n = leaf_with(a, b);
        for (std::size_t i = 0; i < count && n != no_index && !nodes_[n].is_dropped; ++i) {
            const Node node = nodes_[n];
            const int k = first_end(node, a, b);
            const std::uint32_t apex = node.v[(k + 2) % 3], p = point_at(i);
            divide(n, 2);
            add(a, p, apex);
            add(p, b, apex);
            n = static_cast<std::uint32_t>(nodes_.size() - 1);
            a = p;
        }
    }
    // Divides the part that has a point inside. Does nothing if the point is in an edge of it.
    void divide_inside(std::uint32_t p) {
        std::uint32_t n = 0;
        while (nodes_[n].parts > 0) {
            const std::uint32_t first = nodes_[n].first, end = first + nodes_[n].parts;
            n = first;
            while (n < end && !contains(nodes_[n], p)) ++n;
            if (n == end) return;
        }
        const Node node = nodes_[n];
        if (!contains(node, p)) return;
        divide(n, 3);
        for (int k = 0; k < 3; ++k) add(node.v[k], node.v[(k + 1) % 3], p);
    }
    bool is_divided() const { return nodes_[0].parts > 0; }
    template <class F>
    void for_each_leaf(F f) const {
        for (const Node& node : nodes_)
            if (node.parts == 0 && !node.is_dropped) f(node.v[0], node.v[1], node.v[2]);
    }

  private:
    struct Node {
        std::uint32_t v[3];
        std::uint32_t first, parts;  // the parts are `first` and the following ones
        bool is_dropped;
    };

    int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const auto point = [&](std::uint32_t v) { return points_.begin() + 3 * std::size_t{v}; };
        return projection_.turn(point(a), point(b), point(c));
    }
    bool contains(const Node& node, std::uint32_t p) const {
        for (int k = 0; k < 3; ++k)
            if (turn(node.v[k], node.v[(k + 1) % 3], p) != turn_) return false;
        return !node.is_dropped;
    }
    void divide(std::uint32_t n, std::uint32_t parts) {
        nodes_[n].first = static_cast<std::uint32_t>(nodes_.size());
        nodes_[n].parts = parts;
    }
    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        nodes_.push_back({{a, b, c}, 0, 0, a == b || b == c || c == a});
    }
    // Which corner of a node is a, if b is the next one; 3 if there is no such edge.
    static int first_end(const Node& node, std::uint32_t a, std::uint32_t b) {
        int k = 0;
        while (k < 3 && !(node.v[k] == a && node.v[(k + 1) % 3] == b)) ++k;
        return k;
    }
    // The undivided part with an edge of the triangle that has not been divided, or `no_index`. All
    // nodes from the root to that part have the edge.
    std::uint32_t leaf_with(std::uint32_t a, std::uint32_t b) const {
        std::uint32_t n = 0;
        while (nodes_[n].parts > 0) {
            const std::uint32_t first = nodes_[n].first, end = first + nodes_[n].parts;
            n = first;
            while (n < end && first_end(nodes_[n], a, b) == 3) ++n;
            if (n == end) return no_index;
        }
        return nodes_[n].is_dropped ? no_index : n;
    }

    const Buffer<double>& points_;
    Buffer<Node> nodes_;
    Projection projection_;
    int turn_ = 0;
};

class Division {
  public:
    Division(const Incidences& incidences, const Nearness& near, SurfacePieces& pieces,
             Buffer<std::uint8_t>& is_changed, Allocator& allocator)
        : incidences_(incidences),
          near_(near),
          pieces_(pieces),
          is_changed_(is_changed),
          result_(allocator),
          first_on_edge_(allocator) {
        first_on_edge_.resize(incidences.edges.size() + 1, 0u);
        for (const auto& on_edge : incidences.on_edges) ++first_on_edge_[on_edge.of + 1];
        for (std::size_t e = 0; e < incidences.edges.size(); ++e)
            first_on_edge_[e + 1] += first_on_edge_[e];
    }

    void run(Allocator& allocator) {
        TriangleParts parts(pieces_.boundary.points, allocator);
        std::size_t inside = 0;
        for (std::uint32_t t = 0; t < pieces_.triangle_count(); ++t) {
            const std::uint32_t* const v = pieces_.triangle(t);
            const std::uint32_t facet = pieces_.facet_of_triangle[t];
            parts.start(v, Projection(near_.normal(pieces_.point(v[0]), pieces_.point(v[1]),
                                                   pieces_.point(v[2]))));
            for (int k = 0; k < 3; ++k)
                with_points_on(v[k], v[(k + 1) % 3], [&](std::size_t count, auto point_at) {
                    parts.divide_edge(v[k], v[(k + 1) % 3], count, point_at);
                });
            const auto& in = incidences_.in_triangles;
            for (; inside < in.size() && in[inside].of == t; ++inside)
                parts.divide_inside(in[inside].point);
            const bool is_divided = parts.is_divided();
            if (is_divided) is_changed_[facet] = 1;
            parts.for_each_leaf([&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
                result_.add_triangle(p, q, r, facet, is_divided ? 1 : 0);
            });
        }
        const Buffer<std::uint32_t>& ends = pieces_.boundary.segments;
        for (std::uint32_t s = 0; s < ends.size() / 2; ++s) {
            const std::uint32_t source = pieces_.source_of_segment[s];
            std::uint32_t from = ends[2 * std::size_t{s}];
            const std::uint32_t to = ends[2 * std::size_t{s} + 1];
            with_points_on(from, to, [&](std::size_t count, auto point_at) {
                for (std::size_t i = 0; i < count; ++i) {
                    result_.add_segment(from, point_at(i), source);
                    from = point_at(i);
                }
            });
            result_.add_segment(from, to, source);
        }
        std::swap(result_.boundary.points, pieces_.boundary.points);
        pieces_ = std::move(result_);
        find_lone_points(pieces_.boundary, allocator);
    }

  private:
    // Calls f(count, point_at) for the points in an edge, if there are any. point_at(i) is point i
    // from a to b.
    template <class F>
    void with_points_on(std::uint32_t a, std::uint32_t b, F f) const {
        const std::uint32_t edge = incidences_.edges.find(a, b);
        if (edge == no_index) return;
        const std::size_t first = first_on_edge_[edge], count = first_on_edge_[edge + 1] - first;
        f(count, [&](std::size_t i) {
            return incidences_.on_edges[first + (a < b ? i : count - 1 - i)].point;
        });
    }

    const Incidences& incidences_;
    const Nearness& near_;
    SurfacePieces& pieces_;
    Buffer<std::uint8_t>& is_changed_;
    SurfacePieces result_;
    Buffer<std::uint32_t> first_on_edge_;  // of each edge of the incidences
};

}  // namespace

void divide_at(const Incidences& incidences, const Nearness& near, SurfacePieces& pieces,
               Buffer<std::uint8_t>& is_changed, Allocator& allocator) {
    Division(incidences, near, pieces, is_changed, allocator).run(allocator);
}

}  // namespace mgdt
