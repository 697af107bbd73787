// SPDX-License-Identifier: MIT
// The array of tetrahedra: with the sphere of each beside it, the two on one cache line; or, for
// half the memory, without.
#pragma once

#include "mesh/tetrahedron.hpp"
#include "platform/memory.hpp"

namespace mgdt {

// Half a cache line.
union HalfLine {
    Tetrahedron tetrahedron;
    Sphere sphere;
};
static_assert(sizeof(HalfLine) == 32);

// Four tetrahedra, looked up once.
template <bool has_spheres, class Half>
struct FourTetrahedra {
    MGDT_ALWAYS_INLINE auto& operator[](unsigned k) const noexcept { return line[k]->tetrahedron; }
    MGDT_ALWAYS_INLINE auto& sphere(unsigned k) const noexcept {
        static_assert(has_spheres);
        return line[k][1].sphere;
    }
    Half* line[4];
};

// The array for code that is compiled for one of the two ways. Half: HalfLine, maybe const.
template <bool has_spheres, class Half>
struct TetrahedronView {
    MGDT_ALWAYS_INLINE auto& operator[](std::size_t t) const noexcept {
        return line(t)->tetrahedron;
    }
    MGDT_ALWAYS_INLINE auto& sphere(std::size_t t) const noexcept {
        static_assert(has_spheres);
        return line(t)[1].sphere;
    }
    // Each given by any of its facets.
    MGDT_ALWAYS_INLINE FourTetrahedra<has_spheres, Half> four(
        const FacetCode* codes) const noexcept {
        return {
            {line(codes[0] >> 2), line(codes[1] >> 2), line(codes[2] >> 2), line(codes[3] >> 2)}};
    }
    MGDT_ALWAYS_INLINE Half* line(std::size_t t) const noexcept {
        return lines + (has_spheres ? 2 * t : t);
    }
    Half* lines;
};

class TetrahedronStore {
  public:
    explicit TetrahedronStore(Allocator& allocator) noexcept : lines_(allocator) {}

    MGDT_ALWAYS_INLINE Tetrahedron& operator[](std::size_t t) noexcept {
        return lines_[t << shift_].tetrahedron;
    }
    MGDT_ALWAYS_INLINE const Tetrahedron& operator[](std::size_t t) const noexcept {
        return lines_[t << shift_].tetrahedron;
    }
    bool has_spheres() const noexcept { return shift_ != 0; }
    // Of slot t, if there are spheres.
    MGDT_ALWAYS_INLINE Sphere& sphere(std::size_t t) noexcept { return lines_[2 * t + 1].sphere; }
    MGDT_ALWAYS_INLINE const Sphere& sphere(std::size_t t) const noexcept {
        return lines_[2 * t + 1].sphere;
    }
    template <bool with_spheres>
    MGDT_ALWAYS_INLINE TetrahedronView<with_spheres, HalfLine> view() noexcept {
        return {lines_.data()};
    }
    template <bool with_spheres>
    MGDT_ALWAYS_INLINE TetrahedronView<with_spheres, const HalfLine> view() const noexcept {
        return {lines_.data()};
    }

    // Of a slot that need not be there.
    MGDT_ALWAYS_INLINE void prefetch(std::size_t t) const noexcept {
        mgdt::prefetch(lines_.data() + (t << shift_));
    }

    MGDT_ALWAYS_INLINE std::size_t size() const noexcept { return size_; }
    MGDT_ALWAYS_INLINE std::size_t capacity() const noexcept { return capacity_; }
    // As those of Buffer.
    void reserve(std::size_t capacity) {
        if (capacity <= capacity_) return;
        lines_.reserve(capacity << shift_);
        capacity_ = capacity;
    }
    void prefault(std::size_t begin, std::size_t end) noexcept {
        lines_.prefault(begin << shift_, end << shift_);
    }
    void resize(std::size_t size) {
        reserve(size);
        resize_within_capacity(size);
    }
    MGDT_ALWAYS_INLINE void resize_within_capacity(std::size_t size) noexcept {
        size_ = size;
        lines_.resize_within_capacity(size << shift_);
    }
    void clear() noexcept { resize_within_capacity(0); }

    // Leaves the spheres out, and gives their memory back where that can be. The capacity stays.
    void drop_spheres() noexcept;
    // Makes room for spheres, which are not set. Throws std::bad_alloc with nothing changed.
    void make_room_for_spheres();

  private:
    Buffer<HalfLine> lines_;
    std::size_t size_ = 0, capacity_ = 0;
    unsigned shift_ = 1;
};

}  // namespace mgdt
