// SPDX-License-Identifier: MIT
// The results of a part: numbers, arrays and coordinates.
#include <algorithm>

#include "capi/parts_handle.hpp"

using namespace mgdt;

namespace {

// A part of this process and its triangulation. The index base is added to all numbers.
class View {
  public:
    // The triangulation of `p` must exist.
    View(const mgdt_parts& p, PartId i)
        : p_(p),
          all_(*p.triangulation),
          part_(all_.local(i)),
          tetrahedra_(all_.tetrahedra(i)),
          i_(i),
          base_(p.index_base) {}

    std::size_t own_vertices() const { return part_.own_count(); }
    std::size_t vertices() const { return own_vertices() + tetrahedra_.ghosts().size(); }
    std::size_t received() const { return part_.point_count() - part_.own_count(); }
    const PartTetrahedra& tetrahedra() const { return tetrahedra_; }
    const PartPoint& vertex(std::size_t k) const {
        return part_.point(k < own_vertices() ? static_cast<std::uint32_t>(k)
                                              : tetrahedra_.ghosts()[k - own_vertices()]);
    }

    std::size_t size(std::int32_t array) const {
        switch (array) {
            case MGDT_PARTS_POINT_MAP:
                return all_.vertices_of_given(i_).size();
            case MGDT_PARTS_VERTEX_NUMBERS:
            case MGDT_PARTS_VERTEX_IDS:
            case MGDT_PARTS_VERTEX_OWNERS:
                return vertices();
            case MGDT_PARTS_CORNERS:
            case MGDT_PARTS_LOCAL_CORNERS:
                return 4 * tetrahedra_.size();
            case MGDT_PARTS_TETRAHEDRON_NUMBERS:
            case MGDT_PARTS_TETRAHEDRON_OWNERS:
                return tetrahedra_.size();
            case MGDT_PARTS_NEIGHBORS:
                return 4 * tetrahedra_.owned();
            case MGDT_PARTS_TETRAHEDRON_RANGES:
                return all_.first_tetrahedra().size();
            default:  // the ranges of vertices
                return all_.first_vertices().size();
        }
    }
    void write(std::int32_t array, std::int64_t* values) const {
        switch (array) {
            case MGDT_PARTS_POINT_MAP:
                copy(all_.vertices_of_given(i_), values);
                break;
            case MGDT_PARTS_VERTEX_NUMBERS:
                for (std::size_t k = 0; k < vertices(); ++k) values[k] = vertex(k).number + base_;
                break;
            case MGDT_PARTS_VERTEX_IDS:
                // Ids of the caller are returned as they were given.
                for (std::size_t k = 0; k < vertices(); ++k)
                    values[k] = vertex(k).id + (p_.has_ids ? 0 : base_);
                break;
            case MGDT_PARTS_VERTEX_OWNERS:
                for (std::size_t k = 0; k < vertices(); ++k) values[k] = owner(vertex(k).number);
                break;
            case MGDT_PARTS_VERTEX_RANGES:
                copy(all_.first_vertices(), values);
                break;
            case MGDT_PARTS_CORNERS:
                tetrahedra_.get_vertices(part_, values);
                add_base(array, values);
                break;
            case MGDT_PARTS_LOCAL_CORNERS:
                tetrahedra_.get_positions(part_, values);
                add_base(array, values);
                break;
            case MGDT_PARTS_TETRAHEDRON_NUMBERS:
                for (std::size_t k = 0; k < tetrahedra_.size(); ++k)
                    values[k] = tetrahedra_.number(k) + base_;
                break;
            case MGDT_PARTS_TETRAHEDRON_OWNERS:
                for (std::size_t k = 0; k < tetrahedra_.size(); ++k)
                    values[k] = tetrahedra_.owner(k);
                break;
            case MGDT_PARTS_TETRAHEDRON_RANGES:
                copy(all_.first_tetrahedra(), values);
                break;
            default:  // neighbours
                tetrahedra_.get_neighbors(part_, values);
                add_base(array, values);
        }
    }

  private:
    void copy(const Buffer<std::int64_t>& from, std::int64_t* to) const {
        for (const std::int64_t value : from) *to++ = value + base_;
    }
    void add_base(std::int32_t array, std::int64_t* values) const {
        if (base_ == 0) return;
        const std::size_t n = size(array);
        for (std::size_t k = 0; k < n; ++k) values[k] += base_;
    }
    PartId owner(std::int64_t number) const {
        const Buffer<std::int64_t>& first = all_.first_vertices();
        return static_cast<PartId>(std::upper_bound(first.begin(), first.end(), number) -
                                   first.begin() - 1);
    }

    const mgdt_parts& p_;
    const Parts& all_;
    const Part& part_;
    const PartTetrahedra& tetrahedra_;
    PartId i_;
    std::int64_t base_;
};

// The number of elements of an array; 0 without a triangulation. Throws for an unknown array.
std::size_t size_of(const mgdt_parts& p, std::int32_t part, std::int32_t array) {
    const PartId i = p.local(part);
    switch (array) {
        case MGDT_PARTS_TETRAHEDRON_NUMBERS:
        case MGDT_PARTS_TETRAHEDRON_OWNERS:
        case MGDT_PARTS_NEIGHBORS:
            if (p.triangulation && !p.keeps_tetrahedra)
                fail(MGDT_ERR_INVALID_ARGUMENT,
                     "array %d is not known where there is one part at a time",
                     static_cast<int>(array));
            return p.triangulation ? View(p, i).size(array) : 0;
        case MGDT_PARTS_POINT_MAP:
        case MGDT_PARTS_VERTEX_NUMBERS:
        case MGDT_PARTS_VERTEX_IDS:
        case MGDT_PARTS_VERTEX_OWNERS:
        case MGDT_PARTS_VERTEX_RANGES:
        case MGDT_PARTS_CORNERS:
        case MGDT_PARTS_LOCAL_CORNERS:
        case MGDT_PARTS_TETRAHEDRON_RANGES:
            return p.triangulation ? View(p, i).size(array) : 0;
        default:
            fail(MGDT_ERR_UNKNOWN_KEY, "there is no array %d", static_cast<int>(array));
    }
}

std::size_t statistic(const mgdt_parts& p, PartId i, std::int32_t key) {
    const bool is_built = p.triangulation != nullptr;
    switch (key) {
        case MGDT_PARTS_PARTS:
            return p.collective.parts();
        case MGDT_PARTS_FIRST_LOCAL:
            return p.first_local();
        case MGDT_PARTS_LOCAL_PARTS:
            return p.local_parts();
        case MGDT_PARTS_POINTS:
            return p.given[i].count();
        case MGDT_PARTS_OWN_VERTICES:
            return is_built ? View(p, i).own_vertices() : 0;
        case MGDT_PARTS_VERTICES:
            return is_built ? View(p, i).vertices() : 0;
        case MGDT_PARTS_ALL_VERTICES:
            return is_built ? static_cast<std::size_t>(p.triangulation->first_vertices().back())
                            : 0;
        case MGDT_PARTS_OWN_TETRAHEDRA:
            return is_built ? View(p, i).tetrahedra().owned() : 0;
        case MGDT_PARTS_TETRAHEDRA:
            return is_built ? View(p, i).tetrahedra().size() : 0;
        case MGDT_PARTS_ALL_TETRAHEDRA:
            return is_built ? static_cast<std::size_t>(p.triangulation->first_tetrahedra().back())
                            : 0;
        case MGDT_PARTS_RECEIVED:
            return is_built ? View(p, i).received() : 0;
        case MGDT_PARTS_MEMORY_BYTES:
            return p.allocator.bytes() +
                   (is_built && !p.passes_through ? p.triangulation->bytes() : 0);
        default:
            fail(MGDT_ERR_UNKNOWN_KEY, "there is no number %d", static_cast<int>(key));
    }
}

}  // namespace

extern "C" mgdt_status mgdt_parts_get_stat(const mgdt_parts* p, int32_t part, int32_t key,
                                           int64_t* value) {
    return guard(p, [&] {
        require_pointer(value, "value");
        *value = static_cast<std::int64_t>(statistic(*p, p->local(part), key));
    });
}

extern "C" mgdt_status mgdt_parts_get_size(const mgdt_parts* p, int32_t part, int32_t array,
                                           int64_t* size) {
    return guard(p, [&] {
        require_pointer(size, "size");
        *size = static_cast<std::int64_t>(size_of(*p, part, array));
    });
}

extern "C" mgdt_status mgdt_parts_get_array(const mgdt_parts* p, int32_t part, int32_t array,
                                            int64_t capacity, int64_t* values) {
    return guard(p, [&] {
        const std::size_t size = size_of(*p, part, array);
        require_capacity(capacity, size, "values");
        if (size == 0) return;
        require_pointer(values, "values");
        View(*p, p->local(part)).write(array, values);
    });
}

extern "C" mgdt_status mgdt_parts_get_coordinates(const mgdt_parts* p, int32_t part,
                                                  int64_t capacity, double* xyz) {
    return guard(p, [&] {
        const PartId i = p->local(part);
        const std::size_t n = p->triangulation ? View(*p, i).vertices() : 0;
        require_capacity(capacity, 3 * n, "xyz");
        if (n == 0) return;
        require_pointer(xyz, "xyz");
        const View view(*p, i);
        for (std::size_t k = 0; k < n; ++k) std::copy_n(view.vertex(k).x, 3, xyz + 3 * k);
    });
}
