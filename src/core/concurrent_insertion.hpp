// SPDX-License-Identifier: MIT
// Insertion by several threads, stage after stage.
//
// Each thread has a zone: a run of consecutive points of a round. As the schedule follows a curve,
// a zone is compact, and zones are equal in points, not in volume. There are two ways to insert.
//
// In zones, a thread removes only tetrahedra inside its zone, without synchronisation, and defers a
// point that would remove any other tetrahedron. Where few points are near the border of zones, an
// insertion costs no more than with one thread (core/zones.hpp).
//
// Anywhere, a thread may change any tetrahedron. The thread goes along its zone and owns the blocks
// of vertices that it touches until it has tried a piece of at most 64 points
// (parallel/block_ownership.hpp). A point that needs a block of another thread is deferred, tried
// again when this thread has given its blocks back, and finally inserted by fewer threads or one.
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
    // The points of the batch are the vertices of the mesh from `base` on, in the order of the
    // schedule.
    ConcurrentInsertion(State& state, Team& team, const Batch& batch, const Schedule& schedule,
                        std::size_t base, bool may_stop);
    ~ConcurrentInsertion();
    ConcurrentInsertion(const ConcurrentInsertion&) = delete;
    ConcurrentInsertion& operator=(const ConcurrentInsertion&) = delete;

    // Inserts all points but the first `done`. Throws as insert_batch(); the vertex hint of a point
    // that is not inserted is then no_tetrahedron.
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
    std::size_t deferred_ = 0;    // the number of deferred positions in `left_`
    std::size_t next_report_ = 0;
};

}  // namespace mgdt
