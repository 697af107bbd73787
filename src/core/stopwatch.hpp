// SPDX-License-Identifier: MIT
// The time that an operation takes, for a statistic.
#pragma once

#include <chrono>

namespace mgdt {

// Adds the time until its destruction to a statistic; count_for() ends one interval and begins the
// next with a single reading of the clock, which takes as long as 1/50 of an insertion.
class Stopwatch {
  public:
    explicit Stopwatch(double& seconds) : seconds_(&seconds), start_(clock::now()) {}
    ~Stopwatch() { count_for(*seconds_); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

    void count_for(double& seconds) {
        const clock::time_point now = clock::now();
        *seconds_ += std::chrono::duration<double>(now - start_).count();
        seconds_ = &seconds;
        start_ = now;
    }

  private:
    using clock = std::chrono::steady_clock;
    double* seconds_;
    clock::time_point start_;
};

}  // namespace mgdt
