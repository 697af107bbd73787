// SPDX-License-Identifier: MIT
#include "voronoi/cut_faces.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "predicates/differences.hpp"

namespace mgdt {

CutFaces::CutFaces(const MeshView& view, const VertexIndices& indices, const Region& region,
                   const Circumcenters& centers, AtomicArray<std::uint8_t>& is_cut,
                   CutCorners& corners, AtomicArray<TetId>& first, std::size_t points,
                   StageProgress& progress)
    : view_(view),
      mesh_(view.mesh),
      indices_(indices),
      region_(region),
      centers_(centers),
      is_cut_(is_cut),
      corners_(corners),
      first_(first),
      points_(points),
      progress_(progress) {}

// A cell may be cut if one of its corners is not certainly inside the region.
void CutFaces::mark() {
    constexpr std::size_t slots_per_thread = 4096;
    view_.team.split(mesh_.tetrahedra.size(), slots_per_thread,
                     [&](std::size_t begin, std::size_t end, unsigned) {
                         for (std::size_t id = begin; id < end; ++id) {
                             const Tetrahedron& t = mesh_.tetrahedra[id];
                             if (t.is_dead()) continue;
                             if (!t.is_ghost()) {
                                 const double(&x)[3] = centers_[static_cast<TetId>(id)].x;
                                 const double largest = exact::largest_of<0, 3>(x);
                                 if (region_.clearance(x) > 2 * rounding_of<double> * largest)
                                     continue;
                             }
                             for (const VertexId v : t.v)
                                 is_cut_[v].store(1, std::memory_order_relaxed);
                         }
                     });
}

void CutFaces::find_cycles(PerMember<Cycles>& cycles) {
    constexpr std::size_t vertices_per_thread = 256;
    Buffer<VertexId> cut(view_.allocator);
    for (VertexId v = 1; v < mesh_.vertices.size(); ++v)
        if (is_cut_[v].load(std::memory_order_relaxed) != 0 && indices_[v] < points_)
            cut.push_back(v);
    view_.team.split(
        cut.size(), vertices_per_thread, [&](std::size_t begin, std::size_t end, unsigned member) {
            Link link(view_.allocator);
            Cell cell(view_.allocator);
            CellFaces faces(view_.allocator);
            Cycles& of_member = cycles[member];
            for (std::size_t i = begin; i < end; ++i) {
                progress_.step(i, begin, end, member);
                const VertexId v = cut[i];
                const std::uint32_t index = indices_[v];
                link.gather(mesh_, v, first_[v].load(std::memory_order_relaxed));
                cell.make(mesh_, v, link, Centers::plain);
                faces.find(mesh_, v, link, cell, region_);
                const auto of_plane = [&](PlaneNumber plane) {
                    if (plane >= faces.bisectors())
                        return VoronoiDiagram::plane |
                               static_cast<std::uint32_t>(plane - faces.bisectors());
                    return cell.index(faces.neighbor(plane));
                };
                for (std::size_t f = 0; f < faces.size(); ++f) {
                    const CellFaces::Face& face = faces.face(f);
                    const std::uint32_t other = of_plane(face.plane);
                    // The other cell has the face too. If that cell is not cut, the face is among
                    // the whole faces.
                    if (face.plane < faces.bisectors() &&
                        (other < index || is_cut_[link.neighbor(faces.neighbor(face.plane))].load(
                                              std::memory_order_relaxed) == 0))
                        continue;
                    const auto size = static_cast<std::uint32_t>(face.end - face.begin);
                    of_member.faces.push_back(
                        {{index, other}, size, of_member.edges.size(), no_face});
                    for (std::size_t e = face.begin; e < face.end; ++e)
                        of_member.edges.push_back(of_plane(faces.edge(e)));
                }
            }
        });
}

// Finds the corners of the faces. Corner i of a cycle is before edge i. If no plane cuts the cell,
// edges may have length 0, and two consecutive corners are one.
void CutFaces::find_corners(Cycles& cycles, FoundFaces& found) {
    for (std::size_t f = 0; f < cycles.faces.size(); ++f) {
        progress_.stop_request().poll_in_step(f);
        Cycle& cycle = cycles.faces[f];
        FoundFace face = {};
        face.sides[0] = cycle.sides[0];
        face.sides[1] = cycle.sides[1];
        const std::size_t begin = found.corners.size();
        const std::uint32_t* const edges = cycles.edges.begin() + cycle.begin;
        for (std::uint32_t i = 0; i < cycle.size; ++i) {
            const std::uint32_t before = edges[i == 0 ? cycle.size - 1 : i - 1];
            const std::uint32_t corner =
                corners_.find({{cycle.sides[0], cycle.sides[1], before, edges[i]}});
            if (found.corners.size() == begin || found.corners.back() != corner)
                found.corners.push_back(corner);
        }
        if (found.corners.size() > begin + 1 && found.corners.back() == found.corners[begin])
            found.corners.resize(found.corners.size() - 1);
        const std::size_t size = found.corners.size() - begin;
        if (size < 3) {
            // A face with fewer than three corners has no area.
            found.corners.resize(begin);
            continue;
        }
        face.set_corners(begin, size);
        cycle.face = found.faces.size();
        found.faces.push_back(face);
    }
}

FacePlane CutFaces::plane_of(const FoundFace& face) const {
    const double* const a = corners_.point(face.sides[0]);
    if (!is_plane(face.sides[1])) return bisector(a, corners_.point(face.sides[1]));
    const Side side = region_.side(face.sides[1] & ~VoronoiDiagram::plane, a, 1);
    const double size = length(side.normal);
    FacePlane plane;
    plane.normal = (1 / size) * side.normal;
    plane.distance = side.offset / size;
    plane.distance_error = side.error / size + normal_error * std::fabs(plane.distance);
    plane.spacing = 0;
    return plane;
}

void CutFaces::measure(const Cycles& cycles, FoundFaces& found) {
    constexpr std::size_t faces_per_thread = 1024;
    view_.team.split(
        cycles.faces.size(), faces_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
            HalfSpaces half_spaces(view_.allocator);
            Buffer<const SplitPoint*> points(view_.allocator);
            for (std::size_t f = begin; f < end; ++f) {
                progress_.stop_request().poll_in_step(f);
                const Cycle& cycle = cycles.faces[f];
                if (cycle.face == no_face) continue;
                FoundFace& face = found.faces[cycle.face];
                const FacePlane plane = plane_of(face);
                points.clear();
                for (std::size_t i = 0; i < face.size(); ++i)
                    points.push_back(&corners_[found.corners[face.begin() + i]]);
                const FaceMeasure result = measure_accurately(
                    half_spaces, corners_.point(face.sides[0]), plane, points,
                    1 / centers_.factor(), mesh_.scale, [&] {
                        corners_.add_half_space(face.sides[1], half_spaces);
                        for (std::uint32_t i = 0; i < cycle.size; ++i)
                            corners_.add_half_space(cycles.edges[cycle.begin + i], half_spaces);
                        return std::size_t{cycle.size};
                    });
                face.set_measure(result, plane);
            }
        });
}

void CutFaces::find(PerMember<FoundFaces>& found) {
    PerMember<Cycles> cycles(view_.team, view_.allocator, std::ref(view_.allocator));
    find_cycles(cycles);
    for (std::size_t id = 0; id < mesh_.tetrahedra.size(); ++id) {
        progress_.stop_request().poll_in_step(id);
        const Tetrahedron& t = mesh_.tetrahedra[id];
        if (t.is_dead() || t.is_ghost()) continue;
        bool may_be_cut = false;
        for (const VertexId v : t.v) may_be_cut |= is_cut_[v].load(std::memory_order_relaxed) != 0;
        if (may_be_cut) corners_.add(static_cast<TetId>(id));
    }
    for (std::size_t m = 0; m < cycles.size(); ++m) {
        find_corners(cycles[m], found[m]);
        measure(cycles[m], found[m]);
    }
}

}  // namespace mgdt
