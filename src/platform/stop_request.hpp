// SPDX-License-Identifier: MIT
// A request to stop, which long loops look at.
#pragma once

#include <cstddef>

#include "platform/atomic.hpp"
#include "platform/error.hpp"

namespace mgdt {

class StopRequest {
  public:
    explicit StopRequest(const Atomic<bool>& flag) noexcept : flag_(flag) {}

    // Throws MGDT_ERR_CANCELLED if there is a request.
    void poll() const {
        if (flag_.load(std::memory_order_relaxed)) fail(MGDT_ERR_CANCELLED, "cancelled");
    }
    // Does so in step i of a loop, but not in every step.
    void poll_in_step(std::size_t i) const {
        constexpr std::size_t interval = 256;
        if (i % interval == 0) poll();
    }

  private:
    const Atomic<bool>& flag_;
};

}  // namespace mgdt
