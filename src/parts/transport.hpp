// SPDX-License-Identifier: MIT
// The interface by which parts exchange records. Parts are numbered from 0; a process has a range
// of at least one part. Every call is collective: all processes make the same calls in the same
// order. Calls do not throw. A call that returns false has failed, and no other is made after it.
#pragma once

#include "platform/memory.hpp"

namespace mgdt {

using PartId = std::uint32_t;

// Records sorted by the parts that they go to, or come from: records begin[p] to begin[p + 1] - 1
// are for part p.
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

    // Gives every process the bytes of all parts. Those of part p go from all + begin[p] to
    // all + begin[p + 1]. `mine` has the bytes of the local parts.
    virtual bool gather(const void* mine, const std::uint64_t* begin, void* all) noexcept = 0;
    // Replace each number by the sum, or by the least, of the numbers of all processes at that
    // position.
    virtual bool sum(std::uint64_t* numbers, std::size_t n) noexcept = 0;
    virtual bool least(double* numbers, std::size_t n) noexcept = 0;
    // Deliver records of one size: local part i sends out[i] and receives in[i]. The first call
    // sets in[i].begin, the second one fills in[i].bytes; there is room for both.
    virtual bool exchange_counts(const Mail* out, Mail* in) noexcept = 0;
    virtual bool exchange_records(std::size_t record_size, const Mail* out, Mail* in) noexcept = 0;
};

}  // namespace mgdt
