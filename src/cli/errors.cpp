// SPDX-License-Identifier: MIT
#include "cli/errors.hpp"

#include <fmt/format.h>

#include <system_error>

namespace mgdt::cli {

std::string quote(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string out = "'";
    for (std::size_t i = 0; i < text.size() && i < longest; ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        // Bytes of UTF-8 pass; control characters could drive the reader's terminal.
        if (c < 0x20 || c == 0x7f) {
            out += fmt::format("\\x{:02x}", c);
        } else {
            out += text[i];
        }
    }
    if (text.size() > longest) out += "...";
    return out + "'";
}

std::string system_message(int error) {
    return std::generic_category().message(error);
}

}  // namespace mgdt::cli
