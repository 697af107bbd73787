// SPDX-License-Identifier: MIT
// Numbers, round trips and the registry of formats: what is written reads back bit for bit.
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>

#include "cli/formats/number.hpp"
#include "formats_support.hpp"

namespace mgdt::cli {
namespace {

TEST(Number, ReadsExactly) {
    double v = 0;
    EXPECT_EQ(parse_number("0.1", v), NumberStatus::ok);
    EXPECT_EQ(v, 0.1);
    EXPECT_EQ(parse_number("+1.5E+3", v), NumberStatus::ok);
    EXPECT_EQ(v, 1500);
    EXPECT_EQ(parse_number("-.5", v), NumberStatus::ok);
    EXPECT_EQ(v, -0.5);
    EXPECT_EQ(parse_number("1e-400", v), NumberStatus::ok);
    EXPECT_EQ(v, 0);
    EXPECT_EQ(parse_number("4.9e-324", v), NumberStatus::ok);
    EXPECT_EQ(v, std::numeric_limits<double>::denorm_min());
    // Halfway between two doubles, and a digit beyond.
    EXPECT_EQ(parse_number("9007199254740993", v), NumberStatus::ok);
    EXPECT_EQ(v, 9007199254740992.0);
    EXPECT_EQ(parse_number("9007199254740993.00000000000000000001", v), NumberStatus::ok);
    EXPECT_EQ(v, 9007199254740994.0);
}

TEST(Number, ReadsFortran) {
    double v = 0;
    EXPECT_EQ(parse_number("1.5D+03", v), NumberStatus::ok);
    EXPECT_EQ(v, 1500);
    EXPECT_EQ(parse_number("0.25d0", v), NumberStatus::ok);
    EXPECT_EQ(v, 0.25);
    EXPECT_EQ(parse_number("0.5-100", v), NumberStatus::ok);
    EXPECT_EQ(v, 0.5e-100);
}

TEST(Number, Refuses) {
    double v = 0;
    for (const char* bad : {"", "+", "-", ".", "e5", "1e", "1.0x", "abc", "1,5", "++1", "+-1",
                            "0x10", "1.5D", "1e5D2", "1-2", "1.0-10", "nancy", "--1"}) {
        EXPECT_EQ(parse_number(bad, v), NumberStatus::not_a_number) << bad;
    }
    for (const char* bad : {"nan", "NaN", "inf", "-Infinity", "+inf"}) {
        EXPECT_EQ(parse_number(bad, v), NumberStatus::not_finite) << bad;
    }
    EXPECT_EQ(parse_number("1e400", v), NumberStatus::too_large);
    EXPECT_EQ(parse_number("-1D999", v), NumberStatus::too_large);
}

TEST(RoundTrip, Points) {
    int formats = 0;
    for (const Format* f : all_formats()) {
        if (!f->write_points) continue;
        ++formats;
        for (const Points& points : {awkward, Points{}, Points{1, 2, 3}}) {
            EXPECT_TRUE(same_bits(read(*f, written(*f, points)).points, points)) << f->name;
        }
        EXPECT_TRUE(same_bits(read(*f, written(*f, awkward, 1)).points, awkward)) << f->name;
    }
    EXPECT_EQ(formats, 9);
}

TEST(RoundTrip, Mesh) {
    Mesh mesh = two_tetrahedra();
    for (std::size_t i = 0; i < awkward.size(); ++i) mesh.points[i] = awkward[i];
    for (const Format* f : {&vtu_format(), &gmsh_format(), &gmsh2_format(), &vtk_format(),
                            &medit_format(), &medit_binary_format(), &abaqus_format()}) {
        const Mesh back = read(*f, written(*f, mesh));
        EXPECT_TRUE(same_bits(back.points, mesh.points)) << f->name;
        EXPECT_EQ(back.tetrahedra, mesh.tetrahedra) << f->name;
        EXPECT_TRUE(back.has_tetrahedra);
    }
}

TEST(Vtu, HasShortIntegersWhereTheyFit) {
    const std::string file = written(vtu_format(), two_tetrahedra());
    for (const char* array : {"connectivity", "offsets"})
        EXPECT_TRUE(contains(file, fmt::format("type=\"Int32\" Name=\"{}\"", array))) << array;
    EXPECT_FALSE(contains(file, "\"Int64\""));
}

TEST(RoundTrip, EmptyMesh) {
    Mesh mesh;
    mesh.has_tetrahedra = true;
    for (const Points& points : {Points{}, corners}) {
        mesh.points = points;
        for (const Format* f : {&vtu_format(), &gmsh_format(), &gmsh2_format(), &vtk_format(),
                                &medit_format(), &medit_binary_format(), &abaqus_format()}) {
            const Mesh back = read(*f, written(*f, mesh));
            EXPECT_EQ(back.points, points) << f->name;
            EXPECT_TRUE(back.tetrahedra.empty()) << f->name;
            EXPECT_TRUE(back.has_tetrahedra) << f->name;
        }
    }
}

TEST(RoundTrip, TetgenFiles) {
    const Mesh mesh = two_tetrahedra();
    for (const int base : {0, 1}) {
        Directory directory;
        const std::string ele = directory.file("m.ele");
        const std::string node = directory.file("m.node"), neigh = directory.file("m.neigh");
        OutputSet outputs;
        WriteOptions options;
        options.index_base = base;
        tetgen_format().write_mesh(mesh, ele, outputs, options);
        tetgen_format().write_neighbors(mesh.neighbors, ele, outputs, options);
        outputs.commit();
        const InputFile file(ele);
        const Mesh back = tetgen_format().read(file.source(), {});
        EXPECT_EQ(back.points, mesh.points);
        EXPECT_EQ(back.tetrahedra, mesh.tetrahedra);
        EXPECT_EQ(back.neighbors, mesh.neighbors);
        const std::string none = " -1";
        EXPECT_TRUE(contains(bytes_of(neigh), none));
        EXPECT_TRUE(contains(bytes_of(node), base == 0 ? "\n0 0 0 0\n" : "\n1 0 0 0\n"));
    }
}

TEST(RoundTrip, NumPyRows) {
    const Indices rows = {0, 1, 2, 3, 3, 2, 1, 4};
    for (const int base : {0, 1}) {
        Directory directory;
        const std::string path = directory.file("t.npy");
        OutputSet outputs;
        write_npy_rows_of_4(rows, base, outputs.open(path));
        outputs.commit();
        const InputFile file(path);
        EXPECT_EQ(read_npy_tetrahedra(file.source(), base, 5, "points"), rows);
        EXPECT_THROW(read_npy_tetrahedra(file.source(), base, 4, "points"), Error);
        EXPECT_THROW(read_npy_tetrahedra(file.source(), base + 1, 5, "points"), Error);
        EXPECT_EQ(bytes_of(path).size() % 64, 0u);  // 64 bytes of data, so the header is aligned
    }
}

TEST(Registry, FindsFormats) {
    EXPECT_EQ(format_from_path("a/b.VTU"), &vtu_format());
    EXPECT_EQ(format_from_path("a.b/c"), nullptr);
    EXPECT_EQ(format_from_path("x.1.node"), &tetgen_format());
    EXPECT_THROW(format_from_name("step"), Error);
    for (const Format* f : all_formats()) EXPECT_EQ(&format_from_name(f->name), f);
    const Mesh mesh = two_tetrahedra();
    for (const Format* f : {&npy_format(), &ply_format()}) {
        EXPECT_EQ(format_from_content(written(*f, corners)), f);
    }
    for (const Format* f : {&vtu_format(), &gmsh_format()}) {
        EXPECT_EQ(format_from_content(written(*f, mesh)), f);
    }
    EXPECT_EQ(format_from_content("1 2 3\n"), &text_format());
    EXPECT_EQ(format_from_content(raw({1.5, 2.5, 3.5})), nullptr);
}

}  // namespace
}  // namespace mgdt::cli
