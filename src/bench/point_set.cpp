// SPDX-License-Identifier: MIT
#include "bench/point_set.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <string_view>

#include "bench/child.hpp"
#include "bench/status.hpp"
#include "cli/errors.hpp"
#include "cli/point_sets/distributions.hpp"

namespace mgdt::cli::bench {
namespace {

constexpr std::string_view mild = "mild-";
constexpr const char* mild_kinds[] = {"line", "diagonal", "ellipse", "sphere", "spiral", "cluster"};

std::vector<double> make(const PointSetName& name, const std::string& data_directory) {
    GenerateOptions options;
    options.seed = name.seed;
    options.data_directory = data_directory;
    std::string kind = name.distribution;
    if (kind.compare(0, mild.size(), mild) == 0) {
        kind.erase(0, mild.size());
        // S.H. Lo (2014), section 5: 1% of the larger dimension, and power 3 in equation (1).
        if (kind == "cluster") {
            options.power = 3;
        } else {
            options.width = 1e-2;
        }
    }
    return generate(kind, name.points, options);
}

// A file without a name, which vanishes when the last process closes it. The file is on a disk,
// since large sets need the memory for themselves.
int nameless_file() {
    const char* directory = std::getenv("TMPDIR");
    std::string path = std::string(directory != nullptr && *directory != '\0' ? directory : "/tmp");
    path += "/mgdt-bench-XXXXXX";
    const int fd = mkstemp(path.data());
    if (fd < 0) {
        throw Error(exit_output, fmt::format("{}: cannot write: {}; name another folder in TMPDIR",
                                             path, system_message(errno)));
    }
    unlink(path.c_str());
    fcntl(fd, F_SETFD, FD_CLOEXEC);
    return fd;
}

void write_all(int fd, const std::vector<double>& values) {
    const char* data = reinterpret_cast<const char*>(values.data());
    for (std::size_t left = values.size() * sizeof(double); left > 0;) {
        const ssize_t wrote = write(fd, data, std::min(left, std::size_t{1} << 30));
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote < 0) throw std::runtime_error("points: cannot write: " + system_message(errno));
        data += wrote;
        left -= static_cast<std::size_t>(wrote);
    }
}

}  // namespace

std::vector<std::string> distribution_names() {
    std::vector<std::string> names;
    for (const Distribution& d : distributions()) names.emplace_back(d.name);
    for (const char* kind : mild_kinds) names.push_back(std::string(mild) + kind);
    return names;
}

void check_data(const std::string& distribution, const std::string& data_directory) {
    if (distribution != "machine" && distribution != "church") return;
    GenerateOptions options;
    options.data_directory = data_directory;
    try {
        generate(distribution, 1, options);
    } catch (const std::runtime_error& e) {
        throw Error(exit_input, fmt::format("{}; say where they are with --data", e.what()));
    }
}

PointSet::PointSet(const PointSetName& name, const std::string& data_directory,
                   const std::function<void()>& waiting)
    : fd_(nameless_file()) {
    const ChildEnd end = run_in_child(
        [&](int out) { return guarded(out, [&] { write_all(fd_, make(name, data_directory)); }); },
        0, [&](const std::string&) { waiting(); });
    status_ = status_of(end);
}

PointSet::~PointSet() {
    close(fd_);
}

std::size_t PointSet::points() const {
    struct stat status = {};
    if (fstat(fd_, &status) != 0) return 0;
    return static_cast<std::size_t>(status.st_size) / (3 * sizeof(double));
}

int PointSet::file() const {
    lseek(fd_, 0, SEEK_SET);
    return fd_;
}

std::vector<double> PointSet::read() const {
    std::vector<double> values(3 * points());
    char* data = reinterpret_cast<char*>(values.data());
    const int fd = file();
    for (std::size_t left = values.size() * sizeof(double); left > 0;) {
        const ssize_t got = ::read(fd, data, std::min(left, std::size_t{1} << 30));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) throw std::runtime_error("points: cannot read: " + system_message(errno));
        data += got;
        left -= static_cast<std::size_t>(got);
    }
    return values;
}

}  // namespace mgdt::cli::bench
