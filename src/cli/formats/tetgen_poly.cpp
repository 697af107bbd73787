// SPDX-License-Identifier: MIT
// TetGen's boundaries: NAME.poly, whose facets are made of several polygons and holes, and
// NAME.smesh, whose facets are polygons. Points are in the file or in NAME.node.
#include <fmt/core.h>

#include <cmath>

#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/planar_region.hpp"
#include "cli/formats/tetgen_nodes.hpp"
#include "cli/formats/words.hpp"
#include "cli/letter_case.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {
namespace {

constexpr std::int64_t most_marker = std::numeric_limits<std::int32_t>::max();

class PolyReader {
  public:
    PolyReader(const Source& source, Mesh& mesh)
        : lines_(source), mesh_(mesh), is_poly_(!has_ending(source.path, ".smesh")) {}

    void run() {
        read_points();
        const Counted head = counts("the number of facets");
        mesh_.other_cells = static_cast<std::size_t>(head.count);
        for (std::int64_t i = 0; i < head.count; ++i) {
            if (is_poly_)
                read_facet(head.flag != 0);
            else
                read_polygon_facet(head.flag != 0);
        }
        // Holes and regions may be left out.
        if (!lines_.next_with_text()) return;
        read_places(mesh_.facets.holes, "the number of holes", false);
        if (!lines_.next_with_text()) return;
        read_places(mesh_.facets.regions, "the number of regions", true);
    }

  private:
    struct Counted {
        std::int64_t count, flag;
    };
    // Goes to the next line with text.
    Fields next_line() {
        if (!lines_.next_with_text()) lines_.fail("the file is cut short");
        return Fields(lines_);
    }
    Counted counts(const char* what) {
        Fields fields = next_line();
        const std::int64_t count = fields.integer(what, 0, most_marker);
        // Each item takes at least a digit and the end of a line.
        if (static_cast<std::uint64_t>(count) > (lines_.bytes_left() + 1) / 2)
            lines_.fail(fmt::format("announces {} items, but only {} bytes follow", count,
                                    lines_.bytes_left()));
        return {count, optional(fields, 0, what)};
    }
    std::int64_t optional(Fields& fields, std::int64_t otherwise, const char* what) {
        std::string_view word;
        return Fields(fields).next(word) ? fields.integer(what) : otherwise;
    }

    void read_points() {
        if (!lines_.next_with_text()) lines_.source().fail_at_line(1, "the file is empty");
        if (Fields(lines_).integer("the number of points", 0, most_marker) > 0) {
            base_ = read_node_rows(lines_, mesh_.points);
        } else {
            const InputFile nodes(beside_node_file(lines_.source()));
            if (nodes.identity()) mesh_.inputs.push_back(*nodes.identity());
            base_ = read_nodes(nodes.source(), mesh_.points);
        }
        mesh_.first_number = static_cast<int>(base_);
        mesh_.detail = fmt::format("numbered from {}", base_);
    }

    std::int64_t corner(Fields& fields) {
        const auto last = static_cast<std::int64_t>(mesh_.point_count()) + base_ - 1;
        return fields.integer("corner", base_, last) - base_;
    }
    // The corners of a polygon, which may go on in further lines.
    std::vector<std::int64_t> polygon(Fields& fields) {
        const std::int64_t n = fields.integer("the number of corners", 1, most_marker);
        std::vector<std::int64_t> corners;
        for (std::int64_t k = 0; k < n; ++k) {
            std::string_view word;
            if (!Fields(fields).next(word)) fields = next_line();
            corners.push_back(corner(fields));
        }
        return corners;
    }
    static std::int32_t marker(Fields& fields) {
        return static_cast<std::int32_t>(
            fields.integer("the marker of the facet", -most_marker, most_marker));
    }

    void read_facet(bool has_marker) {
        Fields fields = next_line();
        const std::int64_t n = fields.integer("the number of polygons", 1, most_marker),
                           n_holes = optional(fields, 0, "the number of holes");
        const std::int32_t of = has_marker ? marker(fields) : 0;
        std::vector<std::vector<std::int64_t>> polygons;
        for (std::int64_t i = 0; i < n; ++i) {
            Fields line = next_line();
            polygons.push_back(polygon(line));
        }
        std::vector<std::array<double, 3>> holes;
        for (std::int64_t i = 0; i < n_holes; ++i) {
            Fields line = next_line();
            line.integer("the number of the hole");
            std::array<double, 3> x;
            for (double& c : x) c = line.number("coordinate");
            holes.push_back(x);
        }
        if (!add_planar_region(mesh_.points, std::move(polygons), holes, of, mesh_.facets))
            lines_.fail("the polygons of the facet cross");
    }

    void read_polygon_facet(bool has_marker) {
        Fields fields = next_line();
        std::vector<std::vector<std::int64_t>> polygons = {polygon(fields)};
        const std::int32_t of = has_marker ? marker(fields) : 0;
        // One polygon crosses no other one.
        add_planar_region(mesh_.points, std::move(polygons), {}, of, mesh_.facets);
    }

    // The current line has the count.
    void read_places(std::vector<FileFacets::Place>& places, const char* what, bool has_markers) {
        const std::int64_t n = Fields(lines_).integer(what, 0, most_marker);
        for (std::int64_t i = 0; i < n; ++i) {
            Fields line = next_line();
            line.integer("the number of the place");
            FileFacets::Place place = {};
            for (double& c : place.x) c = line.number("coordinate");
            // Numbers of regions may be written as 10.0.
            std::string_view word;
            if (has_markers && Fields(line).next(word)) {
                const double value = line.number("the marker of the region");
                if (!(std::abs(value) <= static_cast<double>(most_marker)) ||
                    value != std::floor(value))
                    lines_.fail(
                        fmt::format("the marker {} of a region is no 32-bit integer", value));
                place.marker = static_cast<std::int32_t>(value);
            }
            places.push_back(place);
        }
    }

    LineReader lines_;
    Mesh& mesh_;
    const bool is_poly_;
    std::int64_t base_ = 0;
};

Mesh read_poly(const Source& source, const ReadOptions&) {
    Mesh mesh;
    PolyReader(source, mesh).run();
    return mesh;
}

}  // namespace

const Format& poly_format() {
    static const Format format = [] {
        Format f = {"poly",
                    {".poly", ".smesh"},
                    "TetGen's facets, holes and regions, text",
                    false,
                    nullptr,
                    read_poly,
                    nullptr,
                    nullptr};
        f.has_facets = true;
        return f;
    }();
    return format;
}

}  // namespace mgdt::cli
