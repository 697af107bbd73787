// SPDX-License-Identifier: MIT
// A whole input file in memory, expanded if its name ends with .gz, and the positions in it that
// messages name. Files are read and not mapped: a mapped file that shrinks would end the program.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cli/file_identity.hpp"

namespace mgdt::cli {

// The bytes of an input and its name. Readers see nothing else.
struct Source {
    std::string name;  // the name in messages
    std::string path;  // empty for standard input; without .gz
    std::string_view bytes;
    std::size_t begin = 0;  // the position of the bytes in the file

    [[noreturn]] void fail(const std::string& what) const;
    [[noreturn]] void fail_at_line(std::size_t line, const std::string& what) const;
    [[noreturn]] void fail_at_byte(std::size_t offset, const std::string& what) const;
};

// The name of an input in messages: printable, and "standard input" for "-".
std::string input_name(const std::string& path);

class InputFile {
  public:
    // "-" is standard input.
    explicit InputFile(const std::string& path) : InputFile(path, 0, whole) {}
    // Reads at most `most` bytes, without expanding them: from byte `begin` of a file, or the next
    // bytes of a pipe.
    InputFile(const std::string& path, std::size_t begin, std::size_t most);
    Source source() const {
        if (expanded_) return {name_, path_, *expanded_, 0};
        return {name_, path_, {data_.get(), size_}, begin_};
    }
    // The size of a regular file; nothing for others.
    std::optional<std::size_t> file_size() const { return file_size_; }
    // The identity of the file; nothing for terminals and the like.
    const std::optional<FileIdentity>& identity() const { return identity_; }

  private:
    static constexpr std::size_t whole = ~std::size_t{0};
    struct Free {
        void operator()(char* p) const noexcept;
    };
    std::string name_, path_;
    std::optional<FileIdentity> identity_;
    std::unique_ptr<char, Free> data_;
    std::optional<std::string> expanded_;
    std::size_t begin_, size_ = 0;
    std::optional<std::size_t> file_size_;
};

}  // namespace mgdt::cli
