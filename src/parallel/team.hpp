// SPDX-License-Identifier: MIT
// A team of threads that lives as long as one call of the library. The calling thread is its first
// member; the others are joined before the call returns. So no thread remains when the host forks
// or unloads the library.
#pragma once

#include <cstddef>

#include "platform/function_ref.hpp"
#include "platform/memory.hpp"

namespace mgdt {

class Team {
  public:
    // The size of the largest team. The owner of a block is stored as one byte.
    static constexpr unsigned most = 254;

    // A team of `size` members, or of fewer if the system refuses threads. A team of one has no
    // overhead.
    explicit Team(unsigned size = 1) {
        if (size > 1) assemble(size);
    }
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;
    ~Team() {
        if (crew_) dismiss();
    }

    unsigned size() const noexcept { return size_; }

    // Runs body(member) on the first `members` members, member 0 on the calling thread, and waits
    // for all of them. If members throw, the exception of the member with the lowest number is
    // thrown here.
    template <class Body>
    void run(unsigned members, Body&& body) {
        if (members <= 1 || size_ == 1)
            body(0u);
        else
            start(members < size_ ? members : size_, FunctionRef<void(unsigned)>(body));
    }

    // The number of threads, 1 to `limit`, for `work` items, if each should have at least
    // `min_items_per_thread`.
    static unsigned threads_for(std::size_t work, std::size_t min_items_per_thread,
                                unsigned limit) noexcept {
        const std::size_t wanted = work / min_items_per_thread;
        return wanted >= limit ? limit : wanted > 1 ? static_cast<unsigned>(wanted) : 1;
    }
    // The number of members of this team for `work` items.
    unsigned members_for(std::size_t work, std::size_t min_items_per_thread) const noexcept {
        return threads_for(work, min_items_per_thread, size_);
    }

    // Divides 0..n-1 into consecutive ranges of about equal size, and runs body(begin, end, member)
    // on each. Each range has at least `min_items_per_thread` items, or the calling thread runs
    // all.
    template <class Body>
    void split(std::size_t n, std::size_t min_items_per_thread, Body&& body) {
        const unsigned members = members_for(n, min_items_per_thread);
        run(members, [&](unsigned member) {
            body(part(n, member, members), part(n, member + 1, members), member);
        });
    }
    static std::size_t part(std::size_t n, unsigned member, unsigned members) noexcept {
        return n / members * member + n % members * member / members;
    }

  private:
    // The threads of the other members, and the shared state.
    struct Crew;
    void assemble(unsigned size);
    void dismiss() noexcept;
    void start(unsigned members, FunctionRef<void(unsigned)> body);

    Crew* crew_ = nullptr;
    unsigned size_ = 1;
};

}  // namespace mgdt
