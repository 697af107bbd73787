// SPDX-License-Identifier: MIT
#include "parallel/team.hpp"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>

#include "platform/cancellation.hpp"
#include "platform/fp_environment.hpp"

#if defined(__unix__)
#include <pthread.h>
#include <signal.h>
#endif

namespace mgdt {
namespace {

// Blocks signals while threads are created. The new threads inherit the mask, so signals go to the
// host's threads.
class SignalsBlocked {
  public:
#if defined(__unix__)
    SignalsBlocked() noexcept {
        sigset_t all;
        sigfillset(&all);
        // Signals that a faulty instruction raises stay unblocked: the thread itself handles them.
        for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP}) sigdelset(&all, own);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~SignalsBlocked() {
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }

  private:
    sigset_t before_;
#else
    SignalsBlocked() noexcept {}
    ~SignalsBlocked() {}
#endif
};

}  // namespace

struct Team::Crew {
    void work(unsigned member) noexcept;
    void perform(unsigned member) noexcept;

    std::thread threads[most - 1];

    std::mutex mutex;
    std::condition_variable begin, end;
    const FunctionRef<void(unsigned)>* body = nullptr;
    unsigned long long turn = 0;  // counts the calls of start()
    unsigned members = 0;         // the number of members that take part in this turn
    unsigned busy = 0;            // how many of these have not finished, without member 0
    bool is_over = false;
    std::exception_ptr failure;
    unsigned failed = most;  // the member that threw `failure`
};

void Team::assemble(unsigned size) {
    if (size > most) size = most;
    crew_ = new (std::nothrow) Crew;
    if (!crew_) return;
    const SignalsBlocked blocked;
    try {
        for (unsigned member = 1; member < size; ++member) {
            crew_->threads[member - 1] =
                std::thread([crew = crew_, member] { crew->work(member); });
            ++size_;
        }
    } catch (const std::system_error&) {
        // The system refuses more threads: go on with fewer.
    } catch (const std::bad_alloc&) {
    }
}

void Team::dismiss() noexcept {
    {
        const std::lock_guard<std::mutex> lock(crew_->mutex);
        crew_->is_over = true;
    }
    crew_->begin.notify_all();
    for (unsigned member = 1; member < size_; ++member) crew_->threads[member - 1].join();
    delete crew_;
}

void Team::start(unsigned members, FunctionRef<void(unsigned)> body) {
    Crew& c = *crew_;
    {
        const std::lock_guard<std::mutex> lock(c.mutex);
        c.body = &body;
        c.members = members;
        c.busy = members - 1;
        ++c.turn;
    }
    c.begin.notify_all();
    c.perform(0);
    std::unique_lock<std::mutex> lock(c.mutex);
    c.end.wait(lock, [&] { return c.busy == 0; });
    c.body = nullptr;
    c.failed = most;
    if (c.failure) {
        const std::exception_ptr failure = c.failure;
        c.failure = nullptr;
        std::rethrow_exception(failure);
    }
}

void Team::Crew::work(unsigned member) noexcept {
    // A callback may give this thread's id to another thread, which could cancel this thread.
    CancellationDisabled::for_good();
    const FpEnvironment environment;
    unsigned long long seen = 0;
    for (;;) {
        {
            std::unique_lock<std::mutex> lock(mutex);
            begin.wait(lock, [&] { return is_over || turn != seen; });
            if (is_over) return;
            seen = turn;
            if (member >= members) continue;
        }
        perform(member);
        const std::lock_guard<std::mutex> lock(mutex);
        if (--busy == 0) end.notify_one();
    }
}

void Team::Crew::perform(unsigned member) noexcept {
    try {
        (*body)(member);
    } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex);
        if (member < failed) {
            failed = member;
            failure = std::current_exception();
        }
    }
}

}  // namespace mgdt
