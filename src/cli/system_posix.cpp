// SPDX-License-Identifier: MIT
// The interface of system.hpp on POSIX.
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>

#include "cli/system.hpp"

namespace mgdt::cli::system {
namespace {

FileStatus status_of(const struct stat& s) {
    const FileKind kind = S_ISREG(s.st_mode)                          ? FileKind::regular
                          : S_ISDIR(s.st_mode)                        ? FileKind::directory
                          : S_ISCHR(s.st_mode) || S_ISSOCK(s.st_mode) ? FileKind::stream
                                                                      : FileKind::other;
    return {kind, static_cast<std::uint64_t>(s.st_size), static_cast<std::uint64_t>(s.st_dev),
            static_cast<std::uint64_t>(s.st_ino), static_cast<unsigned>(s.st_mode & 07777)};
}

}  // namespace

std::optional<FileStatus> status(const std::string& path) {
    struct stat s = {};
    if (stat(path.c_str(), &s) != 0) return std::nullopt;
    return status_of(s);
}

std::optional<FileStatus> status(int file) {
    struct stat s = {};
    if (fstat(file, &s) != 0) return std::nullopt;
    return status_of(s);
}

int open_to_read(const std::string& path) {
    return open(path.c_str(), O_RDONLY | O_CLOEXEC);
}

int open_to_write(const std::string& path) {
    return open(path.c_str(), O_WRONLY | O_CLOEXEC);
}

int create_temporary(std::string& name) {
    return mkostemp(name.data(), O_CLOEXEC);
}

int standard_input() {
    return STDIN_FILENO;
}

int copy_of_standard_output() {
    return dup(STDOUT_FILENO);
}

std::ptrdiff_t read(int file, void* data, std::size_t size) {
    return ::read(file, data, size);
}

std::ptrdiff_t write(int file, const void* data, std::size_t size) {
    return ::write(file, data, size);
}

bool seek(int file, std::uint64_t offset) {
    return lseek(file, static_cast<off_t>(offset), SEEK_SET) >= 0;
}

bool synchronize(int file) {
    // Pipes and terminals cannot be synchronised. A full disk is reported here.
    return fsync(file) == 0 || errno == EINVAL || errno == EROFS || errno == ENOTSUP;
}

bool close(int file) {
    return ::close(file) == 0 || errno == EINTR;
}

void set_permissions(int file, unsigned permissions) {
    // Some file systems do not have permissions.
    static_cast<void>(fchmod(file, static_cast<mode_t>(permissions)) == 0);
}

unsigned permissions_of_new_files() {
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~static_cast<unsigned>(mask);
}

bool is_terminal(int file) {
    return isatty(file) == 1;
}

bool may_write(const std::string& path) {
    return access(path.c_str(), W_OK) == 0;
}

bool may_make_files_in(const std::string& directory) {
    return access(directory.c_str(), W_OK | X_OK) == 0;
}

bool rename(const std::string& from, const std::string& to) {
    return std::rename(from.c_str(), to.c_str()) == 0;
}

void remove(const char* path) noexcept {
    unlink(path);
}

std::optional<std::string> link_target(const std::string& path) {
    char link[PATH_MAX];
    const ssize_t length = readlink(path.c_str(), link, sizeof link);
    if (length < 0) return std::nullopt;
    return std::string(link, static_cast<std::size_t>(length));
}

bool is_absolute(const std::string& path) {
    return !path.empty() && path[0] == '/';
}

std::size_t last_separator(const std::string& path) {
    return path.rfind('/');
}

void handle_signals(void (*handler)(int signal)) {
    struct sigaction action = {};
    sigemptyset(&action.sa_mask);
    action.sa_handler = handler;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction old = {};
        // nohup and background shells ignore signals on purpose.
        if (sigaction(signal, nullptr, &old) == 0 && old.sa_handler == SIG_IGN) continue;
        sigaction(signal, &action, nullptr);
    }
    sigaction(SIGALRM, &action, nullptr);
    action.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &action, nullptr);
    sigaction(SIGXFSZ, &action, nullptr);
}

void signal_again_in(int milliseconds) noexcept {
    itimerval timer = {};
    timer.it_value.tv_sec = milliseconds / 1000;
    timer.it_value.tv_usec = milliseconds % 1000 * 1000;
    setitimer(ITIMER_REAL, &timer, nullptr);
}

void leave(int code) noexcept {
    _exit(code);
}

std::vector<std::string> arguments(int argc, char** argv) {
    return {argv, argv + argc};
}

std::optional<std::string> program_file() {
    return link_target("/proc/self/exe");
}

}  // namespace mgdt::cli::system
