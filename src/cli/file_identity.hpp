// SPDX-License-Identifier: MIT
// Identifies the file that a name leads to, whatever its spelling and the links on the way, so that
// no output overwrites an input.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/system.hpp"

namespace mgdt::cli {

struct FileIdentity {
    std::string name;  // the name in messages
    std::uint64_t device = 0, number = 0;
    std::string entry;  // for a file that does not exist yet: its name in the directory that
                        // `number` identifies

    bool is_same_file(const FileIdentity& other) const {
        return device == other.device && number == other.number && entry == other.entry;
    }
};

// The identity of an existing file. Nothing for terminals and sockets, where writing does not
// change what is read, and for devices such as /dev/null.
std::optional<FileIdentity> identity_of(const std::string& name, const system::FileStatus& status);

// The identity of an input; nothing if the file does not exist.
std::optional<FileIdentity> identity_of_input(const std::string& path);

// The identity of an output, which need not exist; "-" is standard output.
std::optional<FileIdentity> identity_of_output(const std::string& path);

// Throws a usage error if an output is the same file as an input or as another output.
void require_apart(const std::vector<FileIdentity>& inputs,
                   const std::vector<std::string>& outputs);

}  // namespace mgdt::cli
