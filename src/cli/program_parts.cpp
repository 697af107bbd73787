// SPDX-License-Identifier: MIT
#include "cli/program_parts.hpp"

#include <fmt/core.h>

#include <new>
#include <vector>

#include "cli/formats/pieces.hpp"
#include "cli/interrupt.hpp"

namespace mgdt::cli {
namespace {

std::int64_t number_of(const mgdt_parts* parts, std::int32_t part, std::int32_t key) {
    std::int64_t value = 0;
    mgdt_parts_get_stat(parts, part, key, &value);
    return value;
}

void get_array(const mgdt_parts* parts, std::int32_t part, std::int32_t array,
               std::vector<std::int64_t>& values) {
    std::int64_t size = 0;
    mgdt_parts_get_size(parts, part, array, &size);
    values.resize(static_cast<std::size_t>(size));
    if (mgdt_parts_get_array(parts, part, array, size, values.data()) != MGDT_OK)
        throw std::bad_alloc();
}

}  // namespace

ProgramParts::ProgramParts(mgdt_parts* handle, const TriangulationOptions& options)
    : handle_(handle) {
    mgdt_parts_set_option(handle_, MGDT_PARTS_THREADS, options.threads);
    mgdt_parts_set_option(handle_, MGDT_PARTS_MEMORY_LIMIT,
                          static_cast<std::int64_t>(options.memory_limit));
}

std::string ProgramParts::message(mgdt_status status) const {
    char text[256] = "";
    mgdt_parts_get_error(handle_, sizeof text, text);
    return text[0] != '\0' ? text : mgdt_status_string(status);
}

void ProgramParts::require(mgdt_status status, const std::string& doing) const {
    if (status != MGDT_OK) throw_status(status, fmt::format("{}: {}", doing, message(status)));
}

std::int64_t ProgramParts::number(std::int32_t part, std::int32_t key) const {
    return number_of(handle_, part, key);
}

void write_part(const mgdt_parts* parts, std::int32_t part, bool compress, OutputFile& out) {
    Piece piece;
    {
        std::vector<std::int64_t> corners;
        get_array(parts, part, MGDT_PARTS_LOCAL_CORNERS, corners);
        const std::int64_t own = number_of(parts, part, MGDT_PARTS_OWN_TETRAHEDRA);
        piece.corners.reserve(4 * static_cast<std::size_t>(own));
        for (std::int64_t i = 0; i < 4 * own; ++i)
            piece.corners.push_back(static_cast<MeshIndex>(corners[static_cast<std::size_t>(i)]));
    }
    get_array(parts, part, MGDT_PARTS_VERTEX_IDS, piece.ids);
    piece.points.resize(3 * piece.ids.size());
    mgdt_parts_get_coordinates(parts, part, static_cast<std::int64_t>(piece.points.size()),
                               piece.points.data());
    check_interrupt();
    write_piece(piece, compress, out);
    out.close();
}

}  // namespace mgdt::cli
