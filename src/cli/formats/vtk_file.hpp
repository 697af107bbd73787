// SPDX-License-Identifier: MIT
// Writes a file of VTK's XML. Its arrays are appended in raw binary, each compressed, or with a
// length of 64 bits before it.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "cli/byte_order.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli {

struct VtkArray {
    std::string attributes;
    std::uint64_t count;
    std::size_t item_size;
    // Appends items, least significant byte first.
    std::function<void(std::uint64_t begin, std::uint64_t end, std::string& bytes)> append;

    std::uint64_t size() const { return count * item_size; }
};

struct VtkSection {
    const char* name;  // "Points", "Cells", ...
    std::vector<VtkArray> arrays;
};

struct VtkFile {
    const char* type;    // "UnstructuredGrid" or "PolyData"
    std::string counts;  // the attributes of the element Piece
    std::vector<VtkSection> sections;
    bool is_compressed = false;
};

void write_vtk_file(const VtkFile& file, OutputFile& out);

// An array whose i-th item is item(i), converted to T.
template <class T, class Item>
VtkArray vtk_array(const char* type, const std::string& attributes, std::uint64_t count,
                   Item item) {
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

// An array of integers, of 32 bits if `most`, the largest of them, fits.
template <class Item>
VtkArray vtk_integers(std::uint64_t most, const char* name, std::uint64_t count, Item item) {
    const std::string attributes = fmt::format("Name=\"{}\"", name);
    return most <= 0x7FFFFFFF ? vtk_array<std::int32_t>("Int32", attributes, count, item)
                              : vtk_array<std::int64_t>("Int64", attributes, count, item);
}

// An array of doubles, which stays where it is.
VtkArray vtk_doubles(const std::string& name, std::size_t components,
                     const std::vector<double>& values);

}  // namespace mgdt::cli
