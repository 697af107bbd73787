// SPDX-License-Identifier: MIT
#include "cli/formats/extended_xyz.hpp"

#include <fmt/core.h>

#include <vector>

#include "cli/errors.hpp"
#include "cli/formats/number.hpp"

namespace mgdt::cli {
namespace {

// Goes through the names and values of a line.
class NamedValues {
  public:
    explicit NamedValues(std::string_view text) : rest_(text) {}

    // Gives the next name with a value; a word without one is skipped.
    bool next(std::string_view& name, std::string_view& value) {
        while (true) {
            skip_blanks();
            if (rest_.empty()) return false;
            const std::size_t end = rest_.find_first_of(" \t=");
            name = rest_.substr(0, end);
            rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end);
            skip_blanks();
            if (rest_.empty() || rest_.front() != '=') continue;
            rest_.remove_prefix(1);
            skip_blanks();
            value = take_value();
            return true;
        }
    }

  private:
    void skip_blanks() {
        while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
    }
    std::string_view take_value() {
        const char first = rest_.empty() ? ' ' : rest_.front();
        const char last = first == '"' || first == '\'' ? first
                          : first == '{'                ? '}'
                          : first == '['                ? ']'
                                                        : ' ';
        if (last != ' ') rest_.remove_prefix(1);
        const std::size_t end = last == ' ' ? rest_.find_first_of(" \t") : rest_.find(last);
        const std::string_view value = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        return value;
    }

    std::string_view rest_;
};

// The words of a value, which blanks, commas and brackets separate.
std::vector<std::string_view> words_of(std::string_view value, std::string_view separators) {
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t begin = value.find_first_not_of(separators);
        if (begin == std::string_view::npos) return words;
        const std::size_t end = value.find_first_of(separators, begin);
        words.push_back(value.substr(begin, end - begin));
        if (end == std::string_view::npos) return words;
        value.remove_prefix(end);
    }
}

constexpr std::string_view in_lists = " \t,[]";

// Nothing if the value has another form: points are read then, and no box.
std::optional<FileBox> lattice(std::string_view value) {
    const std::vector<std::string_view> words = words_of(value, in_lists);
    FileBox box;
    bool is_right = words.size() == 9;
    for (std::size_t k = 0; k < 9 && is_right; ++k)
        is_right = parse_number(words[k], box.vectors[k]) == NumberStatus::ok;
    return is_right ? std::optional<FileBox>(box) : std::nullopt;
}

std::optional<std::array<bool, 3>> directions(std::string_view value) {
    const std::vector<std::string_view> words = words_of(value, in_lists);
    std::array<bool, 3> repeats = {};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string_view word = words.size() == 3 ? words[k] : std::string_view();
        repeats[k] =
            is_same_but_for_case(word, "T") || is_same_but_for_case(word, "true") || word == "1";
        if (!repeats[k] && !is_same_but_for_case(word, "F") &&
            !is_same_but_for_case(word, "false") && word != "0")
            return std::nullopt;
    }
    return repeats;
}

// The column where the property pos begins: properties are name:type:columns, with colons between.
std::optional<int> column_of_positions(std::string_view value, const LineReader& line) {
    const std::vector<std::string_view> words = words_of(value, ":");
    std::int64_t column = 1;
    for (std::size_t i = 0; i + 2 < words.size(); i += 3) {
        std::int64_t columns = 0;
        if (!parse_integer(words[i + 2], columns) || columns < 1 || columns > 1000) break;
        if (is_same_but_for_case(words[i], "pos") && columns == 3) return static_cast<int>(column);
        column += columns;
        if (column > 10000) break;
    }
    line.fail(fmt::format("Properties is {}; it has no pos:R:3", quote(value)));
}

}  // namespace

XyzTitle read_xyz_title(const LineReader& line) {
    XyzTitle title;
    std::optional<std::array<bool, 3>> repeats = std::array<bool, 3>{true, true, true};
    NamedValues values(line.text());
    std::string_view name, value;
    while (values.next(name, value)) {
        if (is_same_but_for_case(name, "lattice")) title.box = lattice(value);
        if (is_same_but_for_case(name, "pbc")) repeats = directions(value);
        if (is_same_but_for_case(name, "properties"))
            title.first_column = column_of_positions(value, line);
    }
    if (title.box && repeats)
        title.box->repeats = *repeats;
    else
        title.box.reset();
    return title;
}

}  // namespace mgdt::cli
