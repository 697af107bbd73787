// SPDX-License-Identifier: MIT
#include "bench/peers.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <climits>
#include <vector>

#include "cli/errors.hpp"

namespace mgdt::cli::bench {
namespace {

std::string runner_name(const std::string& peer) {
    return "mgdt-peer-" + peer;
}

std::string program_directory() {
    char path[PATH_MAX];
    const ssize_t length = readlink("/proc/self/exe", path, sizeof path);
    if (length <= 0) return ".";
    const std::string program(path, static_cast<std::size_t>(length));
    return program.substr(0, program.rfind('/'));
}

std::vector<std::string> folders(const std::string& directory) {
    if (!directory.empty()) return {directory};
    const std::string here = program_directory();
    return {here, here + "/../../tests/bench/peers"};
}

const char* packages(const std::string& peer) {
    if (peer == "cgal") return "libcgal-dev, libboost-dev, libgmp-dev and libmpfr-dev";
    if (peer == "tetgen") return "libtet1.5-dev";
    return "libqhull-dev";
}

}  // namespace

std::string find_runner(const std::string& peer, const std::string& directory) {
    for (const std::string& folder : folders(directory)) {
        std::string path = folder + "/" + runner_name(peer);
        if (access(path.c_str(), X_OK) == 0) return path;
    }
    return "";
}

std::string how_to_get_runner(const std::string& peer, const std::string& directory) {
    return fmt::format(
        "{} is not timed: there is no {} in {}; install {}, build mgdt from its source with "
        "-Dtests=auto and name the build folder's tests/bench/peers with --peer-directory",
        peer, runner_name(peer),
        directory.empty() ? "the program's build folder" : quote(directory), packages(peer));
}

}  // namespace mgdt::cli::bench
