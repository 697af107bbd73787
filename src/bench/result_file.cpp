// SPDX-License-Identifier: MIT
#include "bench/result_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <set>

#include "cli/errors.hpp"
#include "cli/output_file.hpp"
#include "mgdt/mgdt.h"

namespace mgdt::cli::bench {

ResultFile::ResultFile(const std::string& path) : path_(path) {
    check_writable(path);
    fd_ = open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (fd_ < 0) fail(errno);
    try {
        lock();
        load();
    } catch (...) {
        close(fd_);
        throw;
    }
}

ResultFile::~ResultFile() {
    close(fd_);
}

void ResultFile::lock() const {
    struct stat status = {};
    if (fstat(fd_, &status) != 0) fail(errno);
    if (!S_ISREG(status.st_mode)) {
        throw Error(exit_output, fmt::format("{}: not a file that rows can be read back from; "
                                             "name a file",
                                             path_));
    }
    // The lock belongs to the process, so a child that outlives it for a moment does not hold it.
    struct flock whole = {};
    whole.l_type = F_WRLCK;
    whole.l_whence = SEEK_SET;
    if (fcntl(fd_, F_SETLK, &whole) != 0) {
        throw Error(exit_output, fmt::format("{}: another mgdt-bench is writing it; name another "
                                             "file or wait",
                                             path_));
    }
}

void ResultFile::load() {
    const std::string text = read();
    const std::string heading = csv_heading() + "\n";
    if (text.size() < heading.size() && heading.compare(0, text.size(), text) == 0) {
        // The file is new, or was cut off within the heading.
        truncate(0);
        write_line(heading);
        return;
    }
    if (text.compare(0, heading.size(), heading) != 0) {
        refuse("its first line is not the heading of this version's table");
    }
    std::set<std::string> keys;
    std::size_t begin = heading.size();
    for (std::size_t number = 2; begin < text.size(); ++number) {
        const std::size_t end = text.find('\n', begin);
        if (end == std::string::npos) {
            truncate(begin);
            return;
        }
        const std::optional<Row> row = from_csv(std::string_view(text).substr(begin, end - begin));
        if (!row) refuse(fmt::format("line {} is not one of such a table", number));
        if (row->library == "mgdt" && row->version != mgdt_version_string()) {
            refuse(fmt::format("line {} is of mgdt {}, and this is mgdt {}", number,
                               quote(row->version), mgdt_version_string()));
        }
        if (!keys.insert(row->key()).second) {
            refuse(fmt::format("line {} is a run that an earlier line has", number));
        }
        rows_.push_back(*row);
        begin = end + 1;
    }
}

void ResultFile::truncate(std::size_t size) {
    if (ftruncate(fd_, static_cast<off_t>(size)) != 0) fail(errno);
}

void ResultFile::append(const Row& row) {
    write_line(to_csv(row) + "\n");
}

std::string ResultFile::read() const {
    std::string text;
    char buffer[1 << 16];
    for (;;) {
        const ssize_t got = ::read(fd_, buffer, sizeof buffer);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(errno);
        if (got == 0) return text;
        text.append(buffer, static_cast<std::size_t>(got));
    }
}

void ResultFile::write_line(std::string line) {
    while (!line.empty()) {
        const ssize_t wrote = write(fd_, line.data(), line.size());
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote < 0) fail(errno);
        line.erase(0, static_cast<std::size_t>(wrote));
    }
}

void ResultFile::fail(int error) const {
    throw Error(exit_output, fmt::format("{}: cannot write: {}", path_, system_message(error)));
}

void ResultFile::refuse(const std::string& reason) const {
    throw Error(exit_input, fmt::format("{}: not a table that this run can go on from: {}; name "
                                        "another file",
                                        path_, reason));
}

}  // namespace mgdt::cli::bench
