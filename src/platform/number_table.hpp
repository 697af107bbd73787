// SPDX-License-Identifier: MIT
// A hash table that gives numbers to items.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "platform/memory.hpp"
#include "platform/no_index.hpp"

namespace mgdt {

// Gives items the numbers 0, 1, 2, ... in the order in which they come. The items are stored
// elsewhere; the table knows the 32-bit hashes of their keys (hash.hpp). It is open-addressed with
// linear probing, so different keys should differ in the lowest bits of their hashes. To empty the
// table, clear() raises `first_`, the least number of an entry in use, and writes no entries,
// unless the table must grow or the numbers run out.
class NumberTable {
  public:
    explicit NumberTable(Allocator& allocator) : entries_(allocator) {}

    // Empties the table and makes room for `count` items. Throws std::bad_alloc.
    void clear(std::size_t count) {
        if (first_ + size_ > most_numbers || capacity() < count) {
            std::size_t entries = std::max<std::size_t>(entries_.size(), least_entries);
            while (entries / 2 < count) entries *= 2;
            entries_.set_capacity(entries);
            entries_.resize(0);
            entries_.resize(entries, Entry{0, 0});
            first_ = 1;
        } else {
            first_ += size_;
        }
        size_ = 0;
    }
    // Gives the memory back.
    void reset() noexcept {
        entries_.reset();
        first_ = 1;
        size_ = 0;
    }
    // The number of items that the table has room for, which is half of its entries. In a table
    // with fewer items than that, probe sequences are shorter.
    std::size_t capacity() const noexcept { return entries_.size() / 2; }
    std::uint32_t size() const noexcept { return size_; }
    // Makes room for `count` items. Throws std::bad_alloc with nothing changed.
    void reserve(std::size_t count) {
        if (MGDT_UNLIKELY(count > capacity())) grow(count);
    }

    // Returns the number of the item with a key. is_same(i) says whether item i has that key; the
    // table calls is_same() only for items with the same hash. If there is no such item, a new item
    // gets the number size(), for which the table must have room. Throws only what is_same()
    // throws, with nothing changed.
    template <class IsSame>
    MGDT_ALWAYS_INLINE std::uint32_t number(std::uint32_t hash, IsSame is_same) noexcept(
        noexcept(is_same(std::uint32_t{}))) {
        assert(size_ < capacity() && "there is no room for one more item");
        const std::uint32_t mask = mask_of(entries_);
        for (std::uint32_t at = hash & mask;; at = (at + 1) & mask) {
            Entry& entry = entries_[at];
            if (entry.number < first_) {
                entry = {hash, first_ + size_};
                return size_++;
            }
            if (entry.hash == hash && is_same(entry.number - first_)) return entry.number - first_;
        }
    }
    // The number of the item with a key, or no_index.
    template <class IsSame>
    std::uint32_t find(std::uint32_t hash, IsSame is_same) const
        noexcept(noexcept(is_same(std::uint32_t{}))) {
        assert(!entries_.empty() && "a table without entries is asked");
        const std::uint32_t mask = mask_of(entries_);
        for (std::uint32_t at = hash & mask;; at = (at + 1) & mask) {
            const Entry& entry = entries_[at];
            if (entry.number < first_) return no_index;
            if (entry.hash == hash && is_same(entry.number - first_)) return entry.number - first_;
        }
    }
    // Returns a function that gives the number of a key, or no_index. The keys are the hashes. The
    // function has copies of the members of this object that it needs, so that a loop that writes
    // to memory need not read the members again.
    MGDT_ALWAYS_INLINE auto lookup() const noexcept {
        assert(!entries_.empty() && "a table without entries is asked");
        return [entries = entries_.data(), mask = mask_of(entries_),
                first = first_](std::uint32_t key) {
            for (std::uint32_t at = key & mask;; at = (at + 1) & mask) {
                const Entry& entry = entries[at];
                if (entry.number < first) return no_index;
                if (entry.hash == key) return entry.number - first;
            }
        };
    }

  private:
    struct Entry {
        // `number` is the item's number plus first_, or less than first_ if the entry is free.
        std::uint32_t hash, number;
    };
    static constexpr std::size_t least_entries = 16;
    static constexpr std::uint32_t most_numbers = 0x80000000u;

    static std::uint32_t mask_of(const Buffer<Entry>& entries) noexcept {
        return static_cast<std::uint32_t>(entries.size() - 1);
    }
    MGDT_NOT_INLINE void grow(std::size_t count) {
        std::size_t size = std::max<std::size_t>(entries_.size(), least_entries);
        while (size / 2 < count) size *= 2;
        Buffer<Entry> larger(entries_.allocator());
        larger.resize(size, Entry{0, 0});
        for (const Entry& entry : entries_) {
            if (entry.number < first_) continue;
            std::uint32_t at = entry.hash & mask_of(larger);
            while (larger[at].number != 0) at = (at + 1) & mask_of(larger);
            larger[at] = entry;
        }
        std::swap(entries_, larger);
    }

    Buffer<Entry> entries_;
    std::uint32_t first_ = 1, size_ = 0;
};

}  // namespace mgdt
