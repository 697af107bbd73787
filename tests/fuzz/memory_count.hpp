// SPDX-License-Identifier: MIT
// Counts the bytes that a piece of code holds at most, by operator new and delete of the whole
// program. For one thread.
#pragma once

#include <cstddef>

namespace fuzz {

class MemoryCount {
  public:
    static void start() { now_ = peak_ = 0; }
    static std::size_t peak() { return static_cast<std::size_t>(peak_); }
    static void add(void* p);
    static void take(void* p);

  private:
    inline static std::ptrdiff_t now_ = 0, peak_ = 0;
};

}  // namespace fuzz
