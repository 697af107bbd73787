// SPDX-License-Identifier: MIT
// The CSV table of finished runs, which grows a line a run and from which an interrupted
// measurement goes on.
#pragma once

#include <string>
#include <vector>

#include "bench/row.hpp"

namespace mgdt::cli::bench {

class ResultFile {
  public:
    // Makes the file, or reads the rows of one that is there. A last line that is not whole is cut
    // off. Throws Error for a file of something else, or one that another program is writing.
    explicit ResultFile(const std::string& path);
    ~ResultFile();
    ResultFile(const ResultFile&) = delete;
    ResultFile& operator=(const ResultFile&) = delete;

    // The rows that were there.
    const std::vector<Row>& rows() const { return rows_; }

    // The line is with the system when this returns.
    void append(const Row& row);

  private:
    // Against other programs.
    void lock() const;
    // The rows of what is there; a heading where there is nothing.
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
