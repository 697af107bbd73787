// SPDX-License-Identifier: MIT
// Numbers of vertices or tetrahedra in a small part of a mesh.
#pragma once

#include "platform/memory.hpp"

namespace mgdt {

// Numbers 0, 1, ... for names in the order in which they come.
class Numbers {
  public:
    explicit Numbers(Allocator& allocator) : names_(allocator), table_(allocator) {}

    // Of a name that may be new: then the number is the size before.
    MGDT_ALWAYS_INLINE std::uint32_t number(std::uint32_t name) {
        std::uint32_t at = name & mask_;
        for (;; at = (at + 1) & mask_) {
            const Entry& entry = table_[at];
            if (entry.number < first_) break;
            if (entry.name == name) return entry.number - first_;
        }
        const std::uint32_t number = size_;
        if (MGDT_UNLIKELY(4 * std::size_t{number} >= table_.size()))
            return insert_into_larger(name);
        table_[at] = {name, first_ + number};
        names_[number] = name;
        ++size_;
        return number;
    }
    // A function that gives the number of a name, or `none` if it has not come. It holds all that
    // it looks at, so that a loop that writes need not read this object again.
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    MGDT_ALWAYS_INLINE auto lookup() const {
        return [table = table_.data(), mask = mask_, first = first_](std::uint32_t name) {
            for (std::uint32_t at = name & mask;; at = (at + 1) & mask) {
                const Entry& entry = table[at];
                if (entry.number < first) return none;
                if (entry.name == name) return entry.number - first;
            }
        };
    }
    void clear();
    std::uint32_t size() const noexcept { return size_; }
    MGDT_ALWAYS_INLINE std::uint32_t name(std::uint32_t number) const noexcept {
        return names_[number];
    }

  private:
    std::uint32_t insert_into_larger(std::uint32_t name);

    // Open-addressed. Those of earlier names have lesser numbers than any that counts.
    struct Entry {
        std::uint32_t name, number;
    };
    Buffer<std::uint32_t> names_;
    Buffer<Entry> table_;
    std::uint32_t first_ = 1, size_ = 0, mask_ = 0;
};

}  // namespace mgdt
