// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace mgdt {

// Adds the time that passes to one of the statistics, and from count_for() on to another: to look
// at the clock is a fiftieth of inserting a point.
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
