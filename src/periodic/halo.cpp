// SPDX-License-Identifier: MIT
#include "periodic/halo.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/circumsphere.hpp"
#include "periodic/halo_round.hpp"

namespace mgdt {
namespace {

// The largest width of a shell, as a share of a vector.
constexpr double widest_shell = 0.95;

}  // namespace

void Halo::clear() noexcept {
    triangulation_.reset();
    points_.reset();
    images_.reset();
    known_.reset();
    own_ = 0;
    rounds_ = 0;
}

// The index of an image; no_index if it is not known.
std::uint32_t Halo::number_of(const Image& image) const {
    if (images_.empty()) return no_index;
    const std::uint32_t number =
        known_.find(hash_of(image), [&](std::uint32_t i) { return are_equal(images_[i], image); });
    return number == no_index ? number : static_cast<std::uint32_t>(own_ + number);
}

// Adds an image to the list unless it is known. Returns whether it is new.
bool Halo::add(const Image& image) {
    if (point_count() >= max_points)
        fail(MGDT_ERR_TOO_LARGE, "%zu points and images of points are more than can be numbered",
             point_count() + 1);
    known_.reserve(images_.size() + 1);
    const std::uint32_t number = known_.number(
        hash_of(image), [&](std::uint32_t i) { return are_equal(images_[i], image); });
    if (number < images_.size()) return false;
    images_.push_back(image);
    points_.grow(points_.size() + 3);
    points_.resize_within_capacity(points_.size() + 3);
    double x[3];
    grid_->image(point(image.point), image.multiples(), x);
    std::copy_n(x, 3, points_.end() - 3);
    return true;
}

void Halo::list_used_images(Buffer<UsedImage>& used) const {
    Buffer<std::uint32_t> by(used.allocator());
    by.resize(images_.size(), no_index);
    const Mesh& mesh = triangulation_->mesh();
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
        const Tetrahedron& tetrahedron = mesh.tetrahedra[t];
        if (tetrahedron.is_dead()) continue;
        std::uint32_t own = no_index;
        for (const VertexId v : tetrahedron.v)
            if (v != infinite_vertex && is_own(mesh.vertices[v].index))
                own = mesh.vertices[v].index;
        if (own == no_index) continue;
        for (const VertexId v : tetrahedron.v)
            if (v != infinite_vertex && !is_own(mesh.vertices[v].index))
                by[mesh.vertices[v].index - own_] = own;
    }
    for (std::size_t i = 0; i < images_.size(); ++i)
        if (by[i] != no_index) used.push_back({by[i], images_[i]});
}

std::size_t Halo::bytes_elsewhere() const {
    return triangulation_ && !passes_through_ ? triangulation_->allocator().bytes() : 0;
}

// Adds all images in a shell around the box.
void Halo::add_first_halo() {
    const BoxLattice& lattice = grid_->lattice();
    const unsigned dimensions = lattice.dimensions();
    double low[3], high[3];
    std::fill_n(low, 3, infinity);
    std::fill_n(high, 3, -infinity);
    for (std::uint32_t p = 0; p < own_ && dimensions < 3; ++p) {
        double s[3];
        lattice.coordinates(point(p), s);
        for (unsigned k = dimensions; k < 3; ++k) {
            low[k] = std::min(low[k], s[k]);
            high[k] = std::max(high[k], s[k]);
        }
    }
    // The volume that the points fill, in the coordinates of the basis, and its determinant.
    double volume = 1;
    for (unsigned k = 0; k < 3; ++k) {
        const double* const v = lattice.vector(k);
        const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        volume *= k < dimensions ? length : std::max(high[k] - low[k], 1e-3) * length;
    }
    const double width = first_width * std::cbrt(volume / static_cast<double>(own_));
    for (unsigned k = 0; k < dimensions; ++k)
        shell_[k] = std::min(width * lattice.slope(k), widest_shell);
    for (std::uint32_t p = 0; p < own_; ++p) {
        double s[3];
        lattice.coordinates(point(p), s);
        std::int32_t first[3] = {}, last[3] = {};
        bool is_inner = true;
        for (unsigned k = 0; k < dimensions; ++k) {
            if (s[k] + 1 <= 1 + shell_[k]) last[k] = 1;
            if (s[k] - 1 >= -shell_[k]) first[k] = -1;
            is_inner = is_inner && first[k] == 0 && last[k] == 0;
        }
        if (is_inner) continue;
        Multiples k;
        for (k[0] = first[0]; k[0] <= last[0]; ++k[0])
            for (k[1] = first[1]; k[1] <= last[1]; ++k[1])
                for (k[2] = first[2]; k[2] <= last[2]; ++k[2])
                    if (k != Multiples{}) add(image_of(p, k));
    }
}

void Halo::insert(std::size_t first, StageProgress& progress) {
    const double* const x = point(static_cast<std::uint32_t>(first));
    const double* const axis[3] = {x, x + 1, x + 2};
    progress.watch(triangulation_->settings(), 0, 1,
                   [&] { triangulation_->insert(point_count() - first, axis, 3); });
}

void Halo::build(const ImageGrid& grid, Buffer<double>&& points, const Buffer<Image>& expected,
                 std::int32_t threads, StageProgress& progress) {
    clear();
    grid_ = &grid;
    points_ = std::move(points);
    own_ = points_.size() / 3;
    // If the box has a memory limit or an allocator of the caller, the triangulation uses them.
    // Otherwise it has its own allocator, whose blocks grow without a copy.
    passes_through_ = allocator_.limit() > 0 || allocator_.allocate_function();
    if (passes_through_)
        triangulation_.emplace(Allocator::allocate_from, Allocator::release_to, &allocator_);
    else
        triangulation_.emplace(nullptr, nullptr, nullptr);
    triangulation_->settings().threads = threads;
    if (own_ == 0) return;
    HaloSearch search(allocator_, grid.lattice().dimensions(), own_);
    add_first_halo();
    for (const Image& image : expected) add(image);
    // Reserves memory for the images of later rounds, which are usually few. Growing later would
    // copy everything.
    triangulation_->reserve(std::min(point_count() + point_count() / 32 + 64, max_points));
    std::size_t first = 0;
    bool is_preliminary = true;
    double done = 0;
    do {
        progress.enter(done, done + 0.8 * (1 - done));
        done += 0.8 * (1 - done);
        if (point_count() > first) insert(first, progress);
        Round round(*this, search, std::size_t{8} << std::min(rounds_, 30u),
                    progress.stop_request());
        const std::size_t known = point_count();
        // If the points do not span space but the infinite set does, the basic images of one point
        // suffice.
        if (triangulation_->dimension() < 3)
            round.add_basic_images(0);
        else if (is_preliminary)
            round.look_at_all();
        else
            round.look_at_stars(first);
        round.find_images();
        is_preliminary =
            triangulation_->dimension() < 3 ? point_count() > known : round.is_preliminary();
        first = known;
        ++rounds_;
    } while (point_count() > first || is_preliminary);
    // An expected image may be the image of a point that equals another one.
    for (Image& image : images_) image.point = vertex_of(image.point);
    known_.reset();
}

}  // namespace mgdt
