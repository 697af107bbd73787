// SPDX-License-Identifier: MIT
// Ctrl-C and similar signals. The first signal asks for an orderly end: the library is cancelled,
// and loops that call check_interrupt() throw. If the program has not ended a tenth of a second
// later, or if a second signal arrives, its temporary files are removed and it ends at once,
// whatever it is doing.
#pragma once

#include <string>

#include "mgdt/mgdt.h"

namespace mgdt::cli {

// Handles SIGINT, SIGTERM and SIGHUP, and ignores SIGPIPE and SIGXFSZ, so that closed pipes and
// limits of file sizes become errors of write(). A program that has to agree with others on how to
// end is patient: it ends at once only at the second signal, and without a message.
void install_signal_handlers(bool patient = false);

// The signal that has arrived, or 0.
int interrupt_signal() noexcept;

// Throws Error (exit code 128 + signal) if a signal has arrived.
void check_interrupt();

// From this call on, signals are ignored: the output gets its final names.
void begin_commit() noexcept;

// While an object of this class exists, a signal cancels the running call on its handle.
class Cancellable {
  public:
    explicit Cancellable(mgdt_triangulation* t) noexcept;
    ~Cancellable();
    Cancellable(const Cancellable&) = delete;
    Cancellable& operator=(const Cancellable&) = delete;
};

struct RegisteredName;

// The name of a file that is removed if a signal ends the program.
class TemporaryName {
  public:
    explicit TemporaryName(const std::string& path);
    ~TemporaryName();
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;

  private:
    RegisteredName* entry_;
};

}  // namespace mgdt::cli
