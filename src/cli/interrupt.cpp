// SPDX-License-Identifier: MIT
#include "cli/interrupt.hpp"

#include <atomic>
#include <string>
#include <string_view>

#include "cli/errors.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {
namespace {

constexpr std::string_view message = "cancelled; nothing was written";
constexpr int patience = 100;  // milliseconds

std::atomic<int> received{0};
std::atomic<bool> has_begun_commit{false};
std::atomic<mgdt_triangulation*> cancellable{nullptr};
bool has_terminal = false, is_patient = false;

}  // namespace

// A signal handler can neither allocate nor lock, so names are in a list that only grows.
struct RegisteredName {
    std::string path;
    std::atomic<bool> is_used{false};
    RegisteredName* next = nullptr;
};

namespace {

std::atomic<RegisteredName*> names{nullptr};

void end_at_once() {
    for (const RegisteredName* n = names.load(); n != nullptr; n = n->next) {
        if (n->is_used.load()) system::remove(n->path.c_str());
    }
    if (!is_patient) {
        // Prints the message as main() does, over the progress bar if there is one.
        const auto say = [](std::string_view text) {
            static_cast<void>(system::write(system::standard_error, text.data(), text.size()));
        };
        if (has_terminal) say("\r\x1b[K");
        say("mgdt: ");
        say(message);
        say("\n");
    }
    system::leave(exit_signal + received.load());
}

extern "C" void on_signal(int signal) {
    if (has_begun_commit.load()) return;
    int none = 0;
    if (!received.compare_exchange_strong(none, signal)) end_at_once();
    if (mgdt_triangulation* t = cancellable.load()) mgdt_cancel(t);
    if (!is_patient) system::signal_again_in(patience);
}

}  // namespace

void install_signal_handlers(bool patient) {
    is_patient = patient;
    has_terminal = system::is_terminal(system::standard_error);
    system::handle_signals(on_signal);
}

void begin_commit() noexcept {
    has_begun_commit.store(true);
}

int interrupt_signal() noexcept {
    return received.load(std::memory_order_relaxed);
}

void check_interrupt() {
    if (const int signal = interrupt_signal()) {
        throw Error(exit_signal + signal, std::string(message));
    }
}

Cancellable::Cancellable(mgdt_triangulation* t) noexcept {
    cancellable.store(t);
}

Cancellable::~Cancellable() {
    cancellable.store(nullptr);
}

TemporaryName::TemporaryName(const std::string& path) {
    for (entry_ = names.load(); entry_ != nullptr; entry_ = entry_->next) {
        if (!entry_->is_used.load()) break;
    }
    if (entry_ != nullptr) {
        entry_->path = path;
        entry_->is_used.store(true);
        return;
    }
    entry_ = new RegisteredName;
    entry_->path = path;
    entry_->is_used.store(true);
    entry_->next = names.load();
    names.store(entry_);
}

TemporaryName::~TemporaryName() {
    entry_->is_used.store(false);
}

}  // namespace mgdt::cli
