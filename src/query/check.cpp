// SPDX-License-Identifier: MIT
#include "query/check.hpp"

#include <algorithm>

#include "kernel/circumsphere.hpp"
#include "platform/error.hpp"
#include "predicates/predicates.hpp"
#include "query/incidence.hpp"

namespace mgdt {
namespace {

class Checker {
  public:
    Checker(Team& team, const Mesh& mesh, Allocator& allocator, std::int32_t base)
        : team_(team), mesh_(mesh), allocator_(allocator), base_(base) {}

    void points(const Buffer<VertexId>& point_map) const;
    void records() const;
    void adjacency() const;
    void connection() const;
    void links() const;
    void geometry() const;
    void regularity() const;

  private:
    const Tetrahedron& tet(TetId t) const { return mesh_.tetrahedra[t]; }
    long long index(VertexId v) const {
        if (v == infinite_vertex || v >= mesh_.vertices.size()) return -1;
        return static_cast<long long>(mesh_.vertices[v].index) + base_;
    }
    // On all threads side by side.
    template <class F>
    void for_each_live(F f) const {
        team_.split(mesh_.tetrahedra.size(), 16384,
                    [&](std::size_t begin, std::size_t end, unsigned) {
                        for (std::size_t t = begin; t < end; ++t)
                            if (!tet(static_cast<TetId>(t)).is_dead()) f(static_cast<TetId>(t));
                    });
    }
    [[noreturn]] void reject(TetId t, const char* what) const {
        const VertexId* v = tet(t).v;
        fail(MGDT_ERR_CHECK_FAILED,
             "tetrahedron of points %lld %lld %lld %lld (-1: infinity or none): %s", index(v[0]),
             index(v[1]), index(v[2]), index(v[3]), what);
    }

    Team& team_;
    const Mesh& mesh_;
    Allocator& allocator_;
    const std::int32_t base_;
};

// Every point given is in the map, at a vertex whose index is the least of its points.
void Checker::points(const Buffer<VertexId>& point_map) const {
    Buffer<std::uint32_t> least(allocator_);
    least.resize(mesh_.vertices.size(), no_index);
    for (std::size_t i = point_map.size(); i-- > 0;) {
        if (point_map[i] >= mesh_.vertices.size())
            fail(MGDT_ERR_CHECK_FAILED, "point %lld is mapped to no vertex",
                 static_cast<long long>(i) + base_);
        least[point_map[i]] = static_cast<std::uint32_t>(i);
    }
    for (VertexId v = 1; v < mesh_.vertices.size(); ++v)
        if (least[v] != mesh_.vertices[v].index)
            fail(MGDT_ERR_CHECK_FAILED, "vertex of point %lld does not have its least index",
                 index(v));
}

// Vertices exist and differ; ghosts are marked as such; counts agree.
void Checker::records() const {
    std::size_t live = 0, ghosts = 0;
    for (const Tetrahedron& t : mesh_.tetrahedra) {
        live += !t.is_dead();
        ghosts += !t.is_dead() && t.is_ghost();
    }
    for_each_live([&](TetId id) {
        const Tetrahedron& t = tet(id);
        int infinite = 0;
        for (int i = 0; i < 4; ++i) {
            if (t.v[i] >= mesh_.vertices.size()) reject(id, "a vertex does not exist");
            infinite += t.v[i] == infinite_vertex;
            for (int j = 0; j < i; ++j)
                if (t.v[i] == t.v[j]) reject(id, "a vertex is there twice");
        }
        if (infinite != (t.is_ghost() ? 1 : 0)) reject(id, "wrongly marked as ghost or finite");
    });
    if (live != mesh_.live_count() || ghosts != mesh_.ghost_count)
        fail(MGDT_ERR_CHECK_FAILED, "counts of tetrahedra are wrong");
    if (live != 0 && (mesh_.a_ghost >= mesh_.tetrahedra.size() || tet(mesh_.a_ghost).is_dead() ||
                      !tet(mesh_.a_ghost).is_ghost()))
        fail(MGDT_ERR_CHECK_FAILED, "what is kept as a ghost is none");
    // As many free slots as dead tetrahedra, so it is enough that each is dead and there once.
    Buffer<std::uint64_t> seen(allocator_);
    seen.resize(mesh_.tetrahedra.size() / 64 + 1, 0);
    for (const TetId t : mesh_.free_slots) {
        if (t >= mesh_.tetrahedra.size() || !tet(t).is_dead() || (seen[t >> 6] >> (t & 63) & 1))
            fail(MGDT_ERR_CHECK_FAILED, "slot %u is wrongly in the list of free ones",
                 static_cast<unsigned>(t));
        seen[t >> 6] |= std::uint64_t{1} << (t & 63);
    }
    if (mesh_.near.size() != mesh_.vertices.size())
        fail(MGDT_ERR_CHECK_FAILED, "tetrahedra near vertices are missing");
    for (VertexId v = 1; v < mesh_.vertices.size(); ++v) {
        if (mesh_.near[v] >= mesh_.tetrahedra.size())
            fail(MGDT_ERR_CHECK_FAILED, "the tetrahedron near point %lld does not exist", index(v));
    }
}

// Neighbours point at each other and share the facet, with opposite orientation.
void Checker::adjacency() const {
    for_each_live([&](TetId id) {
        const Tetrahedron& t = tet(id);
        for (unsigned f = 0; f < 4; ++f) {
            const TetId m = t.n[f] >> 2;
            const unsigned g = t.n[f] & 3;
            if (m >= mesh_.tetrahedra.size() || tet(m).is_dead())
                reject(id, "a neighbour does not exist");
            if (tet(m).n[g] != 4 * id + f) reject(id, "a neighbour does not return the adjacency");
            if (t.v[f == 0] != tet(m).v[g == 0])
                reject(id, "a shared facet has different newest vertices");
            // Seen from m the facet turns the other way.
            VertexId mine[3], theirs[3];
            for (int i = 0; i < 3; ++i) {
                mine[i] = t.v[outer_face[f][i]];
                theirs[i] = tet(m).v[outer_face[g][2 - i]];
            }
            std::rotate(theirs, std::find(theirs, theirs + 3, mine[0]), theirs + 3);
            if (!std::equal(mine, mine + 3, theirs)) reject(id, "a shared facet does not match");
        }
    });
}

// The whole is connected.
void Checker::connection() const {
    Buffer<std::uint64_t> seen(allocator_);
    seen.resize(mesh_.tetrahedra.size() / 64 + 1, 0);
    Buffer<TetId> stack(allocator_);
    const auto visit = [&](TetId t) {
        const std::uint64_t bit = std::uint64_t{1} << (t & 63);
        if (seen[t >> 6] & bit) return;
        seen[t >> 6] |= bit;
        stack.push_back(t);
    };
    visit(mesh_.live_from(0));
    std::size_t reached = 0;
    while (!stack.empty()) {
        const TetId t = stack.back();
        stack.pop_back();
        ++reached;
        for (const FacetCode n : tet(t).n) visit(n >> 2);
    }
    if (reached != mesh_.live_count())
        fail(MGDT_ERR_CHECK_FAILED, "the tetrahedra are not connected");
}

// The link of every vertex is one triangulated sphere: connected through the facets that have the
// vertex, with T = 2 V - 4. Over the whole, E = V + T.
void Checker::links() const {
    const Incidence around(mesh_, allocator_);
    Atomic<std::size_t> ends{0};
    team_.split(mesh_.vertices.size(), 4096, [&](std::size_t first, std::size_t last, unsigned) {
        Buffer<std::uint8_t> is_reached(allocator_);
        Buffer<TetId> stack(allocator_);
        Buffer<VertexId> others(allocator_);
        std::size_t sum = 0;
        for (std::size_t v = first; v < last; ++v) {
            // Ascending, so that a tetrahedron is found by halving.
            const Incidence::Range star = around.tetrahedra(static_cast<VertexId>(v));
            is_reached.clear();
            is_reached.resize(star.size(), 0);
            others.clear();
            std::size_t reached = 0;
            const auto reach = [&](TetId t) {
                const TetId* const found = std::lower_bound(star.begin(), star.end(), t);
                const std::size_t place = static_cast<std::size_t>(found - star.begin());
                if (place == star.size() || *found != t || is_reached[place]) return;
                is_reached[place] = 1;
                stack.push_back(t);
                ++reached;
            };
            if (star.size() > 0) reach(*star.begin());
            while (!stack.empty()) {
                const Tetrahedron& t = tet(stack.back());
                stack.pop_back();
                for (int i = 0; i < 4; ++i) {
                    if (t.v[i] == v) continue;
                    reach(t.n[i] >> 2);
                    others.push_back(t.v[i]);
                }
            }
            std::sort(others.begin(), others.end());
            const auto degree = static_cast<std::size_t>(std::unique(others.begin(), others.end()) -
                                                         others.begin());
            if (reached != star.size() || star.size() + 4 != 2 * degree)
                fail(MGDT_ERR_CHECK_FAILED,
                     "the tetrahedra around point %lld (-1: infinity) are no ball",
                     index(static_cast<VertexId>(v)));
            sum += degree;
        }
        ends += sum;
    });
    if (ends != 2 * (mesh_.vertices.size() + mesh_.live_count()))
        fail(MGDT_ERR_CHECK_FAILED, "the Euler characteristic is not that of a sphere");
}

// Exact positive orientation, and no vertex opposite a facet inside the circumsphere.
void Checker::geometry() const {
    for_each_live([&](TetId id) {
        const Tetrahedron& t = tet(id);
        if (t.is_ghost()) return;
        const double* p[4];
        for (int i = 0; i < 4; ++i) p[i] = mesh_.point(t.v[i]);
        if (orientation(p[0], p[1], p[2], p[3]) <= 0) reject(id, "not positively oriented");
        for (const FacetCode n : t.n) {
            const Tetrahedron& m = tet(n >> 2);
            const VertexId opposite = m.v[n & 3];
            if (m.is_ghost()) continue;
            if (side_of_sphere(p[0], p[1], p[2], p[3], mesh_.point(opposite)) > 0)
                reject(id, "a neighbour's vertex is inside its circumsphere");
        }
    });
}

// Every facet locally regular, the ghosts' too (which is convexity) and ties as the perturbation
// breaks them.
void Checker::regularity() const {
    for_each_live([&](TetId id) {
        const Tetrahedron& t = tet(id);
        for (const FacetCode n : t.n) {
            const VertexId opposite = tet(n >> 2).v[n & 3];
            if (opposite == infinite_vertex) continue;
            if (is_conflict_exact(mesh_, t, mesh_.point(opposite)))
                reject(id, t.is_ghost() ? "the hull is not convex there"
                                        : "a tie is not broken canonically");
        }
    });
}

}  // namespace

void check_mesh(Team& team, const Mesh& mesh, const Buffer<VertexId>& point_map,
                Allocator& allocator, std::int32_t level, std::int32_t base) {
    const Checker check(team, mesh, allocator, base);
    check.points(point_map);
    if (mesh.live_count() == 0) return;
    check.records();
    check.adjacency();
    check.connection();
    check.links();
    if (level >= MGDT_CHECK_GEOMETRIC) check.geometry();
    if (level >= MGDT_CHECK_CANONICAL) check.regularity();
}

}  // namespace mgdt
