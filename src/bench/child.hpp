// SPDX-License-Identifier: MIT
// A piece of work in a process of its own: its memory is measured by itself, and whatever becomes
// of it, the program goes on.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace mgdt::cli::bench {

struct ChildEnd {
    enum class How { exited, killed_by_signal, out_of_time, interrupted };
    How how = How::exited;
    int code = 0;  // of its exit, or the signal's number
    std::string last_line;
    std::int64_t peak_rss_bytes = 0;
};

// Runs `body` in a child, in a process group of its own. `out` is a pipe to this process; what
// the body returns is the exit code. `on_line` gets each line that comes through the pipe, and an
// empty one every tenth of a second in which none comes. A child that takes longer than
// `seconds` is killed (0: no limit), and so it is when a signal asks this program to end, or when
// this program dies. Throws Error if there can be no child.
ChildEnd run_in_child(const std::function<int(int out)>& body, double seconds,
                      const std::function<void(const std::string& line)>& on_line);

}  // namespace mgdt::cli::bench
