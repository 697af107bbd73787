// SPDX-License-Identifier: MIT
// Reads text formats word by word.
#pragma once

#include <fmt/core.h>

#include <optional>

#include "cli/formats/lines.hpp"

namespace mgdt::cli {

// The words of a file, across line breaks.
class Words {
  public:
    explicit Words(const LineReader& lines, char comment = '#')
        : lines_(lines), comment_(comment) {}

    bool next(std::string_view& word) { return advance() && row_->next(word); }
    // Skips to after the next blank line, or to the end of the file.
    void skip_to_blank_line() {
        row_.reset();
        std::string_view word;
        while (lines_.next() && Fields(lines_).next(word)) continue;
    }
    // The lines; the current one is partly read.
    const LineReader& lines() const { return lines_; }
    double number(const char* what) {
        require(what);
        return row_->number(what);
    }
    std::int64_t integer(const char* what, std::int64_t low, std::int64_t high) {
        require(what);
        return row_->integer(what, low, high);
    }
    // Reads the number of rows of `columns` words that follow.
    std::size_t count(const char* what, std::size_t columns) {
        const std::int64_t n = integer(what, 0, std::int64_t{1} << 62);
        const std::size_t left = lines_.bytes_left() + lines_.text().size() + 1;
        if (static_cast<std::uint64_t>(n) > left / (2 * columns))
            fail(
                fmt::format("{} is {}, but only {} bytes are left; the file is cut short or the "
                            "number is wrong",
                            what, n, left));
        return static_cast<std::size_t>(n);
    }
    [[noreturn]] void fail(const std::string& what) const { lines_.fail(what); }

  private:
    // Goes to the next word. Returns false at the end of the file.
    bool advance() {
        std::string_view word;
        while (!row_ || !Fields(*row_).next(word)) {
            if (!lines_.next_with_text(comment_)) return false;
            row_.emplace(lines_);
        }
        return true;
    }
    void require(const char* what) {
        if (!advance()) fail(fmt::format("the file ends where {} is to follow", what));
    }

    LineReader lines_;
    char comment_;
    std::optional<Fields> row_;
};

}  // namespace mgdt::cli
