// SPDX-License-Identifier: MIT
// Exact sums and products of doubles of any exponent, against rational numbers.
#include "predicates/exact_number.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "../small.h"

namespace mgdt {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Integer = boost::multiprecision::cpp_int;

Rational times_power_of_two(const Rational& x, std::int64_t e) {
    const Rational power(Integer(1) << static_cast<unsigned>(e < 0 ? -e : e));
    return e < 0 ? Rational(x / power) : Rational(x * power);
}

template <int Bits>
Rational value_of(const LongFloat<Bits>& x) {
    Integer digits = 0;
    for (int i = x.size - 1; i >= 0; --i) digits = digits << exact::limb_bits | x.limb[i];
    const Rational r = times_power_of_two(Rational(digits), x.exponent - Bits);
    return x.is_negative ? -r : r;
}

struct Both {
    ExactNumber number;
    Rational value;
};

template <int Bits>
void expect_equal(const Both& x) {
    EXPECT_EQ(x.number.sign(), x.value.sign());
    const LongFloat<Bits> rounded = x.number.rounded<Bits>();
    const Rational error = abs(value_of(rounded) - x.value);
    EXPECT_LE(error, times_power_of_two(abs(x.value), 1 - Bits));
    EXPECT_EQ(rounded.is_zero(), x.value == 0);
}

TEST(ExactNumber, SumsAndProductsAreExact) {
    std::mt19937_64 random(2);
    Allocator allocator;
    ExactMemory memory(allocator);
    for (const int exponents : {1, 60, 2000}) {
        for (int run = 0; run < (is_small() ? 30 : 1000); ++run) {
            memory.release(0);
            std::vector<Both> all;
            const auto add_double = [&] {
                const double mantissa = run % 3 == 0
                                            ? static_cast<double>(random() % 8)
                                            : static_cast<double>(random() >> 11) * 0x1p-53;
                const int e =
                    static_cast<int>(random() % static_cast<unsigned>(exponents)) - exponents / 2;
                const double x = std::ldexp(random() % 2 ? mantissa : -mantissa, e);
                const auto more = static_cast<std::int64_t>(random() % 200) - 100;
                all.push_back({memory.number(x, more), times_power_of_two(Rational(x), more)});
            };
            for (int i = 0; i < 6; ++i) add_double();
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
            for (const Both& x : all) {
                expect_equal<128>(x);
                expect_equal<512>(x);
            }
        }
    }
}

TEST(ExactNumber, EndsOfTheRangeOfDoubles) {
    Allocator allocator;
    ExactMemory memory(allocator);
    const double most = std::numeric_limits<double>::max(),
                 least = std::numeric_limits<double>::denorm_min();
    const ExactNumber a = memory.number(most), b = memory.number(least);
    EXPECT_EQ(((a + b) - a - b).sign(), 0);
    EXPECT_EQ(((a * a + b * b) - a * a).sign(), 1);
    EXPECT_EQ((a * b - a * b - b * b).sign(), -1);
    EXPECT_EQ(memory.number(-0.0).sign(), 0);
    EXPECT_EQ((ExactNumber() * a).sign(), 0);
    EXPECT_EQ((ExactNumber() - a).sign(), -1);
    EXPECT_EQ(b.rounded<128>().in_double(), least);
    EXPECT_EQ(a.rounded<512>().in_double(), most);
}

}  // namespace
}  // namespace mgdt
