// SPDX-License-Identifier: MIT
#include "solid/mesh_check.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/tetrahedron.hpp"
#include "platform/error.hpp"
#include "predicates/predicates.hpp"
#include "solid/divided_segment.hpp"
#include "solid/embedding_check.hpp"

namespace mgdt {
namespace {

// The corners of a face in ascending order, and the number of the face.
struct Triple {
    std::uint32_t v[3];
    std::uint32_t face;

    Triple(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t of)
        : v{a, b, c}, face(of) {
        std::sort(v, v + 3);
    }
    friend bool operator<(const Triple& a, const Triple& b) {
        return std::lexicographical_compare(a.v, a.v + 3, b.v, b.v + 3);
    }
};
static_assert(std::is_trivially_copyable_v<Triple>);

class MeshCheck {
  public:
    MeshCheck(const SolidMesh& mesh, std::int32_t base, Allocator& allocator,
              StageProgress& progress)
        : mesh_(mesh), allocator_(allocator), base_(base), progress_(progress), faces_(allocator) {}

    void run() {
        progress_.enter(0, 0.1);
        check_sizes();
        check_points();
        check_edges();
        progress_.enter(0.1, 0.25);
        check_tetrahedra();
        progress_.enter(0.25, 0.35);
        check_faces();
        progress_.enter(0.35, 0.7);
        check_neighbors();
        StageProgress last = progress_.within(0.7, 1);
        check_embedding(mesh_, static_cast<std::int32_t>(base_), allocator_, last);
    }

  private:
    long long number(std::size_t i) const { return static_cast<long long>(i) + base_; }
    const double* exact(std::uint32_t v) const {
        return mesh_.exact_points.begin() + 3 * std::size_t{v};
    }
    const double* point(std::uint32_t v) const { return mesh_.points.begin() + 3 * std::size_t{v}; }
    void check_sizes() const {
        const std::size_t tetrahedra = mesh_.tetrahedron_count(), faces = mesh_.faces.size() / 3,
                          edges = mesh_.edges.size() / 2;
        const std::size_t points = mesh_.points.size() / 3,
                          steiner = mesh_.steiner_parameters.size();
        if (mesh_.tetrahedra.size() % 4 != 0 || mesh_.neighbors.size() != 4 * tetrahedra ||
            mesh_.regions.size() != tetrahedra || mesh_.faces.size() % 3 != 0 ||
            mesh_.face_tetrahedra.size() != 2 * faces || mesh_.face_facets.size() != faces ||
            mesh_.face_markers.size() != faces || mesh_.edges.size() % 2 != 0 ||
            mesh_.edge_segments.size() != edges || mesh_.edge_markers.size() != edges ||
            mesh_.points.size() % 3 != 0 || mesh_.points.size() != mesh_.exact_points.size() ||
            mesh_.point_origins.size() != points || steiner > points ||
            mesh_.steiner_edges.size() != 2 * steiner)
            fail(MGDT_ERR_CHECK_FAILED, "the arrays of the mesh do not fit together");
    }

    void check_edges() const {
        const std::size_t points = mesh_.points.size() / 3;
        for (std::size_t i = 0; i < mesh_.edges.size(); ++i)
            if (mesh_.edges[i] >= points || mesh_.edges[i] == mesh_.edges[i ^ 1])
                fail(MGDT_ERR_CHECK_FAILED, "edge %lld has a wrong end", number(i / 2));
    }

    // Checks that points are on the grid, and that each Steiner point divides its edge, if it has
    // one.
    void check_points() const {
        const std::size_t given = mesh_.points.size() / 3 - mesh_.steiner_parameters.size();
        for (std::size_t i = 0; i < 3 * given && mesh_.is_of_domain; ++i)
            if (mesh_.exact_points[i] != mesh_.grid.round(mesh_.points[i]))
                fail(MGDT_ERR_CHECK_FAILED, "point %lld is not where it was", number(i / 3));
        for (std::size_t i = 0; i < mesh_.point_origins.size(); ++i) {
            const std::uint32_t origin = mesh_.point_origins[i];
            if (i < given ? origin > i || mesh_.point_origins[origin] != origin
                          : origin != no_index)
                fail(MGDT_ERR_CHECK_FAILED, "point %lld has a wrong origin", number(i));
        }
        for (std::size_t i = 0; i < mesh_.steiner_parameters.size() && mesh_.is_of_domain; ++i) {
            progress_.step(i, 0, mesh_.steiner_parameters.size());
            const std::uint32_t* const ends = mesh_.steiner_edges.begin() + 2 * i;
            const double t = mesh_.steiner_parameters[i];
            const auto p = static_cast<std::uint32_t>(given + i);
            if (ends[0] == no_index && ends[1] == no_index && t == 0) {
                for (int k = 0; k < 3; ++k)
                    if (mesh_.grid.unround(exact(p)[k]) != point(p)[k])
                        fail(MGDT_ERR_CHECK_FAILED, "point %lld has other coordinates", number(p));
                continue;
            }
            bool is_right = ends[0] < given && ends[1] < given && t > 0 && t < 1;
            if (is_right) {
                const DividedSegment divided(exact(ends[0]), exact(ends[1]));
                const double k = t * divided.parts();
                double x[3];
                divided.point(static_cast<std::uint32_t>(k), x);
                is_right = k == std::floor(k) && std::equal(x, x + 3, exact(p));
            }
            if (is_right) is_right = is_placed(p, ends, t);
            if (!is_right) fail(MGDT_ERR_CHECK_FAILED, "point %lld is not on its edge", number(p));
        }
    }

    // Whether the returned place of a Steiner point is right: on the grid if points are rounded,
    // otherwise between the caller's points.
    bool is_placed(std::uint32_t p, const std::uint32_t* ends, double t) const {
        double x[3];
        if (mesh_.is_rounded)
            for (int k = 0; k < 3; ++k) x[k] = mesh_.grid.unround(exact(p)[k]);
        else
            SolidMesh::place_on_segment(point(ends[0]), point(ends[1]), t, exact(p), mesh_.grid, x);
        return std::equal(x, x + 3, point(p));
    }

    void check_tetrahedra() const {
        const std::size_t points = mesh_.points.size() / 3;
        for (std::size_t t = 0; t < mesh_.tetrahedron_count(); ++t) {
            progress_.step(t, 0, mesh_.tetrahedron_count());
            const std::uint32_t* const v = mesh_.tetrahedra.begin() + 4 * t;
            if (std::any_of(v, v + 4, [&](std::uint32_t p) { return p >= points; }))
                fail(MGDT_ERR_CHECK_FAILED, "tetrahedron %lld has a corner that is no point",
                     number(t));
            if (orientation(exact(v[0]), exact(v[1]), exact(v[2]), exact(v[3])) <= 0 ||
                orientation(point(v[0]), point(v[1]), point(v[2]), point(v[3])) <= 0)
                fail(MGDT_ERR_CHECK_FAILED, "tetrahedron %lld is not positive", number(t));
            if (mesh_.regions[t] >= mesh_.region_markers.size())
                fail(MGDT_ERR_CHECK_FAILED, "tetrahedron %lld is in no region", number(t));
        }
    }

    // Checks that each face is a face of the two tetrahedra that are listed for it, and that these
    // are on the right sides.
    void check_faces() {
        const std::size_t points = mesh_.points.size() / 3;
        for (std::uint32_t f = 0; f < mesh_.face_facets.size(); ++f) {
            progress_.step(f, 0, mesh_.face_facets.size());
            const std::uint32_t* const v = mesh_.faces.begin() + 3 * std::size_t{f};
            if (std::any_of(v, v + 3, [&](std::uint32_t p) { return p >= points; }))
                fail(MGDT_ERR_CHECK_FAILED, "face %lld has a corner that is no point", number(f));
            faces_.push_back(Triple(v[0], v[1], v[2], f));
            for (int side = 0; side < 2; ++side) {
                const std::uint32_t t =
                    mesh_.face_tetrahedra[2 * std::size_t{f} + static_cast<std::size_t>(side)];
                if (t == no_index) continue;
                if (t >= mesh_.tetrahedron_count() || !is_on_side(v, t, side))
                    fail(MGDT_ERR_CHECK_FAILED, "face %lld is not a face of tetrahedron %lld",
                         number(f), number(t));
            }
        }
        std::sort(faces_.begin(), faces_.end());
        for (std::size_t i = 1; i < faces_.size(); ++i)
            if (!(faces_[i - 1] < faces_[i]))
                fail(MGDT_ERR_CHECK_FAILED, "face %lld is listed twice", number(faces_[i].face));
    }

    bool is_on_side(const std::uint32_t* face, std::uint32_t t, int side) const {
        const std::uint32_t* const v = mesh_.tetrahedra.begin() + 4 * std::size_t{t};
        std::uint32_t apex = no_index;
        for (int i = 0; i < 4; ++i) {
            if (std::find(face, face + 3, v[i]) != face + 3) continue;
            if (apex != no_index) return false;
            apex = v[i];
        }
        if (apex == no_index) return false;
        const int sign = orientation(exact(face[0]), exact(face[1]), exact(face[2]), exact(apex));
        return side == 0 ? sign > 0 : sign < 0;
    }

    // The number of the listed face with these corners, or no_index.
    std::uint32_t listed(const Triple& face) const {
        const Triple* const found = std::lower_bound(faces_.begin(), faces_.end(), face);
        return found == faces_.end() || face < *found ? no_index : found->face;
    }

    void check_neighbors() const {
        std::size_t sides = 0, ends = 0;
        for (std::uint32_t t = 0; t < mesh_.tetrahedron_count(); ++t) {
            progress_.step(t, 0, mesh_.tetrahedron_count());
            for (unsigned i = 0; i < 4; ++i) {
                const std::uint32_t* const v = mesh_.tetrahedra.begin() + 4 * std::size_t{t};
                const unsigned char* const f = outer_face[i];
                const std::uint32_t face = listed(Triple(v[f[0]], v[f[1]], v[f[2]], 0));
                const std::uint32_t next = mesh_.neighbors[4 * std::size_t{t} + i];
                if (face != no_index) {
                    const std::uint32_t* const of =
                        mesh_.face_tetrahedra.begin() + 2 * std::size_t{face};
                    if (!(of[0] == t && of[1] == next) && !(of[1] == t && of[0] == next))
                        fail(MGDT_ERR_CHECK_FAILED, "face %lld has wrong tetrahedra", number(face));
                    ++sides;
                }
                if (next == no_index) {
                    if (face == no_index)
                        fail(MGDT_ERR_CHECK_FAILED,
                             "tetrahedron %lld has no neighbour at a face that is on no facet",
                             number(t));
                    continue;
                }
                check_neighbor(t, i, next, face != no_index);
            }
        }
        for (const std::uint32_t t : mesh_.face_tetrahedra) ends += t != no_index ? 1 : 0;
        if (sides != ends)
            fail(MGDT_ERR_CHECK_FAILED, "%zu faces are at tetrahedra, %zu are listed", sides, ends);
    }

    void check_neighbor(std::uint32_t t, unsigned i, std::uint32_t next, bool is_facet) const {
        const std::uint32_t* const v = mesh_.tetrahedra.begin() + 4 * std::size_t{t};
        bool is_right = next < mesh_.tetrahedron_count();
        std::uint32_t apex = no_index;
        for (unsigned k = 0; k < 4 && is_right; ++k) {
            const std::uint32_t w = mesh_.tetrahedra[4 * std::size_t{next} + k];
            const std::uint32_t* const same = std::find(v, v + 4, w);
            if (same == v + 4 || same == v + i) {
                is_right = apex == no_index && same == v + 4 &&
                           mesh_.neighbors[4 * std::size_t{next} + k] == t;
                apex = w;
            }
        }
        if (!is_right || apex == no_index)
            fail(MGDT_ERR_CHECK_FAILED, "tetrahedra %lld and %lld are no neighbours", number(t),
                 number(next));
        if (is_facet) return;
        if (mesh_.regions[t] != mesh_.regions[next])
            fail(MGDT_ERR_CHECK_FAILED, "tetrahedra %lld and %lld are in different regions",
                 number(t), number(next));
        if (mesh_.is_delaunay && side_of_sphere_perturbed(exact(v[0]), exact(v[1]), exact(v[2]),
                                                          exact(v[3]), exact(apex)) > 0)
            fail(MGDT_ERR_CHECK_FAILED, "point %lld is in the sphere of tetrahedron %lld",
                 number(apex), number(t));
    }

    const SolidMesh& mesh_;
    Allocator& allocator_;
    std::int64_t base_;
    StageProgress& progress_;
    Buffer<Triple> faces_;  // the listed faces, sorted
};

}  // namespace

void check_mesh(const SolidMesh& mesh, std::int32_t index_base, Allocator& allocator,
                StageProgress& progress) {
    MeshCheck(mesh, index_base, allocator, progress).run();
}

}  // namespace mgdt
