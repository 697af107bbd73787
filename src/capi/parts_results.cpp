// SPDX-License-Identifier: MIT
// The results of a part: numbers, arrays and coordinates.
#include <algorithm>

#include "capi/arrays.hpp"
#include "capi/parts_handle.hpp"

using namespace mgdt;

namespace {

// A part of this process and its triangulation.
class View {
  public:
    // The triangulation of `p` must exist.
    View(const PartsObject& p, PartId i)
        : p_(p),
          all_(*p.triangulation),
          part_(all_.local(i)),
          tetrahedra_(all_.tetrahedra(i)),
          i_(i) {}

    std::size_t own_vertices() const { return part_.own_count(); }
    std::size_t vertices() const { return own_vertices() + tetrahedra_.ghosts().size(); }
    std::size_t received() const { return part_.point_count() - part_.own_count(); }
    const PartTetrahedra& tetrahedra() const { return tetrahedra_; }
    const PartPoint& vertex(std::size_t k) const {
        return part_.point(k < own_vertices() ? static_cast<std::uint32_t>(k)
                                              : tetrahedra_.ghosts()[k - own_vertices()]);
    }

    const Part& part() const { return part_; }
    const Buffer<std::int64_t>& point_map() const { return all_.vertices_of_given(i_); }
    const Buffer<std::int64_t>& vertex_ranges() const { return all_.first_vertices(); }
    const Buffer<std::int64_t>& tetrahedron_ranges() const { return all_.first_tetrahedra(); }
    // Ids of the caller are returned as they were given; others are numbers.
    std::int64_t id_base() const { return p_.has_ids ? 0 : p_.settings().index_base; }
    // The part that owns the vertex with this number.
    PartId owner(std::int64_t number) const {
        const Buffer<std::int64_t>& first = all_.first_vertices();
        return static_cast<PartId>(std::upper_bound(first.begin(), first.end(), number) -
                                   first.begin() - 1);
    }

  private:
    const PartsObject& p_;
    const Parts& all_;
    const Part& part_;
    const PartTetrahedra& tetrahedra_;
    PartId i_;
};

namespace of_part {

auto vertex_numbers(const View& v) {
    return computed_each(v.vertices(), [&v](std::size_t k) { return v.vertex(k).number; });
}
auto vertex_ids(const View& v) {
    return computed_each(v.vertices(),
                         [&v](std::size_t k) { return v.vertex(k).id + v.id_base(); });
}
auto vertex_owners(const View& v) {
    return computed_each(v.vertices(), [&v](std::size_t k) { return v.owner(v.vertex(k).number); });
}
auto corners(const View& v) {
    return Filled(4 * v.tetrahedra().size(),
                  [&v](std::int64_t* to) { v.tetrahedra().get_vertices(v.part(), to); });
}
auto local_corners(const View& v) {
    return Filled(4 * v.tetrahedra().size(),
                  [&v](std::int64_t* to) { v.tetrahedra().get_positions(v.part(), to); });
}
auto tetrahedron_numbers(const View& v) {
    return computed_each(v.tetrahedra().size(),
                         [&v](std::size_t k) { return v.tetrahedra().number(k); });
}
auto tetrahedron_owners(const View& v) {
    return computed_each(v.tetrahedra().size(),
                         [&v](std::size_t k) { return v.tetrahedra().owner(k); });
}
auto neighbors(const View& v) {
    return Filled(4 * v.tetrahedra().owned(),
                  [&v](std::int64_t* to) { v.tetrahedra().get_neighbors(v.part(), to); });
}

constexpr auto arrays = std::make_tuple(
    array<Element::number>(MGDT_PARTS_POINT_MAP, 1, &View::point_map),
    array<Element::number>(MGDT_PARTS_VERTEX_NUMBERS, 1, vertex_numbers),
    array<Element::integer>(MGDT_PARTS_VERTEX_IDS, 1, vertex_ids),
    array<Element::integer>(MGDT_PARTS_VERTEX_OWNERS, 1, vertex_owners),
    array<Element::number>(MGDT_PARTS_VERTEX_RANGES, 1, &View::vertex_ranges),
    array<Element::number>(MGDT_PARTS_CORNERS, 4, corners),
    array<Element::number>(MGDT_PARTS_LOCAL_CORNERS, 4, local_corners),
    array<Element::number>(MGDT_PARTS_TETRAHEDRON_NUMBERS, 1, tetrahedron_numbers),
    array<Element::integer>(MGDT_PARTS_TETRAHEDRON_OWNERS, 1, tetrahedron_owners),
    array<Element::number>(MGDT_PARTS_TETRAHEDRON_RANGES, 1, &View::tetrahedron_ranges),
    array<Element::number>(MGDT_PARTS_NEIGHBORS, 4, neighbors));

}  // namespace of_part
// Refuses arrays that depend on other parts, if one part is in memory at a time.
void require_kept(const PartsObject& p, std::int32_t key) {
    const bool depends_on_others = key == MGDT_PARTS_TETRAHEDRON_NUMBERS ||
                                   key == MGDT_PARTS_TETRAHEDRON_OWNERS ||
                                   key == MGDT_PARTS_NEIGHBORS;
    if (depends_on_others && p.triangulation && !p.keeps_tetrahedra)
        fail(MGDT_ERR_INVALID_ARGUMENT, "array %d is not known where there is one part at a time",
             static_cast<int>(key));
}

std::size_t statistic(const PartsObject& p, PartId i, std::int32_t key) {
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
            return p.allocator().bytes() +
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
        *value = static_cast<std::int64_t>(statistic(p->object, p->object.local(part), key));
    });
}

extern "C" mgdt_status mgdt_parts_array_info(int32_t array, int32_t* columns, int32_t* is_double) {
    return array_info(of_part::arrays, array, columns, is_double);
}

extern "C" mgdt_status mgdt_parts_get_size(const mgdt_parts* p, int32_t part, int32_t array,
                                           int64_t* size) {
    return guard(p, [&] {
        require_pointer(size, "size");
        const PartId i = p->object.local(part);
        require_kept(p->object, array);
        with_array(of_part::arrays, array, [&](const auto& entry) {
            *size = 0;
            if (!p->object.triangulation) return;
            const View view(p->object, i);
            *size = static_cast<std::int64_t>(std::invoke(entry.read, view).size());
        });
    });
}

extern "C" mgdt_status mgdt_parts_get_array(const mgdt_parts* p, int32_t part, int32_t array,
                                            int64_t capacity, int64_t* values) {
    return guard(p, [&] {
        const PartId i = p->object.local(part);
        require_kept(p->object, array);
        if (!p->object.triangulation)
            return with_array(of_part::arrays, array,
                              [&](const auto&) { require_capacity(capacity, 0, "values"); });
        const View view(p->object, i);
        get_array(of_part::arrays, view, array, p->object.settings().index_base, capacity, values,
                  [](const View&) {});
    });
}

extern "C" mgdt_status mgdt_parts_get_coordinates(const mgdt_parts* p, int32_t part,
                                                  int64_t capacity, double* xyz) {
    return guard(p, [&] {
        const PartId i = p->object.local(part);
        const std::size_t n = p->object.triangulation ? View(p->object, i).vertices() : 0;
        require_capacity(capacity, 3 * n, "xyz");
        if (n == 0) return;
        require_pointer(xyz, "xyz");
        const View view(p->object, i);
        for (std::size_t k = 0; k < n; ++k) std::copy_n(view.vertex(k).x, 3, xyz + 3 * k);
    });
}
