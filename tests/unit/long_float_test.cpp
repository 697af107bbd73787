// SPDX-License-Identifier: MIT
// Numbers of many digits and numbers with bounds, against rational ones.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

#include "predicates/bounded.hpp"

namespace mgdt {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Integer = boost::multiprecision::cpp_int;

Rational power_of_two(std::int64_t e) {
    const Rational power(Integer(1) << static_cast<unsigned>(e < 0 ? -e : e));
    return e < 0 ? 1 / power : power;
}
Rational value_of(double x) {
    return Rational(x);
}
Rational value_of(const Twofold& x) {
    return Rational(x.high) + Rational(x.low);
}
template <int Bits>
Rational value_of(const LongFloat<Bits>& x) {
    Integer digits = 0;
    for (int i = x.size - 1; i >= 0; --i) digits = digits << exact::limb_bits | x.limb[i];
    const Rational r = Rational(digits) * power_of_two(x.exponent - Bits);
    return x.is_negative ? -r : r;
}

double random_double(std::mt19937_64& random, int exponents) {
    const double x = std::ldexp(static_cast<double>(random() >> 11) * 0x1p-53,
                                static_cast<int>(random() % static_cast<unsigned>(exponents)));
    return random() % 2 ? x : -x;
}

template <int Bits>
LongFloat<Bits> random_number(std::mt19937_64& random) {
    // Of one double, or of sums and products that fill it.
    LongFloat<Bits> x(random_double(random, 3));
    for (std::uint64_t i = random() % 8; i > 0; --i)
        x = x * LongFloat<Bits>(random_double(random, 70)) +
            LongFloat<Bits>(random_double(random, 2));
    x.exponent += static_cast<std::int64_t>(random() % 100) - 50;
    return x;
}

template <int Bits>
void expect_right() {
    std::mt19937_64 random(Bits);
    const Rational unit = power_of_two(3 - Bits);
    for (int k = 0; k < 1000; ++k) {
        using L = LongFloat<Bits>;
        const L a = random_number<Bits>(random);
        // Now and then nearly the same, so that leading digits cancel.
        const L b = k % 3 ? random_number<Bits>(random) : a * L(1 + 0x1p-52);
        const Rational ra = value_of(a), rb = value_of(b);
        const auto expect = [&](const L& actual, const Rational& exact) {
            const Rational off = abs(value_of(actual) - exact);
            EXPECT_LE(off, unit * abs(exact));
            EXPECT_NE(actual.limb[L::size - 1] >> (exact::limb_bits - 1), 0u);
        };
        if (ra != 0 && rb != 0) {
            expect(a * b, ra * rb);
            expect(a / b, ra / rb);
            if (ra != rb) expect(a - b, ra - rb);
            expect(a + b, ra + rb);
        }
        EXPECT_EQ(a < b, ra < rb);
        EXPECT_TRUE((a - a).is_zero());
        const double d = a.in_double();
        EXPECT_LE(abs(Rational(d) - ra), abs(ra) * power_of_two(-52));
    }
}

TEST(LongFloat, IsRightToItsLastBits) {
    expect_right<64>();
    expect_right<512>();
    expect_right<2048>();
}

TEST(LongFloat, TakesAnyDouble) {
    for (const double x : {0.0, 1.0, -3.5, 0x1p-1074, -0x1.8p-1060, 0x1.fffffffffffffp1023}) {
        EXPECT_EQ(LongFloat<64>(x).in_double(), x);
        EXPECT_EQ(LongFloat<512>(x).in_double(), x);
        EXPECT_EQ(value_of(LongFloat<512>(x)), Rational(x));
    }
    const LongFloat<512> large(0x1p1000), product = large * large;
    EXPECT_EQ(product.in_double(), std::numeric_limits<double>::infinity());
    EXPECT_EQ((LongFloat<512>(1.0) / product).in_double(), 0);
}

// Whatever is computed, the exact value is within the bound.
template <class Real, class Make>
void expect_bounded(Make make) {
    std::mt19937_64 random(11);
    double least = 1;
    for (int k = 0; k < 300; ++k) {
        using B = Bounded<Real>;
        B x[6];
        Rational r[6];
        for (int i = 0; i < 6; ++i) {
            x[i] = make(random);
            r[i] = value_of(x[i].value);
        }
        for (int step = 0; step < 12; ++step) {
            const std::size_t i = random() % 6, j = random() % 6, to = random() % 6;
            switch (random() % 4) {
                case 0:
                    x[to] = x[i] + x[j], r[to] = r[i] + r[j];
                    break;
                case 1:
                    x[to] = x[i] - x[j], r[to] = r[i] - r[j];
                    break;
                case 2:
                    x[to] = x[i] * x[j], r[to] = r[i] * r[j];
                    break;
                default:
                    if (r[j] == 0) continue;
                    x[to] = x[i] / x[j], r[to] = r[i] / r[j];
            }
            const Rational off = abs(value_of(x[to].value) - r[to]);
            if constexpr (std::is_same_v<Real, Twofold>)
                if (!std::isfinite(x[to].error)) break;
            EXPECT_LE(off, value_of(x[to].error));
            if (off != 0) least = std::min(least, static_cast<double>(value_of(x[to].error) / off));
        }
    }
    EXPECT_GE(least, 1);
}

TEST(Bounded, KnowsItsError) {
    expect_bounded<Twofold>([](std::mt19937_64& random) {
        return Bounded<Twofold>{{random_double(random, 3), 0}, 0};
    });
    expect_bounded<LongFloat<512>>([](std::mt19937_64& random) {
        return Bounded<LongFloat<512>>{LongFloat<512>(random_double(random, 3)), {}};
    });
}

}  // namespace
}  // namespace mgdt
