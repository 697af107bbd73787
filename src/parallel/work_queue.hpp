// SPDX-License-Identifier: MIT
// A work-stealing queue over a range of items. Each member of a team goes through its own part from
// the beginning; when it is done, it steals from the end of another member's part.
#pragma once

#include <cstdint>

#include "parallel/atomic_array.hpp"
#include "parallel/team.hpp"

namespace mgdt {

class WorkQueue {
  public:
    struct Piece {
        std::size_t begin, end;
        bool is_stolen;  // taken from the end of another part; the next piece comes before this one
    };

    // An empty queue for at most `most_members` members.
    WorkQueue(Allocator& allocator, unsigned most_members)
        : ends_(allocator, std::size_t{stride} * most_members) {}

    // Fills the queue with items 0..n-1 in pieces of `size`. No member may take pieces meanwhile.
    void deal(std::size_t n, std::size_t size, unsigned members) noexcept {
        n_ = n;
        size_ = size;
        members_ = members;
        const std::size_t pieces = (n + size - 1) / size;
        for (unsigned m = 0; m < members; ++m)
            ends(m).store(pack(Team::part(pieces, m, members), Team::part(pieces, m + 1, members)),
                          std::memory_order_relaxed);
    }

    // Takes the next piece for a member. Returns false if there is none. `from` is the member from
    // whose part the last piece came; initially, `from` equals `member`.
    bool next(unsigned member, unsigned& from, Piece& piece) noexcept {
        for (;;) {
            std::size_t k;
            if (from == member ? take_first(member, k) : take_last(from, k)) {
                piece = {k * size_, k * size_ + size_ < n_ ? k * size_ + size_ : n_,
                         from != member};
                return true;
            }
            // Steal from the member with the most pieces left.
            std::size_t most = 0;
            for (unsigned m = 0; m < members_; ++m) {
                const std::size_t left = size_of(ends(m).load(std::memory_order_relaxed));
                if (left > most) {
                    most = left;
                    from = m;
                }
            }
            if (most == 0) return false;
        }
    }

  private:
    // Packs the first piece and the end into one word, so that both change atomically.
    static std::uint64_t pack(std::size_t first, std::size_t end) noexcept {
        return static_cast<std::uint64_t>(first) << 32 | end;
    }
    static std::size_t first_of(std::uint64_t ends) noexcept {
        return static_cast<std::size_t>(ends >> 32);
    }
    static std::size_t end_of(std::uint64_t ends) noexcept { return ends & 0xFFFFFFFFu; }
    static std::size_t size_of(std::uint64_t ends) noexcept {
        return end_of(ends) - first_of(ends);
    }

    bool take_first(unsigned member, std::size_t& k) noexcept {
        Atomic<std::uint64_t>& left = ends(member);
        std::uint64_t now = left.load(std::memory_order_relaxed);
        do {
            if (size_of(now) == 0) return false;
            k = first_of(now);
        } while (
            !left.compare_exchange_weak(now, pack(k + 1, end_of(now)), std::memory_order_relaxed));
        return true;
    }
    bool take_last(unsigned member, std::size_t& k) noexcept {
        Atomic<std::uint64_t>& left = ends(member);
        std::uint64_t now = left.load(std::memory_order_relaxed);
        do {
            if (size_of(now) == 0) return false;
            k = end_of(now) - 1;
        } while (
            !left.compare_exchange_weak(now, pack(first_of(now), k), std::memory_order_relaxed));
        return true;
    }

    // The word of each member is on a cache line of its own.
    static constexpr unsigned stride = 64 / sizeof(std::uint64_t);
    Atomic<std::uint64_t>& ends(unsigned member) noexcept {
        return ends_[std::size_t{stride} * member];
    }

    AtomicArray<std::uint64_t> ends_;
    std::size_t n_ = 0, size_ = 1;
    unsigned members_ = 0;
};

}  // namespace mgdt
