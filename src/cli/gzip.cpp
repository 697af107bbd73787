// SPDX-License-Identifier: MIT
#include "cli/gzip.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/letter_case.hpp"

#if defined(MGDT_HAVE_ZLIB)
#include <zlib.h>
#endif

namespace mgdt::cli {

bool is_gzip_name(std::string_view path) {
    return has_ending(path, ".gz");
}

#if defined(MGDT_HAVE_ZLIB)

namespace {

[[noreturn]] void fail(const std::string& name, const std::string& what) {
    throw Error(exit_input, fmt::format("{}: {}", name, what));
}

// Expands the members of a gzip file (RFC 1952).
class Inflater {
  public:
    explicit Inflater(const std::string& name) : name_(name) {
        constexpr int gzip_window = 15 + 16;
        if (inflateInit2(&stream_, gzip_window) != Z_OK) throw std::bad_alloc();
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    ~Inflater() { inflateEnd(&stream_); }

    std::string expand(std::string_view bytes) {
        constexpr std::size_t most = std::size_t{1} << 20;
        std::string out;
        bool is_at_end = true;  // at the end of a member, or before the first one
        while (!bytes.empty() || !is_at_end) {
            if (is_at_end && is_padding(bytes)) break;
            const std::string_view part = bytes.substr(0, most);
            // zlib does not change its input.
            stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
            stream_.avail_in = static_cast<uInt>(part.size());
            is_at_end = step(out);
            const std::size_t used = part.size() - stream_.avail_in;
            bytes.remove_prefix(used);
            if (!is_at_end && bytes.empty() && stream_.avail_out != 0)
                fail(name_, "the gzip file is cut short");
            if (is_at_end) inflateReset(&stream_);
        }
        return out;
    }

  private:
    // The last block of a tape is padded with zeros.
    static bool is_padding(std::string_view bytes) {
        return bytes.find_first_not_of('\0') == std::string_view::npos;
    }
    // Expands one block. Returns true at the end of a member.
    bool step(std::string& out) {
        check_interrupt();
        constexpr std::size_t block = std::size_t{1} << 20;
        const std::size_t before = out.size();
        if (out.capacity() - before < block) out.reserve(2 * out.capacity() + block);
        out.resize(before + block);
        stream_.next_out = reinterpret_cast<Bytef*>(out.data() + before);
        stream_.avail_out = static_cast<uInt>(block);
        const int status = inflate(&stream_, Z_NO_FLUSH);
        out.resize(before + block - stream_.avail_out);
        if (status == Z_MEM_ERROR) throw std::bad_alloc();
        if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR)
            fail(name_, fmt::format("not a gzip file, or damaged: {}",
                                    stream_.msg ? stream_.msg : "zlib cannot expand it"));
        return status == Z_STREAM_END;
    }

    const std::string& name_;
    z_stream stream_ = {};
};

}  // namespace

std::string expand_gzip(std::string_view bytes, const std::string& name) {
    if (bytes.empty()) fail(name, "not a gzip file: it is empty");
    return Inflater(name).expand(bytes);
}

#else

std::string expand_gzip(std::string_view, const std::string& name) {
    throw Error(exit_input, fmt::format("{}: compressed by gzip, which this program was built "
                                        "without; expand it",
                                        name));
}

#endif

}  // namespace mgdt::cli
