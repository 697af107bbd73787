// SPDX-License-Identifier: MIT
// What the tests of readers and writers share: reading from memory, writing to scratch files, small
// meshes and samples of formats.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cfloat>
#include <cstring>
#include <fstream>
#include <iterator>

#include "../support/points.hpp"
#include "cli/errors.hpp"
#include "cli/formats/format.hpp"

namespace mgdt::cli {

using mgdt_tests::Points;
using Indices = std::vector<MeshIndex>;

class Directory {
  public:
    Directory() {
        char name[] = "/tmp/mgdt-formats-XXXXXX";
        if (!mkdtemp(name)) throw std::runtime_error("mkdtemp");
        path_ = name;
    }
    ~Directory() {
        for (const std::string& f : files_) unlink(f.c_str());
        rmdir(path_.c_str());
    }
    std::string file(const std::string& name) {
        files_.push_back(path_ + "/" + name);
        return files_.back();
    }

  private:
    std::string path_;
    std::vector<std::string> files_;
};

inline std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void put(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

inline Mesh read(const Format& format, const std::string& bytes, const ReadOptions& options = {}) {
    // A copy of its own size, so that the sanitizer sees a step beyond the end.
    const std::vector<char> exact(bytes.begin(), bytes.end());
    const Source source{"file", "", {exact.data(), exact.size()}};
    return format.read(source, options);
}

// The message of the Error that reading must throw.
inline std::string failure(const Format& format, const std::string& bytes,
                           const ReadOptions& options = {}) {
    try {
        read(format, bytes, options);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), exit_input);
        return e.what();
    }
    return "no error";
}

inline testing::AssertionResult contains(const std::string& text, const std::string& part) {
    if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "'" << text << "' has no '" << part << "'";
}

inline std::string written(const Format& format, const Points& points, int base = 0) {
    Directory directory;
    const std::string path = directory.file("out");
    OutputSet outputs;
    WriteOptions options;
    options.index_base = base;
    format.write_points(points, outputs.open(path), options);
    outputs.commit();
    return bytes_of(path);
}

inline std::string written(const Format& format, const Mesh& mesh) {
    Directory directory;
    const std::string path = directory.file("out");
    OutputSet outputs;
    format.write_mesh(mesh, path, outputs, {});
    outputs.commit();
    return bytes_of(path);
}

inline bool same_bits(const Points& a, const Points& b) {
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

template <class T>
std::string raw(std::initializer_list<T> values, bool big = false) {
    std::string out;
    for (const T v : values) {
        char b[sizeof(T)];
        std::memcpy(b, &v, sizeof(T));
        if (big) std::reverse(b, b + sizeof(T));
        out.append(b, sizeof(T));
    }
    return out;
}

inline const Points awkward = {
    0.1,       -0.0, 1.0 / 3, DBL_MAX,   -DBL_MAX,           DBL_MIN, 5e-324, -1e-310, 1e22,
    123456789, 2.5,  -7e-5,   1 + 1e-15, 9007199254740993.0, 1e300};
inline const Points corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};

inline Mesh two_tetrahedra() {
    Mesh mesh;
    mesh.points = corners;
    mesh.tetrahedra = {0, 1, 2, 3, 1, 2, 3, 4};
    mesh.neighbors = {1, -1, -1, -1, -1, -1, -1, 0};
    mesh.has_tetrahedra = true;
    return mesh;
}

inline std::string npy(const std::string& header, const std::string& data, char version = 1) {
    std::string out = "\x93NUMPY";
    out += version;
    out += '\0';
    const auto n = static_cast<std::uint32_t>(header.size());
    out += raw<std::uint32_t>({n}).substr(0, version == 1 ? 2 : 4);
    return out + header + data;
}

inline const char* const ply_header =
    "element before 2\nproperty list uchar short items\nproperty int n\n"
    "element vertex 2\nproperty uchar red\nproperty TYPE x\nproperty TYPE y\nproperty TYPE z\n"
    "property list int float more\nelement face 1\nproperty list uchar int vertex_indices\n"
    "end_header\n";

inline std::string ply_head(const std::string& encoding, const std::string& type) {
    std::string body = ply_header;
    for (std::size_t at; (at = body.find("TYPE")) != std::string::npos;) body.replace(at, 4, type);
    return "ply\nformat " + encoding + " 1.0\ncomment made by hand\n" + body;
}

template <class T>
std::string ply_binary(const std::string& type, bool big) {
    std::string out = ply_head(big ? "binary_big_endian" : "binary_little_endian", type);
    out += raw<std::uint8_t>({2}) + raw<std::int16_t>({7, 8}, big) + raw<std::int32_t>({1}, big);
    out += raw<std::uint8_t>({0}) + raw<std::int32_t>({1}, big);
    for (const int i : {1, 4}) {
        out += raw<std::uint8_t>({9});
        out += raw<T>({static_cast<T>(i), static_cast<T>(i + 1), static_cast<T>(i + 2)}, big);
        out += raw<std::int32_t>({1}, big) + raw<float>({0.5f}, big);
    }
    return out + raw<std::uint8_t>({3}) + raw<std::int32_t>({0, 1, 0}, big);
}

inline const char* const msh4_ascii =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"part\"\n$EndPhysicalNames\n"
    "$Nodes\n3 5 3 70\n0 1 0 1\n70\n0 0 0\n2 1 1 2\n5\n4\n1 0 0 0.5 0.5\n0 1 0 0.1 0.2\n3 1 0 "
    "2\n3\n6\n"
    "0 0 1\n1 1 1\n$EndNodes\n$Elements\n2 3 1 3\n2 1 2 1\n1 70 5 4\n3 1 4 2\n2 70 5 4 3\n3 5 4 3 "
    "6\n"
    "$EndElements\n";

inline const char* const msh2_ascii =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n9 1 1 1\n"
    "$EndNodes\n$Elements\n3\n1 2 2 1 1 1 2 3\n2 4 2 1 1 1 2 3 4\n3 4 0 2 3 4 9\n$EndElements\n";

inline std::string msh2_binary(bool big) {
    std::string s =
        "$MeshFormat\n2.2 1 8\n" + raw<std::int32_t>({1}, big) + "\n$EndMeshFormat\n$Nodes\n5\n";
    for (std::int32_t i = 0; i < 5; ++i) {
        const std::size_t k = 3 * static_cast<std::size_t>(i);
        s += raw<std::int32_t>({i + 1}, big) +
             raw({corners[k], corners[k + 1], corners[k + 2]}, big);
    }
    s += "\n$EndNodes\n$Elements\n3\n";
    s += raw<std::int32_t>({2, 1, 2, 1, 1, 1, 1, 2, 3}, big);
    s += raw<std::int32_t>({4, 2, 2, 2, 1, 1, 1, 2, 3, 4, 3, 1, 1, 2, 3, 4, 5}, big);
    return s + "\n$EndElements\n";
}

}  // namespace mgdt::cli
