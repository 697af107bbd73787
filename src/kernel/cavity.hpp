// SPDX-License-Identifier: MIT
// The cavity: all tetrahedra in conflict with q, grown from one of them, and its boundary.
//
// One array holds the members, each a tetrahedron and the face it is reached through. The
// neighbours of one are tested together, and no branch is unpredictable: the outcome moves the ends
// of the arrays by 0 to 4, and only the rare undecided sign branches. A tetrahedron outside may be
// tested through several faces; each is a facet of the boundary.
//
// Entering the cavity marks a tetrahedron in its second vertex, so that an insertion can be given
// up until the star is built. The mark is where no test of kept spheres looks, since a load that
// may meet a store just made waits for it. Among other threads it is in a table of the thread's
// own.
#pragma once

#include "kernel/access.hpp"
#include "kernel/eight_rows.hpp"
#include "kernel/marks.hpp"
#include "kernel/pieces.hpp"
#include "kernel/powers.hpp"
#include "kernel/ties.hpp"

namespace mgdt {
inline namespace MGDT_ISA {

// Where a cavity begins: the tetrahedra in conflict among one that is in conflict, or among the
// neighbours of one that is not.
struct CavityStart {
    TetId tetrahedron;
    std::uint32_t faces;  // beyond which the neighbours are in conflict; 0: the tetrahedron itself
};

// The arrays of the workspace and how far they are filled. Only parts are passed to what is not in
// line, so that the rest stays in registers.
template <class Access>
class CavityFront {
  public:
    using Record = TetrahedronStore::Record<Access::SphereSource::are_kept>;
    using Neighbors = FourTetrahedra<Record>;

    MGDT_ALWAYS_INLINE CavityFront(Access access, Mesh& mesh, Workspace& w, CavityStart start)
        : access_(access),
          workspace_(w),
          mesh_(mesh),
          tetrahedra_(mesh.tetrahedra.view<Access::SphereSource::are_kept>()) {
        if (MGDT_UNLIKELY(w.cavity_capacity == 0)) w.grow_cavity(0, 0, 64);
        if constexpr (Access::is_shared) access_.marks().begin(w.cavity_capacity);
        point_to_arrays();
        const Tetrahedron& t = tetrahedra_[start.tetrahedron];
        if (start.faces == 0) {
            // It is entered through no face; face 0 stands in.
            for (unsigned i = 1; i < 4; ++i) w.first_corners[i] = t.v[i];
            w.first_corners[0] = t.v[1];
            cavity_[members++] = 4 * start.tetrahedron;
            if constexpr (Access::is_shared)
                marks_.put(start.tetrahedron, 1);
            else
                tetrahedra_[start.tetrahedron].v[1] |= in_cavity;
            return;
        }
        // Seen from its neighbours, t is outside. With two of them all its vertices are corners.
        const bool is_one = (start.faces & (start.faces - 1)) == 0;
        for (unsigned i = 0; i < 4; ++i) {
            w.first_corners[i] = is_one && (start.faces >> i & 1) ? t.v[(i + 1) & 3] : t.v[i];
            boundary_[facets] = 4 * start.tetrahedron + i;
            facets += start.faces >> i & 1;
        }
        take(four(t.n), t.n, start.faces);
    }
    // Room for one more member's neighbours.
    MGDT_ALWAYS_INLINE void reserve() {
        if (MGDT_UNLIKELY(members + 4 > workspace_.cavity_capacity)) {
            enlarge(access_, mesh_, workspace_, members, facets);
            point_to_arrays();
        }
    }
    MGDT_ALWAYS_INLINE FacetCode member(std::size_t i) const { return cavity_[i]; }
    MGDT_ALWAYS_INLINE Neighbors four(const FacetCode* codes) const {
        return tetrahedra_.four(codes);
    }
    // What tells whether a tetrahedron is in.
    MGDT_ALWAYS_INLINE auto membership() const {
        if constexpr (Access::is_shared)
            return [marks = marks_](FacetCode code) { return marks.has(code >> 2); };
        else
            return [all = tetrahedra_](FacetCode code) { return all.of(code).is_in_cavity(); };
    }
    // Gives the cavity up.
    MGDT_ALWAYS_INLINE void abandon() const { give_up(mesh_, workspace_, members); }
    // Takes those of four facets whose bits are set.
    MGDT_ALWAYS_INLINE void add_boundary(const FacetCode* codes, std::uint32_t outside) {
        facets += append(boundary_ + facets, codes, outside);
    }
    // Takes in those of four tetrahedra, reached through these facets, whose bits are set, unless
    // they are in already.
    MGDT_ALWAYS_INLINE void take(const Neighbors& four, const FacetCode* codes,
                                 std::uint32_t conflict) {
        std::uint32_t fresh;
        if constexpr (Access::is_shared)
            fresh = put_four(marks_, codes, conflict);
        else
            fresh = mark_four(four, conflict);
        members += append(cavity_ + members, codes, fresh);
    }
    // `whole`: members of which all four neighbours were tested, and not three.
    MGDT_ALWAYS_INLINE void finish(std::size_t whole) const {
        workspace_.cavity_size = members;
        workspace_.boundary_size = facets;
        workspace_.counters.conflict_tests += 3 * members + whole;
    }

    std::size_t members = 0, facets = 0;

  private:
    MGDT_ALWAYS_INLINE void point_to_arrays() {
        cavity_ = workspace_.cavity.data;
        boundary_ = workspace_.boundary.data;
        if constexpr (Access::is_shared) marks_ = access_.marks().view();
    }
    static void enlarge(Access access, Mesh& mesh, Workspace& w, std::size_t members,
                        std::size_t facets) {
        try {
            w.grow_cavity(members, facets, members + 4);
            if constexpr (Access::is_shared)
                access.marks().grow(w.cavity_capacity, w.cavity.data, members);
        } catch (...) {
            give_up(mesh, w, members);
            throw;
        }
    }
    static void give_up(Mesh& mesh, Workspace& w, std::size_t members) {
        if constexpr (!Access::is_shared) w.restore_cavity(mesh.tetrahedra, members);
    }

    const Access access_;
    Workspace& workspace_;
    Mesh& mesh_;
    const TetrahedronView<Record> tetrahedra_;
    FacetCode *cavity_, *boundary_;
    MarkTable::View marks_;  // used among other threads
};

constexpr std::uint32_t not_entered = 16;

// Which of the undecided among four neighbours are in conflict, or not_entered. On a lattice there
// are many, and nothing about them can be foretold, so that branches are few.
template <class Access, class IsIn>
MGDT_PREDICATES_APART std::uint32_t decide(Access access, const Mesh& mesh, Workspace& w,
                                           IsIn is_in, const FacetCode* n, std::uint32_t undecided,
                                           const Query& q) {
    std::uint32_t conflict = 0;
    for (unsigned k = 0; k < 4; ++k) conflict |= static_cast<std::uint32_t>(is_in(n[k])) << k;
    conflict &= undecided;
    for (undecided &= ~conflict; undecided != 0; undecided &= undecided - 1) {
        const unsigned k = lowest_bit(undecided);
        const Tetrahedron& t = mesh.tetrahedra[n[k] >> 2];
        // A ghost's tie is decided by the tetrahedron behind it, which is a neighbour of mine only
        // if the ghost is mine.
        if (!access.enter(t)) return not_entered;
        ++w.counters.exact_calls;
        conflict |= opaque(is_conflict_near_tie(mesh, t, q)) << k;
    }
    return conflict;
}

// Whether the cavity was dug: not if a tetrahedron of it may not be entered.
template <class Access>
inline bool dig_cavity(Access access, Mesh& mesh, Workspace& w, CavityStart start, const Query& q) {
    const typename Access::SphereSource spheres(mesh);
    const auto tetrahedra = spheres.tetrahedra;
    CavityFront<Access> front(access, mesh, w, start);
    const Query query = q;  // no store changes it
    // The first member is entered through no face if it is the start itself.
    std::uint32_t entered = start.faces != 0;
    // Each member's code is read one turn ahead: a load right after the stores that this turn
    // makes would wait for all of them, and the turns would not overlap.
    FacetCode member = front.member(0);
    for (std::size_t done = 0; done < front.members; ++done) {
        if (MGDT_UNLIKELY(!access.enter(tetrahedra.of(member)))) {
            front.abandon();
            return false;
        }
        front.reserve();
        const bool is_last = done + 1 == front.members;
        FacetCode next = front.member(done + 1);
        const FacetCode* const n = tetrahedra.of(member).n;
        const auto four = front.four(n);
        const FourPowers powers(spheres, four, query);
        // All but the one that it was reached through.
        const std::uint32_t active = 0xFu & ~(entered << (member & 3));
        entered = 1;
        std::uint32_t conflict = powers.negative() & active;
        const std::uint32_t undecided = active & ~powers.decided();
        if (MGDT_UNLIKELY(undecided != 0)) {
            const std::uint32_t decided =
                decide(access, mesh, w, front.membership(), n, undecided, q);
            if (decided == not_entered) {
                front.abandon();
                return false;
            }
            conflict = (conflict & ~undecided) | decided;
        }
        front.add_boundary(n, active & ~conflict);
        front.take(four, n, conflict);
        if (MGDT_UNLIKELY(is_last)) next = opaque(front.member(done + 1));
        member = next;
    }
    front.finish(start.faces == 0 ? 1 : 0);
    return true;
}

}  // namespace MGDT_ISA
}  // namespace mgdt
