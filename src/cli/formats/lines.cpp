// SPDX-License-Identifier: MIT
#include "cli/formats/lines.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>

#include "cli/errors.hpp"
#include "cli/formats/number.hpp"
#include "cli/interrupt.hpp"

namespace mgdt::cli {

bool LineReader::next() {
    const std::string_view bytes = source_->bytes;
    if (next_ >= bytes.size()) return false;
    if ((++number_ & 0xFFFF) == 0) check_interrupt();
    const char* begin = bytes.data() + next_;
    const std::size_t left = bytes.size() - next_;
    const void* newline = std::memchr(begin, '\n', left);
    std::size_t length =
        newline ? static_cast<std::size_t>(static_cast<const char*>(newline) - begin) : left;
    std::size_t step = newline ? length + 1 : length;
    if (const void* r = std::memchr(begin, '\r', length)) {
        const auto at = static_cast<std::size_t>(static_cast<const char*>(r) - begin);
        // \r\n ends one line, and so does a \r alone, as on old systems.
        if (!(newline && at + 1 == length)) step = at + 1;
        length = at;
    }
    text_ = bytes.substr(next_, length);
    next_ += step;
    return true;
}

bool LineReader::next_with_text(char comment) {
    while (next()) {
        const std::size_t cut = text_.find(comment);
        if (cut != std::string_view::npos) text_ = text_.substr(0, cut);
        for (const char c : text_) {
            if (!is_blank(c)) return true;
        }
    }
    return false;
}

bool Fields::next(std::string_view& field) {
    std::size_t begin = 0;
    while (begin < rest_.size() && is_blank(rest_[begin])) ++begin;
    std::size_t end = begin;
    while (end < rest_.size() && !is_blank(rest_[end])) ++end;
    field = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return !field.empty();
}

std::string_view Fields::word(const char* what) {
    std::string_view field;
    if (!next(field)) lines_->fail(fmt::format("{} is missing", what));
    return field;
}

double Fields::number(const char* what) {
    const std::string_view field = word(what);
    double value = 0;
    const NumberStatus status = parse_number(field, value);
    if (status != NumberStatus::ok) {
        lines_->fail(fmt::format("{}: {} {}", what, quote(field), describe(status)));
    }
    return value;
}

double Fields::value(const char* what) {
    const std::string_view field = word(what);
    double value = 0;
    const NumberStatus status = parse_number(field, value);
    if (!is_value(status)) {
        lines_->fail(fmt::format("{}: {} {}", what, quote(field), describe(status)));
    }
    return value;
}

std::int64_t Fields::integer(const char* what) {
    const std::string_view field = word(what);
    std::int64_t value = 0;
    if (!parse_integer(field, value)) {
        lines_->fail(fmt::format("{}: {} is not an integer", what, quote(field)));
    }
    return value;
}

std::int64_t Fields::integer(const char* what, std::int64_t low, std::int64_t high) {
    const std::int64_t value = integer(what);
    if (value < low || value > high) {
        lines_->fail(fmt::format("{} is {}; it must be from {} to {}", what, value, low, high));
    }
    return value;
}

}  // namespace mgdt::cli
