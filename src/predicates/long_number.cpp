// SPDX-License-Identifier: MIT
#include "predicates/long_number.hpp"

#include <algorithm>

namespace mgdt {

using exact::Limb;
using exact::limb_bits;

LongNumber LongMemory::number(double x, std::int64_t exponent) {
    if (x == 0) return {};
    std::int64_t mantissa;
    int of_mantissa;
    exact::take_apart(x, mantissa, of_mantissa);
    exponent += of_mantissa;
    // The division rounds down, also for negative exponents.
    const std::int64_t unit = (exponent - (exponent < 0 ? limb_bits - 1 : 0)) / limb_bits;
    const auto shift = static_cast<int>(exponent - unit * limb_bits);
    constexpr int count = exact::limb_count(53 + limb_bits);
    const std::size_t begin = add(count);
    Limb* const limb = limbs_.data() + begin;
    const auto bits = static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa);
    for (int i = 0; i < count; ++i) {
        const int from = i * limb_bits - shift;  // the bit of the mantissa that is the limb's first
        limb[i] = from >= 64 || from <= -limb_bits ? 0
                  : from >= 0                      ? static_cast<Limb>(bits >> from)
                                                   : static_cast<Limb>(bits << -from);
    }
    LongNumber r(*this, begin, count, unit, mantissa < 0);
    r.trim();
    return r;
}

void LongNumber::trim() noexcept {
    const Limb* const limb = limbs();
    while (size_ > 0 && limb[size_ - 1] == 0) --size_;
    const std::size_t most = memory_->most_limbs_;
    std::size_t zeros = most != 0 && size_ > most ? size_ - most : 0;
    while (zeros < size_ && limb[zeros] == 0) ++zeros;
    begin_ += zeros;
    size_ -= zeros;
    unit_ += static_cast<std::int64_t>(zeros);
}

// Sums and products of numbers whose exponents are far apart have many limbs that are 0. The
// operand with fewer nonzero limbs is the multiplier, since its zero limbs are skipped.
LongNumber LongNumber::product(const LongNumber& a, const LongNumber& b) {
    if (a.size_ == 0 || b.size_ == 0) return {};
    const std::size_t begin = a.memory_->add(a.size_ + b.size_);
    LongNumber r(*a.memory_, begin, a.size_ + b.size_, a.unit_ + b.unit_,
                 a.is_negative_ != b.is_negative_);
    Limb* const to = r.limbs();
    std::fill_n(to, r.size_, Limb{0});
    const auto rows = [](const LongNumber& x) {
        return x.size_ -
               static_cast<std::size_t>(std::count(x.limbs(), x.limbs() + x.size_, Limb{0}));
    };
    const bool is_a_first = rows(a) <= rows(b);
    const LongNumber &x = is_a_first ? a : b, &y = is_a_first ? b : a;
    for (std::size_t i = 0; i < x.size_; ++i) {
        const Limb limb = x.limbs()[i];
        if (limb != 0)
            to[i + y.size_] = exact::add_row(to + i, limb, y.limbs(), static_cast<int>(y.size_));
    }
    r.trim();
    return r;
}

LongNumber LongNumber::sum(const LongNumber& a, const LongNumber& b, bool is_b_negative) {
    if (b.size_ == 0) return a;
    if (a.size_ == 0) {
        LongNumber r = b;
        r.is_negative_ = is_b_negative;
        return r;
    }
    const auto top = [](const LongNumber& x) {
        return x.unit_ + static_cast<std::int64_t>(x.size_);
    };
    const std::int64_t unit = std::min(a.unit_, b.unit_);
    // The result has one limb more, for the carry.
    const auto size = static_cast<std::size_t>(std::max(top(a), top(b)) - unit + 1);
    const std::size_t begin = a.memory_->add(size);
    LongNumber r(*a.memory_, begin, size, unit, a.is_negative_);
    Limb* const to = r.limbs();
    std::fill_n(to, size, Limb{0});
    std::copy_n(a.limbs(), a.size_, to + (a.unit_ - unit));
    const bool is_sum = a.is_negative_ == is_b_negative;
    const Limb* const of_b = b.limbs();
    Limb carry = 0;
    for (auto i = static_cast<std::size_t>(b.unit_ - unit), j = std::size_t{0};
         i < size && (j < b.size_ || carry != 0); ++i, ++j) {
        const Limb limb = j < b.size_ ? of_b[j] : 0;
        carry = is_sum ? exact::add_with_carry(to[i], limb, carry)
                       : exact::subtract_with_borrow(to[i], limb, carry);
    }
    if (!is_sum && exact::take_sign(to, static_cast<int>(size))) r.is_negative_ = !r.is_negative_;
    r.trim();
    return r;
}

LongNumber LongMemory::copy(const LongNumber& x) {
    if (x.size_ == 0) return {};
    const std::size_t begin = add(x.size_);
    std::copy_n(x.limbs(), x.size_, limbs_.data() + begin);
    LongNumber r(*this, begin, x.size_, x.unit_, x.is_negative_);
    r.trim();
    return r;
}

std::int64_t LongNumber::top() const {
    return unit_ * limb_bits + exact::length_of(limbs(), static_cast<int>(size_));
}

std::uint64_t LongNumber::bits(int from) const {
    const Limb* const of = limbs();
    // The position of the last of the 64 bits.
    const int last = exact::length_of(of, static_cast<int>(size_)) - from - 64;
    std::uint64_t bits = 0;
    for (int i = static_cast<int>(size_) - 1; i >= 0; --i) {
        const int shift = i * limb_bits - last;
        if (shift >= 64) continue;
        if (shift <= -limb_bits) break;
        bits |= shift >= 0 ? static_cast<std::uint64_t>(of[i]) << shift
                           : static_cast<std::uint64_t>(of[i]) >> -shift;
    }
    return bits;
}

WideDouble LongNumber::wide(std::int64_t exponent) const {
    if (size_ == 0) return {};
    const auto mantissa = static_cast<double>(bits(0) >> 11);
    return WideDouble(is_negative_ ? -mantissa : mantissa, top() - 53 + exponent);
}

Twofold LongNumber::twofold(std::int64_t exponent) const {
    const double high = wide(exponent).in_double();
    if (size_ == 0) return {0, 0};
    const auto rest = static_cast<double>(bits(53) >> 11);
    const double low = WideDouble(rest, top() - 106 + exponent).in_double();
    return Twofold::sum(high, is_negative_ ? -low : low);
}

// The reciprocal of b by Newton's method. Each step doubles the number of correct bits.
LongNumber LongNumber::inverse(const LongNumber& b) {
    LongMemory& memory = *b.memory_;
    const WideDouble start = WideDouble(1) / b.wide();
    LongNumber x = memory.number(start.mantissa, start.exponent);
    const LongNumber one = memory.number(1);
    const auto most = static_cast<int>(memory.most_limbs_) * limb_bits;
    for (int digits = 48; digits < most; digits *= 2) x = x + x * (one - b * x);
    return x;
}

LongNumbers::LongNumbers(Allocator& allocator, std::size_t size, std::size_t most_limbs)
    : memory_(allocator, most_limbs), numbers_(allocator) {
    memory_.add(bytes_of(size, most_limbs));
    numbers_.resize(size, LongNumber());
}

void LongNumbers::set(std::size_t i, const LongNumber& x) {
    LongNumber& to = numbers_[i];
    to = LongNumber();
    if (x.size_ == 0) return;
    const std::size_t most = memory_.most_limbs_, size = std::min(x.size_, most),
                      cut = x.size_ - size;
    to = LongNumber(memory_, i * most, size, x.unit_ + static_cast<std::int64_t>(cut),
                    x.is_negative_);
    std::copy_n(x.limbs() + cut, size, to.limbs());
    to.trim();
}

}  // namespace mgdt
