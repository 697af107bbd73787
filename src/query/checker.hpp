// SPDX-License-Identifier: MIT
// The class of the check, whose functions are in check.cpp and check_geometry.cpp.
#pragma once

#include "platform/error.hpp"
#include "query/check.hpp"

namespace mgdt {

class Checker {
  public:
    Checker(Team& team, const CheckInput& input, Allocator& allocator, std::int32_t base,
            StageProgress& progress)
        : team_(team),
          input_(input),
          mesh_(input.mesh),
          allocator_(allocator),
          base_(base),
          progress_(progress) {}

    void run(std::int32_t level) const;

  private:
    // The functions in check.cpp, which check indices and counts. Each relies on the functions
    // before it.
    void points() const;
    void stores() const;
    void records() const;
    void hints() const;
    void adjacency() const;
    void connection() const;
    void edges() const;
    // The functions in check_geometry.cpp, which check coordinates by exact arithmetic.
    void coordinates() const;
    void degenerate() const;
    void delaunay(bool canonical) const;
    void spheres() const;
    void hull() const;

    const Tetrahedron& tet(TetId t) const { return mesh_.tetrahedra[t]; }
    long long index(VertexId v) const {
        if (v == infinite_vertex || v >= mesh_.vertices.size()) return -1;
        return static_cast<long long>(mesh_.vertices[v].index) + base_;
    }
    // Calls f(t) for each live tetrahedron, on all threads at the same time.
    template <class F>
    void for_each_live(F f) const {
        team_.split(mesh_.tetrahedra.size(), 16384,
                    [&](std::size_t begin, std::size_t end, unsigned member) {
                        for (std::size_t t = begin; t < end; ++t) {
                            progress_.step(t, begin, end, member);
                            if (!tet(static_cast<TetId>(t)).is_dead()) f(static_cast<TetId>(t));
                        }
                    });
    }
    template <class F>
    void for_each_vertex(F f) const {
        team_.split(mesh_.vertices.size(), 16384,
                    [&](std::size_t begin, std::size_t end, unsigned member) {
                        for (std::size_t v = begin; v < end; ++v) {
                            progress_.step(v, begin, end, member);
                            if (v != infinite_vertex) f(static_cast<VertexId>(v));
                        }
                    });
    }
    [[noreturn]] void reject(TetId t, const char* what) const {
        const VertexId* v = tet(t).v;
        fail(MGDT_ERR_CHECK_FAILED,
             "tetrahedron of points %lld %lld %lld %lld (-1: infinity or none): %s", index(v[0]),
             index(v[1]), index(v[2]), index(v[3]), what);
    }

    Team& team_;
    const CheckInput& input_;
    const Mesh& mesh_;
    Allocator& allocator_;
    const std::int32_t base_;
    StageProgress& progress_;
};

}  // namespace mgdt
