// SPDX-License-Identifier: MIT
// Reports the progress of a call that has stages to its caller, who may cancel it.
#pragma once

#include "core/triangulation.hpp"
#include "platform/callback.hpp"

namespace mgdt {

class StageProgress {
  public:
    // Reports to the function that the settings name now.
    StageProgress(const CallSettings& settings, StopFlag& stop)
        : StageProgress(settings.progress, settings.progress_user, stop) {}

    // For a call within the call, which reports nothing and may be cancelled.
    StageProgress quiet() const { return {nullptr, nullptr, stop_}; }
    StopRequest stop_request() const noexcept { return stop_.request(); }
    // Passes this share of what remains. Stages that are entered later, from 0 to 1, divide the
    // rest.
    void leave_behind(double share) { begin_ += share * (1 - begin_); }
    // Enters the next stage, in which the progress of the whole call goes from `from` to `to`.
    void enter(double from, double to) {
        from_ = begin_ + from * (1 - begin_);
        to_ = begin_ + to * (1 - begin_);
        report(0);
    }
    // Reports a fraction of the stage. Throws if the caller cancels.
    void report(double fraction) {
        if (tell(fraction)) fail(MGDT_ERR_CANCELLED, "cancelled");
    }
    // Reports that everything is done. A cancellation has no effect any more.
    void finish() {
        from_ = to_ = 1;
        tell(1);
    }
    // Runs an insertion into t. The progress of the insertion is share i of n of the stage.
    template <class Insert>
    void watch(Triangulation& t, std::size_t i, std::size_t n, const Insert& insert) {
        Share share{*this, static_cast<double>(i), static_cast<double>(n)};
        Settings& settings = t.settings();
        settings.progress_user = &share;
        settings.progress = [](double fraction, void* user) -> std::int32_t {
            const Share& s = *static_cast<const Share*>(user);
            return s.progress.tell((s.first + fraction) / s.count) ? 1 : 0;
        };
        const Unset unset{settings};
        insert();
    }

  private:
    StageProgress(mgdt_progress_fn tell, void* user, StopFlag& stop)
        : tell_(tell), user_(user), stop_(stop) {}

    struct Share {
        StageProgress& progress;
        double first, count;
    };
    struct Unset {
        Settings& settings;
        ~Unset() { settings.progress = nullptr; }
    };
    bool tell(double fraction) {
        const double whole = from_ + fraction * (to_ - from_);
        if (tell_ && call_back<std::int32_t>(1, [&] { return tell_(whole, user_); }) != 0)
            stop_.set();
        return stop_.is_set();
    }

    mgdt_progress_fn tell_;
    void* user_;
    StopFlag& stop_;
    double begin_ = 0, from_ = 0, to_ = 0;
};

}  // namespace mgdt
