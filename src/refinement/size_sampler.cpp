// SPDX-License-Identifier: MIT
#include "refinement/size_sampler.hpp"

#include <algorithm>
#include <limits>

#include "core/point_scan.hpp"
#include "interpolation/interpolation.hpp"
#include "platform/callback.hpp"
#include "platform/error.hpp"

namespace mgdt {

SizeSampler::SizeSampler(const VaryingSizes& sizes, double scale, Team& team, Allocator& allocator,
                         StageProgress& progress)
    : given_(sizes),
      scale_(scale),
      team_(team),
      allocator_(allocator),
      progress_(progress),
      places_(allocator),
      values_(allocator) {
    if (sizes.field_sizes.empty()) return;
    field_.emplace(&Allocator::allocate_from, &Allocator::release_to,
                   static_cast<void*>(&allocator));
    field_->settings().threads = static_cast<std::int32_t>(team.size());
    const double* const x = sizes.field_points.data();
    const double* const axis[3] = {x, x + 1, x + 2};
    field_->insert(sizes.field_sizes.size(), axis, 3);
}

void SizeSampler::sample(std::size_t n, const double* places, double* sizes) {
    places_.clear();
    places_.resize(3 * n);
    for (std::size_t i = 0; i < 3 * n; ++i) places_[i] = places[i] / scale_;
    std::fill_n(sizes, n, std::numeric_limits<double>::infinity());
    if (field_) interpolate_field(n, sizes);
    if (given_.function) ask_function(n, sizes);
}

void SizeSampler::list_seeds(Buffer<SizeTree::Seed>& seeds) const {
    seeds.grow(given_.field_sizes.size());
    for (std::size_t i = 0; i < given_.field_sizes.size(); ++i) {
        const double* const x = given_.field_points.data() + 3 * i;
        seeds.push_back(
            {{x[0] * scale_, x[1] * scale_, x[2] * scale_}, given_.field_sizes[i] * scale_});
    }
}

// Outside of the field's hull, the nearest place of the hull has the size. Points in one plane have
// no tetrahedra: then the nearest point has it.
void SizeSampler::interpolate_field(std::size_t n, double* sizes) {
    const MeshView view = {team_, field_->mesh(), nullptr, allocator_, 0, false};
    const Locator where = {field_->mesh(), field_->calls(), field_->location_tree()};
    const Manner manner = {field_->dimension() == 3 ? Method::linear : Method::nearest,
                           Outside::boundary};
    const double* const axis[3] = {places_.data(), places_.data() + 1, places_.data() + 2};
    const PointSet set = PointScan(team_, n, axis, 3, 0).point_set(n, axis, 3, 1);
    values_.resize(n);
    StageProgress quiet = progress_.quiet();
    interpolate(view, where, manner, {1, given_.field_sizes.data()}, set, quiet, values_.data());
    for (std::size_t i = 0; i < n; ++i)
        if (values_[i] > 0) sizes[i] = std::min(sizes[i], values_[i] * scale_);
}

void SizeSampler::ask_function(std::size_t n, double* sizes) {
    values_.clear();
    values_.resize(n, 0);
    const std::int32_t answer = call_back<std::int32_t>(1, [&] {
        return given_.function(static_cast<std::int64_t>(n), places_.data(), values_.data(),
                               given_.user);
    });
    if (answer != 0) fail(MGDT_ERR_CANCELLED, "the size function asked to stop");
    for (std::size_t i = 0; i < n; ++i) {
        const double* const x = places_.data() + 3 * i;
        if (!(values_[i] >= 0))
            fail(MGDT_ERR_INVALID_ARGUMENT, "the size function gives %g at (%g, %g, %g)",
                 values_[i], x[0], x[1], x[2]);
        if (values_[i] > 0) sizes[i] = std::min(sizes[i], values_[i] * scale_);
    }
}

}  // namespace mgdt
