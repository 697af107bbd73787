// SPDX-License-Identifier: MIT
#include "dual/volume_pass.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "dual/cell_measures.hpp"
#include "parallel/watched_split.hpp"
#include "predicates/circumcenter.hpp"

namespace mgdt {
namespace {

constexpr int least_exponent = -500;
// Volumes are summed as integers, in units of 2^-60 of the cube of the longest edge at the vertex,
// rounded up to a power of two; errors are in units of 2^-66. Sums do not overflow if no part
// exceeds 1/32 of that cube, since 255 parts do not exceed 8 cubes then.
constexpr int sum_bits = 60, error_bits = 66;
constexpr std::uint32_t most_parts = 255;
constexpr double most_units = 0x1p55, most_error = 0x1p50;

using V = Vector<double>;

// Operations on a number that several threads may change. With one thread no atomic
// read-modify-write is used, because it would double the time.
template <bool alone>
struct Update {
    template <class T>
    static void raise(Atomic<T>& to, T value) {
        T known = to.load(std::memory_order_relaxed);
        if (alone) {
            if (known < value) to.store(value, std::memory_order_relaxed);
            return;
        }
        while (known < value &&
               !to.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
        }
    }
    template <class T>
    static void add(Atomic<T>& to, T value) {
        if (alone)
            to.store(to.load(std::memory_order_relaxed) + value, std::memory_order_relaxed);
        else
            to.fetch_add(value, std::memory_order_relaxed);
    }
};

double power_of_two(int exponent) {
    const std::uint64_t bits = static_cast<std::uint64_t>(exponent + 1023) << 52;
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

int exponent_of(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return static_cast<int>(bits >> 52 & 0x7FF) - 1023;
}

// The parts that a facet contributes to its three corners. pp, qq and rr are the squared lengths of
// the edges opposite the corners. `normal` is the cross product of two edges, and `height` is the
// height of the circumcentre over the facet times the length of `normal`. This length is at most
// 0.29 times the sum of the squares.
struct FacetParts {
    double part[3], error;
};
MGDT_ALWAYS_INLINE FacetParts facet_parts(double pp, double qq, double rr, const V& normal,
                                          double height, double center_error, double radius) {
    const double sum = pp + qq + rr;
    const double p = pp * ((qq + rr) - pp), q = qq * ((rr + pp) - qq), r = rr * ((pp + qq) - rr);
    const double inverse = 1 / dot(normal, normal), factor = 1.0 / 48 * inverse,
                 by_height = factor * height;
    const double terms = std::fabs(p) + std::fabs(q) + std::fabs(r), square = sum * sum;
    return {
        {(q + r) * by_height, (r + p) * by_height, (p + q) * by_height},
        factor * (std::fabs(height) * (16 * rounding_of<double> * square +
                                       terms * rounding_of<double> * (2 * square * inverse + 12)) +
                  terms * sum * (0.29 * center_error + 5 * rounding_of<double> * radius))};
}

}  // namespace

MGDT_ALWAYS_INLINE VolumePass::Parts VolumePass::parts_of(const Mesh& mesh, const Tetrahedron& t) {
    Parts result;
    std::uint32_t index[4];
    for (unsigned i = 0; i < 4; ++i) {
        result.v[i] = t.v[i];
        index[i] = mesh.vertices[t.v[i]].index;
    }
    bool is_odd = false;
    const auto order = [&](unsigned i, unsigned j) {
        const bool swaps = index[j] < index[i];
        const std::uint32_t least = swaps ? index[j] : index[i], most = swaps ? index[i] : index[j];
        const VertexId a = swaps ? result.v[j] : result.v[i], b = swaps ? result.v[i] : result.v[j];
        index[i] = least, index[j] = most, result.v[i] = a, result.v[j] = b;
        is_odd ^= swaps;
    };
    order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
    const double *const p0 = mesh.point(result.v[0]), *const p1 = mesh.point(result.v[1]),
                        *const p2 = mesh.point(result.v[2]), *const p3 = mesh.point(result.v[3]);
    const double sign = is_odd ? -1 : 1;
    const V a = difference<double>(p1, p0), b = difference<double>(p2, p0),
            c = difference<double>(p3, p0), ab = difference<double>(p2, p1),
            ac = difference<double>(p3, p1), bc = difference<double>(p3, p2);
    const V A = cross(b, c), B = cross(c, a), C = cross(a, b), D = cross(ab, ac);
    const double aa = dot(a, a), bb = dot(b, b), cc = dot(c, c), abab = dot(ab, ab),
                 acac = dot(ac, ac), bcbc = dot(bc, bc);
    const double det = sign * dot(a, A), a_size = std::sqrt(aa), b_size = std::sqrt(bb),
                 c_size = std::sqrt(cc), product = a_size * b_size * c_size;
    V x;
    double error = -1;
    if (det > 1024 * rounding_of<double> * product) {
        const double inverse = sign * 0.5 / det;
        for (int k = 0; k < 3; ++k) x.x[k] = ((aa * A.x[k] + bb * B.x[k]) + cc * C.x[k]) * inverse;
        result.radius = length(x);
        error = rounding_of<double> * (product / det) *
                (10.5 * (a_size + b_size + c_size) + 16 * result.radius);
    }
    if (!(error >= 0) || error > 400 * rounding_of<double> * result.radius) {
        double offset[3];
        center_offset({p0, p1, is_odd ? p3 : p2, is_odd ? p2 : p3}, offset);
        x = {{offset[0], offset[1], offset[2]}};
        result.radius = length(x);
        error = 2 * center_offset_error * result.radius;
    }
    const V y = x - a;
    const double radius = result.radius;
    const FacetParts opposite_c = facet_parts(abab, bb, aa, C, sign * dot(x, C), error, radius),
                     opposite_b = facet_parts(acac, cc, aa, B, sign * dot(x, B), error, radius),
                     opposite_a = facet_parts(bcbc, cc, bb, A, sign * dot(x, A), error, radius),
                     opposite_d =
                         facet_parts(bcbc, acac, abab, D, -sign * dot(y, D), error, radius);
    result.volume[0] = (opposite_c.part[0] + opposite_b.part[0]) + opposite_a.part[0];
    result.volume[1] = (opposite_c.part[1] + opposite_b.part[1]) + opposite_d.part[0];
    result.volume[2] = (opposite_c.part[2] + opposite_a.part[1]) + opposite_d.part[1];
    result.volume[3] = (opposite_b.part[2] + opposite_a.part[2]) + opposite_d.part[2];
    result.error = (opposite_a.error + opposite_b.error) + (opposite_c.error + opposite_d.error);
    // Outside this range, numbers may have overflowed or underflowed.
    constexpr double shortest = 0x1p-100, longest = 0x1p100;
    const auto is_long = [](double square) { return square > shortest * shortest; };
    result.is_known = is_long(aa) && is_long(bb) && is_long(cc) && is_long(abab) && is_long(acac) &&
                      is_long(bcbc) && result.radius < longest && result.error < longest;
    return result;
}

template <bool alone>
void VolumePass::set_exponents(const Mesh& mesh, std::size_t begin, std::size_t end) {
    constexpr std::size_t ahead = 8;
    for (std::size_t id = begin; id < end; ++id) {
        const Tetrahedron& t = mesh.tetrahedra[id];
        mesh.tetrahedra.prefetch(id + ahead);
        if (t.is_dead()) continue;
        if (t.is_ghost()) {
            for (const VertexId v : t.v) flags_[v].fetch_or(on_hull, std::memory_order_relaxed);
            continue;
        }
        const auto square = [&](unsigned i, unsigned j) {
            const V d = difference<double>(mesh.point(t.v[i]), mesh.point(t.v[j]));
            return dot(d, d);
        };
        const double ab = square(0, 1), ac = square(0, 2), ad = square(0, 3), bc = square(1, 2),
                     bd = square(1, 3), cd = square(2, 3);
        const double longest[4] = {std::max(std::max(ab, ac), ad), std::max(std::max(ab, bc), bd),
                                   std::max(std::max(ac, bc), cd), std::max(std::max(ad, bd), cd)};
        for (unsigned i = 0; i < 4; ++i) {
            Update<alone>::raise(exponents_[t.v[i]], exponent_of(longest[i]) - least_exponent);
            Update<alone>::add(counts_[t.v[i]], 1u);
        }
    }
}

// An exponent e such that the cube of the longest edge at v is less than 2^e.
int VolumePass::exponent(VertexId v) {
    const int of_square = exponents_[v].load(std::memory_order_relaxed) + least_exponent + 1;
    return (3 * of_square + 1) >> 1;
}

template <bool alone>
void VolumePass::add(const Mesh& mesh, std::size_t begin, std::size_t end) {
    constexpr std::size_t ahead = 8;
    for (std::size_t id = begin; id < end; ++id) {
        const Tetrahedron& t = mesh.tetrahedra[id];
        mesh.tetrahedra.prefetch(id + ahead);
        if (t.is_dead() || t.is_ghost()) continue;
        const Parts parts = parts_of(mesh, t);
        const float radius = static_cast<float>(std::min(parts.radius * (1 + 0x1p-20), 0x1p126));
        std::uint32_t bits;
        std::memcpy(&bits, &radius, sizeof bits);
        for (unsigned i = 0; i < 4; ++i) {
            const VertexId v = parts.v[i];
            Update<alone>::raise(radii_[v], bits);
            // The exponent is limited, so that the power of two is in the range of doubles.
            const int least = exponent(v);
            const bool is_known = parts.is_known && least > -400 && least < 400;
            const double one = is_known ? power_of_two(sum_bits - least) : 1;
            const double units = parts.volume[i] * one,
                         error = parts.error * one * (1 << (error_bits - sum_bits));
            if (!is_known || !(std::fabs(units) < most_units) || !(error < most_error)) {
                flags_[v].fetch_or(is_lost, std::memory_order_relaxed);
                continue;
            }
            Update<alone>::add(sums_[v], static_cast<std::int64_t>(units));
            Update<alone>::add(errors_[v], static_cast<std::int64_t>(error));
        }
    }
}

VolumePass::VolumePass(const MeshView& view, StageProgress& progress)
    : exponents_(view.allocator, view.mesh.vertices.size()),
      radii_(view.allocator, view.mesh.vertices.size()),
      flags_(view.allocator, view.mesh.vertices.size()),
      counts_(view.allocator, view.mesh.vertices.size()),
      sums_(view.allocator, view.mesh.vertices.size()),
      errors_(view.allocator, view.mesh.vertices.size()) {
    if (view.team.size() == 1)
        run<true>(view, progress);
    else
        run<false>(view, progress);
}

template <bool alone>
void VolumePass::run(const MeshView& view, StageProgress& progress) {
    constexpr std::size_t slots_per_thread = 16384;
    const std::size_t slots = view.mesh.tetrahedra.size();
    StageProgress first = progress.within(0, 0.3), second = progress.within(0.3, 1);
    watched_split(
        view.team, first, slots, slots_per_thread,
        [&](std::size_t begin, std::size_t end) { set_exponents<alone>(view.mesh, begin, end); });
    watched_split(view.team, second, slots, slots_per_thread,
                  [&](std::size_t begin, std::size_t end) { add<alone>(view.mesh, begin, end); });
}

double VolumePass::radius(VertexId v) {
    const std::uint32_t bits = radii_[v].load(std::memory_order_relaxed);
    float x;
    std::memcpy(&x, &bits, sizeof x);
    return static_cast<double>(x);
}

bool VolumePass::find(VertexId v, double& volume) {
    const std::uint32_t count = counts_[v].load(std::memory_order_relaxed);
    if (flags(v) != 0 || count > most_parts) return false;
    const int least = exponent(v);
    const auto load = [&](AtomicArray<std::int64_t>& of) {
        return static_cast<double>(of[v].load(std::memory_order_relaxed));
    };
    volume = load(sums_) * power_of_two(least - sum_bits);
    // Rounding a part to an integer has an error of at most one unit.
    const double error = (load(errors_) + count) * power_of_two(least - error_bits) +
                         count * power_of_two(least - sum_bits);
    return error <= 0.9 * measure_error * volume;
}

}  // namespace mgdt
