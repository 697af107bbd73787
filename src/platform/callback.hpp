// SPDX-License-Identifier: MIT
// Calls a function of the host. Changes that it makes to the floating-point environment or to the
// cancellation state are undone afterwards, and its exceptions are caught.
#pragma once

#include "platform/cancellation.hpp"
#include "platform/fp_environment.hpp"

namespace mgdt {

// Returns the result of call(), or `instead` if it throws.
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
