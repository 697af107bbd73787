// SPDX-License-Identifier: MIT
// Fields beside the points: what is written reads back bit for bit, and damaged files are errors.
#include <cmath>
#include <limits>

#include "formats_support.hpp"

namespace mgdt::cli {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

ReadOptions with_fields(std::vector<std::string> names = {}) {
    ReadOptions options;
    options.has_fields = true;
    options.field_names = std::move(names);
    return options;
}

Mesh with_two_fields() {
    Mesh mesh = two_tetrahedra();
    mesh.fields.push_back({"pressure", 1, {0.1, -0.0, 5e-324, DBL_MAX, nan_value}});
    mesh.fields.push_back({"velocity", 3, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}});
    return mesh;
}

std::string with_values(const Format& format, const Mesh& mesh) {
    Directory directory;
    const std::string path = directory.file("out");
    OutputSet outputs;
    format.write_fields(mesh, outputs.open(path), {});
    outputs.commit();
    return bytes_of(path);
}

std::vector<const Format*> formats_of_fields() {
    std::vector<const Format*> formats;
    for (const Format* f : all_formats()) {
        if (f->write_fields) formats.push_back(f);
    }
    return formats;
}

// Value k of point i, whether a vector is one field or three.
double value(const Mesh& mesh, std::size_t i, std::size_t k) {
    for (const Field& f : mesh.fields) {
        if (k < f.components) return f.values[i * f.components + k];
        k -= f.components;
    }
    ADD_FAILURE() << "no value " << k;
    return 0;
}

TEST(Fields, RoundTrip) {
    const Mesh mesh = with_two_fields();
    ASSERT_EQ(formats_of_fields().size(), 4u);
    for (const Format* f : formats_of_fields()) {
        const std::string bytes = with_values(*f, mesh);
        const Mesh back = read(*f, bytes, with_fields());
        EXPECT_TRUE(same_bits(back.points, mesh.points)) << f->name;
        for (std::size_t i = 0; i < 5; ++i) {
            for (std::size_t k = 0; k < 4; ++k) {
                const double a = value(mesh, i, k), b = value(back, i, k);
                const bool is_same =
                    std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
                EXPECT_TRUE(is_same) << f->name << ": " << a << " and " << b;
            }
        }
        // The fields of points are not looked at where nobody asks for them.
        if (f != &npy_format()) {
            EXPECT_TRUE(read(*f, bytes).fields.empty()) << f->name;
        }
    }
    EXPECT_EQ(read(vtu_format(), with_values(vtu_format(), mesh), with_fields()).tetrahedra,
              mesh.tetrahedra);
}

TEST(Fields, ByName) {
    Mesh mesh = with_two_fields();
    for (const Format* f : formats_of_fields()) {
        const bool has_names = f != &npy_format();
        const std::string bytes = with_values(*f, mesh);
        const std::string first = has_names ? "pressure" : "column4";
        const Mesh one = read(*f, bytes, with_fields({first}));
        ASSERT_EQ(one.fields.size(), 1u) << f->name;
        EXPECT_EQ(one.fields[0].name, first);
        EXPECT_EQ(one.fields[0].values[3], DBL_MAX);
        const std::string says = failure(*f, bytes, with_fields({first, "humidity"}));
        EXPECT_TRUE(contains(says, "no field 'humidity'")) << f->name;
        EXPECT_TRUE(contains(says, "'" + first + "'")) << f->name;
    }
    mesh.fields.resize(1);
    for (const char* name : {"T & <p> \"q\" 'r'", "x", "1e5", "", "a,b;c#d e"}) {
        mesh.fields[0].name = name;
        const Mesh grid = read(vtu_format(), with_values(vtu_format(), mesh), with_fields());
        EXPECT_EQ(grid.fields.at(0).name, name);
        for (const Format* f : {&text_format(), &csv_format()}) {
            const Mesh back = read(*f, with_values(*f, mesh), with_fields());
            EXPECT_EQ(back.point_count(), 5u) << f->name << " " << name;
            EXPECT_EQ(back.fields.size(), 1u) << f->name << " " << name;
        }
    }
}

TEST(Fields, Text) {
    const std::string table = "name;T;x;y;z;\na;1,5;0;0;0;7\n";
    EXPECT_TRUE(contains(failure(text_format(), table, with_fields({"T"})),
                         "line 2: column 2: '1,5' is not a number"));
    const Mesh words =
        read(text_format(), "T,x,label,y,z\n-inf,0,a,0,0\n2,0,3,0,1\n", with_fields());
    ASSERT_EQ(words.fields.size(), 1u);  // of numbers
    EXPECT_EQ(words.fields[0].name, "T");
    EXPECT_EQ(words.fields[0].values, (Points{-std::numeric_limits<double>::infinity(), 2}));
    ReadOptions first_three = with_fields();
    first_three.columns = {{1, 2, 3}};
    const Mesh bare = read(text_format(), "0 0 0 5\n1 0 0 6 9\n", first_three);
    ASSERT_EQ(bare.fields.size(), 1u);
    EXPECT_EQ(bare.fields[0].name, "column4");
    EXPECT_EQ(bare.fields[0].values, (Points{5, 6}));
    ReadOptions chosen = with_fields();
    chosen.columns = {{2, 3, 4}};
    EXPECT_EQ(read(text_format(), "5 0 0 1\n", chosen).fields[0].name, "column1");
    EXPECT_EQ(read(text_format(), "T a b c\n5 0 0 1\n", chosen).fields[0].name, "T");
    EXPECT_TRUE(contains(failure(text_format(), "0 0 0 5\n1 0 0\n", first_three),
                         "line 2: 3 columns, but 'column4' needs column 4"));
    EXPECT_TRUE(contains(failure(text_format(), "0 0 0 5\n1 0 0 six\n", first_three),
                         "line 2: column 4: 'six' is not a number"));
    EXPECT_TRUE(contains(failure(text_format(), "x,y,z,T\n1,0,0\n", with_fields()),
                         "line 2: 3 columns, but line 1 has 4"));
    EXPECT_TRUE(read(text_format(), "x y z\n1 0 0\n", with_fields()).fields.empty());
}

TEST(Fields, Npy) {
    const auto array = [](const char* type, const char* shape, const std::string& data) {
        return npy(
            std::string("{'descr': '") + type + "', 'fortran_order': True, 'shape': " + shape + "}",
            data);
    };
    const Mesh mesh = read(
        npy_format(), array(">f4", "(2, 4)", raw({0.f, 1.f, 2.f, 3.f, 4.f, 5.f, 6.f, 7.f}, true)),
        with_fields());
    EXPECT_EQ(mesh.points, (Points{0, 2, 4, 1, 3, 5}));
    EXPECT_EQ(mesh.fields.at(0).values, (Points{6, 7}));
    // No rows, and no end of columns.
    EXPECT_TRUE(
        read(npy_format(), array("<f8", "(0, 1000000000000)", ""), with_fields()).fields.empty());
    EXPECT_TRUE(
        contains(failure(npy_format(), array("<f8", "(1, 4611686018427387904)", ""), with_fields()),
                 "cut short"));

    const auto values = [](const std::string& bytes) {
        return read_npy_values(Source{"file", "", bytes});
    };
    const Field rows = values(array("<i4", "(2, 2)", raw<std::int32_t>({1, 2, 3, 4})));
    EXPECT_EQ(rows.components, 2u);
    EXPECT_EQ(rows.values, (Points{1, 3, 2, 4}));
    EXPECT_EQ(values(array("<i8", "(2,)", raw<std::int64_t>({1, -2}))).values, (Points{1, -2}));
    EXPECT_EQ(values(array("<f8", "(1,)", raw({0.5}))).values, (Points{0.5}));
    EXPECT_EQ(values(array("<f8", "(0, 7)", "")).values, Points{});
    for (const auto& [bytes, says] : {std::pair{array("<c16", "(1,)", raw({0.5, 1.0})), "'<c16'"},
                                      {array("<f8", "(1, 1, 1)", raw({0.5})), "(n, m) is needed"},
                                      {array("<f8", "()", raw({0.5})), "(n, m) is needed"},
                                      {array("<f8", "(1, 0)", ""), "no columns"},
                                      {array("<f8", "(2,)", raw({0.5})), "cut short"}}) {
        try {
            values(bytes);
            ADD_FAILURE() << says;
        } catch (const Error& e) {
            EXPECT_TRUE(contains(e.what(), says));
        }
    }
}

const char* const grid =
    "<VTKFile type='UnstructuredGrid' byte_order='LittleEndian'>\n<UnstructuredGrid>"
    "<Piece NumberOfPoints='2' NumberOfCells='0'><PointData>\n"
    "<DataArray type='Int16' Name='a&lt;b' format='ascii'>1 -2</DataArray>\n"
    "<DataArray type='Float32' Name='v' NumberOfComponents='2' format='ascii'>1 nan 3 "
    "4</DataArray>\n"
    "<DataArray type='String' Name='s' format='ascii'>1 2</DataArray></PointData>\n"
    "<CellData><DataArray type='Float64' Name='c' format='ascii'></DataArray></CellData>"
    "<Points><DataArray type='Float32' NumberOfComponents='3' format='ascii'>0 0 0 1 0 "
    "0</DataArray>"
    "</Points><Cells><DataArray type='Int32' Name='connectivity' format='ascii'></DataArray>"
    "<DataArray type='Int32' Name='offsets' format='ascii'></DataArray>"
    "<DataArray type='UInt8' Name='types' format='ascii'></DataArray>"
    "</Cells></Piece></UnstructuredGrid></VTKFile>";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(Fields, Vtu) {
    const Mesh mesh = read(vtu_format(), grid, with_fields());
    ASSERT_EQ(mesh.fields.size(), 2u);
    EXPECT_EQ(mesh.fields[0].name, "a<b");
    EXPECT_EQ(mesh.fields[0].values, (Points{1, -2}));
    EXPECT_EQ(mesh.fields[1].components, 2u);
    EXPECT_TRUE(std::isnan(mesh.fields[1].values[1]));
    EXPECT_EQ(mesh.fields[1].values[3], 4);
    const auto fails = [](const char* from, const char* to) {
        return failure(vtu_format(), replaced(grid, from, to), with_fields());
    };
    EXPECT_TRUE(contains(fails("1 -2", "1 two"), "line 3: value: 'two' is not a number"));
    EXPECT_TRUE(contains(fails("1 -2", "1   "), "1 values; 2 are announced"));
    EXPECT_TRUE(
        contains(fails("NumberOfComponents='2'", "NumberOfComponents='9223372036854775807'"),
                 "more than the file has"));
    EXPECT_TRUE(contains(fails("NumberOfComponents='2'", "NumberOfComponents='-1'"), "a count"));
    // Points without cells are written as a cell each, so that they are shown.
    const Mesh shown = read(vtu_format(), with_values(vtu_format(), mesh), with_fields());
    EXPECT_EQ(shown.other_cells, 2u);
    EXPECT_EQ(shown.fields.size(), 2u);
}

// A small file with many arrays that are one and the same does not fill the memory.
TEST(Fields, ArraysThatShareBytes) {
    Mesh mesh = two_tetrahedra();
    mesh.fields.push_back({"a", 40, Points(200)});
    std::string bytes = with_values(vtu_format(), mesh);
    const std::size_t at = bytes.find("<DataArray", bytes.find("<PointData>"));
    const std::string array = bytes.substr(at, bytes.find('>', at) + 1 - at);
    EXPECT_EQ(read(vtu_format(), bytes, with_fields()).fields.size(), 1u);
    const std::size_t name = bytes.find("\"a\"", at);
    const std::string noisy = bytes.substr(0, name) + "\"\x1b\"" + bytes.substr(name + 3);
    const std::string cut = replaced(noisy, "\"40\"", "\"39\"");
    EXPECT_TRUE(contains(failure(vtu_format(), cut, with_fields()), "the array '\\x1b' has"));
    for (int i = 0; i < 5; ++i) bytes.insert(at, array);
    EXPECT_TRUE(contains(failure(vtu_format(), bytes, with_fields()), "more than the file has"));
}

TEST(Fields, DamagedFiles) {
    Mesh mesh = with_two_fields();
    std::vector<std::pair<const Format*, std::string>> files = {{&vtu_format(), grid}};
    for (const Format* f : formats_of_fields()) files.emplace_back(f, with_values(*f, mesh));
    for (const auto& [format, bytes] : files) {
        const auto attempt = [&, f = format](const std::string& damaged) {
            try {
                const Mesh back = read(*f, damaged, with_fields());
                for (const Field& field : back.fields) {
                    EXPECT_EQ(field.values.size(), field.components * back.point_count());
                }
            } catch (const Error& e) {
                EXPECT_EQ(e.code(), exit_input) << e.what();
            }
        };
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            attempt(bytes.substr(0, i));
            attempt(bytes.substr(0, i) + bytes.substr(i + 1));
            for (const char c : {'\0', '\xff', '9', '-', '\n', ' ', '<', '"'}) {
                std::string damaged = bytes;
                damaged[i] = c;
                attempt(damaged);
            }
        }
    }
}

}  // namespace
}  // namespace mgdt::cli
