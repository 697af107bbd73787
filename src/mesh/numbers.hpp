// SPDX-License-Identifier: MIT
// Consecutive numbers for the vertices or tetrahedra of a small part of a mesh.
#pragma once

#include <cassert>

#include "platform/number_table.hpp"

namespace mgdt {

// Gives names the numbers 0, 1, 2, ... in the order in which the names first appear.
class Numbers {
  public:
    explicit Numbers(Allocator& allocator) : names_(allocator), table_(allocator) {}

    // The number of a name. A new name gets the next number, which is size() before the call.
    MGDT_ALWAYS_INLINE std::uint32_t number(std::uint32_t name) {
        assert(name != no_index && "a name that nothing has");
        if (MGDT_UNLIKELY(table_.size() == names_.size())) make_room();
        const std::uint32_t number = table_.number(name, [](std::uint32_t) { return true; });
        names_[number] = name;
        return number;
    }
    // A function that gives the number of a name, or `no_index` for a name that has no number.
    MGDT_ALWAYS_INLINE auto lookup() const { return table_.lookup(); }
    void clear() { table_.clear(2 * names_.size()); }
    std::uint32_t size() const noexcept { return table_.size(); }
    MGDT_ALWAYS_INLINE std::uint32_t name(std::uint32_t number) const noexcept {
        assert(number < size() && "no name has this number");
        return names_[number];
    }

  private:
    MGDT_NOT_INLINE void make_room() {
        const std::size_t most = std::max<std::size_t>(2 * names_.size(), 64);
        names_.set_capacity(most);
        names_.resize(most);
        table_.reserve(2 * most);
    }

    Buffer<std::uint32_t> names_;  // by number; the buffer's size is the number of names that fit
    NumberTable table_;
};

}  // namespace mgdt
