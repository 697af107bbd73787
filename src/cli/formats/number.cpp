// SPDX-License-Identifier: MIT
#include "cli/formats/number.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

namespace mgdt::cli {
namespace {

bool digit(char c) {
    return c >= '0' && c <= '9';
}

// from_chars does not accept a plus sign.
std::string_view without_plus(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') {
        text.remove_prefix(1);
    }
    return text;
}

NumberStatus parse_plain(std::string_view text, double& value, const char*& end) {
    const char* first = text.data();
    const char* last = first + text.size();
    const auto result = std::from_chars(first, last, value);
    end = result.ptr;
    if (result.ec == std::errc::invalid_argument) return NumberStatus::not_a_number;
    if (result.ec == std::errc::result_out_of_range) {
        // The number is too large or too small: strtod decides which, and rounds small numbers to a
        // subnormal number or zero. The program never leaves the "C" locale.
        value = std::strtod(std::string(first, end).c_str(), nullptr);
        if (std::isinf(value)) return NumberStatus::too_large;
    }
    return std::isfinite(value) ? NumberStatus::ok : NumberStatus::not_finite;
}

}  // namespace

NumberStatus parse_number(std::string_view text, double& value) {
    text = without_plus(text);
    const char* end = nullptr;
    const char* last = text.data() + text.size();
    NumberStatus status = parse_plain(text, value, end);
    if (status == NumberStatus::not_a_number || end == last) return status;
    if (status == NumberStatus::not_finite) return NumberStatus::not_a_number;  // "info"

    // Fortran writes D before the exponent of a double, and no letter before an exponent of three
    // digits.
    const auto head = static_cast<std::size_t>(end - text.data());
    std::string rest(text.substr(head));
    if (text.find_first_of("eE") < head) return NumberStatus::not_a_number;
    if (rest[0] == 'd' || rest[0] == 'D') {
        rest[0] = 'e';
    } else if (rest.size() == 4 && (rest[0] == '+' || rest[0] == '-') && digit(rest[1]) &&
               digit(rest[2]) && digit(rest[3])) {
        rest.insert(0, 1, 'e');
    } else {
        return NumberStatus::not_a_number;
    }
    const std::string whole = std::string(text.substr(0, head)) + rest;
    status = parse_plain(whole, value, end);
    return end == whole.data() + whole.size() ? status : NumberStatus::not_a_number;
}

bool parse_integer(std::string_view text, std::int64_t& value) {
    text = without_plus(text);
    const char* last = text.data() + text.size();
    const auto result = std::from_chars(text.data(), last, value);
    return result.ec == std::errc() && result.ptr == last;
}

const char* describe(NumberStatus status) {
    switch (status) {
        case NumberStatus::ok:
            return "is a number";
        case NumberStatus::not_a_number:
            return "is not a number";
        case NumberStatus::too_large:
            return "is too large for a double";
        case NumberStatus::not_finite:
            return "is not finite; take the point out";
    }
    return "";
}

}  // namespace mgdt::cli
