// SPDX-License-Identifier: MIT
// What a long call exchanges with its caller: reports of progress, and requests to stop.
#pragma once

#include <algorithm>
#include <cstddef>
#include <new>

#include "platform/call_settings.hpp"
#include "platform/error.hpp"
#include "platform/stop_request.hpp"

namespace mgdt {

class Progress {
  public:
    // Each report calls the function that `settings` names at that time.
    explicit Progress(const CallSettings& settings) noexcept : settings_(settings) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // The number of points between two checks for a request to stop.
    static constexpr std::size_t poll_interval = 1024;

    StopFlag& stop() noexcept { return stop_; }
    bool is_cancelled() const noexcept { return stop_.is_set(); }
    // Tells the caller that `done` of `total` points are done. The caller may cancel.
    void report(std::size_t done, std::size_t total);
    // Forgets a request to stop, and throws MGDT_ERR_CANCELLED if there was one.
    void stop_if_cancelled(std::size_t done, std::size_t total);

    // Calls step(k), which makes a change, for k = first, ..., n - 1 until a step returns false.
    // Reports progress. The message of an error says that done(k) of the caller's `total` points
    // are done.
    template <class Done, class Step>
    void change_one_by_one(std::size_t first, std::size_t n, std::size_t total, Done done,
                           Step step);

  private:
    const CallSettings& settings_;
    StopFlag stop_;
};

template <class Done, class Step>
void Progress::change_one_by_one(std::size_t first, std::size_t n, std::size_t total, Done done,
                                 Step step) {
    const std::size_t report_interval = std::max<std::size_t>(n / 100, 1);
    std::size_t next_report = first + report_interval;
    for (std::size_t k = first; k < n; ++k) {
        const bool is_due = k >= next_report;
        if (is_due) {
            next_report += report_interval;
            report(k, n);
        }
        if (is_due || k % poll_interval == 0) stop_if_cancelled(done(k), total);
        try {
            if (!step(k)) return;
        } catch (const std::bad_alloc&) {
            fail(MGDT_ERR_OUT_OF_MEMORY, "out of memory after %zu of %zu points", done(k), total);
        } catch (const Error& error) {
            if (error.status == MGDT_ERR_CANCELLED)
                fail(MGDT_ERR_CANCELLED, "cancelled after %zu of %zu points", done(k), total);
            if (error.status != MGDT_ERR_TOO_LARGE) throw;
            fail(MGDT_ERR_TOO_LARGE, "%s after %zu of %zu points", error.message, done(k), total);
        }
    }
}

}  // namespace mgdt
