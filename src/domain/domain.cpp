// SPDX-License-Identifier: MIT
#include "domain/domain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "domain/facet_insertion.hpp"
#include "domain/kept_boundary.hpp"
#include "domain/mesh_comparison.hpp"
#include "parallel/thread_count.hpp"
#include "platform/objects.hpp"
#include "platform/take_out_repeats.hpp"

namespace mgdt {
namespace {

const char* name_of(Offence::Kind kind) {
    return kind == Offence::facet ? "facet" : kind == Offence::segment ? "segment" : "point";
}

// How much work the division of the segments may take (split_segments()). A unit takes about a
// microsecond. All surfaces of tests/models.sh stay below.
std::uint64_t most_work(std::size_t points, bool may_take_long) {
    const std::uint64_t usual = 100000 + 2000 * std::uint64_t{points};
    return may_take_long ? 6 * usual : usual;
}

}  // namespace

void Domain::clear() noexcept {
    stop_.forget();
    forget_results();
    forget_cleaning();
    input_ = DomainInput(allocator_);
}

void Domain::forget_results() noexcept {
    offences_.reset();
    open_edges_.reset();
}

void Domain::set_points(Buffer<double>&& points) noexcept {
    forget_results();
    forget_cleaning();
    for (Buffer<std::uint32_t>* const of :
         {&input_.facet_begin, &input_.corners, &input_.facet_origins, &input_.segments,
          &input_.segment_origins})
        of->reset();
    input_.facet_markers.reset();
    input_.segment_markers.reset();
    input_.points = std::move(points);
}

void Domain::set_facets(Buffer<std::uint32_t>&& begin, Buffer<std::uint32_t>&& corners,
                        Buffer<std::int32_t>&& markers) noexcept {
    forget_results();
    forget_cleaning();
    input_.facet_begin = std::move(begin);
    input_.corners = std::move(corners);
    input_.facet_markers = std::move(markers);
    input_.facet_origins.reset();
}

void Domain::set_segments(Buffer<std::uint32_t>&& ends, Buffer<std::int32_t>&& markers) noexcept {
    forget_results();
    forget_cleaning();
    input_.segments = std::move(ends);
    input_.segment_markers = std::move(markers);
    input_.segment_origins.reset();
}

void Domain::clean() {
    const StopFlag::Call call(stop_);
    StageProgress progress(settings_, stop_);
    Team team(thread_count(settings_));
    CleanedFacets made = mgdt::clean(input_, settings_, team, allocator_, progress);
    CleaningRecord record(allocator_);
    record.counts = made.counts;
    Buffer<std::int32_t> facet_markers(allocator_), segment_markers(allocator_);
    for (std::uint32_t& f : made.facet_origins) {
        facet_markers.push_back(input_.facet_markers[f]);
        f = input_.facet_origin(f);
    }
    for (std::uint32_t& s : made.segment_origins) {
        segment_markers.push_back(input_.segment_markers[s]);
        s = input_.segment_origin(s);
    }
    record.covered.copy(cleaned_.covered);
    for (const CoveredFacet& c : made.covered)
        record.covered.push_back({input_.facet_origin(c.facet), input_.facet_origin(c.by)});
    take_out_repeats(record.covered);
    progress.finish();
    forget_results();
    cleaned_ = std::move(record);
    input_.points = std::move(made.points);
    input_.facet_begin = std::move(made.facet_begin);
    input_.corners = std::move(made.corners);
    input_.facet_markers = std::move(facet_markers);
    input_.facet_origins = std::move(made.facet_origins);
    input_.segments = std::move(made.segments);
    input_.segment_markers = std::move(segment_markers);
    input_.segment_origins = std::move(made.segment_origins);
}

void Domain::validate() {
    const StopFlag::Call call(stop_);
    StageProgress progress(settings_, stop_);
    forget_results();
    progress.enter(0, 0.1);
    const Complex complex = make_complex(input_, allocator_);
    progress.enter(0.1, 0.95);
    require_valid(complex, MGDT_ERR_INVALID_BOUNDARY, "", progress);
    progress.enter(0.95, 1);
    open_edges_ = mgdt::open_edges(complex, allocator_);
    progress.finish();
}

// Writes the pairs that offend as the caller's items, and throws if there are any.
void Domain::require_valid(const Complex& complex, mgdt_status otherwise, const char* where,
                           StageProgress& progress) {
    const Boundary& boundary = complex.boundary;
    Team team(thread_count(settings_));
    const Buffer<OffendingPair> pairs = offending_pairs(boundary, team, allocator_, progress);
    const auto item = [&](std::size_t i) -> Offence::Item {
        const std::size_t triangles = boundary.triangles.size() / 3,
                          segments = boundary.segments.size() / 2;
        if (i < triangles) return {Offence::facet, complex.facet_of_triangle[i]};
        i -= triangles;
        if (i < segments)
            return {Offence::segment, input_.segment_origin(static_cast<std::uint32_t>(i))};
        const std::uint32_t number = boundary.lone_points[i - segments];
        return {Offence::point, complex.point_of_number[number]};
    };
    Buffer<Offence> found(allocator_);
    for (const OffendingPair& pair : pairs) {
        Offence offence = {item(pair.first), item(pair.second)};
        if (offence.second < offence.first) std::swap(offence.first, offence.second);
        found.push_back(offence);
    }
    for (const std::uint32_t f : complex.bad_facets)
        found.push_back({{Offence::facet, f}, {Offence::facet, f}});
    if (found.empty()) return;
    take_out_repeats(found);
    offences_ = std::move(found);
    const Offence& o = offences_[0];
    if (o.first == o.second)
        fail(otherwise, "%s %lld %s%s; %zu pairs in all offend", name_of(o.first.kind),
             number(o.first.index),
             o.first.kind == Offence::segment ? "has no length" : "is flat or no polygon", where,
             offences_.size());
    fail(otherwise,
         "%s %lld and %s %lld meet elsewhere than in common corners or edges%s; %zu pairs in all "
         "offend",
         name_of(o.first.kind), number(o.first.index), name_of(o.second.kind),
         number(o.second.index), where, offences_.size());
}

void Domain::fail_open() const {
    if (input_.facet_count() == 0)
        fail(MGDT_ERR_OPEN_BOUNDARY, "there are no facets, so nothing is enclosed");
    if (open_edges_.empty())
        fail(MGDT_ERR_OPEN_BOUNDARY,
             "the facets enclose nothing, though no facet has an edge for itself");
    const OpenEdge& e = open_edges_[0];
    fail(MGDT_ERR_OPEN_BOUNDARY,
         "the facets enclose nothing: facet %lld alone has the edge from point %lld to point %lld; "
         "there are %zu such edges",
         number(e.facet), number(e.ends[0]), number(e.ends[1]), open_edges_.size());
}

void Domain::check(const SolidMesh& mesh, StageProgress& progress) const {
    compare_mesh(input_, mesh, settings_.index_base, allocator_, progress);
}

// Rounds the points of a complex to a grid. Refuses points that become equal. Returns whether
// rounding has moved any.
bool Domain::round(const RoundingGrid& grid, Complex& complex) {
    Buffer<double>& points = complex.boundary.points;
    bool is_changed = false;
    for (double& x : points) {
        const double rounded = grid.round(x);
        is_changed = is_changed || grid.unround(rounded) != x;
        x = rounded;
    }
    if (is_changed && !are_distinct(points, allocator_))
        fail(MGDT_ERR_RESOLUTION,
             "two points are nearer to each other than 2^-%d of the largest coordinate",
             grid.bits());
    return is_changed;
}

// Refuses a complex that was valid before its points were rounded to a grid, and is not any more:
// it is finer than the grid.
void Domain::require_valid_on(const RoundingGrid& grid, const Complex& complex,
                              StageProgress& progress) {
    char where[80];
    std::snprintf(where, sizeof where,
                  " when points are rounded to 2^-%d of the largest coordinate", grid.bits());
    require_valid(complex, MGDT_ERR_RESOLUTION, where, progress);
}

void Domain::build(SolidMesh& mesh) {
    const StopFlag::Call call(stop_);
    StageProgress progress(settings_, stop_);
    forget_results();
    run(progress, mesh);
    progress.finish();
}

void Domain::run(StageProgress& progress, SolidMesh& mesh) {
    progress.enter(0, 0.05);
    Complex complex = make_complex(input_, allocator_);
    require_valid(complex, MGDT_ERR_INVALID_BOUNDARY, "", progress);
    progress.leave_behind(0.05);
    open_edges_ = mgdt::open_edges(complex, allocator_);
    if (settings_.keeps_boundary) {
        const Stuck lost = keep(complex, progress, mesh);
        if (!lost) return;
        fail(MGDT_ERR_RESOLUTION,
             "the boundary cannot be kept: the edge from point %lld to point %lld, or a facet at "
             "it, is missing",
             number(lost->ends[0]), number(lost->ends[1]));
    }
    if (!settings_.rounds_points) {
        if (make_with_fewest(std::move(complex), progress, mesh)) return;
        complex = make_complex(input_, allocator_);
    }
    Attempts attempts;
    Stuck reported;
    for (bool is_last = false; !is_last; complex = make_complex(input_, allocator_)) {
        const Attempt attempt = attempts.current();
        progress.leave_behind(attempts.share_passed());
        Stuck stuck;
        std::optional<Error> refused;
        try {
            stuck = mesh_on(attempt, std::move(complex), progress, mesh);
        } catch (const Error& e) {
            // Rounding has made the boundary invalid.
            if (e.status != MGDT_ERR_RESOLUTION) throw;
            refused = e;
        }
        if (!stuck && !refused) return;
        if (stuck && (!reported || attempt.may_take_long)) reported = stuck;
        is_last = !attempts.advance(refused             ? Attempts::Result::too_coarse
                                    : stuck->takes_long ? Attempts::Result::took_long
                                                        : Attempts::Result::stuck);
        if (!refused) continue;
        if (is_last && (!reported || attempt.may_take_long)) throw *refused;
        offences_.reset();
    }
    if (attempts.has_taken_long())
        fail(MGDT_ERR_RESOLUTION,
             "%zu points on segments do not suffice: the segment from point %lld to point %lld is "
             "missing, and more would take too long",
             reported->steiner_points, number(reported->ends[0]), number(reported->ends[1]));
    fail(MGDT_ERR_RESOLUTION,
         "the segment from point %lld to point %lld needs points nearer to each other than double "
         "precision allows",
         number(reported->ends[0]), number(reported->ends[1]));
}

// Makes the mesh of a valid complex with points on a grid. If a segment would have to be divided
// more finely than doubles can, there is no mesh, and the result is its ends.
Domain::Stuck Domain::mesh_on(const Attempt& attempt, Complex complex, StageProgress& progress,
                              SolidMesh& mesh) {
    const RoundingGrid grid(input_.points, attempt.bits);
    const StopRequest stop = stop_.request();
    mesh = SolidMesh(mesh.points.allocator());
    progress.enter(0, 0.1);
    const bool is_moved = round(grid, complex);
    // If no point may be added, most boundaries that are to be validated have a segment that is no
    // edge. This is found sooner.
    const bool is_tried_first = attempt.most_points == 0;
    if (is_moved && !is_tried_first) require_valid_on(grid, complex, progress);
    const PlanarFacets facets = find_planar_facets(complex.boundary, complex.markers, allocator_);
    mesh.planar_facets = facets.facets.size();

    // A triangulation is too large for the stack.
    Objects<Triangulation> storage(allocator_, 1, &Allocator::allocate_from, &Allocator::release_to,
                                   static_cast<void*>(&allocator_));
    Triangulation& triangulation = storage[0];
    triangulation.settings().threads = settings_.threads;
    Buffer<double> points(allocator_);
    points.resize(complex.boundary.points.size());
    std::copy_n(complex.boundary.points.begin(), points.size(), points.begin());
    progress.enter(0.1, 0.4);
    progress.watch(triangulation.settings(), 0, 1, [&] {
        const double* const axis[3] = {points.begin(), points.begin() + 1, points.begin() + 2};
        triangulation.insert(points.size() / 3, axis, 3);
    });
    DividedSegments segments(allocator_);
    if (triangulation.dimension() == 3)
        segments = split_segments(
            triangulation, points, facets.segments, progress, attempt.avoids_short_parts,
            attempt.most_points,
            most_work(complex.boundary.points.size() / 3, attempt.may_take_long), stop);
    if (segments.stuck != no_index) {
        const auto end = [&](std::size_t k) {
            const std::uint32_t v = facets.segments[2 * std::size_t{segments.stuck} + k];
            return complex.point_of_number[v];
        };
        return StuckSegment{{end(0), end(1)}, segments.takes_long, segments.steiner.size()};
    }
    progress.enter(0.8, 0.9);
    if (is_moved && is_tried_first) require_valid_on(grid, complex, progress);
    ConstrainedMesh constrained(triangulation, points, allocator_);
    triangulation.clear();
    triangulation.shrink();
    if (!segments.parts.empty()) {
        const FacetCounts counts =
            insert_facets(constrained, facets, segments.parts, allocator_, stop);
        mesh.missing_facets = counts.missing;
        mesh.cavities = counts.cavities;
        mesh.largest_cavity = counts.largest_cavity;
    }
    progress.enter(0.9, 1);
    Regions found = find_regions(constrained, grid, input_.regions, input_.holes, allocator_);
    finish({input_, complex, facets, grid, constrained, segments.parts, segments.steiner, found},
           mesh);
    return std::nullopt;
}

void Domain::finish(const DomainParts& parts, SolidMesh& mesh) {
    if (!parts.regions.has_inside && !settings_.takes_open_surfaces) fail_open();
    if (parts.regions.has_inside && parts.regions.markers.empty())
        fail(MGDT_ERR_OPEN_BOUNDARY, "all that the facets enclose are holes");
    Team team(thread_count(settings_));
    assemble(parts, settings_.rounds_points, team, allocator_, mesh);
    if (settings_.is_strict) require_all_used(mesh);
}

// Makes the constrained Delaunay mesh if it needs no points, or else the mesh with the fewest: one
// with points inside, or a constrained Delaunay one with no more points on segments. Returns false
// if the boundary cannot be kept, so that segments have to be divided as often as necessary.
bool Domain::make_with_fewest(Complex complex, StageProgress& progress, SolidMesh& mesh) {
    if (complex.boundary.triangles.empty()) return false;
    if (make_delaunay(std::move(complex), 0, progress, mesh)) return true;
    progress.leave_behind(0.45);
    const bool is_lost = keep(make_complex(input_, allocator_), progress, mesh).has_value();
    progress.leave_behind(0.95);
    if (is_lost) return false;
    const std::size_t points = mesh.steiner_parameters.size();
    if (points == 0) return true;
    SolidMesh other(mesh.points.allocator());
    if (make_delaunay(make_complex(input_, allocator_), points, progress, other) &&
        !other.is_rounded)
        mesh = std::move(other);
    return true;
}

// Makes the constrained Delaunay mesh, on the usual grid or on the finest one. Returns false if
// that takes more than `most_points` points on segments.
bool Domain::make_delaunay(Complex complex, std::size_t most_points, StageProgress& progress,
                           SolidMesh& mesh) {
    Attempts attempts;
    do {
        Attempt attempt = attempts.current();
        attempt.most_points = most_points;
        progress.leave_behind(attempts.share_passed());
        try {
            return !mesh_on(attempt, std::move(complex), progress, mesh);
        } catch (const Error& e) {
            // Rounding has made the boundary invalid, which was found at the end.
            if (e.status != MGDT_ERR_RESOLUTION) throw;
            offences_.reset();
            progress.leave_behind(0.9);
        }
        complex = make_complex(input_, allocator_);
    } while (attempts.advance(Attempts::Result::too_coarse));
    return false;
}

// Makes a mesh in which every triangle of a facet is one face. Its points are not rounded. If that
// is impossible, the result is a segment that is lost, or a side of a facet that is.
Domain::Stuck Domain::keep(const Complex& complex, StageProgress& progress, SolidMesh& mesh) {
    if (complex.boundary.points.empty() ||
        (complex.boundary.triangles.empty() && !settings_.takes_open_surfaces))
        fail_open();
    mesh = SolidMesh(mesh.points.allocator());
    PlanarFacets facets = find_planar_facets(complex.boundary, complex.markers, allocator_);
    mesh.planar_facets = facets.facets.size();
    separate_facets(complex.boundary, facets);
    KeptBoundary kept(allocator_);
    StageProgress stages = progress.within(0, 0.9);
    keep_boundary(complex, settings_.threads, allocator_, stages, kept);
    if (kept.lost_edge[0] != no_index) {
        const auto end = [&](std::size_t k) { return complex.point_of_number[kept.lost_edge[k]]; };
        return StuckSegment{{end(0), end(1)}, false, 0};
    }
    progress.enter(0.9, 1);
    const RoundingGrid grid(0.0, RoundingGrid::no_rounding);
    Regions found = find_regions(kept.mesh, grid, input_.regions, input_.holes, allocator_);
    const std::size_t given = complex.point_of_number.size();
    Buffer<SteinerPoint> added(allocator_);
    added.resize(sort_added_points(kept, found.of_tetrahedron, given, allocator_), {no_index, 0});
    Buffer<Subsegment> segments(allocator_);
    for (std::uint32_t s = 0; s < facets.segments.size() / 2; ++s) {
        const std::uint32_t* const ends = facets.segments.begin() + 2 * std::size_t{s};
        segments.push_back({{ends[0], ends[1]}, s, 0, 1});
    }
    mesh.is_delaunay = kept.mesh.is_delaunay(found.of_tetrahedron, Regions::outside);
    mesh.keeps_facets = true;
    finish({input_, complex, facets, grid, kept.mesh, segments, added, found}, mesh);
    return std::nullopt;
}

void Domain::require_all_used(const SolidMesh& mesh) const {
    std::uint32_t facet = no_index;
    for (const std::uint32_t f : mesh.unused_faces) facet = std::min(facet, mesh.face_facets[f]);
    if (facet != no_index)
        fail(MGDT_ERR_OPEN_BOUNDARY,
             "facet %lld bounds nothing: it has a face without a tetrahedron, as %zu faces have",
             number(facet), mesh.unused_faces.size());
    if (!mesh.unused_regions.empty())
        fail(MGDT_ERR_INVALID_ARGUMENT, "the place of region %lld is in no region of the mesh",
             number(mesh.unused_regions[0]));
    if (!mesh.unused_holes.empty())
        fail(MGDT_ERR_INVALID_ARGUMENT, "hole %lld is in nothing that the facets enclose",
             number(mesh.unused_holes[0]));
    if (!mesh.unused_points.empty())
        fail(MGDT_ERR_INVALID_ARGUMENT,
             "point %lld is a corner of no tetrahedron, as %zu points are",
             number(mesh.unused_points[0]), mesh.unused_points.size());
}

}  // namespace mgdt
