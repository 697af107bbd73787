// SPDX-License-Identifier: MIT
#include "cli/progress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "cli/interrupt.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {

using std::chrono::duration;
using std::chrono::steady_clock;

Progress::Progress(std::string what, bool quiet)
    : what_(std::move(what)),
      shown_(!quiet && system::is_terminal(system::standard_error)),
      begin_(steady_clock::now()),
      last_(begin_) {}

Progress::~Progress() {
    // Erases the line, so that only the result remains on the terminal.
    if (drawn_) std::fputs("\r\x1b[K", stderr);
}

void Progress::update(double fraction) {
    if (!shown_) return;
    const auto now = steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(50)) return;
    last_ = now;
    constexpr int width = 30;
    const double f = std::clamp(fraction, 0.0, 1.0);
    const int full = static_cast<int>(f * width);
    const double seconds = duration<double>(now - begin_).count();
    std::string line =
        fmt::format("\r{} [{:=<{}}{: <{}}] {:3.0f}%", what_, "", full, "", width - full, 100 * f);
    if (f > 0.05) line += fmt::format(", {:.0f} s left", seconds * (1 - f) / f);
    line += "\x1b[K";
    std::fputs(line.c_str(), stderr);
    std::fflush(stderr);
    drawn_ = true;
}

bool Progress::update_and_hear(double fraction) {
    update(fraction);
    return interrupt_signal() != 0;
}

}  // namespace mgdt::cli
