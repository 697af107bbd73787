// SPDX-License-Identifier: MIT
// Readers and writers of the program: what is written reads back bit for bit, every documented
// variant of a format is read, and no sequence of bytes does worse than an error.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>

#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/number.hpp"

namespace mgdt::cli {
namespace {

using Points = std::vector<double>;
using Indices = std::vector<std::int64_t>;

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

std::string bytes_of(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void put(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

Mesh read(const Format& format, const std::string& bytes, const ReadOptions& options = {}) {
    // A copy of its own size, so that the sanitizer sees a step beyond the end.
    const std::vector<char> exact(bytes.begin(), bytes.end());
    const Source source{"file", "", {exact.data(), exact.size()}};
    return format.read(source, options);
}

// The message of the Error that reading must throw.
std::string failure(const Format& format, const std::string& bytes,
                    const ReadOptions& options = {}) {
    try {
        read(format, bytes, options);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), exit_input);
        return e.what();
    }
    return "no error";
}

testing::AssertionResult contains(const std::string& text, const std::string& part) {
    if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "'" << text << "' has no '" << part << "'";
}

std::string written(const Format& format, const Points& points, int base = 0) {
    Directory directory;
    const std::string path = directory.file("out");
    OutputSet outputs;
    WriteOptions options;
    options.index_base = base;
    format.write_points(points, outputs.open(path), options);
    outputs.commit();
    return bytes_of(path);
}

std::string written(const Format& format, const Mesh& mesh) {
    Directory directory;
    const std::string path = directory.file("out");
    OutputSet outputs;
    format.write_mesh(mesh, path, outputs, {});
    outputs.commit();
    return bytes_of(path);
}

bool same_bits(const Points& a, const Points& b) {
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

const Points awkward = {0.1,     -0.0, 1.0 / 3,   DBL_MAX, -DBL_MAX, DBL_MIN,   5e-324,
                        -1e-310, 1e22, 123456789, 2.5,     -7e-5,    1 + 1e-15, 9007199254740993.0,
                        1e300};
const Points corners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};

Mesh two_tetrahedra() {
    Mesh mesh;
    mesh.points = corners;
    mesh.tetrahedra = {0, 1, 2, 3, 1, 2, 3, 4};
    mesh.neighbors = {1, -1, -1, -1, -1, -1, -1, 0};
    mesh.has_tetrahedra = true;
    return mesh;
}

// ------------------------------------------------------------------------------ numbers ---

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

// --------------------------------------------------------------------------- round trips ---

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
    EXPECT_EQ(formats, 6);
}

TEST(RoundTrip, Mesh) {
    Mesh mesh = two_tetrahedra();
    for (std::size_t i = 0; i < awkward.size(); ++i) mesh.points[i] = awkward[i];
    for (const Format* f : {&vtu_format(), &gmsh_format(), &gmsh2_format()}) {
        const Mesh back = read(*f, written(*f, mesh));
        EXPECT_TRUE(same_bits(back.points, mesh.points)) << f->name;
        EXPECT_EQ(back.tetrahedra, mesh.tetrahedra) << f->name;
        EXPECT_TRUE(back.has_tetrahedra);
    }
}

TEST(RoundTrip, EmptyMesh) {
    Mesh mesh;
    mesh.has_tetrahedra = true;
    for (const Points& points : {Points{}, corners}) {
        mesh.points = points;
        for (const Format* f : {&vtu_format(), &gmsh_format(), &gmsh2_format()}) {
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
    const Indices rows = {0, 1, 2, 3, 3, 2, 1, -1};
    for (const int base : {0, 1}) {
        Directory directory;
        const std::string path = directory.file("t.npy");
        OutputSet outputs;
        write_npy_rows_of_4(rows, base, outputs.open(path));
        outputs.commit();
        const InputFile file(path);
        EXPECT_EQ(read_npy_rows_of_4(file.source(), base), rows);
        EXPECT_EQ(bytes_of(path).size() % 64, 0u);  // 64 bytes of data, so the header is aligned
    }
}

// ------------------------------------------------------------------------------ variants ---

TEST(Text, Separators) {
    const Points expected = {1, 2, 3, 4, 5, 6};
    for (const char* text :
         {"1 2 3\n4 5 6\n", "1,2,3\n4,5,6", "1;2;3\r\n4;5;6\r\n", "1\t2\t3\n4\t5\t6\n",
          " 1 , 2 ,3 \n\n  4   5 6 99 text\n", "# comment\n1 2 3 # more\n#\n4 5 6",
          "x y z\n1 2 3\n4 5 6", "\"x\",\"y\",\"z\"\n1,2,3\n4,5,6\n", "2\n1 2 3\n4 5 6\n",
          "\xef\xbb\xbf"
          "1 2 3\n4 5 6\n",
          "1 2 3\r4 5 6\r", "1.0D0 2.D0 3\n+4 5 6\n"}) {
        EXPECT_EQ(read(text_format(), text).points, expected) << text;
    }
}

TEST(Text, Columns) {
    ReadOptions options;
    options.columns = {4, 1, 2};
    EXPECT_EQ(read(csv_format(), "y,z,name,x\n2,3,a,1\n5,6,b,4\n", options).points,
              (Points{1, 2, 3, 4, 5, 6}));
    EXPECT_TRUE(contains(failure(csv_format(), "2,3,a\n", options), "x needs column 4"));
    EXPECT_TRUE(contains(failure(csv_format(), "2,3,a,1\n5,6,b\n", options), "line 2: 3 columns"));
}

TEST(Text, ErrorsNameTheLine) {
    EXPECT_TRUE(contains(failure(text_format(), "1 2 3\n4 5\n"), "line 2"));
    EXPECT_TRUE(contains(failure(text_format(), "1 2 3\n\n4 nan 6\n"), "line 3: column 2: 'nan'"));
    EXPECT_TRUE(contains(failure(text_format(), "1 2 3\r4 inf 6\r"), "line 2"));
    EXPECT_TRUE(contains(failure(text_format(), "nan nan nan\n"), "line 1"));
    EXPECT_TRUE(contains(failure(text_format(), "x y z\nx y z\n"), "line 2"));
    EXPECT_TRUE(contains(failure(text_format(), "1 2 three\n"), "'three' is not a number"));
    EXPECT_TRUE(contains(failure(text_format(), "1 2 1e999\n"), "too large"));
    EXPECT_TRUE(contains(failure(csv_format(), "1,2,3\n1,,3\n"), "line 2: column 2: ''"));
    EXPECT_TRUE(contains(failure(text_format(), "3\n1 2 3\n"), "announces 3 points, but 1"));
    EXPECT_TRUE(contains(failure(text_format(),
                                 "\xff\xfe"
                                 "1 2 3"),
                         "UTF-16"));
    EXPECT_TRUE(contains(failure(text_format(), std::string("1 2 \0\x1b[2J\n", 10)), "\\x1b"));
}

std::string npy(const std::string& header, const std::string& data, char version = 1) {
    std::string out = "\x93NUMPY";
    out += version;
    out += '\0';
    const auto n = static_cast<std::uint32_t>(header.size());
    out += raw<std::uint32_t>({n}).substr(0, version == 1 ? 2 : 4);
    return out + header + data;
}

TEST(NumPy, Variants) {
    const Points expected = {1, 2, 3, 4, 5, 6};
    const auto dict = [](const std::string& type, const std::string& order) {
        return "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': (2, 3), }\n";
    };
    const auto d = {1., 2., 3., 4., 5., 6.}, columns = {1., 4., 2., 5., 3., 6.};
    const auto f = {1.f, 2.f, 3.f, 4.f, 5.f, 6.f};
    for (const std::string& file :
         {npy(dict("<f8", "False"), raw(d)), npy(dict(">f8", "False"), raw(d, true)),
          npy(dict("<f4", "False"), raw(f)), npy(dict(">f4", "False"), raw(f, true)),
          npy(dict("<f8", "True"), raw(columns)), npy(dict("<f8", "False"), raw(d), 2),
          npy("{\"shape\":(2,3),\"descr\":\"<f8\",\"fortran_order\":False}", raw(d))}) {
        EXPECT_EQ(read(npy_format(), file).points, expected);
    }
}

TEST(NumPy, Refusals) {
    const std::string data(48, '\0');
    const auto fail = [&](const std::string& header) {
        return failure(npy_format(), npy(header, data));
    };
    const std::string head = "{'descr': '<f8', 'fortran_order': False, 'shape': ";
    EXPECT_TRUE(contains(fail(head + "(6,)}"), "shape is (6,)"));
    EXPECT_TRUE(contains(fail(head + "(3, 2)}"), "shape is (3, 2)"));
    EXPECT_TRUE(contains(fail(head + "(3, 3)}"), "announces 3 rows"));
    EXPECT_TRUE(contains(fail(head + "(1, 3)}"), "announces 1 rows"));
    EXPECT_TRUE(contains(fail(head + "(768614336404564650, 3)}"), "announces"));
    EXPECT_TRUE(contains(fail(head + "(18446744073709551615, 3)}"), "announces"));
    EXPECT_TRUE(contains(fail(head + "(18446744073709551616, 3)}"), "64 bits"));
    EXPECT_TRUE(contains(fail(head + "(-1, 3)}"), "number expected"));
    EXPECT_TRUE(
        contains(fail("{'descr': '<i8', 'fortran_order': False, 'shape': (2, 3)}"), "astype"));
    EXPECT_TRUE(contains(fail("{'descr': '|O', 'fortran_order': False, 'shape': (2, 3)}"), "'|O'"));
    EXPECT_TRUE(contains(fail("{'descr': [('x', '<f8')]}"), "structured"));
    EXPECT_TRUE(contains(fail("{'descr': '<f8'}"), "missing"));
    EXPECT_TRUE(contains(fail("{'descr': '<f8"), "without end"));
    EXPECT_TRUE(contains(failure(npy_format(), npy(head, "", 4)), "version 4.0"));
    EXPECT_TRUE(contains(failure(npy_format(), "\x93NUMPY\x01"), "byte 7"));
    const std::string nan = npy(head + "(1, 3)}", raw({0.0, std::nan(""), 0.0}));
    EXPECT_TRUE(contains(failure(npy_format(), nan), "byte " + std::to_string(nan.size() - 16)));
}

TEST(Raw, Refusals) {
    EXPECT_TRUE(contains(failure(raw_format(), std::string(25, 'a')), "25 bytes"));
    EXPECT_TRUE(contains(failure(raw_format(), raw({1.0, 2.0, 1.0 / 0.0})), "byte 16"));
}

const char* const ply_header =
    "element before 2\nproperty list uchar short items\nproperty int n\n"
    "element vertex 2\nproperty uchar red\nproperty TYPE x\nproperty TYPE y\nproperty TYPE z\n"
    "property list int float more\nelement face 1\nproperty list uchar int vertex_indices\n"
    "end_header\n";

std::string ply_head(const std::string& encoding, const std::string& type) {
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

TEST(Ply, Variants) {
    const Points expected = {1, 2, 3, 4, 5, 6};
    const std::string ascii = "2 7 8 1\n0 1\n9 1 2 3 1 0.5\n9 4 5 6 0\n3 0 1 0\n";
    EXPECT_EQ(read(ply_format(), ply_head("ascii", "double") + ascii).points, expected);
    for (const bool big : {false, true}) {
        EXPECT_EQ(read(ply_format(), ply_binary<double>("double", big)).points, expected);
        EXPECT_EQ(read(ply_format(), ply_binary<float>("float32", big)).points, expected);
        EXPECT_EQ(read(ply_format(), ply_binary<std::int32_t>("int", big)).points, expected);
        EXPECT_EQ(read(ply_format(), ply_binary<std::uint16_t>("ushort", big)).points, expected);
        EXPECT_EQ(read(ply_format(), ply_binary<std::int8_t>("int8", big)).points, expected);
    }
    EXPECT_EQ(read(ply_format(),
                   "ply\r\nformat ascii 1.0\r\nelement vertex 1\r\nproperty float x\r\n"
                   "property float y\r\nproperty float z\r\nend_header\r\n1 2 3\r\n")
                  .points,
              (Points{1, 2, 3}));
}

TEST(Ply, Refusals) {
    const auto head = [](const std::string& encoding, const std::string& count) {
        return "ply\nformat " + encoding + " 1.0\nelement vertex " + count +
               "\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    };
    const std::string little = "binary_little_endian";
    EXPECT_TRUE(contains(failure(ply_format(), head("ascii", "9") + "1 2 3\n"), "9 entries"));
    EXPECT_TRUE(contains(failure(ply_format(), head("ascii", "2") + "1 2 3\n"), "after 1 of 2"));
    EXPECT_TRUE(contains(failure(ply_format(), head("ascii", "1") + "1 2\n"), "line 8"));
    EXPECT_TRUE(contains(failure(ply_format(), head("ascii", "1") + "1 nan 2\n"), "not finite"));
    EXPECT_TRUE(contains(failure(ply_format(), head("ascii", "1") + "1 2 3\n4 5 6\n"), "line 9"));
    EXPECT_TRUE(
        contains(failure(ply_format(), head(little, "4000000000000000000") + "abc"), "bytes"));
    EXPECT_TRUE(contains(failure(ply_format(), head(little, "-1")), "must be from 0"));
    EXPECT_TRUE(
        contains(failure(ply_format(), head(little, "1") + std::string(25, '\0')), "1 bytes"));
    EXPECT_TRUE(contains(failure(ply_format(), head("binary", "1")), "unknown encoding"));
    EXPECT_TRUE(contains(failure(ply_format(), "ply\nformat ascii 1.0\nend_header\n"), "vertex"));
    EXPECT_TRUE(contains(failure(ply_format(),
                                 "ply\nformat ascii 1.0\nelement vertex 1\n"
                                 "property float x\nend_header\n1\n"),
                         "no x, y and z"));
    // A list whose length would wrap an offset.
    EXPECT_TRUE(
        contains(failure(ply_format(),
                         "ply\nformat binary_little_endian 1.0\nelement a 1\n"
                         "property list uint double l\nelement vertex 0\nproperty float x\n"
                         "property float y\nproperty float z\nend_header\n\xff\xff\xff\xff"),
                 "items of a list"));
}

TEST(Tetgen, Nodes) {
    const Points expected = {1, 2, 3, 4, 5, 6};
    EXPECT_EQ(read(tetgen_format(), "# made\n2 3 1 1\n1 1 2 3 0.5 1\n# c\n2 4 5 6 0.5 0\n").points,
              expected);
    EXPECT_EQ(read(tetgen_format(), "2\n0 1 2 3\n1 4 5 6").points, expected);
    EXPECT_TRUE(contains(failure(tetgen_format(), ""), "empty"));
    EXPECT_TRUE(contains(failure(tetgen_format(), "2 2 0 0\n1 1 2\n2 3 4\n"), "dimension 2"));
    EXPECT_TRUE(contains(failure(tetgen_format(), "2 3 0 0\n1 1 2 3\n3 4 5 6\n"), "line 3"));
    EXPECT_TRUE(contains(failure(tetgen_format(), "2 3 0 0\n5 1 2 3\n6 4 5 6\n"), "0 or 1"));
    EXPECT_TRUE(
        contains(failure(tetgen_format(), "3 3 0 0\n1 1.0 2.0 3.0\n2 4.0 5.0 6.0\n"), "2 of 3"));
    EXPECT_TRUE(contains(failure(tetgen_format(), "1 3 0 0\n1 1 2 3\n2 4 5 6\n"), "line 3"));
    EXPECT_TRUE(
        contains(failure(tetgen_format(), "9000000000000000000 3 0 0\n1 1 2 3\n"), "bytes"));
    EXPECT_TRUE(contains(failure(tetgen_format(), "1 3 0 0\n1 1 inf 3\n"), "not finite"));
}

TEST(Tetgen, Elements) {
    Directory directory;
    const std::string ele = directory.file("m.ele");
    put(directory.file("m.node"), "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");
    const auto fail = [&](const std::string& text) {
        put(ele, text);
        const InputFile file(ele);
        try {
            tetgen_format().read(file.source(), {});
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string("no error");
    };
    EXPECT_EQ(fail("1 4 0\n1 1 2 3 4\n"), "no error");
    EXPECT_EQ(fail("1 10 0\n1 1 2 3 4 5 6 7 8 9 10\n"), "no error");
    EXPECT_TRUE(contains(fail("1 4 0\n1 0 1 2 3\n"), "vertex is 0; it must be from 1 to 4"));
    EXPECT_TRUE(contains(fail("1 4 0\n1 1 2 3 5\n"), "m.ele: line 2"));
    EXPECT_TRUE(contains(fail("1 8 0\n1 1 2 3 4 5 6 7 8\n"), "8 nodes"));
    EXPECT_TRUE(contains(fail("999999999999 4 0\n1 1 2 3 4\n"), "announces"));
    unlink((ele.substr(0, ele.size() - 4) + ".node").c_str());
    EXPECT_TRUE(contains(fail("1 4 0\n1 1 2 3 4\n"), "m.node: cannot read"));
}

const char* const msh4_ascii =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"part\"\n$EndPhysicalNames\n"
    "$Nodes\n3 5 3 70\n0 1 0 1\n70\n0 0 0\n2 1 1 2\n5\n4\n1 0 0 0.5 0.5\n0 1 0 0.1 0.2\n3 1 0 "
    "2\n3\n6\n"
    "0 0 1\n1 1 1\n$EndNodes\n$Elements\n2 3 1 3\n2 1 2 1\n1 70 5 4\n3 1 4 2\n2 70 5 4 3\n3 5 4 3 "
    "6\n"
    "$EndElements\n";

const char* const msh2_ascii =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n9 1 1 1\n"
    "$EndNodes\n$Elements\n3\n1 2 2 1 1 1 2 3\n2 4 2 1 1 1 2 3 4\n3 4 0 2 3 4 9\n$EndElements\n";

std::string msh2_binary(bool big) {
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

TEST(Gmsh, Variants) {
    const Indices tetrahedra = {0, 1, 2, 3, 1, 2, 3, 4};
    for (const std::string& file : {std::string(msh4_ascii), std::string(msh2_ascii),
                                    msh2_binary(false), msh2_binary(true)}) {
        const Mesh mesh = read(gmsh_format(), file);
        EXPECT_EQ(mesh.points, corners);
        EXPECT_EQ(mesh.tetrahedra, tetrahedra);
        EXPECT_EQ(mesh.other_cells, 1u);
    }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(Gmsh, Refusals) {
    const auto fail4 = [](const char* from, const char* to) {
        return failure(gmsh_format(), replaced(msh4_ascii, from, to));
    };
    const auto fail2 = [](const char* from, const char* to) {
        return failure(gmsh_format(), replaced(msh2_ascii, from, to));
    };
    EXPECT_TRUE(contains(fail4("4.1", "4.0"), "line 2"));
    EXPECT_TRUE(contains(fail4("0 8", "0 4"), "data size"));
    EXPECT_TRUE(contains(fail4("3 5 3 70", "3 4 3 70"), "more nodes than announced"));
    EXPECT_TRUE(contains(fail4("3 5 3 70", "3 999999 3 70"), "999999 nodes"));
    EXPECT_TRUE(contains(fail4("3 5 3 70", "4611686018427387904 5 3 70"), "blocks"));
    EXPECT_TRUE(contains(fail4("2 70 5 4 3", "2 70 5 4 8"), "no node 8"));
    EXPECT_TRUE(contains(fail4("\n5\n4\n", "\n5\n5\n"), "node 5 comes twice"));
    EXPECT_TRUE(contains(fail4("1 1 1\n$EndNodes", "1 1 nan\n$EndNodes"), "not finite"));
    EXPECT_TRUE(contains(fail4("$Nodes", "$Other"), "$EndOther"));
    EXPECT_TRUE(contains(fail2("$Nodes\n5", "$Nodes\n4"), "$EndNodes expected"));
    EXPECT_TRUE(contains(fail2("$Nodes\n5", "$Nodes\n6"), "line 11"));
    EXPECT_TRUE(contains(fail2("$Elements\n3", "$Elements\n77777777"), "77777777 elements"));
    EXPECT_TRUE(contains(fail2("9 1 1 1", "-9 1 1 1"), "node tag"));
    const std::string big = replaced(msh2_binary(false), "$Nodes\n5", "$Nodes\n1");
    EXPECT_TRUE(contains(failure(gmsh_format(), big), "$EndNodes expected"));
}

TEST(Vtu, TextArraysAndOtherCells) {
    const std::string file =
        "<?xml version='1.0'?>\n<!-- a <comment> -->\n<VTKFile type='UnstructuredGrid' "
        "byte_order='LittleEndian'>\n<UnstructuredGrid><Piece NumberOfPoints='5' "
        "NumberOfCells='3'><PointData><DataArray type='Float64' Name='t' "
        "format='ascii'>1</DataArray></PointData><Points><DataArray type='Float32' "
        "NumberOfComponents='3' format='ascii'>\n0 0 0 1 0 0\n0 1 0 0 0 1 1 1 1\n</DataArray>"
        "</Points>\n<Cells><DataArray type='Int32' Name='connectivity' format='ascii'>0 1 2 0 1 2 "
        "3 1 2 3 4</DataArray><DataArray type='Int32' Name='offsets' format='ascii'>3 7 11"
        "</DataArray><DataArray type='UInt8' Name='types' format='ascii'>5 10 10</DataArray>"
        "</Cells></Piece></UnstructuredGrid></VTKFile>";
    const Mesh mesh = read(vtu_format(), file);
    EXPECT_EQ(mesh.points, corners);
    EXPECT_EQ(mesh.tetrahedra, two_tetrahedra().tetrahedra);
    EXPECT_EQ(mesh.other_cells, 1u);
    EXPECT_TRUE(contains(failure(vtu_format(), replaced(file, "3 7 11", "3 7 12")), "announced"));
    EXPECT_TRUE(contains(failure(vtu_format(), replaced(file, "3 7 11", "7 3 11")), "offset"));
    EXPECT_TRUE(
        contains(failure(vtu_format(), replaced(file, "3 1 2 3 4<", "3 1 2 3 5<")), "vertex 5"));
    EXPECT_TRUE(contains(failure(vtu_format(), replaced(file, "1 1 1\n", "1 1 inf\n")), "line 6"));
    EXPECT_TRUE(contains(failure(vtu_format(), replaced(file, "NumberOfPoints='5'",
                                                        "NumberOfPoints='5000000000000000000'")),
                         "cannot be"));
    EXPECT_TRUE(
        contains(failure(vtu_format(), replaced(file, "byte_order", "compressor='z' byte_order")),
                 "uncompressed"));
}

// -------------------------------------------------------------------------- hostile files ---

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
        // Bare text and bare doubles cannot tell that something is missing.
        const bool counted =
            s.format != &text_format() && s.format != &csv_format() && s.format != &raw_format();
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

TEST(Registry, FindsFormats) {
    EXPECT_EQ(format_from_path("a/b.VTU"), &vtu_format());
    EXPECT_EQ(format_from_path("a.b/c"), nullptr);
    EXPECT_EQ(format_from_path("x.1.node"), &tetgen_format());
    EXPECT_THROW(format_from_name("stl"), Error);
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
