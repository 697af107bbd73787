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

// A failure with a message for the user, which says what went wrong, where, and what to do about
// it.
class Error : public std::runtime_error {
  public:
    Error(int code, const std::string& message) : std::runtime_error(message), code_(code) {}
    int code() const noexcept { return code_; }

  private:
    int code_;
};

// What a failed call of the library means for the program.
struct Failure {
    mgdt_status status;
    ExitCode code;
    const char* advice;  // follows the message
};
// The meaning of a status, or null if the status is not in mgdt.h.
const Failure* find_failure(mgdt_status status);
// The error for a failed call of the library. `what` says where and why.
Error failure_of(mgdt_status status, const std::string& what);

// Returns the exit code of the exception that is being handled, and prints its message to `out`
// unless `out` is null.
int report_exception(std::FILE* out) noexcept;

// A printable form of text that is not the program's own, such as the name of a file. Control
// characters, directional marks and bytes that are not UTF-8 become \xNN. Applying it twice changes
// nothing more.
std::string printable(std::string_view text);

// A short, printable quotation of text from a file.
std::string quote(std::string_view text);

// The text of an errno value.
std::string system_message(int error);

}  // namespace mgdt::cli
