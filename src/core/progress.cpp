// SPDX-License-Identifier: MIT
#include "core/progress.hpp"

#include "platform/callback.hpp"

namespace mgdt {

void Progress::report(std::size_t done, std::size_t total) {
    if (!settings_.progress) return;
    const double fraction = static_cast<double>(done) / static_cast<double>(total);
    const std::int32_t cancels = call_back<std::int32_t>(
        1, [&] { return settings_.progress(fraction, settings_.progress_user); });
    if (cancels != 0) stop_.set();
}

void Progress::stop_if_cancelled(std::size_t done, std::size_t total) {
    if (!stop_.is_set()) return;
    stop_.forget();
    fail(MGDT_ERR_CANCELLED, "cancelled after %zu of %zu points", done, total);
}

}  // namespace mgdt
