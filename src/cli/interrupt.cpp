// SPDX-License-Identifier: MIT
#include "cli/interrupt.hpp"

#include <atomic>
#include <cstring>

#include "cli/errors.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {
namespace {

std::atomic<int> received{0};
std::atomic<mgdt_triangulation*> cancellable{nullptr};

// Fixed storage, because a signal handler can neither allocate nor lock.
constexpr int slots = 8;
constexpr std::size_t longest_path = 4096;
char paths[slots][longest_path];
std::atomic<bool> used[slots];

extern "C" void on_signal(int signal) {
    if (received.exchange(signal) != 0) {
        for (int i = 0; i < slots; ++i) {
            if (used[i].load()) system::remove(paths[i]);
        }
        system::leave(exit_signal + signal);
    }
    if (mgdt_triangulation* t = cancellable.load()) mgdt_cancel(t);
}

}  // namespace

void install_signal_handlers() {
    system::handle_signals(on_signal);
}

int interrupt_signal() noexcept {
    return received.load(std::memory_order_relaxed);
}

void check_interrupt() {
    if (const int signal = interrupt_signal()) {
        throw Error(exit_signal + signal, "cancelled; nothing was written");
    }
}

void set_cancellable(mgdt_triangulation* t) noexcept {
    cancellable.store(t);
}

TemporaryName::TemporaryName(const std::string& path) {
    if (path.size() >= longest_path) return;
    for (int i = 0; i < slots; ++i) {
        if (used[i].load()) continue;
        std::memcpy(paths[i], path.c_str(), path.size() + 1);
        used[i].store(true);
        slot_ = i;
        return;
    }
}

TemporaryName::~TemporaryName() {
    if (slot_ >= 0) used[slot_].store(false);
}

}  // namespace mgdt::cli
