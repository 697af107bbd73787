// SPDX-License-Identifier: MIT
#include "cli/formats/vtk_file.hpp"

#include "cli/formats/vtk_arrays.hpp"
#include "cli/interrupt.hpp"

namespace mgdt::cli {
namespace {

// Calls take() with all bytes of an array, block by block. The last block may be shorter.
template <class Take>
void each_block(const VtkArray& array, const Take& take) {
    const std::uint64_t items = CompressedArray::block_size / array.item_size;
    std::string bytes;
    for (std::uint64_t begin = 0; begin < array.count; begin += items) {
        bytes.clear();
        check_interrupt();
        array.append(begin, std::min(array.count, begin + items), bytes);
        take(bytes);
    }
}

}  // namespace

VtkArray vtk_doubles(const std::string& name, std::size_t components,
                     const std::vector<double>& values) {
    return vtk_array<double>("Float64",
                             fmt::format("Name=\"{}\" NumberOfComponents=\"{}\"", name, components),
                             values.size(), [&values](std::uint64_t i) { return values[i]; });
}

void write_vtk_file(const VtkFile& file, OutputFile& out) {
    // Compressed arrays stay in memory until the header is written, which has their positions.
    std::vector<CompressedArray> compressed;
    if (file.is_compressed) {
        for (const VtkSection& section : file.sections) {
            for (const VtkArray& array : section.arrays) {
                CompressedArray& bytes = compressed.emplace_back();
                each_block(array, [&](const std::string& block) { bytes.add_block(block); });
            }
        }
    }
    std::string head = fmt::format(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\"{1}>\n"
        "  <{0}>\n"
        "    <Piece {2}>\n",
        file.type, file.is_compressed ? " compressor=\"vtkZLibDataCompressor\"" : "", file.counts);
    std::uint64_t offset = 0;
    std::size_t number = 0;
    for (const VtkSection& section : file.sections) {
        head += fmt::format("      <{}>\n", section.name);
        for (const VtkArray& array : section.arrays) {
            head += fmt::format("        <DataArray {} format=\"appended\" offset=\"{}\"/>\n",
                                array.attributes, offset);
            offset += file.is_compressed
                          ? compressed[number].header().size() + compressed[number].blocks().size()
                          : 8 + array.size();
            ++number;
        }
        head += fmt::format("      </{}>\n", section.name);
    }
    head += fmt::format("    </Piece>\n  </{}>\n  <AppendedData encoding=\"raw\">\n_", file.type);
    out.write(head);
    if (file.is_compressed) {
        for (const CompressedArray& bytes : compressed) {
            out.write(bytes.header());
            out.write(bytes.blocks());
        }
    } else {
        for (const VtkSection& section : file.sections) {
            for (const VtkArray& array : section.arrays) {
                out.write_value(array.size());
                each_block(array, [&](const std::string& block) { out.write(block); });
            }
        }
    }
    out.write("\n  </AppendedData>\n</VTKFile>\n");
}

}  // namespace mgdt::cli
