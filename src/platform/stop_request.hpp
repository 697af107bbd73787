// SPDX-License-Identifier: MIT
// Requests to stop: the flag that any thread may set, and what long loops look at.
#pragma once

#include <cstddef>
#include <cstdint>

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

// Stops the running calls of an object. A request that is made while no call runs stops the next
// call.
class StopFlag {
  public:
    StopFlag() noexcept = default;
    StopFlag(const StopFlag&) = delete;
    StopFlag& operator=(const StopFlag&) = delete;

    // Any thread and any signal handler may call this function.
    void set() noexcept { is_set_.store(true, std::memory_order_relaxed); }
    void forget() noexcept { is_set_.store(false, std::memory_order_relaxed); }
    bool is_set() const noexcept { return is_set_.load(std::memory_order_relaxed); }
    StopRequest request() const noexcept { return StopRequest(is_set_); }

    // A call that can be stopped. When the last of the running calls ends, however it ends, the
    // request is forgotten.
    class Call {
      public:
        explicit Call(StopFlag& flag) noexcept : flag_(flag) {
            flag_.running_.fetch_add(1, std::memory_order_relaxed);
        }
        ~Call() {
            if (flag_.running_.fetch_sub(1, std::memory_order_relaxed) == 1) flag_.forget();
        }
        Call(const Call&) = delete;
        Call& operator=(const Call&) = delete;

      private:
        StopFlag& flag_;
    };

  private:
    Atomic<bool> is_set_{false};
    Atomic<std::uint32_t> running_{0};
};

}  // namespace mgdt
