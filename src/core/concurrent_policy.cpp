// SPDX-License-Identifier: MIT
#include "core/concurrent_policy.hpp"

#include <algorithm>
#include <utility>

#include "parallel/team.hpp"

namespace mgdt {
namespace {

// A round is early if it has less than 1/8 of the points of the batch.
constexpr std::size_t early_share = 8;
// A round gains from zones if it has at least 8 points for each point at the border of zones.
constexpr std::size_t min_points_per_border_point = 8;

// Whether more than 1/50 of the points were deferred, which means contention between threads.
bool is_many(std::uint64_t deferred, std::size_t points) noexcept {
    return deferred > points / 50;
}

}  // namespace

unsigned ConcurrentPolicy::threads_for(std::size_t points,
                                       std::size_t min_points_per_thread) const noexcept {
    return Team::threads_for(points, std::max<std::size_t>(min_points_per_thread, 1),
                             most_threads_);
}

unsigned ConcurrentPolicy::threads_for_round(std::size_t size, std::size_t tetrahedra,
                                             std::size_t vertices) const noexcept {
    // With many tetrahedra per vertex, as between the arms of a spiral, most tetrahedra are long,
    // and most insertions would need some that another thread owns.
    if (tetrahedra / hooks_.max_tetrahedra_per_vertex > vertices) return 1;
    const std::size_t usual = hooks_.min_points_per_thread;
    unsigned threads = threads_for(size, usual);
    // All other threads wait for an early round. Such a round gets two threads if each of the two
    // has a quarter of the usual number of points.
    if (early_share * size < batch_size_)
        threads = std::max(threads, std::min(2u, threads_for(size, usual / 4)));
    // With few tetrahedra, as when most points are repeats, most insertions would need tetrahedra
    // that another thread owns.
    return std::min(threads, threads_for_few(tetrahedra));
}

unsigned ConcurrentPolicy::threads_for_few(std::size_t points) const noexcept {
    return threads_for(points, hooks_.min_points_per_thread / 8);
}

unsigned ConcurrentPolicy::threads_for_deferred(std::size_t deferred,
                                                std::size_t points) const noexcept {
    return is_many(deferred, points) ? threads_for(deferred, hooks_.min_points_per_thread)
                                     : threads_for_few(deferred);
}

bool ConcurrentPolicy::may_use_zones() const noexcept {
    return hooks_.zones == ZoneUse::always ||
           (hooks_.zones == ZoneUse::where_few_meet && !is_contended_);
}

bool ConcurrentPolicy::is_border_short(std::size_t border, std::size_t round_size) const noexcept {
    return hooks_.zones == ZoneUse::always || min_points_per_border_point * border <= round_size;
}

void ConcurrentPolicy::end_round(std::uint64_t deferred, std::size_t size) noexcept {
    is_contended_ = is_many(deferred, size);
}

void ConcurrentPolicy::begin_list() noexcept {
    was_faster_alone_ = false;
    attempts_before_doubt_ = hooks_.attempts_before_doubt;
}

bool ConcurrentPolicy::compare(double alone_seconds, std::size_t sample, double seconds,
                               std::size_t inserted) noexcept {
    // Contention may pass, so one thread has to be twice as fast, two times in a row.
    const bool is_faster =
        alone_seconds * static_cast<double>(inserted) < 0.5 * seconds * static_cast<double>(sample);
    const bool was_faster = std::exchange(was_faster_alone_, is_faster);
    if (!is_faster) attempts_before_doubt_ *= 2;
    return is_faster && was_faster;
}

void Contention::begin(std::size_t points, unsigned threads,
                       std::size_t attempts_before_doubt) noexcept {
    *this = {};
    attempts_per_judgement_ = std::max(min_attempts, points / (threads * judgements));
    attempts_before_doubt_ = attempts_before_doubt;
}

void Contention::count(std::size_t attempts, std::size_t failures) noexcept {
    for (Sample* const sample : {&own_, &doubt_}) {
        sample->attempts += attempts;
        sample->failures += failures;
    }
}

Contention::Advice Contention::judge() noexcept {
    if (doubt_.attempts >= attempts_before_doubt_) {
        doubt_.failures += std::exchange(given_up_, 0) / given_up_per_failure;
        if (std::exchange(doubt_, {}).is_contended()) return Advice::doubt;
    }
    if (own_.attempts < attempts_per_judgement_) return Advice::go_on;
    if (!std::exchange(own_, {}).is_contended()) {
        waits_ = 0;
        return Advice::go_on;
    }
    if (waits_ == max_waits) return Advice::leave;
    ++waits_;
    return Advice::wait;
}

}  // namespace mgdt
