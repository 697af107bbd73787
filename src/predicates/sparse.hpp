// SPDX-License-Identifier: MIT
// Exact numbers whose bits are in a few clusters, however far apart: sums of integers times powers
// of two. The cost of a determinant depends on the clusters and not on the distances between them.
// See docs/theory.md, "Sparse integers".
#pragma once

#include "predicates/differences.hpp"

namespace mgdt::exact {

// In a product of two sparse numbers, at most 2^merge_bits products of factors have the same
// exponent: at most one for each term of the first number.
constexpr int merge_bits = 5;

// The sum of factor[i] * 2^exponent[i], in descending order of exponents.
template <int Bits>
struct Sparse {
    static constexpr int capacity = 24;
    static_assert(capacity <= 1 << merge_bits);

    int count = 0;  // if it exceeds the capacity, terms were lost and the number is meaningless
    int exponent[capacity];
    Integer<Bits> factor[capacity];

    bool is_lost() const { return count > capacity; }
    void lose() { count = capacity + 1; }
    // Adds or subtracts f * 2^e. The sum of all factors with this exponent has to fit.
    template <bool Negative = false, int B>
    void add(int e, const Integer<B>& f) {
        int at = count;
        while (at > 0 && exponent[at - 1] < e) --at;
        if (at > 0 && exponent[at - 1] == e) {
            Integer<Bits>& there = factor[at - 1];
            there = Negative ? narrowed<Bits>(there - f) : narrowed<Bits>(there + f);
            return;
        }
        if (count >= capacity) return lose();
        for (int i = count++; i > at; --i) {
            exponent[i] = exponent[i - 1];
            factor[i] = factor[i - 1];
        }
        exponent[at] = e;
        factor[at] = Negative ? narrowed<Bits>(shifted<Bits>(0, 0) - f) : narrowed<Bits>(f);
    }
    template <bool Negative = false, int B>
    void add(const Sparse<B>& other) {
        if (is_lost() || other.is_lost()) return lose();
        for (int i = 0; i < other.count && !is_lost(); ++i)
            add<Negative>(other.exponent[i], other.factor[i]);
    }
};

template <int A, int B>
Sparse<sum_bits(A, B)> operator+(const Sparse<A>& a, const Sparse<B>& b) {
    Sparse<sum_bits(A, B)> r;
    r.add(a);
    r.add(b);
    return r;
}

template <int A, int B>
Sparse<sum_bits(A, B)> operator-(const Sparse<A>& a, const Sparse<B>& b) {
    Sparse<sum_bits(A, B)> r;
    r.add(a);
    r.template add<true>(b);
    return r;
}

template <int A, int B>
Sparse<A + B - 1 + merge_bits> operator*(const Sparse<A>& a, const Sparse<B>& b) {
    Sparse<A + B - 1 + merge_bits> r;
    if (a.is_lost() || b.is_lost()) {
        r.lose();
        return r;
    }
    for (int i = 0; i < a.count; ++i)
        for (int j = 0; j < b.count && !r.is_lost(); ++j)
            r.add(a.exponent[i] + b.exponent[j], a.factor[i] * b.factor[j]);
    return r;
}

// The sign, or `undecided` if terms were lost. Terms are added from the highest on, until the
// remaining terms cannot change the sign: there are fewer than 2^merge_bits of them, each below
// 2^(Bits - 1) units of the next term.
template <int Bits>
int sign(const Sparse<Bits>& a) {
    if (a.is_lost()) return undecided;
    constexpr int enough = Bits + merge_bits;
    Integer<enough + 3> sum = shifted<enough + 3>(0, 0);
    for (int i = 0; i < a.count; ++i) {
        if (i > 0 && sign(sum) != 0) {
            const int shift = a.exponent[i - 1] - a.exponent[i];
            if (length(sum) + shift > enough) return sign(sum);
            sum = shifted_left(sum, shift);
        }
        sum = narrowed<enough + 3>(sum + a.factor[i]);
    }
    return sign(sum);
}

// The differences of points as sparse numbers, if their bits are in a few clusters of at most Bits
// - 2 bits.
template <int N, int Bits>
class SparseDifferences {
  public:
    explicit SparseDifferences(const ExactDifferences<N>& d) {
        Part parts[2 * N];
        int count = 0;
        for (int i = 0; i < N; ++i)
            for (const double v : {d.first[i], d.second[i]})
                if (v != 0) insert(parts, count++, Part(v, i));
        // Divide the parts into clusters, from the highest to the lowest.
        int clusters = 0, top = 0, begin = 0;
        for (int i = 0; i <= count; ++i) {
            if (i < count && i > begin && parts[i].bottom >= top - (Bits - 2)) continue;
            if (i > begin) close(parts + begin, parts + i);
            if (i == count) break;
            if (++clusters > most_clusters) return;
            begin = i;
            top = parts[i].top;
        }
        is_good_ = true;
    }

    bool is_good() const { return is_good_; }
    // Whether each difference is one integer times a power of two.
    bool is_single() const {
        for (const Sparse<Bits>& v : value)
            if (v.count > 1) return false;
        return true;
    }

    Sparse<Bits> value[N];

  private:
    static constexpr int most_clusters = 6;

    // One of the two doubles that add up to difference `of`: mantissa * 2^exponent.
    struct Part {
        Part() = default;
        Part(double v, int difference) : of(difference) {
            take_apart(v, mantissa, exponent);
            top = exponent + 53;
            bottom = exponent + trailing_zeros(static_cast<std::uint64_t>(mantissa));
        }
        std::int64_t mantissa;
        int exponent, top, bottom, of;
    };

    // Inserts a part in descending order of the leading bits.
    static void insert(Part* parts, int count, const Part& part) {
        int at = count;
        for (; at > 0 && parts[at - 1].top < part.top; --at) parts[at] = parts[at - 1];
        parts[at] = part;
    }
    void close(const Part* begin, const Part* end) {
        int unit = begin->bottom;
        for (const Part* p = begin; p != end; ++p) unit = p->bottom < unit ? p->bottom : unit;
        for (const Part* p = begin; p != end; ++p)
            value[p->of].add(unit, shifted<Bits>(p->mantissa, p->exponent - unit));
    }

    bool is_good_ = false;
};

}  // namespace mgdt::exact
