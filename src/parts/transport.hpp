// SPDX-License-Identifier: MIT
// How the parts of a triangulation exchange records. Parts are numbered from 0 on; a process holds
// a run of them, all of them where there is one process. Every call is collective: all processes
// make the same calls in the same order. None throws.
#pragma once

#include "platform/memory.hpp"

namespace mgdt {

using PartId = std::uint32_t;

// Records by the parts that they are for, or from: those of part p are begin[p] to begin[p + 1].
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
    std::size_t count() const { return begin.empty() ? 0 : begin.back(); }

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

    // Gives every process the records of all parts, `bytes` each, in the order of the parts.
    // `mine` has those of the local parts.
    virtual void gather(const void* mine, std::size_t bytes, void* all) noexcept = 0;
    // Adds the numbers of all processes, one by one; takes the least of each.
    virtual void sum(std::uint64_t* numbers, std::size_t n) noexcept = 0;
    virtual void least(double* numbers, std::size_t n) noexcept = 0;
    // Delivers records of one size: out[i] is what local part i sends, in[i] what it receives.
    // First sets in[i].begin, for which there is room, then fills in[i].bytes likewise.
    virtual void exchange_counts(const Mail* out, Mail* in) noexcept = 0;
    virtual void exchange_records(std::size_t record_size, const Mail* out, Mail* in) noexcept = 0;
};

}  // namespace mgdt
