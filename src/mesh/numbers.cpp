// SPDX-License-Identifier: MIT
#include "mesh/numbers.hpp"

namespace mgdt {

void Numbers::clear() {
    constexpr std::size_t least = 256;
    if (table_.empty()) {
        table_.resize(least, Entry{0, 0});
        names_.resize(least / 4);
        mask_ = least - 1;
    }
    // Numbers have 32 bits, and a link has fewer than 2^30 members.
    if (first_ + size_ > 0x80000000u) {
        table_.resize(0);
        table_.resize(std::size_t{mask_} + 1, Entry{0, 0});
        first_ = 1;
    } else {
        first_ += size_;
    }
    size_ = 0;
}

std::uint32_t Numbers::insert_into_larger(std::uint32_t name) {
    const std::size_t size = 2 * table_.size();
    names_.set_capacity(size / 4);
    table_.set_capacity(size);
    names_.resize(size / 4);
    table_.resize(0);
    table_.resize(size, Entry{0, 0});
    mask_ = static_cast<std::uint32_t>(size - 1);
    const std::uint32_t count = size_;
    size_ = 0;
    for (std::uint32_t i = 0; i < count; ++i) number(names_[i]);
    return number(name);
}

}  // namespace mgdt
