// SPDX-License-Identifier: MIT
#include "core/concurrent_insertion.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/stopwatch.hpp"

namespace mgdt {
namespace {

// A thread gives its blocks back after this many points.
constexpr std::size_t piece_size = 64;
constexpr std::uint32_t max_slots_at_once = 16384;

std::uint32_t slots_at_once(std::size_t points, unsigned threads) {
    return static_cast<std::uint32_t>(
        std::min<std::size_t>(max_slots_at_once, 64 + points / (4 * threads)));
}

}  // namespace

ConcurrentInsertion::ConcurrentInsertion(State& state, Team& team, const Batch& batch,
                                         const Schedule& schedule, std::size_t base, bool may_stop)
    : state_(state),
      team_(team),
      may_stop_(may_stop),
      positions_(schedule, batch.points.size, base),
      policy_(state.hooks, team.size(), batch.points.size),
      owners_(state.allocator, base + batch.points.size, state.hooks.pause),
      supply_(state.mesh, slots_at_once(batch.points.size, team.size())),
      queue_(state.allocator, team.size()),
      zones_(team, state.allocator, schedule, batch.points.size),
      stage_{state, positions_, owners_, supply_, queue_, zones_},
      workers_(team, state.allocator, std::ref(stage_)),
      left_(state.allocator) {}

ConcurrentInsertion::~ConcurrentInsertion() {
    // The tetrahedron of the last insertion may be gone.
    state_.walk_starts.last = state_.mesh.live_from(state_.walk_starts.last);
    state_.workspace.slot_count = 0;
    for (Worker& worker : workers_) worker.add_counts_to(state_);
}

void ConcurrentInsertion::run(std::size_t done) {
    stage_.done = done;
    const std::size_t n = positions_.size();
    const Buffer<std::uint32_t>& rounds = positions_.rounds();
    for (std::size_t r = 0; r < rounds.size(); ++r) {
        const std::size_t begin = std::max<std::size_t>(rounds[r], done);
        const Zones::Round round = {begin, r + 1 < rounds.size() ? rounds[r + 1] : n,
                                    r > 0 && begin == rounds[r] ? rounds[r - 1] : begin};
        if (round.begin < round.end) insert_round(round);
    }
}

void ConcurrentInsertion::insert_round(const Zones::Round& round) {
    const unsigned threads = policy_.threads_for_round(round.size(), state_.mesh.tetrahedra.size(),
                                                       positions_.vertex(round.begin));
    policy_.begin_round();
    const std::uint64_t before = times_deferred();
    if (!insert_in_zones(round, threads))
        insert_anywhere({round.begin, round.size(), nullptr}, threads);
    policy_.end_round(times_deferred() - before, round.size());
}

std::uint64_t ConcurrentInsertion::times_deferred() const {
    std::uint64_t sum = 0;
    for (const Worker& worker : workers_) sum += worker.results().times_deferred;
    return sum;
}

// Inserts the items with `threads` threads. The items that are left are inserted with fewer
// threads, and finally with one.
void ConcurrentInsertion::insert_anywhere(Items items, unsigned threads) {
    Buffer<std::uint32_t> list(state_.allocator);
    policy_.begin_list();
    while (threads > 1) {
        const std::size_t before = stage_.done;
        double seconds = 0;
        {
            const Stopwatch watch(seconds);
            insert_by_threads(items, threads);
        }
        const bool is_in_doubt = stage_.is_in_doubt, met_hubs = insert_hubs() > 0;
        if (stage_.lacks_slots && !met_hubs) {
            // One thread needs no spare slots. It reports the error if the storage is full.
            if (!try_to_grow_storage(threads)) threads = 1;
        } else if (!is_in_doubt && !met_hubs) {
            threads /= 2;  // contention left these points, and fewer threads contend less
        }
        if (is_in_doubt) {
            const Stopwatch watch(seconds);
            insert_deferred_first();
        }
        const std::size_t inserted = stage_.done - before;
        list = take_left();
        if (!is_in_doubt) {
            threads = std::min(threads, policy_.threads_for_deferred(list.size(), items.size));
        } else {
            const std::size_t sample = std::min(list.size(), ConcurrentPolicy::sample_size);
            if (!met_hubs && sample > 0 &&
                policy_.compare(insert_last_alone(list, sample), sample, seconds, inserted))
                threads = 1;
            threads = std::min(threads, policy_.threads_for_few(list.size()));
        }
        items = {0, list.size(), list.data()};
    }
    insert_alone(items);
}

void ConcurrentInsertion::insert_by_threads(const Items& items, unsigned threads) {
    const std::size_t piece =
        std::min(piece_size, std::max<std::size_t>(1, items.size / (threads * 4)));
    queue_.deal(items.size, piece, threads);
    begin_stage(items, threads);
    for (unsigned m = 0; m < threads; ++m)
        workers_[m].begin_anywhere(threads, policy_.attempts_before_doubt());
    supply_.open();
    try {
        team_.run(threads, [&](unsigned m) {
            workers_[m].insert_anywhere([this](std::size_t done) { poll(done); });
        });
    } catch (...) {
        end_stage(threads);
        throw;
    }
    end_stage(threads);
    poll(stage_.done);
}

void ConcurrentInsertion::insert_alone(const Items& items) {
    begin_stage(items, 1);
    for (std::size_t i = 0; i < items.size; ++i) {
        if (i % 1024 == 0) poll(stage_.done);
        insert_serially(items[i], i > 0 && items[i] - items[i - 1] <= items.max_distance());
    }
}

// Inserts the points that the last stage has deferred, before threads make more tetrahedra in the
// cavities of these points.
void ConcurrentInsertion::insert_deferred_first() {
    const std::size_t count = std::min(deferred_, left_.size());
    std::sort(left_.begin(), left_.begin() + count);
    insert_alone({0, count, left_.data()});
    std::copy(left_.begin() + count, left_.end(), left_.begin());
    left_.resize(left_.size() - count);
}

// Inserts the last n points of the list and removes them from the list. Returns the time taken, in
// seconds.
double ConcurrentInsertion::insert_last_alone(Buffer<std::uint32_t>& list, std::size_t n) {
    double seconds = 0;
    {
        const Stopwatch watch(seconds);
        insert_alone({0, n, list.end() - n});
    }
    list.resize(list.size() - n);
    return seconds;
}

// Inserts the point at position k while no other thread works. `is_near_last`: the point is near
// the one that was inserted last.
void ConcurrentInsertion::insert_serially(std::size_t k, bool is_near_last) {
    const Mesh& mesh = state_.mesh;
    const VertexId q = positions_.vertex(k);
    TetId start = state_.walk_starts.last;
    if (!is_near_last || k == 0) {
        const bool is_found = positions_.for_nearby(k, [&](std::size_t position) {
            const TetId near = mesh.vertex_hint[positions_.vertex(position)];
            if (near == no_tetrahedron) return false;
            start = mesh.live_from(near);
            return true;
        });
        if (!is_found) {
            start = start == no_tetrahedron ? mesh.a_ghost : mesh.live_from(start);
            if (k == 0)
                start = start_of_walk(
                    mesh, state_.walk_starts.tree_for_insertion(mesh, positions_.first_vertex()),
                    start, mesh.point(q));
        }
        state_.workspace.slot_count = 0;
    }
    const Insertion result = state_.calls().insert(state_.mesh, state_.workspace, q, start);
    state_.walk_starts.last = result.tetrahedron;
    state_.note(q, result);
    ++state_.statistics.inserted_alone;
    ++stage_.done;
}

void ConcurrentInsertion::begin_stage(const Items& items, unsigned threads) {
    stage_.begin(items, policy_.may_stop_for_hubs());
    stage_.active = threads;
    for (unsigned m = 0; m < threads; ++m) workers_[m].results().hub = no_index;
}

// Ends a stage after its threads are done: returns their slots to the mesh, records their repeats,
// and lists the points that are left.
void ConcurrentInsertion::end_stage(unsigned threads) {
    supply_.close();
    for (unsigned m = 0; m < threads; ++m) workers_[m].return_slots();
    for (unsigned m = 0; m < threads; ++m) {
        Worker::Results& results = workers_[m].results();
        for (const Worker::Results::Repeat& repeat : results.repeats)
            state_.note_repeat(repeat.q, repeat.vertex);
        results.repeats.clear();
        for (const std::uint32_t k : results.deferred) left_.push_back(k);
        results.deferred.clear();
    }
    deferred_ = left_.size();
    unsigned from = 0;
    for (WorkQueue::Piece piece; queue_.next(0, from, piece);)
        for (std::size_t i = piece.begin; i < piece.end; ++i)
            left_.push_back(static_cast<std::uint32_t>(stage_.items[i]));
}

// Inserts the hubs for which all threads have stopped, and removes them from `left_`. Returns the
// number of hubs.
std::size_t ConcurrentInsertion::insert_hubs() {
    std::size_t hubs = 0;
    for (Worker& worker : workers_) {
        const std::uint32_t k = std::exchange(worker.results().hub, no_index);
        if (k == no_index) continue;
        insert_serially(k, false);
        *std::find(left_.begin(), left_.end(), k) = left_.back();
        left_.pop_back();
        ++hubs;
    }
    if (hubs > 0) policy_.count_stop_for_hubs();
    return hubs;
}

// Reserves more slots for tetrahedra. Returns false if there is no memory for them.
bool ConcurrentInsertion::try_to_grow_storage(unsigned threads) {
    const std::size_t more = threads * std::size_t{2} * max_slots_at_once;
    try {
        state_.mesh.reserve_tetrahedra(state_.mesh.tetrahedra.capacity() + more);
        return true;
    } catch (...) {
        return false;
    }
}

// Returns the positions in `left_`, in the order of the schedule, and empties `left_`.
Buffer<std::uint32_t> ConcurrentInsertion::take_left() {
    std::sort(left_.begin(), left_.end());
    return std::exchange(left_, Buffer<std::uint32_t>(state_.allocator));
}

// Reports progress and answers a request to stop. Only the calling thread may do so.
void ConcurrentInsertion::poll(std::size_t done) {
    if (!may_stop_) return;
    const std::size_t n = positions_.size();
    if (done >= next_report_) {
        next_report_ = done + std::max<std::size_t>(n / 100, 1);
        state_.progress.report(done, n);
    }
    state_.progress.stop_if_cancelled(done, n);
}

}  // namespace mgdt
