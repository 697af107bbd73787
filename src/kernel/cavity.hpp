// SPDX-License-Identifier: MIT
// The cavity: all tetrahedra in conflict with q, and its boundary.
//
// One array holds the members, each a tetrahedron and the face through which it was reached. The
// four neighbours of a member are tested together. There is no branch on whether a neighbour is in
// conflict: four codes are written to an array, and its end moves by the number of codes that
// count. The branches that remain are rarely taken. A tetrahedron outside may be tested through
// several faces; each of these faces is a facet of the boundary.
//
// A tetrahedron that joins the cavity gets a mark, one bit of its second vertex. Nothing else
// changes before the star is built, so an insertion is given up by removing the marks. Tests with
// kept spheres do not read the second vertex, so no test has to wait for the store of a mark. Where
// other threads may test a member too, the marks are in a table of the thread's own.
#pragma once

#include <algorithm>
#include <cassert>

#include "kernel/access.hpp"
#include "kernel/cavity_marks.hpp"
#include "kernel/powers.hpp"
#include "kernel/ties.hpp"
#include "kernel/words.hpp"
#include "kernel/workspace.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// Where a cavity begins. If `faces` is 0, the cavity begins at this tetrahedron, which is in
// conflict. Otherwise the tetrahedron is not in conflict, but its neighbours across these faces
// are.
struct CavityStart {
    TetId tetrahedron;
    std::uint32_t faces;  // a bit mask
};

// How far the arrays of the workspace are filled. grow() works on a local copy: its loop makes no
// out-of-line calls, so the copy stays in registers.
template <class Access>
struct CavityFront {
    using Record = TetrahedronStore::Record<Access::SphereSource::are_kept>;
    using Neighbors = FourTetrahedra<Record>;

    MGDT_ALWAYS_INLINE CavityFront(Access access, Mesh& mesh, Workspace& w)
        : tetrahedra(mesh.tetrahedra.view<Access::SphereSource::are_kept>()),
          next(w.cavity.data),
          end(w.cavity.data),
          limit(limit_of(access, w)),
          boundary_end(w.boundary.data) {
        if constexpr (Access::has_mark_table) marks = access.marks().view();
    }
    static FacetCode* limit_of(Access access, const Workspace& w) {
        std::size_t most = w.cavity_capacity;
        if constexpr (Access::has_mark_table) most = std::min(most, access.marks().capacity());
        return w.cavity.data + most - 4;
    }
    // Puts the first members and facets into the arrays.
    MGDT_ALWAYS_INLINE void begin(Workspace& w, CavityStart start) {
        const Tetrahedron& t = tetrahedra[start.tetrahedron];
        assert(!t.is_dead() && "the cavity begins at a dead tetrahedron");
        assert(start.faces < 16 && "a tetrahedron has four faces");
        if (start.faces == 0) {
            // The first member is entered through no face; face 0 is recorded instead.
            for (unsigned i = 1; i < 4; ++i) w.first_corners[i] = t.v[i];
            w.first_corners[0] = t.v[1];
            *end++ = first_facet(start.tetrahedron);
            if constexpr (Access::has_mark_table)
                marks.put(start.tetrahedron, 1);
            else
                tetrahedra[start.tetrahedron].v[1] |= in_cavity;
            return;
        }
        // t stays outside, and its facets to members are boundary facets. first_corners may only
        // hold vertices of the cavity. Two such facets have all four vertices of t. A single one
        // lacks the vertex opposite it, which is replaced by another vertex of t.
        const bool is_one = (start.faces & (start.faces - 1)) == 0;
        for (unsigned i = 0; i < 4; ++i) {
            w.first_corners[i] = is_one && (start.faces >> i & 1) ? t.v[(i + 1) & 3] : t.v[i];
            *boundary_end = facet_code(start.tetrahedron, i);
            boundary_end += start.faces >> i & 1;
        }
        take(tetrahedra.four(t.n), t.n, start.faces);
    }
    // A function that says whether a tetrahedron is in the cavity.
    MGDT_ALWAYS_INLINE auto membership() const {
        if constexpr (Access::has_mark_table)
            return [m = marks](FacetCode code) { return m.has(tetrahedron_of(code)); };
        else
            return [all = tetrahedra](FacetCode code) { return all.of(code).is_in_cavity(); };
    }
    // Adds the neighbours in conflict to the cavity, unless they are members already. The facets of
    // the other active neighbours go to the boundary. `codes` are the facets on the neighbours'
    // side.
    MGDT_ALWAYS_INLINE void sort_out(const Neighbors& four, const FacetCode* codes,
                                     std::uint32_t active, std::uint32_t conflict) {
        assert((conflict & ~active) == 0 && "a neighbour that was not tested is in conflict");
        boundary_end += append(boundary_end, codes, active & ~conflict);
        take(four, codes, conflict);
    }
    MGDT_ALWAYS_INLINE void take(const Neighbors& four, const FacetCode* codes,
                                 std::uint32_t conflict) {
        assert(end <= limit && "there is no room for four more members");
        std::uint32_t fresh;
        if constexpr (Access::has_mark_table)
            fresh = put_four(marks, codes, conflict);
        else
            fresh = mark_four(four, conflict);
        end += append(end, codes, fresh);
    }
    // Like sort_out(), but if neighbours may be closed, writes only to those in conflict.
    void sort_out_apart(const FacetCode* codes, std::uint32_t active, std::uint32_t conflict) {
        assert((conflict & ~active) == 0 && "a neighbour that was not tested is in conflict");
        boundary_end += append(boundary_end, codes, active & ~conflict);
        take_apart(codes, conflict);
    }
    void take_apart(const FacetCode* codes, std::uint32_t conflict) {
        if constexpr (Access::has_mark_table || Access::is_alone) {
            take(tetrahedra.four(codes), codes, conflict);
        } else {
            for (; conflict != 0; conflict &= conflict - 1) {
                const FacetCode code = codes[lowest_bit(conflict)];
                Tetrahedron& t = tetrahedra.of(code);
                if (t.is_in_cavity()) continue;
                t.v[1] |= in_cavity;
                *end++ = code;
            }
        }
    }
    MGDT_ALWAYS_INLINE std::size_t members(const Workspace& w) const {
        assert(next <= end && "more members were passed than there are");
        return static_cast<std::size_t>(end - w.cavity.data);
    }
    // Enlarges the arrays for the neighbours of one more member. If memory runs out, gives up the
    // cavity and throws the exception again.
    void enlarge(Access access, Mesh& mesh, Workspace& w) {
        const std::size_t passed = static_cast<std::size_t>(next - w.cavity.data),
                          size = members(w),
                          facets = static_cast<std::size_t>(boundary_end - w.boundary.data);
        try {
            if (size + 4 > w.cavity_capacity) w.grow_cavity(size, facets, size + 4);
            if constexpr (Access::has_mark_table)
                access.marks().grow(std::min(w.cavity_capacity, 4 * size), w.cavity.data, size);
        } catch (...) {
            give_up(mesh, w, size);
            throw;
        }
        if constexpr (Access::has_mark_table) marks = access.marks().view();
        next = w.cavity.data + passed;
        end = w.cavity.data + size;
        limit = limit_of(access, w);
        boundary_end = w.boundary.data + facets;
    }
    static void give_up(Mesh& mesh, Workspace& w, std::size_t members) {
        assert(members > 0 && "a cavity without members is given up");
        w.given_up = members;
        if constexpr (!Access::has_mark_table) w.restore_cavity(mesh.tetrahedra, members);
    }

    TetrahedronView<Record> tetrahedra;
    FacetCode* next;  // the first member whose neighbours are still to be tested
    FacetCode* end;
    FacetCode* limit;  // the largest `end` that leaves room for four more members
    FacetCode* boundary_end;
    MarkTable::View marks;  // used among other threads
};

// The result of decide() if another thread owns a neighbour; not a set of faces.
constexpr std::uint32_t not_owned = 16;

// Returns which of the undecided neighbours are in conflict, or not_owned if the test or the cavity
// needs a neighbour that this thread may not change. A neighbour that is a member already counts as
// in conflict. It is not tested, because its second vertex has a mark. Points of a lattice give
// many undecided signs with unpredictable answers, so the code has few branches.
template <class Access, class IsIn>
MGDT_PREDICATES_APART std::uint32_t decide(Access access, const Mesh& mesh, Workspace& w,
                                           IsIn is_in, const FacetCode* n, std::uint32_t undecided,
                                           const Query& q) {
    std::uint32_t conflict = 0;
    for (unsigned k = 0; k < 4; ++k) conflict |= static_cast<std::uint32_t>(is_in(n[k])) << k;
    conflict &= undecided;
    for (undecided &= ~conflict; undecided != 0; undecided &= undecided - 1) {
        const unsigned k = lowest_bit(undecided);
        const Tetrahedron& t = mesh.tetrahedra[tetrahedron_of(n[k])];
        // A ghost's tie is decided by the finite tetrahedron on the other side of its hull facet,
        // which this thread may read only if it owns the ghost, or if both are closed.
        const bool is_mine = access.try_own(t);
        if (Access::has_mark_table && !is_mine) return not_owned;
        ++w.counters.exact_calls;
        const bool is_in_conflict = is_conflict_near_tie(mesh, t, q);
        if (is_in_conflict && !is_mine) return not_owned;
        conflict |= hide_from_optimizer(is_in_conflict) << k;
    }
    return conflict;
}

// All faces of a member but the one that it was reached through.
MGDT_ALWAYS_INLINE std::uint32_t other_faces(FacetCode code) {
    return 0xFu ^ (1u << face_of(code));
}

// The neighbours of a member that are tested: all of them, or those that are not beyond walls. The
// member itself stands for the others.
template <class Access>
class OpenNeighbors {
  public:
    MGDT_ALWAYS_INLINE OpenNeighbors(Access access, FacetCode member, const FacetCode* n) noexcept
        : faces_(0xFu & ~access.walls_of(member)) {
        for (unsigned k = 0; k < 4; ++k) codes_[k] = faces_ >> k & 1 ? n[k] : member;
    }
    MGDT_ALWAYS_INLINE const FacetCode* codes() const noexcept { return codes_; }
    MGDT_ALWAYS_INLINE std::uint32_t faces() const noexcept { return faces_; }

  private:
    std::uint32_t faces_;
    FacetCode codes_[4];
};
struct AllNeighbors {
    MGDT_ALWAYS_INLINE const FacetCode* codes() const noexcept { return n; }
    MGDT_ALWAYS_INLINE static constexpr std::uint32_t faces() noexcept { return 0xFu; }
    const FacetCode* n;
};
template <class Access>
MGDT_ALWAYS_INLINE auto open_neighbors([[maybe_unused]] Access access,
                                       [[maybe_unused]] FacetCode member, const FacetCode* n) {
    if constexpr (Access::has_walls)
        return OpenNeighbors<Access>(access, member, n);
    else
        return AllNeighbors{n};
}

// Why growing pauses.
enum class Pause {
    done,         // the neighbours of all members are tested
    no_room,      // the arrays have no room for the neighbours of the next member
    not_entered,  // another thread owns the next member
    undecided,    // the filter leaves the sign of a neighbour open
};

// One bit for each face of the next member. The neighbours beyond active faces are tested;
// `conflict` and `undecided` are the results.
struct Tests {
    std::uint32_t active, conflict, undecided;
};

// Tests the neighbours of one member after the other and sorts them, until a rare case occurs. The
// caller handles the rare case, since a call in this loop would take registers from the loop.
template <class Access>
MGDT_ALWAYS_INLINE Pause grow(Access access, const Mesh& mesh, const Query& q,
                              CavityFront<Access>& cavity, Tests& tests) {
    CavityFront<Access> front = cavity;
    const typename Access::SphereSource spheres(mesh);
    const QueryRows query(q);
    std::uint32_t active = tests.active, conflict = 0, undecided = 0;
    Pause pause = Pause::no_room;
    // The code of the next member is loaded before the stores of this turn: a load after them would
    // wait for all of them, and the turns would not overlap.
    FacetCode member = *front.next;
    while (front.end <= front.limit) {
        // In a zone every member belongs to this thread: decide() admits no other.
        if constexpr (Access::has_mark_table) {
            if (MGDT_UNLIKELY(!access.try_own(front.tetrahedra.of(member)))) {
                pause = Pause::not_entered;
                break;
            }
        }
        const FacetCode* const n = front.tetrahedra.of(member).n;
        const auto open = open_neighbors(access, member, n);
        const auto four = front.tetrahedra.four(open.codes());
        const FourPowers powers(spheres, four, query);
        conflict = powers.negative() & active & open.faces();
        undecided = active & open.faces() & ~powers.decided();
        if (MGDT_UNLIKELY(undecided != 0)) {
            pause = Pause::undecided;
            break;
        }
        ++front.next;
        FacetCode following = *front.next;
        const bool is_last = front.next == front.end;
        front.sort_out(four, n, active, conflict);
        if (MGDT_UNLIKELY(is_last)) {  // there was no next member before sort_out()
            if (front.next == front.end) {
                pause = Pause::done;
                break;
            }
            following = hide_from_optimizer(*front.next);
        }
        member = following;
        active = other_faces(member);
    }
    cavity = front;
    tests = {active, conflict, undecided};
    return pause;
}

// Digs the cavity. Returns false, with the insertion given up, if a member or an undecided
// neighbour belongs to another thread.
template <class Access>
MGDT_NOT_INLINE bool dig_cavity(Access access, Mesh& mesh, Workspace& w, CavityStart start,
                                const Query& q) {
    if (MGDT_UNLIKELY(w.cavity_capacity == 0)) w.grow_cavity(0, 0, 64);
    if constexpr (Access::has_mark_table) access.marks().begin(MarkTable::least_capacity);
    CavityFront<Access> cavity(access, mesh, w);
    cavity.begin(w, start);
    // If the cavity begins at a member, all four neighbours of this member are tested.
    Tests tests = {start.faces == 0 ? 0xFu : other_faces(*cavity.next), 0, 0};
    for (;;) {
        const Pause pause = grow(access, mesh, q, cavity, tests);
        if (pause == Pause::done) break;
        if (pause == Pause::no_room) {
            cavity.enlarge(access, mesh, w);
            continue;
        }
        std::uint32_t decided = not_owned;
        const FacetCode* const n = cavity.tetrahedra.of(*cavity.next).n;
        if (pause == Pause::undecided)
            decided = decide(access, mesh, w, cavity.membership(), n, tests.undecided, q);
        if (decided == not_owned) {
            cavity.give_up(mesh, w, cavity.members(w));
            return false;
        }
        ++cavity.next;
        cavity.sort_out_apart(n, tests.active, (tests.conflict & ~tests.undecided) | decided);
        if (cavity.next == cavity.end) break;
        tests.active = other_faces(*cavity.next);
    }
    w.cavity_size = cavity.members(w);
    w.boundary_size = static_cast<std::size_t>(cavity.boundary_end - w.boundary.data);
    assert(w.boundary_size >= 4 && w.boundary_size % 2 == 0 &&
           "the boundary of the cavity is no sphere");
    assert(w.boundary_size <= 2 * w.cavity_size + 2 && "more facets than the members have");
    // Three neighbours of each member were tested, and a fourth if the cavity began at a member.
    w.counters.conflict_tests += 3 * w.cavity_size + (start.faces == 0 ? 1 : 0);
    return true;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
