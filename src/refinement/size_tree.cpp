// SPDX-License-Identifier: MIT
#include "refinement/size_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/bounding_box.hpp"
#include "platform/hash.hpp"
#include "predicates/vector.hpp"

namespace mgdt {
namespace {

constexpr double no_size = std::numeric_limits<double>::infinity();

}  // namespace

std::uint32_t SizeTree::corner(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    constexpr unsigned bits = 21;
    const std::uint64_t key = std::uint64_t{x} << (2 * bits) | std::uint64_t{y} << bits | z;
    numbers_.reserve(corners_.size() + 1);
    corners_.grow(corners_.size() + 1);
    const std::uint32_t number = numbers_.number(
        hash_of_words(key), [&](std::uint32_t i) { return corners_[i].key == key; });
    if (number == corners_.size()) corners_.push_back({key, far_});
    return number;
}

// Adds a cell; its tetrahedra are those at the end of the list from cells_.back().begin on.
void SizeTree::add_cell(const std::uint32_t (&x)[3], std::uint32_t edge) {
    Cell& cell = cells_.back();
    std::copy_n(x, 3, cell.x);
    cell.edge = edge;
    cell.end = static_cast<std::uint32_t>(touching_.size());
    std::fill_n(cell.corners, 8, no_index);
    cell.centre = no_index;
    if (cell.begin == cell.end) return;
    for (std::uint32_t i = 0; i < 8; ++i)
        cell.corners[i] =
            corner(x[0] + (i & 1) * edge, x[1] + (i >> 1 & 1) * edge, x[2] + (i >> 2) * edge);
    cell.centre = corner(x[0] + edge / 2, x[1] + edge / 2, x[2] + edge / 2);
}

// Whether a tetrahedron touches a cell, as far as its faces and those of the cell tell.
bool SizeTree::touches(const Mesh& mesh, const Cell& cell, TetId t) const noexcept {
    constexpr double margin = 1e-9;
    const VertexId(&v)[4] = mesh.tetrahedra[t].v;
    const double half = 0.5 * length(cell) * (1 + margin);
    double centre[3];
    BoundingBox box;
    for (int k = 0; k < 3; ++k) {
        centre[k] = origin_[k] + (cell.x[k] + 0.5 * cell.edge) * unit_;
        box.low[k] = centre[k] - half;
        box.high[k] = centre[k] + half;
    }
    if (box.has_beside(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3])))
        return false;
    for (unsigned i = 0; i < 4; ++i) {
        const double* const a = mesh.point(v[outer_face[i][0]]);
        const Vector<double> normal = cross(difference<double>(mesh.point(v[outer_face[i][1]]), a),
                                            difference<double>(mesh.point(v[outer_face[i][2]]), a));
        const double reach =
            half * (std::fabs(normal.x[0]) + std::fabs(normal.x[1]) + std::fabs(normal.x[2]));
        // The normal points into the tetrahedron.
        const double height = dot(normal, difference<double>(mesh.point(v[i]), a));
        const double to_centre = dot(normal, difference<double>(centre, a));
        if ((height > 0 ? to_centre : -to_centre) < -reach) return false;
    }
    return true;
}

void SizeTree::divide(const Mesh& mesh, std::uint32_t i) {
    const auto first = static_cast<std::uint32_t>(cells_.size());
    cells_.grow(cells_.size() + 8);
    for (std::uint32_t k = 0; k < 8; ++k) {
        const std::uint32_t half = cells_[i].edge / 2;
        cells_.push_back(Cell());
        Cell& cell = cells_.back();
        const Cell& parent = cells_[i];
        const std::uint32_t x[3] = {parent.x[0] + (k & 1) * half, parent.x[1] + (k >> 1 & 1) * half,
                                    parent.x[2] + (k >> 2) * half};
        cell.begin = static_cast<std::uint32_t>(touching_.size());
        std::copy_n(x, 3, cell.x);
        cell.edge = half;
        for (std::uint32_t at = parent.begin; at < parent.end; ++at)
            if (const TetId t = touching_[at]; touches(mesh, cell, t)) touching_.push_back(t);
        add_cell(x, half);
    }
    cells_[i].child = first;
}

void SizeTree::sample_new(Sample sample, StageProgress& progress) {
    constexpr std::size_t most_at_once = 65536;
    constexpr std::uint64_t mask = (std::uint64_t{1} << 21) - 1;
    Buffer<double> places(corners_.allocator()), sizes(corners_.allocator());
    while (sampled_ < corners_.size()) {
        progress.stop_request().poll();
        const std::size_t count = std::min(corners_.size() - sampled_, most_at_once);
        places.clear();
        for (std::size_t i = sampled_; i < sampled_ + count; ++i) {
            const std::uint64_t key = corners_[i].key;
            const std::uint64_t units[3] = {key >> 42, key >> 21 & mask, key & mask};
            for (int k = 0; k < 3; ++k)
                places.push_back(origin_[k] + static_cast<double>(units[k]) * unit_);
        }
        sizes.resize(count);
        sample(count, places.data(), sizes.data());
        for (std::size_t i = 0; i < count; ++i)
            corners_[sampled_ + i].size = std::min(sizes[i], far_);
        sampled_ += count;
    }
}

// Whether a leaf is to be divided.
bool SizeTree::is_coarse(const Cell& cell) const noexcept {
    constexpr double most_edge = 2, most_at_change = 0.5, change = 0.1;
    if (cell.edge <= 2) return false;
    if (cell.edge > root_edge >> first_level) return true;
    const double centre = corners_[cell.centre].size, edge = length(cell);
    double least = centre, sum = 0;
    for (const std::uint32_t i : cell.corners) {
        least = std::min(least, corners_[i].size);
        sum += corners_[i].size;
    }
    return edge > most_edge * least ||
           (edge > most_at_change * least && std::fabs(centre - sum / 8) > change * centre);
}

// Forgets seeds whose cells are small enough.
std::size_t SizeTree::divide_at_seeds(const Mesh& mesh, Buffer<Seed>& seeds,
                                      std::size_t most_cells) {
    std::size_t divided = 0, left = 0;
    for (std::size_t s = 0; s < seeds.size(); ++s) {
        const Seed seed = seeds[s];
        const std::uint32_t i = leaf_at(seed.x);
        if (i == no_index || !(length(cells_[i]) > 2 * seed.size) || cells_[i].edge <= 2) continue;
        seeds[left++] = seed;
        if (cells_.size() >= most_cells) continue;
        divide(mesh, i);
        ++divided;
    }
    seeds.resize(left);
    return divided;
}

// Lowers sizes at the corners of a leaf. Returns whether one has changed.
bool SizeTree::limit(Cell& cell, double gradation) noexcept {
    constexpr double tolerance = 1e-3;
    const double edge = length(cell);
    const double change[4] = {0, gradation * edge, gradation * edge * std::sqrt(2.0),
                              gradation * edge * std::sqrt(3.0)};
    double least = no_size, most = 0;
    for (const std::uint32_t i : cell.corners) {
        least = std::min(least, corners_[i].size);
        most = std::max(most, corners_[i].size);
    }
    double& centre = corners_[cell.centre].size;
    least = std::min(least, centre);
    most = std::max(most, centre);
    if (!(most > least + 0.5 * change[3])) return false;
    bool has_changed = false;
    const auto lower = [&](double& size, double bound) {
        if (!(bound < (1 - tolerance) * size)) return;
        size = bound;
        has_changed = true;
    };
    for (unsigned i = 0; i < 8; ++i) {
        double& size = corners_[cell.corners[i]].size;
        lower(size, centre + 0.5 * change[3]);
        lower(centre, size + 0.5 * change[3]);
        for (unsigned j = 0; j < 8; ++j) {
            const unsigned axes = i ^ j;
            lower(size, corners_[cell.corners[j]].size +
                            change[(axes & 1) + (axes >> 1 & 1) + (axes >> 2)]);
        }
    }
    return has_changed;
}

// Passes over the leaves, to and fro, until no size changes any more.
void SizeTree::limit_all(double gradation, StageProgress& progress) {
    constexpr int most_passes = 100;
    for (int pass = 0; pass < most_passes; ++pass) {
        bool has_changed = false;
        for (std::size_t k = 0; k < cells_.size(); ++k) {
            if (k % 4096 == 0) progress.stop_request().poll();
            Cell& cell = cells_[pass % 2 == 0 ? k : cells_.size() - 1 - k];
            if (cell.is_leaf()) has_changed |= limit(cell, gradation);
        }
        if (!has_changed) return;
    }
}

void SizeTree::build(const Mesh& mesh, Sample sample, double gradation, Buffer<Seed>& seeds,
                     std::size_t most_cells, StageProgress& progress) {
    cells_.clear();
    corners_.clear();
    numbers_.clear(0);
    touching_.clear();
    sampled_ = 0;
    BoundingBox box = BoundingBox::empty();
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
        const Tetrahedron& tet = mesh.tetrahedra[t];
        if (tet.is_dead() || tet.is_ghost()) continue;
        touching_.push_back(t);
        for (const VertexId v : tet.v) box.include(mesh.point(v));
    }
    if (touching_.empty()) return;
    double edge = 0;
    for (int k = 0; k < 3; ++k) edge = std::max(edge, box.high[k] - box.low[k]);
    // Tetrahedra are inside of the root, whatever rounding does.
    constexpr double margin = 0x1p-20;
    for (int k = 0; k < 3; ++k) origin_[k] = box.low[k] - margin * edge;
    edge *= 1 + 2 * margin;
    unit_ = edge / root_edge;
    far_ = 1024 * edge;
    cells_.push_back(Cell());
    cells_.back().begin = 0;
    add_cell({0, 0, 0}, root_edge);
    for (unsigned round = 0;; ++round) {
        // There are at most 20 levels. Sizes that are lowered may take a few more rounds.
        constexpr unsigned rounds = 24;
        progress.look(std::min(round, rounds), rounds, 0);
        sample_new(sample, progress);
        limit_all(gradation, progress);
        std::size_t divided = 0;
        const std::size_t count = cells_.size();
        for (std::uint32_t i = 0; i < count && cells_.size() < most_cells; ++i) {
            if (!cells_[i].is_leaf() || !is_coarse(cells_[i])) continue;
            divide(mesh, i);
            ++divided;
        }
        divided += divide_at_seeds(mesh, seeds, most_cells);
        if (divided == 0) break;
    }
}

// The leaf that contains a place, or no_index if it touches no tetrahedron.
std::uint32_t SizeTree::leaf_at(const double* x) const noexcept {
    std::uint32_t units[3];
    for (int k = 0; k < 3; ++k) {
        const double place = (x[k] - origin_[k]) / unit_;
        if (!(place >= 0 && place <= root_edge)) return no_index;
        units[k] = std::min(static_cast<std::uint32_t>(place), root_edge - 1);
    }
    std::uint32_t i = 0;
    for (std::uint32_t half = root_edge / 2; cells_[i].child != 0; half /= 2)
        i = cells_[i].child + ((units[0] & half) != 0 ? 1u : 0u) +
            ((units[1] & half) != 0 ? 2u : 0u) + ((units[2] & half) != 0 ? 4u : 0u);
    return cells_[i].begin != cells_[i].end ? i : no_index;
}

double SizeTree::at(const double* x) const noexcept {
    const std::uint32_t leaf = leaf_at(x);
    if (leaf == no_index) return no_size;
    const Cell& cell = cells_[leaf];
    double part[3];
    for (int k = 0; k < 3; ++k) {
        part[k] = ((x[k] - origin_[k]) / unit_ - cell.x[k]) / cell.edge;
        part[k] = std::min(std::max(part[k], 0.0), 1.0);
    }
    const auto size = [&](unsigned i) { return corners_[cell.corners[i]].size; };
    const auto along = [&](double s, double a, double b) { return a + s * (b - a); };
    const double low = along(part[1], along(part[0], size(0), size(1)),
                             along(part[0], size(2), size(3))),
                 high = along(part[1], along(part[0], size(4), size(5)),
                              along(part[0], size(6), size(7)));
    const double result = along(part[2], low, high);
    return result < 0.5 * far_ ? result : no_size;
}

double SizeTree::wanted_points() const noexcept {
    constexpr double points_in_cube = 1.6;
    double wanted = 0;
    for (const Cell& cell : cells_) {
        if (!cell.is_leaf()) continue;
        const double ratio = length(cell) / corners_[cell.centre].size;
        wanted += points_in_cube * ratio * ratio * ratio;
    }
    return wanted;
}

}  // namespace mgdt
