// SPDX-License-Identifier: MIT
// How the parts of a triangulation exchange records. Parts are numbered from 0 on; a process holds
// a run of them, at least one, and all of them where there is one process. Every call is
// collective: all processes make the same calls in the same order. None throws; one that returns
// false has failed, and none is called again.
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

    // Gives every process the bytes of all parts: those of part p are all + begin[p] to
    // all + begin[p + 1]. `mine` has those of the local parts.
    virtual bool gather(const void* mine, const std::uint64_t* begin, void* all) noexcept = 0;
    // Adds the numbers of all processes, one by one; takes the least of each.
    virtual bool sum(std::uint64_t* numbers, std::size_t n) noexcept = 0;
    virtual bool least(double* numbers, std::size_t n) noexcept = 0;
    // Delivers records of one size: out[i] is what local part i sends, in[i] what it receives.
    // First sets in[i].begin, for which there is room, then fills in[i].bytes likewise.
    virtual bool exchange_counts(const Mail* out, Mail* in) noexcept = 0;
    virtual bool exchange_records(std::size_t record_size, const Mail* out, Mail* in) noexcept = 0;
};

}  // namespace mgdt
