// SPDX-License-Identifier: MIT
#include "parts/skeleton.hpp"

#include <algorithm>

#include "platform/random.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// Sets d to direction i of 26, which go from the centre of a cube to its faces, edges and corners.
void direction(std::size_t i, double* d) {
    std::size_t cell = i < 13 ? i : i + 1;
    for (int k = 0; k < 3; ++k, cell /= 3) d[k] = static_cast<double>(cell % 3) - 1;
}

// A quarter of the dot product of d and x. A sum of three large coordinates might overflow.
double along(const double* d, const double* x) {
    return d[0] * (0.25 * x[0]) + d[1] * (0.25 * x[1]) + d[2] * (0.25 * x[2]);
}

}  // namespace

void Skeleton::gather(Collective& all, const Objects<Part>& parts) {
    Buffer<Offer> mine(offers_.allocator());
    mine.resize(all.local_parts());
    for (PartId p = 0; p < all.local_parts(); ++p) {
        const Part& part = parts[p];
        const std::size_t n = part.own_count();
        Offer& offer = mine[p] = Offer{};
        offer.count = n;
        if (n == 0) continue;
        const auto at = [&](std::size_t i) { return part.point(static_cast<std::uint32_t>(i)); };
        for (std::size_t k = 0; k < sample_size; ++k)
            offer.sample[k] =
                at(static_cast<std::size_t>(Random::at(all.first_local() + p, k) % n));
        for (std::size_t k = 0; k < directions; ++k) {
            double d[3];
            direction(k, d);
            std::size_t farthest = 0;
            for (std::size_t i = 1; i < n; ++i)
                if (along(d, at(i).x) > along(d, at(farthest).x)) farthest = i;
            offer.farthest[k] = at(farthest);
        }
    }
    all.gather(mine, offers_);
    find_basis(all, parts);
}

void Skeleton::find_basis(Collective& all, const Objects<Part>& parts) {
    // The lexicographically first and last points, then a point that is not on the line through
    // these two, then a point that is not in the plane of these three.
    struct Found {
        std::uint64_t is_found;
        PartPoint point;
    };
    Buffer<Found> mine(basis_.allocator()), of_all(basis_.allocator());
    mine.resize(all.local_parts());
    basis_.clear();
    const auto is_better = [&](const PartPoint& candidate, const PartPoint& best) {
        if (basis_.size() > 1) return false;
        return basis_.empty() ? precedes(candidate.x, best.x) : precedes(best.x, candidate.x);
    };
    const auto extends = [&](const double* x) {
        switch (basis_.size()) {
            case 0:
                return true;
            case 1:
                return precedes(basis_[0].x, x);
            case 2:
                return !collinear(basis_[0].x, basis_[1].x, x);
            default:
                return orientation(basis_[0].x, basis_[1].x, basis_[2].x, x) != 0;
        }
    };
    while (basis_.size() < 4) {
        for (PartId p = 0; p < all.local_parts(); ++p) {
            const Part& part = parts[p];
            Found& found = mine[p] = Found{};
            for (std::uint32_t i = 0; i < part.own_count(); ++i) {
                const PartPoint& x = part.point(i);
                if (found.is_found == 1 ? !is_better(x, found.point) : !extends(x.x)) continue;
                found = {1, x};
            }
        }
        all.gather(mine, of_all);
        const PartPoint* best = nullptr;
        for (const Found& f : of_all)
            if (f.is_found == 1 && (!best || is_better(f.point, *best))) best = &f.point;
        if (!best) return;
        basis_.push_back(*best);
    }
}

void Skeleton::points_for(PartId part, PartId parts, Buffer<PartPoint>& points) const {
    points.clear();
    for (const PartPoint& p : basis_) points.push_back(p);
    for (std::size_t k = 0; k < directions; ++k) {
        double d[3];
        direction(k, d);
        const PartPoint* farthest = nullptr;
        for (const Offer& o : offers_)
            if (o.count > 0 && (!farthest || along(d, o.farthest[k].x) > along(d, farthest->x)))
                farthest = &o.farthest[k];
        if (farthest) points.push_back(*farthest);
    }
    // Adds a sample from each subtree of parts that branches off the path to this part.
    const auto sample = [&](PartId first, PartId last) {
        for (std::size_t k = 0; k < sample_size; ++k) {
            const Offer& o = offers_[first + k * (last - first) / sample_size];
            if (o.count > 0) points.push_back(o.sample[k]);
        }
    };
    each_division(0, parts, [&](PartId first, PartId middle, PartId last) {
        if (part < first || part >= last) return;
        if (part < middle)
            sample(middle, last);
        else
            sample(first, middle);
    });
}

}  // namespace mgdt
