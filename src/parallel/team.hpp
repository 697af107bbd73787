// SPDX-License-Identifier: MIT
// A team of threads that lives as long as one call of the library: the calling thread is its first
// member, the others are joined before the call returns, so nothing is left running for a host
// that forks, unloads the library or has its own threads.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>

#include "platform/memory.hpp"

namespace mgdt {

// Stands for callables of one kind without owning or allocating anything.
template <class Signature>
class FunctionRef;
template <class... Arguments>
class FunctionRef<void(Arguments...)> {
  public:
    template <class F>
    FunctionRef(F& f) noexcept  // NOLINT: meant to convert
        : object_(&f), call_([](void* object, Arguments... arguments) {
              (*static_cast<F*>(object))(arguments...);
          }) {}
    void operator()(Arguments... arguments) const { call_(object_, arguments...); }

  private:
    void* object_;
    void (*call_)(void*, Arguments...);
};

class Team {
  public:
    // The most members that a team has: owners of blocks are numbered in a byte.
    static constexpr unsigned most = 254;

    // Of `size` members, or of as many as the system has threads for; with a size of 1 it is free.
    explicit Team(unsigned size = 1);
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;
    ~Team();

    unsigned size() const noexcept { return size_; }

    // Runs body(member) on the first `members` members, 0 on the calling thread, and waits for all
    // of them. What the first of them threw, if any did, is thrown here.
    template <class Body>
    void run(unsigned members, Body&& body) {
        if (members <= 1 || size_ == 1)
            body(0u);
        else
            start(members < size_ ? members : size_, FunctionRef<void(unsigned)>(body));
    }

    // How many members it takes for `work` of which one should have `share` at least.
    unsigned members_for(std::size_t work, std::size_t share) const noexcept {
        const std::size_t wanted = work / share;
        return wanted >= size_ ? size_ : wanted > 1 ? static_cast<unsigned>(wanted) : 1;
    }

    // Runs body(begin, end, member) on ranges that divide 0..n-1 evenly and ascend with the member;
    // all of it on the calling thread if there is less than `share` for each.
    template <class Body>
    void split(std::size_t n, std::size_t share, Body&& body) {
        const unsigned members = members_for(n, share);
        run(members, [&](unsigned member) {
            body(part(n, member, members), part(n, member + 1, members), member);
        });
    }
    static std::size_t part(std::size_t n, unsigned member, unsigned members) noexcept {
        return n / members * member + n % members * member / members;
    }

  private:
    void start(unsigned members, FunctionRef<void(unsigned)> body);
    void work(unsigned member) noexcept;
    void perform(unsigned member) noexcept;

    std::thread* threads_ = nullptr;
    unsigned size_ = 1;

    std::mutex mutex_;
    std::condition_variable begin_, end_;
    const FunctionRef<void(unsigned)>* body_ = nullptr;
    unsigned long long turn_ = 0;  // counts the calls of start()
    unsigned members_ = 0;         // of this turn
    unsigned busy_ = 0;            // members that have not finished, but for the calling thread
    bool is_over_ = false;
    std::exception_ptr failure_;
    unsigned failed_ = most;  // member whose failure that is
};

}  // namespace mgdt
