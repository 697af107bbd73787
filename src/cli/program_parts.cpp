// SPDX-License-Identifier: MIT
#include "cli/program_parts.hpp"

#include <vector>

#include "cli/errors.hpp"
#include "cli/formats/pieces.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"

namespace mgdt::cli {

void set_options(Parts& parts, const TriangulationOptions& options) {
    parts.set_option(PartsOption::threads, options.threads);
    parts.set_option(PartsOption::memory_limit, static_cast<std::int64_t>(options.memory_limit));
}

void with_progress(Parts& parts, const std::string& name, bool quiet,
                   const std::function<void()>& work) {
    Progress progress("triangulating", quiet);
    parts.set_progress([&](double fraction) { return progress.update_and_hear(fraction); });
    try {
        work();
    } catch (...) {
        rethrow_failure(name, parts.last_error());
    }
    parts.clear_progress();
}

void write_part(const Parts& parts, std::int32_t part, bool compress, OutputFile& out) {
    Piece piece;
    {
        const auto corners = parts.rows(PartsArray::local_corners, part);
        const auto own = static_cast<std::size_t>(parts.number(PartsNumber::own_tetrahedra, part));
        piece.corners.reserve(4 * own);
        for (std::size_t i = 0; i < own; ++i)
            for (const std::int64_t corner : corners[i])
                piece.corners.push_back(static_cast<MeshIndex>(corner));
    }
    piece.ids = parts.array(PartsArray::vertex_ids, part);
    piece.points.reserve(3 * piece.ids.size());
    for (const Point& xyz : parts.coordinates(part))
        piece.points.insert(piece.points.end(), xyz.begin(), xyz.end());
    check_interrupt();
    write_piece(piece, compress, out);
    out.close();
}

}  // namespace mgdt::cli
