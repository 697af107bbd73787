// SPDX-License-Identifier: MIT
#include "cli/input_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <limits>
#include <new>

#include "cli/errors.hpp"
#include "cli/gzip.hpp"
#include "cli/interrupt.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {

void Source::fail(const std::string& what) const {
    throw Error(exit_input, fmt::format("{}: {}", name, what));
}

void Source::fail_at_line(std::size_t line, const std::string& what) const {
    throw Error(exit_input, fmt::format("{}: line {}: {}", name, line, what));
}

void Source::fail_at_byte(std::size_t offset, const std::string& what) const {
    throw Error(exit_input, fmt::format("{}: byte {}: {}", name, begin + offset, what));
}

void InputFile::Free::operator()(char* p) const noexcept {
    std::free(p);
}

namespace {

struct Descriptor {
    int fd;
    bool owned;
    ~Descriptor() {
        if (owned && fd >= 0) system::close(fd);
    }
};

std::string reading_remedy(int error) {
    switch (error) {
        case ENOENT:
        case ENOTDIR:
            return "; check the name";
        case EACCES:
        case EPERM:
            return "; check its permissions";
        case EISDIR:
            return "; name a file inside it";
        default:
            return "";
    }
}

[[noreturn]] void fail_reading(const std::string& name, int error) {
    throw Error(exit_input, fmt::format("{}: cannot read: {}{}", name, system_message(error),
                                        reading_remedy(error)));
}

}  // namespace

std::string input_name(const std::string& path) {
    return path == "-" ? "standard input" : printable(path);
}

InputFile::InputFile(const std::string& path, std::size_t begin, std::size_t most) : begin_(begin) {
    const bool standard = path == "-";
    name_ = input_name(path);
    if (!standard) path_ = path;
    Descriptor file{standard ? system::standard_input() : system::open_to_read(path), !standard};
    if (file.fd < 0) fail_reading(name_, errno);
    const auto status = system::status(file.fd);
    if (!status) fail_reading(name_, errno);
    if (status->kind == system::FileKind::directory) fail_reading(name_, EISDIR);
    identity_ = identity_of(name_, *status);

    // The size is only a hint: pipes have none, and a file may grow while it is read.
    std::size_t wanted = std::size_t{1} << 16;
    if (status->kind == system::FileKind::regular) {
        file_size_ = static_cast<std::size_t>(status->size);
        if (begin > 0 && !system::seek(file.fd, begin)) fail_reading(name_, errno);
        if (*file_size_ > begin) wanted = *file_size_ - begin + 1;
    }
    wanted = std::min(wanted, most);
    std::size_t capacity = 0;
    while (size_ < most) {
        if (size_ == capacity) {
            if (capacity > std::numeric_limits<std::size_t>::max() / 2) throw std::bad_alloc();
            capacity = std::min(std::max(wanted, 2 * capacity), most);
            char* p = static_cast<char*>(std::realloc(data_.get(), capacity));
            if (!p) throw std::bad_alloc();
            static_cast<void>(data_.release());
            data_.reset(p);
        }
        check_interrupt();
        constexpr std::size_t chunk = std::size_t{1} << 24;
        const std::size_t room = capacity - size_;
        const std::ptrdiff_t got =
            system::read(file.fd, data_.get() + size_, room < chunk ? room : chunk);
        if (got == 0) break;
        if (got < 0) {
            if (errno == EINTR) continue;
            fail_reading(name_, errno);
        }
        size_ += static_cast<std::size_t>(got);
    }
    if (!standard && most == whole && is_gzip_name(path)) {
        expanded_ = expand_gzip({data_.get(), size_}, name_);
        data_.reset();
        path_.resize(path_.size() - 3);
    }
}

}  // namespace mgdt::cli
