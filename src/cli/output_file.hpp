// SPDX-License-Identifier: MIT
// Output that appears whole or not at all: written under a temporary name in the same directory,
// given its name when every byte is on the disk, and removed on every other way out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/interrupt.hpp"

namespace mgdt::cli {

class OutputFile {
  public:
    // "-" is standard output. Devices, pipes and sockets are written to as they are.
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(const void* data, std::size_t size);
    void write(std::string_view text) { write(text.data(), text.size()); }
    // Shortest text that reads back as the same number.
    void write_number(double value);
    void write_integer(std::int64_t value);
    // Binary, least significant byte first on every machine.
    template <class T>
    void write_values(const T* values, std::size_t count);
    template <class T>
    void write_value(T value) {
        write_values(&value, 1);
    }

    // Brings every byte to the disk; the name is still the temporary one. Once.
    void close();
    // Gives the file its name. After close().
    void commit();

  private:
    void flush();
    [[noreturn]] void fail(int error) const;

    std::string name_;
    std::string target_;  // where links lead
    std::string temporary_;
    std::unique_ptr<TemporaryName> guard_;
    int fd_ = -1;
    std::vector<char> buffer_;
};

extern template void OutputFile::write_values(const double*, std::size_t);
extern template void OutputFile::write_values(const std::int64_t*, std::size_t);
extern template void OutputFile::write_values(const std::uint64_t*, std::size_t);
extern template void OutputFile::write_values(const std::int32_t*, std::size_t);
extern template void OutputFile::write_values(const std::uint16_t*, std::size_t);
extern template void OutputFile::write_values(const std::uint8_t*, std::size_t);

// Files that belong together: none gets its name before all are complete.
class OutputSet {
  public:
    OutputFile& open(const std::string& path) { return files_.emplace_back(path); }
    // Brings all to the disk. What may fail, or be interrupted, does so here.
    void close();
    // Gives them their names, after close() if that was not called.
    void commit();

  private:
    std::list<OutputFile> files_;
    bool is_closed_ = false;
};

// The file that a chain of symbolic links leads to, so that a link stays a link.
std::string follow_links(const std::string& path);

// The part of a path before its last separator.
std::string directory_of(const std::string& path);

// Throws if `path` could not be written, so that a mistyped directory is not found out after an
// hour's work.
void check_writable(const std::string& path);

}  // namespace mgdt::cli
