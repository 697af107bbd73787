// SPDX-License-Identifier: MIT
// How many threads a call may use.
#pragma once

#include <algorithm>
#include <thread>

#include "parallel/team.hpp"
#include "platform/call_settings.hpp"

namespace mgdt {

// The number that the caller has chosen, where 0 is the number of cores, at most Team::most.
inline unsigned thread_count(const CallSettings& settings) noexcept {
    const unsigned chosen = settings.threads > 0
                                ? static_cast<unsigned>(settings.threads)
                                : std::max(1u, std::thread::hardware_concurrency());
    return std::min(chosen, Team::most);
}

}  // namespace mgdt
