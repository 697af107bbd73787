// SPDX-License-Identifier: MIT
// The progress of a long call that has stages. Its caller receives reports and may cancel the call.
#pragma once

#include <cstddef>

#include "platform/call_settings.hpp"
#include "platform/function_ref.hpp"
#include "platform/stop_request.hpp"

namespace mgdt {

class StageProgress {
  public:
    // Reports to the function that the settings name now.
    StageProgress(const CallSettings& settings, StopFlag& stop) noexcept
        : StageProgress(settings.progress, settings.progress_user, stop) {}

    // For a call within the call, which reports nothing and may be cancelled.
    StageProgress quiet() const noexcept { return {nullptr, nullptr, stop_}; }
    // For a call within the call, which has stages of its own. In these, the progress of the whole
    // call goes from `from` to `to`.
    StageProgress within(double from, double to) const noexcept;
    // The same, for items `first` to `last` of `all` items that take about equal times.
    StageProgress within_items(std::size_t first, std::size_t last,
                               std::size_t all) const noexcept {
        const double count = static_cast<double>(all);
        return within(static_cast<double>(first) / count, static_cast<double>(last) / count);
    }
    StopRequest stop_request() const noexcept { return stop_.request(); }
    // Passes this share of what remains. Stages that are entered later, from 0 to 1, divide the
    // rest.
    void leave_behind(double share) { begin_ = at(share); }
    // Enters the next stage, in which the progress of the whole call goes from `from` to `to`.
    void enter(double from, double to);
    // Reports a fraction of the stage. Throws MGDT_ERR_CANCELLED if there is a request to stop.
    void report(double fraction);
    // Polls for a request to stop, and reports progress. A member of a team calls this function
    // when `done` of the `all` items of its share are done. Only member 0, which runs on the
    // calling thread, reports; its share stands for the whole stage. Throws as report() does.
    void look(std::size_t done, std::size_t all, unsigned member);
    // Counts step i of a loop over the share from `begin` to `end` of a member. Calls look() once
    // in 256 steps.
    void step(std::size_t i, std::size_t begin, std::size_t end, unsigned member = 0) {
        constexpr std::size_t interval = 256;
        if ((i - begin) % interval == 0) look(i - begin, end - begin, member);
    }
    // Reports that everything is done. It is too late to cancel.
    void finish();
    // Runs an insertion into a triangulation with these settings. The progress of the insertion is
    // share i of n of the stage.
    template <class Insert>
    void watch(CallSettings& settings, std::size_t i, std::size_t n, const Insert& insert) {
        run_watched(settings, i, n, insert);
    }

  private:
    StageProgress(mgdt_progress_fn tell, void* user, StopFlag& stop) noexcept
        : tell_(tell), user_(user), stop_(stop) {}

    double at(double fraction) const noexcept { return begin_ + fraction * (end_ - begin_); }
    void tell(double fraction);
    void run_watched(CallSettings& settings, std::size_t i, std::size_t n,
                     FunctionRef<void()> insert);

    mgdt_progress_fn tell_;
    void* user_;
    StopFlag& stop_;
    // All of these are fractions of the whole call: the range that the stages divide, the range of
    // the current stage, and the fraction that was reported last.
    double begin_ = 0, end_ = 1, from_ = 0, to_ = 1, told_ = -1;
};

}  // namespace mgdt
