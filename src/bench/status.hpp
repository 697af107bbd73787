// SPDX-License-Identifier: MIT
// How a child says what became of its work, and the word for it in the table.
#pragma once

#include <functional>
#include <string>

#include "bench/child.hpp"

namespace mgdt::cli::bench {

// In a child: does the work; the exit code, with a line about what went wrong written to `out`.
int guarded(int out, const std::function<void()>& work);

// "ok", "out-of-memory", "timeout", "signal 11", "error: what the last line says". Empty if this
// program is to end.
std::string status_of(const ChildEnd& end);

// Sends a line through the pipe.
void send(int out, std::string line);

}  // namespace mgdt::cli::bench
