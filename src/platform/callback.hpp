// SPDX-License-Identifier: MIT
// How the library calls a function of the host's. What the function changes of the floating-point
// environment or of the cancellation state ends with it, and no exception of it passes.
#pragma once

#include "platform/cancellation.hpp"
#include "platform/fp_environment.hpp"

namespace mgdt {

// What call() returns; `instead` where it throws.
template <class Result, class Call>
Result call_back(Result instead, Call call) noexcept {
    const FpEnvironment environment;
    const CancellationDisabled uninterrupted;
    try {
        return call();
    } catch (...) {
        return instead;
    }
}

}  // namespace mgdt
