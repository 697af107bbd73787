// SPDX-License-Identifier: MIT
// The interface by which parts exchange records. Parts are numbered from 0; a process has a range
// of at least one part. Every call is collective: all processes make the same calls in the same
// order. Calls do not throw. A call that returns false has failed, and no other call follows it.
#pragma once

#include "platform/memory.hpp"

namespace mgdt {

using PartId = std::uint32_t;

// Records to other parts, sorted by receiver, or from other parts, sorted by sender. Records
// begin[p] to begin[p + 1] - 1 are for part p, or from part p.
struct Mail {
    explicit Mail(Allocator& allocator) : bytes(allocator), begin(allocator) {}

    template <class T>
    const T* records() const {
        return reinterpret_cast<const T*>(bytes.data());
    }
    template <class T>
    T* records() {
        return reinterpret_cast<T*>(bytes.data());
    }
    std::size_t count() const { return begin.empty() ? 0 : static_cast<std::size_t>(begin.back()); }

    Buffer<unsigned char> bytes;
    Buffer<std::uint64_t> begin;
};

class Transport {
  public:
    Transport() = default;
    virtual ~Transport() = default;
    Transport(const Transport&) = delete;
    Transport& operator=(const Transport&) = delete;

    virtual PartId parts() const noexcept = 0;
    virtual PartId first_local() const noexcept = 0;
    virtual PartId local_parts() const noexcept = 0;

    // Gives every process the bytes of all parts. The bytes of part p fill the memory from
    // all + begin[p] to all + begin[p + 1]. `mine` has the bytes of the local parts.
    virtual bool gather(const void* mine, const std::uint64_t* begin, void* all) noexcept = 0;
    // sum() replaces each number by the sum of the numbers that all processes have at its position,
    // least() by the least of these numbers.
    virtual bool sum(std::uint64_t* numbers, std::size_t n) noexcept = 0;
    virtual bool least(double* numbers, std::size_t n) noexcept = 0;
    // Two calls deliver records of one size: local part i sends out[i] and receives in[i].
    // exchange_counts() fills in[i].begin, exchange_records() fills in[i].bytes. Each array has its
    // size before the call that fills it.
    virtual bool exchange_counts(const Mail* out, Mail* in) noexcept = 0;
    virtual bool exchange_records(std::size_t record_size, const Mail* out, Mail* in) noexcept = 0;
};

}  // namespace mgdt
