// SPDX-License-Identifier: MIT
// Points as raw doubles: x y z of each point, in little-endian order.
#include <fmt/core.h>

#include "cli/formats/bytes.hpp"
#include "cli/formats/format.hpp"

namespace mgdt::cli {
namespace {

Mesh read_raw(const Source& source, const ReadOptions&) {
    const std::size_t size = source.bytes.size();
    if (size % 24 != 0) {
        source.fail(
            fmt::format("{} bytes are no whole number of points of 24 bytes (three "
                        "doubles); the file is cut short or of another format (--from)",
                        size));
    }
    Mesh mesh;
    mesh.detail = "float64, little endian";
    mesh.points.resize(size / 8);
    ByteReader bytes(source, 0, false);
    for (double& x : mesh.points) x = bytes.coordinate<double>();
    return mesh;
}

std::optional<RowLayout> raw_rows(const Source&, std::size_t file_size) {
    if (file_size % 24 != 0) return std::nullopt;
    return RowLayout{0, file_size / 24, 24, true, false};
}

void write_raw(const std::vector<double>& points, OutputFile& out, const WriteOptions&) {
    out.write_values(points.data(), points.size());
}

}  // namespace

const Format& raw_format() {
    static const Format format = {"f64",
                                  {".f64", ".raw", ".bin"},
                                  "bare doubles, little endian",
                                  true,
                                  nullptr,
                                  read_raw,
                                  write_raw,
                                  nullptr,
                                  nullptr,
                                  nullptr,
                                  raw_rows};
    return format;
}

}  // namespace mgdt::cli
