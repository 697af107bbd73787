// SPDX-License-Identifier: MIT
// The program's interface to the operating system: files with names in UTF-8, terminals and
// signals. Each system has a file of its own. Functions that fail return -1, false or nothing, and
// set errno.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mgdt::cli::system {

enum class FileKind {
    regular,
    directory,
    stream,  // terminals and their like, sockets: what is written there does not change what is
             // read
    other    // pipes and disks
};

struct FileStatus {
    FileKind kind;
    std::uint64_t size;
    std::uint64_t device, number;  // identify the file, whatever its name
    unsigned permissions;
};
std::optional<FileStatus> status(const std::string& path);
std::optional<FileStatus> status(int file);

// Open files. Bytes are read and written unchanged.
int open_to_read(const std::string& path);
int open_to_write(const std::string& path);
// Creates a new file. The characters XXXXXX at the end of its name are replaced.
int create_temporary(std::string& name);
int standard_input();
int copy_of_standard_output();
std::ptrdiff_t read(int file, void* data, std::size_t size);
std::ptrdiff_t write(int file, const void* data, std::size_t size);
bool seek(int file, std::uint64_t offset);
// Writes all data to the disk. Returns true if the file is not on a disk.
bool synchronize(int file);
bool close(int file);
void set_permissions(int file, unsigned permissions);
unsigned permissions_of_new_files();

constexpr int standard_output = 1, standard_error = 2;
bool is_terminal(int file);

bool may_write(const std::string& path);
bool may_make_files_in(const std::string& directory);
// Renames a file, and replaces a file with the new name.
bool rename(const std::string& from, const std::string& to);
void remove(const char* path) noexcept;  // may be called by a signal handler
// The target of a symbolic link; nothing if the path is none.
std::optional<std::string> link_target(const std::string& path);
bool is_absolute(const std::string& path);
// The position of the last separator in a path, or npos.
std::size_t last_separator(const std::string& path);

// Calls the handler with the number of the signal when the user or the system asks the program to
// end. Closed pipes and limits of file sizes become errors of write().
void handle_signals(void (*handler)(int signal));
// Calls the handler again after a time. The handler may call this.
void signal_again_in(int milliseconds) noexcept;
[[noreturn]] void leave(int code) noexcept;  // ends the process at once

// The arguments of the command line, in UTF-8; and the program's file, or nothing.
std::vector<std::string> arguments(int argc, char** argv);
std::optional<std::string> program_file();

}  // namespace mgdt::cli::system
