// SPDX-License-Identifier: MIT
#include "domain/segment_splitting.hpp"

#include <algorithm>
#include <array>

#include "domain/missing_segment.hpp"
#include "domain/split_place.hpp"
#include "mesh/star_traversal.hpp"

namespace mgdt {
namespace {

class Splitting {
  public:
    Splitting(Triangulation& triangulation, Buffer<double>& points,
              const Buffer<std::uint32_t>& segments, StageProgress& progress,
              bool avoids_short_parts, const StopRequest& stop)
        : allocator_(triangulation.allocator()),
          triangulation_(triangulation),
          points_(points),
          segments_(segments),
          progress_(progress),
          avoids_short_parts_(avoids_short_parts),
          stop_(stop),
          acute_(find_acute_ends(points, segments, allocator_)),
          result_(allocator_),
          parts_(result_.parts),
          suspects_(allocator_),
          splits_(allocator_),
          degree_(allocator_),
          touches_(allocator_),
          round_near_(allocator_),
          is_waiting_(allocator_) {}

    DividedSegments run() {
        const std::size_t n = segments_.size() / 2;
        for (std::uint32_t s = 0; s < n; ++s) {
            const DividedSegment divided = this->divided(s);
            parts_.push_back({{segments_[2 * s], segments_[2 * s + 1]}, s, 0, divided.parts()});
            suspects_.push_back(s);
            is_waiting_.push_back(0);
        }
        degree_.resize(points_.size() / 3, 0u);
        for (const std::uint32_t end : segments_) ++degree_[end];
        touches_.resize(points_.size() / 3, Touches());
        round_near_.resize(points_.size() / 3, 0u);
        for (std::uint32_t round = 1; find_splits() && result_.stuck == none; ++round) {
            choose_splits(round);
            insert();
            find_suspects(round);
        }
        std::sort(parts_.begin(), parts_.end(), [](const Subsegment& a, const Subsegment& b) {
            return a.segment != b.segment ? a.segment < b.segment : a.k0 < b.k0;
        });
        return std::move(result_);
    }

  private:
    static constexpr std::uint32_t none = DividedSegments::none;

    // Where to divide a subsegment that is no edge.
    struct Split {
        std::uint32_t part, reference, k;
    };
    // How many splits of a round have a point as an end or as their reference point.
    struct Touches {
        std::uint32_t round = 0, wanted = 0, kept = 0;
    };
    std::array<std::uint32_t, 3> touched(const Split& split) const {
        const Subsegment& s = parts_[split.part];
        return {s.ends[0], s.ends[1], split.reference};
    }
    const double* point(std::uint32_t v) const { return points_.begin() + 3 * std::size_t{v}; }
    DividedSegment divided(std::uint32_t segment) const {
        return {point(segments_[2 * std::size_t{segment}]),
                point(segments_[2 * std::size_t{segment} + 1])};
    }

    // Fills splits_ with the suspects that are missing. Returns false if none is.
    bool find_splits() {
        splits_.clear();
        MissingSegment search(triangulation_, allocator_);
        std::size_t steps = 0;
        for (const std::uint32_t part : suspects_) {
            stop_.poll_in_step(steps++);
            const Subsegment& s = parts_[part];
            // From the end with fewer segments, whose star is smaller. The result is the same.
            const unsigned from = degree_[s.ends[1]] < degree_[s.ends[0]] ? 1 : 0;
            if (!search.find(s.ends[from], s.ends[1 - from])) continue;
            if (s.k1 - s.k0 < 2) result_.stuck = s.segment;
            if (result_.stuck != none) break;
            const std::uint32_t reference = search.reference();
            splits_.push_back({part, reference, place(s, reference)});
        }
        return !splits_.empty();
    }

    std::uint32_t place(const Subsegment& s, std::uint32_t reference) const {
        const std::size_t i = 2 * std::size_t{s.segment};
        return split_place(point(segments_[i]), point(segments_[i + 1]), acute_[i] != 0,
                           acute_[i + 1] != 0, point(reference), s.k0, s.k1,
                           divided(s.segment).parts(), avoids_short_parts_);
    }

    // Keeps an independent set of splits_: each point may be an end or the reference point of one
    // of them, since the place of a second would be chosen better after the first. Of many at one
    // point, a sixteenth is kept, so that the number of rounds is logarithmic there. The others
    // wait for a later round.
    void choose_splits(std::uint32_t round) {
        constexpr std::uint32_t many = 16;
        suspects_.clear();
        for (const Split& split : splits_)
            for (const std::uint32_t v : touched(split)) {
                Touches& touches = touches_[v];
                if (touches.round != round) touches = {round, 0, 0};
                ++touches.wanted;
            }
        std::size_t kept = 0;
        for (const Split& split : splits_) {
            const std::array<std::uint32_t, 3> points = touched(split);
            if (std::any_of(points.begin(), points.end(), [&](std::uint32_t v) {
                    return touches_[v].kept > touches_[v].wanted / many;
                })) {
                suspects_.push_back(split.part);
                continue;
            }
            for (const std::uint32_t v : points) ++touches_[v].kept;
            splits_[kept++] = split;
        }
        splits_.resize(kept);
    }

    void insert() {
        first_new_ = static_cast<std::uint32_t>(points_.size() / 3);
        for (const Split& split : splits_) {
            Subsegment& s = parts_[split.part];
            const auto middle = static_cast<std::uint32_t>(points_.size() / 3);
            points_.grow(points_.size() + 3);
            points_.resize_within_capacity(points_.size() + 3);
            divided(s.segment).point(split.k, points_.end() - 3);
            result_.steiner.push_back({s.segment, split.k});
            degree_.push_back(2);
            touches_.push_back({});
            round_near_.push_back(0);
            is_waiting_.push_back(0);
            const Subsegment second = {{middle, s.ends[1]}, s.segment, split.k, s.k1};
            s.ends[1] = middle;
            s.k1 = split.k;
            suspects_.push_back(split.part);
            suspects_.push_back(static_cast<std::uint32_t>(parts_.size()));
            parts_.push_back(second);
        }
        const double* const first = point(first_new_);
        const double* const axis[3] = {first, first + 1, first + 2};
        // The number of rounds is not known, so each takes a part of what is left.
        reached_ += (end_of_stage - reached_) / 16;
        progress_.enter(reached_, reached_);
        progress_.watch(triangulation_, 0, 1,
                        [&] { triangulation_.insert(splits_.size(), axis, 3); });
    }

    // Adds the subsegments that may have become missing to those that wait or are new. If an
    // insertion destroys an edge, both of its ends are on the boundary of the cavity and become
    // neighbours of the new point. If a later insertion destroys such a connection, they are
    // neighbours of its point. So the ends are neighbours of a new point in the end.
    void find_suspects(std::uint32_t round) {
        const Mesh& mesh = triangulation_.mesh();
        const Locator where = {mesh, triangulation_.calls(), nullptr};
        VisitQueue star(allocator_);
        const auto count = static_cast<std::uint32_t>(points_.size() / 3);
        for (std::uint32_t p = first_new_; p < count; ++p) {
            const VertexId v = triangulation_.point_map()[p];
            star.clear();
            star.push(where.tetrahedron_of(v));
            traverse_star(mesh, v, star,
                          [&](FacetCode facet) { star.push(tetrahedron_of(facet)); });
            for (std::size_t i = 0; i < star.size(); ++i)
                for (const VertexId u : mesh.tetrahedra[star[i]].v)
                    if (u != infinite_vertex) round_near_[mesh.vertices[u].index] = round;
        }
        for (const std::uint32_t part : suspects_) is_waiting_[part] = 1;
        for (std::uint32_t part = 0; part < parts_.size(); ++part) {
            const std::uint32_t* const ends = parts_[part].ends;
            if (is_waiting_[part] != 0)
                is_waiting_[part] = 0;
            else if (round_near_[ends[0]] == round && round_near_[ends[1]] == round)
                suspects_.push_back(part);
        }
    }

    Allocator& allocator_;
    Triangulation& triangulation_;
    Buffer<double>& points_;
    const Buffer<std::uint32_t>& segments_;
    StageProgress& progress_;
    const bool avoids_short_parts_;
    const StopRequest stop_;
    const Buffer<std::uint8_t> acute_;  // for each end of each segment
    DividedSegments result_;
    Buffer<Subsegment>& parts_;
    Buffer<std::uint32_t> suspects_;  // subsegments that may be missing
    Buffer<Split> splits_;
    Buffer<std::uint32_t> degree_;      // the number of segments at each point
    Buffer<Touches> touches_;           // for each point
    Buffer<std::uint32_t> round_near_;  // the last round in which a point had a new neighbour
    Buffer<std::uint8_t> is_waiting_;   // for each subsegment; all 0 between the steps
    std::uint32_t first_new_ = 0;
    double reached_ = 0.4;  // the progress of the build
    static constexpr double end_of_stage = 0.8;
};

}  // namespace

DividedSegments split_segments(Triangulation& triangulation, Buffer<double>& points,
                               const Buffer<std::uint32_t>& segments, StageProgress& progress,
                               bool avoids_short_parts, const StopRequest& stop) {
    return Splitting(triangulation, points, segments, progress, avoids_short_parts, stop).run();
}

}  // namespace mgdt
