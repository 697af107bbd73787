// SPDX-License-Identifier: MIT
// A set of numbers in the order of insertion, which serves as the queue of a traversal. Up to 64
// numbers are stored in the object itself.
#pragma once

#include <algorithm>

#include "mesh/tetrahedron.hpp"
#include "platform/memory.hpp"

namespace mgdt {

class VisitQueue {
  public:
    explicit VisitQueue(Allocator& allocator) : more_items_(allocator), more_slots_(allocator) {}
    void clear() {
        items_ = few_items_;
        slots_ = few_slots_;
        size_ = 0;
        bits_ = few_bits;
        std::fill_n(slots_, slot_count(), no_index);
    }
    std::size_t size() const { return size_; }
    std::uint32_t operator[](std::size_t i) const { return items_[i]; }
    // Adds a number. Returns false if it is in already.
    bool push(std::uint32_t item) {
        if (2 * size_ == slot_count()) grow();
        const std::size_t at = slot(item);
        if (slots_[at] == item) return false;
        slots_[at] = item;
        items_[size_++] = item;
        return true;
    }

  private:
    static constexpr unsigned few_bits = 7;  // 64 numbers; a vertex has 27 tetrahedra on average

    std::size_t slot_count() const { return std::size_t{1} << bits_; }
    // Multiplicative hashing: the upper bits of the product depend on all bits of the item.
    std::size_t slot(std::uint32_t item) const {
        std::size_t h = (item * 0x9E3779B1u) >> (32 - bits_);
        while (slots_[h] != no_index && slots_[h] != item) h = (h + 1) & (slot_count() - 1);
        return h;
    }
    void grow() {
        more_items_.resize(2 * slot_count());
        if (items_ == few_items_) std::copy_n(items_, size_, more_items_.data());
        more_slots_.clear();
        more_slots_.resize(4 * slot_count(), no_index);
        items_ = more_items_.data();
        slots_ = more_slots_.data();
        bits_ += 2;
        for (std::size_t i = 0; i < size_; ++i) slots_[slot(items_[i])] = items_[i];
    }

    std::uint32_t few_items_[1u << (few_bits - 1)], few_slots_[1u << few_bits];
    Buffer<std::uint32_t> more_items_, more_slots_;
    std::uint32_t *items_ = few_items_, *slots_ = few_slots_;
    std::size_t size_ = 0;
    unsigned bits_ = few_bits;
};

}  // namespace mgdt
