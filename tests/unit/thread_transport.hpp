// SPDX-License-Identifier: MIT
// Parts in threads that share nothing but what they exchange: processes, as the parts see them.
#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <thread>
#include <vector>

#include "parts/transport.hpp"

namespace mgdt {

// What the threads meet at. All make the same calls.
class MeetingPlace {
  public:
    explicit MeetingPlace(PartId parts) : slots_(parts), waiting_for_(parts) {}

    PartId size() const { return static_cast<PartId>(slots_.size()); }
    // Shows the others what is at `mine` while they look at it; look(part, what it shows).
    template <class Look>
    bool meet(PartId self, const void* mine, const Look& look) {
        slots_[self] = mine;
        wait();
        for (PartId p = 0; p < size(); ++p) look(p, slots_[p]);
        wait();
        return true;
    }

  private:
    void wait() {
        std::unique_lock<std::mutex> lock(mutex_);
        const unsigned turn = turn_;
        if (--waiting_for_ == 0) {
            waiting_for_ = size();
            ++turn_;
            all_here_.notify_all();
        } else {
            all_here_.wait(lock, [&] { return turn != turn_; });
        }
    }

    std::vector<const void*> slots_;
    std::mutex mutex_;
    std::condition_variable all_here_;
    PartId waiting_for_;
    unsigned turn_ = 0;
};

class ThreadTransport final : public Transport {
  public:
    ThreadTransport(MeetingPlace& place, PartId self) : place_(place), self_(self) {}

    PartId parts() const noexcept override { return place_.size(); }
    PartId first_local() const noexcept override { return self_; }
    PartId local_parts() const noexcept override { return 1; }
    bool gather(const void* mine, const std::uint64_t* begin, void* all) noexcept override {
        return place_.meet(self_, mine, [&](PartId p, const void* theirs) {
            const std::size_t bytes = begin[p + 1] - begin[p];
            if (bytes > 0) std::memcpy(static_cast<char*>(all) + begin[p], theirs, bytes);
        });
    }
    bool sum(std::uint64_t* numbers, std::size_t n) noexcept override {
        return combine(numbers, n, [](std::uint64_t a, std::uint64_t b) { return a + b; });
    }
    bool least(double* numbers, std::size_t n) noexcept override {
        return combine(numbers, n, [](double a, double b) { return std::min(a, b); });
    }
    bool exchange_counts(const Mail* out, Mail* in) noexcept override {
        in->begin[0] = 0;
        return place_.meet(self_, out, [&](PartId p, const void* theirs) {
            const auto& begin = static_cast<const Mail*>(theirs)->begin;
            in->begin[p + 1] = in->begin[p] + (begin[self_ + 1] - begin[self_]);
        });
    }
    bool exchange_records(std::size_t record_size, const Mail* out, Mail* in) noexcept override {
        return place_.meet(self_, out, [&](PartId p, const void* theirs) {
            const auto& mail = *static_cast<const Mail*>(theirs);
            const std::size_t count = in->begin[p + 1] - in->begin[p];
            if (count > 0)
                std::memcpy(in->bytes.data() + in->begin[p] * record_size,
                            mail.bytes.data() + mail.begin[self_] * record_size,
                            count * record_size);
        });
    }

  private:
    template <class T, class Operation>
    bool combine(T* numbers, std::size_t n, const Operation& operation) {
        const std::vector<T> mine(numbers, numbers + n);
        return place_.meet(self_, mine.data(), [&](PartId p, const void* theirs) {
            if (p == self_) return;
            for (std::size_t i = 0; i < n; ++i)
                numbers[i] = operation(numbers[i], static_cast<const T*>(theirs)[i]);
        });
    }

    MeetingPlace& place_;
    PartId self_;
};

}  // namespace mgdt
