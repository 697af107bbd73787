// SPDX-License-Identifier: MIT
#include "solid/linked_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solid/corner_exponent.hpp"
#include "solid/sorted_corners.hpp"

namespace mgdt {
namespace {

constexpr std::size_t tetrahedra_per_thread = 4096;

}  // namespace

LinkedMesh::LinkedMesh(const SolidMesh& from, Team& team, Allocator& allocator)
    : LinkedTetrahedra(allocator),
      regions(allocator),
      x(allocator),
      is_lost(allocator),
      edges(allocator),
      labels(allocator),
      team_(team),
      allocator_(allocator) {
    // What the others become does not matter.
    scale_ = corner_exponent(from);
    x.resize(from.points.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::ldexp(from.points[i], -scale_);
    is_lost.resize(x.size() / 3, 0);
    const auto count = static_cast<std::uint32_t>(from.tetrahedron_count());
    tetrahedra.resize(count);
    hints.resize(x.size() / 3, no_tetrahedron);
    regions.resize(count);
    team_.split(count, tetrahedra_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t t = begin; t < end; ++t) read_tetrahedron(from, t);
    });
    for (std::uint32_t t = 0; t < count; ++t)
        for (const std::uint32_t v : tetrahedra[t].v) hints[v] = t;
    read_faces(from);
    for (std::size_t e = 0; e < from.edge_segments.size(); ++e)
        edges.add(from.edges[2 * e], from.edges[2 * e + 1],
                  {from.edge_segments[e], from.edge_markers[e]});
}

void LinkedMesh::read_tetrahedron(const SolidMesh& from, std::size_t t) noexcept {
    Tetrahedron& to = tetrahedra[t];
    for (unsigned i = 0; i < 4; ++i) {
        to.v[i] = from.tetrahedra[4 * t + i];
        to.facets[i] = no_index;
        const std::uint32_t next = from.neighbors[4 * t + i];
        to.n[i] = no_index;
        if (next == no_index) continue;
        const std::uint32_t* const back = from.neighbors.begin() + 4 * std::size_t{next};
        to.n[i] = 4 * next + static_cast<std::uint32_t>(std::find(back, back + 4, t) - back);
    }
    regions[t] = from.regions[t];
}

void LinkedMesh::read_faces(const SolidMesh& from) {
    // Facets get labels in the order of their numbers.
    for (std::size_t f = 0; f < from.face_facets.size(); ++f)
        labels.push_back({from.face_facets[f], from.face_markers[f]});
    const auto is_before = [](const Label& a, const Label& b) { return a.facet < b.facet; };
    std::sort(labels.begin(), labels.end(), is_before);
    Label* const end =
        std::unique(labels.begin(), labels.end(),
                    [](const Label& a, const Label& b) { return a.facet == b.facet; });
    labels.resize(static_cast<std::size_t>(end - labels.begin()));
    for (std::size_t f = 0; f < from.face_facets.size(); ++f) {
        const Label* const label = std::lower_bound(labels.begin(), labels.end(),
                                                    Label{from.face_facets[f], 0}, is_before);
        const auto number = static_cast<std::uint32_t>(label - labels.begin());
        const std::uint32_t* const corner = from.faces.begin() + 3 * f;
        for (std::uint32_t side = 0; side < 2; ++side) {
            const std::uint32_t t = from.face_tetrahedra[2 * f + side];
            if (t == no_index) continue;
            unsigned i = 0;
            while (std::find(corner, corner + 3, tetrahedra[t].v[i]) != corner + 3) ++i;
            tetrahedra[t].facets[i] = 2 * number + side;
        }
    }
}

void LinkedMesh::write(SolidMesh& to) const {
    SolidMesh made(to.points.allocator());
    Buffer<std::uint32_t> number(allocator_);
    write(to, made, number);
    // If memory runs out before this, the mesh stays as it was.
    to = std::move(made);
}

void LinkedMesh::write(const SolidMesh& from, SolidMesh& made,
                       Buffer<std::uint32_t>& number) const {
    write_tetrahedra(number, made);
    write_faces(number, from, made);
    write_edges(made);
    write_points(from, made);
    made.region_markers.copy(from.region_markers);
    made.unused_regions.copy(from.unused_regions);
    made.unused_holes.copy(from.unused_holes);
    made.is_rounded = from.is_rounded;
    made.grid = from.grid;
    made.is_of_domain = false;
    made.is_delaunay = false;
    made.planar_facets = from.planar_facets;
    made.missing_facets = from.missing_facets;
    made.cavities = from.cavities;
    made.largest_cavity = from.largest_cavity;
}

// Writes the tetrahedra, sorted, and their numbers.
void LinkedMesh::write_tetrahedra(Buffer<std::uint32_t>& number, SolidMesh& made) const {
    Buffer<SortedCorners<4>> records(allocator_);
    for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
        if (tetrahedra[t].is_dead()) continue;
        const std::uint32_t(&v)[4] = tetrahedra[t].v;
        SortedCorners<4> record = {{v[0], v[1], v[2], v[3]}, t, false};
        record.sort();
        records.push_back(record);
    }
    sort_by_corners(team_, allocator_, records);
    number.resize(tetrahedra.size(), no_index);
    for (std::uint32_t i = 0; i < records.size(); ++i) number[records[i].from] = i;
    const auto number_behind = [&](std::uint32_t code) {
        return code == no_index ? no_index : number[code / 4];
    };
    made.tetrahedra.resize(4 * records.size());
    made.neighbors.resize(4 * records.size());
    made.regions.resize(records.size());
    team_.split(records.size(), tetrahedra_per_thread,
                [&](std::size_t begin, std::size_t end, unsigned) {
                    for (std::size_t i = begin; i < end; ++i) {
                        SortedCorners<4> record = records[i];
                        if (record.is_odd) std::swap(record.v[2], record.v[3]);
                        const Tetrahedron& t = tetrahedra[record.from];
                        for (std::size_t k = 0; k < 4; ++k) {
                            made.tetrahedra[4 * i + k] = record.v[k];
                            made.neighbors[4 * i + k] = number_behind(t.n[t.position(record.v[k])]);
                        }
                        made.regions[i] = regions[record.from];
                    }
                });
}

// Writes the faces at tetrahedra, and those of the mesh before that are at none.
void LinkedMesh::write_faces(const Buffer<std::uint32_t>& number, const SolidMesh& before,
                             SolidMesh& made) const {
    struct Source {
        Label label;
        std::uint32_t ends[2];
        bool turns;  // whether the direction of the corners is the reverse of the sorted one
    };
    Buffer<SortedCorners<3>> records(allocator_);
    Buffer<Source> sources(allocator_);
    const auto add = [&](SortedCorners<3> record, const Source& source) {
        record.from = static_cast<std::uint32_t>(sources.size());
        records.push_back(record);
        sources.push_back(source);
    };
    for (std::size_t f = 0; f < before.face_facets.size(); ++f) {
        if (before.face_tetrahedra[2 * f] != no_index ||
            before.face_tetrahedra[2 * f + 1] != no_index)
            continue;
        SortedCorners<3> record = {
            {before.faces[3 * f], before.faces[3 * f + 1], before.faces[3 * f + 2]}, 0, false};
        record.sort();
        add(record,
            {{before.face_facets[f], before.face_markers[f]}, {no_index, no_index}, record.is_odd});
    }
    for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
        for (unsigned i = 0; i < 4 && !tetrahedra[t].is_dead(); ++i) {
            const Side side = tetrahedra[t].facets[i];
            const std::uint32_t behind = tetrahedra[t].n[i];
            if (side == no_index || (behind != no_index && behind < 4 * t + i)) continue;
            const std::uint32_t(&v)[4] = tetrahedra[t].v;
            const unsigned char* const f = outer_face[i];
            SortedCorners<3> record = {{v[f[0]], v[f[1]], v[f[2]]}, no_index, false};
            record.sort();
            Source source = {
                labels[label_of(side)], {no_index, no_index}, record.is_odd == (side % 2 == 0)};
            source.ends[side % 2] = number[t];
            if (behind != no_index) source.ends[1 - side % 2] = number[behind / 4];
            add(record, source);
        }
    sort_by_corners(team_, allocator_, records);
    for (const SortedCorners<3>& record : records) {
        const Source& source = sources[record.from];
        if (source.ends[0] == no_index && source.ends[1] == no_index)
            made.unused_faces.push_back(static_cast<std::uint32_t>(made.face_facets.size()));
        made.faces.push_back(record.v[0]);
        made.faces.push_back(record.v[source.turns ? 2 : 1]);
        made.faces.push_back(record.v[source.turns ? 1 : 2]);
        for (const std::uint32_t t : source.ends) made.face_tetrahedra.push_back(t);
        made.face_facets.push_back(source.label.facet);
        made.face_markers.push_back(source.label.marker);
    }
}

// Writes the points and gives vertices their numbers: the caller's keep theirs, and of the others
// those that have left the mesh leave no gaps. A Steiner point stays on its edge if neither it nor
// an end of the edge has moved.
void LinkedMesh::write_points(const SolidMesh& before, SolidMesh& made) const {
    const std::size_t given = before.points.size() / 3 - before.steiner_parameters.size();
    Buffer<std::uint32_t> number(allocator_);
    Buffer<std::uint8_t> has_moved(allocator_);
    number.resize(hints.size(), no_index);
    has_moved.resize(hints.size(), 0);
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < hints.size(); ++v) {
        if (v >= given && is_lost[v] != 0) continue;
        number[v] = count++;
        // Points that have not moved keep their coordinates to the last bit, and so do those of no
        // tetrahedron. Tetrahedra have the first of several equal points as a corner; the others
        // get its coordinates.
        const bool is_old = 3 * std::size_t{v} < before.points.size();
        const std::uint32_t corner = v < given ? before.point_origins[v] : v;
        const bool is_used = hints[corner] != no_tetrahedron || is_lost[corner] != 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double now = x[3 * std::size_t{corner} + k],
                         was = is_old ? before.points[3 * std::size_t{v} + k] : 0;
            const bool moves = !is_old || (is_used && now != std::ldexp(was, -scale_));
            made.points.push_back(moves ? std::ldexp(now, scale_) : was);
            if (moves) has_moved[v] = 1;
        }
        made.point_origins.push_back(v < given ? before.point_origins[v] : no_index);
        if (v < given) continue;
        const std::uint32_t* const ends =
            is_old ? before.steiner_edges.begin() + 2 * (v - given) : nullptr;
        const bool is_on_edge = is_old && has_moved[v] == 0 && ends[0] != no_index &&
                                has_moved[ends[0]] == 0 && has_moved[ends[1]] == 0;
        for (int k = 0; k < 2; ++k) made.steiner_edges.push_back(is_on_edge ? ends[k] : no_index);
        made.steiner_parameters.push_back(is_on_edge ? before.steiner_parameters[v - given] : 0);
    }
    for (Buffer<std::uint32_t>* const list : {&made.tetrahedra, &made.faces, &made.edges})
        for (std::uint32_t& v : *list) v = number[v];
    for (std::uint32_t v = 0; v < given; ++v)
        if (hints[made.point_origins[v]] == no_tetrahedron) made.unused_points.push_back(v);
    made.exact_points.copy(made.points);
}

// Writes the edges: those that were read come first. Vertices have their numbers in this mesh.
void LinkedMesh::write_edges(SolidMesh& made) const {
    edges.for_each([&](std::uint32_t a, std::uint32_t b, const KeptEdges::Origin& origin) {
        made.edges.push_back(a);
        made.edges.push_back(b);
        made.edge_segments.push_back(origin.segment);
        made.edge_markers.push_back(origin.marker);
    });
}

}  // namespace mgdt
