// SPDX-License-Identifier: MIT
// Runs work in a process of its own: its memory is measured separately, and the program continues
// if it fails.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace mgdt::cli::bench {

struct ChildEnd {
    enum class How { exited, killed_by_signal, out_of_time, interrupted };
    How how = How::exited;
    int code = 0;  // the exit code, or the number of the signal
    std::string last_line;
    std::int64_t peak_rss_bytes = 0;
};

// Runs `body` in a child process with a process group of its own. `out` is a pipe to this process;
// the result of the body is the exit code. `on_line` is called with each line that arrives through
// the pipe, and with an empty one after every tenth of a second without a line. The child is killed
// if it takes longer than `seconds` (0: no limit), if a signal asks this program to end, or if this
// program ends. Throws Error if there can be no child.
ChildEnd run_in_child(const std::function<int(int out)>& body, double seconds,
                      const std::function<void(const std::string& line)>& on_line);

}  // namespace mgdt::cli::bench
