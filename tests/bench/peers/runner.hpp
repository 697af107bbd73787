// SPDX-License-Identifier: MIT
// What the runners of peers have in common: points come in as doubles on standard input, and the
// last line on standard output is "VERSION SECONDS TETRAHEDRA BYTES USER_SECONDS", the bytes being
// the growth of the process while it triangulated, and user seconds its own processor time, without
// the system's. Failing is a line of text and another exit code than 0.
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace peer {

constexpr int exit_failed = 1;
constexpr int exit_memory = 5;  // as mgdt's own

inline std::vector<double> read_points() {
    std::vector<double> values, block(std::size_t{1} << 16);
    for (std::size_t got;
         (got = std::fread(block.data(), sizeof(double), block.size(), stdin)) > 0;)
        values.insert(values.end(), block.begin(),
                      block.begin() + static_cast<std::ptrdiff_t>(got));
    if (std::ferror(stdin) != 0 || values.size() % 3 != 0)
        throw std::runtime_error("standard input is not points of three doubles");
    return values;
}

inline rusage usage() {
    rusage all = {};
    getrusage(RUSAGE_SELF, &all);
    return all;
}

inline long long peak_bytes() {
    return 1024LL * usage().ru_maxrss;
}

inline double user_seconds() {
    const timeval time = usage().ru_utime;
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// What is resident now; the peak so far if the system does not say.
inline long long resident_bytes() {
    long long size = 0, resident = 0;
    std::FILE* f = std::fopen("/proc/self/statm", "r");
    if (f == nullptr) return peak_bytes();
    const int fields = std::fscanf(f, "%lld %lld", &size, &resident);
    std::fclose(f);
    return fields == 2 ? resident * sysconf(_SC_PAGESIZE) : peak_bytes();
}

/// Times `triangulate` alone, then asks `count` for the tetrahedra.
template <class Triangulate, class Count>
void measure(const std::string& version, Triangulate triangulate, Count count) {
    const long long before = resident_bytes();
    const double user_before = user_seconds();
    const auto begin = std::chrono::steady_clock::now();
    triangulate();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    const double user = user_seconds() - user_before;
    const long long growth = peak_bytes() - before;
    std::printf("\n%s %.9f %lld %lld %.6f\n", version.c_str(), taken.count(),
                static_cast<long long>(count()), growth, user);
}

/// The exit code of a runner's main().
template <class Body>
int guarded(Body body) {
    try {
        body();
        return 0;
    } catch (const std::bad_alloc&) {
        return exit_memory;
    } catch (const std::exception& e) {
        std::printf("\n%s\n", e.what());
    } catch (...) {
        std::printf("\nan exception without a text\n");
    }
    return exit_failed;
}

}  // namespace peer
