// SPDX-License-Identifier: MIT
#include "cli/formats/vtk_arrays.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#if defined(MGDT_HAVE_ZLIB)
#include <zlib.h>
#endif

#include "cli/errors.hpp"
#include "cli/formats/bytes.hpp"

namespace mgdt::cli {
namespace {

// The values of the characters of base64; 64 for other characters.
constexpr std::array<std::uint8_t, 256> base64_values() {
    std::array<std::uint8_t, 256> values = {};
    for (auto& v : values) v = 64;
    constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (unsigned i = 0; i < 64; ++i)
        values[static_cast<unsigned char>(letters[i])] = static_cast<std::uint8_t>(i);
    return values;
}

std::size_t base64_length(std::size_t bytes) {
    return (bytes + 2) / 3 * 4;
}

// Reads the pieces of an encoded array in sequence.
class Pieces {
  public:
    Pieces(const Source& source, std::size_t begin, bool in_base64)
        : source_(source), at_(begin), in_base64_(in_base64) {
        // In XML, blanks may precede an array.
        if (in_base64)
            at_ = std::min(source.bytes.find_first_not_of(" \t\r\n", begin), source.bytes.size());
    }
    // The next n bytes. In base64 they are encoded as a piece of their own.
    std::string take(std::uint64_t n) {
        std::string bytes = look(n);
        at_ += in_base64_ ? base64_length(bytes.size()) : bytes.size();
        return bytes;
    }
    // The first n bytes of the next piece, which stays.
    std::string look(std::uint64_t n) const {
        const std::uint64_t left = source_.bytes.size() - at_;
        if (n > left || (in_base64_ && base64_length(static_cast<std::size_t>(n)) > left))
            fail(fmt::format("{} bytes are to follow; the file is cut short", n));
        const auto size = static_cast<std::size_t>(n);
        const std::string_view text =
            source_.bytes.substr(at_, in_base64_ ? base64_length(size) : size);
        return in_base64_ ? decoded(text, size) : std::string(text);
    }
    std::uint64_t left() const { return source_.bytes.size() - at_; }
    [[noreturn]] void fail(const std::string& what) const { source_.fail_at_byte(at_, what); }

  private:
    std::string decoded(std::string_view text, std::size_t n) const {
        static constexpr std::array<std::uint8_t, 256> values = base64_values();
        std::string bytes;
        bytes.reserve(n + 3);
        for (std::size_t i = 0; i < text.size(); i += 4) {
            std::uint32_t word = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const char c = text[i + k];
                // Padding may follow the last byte that is asked for.
                const bool is_padding = c == '=' && k > 1 && 3 * (i / 4) + k > n;
                const std::uint32_t v = is_padding ? 0 : values[static_cast<unsigned char>(c)];
                if (v == 64) source_.fail_at_byte(at_ + i + k, "a character that is not base64");
                word = word << 6 | v;
            }
            for (int shift = 16; shift >= 0; shift -= 8)
                bytes += static_cast<char>(word >> shift & 0xFF);
        }
        bytes.resize(n);
        return bytes;
    }

    const Source& source_;
    std::size_t at_;
    bool in_base64_;
};

class Words {
  public:
    Words(std::string bytes, const ArrayEncoding& encoding)
        : bytes_(std::move(bytes)), encoding_(encoding) {}
    std::uint64_t operator[](std::size_t i) const {
        const std::size_t size = encoding_.has_wide_header ? 8 : 4;
        std::uint64_t value = 0;
        for (std::size_t k = 0; k < size; ++k) {
            const std::size_t byte = encoding_.is_big_endian ? k : size - 1 - k;
            value = value << 8 | static_cast<unsigned char>(bytes_[size * i + byte]);
        }
        return value;
    }

  private:
    std::string bytes_;
    const ArrayEncoding& encoding_;
};

[[noreturn]] void fail_size(const Pieces& pieces, const std::string& name, std::uint64_t size,
                            std::uint64_t expected) {
    pieces.fail(fmt::format("the array {} has {} bytes; {} are announced", name, size, expected));
}

std::string expanded(Pieces& pieces, const ArrayEncoding& encoding, const std::string& name,
                     std::uint64_t expected) {
    const std::size_t word = encoding.has_wide_header ? 8 : 4;
    // The header has the number of blocks, the size of each block and of the last (0: the same),
    // and the compressed sizes.
    const std::uint64_t count = Words(pieces.look(3 * word), encoding)[0];
    if (count > expected || count > pieces.left() / word) fail_size(pieces, name, count, expected);
    const Words head(pieces.take((3 + count) * word), encoding);
    const std::uint64_t block = head[1], last = head[2] == 0 ? block : head[2];
    if (count == 0) {
        if (expected != 0) fail_size(pieces, name, 0, expected);
        return {};
    }
    const bool is_all = last <= block && last <= expected &&
                        (count == 1 ? last == expected
                                    : block != 0 && (count - 1) <= (expected - last) / block &&
                                          (count - 1) * block + last == expected);
    if (!is_all)
        pieces.fail(fmt::format(
            "the array {} has {} blocks of {} bytes and one of {}; {} bytes are announced", name,
            count - 1, block, last, expected));
    std::uint64_t compressed = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t size = head[3 + static_cast<std::size_t>(i)];
        if (size > pieces.left() - std::min(pieces.left(), compressed))
            pieces.fail(fmt::format("a block of {} bytes; the file is cut short", size));
        compressed += size;
    }
    const std::string bytes = pieces.take(compressed);
    std::string out;
#if defined(MGDT_HAVE_ZLIB)
    std::size_t at = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto size = static_cast<uLong>(head[3 + static_cast<std::size_t>(i)]);
        const std::uint64_t whole = i + 1 < count ? block : last;
        if (whole > most_expansion * (std::uint64_t{size} + 1))
            pieces.fail("a block that is too small");
        const std::size_t before = out.size();
        out.resize(before + static_cast<std::size_t>(whole));
        auto length = static_cast<uLongf>(whole);
        const int status = uncompress(reinterpret_cast<Bytef*>(out.data() + before), &length,
                                      reinterpret_cast<const Bytef*>(bytes.data() + at), size);
        if (status != Z_OK || length != whole)
            pieces.fail(fmt::format("the array {}: block {} cannot be expanded", name, i));
        at += size;
    }
#endif
    return out;
}

}  // namespace

bool can_compress() {
#if defined(MGDT_HAVE_ZLIB)
    return true;
#else
    return false;
#endif
}

std::string array_bytes(const Source& source, std::size_t begin, const ArrayEncoding& encoding,
                        const std::string& name, std::uint64_t expected) {
    Pieces pieces(source, begin, encoding.in_base64);
    if (encoding.is_compressed) return expanded(pieces, encoding, name, expected);
    const std::size_t word = encoding.has_wide_header ? 8 : 4;
    const std::uint64_t size = Words(pieces.look(word), encoding)[0];
    if (size != expected) fail_size(pieces, name, size, expected);
    if (size > source.bytes.size()) pieces.fail(fmt::format("the array {} is cut short", name));
    return pieces.take(word + static_cast<std::size_t>(size)).substr(word);
}

void CompressedArray::add_block(const std::string& bytes) {
#if defined(MGDT_HAVE_ZLIB)
    auto length = compressBound(static_cast<uLong>(bytes.size()));
    const std::size_t before = blocks_.size();
    blocks_.resize(before + length);
    if (compress2(reinterpret_cast<Bytef*>(blocks_.data() + before), &length,
                  reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()),
                  5) != Z_OK)
        throw std::bad_alloc();
    blocks_.resize(before + length);
    for (int shift = 0; shift < 64; shift += 8)
        sizes_ += static_cast<char>(std::uint64_t{length} >> shift & 0xFF);
#endif
    ++count_;
    last_size_ = bytes.size();
}

std::string CompressedArray::header() const {
    std::string out;
    for (const std::uint64_t value : {count_, std::uint64_t{block_size},
                                      last_size_ == block_size ? std::uint64_t{0} : last_size_})
        for (int shift = 0; shift < 64; shift += 8) out += static_cast<char>(value >> shift & 0xFF);
    return out + sizes_;
}

}  // namespace mgdt::cli
