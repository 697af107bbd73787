// SPDX-License-Identifier: MIT
#include "cleaning/cleaning.hpp"

#include <algorithm>

#include "cleaning/division.hpp"
#include "cleaning/incidences.hpp"
#include "cleaning/patch_edges.hpp"
#include "cleaning/patches.hpp"
#include "cleaning/welding.hpp"
#include "platform/take_out_repeats.hpp"

namespace mgdt {
namespace {

class Cleaning {
  public:
    Cleaning(const DomainInput& input, const CleaningDistances& distances, Team& team,
             Allocator& allocator)
        : input_(input),
          weld_(distances.weld, input.points),
          flatness_(std::max(distances.weld, distances.flatness), input.points),
          exchanges_all_(distances.flatness > 0),
          team_(team),
          allocator_(allocator),
          complex_(allocator),
          pieces_(allocator),
          areas_(allocator),
          is_changed_(allocator),
          result_(allocator) {}

    CleanedFacets run(StageProgress& progress) {
        progress.enter(0, 0.1);
        result_.points.copy(input_.points);
        result_.counts.moved_points =
            weld_points(result_.points, weld_, allocator_, progress.stop_request());
        start();
        // A round can leave something to the next one: a point in an edge that the round has made,
        // or a point near an edge that it has bent. The number of rounds is not known in advance,
        // so each one gets half of the progress that remains.
        constexpr int most_rounds = 40;
        for (int round = 0; round < most_rounds; ++round) {
            progress.leave_behind(round == 0 ? 0.1 : 0.5);
            if (!clean_once(round == 0, progress)) break;
        }
        write();
        return std::move(result_);
    }

  private:
    void start() {
        complex_ = make_complex(result_.points, input_, allocator_);
        Boundary& boundary = pieces_.boundary;
        std::swap(boundary, complex_.boundary);
        std::swap(pieces_.facet_of_triangle, complex_.facet_of_triangle);
        pieces_.is_new.resize(pieces_.triangle_count(), std::uint8_t{0});
        for (std::uint32_t s = 0; s < boundary.segments.size() / 2; ++s)
            pieces_.source_of_segment.push_back(s);
        areas_.resize(input_.facet_count(), 0.0);
        is_changed_.resize(input_.facet_count(), std::uint8_t{0});
        for (std::uint32_t t = 0; t < pieces_.triangle_count(); ++t) {
            const std::uint32_t* const v = pieces_.triangle(t);
            areas_[pieces_.facet_of_triangle[t]] +=
                length(weld_.normal(pieces_.point(v[0]), pieces_.point(v[1]), pieces_.point(v[2])));
        }
        // A polygon whose corners are on one line is one that has collapsed.
        for (const std::uint32_t f : complex_.bad_facets)
            if (is_on_line(f)) is_changed_[f] = 1;
    }

    bool is_on_line(std::uint32_t f) const {
        const double* ends[2] = {nullptr, nullptr};
        for (std::uint32_t i = input_.facet_begin[f]; i < input_.facet_begin[f + 1]; ++i) {
            const double* const x = pieces_.point(complex_.number_of_point[input_.corners[i]]);
            if (!ends[0])
                ends[0] = x;
            else if (!ends[1] && x != ends[0])
                ends[1] = x;
            else if (ends[1] && !collinear(ends[0], ends[1], x))
                return false;
        }
        return true;
    }

    // Returns whether there was anything to do.
    bool clean_once(bool is_first, StageProgress& progress) {
        const StopRequest stop = progress.stop_request();
        progress.enter(0, 0.8);
        const Incidences found = find_incidences(pieces_, weld_, team_, allocator_, progress);
        CleaningCounts& counts = result_.counts;
        counts.points_in_edges += found.on_edges.size();
        counts.points_in_facets += found.in_triangles.size();
        bool is_done = found.empty();
        std::fill(pieces_.is_new.begin(), pieces_.is_new.end(), std::uint8_t{0});
        if (!is_done) divide_at(found, weld_, pieces_, is_changed_, allocator_);
        const Buffer<Projection> patches =
            find_patches(pieces_, input_.facet_markers, flatness_, allocator_);
        progress.enter(0.8, 1);
        {
            PatchEdges edges(pieces_, patches, flatness_, is_changed_, allocator_);
            const std::size_t taken = edges.take_in_edges(stop);
            counts.edges_in_facets += taken;
            is_done = is_done && taken == 0;
        }
        if (remove_equal_triangles(pieces_, areas_, result_.covered, is_changed_, allocator_))
            is_done = false;
        if (is_done && !(is_first && exchanges_all_)) return false;
        PatchEdges edges(pieces_, patches, flatness_, is_changed_, allocator_);
        const std::size_t exchanged = edges.make_delaunay(exchanges_all_, stop);
        counts.exchanged_edges += exchanged;
        return !is_done || exchanged > 0;
    }

    // Writes the facets in the order of the given ones, and the parts of each in theirs.
    void write() {
        Buffer<std::uint32_t> order(allocator_, pieces_.triangle_count());
        for (std::uint32_t t = 0; t < order.size(); ++t) order[t] = t;
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            const std::uint32_t f = pieces_.facet_of_triangle[a], g = pieces_.facet_of_triangle[b];
            return f != g ? f < g : a < b;
        });
        take_out_repeats(result_.covered);
        const CoveredFacet* covered = result_.covered.begin();
        result_.facet_begin.push_back(0);
        std::size_t at = 0;
        for (std::uint32_t f = 0; f < input_.facet_count(); ++f) {
            const std::size_t first = at;
            while (at < order.size() && pieces_.facet_of_triangle[order[at]] == f) ++at;
            bool is_covered = false;
            for (; covered != result_.covered.end() && covered->facet == f; ++covered)
                is_covered = true;
            if (is_changed_[f] == 0) {
                write_whole(f);
                continue;
            }
            if (at == first && !is_covered) ++result_.counts.collapsed_facets;
            for (std::size_t i = first; i < at; ++i) {
                const std::uint32_t* const v = pieces_.triangle(order[i]);
                for (int k = 0; k < 3; ++k)
                    result_.corners.push_back(complex_.point_of_number[v[k]]);
                finish_facet(f);
            }
        }
        for (std::size_t s = 0; s < pieces_.source_of_segment.size(); ++s) {
            const std::uint32_t* const ends = pieces_.boundary.segments.begin() + 2 * s;
            if (ends[0] == ends[1]) continue;
            for (int k = 0; k < 2; ++k)
                result_.segments.push_back(complex_.point_of_number[ends[k]]);
            result_.segment_origins.push_back(pieces_.source_of_segment[s]);
        }
    }
    // Writes a facet that has not been changed. Corners that equal the ones before are left out.
    void write_whole(std::uint32_t f) {
        const std::size_t first = result_.corners.size();
        Buffer<std::uint32_t>& corners = result_.corners;
        const std::uint32_t begin = input_.facet_begin[f], end = input_.facet_begin[f + 1];
        const auto number = [&](std::uint32_t p) { return complex_.number_of_point[p]; };
        for (std::uint32_t i = begin; i < end; ++i)
            if (corners.size() == first || number(corners.back()) != number(input_.corners[i]))
                corners.push_back(input_.corners[i]);
        while (corners.size() > first + 1 && number(corners.back()) == number(corners[first]))
            corners.pop_back();
        result_.counts.repeated_corners += end - begin - (corners.size() - first);
        finish_facet(f);
    }
    void finish_facet(std::uint32_t f) {
        result_.facet_begin.push_back(static_cast<std::uint32_t>(result_.corners.size()));
        result_.facet_origins.push_back(f);
    }

    const DomainInput& input_;
    const Nearness weld_, flatness_;
    const bool exchanges_all_;
    Team& team_;
    Allocator& allocator_;
    Complex complex_;
    SurfacePieces pieces_;
    Buffer<double> areas_;             // twice the area of each given facet
    Buffer<std::uint8_t> is_changed_;  // whether a given facet is not as it was
    CleanedFacets result_;
};

}  // namespace

CleanedFacets clean(const DomainInput& input, const CleaningDistances& distances, Team& team,
                    Allocator& allocator, StageProgress& progress) {
    return Cleaning(input, distances, team, allocator).run(progress);
}

}  // namespace mgdt
