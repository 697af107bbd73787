// SPDX-License-Identifier: MIT
#include "cli/output_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "cli/byte_order.hpp"
#include "cli/errors.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16;

std::string writing_remedy(int error) {
    switch (error) {
        case ENOSPC:
#if defined(EDQUOT)
        case EDQUOT:
#endif
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
                                         system_message(error), writing_remedy(error)));
}

// Whether the path is an existing device, pipe or socket, which a rename must not replace.
bool is_special(const std::string& path) {
    const auto status = system::status(path);
    return status && status->kind != system::FileKind::regular &&
           status->kind != system::FileKind::directory;
}

}  // namespace

std::string follow_links(const std::string& path) {
    std::string target = path;
    for (int depth = 0; depth < 40; ++depth) {
        const auto next = system::link_target(target);
        if (!next) return target;
        const std::size_t separator = system::last_separator(target);
        if (next->empty() || system::is_absolute(*next) || separator == std::string::npos) {
            target = *next;
        } else {
            target.replace(separator + 1, std::string::npos, *next);
        }
    }
    fail_writing(path, ELOOP);
}

std::string directory_of(const std::string& path) {
    const std::size_t separator = system::last_separator(path);
    if (separator == std::string::npos) return ".";
    // The name of the root is its separator; the name of a drive ends with one.
    const bool is_root = separator == 0 || path[separator] == ':';
    return path.substr(0, separator + (is_root ? 1 : 0));
}

void check_writable(const std::string& path) {
    if (path == "-") return;
    if (path.empty()) throw Error(exit_usage, "the output needs a name");
    const std::string target = follow_links(path);
    if (const auto status = system::status(target)) {
        if (status->kind == system::FileKind::directory) fail_writing(path, EISDIR);
        // A rename would silently replace a write-protected file.
        if (!system::may_write(target)) fail_writing(path, errno);
        if (status->kind != system::FileKind::regular) return;
    }
    if (!system::may_make_files_in(directory_of(target))) fail_writing(path, errno);
}

OutputFile::OutputFile(const std::string& path)
    : name_(path), buffer_(new char[buffer_size]) {  // not initialised: most files are short
    if (path == "-") {
        name_ = "standard output";
        fd_ = system::copy_of_standard_output();
        if (fd_ < 0) fail(errno);
        return;
    }
    check_writable(path);
    if (is_special(path)) {
        fd_ = system::open_to_write(path);
        if (fd_ < 0) fail(errno);
        return;
    }
    target_ = follow_links(path);
    // The temporary name is short and hidden, since the target's name may already have the greatest
    // length.
    const std::string directory = directory_of(target_);
    temporary_ = directory + (directory.back() == ':' ? ".mgdt-XXXXXX" : "/.mgdt-XXXXXX");
    fd_ = system::create_temporary(temporary_);
    if (fd_ < 0) {
        const int error = errno;
        temporary_.clear();
        fail(error);
    }
    guard_ = std::make_unique<TemporaryName>(temporary_);
    const auto status = system::status(target_);
    system::set_permissions(fd_, status ? status->permissions : system::permissions_of_new_files());
}

OutputFile::~OutputFile() {
    if (fd_ >= 0) system::close(fd_);
    if (!temporary_.empty()) system::remove(temporary_.c_str());
}

void OutputFile::fail(int error) const {
    fail_writing(name_, error);
}

void OutputFile::flush() {
    const char* p = buffer_.get();
    std::size_t left = used_;
    while (left > 0) {
        check_interrupt();
        const std::ptrdiff_t done = system::write(fd_, p, left);
        if (done < 0) {
            if (errno == EINTR) continue;
            fail(errno);
        }
        p += done;
        left -= static_cast<std::size_t>(done);
    }
    used_ = 0;
}

void OutputFile::write(const void* data, std::size_t size) {
    const char* p = static_cast<const char*>(data);
    while (size > 0) {
        const std::size_t part = std::min(size, buffer_size - used_);
        std::memcpy(buffer_.get() + used_, p, part);
        used_ += part;
        p += part;
        size -= part;
        if (used_ == buffer_size) flush();
    }
}

template <class T>
void OutputFile::write_text_of(T value) {
    constexpr std::size_t longest = 32;
    if (buffer_size - used_ <= longest) flush();
    char* const text = buffer_.get() + used_;
    const auto result = std::to_chars(text, text + longest, value);
    used_ += static_cast<std::size_t>(result.ptr - text);
}

void OutputFile::write_number(double value) {
    write_text_of(value);
}

void OutputFile::write_integer(std::int64_t value) {
    write_text_of(value);
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
template void OutputFile::write_values(const float*, std::size_t);
template void OutputFile::write_values(const std::uint32_t*, std::size_t);
template void OutputFile::write_values(const std::int64_t*, std::size_t);
template void OutputFile::write_values(const std::uint64_t*, std::size_t);
template void OutputFile::write_values(const std::int32_t*, std::size_t);
template void OutputFile::write_values(const std::uint16_t*, std::size_t);
template void OutputFile::write_values(const std::uint8_t*, std::size_t);

void OutputFile::close() {
    if (fd_ < 0) return;
    flush();
    if (!system::synchronize(fd_)) fail(errno);
    const int fd = fd_;
    fd_ = -1;
    if (!system::close(fd)) fail(errno);
}

void OutputFile::commit() {
    if (temporary_.empty()) return;
    if (!system::rename(temporary_, target_)) fail(errno);
    temporary_.clear();
    guard_.reset();
}

void OutputSet::close() {
    for (OutputFile& file : files_) file.close();
    check_interrupt();
    is_closed_ = true;
}

void OutputSet::commit() {
    if (!is_closed_) close();
    begin_commit();
    for (OutputFile& file : files_) file.commit();
}

}  // namespace mgdt::cli
