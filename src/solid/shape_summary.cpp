// SPDX-License-Identifier: MIT
#include "solid/shape_summary.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/scale.hpp"
#include "parallel/watched_split.hpp"
#include "predicates/vector.hpp"
#include "query/tetrahedron_measures.hpp"

namespace mgdt {
namespace {

constexpr double degrees_per_radian = 57.295779513082320877;
// Rounding of a cosine may take an angle to the other side of a bound.
constexpr double tolerance = 1e-12;
// The cosines of 10, 20, ..., 170 degrees.
constexpr double cosines[ShapeSummary::angle_bins - 1] = {
    0.98480775301220806,  0.93969262078590838,  0.86602540378443865,
    0.76604444311897804,  0.64278760968653933,  0.5,
    0.34202014332566873,  0.17364817766693035,  0.0,
    -0.17364817766693035, -0.34202014332566873, -0.5,
    -0.64278760968653933, -0.76604444311897804, -0.86602540378443865,
    -0.93969262078590838, -0.98480775301220806};
// The cosines of ShapeSummary::bound_degrees.
constexpr double bound_cosines[ShapeSummary::bounds] = {0.99619469809174553, 0.98480775301220806,
                                                        0.96592582628906829, 0.93969262078590838,
                                                        0.90630778703664996, 0.86602540378443865};

// The summary of some tetrahedra, with the cosines of the extreme angles and their tetrahedra.
struct Part {
    std::uint64_t angles[ShapeSummary::angle_bins] = {};
    std::uint64_t below[ShapeSummary::bounds] = {};
    double sum = 0;
    double largest_cosine = -2, least_cosine = 2;
    std::size_t largest_at = 0, least_at = 0;

    void add(const Part& other) {
        for (int i = 0; i < ShapeSummary::angle_bins; ++i) angles[i] += other.angles[i];
        for (int i = 0; i < ShapeSummary::bounds; ++i) below[i] += other.below[i];
        sum += other.sum;
        if (other.largest_cosine > largest_cosine) {
            largest_cosine = other.largest_cosine;
            largest_at = other.largest_at;
        }
        if (other.least_cosine < least_cosine) {
            least_cosine = other.least_cosine;
            least_at = other.least_at;
        }
    }
};

class Summary {
  public:
    Summary(const SolidMesh& mesh, Allocator& allocator)
        : mesh_(mesh), allocator_(allocator), points_(allocator) {
        ExponentRange range;
        for (const double c : mesh.points) range.add(c);
        scale_ = choose_scale(range, 0);
        points_.resize(mesh.points.size());
        for (std::size_t i = 0; i < points_.size(); ++i)
            points_[i] = scaled(mesh.points[i], scale_);
    }

    ShapeSummary run(Team& team, StageProgress& progress) const {
        // Parts have the same tetrahedra for every number of threads, and so the same sums.
        constexpr std::size_t size = 1024, parts_per_thread = 4;
        const std::size_t count = mesh_.tetrahedron_count();
        Buffer<Part> parts(allocator_);
        parts.resize((count + size - 1) / size, Part());
        team.split(parts.size(), parts_per_thread,
                   [&](std::size_t begin, std::size_t end, unsigned member) {
                       for (std::size_t i = begin; i < end; ++i) {
                           progress.look(i - begin, end - begin, member);
                           for (std::size_t t = i * size; t < std::min((i + 1) * size, count); ++t)
                               add(t, parts[i]);
                       }
                   });
        Part all;
        for (const Part& part : parts) all.add(part);
        ShapeSummary result;
        std::copy_n(all.angles, ShapeSummary::angle_bins, result.angles);
        std::copy_n(all.below, ShapeSummary::bounds, result.tetrahedra_below);
        if (count == 0) return result;
        result.mean_volume_length = all.sum / static_cast<double>(count);
        result.least_angle =
            degrees_per_radian * measure(all.largest_at, TetrahedronMeasure::least_dihedral_angle);
        result.largest_angle =
            degrees_per_radian * measure(all.least_at, TetrahedronMeasure::largest_dihedral_angle);
        return result;
    }

  private:
    const double* corner(std::size_t t, std::size_t i) const {
        return points_.begin() + 3 * std::size_t{mesh_.tetrahedra[4 * t + i]};
    }
    double measure(std::size_t t, TetrahedronMeasure of) const {
        return measure_tetrahedron({corner(t, 0), corner(t, 1), corner(t, 2), corner(t, 3)}, scale_,
                                   of, allocator_);
    }

    void add(std::size_t t, Part& part) const {
        double cosine[6];
        part.sum += find_cosines(t, cosine);
        double largest = cosine[0], least = cosine[0];
        for (const double c : cosine) {
            int bin = 0;
            for (const double bound : cosines) bin += c <= bound + tolerance ? 1 : 0;
            ++part.angles[bin];
            largest = std::max(largest, c);
            least = std::min(least, c);
        }
        for (int i = 0; i < ShapeSummary::bounds; ++i)
            part.below[i] += largest > bound_cosines[i] + tolerance ? 1 : 0;
        if (largest > part.largest_cosine) {
            part.largest_cosine = largest;
            part.largest_at = t;
        }
        if (least < part.least_cosine) {
            part.least_cosine = least;
            part.least_at = t;
        }
    }

    // Finds the cosines of the six dihedral angles. Returns the ratio of volume and lengths.
    double find_cosines(std::size_t t, double (&cosine)[6]) const {
        using Edge = Vector<double>;
        const Edge u = difference<double>(corner(t, 1), corner(t, 0)),
                   v = difference<double>(corner(t, 2), corner(t, 0)),
                   w = difference<double>(corner(t, 3), corner(t, 0));
        const Edge uv = v - u, vw = w - v, wu = u - w;
        const Edge n[4] = {cross(uv, w - u), cross(w, v), cross(u, w), cross(v, u)};
        double length[4];
        for (int i = 0; i < 4; ++i) length[i] = std::sqrt(dot(n[i], n[i]));
        int k = 0;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < i; ++j) {
                const double c = -dot(n[i], n[j]) / (length[i] * length[j]);
                // A tetrahedron that is so small or so flat that a normal is nothing in doubles.
                cosine[k++] = std::isfinite(c) ? std::clamp(c, -1.0, 1.0) : 1;
            }
        const double square =
            ((dot(u, u) + dot(v, v)) + (dot(w, w) + dot(uv, uv))) + (dot(vw, vw) + dot(wu, wu));
        const double ratio =
            12 * std::sqrt(3.0) * std::fabs(dot(u, n[1])) / (square * std::sqrt(square));
        return std::isfinite(ratio) ? ratio : 0;
    }

    const SolidMesh& mesh_;
    Allocator& allocator_;
    Buffer<double> points_;
    int scale_ = 0;
};

}  // namespace

ShapeSummary summarize_shapes(const SolidMesh& mesh, Team& team, Allocator& allocator,
                              StageProgress& progress) {
    return Summary(mesh, allocator).run(team, progress);
}

}  // namespace mgdt
