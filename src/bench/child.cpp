// SPDX-License-Identifier: MIT
#include "bench/child.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <chrono>
#include <cstdio>

#include "cli/errors.hpp"
#include "cli/interrupt.hpp"

namespace mgdt::cli::bench {
namespace {

using std::chrono::steady_clock;

[[noreturn]] void fail(const char* what, int error) {
    throw Error(exit_memory, fmt::format("cannot {}: {}", what, system_message(error)));
}

// Makes the child, which calls this function, end with its parent, and makes the child the first
// process that the system ends when memory runs out.
void prepare_child([[maybe_unused]] pid_t parent) {
    setpgid(0, 0);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(exit_internal);
    if (std::FILE* f = std::fopen("/proc/self/oom_score_adj", "w")) {
        std::fputs("1000", f);
        std::fclose(f);
    }
#endif
}

// The reading end of the pipe, and the lines that have arrived.
class Lines {
  public:
    explicit Lines(int fd) : fd_(fd) { fcntl(fd_, F_SETFL, O_NONBLOCK); }
    ~Lines() { close(fd_); }
    Lines(const Lines&) = delete;
    Lines& operator=(const Lines&) = delete;

    // Waits until something arrives, for at most a tenth of a second.
    void wait() const {
        // A pipe that has ended is always ready, which would make this a busy loop.
        pollfd entry{fd_, POLLIN, 0};
        poll(&entry, ended_ ? 0 : 1, ended_ ? 5 : 100);
    }

    // Reads what has arrived. Returns false if nothing has.
    bool read(const std::function<void(const std::string&)>& on_line) {
        char buffer[4096];
        bool any = false;
        for (;;) {
            const ssize_t got = ::read(fd_, buffer, sizeof buffer);
            if (got < 0 && errno == EINTR) continue;
            if (got == 0) ended_ = true;
            if (got <= 0) return any;
            any = true;
            for (const char c : std::string_view(buffer, static_cast<std::size_t>(got))) {
                if (c == '\n') {
                    finish(on_line);
                } else if (line_.size() < longest) {
                    line_ += c;
                }
            }
        }
    }

    // The last line that is not empty, even if its end has not arrived.
    std::string last() {
        finish([](const std::string&) {});
        return last_;
    }

  private:
    void finish(const std::function<void(const std::string&)>& on_line) {
        if (!line_.empty()) {
            on_line(line_);
            last_ = std::move(line_);
        }
        line_.clear();
    }

    static constexpr std::size_t longest = 4096;
    int fd_;
    bool ended_ = false;
    std::string line_, last_;
};

std::int64_t peak_memory(const rusage& usage) {
#ifdef __APPLE__
    return usage.ru_maxrss;
#else
    return std::int64_t{1024} * usage.ru_maxrss;
#endif
}

}  // namespace

ChildEnd run_in_child(const std::function<int(int out)>& body, double seconds,
                      const std::function<void(const std::string& line)>& on_line) {
    int ends[2];
    if (pipe(ends) != 0) fail("make a pipe", errno);
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child < 0) {
        const int error = errno;
        close(ends[0]);
        close(ends[1]);
        fail("start a process", error);
    }
    if (child == 0) {
        close(ends[0]);
        prepare_child(parent);
        _exit(body(ends[1]));  // not exit(): buffers and destructors belong to the parent
    }
    setpgid(child, child);  // both processes do this, so that it is done whichever runs first
    close(ends[1]);
    Lines lines(ends[0]);

    const auto begin = steady_clock::now();
    ChildEnd end;
    for (;;) {
        int status = 0;
        rusage usage = {};
        const pid_t done = wait4(child, &status, WNOHANG, &usage);
        if (done == child) {
            lines.read(on_line);
            kill(-child, SIGKILL);  // processes that the child may have left behind
            end.last_line = lines.last();
            end.peak_rss_bytes = peak_memory(usage);
            if (end.how != ChildEnd::How::exited) return end;
            end.how = WIFSIGNALED(status) ? ChildEnd::How::killed_by_signal : ChildEnd::How::exited;
            end.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
            return end;
        }
        const std::chrono::duration<double> elapsed = steady_clock::now() - begin;
        if (interrupt_signal() != 0) {
            end.how = ChildEnd::How::interrupted;
        } else if (seconds > 0 && elapsed.count() > seconds) {
            end.how = ChildEnd::How::out_of_time;
        }
        if (end.how != ChildEnd::How::exited) kill(-child, SIGKILL);
        lines.wait();
        if (!lines.read(on_line)) on_line("");
    }
}

}  // namespace mgdt::cli::bench
