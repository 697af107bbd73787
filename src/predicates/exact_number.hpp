// SPDX-License-Identifier: MIT
// Sums and products of doubles that are exact whatever the exponents: for predicates of any degree
// whose operands have no common unit, such as the planes of a region and the bisectors of points.
#pragma once

#include "differences.hpp"
#include "long_float.hpp"
#include "platform/memory.hpp"

namespace mgdt {

class ExactNumber;

// Holds the limbs of numbers. A number is valid until a mark that is older than it is released.
class ExactMemory {
  public:
    explicit ExactMemory(Allocator& allocator) : limbs_(allocator) {}

    std::size_t mark() const noexcept { return limbs_.size(); }
    void release(std::size_t mark) noexcept { limbs_.resize_within_capacity(mark); }

    // x times 2^exponent.
    ExactNumber number(double x, std::int64_t exponent = 0);

  private:
    friend class ExactNumber;
    // Adds room for n limbs and returns its index.
    std::size_t add(std::size_t n) {
        const std::size_t begin = limbs_.size();
        limbs_.grow(begin + n);
        limbs_.resize_within_capacity(begin + n);
        return begin;
    }

    Buffer<exact::Limb> limbs_;
};

// +-sum of limb[i] 2^(limb_bits (unit + i)), where neither the first nor the last limb is 0. The
// limbs of all numbers have the same positions, so that no sum has to shift them.
class ExactNumber {
  public:
    ExactNumber() = default;  // 0

    int sign() const noexcept { return size_ == 0 ? 0 : is_negative_ ? -1 : 1; }
    // Cut off to the leading Bits, which is a relative error below 2^(1 - Bits).
    template <int Bits>
    LongFloat<Bits> rounded() const {
        LongFloat<Bits> r;
        if (size_ == 0) return r;
        const exact::Limb* const of = limbs();
        const int shift = exact::limb_bits * static_cast<int>(size_) -
                          exact::length_of(of, static_cast<int>(size_));
        const auto limb = [&](std::int64_t i) {
            return i >= 0 ? of[static_cast<std::size_t>(i)] : exact::Limb{0};
        };
        for (int i = 0; i < r.size; ++i) {
            const std::int64_t from = static_cast<std::int64_t>(size_) - r.size + i;
            r.limb[i] =
                shift == 0 ? limb(from)
                           : static_cast<exact::Limb>(limb(from) << shift |
                                                      limb(from - 1) >> (exact::limb_bits - shift));
        }
        r.exponent = (unit_ + static_cast<std::int64_t>(size_)) * exact::limb_bits - shift;
        r.is_negative = is_negative_;
        return r;
    }

    friend ExactNumber operator-(const ExactNumber& a) {
        ExactNumber r = a;
        r.is_negative_ = !a.is_negative_;
        return r;
    }
    friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) {
        return sum(a, b, b.is_negative_);
    }
    friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) {
        return sum(a, b, !b.is_negative_);
    }
    friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) {
        return product(a, b);
    }

  private:
    friend class ExactMemory;
    ExactNumber(ExactMemory& memory, std::size_t begin, std::size_t size, std::int64_t unit,
                bool is_negative)
        : memory_(&memory), begin_(begin), size_(size), unit_(unit), is_negative_(is_negative) {}
    static ExactNumber product(const ExactNumber& a, const ExactNumber& b);
    static ExactNumber sum(const ExactNumber& a, const ExactNumber& b, bool is_b_negative);
    const exact::Limb* limbs() const noexcept { return memory_->limbs_.data() + begin_; }
    exact::Limb* limbs() noexcept { return memory_->limbs_.data() + begin_; }
    // Leaves limbs out that are 0 at either end.
    void trim() noexcept;

    ExactMemory* memory_ = nullptr;
    std::size_t begin_ = 0, size_ = 0;
    std::int64_t unit_ = 0;
    bool is_negative_ = false;
};

}  // namespace mgdt
