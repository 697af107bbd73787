// SPDX-License-Identifier: MIT
// Differences as native integers of a common unit, and determinants of these integers. If the
// coordinates span at most 62 bits, which is nearly always the case, the exact sign costs no more
// than a filter.
//
// A longer number is a sum of digits times powers of 2^62; only the highest digit has a sign.
// Products are added digit by digit in 128 bits, and carries are propagated only when the sum is
// complete. docs/theory.md bounds the sizes.
#pragma once

#include "predicates/differences.hpp"

namespace mgdt::exact {

constexpr int native_bits = 60;      // differences are below 2^native_bits in magnitude
constexpr int coordinate_bits = 62;  // coordinates are below 2^coordinate_bits

#ifdef __SIZEOF_INT128__
constexpr bool have_native = true;
#else
constexpr bool have_native = false;
#endif

// In this range, units and their reciprocals are normal numbers.
constexpr double least_size = 0x1p-900, most_size = 0x1p900;

// `unit` is the power of two for which numbers up to `size` are below 2^Bits units, and `per_unit`
// is its reciprocal.
template <int Bits>
struct NativeUnit {
    double unit, per_unit;

    MGDT_PREDICATES_INLINE explicit NativeUnit(double size) {
        const std::uint64_t power = bits_of(size) & exponent_mask;  // size < 2 power
        constexpr std::uint64_t shift = std::uint64_t{Bits - 1} << 52;
        unit = double_of(power - shift);
        per_unit = double_of((std::uint64_t{2 * 1023} << 52) - (power - shift));
    }

    // x in units. If this number is no integer, `off` becomes nonzero.
    MGDT_PREDICATES_INLINE std::int64_t count(double x, std::uint64_t& off) const {
        // The conversion rounds towards zero, so a number that is no integer does not convert back.
        // The comparison ignores signs: x may be -0, and n as a double may be -0 if the compiler
        // rounds in floating point instead of converting to an integer and back.
        const auto n = static_cast<std::int64_t>(x * per_unit);
        off |= (bits_of(static_cast<double>(n) * unit) ^ bits_of(x)) << 1;
        return n;
    }
};

// Writes the differences to `out`, in units of a power of two. Returns false if a coordinate is not
// a multiple of the unit, or if a number does not fit.
template <int N>
MGDT_PREDICATES_INLINE bool to_native(const Differences<N>& d, std::int64_t (&out)[N]) {
    double size = 4 * d.largest;
    const auto cover = [&](const double* p) {
        const double s = largest_of<0, 3>(p);
        size = s > size ? s : size;
    };
    cover(d.origin);
    each<N / 3>([&](auto i) { cover(d.point[i]); });
    if (!(size >= least_size && size <= most_size)) return false;
    const NativeUnit<coordinate_bits> in(size);
    std::uint64_t off = 0;
    std::int64_t any = 0;
    const auto units = [&](double x) { return in.count(x, off); };
    const std::int64_t o[3] = {units(d.origin[0]), units(d.origin[1]), units(d.origin[2])};
    each<N>([&](auto i) {
        const std::int64_t n = units(d.point[i / 3][i % 3]) - o[i % 3];
        any |= n ^ (n >> 63);
        out[i] = n;
    });
    return (off | static_cast<std::uint64_t>(any >> native_bits)) == 0;
}

#ifdef __SIZEOF_INT128__

constexpr int digit_bits = 62;
constexpr std::int64_t digit_mask = (std::int64_t{1} << digit_bits) - 1;

MGDT_PREDICATES_INLINE std::int64_t low_digit(Widest v) {
    return static_cast<std::int64_t>(v) & digit_mask;
}

MGDT_PREDICATES_INLINE Widest product(std::int64_t a, std::int64_t b) {
    return static_cast<Widest>(a) * b;
}

// Integers of up to 122 bits.
struct TwoDigits {
    std::int64_t d0, d1;

    MGDT_PREDICATES_INLINE explicit TwoDigits(Widest v)
        : d0(low_digit(v)), d1(static_cast<std::int64_t>(v >> digit_bits)) {}
};

// Integers of up to 184 bits.
struct ThreeDigits {
    std::int64_t d0, d1, d2;

    // The number c0 + c1 * 2^62, where c0 and c1 are sums of products of digits. The part of a sum
    // that does not fit a digit is carried to the next digit.
    MGDT_PREDICATES_INLINE ThreeDigits(Widest c0, Widest c1) : d0(low_digit(c0)) {
        const Widest carried = c1 + (c0 >> digit_bits);
        d1 = low_digit(carried);
        d2 = static_cast<std::int64_t>(carried >> digit_bits);
    }
    MGDT_PREDICATES_INLINE int sign() const { return d2 < 0 ? -1 : (d0 | d1 | d2) != 0; }
};

// Sizes in bits. The assertions below show that every sum has room for its sign and a carry.
constexpr int minor_bits = 2 * native_bits + 1;   // a minor: two products
constexpr int square_bits = 2 * native_bits + 2;  // a square: three products
constexpr int cubic_bits = 3 * native_bits + 3;   // a determinant: 6 * 2^(3 * 60)
static_assert(square_bits <= 2 * digit_bits && cubic_bits <= 3 * digit_bits,
              "two digits hold a minor and a square, three a minor of three rows");
static_assert(native_bits + digit_bits + 2 < 127, "three products of a difference and a digit");
// The second digit of a square is at most a quarter of 2^62. So the largest sum in the sphere
// determinant has four products of two digits, and four products of a digit and such a quarter: it
// is at most 5 * 2^(2 * 62).
static_assert(square_bits - digit_bits <= digit_bits - 2 && 2 * digit_bits + 3 <= 127,
              "eight products of digits");

MGDT_PREDICATES_INLINE TwoDigits native_minor(const std::int64_t* p, const std::int64_t* q) {
    return TwoDigits(product(p[0], q[1]) - product(q[0], p[1]));
}

MGDT_PREDICATES_INLINE TwoDigits native_square(const std::int64_t* p) {
    return TwoDigits(product(p[0], p[0]) + product(p[1], p[1]) + product(p[2], p[2]));
}

// The sum z u - z' v + z" w as sums of products by position: z, z', z" are the third coordinates of
// three rows, and u, v, w the minors of the first two coordinates of the other rows.
struct DigitSums {
    Widest c0, c1;
};

MGDT_PREDICATES_INLINE DigitSums digit_sums(const std::int64_t* p, const TwoDigits& u,
                                            const std::int64_t* q, const TwoDigits& v,
                                            const std::int64_t* r, const TwoDigits& w) {
    return {product(p[2], u.d0) - product(q[2], v.d0) + product(r[2], w.d0),
            product(p[2], u.d1) - product(q[2], v.d1) + product(r[2], w.d1)};
}

MGDT_PREDICATES_INLINE ThreeDigits native_cubic(const std::int64_t* p, const TwoDigits& u,
                                                const std::int64_t* q, const TwoDigits& v,
                                                const std::int64_t* r, const TwoDigits& w) {
    const DigitSums sums = digit_sums(p, u, q, v, r, w);
    return {sums.c0, sums.c1};
}

// The sign of the determinant of three rows.
MGDT_PREDICATES_INLINE int native_orientation(const std::int64_t (&v)[9]) {
    const std::int64_t *b = v, *c = v + 3, *d = v + 6;
    return native_cubic(b, native_minor(c, d), c, native_minor(b, d), d, native_minor(b, c)).sign();
}

// The sign of the determinant of SphereDeterminant, and its four minors.
struct NativeSphere {
    ThreeDigits minor[4];
    int sign;

    MGDT_PREDICATES_INLINE explicit NativeSphere(const std::int64_t (&v)[12])
        : NativeSphere(v, native_minor(v, v + 3), native_minor(v, v + 6), native_minor(v, v + 9),
                       native_minor(v + 3, v + 6), native_minor(v + 3, v + 9),
                       native_minor(v + 6, v + 9)) {}

  private:
    MGDT_PREDICATES_INLINE NativeSphere(const std::int64_t (&v)[12], const TwoDigits& ab,
                                        const TwoDigits& ac, const TwoDigits& ad,
                                        const TwoDigits& bc, const TwoDigits& bd,
                                        const TwoDigits& cd)
        : minor{native_cubic(v + 3, cd, v + 6, bd, v + 9, bc),
                native_cubic(v, cd, v + 6, ad, v + 9, ac),
                native_cubic(v, bd, v + 3, ad, v + 9, ab),
                native_cubic(v, bc, v + 3, ac, v + 6, ab)} {
        Widest sum[4] = {};
        each<4>([&](auto i) {
            const TwoDigits s = native_square(v + 3 * i);
            const ThreeDigits& m = minor[i];
            // The terms have alternating signs, so that no partial sum grows.
            const auto add = [&](auto at, std::int64_t x, std::int64_t y) {
                sum[at] += i % 2 == 0 ? product(x, y) : -product(x, y);
            };
            add(index<0>(), s.d0, m.d0);
            add(index<1>(), s.d0, m.d1);
            add(index<1>(), s.d1, m.d0);
            add(index<2>(), s.d0, m.d2);
            add(index<2>(), s.d1, m.d1);
            add(index<3>(), s.d1, m.d2);
        });
        sum[1] += sum[0] >> digit_bits;
        sum[2] += sum[1] >> digit_bits;
        sum[3] += sum[2] >> digit_bits;
        const std::int64_t low = low_digit(sum[0]) | low_digit(sum[1]) | low_digit(sum[2]);
        sign = static_cast<int>(sum[3] >> 127) | ((sum[3] | low) != 0);
    }
};

#else

// Without native integers of 128 bits, these definitions only let callers compile; nothing calls
// them.
struct NativeSphere {
    struct Minor {
        int sign() const { return 0; }
    };
    explicit NativeSphere(const std::int64_t (&)[12]) {}
    Minor minor[4];
    int sign = undecided;
};
inline int native_orientation(const std::int64_t (&)[9]) {
    return undecided;
}

#endif

}  // namespace mgdt::exact
