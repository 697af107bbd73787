// SPDX-License-Identifier: MIT
#include "domain/mesh_assembly.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/predicates.hpp"
#include "solid/sorted_corners.hpp"

namespace mgdt {
namespace {

class Assembly {
  public:
    Assembly(const DomainParts& parts, Team& team, Allocator& allocator, SolidMesh& out)
        : parts_(parts), out_(out), team_(team), allocator_(allocator), number_(allocator) {}

    void run(bool rounds) {
        write_tetrahedra();
        write_faces();
        write_edges();
        write_steiner_points();
        write_unused();
        out_.is_rounded = rounds || !write_points(false);
        if (out_.is_rounded && !write_points(true))
            fail(MGDT_ERR_RESOLUTION,
                 "the mesh has tetrahedra that double precision cannot represent");
    }

  private:
    // The index of a vertex of the mesh among the points that are returned.
    std::uint32_t index(std::uint32_t v) const {
        const std::size_t distinct = parts_.complex.point_of_number.size();
        if (v < distinct) return parts_.complex.point_of_number[v];
        return static_cast<std::uint32_t>(parts_.input.point_count() + (v - distinct));
    }

    const double* given(std::uint32_t point) const {
        return parts_.input.points.begin() + 3 * std::size_t{point};
    }

    void write_tetrahedra() {
        const auto& tetrahedra = parts_.mesh.tetrahedra;
        Buffer<SortedCorners<4>> records(allocator_);
        for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
            if (tetrahedra[t].is_dead() || parts_.regions.of_tetrahedron[t] == Regions::outside)
                continue;
            SortedCorners<4> record = {{}, t, false};
            for (int i = 0; i < 4; ++i) record.v[i] = index(tetrahedra[t].v[i]);
            record.sort();
            records.push_back(record);
        }
        sort_by_corners(team_, allocator_, records);
        number_.resize(tetrahedra.size(), no_index);
        for (std::uint32_t i = 0; i < records.size(); ++i) number_[records[i].from] = i;
        // Regions are numbered in the order of their first tetrahedra.
        Buffer<std::uint32_t> region(allocator_);
        region.resize(parts_.regions.markers.size(), no_index);
        for (SortedCorners<4>& record : records) {
            if (record.is_odd) std::swap(record.v[2], record.v[3]);
            const ConstrainedMesh::Tetrahedron& t = tetrahedra[record.from];
            for (const std::uint32_t v : record.v) {
                out_.tetrahedra.push_back(v);
                unsigned k = 0;
                while (index(t.v[k]) != v) ++k;
                const std::uint32_t next = t.n[k];
                out_.neighbors.push_back(next == no_index ? no_index : number_[next / 4]);
            }
            const std::uint32_t from = parts_.regions.of_tetrahedron[record.from];
            if (region[from] == no_index) {
                region[from] = static_cast<std::uint32_t>(out_.region_markers.size());
                out_.region_markers.push_back(parts_.regions.markers[from]);
            }
            out_.regions.push_back(region[from]);
        }
    }

    void write_faces() {
        const auto& tetrahedra = parts_.mesh.tetrahedra;
        Buffer<SortedCorners<3>> records(allocator_);
        for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
            for (unsigned i = 0; i < 4 && !tetrahedra[t].is_dead(); ++i) {
                const std::uint32_t code = 4 * t + i, other = tetrahedra[t].n[i];
                if (tetrahedra[t].facets[i] == no_index || (other != no_index && other < code))
                    continue;
                SortedCorners<3> record = {{}, code, false};
                for (int k = 0; k < 3; ++k) record.v[k] = index(tetrahedra[t].v[outer_face[i][k]]);
                record.sort();
                records.push_back(record);
            }
        sort_by_corners(team_, allocator_, records);
        for (const SortedCorners<3>& record : records) write_face(record);
    }

    void write_face(const SortedCorners<3>& record) {
        const std::uint32_t code = record.from;
        const ConstrainedMesh::Tetrahedron& t = parts_.mesh.of(code);
        const PlanarFacets::Facet& facet = parts_.facets.facets[t.facets[code % 4]];
        const std::uint32_t* const corner =
            parts_.complex.boundary.triangles.begin() + 3 * std::size_t{facet.triangle};
        const int side =
            orientation(parts_.mesh.point(corner[0]), parts_.mesh.point(corner[1]),
                        parts_.mesh.point(corner[2]), parts_.mesh.point(parts_.mesh.apex(code)));
        // (q, a, b, c) is positive for q beyond the face, so (a, b, c, apex) is positive, as it is
        // for a facet whose normal points to the apex. An odd order reverses that.
        const bool turns = record.is_odd == (side > 0);
        out_.faces.push_back(record.v[0]);
        out_.faces.push_back(record.v[turns ? 2 : 1]);
        out_.faces.push_back(record.v[turns ? 1 : 2]);
        const std::uint32_t behind = t.n[code % 4];
        const std::uint32_t here = number_[code / 4],
                            there = behind == no_index ? no_index : number_[behind / 4];
        out_.face_tetrahedra.push_back(side > 0 ? here : there);
        out_.face_tetrahedra.push_back(side > 0 ? there : here);
        out_.face_facets.push_back(parts_.complex.facet_of_triangle[facet.triangle]);
        out_.face_markers.push_back(parts_.complex.markers[facet.triangle]);
    }

    void write_unused() {
        out_.unused_regions.copy(parts_.regions.unused_regions);
        out_.unused_holes.copy(parts_.regions.unused_holes);
        Buffer<std::uint8_t> is_used(allocator_);
        is_used.resize(parts_.input.point_count(), 0);
        for (const std::uint32_t v : out_.tetrahedra)
            if (v < is_used.size()) is_used[v] = 1;
        const Complex& complex = parts_.complex;
        for (std::uint32_t i = 0; i < is_used.size(); ++i)
            if (is_used[complex.point_of_number[complex.number_of_point[i]]] == 0)
                out_.unused_points.push_back(i);
        for (std::uint32_t f = 0; f < out_.face_facets.size(); ++f)
            if (out_.face_tetrahedra[2 * f] == no_index &&
                out_.face_tetrahedra[2 * f + 1] == no_index)
                out_.unused_faces.push_back(f);
    }

    void write_edges() {
        // The caller's segments, sorted by their ends, in which the segments of the boundary are
        // looked up.
        struct Source {
            std::uint32_t a, b, source;
            bool operator<(const Source& s) const {
                return a != s.a ? a < s.a : b != s.b ? b < s.b : source < s.source;
            }
        };
        Buffer<Source> sources(allocator_);
        const Buffer<std::uint32_t>& given = parts_.complex.boundary.segments;
        for (std::uint32_t i = 0; i < given.size() / 2; ++i) {
            const std::uint32_t a = given[2 * std::size_t{i}], b = given[2 * std::size_t{i} + 1];
            sources.push_back({std::min(a, b), std::max(a, b), i});
        }
        std::sort(sources.begin(), sources.end());
        for (const Subsegment& s : parts_.subsegments) {
            const std::uint32_t* const ends =
                parts_.facets.segments.begin() + 2 * std::size_t{s.segment};
            const Source* const found =
                std::lower_bound(sources.begin(), sources.end(), Source{ends[0], ends[1], 0});
            const bool is_given =
                found != sources.end() && found->a == ends[0] && found->b == ends[1];
            out_.edges.push_back(index(s.ends[0]));
            out_.edges.push_back(index(s.ends[1]));
            out_.edge_segments.push_back(is_given ? parts_.input.segment_origin(found->source)
                                                  : no_index);
            out_.edge_markers.push_back(is_given ? parts_.input.segment_markers[found->source] : 0);
        }
    }

    void write_steiner_points() {
        for (const SteinerPoint& s : parts_.steiner) {
            if (s.segment == no_index) {
                for (int k = 0; k < 2; ++k) out_.steiner_edges.push_back(no_index);
                out_.steiner_parameters.push_back(0);
                continue;
            }
            const std::uint32_t* const ends =
                parts_.facets.segments.begin() + 2 * std::size_t{s.segment};
            for (int k = 0; k < 2; ++k) out_.steiner_edges.push_back(index(ends[k]));
            const DividedSegment divided(parts_.mesh.point(ends[0]), parts_.mesh.point(ends[1]));
            out_.steiner_parameters.push_back(double(s.k) / divided.parts());
        }
    }

    // Writes the coordinates of the points. Returns whether all tetrahedra are positive with them.
    bool write_points(bool rounded) {
        const std::size_t distinct = parts_.complex.point_of_number.size();
        out_.points.clear();
        out_.exact_points.clear();
        out_.point_origins.clear();
        for (std::size_t i = 0; i < parts_.input.points.size(); ++i) {
            const std::size_t v = parts_.complex.number_of_point[i / 3];
            const double x = parts_.mesh.points[3 * v + i % 3];
            out_.exact_points.push_back(x);
            out_.points.push_back(rounded ? parts_.grid.unround(x) : parts_.input.points[i]);
        }
        for (const std::uint32_t v : parts_.complex.number_of_point)
            out_.point_origins.push_back(parts_.complex.point_of_number[v]);
        out_.point_origins.resize(out_.points.size() / 3 + parts_.steiner.size(), no_index);
        for (std::size_t i = 0; i < parts_.steiner.size(); ++i) {
            const double* const exact = parts_.mesh.points.begin() + 3 * (distinct + i);
            double x[3];
            if (rounded || parts_.steiner[i].segment == no_index)
                for (int k = 0; k < 3; ++k) x[k] = parts_.grid.unround(exact[k]);
            else
                SolidMesh::place_on_segment(given(out_.steiner_edges[2 * i]),
                                            given(out_.steiner_edges[2 * i + 1]),
                                            out_.steiner_parameters[i], exact, parts_.grid, x);
            for (int k = 0; k < 3; ++k) {
                out_.exact_points.push_back(exact[k]);
                out_.points.push_back(x[k]);
            }
        }
        for (std::size_t t = 0; t < out_.tetrahedra.size(); t += 4) {
            const auto point = [&](std::size_t k) {
                return out_.points.begin() + 3 * std::size_t{out_.tetrahedra[t + k]};
            };
            if (orientation(point(0), point(1), point(2), point(3)) <= 0) return false;
        }
        return true;
    }

    const DomainParts& parts_;
    SolidMesh& out_;
    Team& team_;
    Allocator& allocator_;
    Buffer<std::uint32_t> number_;  // of each tetrahedron in the result, or `no_index`
};

}  // namespace

void assemble(const DomainParts& parts, bool rounds, Team& team, Allocator& allocator,
              SolidMesh& out) {
    out.grid = parts.grid;
    Assembly(parts, team, allocator, out).run(rounds);
}

}  // namespace mgdt
