// SPDX-License-Identifier: MIT
// The classes of tetrahedra that the construction of a halo has looked at. Two tetrahedra are of
// one class if a lattice translation moves one to the other.
#pragma once

#include "periodic/image.hpp"
#include "platform/memory.hpp"
#include "platform/number_table.hpp"

namespace mgdt {

class TetrahedronClasses {
  public:
    explicit TetrahedronClasses(Allocator& allocator) : classes_(allocator), numbers_(allocator) {}

    struct Class {
        Image corners[4];     // sorted, and moved such that the multiples of the first are 0
        std::uint32_t round;  // in which its ball was looked at, counted from 1; or 0
        bool is_right;        // whether it is one of the infinite set's
    };
    // The number of the class of a tetrahedron, whose corners are in any order.
    std::uint32_t number_of(const Image (&corners)[4]);
    Class& operator[](std::uint32_t number) { return classes_[number]; }

  private:
    Buffer<Class> classes_;
    NumberTable numbers_;
};

}  // namespace mgdt
