// SPDX-License-Identifier: MIT
// No sequence of bytes given to a reader does worse than an error.
#include <cmath>

#include "formats_support.hpp"

namespace mgdt::cli {
namespace {

struct Sample {
    const char* what;
    const Format* format;
    std::string bytes;
};

std::vector<Sample> samples() {
    const Mesh mesh = two_tetrahedra();
    std::vector<Sample> all;
    for (const Format* f : all_formats()) {
        if (f->write_points) all.push_back({f->name, f, written(*f, corners)});
        if (f->write_mesh && f != &tetgen_format() && f != &npy_format()) {
            all.push_back({f->name, f, written(*f, mesh)});
        }
    }
    all.push_back({"msh 4.1 text", &gmsh_format(), msh4_ascii});
    all.push_back({"msh 2.2 binary", &gmsh_format(), msh2_binary(false)});
    all.push_back({"ply binary", &ply_format(), ply_binary<float>("float", true)});
    all.push_back(
        {"ply text", &ply_format(),
         ply_head("ascii", "float") + "2 7 8 1\n0 1\n9 1 2 3 1 0.5\n9 4 5 6 0\n3 0 1 0\n"});
    all.push_back({"npy Fortran", &npy_format(),
                   npy("{'descr': '>f4', 'fortran_order': True, 'shape': (2, 3)}",
                       raw({1.f, 2.f, 3.f, 4.f, 5.f, 6.f}, true))});
    return all;
}

// Reads; true if it succeeded. What comes back must keep the reader's promises.
bool survives(const Format& format, const std::string& bytes, Mesh& mesh) {
    try {
        mesh = read(format, bytes);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), exit_input) << e.what();
        return false;
    }
    EXPECT_EQ(mesh.points.size() % 3, 0u);
    EXPECT_EQ(mesh.tetrahedra.size() % 4, 0u);
    for (const double x : mesh.points) EXPECT_TRUE(std::isfinite(x));
    for (const std::int64_t v : mesh.tetrahedra) {
        EXPECT_GE(v, 0);
        EXPECT_LT(v, static_cast<std::int64_t>(mesh.point_count()));
    }
    return true;
}

TEST(Hostile, CutAnywhere) {
    for (const Sample& s : samples()) {
        Mesh whole;
        ASSERT_TRUE(survives(*s.format, s.bytes, whole)) << s.what;
        // Bare text, Abaqus's too, and bare doubles cannot tell that something is missing.
        const bool counted = s.format != &text_format() && s.format != &csv_format() &&
                             s.format != &raw_format() && s.format != &abaqus_format();
        for (std::size_t length = 0; length < s.bytes.size(); ++length) {
            Mesh mesh;
            if (!survives(*s.format, s.bytes.substr(0, length), mesh)) continue;
            if (counted) {
                // Gmsh's sections are whole or an error; a file may end between two of them.
                EXPECT_EQ(mesh.point_count(), whole.point_count())
                    << s.what << " cut at " << length;
                if (s.format != &gmsh_format() && s.format != &gmsh2_format()) {
                    EXPECT_EQ(mesh.tetrahedra, whole.tetrahedra) << s.what << " cut at " << length;
                }
            } else {
                EXPECT_LE(mesh.point_count(), whole.point_count())
                    << s.what << " cut at " << length;
            }
        }
    }
}

TEST(Hostile, EveryByteChanged) {
    for (const Sample& s : samples()) {
        for (std::size_t i = 0; i < s.bytes.size(); ++i) {
            for (const char c : {'\0', '\xff', '\x7f', '9', '-', '\n', ' ', '<', '"'}) {
                std::string bytes = s.bytes;
                bytes[i] = c;
                Mesh mesh;
                survives(*s.format, bytes, mesh);
            }
        }
    }
}

TEST(Hostile, BytesDoubledAndDropped) {
    for (const Sample& s : samples()) {
        for (std::size_t i = 0; i < s.bytes.size(); ++i) {
            Mesh mesh;
            survives(*s.format, s.bytes.substr(0, i) + s.bytes.substr(i + 1), mesh);
            survives(*s.format, s.bytes.substr(0, i + 1) + s.bytes.substr(i), mesh);
        }
    }
}

// Every format's reader given every other format's file.
TEST(Hostile, WrongFormat) {
    for (const Sample& s : samples()) {
        for (const Format* f : all_formats()) {
            Mesh mesh;
            survives(*f, s.bytes, mesh);
        }
    }
}

}  // namespace
}  // namespace mgdt::cli
