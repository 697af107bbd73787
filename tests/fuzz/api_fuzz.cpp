// SPDX-License-Identifier: MIT
// A program of calls on one handle, read from the input: settings, insertions of all shapes, points
// that leave and move, calls that are refused, cancelled or run out of memory, queries in between,
// and callbacks that call the handle. After each call the handle proves itself, and at the end its
// tetrahedra are those that the points have by other ways.
#include <atomic>
#include <optional>
#include <thread>

#include "../support/reproduction.h"
#include "capi/triangulation_handle.hpp"
#include "comparison.hpp"
#include "counted_memory.hpp"
#include "wrong_calls.hpp"

namespace fuzz {
namespace {

constexpr std::size_t most_points = 200;
// Points looked at, those among others that need long integers counting more.
constexpr std::size_t most_work = 2000;
constexpr int most_calls = 30;

void pause() {
    std::this_thread::yield();
}

class Calls {
  public:
    explicit Calls(Input& in) : in_(in) {
        const unsigned b = in.byte();
        source_.choose_sphere(b);
        margin_ = b & 4 ? 3 : 0;
        may_be_wide_ = (b & 3) == 0;
        if (b & 8) memory_.refuse(1 + (b >> 4), true);
        const mgdt_status status = mgdt_create_with_allocator(
            CountedMemory::obtain, CountedMemory::release, &memory_, &t_);
        FUZZ_REQUIRE(status == MGDT_OK || (status == MGDT_ERR_OUT_OF_MEMORY && memory_.is_armed()),
                     mgdt_status_string(status));
        FUZZ_REQUIRE((t_ == nullptr) == (status != MGDT_OK), "a handle and a failure");
        memory_.refuse(0, false);
        memory_.set_handle(t_);
    }
    ~Calls() { mgdt_destroy(t_); }
    Calls(const Calls&) = delete;
    Calls& operator=(const Calls&) = delete;

    void run() {
        if (!t_) return;
        for (int call = 0; call < most_calls && work_ < most_work && !in_.empty(); ++call) step();
        finish();
    }

  private:
    struct Snapshot;

    void step() {
        switch (in_.below(22)) {
            case 0:
                set_order();
                break;
            case 1:
                set_threads();
                break;
            case 2:
                set_output();
                break;
            case 3:
                set_limit();
                break;
            case 4:
                set_memory();
                break;
            case 5:
                set_progress();
                break;
            case 6:
                cancel();
                break;
            case 7:
                clear();
                break;
            case 8:
                reserve();
                break;
            case 9:
                refused();
                break;
            case 10:
                locate();
                break;
            case 11:
                nearest();
                break;
            case 12:
                together();
                break;
            case 13:
                query_in_need();
                break;
            case 19:
                remove();
                break;
            case 20:
                move();
                break;
            case 21:
                renumber();
                break;
            default:
                insert();
                break;
        }
    }

    void ok(mgdt_status status) { FUZZ_REQUIRE(status == MGDT_OK, error_of(t_)); }

    // ------------------------------------------------------------------------------ settings

    void set_order() {
        ok(mgdt_set_order_scheme(
            t_, order_schemes[in_.below(static_cast<unsigned>(order_schemes.size()))]));
        ok(mgdt_set_seed(t_, in_.byte()));
        const unsigned b = in_.byte();
        ok(mgdt_set_order_parameter(t_, MGDT_PARAMETER_POINTS_PER_CELL, b & 15));
        ok(mgdt_set_order_parameter(t_, MGDT_PARAMETER_THRESHOLD, b >> 4));
        ok(mgdt_set_order_parameter(t_, MGDT_PARAMETER_SEPARATION, (b >> 2) % 3));
        ok(mgdt_set_order_parameter(t_, MGDT_PARAMETER_ROUND_RATIO, b < 128 ? 0 : 1 + b / 64.0));
    }

    // Sets this small would be left to one thread.
    void set_threads() {
        const unsigned b = in_.byte();
        ok(mgdt_set_threads(t_, 1 + static_cast<std::int32_t>(b & 3)));
        t_->object.hooks().min_points_per_thread = 1 + (b >> 2 & 15);
        t_->object.hooks().pause = b & 64 ? pause : nullptr;
        t_->object.hooks().zones = b & 128 ? mgdt::ZoneUse::always : mgdt::ZoneUse::never;
        set_isa(t_, in_.byte());
    }

    void set_output() {
        const unsigned b = in_.byte();
        base_ = b & 1;
        canonical_ = b >> 1 & 1;
        ok(mgdt_set_index_base(t_, base_));
        ok(mgdt_set_canonical_output(t_, canonical_));
        set_compact(b >> 2 & 1);
    }

    // What is compact gives memory back; what is no longer so may run out, with nothing changed.
    void set_compact(std::int32_t compact) {
        const bool grows = compact_ != 0 && compact == 0;
        std::optional<Snapshot> before;
        if (grows) before.emplace(*this);
        refuses_ = memory_.is_armed();
        const mgdt_status status = mgdt_set_compact(t_, compact);
        FUZZ_REQUIRE(status == MGDT_OK || (grows && may_run_out(status)), error_of(t_));
        refuses_ = false;
        if (before) before->expect_same();
        if (status != MGDT_OK || compact == compact_) return;
        compact_ = compact;
        verify();
    }

    void set_limit() {
        double held = 0;
        ok(mgdt_get_stat(t_, MGDT_STAT_MEMORY_BYTES, &held));
        const unsigned b = in_.byte();
        limit_ = b == 0 ? 0 : static_cast<std::int64_t>(held) + (b - 1) * 128;
        ok(mgdt_set_memory_limit(t_, limit_));
    }

    // An allocator that refuses, or that calls the handle from whatever thread it is asked on.
    void set_memory() {
        const unsigned n = in_.byte(), b = in_.byte();
        memory_.refuse(n, (b & 1) != 0);
        memory_.set_visitor((b & 2) != 0 ? visit : nullptr, this);
    }

    static void visit(void* user) {
        Calls& self = *static_cast<Calls*>(user);
        busy_call(self.visits_++, self.t_);
    }

    void set_progress() {
        heard_ = 0;
        stop_at_ = in_.byte();
        const unsigned b = in_.byte();
        stops_by_cancel_ = (b & 1) != 0;
        calls_handle_ = (b & 2) != 0;
        ok(mgdt_set_progress(t_, stop_at_ == 0 ? nullptr : progress, this));
    }

    static std::int32_t progress(double fraction, void* user) {
        Calls& self = *static_cast<Calls*>(user);
        FUZZ_REQUIRE(fraction >= 0 && fraction <= 1, std::to_string(fraction));
        if (self.calls_handle_) {
            const unsigned which = self.visits_++;
            if (which % 2 == 0)
                busy_call(which / 2, self.t_);
            else
                busy_query(which / 2, self.t_);
        }
        if (++self.heard_ < self.stop_at_) return 0;
        self.heard_ = 0;
        self.stopped_ = self.stopped_ || fraction < 1;
        if (!self.stops_by_cancel_) return -1;
        mgdt_cancel(self.t_);
        return 0;
    }

    void cancel() {
        ok(mgdt_cancel(t_));
        cancelled_ = true;
    }

    void clear() {
        if (!in_.flag()) return;
        ok(mgdt_clear(t_));
        points_.clear();
        was_in_.clear();
        cancelled_ = false;  // a request to stop is withdrawn
        verify();
    }

    void reserve() {
        refuses_ = memory_.is_armed();
        const unsigned b = in_.byte();
        if (b >= 128) ok(mgdt_shrink(t_));
        const mgdt_status status = b < 192 ? mgdt_reserve(t_, b) : MGDT_OK;
        FUZZ_REQUIRE(status == MGDT_OK || may_run_out(status), error_of(t_));
        verify();
    }

    bool may_run_out(mgdt_status status) const {
        return status == MGDT_ERR_OUT_OF_MEMORY && (limit_ != 0 || memory_.is_armed() || refuses_);
    }

    // ------------------------------------------------------------------------------ insertion

    // Kinds that need the longest integers come seldom, since each point takes milliseconds then.
    unsigned draw_kind() {
        const unsigned b = in_.byte() & 31;
        if (b < 29 || !may_be_wide_) return b % PointSource::exponents;
        is_wide_ = true;
        return PointSource::exponents + (b - 29);
    }

    std::vector<Point> draw_points(std::size_t most) {
        const std::size_t n = std::min<std::size_t>(in_.byte() & (is_wide_ ? 7 : 31), most);
        const unsigned kind = draw_kind();
        const bool is_mixed = in_.flag();
        std::vector<Point> all = points_;
        for (std::size_t i = 0; i < n; ++i)
            all.push_back(source_.draw(in_, is_mixed ? draw_kind() : kind, all));
        return {all.begin() + static_cast<std::ptrdiff_t>(points_.size()), all.end()};
    }

    // The call, with the points in one of the shapes that it takes.
    mgdt_status give(std::vector<Point>& points) {
        const std::size_t n = points.size();
        const auto count = static_cast<std::int64_t>(n);
        const unsigned shape = in_.below(8);
        if (n == 0) return mgdt_insert_points(t_, 0, nullptr);
        if (shape == 7) {  // one place, many times
            points.assign(n, points[0]);
            const Point p = points[0];
            return mgdt_insert_points_strided(t_, count, &p[0], &p[1], &p[2], 0);
        }
        const std::size_t stride = shape < 3 ? 3 : shape == 3 ? 1 : shape;
        const bool backwards = shape == 6;
        std::vector<double> axis[3];
        if (stride == 1) {
            for (std::size_t k = 0; k < 3; ++k)
                for (const Point& p : points) axis[k].push_back(p[k]);
            return mgdt_insert_points_strided(t_, count, axis[0].data(), axis[1].data(),
                                              axis[2].data(), 1);
        }
        std::vector<double> records(stride * (n - 1) + 3, 1e77);
        for (std::size_t i = 0; i < n; ++i)
            std::copy(points[i].begin(), points[i].end(),
                      &records[stride * (backwards ? n - 1 - i : i)]);
        if (shape < 3) return mgdt_insert_points(t_, count, records.data());
        const double* const first = backwards ? &records[stride * (n - 1)] : records.data();
        const auto step = static_cast<std::int64_t>(stride);
        return mgdt_insert_points_strided(t_, count, first, first + 1, first + 2,
                                          backwards ? -step : step);
    }

    void insert() {
        std::vector<Point> added = draw_points(most_points - points_.size());
        refuses_ = memory_.is_armed();
        stopped_ = false;
        const bool was_cancelled = cancelled_;
        const bool could_stop = stop_at_ != 0 || was_cancelled;
        const Snapshot before(*this);
        const mgdt_status status = give(added);

        for (std::size_t i = 0; i < added.size(); ++i) {
            if (std::isfinite(added[i][0]) && std::isfinite(added[i][1]) &&
                std::isfinite(added[i][2]))
                continue;
            const std::string index = std::to_string(i + points_.size() + unsigned(base_));
            FUZZ_REQUIRE(status == MGDT_ERR_NOT_FINITE, mgdt_status_string(status));
            FUZZ_REQUIRE(error_of(t_).find(index) != std::string::npos, error_of(t_));
            before.expect_same();
            return;
        }
        if (!added.empty()) cancelled_ = false;
        FUZZ_REQUIRE(status == MGDT_OK || (status == MGDT_ERR_CANCELLED && could_stop) ||
                         may_run_out(status),
                     error_of(t_));
        FUZZ_REQUIRE(status != MGDT_OK || !(stopped_ || (was_cancelled && !added.empty())),
                     "not cancelled");
        refuses_ = false;

        const auto counted = static_cast<std::size_t>(mgdt_point_count(t_));
        if (counted == points_.size() && !added.empty()) {
            FUZZ_REQUIRE(status == MGDT_ERR_OUT_OF_MEMORY, "points are not counted");
            before.expect_same();
            return;
        }
        points_.insert(points_.end(), added.begin(), added.end());
        FUZZ_REQUIRE(counted == points_.size(), std::to_string(counted));
        const bool held = before.exports.dimension < 3;
        const Exports now = verify();
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const bool is_new = i >= was_in_.size();
            // Running out of memory may lose points that were held.
            if (is_new ? status == MGDT_OK
                       : was_in_[i] && !(held && status == MGDT_ERR_OUT_OF_MEMORY))
                FUZZ_REQUIRE(now.is_in(i), "point " + std::to_string(i) + " is not in");
        }
        was_in_.resize(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i) was_in_[i] = now.is_in(i);
        verify_statistics(now);
    }

    void verify_statistics(const Exports& now) {
        double inserted = 0, repeats = 0;
        std::int64_t in = 0;
        for (std::size_t i = 0; i < points_.size(); ++i) in += now.is_in(i);
        ok(mgdt_get_stat(t_, MGDT_STAT_POINTS_INSERTED, &inserted));
        ok(mgdt_get_stat(t_, MGDT_STAT_DUPLICATES, &repeats));
        FUZZ_REQUIRE(inserted == static_cast<double>(now.vertices), std::to_string(inserted));
        FUZZ_REQUIRE(repeats == static_cast<double>(in - now.vertices), std::to_string(repeats));
    }

    // ------------------------------------------------------------------- points out and moved

    // Indices of points, counted from 0: seldom one of no point, one that is not in, or one twice.
    Indices draw_list() {
        const std::size_t n = in_.byte() & 31;
        Indices list;
        for (std::size_t k = 0; k < n; ++k) {
            const unsigned b = in_.byte();
            auto i = static_cast<std::int64_t>(points_.empty() ? 0 : b % points_.size());
            if (b == 255) i = -1;
            if (b == 254) i = static_cast<std::int64_t>(points_.size());
            const bool is_good = is_in(i) && std::find(list.begin(), list.end(), i) == list.end();
            if (is_good || b >= 240) list.push_back(i);
        }
        return list;
    }
    bool is_in(std::int64_t i) const {
        return i >= 0 && i < static_cast<std::int64_t>(points_.size()) &&
               was_in_[static_cast<std::size_t>(i)];
    }
    bool is_good(Indices list) const {
        std::sort(list.begin(), list.end());
        return std::all_of(list.begin(), list.end(), [&](std::int64_t i) { return is_in(i); }) &&
               std::adjacent_find(list.begin(), list.end()) == list.end();
    }
    // As the call takes it, in one of two widths.
    template <class Int>
    std::vector<Int> given(const Indices& list) const {
        std::vector<Int> out;
        for (const std::int64_t i : list) out.push_back(static_cast<Int>(i + base_));
        return out;
    }

    // How many points of the list a call has done that ended so. `changes`: it has something to do.
    std::size_t done(mgdt_status status, std::size_t n, bool changes, bool could_stop,
                     bool was_cancelled) {
        FUZZ_REQUIRE(status == MGDT_OK || (status == MGDT_ERR_CANCELLED && could_stop) ||
                         may_run_out(status),
                     error_of(t_));
        FUZZ_REQUIRE(status != MGDT_OK || !(stopped_ || (was_cancelled && changes)),
                     "not cancelled");
        refuses_ = false;
        cancelled_ = false;
        if (status == MGDT_OK) return n;
        // Where memory runs out at the very beginning, a request to stop may still be pending.
        if (status == MGDT_ERR_OUT_OF_MEMORY) cancel();
        unsigned long first = 0, of = n;
        const std::string text = error_of(t_);
        const std::size_t after = text.find("after ");
        if (after != std::string::npos) {
            const int found = std::sscanf(text.c_str() + after, "after %lu of %lu", &first, &of);
            FUZZ_REQUIRE(found == 2 && first < of, text);
        }
        FUZZ_REQUIRE(of == n, text);
        return first;
    }

    void remove() {
        const Indices list = draw_list();
        const auto n = static_cast<std::int64_t>(list.size());
        begin_change();
        const bool was_cancelled = cancelled_;
        const Snapshot before(*this);
        const std::vector<std::int64_t> wide = given<std::int64_t>(list);
        const std::vector<std::int32_t> narrow = given<std::int32_t>(list);
        const mgdt_status status = in_.flag() ? mgdt_remove_points(t_, n, wide.data())
                                              : mgdt_remove_points_i32(t_, n, narrow.data());
        if (!is_good(list)) {
            expect_refused(status, before);
            return;
        }
        if (n == 0) {
            ok(status);
            return;
        }
        const std::size_t out =
            done(status, list.size(), true, stop_at_ != 0 || was_cancelled, was_cancelled);
        // Where not all are out, the point map says which.
        const Exports now = canonical();
        std::size_t gone = 0;
        for (const std::int64_t i : list) {
            const auto at = static_cast<std::size_t>(i);
            was_in_[at] = now.is_in(at);
            gone += !was_in_[at];
        }
        FUZZ_REQUIRE(gone == out, std::to_string(gone));
        expect_in();
    }

    void move() {
        const bool is_all = in_.flag() && points_.size() < 32;
        Indices list;
        if (!is_all) list = draw_list();
        for (std::size_t i = 0; is_all && i < points_.size(); ++i)
            if (was_in_[i]) list.push_back(static_cast<std::int64_t>(i));
        std::vector<Point> places = draw_points(list.size());
        // Some stay where they are, or go back there.
        while (places.size() < list.size()) {
            const std::int64_t i = list[places.size()];
            places.push_back(is_in(i) ? points_[static_cast<std::size_t>(i)] : Point{});
        }
        begin_change();
        const bool was_cancelled = cancelled_;
        const Snapshot before(*this);
        const mgdt_status status = give_move(is_all, list, places);
        const bool is_finite = std::all_of(places.begin(), places.end(), [](const Point& p) {
            return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
        });
        if (!is_good(list)) {
            expect_refused(status, before);
            return;
        }
        if (list.empty()) {
            FUZZ_REQUIRE(status == MGDT_OK || may_run_out(status), error_of(t_));
            refuses_ = false;
            before.expect_same();
            return;
        }
        if (!is_finite) {
            if (may_run_out(status)) {
                done(status, list.size(), false, false, false);
            } else {
                FUZZ_REQUIRE(status == MGDT_ERR_NOT_FINITE, mgdt_status_string(status));
                refuses_ = false;
            }
            before.expect_same();
            return;
        }
        const std::size_t moved =
            done(status, list.size(), true, stop_at_ != 0 || was_cancelled, was_cancelled);
        for (std::size_t k = 0; k < moved; ++k)
            points_[static_cast<std::size_t>(list[k])] = places[k];
        expect_in();
    }

    mgdt_status give_move(bool is_all, const Indices& list, const std::vector<Point>& places) {
        std::vector<double> xyz;
        const auto n = static_cast<std::int64_t>(is_all ? points_.size() : list.size());
        if (is_all) xyz.assign(3 * points_.size(), std::numeric_limits<double>::quiet_NaN());
        if (!is_all) xyz.resize(3 * list.size());
        for (std::size_t k = 0; k < list.size(); ++k)
            std::copy(places[k].begin(), places[k].end(),
                      &xyz[3 * (is_all ? static_cast<std::size_t>(list[k]) : k)]);
        const std::vector<std::int64_t> wide = given<std::int64_t>(list);
        const std::vector<std::int32_t> narrow = given<std::int32_t>(list);
        if (in_.flag()) return mgdt_move_points(t_, n, is_all ? nullptr : wide.data(), xyz.data());
        return mgdt_move_points_i32(t_, n, is_all ? nullptr : narrow.data(), xyz.data());
    }

    void renumber() {
        const std::size_t n = points_.size();
        const auto count = static_cast<std::int64_t>(n);
        Exact<std::int64_t> wide(n, margin_);
        Exact<std::int32_t> narrow(n, margin_);
        const bool is_wide = in_.flag();
        ok(is_wide ? mgdt_renumber_points(t_, count, wide.data())
                   : mgdt_renumber_points_i32(t_, count, narrow.data()));
        Indices index = wide.take();
        const std::vector<std::int32_t> same = narrow.take();
        if (!is_wide) index.assign(same.begin(), same.end());
        std::size_t next = 0;
        for (std::size_t i = 0; i < n; ++i) {
            FUZZ_REQUIRE(index[i] - base_ == (was_in_[i] ? static_cast<std::int64_t>(next) : -1),
                         std::to_string(index[i]));
            if (was_in_[i]) points_[next++] = points_[i];
        }
        points_.resize(next);
        was_in_.assign(next, true);
        expect_in();
    }

    void begin_change() {
        refuses_ = memory_.is_armed();
        stopped_ = false;
    }

    void expect_refused(mgdt_status status, const Snapshot& before) {
        FUZZ_REQUIRE(status == MGDT_ERR_INVALID_ARGUMENT || may_run_out(status),
                     mgdt_status_string(status));
        refuses_ = false;
        before.expect_same();
    }

    void expect_in() {
        const Exports now = verify();
        for (std::size_t i = 0; i < points_.size(); ++i)
            FUZZ_REQUIRE(now.is_in(i) == was_in_[i], "point " + std::to_string(i));
        verify_statistics(now);
    }

    void refused() {
        const Snapshot before(*this);
        wrong_call(in_, t_);
        before.expect_same();
    }

    // -------------------------------------------------------------------------------- queries

    void locate() {
        const std::vector<Point> asked = draw_points(31);
        const std::size_t n = asked.size();
        std::vector<double> xyz;
        bool finite = true;
        for (const Point& p : asked) {
            xyz.insert(xyz.end(), p.begin(), p.end());
            for (const double x : p) finite = finite && std::isfinite(x);
        }
        const Unlimited unlimited(*this);
        const auto count = static_cast<std::int64_t>(n);
        Exact<std::int64_t> wide(n, margin_);
        Exact<std::int32_t> narrow(n, margin_);
        Exact<double> weights(4 * n, margin_);
        const mgdt_status status =
            mgdt_locate_points(t_, count, xyz.data(), wide.data(), weights.data());
        if (!finite) {
            FUZZ_REQUIRE(status == MGDT_ERR_NOT_FINITE, mgdt_status_string(status));
            FUZZ_REQUIRE(wide.is_untouched() && weights.is_untouched(), "outputs are touched");
            return;
        }
        ok(status);
        ok(mgdt_locate_points_i32(t_, count, xyz.data(), narrow.data(), nullptr));
        const Exports now(t_, base_, 0);
        const Indices found = wide.take();
        const std::vector<std::int32_t> same = narrow.take();
        const std::vector<double> w = weights.take();
        FUZZ_REQUIRE(std::equal(found.begin(), found.end(), same.begin()), "64 and 32 bits differ");
        for (std::size_t i = 0; i < n; ++i) {
            verify_place(now, found[i] - base_, asked[i]);
            std::int64_t alone = -99;
            ok(mgdt_locate(t_, &xyz[3 * i], &alone));
            verify_place(now, alone - base_, asked[i]);
            std::int32_t alone32 = -99;
            ok(mgdt_locate_i32(t_, &xyz[3 * i], &alone32));
            FUZZ_REQUIRE(alone32 == alone, "64 and 32 bits differ");
            double sum = 0;
            for (std::size_t k = 0; k < 4; ++k) sum += w[4 * i + k];
            const double expected = found[i] < base_ ? 0 : 1;
            FUZZ_REQUIRE(std::fabs(sum - expected) <= 1e-15, "weights " + std::to_string(sum));
            if (found[i] < base_) continue;
            const std::int64_t* v = &now.tetrahedra[4 * static_cast<std::size_t>(found[i] - base_)];
            const double* vertices[4] = {at(v[0]), at(v[1]), at(v[2]), at(v[3])};
            FUZZ_REQUIRE(reproduces(vertices, &xyz[3 * i], &w[4 * i]),
                         "the weights of point " + std::to_string(i));
        }
    }

    void verify_place(const Exports& now, std::int64_t tetrahedron, const Point& q) const {
        const auto side = [&](std::int64_t a, std::int64_t b, std::int64_t c) {
            return mgdt::orientation(at(a), at(b), at(c), q.data());
        };
        FUZZ_REQUIRE(tetrahedron >= -1 && tetrahedron < static_cast<std::int64_t>(now.count()),
                     std::to_string(tetrahedron));
        if (tetrahedron >= 0) {
            const std::int64_t* v = &now.tetrahedra[4 * static_cast<std::size_t>(tetrahedron)];
            FUZZ_REQUIRE(side(v[0], v[1], v[2]) >= 0 && side(v[0], v[2], v[3]) >= 0 &&
                             side(v[0], v[3], v[1]) >= 0 && side(v[1], v[3], v[2]) >= 0,
                         "the point is not in its tetrahedron");
            return;
        }
        bool outside = now.hull.empty();
        for (std::size_t h = 0; h < now.hull.size() && !outside; h += 3)
            outside = side(now.hull[h], now.hull[h + 1], now.hull[h + 2]) > 0;
        FUZZ_REQUIRE(outside, "a point of the hull is in no tetrahedron");
    }

    void nearest() {
        const std::vector<Point> asked = draw_points(4);
        const Unlimited unlimited(*this);
        const Exports now(t_, base_, 0);
        Exact<std::int64_t> all(asked.size(), margin_);
        const double* const places = asked.empty() ? nullptr : asked[0].data();
        const mgdt_status of_all =
            mgdt_nearest_vertices(t_, static_cast<std::int64_t>(asked.size()), places, all.data());
        FUZZ_REQUIRE(of_all == MGDT_OK || (of_all == MGDT_ERR_NOT_FINITE && all.is_untouched()),
                     error_of(t_));
        for (const Point& q : asked) {
            std::int64_t found = -99;
            const mgdt_status status = mgdt_nearest_vertex(t_, q.data(), &found);
            if (!std::isfinite(q[0]) || !std::isfinite(q[1]) || !std::isfinite(q[2])) {
                FUZZ_REQUIRE(status == MGDT_ERR_NOT_FINITE && found == -99, error_of(t_));
                continue;
            }
            ok(status);
            FUZZ_REQUIRE(of_all != MGDT_OK || all.data()[&q - asked.data()] == found,
                         "the nearest of many differs");
            found -= base_;
            FUZZ_REQUIRE((found == -1) == (now.vertices == 0), std::to_string(found));
            for (std::size_t i = 0; i < points_.size(); ++i) {
                if (now.map[i] != static_cast<std::int64_t>(i)) continue;
                const int s = mgdt::compare_distance(q.data(), at(found), points_[i].data());
                FUZZ_REQUIRE(s < 0 || (s == 0 && found <= static_cast<std::int64_t>(i)),
                             std::to_string(i) + " is nearer than " + std::to_string(found));
            }
        }
    }

    // Const calls from several threads at once say what they say from one.
    void together() {
        const Unlimited unlimited(*this);
        std::vector<Exports> seen;
        seen.reserve(2);
        std::thread other([&] { static_cast<void>(mgdt_check(t_, MGDT_CHECK_CANONICAL)); });
        std::thread third([&] { seen.emplace_back(t_, base_, 0); });
        const Exports mine(t_, base_, 0);
        other.join();
        third.join();
        FUZZ_REQUIRE(mine == seen[0], "two threads see different arrays");
    }

    // Queries with whatever refusal and limit are set: they answer or run out of memory.
    void query_in_need() {
        const Snapshot before(*this);
        refuses_ = memory_.is_armed();
        const auto count = static_cast<std::size_t>(mgdt_tetrahedron_count(t_));
        Exact<std::int64_t> tetrahedra(4 * count, margin_), found(4, margin_);
        const double xyz[12] = {0, 0, 0, 1, 1, 1, 2, 1, 0, 0.5, 0.25, 3};
        for (const mgdt_status status :
             {mgdt_check(t_, MGDT_CHECK_CANONICAL),
              mgdt_get_tetrahedra(t_, tetrahedra.capacity(), tetrahedra.data()),
              mgdt_locate_points(t_, 4, xyz, found.data(), nullptr),
              mgdt_nearest_vertex(t_, xyz, found.data())})
            FUZZ_REQUIRE(status == MGDT_OK || may_run_out(status), error_of(t_));
        refuses_ = false;
        before.expect_same();
    }

    // ---------------------------------------------------------------------------- verification

    const double* at(std::int64_t v) const { return points_[static_cast<std::size_t>(v)].data(); }

    // Looking at the handle must not fail: no limit, no refusal.
    struct Unlimited {
        explicit Unlimited(Calls& s) : calls(s), saved(s.memory_.pause()) {
            calls.ok(mgdt_set_memory_limit(calls.t_, 0));
        }
        ~Unlimited() {
            calls.memory_.resume(saved);
            mgdt_set_memory_limit(calls.t_, calls.limit_);
        }
        Calls& calls;
        CountedMemory::Refusal saved;
    };

    struct Snapshot {
        explicit Snapshot(Calls& s) : calls(s), exports(s.canonical()) {}
        void expect_same() const {
            FUZZ_REQUIRE(calls.canonical() == exports, "a call that failed changed the handle");
        }
        Calls& calls;
        Exports exports;
    };

    Exports canonical() {
        const Unlimited unlimited(*this);
        ok(mgdt_set_canonical_output(t_, 1));
        const Exports now(t_, base_, margin_);
        ok(mgdt_set_canonical_output(t_, canonical_));
        return now;
    }

    Exports verify() {
        const Unlimited unlimited(*this);
        work_ += (is_wide_ ? 32 : 1) * (points_.size() + 1);
        ok(mgdt_check(t_, MGDT_CHECK_CANONICAL));
        const Exports now(t_, base_, margin_);
        now.verify();
        if (points_.size() <= 16) now.verify_geometry(points_);
        return now;
    }

    void finish() {
        memory_.refuse(0, false);
        limit_ = 0;
        ok(mgdt_set_memory_limit(t_, 0));
        verify().verify_geometry(points_);
        const Exports grown = canonical();
        Indices in, vertices;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const auto index = static_cast<std::int64_t>(i);
            if (grown.is_in(i)) in.push_back(index);
            if (grown.map[i] == index) vertices.push_back(index);
        }
        compare_at_once(in_, grown, points_, in);
        compare_backwards(in_, grown, points_, vertices);
        compare_with_oracle(grown, points_, vertices);
        compare_volumes(grown, points_);
    }

    Input& in_;
    CountedMemory memory_;
    mgdt_triangulation* t_ = nullptr;
    PointSource source_;
    std::vector<Point> points_;  // all that were counted
    std::vector<bool> was_in_;
    std::size_t work_ = 0;
    bool may_be_wide_ = false, is_wide_ = false;  // points that need the longest integers
    bool refuses_ = false;                        // the allocator was armed before the call
    bool cancelled_ = false;
    std::size_t margin_ = 0;
    int base_ = 0, canonical_ = 0, compact_ = 0;
    std::int64_t limit_ = 0;
    unsigned stop_at_ = 0, heard_ = 0;
    bool stops_by_cancel_ = false, calls_handle_ = false;
    std::atomic<unsigned> visits_{0};  // calls of callbacks on the handle
    bool stopped_ = false;             // the callback asked to stop before the end
};

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input in(data, size);
    fuzz::Calls(in).run();
    return 0;
}
