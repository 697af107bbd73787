// SPDX-License-Identifier: MIT
// Numbers of any length, exact and cut off, and numbers with bounds, against rational ones.

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "../support/small.h"
#include "predicates/bounded_numbers.hpp"

namespace mgdt {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Integer = boost::multiprecision::cpp_int;

Rational times_power_of_two(const Rational& x, std::int64_t e) {
    const Rational power(Integer(1) << static_cast<unsigned>(e < 0 ? -e : e));
    return e < 0 ? Rational(x / power) : Rational(x * power);
}

Rational value_of(const Twofold& x) {
    return Rational(x.high) + Rational(x.low);
}
Rational value_of(double x) {
    return Rational(x);
}
Rational value_of(const WideDouble& x) {
    return times_power_of_two(Rational(x.mantissa), x.exponent);
}
// 53 bits after another.
Rational value_of(LongNumber x, LongMemory& memory) {
    Rational value = 0;
    while (x.sign() != 0) {
        const WideDouble leading = x.wide();
        value += value_of(leading);
        x = x - memory.number(leading.mantissa, leading.exponent);
    }
    return value;
}

struct Both {
    LongNumber number;
    Rational value;
};

double random_double(std::mt19937_64& random, int exponents) {
    const double mantissa = random() % 3 == 0 ? static_cast<double>(random() % 8)
                                              : static_cast<double>(random() >> 11) * 0x1p-53;
    const double x = std::ldexp(
        mantissa, static_cast<int>(random() % static_cast<unsigned>(exponents)) - exponents / 2);
    return random() % 2 ? x : -x;
}

void expect_equal(const Both& x, LongMemory& memory) {
    EXPECT_EQ(x.number.sign(), x.value.sign());
    EXPECT_EQ(value_of(x.number, memory), x.value);
    const Rational size = abs(x.value);
    EXPECT_LE(abs(value_of(x.number.wide()) - x.value), size * Rational(0x1p-52));
    const std::int64_t exponent = -x.number.wide().exponent;
    EXPECT_LE(abs(value_of(x.number.twofold(exponent)) - times_power_of_two(x.value, exponent)),
              times_power_of_two(size, exponent) * Rational(0x1p-104));
}

TEST(LongNumber, SumsAndProductsAreExact) {
    std::mt19937_64 random(2);
    Allocator allocator;
    LongMemory memory(allocator);
    for (const int exponents : {1, 60, 2000}) {
        for (int run = 0; run < (is_small() ? 10 : 200); ++run) {
            memory.release(0);
            std::vector<Both> all;
            for (int i = 0; i < 6; ++i) {
                const double x = random_double(random, exponents);
                const auto more = static_cast<std::int64_t>(random() % 200) - 100;
                all.push_back({memory.number(x, more), times_power_of_two(Rational(x), more)});
            }
            for (int i = 0; i < 8; ++i) {
                const Both a = all[random() % all.size()], b = all[random() % all.size()];
                switch (random() % 3) {
                    case 0:
                        all.push_back({a.number + b.number, a.value + b.value});
                        break;
                    case 1:
                        all.push_back({a.number - b.number, a.value - b.value});
                        break;
                    default:
                        all.push_back({a.number * b.number, a.value * b.value});
                }
                // What cancels to 0, or to little.
                all.push_back({-b.number + (b.number + a.number), a.value});
            }
            const std::size_t mark = memory.mark();
            for (const Both& x : all) {
                expect_equal(x, memory);
                memory.release(mark);
            }
        }
    }
}

// The error of each operation is within its bound, and not by much more than it has to be.
TEST(LongNumber, IsCutOffAsItsBoundSays) {
    Allocator allocator;
    for (const std::size_t bits : {192u, 512u, 2048u}) {
        const std::size_t limbs = bits / exact::limb_bits;
        LongMemory memory(allocator, limbs);
        std::mt19937_64 random(bits);
        const Rational bound = value_of(memory.rounding());
        Rational most = 0;
        const auto any = [&] {
            LongNumber x = memory.number(random_double(random, 3));
            for (std::uint64_t i = random() % 40; i > 0; --i)
                x = x * memory.number(random_double(random, 70)) +
                    memory.number(random_double(random, 2));
            return x;
        };
        for (int k = 0; k < (is_small() ? 20 : 300); ++k) {
            memory.release(0);
            const LongNumber a = any(), b = k % 3 ? any() : a * memory.number(1 + 0x1p-52);
            const Rational ra = value_of(a, memory), rb = value_of(b, memory);
            const auto expect = [&](const LongNumber& x, const Rational& exact, int factor) {
                const Rational off = abs(value_of(x, memory) - exact);
                EXPECT_LE(off, bound * factor * abs(exact));
                if (exact != 0) most = std::max(most, Rational(off / abs(exact)));
            };
            expect(a + b, ra + rb, 1);
            expect(a - b, ra - rb, 1);
            expect(a * b, ra * rb, 1);
            if (rb != 0) expect(a / b, ra / rb, 4);
            EXPECT_EQ((a - a).sign(), 0);
        }
        EXPECT_GT(most, bound / Rational(0x1p20));
    }
}

TEST(LongNumber, EndsOfTheRangeOfDoubles) {
    Allocator allocator;
    LongMemory memory(allocator);
    const double most = std::numeric_limits<double>::max(),
                 least = std::numeric_limits<double>::denorm_min();
    const LongNumber a = memory.number(most), b = memory.number(least);
    EXPECT_EQ(((a + b) - a - b).sign(), 0);
    EXPECT_EQ(((a * a + b * b) - a * a).sign(), 1);
    EXPECT_EQ((a * b - a * b - b * b).sign(), -1);
    EXPECT_EQ(memory.number(-0.0).sign(), 0);
    EXPECT_EQ((LongNumber() * a).sign(), 0);
    EXPECT_EQ((LongNumber() - a).sign(), -1);
    EXPECT_EQ(b.wide().in_double(), least);
    EXPECT_EQ(a.wide().in_double(), most);
    EXPECT_EQ((a * a).wide().in_double(), std::numeric_limits<double>::infinity());
    EXPECT_EQ((b * b).wide().in_double(), 0);
}

TEST(LongNumbers, KeepWhatIsSet) {
    Allocator allocator;
    LongMemory exact(allocator), cut_off(allocator, 3);
    LongNumbers kept(allocator, 4, 3);
    const LongNumber small = exact.number(5), large = exact.number(0x1p200) + small;
    EXPECT_EQ(kept[2].sign(), 0);
    kept.set(1, large);
    kept.set(2, small);
    kept.set(3, -small);
    exact.release(0);
    EXPECT_EQ(kept[2].wide().in_double(), 5);
    EXPECT_EQ(kept[3].wide().in_double(), -5);
    EXPECT_EQ(kept[1].wide().in_double(), 0x1p200);
    kept.set(1, cut_off.copy(kept[2]) + cut_off.copy(kept[2]));
    kept.set(2, LongNumber());
    EXPECT_EQ(kept[1].wide().in_double(), 10);
    EXPECT_EQ(kept[2].sign(), 0);
}

TEST(WideDouble, IsADoubleWithAnotherExponent) {
    const WideDouble large(0x1p1000), square = large * large, small = WideDouble(1) / square;
    EXPECT_EQ(square.in_double(), std::numeric_limits<double>::infinity());
    EXPECT_EQ(small.in_double(), 0);
    EXPECT_EQ((square * small).in_double(), 1);
    EXPECT_EQ((square / large).in_double(), 0x1p1000);
    EXPECT_EQ((WideDouble(3) - WideDouble(5)).in_double(), -2);
    EXPECT_EQ((square + small - square).in_double(), 0);
    EXPECT_TRUE(small < large && WideDouble() < small && !(large < large));
}

// Whatever is computed, the exact value is within the bound.
template <class B, class Make, class Value, class Error>
void expect_bounded(Make make, Value value_of_bounded, Error error_of) {
    std::mt19937_64 random(11);
    int known = 0;
    for (int k = 0; k < (is_small() ? 20 : 300); ++k) {
        B x[6];
        Rational r[6];
        for (int i = 0; i < 6; ++i) {
            x[i] = make(random);
            r[i] = value_of_bounded(x[i]);
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
            if (!(x[to].wide_error() < WideDouble(1, 100000))) break;
            EXPECT_LE(abs(value_of_bounded(x[to]) - r[to]), error_of(x[to]));
            ++known;
        }
    }
    EXPECT_GT(known, is_small() ? 100 : 2000);
}

// With exponents up to `spread` apart.
template <class Real>
void expect_floats_bounded(int spread) {
    using B = BoundedFloat<Real>;
    expect_bounded<B>(
        [&](std::mt19937_64& random) {
            const double mantissa = static_cast<double>(random() >> 11) * 0x1p-53;
            return B::number(mantissa,
                             static_cast<int>(random() % (2u * unsigned(spread) + 1)) - spread);
        },
        [&](const B& x) { return times_power_of_two(value_of(x.value), 256 * x.block); },
        [&](const B& x) { return times_power_of_two(Rational(x.error), 256 * x.block); });
}

TEST(Bounded, KnowsItsError) {
    for (const int spread : {1, 100, 300, 2000}) {
        expect_floats_bounded<double>(spread);
        expect_floats_bounded<Twofold>(spread);
    }
    Allocator allocator;
    LongMemory memory(allocator, 512 / exact::limb_bits);
    expect_bounded<BoundedLong>(
        [&](std::mt19937_64& random) {
            return BoundedLong{memory.number(std::ldexp(static_cast<double>(random() >> 11),
                                                        static_cast<int>(random() % 3))),
                               {}};
        },
        [&](const BoundedLong& x) { return value_of(x.value, memory); },
        [](const BoundedLong& x) { return value_of(x.error); });
}

TEST(BoundedFloat, IsWhatDoublesAre) {
    using B = BoundedFloat<Twofold>;
    std::mt19937_64 random(12);
    for (int k = 0; k < 3000; ++k) {
        double x[2];
        for (double& y : x)
            y = std::ldexp(static_cast<double>(random() >> 11) * 0x1p-53,
                           static_cast<int>(random() % 2040) - 1060);
        const B number = B::number(x[0]);
        EXPECT_EQ(number.wide().in_double(), x[0]);
        EXPECT_EQ(number.error, 0);
        const B difference = B::difference(x[0], x[1]);
        EXPECT_EQ(difference.wide().in_double(), x[0] - x[1]);
        EXPECT_EQ(difference.sign(), (x[0] > x[1]) - (x[0] < x[1]));
        EXPECT_EQ(B::difference(x[0], x[0]).sign(), 0);
        EXPECT_EQ((number - number).sign(), 0);
    }
    // What is not known stays so.
    const B one = B::number(1), unknown = one / (one - one), tiny = B::number(0x1p-1000);
    for (const B& x : {unknown, unknown + tiny, tiny * unknown, B::number(0) * unknown,
                       one / unknown, unknown - unknown, tiny + unknown * unknown}) {
        EXPECT_EQ(x.sign(), 2);
        EXPECT_FALSE(x.wide_error() < WideDouble(1, 100000));
    }
}

}  // namespace
}  // namespace mgdt
