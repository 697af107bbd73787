// SPDX-License-Identifier: MIT
// Ctrl-C and its kin. The first signal asks for an orderly end: the library is cancelled, and
// loops that call check_interrupt() throw. A second one removes temporary files and leaves.
#pragma once

#include <string>

#include "mgdt/mgdt.h"

namespace mgdt::cli {

// Handles SIGINT, SIGTERM and SIGHUP; ignores SIGPIPE and SIGXFSZ, so that a closed pipe and the
// limit on file sizes come back as errors of write().
void install_signal_handlers();

// The signal that has come, or 0.
int interrupt_signal() noexcept;

// Throws Error (exit code 128 + signal) once a signal has come.
void check_interrupt();

// The handle that a signal cancels; nullptr for none.
void set_cancellable(mgdt_triangulation* t) noexcept;

// A file that must not outlive the program.
class TemporaryName {
  public:
    explicit TemporaryName(const std::string& path);
    ~TemporaryName();
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;

  private:
    int slot_ = -1;
};

}  // namespace mgdt::cli
