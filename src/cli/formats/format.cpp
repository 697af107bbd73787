// SPDX-License-Identifier: MIT
#include "cli/formats/format.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "cli/errors.hpp"
#include "cli/formats/mid_side_nodes.hpp"
#include "cli/formats/vtk_arrays.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {
namespace {

std::string extension(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    const std::size_t slash = system::last_separator(path);
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
    std::string e = path.substr(dot);
    std::transform(e.begin(), e.end(), e.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return e;
}

std::string names() {
    std::vector<const char*> list;
    for (const Format* f : all_formats()) list.push_back(f->name);
    return fmt::format("{}", fmt::join(list, ", "));
}

// Throws if a facet has a corner that is no point, or fewer than three corners, or if an end of a
// segment is no point.
void require_corners(const Mesh& mesh, const Source& source) {
    const FileFacets& facets = mesh.facets;
    for (const std::int64_t end : facets.segments)
        if (end < 0 || end >= static_cast<std::int64_t>(mesh.point_count()))
            source.fail(
                fmt::format("a segment has the end {}, counted from 0, but there are {} "
                            "vertices",
                            end, mesh.point_count()));
    for (std::size_t f = 0; f < facets.size(); ++f) {
        if (facets.begin[f + 1] - facets.begin[f] < 3)
            source.fail(fmt::format("face {} has fewer than three corners", f));
        for (auto i = facets.begin[f]; i < facets.begin[f + 1]; ++i) {
            const std::int64_t corner = facets.corners[static_cast<std::size_t>(i)];
            if (corner < 0 || corner >= static_cast<std::int64_t>(mesh.point_count()))
                source.fail(
                    fmt::format("face {} has the corner {}, counted from 0, but there are "
                                "{} vertices",
                                f, corner, mesh.point_count()));
        }
    }
}

}  // namespace

const std::vector<const Format*>& all_formats() {
    static const std::vector<const Format*> formats = {
        &text_format(),         &csv_format(),    &npy_format(),         &raw_format(),
        &ply_format(),          &obj_format(),    &off_format(),         &stl_format(),
        &tetgen_format(),       &poly_format(),   &gmsh_format(),        &gmsh2_format(),
        &vtu_format(),          &vtp_format(),    &vtk_format(),         &medit_format(),
        &medit_binary_format(), &abaqus_format(), &lammps_dump_format(), &lammps_data_format(),
        &poscar_format()};
    return formats;
}

const Format& format_from_name(const std::string& name) {
    for (const Format* f : all_formats()) {
        if (name == f->name) return *f;
    }
    throw Error(exit_usage,
                fmt::format("unknown format {}; it is one of {}", quote(name), names()));
}

const Format* format_from_path(const std::string& path) {
    const std::size_t slash = system::last_separator(path);
    const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
    if (name == "POSCAR" || name == "CONTCAR") return &poscar_format();
    const std::string e = extension(path);
    for (const Format* f : all_formats()) {
        for (const char* known : f->extensions) {
            if (e == known) return f;
        }
    }
    return nullptr;
}

const Format* format_from_content(std::string_view bytes) {
    for (const Format* f : all_formats()) {
        if (f->sniff && f->sniff(bytes)) return f;
    }
    // Text has no signature; it is recognised by the absence of control characters.
    const std::string_view start = bytes.substr(0, 4096);
    const bool printable = std::all_of(start.begin(), start.end(), [](char c) {
        const auto u = static_cast<unsigned char>(c);
        return u >= 0x20 || u == '\n' || u == '\r' || u == '\t' || u == '\f';
    });
    return printable ? &text_format() : nullptr;
}

const Format& input_format(const Source& source, const std::string& name) {
    if (!name.empty()) return format_from_name(name);
    if (const Format* f = format_from_path(source.path)) return *f;
    const std::string e = extension(source.path);
    if (const Format* f = format_from_content(source.bytes)) {
        // Text without a signature may be anything.
        if (e.empty() || f != &text_format()) return *f;
    }
    source.fail(fmt::format("unknown format{}; choose it with --from ({})",
                            e.empty() ? "" : fmt::format(" by the extension {}", quote(e)),
                            names()));
}

Mesh read_mesh(const Format& format, const Source& source, const ReadOptions& options) {
    Mesh mesh = format.read(source, options);
    if (mesh.has_tetrahedra &&
        std::max(mesh.point_count(), mesh.tetrahedron_count()) > most_in_mesh) {
        source.fail(fmt::format("{} points and {} tetrahedra; at most {} of each are possible",
                                mesh.point_count(), mesh.tetrahedron_count(), most_in_mesh));
    }
    leave_out_mid_side_nodes(mesh);
    require_corners(mesh, source);
    return mesh;
}

const Format& output_format(const std::string& path, const std::string& name) {
    if (!name.empty()) return format_from_name(name);
    if (const Format* f = format_from_path(path)) return *f;
    throw Error(exit_usage,
                fmt::format("{}: unknown format by the name; choose it with --to ({})",
                            path == "-" ? "standard output" : printable(path), names()));
}

WriteOptions options_after(const Mesh& input, const Format* format, WriteOptions options) {
    if (format == &tetgen_format() && !options.is_base_chosen)
        options.index_base = input.first_number.value_or(0);
    return options;
}

void require_compressible(const WriteOptions& options, const Format& format) {
    if (!options.compress) return;
    if (&format != &vtu_format() && &format != &vtp_format())
        throw Error(exit_usage, fmt::format("--compress is for .vtu and .vtp, not for {} ({})",
                                            format.name, format.description));
    if (!can_compress())
        throw Error(exit_usage, "this program was built without zlib, which --compress needs");
}

bool wants_field(const ReadOptions& options, const std::string& name) {
    const std::vector<std::string>& wanted = options.field_names;
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

void require_fields(const Source& source, const ReadOptions& options,
                    const std::vector<std::string>& names) {
    for (const std::string& wanted : options.field_names) {
        if (std::find(names.begin(), names.end(), wanted) != names.end()) continue;
        const std::size_t shown = std::min<std::size_t>(names.size(), 10);
        std::string known;
        for (std::size_t i = 0; i < shown; ++i) known += (i > 0 ? ", " : "") + quote(names[i]);
        if (names.empty()) source.fail(fmt::format("no field {}; it has none", quote(wanted)));
        source.fail(fmt::format("no field {}; it has {}{}", quote(wanted), known,
                                shown < names.size() ? ", ..." : ""));
    }
}

std::string without_extension(const std::string& path, const Format& format) {
    const std::string e = extension(path);
    for (const char* known : format.extensions) {
        if (e == known) return path.substr(0, path.size() - e.size());
    }
    return path;
}

}  // namespace mgdt::cli
