// SPDX-License-Identifier: MIT
#include "cli/file_identity.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/errors.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli {

std::optional<FileIdentity> identity_of(const std::string& name, const struct stat& status) {
    if (S_ISCHR(status.st_mode) || S_ISSOCK(status.st_mode)) return std::nullopt;
    return FileIdentity{printable(name), status.st_dev, status.st_ino, ""};
}

std::optional<FileIdentity> identity_of_input(const std::string& path) {
    struct stat status = {};
    if (stat(path.c_str(), &status) != 0) return std::nullopt;
    return identity_of(path, status);
}

std::optional<FileIdentity> identity_of_output(const std::string& path) {
    struct stat status = {};
    if (path == "-") {
        if (fstat(STDOUT_FILENO, &status) != 0) return std::nullopt;
        return identity_of("standard output", status);
    }
    if (stat(path.c_str(), &status) == 0) return identity_of(path, status);
    const std::string target = follow_links(path);
    const std::string directory = directory_of(target);
    if (stat(directory.c_str(), &status) != 0) return std::nullopt;
    return FileIdentity{printable(path), status.st_dev, status.st_ino,
                        target.substr(target.rfind('/') + 1)};
}

void require_apart(const std::vector<FileIdentity>& inputs,
                   const std::vector<std::string>& outputs) {
    std::vector<FileIdentity> seen;
    for (const std::string& path : outputs) {
        const std::optional<FileIdentity> output = identity_of_output(path);
        if (!output) continue;
        for (const FileIdentity& input : inputs) {
            if (!output->is_same_file(input)) continue;
            const std::string which =
                output->name == input.name ? "" : fmt::format(" {}", input.name);
            throw Error(exit_usage,
                        fmt::format("{}: would overwrite the input{}; name another output",
                                    output->name, which));
        }
        for (const FileIdentity& other : seen) {
            if (!output->is_same_file(other)) continue;
            throw Error(
                exit_usage,
                fmt::format("{}: the same file as another output{}; name "
                            "another file",
                            output->name, output->name == other.name ? "" : ", " + other.name));
        }
        seen.push_back(*output);
    }
}

}  // namespace mgdt::cli
