// SPDX-License-Identifier: MIT
// The insertion of one batch of points: schedule, copy, and one point after another.
#include <algorithm>

#include "core/batch.hpp"
#include "core/concurrent_insertion.hpp"
#include "core/stopwatch.hpp"
#include "core/triangulation.hpp"
#include "order/round_assignment.hpp"
#include "platform/borrowed_arena.hpp"
#include "platform/error.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// Below this many points a schedule costs more than it gains.
constexpr std::size_t smallest_schedule = 16;

// Moves four positions to the front of the schedule; the others keep their order.
void bring_to_front(Schedule& schedule, const std::size_t positions[4]) {
    // Positions before the last of the four move back by the number of the four behind them.
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
        // The i-th of the four, counted from the back, is now 3 - i places further back.
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

}  // namespace

// Assumes that every point becomes a vertex; compact_vertices() corrects that. Filling the point
// map at each insertion would be a random-access store, for which the stores of its star would
// wait.
void Triangulation::copy_vertices(Team& team, const Batch& batch, const Schedule& schedule,
                                  std::size_t base) {
    const std::size_t size = batch.points.size;
    mesh_.vertices.resize(base + size);
    mesh_.vertex_hint.resize(base + size);
    team.split(size, 8192, [&](std::size_t begin, std::size_t end, unsigned) {
        mesh_.vertex_hint.prefault(base + begin, base + end);
        constexpr std::size_t ahead = 24;
        // Copies, which stores cannot change.
        Vertex* const vertices = mesh_.vertices.data() + base;
        TetId* const hints = mesh_.vertex_hint.data() + base;
        VertexId* const of_points = point_map_.data();
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
    if (!batch.is_normal) mesh_.has_extremes = true;
}

// Fills the schedule of a batch, with rounds where several threads will insert it.
void Triangulation::schedule_batch(Team& team, const Batch& batch, Schedule& schedule) {
    const std::int32_t scheme =
        batch.points.size <= smallest_schedule ? MGDT_ORDER_INPUT : settings_.scheme;
    make_schedule(team, batch.points, scheme, settings_.order, schedule);
    // Several threads need rounds, so that the space is divided before they start.
    if (team.size() > 1 && schedule.rounds.size() == 1 && scheme != MGDT_ORDER_RANDOM)
        assign_rounds(team, settings_.order.seed, schedule);
    statistics_.levels = schedule.levels;
    statistics_.rounds = static_cast<double>(schedule.rounds.size());
    statistics_.threads = team.size();
}

// Puts four points of a batch that span space at the front of its schedule, and starts the mesh
// with them; the others become vertices that are not inserted yet.
void Triangulation::begin_with(Team& team, const Batch& batch, Schedule& schedule) {
    std::size_t positions[4];
    AffineBasis basis;
    for (std::size_t k = 0; basis.dimension() < 3; ++k) {
        double p[3];
        batch.get(schedule.order[k], p);
        if (basis.add(p)) positions[basis.dimension()] = k;
    }
    bring_to_front(schedule, positions);
    mesh_.reserve_tetrahedra(8);

    location_tree_.forget();
    mesh_.clear();
    degenerate_.clear();
    std::fill(point_map_.begin(), point_map_.end(), infinite_vertex);
    statistics_.points_inserted = statistics_.duplicates = 0;
    basis_ = basis;
    copy_vertices(team, batch, schedule, 1);
    make_first_tetrahedra();
}

void Triangulation::insert_batch(Team& team, const Batch& batch, bool fresh, bool may_stop) {
    // All that can fail before the mesh changes.
    const std::size_t n = batch.points.size;
    const std::size_t base = fresh ? 1 : mesh_.vertices.size();
    Stopwatch watch(statistics_.insert_seconds);
    mesh_.vertices.grow(base + n);
    mesh_.vertex_hint.grow(base + n);
    team.split(n, 8192, [&](std::size_t begin, std::size_t end, unsigned) {
        mesh_.vertices.prefault(base + begin, base + end);
    });
    // Until the vertices come, the schedule is made where they will be, but for those held till
    // now.
    const std::size_t held = std::min(mesh_.vertices.size(), base + n);
    BorrowedArena room(mesh_.vertices.data() + held, (base + n - held) * sizeof(Vertex),
                       allocator_);
    Schedule full(allocator_, room.allocator());
    const bool is_short = n <= smallest_schedule;
    Schedule& schedule = is_short ? short_schedule_ : full;
    if (!is_short) watch.count_for(statistics_.order_seconds);
    schedule_batch(team, batch, schedule);
    if (!is_short) watch.count_for(statistics_.insert_seconds);
    if (may_stop) stop_if_cancelled(0, n);
    try {
        mesh_.reserve_tetrahedra(expected_tetrahedra(base + n, mesh_.slot_limit));
    } catch (const std::bad_alloc&) {
        // Growing as needed may still fit.
    }

    if (fresh)
        begin_with(team, batch, schedule);
    else
        copy_vertices(team, batch, schedule, base);
    struct Close {
        Triangulation& t;
        Team& team;
        const std::size_t base, first_point;
        ~Close() {
            t.compact_vertices(team, base, first_point);
            t.extend_location_tree(base);
        }
    } close{*this, team, base, batch.first_index};
    const std::size_t done = fresh ? 4 : 0;
    // Several threads cannot do without numbers for repeats.
    if (team.size() == 1 || schedule.rounds.size() == 1 || base + n > mesh_.vertex_limit) {
        insert_scheduled(batch, schedule, base, done, may_stop);
    } else {
        make_guards_agree();
        ConcurrentInsertion(*this, team, batch, schedule, base, may_stop).run(done);
    }
}

// Vertices 1 to 4 and the vertex at infinity: one tetrahedron and four ghosts, each the
// neighbour of all the others.
void Triangulation::make_first_tetrahedra() {
    // As if 4 had been inserted last, before it 3, then 2.
    VertexId v[4] = {4, 3, 2, 1};
    if (orientation(mesh_.point(4), mesh_.point(3), mesh_.point(2), mesh_.point(1)) < 0)
        std::swap(v[2], v[3]);
    mesh_.tetrahedra.resize(5);
    TetrahedronStore& all = mesh_.tetrahedra;
    std::copy(v, v + 4, all[0].v);
    for (unsigned f = 0; f < 4; ++f) {
        // Ghost f + 1 stands on face f. (q, a, b, c) is positive for q beyond it, so these are:
        const unsigned char* face = outer_face[f];
        const VertexId a = v[face[0]], b = v[face[1]], c = v[face[2]];
        const VertexId ghost[4] = {a, b > c ? b : c, b > c ? infinite_vertex : b,
                                   b > c ? c : infinite_vertex};
        std::copy(ghost, ghost + 4, all[f + 1].v);
    }
    const auto slot = [&](TetId t, VertexId of) {
        return static_cast<FacetCode>(std::find(all[t].v, all[t].v + 4, of) - all[t].v);
    };
    for (FacetCode f = 0; f < 4; ++f) {
        Tetrahedron& ghost = all[f + 1];
        for (unsigned i = 0; i < 4; ++i) {
            if (ghost.v[i] == infinite_vertex) {
                ghost.n[i] = f;
                all[0].n[f] = facet_code(f + 1, i);
            } else {
                // Beyond the other two of the facet is the ghost that lacks this vertex and has
                // the one that this ghost lacks.
                const TetId other = slot(0, ghost.v[i]) + 1;
                ghost.n[i] = facet_code(other, slot(other, v[f]));
            }
        }
    }
    if (mesh_.tetrahedra.has_spheres()) set_spheres();
    mesh_.ghost_count = 4;
    mesh_.a_ghost = 4;
    last_ = 0;
    for (VertexId i = 1; i <= 4; ++i) mesh_.vertex_hint[i] = 0;
    statistics_.points_inserted += 4;
}

// The tree that finds a batch's first point, over the vertices before `end`. It is made when walks
// without it have cost as much as making it does.
const LocationTree* Triangulation::tree_for_insertion(std::size_t end) noexcept {
    if (!location_tree_.peek() && lone_steps_ < end / 8) return nullptr;
    lone_steps_ = 0;
    return location_tree(end);
}

// After vertices from `begin` on have come in.
void Triangulation::extend_location_tree(std::size_t begin) noexcept {
    LocationTree* const tree = location_tree_.peek();
    if (!tree) return;
    const std::size_t end = mesh_.vertices.size();
    // Many at a time are better taken together, when somebody asks.
    if (end - begin >= begin / 16) {
        location_tree_.forget();
        return;
    }
    tree->add(mesh_, begin, end);
    if (tree->is_outgrown()) {
        location_tree_.forget();
        location_tree(end);
    }
}

void Triangulation::insert_scheduled(const Batch& batch, const Schedule& schedule, std::size_t base,
                                     std::size_t done, bool may_stop) {
    const std::size_t n = batch.points.size;
    const LocationTree* const tree = done == 0 ? tree_for_insertion(base) : nullptr;
    // If there are more points than numbers for vertices, a repeat leaves its number to later
    // points.
    const bool is_crowded = base + n > mesh_.vertex_limit;
    std::size_t in = done;
    const std::size_t report_interval = std::max<std::size_t>(n / 100, 1);
    std::size_t next_report = report_interval;
    for (std::size_t k = done; k < n; ++k) {
        const bool is_due = may_stop && k >= next_report;
        if (is_due) {
            next_report += report_interval;
            report(k, n);
        }
        if (is_due || (may_stop && k % poll_interval == 0)) stop_if_cancelled(k, n);
        const VertexId q = static_cast<VertexId>(base + (is_crowded ? in : k));
        if (q >= mesh_.vertex_limit)
            fail(MGDT_ERR_TOO_LARGE, "more than %u vertices", mesh_.vertex_limit);
        if (q != base + k) {
            mesh_.vertices[q] = mesh_.vertices[base + k];
            point_map_[mesh_.vertices[q].index] = q;
        }
        TetId start = last_;
        if (!schedule.hints.empty() && schedule.hints[k] != no_hint)
            start = mesh_.live_from(
                mesh_.vertex_hint[point_map_[batch.index(schedule.order[schedule.hints[k]])]]);
        else if (k == 0)
            start = start_of_walk(mesh_, tree, last_, mesh_.point(q));
        workspace_.may_jump = k == 0;
        const std::uint64_t steps_before = workspace_.counters.walk_steps;
        const Insertion result = calls().insert(mesh_, workspace_, q, start);
        if (k == 0) lone_steps_ += workspace_.counters.walk_steps - steps_before;
        last_ = result.tetrahedron;
        note(q, result);
        in += result.duplicate == infinite_vertex;
    }
}

void Triangulation::note(VertexId q, const Insertion& result) {
    if (result.duplicate == infinite_vertex)
        ++statistics_.points_inserted;
    else
        note_repeat(q, result.duplicate);
}

void Triangulation::note_repeat(VertexId q, VertexId vertex) {
    const std::uint32_t index = mesh_.vertices[q].index;
    point_map_[index] = vertex;
    std::uint32_t& least = mesh_.vertices[vertex].index;
    least = std::min(least, index);
    mesh_.vertices[vertex].moved_to = has_equals;
    ++statistics_.duplicates;
}

}  // namespace mgdt
