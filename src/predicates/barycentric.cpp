// SPDX-License-Identifier: MIT
#include "predicates/barycentric.hpp"

#include <cmath>

#include "predicates/determinants.hpp"
#include "predicates/native_integer.hpp"
#include "predicates/quotient.hpp"

namespace mgdt {
namespace exact {
namespace {

// The weight of a vertex is the volume with q in the vertex's place divided by the volume of the
// tetrahedron. With the vertices a, b, c, d relative to q, the four volumes are [bcd], -[acd],
// [abd], -[abc], and the volume of the tetrahedron is their sum. A common factor of a column of
// coordinates cancels, so each axis has its own unit.

#ifdef __SIZEOF_INT128__

// Coordinates along an axis are below 2^axis_bits units, so differences are below 2^native_bits.
constexpr int axis_bits = native_bits - 1;

// Writes the differences between the vertices and q along an axis, as integers, to every third
// element of n. Returns false if the coordinates are out of range or have no common unit.
MGDT_PREDICATES_INLINE bool axis_to_native(const double* const (&p)[4], const double* q,
                                           std::size_t axis, std::int64_t* n) {
    const double x[5] = {p[0][axis], p[1][axis], p[2][axis], p[3][axis], q[axis]};
    const double size = largest_of<0, 5>(x);
    if (!(size >= least_size && size <= most_size)) return false;
    const NativeUnit<axis_bits> in(size);
    std::uint64_t off = 0;
    const std::int64_t origin = in.count(x[4], off);
    each<4>([&](auto i) { n[3 * i] = in.count(x[i], off) - origin; });
    return off == 0;
}

MGDT_PREDICATES_INLINE DigitSums negative(const DigitSums& v) {
    return {-v.c0, -v.c1};
}

static_assert(native_bits + digit_bits + 4 < 127,
              "the sums of four volumes hold twelve products of a difference and a digit");

// Rounds to the nearest double.
MGDT_PREDICATES_INLINE double rounded(Widest v) {
    const auto narrow = static_cast<std::int64_t>(v);
    if (v == narrow) return static_cast<double>(narrow);
    // The leading 64 bits determine the result, except for whether a later bit is set. So the last
    // of the 64 bits is set if any later bit is; it is far below the bits that a double keeps.
    const int shift = __builtin_clrsbll(static_cast<std::int64_t>(v >> 64));
    const DoubleLimb aligned = static_cast<DoubleLimb>(v) << shift;
    const auto leading = static_cast<std::int64_t>(aligned >> 64);
    const bool rest = static_cast<std::uint64_t>(aligned) != 0;
    const double power = double_of(static_cast<std::uint64_t>(1023 + 64 - shift) << 52);
    return static_cast<double>(leading | rest) * power;
}

MGDT_PREDICATES_INLINE double rounded(const DigitSums& v) {
    const Widest upper = v.c1 + (v.c0 >> digit_bits);
    const std::int64_t lower = low_digit(v.c0);
    constexpr Widest few = Widest{1} << 60;
    if (-few < upper && upper < few) return rounded(upper * (Widest{1} << digit_bits) + lower);
    return rounded(upper | (lower != 0)) * 0x1p62;
}

MGDT_PREDICATES_INLINE void native_weights(const std::int64_t (&v)[12], double (&w)[4]) {
    const std::int64_t *a = v, *b = v + 3, *c = v + 6, *d = v + 9;
    const TwoDigits ab = native_minor(a, b), ac = native_minor(a, c), ad = native_minor(a, d),
                    bc = native_minor(b, c), bd = native_minor(b, d), cd = native_minor(c, d);
    const DigitSums volume[4] = {
        digit_sums(b, cd, c, bd, d, bc), negative(digit_sums(a, cd, c, ad, d, ac)),
        digit_sums(a, bd, b, ad, d, ab), negative(digit_sums(a, bc, b, ac, c, ab))};
    DigitSums sum = {0, 0};
    each<4>([&](auto i) {
        sum.c0 += volume[i].c0;
        sum.c1 += volume[i].c1;
    });
    const double all = rounded(sum);
    each<4>([&](auto i) { w[i] = rounded(volume[i]) / all; });
}

#endif

}  // namespace

bool barycentric_native(const double* const (&p)[4], const double* q, double (&w)[4]) {
#ifdef __SIZEOF_INT128__
    std::int64_t n[12];
    if (!axis_to_native(p, q, 0, n) || !axis_to_native(p, q, 1, n + 1) ||
        !axis_to_native(p, q, 2, n + 2))
        return false;
    native_weights(n, w);
    return true;
#else
    (void)p, (void)q, (void)w;
    return false;
#endif
}

void barycentric_integer(const double* const (&p)[4], const double* q, double (&w)[4],
                         int least_width) {
    const auto divide = [&](const auto& v) {
        const auto minors = SphereDeterminant::minors(v);
        const auto& m = minors.of;
        const Rounded all = rounded((m[0] - m[1]) + (m[2] - m[3]));
        for (int i = 0; i < 4; ++i) {
            const double weight = quotient(rounded(m[i]), all);
            w[i] = i % 2 == 0 || weight == 0 ? weight : -weight;
        }
        return 0;
    };
    with_integers(ExactDifferencesByAxis<12>(p, q), least_width, divide);
}

}  // namespace exact

void barycentric_weights(const double* const (&p)[4], const double* q, double (&w)[4]) {
    if (!exact::barycentric_native(p, q, w)) exact::barycentric_integer(p, q, w);
}

}  // namespace mgdt
