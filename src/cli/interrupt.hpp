// SPDX-License-Identifier: MIT
// Ctrl-C and its kin. The first signal asks for an orderly end: the library is cancelled, and
// loops that call check_interrupt() throw. Where that has not ended the program a tenth of a second
// later, or when a second signal comes, its temporary files are removed and the program leaves at
// once, whatever it is doing.
#pragma once

#include <string>

#include "mgdt/mgdt.h"

namespace mgdt::cli {

// Handles SIGINT, SIGTERM and SIGHUP; ignores SIGPIPE and SIGXFSZ, so that a closed pipe and the
// limit on file sizes come back as errors of write(). A program that is one of several, which have
// to agree on how they end, is patient: it leaves at once when a second signal comes, and silently.
void install_signal_handlers(bool patient = false);

// The signal that has come, or 0.
int interrupt_signal() noexcept;

// Throws Error (exit code 128 + signal) once a signal has come.
void check_interrupt();

// From here on signals are too late: the output gets its names.
void begin_commit() noexcept;

// While it exists, signals cancel the handle.
class Cancellable {
  public:
    explicit Cancellable(mgdt_triangulation* t) noexcept;
    ~Cancellable();
    Cancellable(const Cancellable&) = delete;
    Cancellable& operator=(const Cancellable&) = delete;
};

struct RegisteredName;

// A file that must not outlive the program.
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
