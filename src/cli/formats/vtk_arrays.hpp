// SPDX-License-Identifier: MIT
// The encoding of arrays in VTK's XML files: a header of integers, then the bytes. Both are raw or
// in base64, and the bytes may be compressed in blocks. See VTK's vtkXMLDataParser and
// vtkXMLWriter.
#pragma once

#include <cstdint>
#include <string>

#include "cli/input_file.hpp"

namespace mgdt::cli {

struct ArrayEncoding {
    bool in_base64 = false;
    bool is_compressed = false;
    bool has_wide_header = false;  // integers of 64 bits, otherwise 32
    bool is_big_endian = false;
};

// Whether this program was built with zlib, which compresses and expands.
bool can_compress();

// The decoded bytes of an array that begins at byte `begin`, in the byte order of the file. Throws
// if there are not `expected` bytes. `name` is for messages.
std::string array_bytes(const Source& source, std::size_t begin, const ArrayEncoding& encoding,
                        const std::string& name, std::uint64_t expected);

// The greatest number of bytes that one compressed byte can expand to.
constexpr std::uint64_t most_expansion = 1032;

// An array that is compressed block by block; header() and blocks() are as in a file.
class CompressedArray {
  public:
    // The size of all blocks but the last.
    static constexpr std::size_t block_size = std::size_t{1} << 18;

    void add_block(const std::string& bytes);
    // The header, with little-endian integers of 64 bits.
    std::string header() const;
    const std::string& blocks() const { return blocks_; }

  private:
    std::string blocks_;
    std::string sizes_;
    std::uint64_t count_ = 0, last_size_ = 0;
};

}  // namespace mgdt::cli
