// SPDX-License-Identifier: MIT
// Sorts the items of a buffer and keeps one of those that are equal.
#pragma once

#include <algorithm>

#include "platform/memory.hpp"

namespace mgdt {

// The items before `first` stay as they are.
template <class T>
void take_out_repeats(Buffer<T>& items, std::size_t first = 0) {
    std::sort(items.begin() + first, items.end());
    const T* const end = std::unique(items.begin() + first, items.end());
    items.resize(static_cast<std::size_t>(end - items.begin()));
}

}  // namespace mgdt
