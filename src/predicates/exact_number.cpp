// SPDX-License-Identifier: MIT
#include "exact_number.hpp"

#include <algorithm>

namespace mgdt {

using exact::Limb;
using exact::limb_bits;

ExactNumber ExactMemory::number(double x, std::int64_t exponent) {
    if (x == 0) return {};
    std::int64_t mantissa;
    int of_mantissa;
    exact::take_apart(x, mantissa, of_mantissa);
    exponent += of_mantissa;
    // Division that rounds down.
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
    ExactNumber r(*this, begin, count, unit, mantissa < 0);
    r.trim();
    return r;
}

void ExactNumber::trim() noexcept {
    const Limb* const limb = limbs();
    while (size_ > 0 && limb[size_ - 1] == 0) --size_;
    std::size_t zeros = 0;
    while (zeros < size_ && limb[zeros] == 0) ++zeros;
    begin_ += zeros;
    size_ -= zeros;
    unit_ += static_cast<std::int64_t>(zeros);
}

ExactNumber ExactNumber::product(const ExactNumber& a, const ExactNumber& b) {
    if (a.size_ == 0 || b.size_ == 0) return {};
    const std::size_t begin = a.memory_->add(a.size_ + b.size_);
    ExactNumber r(*a.memory_, begin, a.size_ + b.size_, a.unit_ + b.unit_,
                  a.is_negative_ != b.is_negative_);
    Limb* const to = r.limbs();
    std::fill_n(to, r.size_, Limb{0});
    for (std::size_t i = 0; i < a.size_; ++i)
        to[i + b.size_] =
            exact::add_row(to + i, a.limbs()[i], b.limbs(), static_cast<int>(b.size_));
    r.trim();
    return r;
}

ExactNumber ExactNumber::sum(const ExactNumber& a, const ExactNumber& b, bool is_b_negative) {
    if (b.size_ == 0) return a;
    if (a.size_ == 0) {
        ExactNumber r = b;
        r.is_negative_ = is_b_negative;
        return r;
    }
    const auto top = [](const ExactNumber& x) {
        return x.unit_ + static_cast<std::int64_t>(x.size_);
    };
    const std::int64_t unit = std::min(a.unit_, b.unit_);
    // A limb more, for the carry.
    const auto size = static_cast<std::size_t>(std::max(top(a), top(b)) - unit + 1);
    const std::size_t begin = a.memory_->add(size);
    ExactNumber r(*a.memory_, begin, size, unit, a.is_negative_);
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

}  // namespace mgdt
