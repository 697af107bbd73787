// SPDX-License-Identifier: MIT
// What the program asks the system for: files by names in UTF-8, terminals and signals, each system
// in a file of its own. What fails returns -1, false or nothing, and sets errno.
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
    other    // pipes, disks
};

struct FileStatus {
    FileKind kind;
    std::uint64_t size;
    std::uint64_t device, number;  // which file it is, whatever its name
    unsigned permissions;
};
std::optional<FileStatus> status(const std::string& path);
std::optional<FileStatus> status(int file);

// Files that are open; bytes are not changed on the way.
int open_to_read(const std::string& path);
int open_to_write(const std::string& path);
// A new file; its name gets letters where it ends in XXXXXX.
int create_temporary(std::string& name);
int standard_input();
int copy_of_standard_output();
std::ptrdiff_t read(int file, void* data, std::size_t size);
std::ptrdiff_t write(int file, const void* data, std::size_t size);
bool seek(int file, std::uint64_t offset);
// Brings what was written to the disk; true where there is none.
bool synchronize(int file);
bool close(int file);
void set_permissions(int file, unsigned permissions);
unsigned permissions_of_new_files();

constexpr int standard_output = 1, standard_error = 2;
bool is_terminal(int file);

bool may_write(const std::string& path);
bool may_make_files_in(const std::string& directory);
// Over a file of that name too.
bool rename(const std::string& from, const std::string& to);
void remove(const char* path) noexcept;  // may be called when a signal comes
// Where a symbolic link leads; nothing for what is none.
std::optional<std::string> link_target(const std::string& path);
bool is_absolute(const std::string& path);
// Of the last character that separates a folder from what is in it, or npos.
std::size_t last_separator(const std::string& path);

// Calls the handler when the user or the system asks the program to end, with the signal's number.
// Pipes that were closed and limits of file sizes come back as errors of write().
void handle_signals(void (*handler)(int signal));
// Calls it again after a time. May be called by the handler.
void signal_again_in(int milliseconds) noexcept;
[[noreturn]] void leave(int code) noexcept;  // at once

// The words of the command line, in UTF-8; and the program's file, or nothing.
std::vector<std::string> arguments(int argc, char** argv);
std::optional<std::string> program_file();

}  // namespace mgdt::cli::system
