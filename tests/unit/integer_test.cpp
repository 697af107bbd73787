// SPDX-License-Identifier: MIT
#include "predicates/integer.hpp"

#include <gtest/gtest.h>

#include "exact_reference.hpp"
#include "point_families.hpp"

namespace {

using families::Random;
using mgdt::exact::Integer;
using reference::Big;

template <int Bits>
Big value(const Integer<Bits>& a) {
    mgdt::exact::Limb limb[mgdt::exact::limb_count(Bits)];
    mgdt::exact::to_limbs(a, limb);
    Big v = mgdt::exact::extension(a) != 0 ? -1 : 0;
    for (int i = mgdt::exact::limb_count(Bits) - 1; i >= 0; --i) {
        v = (v << mgdt::exact::limb_bits) + Big(limb[i]);
    }
    return v;
}

// 0, +-1, the largest, or a number of random length: mantissas put side by side.
template <int Bits>
Integer<Bits> some(Random& r) {
    Integer<Bits> a = mgdt::exact::shifted<Bits>(0, 0);
    const int kind = r.integer(0, 9);
    if (kind == 0) return a;
    const bool negative = r.integer(0, 1) != 0;
    const int top = kind == 1 ? 1 : kind == 2 ? Bits - 1 : r.integer(1, Bits - 1);
    for (int at = 0; at < top; at += 30) {
        const int width = std::min(30, top - at);
        const int mask = static_cast<int>((1U << width) - 1);
        // All ones are where carries run far.
        const int piece = kind <= 4 ? mask : r.integer(0, mask);
        const auto part = mgdt::exact::shifted<Bits>(negative ? -piece : piece, at);
        a = mgdt::exact::narrowed<Bits>(a + part);
    }
    return a;
}

template <class Widths>
class IntegerPair : public testing::Test {};

template <int A, int B>
struct Widths {
    static constexpr int a = A, b = B;
};

using Pairs = testing::Types<Widths<25, 25>, Widths<50, 25>, Widths<63, 63>, Widths<64, 64>,
                             Widths<64, 65>, Widths<126, 63>, Widths<127, 190>, Widths<128, 128>,
                             Widths<129, 3>, Widths<254, 127>, Widths<318, 320>, Widths<511, 511>,
                             Widths<640, 300>, Widths<2111, 2>, Widths<4222, 6334>>;
TYPED_TEST_SUITE(IntegerPair, Pairs, );  // the third argument is what -Wpedantic misses

TYPED_TEST(IntegerPair, AgreesWithUnlimitedIntegers) {
    Random r(5);
    for (int i = 0; i < reference::cases(1000); ++i) {
        const auto a = some<TypeParam::a>(r);
        const auto b = some<TypeParam::b>(r);
        const Big x = value(a), y = value(b);
        ASSERT_LT(abs(x), Big(1) << (TypeParam::a - 1));
        ASSERT_EQ(value(a + b), x + y);
        ASSERT_EQ(value(a - b), x - y);
        ASSERT_EQ(value(b - a), y - x);
        ASSERT_EQ(value(a * b), x * y);
        ASSERT_EQ(value(b * a), x * y);
        ASSERT_EQ(value(a - a), 0);
        ASSERT_EQ(sign(a), x.sign());
        ASSERT_EQ(sign(a * b), x.sign() * y.sign());
        ASSERT_EQ(value(mgdt::exact::narrowed<TypeParam::a>(a + b - b)), x);
    }
}

TEST(Integer, ASumHasOneBitMoreThanTheLonger) {
    EXPECT_EQ(mgdt::exact::sum_bits(25, 50), 51);
    EXPECT_EQ(mgdt::exact::sum_bits(50, 25), 51);
    EXPECT_EQ(mgdt::exact::sum_bits(64, 64), 65);
}

// The bound in the type of a result holds at the extremes of the operands.
TYPED_TEST(IntegerPair, ExtremesFitTheResult) {
    constexpr int n = TypeParam::a, m = TypeParam::b;
    const auto largest = [](auto bits) {
        auto a = mgdt::exact::shifted<bits>(0, 0);
        for (int at = 0; at < bits - 1; ++at) {
            a = mgdt::exact::narrowed<bits>(a + mgdt::exact::shifted<bits>(1, at));
        }
        return a;
    };
    const auto a = largest(std::integral_constant<int, n>());
    const auto b = largest(std::integral_constant<int, m>());
    const Big x = (Big(1) << (n - 1)) - 1, y = (Big(1) << (m - 1)) - 1;
    ASSERT_EQ(value(a), x);
    ASSERT_EQ(value(b), y);
    const auto zero = mgdt::exact::shifted<n>(0, 0);
    const auto minus = zero - a;
    EXPECT_EQ(value(a + b), x + y);
    EXPECT_EQ(value(minus - b), -x - y);
    EXPECT_EQ(value(a * b), x * y);
    EXPECT_EQ(value(minus * b), -x * y);
    EXPECT_EQ(value(minus * minus), x * x);
}

// To the nearest double, of two as near the even one.
TYPED_TEST(IntegerPair, RoundsToNearest) {
    Random r(6);
    for (int i = 0; i < reference::cases(2000); ++i) {
        auto a = some<TypeParam::a>(r);
        // Often a mantissa of 53 bits, or at the middle of two, and nothing or little after it.
        if (i % 2 == 0 && TypeParam::a > 120) {
            const std::int64_t half = (std::int64_t{1} << 53) + 2 * r.integer(0, 1 << 20) + 1;
            const auto leading = mgdt::exact::shifted<TypeParam::a>(
                i % 3 == 0 ? -half : half, r.integer(2, TypeParam::a - 57));
            const auto rest = mgdt::exact::shifted<TypeParam::a>(r.integer(-1, 1), 0);
            a = mgdt::exact::narrowed<TypeParam::a>(leading + rest);
        }
        const auto rounded = mgdt::exact::rounded(a);
        const Big x = value(a);
        const Big near = Big(rounded.value) << rounded.exponent;
        if (x == 0) {
            ASSERT_EQ(rounded.value, 0);
            continue;
        }
        const int length = static_cast<int>(msb(abs(x))) + 1;
        const Big twice_error = 2 * abs(x - near);
        ASSERT_LE(twice_error << 53, Big(1) << length);
        if ((twice_error << 53) == (Big(1) << length)) {
            int exponent;
            const double mantissa = std::frexp(rounded.value, &exponent);
            ASSERT_EQ(std::fmod(std::ldexp(mantissa, 53), 2), 0);
        }
    }
}

TEST(Integer, ShiftsAMantissaToAnyPlace) {
    const std::int64_t mantissa = 0x1234567890abc;
    for (int shift = 0; shift < 2047; ++shift) {
        EXPECT_EQ(value(mgdt::exact::shifted<2111>(mantissa, shift)), Big(mantissa) << shift);
        EXPECT_EQ(value(mgdt::exact::shifted<2111>(-mantissa, shift)), -(Big(mantissa) << shift));
    }
    for (int shift = 0; shift < 70; ++shift) {
        EXPECT_EQ(value(mgdt::exact::shifted<127>(-mantissa, shift)), -(Big(mantissa) << shift));
    }
    EXPECT_EQ(value(mgdt::exact::shifted<63>(-(mantissa << 8), -8)), -mantissa);
    EXPECT_EQ(value(mgdt::exact::shifted<255>(mantissa << 8, -8)), mantissa);
    // Zero has none but zero bits.
    for (const int shift : {-63, -64, -2000}) {
        EXPECT_EQ(value(mgdt::exact::shifted<63>(0, shift)), 0);
        EXPECT_EQ(value(mgdt::exact::shifted<127>(0, shift)), 0);
        EXPECT_EQ(value(mgdt::exact::shifted<255>(0, shift)), 0);
    }
}

}  // namespace
