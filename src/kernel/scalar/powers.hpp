// SPDX-License-Identifier: MIT
// Powers with respect to four tetrahedra: see kernel/powers.hpp.
#pragma once

#include "kernel/sphere_source.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

using QueryRows = Query;

class FourPowers {
  public:
    template <class Spheres, class Tetrahedra>
    MGDT_ALWAYS_INLINE FourPowers(const Spheres& from, const Tetrahedra& four, const Query& q) {
        for (unsigned k = 0; k < 4; ++k) {
            const Power s = power(from.sphere(four, k), from.vertices[four[k].v[0]].x, q);
            value_[k] = s.value;
            error_[k] = s.error;
            negative_ |= static_cast<std::uint32_t>(s.value < 0) << k;
            decided_ |= static_cast<std::uint32_t>(s.is_decided()) << k;
            ghosts_ |= static_cast<std::uint32_t>(four[k].is_ghost()) << k;
        }
    }
    MGDT_ALWAYS_INLINE std::uint32_t negative() const { return negative_; }
    MGDT_ALWAYS_INLINE std::uint32_t decided() const { return decided_; }
    MGDT_ALWAYS_INLINE std::uint32_t ghosts() const { return ghosts_; }
    MGDT_ALWAYS_INLINE Power operator[](unsigned k) const { return {value_[k], error_[k]}; }
    MGDT_ALWAYS_INLINE std::uint32_t above(Power other) const {
        std::uint32_t bits = 0;
        for (unsigned k = 0; k < 4; ++k) {
            const double floor = ghosts_ >> k & 1 ? 0.0 : other.value + other.error;
            bits |= static_cast<std::uint32_t>(value_[k] - floor > error_[k]) << k;
        }
        return bits;
    }
    MGDT_ALWAYS_INLINE unsigned least_finite(double bound) const {
        unsigned best = 4;
        for (unsigned k = 0; k < 4; ++k) {
            if ((ghosts_ >> k & 1) || !(value_[k] < bound)) continue;
            bound = value_[k];
            best = k;
        }
        return best;
    }

  private:
    double value_[4], error_[4];
    std::uint32_t negative_ = 0, decided_ = 0, ghosts_ = 0;
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
