// SPDX-License-Identifier: MIT
// What the commands share.
#include "cli/commands.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <cmath>

#include "cli/errors.hpp"

namespace mgdt::cli {

Mesh read_input(const InputOptions& options, const Format** format) {
    const InputFile file(options.path);
    const Source source = file.source();
    const Format& f = input_format(source, options.from);
    if (format) *format = &f;
    return f.read(source, options.read);
}

void check_terminal(const OutputOptions& options, const Format& format) {
    if (options.path == "-" && format.binary && isatty(STDOUT_FILENO) == 1) {
        throw Error(exit_usage,
                    fmt::format("{} is binary and standard output is a terminal; give -o a file",
                                format.name));
    }
}

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
