// SPDX-License-Identifier: MIT
#include "boundary/validation.hpp"

#include <algorithm>
#include <functional>

#include "parallel/per_member.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

bool is_flat(const Simplex& s) {
    if (s.size == 3) return collinear(s.x[0], s.x[1], s.x[2]);
    return s.size == 2 && s.number[0] == s.number[1];
}

// Whether two triangles have the same corners.
bool are_equal_triangles(const Simplex& a, const Simplex& b) {
    return a.size == 3 && b.size == 3 && std::is_permutation(a.number, a.number + 3, b.number);
}

}  // namespace

Buffer<OffendingPair> offending_pairs(const Boundary& boundary, Team& team, Allocator& allocator,
                                      StageProgress& progress) {
    const Buffer<BoundingBox> boxes = boxes_of(boundary, 0, team, allocator);
    const std::size_t n = boxes.size();
    constexpr std::size_t simplices_per_thread = 4096;
    Buffer<std::uint8_t> flat(allocator, n);
    team.split(n, simplices_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t i = begin; i < end; ++i) flat[i] = is_flat(boundary.simplex(i)) ? 1 : 0;
    });
    PerMember<Buffer<OffendingPair>> found(team, allocator, std::ref(allocator));
    const BoxTree tree(allocator, boxes, progress.stop_request());
    tree.for_each_pair(team, progress, [&](std::uint32_t i, std::uint32_t j, unsigned member) {
        if ((flat[i] | flat[j]) != 0) return;
        const Simplex a = boundary.simplex(i), b = boundary.simplex(j);
        if (are_equal_triangles(a, b) || !meet_in_common_face(a, b))
            found[member].push_back({i, j});
    });
    Buffer<OffendingPair> pairs(allocator);
    for (std::uint32_t i = 0; i < n; ++i)
        if (flat[i] != 0) pairs.push_back({i, i});
    for (const Buffer<OffendingPair>& of_member : found)
        for (const OffendingPair& pair : of_member) pairs.push_back(pair);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace mgdt
