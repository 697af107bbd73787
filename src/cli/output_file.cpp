// SPDX-License-Identifier: MIT
#include "cli/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "cli/byte_order.hpp"
#include "cli/errors.hpp"

namespace mgdt::cli {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 20;

std::string remedy(int error) {
    switch (error) {
        case ENOSPC:
        case EDQUOT:
            return "; free some space or write elsewhere";
        case EFBIG:
            return "; raise the limit on file sizes (ulimit -f) or write elsewhere";
        case EACCES:
        case EPERM:
        case EROFS:
            return "; check the permissions or write elsewhere";
        case ENOENT:
        case ENOTDIR:
            return "; make the directory first";
        case EISDIR:
            return "; name a file inside it";
        case EPIPE:
            return "; the reading program ended first";
        default:
            return "";
    }
}

[[noreturn]] void fail_writing(const std::string& name, int error) {
    throw Error(exit_output, fmt::format("{}: cannot write: {}{}", printable(name),
                                         system_message(error), remedy(error)));
}

// Whether the path is there and is a device, pipe or socket, which cannot be renamed over.
bool is_special(const std::string& path) {
    struct stat status = {};
    return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

mode_t default_mode() {
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

}  // namespace

std::string follow_links(const std::string& path) {
    std::string target = path;
    for (int depth = 0; depth < 40; ++depth) {
        char link[PATH_MAX];
        const ssize_t length = readlink(target.c_str(), link, sizeof link);
        if (length < 0) return target;
        const std::string next(link, static_cast<std::size_t>(length));
        const std::size_t slash = target.rfind('/');
        if (next.empty() || next[0] == '/' || slash == std::string::npos) {
            target = next;
        } else {
            target.replace(slash + 1, std::string::npos, next);
        }
    }
    fail_writing(path, ELOOP);
}

std::string directory_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return ".";
    return slash == 0 ? "/" : path.substr(0, slash);
}

void check_writable(const std::string& path) {
    if (path == "-") return;
    if (path.empty()) throw Error(exit_usage, "the output needs a name");
    const std::string target = follow_links(path);
    struct stat status = {};
    if (stat(target.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) fail_writing(path, EISDIR);
        // A rename would replace a write-protected file without asking.
        if (access(target.c_str(), W_OK) != 0) fail_writing(path, errno);
        if (!S_ISREG(status.st_mode)) return;
    }
    if (access(directory_of(target).c_str(), W_OK | X_OK) != 0) fail_writing(path, errno);
}

OutputFile::OutputFile(const std::string& path) : name_(path) {
    buffer_.reserve(buffer_size);
    if (path == "-") {
        name_ = "standard output";
        fd_ = dup(STDOUT_FILENO);
        if (fd_ < 0) fail(errno);
        return;
    }
    check_writable(path);
    if (is_special(path)) {
        fd_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
        if (fd_ < 0) fail(errno);
        return;
    }
    target_ = follow_links(path);
    // Short and hidden: the target's own name may already be as long as names can be.
    temporary_ = directory_of(target_) + "/.mgdt-XXXXXX";
    fd_ = mkostemp(temporary_.data(), O_CLOEXEC);
    if (fd_ < 0) {
        const int error = errno;
        temporary_.clear();
        fail(error);
    }
    guard_ = std::make_unique<TemporaryName>(temporary_);
    struct stat status = {};
    const mode_t mode =
        stat(target_.c_str(), &status) == 0 ? status.st_mode & 07777 : default_mode();
    // Some file systems have no permissions to change.
    static_cast<void>(fchmod(fd_, mode) == 0);
}

OutputFile::~OutputFile() {
    if (fd_ >= 0) ::close(fd_);
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::fail(int error) const {
    fail_writing(name_, error);
}

void OutputFile::flush() {
    const char* p = buffer_.data();
    std::size_t left = buffer_.size();
    while (left > 0) {
        check_interrupt();
        const ssize_t done = ::write(fd_, p, left);
        if (done < 0) {
            if (errno == EINTR) continue;
            fail(errno);
        }
        p += done;
        left -= static_cast<std::size_t>(done);
    }
    buffer_.clear();
}

void OutputFile::write(const void* data, std::size_t size) {
    const char* p = static_cast<const char*>(data);
    while (size > 0) {
        const std::size_t part = std::min(size, buffer_size - buffer_.size());
        buffer_.insert(buffer_.end(), p, p + part);
        p += part;
        size -= part;
        if (buffer_.size() == buffer_size) flush();
    }
}

void OutputFile::write_number(double value) {
    char text[32];
    const auto result = std::to_chars(text, text + sizeof text, value);
    write(text, static_cast<std::size_t>(result.ptr - text));
}

void OutputFile::write_integer(std::int64_t value) {
    char text[32];
    const auto result = std::to_chars(text, text + sizeof text, value);
    write(text, static_cast<std::size_t>(result.ptr - text));
}

template <class T>
void OutputFile::write_values(const T* values, std::size_t count) {
    if (!host_is_big_endian()) {
        write(values, count * sizeof(T));
        return;
    }
    for (std::size_t i = 0; i < count; ++i) {
        char bytes[sizeof(T)];
        std::memcpy(bytes, values + i, sizeof(T));
        std::reverse(bytes, bytes + sizeof(T));
        write(bytes, sizeof(T));
    }
}

template void OutputFile::write_values(const double*, std::size_t);
template void OutputFile::write_values(const std::int64_t*, std::size_t);
template void OutputFile::write_values(const std::uint64_t*, std::size_t);
template void OutputFile::write_values(const std::int32_t*, std::size_t);
template void OutputFile::write_values(const std::uint16_t*, std::size_t);
template void OutputFile::write_values(const std::uint8_t*, std::size_t);

void OutputFile::close() {
    if (fd_ < 0) return;
    flush();
    // Pipes and terminals have nothing to synchronise. A disk that turns out full says so here.
    if (fsync(fd_) != 0 && errno != EINVAL && errno != EROFS && errno != ENOTSUP) fail(errno);
    const int fd = fd_;
    fd_ = -1;
    if (::close(fd) != 0 && errno != EINTR) fail(errno);
}

void OutputFile::commit() {
    if (temporary_.empty()) return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    temporary_.clear();
    guard_.reset();
}

void OutputSet::commit() {
    for (OutputFile& file : files_) file.close();
    check_interrupt();
    for (OutputFile& file : files_) file.commit();
}

}  // namespace mgdt::cli
