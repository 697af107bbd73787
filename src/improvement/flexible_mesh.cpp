// SPDX-License-Identifier: MIT
#include "improvement/flexible_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "improvement/quality.hpp"
#include "platform/error.hpp"

namespace mgdt {

FlexibleMesh::FlexibleMesh(const SolidMesh& from, Allocator& allocator)
    : LinkedTetrahedra(allocator),
      regions(allocator),
      qualities(allocator),
      x(allocator),
      edges(allocator),
      labels(allocator),
      allocator_(allocator),
      faces_(allocator),
      links_(allocator),
      slots_(allocator),
      leaves_(allocator) {
    double largest = 0;
    for (const double c : from.points) largest = std::max(largest, std::fabs(c));
    if (largest > 0) std::frexp(largest, &scale_);
    x.resize(from.points.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::ldexp(from.points[i], -scale_);
    const auto count = static_cast<std::uint32_t>(from.tetrahedron_count());
    tetrahedra.resize(count);
    hints.resize(x.size() / 3, no_tetrahedron);
    regions.resize(count);
    qualities.resize(count);
    for (std::uint32_t t = 0; t < count; ++t) {
        Tetrahedron& to = tetrahedra[t];
        for (unsigned i = 0; i < 4; ++i) {
            to.v[i] = from.tetrahedra[4 * std::size_t{t} + i];
            to.facets[i] = no_index;
            hints[to.v[i]] = t;
            const std::uint32_t next = from.neighbors[4 * std::size_t{t} + i];
            to.n[i] = no_index;
            if (next == no_index) continue;
            const std::uint32_t* const back = from.neighbors.begin() + 4 * std::size_t{next};
            to.n[i] = 4 * next + static_cast<std::uint32_t>(std::find(back, back + 4, t) - back);
        }
        regions[t] = from.regions[t];
        qualities[t] = quality(to.v);
    }
    read_faces(from);
    for (std::size_t i = 0; i < from.edges.size(); i += 2)
        edges.add(from.edges[i], from.edges[i + 1]);
}

void FlexibleMesh::read_faces(const SolidMesh& from) {
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

double FlexibleMesh::quality_of(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                std::uint32_t d) const noexcept {
    return mgdt::quality_of(point(a), point(b), point(c), point(d));
}

FlexibleMesh::Face FlexibleMesh::make_face(const std::uint32_t (&v)[4],
                                           unsigned position) noexcept {
    const unsigned char* const f = outer_face[position];
    Face face = {{{v[f[0]], v[f[1]], v[f[2]]}, no_index, false}, false, no_index};
    face.corners.sort();
    return face;
}

// Collects the outer faces of the tetrahedra that leave and all faces of those that come, sorted.
void FlexibleMesh::collect_faces(const Change& change) {
    faces_.clear();
    inner_sides_ = 0;
    leaves_.grow(tetrahedra.size());
    leaves_.resize(tetrahedra.size(), 0);
    for (const std::uint32_t t : change.removed) leaves_[t] = 1;
    for (const std::uint32_t t : change.removed)
        for (unsigned i = 0; i < 4; ++i) {
            const std::uint32_t behind = tetrahedra[t].n[i];
            if (behind != no_index && leaves_[behind / 4] != 0) {
                if (tetrahedra[t].facets[i] != no_index) ++inner_sides_;
                continue;
            }
            Face face = make_face(tetrahedra[t].v, i);
            face.corners.from = behind;
            face.side = tetrahedra[t].facets[i];
            faces_.push_back(face);
        }
    for (const std::uint32_t t : change.removed) leaves_[t] = 0;
    for (std::uint32_t k = 0; k < change.added.size(); ++k)
        for (unsigned i = 0; i < 4; ++i) {
            Face face = make_face(change.added[k].v, i);
            face.corners.from = 4 * k + i;
            face.is_new = true;
            faces_.push_back(face);
        }
    std::sort(faces_.begin(), faces_.end());
}

// Finds the links of the new tetrahedra. Returns false if some faces do not fit.
bool FlexibleMesh::pair_faces(const Change& change) {
    collect_faces(change);
    links_.clear();
    links_.resize(4 * change.added.size(), {no_index, false, no_index});
    std::size_t come = 0, leave = inner_sides_ / 2;  // faces of facets
    for (std::size_t i = 0; i < faces_.size();) {
        std::size_t end = i + 1;
        while (end < faces_.size() && faces_[end].corners.has_same_corners(faces_[i].corners))
            ++end;
        const Face &one = faces_[i], &other = faces_[end - 1];
        const std::size_t size = end - i;
        i = end;
        // The facet of the face, if the change says that it becomes a part of one.
        const auto side_of = [&](const Face& face) -> Side {
            for (const Change::Face& f : change.faces) {
                SortedCorners<3> corners = {{f.v[0], f.v[1], f.v[2]}, 0, false};
                corners.sort();
                if (corners.has_same_corners(face.corners))
                    return 2 * f.label + (corners.is_odd == face.corners.is_odd ? 0u : 1u);
            }
            return no_index;
        };
        if (size == 1 && one.is_new) {
            // A new face where the mesh ends.
            const Side side = side_of(one);
            if (side == no_index) return false;
            links_[one.corners.from] = {no_index, false, side};
            ++come;
        } else if (size == 1) {
            // A face where the mesh has ended, in whose place others are declared.
            if (one.corners.from != no_index || one.side == no_index) return false;
            ++leave;
        } else if (size == 2 && one.is_new && other.is_new) {
            if (one.corners.is_odd == other.corners.is_odd) return false;
            const Side side = side_of(one);
            if (side != no_index) ++come;
            links_[one.corners.from] = {other.corners.from, true, side};
            links_[other.corners.from] = {one.corners.from, true,
                                          side == no_index ? no_index : side ^ 1};
        } else if (size == 2 && one.is_new != other.is_new) {
            const Face &inner = one.is_new ? one : other, &outer = one.is_new ? other : one;
            if (inner.corners.is_odd != outer.corners.is_odd) return false;
            links_[inner.corners.from] = {outer.corners.from, false, outer.side};
        } else {
            return false;
        }
    }
    return come == change.faces.size() && leave == come + change.lost_faces;
}

bool FlexibleMesh::apply(const Change& change) {
    if (!pair_faces(change)) return false;
    slots_.clear();
    for (std::size_t k = 0; k < change.added.size(); ++k) {
        if (k < change.removed.size()) {
            slots_.push_back(change.removed[k]);
        } else if (!free_slots.empty()) {
            slots_.push_back(free_slots.back());
            free_slots.pop_back();
        } else {
            const auto t = static_cast<std::uint32_t>(tetrahedra.size());
            if (t >= max_tetrahedra) fail(MGDT_ERR_TOO_LARGE, "there are too many tetrahedra");
            tetrahedra.push_back({});
            regions.push_back(0);
            qualities.push_back(0);
            slots_.push_back(t);
        }
    }
    for (std::size_t k = change.added.size(); k < change.removed.size(); ++k)
        remove(change.removed[k]);
    // Faces of the mesh that end it and leave have no link to be written.
    for (std::uint32_t k = 0; k < slots_.size(); ++k) {
        Tetrahedron& t = tetrahedra[slots_[k]];
        for (unsigned i = 0; i < 4; ++i) {
            const Link& link = links_[4 * std::size_t{k} + i];
            t.v[i] = change.added[k].v[i];
            t.facets[i] = link.side;
            t.n[i] = link.is_new ? 4 * slots_[link.code / 4] + link.code % 4 : link.code;
            if (!link.is_new && link.code != no_index)
                of(link.code).n[link.code % 4] = 4 * slots_[k] + i;
            hints[t.v[i]] = slots_[k];
        }
        regions[slots_[k]] = change.added[k].region;
        qualities[slots_[k]] = change.added[k].quality;
    }
    return true;
}

void FlexibleMesh::write(SolidMesh& to) const {
    Buffer<SortedCorners<4>> records(allocator_);
    for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
        if (tetrahedra[t].is_dead()) continue;
        const std::uint32_t(&v)[4] = tetrahedra[t].v;
        SortedCorners<4> record = {{v[0], v[1], v[2], v[3]}, t, false};
        record.sort();
        records.push_back(record);
    }
    std::sort(records.begin(), records.end());
    Buffer<std::uint32_t> number(allocator_);
    number.resize(tetrahedra.size(), no_index);
    for (std::uint32_t i = 0; i < records.size(); ++i) number[records[i].from] = i;
    const auto number_behind = [&](std::uint32_t code) {
        return code == no_index ? no_index : number[code / 4];
    };
    to.tetrahedra.clear();
    to.neighbors.clear();
    to.regions.clear();
    for (SortedCorners<4>& record : records) {
        if (record.is_odd) std::swap(record.v[2], record.v[3]);
        const Tetrahedron& t = tetrahedra[record.from];
        for (const std::uint32_t v : record.v) {
            to.tetrahedra.push_back(v);
            to.neighbors.push_back(number_behind(t.n[t.position(v)]));
        }
        to.regions.push_back(regions[record.from]);
    }
    write_faces(number, to);
    // Points that have not moved keep their coordinates to the last bit.
    for (std::size_t i = 0; i < x.size(); ++i)
        if (x[i] != std::ldexp(to.points[i], -scale_)) to.points[i] = std::ldexp(x[i], scale_);
    to.exact_points.copy(to.points);
    to.is_delaunay = false;
}

// Writes the faces at tetrahedra. Those at none stay.
void FlexibleMesh::write_faces(const Buffer<std::uint32_t>& number, SolidMesh& to) const {
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
    for (std::size_t f = 0; f < to.face_facets.size(); ++f) {
        if (to.face_tetrahedra[2 * f] != no_index || to.face_tetrahedra[2 * f + 1] != no_index)
            continue;
        SortedCorners<3> record = {
            {to.faces[3 * f], to.faces[3 * f + 1], to.faces[3 * f + 2]}, 0, false};
        record.sort();
        add(record, {{to.face_facets[f], to.face_markers[f]}, {no_index, no_index}, record.is_odd});
    }
    for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
        for (unsigned i = 0; i < 4 && !tetrahedra[t].is_dead(); ++i) {
            const Side side = tetrahedra[t].facets[i];
            const std::uint32_t behind = tetrahedra[t].n[i];
            if (side == no_index || (behind != no_index && behind < 4 * t + i)) continue;
            const Face face = make_face(tetrahedra[t].v, i);
            Source source = {labels[label_of(side)],
                             {no_index, no_index},
                             face.corners.is_odd == (side % 2 == 0)};
            source.ends[side % 2] = number[t];
            if (behind != no_index) source.ends[1 - side % 2] = number[behind / 4];
            add(face.corners, source);
        }
    std::sort(records.begin(), records.end());
    to.faces.clear();
    to.face_tetrahedra.clear();
    to.face_facets.clear();
    to.face_markers.clear();
    to.unused_faces.clear();
    for (const SortedCorners<3>& record : records) {
        const Source& source = sources[record.from];
        if (source.ends[0] == no_index && source.ends[1] == no_index)
            to.unused_faces.push_back(static_cast<std::uint32_t>(to.face_facets.size()));
        to.faces.push_back(record.v[0]);
        to.faces.push_back(record.v[source.turns ? 2 : 1]);
        to.faces.push_back(record.v[source.turns ? 1 : 2]);
        for (const std::uint32_t t : source.ends) to.face_tetrahedra.push_back(t);
        to.face_facets.push_back(source.label.facet);
        to.face_markers.push_back(source.label.marker);
    }
}

}  // namespace mgdt
