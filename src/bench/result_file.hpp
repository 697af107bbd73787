// SPDX-License-Identifier: MIT
// The CSV table of finished runs. It gets one line per run, and an interrupted measurement
// continues from it.
#pragma once

#include <string>
#include <vector>

#include "bench/row.hpp"

namespace mgdt::cli::bench {

class ResultFile {
  public:
    // Creates the file, or reads the rows of an existing one and cuts an incomplete last line off.
    // Throws Error if the file is no such table, or if another program is writing it.
    explicit ResultFile(const std::string& path);
    ~ResultFile();
    ResultFile(const ResultFile&) = delete;
    ResultFile& operator=(const ResultFile&) = delete;

    // The rows that the file had.
    const std::vector<Row>& rows() const { return rows_; }

    // Appends a row. The system has the line when this returns.
    void append(const Row& row);

  private:
    // Locks the file against other programs.
    void lock() const;
    // Reads the rows, or writes the heading of an empty file.
    void load();
    std::string read() const;
    void truncate(std::size_t size);
    void write_line(std::string line);
    [[noreturn]] void fail(int error) const;
    [[noreturn]] void refuse(const std::string& reason) const;

    std::string path_;
    int fd_ = -1;
    std::vector<Row> rows_;
};

}  // namespace mgdt::cli::bench
