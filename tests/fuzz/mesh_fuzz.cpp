// SPDX-License-Identifier: MIT
// Meshes of a caller's tetrahedra: any at all, or some of a Delaunay triangulation, with faces and
// edges. What is built passes its check and can be refined with any sizes and improved with any
// options: the mesh is valid then, an improved one is no worse, regions keep their volumes, and two
// threads make the same. Places are in
// the tetrahedra that contain them.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "../support/messages.hpp"
#include "mgdt/mgdt_mesh.h"
#include "points.hpp"

namespace fuzz {
namespace {

using Integers = std::vector<std::int64_t>;

class Handle {
  public:
    Handle() { FUZZ_REQUIRE(mgdt_mesh_create(&m_) == MGDT_OK, "create"); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { mgdt_mesh_destroy(m_); }
    operator mgdt_mesh*() const { return m_; }

    void set(std::int32_t option, std::int64_t value) const {
        FUZZ_REQUIRE(mgdt_mesh_set_option(m_, option, value) == MGDT_OK, "option");
    }
    void set_double(std::int32_t option, double value) const {
        FUZZ_REQUIRE(mgdt_mesh_set_double_option(m_, option, value) == MGDT_OK, "option");
    }
    std::int64_t stat(std::int32_t key) const {
        std::int64_t value = -1;
        FUZZ_REQUIRE(mgdt_mesh_get_stat(m_, key, &value) == MGDT_OK, "stat");
        return value;
    }
    Integers array(std::int32_t key) const {
        std::int64_t size = -1;
        FUZZ_REQUIRE(mgdt_mesh_get_size(m_, key, &size) == MGDT_OK && size >= 0, "size");
        Integers values(static_cast<std::size_t>(size));
        FUZZ_REQUIRE(mgdt_mesh_get_array(m_, key, size, values.data()) == MGDT_OK, "array");
        return values;
    }
    std::vector<double> doubles(std::int32_t key) const {
        std::int64_t size = -1;
        FUZZ_REQUIRE(mgdt_mesh_get_size(m_, key, &size) == MGDT_OK && size >= 0, "size");
        std::vector<double> values(static_cast<std::size_t>(size));
        FUZZ_REQUIRE(mgdt_mesh_get_doubles(m_, key, size, values.data()) == MGDT_OK, "doubles");
        return values;
    }
    std::vector<double> measures(std::int32_t measure) const {
        std::vector<double> x(static_cast<std::size_t>(stat(MGDT_MESH_STAT_TETRAHEDRA)));
        FUZZ_REQUIRE(mgdt_mesh_get_tetrahedron_measures(
                         m_, measure, static_cast<std::int64_t>(x.size()), x.data()) == MGDT_OK,
                     "measures");
        return x;
    }
    // The volume of the tetrahedra with each marker.
    std::map<std::int64_t, double> volumes() const {
        const Integers regions = array(MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS),
                       markers = array(MGDT_MESH_ARRAY_REGION_MARKERS);
        const std::vector<double> x = measures(MGDT_TETRAHEDRON_VOLUME);
        std::map<std::int64_t, double> sums;
        for (std::size_t t = 0; t < x.size(); ++t)
            sums[markers[static_cast<std::size_t>(regions[t])]] += x[t];
        return sums;
    }
    bool check() const {
        const mgdt_status status = mgdt_mesh_check(m_);
        FUZZ_REQUIRE(status == MGDT_OK || status == MGDT_ERR_CHECK_FAILED, "check");
        return status == MGDT_OK;
    }

  private:
    mgdt_mesh* m_ = nullptr;
};

class Session {
  public:
    explicit Session(Input& in) : in_(in) { source_.choose_sphere(in.below(4)); }

    void run() {
        draw_points();
        is_of_delaunay_ = in_.below(4) != 0;
        if (is_of_delaunay_)
            take_tetrahedra();
        else
            for (unsigned k = in_.below(12); k > 0; --k)
                for (int i = 0; i < 4; ++i) corners_.push_back(index());
        for (std::size_t t = 0; t < corners_.size() / 4; ++t)
            markers_.push_back(static_cast<std::int32_t>(in_.below(2)) - 1);
        draw_listed(faces_, 3);
        draw_listed(edges_, 2);
        if (!build(first_)) return;
        // Tetrahedra of a Delaunay triangulation do not overlap; any others may.
        const bool is_valid = first_.check();
        FUZZ_REQUIRE(is_valid || !is_of_delaunay_, "the mesh of the caller");
        locate();
        if (is_valid) refine();
        if (is_valid) improve();
    }

  private:
    std::int64_t count() const { return static_cast<std::int64_t>(xyz_.size() / 3); }
    std::int64_t index() { return in_.byte() % count(); }

    void draw_points() {
        std::vector<Point> points;
        unsigned kind = in_.below(PointSource::bits);
        for (unsigned n = 4 + in_.below(20); n > 0; --n) {
            if (in_.below(8) == 0) kind = in_.below(PointSource::bits);
            points.push_back(source_.draw(in_, kind, points));
        }
        for (const Point& p : points) xyz_.insert(xyz_.end(), p.begin(), p.end());
    }

    // Most tetrahedra of the Delaunay triangulation, with their corners in any order.
    void take_tetrahedra() {
        mgdt_triangulation* t = nullptr;
        FUZZ_REQUIRE(mgdt_create(&t) == MGDT_OK, "create");
        FUZZ_REQUIRE(mgdt_insert_points(t, count(), xyz_.data()) == MGDT_OK, "insert");
        Integers v(static_cast<std::size_t>(4 * mgdt_tetrahedron_count(t)));
        FUZZ_REQUIRE(
            mgdt_get_tetrahedra(t, static_cast<std::int64_t>(v.size()), v.data()) == MGDT_OK,
            "tetrahedra");
        mgdt_destroy(t);
        for (std::size_t i = 0; i < v.size(); i += 4) {
            const unsigned b = in_.byte();
            if (b % 8 == 7) continue;
            std::swap(v[i + (b >> 3 & 3)], v[i + (b >> 5 & 3)]);
            corners_.insert(corners_.end(), &v[i], &v[i] + 4);
        }
    }

    // Faces or edges: mostly of tetrahedra.
    void draw_listed(Integers& list, unsigned width) {
        for (unsigned k = in_.below(4); k > 0 && !corners_.empty(); --k) {
            const std::size_t t = in_.byte() % (corners_.size() / 4);
            const unsigned b = in_.byte();
            for (unsigned i = 0; i < width; ++i)
                list.push_back(b % 16 == 15 ? index() : corners_[4 * t + (b + i) % 4]);
        }
    }

    bool build(const Handle& m) const {
        const auto n = static_cast<std::int64_t>(corners_.size() / 4);
        FUZZ_REQUIRE(mgdt_mesh_set_points(m, count(), xyz_.data()) == MGDT_OK, "points");
        FUZZ_REQUIRE(mgdt_mesh_set_tetrahedra(m, n, corners_.data(), markers_.data()) == MGDT_OK,
                     "tetrahedra");
        FUZZ_REQUIRE(mgdt_mesh_set_faces(m, static_cast<std::int64_t>(faces_.size() / 3),
                                         faces_.data(), nullptr) == MGDT_OK,
                     "faces");
        FUZZ_REQUIRE(mgdt_mesh_set_edges(m, static_cast<std::int64_t>(edges_.size() / 2),
                                         edges_.data(), nullptr) == MGDT_OK,
                     "edges");
        const mgdt_status status = mgdt_mesh_build(m);
        FUZZ_REQUIRE(status == MGDT_OK || status == MGDT_ERR_INVALID_ARGUMENT, "build");
        if (status == MGDT_ERR_INVALID_ARGUMENT)
            FUZZ_REQUIRE(
                !mgdt_tests::message_of(static_cast<mgdt_mesh*>(m), mgdt_mesh_get_error).empty(),
                "a message");
        return status == MGDT_OK;
    }

    // The corners and the middle of a tetrahedron, and any places.
    void locate() {
        std::vector<double> places(xyz_.begin(), xyz_.begin() + 12);
        const Integers v = first_.array(MGDT_MESH_ARRAY_TETRAHEDRA);
        for (std::size_t k = 0; k < 3; ++k) {
            double middle = 0;
            for (std::size_t i = 0; i < 4; ++i)
                middle += xyz_[3 * static_cast<std::size_t>(v[i]) + k] / 4;
            places.push_back(middle);
        }
        const std::size_t n = places.size() / 3;
        Integers found(n), nearest(n);
        std::vector<double> weights(4 * n);
        for (const std::int32_t outside : {MGDT_OUTSIDE_BOUNDARY, MGDT_OUTSIDE_NONE})
            FUZZ_REQUIRE(mgdt_mesh_locate_points(
                             first_, outside, static_cast<std::int64_t>(n), places.data(),
                             outside == MGDT_OUTSIDE_NONE ? found.data() : nearest.data(),
                             weights.data()) == MGDT_OK,
                         "locate");
        for (std::size_t i = 0; i < n; ++i) {
            double sum = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                FUZZ_REQUIRE(weights[4 * i + k] >= 0, "a weight");
                sum += weights[4 * i + k];
            }
            FUZZ_REQUIRE(std::fabs(sum - (found[i] < 0 ? 0 : 1)) < 1e-12, "the sum of weights");
            FUZZ_REQUIRE(nearest[i] >= 0 && (found[i] < 0 || found[i] == nearest[i]), "nearest");
        }
    }

    // Sizes that change between 0 and a size, with jumps.
    struct Waves {
        bool are_asked_for;
        double size, length;
    };
    static std::int32_t find_waves(std::int64_t n, const double* xyz, double* sizes, void* user) {
        const Waves& waves = *static_cast<const Waves*>(user);
        for (std::int64_t i = 0; i < n; ++i) {
            const double place = xyz[3 * i] / waves.length;
            const double wave = std::fabs(place - std::floor(place));
            sizes[i] = wave >= 0 ? waves.size * wave : 0;  // places may be infinite
        }
        return 0;
    }

    // A size: any power of two, or one that fits the mesh, or none.
    double size(double length) {
        switch (in_.below(4)) {
            case 0:
                return 0;
            case 1:
                return std::ldexp(1.0, static_cast<int>(in_.below(2000)) - 1000);
            default:
                return length * (1 + in_.below(16)) / 16;
        }
    }

    void refine() {
        Handle one, other;
        FUZZ_REQUIRE(build(one) && build(other), "the same again");
        const std::map<std::int64_t, double> volumes = one.volumes();
        const std::vector<double> longest = one.measures(MGDT_TETRAHEDRON_LONGEST_EDGE);
        const double length = longest.empty() ? 1 : longest[0];
        const double everywhere = size(length), gradation = in_.below(8) / 4.0,
                     ratio = in_.below(5) / 2.0,
                     volume = in_.below(2) * length * length * length / 64;
        const std::int64_t of_surface = in_.below(2), most = 1 + in_.below(400);
        const auto of = static_cast<std::int32_t>(in_.below(3));
        const std::int32_t counts[3] = {MGDT_MESH_STAT_POINTS, MGDT_MESH_STAT_TETRAHEDRA,
                                        MGDT_MESH_STAT_REGIONS};
        std::vector<double> sizes;
        for (std::int64_t n = one.stat(counts[of]); n > 0; --n) sizes.push_back(size(length));
        // Sizes in space: a field around the mesh, and a function of the first coordinate.
        std::vector<double> field, field_sizes;
        const double unit = length < 1e300 ? length : 1;
        for (unsigned n = in_.below(12); n > 0; --n) {
            for (int k = 0; k < 3; ++k) field.push_back(unit * (in_.below(33) - 16.0) / 8);
            const double there = size(length);
            field_sizes.push_back(there > 0 && there < 1e300 ? there : 1.0);
        }
        Waves waves = {in_.below(2) != 0, unit, unit * (1 + in_.below(64)) / 16};
        const std::int64_t boundary = in_.below(2);
        other.set(MGDT_MESH_OPTION_THREADS, 2);
        mgdt_status status[2];
        int k = 0;
        for (const Handle* m : {&one, &other}) {
            m->set(MGDT_MESH_OPTION_SIZES_OF_SURFACE, of_surface);
            m->set(MGDT_MESH_OPTION_BOUNDARY, boundary);
            m->set(MGDT_MESH_OPTION_MOST_POINTS, most);
            if (everywhere < 1e300) m->set_double(MGDT_MESH_OPTION_SIZE, everywhere);
            m->set_double(MGDT_MESH_OPTION_GRADATION, gradation);
            m->set_double(MGDT_MESH_OPTION_RADIUS_EDGE, ratio);
            if (volume < 1e300) m->set_double(MGDT_MESH_OPTION_VOLUME, volume);
            FUZZ_REQUIRE(mgdt_mesh_set_sizes(*m, of, static_cast<std::int64_t>(sizes.size()),
                                             sizes.data()) == MGDT_OK,
                         "sizes");
            FUZZ_REQUIRE(mgdt_mesh_set_size_field(*m, static_cast<std::int64_t>(field_sizes.size()),
                                                  field.data(), field_sizes.data()) == MGDT_OK,
                         "a field of sizes");
            if (waves.are_asked_for)
                FUZZ_REQUIRE(mgdt_mesh_set_size_function(*m, find_waves, &waves) == MGDT_OK,
                             "a size function");
            status[k++] = mgdt_mesh_refine(*m);
        }
        FUZZ_REQUIRE(status[0] == MGDT_OK && status[1] == MGDT_OK,
                     mgdt_tests::message_of(static_cast<mgdt_mesh*>(one), mgdt_mesh_get_error));
        FUZZ_REQUIRE(one.check(),
                     mgdt_tests::message_of(static_cast<mgdt_mesh*>(one), mgdt_mesh_get_error));
        FUZZ_REQUIRE(one.stat(MGDT_MESH_STAT_INSERTED_POINTS) <= most, "the most points");
        for (const std::int32_t key : {MGDT_MESH_ARRAY_TETRAHEDRA, MGDT_MESH_ARRAY_FACES,
                                       MGDT_MESH_ARRAY_EDGES, MGDT_MESH_ARRAY_REFUSALS})
            FUZZ_REQUIRE(one.array(key) == other.array(key), "threads");
        const std::vector<double> xyz = one.doubles(MGDT_MESH_ARRAY_POINTS);
        FUZZ_REQUIRE(xyz == other.doubles(MGDT_MESH_ARRAY_POINTS), "threads");
        FUZZ_REQUIRE(one.doubles(MGDT_MESH_ARRAY_SIZES) == other.doubles(MGDT_MESH_ARRAY_SIZES),
                     "threads");
        FUZZ_REQUIRE(std::equal(xyz_.begin(), xyz_.end(), xyz.begin()), "points stay");
        if (boundary == MGDT_BOUNDARY_FIXED)
            FUZZ_REQUIRE(one.array(MGDT_MESH_ARRAY_FACE_MARKERS) ==
                             first_.array(MGDT_MESH_ARRAY_FACE_MARKERS),
                         "faces stay");
        double extent = 0;
        for (const double x : xyz_) extent = std::max(extent, std::fabs(x));
        if (!(extent > 1e-90 && extent < 1e90)) return;  // cubes underflow or overflow
        for (const auto& [region, value] : one.volumes())
            FUZZ_REQUIRE(std::fabs(value - volumes.at(region)) <= 1e-9 * extent * extent * extent,
                         "volumes");
    }

    void improve() {
        const std::int64_t goal = in_.below(46), passes = in_.below(4), mean_passes = in_.below(3),
                           boundary = in_.below(2), points = in_.below(3);
        Integers fixed;
        for (unsigned k = in_.below(4); k > 0; --k) fixed.push_back(index());
        Handle second;
        FUZZ_REQUIRE(build(second), "the same again");
        const std::vector<double> before = first_.measures(MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE);
        const std::map<std::int64_t, double> volumes = first_.volumes();
        second.set(MGDT_MESH_OPTION_THREADS, 2);
        for (const Handle* m : {&first_, &second}) {
            m->set(MGDT_MESH_OPTION_GOAL, goal);
            m->set(MGDT_MESH_OPTION_MOST_PASSES, passes);
            m->set(MGDT_MESH_OPTION_MEAN_PASSES, mean_passes);
            m->set(MGDT_MESH_OPTION_BOUNDARY, boundary);
            m->set(MGDT_MESH_OPTION_POINTS, points);
            FUZZ_REQUIRE(mgdt_mesh_set_fixed_points(*m, static_cast<std::int64_t>(fixed.size()),
                                                    fixed.data()) == MGDT_OK,
                         "fixed points");
            FUZZ_REQUIRE(mgdt_mesh_improve(*m) == MGDT_OK, "improve");
        }
        FUZZ_REQUIRE(first_.check(),
                     mgdt_tests::message_of(static_cast<mgdt_mesh*>(first_), mgdt_mesh_get_error));
        for (const std::int32_t key :
             {MGDT_MESH_ARRAY_TETRAHEDRA, MGDT_MESH_ARRAY_FACES, MGDT_MESH_ARRAY_EDGES,
              MGDT_MESH_ARRAY_REASONS, MGDT_MESH_ARRAY_POINT_ORIGINS})
            FUZZ_REQUIRE(first_.array(key) == second.array(key), "threads");
        const std::vector<double> xyz = first_.doubles(MGDT_MESH_ARRAY_POINTS);
        FUZZ_REQUIRE(xyz == second.doubles(MGDT_MESH_ARRAY_POINTS), "threads");
        // Fixed points, and all if they are kept, are where they were.
        for (std::size_t i = 0; i < xyz_.size(); ++i)
            FUZZ_REQUIRE(points != MGDT_POINTS_KEEP || xyz[i] == xyz_[i], "kept points");
        for (const std::int64_t p : fixed)
            for (std::size_t k = 0; k < 3; ++k)
                FUZZ_REQUIRE(xyz[3 * static_cast<std::size_t>(p) + k] ==
                                 xyz_[3 * static_cast<std::size_t>(p) + k],
                             "fixed points");
        // Volumes that are ordinary numbers are kept, but for rounding.
        double size = 0;
        for (const double x : xyz_) size = std::max(size, std::fabs(x));
        if (size > 1e-30 && size < 1e30)
            for (const auto& [marker, volume] : first_.volumes())
                FUZZ_REQUIRE(std::fabs(volume - volumes.at(marker)) <= 1e-9 * size * size * size,
                             "volumes");
        const std::vector<double> after = first_.measures(MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE);
        const double worst = *std::min_element(before.begin(), before.end()),
                     now = *std::min_element(after.begin(), after.end());
        // An obtuse angle counts like an acute one with 0.7 times its sine.
        if (boundary == MGDT_BOUNDARY_FIXED)
            FUZZ_REQUIRE(now >= std::min(0.7 * worst, static_cast<double>(goal) * 0.0174) - 1e-9,
                         "worse");
    }

    Input& in_;
    PointSource source_;
    Handle first_;
    std::vector<double> xyz_;
    Integers corners_, faces_, edges_;
    std::vector<std::int32_t> markers_;
    bool is_of_delaunay_ = false;
};

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    fuzz::Session(in).run();
    return 0;
}
