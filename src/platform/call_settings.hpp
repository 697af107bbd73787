// SPDX-License-Identifier: MIT
// The settings that every handle has.
#pragma once

#include <cstdint>

#include "mgdt/mgdt.h"

namespace mgdt {

struct CallSettings {
    std::int32_t index_base = 0;
    std::int32_t threads = 1;  // 0: all cores
    mgdt_progress_fn progress = nullptr;
    void* progress_user = nullptr;
    // Whether long calls that only read the handle report progress and can be cancelled.
    bool watches_reads = true;
};

}  // namespace mgdt
