// SPDX-License-Identifier: MIT
// Sums and products of doubles without limits on exponents and lengths. They are exact, for
// predicates whose operands have no common unit, or truncated to a number of limbs, for quantities
// that doubles and twofold numbers do not give accurately enough.
#pragma once

#include "platform/memory.hpp"
#include "predicates/differences.hpp"
#include "predicates/twofold.hpp"
#include "predicates/wide_double.hpp"

namespace mgdt {

class LongNumber;

// The memory for the limbs of numbers. Releasing a mark frees all numbers that are newer than the
// mark.
class LongMemory {
  public:
    // Each result is truncated to this number of limbs; 0 means that results are exact.
    explicit LongMemory(Allocator& allocator, std::size_t most_limbs = 0)
        : limbs_(allocator), most_limbs_(most_limbs) {}

    std::size_t mark() const noexcept { return limbs_.size(); }
    void release(std::size_t mark) noexcept { limbs_.resize_within_capacity(mark); }
    std::size_t most_limbs() const noexcept { return most_limbs_; }
    // An upper bound on the relative error of a sum, product or copy. The error of a quotient is at
    // most four times this bound.
    WideDouble rounding() const {
        if (most_limbs_ == 0) return {};
        return WideDouble(1, exact::limb_bits * (1 - static_cast<std::int64_t>(most_limbs_)));
    }

    // The number x times 2^exponent.
    LongNumber number(double x, std::int64_t exponent = 0);
    // Copies x, which may be in another memory, into this memory.
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

// The number +-sum of limb[i] 2^(limb_bits (unit + i)), where neither the first nor the last limb
// is 0. The boundaries between limbs are at the same positions in all numbers, so sums need no
// shifts. The operands and the result of an operation are in one memory.
class LongNumber {
  public:
    LongNumber() = default;  // 0

    // An upper bound on the relative error of the operation that gave the number.
    WideDouble rounding() const { return size_ == 0 ? WideDouble() : memory_->rounding(); }
    int sign() const noexcept { return size_ == 0 ? 0 : is_negative_ ? -1 : 1; }
    // wide() gives the number times 2^exponent, truncated to 53 bits. twofold() gives it with a
    // relative error below 2^-104, if both parts are in the range of doubles.
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
    // Division requires a memory that truncates numbers; b is not 0.
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
    // The 64 bits that begin `from` bits below the leading one.
    std::uint64_t bits(int from) const;
    // The position above the leading bit: the magnitude is below 2^top().
    std::int64_t top() const;
    // Removes limbs that are 0 at either end, and the lowest limbs beyond the memory's limit.
    void trim() noexcept;

    LongMemory* memory_ = nullptr;
    std::size_t begin_ = 0, size_ = 0;
    std::int64_t unit_ = 0;
    bool is_negative_ = false;
};

// An array of truncated numbers with its own memory, for sums of many terms.
class LongNumbers {
  public:
    // All numbers are 0.
    LongNumbers(Allocator& allocator, std::size_t size, std::size_t most_limbs);

    LongNumber operator[](std::size_t i) const noexcept { return numbers_[i]; }
    // Sets number i; x may be in another memory.
    void set(std::size_t i, const LongNumber& x);

  private:
    LongMemory memory_;
    Buffer<LongNumber> numbers_;
};

}  // namespace mgdt
