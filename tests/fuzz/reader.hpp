// SPDX-License-Identifier: MIT
// What the targets of the file readers share. Whatever the bytes, a reader gives a mesh that keeps
// its promises or an Error that says where; it takes memory in proportion to the file, whatever
// counts the file announces; and what it read, written and read again, is the same.
#pragma once

#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/vtk_arrays.hpp"
#include "input.hpp"
#include "memory_count.hpp"

namespace fuzz {

using mgdt::cli::Error;
using mgdt::cli::Format;
using mgdt::cli::Mesh;
using mgdt::cli::Source;

// A folder of the process, in memory where the system has such a place.
class Scratch {
  public:
    Scratch() {
        const bool shared = access("/dev/shm", W_OK | X_OK) == 0;
        std::string name = std::string(shared ? "/dev/shm" : "/tmp") + "/mgdt-fuzz-XXXXXX";
        FUZZ_REQUIRE(mkdtemp(name.data()) != nullptr, name);
        path_ = name;
    }
    ~Scratch() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    std::string file(const char* name) const { return path_ + "/" + name; }

    static const Scratch& get() {
        static const Scratch scratch;
        return scratch;
    }

  private:
    std::string path_;
};

inline std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void put(const std::string& path, std::string_view bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

// Calls read() and accepts an Error as a bad file gets it. Memory is limited to what files of the
// size may need: a point takes at least 6 bytes of text and 24 bytes in memory, and vectors double.
template <class Read>
auto attempt(std::size_t size, const Read& read) -> std::optional<decltype(read())> {
    MemoryCount::start();
    std::optional<decltype(read())> result;
    try {
        result = read();
    } catch (const Error& e) {
        FUZZ_REQUIRE(e.code() == mgdt::cli::exit_input, e.what());
        const std::string message = e.what();
        FUZZ_REQUIRE(!message.empty() && message.size() < 1000, message);
        for (const char c : message)
            FUZZ_REQUIRE(static_cast<unsigned char>(c) >= 0x20, message);  // one printable line
    }
    const std::size_t most = 65536 + 64 * size;
    FUZZ_REQUIRE(MemoryCount::peak() <= most, std::to_string(MemoryCount::peak()) +
                                                  " bytes for a file of " + std::to_string(size));
    return result;
}

// `beside` is the size of the files that the reader finds by itself.
inline std::optional<Mesh> read(const Format& format, std::string_view bytes,
                                const std::string& path = "",
                                const mgdt::cli::ReadOptions& options = {},
                                std::size_t beside = 0) {
    // A copy of its own size, so that the sanitizer sees a step beyond the end.
    const std::vector<char> exact(bytes.begin(), bytes.end());
    const Source source{"file", path, {exact.data(), exact.size()}};
    const bool may_expand = bytes.find("compressor") != bytes.npos;
    const std::size_t size = bytes.size() * (may_expand ? mgdt::cli::most_expansion : 1) + beside;
    const std::optional<Mesh> mesh =
        attempt(size, [&] { return read_mesh(format, source, options); });
    if (!mesh) return mesh;
    FUZZ_REQUIRE(mesh->points.size() % 3 == 0, "points");
    FUZZ_REQUIRE(mesh->tetrahedra.size() % 4 == 0, "tetrahedra");
    FUZZ_REQUIRE(mesh->has_tetrahedra || mesh->tetrahedra.empty(), "has_tetrahedra");
    for (const double x : mesh->points) FUZZ_REQUIRE(std::isfinite(x), "a coordinate");
    const auto within = [](const std::vector<mgdt::cli::MeshIndex>& values, std::int64_t low,
                           std::size_t end) {
        for (const mgdt::cli::MeshIndex v : values)
            if (v < low || v >= static_cast<std::int64_t>(end)) return false;
        return true;
    };
    FUZZ_REQUIRE(within(mesh->tetrahedra, 0, mesh->point_count()), "vertices");
    FUZZ_REQUIRE(within(mesh->neighbors, -1, mesh->tetrahedron_count()), "neighbours");
    FUZZ_REQUIRE(mesh->neighbors.empty() || mesh->neighbors.size() == mesh->tetrahedra.size(),
                 "neighbours");
    return mesh;
}

// Reads facets, and then markers: each tetrahedron has one, or none has, and so with the facets.
inline void facets_and_markers_read(const Format& format, std::string_view bytes,
                                    const std::string& path = "", std::size_t beside = 0) {
    mgdt::cli::ReadOptions options;
    options.has_facets = true;
    read(format, bytes, path, options, beside);
    options = {};
    options.has_markers = true;
    const std::optional<Mesh> mesh = read(format, bytes, path, options, beside);
    if (!mesh) return;
    FUZZ_REQUIRE(mesh->regions.empty() || mesh->regions.size() == mesh->tetrahedron_count(),
                 "markers of tetrahedra");
    const mgdt::cli::FileFacets& facets = mesh->facets;
    FUZZ_REQUIRE(facets.markers.size() + 1 == facets.begin.size(), "markers of facets");
}

inline void expect_same_points(const std::vector<double>& a, const std::vector<double>& b) {
    FUZZ_REQUIRE(a.size() == b.size(), "points of a round trip");
    FUZZ_REQUIRE(a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0,
                 "coordinates of a round trip");
}

// Writes the points and reads them again.
inline void points_return(const Format& format, const std::vector<double>& points) {
    const std::string path = Scratch::get().file("points");
    mgdt::cli::OutputSet outputs;
    format.write_points(points, outputs.open(path), {});
    outputs.commit();
    const std::optional<Mesh> again = read(format, bytes_of(path));
    FUZZ_REQUIRE(again.has_value(), "the file that was written cannot be read");
    expect_same_points(points, again->points);
}

// The same for points and tetrahedra in one file.
inline void mesh_returns(const Format& format, const Mesh& mesh,
                         const mgdt::cli::WriteOptions& options = {}) {
    const std::string path = Scratch::get().file("mesh");
    mgdt::cli::OutputSet outputs;
    format.write_mesh(mesh, path, outputs, options);
    outputs.commit();
    const std::optional<Mesh> again = read(format, bytes_of(path));
    FUZZ_REQUIRE(again.has_value(), "the file that was written cannot be read");
    expect_same_points(mesh.points, again->points);
    FUZZ_REQUIRE(mesh.tetrahedra == again->tetrahedra, "tetrahedra of a round trip");
}

// Reads with all fields, writes them and reads them again: where names of them return, as many.
inline void fields_return(const Format& format, std::string_view bytes) {
    mgdt::cli::ReadOptions options;
    options.has_fields = true;
    const std::optional<Mesh> mesh = read(format, bytes, "", options);
    if (!mesh) return;
    std::size_t values = 0;
    for (const mgdt::cli::Field& f : mesh->fields) {
        FUZZ_REQUIRE(f.components > 0, "components");
        FUZZ_REQUIRE(f.values.size() == f.components * mesh->point_count(), "values");
        values += f.values.size();
    }
    const std::string path = Scratch::get().file("fields");
    mgdt::cli::OutputSet outputs;
    format.write_fields(*mesh, outputs.open(path), {});
    outputs.commit();
    const std::optional<Mesh> again = read(format, bytes_of(path), "", options);
    FUZZ_REQUIRE(again.has_value(), "the file that was written cannot be read");
    expect_same_points(mesh->points, again->points);
    std::size_t values_again = 0;
    for (const mgdt::cli::Field& f : again->fields) values_again += f.values.size();
    FUZZ_REQUIRE(values == values_again, "values of a round trip");
}

// The guess of a format from a file's beginning ends for any bytes.
inline void guess(std::string_view bytes) {
    const std::vector<char> exact(bytes.begin(), bytes.end());
    static_cast<void>(mgdt::cli::format_from_content({exact.data(), exact.size()}));
}

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

}  // namespace fuzz
