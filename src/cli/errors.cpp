// SPDX-License-Identifier: MIT
#include "cli/errors.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <exception>
#include <mgdt/mgdt.hpp>
#include <new>
#include <system_error>

namespace mgdt::cli {
namespace {

// The first character of a text in UTF-8. If the bytes are not UTF-8, the length is 1 and there is
// no value.
struct Character {
    std::size_t length;
    std::uint32_t value;
};
constexpr std::uint32_t not_utf8 = ~std::uint32_t{0};

Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    if (lead < 0x80) return {1, lead};
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc0 || lead >= 0xf8 || text.size() < length) return {1, not_utf8};
    std::uint32_t value = lead & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0u) != 0x80) return {1, not_utf8};
        value = value << 6 | (byte(i) & 0x3fu);
    }
    // Valid characters have their shortest form and are not half of a surrogate pair.
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool is_half = value >= 0xd800 && value < 0xe000;
    if (value < least[length] || is_half || value > 0x10ffff) return {1, not_utf8};
    return {length, value};
}

// Control characters act on terminals and end lines; directional marks change what a reader sees.
bool is_printable(std::uint32_t c) {
    const bool is_control = c < 0x20 || (c >= 0x7f && c < 0xa0);
    const bool ends_line = c == 0x2028 || c == 0x2029;
    const bool turns = c == 0x061c || c == 0x200e || c == 0x200f || (c >= 0x202a && c <= 0x202e) ||
                       (c >= 0x2066 && c <= 0x2069);
    return c != not_utf8 && !is_control && !ends_line && !turns;
}

// Appends the printable form of the first character. Returns the number of its bytes.
std::size_t append_first(std::string& out, std::string_view text) {
    const Character c = first_character(text);
    for (const char byte : text.substr(0, c.length)) {
        if (is_printable(c.value)) {
            out += byte;
        } else {
            out += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
        }
    }
    return c.length;
}

// Messages may contain arguments and names that are not printable yet.
int report(std::FILE* out, int code, const char* message) noexcept {
    if (out == nullptr) return code;
    std::fflush(stdout);
    try {
        fmt::print(out, "mgdt: {}\n", printable(message));
    } catch (const std::exception&) {
        // If nobody reads the message or memory is short, the exit status remains.
    }
    return code;
}

}  // namespace

const Failure* find_failure(mgdt_status status) {
    static constexpr Failure failures[] = {
        {MGDT_ERR_NULL_POINTER, exit_internal, ""},
        {MGDT_ERR_INVALID_ARGUMENT, exit_input, ""},
        {MGDT_ERR_NOT_FINITE, exit_input, "; take the point out"},
        {MGDT_ERR_UNKNOWN_SCHEME, exit_usage, ""},
        {MGDT_ERR_UNKNOWN_KEY, exit_internal, ""},
        {MGDT_ERR_NOT_BUILT, exit_internal, ""},
        {MGDT_ERR_BUFFER_TOO_SMALL, exit_internal, ""},
        {MGDT_ERR_INDEX_RANGE, exit_memory, "; triangulate fewer points"},
        {MGDT_ERR_OUT_OF_MEMORY, exit_memory, "; triangulate fewer points or give it more memory"},
        {MGDT_ERR_TOO_LARGE, exit_memory, "; triangulate fewer points"},
        {MGDT_ERR_CANCELLED, exit_internal, ""},
        {MGDT_ERR_BUSY, exit_internal, ""},
        {MGDT_ERR_TRANSPORT, exit_internal, ""},
        {MGDT_ERR_CHECK_FAILED, exit_check_failed, ""},
        {MGDT_ERR_INVALID_BOUNDARY, exit_input, "; mgdt validate lists them"},
        {MGDT_ERR_RESOLUTION, exit_input, ""},
        {MGDT_ERR_OPEN_BOUNDARY, exit_input, ""},
        {MGDT_ERR_INTERNAL, exit_internal, ""},
    };
    for (const Failure& failure : failures)
        if (failure.status == status) return &failure;
    return nullptr;
}

Error failure_of(mgdt_status status, const std::string& what) {
    const Failure* const failure = find_failure(status);
    return failure ? Error(failure->code, what + failure->advice) : Error(exit_internal, what);
}

int report_exception(std::FILE* out) noexcept {
    try {
        throw;
    } catch (const Error& e) {
        return report(out, e.code(), e.what());
    } catch (const mgdt::Error& e) {
        return report(out, failure_of(e.status(), "").code(), e.what());
    } catch (const std::bad_alloc&) {
        return report(out, exit_memory,
                      "out of memory; triangulate fewer points or free some memory");
    } catch (const std::length_error&) {
        return report(out, exit_memory, "out of memory: more than an array can hold");
    } catch (const std::exception& e) {
        return report(out, exit_internal, e.what());
    } catch (...) {
        return report(out, exit_internal, "an unknown exception");
    }
}

std::string printable(std::string_view text) {
    std::string out;
    while (!text.empty()) text.remove_prefix(append_first(out, text));
    return out;
}

std::string quote(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string out = "'";
    std::size_t taken = 0;
    while (taken < text.size() && taken < longest) taken += append_first(out, text.substr(taken));
    if (taken < text.size()) out += "...";
    return out + "'";
}

std::string system_message(int error) {
    return std::generic_category().message(error);
}

}  // namespace mgdt::cli
