// SPDX-License-Identifier: MIT
// A radix sort by 64-bit keys, which looks only at as many bits as distinguish the keys.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "order/equal_runs.hpp"
#include "platform/compiler.hpp"

namespace mgdt {

struct KeyedIndex {
    std::uint64_t key;
    std::uint32_t index;
};

inline std::uint64_t radix_key(std::uint64_t word) noexcept {
    return word;
}
inline std::uint64_t radix_key(const KeyedIndex& record) noexcept {
    return record.key;
}

template <class Record>
void insertion_sort(Record* a, std::size_t n) noexcept {
    for (std::size_t i = 1; i < n; ++i) {
        const Record r = a[i];
        std::size_t j = i;
        for (; j > 0 && radix_key(r) < radix_key(a[j - 1]); --j) a[j] = a[j - 1];
        a[j] = r;
    }
}

namespace radix_detail {

inline constexpr unsigned digit_bits = 11;
inline constexpr unsigned most_digits = 2;  // 16 KiB of counters on the stack

struct Counters {
    std::uint32_t of_digit[most_digits][1u << digit_bits];
};

// The number of the bits low..high-1 by which n records are sorted first: enough to distinguish
// most of them in two passes.
inline unsigned first_width(std::size_t n, unsigned low, unsigned high) noexcept {
    return std::min({bit_width(n) + 2, high - low, most_digits * digit_bits});
}

// The digits of equal width into which `width` bits are divided.
struct Digits {
    explicit Digits(unsigned width) noexcept
        : count((width + digit_bits - 1) / digit_bits), bits((width + count - 1) / count) {}
    const unsigned count, bits;
    std::size_t values() const noexcept { return std::size_t{1} << bits; }
};

// Sorts n records stably by bits low..low+width-1 of their keys, from the least significant digit
// on. Each pass moves the records from one of the arrays a and b to the other. Returns the array
// with the result. The function is not inlined, since short arrays are sorted without it, and stack
// protection would touch its large frame at each call.
template <class Record>
MGDT_NOT_INLINE Record* least_digit_first(Record* a, Record* b, std::size_t n, unsigned low,
                                          unsigned width) noexcept {
    Counters counters;
    const Digits digits(width);
    const std::uint64_t mask = digits.values() - 1;
    for (unsigned d = 0; d < digits.count; ++d) {
        std::memset(counters.of_digit[d], 0, sizeof(std::uint32_t) << digits.bits);
    }
    for (std::size_t i = 0; i < n; ++i) {
        std::uint64_t key = radix_key(a[i]) >> low;
        for (unsigned d = 0; d < digits.count; ++d, key >>= digits.bits)
            ++counters.of_digit[d][key & mask];
    }
    for (unsigned d = 0; d < digits.count; ++d) {
        const unsigned shift = low + d * digits.bits;
        std::uint32_t* next = counters.of_digit[d];
        if (next[(radix_key(a[0]) >> shift) & mask] == n) continue;
        std::uint32_t sum = 0;
        for (std::size_t v = 0; v <= mask; ++v) {
            const std::uint32_t here = next[v];
            next[v] = sum;
            sum += here;
        }
        for (std::size_t i = 0; i < n; ++i) b[next[(radix_key(a[i]) >> shift) & mask]++] = a[i];
        std::swap(a, b);
    }
    return a;
}

}  // namespace radix_detail

// Sorts n < 2^32 records by bits low..high-1 of their keys, whose higher bits are equal. Sorts by
// the top bits first (see first_width()), and then sorts each run of records whose top bits are
// equal. So keys that differ in their top bits take two passes, however long they are. `scratch`
// has room for n records. With low = 0, records with equal keys keep their order.
template <class Record>
void radix_sort(Record* a, Record* scratch, std::size_t n, unsigned low, unsigned high) noexcept {
    constexpr std::size_t few = 24;
    if (n <= few) {
        insertion_sort(a, n);
        return;
    }
    std::uint64_t differ = 0;
    for (std::size_t i = 1; i < n; ++i) differ |= radix_key(a[i]) ^ radix_key(a[0]);
    const unsigned differing = bit_width(differ);
    if (differing < high) high = differing;
    if (high <= low) return;
    const unsigned width = radix_detail::first_width(n, low, high);
    high -= width;
    const Record* sorted = radix_detail::least_digit_first(a, scratch, n, high, width);
    if (sorted != a) std::memcpy(static_cast<void*>(a), sorted, n * sizeof(Record));
    if (high <= low) return;
    for_each_run(
        0, n,
        [&](std::size_t i, std::size_t j) {
            return radix_key(a[i]) >> high == radix_key(a[j]) >> high;
        },
        [&](std::size_t begin, std::size_t end) {
            if (end - begin > 1) radix_sort(a + begin, scratch + begin, end - begin, low, high);
        });
}

}  // namespace mgdt
