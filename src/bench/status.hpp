// SPDX-License-Identifier: MIT
// How a child reports the outcome of its work, and the word for the outcome in the table.
#pragma once

#include <functional>
#include <string>

#include "bench/child.hpp"

namespace mgdt::cli::bench {

// Does the work of a child, which calls this function, and returns the exit code. If the work
// fails, writes a line to `out` that says why.
int guarded(int out, const std::function<void()>& work);

// The status for the table: "ok", "out-of-memory", "timeout", "signal 11", or "error:" and the last
// line that the child wrote. Empty if the child was stopped because this program got a signal.
std::string status_of(const ChildEnd& end);

// Sends a line through the pipe.
void send(int out, std::string line);

}  // namespace mgdt::cli::bench
