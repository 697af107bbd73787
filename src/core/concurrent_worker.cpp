// SPDX-License-Identifier: MIT
#include "core/concurrent_worker.hpp"

#include <thread>

namespace mgdt {
namespace {

// A hub is a point whose cavity has at least this many tetrahedra when it meets a vertex that
// another thread owns. A hub cannot be inserted while other threads insert, and until it is
// inserted, these threads build tetrahedra in its cavity that the hub removes again.
constexpr std::size_t min_hub_cavity = 1024;

}  // namespace

void Stage::begin(const Items& stage_items, bool stops_for_hubs_now) noexcept {
    items = stage_items;
    stops_for_hubs = stops_for_hubs_now;
    stop = lacks_slots = is_in_doubt = false;
}

Worker::Worker(Stage& stage)
    : stage_(stage),
      number_(stage.workers++),
      thread_state_(stage.state.mesh, stage.owners, static_cast<std::uint8_t>(number_ + 1),
                    stage.supply),
      own_(stage.state.allocator),
      workspace_(number_ == 0 ? stage.state.workspace : own_),
      retries_(stage.state.allocator),
      results_(stage.state.allocator) {}

void Worker::begin_anywhere(unsigned threads, std::size_t attempts_before_doubt) noexcept {
    contention_.begin(stage_.items.size, threads, attempts_before_doubt);
}

// Inserts the points of a piece as far as possible. Deferred points are tried again once the thread
// has given its blocks back. Returns the number of points that are inserted.
std::size_t Worker::insert_piece(const WorkQueue::Piece& piece) {
    const std::size_t size = piece.end - piece.begin;
    for (std::size_t i = 0; i < size; ++i) {
        const std::size_t k = stage_.items[piece.is_stolen ? piece.end - 1 - i : piece.begin + i];
        if (!try_insert(k)) retries_.push_back(static_cast<std::uint32_t>(k));
    }
    release_blocks();
    const std::size_t failures = stage_.stop ? 0 : retries_.size();
    results_.times_deferred += failures;
    contention_.count(size, failures);
    std::size_t left = 0;
    while (!retries_.empty()) {
        const std::uint32_t k = retries_.back();
        retries_.pop_back();
        if (try_insert(k)) continue;
        results_.deferred.push_back(k);
        ++left;
    }
    release_blocks();
    return size - left;
}

// Waits, or stops all threads, if too many attempts fail. Returns false if this thread leaves.
bool Worker::follow_advice() {
    switch (contention_.judge()) {
        case Contention::Advice::go_on:
            return true;
        case Contention::Advice::wait:
            std::this_thread::sleep_for(contention_.wait());
            return true;
        case Contention::Advice::doubt:
            stage_.is_in_doubt = true;
            stage_.ask_all_to_stop();
            return false;
        case Contention::Advice::leave:
            break;
    }
    // This thread leaves, unless it is the last one.
    unsigned active = stage_.active;
    while (active > 1)
        if (stage_.active.compare_exchange_weak(active, active - 1)) return false;
    return true;
}

bool Worker::try_insert(std::size_t k) {
    if (stage_.stop.load(std::memory_order_relaxed)) return false;
    if (!thread_state_.try_own(stage_.positions.vertex(k))) return false;
    const std::size_t distance = k > last_ ? k - last_ : last_ - k;
    if ((here_ == no_tetrahedron || distance > stage_.items.max_distance()) && !arrive(k))
        return false;
    if (insert(k, stage_.state.calls().insert_concurrent)) return true;
    contention_.count_given_up(workspace_.given_up);
    if (contention_.has_given_up_too_much()) {
        stage_.is_in_doubt = true;
        stage_.ask_all_to_stop();
    }
    return false;
}

bool Worker::try_insert_in_zone(std::size_t k) {
    // After this many failures in a row, the thread may be in a corner of its zone, so the next
    // walk starts near its point instead.
    constexpr std::size_t max_failures = 4;
    if ((here_ == no_tetrahedron || failures_in_zone_ >= max_failures) && !arrive_in_zone(k))
        return false;
    const bool is_in = insert(k, stage_.state.calls().insert_in_zone);
    failures_in_zone_ = is_in ? 0 : failures_in_zone_ + 1;
    return is_in;
}

// Inserts the point at position k by a function of the kernel. The walk starts at `here_`.
bool Worker::insert(std::size_t k, InsertCall call) {
    const VertexId q = stage_.positions.vertex(k);
    Insertion result;
    workspace_.given_up = 0;
    try {
        result = call(stage_.state.mesh, workspace_, thread_state_, q, here_);
    } catch (const SlotSupply::NoSlots&) {
        stage_.lacks_slots = true;
        stage_.ask_all_to_stop();
        return false;
    }
    if (result.tetrahedron == no_tetrahedron) {
        if (stage_.stops_for_hubs && workspace_.given_up >= min_hub_cavity) {
            results_.hub = static_cast<std::uint32_t>(k);
            stage_.ask_all_to_stop();
        }
        return false;
    }
    here_ = result.tetrahedron;
    last_ = k;
    if (result.duplicate == infinite_vertex)
        ++results_.inserted;
    else
        results_.repeats.push_back({q, result.duplicate});
    return true;
}

// Takes ownership of a tetrahedron near point k, where a walk can start. Returns false if there is
// no such tetrahedron.
bool Worker::arrive(std::size_t k) {
    const Mesh& mesh = stage_.state.mesh;
    return stage_.positions.for_nearby(k, [&](std::size_t position) {
        const VertexId near = stage_.positions.vertex(position);
        if (!thread_state_.try_own(near)) return false;
        const TetId t = mesh.vertex_hint[near];
        if (t == no_tetrahedron) return false;
        // Another thread may be changing the tetrahedron. Once this thread owns both guards, it
        // reads them again: if they are the same, no other thread can be changing it.
        VertexId first[2], again[2];
        read_racing(mesh.tetrahedra[t].v, first);
        if (first[0] == infinite_vertex) return false;
        if (!thread_state_.try_own(first[0]) || !thread_state_.try_own(first[1])) return false;
        read_racing(mesh.tetrahedra[t].v, again);
        if (first[0] != again[0] || first[1] != again[1]) return false;
        here_ = t;
        workspace_.slot_count = 0;
        return true;
    });
}

// Finds a tetrahedron of the thread's zone near point k, where a walk can start. Returns whether
// there is one.
bool Worker::arrive_in_zone(std::size_t k) {
    const Mesh& mesh = stage_.state.mesh;
    const Zones& zones = stage_.zones;
    return stage_.positions.for_nearby(k, [&](std::size_t position) {
        const VertexId near = stage_.positions.vertex(position);
        if (zones.of(near) != number_) return false;
        const TetId t = mesh.vertex_hint[near];
        if (t == no_tetrahedron) return false;
        // Another thread may have reused the slot for a tetrahedron whose first vertex is in
        // another zone. The first vertex in a free slot is in no zone.
        VertexId first[2];
        read_racing(mesh.tetrahedra[t].v, first);
        if (zones.of(first[0]) != number_ || mesh.tetrahedra.sphere(t).is_closed()) return false;
        here_ = t;
        workspace_.slot_count = 0;
        return true;
    });
}

// Gives back all blocks but those of the tetrahedron `here_`.
void Worker::release_blocks() {
    workspace_.slot_count = 0;  // other threads may change the last star from now on
    const Tetrahedron* const here =
        here_ == no_tetrahedron ? nullptr : &stage_.state.mesh.tetrahedra[here_];
    if (here && thread_state_.try_own(*here)) {
        thread_state_.blocks.release(here->v, 2);
    } else {
        here_ = no_tetrahedron;
        thread_state_.blocks.release();
    }
}

void Worker::add_counts_to(State& state) const noexcept {
    if (number_ > 0) state.workspace.counters += own_.counters;
    state.statistics.points_inserted += results_.inserted;
    state.statistics.deferred += results_.times_deferred;
}

void Worker::leave_zone() noexcept {
    here_ = no_tetrahedron;
    workspace_.slot_count = 0;
}

void Worker::return_slots() noexcept {
    Mesh& mesh = stage_.state.mesh;
    thread_state_.return_slots();
    mesh.ghost_count += static_cast<std::size_t>(thread_state_.ghosts);
    thread_state_.ghosts = 0;
    // The newest ghost of this thread may be gone, but the newest ghost of all threads exists.
    const TetId ghost = thread_state_.a_ghost;
    if (ghost != no_tetrahedron && !mesh.tetrahedra[ghost].is_dead() &&
        mesh.tetrahedra[ghost].is_ghost())
        mesh.a_ghost = ghost;
}

}  // namespace mgdt
