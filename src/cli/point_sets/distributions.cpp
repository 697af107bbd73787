// SPDX-License-Identifier: MIT
//
// The smooth distributions and the table of all kinds. In the comments u is uniform in [0, 1), d a
// uniform random direction, j uniform in [-w/2, w/2), drawn anew for each coordinate.
#include "cli/point_sets/distributions.hpp"

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "cli/element_mesh.hpp"
#include "cli/point_sets/hostile.hpp"
#include "cli/point_sets/random_points.hpp"
#include "cli/point_sets/refinement.hpp"

namespace mgdt::cli {
namespace {

constexpr double narrow_width = 1e-4;  // w: 0.01 % of the larger dimension
constexpr double wide_width = 1e-2;    // the same for the mixed sets
constexpr double pi = 3.14159265358979323846;

double power_of(double base, double exponent) {
    if (exponent == std::floor(exponent) && exponent >= 0 && exponent <= 64) {
        double result = 1;  // by multiplication, which gives the same bits with every libm
        for (int i = 0; i < static_cast<int>(exponent); ++i) result *= base;
        return result;
    }
    return std::pow(base, exponent);
}

Point jittered(Random& random, Point p, double width) {
    for (double& c : p) c += random.jitter(width);
    return p;
}

// (u, u, u)
Point uniform_point(Random& random, double) {
    return random.uniform_point();
}

// (t, t, t) + j: along the body diagonal of the cube
Point line_point(Random& random, double width) {
    const double t = random.uniform();
    return jittered(random, {t, t, t}, width);
}

// One of the four body diagonals, + j
Point diagonal_point(Random& random, double width) {
    const double t = random.uniform();
    const std::uint64_t which = random.below(4);
    return jittered(random, {t, (which & 1) != 0 ? 1 - t : t, (which & 2) != 0 ? 1 - t : t}, width);
}

// The centre of the cube + semi-axes (1 + j) d
Point ellipsoid_point(Random& random, double width, const Point& axes) {
    const Point d = random.direction();
    Point p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = 0.5 + axes[i] * (1 + random.jitter(width)) * d[i];
    return p;
}

Point ellipse_point(Random& random, double width) {
    return ellipsoid_point(random, width, {0.5, 0.4, 0.3});
}

Point sphere_point(Random& random, double width) {
    return ellipsoid_point(random, width, {0.5, 0.5, 0.5});
}

// t = u: angle 8 pi t, radius .1 + .4 t, height t, + j
Point spiral_point(Random& random, double width) {
    const double t = random.uniform();
    const double angle = 8 * pi * t;
    const double radius = 0.1 + 0.4 * t;
    return jittered(random, {0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), t},
                    width);
}

using MakePoint = Point (*)(Random&, double width);

Points independent(Random& random, std::size_t n, double width, MakePoint make_point) {
    return repeat(n, [&] { return make_point(random, width); });
}

// Every second point is uniform, so that each part of the sequence has both kinds.
Points half_uniform(Random& random, std::size_t n, double width, MakePoint make_point) {
    bool uniform = false;
    return repeat(n, [&] {
        uniform = !uniform;
        return uniform ? random.uniform_point() : make_point(random, width);
    });
}

// .5 + .5 u^power d
Points cluster(Random& random, std::size_t n, double power) {
    return repeat(n, [&] {
        const double radius = 0.5 * power_of(random.uniform(), power);
        const Point d = random.direction();
        return Point{0.5 + d[0] * radius, 0.5 + d[1] * radius, 0.5 + d[2] * radius};
    });
}

// 60 clusters at random centres. The radius is .002 * 10^u, the population is proportional to u^2,
// and the distance of a point from the centre is radius * u^power, flattened by .3 in z.
Points galaxy(Random& random, std::size_t n, double power) {
    constexpr std::size_t count = 60;
    constexpr double flattening = 0.3;
    struct Cluster {
        Point centre;
        double radius;
        double population_up_to_here;
    };
    std::array<Cluster, count> clusters;
    double total = 0;
    for (Cluster& c : clusters) {
        c.centre = random.uniform_point();
        c.radius = 0.002 * std::pow(10.0, random.uniform());
        const double u = random.uniform();
        total += u * u;
        c.population_up_to_here = total;
    }
    return repeat(n, [&] {
        const double drawn = random.uniform() * total;
        std::size_t which = 0;
        while (which + 1 < count && clusters[which].population_up_to_here <= drawn) ++which;
        const Cluster& c = clusters[which];
        const double r = c.radius * power_of(random.uniform(), power);
        const Point d = random.direction();
        return Point{c.centre[0] + r * d[0], c.centre[1] + r * d[1],
                     c.centre[2] + flattening * r * d[2]};
    });
}

// Where the meshes are refined: the mouth of the oil hole in the bore of docs/data/machine.geo, and
// the pier between the nave and the crossing of docs/data/church.geo, below the springing of its
// arch. The radii make sets as mild as the paper says of its own (Table 9): its regular grid has
// cells of some hundred times the mean, and walks as far in them as the multi-grid does.
constexpr Focus oil_hole{{0, 0, 103}, 25};
constexpr Focus pier{{29, 5.5, 3}, 8};

struct Request {
    Random& random;
    std::size_t n;
    const GenerateOptions& options;
    std::string data_path;

    double width(double own) const { return options.width != 0 ? options.width : own; }
    double power(double own) const { return options.power != 0 ? options.power : own; }
};

template <MakePoint make_point>
Points narrow(const Request& r) {
    return independent(r.random, r.n, r.width(narrow_width), make_point);
}

template <MakePoint make_point>
Points mixed(const Request& r) {
    return half_uniform(r.random, r.n, r.width(wide_width), make_point);
}

template <Points (*make_points)(Random&, std::size_t)>
Points hard(const Request& r) {
    return make_points(r.random, r.n);
}

template <const Focus& focus>
Points refined(const Request& r) {
    return refine(read_element_mesh(r.data_path), focus, r.n);
}

struct Kind {
    Distribution distribution;
    Points (*make)(const Request&);
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all{
        {{"uniform", "uniform in the unit cube"}, narrow<uniform_point>},
        {{"line", "along a body diagonal of the cube, width 1e-4"}, narrow<line_point>},
        {{"diagonal", "along the four body diagonals, width 1e-4"}, narrow<diagonal_point>},
        {{"ellipse", "near an ellipsoid of semi-axes .5, .4, .3, width 1e-4"},
         narrow<ellipse_point>},
        {{"sphere", "near a sphere of radius .5, width 1e-4"}, narrow<sphere_point>},
        {{"spiral", "along a conical spiral of four turns, width 1e-4"}, narrow<spiral_point>},
        {{"cluster", "crowded at the centre, distance .5 u^5"},
         [](const Request& r) { return cluster(r.random, r.n, r.power(5)); }},
        {{"galaxy", "60 flat clusters of different sizes and populations, distance u^2"},
         [](const Request& r) { return galaxy(r.random, r.n, r.power(2)); }},
        {{"mixdiag", "half uniform, half along the diagonals, width 1e-2"}, mixed<diagonal_point>},
        {{"mixsphere", "half uniform, half near the sphere, width 1e-2"}, mixed<sphere_point>},
        {{"mixspiral", "half uniform, half along the spiral, width 1e-2"}, mixed<spiral_point>},
        {{"machine", "nodes of a finite-element mesh of a bearing bracket, locally refined",
          "machine.msh"},
         refined<oil_hole>},
        {{"church", "nodes of a finite-element mesh of a church, locally refined", "church.msh"},
         refined<pier>},
        {{"lattice", "integer points of a cube"}, hard<hostile::lattice>},
        {{"integer-sphere", "integer points of the sphere of radius 1105 (6630 at most)"},
         hard<hostile::integer_sphere>},
        {{"moment-curve", "on the curve (t, t^2, t^3): quadratic size"},
         hard<hostile::moment_curve>},
        {{"two-lines", "on two skew lines: quadratic size"}, hard<hostile::two_lines>},
        {{"rounded", "uniform, rounded to multiples of 1/1024"}, hard<hostile::rounded>},
        {{"lattice-repeats", "from a 20^3 lattice, with repeats"}, hard<hostile::lattice_repeats>},
        {{"coplanar", "on an oblique plane, exactly"}, hard<hostile::coplanar>},
        {{"collinear", "on an oblique line, exactly"}, hard<hostile::collinear>},
        {{"one-point", "one point, repeated"}, hard<hostile::one_point>},
        {{"anisotropic", "uniform in a box of 1e6 by 1 by 1e-6"}, hard<hostile::anisotropic>},
        {{"nan", "uniform, with one NaN"}, hard<hostile::nan>},
        {{"infinity", "uniform, with one infinity"}, hard<hostile::infinity>},
    };
    return all;
}

const Kind* find_kind(const std::string& name) {
    for (const Kind& k : kinds()) {
        if (name == k.distribution.name) return &k;
    }
    return nullptr;
}

}  // namespace

const std::vector<Distribution>& distributions() {
    static const std::vector<Distribution> all = [] {
        std::vector<Distribution> list;
        for (const Kind& kind : kinds()) list.push_back(kind.distribution);
        return list;
    }();
    return all;
}

std::string data_path(const std::string& name, const std::string& data_directory) {
    const Kind* const kind = find_kind(name);
    if (kind == nullptr || kind->distribution.data_file == nullptr) return "";
    return (data_directory.empty() ? "." : data_directory) + "/" + kind->distribution.data_file;
}

std::vector<double> generate(const std::string& name, std::size_t n,
                             const GenerateOptions& options) {
    const Kind* const kind = find_kind(name);
    if (kind == nullptr) {
        std::string message = "unknown kind of points '" + name + "'; known are";
        for (const Kind& k : kinds()) message += std::string(" ") + k.distribution.name;
        throw std::invalid_argument(message);
    }
    Random random(options.seed);
    const Points points = kind->make({random, n, options, data_path(name, options.data_directory)});
    std::vector<double> xyz;
    xyz.reserve(3 * points.size());
    for (const Point& p : points) {
        for (const double c : p) xyz.push_back(c * options.scale);
    }
    return xyz;
}

}  // namespace mgdt::cli
