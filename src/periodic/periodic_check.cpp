// SPDX-License-Identifier: MIT
#include "periodic/periodic_check.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/interior_point.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

class PeriodicChecker {
    using Tetrahedron = PeriodicTetrahedra::Tetrahedron;
    using Neighbor = PeriodicTetrahedra::Neighbor;
    using Record = PeriodicTetrahedra::Record;

  public:
    PeriodicChecker(const Periodic& periodic, const Buffer<Record>& tetrahedra,
                    StageProgress& progress)
        : periodic_(periodic),
          tetrahedra_(tetrahedra),
          progress_(progress),
          is_corner_(periodic.allocator()) {}

    void run() {
        is_corner_.resize(periodic_.point_count(), std::uint8_t{0});
        progress_.enter(0, 0.2);
        for (std::size_t i = 0; i < tetrahedra_.size(); ++i) {
            progress_.step(i, 0, tetrahedra_.size());
            check_corners(i);
        }
        progress_.enter(0.2, 0.8);
        for (std::size_t i = 0; i < tetrahedra_.size(); ++i) {
            progress_.step(i, 0, tetrahedra_.size());
            for (unsigned k = 0; k < 4; ++k) check_side(i, k);
        }
        progress_.enter(0.8, 1);
        if (tetrahedra_.empty() && !points_span()) return;
        if (!tetrahedra_.empty()) check_cover();
        for (std::uint32_t p = 0; p < is_corner_.size(); ++p)
            if (periodic_.vertex_of(p) == p && is_corner_[p] == 0)
                fail(MGDT_ERR_CHECK_FAILED, "point %llu is a corner of no tetrahedron", shown(p));
    }

  private:
    // The coordinates of the corners of a tetrahedron that is moved by multiples of the basis.
    struct Places {
        double x[4][3];
        const double* p[4];
    };
    void place(const Image& image, double (&x)[3]) const {
        periodic_.grid().image(periodic_.halo().point(image.point), image.multiples(), x);
    }
    void place(std::size_t i, const Multiples& moved, Places& places) const {
        for (unsigned k = 0; k < 4; ++k) {
            const Image& corner = tetrahedra_[i].tetrahedron.corners[k];
            periodic_.grid().image(periodic_.halo().point(corner.point), corner.multiples() + moved,
                                   places.x[k]);
            places.p[k] = places.x[k];
        }
    }
    unsigned long long shown(std::size_t number) const {
        return static_cast<unsigned long long>(number) +
               static_cast<unsigned long long>(periodic_.settings().index_base);
    }
    [[noreturn]] void reject(std::size_t i, const char* what) const {
        fail(MGDT_ERR_CHECK_FAILED, "tetrahedron %llu: %s", shown(i), what);
    }

    void check_corners(std::size_t i) {
        const Tetrahedron& t = tetrahedra_[i].tetrahedron;
        for (const Image& corner : t.corners) {
            if (corner.point >= is_corner_.size() ||
                periodic_.vertex_of(corner.point) != corner.point)
                reject(i, "a corner is no vertex");
            is_corner_[corner.point] = 1;
        }
        if (t.corners[0].multiples() != Multiples{})
            reject(i, "its first corner is not in the box");
        Places places;
        place(i, {}, places);
        for (unsigned k = 1; k < 4; ++k)
            if (compare_lexicographic(places.p[0], places.p[k]) >= 0)
                reject(i, "its first corner is not the least");
        if (orientation(places.p[0], places.p[1], places.p[2], places.p[3]) <= 0)
            reject(i, "it is not positively oriented");
    }

    // Checks the facet opposite a corner: the neighbour there has the same three corners, is on the
    // other side of the facet with the opposite orientation, and has its fourth corner outside of
    // the circumsphere.
    void check_side(std::size_t i, unsigned corner) const {
        const Neighbor& n = tetrahedra_[i].neighbors[corner];
        if (n.number == no_index) return check_hull_facet(i, corner);
        if (n.number >= tetrahedra_.size()) reject(i, "a neighbour does not exist");
        const Multiples moved = {n.of[0], n.of[1], n.of[2]};
        const Tetrahedron &t = tetrahedra_[i].tetrahedron,
                          &other = tetrahedra_[n.number].tetrahedron;
        unsigned shared = 0, apex = 0;
        for (unsigned l = 0; l < 4; ++l) {
            bool is_shared = false;
            for (unsigned k = 0; k < 4; ++k)
                is_shared =
                    is_shared || (k != corner && t.corners[k].point == other.corners[l].point &&
                                  t.corners[k].multiples() == other.corners[l].multiples() + moved);
            if (is_shared)
                ++shared;
            else
                apex = l;
        }
        if (shared != 3) reject(i, "it does not share a facet with its neighbour");
        const Neighbor& back = tetrahedra_[n.number].neighbors[apex];
        if (back.number != i || Multiples{back.of[0], back.of[1], back.of[2]} != -moved)
            reject(i, "its neighbour has another neighbour there");
        Places places;
        place(i, {}, places);
        double x[3];
        place(image_of(other.corners[apex].point, other.corners[apex].multiples() + moved), x);
        const double* p[4] = {places.p[0], places.p[1], places.p[2], places.p[3]};
        p[corner] = x;
        if (orientation(p[0], p[1], p[2], p[3]) >= 0)
            reject(i, "it is on the same side of a facet as its neighbour");
        if (side_of_sphere_perturbed(places.p[0], places.p[1], places.p[2], places.p[3], x) >= 0)
            reject(i, "a corner of a neighbour is in its circumsphere");
    }

    // Checks a facet of the hull: its plane contains all images of its corners, and no point is
    // beyond.
    void check_hull_facet(std::size_t i, unsigned corner) const {
        Places places;
        place(i, {}, places);
        const unsigned dimensions = periodic_.dimensions();
        if (dimensions == 3) reject(i, "it has no neighbour");
        const auto side_of = [&](const double* x) {
            const double* p[4] = {places.p[0], places.p[1], places.p[2], places.p[3]};
            p[corner] = x;
            return orientation(p[0], p[1], p[2], p[3]);
        };
        const Image& at = tetrahedra_[i].tetrahedron.corners[corner == 0 ? 1 : 0];
        for (unsigned k = 0; k < dimensions; ++k) {
            Multiples moved = at.multiples();
            ++moved[k];
            double x[3];
            place(image_of(at.point, moved), x);
            if (side_of(x) != 0)
                reject(i, "a facet of the hull is inclined to a vector of the box");
        }
        for (std::uint32_t p = 0; p < is_corner_.size(); ++p)
            if (side_of(periodic_.halo().point(p)) < 0)
                reject(i, "a point is beyond a facet of the hull");
    }

    // Whether the images of the points are not all in one plane.
    bool points_span() const {
        const auto n = static_cast<std::uint32_t>(is_corner_.size());
        if (n == 0 || periodic_.dimensions() == 3) return n > 0;
        double a[3], b[3], c[3];
        place(image_of(0, {}), a);
        place(image_of(0, {1, 0, 0}), b);
        std::uint32_t next = 0;
        if (periodic_.dimensions() == 2)
            place(image_of(0, {0, 1, 0}), c);
        else
            for (bool is_line = true; is_line; ++next) {
                if (next == n) return false;
                place(image_of(next, {}), c);
                is_line = collinear(a, b, c);
            }
        for (; next < n; ++next)
            if (orientation(a, b, c, periodic_.halo().point(next)) != 0) return true;
        return false;
    }

    // Checks that a place inside of the first tetrahedron is in no other tetrahedron and in no
    // image of one.
    void check_cover() const {
        Places home, places;
        place(0, {}, home);
        const InteriorPoint inside(home.p[0], home.p[1], home.p[2], home.p[3]);
        const BoxLattice& lattice = periodic_.grid().lattice();
        double s[3];
        lattice.coordinates(home.p[0], s);
        for (std::size_t i = 0; i < tetrahedra_.size(); ++i) {
            progress_.step(i, 0, tetrahedra_.size());
            place(i, {}, places);
            // The range of multiples that can move the tetrahedron to the place.
            std::int32_t first[3] = {}, last[3] = {};
            for (unsigned k = 0; k < lattice.dimensions(); ++k) {
                double low = 0, high = 0;
                for (unsigned c = 0; c < 4; ++c) {
                    double x[3];
                    lattice.coordinates(places.p[c], x);
                    low = c == 0 ? x[k] : std::min(low, x[k]);
                    high = c == 0 ? x[k] : std::max(high, x[k]);
                }
                constexpr double slack = 0x1p-4;
                first[k] = static_cast<std::int32_t>(std::ceil(s[k] - high - slack));
                last[k] = static_cast<std::int32_t>(std::floor(s[k] - low + slack));
            }
            Multiples k;
            for (k[0] = first[0]; k[0] <= last[0]; ++k[0])
                for (k[1] = first[1]; k[1] <= last[1]; ++k[1])
                    for (k[2] = first[2]; k[2] <= last[2]; ++k[2]) {
                        if (i == 0 && k == Multiples{}) continue;
                        place(i, k, places);
                        if (inside.is_in(places.p)) reject(i, "it overlaps another one");
                    }
        }
    }

    const Periodic& periodic_;
    const Buffer<Record>& tetrahedra_;
    StageProgress& progress_;
    Buffer<std::uint8_t> is_corner_;
};

}  // namespace

void check_periodic(const Periodic& periodic, const Buffer<PeriodicTetrahedra::Record>& tetrahedra,
                    StageProgress& progress) {
    PeriodicChecker(periodic, tetrahedra, progress).run();
}

void check_periodic(const Periodic& periodic, StageProgress& progress) {
    check_periodic(periodic, periodic.tetrahedra().records(), progress);
}

}  // namespace mgdt
