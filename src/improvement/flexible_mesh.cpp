// SPDX-License-Identifier: MIT
#include "improvement/flexible_mesh.hpp"

#include <algorithm>

#include "improvement/quality.hpp"

namespace mgdt {

FlexibleMesh::FlexibleMesh(const SolidMesh& from, Team& team, Allocator& allocator)
    : LinkedMesh(from, team, allocator),
      qualities(allocator),
      classes(allocator),
      star_sizes(allocator),
      last_change(allocator),
      faces_(allocator),
      links_(allocator),
      slots_(allocator),
      leaves_(allocator) {
    star_sizes.resize(hints.size(), 0);
    last_change.resize(hints.size(), 0);
    classes.resize(hints.size(), {Freedom::fixed, false, {0, 0, 0}});
    qualities.resize(tetrahedra.size());
    constexpr std::size_t tetrahedra_per_thread = 4096;
    team_.split(tetrahedra.size(), tetrahedra_per_thread,
                [&](std::size_t begin, std::size_t end, unsigned) {
                    for (std::size_t t = begin; t < end; ++t)
                        qualities[t] = quality(tetrahedra[t].v);
                });
    for (const Tetrahedron& t : tetrahedra)
        for (const std::uint32_t v : t.v) ++star_sizes[v];
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
    return come == change.faces.size() && leave == come + change.more.lost_faces;
}

bool FlexibleMesh::apply(Change& change) {
    if (!pair_faces(change)) return false;
    add_vertex(change);
    for (const std::uint32_t t : change.removed)
        for (const std::uint32_t v : tetrahedra[t].v) {
            note_change(v);
            --star_sizes[v];
        }
    for (const Change::Tetrahedron& t : change.added)
        for (const std::uint32_t v : t.v) ++star_sizes[v];
    if (const std::uint32_t lost = change.more.lost_vertex; lost != no_index) {
        hints[lost] = no_tetrahedron;
        is_lost[lost] = 1;
        const std::uint32_t(&ends)[2] = change.more.ends;
        if (ends[0] != no_index) {
            edges.add(ends[0], ends[1], edges.origin(lost, ends[1]));
            for (const std::uint32_t end : ends) edges.remove(lost, end);
        }
    }
    slots_.clear();
    for (std::size_t k = 0; k < change.added.size(); ++k)
        slots_.push_back(k < change.removed.size() ? change.removed[k] : take_slot());
    regions.grow(tetrahedra.size());
    regions.resize(tetrahedra.size());
    qualities.grow(tetrahedra.size());
    qualities.resize(tetrahedra.size());
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

// Adds the vertex that comes with a change, if there is one.
void FlexibleMesh::add_vertex(Change& change) {
    const auto number = static_cast<std::uint32_t>(hints.size());
    bool is_named = false;
    for (Change::Tetrahedron& t : change.added)
        for (std::uint32_t& v : t.v)
            if (v == Change::new_vertex) {
                v = number;
                is_named = true;
            }
    if (!is_named) return;
    for (const double c : change.more.place) x.push_back(c);
    hints.push_back(no_tetrahedron);
    classes.push_back(free_vertex);
    is_lost.push_back(0);
    star_sizes.push_back(0);
    last_change.push_back(round);
}

}  // namespace mgdt
