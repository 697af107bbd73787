// SPDX-License-Identifier: MIT
// How VTK's XML files encode arrays: a header of integers, then the bytes, both as they are or in
// base64, the bytes compressed block by block or not. VTK's vtkXMLDataParser and
// vtkXMLWriter.
#pragma once

#include <cstdint>
#include <string>

#include "cli/input_file.hpp"

namespace mgdt::cli {

struct ArrayEncoding {
    bool in_base64 = false;
    bool is_compressed = false;
    bool has_wide_header = false;  // integers of 64 bits, or else 32
    bool is_big_endian = false;
};

// Whether this program was built with zlib, which compresses and expands.
bool can_compress();

// The bytes of an array that begins at a byte of the file, as they are in memory of the machine
// that wrote it. Fails unless they are as many as expected. `name` is for messages.
std::string array_bytes(const Source& source, std::size_t begin, const ArrayEncoding& encoding,
                        const std::string& name, std::uint64_t expected);

// The greatest number of bytes that one byte of a compressed file can stand for.
constexpr std::uint64_t most_expansion = 1032;

// Blocks of an array, compressed as they come; header and blocks as they stand in a file.
class CompressedArray {
  public:
    // The size of all blocks but the last.
    static constexpr std::size_t block_size = std::size_t{1} << 18;

    void add_block(const std::string& bytes);
    // With 64-bit integers, least significant byte first.
    std::string header() const;
    const std::string& blocks() const { return blocks_; }

  private:
    std::string blocks_;
    std::string sizes_;
    std::uint64_t count_ = 0, last_size_ = 0;
};

}  // namespace mgdt::cli
