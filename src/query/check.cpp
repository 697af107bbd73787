// SPDX-License-Identifier: MIT
// The combinatorial part of the check: indices, counts and adjacency.
#include "query/check.hpp"

#include <algorithm>

#include "mesh/facet_turns.hpp"
#include "parallel/disjoint_sets.hpp"
#include "platform/atomic.hpp"
#include "query/checker.hpp"

namespace mgdt {

void Checker::run(std::int32_t level) const {
    // The share of the combinatorial part in the time of the check.
    const double share = level < MGDT_CHECK_GEOMETRIC ? 1 : 0.5;
    const auto enter = [&](double from, double to) { progress_.enter(from * share, to * share); };
    enter(0, 0.1);
    points();
    stores();
    if (mesh_.live_count() != 0) {
        enter(0.1, 0.25);
        records();
        enter(0.25, 0.3);
        hints();
        enter(0.3, 0.55);
        adjacency();
        enter(0.55, 0.7);
        connection();
        enter(0.7, 1);
        edges();
    }
    if (level < MGDT_CHECK_GEOMETRIC) return;
    progress_.enter(0.5, 0.55);
    coordinates();
    if (mesh_.live_count() == 0) {
        degenerate();
        return;
    }
    progress_.enter(0.55, 0.8);
    delaunay(level >= MGDT_CHECK_CANONICAL);
    progress_.enter(0.8, 0.9);
    spheres();
    progress_.enter(0.9, 1);
    if (level >= MGDT_CHECK_CANONICAL) hull();
}

// Checks that each point is either at no vertex or mapped to a vertex whose index is the least of
// the vertex's points, and that the statistics have the right numbers of points.
void Checker::points() const {
    const Buffer<VertexId>& map = input_.point_map;
    const std::size_t vertices = mesh_.vertices.size();
    if (vertices == 0) fail(MGDT_ERR_CHECK_FAILED, "the vertex at infinity is missing");
    Buffer<std::uint32_t> least(allocator_);
    least.resize(vertices, no_index);
    std::size_t in = 0;
    for (std::size_t i = map.size(); i-- > 0;) {
        if (map[i] >= vertices)
            fail(MGDT_ERR_CHECK_FAILED, "point %lld is mapped to no vertex",
                 static_cast<long long>(i) + base_);
        if (map[i] == infinite_vertex) continue;
        least[map[i]] = static_cast<std::uint32_t>(i);
        ++in;
    }
    for (VertexId v = 0; v < vertices; ++v)
        if (least[v] != mesh_.vertices[v].index)
            fail(MGDT_ERR_CHECK_FAILED,
                 "vertex %u says it is point %u, but the first point mapped to it is %u (%u: none)",
                 static_cast<unsigned>(v), static_cast<unsigned>(mesh_.vertices[v].index),
                 static_cast<unsigned>(least[v]), static_cast<unsigned>(no_index));
    if (vertices - 1 != input_.points_inserted || in - (vertices - 1) != input_.duplicates)
        fail(MGDT_ERR_CHECK_FAILED,
             "%zu points are in and %zu are repeats, but %llu and %llu were counted", vertices - 1,
             in - (vertices - 1), static_cast<unsigned long long>(input_.points_inserted),
             static_cast<unsigned long long>(input_.duplicates));
}

// Checks that there are tetrahedra exactly if the points span space, that the free slots are those
// of dead tetrahedra, that sizes do not exceed capacities, and that counts are right.
void Checker::stores() const {
    const std::size_t slots = mesh_.tetrahedra.size();
    if (slots > max_tetrahedra || mesh_.slot_limit > max_tetrahedra ||
        mesh_.prefaulted_slots > mesh_.tetrahedra.capacity())
        fail(MGDT_ERR_CHECK_FAILED, "more tetrahedra than there is room for");
    if (input_.dimension < -1 || input_.dimension > 3 ||
        (input_.dimension == 3) != (mesh_.live_count() != 0))
        fail(MGDT_ERR_CHECK_FAILED, "%zu tetrahedra in dimension %d", mesh_.live_count(),
             input_.dimension);
    // The counts below show that there are as many free slots as dead tetrahedra, so it suffices
    // that each free slot is dead and listed once.
    Buffer<std::uint64_t> seen(allocator_);
    seen.resize(slots / 64 + 1, 0);
    for (const TetId t : mesh_.free_slots) {
        if (t >= slots || !tet(t).is_dead() || (seen[t >> 6] >> (t & 63) & 1))
            fail(MGDT_ERR_CHECK_FAILED, "slot %u is wrongly in the list of free ones",
                 static_cast<unsigned>(t));
        seen[t >> 6] |= std::uint64_t{1} << (t & 63);
    }
    Atomic<std::size_t> live{0}, ghosts{0};
    team_.split(slots, 65536, [&](std::size_t begin, std::size_t end, unsigned) {
        std::size_t my_live = 0, my_ghosts = 0;
        for (std::size_t t = begin; t < end; ++t) {
            my_live += !mesh_.tetrahedra[t].is_dead();
            my_ghosts += !mesh_.tetrahedra[t].is_dead() && mesh_.tetrahedra[t].is_ghost();
        }
        live += my_live;
        ghosts += my_ghosts;
    });
    if (live != mesh_.live_count() || ghosts != mesh_.ghost_count)
        fail(MGDT_ERR_CHECK_FAILED,
             "there are %zu tetrahedra, %zu of them ghosts, but %zu and %zu were counted",
             live.load(), ghosts.load(), mesh_.live_count(), mesh_.ghost_count);
}

// Checks that the vertices of a tetrahedron exist and differ, that each vertex is in a tetrahedron,
// and that exactly the spheres of ghosts are marked as those of ghosts.
void Checker::records() const {
    const std::size_t vertices = mesh_.vertices.size();
    AtomicArray<bool> is_used(allocator_, vertices);
    for_each_live([&](TetId id) {
        const Tetrahedron& t = tet(id);
        int infinite = 0;
        for (int i = 0; i < 4; ++i) {
            if (t.v[i] >= vertices) reject(id, "a vertex does not exist");
            infinite += t.v[i] == infinite_vertex;
            for (int j = 0; j < i; ++j)
                if (t.v[i] == t.v[j]) reject(id, "a vertex is there twice");
        }
        if (infinite != (t.is_ghost() ? 1 : 0)) reject(id, "infinity is not where a ghost has it");
        if (mesh_.tetrahedra.has_spheres() &&
            mesh_.tetrahedra.sphere(id).is_ghost() != t.is_ghost())
            reject(id, "its sphere is wrongly marked as ghost or finite");
        for (const VertexId v : t.v)
            if (!is_used[v].load(std::memory_order_relaxed))
                is_used[v].store(true, std::memory_order_relaxed);
    });
    for_each_vertex([&](VertexId v) {
        if (!is_used[v].load(std::memory_order_relaxed))
            fail(MGDT_ERR_CHECK_FAILED, "point %lld is in no tetrahedron", index(v));
    });
}

// Checks the tetrahedra where walks and traversals start, and the location tree.
void Checker::hints() const {
    const std::size_t slots = mesh_.tetrahedra.size();
    const auto is_live = [&](TetId t) { return t < slots && !tet(t).is_dead(); };
    if (!is_live(mesh_.a_ghost) || !tet(mesh_.a_ghost).is_ghost())
        fail(MGDT_ERR_CHECK_FAILED, "what is kept as a ghost is none (slot %u)",
             static_cast<unsigned>(mesh_.a_ghost));
    if (!is_live(input_.last))
        fail(MGDT_ERR_CHECK_FAILED, "the next walk would start nowhere (slot %u)",
             static_cast<unsigned>(input_.last));
    if (mesh_.vertex_hint.size() != mesh_.vertices.size())
        fail(MGDT_ERR_CHECK_FAILED, "there are %zu slots near %zu vertices",
             mesh_.vertex_hint.size(), mesh_.vertices.size());
    // A hint may name any slot, since the slot of a removed tetrahedron may be reused.
    for_each_vertex([&](VertexId v) {
        if (mesh_.vertex_hint[v] >= slots)
            fail(MGDT_ERR_CHECK_FAILED, "the tetrahedron near point %lld does not exist", index(v));
    });
    if (input_.tree && !input_.tree->is_sound(mesh_.vertices.size()))
        fail(MGDT_ERR_CHECK_FAILED, "the location tree is broken");
}

// Checks that neighbours refer to each other and share the facet, with opposite orientations.
void Checker::adjacency() const {
    for_each_live([&](TetId id) {
        const Tetrahedron& t = tet(id);
        for (unsigned f = 0; f < 4; ++f) {
            const TetId m = tetrahedron_of(t.n[f]);
            const unsigned g = face_of(t.n[f]);
            if (m >= mesh_.tetrahedra.size() || tet(m).is_dead())
                reject(id, "a neighbour does not exist");
            if (tet(m).n[g] != facet_code(id, f))
                reject(id, "a neighbour does not return the adjacency");
            if (mesh_.guards_agree && t.v[f == 0] != tet(m).v[g == 0])
                reject(id, "a shared facet has different newest vertices");
            // Seen from m, the facet has the opposite orientation.
            VertexId mine[3], theirs[3];
            for (int i = 0; i < 3; ++i) {
                mine[i] = t.v[outer_face[f][i]];
                theirs[i] = tet(m).v[outer_face[g][2 - i]];
            }
            turn_to(theirs, theirs[1] == mine[0] ? 1 : theirs[2] == mine[0] ? 2 : 0);
            if (!std::equal(mine, mine + 3, theirs)) reject(id, "a shared facet does not match");
        }
    });
}

// Checks that the tetrahedra are connected through facets.
void Checker::connection() const {
    DisjointSets sets(allocator_, mesh_.tetrahedra.size());
    for_each_live([&](TetId id) {
        for (const FacetCode n : tet(id).n)
            if (tetrahedron_of(n) < id) sets.join(id, tetrahedron_of(n));
    });
    const TetId all = sets.least(mesh_.a_ghost);
    for_each_live([&](TetId id) {
        if (sets.least(id) != all) reject(id, "not connected with the vertex at infinity");
    });
}

// Checks that the tetrahedra around each edge form a ring, and that there are V + T rings, as the
// Euler characteristic of a closed manifold demands. V includes the vertex at infinity. A ring is
// counted at its least tetrahedron.
void Checker::edges() const {
    // Whether `id` is the least tetrahedron of the ring around the edge that its facets c and d
    // share.
    const auto is_least = [&](TetId id, int c, int d) {
        const Tetrahedron& first = tet(id);
        if (tetrahedron_of(first.n[c]) < id || tetrahedron_of(first.n[d]) < id) return false;
        // Since adjacency() has passed, the way around the edge through facet c returns to `id`.
        VertexId behind = first.v[d];
        FacetCode code = first.n[c];
        while (tetrahedron_of(code) > id) {
            const Tetrahedron& t = tet(tetrahedron_of(code));
            const VertexId ahead = t.v[face_of(code)];
            int next = 0;
            while (t.v[next] != behind) ++next;
            code = t.n[next];
            behind = ahead;
        }
        return tetrahedron_of(code) == id;
    };
    Atomic<std::size_t> rings{0};
    team_.split(mesh_.tetrahedra.size(), 16384,
                [&](std::size_t begin, std::size_t end, unsigned member) {
                    std::size_t mine = 0;
                    for (TetId t = static_cast<TetId>(begin); t < end; ++t) {
                        progress_.step(t, begin, end, member);
                        if (!tet(t).is_dead())
                            for (int c = 0; c < 4; ++c)
                                for (int d = 0; d < c; ++d) mine += is_least(t, c, d);
                    }
                    rings += mine;
                });
    if (rings != mesh_.vertices.size() + mesh_.live_count())
        fail(MGDT_ERR_CHECK_FAILED,
             "%zu edges, %zu vertices and %zu tetrahedra: not the Euler characteristic of a sphere",
             rings.load(), mesh_.vertices.size(), mesh_.live_count());
}

void check_triangulation(Team& team, const CheckInput& input, Allocator& allocator,
                         std::int32_t level, std::int32_t base, StageProgress& progress) {
    Checker(team, input, allocator, base, progress).run(level);
}

}  // namespace mgdt
