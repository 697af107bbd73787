// SPDX-License-Identifier: MIT
// Reads binary formats value by value. Every access is checked against the end of the file.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "cli/byte_order.hpp"
#include "cli/input_file.hpp"

namespace mgdt::cli {

class ByteReader {
  public:
    ByteReader(const Source& source, std::size_t offset, bool big_endian)
        : source_(&source), offset_(offset), swap_(big_endian != host_is_big_endian()) {}

    std::size_t offset() const { return offset_; }
    void seek(std::size_t offset) { offset_ = offset; }
    std::size_t left() const { return source_->bytes.size() - offset_; }
    const Source& source() const { return *source_; }
    [[noreturn]] void fail(const std::string& what) const { source_->fail_at_byte(offset_, what); }

    // Throws if fewer than `count` items of `size` bytes each are left.
    void need(std::uint64_t count, std::size_t size, const char* what) const {
        if (size == 0 || count <= left() / size) return;
        fail(
            fmt::format("{} {} need at least {} bytes each, but only {} bytes are left; the file "
                        "is cut short or its header is wrong",
                        count, what, size, left()));
    }
    void skip(std::uint64_t count, std::size_t size, const char* what) {
        need(count, size, what);
        offset_ += static_cast<std::size_t>(count) * size;
    }

    template <class T>
    T value(const char* what) {
        need(1, sizeof(T), what);
        char bytes[sizeof(T)];
        std::memcpy(bytes, source_->bytes.data() + offset_, sizeof(T));
        if (swap_) std::reverse(bytes, bytes + sizeof(T));
        T value;
        std::memcpy(&value, bytes, sizeof(T));
        offset_ += sizeof(T);
        return value;
    }

    // Reads a coordinate of type T and checks that it is finite.
    template <class T>
    double coordinate() {
        const auto v = static_cast<double>(value<T>("coordinate"));
        if (!std::isfinite(v)) {
            offset_ -= sizeof(T);
            fail("a coordinate is not finite; take the point out");
        }
        return v;
    }

  private:
    const Source* source_;
    std::size_t offset_;
    bool swap_;
};

}  // namespace mgdt::cli
