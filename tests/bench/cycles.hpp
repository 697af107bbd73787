// SPDX-License-Identifier: MIT
// Processor cycles of the calling thread: unlike seconds, they do not depend on the clock's speed
// and count no time in which another thread had the core. Only Linux has them here, and there a
// virtual machine or the setting kernel.perf_event_paranoid may withhold them.
#pragma once

#include <cstdint>

#if defined(__linux__)
#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace bench {

class CycleCounter {
  public:
    CycleCounter() {
        if (open(false))
            scope_ = "of user and kernel";
        else if (open(true))
            scope_ = "of user code alone";
    }
    ~CycleCounter() { close(); }
    CycleCounter(const CycleCounter&) = delete;
    CycleCounter& operator=(const CycleCounter&) = delete;

    /// Whose cycles are counted, in words.
    const char* scope() const { return scope_; }

    /// The cycles that body() takes; 0 if they are not to be had.
    template <class Body>
    double count(Body body) const {
        const std::uint64_t start = read();
        body();
        const std::uint64_t end = read();
        return start == 0 || end == 0 ? 0 : static_cast<double>(end - start);
    }

  private:
#if defined(__linux__)
    bool open(bool user_only) {
        perf_event_attr attributes{};
        attributes.size = sizeof attributes;
        attributes.type = PERF_TYPE_HARDWARE;
        attributes.config = PERF_COUNT_HW_CPU_CYCLES;
        attributes.pinned = 1;  // all of the time or, seen by read(), not at all
        attributes.exclude_kernel = user_only;
        attributes.exclude_hv = 1;
        constexpr int this_thread = 0, any_core = -1, no_group = -1;
        file_ = static_cast<int>(
            syscall(SYS_perf_event_open, &attributes, this_thread, any_core, no_group, 0));
        return file_ >= 0;
    }
    std::uint64_t read() const {
        std::uint64_t value = 0;
        return file_ >= 0 && ::read(file_, &value, sizeof value) == sizeof value ? value : 0;
    }
    void close() {
        if (file_ >= 0) ::close(file_);
    }
    int file_ = -1;
#else
    static bool open(bool) {
        return false;
    }
    static std::uint64_t read() {
        return 0;
    }
    static void close() {}
#endif
    const char* scope_ = "not available";
};

}  // namespace bench
