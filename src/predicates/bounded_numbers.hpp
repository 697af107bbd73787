// SPDX-License-Identifier: MIT
// Two number systems with error bounds and one interface: BoundedFloats (doubles and
// double-doubles) and BoundedLongs (long numbers). Each class creates numbers and arrays of
// numbers. forget() frees intermediate results; the numbers in arrays remain valid.
#pragma once

#include "predicates/bounded_float.hpp"
#include "predicates/bounded_long.hpp"

namespace mgdt {

template <class Real>
class BoundedFloats {
  public:
    using B = BoundedFloat<Real>;
    static B number(double x, std::int64_t exponent = 0) { return B::number(x, exponent); }
    static B number(const WideDouble& x, const WideDouble& error) {
        return B::with_error(x, error);
    }
    static B difference(double a, double b) { return B::difference(a, b); }
    void forget() {}

    class Array {
      public:
        Array(Allocator& allocator, std::size_t size) : numbers_(allocator) {
            numbers_.resize(size, B::number(0));
        }
        B get(const BoundedFloats&, std::size_t i) const { return numbers_[i]; }
        void set(std::size_t i, const B& x) { numbers_[i] = x; }

      private:
        Buffer<B> numbers_;
    };
    Array array(Allocator& allocator, std::size_t size) const { return Array(allocator, size); }
};

// Long numbers that are truncated to a fixed number of limbs.
class BoundedLongs {
  public:
    using B = BoundedLong;
    BoundedLongs(Allocator& allocator, std::size_t limbs) : memory_(allocator, limbs) {}
    B number(double x, std::int64_t exponent = 0) { return {memory_.number(x, exponent), {}}; }
    B number(const WideDouble& x, const WideDouble& error) {
        return {memory_.number(x.mantissa, x.exponent), error};
    }
    B difference(double a, double b) { return number(a) - number(b); }
    void forget() { memory_.release(0); }

    class Array {
      public:
        Array(Allocator& allocator, std::size_t size, std::size_t limbs)
            : numbers_(allocator, size, limbs), errors_(allocator) {
            errors_.resize(size, WideDouble());
        }
        B get(BoundedLongs& in, std::size_t i) const {
            return {in.memory_.copy(numbers_[i]), errors_[i]};
        }
        void set(std::size_t i, const B& x) {
            numbers_.set(i, x.value);
            errors_[i] = x.error;
        }

      private:
        LongNumbers numbers_;
        Buffer<WideDouble> errors_;
    };
    Array array(Allocator& allocator, std::size_t size) const {
        return Array(allocator, size, memory_.most_limbs());
    }

  private:
    LongMemory memory_;
};

}  // namespace mgdt
