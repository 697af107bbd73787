// SPDX-License-Identifier: MIT
#include "kernel/thread_state.hpp"

#include <algorithm>

namespace mgdt {

bool MarkTable::View::is_displaced(TetId t) const noexcept {
    return std::find(displaced, displaced + *displaced_count, t) != displaced + *displaced_count;
}

std::uint32_t MarkTable::View::put_displaced(TetId t, std::uint32_t is_in) const noexcept {
    if (is_displaced(t)) return 0;
    if (is_in != 0) displaced[(*displaced_count)++] = t;
    return 1;
}

bool MarkTable::View::has(TetId t) const noexcept {
    const std::uint32_t entry = data[t & mask], key = key_of(t);
    return entry == key || (is_collision(entry, key) && is_displaced(t));
}

void MarkTable::resize(std::size_t members) {
    unsigned bits = least_bits;
    while (std::size_t{1} << bits < 4 * members) ++bits;
    const std::size_t size = std::size_t{1} << bits;
    if (size > entries_.size() || view_.stamp == 0) {
        const std::size_t larger = std::max(size, entries_.size());
        displaced_.resize(larger / 4);
        entries_.clear();
        entries_.resize(larger, 0);
        view_.stamp = one_stamp;
    }
    view_.data = entries_.data();
    view_.mask = static_cast<std::uint32_t>(size - 1);
    view_.position_bits = bits;
    view_.displaced = displaced_.data();
    view_.displaced_count = &displaced_count_;
}

void MarkTable::grow(std::size_t members, const FacetCode* codes, std::size_t marked) {
    if (members <= capacity()) return;
    view_.stamp += one_stamp;  // the old entries are at other positions now
    resize(members);
    displaced_count_ = 0;
    for (std::size_t i = 0; i < marked; ++i) view_.put(tetrahedron_of(codes[i]), 1);
}

SlotSupply::SlotRange SlotSupply::take(std::size_t least) {
    TetId begin = next_.load(std::memory_order_relaxed);
    std::size_t size;
    do {
        const std::size_t left = mesh_.tetrahedra.capacity() - begin;
        size = std::min(left, most(least));
        if (size < least) throw NoSlots();
    } while (!next_.compare_exchange_weak(begin, begin + static_cast<TetId>(size),
                                          std::memory_order_relaxed));
    return {begin, begin + static_cast<TetId>(size)};
}

void SlotSupply::promise(std::size_t more) {
    const std::lock_guard<std::mutex> lock(mutex_);
    mesh_.free_slots.grow(mesh_.free_slots.size() + promised_ + more);
    promised_ += more;
}

void SlotSupply::take_free(Buffer<TetId>& list, std::size_t most) noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::size_t count = std::min(most, mesh_.free_slots.size()), size = list.size();
    list.resize_within_capacity(size + count);
    for (std::size_t i = 0; i < count; ++i) {
        list[size + i] = mesh_.free_slots.back();
        mesh_.free_slots.pop_back();
    }
}

void SlotSupply::open() noexcept {
    next_.store(static_cast<TetId>(mesh_.tetrahedra.size()), std::memory_order_relaxed);
    promised_ = 0;
}

void SlotSupply::close() noexcept {
    const std::size_t size = next_.load(std::memory_order_relaxed);
    mesh_.tetrahedra.resize_within_capacity(size);
    mesh_.prefaulted_slots = std::max(mesh_.prefaulted_slots, size);
}

void ThreadState::grow_slots(std::size_t taken, std::size_t freed) {
    const auto make_room = [&](std::size_t free) {
        if (free <= most_free_) return;
        const std::size_t more = std::max<std::size_t>(free - most_free_, 1024);
        free_slots_.grow(most_free_ + more);
        supply_.promise(more);
        most_free_ += more;
    };
    make_room(slots_left() + freed);
    if (taken <= slots_left()) return;
    make_room(slots_left() + 2 * supply_.most(taken) + freed);
    supply_.take_free(free_slots_, supply_.most(taken));
    if (taken <= slots_left()) return;
    const std::size_t needed = taken - slots_left();
    const SlotSupply::SlotRange range = supply_.take(needed);
    // The rest of the last range becomes free slots.
    while (fresh_ < end_) free_slot(fresh_++);
    fresh_ = range.begin;
    end_ = range.end;
    mesh_.tetrahedra.prefault(fresh_, end_);
}

void ThreadState::return_slots() noexcept {
    while (fresh_ < end_) mesh_.free_slot(fresh_++);
    for (const TetId t : free_slots_) mesh_.free_slot(t);
    free_slots_.clear();
    most_free_ = 0;
}

}  // namespace mgdt
