// SPDX-License-Identifier: MIT
#include "parallel/team.hpp"

#include <new>
#include <system_error>

#include "platform/fp_environment.hpp"

#if defined(__unix__)
#include <pthread.h>
#include <signal.h>
#endif

namespace mgdt {
namespace {

// Threads inherit the mask: signals stay with the host's own threads.
class SignalsBlocked {
  public:
#if defined(__unix__)
    SignalsBlocked() noexcept {
        sigset_t all;
        sigfillset(&all);
        // What the thread itself does wrong is its own affair.
        for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP}) sigdelset(&all, own);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~SignalsBlocked() {
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

  private:
    sigset_t before_;
#endif
};

}  // namespace

Team::Team(unsigned size) {
    if (size > most) size = most;
    if (size <= 1) return;
    threads_ = new (std::nothrow) std::thread[size - 1];
    if (!threads_) return;
    const SignalsBlocked blocked;
    try {
        for (unsigned member = 1; member < size; ++member) {
            threads_[member - 1] = std::thread([this, member] { work(member); });
            ++size_;
        }
    } catch (const std::system_error&) {
        // The system has no more: fewer will do.
    } catch (const std::bad_alloc&) {
    }
}

Team::~Team() {
    if (!threads_) return;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        is_over_ = true;
    }
    begin_.notify_all();
    for (unsigned member = 1; member < size_; ++member) threads_[member - 1].join();
    delete[] threads_;
}

void Team::start(unsigned members, FunctionRef<void(unsigned)> body) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        body_ = &body;
        members_ = members;
        busy_ = members - 1;
        ++turn_;
    }
    begin_.notify_all();
    perform(0);
    std::unique_lock<std::mutex> lock(mutex_);
    end_.wait(lock, [&] { return busy_ == 0; });
    body_ = nullptr;
    failed_ = most;
    if (failure_) {
        const std::exception_ptr failure = failure_;
        failure_ = nullptr;
        std::rethrow_exception(failure);
    }
}

void Team::work(unsigned member) noexcept {
    const FpEnvironment environment;
    unsigned long long seen = 0;
    for (;;) {
        {
            std::unique_lock<std::mutex> lock(mutex_);
            begin_.wait(lock, [&] { return is_over_ || turn_ != seen; });
            if (is_over_) return;
            seen = turn_;
            if (member >= members_) continue;
        }
        perform(member);
        const std::lock_guard<std::mutex> lock(mutex_);
        if (--busy_ == 0) end_.notify_one();
    }
}

void Team::perform(unsigned member) noexcept {
    try {
        (*body_)(member);
    } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (member < failed_) {
            failed_ = member;
            failure_ = std::current_exception();
        }
    }
}

}  // namespace mgdt
