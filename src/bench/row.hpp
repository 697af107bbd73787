// SPDX-License-Identifier: MIT
// One run of one library on one set of points, which is one line of the CSV table.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mgdt::cli::bench {

enum Figure : std::size_t {
    walked,  // tetrahedra visited by walks, per insertion: the paper's NP
    removed,
    created,
    order_seconds,
    insert_seconds,
    total_seconds,
    bytes_per_point,
    peak_rss_bytes,
    inserted,
    duplicates,
    tetrahedra,
    levels,
    rounds,
    system_seconds,  // processor time in the system, of all threads: mostly fresh pages
    user_seconds,    // processor time in the program itself, of all threads
    alone_percent,   // percentage of points inserted by one thread while others had no work
    figure_count
};

inline constexpr std::array<const char*, figure_count> figure_names{"np",
                                                                    "nr",
                                                                    "created",
                                                                    "order_seconds",
                                                                    "insert_seconds",
                                                                    "total_seconds",
                                                                    "bytes_per_point",
                                                                    "peak_rss_bytes",
                                                                    "inserted",
                                                                    "duplicates",
                                                                    "tetrahedra",
                                                                    "levels",
                                                                    "rounds",
                                                                    "system_seconds",
                                                                    "user_seconds",
                                                                    "alone_percent"};

// A figure that a library does not report is empty.
using Figures = std::array<std::optional<double>, figure_count>;

// The suffix of the scheme of a run in compact storage.
inline constexpr std::string_view compact_suffix = "+compact";

struct Row {
    std::string library = "mgdt";  // or the name of a peer
    std::string version;
    std::string distribution;
    std::size_t points = 0;  // the number that is asked for; a distribution may have fewer
    std::uint64_t seed = 1;
    std::string scheme;  // empty for peers; ends in compact_suffix for compact storage
    int threads = 1;
    int run = 1;
    std::string status = "ok";  // or a word for what has failed
    Figures figures{};

    // The scheme without the suffix, and whether it had the suffix.
    std::string plain_scheme() const;
    bool compact() const;
    bool ok() const { return status == "ok"; }
    // Identifies the set and the contender, without the number of the run. Medians are over rows
    // with the same subject.
    std::string subject() const;
    // Identifies the run within the table.
    std::string key() const;
    // The scheme, or the peer's name.
    const std::string& contender() const { return scheme.empty() ? library : scheme; }
};

// The heading of the CSV table, without the end of the line.
std::string csv_heading();

std::string to_csv(const Row& row);

// Reads a line of the table. Returns nothing if the text is not such a line.
std::optional<Row> from_csv(std::string_view line);

// Converts any text to a field: printable, without commas and quotation marks, and short.
std::string as_field(std::string_view text);

}  // namespace mgdt::cli::bench
