// SPDX-License-Identifier: MIT
#include "bench/status.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <exception>
#include <new>

#include "bench/row.hpp"
#include "cli/errors.hpp"

namespace mgdt::cli::bench {

int guarded(int out, const std::function<void()>& work) {
    try {
        work();
        return exit_ok;
    } catch (const Error& e) {
        send(out, e.what());
        return e.code();
    } catch (const std::bad_alloc&) {
        return exit_memory;
    } catch (const std::exception& e) {
        send(out, e.what());
        return exit_internal;
    }
}

std::string status_of(const ChildEnd& end) {
    switch (end.how) {
        case ChildEnd::How::interrupted:
            return "";
        case ChildEnd::How::out_of_time:
            return "timeout";
        case ChildEnd::How::killed_by_signal:
            return fmt::format("signal {}", end.code);
        case ChildEnd::How::exited:
            break;
    }
    if (end.code == exit_ok) return "ok";
    if (end.code == exit_memory) return "out-of-memory";
    const std::string what = as_field(end.last_line);
    return "error: " + (what.empty() ? fmt::format("exit code {}", end.code) : what);
}

void send(int out, std::string line) {
    line += '\n';
    // Short lines are written as a whole. If nobody reads the pipe, nothing needs to be reported.
    [[maybe_unused]] const ssize_t wrote = write(out, line.data(), line.size());
}

}  // namespace mgdt::cli::bench
