// SPDX-License-Identifier: MIT
#include "bench/row.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <vector>

namespace mgdt::cli::bench {
namespace {

constexpr const char* key_columns =
    "library,version,distribution,points,seed,scheme,threads,run,status";
constexpr std::size_t key_column_count = 9;

template <class Number>
bool parse(std::string_view text, Number& value) {
    const char* last = text.data() + text.size();
    const auto result = std::from_chars(text.data(), last, value);
    return result.ec == std::errc() && result.ptr == last;
}

std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> fields;
    for (std::size_t comma; (comma = line.find(',')) != std::string_view::npos;
         line.remove_prefix(comma + 1)) {
        fields.push_back(line.substr(0, comma));
    }
    fields.push_back(line);
    return fields;
}

}  // namespace

bool Row::compact() const {
    return scheme.size() > compact_suffix.size() &&
           scheme.compare(scheme.size() - compact_suffix.size(), std::string::npos,
                          compact_suffix) == 0;
}

std::string Row::plain_scheme() const {
    return compact() ? scheme.substr(0, scheme.size() - compact_suffix.size()) : scheme;
}

std::string Row::subject() const {
    return fmt::format("{},{},{},{},{},{}", distribution, points, seed, library, scheme, threads);
}

std::string Row::key() const {
    return fmt::format("{},{}", subject(), run);
}

std::string csv_heading() {
    std::string text = key_columns;
    for (const char* name : figure_names) text += std::string(",") + name;
    return text;
}

std::string to_csv(const Row& row) {
    std::string text =
        fmt::format("{},{},{},{},{},{},{},{},{}", row.library, row.version, row.distribution,
                    row.points, row.seed, row.scheme, row.threads, row.run, row.status);
    for (const std::optional<double>& figure : row.figures) {
        text += figure ? fmt::format(",{}", *figure) : ",";
    }
    return text;
}

std::optional<Row> from_csv(std::string_view line) {
    const std::vector<std::string_view> fields = split(line);
    if (fields.size() != key_column_count + figure_count) return std::nullopt;
    Row row;
    row.library = fields[0];
    row.version = fields[1];
    row.distribution = fields[2];
    row.scheme = fields[5];
    row.status = fields[8];
    if (row.library.empty() || row.distribution.empty() || row.status.empty() ||
        !parse(fields[3], row.points) || !parse(fields[4], row.seed) ||
        !parse(fields[6], row.threads) || !parse(fields[7], row.run)) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < figure_count; ++i) {
        const std::string_view field = fields[key_column_count + i];
        if (field.empty()) continue;
        double value = 0;
        if (!parse(field, value) || !std::isfinite(value)) return std::nullopt;
        row.figures[i] = value;
    }
    return row;
}

std::string as_field(std::string_view text) {
    constexpr std::size_t longest = 100;
    std::string field;
    for (const char c : text.substr(0, longest)) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == ',') {
            field += ';';
        } else if (c == '"') {
            field += '\'';
        } else {
            // The cut may split a character of several bytes, so such characters are replaced.
            field += byte < 0x20 || byte >= 0x7f ? '?' : c;
        }
    }
    return field;
}

}  // namespace mgdt::cli::bench
