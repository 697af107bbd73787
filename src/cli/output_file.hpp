// SPDX-License-Identifier: MIT
// Output that appears completely or not at all. It is written under a temporary name in the same
// directory and renamed when all bytes are on the disk; otherwise it is removed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <string_view>

#include "cli/interrupt.hpp"

namespace mgdt::cli {

class OutputFile {
  public:
    // "-" is standard output. Devices, pipes and sockets are written directly.
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(const void* data, std::size_t size);
    void write(std::string_view text) { write(text.data(), text.size()); }
    // Writes the shortest text that reads back as the same number.
    void write_number(double value);
    void write_integer(std::int64_t value);
    // Writes binary values in little-endian order.
    template <class T>
    void write_values(const T* values, std::size_t count);
    template <class T>
    void write_value(T value) {
        write_values(&value, 1);
    }

    // Writes all bytes to the disk; the file keeps its temporary name. Called once.
    void close();
    // Gives the file its final name, after close().
    void commit();

  private:
    void flush();
    template <class T>
    void write_text_of(T value);
    [[noreturn]] void fail(int error) const;

    std::string name_;
    std::string target_;  // the file that links lead to
    std::string temporary_;
    std::unique_ptr<TemporaryName> guard_;
    int fd_ = -1;
    std::unique_ptr<char[]> buffer_;
    std::size_t used_ = 0;  // of the buffer
};

extern template void OutputFile::write_values(const double*, std::size_t);
extern template void OutputFile::write_values(const float*, std::size_t);
extern template void OutputFile::write_values(const std::uint32_t*, std::size_t);
extern template void OutputFile::write_values(const std::int64_t*, std::size_t);
extern template void OutputFile::write_values(const std::uint64_t*, std::size_t);
extern template void OutputFile::write_values(const std::int32_t*, std::size_t);
extern template void OutputFile::write_values(const std::uint16_t*, std::size_t);
extern template void OutputFile::write_values(const std::uint8_t*, std::size_t);

// Files that belong together: none gets its final name before all are complete.
class OutputSet {
  public:
    OutputFile& open(const std::string& path) { return files_.emplace_back(path); }
    // Writes all files to the disk. Errors and interruptions happen here.
    void close();
    // Gives all files their final names; calls close() first if that was not done.
    void commit();

  private:
    std::list<OutputFile> files_;
    bool is_closed_ = false;
};

// The file at the end of a chain of symbolic links, so that a link remains a link.
std::string follow_links(const std::string& path);

// The part of a path before its last separator.
std::string directory_of(const std::string& path);

// Throws if `path` cannot be written, so that a mistyped directory is found before the work begins.
void check_writable(const std::string& path);

}  // namespace mgdt::cli
