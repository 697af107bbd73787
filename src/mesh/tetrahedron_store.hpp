// SPDX-License-Identifier: MIT
// The array of tetrahedra, with the sphere of each beside it. In compact storage the spheres are
// left out, and records take two thirds of the memory.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <type_traits>

#include "mesh/tetrahedron.hpp"
#include "platform/memory.hpp"

namespace mgdt {

// The record takes three quarters of a cache line. A conflict test reads the sphere and the base
// vertex, which are adjacent. In one of four consecutive records, the two are on different cache
// lines.
struct TetrahedronAndSphere {
    KeptSphere sphere;
    Tetrahedron tetrahedron;
};
static_assert(sizeof(TetrahedronAndSphere) == 48);

struct TetrahedronAlone {
    Tetrahedron tetrahedron;
};
static_assert(sizeof(TetrahedronAlone) == 32);

// Pointers to four tetrahedra. Record is one of the two types above, possibly const.
template <class Record>
struct FourTetrahedra {
    MGDT_ALWAYS_INLINE auto& operator[](unsigned k) const noexcept {
        return record[k]->tetrahedron;
    }
    MGDT_ALWAYS_INLINE auto& sphere(unsigned k) const noexcept { return record[k]->sphere; }
    Record* record[4];
};

// A view of the array, for code that is compiled for one type of record.
template <class Record>
struct TetrahedronView {
    MGDT_ALWAYS_INLINE auto& operator[](std::size_t t) const noexcept {
        return records[t].tetrahedron;
    }
    MGDT_ALWAYS_INLINE auto& sphere(std::size_t t) const noexcept { return records[t].sphere; }
    // of() gives the tetrahedron of any facet code. of_first() requires the code of face 0, and
    // saves an instruction.
    MGDT_ALWAYS_INLINE auto& of(FacetCode code) const noexcept {
        return of_first(first_facet_of(code));
    }
    MGDT_ALWAYS_INLINE auto& of_first(FacetCode code) const noexcept {
        return record(code)->tetrahedron;
    }
    MGDT_ALWAYS_INLINE FourTetrahedra<Record> four(const FacetCode* codes) const noexcept {
        return {{record(first_facet_of(codes[0])), record(first_facet_of(codes[1])),
                 record(first_facet_of(codes[2])), record(first_facet_of(codes[3]))}};
    }
    // Prefetches the whole record, which may be on two cache lines.
    MGDT_ALWAYS_INLINE void prefetch_of(FacetCode code) const noexcept {
        const Record* const r = record(first_facet_of(code));
        mgdt::prefetch(r);
        if constexpr (sizeof(Record) > sizeof(Tetrahedron)) mgdt::prefetch(&r->tetrahedron.n);
    }
    MGDT_ALWAYS_INLINE Record* record(FacetCode first) const noexcept {
        assert(face_of(first) == 0 && "not the code of face 0");
        using Byte = std::conditional_t<std::is_const_v<Record>, const char, char>;
        return reinterpret_cast<Record*>(reinterpret_cast<Byte*>(records) +
                                         std::size_t{first} * (sizeof(Record) / 4));
    }
    Record* records;
};

class TetrahedronStore {
  public:
    template <bool with_spheres>
    using Record = std::conditional_t<with_spheres, TetrahedronAndSphere, TetrahedronAlone>;

    explicit TetrahedronStore(Allocator& allocator) noexcept : pieces_(allocator) {}

    MGDT_ALWAYS_INLINE Tetrahedron& operator[](std::size_t t) noexcept {
        assert(t < capacity_ && "there is no such slot");
        return *reinterpret_cast<Tetrahedron*>(tetrahedron(t));
    }
    MGDT_ALWAYS_INLINE const Tetrahedron& operator[](std::size_t t) const noexcept {
        assert(t < capacity_ && "there is no such slot");
        return *reinterpret_cast<const Tetrahedron*>(tetrahedron(t));
    }
    bool has_spheres() const noexcept { return sphere_ != 0; }
    // The sphere of a tetrahedron, in a store with spheres.
    MGDT_ALWAYS_INLINE static const KeptSphere& sphere_of(const Tetrahedron& t) noexcept {
        const char* const bytes = reinterpret_cast<const char*>(&t);
        return reinterpret_cast<const TetrahedronAndSphere*>(
                   bytes - offsetof(TetrahedronAndSphere, tetrahedron))
            ->sphere;
    }
    // The address of the sphere of slot t, in a store with spheres.
    MGDT_ALWAYS_INLINE KeptSphere& sphere(std::size_t t) noexcept {
        assert(t < capacity_ && "there is no such slot");
        return view<true>().sphere(t);
    }
    MGDT_ALWAYS_INLINE const KeptSphere& sphere(std::size_t t) const noexcept {
        assert(t < capacity_ && "there is no such slot");
        return view<true>().sphere(t);
    }
    template <bool with_spheres>
    MGDT_ALWAYS_INLINE TetrahedronView<Record<with_spheres>> view() noexcept {
        assert(with_spheres == has_spheres() && "records of the other kind");
        return {reinterpret_cast<Record<with_spheres>*>(pieces_.data())};
    }
    template <bool with_spheres>
    MGDT_ALWAYS_INLINE TetrahedronView<const Record<with_spheres>> view() const noexcept {
        assert(with_spheres == has_spheres() && "records of the other kind");
        return {reinterpret_cast<const Record<with_spheres>*>(pieces_.data())};
    }

    // Prefetches slot t, which need not exist.
    MGDT_ALWAYS_INLINE void prefetch(std::size_t t) const noexcept {
        mgdt::prefetch(tetrahedron(t));
    }

    MGDT_ALWAYS_INLINE std::size_t size() const noexcept { return size_; }
    MGDT_ALWAYS_INLINE std::size_t capacity() const noexcept { return capacity_; }
    // These functions work like those of Buffer, but count slots.
    void reserve(std::size_t capacity) {
        assert(capacity <= max_tetrahedra && "more slots than have codes");
        if (capacity <= capacity_) return;
        pieces_.reserve(capacity * stride());
        capacity_ = capacity;
    }
    void prefault(std::size_t begin, std::size_t end) noexcept {
        pieces_.prefault(begin * stride(), end * stride());
    }
    void resize(std::size_t size) {
        reserve(size);
        resize_within_capacity(size);
    }
    MGDT_ALWAYS_INLINE void resize_within_capacity(std::size_t size) noexcept {
        assert(size <= capacity_ && "the size is beyond the capacity");
        size_ = size;
        pieces_.resize_within_capacity(size * stride());
    }
    void clear() noexcept { resize_within_capacity(0); }

    // Removes the spheres, and gives their memory back if the allocator can shrink the block. The
    // capacity stays.
    void drop_spheres() noexcept;
    // Gives unused storage back, if the allocator can shrink the block.
    void shrink() noexcept {
        pieces_.shrink();
        // If the allocator refused to shrink the block in drop_spheres(), the block is larger than
        // the capacity needs.
        capacity_ = std::min(capacity_, pieces_.capacity() / stride());
    }
    // Makes room for spheres and leaves them unset. Throws std::bad_alloc with nothing changed.
    void make_room_for_spheres();

  private:
    struct alignas(16) Piece {
        unsigned char bytes[16];
    };
    MGDT_ALWAYS_INLINE std::size_t stride() const noexcept { return 2 + sphere_; }
    MGDT_ALWAYS_INLINE Piece* tetrahedron(std::size_t t) noexcept {
        return pieces_.data() + (t * stride() + sphere_);
    }
    MGDT_ALWAYS_INLINE const Piece* tetrahedron(std::size_t t) const noexcept {
        return pieces_.data() + (t * stride() + sphere_);
    }

    Buffer<Piece> pieces_;
    std::size_t size_ = 0, capacity_ = 0;
    std::size_t sphere_ = 1;  // the number of pieces per sphere: 1, or 0 in compact storage
};

}  // namespace mgdt
