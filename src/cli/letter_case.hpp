// SPDX-License-Identifier: MIT
// Comparison of texts without regard to the case of ASCII letters.
#pragma once

#include <algorithm>
#include <string_view>

namespace mgdt::cli {

inline bool is_same_but_for_case(std::string_view a, std::string_view b) {
    const auto small = [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](char x, char y) { return small(x) == small(y); });
}

// Whether a path ends so.
inline bool has_ending(std::string_view path, std::string_view ending) {
    return path.size() >= ending.size() &&
           is_same_but_for_case(path.substr(path.size() - ending.size()), ending);
}

}  // namespace mgdt::cli
