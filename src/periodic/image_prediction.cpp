// SPDX-License-Identifier: MIT
#include "periodic/image_prediction.hpp"

#include "periodic/point_tree.hpp"

namespace mgdt {
namespace {

// With fewer points, the halo takes few rounds in any case.
constexpr std::size_t least_points = 4000;
constexpr std::size_t most_in_group = 16;

void push(Buffer<double>& points, const double* x) {
    for (unsigned c = 0; c < 3; ++c) points.push_back(x[c]);
}

// Whether the points of a small sample need more images than points that fill the box evenly.
bool need_many_images(const ImageGrid& grid, const Buffer<double>& points,
                      StageProgress& progress) {
    Allocator& allocator = points.allocator();
    const std::size_t n = points.size() / 3, count = std::min<std::size_t>(n / 16, 4096);
    Buffer<double> probe(allocator);
    for (std::size_t i = 0; i < count; ++i) push(probe, points.begin() + 3 * (i * n / count));
    Halo halo(allocator);
    halo.build(grid, std::move(probe), Buffer<Image>(allocator), 1, progress);
    Buffer<Halo::UsedImage> used(allocator);
    halo.list_used_images(used);
    // The stars of evenly spaced points need images at up to 1.2 times the distance of neighbouring
    // points.
    constexpr double share = 1.2 / Halo::first_width;
    double even = 1;
    for (unsigned k = 0; k < grid.lattice().dimensions(); ++k)
        even *= 1 + 2 * share * halo.shell(k);
    return static_cast<double>(used.size()) > 1.3 * (even - 1) * static_cast<double>(count);
}

}  // namespace

void predict_images(const ImageGrid& grid, const Buffer<double>& points, std::int32_t threads,
                    StageProgress& progress, Buffer<Image>& expected) {
    Allocator& allocator = points.allocator();
    const auto n = static_cast<std::uint32_t>(points.size() / 3);
    StageProgress quiet = progress.quiet();
    if (n < least_points || !need_many_images(grid, points, quiet)) return;
    // The sample has one point from each group of near points.
    PointTree tree(allocator, most_in_group);
    for (std::uint32_t p = 0; p < n; ++p) tree.push(p, points.begin() + 3 * std::size_t{p});
    tree.make(progress.stop_request());
    Buffer<double> sample(allocator);
    tree.each_leaf([&](std::uint32_t begin, std::uint32_t end) {
        push(sample, points.begin() + 3 * std::size_t{tree.number(begin + (end - begin) / 2)});
    });
    const std::size_t groups = sample.size() / 3;
    Buffer<Image> of_sample(allocator);
    predict_images(grid, sample, threads, quiet, of_sample);
    Halo halo(allocator);
    halo.build(grid, std::move(sample), of_sample, threads, quiet);
    Buffer<Halo::UsedImage> used(allocator);
    halo.list_used_images(used);
    Buffer<std::uint32_t> begin_of(allocator);
    begin_of.resize(groups + 1, 0u);
    for (const Halo::UsedImage& u : used) ++begin_of[u.image.point + std::size_t{1}];
    for (std::size_t g = 0; g < groups; ++g) begin_of[g + 1] += begin_of[g];
    Buffer<Multiples> multiples(allocator);
    multiples.resize(used.size());
    for (const Halo::UsedImage& u : used)
        multiples[begin_of[u.image.point]++] = u.image.multiples();
    // Each point of a group will need about the images that its point in the sample needs.
    std::size_t group = 0, from = 0;
    tree.each_leaf([&](std::uint32_t begin, std::uint32_t end) {
        for (std::size_t k = from; k < begin_of[group]; ++k)
            for (std::uint32_t i = begin; i < end; ++i)
                expected.push_back(image_of(tree.number(i), multiples[k]));
        from = begin_of[group++];
    });
}

}  // namespace mgdt
