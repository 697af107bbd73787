// SPDX-License-Identifier: MIT
#include "bench/json.hpp"

#include <fmt/core.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>

#include "mgdt/mgdt.h"

namespace mgdt::cli::bench {
namespace {

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (byte < 0x20 || byte >= 0x7f) {
            // Escapes byte by byte, since a command line need not be UTF-8 and JSON must be.
            out += fmt::format("\\u{:04x}", byte);
        } else {
            out += c;
        }
    }
    return out + '"';
}

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        const std::size_t colon = line.find(": ");
        if (line.compare(0, 10, "model name") == 0 && colon != std::string::npos) {
            return line.substr(colon + 2);
        }
    }
    utsname name = {};
    return uname(&name) == 0 ? name.machine : "unknown";
}

std::string machine() {
    return fmt::format(R"({{"cpu": {}, "cores": {}, "memory_bytes": {}}})", quoted(processor()),
                       sysconf(_SC_NPROCESSORS_ONLN),
                       sysconf(_SC_PHYS_PAGES) * sysconf(_SC_PAGESIZE));
}

std::string object(const Row& row) {
    std::string text = fmt::format(
        R"({{"library": {}, "version": {}, "distribution": {}, "points": {}, "seed": {}, )"
        R"("scheme": {}, "threads": {}, "run": {}, "status": {})",
        quoted(row.library), quoted(row.version), quoted(row.distribution), row.points, row.seed,
        quoted(row.scheme), row.threads, row.run, quoted(row.status));
    for (std::size_t i = 0; i < figure_count; ++i) {
        text += fmt::format(", \"{}\": {}", figure_names[i],
                            row.figures[i] ? fmt::format("{}", *row.figures[i]) : "null");
    }
    return text + "}";
}

}  // namespace

void write_json(OutputFile& out, const std::string& command, const std::vector<Row>& rows) {
    out.write(fmt::format("{{\n\"machine\": {},\n\"command\": {},\n\"version\": {},\n\"rows\": [",
                          machine(), quoted(command), quoted(mgdt_version_string())));
    const char* separator = "\n";
    for (const Row& row : rows) {
        out.write(separator + object(row));
        separator = ",\n";
    }
    out.write("\n]\n}\n");
}

}  // namespace mgdt::cli::bench
