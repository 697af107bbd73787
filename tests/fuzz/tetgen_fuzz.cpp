// SPDX-License-Identifier: MIT
// TetGen's three files. NUL bytes, which are in none of them, separate .node, .ele and .neigh.
#include <array>

#include "reader.hpp"

namespace {

void write_three(const std::string& path, const mgdt::cli::Mesh& mesh, int base) {
    mgdt::cli::OutputSet outputs;
    mgdt::cli::WriteOptions options;
    options.index_base = base;
    mgdt::cli::tetgen_format().write_mesh(mesh, path, outputs, options);
    mgdt::cli::tetgen_format().write_neighbors(mesh.neighbors, path, outputs, options);
    outputs.commit();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const mgdt::cli::Format& format = mgdt::cli::tetgen_format();
    std::string_view rest = fuzz::text_of(data, size);
    std::array<std::string_view, 3> part;
    std::size_t parts = 0;
    while (parts < 3) {
        const std::size_t end = rest.find('\0');
        part[parts++] = rest.substr(0, end);
        if (end == std::string_view::npos) break;
        rest.remove_prefix(end + 1);
    }

    if (const auto nodes = fuzz::read(format, part[0], "x.node"))
        fuzz::points_return(format, nodes->points);
    if (parts == 1) return 0;

    const fuzz::Scratch& scratch = fuzz::Scratch::get();
    const std::string elements = scratch.file("x.ele"), neighbors = scratch.file("x.neigh");
    fuzz::put(scratch.file("x.node"), part[0]);
    unlink(neighbors.c_str());
    if (parts == 3) fuzz::put(neighbors, part[2]);
    const auto mesh = fuzz::read(format, part[1], elements, {}, size);
    fuzz::facets_and_markers_read(format, part[1], elements, size);
    if (!mesh || mesh->neighbors.size() != mesh->tetrahedra.size()) return 0;
    for (int base = 0; base < 2; ++base) {
        write_three(elements, *mesh, base);
        const auto again = fuzz::read(format, fuzz::bytes_of(elements), elements, {}, 100 * size);
        FUZZ_REQUIRE(again.has_value(), "the files that were written cannot be read");
        fuzz::expect_same_points(mesh->points, again->points);
        // An empty .node file does not say at which number points begin.
        FUZZ_REQUIRE(mesh->tetrahedra == again->tetrahedra, "tetrahedra of a round trip");
        FUZZ_REQUIRE(mesh->neighbors == again->neighbors, "neighbours of a round trip");
    }
    return 0;
}
