// SPDX-License-Identifier: MIT
// The interface of system.hpp on Windows. Names of files are in UTF-16 there. Files are opened in
// binary mode, since Windows would change line ends.
#include <windows.h>

// These headers need those above.
#include <fcntl.h>
#include <io.h>
#include <shellapi.h>
#include <sys/stat.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <random>

#include "cli/system.hpp"

namespace mgdt::cli::system {
namespace {

std::wstring wide(const std::string& text) {
    const int size = static_cast<int>(text.size());
    const int length = MultiByteToWideChar(CP_UTF8, 0, text.data(), size, nullptr, 0);
    std::wstring out(static_cast<std::size_t>(length), L'\0');
    MultiByteToWideChar(CP_UTF8, 0, text.data(), size, out.data(), length);
    return out;
}

std::string narrow(const wchar_t* text) {
    const int length = WideCharToMultiByte(CP_UTF8, 0, text, -1, nullptr, 0, nullptr, nullptr);
    if (length <= 0) return {};
    std::string out(static_cast<std::size_t>(length), '\0');
    WideCharToMultiByte(CP_UTF8, 0, text, -1, out.data(), length, nullptr, nullptr);
    out.pop_back();  // the terminating zero
    return out;
}

// Sets errno after the failure of a Windows function.
void set_errno() {
    switch (GetLastError()) {
        case ERROR_FILE_NOT_FOUND:
        case ERROR_PATH_NOT_FOUND:
        case ERROR_INVALID_NAME:
            errno = ENOENT;
            break;
        case ERROR_ACCESS_DENIED:
        case ERROR_SHARING_VIOLATION:
            errno = EACCES;
            break;
        case ERROR_DISK_FULL:
            errno = ENOSPC;
            break;
        case ERROR_FILE_EXISTS:
        case ERROR_ALREADY_EXISTS:
            errno = EEXIST;
            break;
        case ERROR_BROKEN_PIPE:
        case ERROR_NO_DATA:
            errno = EPIPE;
            break;
        default:
            errno = EIO;
    }
}

std::optional<FileStatus> status_of(HANDLE file) {
    FileStatus s = {FileKind::other, 0, 0, 0, 0};
    const DWORD type = GetFileType(file);
    // Pipes have no identity on Windows.
    if (type == FILE_TYPE_CHAR || type == FILE_TYPE_PIPE) s.kind = FileKind::stream;
    if (type != FILE_TYPE_DISK) return s;
    BY_HANDLE_FILE_INFORMATION information;
    if (!GetFileInformationByHandle(file, &information)) {
        set_errno();
        return std::nullopt;
    }
    const bool is_directory = (information.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
    s.kind = is_directory ? FileKind::directory : FileKind::regular;
    s.size = std::uint64_t{information.nFileSizeHigh} << 32 | information.nFileSizeLow;
    s.device = information.dwVolumeSerialNumber;
    s.number = std::uint64_t{information.nFileIndexHigh} << 32 | information.nFileIndexLow;
    return s;
}

void (*the_handler)(int) = nullptr;
DWORD milliseconds_until_again = 0;

BOOL WINAPI on_event(DWORD event) {
    // This runs on a separate thread, which may wait. Windows ends the program when it returns,
    // unless the event came from the keyboard, and soon in any case.
    the_handler(event == CTRL_C_EVENT ? SIGINT : SIGTERM);
    if (milliseconds_until_again > 0) {
        Sleep(milliseconds_until_again);
        the_handler(SIGTERM);
    }
    return TRUE;
}

}  // namespace

std::optional<FileStatus> status(const std::string& path) {
    // This also opens folders.
    const HANDLE file =
        CreateFileW(wide(path).c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                    nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
    if (file == INVALID_HANDLE_VALUE) {
        set_errno();
        return std::nullopt;
    }
    const std::optional<FileStatus> s = status_of(file);
    CloseHandle(file);
    return s;
}

std::optional<FileStatus> status(int file) {
    const auto handle = reinterpret_cast<HANDLE>(_get_osfhandle(file));
    if (handle == INVALID_HANDLE_VALUE) return std::nullopt;
    return status_of(handle);
}

int open_to_read(const std::string& path) {
    if (const auto s = status(path); s && s->kind == FileKind::directory) {
        errno = EISDIR;
        return -1;
    }
    return _wopen(wide(path).c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

int open_to_write(const std::string& path) {
    return _wopen(wide(path).c_str(), _O_WRONLY | _O_BINARY | _O_NOINHERIT);
}

int create_temporary(std::string& name) {
    std::random_device random;
    for (int attempt = 0; attempt < 100; ++attempt) {
        std::uint64_t number = std::uint64_t{random()} << 32 | random();
        for (std::size_t i = name.size() - 6; i < name.size(); ++i, number /= 36)
            name[i] = "0123456789abcdefghijklmnopqrstuvwxyz"[number % 36];
        // remove() may delete the file while it is open.
        const HANDLE file = CreateFileW(wide(name).c_str(), GENERIC_WRITE | DELETE,
                                        FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr, CREATE_NEW,
                                        FILE_ATTRIBUTE_NORMAL, nullptr);
        if (file != INVALID_HANDLE_VALUE)
            return _open_osfhandle(reinterpret_cast<std::intptr_t>(file), _O_BINARY | _O_NOINHERIT);
        set_errno();
        if (errno != EEXIST) return -1;
    }
    return -1;
}

int standard_input() {
    _setmode(0, _O_BINARY);
    return 0;
}

int copy_of_standard_output() {
    std::fflush(stdout);
    _setmode(standard_output, _O_BINARY);
    return _dup(standard_output);
}

std::ptrdiff_t read(int file, void* data, std::size_t size) {
    return _read(file, data, static_cast<unsigned>(size));
}

std::ptrdiff_t write(int file, const void* data, std::size_t size) {
    const std::ptrdiff_t done = _write(file, data, static_cast<unsigned>(size));
    // C reports EINVAL for a pipe that nobody reads.
    if (done < 0 && errno == EINVAL) errno = EPIPE;
    return done;
}

bool seek(int file, std::uint64_t offset) {
    return _lseeki64(file, static_cast<__int64>(offset), SEEK_SET) >= 0;
}

bool synchronize(int file) {
    const auto s = status(file);
    return !s || s->kind != FileKind::regular || _commit(file) == 0;
}

bool close(int file) {
    return _close(file) == 0;
}

void set_permissions(int, unsigned) {}

unsigned permissions_of_new_files() {
    return 0;
}

bool is_terminal(int file) {
    DWORD mode = 0;
    return GetConsoleMode(reinterpret_cast<HANDLE>(_get_osfhandle(file)), &mode) != 0;
}

bool may_write(const std::string& path) {
    return _waccess(wide(path).c_str(), 2) == 0;
}

bool may_make_files_in(const std::string& directory) {
    // Whether it is permitted is only known after trying.
    const auto s = status(directory);
    if (s && s->kind != FileKind::directory) errno = ENOTDIR;
    return s && s->kind == FileKind::directory;
}

bool rename(const std::string& from, const std::string& to) {
    if (MoveFileExW(wide(from).c_str(), wide(to).c_str(), MOVEFILE_REPLACE_EXISTING)) return true;
    set_errno();
    return false;
}

void remove(const char* path) noexcept {
    DeleteFileW(wide(path).c_str());
}

std::optional<std::string> link_target(const std::string&) {
    errno = EINVAL;
    return std::nullopt;
}

bool is_absolute(const std::string& path) {
    return !path.empty() && (path[0] == '/' || path[0] == '\\' || path.substr(1, 1) == ":");
}

std::size_t last_separator(const std::string& path) {
    return path.find_last_of("/\\:");
}

void handle_signals(void (*handler)(int signal)) {
    the_handler = handler;
    SetConsoleCtrlHandler(on_event, TRUE);
}

void signal_again_in(int milliseconds) noexcept {
    milliseconds_until_again = static_cast<DWORD>(milliseconds);
}

void leave(int code) noexcept {
    TerminateProcess(GetCurrentProcess(), static_cast<UINT>(code));
    std::abort();
}

std::vector<std::string> arguments(int argc, char** argv) {
    SetConsoleOutputCP(CP_UTF8);
    // Output has the same bytes as on other systems.
    _setmode(standard_output, _O_BINARY);
    _setmode(standard_error, _O_BINARY);
    int count = 0;
    wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
    if (words == nullptr) return {argv, argv + argc};
    std::vector<std::string> out;
    for (int i = 0; i < count; ++i) out.push_back(narrow(words[i]));
    LocalFree(words);
    return out;
}

std::optional<std::string> program_file() {
    wchar_t name[32768];
    const DWORD length = GetModuleFileNameW(nullptr, name, 32768);
    if (length == 0 || length == 32768) return std::nullopt;
    return narrow(name);
}

}  // namespace mgdt::cli::system
