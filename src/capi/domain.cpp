// SPDX-License-Identifier: MIT
// Creation, options and input of a domain, and the calls that make its mesh.
#include <algorithm>

#include "capi/domain_handle.hpp"
#include "capi/entry_points.hpp"
#include "capi/items.hpp"
#include "capi/mesh_handle.hpp"

using namespace mgdt;

namespace {

CornerRange corners_of(const Domain& d) {
    return {d.input().point_count(), d.settings().index_base};
}

template <class Int>
void set_facets(Domain& d, std::int64_t n, const Int* offsets, const Int* corners,
                const std::int32_t* markers) {
    const std::size_t count = require_items(n, 3, "facets");
    if (count > 0) require_pointer(corners, "corners");
    const std::int64_t base = d.settings().index_base;
    const auto begin_of = [&](std::size_t f) {
        if (!offsets) return 3 * static_cast<std::int64_t>(f);
        return offsets[f] < base ? std::int64_t{-1} : offsets[f] - base;
    };
    const auto shown = [&](std::int64_t offset) {
        return static_cast<long long>(offset) + d.settings().index_base;
    };
    Buffer<std::uint32_t> begin(d.allocator()), points(d.allocator());
    begin.resize(count + 1, 0u);
    // All offsets are looked at before a corner is.
    for (std::size_t f = 0; f < count; ++f) {
        const std::int64_t from = begin_of(f), to = begin_of(f + 1);
        if (from < 0 || to - from < 3 || (f == 0 && from != 0))
            fail(MGDT_ERR_INVALID_ARGUMENT,
                 "facet %lld has offsets from %lld to %lld; the first is %lld, and a facet has at "
                 "least three corners",
                 static_cast<long long>(f) + d.settings().index_base, shown(from), shown(to),
                 shown(0));
        if (static_cast<std::uint64_t>(to) > most_items)
            fail(MGDT_ERR_TOO_LARGE, "%lld corners are more than can be numbered",
                 static_cast<long long>(to));
        begin[f] = static_cast<std::uint32_t>(from);
        begin[f + 1] = static_cast<std::uint32_t>(to);
    }
    points.resize(begin[count]);
    for (std::size_t f = 0; f < count; ++f)
        for (std::size_t i = begin[f]; i < begin[f + 1]; ++i)
            points[i] = corners_of(d).at(corners[i], "facet", f);
    Buffer<std::int32_t> copy = copy_of_markers(d.allocator(), count, markers);
    d.set_facets(std::move(begin), std::move(points), std::move(copy));
}

template <class Int>
void set_segments(Domain& d, std::int64_t n, const Int* ends, const std::int32_t* markers) {
    const std::size_t count = require_items(n, 2, "segments");
    if (count > 0) require_pointer(ends, "ends");
    Buffer<std::uint32_t> points =
        copy_of_corners(d.allocator(), count, 2, ends, corners_of(d), "segment");
    Buffer<std::int32_t> copy = copy_of_markers(d.allocator(), count, markers);
    d.set_segments(std::move(points), std::move(copy));
}

// The places of regions or holes.
Buffer<DomainInput::Place> places(Domain& d, std::int64_t n, const double* xyz,
                                  const std::int32_t* markers, const char* of) {
    const std::size_t count = require_items(n, 3, of);
    if (count > 0) require_pointer(xyz, "xyz");
    Buffer<DomainInput::Place> all(d.allocator());
    all.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double* const x = xyz + 3 * i;
        for (std::size_t k = 0; k < 3; ++k)
            if (!std::isfinite(x[k]))
                fail(MGDT_ERR_NOT_FINITE, "coordinate %c of place %lld is not finite", "xyz"[k],
                     static_cast<long long>(i) + d.settings().index_base);
        all[i] = {{x[0], x[1], x[2]}, markers ? markers[i] : 0};
    }
    return all;
}

const OwnOptions<DomainSettings> domain_options = {
    {MGDT_DOMAIN_OPTION_ROUND_POINTS, &DomainSettings::rounds_points},
    {MGDT_DOMAIN_OPTION_STRICT, &DomainSettings::is_strict},
    {MGDT_DOMAIN_OPTION_KEEP_BOUNDARY, &DomainSettings::keeps_boundary}};

constexpr double most_share = 0.1;  // of the size of the points
constexpr DoubleOption<DomainSettings> double_options[] = {
    {MGDT_DOMAIN_OPTION_WELD, &DomainSettings::weld, most_share},
    {MGDT_DOMAIN_OPTION_FLATNESS, &DomainSettings::flatness, most_share}};

namespace of_domain {

constexpr IntegerStatistic<Domain> statistics[] = {
    {MGDT_DOMAIN_STAT_POINTS, [](const Domain& d) { return d.input().point_count(); }},
    {MGDT_DOMAIN_STAT_FACETS, [](const Domain& d) { return d.input().facet_count(); }},
    {MGDT_DOMAIN_STAT_SEGMENTS, [](const Domain& d) { return d.input().segment_count(); }},
    {MGDT_DOMAIN_STAT_REGIONS, [](const Domain& d) { return d.input().regions.size(); }},
    {MGDT_DOMAIN_STAT_HOLES, [](const Domain& d) { return d.input().holes.size(); }},
    {MGDT_DOMAIN_STAT_MEMORY_BYTES, [](const Domain& d) { return d.allocator().bytes(); }},
    {MGDT_DOMAIN_STAT_OFFENDING_PAIRS, [](const Domain& d) { return d.offences().size(); }},
    {MGDT_DOMAIN_STAT_OPEN_EDGES, [](const Domain& d) { return d.open_edges().size(); }},
    {MGDT_DOMAIN_STAT_MOVED_POINTS,
     [](const Domain& d) { return d.cleaned().counts.moved_points; }},
    {MGDT_DOMAIN_STAT_REPEATED_CORNERS,
     [](const Domain& d) { return d.cleaned().counts.repeated_corners; }},
    {MGDT_DOMAIN_STAT_COLLAPSED_FACETS,
     [](const Domain& d) { return d.cleaned().counts.collapsed_facets; }},
    {MGDT_DOMAIN_STAT_COVERED_FACETS, [](const Domain& d) { return d.cleaned().covered.size(); }},
    {MGDT_DOMAIN_STAT_POINTS_IN_EDGES,
     [](const Domain& d) { return d.cleaned().counts.points_in_edges; }},
    {MGDT_DOMAIN_STAT_POINTS_IN_FACETS,
     [](const Domain& d) { return d.cleaned().counts.points_in_facets; }},
    {MGDT_DOMAIN_STAT_EDGES_IN_FACETS,
     [](const Domain& d) { return d.cleaned().counts.edges_in_facets; }},
    {MGDT_DOMAIN_STAT_EXCHANGED_EDGES,
     [](const Domain& d) { return d.cleaned().counts.exchanged_edges; }},
};

auto offending_pairs(const Domain& d) {
    return Computed(4 * d.offences().size(), [&d](const auto& f) {
        for (const Offence& o : d.offences())
            for (const Offence::Item& item : {o.first, o.second}) {
                f(std::int64_t{item.kind});
                f(std::int64_t{item.index} + d.settings().index_base);
            }
    });
}

auto open_edges(const Domain& d) {
    return Computed(3 * d.open_edges().size(), [&d](const auto& f) {
        for (const OpenEdge& e : d.open_edges())
            for (const std::uint32_t i : {e.ends[0], e.ends[1], e.facet}) f(i);
    });
}

auto facet_origins(const Domain& d) {
    return computed_each(d.input().facet_count(), [&d](std::size_t f) {
        return d.input().facet_origin(static_cast<std::uint32_t>(f));
    });
}

auto segment_origins(const Domain& d) {
    return computed_each(d.input().segment_count(), [&d](std::size_t s) {
        return d.input().segment_origin(static_cast<std::uint32_t>(s));
    });
}

auto covered_facets(const Domain& d) {
    return Computed(2 * d.cleaned().covered.size(), [&d](const auto& f) {
        for (const CoveredFacet& c : d.cleaned().covered)
            for (const std::uint32_t i : {c.facet, c.by}) f(i);
    });
}

// One offset more than facets, also if none have been set.
auto facet_offsets(const Domain& d) {
    return computed_each(d.input().facet_count() + 1, [&d](std::size_t f) {
        return d.input().facet_begin.empty() ? 0 : d.input().facet_begin[f];
    });
}

constexpr auto arrays =
    std::make_tuple(array<Element::integer>(MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS, 4, offending_pairs),
                    array<Element::number>(MGDT_DOMAIN_ARRAY_OPEN_EDGES, 3, open_edges),
                    array<Element::number>(MGDT_DOMAIN_ARRAY_FACET_OFFSETS, 1, facet_offsets),
                    array<Element::number>(
                        MGDT_DOMAIN_ARRAY_FACET_CORNERS, 1,
                        [](const Domain& d) -> const auto& { return d.input().corners; }),
                    array<Element::integer>(
                        MGDT_DOMAIN_ARRAY_FACET_MARKERS, 1,
                        [](const Domain& d) -> const auto& { return d.input().facet_markers; }),
                    array<Element::number>(MGDT_DOMAIN_ARRAY_FACET_ORIGINS, 1, facet_origins),
                    array<Element::number>(MGDT_DOMAIN_ARRAY_COVERED_FACETS, 2, covered_facets),
                    array<Element::number>(
                        MGDT_DOMAIN_ARRAY_SEGMENTS, 2,
                        [](const Domain& d) -> const auto& { return d.input().segments; }),
                    array<Element::integer>(
                        MGDT_DOMAIN_ARRAY_SEGMENT_MARKERS, 1,
                        [](const Domain& d) -> const auto& { return d.input().segment_markers; }),
                    array<Element::number>(MGDT_DOMAIN_ARRAY_SEGMENT_ORIGINS, 1, segment_origins),
                    array<Element::real>(
                        MGDT_DOMAIN_ARRAY_POINTS, 3,
                        [](const Domain& d) -> const auto& { return d.input().points; }));

}  // namespace of_domain

// See entry_points.hpp.
struct DomainResults {
    static constexpr const auto& statistics = of_domain::statistics;
    static constexpr const auto& arrays = of_domain::arrays;
    static const Domain& of(const Domain& object) { return object; }
    static void require(const Domain&) {}
};

}  // namespace

MGDT_LIFE(domain)
MGDT_OPTIONS(domain, domain_options)
MGDT_DOUBLE_OPTIONS(domain, double_options)
MGDT_PROGRESS(domain)
MGDT_RESULTS(domain, DomainResults)
MGDT_DOUBLES(domain, DomainResults)
MGDT_MESSAGE(domain)

extern "C" mgdt_status mgdt_domain_clear(mgdt_domain* d) {
    return guard(d, [&] { d->object.clear(); });
}

extern "C" mgdt_status mgdt_domain_set_points(mgdt_domain* d, int64_t n, const double* xyz) {
    return guard(d, [&] {
        d->object.set_points(
            copy_of_points(d->object.allocator(), n, xyz, d->object.settings().index_base));
    });
}

extern "C" mgdt_status mgdt_domain_set_facets(mgdt_domain* d, int64_t n, const int64_t* offsets,
                                              const int64_t* corners, const int32_t* markers) {
    return guard(d, [&] { set_facets(d->object, n, offsets, corners, markers); });
}

extern "C" mgdt_status mgdt_domain_set_facets_i32(mgdt_domain* d, int64_t n, const int32_t* offsets,
                                                  const int32_t* corners, const int32_t* markers) {
    return guard(d, [&] { set_facets(d->object, n, offsets, corners, markers); });
}

extern "C" mgdt_status mgdt_domain_set_segments_i32(mgdt_domain* d, int64_t n, const int32_t* ends,
                                                    const int32_t* markers) {
    return guard(d, [&] { set_segments(d->object, n, ends, markers); });
}

extern "C" mgdt_status mgdt_domain_set_segments(mgdt_domain* d, int64_t n, const int64_t* ends,
                                                const int32_t* markers) {
    return guard(d, [&] { set_segments(d->object, n, ends, markers); });
}

extern "C" mgdt_status mgdt_domain_set_regions(mgdt_domain* d, int64_t n, const double* xyz,
                                               const int32_t* markers) {
    return guard(d, [&] { d->object.set_regions(places(d->object, n, xyz, markers, "regions")); });
}

extern "C" mgdt_status mgdt_domain_set_holes(mgdt_domain* d, int64_t n, const double* xyz) {
    return guard(d, [&] { d->object.set_holes(places(d->object, n, xyz, nullptr, "holes")); });
}

extern "C" mgdt_status mgdt_domain_clean(mgdt_domain* d) {
    return guard(d, [&] { d->object.clean(); });
}

extern "C" mgdt_status mgdt_domain_validate(mgdt_domain* d) {
    return guard(d, [&] { d->object.validate(); });
}

extern "C" mgdt_status mgdt_domain_build(mgdt_domain* d, mgdt_mesh** out) {
    if (!out) return MGDT_ERR_NULL_POINTER;
    *out = nullptr;
    return guard(d, [&] {
        *out = new_result<mgdt_mesh>(d->object, [&](MeshObject& made) {
            made.settings().points = MGDT_POINTS_KEEP;
            d->object.build(made.value);
        });
    });
}

extern "C" mgdt_status mgdt_domain_check(const mgdt_domain* d, const mgdt_mesh* mesh) {
    if (!mesh) return MGDT_ERR_NULL_POINTER;
    return guard_long(d, [&](StageProgress& progress) {
        const SecondHandle second(mesh);
        if (!mesh->object.value.is_of_domain)
            fail(
                MGDT_ERR_INVALID_ARGUMENT,
                "the mesh has been improved, or was not made of a domain; mgdt_mesh_check() checks "
                "it");
        d->object.check(mesh->object.value, progress);
    });
}
