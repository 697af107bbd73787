// SPDX-License-Identifier: MIT
#include "periodic/tetrahedron_classes.hpp"

namespace mgdt {

std::uint32_t TetrahedronClasses::number_of(const Image (&corners)[4]) {
    Class its = {{}, 0, false};
    for (unsigned i = 0; i < 4; ++i) {
        unsigned k = i;
        for (; k > 0 && is_before(corners[i], its.corners[k - 1]); --k)
            its.corners[k] = its.corners[k - 1];
        its.corners[k] = corners[i];
    }
    std::uint32_t hash = 0;
    const Multiples first = its.corners[0].multiples();
    for (Image& corner : its.corners) {
        corner = image_of(corner.point, corner.multiples() - first);
        hash = hash_of_words(hash, hash_of(corner));
    }
    numbers_.reserve(classes_.size() + 1);
    const std::uint32_t number = numbers_.number(hash ^ hash >> 15, [&](std::uint32_t i) {
        return std::equal(its.corners, its.corners + 4, classes_[i].corners, are_equal);
    });
    if (number == classes_.size()) classes_.push_back(its);
    return number;
}

}  // namespace mgdt
