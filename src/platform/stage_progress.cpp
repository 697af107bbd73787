// SPDX-License-Identifier: MIT
#include "platform/stage_progress.hpp"

#include "platform/callback.hpp"

namespace mgdt {

StageProgress StageProgress::within(double from, double to) const noexcept {
    StageProgress inner = *this;
    inner.begin_ = inner.from_ = at(from);
    inner.end_ = inner.to_ = at(to);
    return inner;
}

void StageProgress::enter(double from, double to) {
    from_ = at(from);
    to_ = at(to);
    report(0);
}

void StageProgress::report(double fraction) {
    tell(fraction);
    stop_.request().poll();
}

void StageProgress::look(std::size_t done, std::size_t all, unsigned member) {
    stop_.request().poll();
    if (member != 0 || !tell_) return;
    // About a hundred reports of the whole call.
    const double fraction = static_cast<double>(done) / static_cast<double>(all);
    if (from_ + fraction * (to_ - from_) >= told_ + 0.01) report(fraction);
}

void StageProgress::finish() {
    if (tell_) call_back<std::int32_t>(1, [&] { return tell_(1, user_); });
}

void StageProgress::tell(double fraction) {
    if (!tell_) return;
    told_ = from_ + fraction * (to_ - from_);
    if (call_back<std::int32_t>(1, [&] { return tell_(told_, user_); }) != 0) stop_.set();
}

void StageProgress::run_watched(CallSettings& settings, std::size_t i, std::size_t n,
                                FunctionRef<void()> insert) {
    struct Share {
        StageProgress& progress;
        double first, count;
    } share{*this, static_cast<double>(i), static_cast<double>(n)};
    settings.progress_user = &share;
    settings.progress = [](double fraction, void* user) -> std::int32_t {
        const Share& s = *static_cast<const Share*>(user);
        s.progress.tell((s.first + fraction) / s.count);
        return s.progress.stop_.is_set() ? 1 : 0;
    };
    struct Unset {
        CallSettings& settings;
        ~Unset() { settings.progress = nullptr; }
    } const unset{settings};
    insert();
}

}  // namespace mgdt
