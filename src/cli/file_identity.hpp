// SPDX-License-Identifier: MIT
// Which file a name leads to, whatever its spelling and the links on the way, so that no output
// destroys an input.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/system.hpp"

namespace mgdt::cli {

struct FileIdentity {
    std::string name;  // as messages say it
    std::uint64_t device = 0, number = 0;
    std::string entry;  // of a file that is not there yet: its name in the directory of that number

    bool is_same_file(const FileIdentity& other) const {
        return device == other.device && number == other.number && entry == other.entry;
    }
};

// Of a file that is there. Nothing for terminals and sockets, where what is written does not change
// what is read, and devices such as /dev/null.
std::optional<FileIdentity> identity_of(const std::string& name, const system::FileStatus& status);

// Of a file that is read by name; nothing if it is not there.
std::optional<FileIdentity> identity_of_input(const std::string& path);

// Of a file that is to be written, which need not be there; "-" is standard output.
std::optional<FileIdentity> identity_of_output(const std::string& path);

// Throws a usage error if one of the outputs is one of the inputs, or another one of the outputs.
void require_apart(const std::vector<FileIdentity>& inputs,
                   const std::vector<std::string>& outputs);

}  // namespace mgdt::cli
