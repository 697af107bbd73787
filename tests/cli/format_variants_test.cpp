// SPDX-License-Identifier: MIT
// Every documented variant of a format is read, and what is not is refused with a message that says
// where.
#include <cmath>

#include "formats_support.hpp"

namespace mgdt::cli {
namespace {

ReadOptions with_all_fields() {
    ReadOptions options;
    options.has_fields = true;
    return options;
}

TEST(Text, Separators) {
    const Points expected = {1, 2, 3, 4, 5, 6};
    for (const char* text :
         {"1 2 3\n4 5 6\n", "1,2,3\n4,5,6", "1;2;3\r\n4;5;6\r\n", "1\t2\t3\n4\t5\t6\n",
          " 1 , 2 ,3 \n\n  4 ,  5, 6 \n", "1 2 3\n  4   5 6 \n", "1,2,3,\n4,5,6,\n",
          "# comment\n1 2 3 # more\n#\n4 5 6", "! comment\n1 2 3 ! more\n  // too\n4 5 6 //",
          "x y z\n1 2 3\n4 5 6", "\"x\",\"y\",\"z\"\n1,2,3\n4,5,6\n", "2\n1 2 3\n4 5 6\n",
          "\xef\xbb\xbf"
          "1 2 3\n4 5 6\n",
          "1 2 3\r4 5 6\r", "1.0D0 2.D0 3\n+4 5 6\n"}) {
        EXPECT_EQ(read(text_format(), text).points, expected) << text;
    }
}

TEST(Text, Columns) {
    ReadOptions options;
    options.columns = {{4, 1, 2}};
    EXPECT_EQ(read(csv_format(), "y,z,name,x\n2,3,a,1\n5,6,b,4\n", options).points,
              (Points{1, 2, 3, 4, 5, 6}));
    EXPECT_TRUE(contains(failure(csv_format(), "2,3,a\n", options), "x needs column 4"));
    EXPECT_TRUE(contains(failure(csv_format(), "2,3,a,1\n5,6,b\n", options), "line 2: 3 columns"));
    // Chosen columns, and text of any number of words.
    options.columns = {{1, 2, 3}};
    EXPECT_EQ(read(text_format(), "1 2 3 one\n4 5 6 two words\n", options).points,
              (Points{1, 2, 3, 4, 5, 6}));
}

// A lost or additional field moves the coordinates to other columns.
TEST(Text, RowsHaveTheSameColumns) {
    for (const char* text :
         {"1 2 3\n4 5 6 7\n", "1,2,3\n4,5,6,7\n", "1,2,3\n4,5,6,\n", "x,y,z\n1,2,3,4\n",
          "x,y,z,t\n1,2,3\n", "t;x;y;z\n1;2;3\n", "2\n1 2 3\n4 5 6 7\n"}) {
        const std::string what = failure(csv_format(), text);
        EXPECT_TRUE(contains(what, "line 2") || contains(what, "line 3")) << text;
        EXPECT_TRUE(contains(what, " column")) << text;
    }
    ReadOptions options;
    options.columns = {{1, 2, 3}};
    EXPECT_TRUE(contains(failure(csv_format(), "1,2,3,4\n1,2,3\n", options),
                         "line 2: 3 columns, but line 1 has 4"));
}

TEST(Text, MoreThanThreeColumnsWithoutNames) {
    const auto says = [](const char* text, const char* part) {
        return contains(failure(text_format(), text), part);
    };
    EXPECT_TRUE(says("1 0 0 0\n2 1 0 0\n", "line 1: 4 columns without names"));
    EXPECT_TRUE(says("1 0 0 0\n2 1 0 0\n", "--columns 2,3,4: the first column counts"));
    EXPECT_TRUE(says("0,5,6,7\n1,8,9,7\n# so\n2,5,5,5\n", "the first column counts"));
    for (const char* text : {"1 0 0 0\n", "1 0 0 0\n3 1 0 0\n", "2 0 0 0\n3 1 0 0\n",
                             "1.5 0 0 0\n2.5 1 0 0\n", "2\n0 0 0 255\n1 0 0 255 0\n"}) {
        EXPECT_TRUE(says(text, "say which are x, y and z, with --columns 1,2,3 or others") ||
                    says(text, "the first column counts"))
            << text;
    }
    EXPECT_FALSE(says("1 0 0 0\n3 1 0 0\n", "counts"));
    ReadOptions options;
    options.columns = {{2, 3, 4}};
    EXPECT_EQ(read(text_format(), "1 0 0 0\n2 1 0 0\n", options).points,
              (Points{0, 0, 0, 1, 0, 0}));
}

// The number of atoms, a line of anything, then an element and its place.
TEST(Text, AtomsOfChemists) {
    const Points expected = {1, 2, 3, 4, 5, 6};
    for (const char* text :
         {"2\nwater, 1 2 3 4\nO 1 2 3\nH 4 5 6\n", "2\n\nO 1 2 3 0.5\nH1 4 5 6 0.25\n\n\n",
          " 2 \r\nLattice=\"5 0 0\" # x\r\n  O 1 2 3\r\n H 4 5 6\r\n", "2\n\n8 1 2 3\n1 4 5 6\n",
          "2\nof numbers\n8 1 2 3\n1 4 5 6\n"}) {
        EXPECT_EQ(read(text_format(), text).points, expected) << text;
    }
    EXPECT_TRUE(contains(failure(text_format(), "3\n\nO 1 2 3\nH 4 5 6\n"), "announces 3 points"));
    EXPECT_TRUE(contains(failure(text_format(), "1\n\nO 1 2 3\n1\n\nO 4 5 6\n"),
                         "line 4: text after the 1 atoms"));
    EXPECT_TRUE(contains(failure(text_format(), "2\n\nO 1 2 3\nH 4 5\n"), "line 4"));
    const Mesh charged = read(text_format(), "1\n\nO 1 2 3 0.5\n", with_all_fields());
    ASSERT_EQ(charged.fields.size(), 1u);
    EXPECT_EQ(charged.fields[0].values, (Points{0.5}));
    // No title of text: a table with a count and four columns.
    EXPECT_TRUE(contains(failure(text_format(), "2\n8 1 2 3\n1 4 5 6\n"), "4 columns"));
}

TEST(Text, NamesOfColumns) {
    const Points expected = {1, 2, 3, 4, 5, 6};
    for (const char* text :
         {"id,x,y,z\n7,1,2,3\n8,4,5,6\n", "\"id\",\"X\",\"Y\",\"Z\"\n7,1,2,3\n8,4,5,6\n",
          "id z y x\n7 3 2 1\n8 6 5 4\n", "what; x ;y;z\na;1;2;3\n\"b;c\";4;5;6\n",
          "lon,lat,height\n1,2,3\n4,5,6\n",
          "\"Points:0\",\"Points:1\",\"Points:2\",\"x\"\n1,2,3,9\n4,5,6,9\n",
          "\"T\",\"Points_0\",\"Points_1\",\"Points_2\"\n9,1,2,3\n9,4,5,6\n",
          "Station;Northing;Easting;Height\na;2;1;3\nb;5;4;6\n",
          "easting northing elevation t\n1 2 3 9\n4 5 6 9\n"}) {
        EXPECT_EQ(read(csv_format(), text).points, expected) << text;
    }
    for (const char* text : {"id,lon,lat,h\n7,1,2,3\n", "x,x,y,z\n9,1,2,3\n", "x,y,w,t\n1,2,3,4\n",
                             "a title of words\n1 2 3\n"}) {
        EXPECT_TRUE(contains(failure(csv_format(), text), "line 1")) << text;
        EXPECT_TRUE(contains(failure(csv_format(), text), "x, y and z")) << text;
    }
    // Far apart: the product of these columns' numbers is beyond an int, and 0 in its bits.
    std::string names, numbers;
    for (int column = 1; column <= 4096; ++column) {
        names += column == 1024 ? "x," : column == 2048 ? "y," : column == 4096 ? "z," : "t,";
        numbers += std::to_string(column) + ",";
    }
    EXPECT_EQ(read(csv_format(), names + "\n" + numbers + "\n").points, (Points{1024, 2048, 4096}));
    ReadOptions options;
    options.columns = {{2, 3, 4}};
    EXPECT_EQ(read(csv_format(), "x,lon,lat,z,y\n9,1,2,3,9\n", options).points, (Points{1, 2, 3}));
}

TEST(Text, OneSeparator) {
    for (const char* text : {"1,5;2,5;3,5\n", "x;y;z\n1,5;2,5;3,5\n", "1,5 2,5 3,5\n"}) {
        const std::string what = failure(csv_format(), text);
        EXPECT_TRUE(contains(what, text[0] == 'x' ? "line 2" : "line 1"));
    }
    EXPECT_TRUE(contains(failure(csv_format(), "1,5;2,5;3,5\n"), "decimals by points"));
    EXPECT_TRUE(contains(failure(csv_format(), "1,2,3\n4;5;6\n"), "line 2"));
    EXPECT_TRUE(contains(failure(csv_format(), "1 2 3\n4,5,6\n"), "line 2"));
    EXPECT_TRUE(contains(failure(csv_format(), "1;2;3\n4 5 6\n"), "line 2"));
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
    // Advice that is for points would destroy tetrahedra.
    const std::string tetrahedra =
        fail("{'descr': '<i8', 'fortran_order': False, 'shape': (2, 4)}");
    EXPECT_TRUE(contains(tetrahedra, "tetrahedra, without their points"));
    EXPECT_FALSE(contains(tetrahedra, "astype"));
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
    std::string nodes = "10 3 0 0\n";
    for (const char* p : {"1 0 0 0", "2 1 0 0", "3 0 1 0", "4 0 0 1", "5 .5 0 0", "6 .5 .5 0",
                          "7 0 .5 0", "8 0 0 .5", "9 .5 0 .5", "10 0 .5 .5"}) {
        nodes += std::string(p) + "\n";
    }
    put(directory.file("m.node"), nodes);
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
    EXPECT_TRUE(contains(fail("1 4 0\n1 0 1 2 3\n"), "vertex is 0; it must be from 1 to 10"));
    EXPECT_TRUE(contains(fail("1 4 0\n1 1 2 3 11\n"), "m.ele: line 2"));
    EXPECT_TRUE(contains(fail("1 8 0\n1 1 2 3 4 5 6 7 8\n"), "8 nodes"));
    EXPECT_TRUE(contains(fail("999999999999 4 0\n1 1 2 3 4\n"), "announces"));
    unlink((ele.substr(0, ele.size() - 4) + ".node").c_str());
    EXPECT_TRUE(contains(fail("1 4 0\n1 1 2 3 4\n"), "m.node: cannot read"));
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
    // Text is not compressed.
    const std::string other = replaced(file, "byte_order", "compressor='z' byte_order");
    EXPECT_EQ(read(vtu_format(), other).points, corners);
    EXPECT_TRUE(contains(
        failure(vtu_format(), replaced(other, "'3' format='ascii'", "'3' format='binary'")),
        "cannot expand"));
    const std::string binary = replaced(file, "'3' format='ascii'", "'3' format='binary'");
    EXPECT_TRUE(contains(failure(vtu_format(), binary), "base64"));
}

}  // namespace
}  // namespace mgdt::cli
