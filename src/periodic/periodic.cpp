// SPDX-License-Identifier: MIT
#include "periodic/periodic.hpp"

#include <algorithm>

#include "periodic/image_prediction.hpp"
#include "periodic/merging.hpp"

namespace mgdt {

Periodic::Periodic(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user)
    : allocator_(alloc, release, user),
      given_(allocator_),
      taken_(allocator_),
      needed_images_(allocator_),
      halo_(allocator_) {}

void Periodic::set_vectors(unsigned dimensions, const double* vectors) {
    const BoxLattice lattice(dimensions, vectors);
    if (has_triangulation_) remember_images();
    if (dimensions != this->dimensions()) needed_images_.reset();
    forget_results();
    lattice_.emplace(lattice);
}

void Periodic::clear() noexcept {
    stop_.forget();
    given_.reset();
    needed_images_.reset();
    forget_results();
}

void Periodic::forget_results() noexcept {
    has_triangulation_ = false;
    neighbors_.forget();
    tetrahedra_.forget();
    halo_.clear();
    taken_.reset();
    grid_.reset();
}

void Periodic::require_room(std::size_t n) const {
    if (n > max_points || point_count() + n > max_points)
        fail(MGDT_ERR_TOO_LARGE, "%zu points are more than can be numbered", point_count() + n);
}

void Periodic::insert(std::size_t n, const double* xyz) {
    if (n == 0) return;
    require_room(n);
    const std::size_t before = given_.size();
    given_.grow(before + 3 * n);
    given_.resize_within_capacity(before + 3 * n);
    std::copy_n(xyz, 3 * n, given_.begin() + before);
    forget_results();
}

void Periodic::move(std::size_t n, const std::uint32_t* points, const double* xyz) {
    for (std::size_t i = 0; i < n; ++i)
        if (points[i] >= point_count())
            fail(MGDT_ERR_INVALID_ARGUMENT, "there is no point %llu",
                 static_cast<unsigned long long>(points[i]) +
                     static_cast<unsigned long long>(settings_.index_base));
    if (n == 0) return;
    if (has_triangulation_) remember_images();
    for (std::size_t i = 0; i < n; ++i)
        std::copy_n(xyz + 3 * i, 3, given_.begin() + 3 * std::size_t{points[i]});
    forget_results();
}

void Periodic::remember_images() {
    Buffer<Halo::UsedImage> used(allocator_);
    halo_.list_used_images(used);
    Buffer<NeededImage> needed(allocator_);
    needed.grow(used.size());
    for (const Halo::UsedImage& u : used)
        needed.push_back({u.by, u.image.point, shift_from(u.by, u.image)});
    needed_images_ = std::move(needed);
}

// Computes the images that have, relative to the moved points, the shifts of the images of the last
// triangulation.
void Periodic::find_expected_images(Buffer<Image>& expected) const {
    constexpr std::int64_t most = 4;
    for (const NeededImage& needed : needed_images_) {
        const std::array<std::int64_t, 3> of_basis =
            grid_->lattice().multiples_of_basis(needed.shift);
        Multiples k = {};
        bool is_near = true;
        for (unsigned c = 0; c < 3 && is_near; ++c) {
            // The multiples of points fit 32 bits. A shift in terms of the new basis may be large,
            // so the sum is computed modulo 2^64: a wrong image costs time, but changes no result.
            const auto of = static_cast<std::int64_t>(
                static_cast<std::uint64_t>(of_basis[c]) +
                static_cast<std::uint64_t>(std::int64_t{taken_[needed.point][c]} -
                                           taken_[needed.by][c]));
            is_near = of >= -most && of <= most;
            if (is_near) k[c] = static_cast<std::int32_t>(of);
        }
        if (is_near && k != Multiples{}) expected.push_back(image_of(needed.point, k));
    }
}

// Rounds the points and moves them into the box.
void Periodic::wrap(Buffer<double>& wrapped) {
    const std::size_t n = point_count();
    const auto number = [&](std::size_t i) {
        return static_cast<unsigned long long>(i) +
               static_cast<unsigned long long>(settings_.index_base);
    };
    PointReach reach(*lattice_);
    for (std::size_t i = 0; i < n; ++i)
        if (!reach.add(given_.begin() + 3 * i))
            fail(MGDT_ERR_INVALID_ARGUMENT,
                 "point %llu is too far from the box in a direction without periods: by more than "
                 "%.0f times the least distance of images",
                 number(i), BoxLattice::largest_ratio);
    grid_.emplace(*lattice_, reach);
    wrapped.resize(3 * n);
    taken_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
        if (!grid_->wrap(given_.begin() + 3 * i, wrapped.begin() + 3 * i, taken_[i]))
            fail(MGDT_ERR_INVALID_ARGUMENT, "point %llu is more than %.0f boxes away from the box",
                 number(i), ImageGrid::farthest);
    if (settings_.merge_distance > 0)
        merge_points(*grid_, lattice_->from_callers(settings_.merge_distance), wrapped, taken_,
                     allocator_);
    has_one_wrap_ = std::all_of(taken_.begin(), taken_.end(),
                                [&](const Multiples& taken) { return taken == taken_[0]; });
}

void Periodic::build() {
    if (!lattice_)
        fail(MGDT_ERR_INVALID_ARGUMENT,
             "the box has no vectors; mgdt_periodic_set_vectors() sets them");
    const StopFlag::Call call(stop_);
    StageProgress progress(settings_, stop_);
    forget_results();
    try {
        progress.enter(0, 0);
        Buffer<double> wrapped(allocator_);
        wrap(wrapped);
        Buffer<Image> expected(allocator_);
        find_expected_images(expected);
        if (expected.empty())
            predict_images(*grid_, wrapped, settings_.threads, progress, expected);
        halo_.build(*grid_, std::move(wrapped), expected, settings_.threads, progress);
    } catch (...) {
        forget_results();
        throw;
    }
    needed_images_.reset();
    has_triangulation_ = true;
    progress.finish();
}

void Periodic::place_of(std::uint32_t point, double* x) const {
    grid_->round(given_.begin() + 3 * std::size_t{point}, x);
}

void Periodic::rounded(std::uint32_t point, double* x) const {
    place_of(point, x);
    for (unsigned c = 0; c < 3; ++c) x[c] = lattice_->to_callers(x[c]);
}

void Periodic::rounded_vector(std::uint32_t k, double* x) const {
    const double* const vector = grid_->lattice().callers_vector(k);
    for (unsigned c = 0; c < 3; ++c) x[c] = lattice_->to_callers(vector[c]);
}

std::size_t Periodic::vertex_count() const {
    std::size_t count = 0;
    for (std::uint32_t p = 0; has_triangulation_ && p < point_count(); ++p)
        count += vertex_of(p) == p ? 1 : 0;
    return count;
}

}  // namespace mgdt
