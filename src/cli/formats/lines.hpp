// SPDX-License-Identifier: MIT
// Reads text formats line by line: numbered lines, and the fields of a line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "cli/input_file.hpp"
#include "cli/letter_case.hpp"

namespace mgdt::cli {

// A comment character that no line contains.
inline constexpr char no_comment = '\n';

// Whether a character separates fields.
inline bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

// Lines end with \n, \r\n or \r.
class LineReader {
  public:
    // Begins at byte `offset`, which is on line `line`.
    explicit LineReader(const Source& source, std::size_t offset = 0, std::size_t line = 1)
        : source_(&source), next_(offset), number_(line - 1) {}

    // Goes to the next line. Returns false at the end of the file.
    bool next();
    // The same, but skips lines with only blanks and comments. text() ends before `comment`.
    bool next_with_text(char comment = '#');

    std::string_view text() const { return text_; }
    std::size_t number() const { return number_; }
    // The position of the next line.
    std::size_t offset() const { return next_; }
    std::size_t bytes_left() const { return source_->bytes.size() - next_; }
    const Source& source() const { return *source_; }
    [[noreturn]] void fail(const std::string& what) const { source_->fail_at_line(number_, what); }

  private:
    const Source* source_;
    std::string_view text_;
    std::size_t next_;
    std::size_t number_;
};

// Fields of the current line, separated by blanks and tabs. Missing and malformed ones are
// errors that name the line and `what` was expected.
class Fields {
  public:
    explicit Fields(const LineReader& lines) : lines_(&lines), rest_(lines.text()) {}

    bool next(std::string_view& field);
    std::string_view word(const char* what);
    // Reads a finite number.
    double number(const char* what);
    // Reads a number that may be nan or inf.
    double value(const char* what);
    std::int64_t integer(const char* what);
    // Reads an integer from `low` to `high`.
    std::int64_t integer(const char* what, std::int64_t low, std::int64_t high);

  private:
    const LineReader* lines_;
    std::string_view rest_;
};

}  // namespace mgdt::cli
