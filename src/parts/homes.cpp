// SPDX-License-Identifier: MIT
//
// The tree is built level by level. The parts offer some of their points as candidates for
// splitters, and count the points before each candidate. The search continues between the two
// candidates that enclose the wanted number of points, until a candidate is good enough.
#include "parts/homes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "platform/random.hpp"

namespace mgdt {
namespace {

// The largest error of a split, as a fraction of the points of one part.
constexpr double tolerance = 1.0 / 512;
constexpr int most_rounds = 8;
// The number of candidates per split in one round. If there are many splits, `candidates_in_all`
// is divided among them, but each split gets at least `candidates_least`.
constexpr std::uint64_t candidates_wanted = 1024, candidates_least = 64,
                        candidates_in_all = std::uint64_t{1} << 18;

}  // namespace

class Homes::Level {
  public:
    Level(Allocator& allocator, Collective& collective, const GivenPoints* points)
        : collective_(collective),
          nodes_(allocator),
          begin_(allocator),
          order_(allocator),
          mine_(allocator),
          all_(allocator),
          between_(allocator),
          begin_between_(allocator),
          count_between_(allocator),
          first_(allocator),
          counts_(allocator) {
        std::size_t n = 0;
        for (PartId i = 0; i < collective.local_parts(); ++i) n += points[i].n;
        order_.resize(n);
        n = 0;
        for (PartId i = 0; i < collective.local_parts(); ++i)
            for (std::size_t k = 0; k < points[i].n; ++k) order_[n++] = points[i].xyz + 3 * k;
        begin_.push_back(0);
        begin_.push_back(n);
        nodes_.push_back(node(0, collective.parts()));
    }
    bool is_done() const { return nodes_.empty(); }

    void divide(Buffer<Splitter>& splitters) {
        choose_axes();
        bool goes_on = true;
        for (std::uint64_t round = 0; goes_on && round < most_rounds; ++round) {
            offer(round);
            count();
            goes_on = narrow();
        }
        for (const Node& n : nodes_) splitters[n.middle] = n.best;
    }
    // Continues with the subsets of the sets that were divided.
    void descend() {
        Buffer<Node> nodes(nodes_.allocator());
        Buffer<std::size_t> begin(nodes_.allocator());
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const Node& n = nodes_[i];
            const double** const from = order_.data() + begin_[2 * i];
            const double** const to = order_.data() + begin_[2 * i + 1];
            const double** const middle =
                std::partition(from, to, [&](const double* x) { return n.best.has_before(x); });
            const auto add = [&](PartId first, PartId last, const double** a, const double** b) {
                if (last - first < 2) return;
                nodes.push_back(node(first, last));
                begin.push_back(static_cast<std::size_t>(a - order_.data()));
                begin.push_back(static_cast<std::size_t>(b - order_.data()));
            };
            add(n.first, n.middle, from, middle);
            add(n.middle, n.last, middle, to);
        }
        nodes_ = std::move(nodes);
        begin_ = std::move(begin);
        ++depth_;
    }

  private:
    struct Candidate {
        double x[3];
        std::uint64_t node;
    };

    static Node node(PartId first, PartId last) {
        Node n{};
        n.first = first;
        n.middle = first + (last - first) / 2;
        n.last = last;
        return n;
    }
    template <class Visit>
    void each_point(std::size_t i, const Visit& visit) const {
        for (std::size_t k = begin_[2 * i]; k < begin_[2 * i + 1]; ++k) visit(order_[k]);
    }
    static bool is_between(const Node& n, const double* x) {
        return (!n.has_low || n.low.has_after(x)) && (!n.has_high || n.high.has_before(x));
    }
    bool is_settled(const Node& n) const {
        const double each = static_cast<double>(n.points) / (n.last - n.first);
        return n.has_best && static_cast<double>(n.off) <= tolerance * each;
    }

    // Chooses the axis of the longest side of the box around each node's points. Counts the points.
    void choose_axes() {
        Buffer<double> box(nodes_.allocator());
        Buffer<std::uint64_t> points(nodes_.allocator());
        box.resize(6 * nodes_.size(), std::numeric_limits<double>::infinity());
        points.resize(nodes_.size());
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            points[i] = begin_[2 * i + 1] - begin_[2 * i];
            each_point(i, [&](const double* x) {
                for (unsigned k = 0; k < 3; ++k) {
                    box[6 * i + k] = std::min(box[6 * i + k], x[k]);
                    box[6 * i + 3 + k] = std::min(box[6 * i + 3 + k], -x[k]);
                }
            });
        }
        collective_.least(box);
        collective_.sum(points);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            Node& n = nodes_[i];
            n.points = points[i];
            n.wanted = static_cast<std::uint64_t>(static_cast<double>(n.points) *
                                                  (n.middle - n.first) / (n.last - n.first));
            // The coordinates are halved, since the difference of two doubles may overflow.
            const auto half_side = [&](unsigned k) {
                return -(0.5 * box[6 * i + k] + 0.5 * box[6 * i + 3 + k]);
            };
            for (unsigned k = 1; k < 3; ++k)
                if (n.points > 0 && half_side(k) > half_side(n.axis)) n.axis = k;
        }
    }

    // Chooses candidates among the points of each node that are still between two candidates. Each
    // process offers a number in proportion to its share of these points.
    void offer(std::uint64_t round) {
        const std::uint64_t wanted = std::min(
            candidates_wanted, std::max(candidates_least, candidates_in_all / nodes_.size()));
        look_between();
        mine_.clear();
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const double* const* const from = between_.data() + begin_between_[i];
            const std::uint64_t size = begin_between_[i + 1] - begin_between_[i],
                                of_all = count_between_[i];
            if (of_all <= wanted) {
                for (std::uint64_t k = 0; k < size; ++k) offer(i, from[k]);
                continue;
            }
            Random random((std::uint64_t{collective_.first_local()} << 32 | i) ^ depth_ << 24 ^
                          round << 60);
            // Rounds up at random, so that the expected value is exact.
            const std::uint64_t count = (wanted * size + random.next() % of_all) / of_all;
            for (std::uint64_t k = 0; k < count; ++k) offer(i, from[random.next() % size]);
        }
        collective_.gather_all(mine_, all_);
        std::sort(all_.begin(), all_.end(), [&](const Candidate& a, const Candidate& b) {
            if (a.node != b.node) return a.node < b.node;
            return splitter(b).has_before(a.x);
        });
        if (round == 0) keep_likely();
        first_.clear();
        first_.resize(nodes_.size() + 1, all_.size());
        for (std::size_t k = all_.size(); k-- > 0;) first_[node_of(all_[k])] = k;
        for (std::size_t i = nodes_.size(); i-- > 0;)
            first_[i] = std::min(first_[i], first_[i + 1]);
    }
    // Lists the local points between the two enclosing candidates of each node that is not settled.
    // Counts these points over all processes, in count_between_.
    void look_between() {
        between_.clear();
        begin_between_.clear();
        count_between_.clear();
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const Node& n = nodes_[i];
            begin_between_.push_back(between_.size());
            if (!is_settled(n))
                each_point(i, [&](const double* x) {
                    if (is_between(n, x)) between_.push_back(x);
                });
            count_between_.push_back(between_.size() - begin_between_[i]);
        }
        begin_between_.push_back(between_.size());
        collective_.sum(count_between_);
    }
    void offer(std::size_t node, const double* x) { mine_.push_back({{x[0], x[1], x[2]}, node}); }
    // The first candidates are a random sample. Keeps the candidates that are likely to enclose the
    // wanted splitter, so that most points are compared with the first and the last candidate
    // alone. If the sample is misleading, the next round searches further.
    void keep_likely() {
        Candidate* to = all_.begin();
        for (Candidate* from = all_.begin(); from != all_.end();) {
            Candidate* const end = std::find_if(
                from, all_.end(), [&](const Candidate& c) { return c.node != from->node; });
            const Node& n = nodes_[node_of(*from)];
            const auto size = static_cast<double>(end - from);
            const double share = static_cast<double>(n.middle - n.first) / (n.last - n.first),
                         spread = 4 * std::sqrt(size * share * (1 - share)) + 1;
            const auto low = static_cast<std::ptrdiff_t>(std::max(0.0, size * share - spread)),
                       high = static_cast<std::ptrdiff_t>(std::min(size, size * share + spread));
            // `to` is never beyond the candidate that is read, so no unread one is overwritten.
            for (std::ptrdiff_t k = low; k < high; ++k) *to++ = from[k];
            from = end;
        }
        all_.resize(static_cast<std::size_t>(to - all_.begin()));
    }
    static std::size_t node_of(const Candidate& c) { return static_cast<std::size_t>(c.node); }
    Splitter splitter(const Candidate& c) const {
        return {{c.x[0], c.x[1], c.x[2]}, nodes_[node_of(c)].axis};
    }

    // Counts the points of a node before its first candidate, between the first and the second, and
    // so on.
    void count() {
        counts_.clear();
        counts_.resize(all_.size() + nodes_.size(), 0);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const Candidate *const from = all_.begin() + first_[i], *const to = all_.begin() +
                                                                                first_[i + 1];
            if (from == to) continue;
            std::uint64_t* const counts = counts_.data() + first_[i] + i;
            const Splitter first = splitter(*from), last = splitter(to[-1]);
            std::uint64_t before = 0;
            each_point(i, [&](const double* x) {
                if (first.has_before(x)) {
                    ++before;
                } else if (last.has_before(x)) {
                    const Candidate* const next =
                        std::upper_bound(from, to, x, [&](const double* p, const Candidate& c) {
                            return splitter(c).has_before(p);
                        });
                    ++counts[next - from];
                }
            });
            counts[0] += before;
        }
        collective_.sum(counts_);
    }

    // Chooses the best candidate so far. Returns whether another round is needed.
    bool narrow() {
        bool goes_on = false;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            Node& n = nodes_[i];
            if (count_between_[i] == 0) continue;
            const std::uint64_t* const counts = counts_.data() + first_[i] + i;
            std::uint64_t before = 0;
            for (std::size_t k = first_[i]; k < first_[i + 1]; ++k) {
                before += counts[k - first_[i]];
                const Splitter s = splitter(all_[k]);
                const std::uint64_t off = before < n.wanted ? n.wanted - before : before - n.wanted;
                if (!n.has_best || off < n.off) {
                    n.best = s;
                    n.off = off;
                    n.has_best = true;
                }
                if (before <= n.wanted) {
                    n.low = s;
                    n.has_low = true;
                } else {
                    n.high = s;
                    n.has_high = true;
                    break;
                }
            }
            goes_on = goes_on || !is_settled(n);
        }
        return goes_on;
    }

    Collective& collective_;
    Buffer<Node> nodes_;
    // The points of node i are order_[begin_[2 i]] to order_[begin_[2 i + 1] - 1].
    Buffer<std::size_t> begin_;
    Buffer<const double*> order_;  // the points of the local parts, sorted by node
    Buffer<Candidate> mine_,
        all_;  // the candidates of this process; of all processes, sorted by node and position
    Buffer<const double*> between_;
    Buffer<std::size_t> begin_between_;  // where each node's points begin in between_; and the end
    Buffer<std::uint64_t> count_between_;
    Buffer<std::size_t> first_;     // where the candidates of each node begin in all_
    Buffer<std::uint64_t> counts_;  // each node has one count more than it has candidates
    std::uint64_t depth_ = 0;
};

void Homes::divide(Collective& all, const GivenPoints* points) {
    splitters_.clear();
    splitters_.resize(parts_, Splitter{{0, 0, 0}, 0});
    if (parts_ < 2) return;
    Level level(splitters_.allocator(), all, points);
    for (; !level.is_done(); level.descend()) level.divide(splitters_);
}

}  // namespace mgdt
