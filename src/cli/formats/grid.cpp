// SPDX-License-Identifier: MIT
#include "cli/formats/grid.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>

#include "cli/byte_order.hpp"
#include "cli/formats/vtk_arrays.hpp"
#include "cli/formats/xml.hpp"
#include "cli/interrupt.hpp"

namespace mgdt::cli {
namespace {

bool fits_32_bits(std::uint64_t most) {
    return most <= static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
}

// Arrays are named in the header of a file, and follow in the same order.
struct Array {
    std::string attributes;
    std::uint64_t count;
    std::size_t item_size;
    // Appends items, least significant byte first.
    std::function<void(std::uint64_t begin, std::uint64_t end, std::string& bytes)> append;

    std::uint64_t size() const { return count * item_size; }
    // Calls take() with all bytes, block by block. The last block may be shorter.
    template <class Take>
    void each_block(const Take& take) const {
        const std::uint64_t items = CompressedArray::block_size / item_size;
        std::string bytes;
        for (std::uint64_t begin = 0; begin < count; begin += items) {
            bytes.clear();
            check_interrupt();
            append(begin, std::min(count, begin + items), bytes);
            take(bytes);
        }
    }
};

// An array whose i-th item is item(i), converted to T.
template <class T, class Item>
Array array_of(const char* type, const std::string& attributes, std::uint64_t count, Item item) {
    const auto append = [item](std::uint64_t begin, std::uint64_t end, std::string& bytes) {
        bytes.resize(static_cast<std::size_t>(end - begin) * sizeof(T));
        for (std::uint64_t i = begin; i < end; ++i) {
            const auto value = static_cast<T>(item(i));
            char* const to = bytes.data() + static_cast<std::size_t>(i - begin) * sizeof(T);
            std::memcpy(to, &value, sizeof(T));
            if (host_is_big_endian()) std::reverse(to, to + sizeof(T));
        }
    };
    return {fmt::format("type=\"{}\" {}", type, attributes), count, sizeof(T), append};
}

template <class Item>
Array integers(bool is_short, const char* name, std::uint64_t count, Item item) {
    const std::string attributes = fmt::format("Name=\"{}\"", name);
    return is_short ? array_of<std::int32_t>("Int32", attributes, count, item)
                    : array_of<std::int64_t>("Int64", attributes, count, item);
}

Array doubles(const std::string& name, std::size_t components, const std::vector<double>& values) {
    return array_of<double>("Float64",
                            fmt::format("Name=\"{}\" NumberOfComponents=\"{}\"", name, components),
                            values.size(), [&values](std::uint64_t i) { return values[i]; });
}

// The XML elements that name arrays. The positions of arrays follow from their sizes.
class Places {
  public:
    std::string element(const Array& array, std::uint64_t size) {
        const std::uint64_t begin = offset_;
        offset_ += size;
        return fmt::format("        <DataArray {} format=\"appended\" offset=\"{}\"/>\n",
                           array.attributes, begin);
    }

  private:
    std::uint64_t offset_ = 0;
};

}  // namespace

void write_grid(const Grid& grid, OutputFile& out) {
    const std::uint64_t points = grid.points.size() / 3,
                        corners = grid.vertices ? grid.vertices->size() : points,
                        cells = corners / grid.size;
    const bool short_numbers = fits_32_bits(points), short_offsets = fits_32_bits(corners);
    std::vector<Array> arrays = {
        doubles("Points", 3, grid.points),
        integers(short_numbers, "connectivity", corners,
                 [&](std::uint64_t i) {
                     return grid.vertices ? (*grid.vertices)[i] : static_cast<std::int64_t>(i);
                 }),
        integers(short_offsets, "offsets", cells,
                 [&](std::uint64_t i) { return static_cast<std::int64_t>(grid.size * (i + 1)); }),
        array_of<std::uint8_t>("UInt8", "Name=\"types\"", cells,
                               [&](std::uint64_t) { return grid.type; })};
    const std::size_t of_grid = arrays.size();
    for (const Field& f : grid.fields)
        arrays.push_back(doubles(to_xml(f.name), f.components, f.values));
    if (grid.ids != nullptr)
        arrays.push_back(integers(false, "point", grid.ids->size(),
                                  [&](std::uint64_t i) { return (*grid.ids)[i]; }));

    // Compressed arrays stay in memory until the header is written, which has their positions.
    std::vector<CompressedArray> compressed(grid.is_compressed ? arrays.size() : 0);
    for (std::size_t i = 0; i < compressed.size(); ++i)
        arrays[i].each_block([&](const std::string& bytes) { compressed[i].add_block(bytes); });
    Places places;
    const auto element = [&](std::size_t i) {
        return places.element(arrays[i], grid.is_compressed ? compressed[i].header().size() +
                                                                  compressed[i].blocks().size()
                                                            : 8 + arrays[i].size());
    };
    std::string head = fmt::format(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\"{}>\n"
        "  <UnstructuredGrid>\n"
        "    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"
        "      <Points>\n",
        grid.is_compressed ? " compressor=\"vtkZLibDataCompressor\"" : "", points, cells);
    head += element(0);
    head += "      </Points>\n      <Cells>\n";
    for (std::size_t i = 1; i < of_grid; ++i) head += element(i);
    head += "      </Cells>\n";
    if (arrays.size() > of_grid) head += "      <PointData>\n";
    for (std::size_t i = of_grid; i < arrays.size(); ++i) head += element(i);
    if (arrays.size() > of_grid) head += "      </PointData>\n";
    head +=
        "    </Piece>\n  </UnstructuredGrid>\n"
        "  <AppendedData encoding=\"raw\">\n_";
    out.write(head);
    for (std::size_t i = 0; i < arrays.size(); ++i) {
        if (grid.is_compressed) {
            out.write(compressed[i].header());
            out.write(compressed[i].blocks());
        } else {
            out.write_value(arrays[i].size());
            arrays[i].each_block([&](const std::string& bytes) { out.write(bytes); });
        }
    }
    out.write("\n  </AppendedData>\n</VTKFile>\n");
}

}  // namespace mgdt::cli
