// SPDX-License-Identifier: MIT
// Sums and products of doubles whose exponents and lengths have no limit: exact, for predicates
// whose operands have no common unit, or cut off to a number of limbs, for what has to be measured
// where doubles and twofold numbers do not do.
#pragma once

#include "platform/memory.hpp"
#include "predicates/differences.hpp"
#include "predicates/twofold.hpp"
#include "predicates/wide_double.hpp"

namespace mgdt {

class LongNumber;

// Holds the limbs of numbers. A number is valid until a mark that is older than it is released.
class LongMemory {
  public:
    // Each result is cut off to this number of limbs; with 0 it is exact.
    explicit LongMemory(Allocator& allocator, std::size_t most_limbs = 0)
        : limbs_(allocator), most_limbs_(most_limbs) {}

    std::size_t mark() const noexcept { return limbs_.size(); }
    void release(std::size_t mark) noexcept { limbs_.resize_within_capacity(mark); }
    std::size_t most_limbs() const noexcept { return most_limbs_; }
    // Bounds the relative error of a sum, product, copy or, but for a factor of 4, quotient.
    WideDouble rounding() const {
        if (most_limbs_ == 0) return {};
        return WideDouble(1, exact::limb_bits * (1 - static_cast<std::int64_t>(most_limbs_)));
    }

    // x times 2^exponent.
    LongNumber number(double x, std::int64_t exponent = 0);
    // The same number here.
    LongNumber copy(const LongNumber& x);

  private:
    friend class LongNumber;
    friend class LongNumbers;
    // Adds room for n limbs and returns its index.
    std::size_t add(std::size_t n) {
        const std::size_t begin = limbs_.size();
        limbs_.grow(begin + n);
        limbs_.resize_within_capacity(begin + n);
        return begin;
    }

    Buffer<exact::Limb> limbs_;
    std::size_t most_limbs_;
};

// +-sum of limb[i] 2^(limb_bits (unit + i)), where neither the first nor the last limb is 0. The
// limbs of all numbers have the same positions, so that no sum has to shift them. A result is in
// the memory of the operands, which is one.
class LongNumber {
  public:
    LongNumber() = default;  // 0

    // Bounds the relative error of the operation that gave it.
    WideDouble rounding() const { return size_ == 0 ? WideDouble() : memory_->rounding(); }
    int sign() const noexcept { return size_ == 0 ? 0 : is_negative_ ? -1 : 1; }
    // Times 2^exponent. Cut off to 53 bits; to twice as many, with an error below 2^-104 of the
    // number, where the exponents of both parts are those of doubles.
    WideDouble wide(std::int64_t exponent = 0) const;
    Twofold twofold(std::int64_t exponent = 0) const;

    friend LongNumber operator-(const LongNumber& a) {
        LongNumber r = a;
        r.is_negative_ = !a.is_negative_;
        return r;
    }
    friend LongNumber operator+(const LongNumber& a, const LongNumber& b) {
        return sum(a, b, b.is_negative_);
    }
    friend LongNumber operator-(const LongNumber& a, const LongNumber& b) {
        return sum(a, b, !b.is_negative_);
    }
    friend LongNumber operator*(const LongNumber& a, const LongNumber& b) { return product(a, b); }
    // Of numbers in a memory that cuts them off; b is not 0.
    friend LongNumber operator/(const LongNumber& a, const LongNumber& b) { return a * inverse(b); }

  private:
    friend class LongMemory;
    friend class LongNumbers;
    LongNumber(LongMemory& memory, std::size_t begin, std::size_t size, std::int64_t unit,
               bool is_negative)
        : memory_(&memory), begin_(begin), size_(size), unit_(unit), is_negative_(is_negative) {}
    static LongNumber sum(const LongNumber& a, const LongNumber& b, bool is_b_negative);
    static LongNumber product(const LongNumber& a, const LongNumber& b);
    static LongNumber inverse(const LongNumber& b);
    const exact::Limb* limbs() const noexcept { return memory_->limbs_.data() + begin_; }
    exact::Limb* limbs() noexcept { return memory_->limbs_.data() + begin_; }
    // The 64 bits from bit `from` below the leading one on.
    std::uint64_t bits(int from) const;
    // Of the leading bit, so that the magnitude is below 2^top().
    std::int64_t top() const;
    // Leaves limbs out that are 0 at either end, and those beyond the memory's limit.
    void trim() noexcept;

    LongMemory* memory_ = nullptr;
    std::size_t begin_ = 0, size_ = 0;
    std::int64_t unit_ = 0;
    bool is_negative_ = false;
};

// An array of numbers that are cut off, which stay there: for sums of many terms.
class LongNumbers {
  public:
    // All are 0.
    LongNumbers(Allocator& allocator, std::size_t size, std::size_t most_limbs);

    LongNumber operator[](std::size_t i) const noexcept { return numbers_[i]; }
    // Its operand may be in another memory.
    void set(std::size_t i, const LongNumber& x);

  private:
    LongMemory memory_;
    Buffer<LongNumber> numbers_;
};

}  // namespace mgdt
