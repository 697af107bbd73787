// SPDX-License-Identifier: MIT
// A whole input file in memory, expanded where its name ends with .gz, and the place that error
// messages speak of. Files are read, not mapped: one that shrinks while it is mapped would kill the
// program.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cli/file_identity.hpp"

namespace mgdt::cli {

// The bytes of an input with its name. Readers see nothing else.
struct Source {
    std::string name;  // as messages say it
    std::string path;  // empty for standard input; without .gz
    std::string_view bytes;
    std::size_t begin = 0;  // of the bytes in the file

    [[noreturn]] void fail(const std::string& what) const;
    [[noreturn]] void fail_at_line(std::size_t line, const std::string& what) const;
    [[noreturn]] void fail_at_byte(std::size_t offset, const std::string& what) const;
};

// The name of an input as messages say it: printable, and "-" is standard input.
std::string input_name(const std::string& path);

class InputFile {
  public:
    // "-" is standard input.
    explicit InputFile(const std::string& path) : InputFile(path, 0, whole) {}
    // Reads at most `most` bytes from byte `begin` of the file on, as they are stored; of a pipe,
    // the next bytes.
    InputFile(const std::string& path, std::size_t begin, std::size_t most);
    Source source() const {
        if (expanded_) return {name_, path_, *expanded_, 0};
        return {name_, path_, {data_.get(), size_}, begin_};
    }
    // Of a regular file; nothing for others.
    std::optional<std::size_t> file_size() const { return file_size_; }
    // Nothing for terminals and their like.
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
