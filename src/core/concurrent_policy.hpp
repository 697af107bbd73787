// SPDX-License-Identifier: MIT
// Decides how many threads insert, in which way, and when they give up. The policy uses only the
// sizes, counts and times that its caller passes; it starts no thread and changes no mesh.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "core/settings.hpp"

namespace mgdt {

class ConcurrentPolicy {
  public:
    // A policy for a batch of `batch_size` points and at most `threads` threads.
    ConcurrentPolicy(const TestHooks& hooks, unsigned threads, std::size_t batch_size) noexcept
        : hooks_(hooks), most_threads_(threads), batch_size_(batch_size) {}

    // The number of threads for a round of this size, which `vertices` vertices and `tetrahedra`
    // tetrahedra precede.
    unsigned threads_for_round(std::size_t size, std::size_t tetrahedra,
                               std::size_t vertices) const noexcept;
    // The number of threads for a few points that all other threads wait for.
    unsigned threads_for_few(std::size_t points) const noexcept;
    // The number of threads for the `deferred` points out of `points` points. Many deferred points
    // mean contention, so each thread then needs more points.
    unsigned threads_for_deferred(std::size_t deferred, std::size_t points) const noexcept;

    // Whether the next round may be inserted in zones. By default, contention in the previous round
    // forbids zones.
    bool may_use_zones() const noexcept;
    // Whether the border of the zones has few enough points for the round to gain from zones.
    bool is_border_short(std::size_t border, std::size_t round_size) const noexcept;
    void begin_round() noexcept { stops_for_hubs_ = 0; }
    void end_round(std::uint64_t deferred, std::size_t size) noexcept;

    // Whether all threads stop for the next hub. The number of such stops per round is limited.
    bool may_stop_for_hubs() const noexcept { return stops_for_hubs_ < max_stops_for_hubs; }
    void count_stop_for_hubs() noexcept { ++stops_for_hubs_; }

    // The number of points in a sample. Where many attempts fail, one thread may be faster than
    // several, so one thread inserts a sample and compare() compares the speeds. begin_list()
    // forgets the comparisons of the previous list of points.
    static constexpr std::size_t sample_size = 1024;
    void begin_list() noexcept;
    std::size_t attempts_before_doubt() const noexcept { return attempts_before_doubt_; }
    // One thread took `alone_seconds` for a sample, all threads `seconds` for `inserted` points.
    // Returns whether one thread goes on alone.
    bool compare(double alone_seconds, std::size_t sample, double seconds,
                 std::size_t inserted) noexcept;

  private:
    static constexpr std::size_t max_stops_for_hubs = 16;

    unsigned threads_for(std::size_t points, std::size_t min_points_per_thread) const noexcept;

    const TestHooks& hooks_;
    const unsigned most_threads_;
    const std::size_t batch_size_;
    std::size_t stops_for_hubs_ = 0;
    bool is_contended_ = false;  // many points of the previous round were deferred
    std::size_t attempts_before_doubt_ = 0;
    bool was_faster_alone_ = false;
};

// Advises one thread what to do, according to its failed attempts.
class Contention {
  public:
    enum class Advice : std::uint8_t {
        go_on,
        wait,   // sleep for wait(): the other thread may soon be done, or be suspended
        leave,  // leave the rest of the stage to other threads
        doubt,  // stop all threads: one thread may be faster than several
    };

    // Begins a stage in which `threads` threads insert `points` points. A thread asks for advice
    // after each piece.
    void begin(std::size_t points, unsigned threads, std::size_t attempts_before_doubt) noexcept;
    void count(std::size_t attempts, std::size_t failures) noexcept;
    // Counts the tetrahedra of the cavity that an attempt visited before it failed.
    void count_given_up(std::size_t tetrahedra) noexcept { given_up_ += tetrahedra; }
    // Whether failed attempts have cost so much that all threads should stop at once, without
    // waiting for the next judgement.
    bool has_given_up_too_much() const noexcept {
        return given_up_ > max_given_up_per_attempt * attempts_before_doubt_;
    }
    // Judges the attempts since the previous judgement, if there are enough of them.
    Advice judge() noexcept;
    std::chrono::microseconds wait() const noexcept { return first_wait * (1 << (waits_ - 1)); }

  private:
    // The attempts of a thread are judged about this many times per stage, after at least
    // `min_attempts` attempts each time.
    static constexpr std::size_t judgements = 64, min_attempts = 512;
    // A thread waits at most this often in a row, each time twice as long, before it leaves.
    static constexpr unsigned max_waits = 4;
    static constexpr std::chrono::microseconds first_wait{100};
    // has_given_up_too_much() allows this many visited tetrahedra, on the average, per attempt
    // before a doubt.
    static constexpr std::size_t max_given_up_per_attempt = 64;
    // Visiting this many tetrahedra in vain counts as one more failed attempt.
    static constexpr std::size_t given_up_per_failure = 256;

    struct Sample {
        std::size_t attempts = 0, failures = 0;
        bool is_contended() const noexcept { return failures > attempts / 4; }
    };

    std::size_t attempts_per_judgement_ = 0, attempts_before_doubt_ = 0;
    Sample own_;    // decides whether this thread waits or leaves
    Sample doubt_;  // decides whether all threads stop
    std::size_t given_up_ = 0;
    unsigned waits_ = 0;  // the number of waits in a row
};

}  // namespace mgdt
