// SPDX-License-Identifier: MIT
#include "cli/input_share.hpp"

#include <optional>

#include "cli/formats/bytes.hpp"
#include "cli/gzip.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {
namespace {

// The headers of these files are a few hundred bytes long.
constexpr std::size_t beginning_bytes = std::size_t{1} << 17;

}  // namespace

std::optional<RowLayout> shared_layout(const InputOptions& options) {
    // A pipe can be read only once, and in compressed bytes the position of a point is not known.
    if (options.path == "-" || is_gzip_name(options.path)) return std::nullopt;
    const auto status = system::status(options.path);
    if (!status || status->kind != system::FileKind::regular) return std::nullopt;
    const InputFile file(options.path, 0, beginning_bytes);
    const Source beginning = file.source();
    if (!file.file_size() || beginning.bytes.empty()) return std::nullopt;
    const Format& format = input_format(beginning, options.from);
    if (format.rows == nullptr) return std::nullopt;
    return format.rows(beginning, *file.file_size());
}

Share read_share(const InputOptions& options, const std::optional<RowLayout>& layout, int reader,
                 int readers) {
    Share share;
    if (!layout) {
        if (reader > 0) return share;
        Mesh mesh = read_input(options);
        share.points = std::move(mesh.points);
        share.mid_side_nodes = mesh.mid_side_nodes;
        share.inputs = std::move(mesh.inputs);
        return share;
    }
    const auto all = static_cast<std::size_t>(readers);
    const auto begin_of = [&](int r) {
        const auto i = static_cast<std::size_t>(r);
        return layout->rows / all * i + layout->rows % all * i / all;
    };
    const std::size_t first = begin_of(reader), n = begin_of(reader + 1) - first;
    const InputFile file(options.path, layout->begin + first * layout->row_bytes,
                         n * layout->row_bytes);
    const Source source = file.source();
    share.first = static_cast<std::int64_t>(first);
    share.points.resize(3 * n);
    ByteReader bytes(source, 0, layout->big_endian);
    for (std::size_t i = 0; i < n; ++i) {
        bytes.seek(i * layout->row_bytes);
        for (std::size_t k = 0; k < 3; ++k)
            share.points[3 * i + k] =
                layout->wide ? bytes.coordinate<double>() : bytes.coordinate<float>();
    }
    if (file.identity()) share.inputs.push_back(*file.identity());
    return share;
}

}  // namespace mgdt::cli
