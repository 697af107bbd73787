// SPDX-License-Identifier: MIT
#include "sweep_families.hpp"

#include <array>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "../faults/degenerate_sets.hpp"
#include "../support/points.hpp"
#include "../unit/point_families.hpp"
#include "cli/point_sets/distributions.hpp"

namespace bench {
namespace {

using families::Random;
using mgdt_tests::Points;

constexpr double pi = 3.14159265358979323846;
constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max();
/// Of sets whose number of tetrahedra is quadratic in the number of points.
constexpr std::size_t quadratic = 1000;

void add(Points& xyz, double x, double y, double z) {
    xyz.insert(xyz.end(), {x, y, z});
}

/// The points in a random order, as a program may have them that reads a file.
Points shuffled(const Points& xyz) {
    std::vector<std::size_t> order(xyz.size() / 3);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::mt19937_64 random(11);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    Points out;
    for (const std::size_t i : order) add(out, xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]);
    return out;
}

Points generated(const std::string& kind, std::size_t n, double scale = 1) {
    mgdt::cli::GenerateOptions options;
    options.scale = scale;
    return mgdt::cli::generate(kind, n, options);
}

/// Uniform points of which each is changed by f(point, random).
template <class F>
Points changed_uniform(std::size_t n, F f) {
    Points xyz = generated("uniform", n);
    Random random(3);
    for (std::size_t i = 0; i < xyz.size(); i += 3) f(&xyz[i], random);
    return xyz;
}

Points scaled(Points xyz, double x, double y, double z) {
    for (std::size_t i = 0; i < xyz.size(); i += 3) {
        xyz[i] *= x;
        xyz[i + 1] *= y;
        xyz[i + 2] *= z;
    }
    return xyz;
}

/// Copies of a segment of an axis inside a ring: each of its edges makes a tetrahedron with each
/// edge of the ring.
Points fans(std::size_t n, std::size_t copies, bool is_one_after_another) {
    const std::size_t each = n / copies, on_line = each / 2, on_ring = each - on_line;
    Points xyz;
    const auto put = [&](std::size_t copy, std::size_t i) {
        const double shift = 10 * static_cast<double>(copy);
        if (i < on_line) {
            const double t = static_cast<double>(i) / static_cast<double>(on_line);
            add(xyz, shift, 0, 0.2 * (t - 0.5));
        } else {
            const double t = static_cast<double>(i - on_line) / static_cast<double>(on_ring);
            add(xyz, shift + std::cos(2 * pi * t), std::sin(2 * pi * t), 0);
        }
    };
    if (is_one_after_another)
        for (std::size_t k = 0; k < copies * each; ++k) put(k / each, k % each);
    else
        for (std::size_t k = 0; k < copies * each; ++k) put(k % copies, k / copies);
    return xyz;
}

/// A segment of an axis inside a ring, so many points on the segment, the others on the ring.
Points fan(std::size_t on_line, std::size_t on_ring) {
    Points xyz;
    for (std::size_t i = 0; i < on_line; ++i)
        add(xyz, 0, 0, 0.2 * static_cast<double>(i) / static_cast<double>(on_line) - 0.1);
    for (std::size_t i = 0; i < on_ring; ++i) {
        const double t = 2 * pi * static_cast<double>(i) / static_cast<double>(on_ring);
        add(xyz, std::cos(t), std::sin(t), 0);
    }
    return xyz;
}

/// Two linked circles.
Points linked_circles(std::size_t n) {
    Points xyz;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = 2 * pi * static_cast<double>(i / 2) / static_cast<double>(n / 2);
        if (i % 2 == 0)
            add(xyz, std::cos(t), std::sin(t), 0);
        else
            add(xyz, 1 + std::cos(t), 0, std::sin(t));
    }
    return xyz;
}

/// Regular grids on parallel planes.
Points grids_on_planes(std::size_t n, std::size_t planes) {
    const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n / planes)));
    Points xyz;
    for (std::size_t p = 0; p < planes; ++p)
        for (std::size_t i = 0; i < side * side; ++i)
            add(xyz, static_cast<double>(i / side), static_cast<double>(i % side),
                static_cast<double>(p * side));
    return xyz;
}

/// Uniform points of a square and points far above and below it, each of which has an edge to
/// most of the others.
Points plane_and_apexes(std::size_t n, bool is_grid, double noise) {
    Points xyz = is_grid ? grids_on_planes(n - 2, 1) : generated("uniform", n - 2);
    const double size = is_grid ? std::sqrt(static_cast<double>(n)) : 1;
    Random random(4);
    for (std::size_t i = 0; i < xyz.size(); i += 3) xyz[i + 2] = noise * random.uniform();
    add(xyz, size / 2, size / 2, 10 * size);
    add(xyz, size / 2, size / 2, -10 * size);
    return xyz;
}

/// Points of a sphere and some near its centre.
Points sphere_and_centre(std::size_t n, std::size_t centres, bool is_centre_first) {
    Random random(5);
    Points centre, sphere;
    add(centre, 0, 0, 0);
    for (std::size_t i = 1; i < centres; ++i) {
        const auto d = random.direction();
        add(centre, 0.01 * d[0], 0.01 * d[1], 0.01 * d[2]);
    }
    for (std::size_t i = centres; i < n; ++i) {
        const auto d = random.direction();
        add(sphere, d[0], d[1], d[2]);
    }
    Points& first = is_centre_first ? centre : sphere;
    const Points& last = is_centre_first ? sphere : centre;
    first.insert(first.end(), last.begin(), last.end());
    return first;
}

/// A regular mesh of a surface given by two parameters.
template <class Surface>
Points surface(std::size_t n, Surface point) {
    const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
    Points xyz;
    for (std::size_t i = 0; i < side * side; ++i) {
        const std::array<double, 3> p =
            point(static_cast<double>(i / side) / static_cast<double>(side),
                  static_cast<double>(i % side) / static_cast<double>(side));
        add(xyz, p[0], p[1], p[2]);
    }
    return xyz;
}

/// Corners and centres of the faces of boxes, each half of the one around it.
Points nested_powers(std::size_t n, bool is_jittered) {
    Points xyz;
    Random random(6);
    for (std::size_t i = 0; i < n; ++i) {
        const double size = std::ldexp(1.0, -static_cast<int>(i / 8 % 900));
        double p[3];
        for (unsigned k = 0; k < 3; ++k) {
            p[k] = (i >> k & 1) != 0 ? size : -size;
            if (is_jittered) p[k] *= 1 + random.uniform(0, 0.1);
        }
        add(xyz, p[0], p[1], p[2]);
    }
    return xyz;
}

/// The five points of a family of tests/unit/point_families.hpp over and over.
Points fives(const families::Family& family, std::size_t n) {
    Random random(7);
    Points xyz;
    while (xyz.size() < 3 * n)
        for (const auto& p : family.make(random)) add(xyz, p[0], p[1], p[2]);
    return xyz;
}

void add_generated(std::vector<Family>& all) {
    for (const mgdt::cli::Distribution& d : mgdt::cli::distributions()) {
        const std::string kind = d.name;
        // Those without points for anybody, or that want files.
        if (kind == "nan" || kind == "infinity" || kind == "one-point" || kind == "machine" ||
            kind == "church")
            continue;
        const bool is_quadratic = kind == "two-lines" || kind == "moment-curve";
        all.push_back({kind, [kind](std::size_t n) { return generated(kind, n); },
                       is_quadratic ? quadratic : any_size});
    }
    for (const char* kind : {"uniform", "lattice", "galaxy"})
        for (const double scale : {1e300, 1e-300, 0x1p-1050})
            all.push_back(
                {std::string(kind) + " times " + std::to_string(std::ilogb(scale)) + " bits",
                 [=](std::size_t n) { return generated(kind, n, scale); }, any_size});
}

void add_hard(std::vector<Family>& all) {
    for (const families::Family& family : families::all())
        all.push_back({"fives, " + family.name,
                       [&family](std::size_t n) { return fives(family, n); }, any_size});
    const auto put = [&](const char* name, Points (*points)(std::size_t), std::size_t most) {
        all.push_back({name, points, most});
    };
    put("any doubles", faults::any_doubles, any_size);
    put(
        "exponents of 100 bits",
        [](std::size_t n) { return faults::exponent_spread(n, 100, false); }, any_size);
    put(
        "exponents of 600 bits",
        [](std::size_t n) { return faults::exponent_spread(n, 600, false); }, any_size);
    put(
        "powers of two, 40 bits",
        [](std::size_t n) { return faults::exponent_spread(n, 40, true); }, any_size);
    put(
        "powers of two, 2000 bits",
        [](std::size_t n) { return faults::exponent_spread(n, 2000, true); }, any_size);
    put("ends of range", faults::ends_of_range, any_size);
    put(
        "two clusters, 1e6 apart", [](std::size_t n) { return faults::two_clusters(n, 1e6); },
        any_size);
    put(
        "two clusters, 1e100 apart", [](std::size_t n) { return faults::two_clusters(n, 1e100); },
        any_size);
    put("subnormals and units", faults::subnormals_and_units, any_size);
    put("layers", faults::layers, any_size);
    put("helix", faults::helix, quadratic);
    put(
        "integer sphere, 77220 points",
        [](std::size_t n) { return faults::integer_sphere(n, 4389); }, any_size);
}

void add_anisotropic(std::vector<Family>& all) {
    const auto put = [&](const char* name, Points (*points)(std::size_t)) {
        all.push_back({name, points, any_size});
    };
    put("z by 1e-300", [](std::size_t n) { return scaled(generated("uniform", n), 1, 1, 1e-300); });
    put("z by 1e-100", [](std::size_t n) { return scaled(generated("uniform", n), 1, 1, 1e-100); });
    put("z by 1e-30", [](std::size_t n) { return scaled(generated("uniform", n), 1, 1, 1e-30); });
    put("z by 1e-15", [](std::size_t n) { return scaled(generated("uniform", n), 1, 1, 1e-15); });
    put("x by 1e150, z by 1e-150",
        [](std::size_t n) { return scaled(generated("uniform", n), 1e150, 1, 1e-150); });
    put("y and z by 1e-150",
        [](std::size_t n) { return scaled(generated("uniform", n), 1, 1e-150, 1e-150); });
    put("lattice, z by 1e-200",
        [](std::size_t n) { return scaled(generated("lattice", n), 1, 1, 1e-200); });
    put("half of z at 1e-310", [](std::size_t n) {
        return changed_uniform(n, [](double* p, Random& r) {
            if (r.integer(0, 1)) p[2] *= 1e-310;
        });
    });
    put("terrain, z = -DBL_MAX where there is none", [](std::size_t n) {
        return changed_uniform(n, [](double* p, Random& r) {
            p[2] = r.integer(0, 19) ? 0.01 * std::sin(20 * p[0]) * std::cos(30 * p[1]) : -DBL_MAX;
        });
    });
    put("a tenth of z at 1e300", [](std::size_t n) {
        return changed_uniform(n, [](double* p, Random& r) {
            if (r.integer(0, 9) == 0) p[2] = 1e300;
        });
    });
    put("one point at 1e300", [](std::size_t n) {
        Points xyz = generated("uniform", n);
        xyz[0] = 1e300;
        return xyz;
    });
    put("one point at 1e30", [](std::size_t n) {
        Points xyz = generated("uniform", n);
        xyz[0] = 1e30;
        return xyz;
    });
    put("one point at 1e10", [](std::size_t n) {
        Points xyz = generated("uniform", n);
        xyz[0] = 1e10;
        return xyz;
    });
    put("corners of a box of 1e200", [](std::size_t n) {
        Points xyz = generated("uniform", n);
        for (std::size_t i = 0; i < 24; ++i) xyz[i] = (i / 3 >> i % 3 & 1) != 0 ? 1e200 : -1e200;
        return xyz;
    });
    put("one coordinate of 1e-200", [](std::size_t n) {
        Points xyz = generated("uniform", n);
        xyz[4] = 1e-200;
        return xyz;
    });
    put("slab, z by 1e-6",
        [](std::size_t n) { return scaled(generated("uniform", n), 1, 1, 1e-6); });
    put("far from the origin", [](std::size_t n) {
        return changed_uniform(n, [](double* p, Random&) {
            for (unsigned k = 0; k < 3; ++k) p[k] += 1e9;
        });
    });
}

void add_hubs(std::vector<Family>& all) {
    const auto put = [&](const char* name, Points (*points)(std::size_t),
                         std::size_t most = any_size) {
        all.push_back({name, points, most});
    };
    put(
        "fan", [](std::size_t n) { return fans(n, 1, true); }, quadratic);
    for (const bool is_shuffled : {false, true}) {
        const std::string order = is_shuffled ? ", shuffled" : "";
        all.push_back({"fan, 40 on the line" + order,
                       [=](std::size_t n) {
                           const Points xyz = fan(40, n - 40);
                           return is_shuffled ? shuffled(xyz) : xyz;
                       },
                       20 * quadratic});
        all.push_back({"fan, 40 on the ring" + order,
                       [=](std::size_t n) {
                           const Points xyz = fan(n - 40, 40);
                           return is_shuffled ? shuffled(xyz) : xyz;
                       },
                       20 * quadratic});
    }
    put(
        "fan, shuffled", [](std::size_t n) { return shuffled(fans(n, 1, true)); }, quadratic);
    put(
        "fans, 40", [](std::size_t n) { return fans(n, 40, true); }, 20 * quadratic);
    put(
        "fans, 40, in turns", [](std::size_t n) { return fans(n, 40, false); }, 20 * quadratic);
    put(
        "fans, 40, shuffled", [](std::size_t n) { return shuffled(fans(n, 40, false)); },
        20 * quadratic);
    put("fans of 40 points", [](std::size_t n) { return shuffled(fans(n, n / 40 + 1, false)); });
    put("linked circles", linked_circles, quadratic);
    put("moment curve in order", faults::moment_curve, quadratic);
    put("plane and two apexes", [](std::size_t n) { return plane_and_apexes(n, false, 0); });
    put("grid and two apexes", [](std::size_t n) { return plane_and_apexes(n, true, 0); });
    put("rough plane and two apexes",
        [](std::size_t n) { return plane_and_apexes(n, false, 1e-3); });
    put("sphere, then its centre", [](std::size_t n) { return sphere_and_centre(n, 1, false); });
    put("centre, then its sphere", [](std::size_t n) { return sphere_and_centre(n, 1, true); });
    put("sphere and ten inside",
        [](std::size_t n) { return shuffled(sphere_and_centre(n, 10, true)); });
    put("grids on two planes", [](std::size_t n) { return grids_on_planes(n, 2); });
    put("grids on ten planes", [](std::size_t n) { return grids_on_planes(n, 10); });
    put("cone and its axis", [](std::size_t n) {
        return surface(n, [](double s, double t) -> std::array<double, 3> {
            return {s * std::cos(2 * pi * t), s * std::sin(2 * pi * t), s};
        });
    });
    put("cylinder", [](std::size_t n) {
        return surface(n, [](double s, double t) -> std::array<double, 3> {
            return {std::cos(2 * pi * t), std::sin(2 * pi * t), s};
        });
    });
    put(
        "cylinder and its axis",
        [](std::size_t n) {
            Points xyz = surface(n, [](double s, double t) -> std::array<double, 3> {
                return {std::cos(2 * pi * t), std::sin(2 * pi * t), 4 * s};
            });
            for (std::size_t i = 0; i < n / 10; ++i)
                add(xyz, 0, 0, 40 * static_cast<double>(i) / static_cast<double>(n));
            return xyz;
        },
        5 * quadratic);
    put("torus", [](std::size_t n) {
        return surface(n, [](double s, double t) -> std::array<double, 3> {
            const double r = 2 + std::cos(2 * pi * s);
            return {r * std::cos(2 * pi * t), r * std::sin(2 * pi * t), std::sin(2 * pi * s)};
        });
    });
    put("paraboloid", [](std::size_t n) {
        return changed_uniform(n, [](double* p, Random&) { p[2] = p[0] * p[0] + p[1] * p[1]; });
    });
    put("sphere of latitudes", [](std::size_t n) {
        return surface(n, [](double s, double t) -> std::array<double, 3> {
            return {std::sin(pi * s) * std::cos(2 * pi * t),
                    std::sin(pi * s) * std::sin(2 * pi * t), std::cos(pi * s)};
        });
    });
    put("concentric spheres", [](std::size_t n) {
        Random random(8);
        Points xyz;
        for (std::size_t i = 0; i < n; ++i) {
            const auto d = random.direction();
            const double r = static_cast<double>(1 + i % 10);
            add(xyz, r * d[0], r * d[1], r * d[2]);
        }
        return xyz;
    });
    put("rod with tags", [](std::size_t n) {
        Points xyz;
        for (std::size_t i = 0; i < n; ++i)
            add(xyz, static_cast<double>(i), 0.1 * static_cast<double>(i % 7),
                0.1 * static_cast<double>(i % 5));
        return xyz;
    });
    put("line and two points beside it", [](std::size_t n) {
        Points xyz;
        for (std::size_t i = 2; i < n; ++i) add(xyz, static_cast<double>(i), 0, 0);
        add(xyz, 1, 1, 0);
        add(xyz, 1, 0, 1);
        return xyz;
    });
    put(
        "geometric progressions on axes",
        [](std::size_t n) {
            Points xyz;
            for (std::size_t i = 0; i < n; ++i) {
                double p[3] = {0, 0, 0};
                p[i % 3] =
                    std::pow(1.0 + 60.0 / static_cast<double>(n), static_cast<double>(i / 3));
                add(xyz, p[0], p[1], p[2]);
            }
            return xyz;
        },
        3 * quadratic);
    put(
        "nested powers of two", [](std::size_t n) { return nested_powers(n, false); }, 7200);
    put(
        "nested powers of two, jittered", [](std::size_t n) { return nested_powers(n, true); },
        7200);
}

void add_lattices(std::vector<Family>& all) {
    const auto put = [&](const char* name, Points (*points)(std::size_t)) {
        all.push_back({name, points, any_size});
    };
    put("lattice of spacing 0.1", [](std::size_t n) { return generated("lattice", n, 0.1); });
    put("lattice of spacing 1/3, shuffled",
        [](std::size_t n) { return shuffled(generated("lattice", n, 1.0 / 3)); });
    put("lattice, shuffled", [](std::size_t n) { return shuffled(generated("lattice", n)); });
    put("lattice, face-centred", [](std::size_t n) {
        Points xyz = generated("lattice", 2 * n), out;
        for (std::size_t i = 0; i < xyz.size(); i += 3)
            if (static_cast<int>(xyz[i] + xyz[i + 1] + xyz[i + 2]) % 2 == 0)
                add(out, xyz[i], xyz[i + 1], xyz[i + 2]);
        return out;
    });
    put("nine repeats of ten", [](std::size_t n) {
        Points xyz = generated("uniform", n);
        for (std::size_t i = n / 10 * 3; i < xyz.size(); ++i) xyz[i] = xyz[i % (n / 10 * 3)];
        return xyz;
    });
    put("ten points, repeated", [](std::size_t n) {
        Points xyz = generated("uniform", n);
        for (std::size_t i = 30; i < xyz.size(); ++i) xyz[i] = xyz[i % 30];
        return xyz;
    });
    put("sorted by x", [](std::size_t n) {
        Points xyz = generated("uniform", n);
        for (std::size_t i = 0; i < xyz.size(); i += 3)
            xyz[i] = static_cast<double>(i) / static_cast<double>(xyz.size());
        return xyz;
    });
}

}  // namespace

std::vector<Family> sweep_families() {
    std::vector<Family> all;
    add_generated(all);
    add_hard(all);
    add_anisotropic(all);
    add_hubs(all);
    add_lattices(all);
    return all;
}

}  // namespace bench
