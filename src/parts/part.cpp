// SPDX-License-Identifier: MIT
#include "parts/part.hpp"

#include <algorithm>

#include "kernel/circumsphere.hpp"
#include "mesh/scale.hpp"
#include "platform/take_out_repeats.hpp"

namespace mgdt {
namespace {

// A word for a part and a point that the part needs: the part is in the upper half of the word, the
// point in the lower half. Sorted words have the order of the records of a Mail.
constexpr std::uint64_t wants(PartId part, std::uint32_t point) {
    return std::uint64_t{part} << 32 | point;
}

// The least number of words at which repeated words are removed.
constexpr std::size_t many_wishes = std::size_t{1} << 16;

// Whether the ball is within the box of the part. Such a ball contains no points of other parts.
bool is_within(const Sphere& s, const double* base, const double* low, const double* high) {
    double square = 0, to_side = infinity;
    for (int k = 0; k < 3; ++k) {
        const double half = 0.5 * s.w[k], center = base[k] + half,
                     slack = s.e + 0x1p-45 * (std::fabs(base[k]) + std::fabs(half));
        const double size = std::fabs(half) + s.e;
        square += size * size;
        to_side = std::min({to_side, center - low[k] - slack, high[k] - center - slack});
    }
    return to_side > 0 && to_side * to_side > square * (1 + 0x1p-40);
}

}  // namespace

void Part::begin(PartId self, std::int64_t first, const PartPoint* own, std::size_t n) {
    self_ = self;
    own_ = n;
    points_.clear();
    points_.resize(n);
    std::copy(own, own + n, points_.data());
    for (std::size_t i = 0; i < n; ++i) {
        points_[i].number = first + static_cast<std::int64_t>(i);
        box_.include(own[i].x);
    }
}

void Part::insert(const PartPoint* points, std::size_t n, StageProgress& progress, std::size_t i,
                  std::size_t shares) {
    // A part without own points has no tetrahedra to contribute, so it needs no other points.
    if (own_ == 0) return;
    const std::size_t first = points_.size(), known = known_.size();
    for (const PartPoint* p = points; p != points + n; ++p)
        if (!std::binary_search(known_.begin(), known_.begin() + known, p->number))
            points_.push_back(*p);
    take_out_repeats(points_, first);
    for (std::size_t k = first; k < points_.size(); ++k) known_.push_back(points_[k].number);
    std::sort(known_.begin(),
              known_.end());  // std::inplace_merge would allocate outside the allocator
    const std::size_t begin = triangulation_->point_map().size();
    static_assert(sizeof(PartPoint) == 5 * sizeof(double));
    if (begin == points_.size()) return;
    const double* const x = points_[begin].x;
    const double* const axis[3] = {x, x + 1, x + 2};
    progress.watch(triangulation_->settings(), i, shares,
                   [&] { triangulation_->insert(points_.size() - begin, axis, 5); });
}

std::uint32_t Part::least_of(const std::uint32_t (&v)[4]) const {
    std::uint32_t least = v[0];
    for (int i = 1; i < 4; ++i)
        if (precedes(points_[v[i]].x, points_[least].x)) least = v[i];
    return least;
}

template <class Visit, class VisitGhost>
void Part::each_at_border(const Visit& visit, const VisitGhost& visit_ghost) const {
    const Mesh& mesh = triangulation_->mesh();
    const bool has_spheres = mesh.tetrahedra.has_spheres();
    double low[3], high[3];
    for (int k = 0; k < 3; ++k) {
        low[k] = scaled(box_.low[k], mesh.scale);
        high[k] = scaled(box_.high[k], mesh.scale);
    }
    for (TetId t = 0; own_ > 0 && t < mesh.tetrahedra.size(); ++t) {
        const Tetrahedron& tetrahedron = mesh.tetrahedra[t];
        if (tetrahedron.is_dead()) continue;
        const bool is_ghost = tetrahedron.is_ghost();
        Sphere s{};
        if (!is_ghost) {
            s = has_spheres ? mesh.tetrahedra.sphere(t).in_doubles()
                            : circumsphere(tetrahedron, mesh.vertices.data());
            if (is_within(s, mesh.point(tetrahedron.v[0]), low, high)) continue;
        }
        OwnVertices own{{}, 0};
        for (const VertexId v : tetrahedron.v)
            if (v != infinite_vertex && mesh.vertices[v].index < own_)
                own.index[own.count++] = mesh.vertices[v].index;
        if (own.count == 0) continue;
        if (is_ghost)
            visit_ghost(t, own);
        else
            visit(t, own, s);
    }
}

void Part::push(const Boxes& boxes, PartId parts, Mail& out) {
    const Mesh& mesh = triangulation_->mesh();
    Buffer<std::uint64_t> wishes(allocator_);
    std::size_t limit = many_wishes;
    const auto send = [&](PartId part, const OwnVertices& own) {
        if (part == self_) return;
        for (unsigned i = 0; i < own.count; ++i) wishes.push_back(wants(part, own.index[i]));
        if (wishes.size() < limit) return;
        take_out_repeats(wishes);
        limit = std::max(many_wishes, 2 * wishes.size());
    };
    each_at_border(
        [&](TetId t, const OwnVertices& own, const Sphere& s) {
            const Tetrahedron& tetrahedron = mesh.tetrahedra[t];
            boxes.each_in_ball(s, mesh.point(tetrahedron.v[0]), mesh.scale,
                               [&](PartId part) { send(part, own); });
        },
        [&](TetId t, const OwnVertices& own) {
            const Tetrahedron& ghost = mesh.tetrahedra[t];
            const auto slot = static_cast<unsigned>(ghost.infinite_slot());
            const Tetrahedron& inner = mesh.tetrahedra[tetrahedron_of(ghost.n[slot])];
            const auto corner = [&](VertexId v) { return point(mesh.vertices[v].index).x; };
            boxes.each_beyond(
                corner(ghost.v[outer_face[slot][0]]), corner(ghost.v[outer_face[slot][1]]),
                corner(ghost.v[outer_face[slot][2]]), corner(inner.v[face_of(ghost.n[slot])]),
                [&](PartId part) { send(part, own); });
        });
    take_out_repeats(wishes);
    out.begin.resize(std::size_t{parts} + 1);
    out.bytes.resize(wishes.size() * sizeof(PartPoint));
    std::size_t at = 0;
    for (PartId part = 0; part <= parts; ++part) {
        while (at < wishes.size() && wishes[at] < wants(part, 0)) ++at;
        out.begin[part] = at;
    }
    for (std::size_t i = 0; i < wishes.size(); ++i)
        out.records<PartPoint>()[i] = points_[wishes[i] & 0xFFFFFFFFu];
}

}  // namespace mgdt
