// SPDX-License-Identifier: MIT
// Insertion by several threads, each in a zone of its own.
//
// A zone is a run of consecutive points of a round: as the schedule follows a curve, it is compact,
// and zones are equal in points, not in volume. There are two ways. In one, a thread changes what
// is inside its zone without a look at the others, and puts off what is not: where the points at
// the border of zones are few, this costs no more than one thread alone (core/zones.hpp). In the
// other, a thread may change anything: it goes along its zone and keeps the blocks of vertices that
// it touches for some hundred points (parallel/block_ownership.hpp). A point that needs a block of
// another thread is deferred, tried again when this thread has given its blocks back, and in the
// end inserted while nobody else is there. Where most tries fail, as at a vertex with edges to all
// others, all stop, one inserts what was put off, and then a sample of the rest: if that is twice
// as fast a point, and the next time too, it goes on alone. The tetrahedra do not depend on any of
// this, since the Delaunay triangulation of the points is unique.
#pragma once

#include "core/batch.hpp"
#include "core/state.hpp"
#include "core/zones.hpp"
#include "kernel/kernel.hpp"
#include "kernel/thread_state.hpp"
#include "parallel/work_queue.hpp"

namespace mgdt {

class ConcurrentInsertion {
  public:
    // Vertices of the batch are in the mesh from `base` on, in the order of the schedule.
    ConcurrentInsertion(State& state, Team& team, const Batch& batch, const Schedule& schedule,
                        std::size_t base, bool may_stop);
    ~ConcurrentInsertion();

    // Inserts all points but the first `done`. Throws as insert_scheduled(); points that are not in
    // have no tetrahedron near then.
    void run(std::size_t done);

  private:
    struct Member;
    // Positions in the schedule: a range, or those of a list.
    struct Items {
        std::size_t begin, size;
        const std::uint32_t* list;
        std::size_t operator[](std::size_t i) const { return list ? list[i] : begin + i; }
    };

    using ConcurrentCall = decltype(KernelCalls::insert_concurrent);

    void insert_round(const Zones::Round& round);
    void insert_anywhere(Items items, unsigned members);
    void insert_alone(const Items& items);
    unsigned members_for_round(const Zones::Round& round) const;
    std::uint64_t times_deferred() const;
    bool grow_storage(unsigned members);
    unsigned members_for_few(std::size_t count) const;
    unsigned members_for_left(std::size_t left, std::size_t count) const;
    Buffer<std::uint32_t> take_left();
    void begin_stage(const Items& items, unsigned members);
    // Inserts items on `members` threads and lists those that are left.
    void insert_concurrently(const Items& items, unsigned members);
    void work(Member& member, const Items& items);
    bool is_too_crowded(Member& member);
    bool try_insert(Member& member, std::size_t k);
    bool insert(Member& member, std::size_t k, ConcurrentCall call);
    bool arrive(Member& member, std::size_t k);
    void release_blocks(Member& member);
    void gather_results(unsigned members, const Items& items);
    std::size_t insert_hubs();
    void insert_serially(std::size_t k, bool is_next);

    // Where most tries fail: concurrent_doubts.cpp.
    void insert_put_off();
    bool has_doubts(Member& member) const;
    bool is_faster_alone(Buffer<std::uint32_t>& list, double together, std::size_t inserted);

    // In zones: zone_insertion.cpp.
    bool may_use_zones(const Zones::Round& round, unsigned members) const;
    bool insert_in_zones(const Zones::Round& round, unsigned members);
    bool list_border(const Zones::Round& round, unsigned members, Buffer<std::uint32_t>& border);
    void insert_inside(const Zones::Round& round, unsigned members);
    void insert_closed(const Zones::Round& round, unsigned members);
    void work_inside(Member& member, unsigned zone);
    bool try_insert_inside(Member& member, unsigned zone, std::size_t k);
    bool arrive_inside(Member& member, unsigned zone, std::size_t k);

    template <class F>
    bool for_nearby_positions(std::size_t k, F f) const;
    VertexId vertex(std::size_t k) const { return static_cast<VertexId>(base_ + k); }
    void poll(std::size_t done);

    State& state_;
    Team& team_;
    const Batch& batch_;
    const Schedule& schedule_;
    const std::size_t base_;
    const bool may_stop_;

    BlockOwners owners_;
    SlotSupply supply_;
    WorkQueue queue_;
    Member* members_ = nullptr;
    unsigned member_count_ = 0;
    Buffer<std::uint32_t> left_;
    std::size_t put_off_ = 0;   // of these, the first
    std::size_t far_away_ = 0;  // along the schedule: too far for a walk from the last point
    std::size_t stops_ = 0;     // of this round, for hubs

    Zones zones_;
    bool is_crowded_ = false;  // the round before: many points were deferred

    std::size_t trial_ = 0;        // tries after which a thread may leave
    Atomic<unsigned> active_{0};   // threads that go on
    std::size_t doubt_after_ = 0;  // tries of a thread before it may doubt
    bool was_faster_alone_ = false;
    Atomic<bool> doubts_{false};  // all stop since one may be faster alone
    bool may_stop_for_hubs_ = false;
    Atomic<bool> stop_{false};      // all threads end soon
    Atomic<bool> no_slots_{false};  // why they do: the storage must grow
    Atomic<std::size_t> done_{0};   // positions dealt with
    std::size_t next_report_ = 0;
};

}  // namespace mgdt
