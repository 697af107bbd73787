// SPDX-License-Identifier: MIT
// Exit codes of the program and the exceptions that carry them to main().
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mgdt/mgdt.h"

namespace mgdt::cli {

enum ExitCode : int {
    exit_ok = 0,
    exit_check_failed = 1,
    exit_usage = 2,
    exit_input = 3,
    exit_output = 4,
    exit_memory = 5,
    exit_internal = 6,
    exit_no_tetrahedra = 7,
    exit_signal = 128  // plus the signal's number
};

// A failure with a message for the user: what, where and what to do about it.
class Error : public std::runtime_error {
  public:
    Error(int code, const std::string& message) : std::runtime_error(message), code_(code) {}
    int code() const noexcept { return code_; }

  private:
    int code_;
};

// What a failed call of the library is to the user. `what` says where and why.
Error failure_of(mgdt_status status, const std::string& what);

// The exit code of the exception that is being handled. Its message goes to `out`, unless that is
// null.
int report_exception(std::FILE* out) noexcept;

// Text that is not the program's own, such as the name of a file, as it may be shown in a message:
// control characters, marks of direction and what is no UTF-8 as \xNN. Applied again it changes
// nothing.
std::string printable(std::string_view text);

// Text of a file as it may be shown in a message: printable, and short.
std::string quote(std::string_view text);

// Text of an errno value.
std::string system_message(int error);

}  // namespace mgdt::cli
