// SPDX-License-Identifier: MIT
#include "improvement/improver.hpp"

#include <algorithm>
#include <utility>

namespace mgdt {
namespace {

// Kinds of tries for a tetrahedron.
constexpr FailedTries::Kind flips = {1, 1}, contractions = {2, 2}, insertions = {4, 4},
                            raised_insertions = {8, 8};

// Kinds of moves of a vertex. In the tail, a vertex moves on after its tetrahedra have reached the
// goal; where even its first move fails, it fails outside of the tail too. Moves that push have the
// fewest conditions, so where these fail, all others do.
constexpr FailedTries::Kind moves = {1, 1}, tail_moves = {2, 2 | 1}, raised_moves = {4, 4},
                            pushing_moves = {8, 8 | 4 | 2 | 1};

}  // namespace

bool Improver::find_flip(std::uint32_t t, Finder& finder, Change& best) const {
    best.clear();
    best.after = 0;
    const auto keep = [&](bool is_found) {
        if (is_found && finder.other.after > best.after) std::swap(best, finder.other);
    };
    // A change that reaches the goal is good enough.
    for (unsigned i = 0; i < 4 && best.after < goal_; ++i)
        for (unsigned j = i + 1; j < 4 && best.after < goal_; ++j)
            keep(finder.edges.find(t, i, j, finder.other));
    for (unsigned i = 0; i < 4 && best.after < goal_; ++i)
        keep(finder.faces.find(t, i, finder.other));
    return !best.empty();
}

bool Improver::find_contraction(std::uint32_t t, Finder& finder, Change& best) const {
    best.clear();
    best.after = 0;
    for (unsigned i = 0; i < 4; ++i)
        for (unsigned j = 0; j < 4; ++j)
            if (i != j && finder.contraction.find(t, i, j, finder.other) &&
                finder.other.after > best.after)
                std::swap(best, finder.other);
    return !best.empty();
}

// How many passes there will be is not known: each takes a share of the progress that remains.
template <class Pass>
std::size_t Improver::count_changes(StageProgress& progress, const Pass& pass) {
    constexpr double share = 0.04;
    progress.enter(0, share);
    const std::size_t count = pass();
    progress.leave_behind(share);
    changes_ += count;
    return count;
}

// The last round that has changed something that flips and contractions of a tetrahedron depend on:
// tetrahedra at its corners, and at those behind its faces. An insertion also depends on what is
// farther away, but is not tried again for that alone.
std::uint32_t Improver::last_change(std::uint32_t t) const noexcept {
    const FlexibleMesh::Tetrahedron& one = mesh_.tetrahedra[t];
    std::uint32_t last = 0;
    for (unsigned i = 0; i < 4; ++i) {
        last = std::max(last, mesh_.last_change[one.v[i]]);
        if (one.n[i] == no_index) continue;
        last = std::max(last, mesh_.last_change[mesh_.of(one.n[i]).v[one.n[i] % 4]]);
    }
    return last;
}

// Calls find(t, finder, change) for each candidate, except where it has failed and no tetrahedron
// nearby has changed since then.
template <class Find>
std::size_t Improver::run_round(FailedTries::Kind kind, StageProgress& progress, const Find& find) {
    failed_.resize(mesh_.tetrahedra.size());
    return count_changes(progress, [&] {
        return round_.run(candidates_.size(), progress,
                          [&](std::size_t k, unsigned member, Change& change) {
                              const std::uint32_t t = candidates_[k], last = last_change(t);
                              if (failed_.has(t, kind, last)) return false;
                              if (find(t, finders_[member], change)) return true;
                              failed_.add(t, kind, mesh_.round, last);
                              return false;
                          });
    });
}

std::size_t Improver::flip(StageProgress& progress) {
    return run_round(flips, progress, [&](std::uint32_t t, Finder& finder, Change& change) {
        return find_flip(t, finder, change);
    });
}

std::size_t Improver::contract(StageProgress& progress) {
    return run_round(contractions, progress, [&](std::uint32_t t, Finder& finder, Change& change) {
        return find_contraction(t, finder, change);
    });
}

std::size_t Improver::insert(StageProgress& progress) {
    const FailedTries::Kind kind = goal_ != settings_.goal ? raised_insertions : insertions;
    return run_round(kind, progress, [&](std::uint32_t t, Finder& finder, Change& change) {
        return finder.insertion.find(t, goal_, change);
    });
}

std::size_t Improver::smooth(StageProgress& progress) {
    constexpr int most_moves = 4;
    return count_changes(progress, [&] {
        const FailedTries::Kind kind = pushes_                   ? pushing_moves
                                       : goal_ != settings_.goal ? raised_moves
                                       : is_tail_                ? tail_moves
                                                                 : moves;
        return smoothing_.pass(candidates_,
                               {most_moves, is_tail_ ? best_quality : goal_, goal_, pushes_}, kind,
                               progress);
    });
}

std::size_t Improver::smooth_mean(StageProgress& progress) {
    // Without a goal, nothing may become worse.
    const double goal = settings_.goal > 0 ? settings_.goal : above_all;
    return count_changes(progress,
                         [&] { return smoothing_.pass_for_mean(candidates_, goal, progress); });
}

double Improver::choose(double quality) {
    goal_ = quality;
    candidates_.clear();
    double missing = 0;
    // Vertices that have come since then are near.
    if (rings_ > 0) is_near_.resize(mesh_.hints.size(), 1);
    for (std::uint32_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
        const FlexibleMesh::Tetrahedron& tetrahedron = mesh_.tetrahedra[t];
        if (tetrahedron.is_dead() || !(mesh_.qualities[t] < quality)) continue;
        if (rings_ > 0 && std::all_of(tetrahedron.v, tetrahedron.v + 4,
                                      [&](std::uint32_t v) { return is_near_[v] == 0; }))
            continue;
        missing += 1 - mesh_.qualities[t] / quality;
        candidates_.push_back(t);
    }
    return missing;
}

// Marks the vertices within some rings of the tetrahedra below a quality.
void Improver::choose_near(double quality, int rings) {
    rings_ = 0;
    choose(quality);
    rings_ = rings;
    is_near_.clear();
    is_near_.resize(mesh_.hints.size(), 0);
    for (const std::uint32_t t : candidates_)
        for (const std::uint32_t v : mesh_.tetrahedra[t].v) is_near_[v] = 1;
    for (int ring = 1; ring < rings; ++ring)
        for (const FlexibleMesh::Tetrahedron& t : mesh_.tetrahedra) {
            if (t.is_dead() || std::all_of(t.v, t.v + 4, [&](std::uint32_t v) {
                    return is_near_[v] == 0 || is_near_[v] > ring;
                }))
                continue;
            for (const std::uint32_t v : t.v)
                if (is_near_[v] == 0) is_near_[v] = static_cast<std::uint8_t>(ring + 1);
        }
}

// All operations once. Returns by how much tetrahedra miss the quality afterwards.
double Improver::pass(double quality, bool inserts, StageProgress& progress) {
    choose(quality);
    flip(progress);
    choose(quality);
    smooth(progress);
    choose(quality);
    contract(progress);
    choose(quality);
    smooth(progress);
    if (inserts) {
        choose(quality);
        insert(progress);
        choose(quality);
        smooth(progress);
    }
    return choose(quality);
}

// Flips alone, while more than one tetrahedron in 50 can be improved by them.
void Improver::flip_most(StageProgress& progress) {
    constexpr std::size_t least_share = 50;
    std::size_t flips = 0;
    do {
        choose(settings_.goal);
        flips = flip(progress);
    } while (flips * least_share > candidates_.size());
}

// Passes of all operations, until nothing is below the goal or nothing helps. What helps where less
// does not: moves that push other tetrahedra below the goal, then insertions, then a higher goal
// around what is left.
void Improver::reach_goal(StageProgress& progress) {
    constexpr double least_gain = 0.05;
    constexpr int first_rings = 2, last_rings = 5, passes_with_raised_goal = 3;
    const double goal = settings_.goal;
    int rings = first_rings, stage = 0;
    double missing = choose(goal);
    for (int i = 0; i < settings_.most_passes && missing > 0; ++i) {
        const double before = missing;
        ++passes_;
        is_tail_ = stage > 0;
        // What such moves push below the goal is for later passes.
        pushes_ = stage == 1 && i + 1 < settings_.most_passes;
        missing = pass(goal, stage >= 2, progress);
        pushes_ = false;
        if (missing < (1 - least_gain) * before) {
            stage = std::max(0, stage - 1);
            continue;
        }
        if (++stage < 4) continue;
        if (rings > last_rings) break;
        is_tail_ = true;
        choose_near(goal, rings);
        for (int k = 0; k < passes_with_raised_goal; ++k)
            pass(settings_.raised_goal, true, progress);
        is_tail_ = false;
        rings_ = 0;
        ++rings;
        stage = 0;
        missing = choose(goal);
    }
    is_tail_ = false;
}

void Improver::run(StageProgress& progress) {
    if (settings_.goal > 0 && choose(settings_.goal) == 0) return;
    flip_most(progress);
    choose(settings_.goal);
    smooth(progress);
    reach_goal(progress);
    for (int i = 0; i < settings_.mean_passes; ++i) {
        choose(above_all);
        smooth_mean(progress);
    }
    // Better tetrahedra around what is left may help.
    if (settings_.mean_passes > 0 && choose(settings_.goal) > 0) reach_goal(progress);
}

}  // namespace mgdt
