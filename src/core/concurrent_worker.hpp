// SPDX-License-Identifier: MIT
// One thread of a concurrent insertion: its loop over points, and how it finds where to start.
#pragma once

#include <algorithm>

#include "core/concurrent_policy.hpp"
#include "core/state.hpp"
#include "core/zones.hpp"
#include "kernel/thread_state.hpp"
#include "parallel/work_queue.hpp"

namespace mgdt {

// The points of a batch by their positions in its schedule. The points are vertices of the mesh
// already.
class Positions {
  public:
    Positions(const Schedule& schedule, std::size_t size, std::size_t first_vertex) noexcept
        : rounds_(schedule.rounds), size_(size), first_vertex_(first_vertex) {}

    std::size_t size() const noexcept { return size_; }
    std::size_t first_vertex() const noexcept { return first_vertex_; }
    const Buffer<std::uint32_t>& rounds() const noexcept { return rounds_; }
    VertexId vertex(std::size_t k) const noexcept {
        return static_cast<VertexId>(first_vertex_ + k);
    }
    // Calls f with positions whose points are probably near the point at k, until f returns true.
    // In the first round, these are the positions just before k. In later rounds, they are in the
    // previous round: a point 30% through its round is near those 30% through the previous round.
    // Returns whether f returned true.
    template <class F>
    bool for_nearby(std::size_t k, F f) const;

  private:
    const Buffer<std::uint32_t>& rounds_;
    const std::size_t size_, first_vertex_;
};

// The positions to insert: a range, or the entries of a list.
struct Items {
    std::size_t begin, size;
    const std::uint32_t* list;
    std::size_t operator[](std::size_t i) const { return list ? list[i] : begin + i; }
    // A walk to a point starts at the last inserted point if their positions differ by at most this
    // number. The limit is smaller for a list, whose positions are sparse.
    std::size_t max_distance() const { return list ? 32 : 512; }
};

// The state that the threads of a stage share. Between stages, only one thread changes this state.
struct Stage {
    void begin(const Items& stage_items, bool stops_for_hubs) noexcept;
    void ask_all_to_stop() noexcept { stop = true; }

    State& state;
    const Positions& positions;
    BlockOwners& owners;
    SlotSupply& supply;
    WorkQueue& queue;
    const Zones& zones;

    Items items{0, 0, nullptr};
    bool stops_for_hubs = false;
    // These members are on another cache line than the members that change only between stages.
    alignas(64) Atomic<bool> stop{false};  // asks all threads to stop
    Atomic<bool> lacks_slots{false};       // the threads stop because the storage has to grow
    Atomic<bool> is_in_doubt{false};       // the threads stop because one may be faster alone
    Atomic<unsigned> active{0};            // the number of threads that have not left the stage
    Atomic<std::size_t> done{0};           // the number of points of the batch that are dealt with
    unsigned workers = 0;                  // the number of workers that were made
};

// A worker has cache lines of its own, since every thread writes to its worker at each point.
class alignas(64) Worker {
  public:
    explicit Worker(Stage& stage);

    // The results that the worker leaves for the calling thread, which ends the stage.
    struct Results {
        struct Repeat {
            VertexId q, vertex;
        };
        explicit Results(Allocator& allocator) : repeats(allocator), deferred(allocator) {}
        // Points whose coordinates another vertex has already. The record of that vertex is changed
        // at the end of a stage, since other threads may read it before.
        Buffer<Repeat> repeats;
        Buffer<std::uint32_t> deferred;
        std::uint32_t hub = no_index;  // the position of a hub that all threads stop for
        std::uint64_t inserted = 0, times_deferred = 0;
    };

    // Takes pieces of the stage's items from the queue and inserts them anywhere. Only the worker
    // on the calling thread calls `poll`, with the number of points done.
    template <class Poll>
    void insert_anywhere(Poll poll);
    // Inserts the points of this worker's zone until they are done or all threads stop. Calls
    // `poll` as insert_anywhere() does.
    template <class Poll>
    void insert_in_zone(Poll poll);

    void begin_anywhere(unsigned threads, std::size_t attempts_before_doubt) noexcept;
    // Sets the range of positions of the worker's zone in a round.
    void begin_zone(std::size_t begin, std::size_t end) noexcept {
        next_in_zone_ = begin;
        end_of_zone_ = end;
    }
    // Calls f with each position inside the zone that insert_in_zone() has not tried.
    template <class F>
    void for_left_in_zone(F f) const;
    // Forgets the tetrahedra that this thread knows, since other threads may change them from now
    // on.
    void leave_zone() noexcept;
    // Returns unused slots and the count of ghosts to the mesh, after all threads have ended.
    void return_slots() noexcept;

    // Adds the counts of this worker to the state, after the last stage.
    void add_counts_to(State& state) const noexcept;

    Results& results() noexcept { return results_; }
    const Results& results() const noexcept { return results_; }

  private:
    using InsertCall = decltype(KernelCalls::insert_concurrent);

    bool is_on_calling_thread() const noexcept { return number_ == 0; }
    std::size_t insert_piece(const WorkQueue::Piece& piece);
    bool follow_advice();
    bool try_insert(std::size_t k);
    bool try_insert_in_zone(std::size_t k);
    bool insert(std::size_t k, InsertCall call);
    bool arrive(std::size_t k);
    bool arrive_in_zone(std::size_t k);
    void release_blocks();

    Stage& stage_;
    const unsigned number_;
    ThreadState thread_state_;
    Workspace own_;
    Workspace& workspace_;
    Contention contention_;
    TetId here_ = no_tetrahedron;    // a tetrahedron that this thread owns, where walks start
    std::size_t last_ = 0;           // the position of the point inserted last
    Buffer<std::uint32_t> retries_;  // positions of the piece to try again
    std::size_t next_in_zone_ = 0, end_of_zone_ = 0;
    std::size_t failures_in_zone_ = 0;  // the number of failures in a row
    Results results_;
};

template <class F>
bool Positions::for_nearby(std::size_t k, F f) const {
    constexpr std::size_t tries = 16;
    const std::size_t r = static_cast<std::size_t>(
        std::upper_bound(rounds_.begin(), rounds_.end(), static_cast<std::uint32_t>(k)) -
        rounds_.begin());
    if (r <= 1) {
        for (std::size_t i = 1; i <= tries && i <= k; ++i)
            if (f(k - i)) return true;
        return false;
    }
    // The previous round follows the same curve, so its points at the same share are near.
    const std::size_t end = r < rounds_.size() ? rounds_[r] : size_;
    const std::size_t begin = rounds_[r - 1], before = rounds_[r - 2];
    const double share = static_cast<double>(k - begin) / static_cast<double>(end - begin);
    const std::size_t size = begin - before;
    const std::size_t there = static_cast<std::size_t>(share * static_cast<double>(size));
    for (std::size_t i = 0; i < tries; ++i) {
        const std::size_t at = i % 2 == 0 ? there + i / 2 : there - (i + 1) / 2;
        if (at < size && f(before + at)) return true;
    }
    return false;
}

template <class Poll>
void Worker::insert_anywhere(Poll poll) {
    struct ReleaseBlocks {
        Worker& worker;
        ~ReleaseBlocks() {
            worker.here_ = no_tetrahedron;
            worker.release_blocks();
        }
    } at_the_end{*this};
    unsigned from = number_;
    try {
        for (WorkQueue::Piece piece; !stage_.stop && stage_.queue.next(number_, from, piece);) {
            const std::size_t dealt_with = insert_piece(piece);
            const std::size_t done = stage_.done.fetch_add(dealt_with) + dealt_with;
            if (is_on_calling_thread()) poll(done);
            if (stage_.stop || !follow_advice()) return;
        }
    } catch (...) {
        stage_.ask_all_to_stop();
        throw;
    }
}

template <class Poll>
void Worker::insert_in_zone(Poll poll) {
    constexpr std::size_t piece_size = 256;
    std::size_t& k = next_in_zone_;
    failures_in_zone_ = 0;
    try {
        while (k < end_of_zone_ && !stage_.stop) {
            const std::size_t piece_end = std::min(k + piece_size, end_of_zone_);
            std::size_t inserted = 0;
            for (; k < piece_end && !stage_.stop.load(std::memory_order_relaxed); ++k) {
                if (stage_.zones.is_at_border(k)) continue;
                if (try_insert_in_zone(k)) {
                    ++inserted;
                } else {
                    results_.deferred.push_back(static_cast<std::uint32_t>(k));
                    ++results_.times_deferred;
                }
            }
            const std::size_t done = stage_.done.fetch_add(inserted) + inserted;
            if (is_on_calling_thread()) poll(done);
        }
        // The first thread that is done stops all threads: outside zones, the threads share the
        // points that are left more evenly.
        stage_.ask_all_to_stop();
    } catch (...) {
        stage_.ask_all_to_stop();
        throw;
    }
}

template <class F>
void Worker::for_left_in_zone(F f) const {
    for (std::size_t k = next_in_zone_; k < end_of_zone_; ++k)
        if (!stage_.zones.is_at_border(k)) f(static_cast<std::uint32_t>(k));
}

}  // namespace mgdt
