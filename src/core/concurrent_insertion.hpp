// SPDX-License-Identifier: MIT
// Insertion by several threads, stage after stage.
//
// Each thread has a zone: a run of consecutive points of a round. As the schedule follows a curve,
// a zone is compact, and zones are equal in points, not in volume. There are two ways to insert.
//
// In zones, a thread changes what is inside its zone and never looks at the others; it defers a
// point that would change anything else. Where few points are near the border of zones, this costs
// no more than one thread alone (core/zones.hpp).
//
// Anywhere, a thread may change any tetrahedron. It goes along its zone and keeps the blocks of
// vertices that it touches for some hundred points (parallel/block_ownership.hpp). A point that
// needs a block of another thread is deferred, tried again when this thread has given its blocks
// back, and in the end inserted by fewer threads, or by one.
//
// ConcurrentPolicy decides which way is taken and by how many threads, ConcurrentInsertion goes
// through the stages, and a Worker has the loop of one thread. The tetrahedra do not depend on any
// of this, since the Delaunay triangulation of the points is unique.
#pragma once

#include "core/batch.hpp"
#include "core/concurrent_policy.hpp"
#include "core/concurrent_worker.hpp"
#include "core/zones.hpp"
#include "parallel/per_member.hpp"

namespace mgdt {

class ConcurrentInsertion {
  public:
    // Vertices of the batch are in the mesh from `base` on, in the order of the schedule.
    ConcurrentInsertion(State& state, Team& team, const Batch& batch, const Schedule& schedule,
                        std::size_t base, bool may_stop);
    ~ConcurrentInsertion();
    ConcurrentInsertion(const ConcurrentInsertion&) = delete;
    ConcurrentInsertion& operator=(const ConcurrentInsertion&) = delete;

    // Inserts all points but the first `done`. Throws as insert_batch(); points that are not in
    // have no tetrahedron near then.
    void run(std::size_t done);

  private:
    void insert_round(const Zones::Round& round);
    std::uint64_t times_deferred() const;

    // Anywhere.
    void insert_anywhere(Items items, unsigned threads);
    void insert_by_threads(const Items& items, unsigned threads);
    void insert_alone(const Items& items);
    void insert_deferred_first();
    double insert_last_alone(Buffer<std::uint32_t>& list, std::size_t n);
    void insert_serially(std::size_t k, bool is_near_last);

    // In zones.
    bool insert_in_zones(const Zones::Round& round, unsigned threads);
    bool list_border(const Zones::Round& round, unsigned threads, Buffer<std::uint32_t>& border);
    void insert_inside(const Zones::Round& round, unsigned threads);
    void insert_between_closed(unsigned threads);

    // Between stages.
    void begin_stage(const Items& items, unsigned threads);
    void end_stage(unsigned threads);
    std::size_t insert_hubs();
    bool try_to_grow_storage(unsigned threads);
    Buffer<std::uint32_t> take_left();
    void poll(std::size_t done);

    State& state_;
    Team& team_;
    const bool may_stop_;
    const Positions positions_;
    ConcurrentPolicy policy_;
    BlockOwners owners_;
    SlotSupply supply_;
    WorkQueue queue_;
    Zones zones_;
    Stage stage_;
    PerMember<Worker> workers_;
    Buffer<std::uint32_t> left_;  // positions that a stage has left, the deferred ones first
    std::size_t deferred_ = 0;    // of these
    std::size_t next_report_ = 0;
};

}  // namespace mgdt
