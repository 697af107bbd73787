// SPDX-License-Identifier: MIT
#include "core/concurrent_insertion.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "core/concurrent_member.hpp"
#include "core/stopwatch.hpp"

namespace mgdt {
namespace {

// Points between two times that a thread gives its blocks back.
constexpr std::size_t piece_size = 64;
// A thread looks `trials` times along its zone, but not before `least_trial` tries, how many tries
// failed. If more than a quarter did, it waits, since the thread that it meets may be about to go
// on or suspended by the system. When waiting, each time twice as long, has not helped `most_waits`
// times in a row, it leaves the rest of the round to the others.
constexpr std::size_t trials = 64, least_trial = 512;
constexpr unsigned most_waits = 4;
constexpr std::chrono::microseconds first_wait{100};
// A point further along the schedule than that is not walked to from the last one: in a list there
// are few of those in between.
constexpr std::size_t far_away_in_round = 512, far_away_in_list = 32;
constexpr std::uint32_t most_slots_at_once = 16384;
// A round is early if the batch is so many times as large.
constexpr std::size_t early_share = 8;
// Members of cavities a try that a thread gives up before it stops all.
constexpr std::size_t most_given_up = 64;
// A point whose cavity has grown so large when it comes to what another thread owns is a hub, which
// has an edge to most of the vertices around. It cannot be inserted while other threads insert, and
// until it is, they build tetrahedra in its place that it removes again. So all threads stop for
// it, unless that happens too often.
constexpr std::size_t least_hub = 1024, most_stops = 16;

// Whether so many of `count` points are put off that the threads are in each other's way.
bool is_many(std::uint64_t put_off, std::size_t count) {
    return put_off > count / 50;
}

}  // namespace

ConcurrentInsertion::ConcurrentInsertion(State& state, Team& team, const Batch& batch,
                                         const Schedule& schedule, std::size_t base, bool may_stop)
    : state_(state),
      team_(team),
      batch_(batch),
      schedule_(schedule),
      base_(base),
      may_stop_(may_stop),
      owners_(state.allocator, base + batch.points.size, state.hooks.pause),
      supply_(state.mesh, static_cast<std::uint32_t>(std::min<std::size_t>(
                              most_slots_at_once, 64 + batch.points.size / (4 * team.size())))),
      queue_(state.allocator, team.size()),
      left_(state.allocator),
      zones_(team, state.allocator, schedule, batch.points.size) {
    const std::size_t bytes = team.size() * sizeof(Member);
    members_ = static_cast<Member*>(state.allocator.allocate(bytes, alignof(Member)));
    for (; member_count_ < team.size(); ++member_count_)
        new (members_ + member_count_)
            Member(state.mesh, owners_, static_cast<std::uint8_t>(member_count_ + 1), supply_,
                   member_count_ == 0 ? &state.workspace : nullptr);
}

ConcurrentInsertion::~ConcurrentInsertion() {
    // What threads left behind may be gone.
    state_.walk_starts.last = state_.mesh.live_from(state_.walk_starts.last);
    state_.workspace.slot_count = 0;
    for (unsigned m = 0; m < member_count_; ++m) {
        if (m > 0) state_.workspace.counters += members_[m].own.counters;
        state_.statistics.points_inserted += members_[m].inserted;
        state_.statistics.deferred += members_[m].times_deferred;
        members_[m].~Member();
    }
    state_.allocator.release(members_, team_.size() * sizeof(Member), alignof(Member));
}

void ConcurrentInsertion::run(std::size_t done) {
    done_ = done;
    const std::size_t n = batch_.points.size;
    const Buffer<std::uint32_t>& rounds = schedule_.rounds;
    for (std::size_t r = 0; r < rounds.size(); ++r) {
        const std::size_t begin = std::max<std::size_t>(rounds[r], done);
        const Zones::Round round = {begin, r + 1 < rounds.size() ? rounds[r + 1] : n,
                                    r > 0 && begin == rounds[r] ? rounds[r - 1] : begin};
        if (round.begin < round.end) insert_round(round);
    }
}

void ConcurrentInsertion::insert_round(const Zones::Round& round) {
    const unsigned members = members_for_round(round);
    stops_ = 0;
    const std::uint64_t before = times_deferred();
    if (!insert_in_zones(round, members))
        insert_anywhere({round.begin, round.size(), nullptr}, members);
    is_crowded_ = is_many(times_deferred() - before, round.size());
}

// Where there are many tetrahedra a vertex, as between the arms of a spiral, most are long, and
// most points want some that belong to others: one thread takes less time. So it does where there
// are few, because most points are where others are.
unsigned ConcurrentInsertion::members_for_round(const Zones::Round& round) const {
    const TestHooks& hooks = state_.hooks;
    const std::size_t tetrahedra = state_.mesh.tetrahedra.size();
    if (tetrahedra / hooks.max_tetrahedra_per_vertex > base_ + round.begin) return 1;
    const std::size_t usual = hooks.min_points_per_thread;
    unsigned members = team_.members_for(round.size(), usual);
    // For an early round all others wait: it has two threads if it is large enough for that.
    if (early_share * round.size() < batch_.points.size)
        members = std::max(
            members,
            std::min(2u, team_.members_for(round.size(), std::max<std::size_t>(usual / 4, 1))));
    return std::min(members, members_for_few(tetrahedra));
}

std::uint64_t ConcurrentInsertion::times_deferred() const {
    std::uint64_t sum = 0;
    for (unsigned m = 0; m < member_count_; ++m) sum += members_[m].times_deferred;
    return sum;
}

// Inserts items on `members` threads, and what is left on fewer, in the end on one.
void ConcurrentInsertion::insert_anywhere(Items items, unsigned members) {
    Buffer<std::uint32_t> list(state_.allocator);
    was_faster_alone_ = false;
    doubt_after_ = state_.hooks.attempts_before_doubt;
    while (members > 1) {
        const std::size_t before = done_;
        double seconds = 0;
        {
            const Stopwatch watch(seconds);
            insert_concurrently(items, members);
        }
        const bool are_in_doubt = doubts_, met_hubs = insert_hubs() > 0;
        if (no_slots_ && !met_hubs) {
            // One wastes no slots, and reports the error.
            if (!grow_storage(members)) members = 1;
        } else if (!are_in_doubt && !met_hubs) {
            members /= 2;  // what is left is where threads met: fewer will meet less
        }
        if (are_in_doubt) {
            const Stopwatch watch(seconds);
            insert_put_off();
        }
        const std::size_t inserted = done_ - before;
        list = take_left();
        if (!are_in_doubt)
            members = std::min(members, members_for_left(list.size(), items.size));
        else if (!met_hubs && is_faster_alone(list, seconds, inserted))
            members = 1;
        else
            members = std::min(members, members_for_few(list.size()));
        items = {0, list.size(), list.data()};
    }
    insert_alone(items);
}

void ConcurrentInsertion::insert_alone(const Items& items) {
    begin_stage(items, 1);
    for (std::size_t i = 0; i < items.size; ++i) {
        if (i % 1024 == 0) poll(done_);
        insert_serially(items[i], i > 0 && items[i] - items[i - 1] <= far_away_);
    }
}

// Room for more tetrahedra. Whether there is any.
bool ConcurrentInsertion::grow_storage(unsigned members) {
    const std::size_t more = members * std::size_t{2} * most_slots_at_once;
    try {
        state_.mesh.reserve_tetrahedra(state_.mesh.tetrahedra.capacity() + more);
        return true;
    } catch (...) {
        return false;
    }
}

// How many for a few points, which all others would wait for one to insert.
unsigned ConcurrentInsertion::members_for_few(std::size_t count) const {
    const std::size_t usual = state_.hooks.min_points_per_thread;
    return team_.members_for(count, std::max<std::size_t>(usual / 8, 1));
}

// How many for what is left of `count` points. If it is much, threads meet there.
unsigned ConcurrentInsertion::members_for_left(std::size_t left, std::size_t count) const {
    return is_many(left, count) ? team_.members_for(left, state_.hooks.min_points_per_thread)
                                : members_for_few(left);
}

// In the order of the schedule.
Buffer<std::uint32_t> ConcurrentInsertion::take_left() {
    std::sort(left_.begin(), left_.end());
    return std::exchange(left_, Buffer<std::uint32_t>(state_.allocator));
}

void ConcurrentInsertion::begin_stage(const Items& items, unsigned members) {
    far_away_ = items.list ? far_away_in_list : far_away_in_round;
    may_stop_for_hubs_ = stops_ < most_stops;
    stop_ = no_slots_ = doubts_ = false;
    for (unsigned m = 0; m < members; ++m) members_[m].hub = no_index;
}

void ConcurrentInsertion::insert_concurrently(const Items& items, unsigned members) {
    const std::size_t piece =
        std::min(piece_size, std::max<std::size_t>(1, items.size / (members * 4)));
    queue_.deal(items.size, piece, members);
    begin_stage(items, members);
    active_ = members;
    trial_ = std::max(least_trial, items.size / (members * trials));
    for (unsigned m = 0; m < members; ++m) members_[m].begin_counting();
    supply_.open();
    try {
        team_.run(members, [&](unsigned m) { work(members_[m], items); });
    } catch (...) {
        gather_results(members, items);
        throw;
    }
    gather_results(members, items);
    poll(done_);
}

// Inserts those that all have stopped for, and takes them from the list of what is left.
std::size_t ConcurrentInsertion::insert_hubs() {
    std::size_t hubs = 0;
    for (unsigned m = 0; m < member_count_; ++m) {
        const std::uint32_t k = std::exchange(members_[m].hub, no_index);
        if (k == no_index) continue;
        insert_serially(k, false);
        *std::find(left_.begin(), left_.end(), k) = left_.back();
        left_.pop_back();
        ++hubs;
    }
    stops_ += hubs > 0;
    return hubs;
}

// When the threads are done: hands to the mesh what was theirs, and lists the points that are left.
void ConcurrentInsertion::gather_results(unsigned members, const Items& items) {
    supply_.close();
    Mesh& mesh = state_.mesh;
    for (unsigned m = 0; m < members; ++m) {
        ThreadState& thread_state = members_[m].thread_state;
        thread_state.return_slots();
        mesh.ghost_count += static_cast<std::size_t>(thread_state.ghosts);
        thread_state.ghosts = 0;
        // Of the last ones made by each thread, the last of all is there.
        const TetId ghost = thread_state.a_ghost;
        if (ghost != no_tetrahedron && !mesh.tetrahedra[ghost].is_dead() &&
            mesh.tetrahedra[ghost].is_ghost())
            mesh.a_ghost = ghost;
    }
    for (unsigned m = 0; m < members; ++m) {
        for (const Member::Repeat& repeat : members_[m].repeats)
            state_.note_repeat(repeat.q, repeat.vertex);
        members_[m].repeats.clear();
        for (const std::uint32_t k : members_[m].left) left_.push_back(k);
        members_[m].left.clear();
    }
    put_off_ = left_.size();
    unsigned from = 0;
    for (WorkQueue::Piece piece; queue_.next(0, from, piece);)
        for (std::size_t i = piece.begin; i < piece.end; ++i)
            left_.push_back(static_cast<std::uint32_t>(items[i]));
}

void ConcurrentInsertion::work(Member& member, const Items& items) {
    const unsigned number = static_cast<unsigned>(&member - members_);
    struct ReleaseBlocks {
        ConcurrentInsertion& z;
        Member& member;
        ~ReleaseBlocks() {
            member.here = no_tetrahedron;
            z.release_blocks(member);
        }
    } at_the_end{*this, member};
    unsigned from = number;
    try {
        for (WorkQueue::Piece piece; !stop_ && queue_.next(number, from, piece);) {
            const std::size_t size = piece.end - piece.begin;
            for (std::size_t i = 0; i < size; ++i) {
                const std::size_t k = items[piece.is_stolen ? piece.end - 1 - i : piece.begin + i];
                if (!try_insert(member, k))
                    member.deferred.push_back(static_cast<std::uint32_t>(k));
            }
            release_blocks(member);
            const std::size_t failures = stop_ ? 0 : member.deferred.size();
            member.times_deferred += failures;
            std::size_t left = 0;
            while (!member.deferred.empty()) {
                const std::uint32_t k = member.deferred.back();
                member.deferred.pop_back();
                if (try_insert(member, k)) continue;
                member.left.push_back(k);
                ++left;
            }
            release_blocks(member);
            const std::size_t done = done_.fetch_add(size - left) + size - left;
            if (number == 0) poll(done);
            if (stop_) return;
            for (Member::Trial* const trial : {&member.crowd, &member.doubts}) {
                trial->tries += size;
                trial->failures += failures;
            }
            if (has_doubts(member)) {
                doubts_ = stop_ = true;
                return;
            }
            if (is_too_crowded(member)) return;
        }
    } catch (...) {
        stop_ = true;
        throw;
    }
}

bool ConcurrentInsertion::is_too_crowded(Member& member) {
    if (member.crowd.tries < trial_) return false;
    if (!member.crowd.ends_crowded()) {
        member.waits = 0;
        return false;
    }
    if (member.waits < most_waits) {
        std::this_thread::sleep_for(first_wait * (1 << member.waits++));
        return false;
    }
    // The last one stays.
    unsigned active = active_;
    while (active > 1)
        if (active_.compare_exchange_weak(active, active - 1)) return true;
    return false;
}

bool ConcurrentInsertion::try_insert(Member& member, std::size_t k) {
    if (stop_.load(std::memory_order_relaxed)) return false;
    if (!member.thread_state.try_own(vertex(k))) return false;
    const std::size_t distance = k > member.last ? k - member.last : member.last - k;
    if ((member.here == no_tetrahedron || distance > far_away_) && !arrive(member, k)) return false;
    if (insert(member, k, state_.calls().insert_concurrent)) return true;
    member.members_given_up += member.workspace.given_up;
    if (member.members_given_up > most_given_up * doubt_after_) doubts_ = stop_ = true;
    return false;
}

// Inserts point k in one of the kernel's ways, from where the thread is.
bool ConcurrentInsertion::insert(Member& member, std::size_t k, ConcurrentCall call) {
    const VertexId q = vertex(k);
    Insertion result;
    member.workspace.given_up = 0;
    try {
        result = call(state_.mesh, member.workspace, member.thread_state, q, member.here);
    } catch (const SlotSupply::NoSlots&) {
        no_slots_ = true;
        stop_ = true;
        return false;
    }
    if (result.tetrahedron == no_tetrahedron) {
        if (may_stop_for_hubs_ && member.workspace.given_up >= least_hub) {
            member.hub = static_cast<std::uint32_t>(k);
            stop_ = true;
        }
        return false;
    }
    member.here = result.tetrahedron;
    member.last = k;
    if (result.duplicate == infinite_vertex)
        ++member.inserted;
    else
        member.repeats.push_back({q, result.duplicate});
    return true;
}

// Makes a tetrahedron near point k this thread's, to walk from. Whether that could be.
bool ConcurrentInsertion::arrive(Member& member, std::size_t k) {
    const Mesh& mesh = state_.mesh;
    ThreadState& thread_state = member.thread_state;
    return for_nearby_positions(k, [&](std::size_t position) {
        const VertexId near = vertex(position);
        if (!thread_state.try_own(near)) return false;
        const TetId t = mesh.vertex_hint[near];
        if (t == no_tetrahedron) return false;
        // The guards of a tetrahedron that another thread may be changing. Once this thread owns
        // both, it reads them again: if they are the same, no other thread can be changing it.
        VertexId first[2], again[2];
        read_racing(mesh.tetrahedra[t].v, first);
        if (first[0] == infinite_vertex) return false;
        if (!thread_state.try_own(first[0]) || !thread_state.try_own(first[1])) return false;
        read_racing(mesh.tetrahedra[t].v, again);
        if (first[0] != again[0] || first[1] != again[1]) return false;
        member.here = t;
        member.workspace.slot_count = 0;
        return true;
    });
}

// Gives all blocks back but those of the place where the thread is.
void ConcurrentInsertion::release_blocks(Member& member) {
    member.workspace.slot_count = 0;  // the last star is not wholly mine any more
    OwnedBlocks& blocks = member.thread_state.blocks;
    const Tetrahedron* const here =
        member.here == no_tetrahedron ? nullptr : &state_.mesh.tetrahedra[member.here];
    if (here && member.thread_state.try_own(*here)) {
        blocks.release(here->v, 2);
    } else {
        member.here = no_tetrahedron;
        blocks.release();
    }
}

// With no other thread at work. `is_next`: the point inserted last is near.
void ConcurrentInsertion::insert_serially(std::size_t k, bool is_next) {
    const Mesh& mesh = state_.mesh;
    TetId start = state_.walk_starts.last;
    if (!is_next || k == 0) {
        const bool is_found = for_nearby_positions(k, [&](std::size_t position) {
            const TetId near = mesh.vertex_hint[vertex(position)];
            if (near == no_tetrahedron) return false;
            start = mesh.live_from(near);
            return true;
        });
        if (!is_found) {
            start = start == no_tetrahedron ? mesh.a_ghost : mesh.live_from(start);
            if (k == 0)
                start = start_of_walk(mesh, state_.walk_starts.tree_for_insertion(mesh, base_),
                                      start, mesh.point(vertex(k)));
        }
        state_.workspace.slot_count = 0;
    }
    const VertexId q = vertex(k);
    const Insertion result = state_.calls().insert(state_.mesh, state_.workspace, q, start);
    state_.walk_starts.last = result.tetrahedron;
    state_.note(q, result);
    ++state_.statistics.inserted_alone;
    ++done_;
}

// On the calling thread alone.
void ConcurrentInsertion::poll(std::size_t done) {
    if (!may_stop_) return;
    const std::size_t n = batch_.points.size;
    if (done >= next_report_) {
        next_report_ = done + std::max<std::size_t>(n / 100, 1);
        state_.progress.report(done, n);
    }
    state_.progress.stop_if_cancelled(done, n);
}

}  // namespace mgdt
