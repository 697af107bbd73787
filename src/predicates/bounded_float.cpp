// SPDX-License-Identifier: MIT
#include "predicates/bounded_float.hpp"

namespace mgdt {

bool round_to_nearest(const BoundedFloat<Twofold>& x, std::int64_t exponent, double& r) {
    if (x.sign() == 2) return false;
    const double high = x.value.high;
    r = high;
    if (high == 0) return true;
    int of_high;
    const double mantissa = std::frexp(high, &of_high);
    const std::int64_t of_unit = 256 * x.block + exponent, of_result = of_unit + of_high;
    if (of_result > 1026 && x.error < 0.5 * std::fabs(high)) {
        r = std::copysign(std::numeric_limits<double>::infinity(), high);
        return true;
    }
    // The sign is known: the error is less than the value.
    if (of_result < -1080) {
        r = std::copysign(0.0, high);
        return true;
    }
    // Half the distance to the next double. Below a power of two, the next double towards 0 is
    // closer.
    const double half = std::ldexp(1, of_high - (std::fabs(mantissa) == 0.5 ? 55 : 54));
    if (of_result < -1019 || of_result > 1023) return false;
    if (!(std::fabs(x.value.low) + x.error * (1 + 0x1p-40) < half)) return false;
    r = std::ldexp(high, static_cast<int>(of_unit));
    return true;
}

}  // namespace mgdt
