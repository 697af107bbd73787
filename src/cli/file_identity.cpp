// SPDX-License-Identifier: MIT
#include "cli/file_identity.hpp"

#include <fmt/core.h>

#include "cli/errors.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli {

std::optional<FileIdentity> identity_of(const std::string& name, const system::FileStatus& status) {
    if (status.kind == system::FileKind::stream) return std::nullopt;
    return FileIdentity{printable(name), status.device, status.number, ""};
}

std::optional<FileIdentity> identity_of_input(const std::string& path) {
    const auto status = system::status(path);
    if (!status) return std::nullopt;
    return identity_of(path, *status);
}

std::optional<FileIdentity> identity_of_output(const std::string& path) {
    if (path == "-") {
        const auto status = system::status(system::standard_output);
        if (!status) return std::nullopt;
        return identity_of("standard output", *status);
    }
    if (const auto status = system::status(path)) return identity_of(path, *status);
    const std::string target = follow_links(path);
    const std::string directory = directory_of(target);
    const auto status = system::status(directory);
    if (!status) return std::nullopt;
    return FileIdentity{printable(path), status->device, status->number,
                        target.substr(system::last_separator(target) + 1)};
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
