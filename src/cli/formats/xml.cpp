// SPDX-License-Identifier: MIT
#include "cli/formats/xml.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace mgdt::cli {
namespace {

// The characters that XML replaces by entities.
constexpr std::array<std::pair<char, std::string_view>, 5> entities = {{
    {'&', "&amp;"},
    {'<', "&lt;"},
    {'>', "&gt;"},
    {'"', "&quot;"},
    {'\'', "&apos;"},
}};

}  // namespace

std::string from_xml(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const auto found = std::find_if(entities.begin(), entities.end(), [&](const auto& e) {
            return text.substr(at, e.second.size()) == e.second;
        });
        out += found == entities.end() ? text[at] : found->first;
        at += found == entities.end() ? 1 : found->second.size();
    }
    return out;
}

std::string to_xml(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const auto found = std::find_if(entities.begin(), entities.end(),
                                        [c](const auto& e) { return e.first == c; });
        out += found == entities.end() ? std::string_view(&c, 1) : found->second;
    }
    return out;
}

}  // namespace mgdt::cli
