// SPDX-License-Identifier: MIT
#include "domain/segment_splitting.hpp"

#include <algorithm>
#include <array>

#include "domain/missing_segment.hpp"
#include "domain/split_place.hpp"
#include "query/star.hpp"

namespace mgdt {
namespace {

class Splitting {
  public:
    Splitting(Triangulation& triangulation, Buffer<double>& points,
              const Buffer<std::uint32_t>& segments, StageProgress& progress,
              bool avoids_short_parts, std::size_t most_points, std::uint64_t most_work,
              const StopRequest& stop)
        : allocator_(triangulation.allocator()),
          triangulation_(triangulation),
          points_(points),
          segments_(segments),
          progress_(progress),
          avoids_short_parts_(avoids_short_parts),
          most_points_(most_points),
          most_work_(most_work),
          stop_(stop),
          acute_(find_acute_ends(points, segments, allocator_)),
          result_(points.allocator()),  // it may outlive the triangulation
          parts_(result_.parts),
          suspects_(allocator_),
          splits_(allocator_),
          degree_(allocator_),
          touches_(allocator_),
          round_near_(allocator_),
          near_(allocator_),
          tetrahedron_at_(allocator_),
          is_suspect_(allocator_),
          first_part_(allocator_),
          parts_of_(allocator_),
          last_of_segment_(allocator_) {}

    DividedSegments run() {
        degree_.resize(points_.size() / 3, 0u);
        for (const std::uint32_t end : segments_) ++degree_[end];
        const std::size_t n = segments_.size() / 2;
        for (std::uint32_t s = 0; s < n; ++s) {
            const DividedSegment divided = this->divided(s);
            parts_.push_back({{segments_[2 * s], segments_[2 * s + 1]}, s, 0, divided.parts()});
            suspects_.push_back(s);
            is_suspect_.push_back(1);
        }
        list_parts();
        touches_.resize(points_.size() / 3, Touches());
        round_near_.resize(points_.size() / 3, 0u);
        tetrahedron_at_.resize(points_.size() / 3, no_tetrahedron);
        for (std::uint32_t round = 1; find_splits() && result_.stuck == no_index; ++round) {
            if (is_at_limit()) {
                result_.stuck = parts_[splits_[0].part].segment;
                result_.takes_long = true;
                break;
            }
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
    // The work of a round, besides the tetrahedra at its new points.
    static constexpr std::uint64_t work_of_round = 64;

    // A missing subsegment, and where it is divided.
    struct Split {
        std::uint32_t part, reference, k;
    };
    // The numbers of splits of a round that have a point as an end or as their reference point.
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

    bool is_at_limit() const {
        return work_ > most_work_ || result_.steiner.size() >= most_points_;
    }
    // Fills splits_ with those suspects that are missing, at the limit with one of them. Returns
    // false if none is.
    bool find_splits() {
        splits_.clear();
        MissingSegment search(triangulation_, allocator_);
        std::size_t steps = 0;
        for (const std::uint32_t part : suspects_) {
            stop_.poll_in_step(steps++);
            is_suspect_[part] = 0;
            const Subsegment& s = parts_[part];
            // The search starts from the end with fewer segments, because its star is smaller. The
            // result is the same from both ends.
            const unsigned from = degree_[s.ends[1]] < degree_[s.ends[0]] ? 1 : 0;
            const std::uint32_t a = s.ends[from], b = s.ends[1 - from];
            if (!search.find(a, b, tetrahedron_at_[a])) continue;
            if (s.k1 - s.k0 < 2) result_.stuck = s.segment;
            if (result_.stuck != no_index) break;
            if (is_at_limit()) {  // so it is not going to be divided
                splits_.push_back({part, no_index, 0});
                break;
            }
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

    // Keeps an independent set of splits_: each point is an end or the reference point of at most
    // one of them, because a second split at a point is chosen better after the first. Where many
    // splits are at one point, a sixteenth of them is kept, so that the number of rounds is
    // logarithmic there. The others wait for a later round.
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
                is_suspect_[split.part] = 1;
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
            tetrahedron_at_.push_back(no_tetrahedron);
            const Subsegment second = {{middle, s.ends[1]}, s.segment, split.k, s.k1};
            const auto number = static_cast<std::uint32_t>(parts_.size());
            // The second part replaces the whole one at their common end.
            const std::uint32_t at = s.k1 == divided(s.segment).parts()
                                         ? last_of_segment_[s.segment]
                                         : first_part_[s.ends[1]];
            parts_of_[at] = number;
            parts_of_.push_back(split.part);
            parts_of_.push_back(number);
            first_part_.push_back(static_cast<std::uint32_t>(parts_of_.size()));
            s.ends[1] = middle;
            s.k1 = split.k;
            suspects_.push_back(split.part);
            is_suspect_[split.part] = 1;
            suspects_.push_back(number);
            is_suspect_.push_back(1);
            parts_.push_back(second);
        }
        const double* const first = point(first_new_);
        const double* const axis[3] = {first, first + 1, first + 2};
        // The number of rounds is not known in advance, so each round takes a fixed share of the
        // remaining progress.
        reached_ += (end_of_stage - reached_) / 16;
        progress_.enter(reached_, reached_);
        progress_.watch(triangulation_.settings(), 0, 1,
                        [&] { triangulation_.insert(splits_.size(), axis, 3); });
    }

    // Adds the subsegments that may have become missing to the suspects. If an insertion destroys
    // an edge, both of its ends are on the boundary of the cavity, and become neighbours of the new
    // point. If a later insertion of the round destroys one of these edges, its ends are neighbours
    // of the later point. So it suffices to look at the neighbours of the new points after the
    // round.
    void find_suspects(std::uint32_t round) {
        const Mesh& mesh = triangulation_.mesh();
        const Locator where = {mesh, triangulation_.calls(), nullptr};
        VisitQueue star(allocator_);
        work_ += work_of_round;
        const auto count = static_cast<std::uint32_t>(points_.size() / 3);
        for (std::uint32_t p = first_new_; p < count; ++p) {
            const VertexId v = triangulation_.point_map()[p];
            gather_star(where, v, star);
            work_ += star.size();
            for (std::size_t i = 0; i < star.size(); ++i)
                for (const VertexId u : mesh.tetrahedra[star[i]].v)
                    if (u != infinite_vertex) {
                        const std::uint32_t near = mesh.vertices[u].index;
                        tetrahedron_at_[near] = star[i];
                        note_near(near, round);
                    }
        }
        const std::size_t first_found = suspects_.size();
        for (const std::uint32_t v : near_)
            for (std::uint32_t i = first_part_[v]; i < first_part_[v + 1]; ++i) {
                const std::uint32_t part = parts_of_[i], *const ends = parts_[part].ends;
                if (is_suspect_[part] != 0 || round_near_[ends[0]] != round ||
                    round_near_[ends[1]] != round)
                    continue;
                is_suspect_[part] = 1;
                suspects_.push_back(part);
            }
        near_.clear();
        // The order of near_ depends on how tetrahedra are stored.
        std::sort(suspects_.begin() + first_found, suspects_.end());
    }
    void note_near(std::uint32_t v, std::uint32_t round) {
        if (round_near_[v] == round) return;
        round_near_[v] = round;
        near_.push_back(v);
    }
    // Lists the parts at each point. In the beginning, these are its segments.
    void list_parts() {
        first_part_.resize(degree_.size() + 1, 0u);
        for (std::size_t v = 0; v < degree_.size(); ++v)
            first_part_[v + 1] = first_part_[v] + degree_[v];
        parts_of_.resize(segments_.size());
        Buffer<std::uint32_t> next(allocator_);
        next.resize(degree_.size(), 0u);
        last_of_segment_.resize(segments_.size() / 2);
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            const std::uint32_t v = segments_[i], at = first_part_[v] + next[v]++;
            parts_of_[at] = static_cast<std::uint32_t>(i / 2);
            if (i % 2 == 1) last_of_segment_[i / 2] = at;
        }
    }

    Allocator& allocator_;
    Triangulation& triangulation_;
    Buffer<double>& points_;
    const Buffer<std::uint32_t>& segments_;
    StageProgress& progress_;
    const bool avoids_short_parts_;
    const std::size_t most_points_;
    const std::uint64_t most_work_;
    std::uint64_t work_ = 0;
    const StopRequest stop_;
    const Buffer<std::uint8_t> acute_;  // for each end of each segment
    DividedSegments result_;
    Buffer<Subsegment>& parts_;
    Buffer<std::uint32_t> suspects_;  // subsegments that may be missing
    Buffer<Split> splits_;
    Buffer<std::uint32_t> degree_;      // the number of segments at each point
    Buffer<Touches> touches_;           // for each point
    Buffer<std::uint32_t> round_near_;  // the last round in which a point had a new neighbour
    Buffer<std::uint32_t> near_;        // the points that had one in this round
    Buffer<TetId> tetrahedron_at_;      // a tetrahedron of each point, or no_tetrahedron
    Buffer<std::uint8_t> is_suspect_;   // for each subsegment, whether suspects_ has it
    // For each point the parts that end there: parts_of_[first_part_[v]] to
    // parts_of_[first_part_[v + 1] - 1]. For a point that was put on a segment, the one before it
    // comes first. For each segment, where parts_of_ has its last part at the second end.
    Buffer<std::uint32_t> first_part_, parts_of_, last_of_segment_;
    std::uint32_t first_new_ = 0;
    double reached_ = 0.4;  // the progress of the build
    static constexpr double end_of_stage = 0.8;
};

}  // namespace

DividedSegments split_segments(Triangulation& triangulation, Buffer<double>& points,
                               const Buffer<std::uint32_t>& segments, StageProgress& progress,
                               bool avoids_short_parts, std::size_t most_points,
                               std::uint64_t most_work, const StopRequest& stop) {
    return Splitting(triangulation, points, segments, progress, avoids_short_parts, most_points,
                     most_work, stop)
        .run();
}

}  // namespace mgdt
