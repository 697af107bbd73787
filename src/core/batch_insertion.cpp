// SPDX-License-Identifier: MIT
#include "core/batch_insertion.hpp"

#include <algorithm>

#include "core/concurrent_insertion.hpp"
#include "core/first_tetrahedra.hpp"
#include "core/stopwatch.hpp"
#include "core/vertex_compaction.hpp"
#include "order/round_assignment.hpp"
#include "platform/borrowed_arena.hpp"
#include "platform/compiler.hpp"
#include "platform/error.hpp"

namespace mgdt {
namespace {

// With at most this many points a schedule costs more than it gains.
constexpr std::size_t smallest_schedule = 16;

// Moves four positions to the front of the schedule; the others keep their order.
void bring_to_front(Schedule& schedule, const std::size_t positions[4]) {
    // Each of the four positions moves to the front. Every other position before the last of the
    // four moves back by the number of the four that come after it.
    const auto moved = [&](std::size_t k) {
        std::size_t behind = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            if (positions[i] == k) return i;
            behind += positions[i] > k;
        }
        return k + behind;
    };
    const std::size_t last = positions[3];
    for (std::size_t i = 4; i-- > 0;) {
        // The rotations before this one have moved position i back by 3 - i.
        const std::size_t from = positions[i] + (3 - i);
        std::rotate(schedule.order.begin(), schedule.order.begin() + from,
                    schedule.order.begin() + from + 1);
        if (!schedule.hints.empty())
            std::rotate(schedule.hints.begin(), schedule.hints.begin() + from,
                        schedule.hints.begin() + from + 1);
    }
    for (std::uint32_t& hint : schedule.hints)
        if (hint <= last) hint = static_cast<std::uint32_t>(moved(hint));
    for (std::size_t i = 0; i < 4 && !schedule.hints.empty(); ++i) schedule.hints[i] = no_hint;
    for (std::uint32_t& start : schedule.rounds) {
        std::size_t behind = 0;
        for (std::size_t i = 0; i < 4; ++i) behind += positions[i] >= start;
        if (start != 0) start += static_cast<std::uint32_t>(behind);
    }
}

// Copies the points to vertices, in the order of the schedule, and fills the point map. Every point
// gets a vertex; compact_vertices() removes the vertices of repeats later. This function writes the
// map, because stores at random addresses during an insertion would delay the stores of the star.
void copy_vertices(State& state, Team& team, const Batch& batch, const Schedule& schedule,
                   std::size_t base) {
    const std::size_t size = batch.points.size;
    state.mesh.vertices.resize(base + size);
    state.mesh.vertex_hint.resize(base + size);
    team.split(size, 8192, [&](std::size_t begin, std::size_t end, unsigned) {
        state.mesh.vertex_hint.prefault(base + begin, base + end);
        constexpr std::size_t ahead = 24;
        // Local copies, so that the compiler need not reload the pointers after each store.
        Vertex* const vertices = state.mesh.vertices.data() + base;
        TetId* const hints = state.mesh.vertex_hint.data() + base;
        VertexId* const of_points = state.points.map.data();
        const std::uint32_t* const order = schedule.order.data();
        for (std::size_t k = begin; k < end; ++k) {
            if (k + ahead < end) {
                const std::uint32_t next = order[k + ahead];
                batch.points.prefetch(next);
                prefetch(&of_points[batch.index(next)]);
            }
            const std::uint32_t i = order[k], index = batch.index(i);
            batch.get(i, vertices[k].x);
            vertices[k].index = index;
            vertices[k].moved_to = 0;
            hints[k] = no_tetrahedron;
            of_points[index] = static_cast<VertexId>(base + k);
        }
    });
    if (!batch.is_normal) state.mesh.has_extremes = true;
}

// Makes the schedule of a batch, in rounds if several threads will insert it.
void schedule_batch(State& state, Team& team, const Batch& batch, Schedule& schedule) {
    const std::int32_t scheme =
        batch.points.size <= smallest_schedule ? MGDT_ORDER_INPUT : state.settings.scheme;
    make_schedule(team, batch.points, scheme, state.settings.order, schedule);
    // Several threads need rounds: the first rounds make a mesh that the threads can share.
    if (team.size() > 1 && schedule.rounds.size() == 1 && scheme != MGDT_ORDER_RANDOM)
        assign_rounds(team, state.settings.order.seed, schedule);
    state.statistics.levels = schedule.levels;
    state.statistics.rounds = static_cast<double>(schedule.rounds.size());
    state.statistics.threads = team.size();
}

// Moves four points that span space to the front of the schedule, and starts the mesh with their
// tetrahedron. All other points become vertices that are not inserted yet. The function is not
// inlined, so that its variables take no stack while the points are inserted.
MGDT_NOT_INLINE void begin_with(State& state, Team& team, const Batch& batch, Schedule& schedule) {
    std::size_t positions[4];
    AffineBasis basis;
    for (std::size_t k = 0; basis.dimension() < 3; ++k) {
        double p[3];
        batch.get(schedule.order[k], p);
        if (basis.add(p)) positions[basis.dimension()] = k;
    }
    bring_to_front(schedule, positions);
    state.mesh.reserve_tetrahedra(8);

    state.walk_starts.forget_tree();
    state.mesh.clear();
    state.points.held.clear();
    std::fill(state.points.map.begin(), state.points.map.end(), infinite_vertex);
    state.statistics.points_inserted = state.statistics.duplicates = 0;
    state.points.basis = basis;
    copy_vertices(state, team, batch, schedule, 1);
    make_first_tetrahedra(state);
}

// The function is not inlined, so that its variables take no stack while several threads insert.
MGDT_NOT_INLINE void insert_scheduled(State& state, const Batch& batch, const Schedule& schedule,
                                      std::size_t base, std::size_t done, bool may_stop) {
    const std::size_t n = batch.points.size;
    const LocationTree* const tree =
        done == 0 ? state.walk_starts.tree_for_insertion(state.mesh, base) : nullptr;
    // If there are more points than vertex numbers, the next point reuses the number of a repeat.
    const bool is_crowded = base + n > state.mesh.vertex_limit;
    std::size_t in = done;
    const std::size_t report_interval = std::max<std::size_t>(n / 100, 1);
    std::size_t next_report = report_interval;
    for (std::size_t k = done; k < n; ++k) {
        const bool is_due = may_stop && k >= next_report;
        if (is_due) {
            next_report += report_interval;
            state.progress.report(k, n);
        }
        if (is_due || (may_stop && k % Progress::poll_interval == 0))
            state.progress.stop_if_cancelled(k, n);
        const VertexId q = static_cast<VertexId>(base + (is_crowded ? in : k));
        if (q >= state.mesh.vertex_limit)
            fail(MGDT_ERR_TOO_LARGE, "more than %u vertices", state.mesh.vertex_limit);
        if (q != base + k) {
            state.mesh.vertices[q] = state.mesh.vertices[base + k];
            state.points.map[state.mesh.vertices[q].index] = q;
        }
        TetId start = state.walk_starts.last;
        if (!schedule.hints.empty() && schedule.hints[k] != no_hint)
            start = state.mesh.live_from(
                state.mesh
                    .vertex_hint[state.points.map[batch.index(schedule.order[schedule.hints[k]])]]);
        else if (k == 0)
            start = start_of_walk(state.mesh, tree, state.walk_starts.last, state.mesh.point(q));
        state.workspace.may_jump = k == 0;
        const std::uint64_t steps_before = state.workspace.counters.walk_steps;
        const Insertion result = state.calls().insert(state.mesh, state.workspace, q, start);
        if (k == 0)
            state.walk_starts.count_lone_steps(state.workspace.counters.walk_steps - steps_before);
        state.walk_starts.last = result.tetrahedron;
        state.note(q, result);
        in += result.duplicate == infinite_vertex;
    }
}

}  // namespace

void insert_batch(State& state, Team& team, const Batch& batch, bool fresh, bool may_stop) {
    // The arrays and the schedule are allocated before the mesh changes, so that a failure to
    // allocate them changes nothing.
    const std::size_t n = batch.points.size;
    const std::size_t base = fresh ? 1 : state.mesh.vertices.size();
    Stopwatch watch(state.statistics.insert_seconds);
    state.mesh.vertices.grow(base + n);
    state.mesh.vertex_hint.grow(base + n);
    team.split(n, 8192, [&](std::size_t begin, std::size_t end, unsigned) {
        state.mesh.vertices.prefault(base + begin, base + end);
    });
    // The schedule uses the memory that the new vertices will take, behind the vertices that are in
    // the array now.
    const std::size_t held = std::min(state.mesh.vertices.size(), base + n);
    BorrowedArena room(state.mesh.vertices.data() + held, (base + n - held) * sizeof(Vertex),
                       state.allocator);
    Schedule full(state.allocator, room.allocator());
    const bool is_short = n <= smallest_schedule;
    Schedule& schedule = is_short ? state.short_schedule : full;
    if (!is_short) watch.count_for(state.statistics.order_seconds);
    schedule_batch(state, team, batch, schedule);
    if (!is_short) watch.count_for(state.statistics.insert_seconds);
    if (may_stop) state.progress.stop_if_cancelled(0, n);
    try {
        state.mesh.reserve_tetrahedra(expected_tetrahedra(base + n, state.mesh.slot_limit));
    } catch (const std::bad_alloc&) {
        // The insertion may still succeed, since the storage also grows on demand.
    }

    if (fresh)
        begin_with(state, team, batch, schedule);
    else
        copy_vertices(state, team, batch, schedule, base);
    struct Close {
        State& state;
        Team& team;
        const std::size_t base, first_point;
        ~Close() {
            compact_vertices(state, team, base, first_point);
            state.walk_starts.take_new_vertices(state.mesh, base);
        }
    } close{state, team, base, batch.first_index};
    const std::size_t done = fresh ? 4 : 0;
    // Several threads need a vertex number for every point, repeats included.
    if (team.size() == 1 || schedule.rounds.size() == 1 || base + n > state.mesh.vertex_limit) {
        insert_scheduled(state, batch, schedule, base, done, may_stop);
    } else {
        make_guards_agree(state.mesh);
        ConcurrentInsertion(state, team, batch, schedule, base, may_stop).run(done);
    }
}

}  // namespace mgdt
