// SPDX-License-Identifier: MIT
// Signed integers with a bound in their type: |v| < 2^(Bits - 1) for every Integer<Bits>. The type
// of a sum or product follows from the types of its operands, so a polynomial that compiles cannot
// overflow. All integers are on the stack.
#pragma once

#include <cstdint>
#include <type_traits>

// The first stages of a predicate are a few hundred instructions that share registers. The later
// stages are not inlined, so that they do not take registers from the first stages.
#if defined(__GNUC__)
#define MGDT_PREDICATES_INLINE inline __attribute__((always_inline))
#define MGDT_PREDICATES_APART __attribute__((noinline))
#else
#define MGDT_PREDICATES_INLINE inline
#define MGDT_PREDICATES_APART
#endif

namespace mgdt::exact {

#ifdef __SIZEOF_INT128__
using Limb = std::uint64_t;
__extension__ typedef unsigned __int128 DoubleLimb;
__extension__ typedef __int128 Widest;  // the widest native signed integer
constexpr int widest_bits = 128;
#else
using Limb = std::uint32_t;
using DoubleLimb = std::uint64_t;
using Widest = std::int64_t;
constexpr int widest_bits = 64;
#endif
constexpr int limb_bits = static_cast<int>(8 * sizeof(Limb));

constexpr int limb_count(int bits) {
    return (bits + limb_bits - 1) / limb_bits;
}

template <int Bits, bool Native = (Bits <= widest_bits)>
struct Integer;

// A narrow integer is a native one.
template <int Bits>
struct Integer<Bits, true> {
    using Value = std::conditional_t<Bits <= 64, std::int64_t, Widest>;
    Value value;
};

// A wide integer is an array of limbs in two's complement, least significant first.
template <int Bits>
struct Integer<Bits, false> {
    static constexpr int size = limb_count(Bits);
    Limb limb[size];
};

// The limb that extends the integer: all ones if it is negative, otherwise 0.
template <int Bits>
inline Limb extension(const Integer<Bits>& a) {
    if constexpr (Bits <= widest_bits) {
        return a.value < 0 ? ~Limb{0} : Limb{0};
    } else {
        return Limb{0} - (a.limb[a.size - 1] >> (limb_bits - 1));
    }
}

// The first N limbs of a, extended by its sign.
template <int N, int Bits>
inline void to_limbs(const Integer<Bits>& a, Limb (&out)[N]) {
    constexpr int own = limb_count(Bits) < N ? limb_count(Bits) : N;
    const Limb sign = extension(a);
    if constexpr (Bits <= widest_bits) {
        for (int i = 0; i < own; ++i) out[i] = static_cast<Limb>(a.value >> (i * limb_bits));
    } else {
        for (int i = 0; i < own; ++i) out[i] = a.limb[i];
    }
    for (int i = own; i < N; ++i) out[i] = sign;
}

// a += b + carry, modulo 2^limb_bits. Returns the new carry.
inline Limb add_with_carry(Limb& a, Limb b, Limb carry) {
    const DoubleLimb sum = static_cast<DoubleLimb>(a) + b + carry;
    a = static_cast<Limb>(sum);
    return static_cast<Limb>(sum >> limb_bits);
}

// a -= b + borrow, modulo 2^limb_bits. Returns the new borrow.
inline Limb subtract_with_borrow(Limb& a, Limb b, Limb borrow) {
    const DoubleLimb difference = static_cast<DoubleLimb>(a) - b - borrow;
    a = static_cast<Limb>(difference);
    return static_cast<Limb>(difference >> limb_bits) & 1U;
}

// Subtracts b[0 .. n) from r[0 .. n), modulo the size of r, if mask is all ones. Changes nothing if
// mask is 0.
inline void subtract_masked(Limb* r, const Limb* b, int n, Limb mask) {
    Limb borrow = 0;
    for (int i = 0; i < n; ++i) borrow = subtract_with_borrow(r[i], b[i] & mask, borrow);
}

// Operations whose results have more limbs than this call the functions below, which work modulo
// the size of r. add(): r[0..n) += b[0..m). subtract(): r[0..n) -= b[0..m). multiply(): r[0..size)
// = x[0..n) * y[0..m), where size is n + m or one less.
constexpr int inline_limbs = 10;
void add(Limb* r, int n, const Limb* b, int m);
void subtract(Limb* r, int n, const Limb* b, int m);
void multiply(const Limb* x, int n, const Limb* y, int m, Limb* r, int size);

// The limbs of an integer: a pointer to the limbs of a wide integer, or a copy for a native
// integer.
template <int Bits, bool Native = (Bits <= widest_bits)>
struct Limbs {
    static constexpr int size = limb_count(Bits);
    explicit Limbs(const Integer<Bits>& a) : data(a.limb) {}
    const Limb* data;
};
template <int Bits>
struct Limbs<Bits, true> {
    static constexpr int size = limb_count(Bits);
    explicit Limbs(const Integer<Bits>& a) { to_limbs(a, data); }
    Limb data[size];
};

// Replaces a by its magnitude. Returns whether a was negative.
bool take_sign(Limb* a, int n);
// The number of bits of a magnitude; 0 for 0.
int length_of(const Limb* a, int n);

// A rounded number, value * 2^exponent, where value is an integer of magnitude at most 2^64.
// rounded(a, n) overwrites the limbs of a.
struct Rounded {
    double value;
    int exponent;
};
Rounded rounded(Limb* a, int n);

constexpr int sum_bits(int a, int b) {
    return (a > b ? a : b) + 1;
}

template <int A, int B>
inline Integer<sum_bits(A, B)> operator+(const Integer<A>& a, const Integer<B>& b) {
    Integer<sum_bits(A, B)> r;
    if constexpr (sum_bits(A, B) <= widest_bits) {
        r.value = static_cast<decltype(r.value)>(a.value) + b.value;
    } else {
        to_limbs(a, r.limb);
        if constexpr (r.size > inline_limbs) {
            const Limbs<B> other(b);
            add(r.limb, r.size, other.data, other.size);
        } else {
            Limb other[r.size];
            to_limbs(b, other);
            Limb carry = 0;
            for (int i = 0; i < r.size; ++i) carry = add_with_carry(r.limb[i], other[i], carry);
        }
    }
    return r;
}

template <int A, int B>
inline Integer<sum_bits(A, B)> operator-(const Integer<A>& a, const Integer<B>& b) {
    Integer<sum_bits(A, B)> r;
    if constexpr (sum_bits(A, B) <= widest_bits) {
        r.value = static_cast<decltype(r.value)>(a.value) - b.value;
    } else {
        to_limbs(a, r.limb);
        if constexpr (r.size > inline_limbs) {
            const Limbs<B> other(b);
            subtract(r.limb, r.size, other.data, other.size);
        } else {
            Limb other[r.size];
            to_limbs(b, other);
            Limb borrow = 0;
            for (int i = 0; i < r.size; ++i) {
                borrow = subtract_with_borrow(r.limb[i], other[i], borrow);
            }
        }
    }
    return r;
}

// r[0 .. m) += x * y[0 .. m). Returns the carry.
inline Limb add_row(Limb* r, Limb x, const Limb* y, int m) {
    Limb carry = 0;
    for (int j = 0; j < m; ++j) {
        const DoubleLimb t = static_cast<DoubleLimb>(x) * y[j] + r[j] + carry;
        r[j] = static_cast<Limb>(t);
        carry = static_cast<Limb>(t >> limb_bits);
    }
    return carry;
}

// Multiplies the limbs as unsigned numbers, by the schoolbook method. With B = 2^limb_bits, a
// negative a of n limbs is taken for a + B^n, so B^n b is subtracted from the product; likewise for
// a negative b (Knuth, The Art of Computer Programming 2, 4.3.1).
template <int A, int B>
inline Integer<A + B - 1> operator*(const Integer<A>& a, const Integer<B>& b) {
    Integer<A + B - 1> r;
    if constexpr (A + B - 1 <= widest_bits) {
        r.value = static_cast<decltype(r.value)>(a.value) * b.value;
    } else {
        constexpr int n = limb_count(A), m = limb_count(B);
        static_assert(r.size == n + m || r.size == n + m - 1, "the product fills its limbs");
        if constexpr (n + m > inline_limbs) {
            const Limbs<A> x(a);
            const Limbs<B> y(b);
            multiply(x.data, n, y.data, m, r.limb, r.size);
        } else {
            Limb x[n], y[m], product[n + m] = {};
            to_limbs(a, x);
            to_limbs(b, y);
            for (int i = 0; i < n; ++i) product[i + m] = add_row(product + i, x[i], y, m);
            subtract_masked(product + n, y, m, extension(a));
            subtract_masked(product + m, x, n, extension(b));
            for (int i = 0; i < r.size; ++i) r.limb[i] = product[i];
        }
    }
    return r;
}

template <int Bits>
inline int sign(const Integer<Bits>& a) {
    if constexpr (Bits <= widest_bits) {
        return (a.value > 0) - (a.value < 0);
    } else {
        if (extension(a) != 0) return -1;
        Limb any = 0;
        for (int i = 0; i < a.size; ++i) any |= a.limb[i];
        return any != 0;
    }
}

template <int Bits>
inline Rounded rounded(const Integer<Bits>& a) {
    Limb limb[limb_count(Bits)];
    to_limbs(a, limb);
    return rounded(limb, limb_count(Bits));
}

// mantissa * 2^shift. A negative shift drops zero bits only.
template <int Bits>
inline Integer<Bits> shifted(std::int64_t mantissa, int shift) {
    Integer<Bits> r;
    if constexpr (Bits <= widest_bits) {
        using Value = typename Integer<Bits>::Value;
        using Unsigned = std::conditional_t<Bits <= 64, std::uint64_t, DoubleLimb>;
        const auto v = static_cast<Value>(mantissa);
        r.value = shift < 0 ? (shift > -64 ? v >> -shift : 0)
                            : static_cast<Value>(static_cast<Unsigned>(v) << shift);
    } else {
        if (shift < 0) {
            mantissa = shift > -64 ? mantissa >> -shift : 0;
            shift = 0;
        }
        const auto bits = static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa);
        for (int i = 0; i < r.size; ++i) r.limb[i] = 0;
        // Write the limb that holds bit `shift`, and the limbs above it up to the end of the 64
        // bits.
        const int first = shift / limb_bits, offset = shift % limb_bits;
        r.limb[first] = static_cast<Limb>(bits << offset);
        for (int i = first + 1, from = limb_bits - offset; from < 64 && i < r.size; ++i) {
            r.limb[i] = static_cast<Limb>(bits >> from);
            from += limb_bits;
        }
        if (mantissa < 0) {
            Limb borrow = 0;
            for (int i = 0; i < r.size; ++i) {
                const Limb magnitude = r.limb[i];
                r.limb[i] = 0;
                borrow = subtract_with_borrow(r.limb[i], magnitude, borrow);
            }
        }
    }
    return r;
}

// The value of a in a narrower type, for callers that know a better bound than the type of a.
template <int Bits, int A>
inline Integer<Bits> narrowed(const Integer<A>& a) {
    Integer<Bits> r;
    if constexpr (Bits <= widest_bits && A <= widest_bits) {
        r.value = static_cast<typename Integer<Bits>::Value>(a.value);
    } else if constexpr (Bits <= widest_bits) {
        DoubleLimb v = 0;
        for (int i = limb_count(Bits) - 1; i >= 0; --i) {
            v = static_cast<DoubleLimb>(v << (limb_bits - 1) << 1) | a.limb[i];
        }
        r.value = static_cast<typename Integer<Bits>::Value>(v);
    } else {
        to_limbs(a, r.limb);
    }
    return r;
}

// a * 2^shift, which has to fit.
template <int Bits>
inline Integer<Bits> shifted_left(const Integer<Bits>& a, int shift) {
    Integer<Bits> r;
    if constexpr (Bits <= widest_bits) {
        using Unsigned = std::conditional_t<Bits <= 64, std::uint64_t, DoubleLimb>;
        r.value =
            static_cast<typename Integer<Bits>::Value>(static_cast<Unsigned>(a.value) << shift);
    } else {
        const int limbs = shift / limb_bits, bits = shift % limb_bits;
        for (int i = a.size - 1; i >= 0; --i) {
            const Limb high = i >= limbs ? a.limb[i - limbs] : 0;
            const Limb low = i > limbs ? a.limb[i - limbs - 1] : 0;
            r.limb[i] =
                bits == 0 ? high : static_cast<Limb>(high << bits | low >> (limb_bits - bits));
        }
    }
    return r;
}

// The number of bits of the magnitude, or one less: |a| <= 2^length(a).
template <int Bits>
inline int length(const Integer<Bits>& a) {
    Limb limb[limb_count(Bits)];
    to_limbs(a, limb);
    const Limb sign = extension(a);
    int i = limb_count(Bits) - 1;
    while (i > 0 && limb[i] == sign) --i;
    int bits = i * limb_bits;
    for (Limb top = limb[i] ^ sign; top != 0; top >>= 1) ++bits;
    return bits;
}

}  // namespace mgdt::exact
