// SPDX-License-Identifier: MIT
#include "cli/counts.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>

#include "cli/errors.hpp"

namespace mgdt::cli {

std::size_t parse_point_count(const std::string& name, const std::string& text) {
    double value = -1;
    const char* last = text.data() + text.size();
    const auto result = std::from_chars(text.data(), last, value);
    if (result.ec != std::errc() || result.ptr != last || !(value >= 0) || value > 1e15 ||
        value != std::floor(value)) {
        throw Error(exit_usage,
                    fmt::format("{} is {}; a number of points such as 1000 or 1e6 is needed", name,
                                quote(text)));
    }
    return static_cast<std::size_t>(value);
}

std::string counted(std::size_t n, const char* singular, const char* plural) {
    return fmt::format("{} {}", n, n == 1 ? singular : plural);
}

}  // namespace mgdt::cli
