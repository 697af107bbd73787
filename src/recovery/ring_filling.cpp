// SPDX-License-Identifier: MIT
#include "recovery/ring_filling.hpp"

#include <algorithm>

#include "recovery/flatness.hpp"

namespace mgdt {

// Parts with more than `most` crossings are left out. Only one edge has a negative count: the
// segment itself. A filling that has it crosses nothing else, so no part of that filling is left
// out.
RingFilling::Part RingFilling::best_part(std::size_t i, std::size_t j, const Crossings& crossings,
                                         int most) const {
    Part best = {0, 0, no_index};
    const std::uint32_t a = v_[i], c = v_[j];
    for (std::size_t m = i + 1; m < j; ++m) {
        const Part &one = best_[i * n_ + m], &other = best_[m * n_ + j];
        if (one.middle == no_index || other.middle == no_index) continue;
        const int least = one.crossings + other.crossings;
        if (least > (best.middle != no_index ? best.crossings : most)) continue;
        const std::uint32_t b = v_[m];
        const double *const pa = mesh_.point(a), *const pb = mesh_.point(b),
                            *const pc = mesh_.point(c);
        if (orientation(pa, pb, pc, mesh_.point(q_)) <= 0 ||
            orientation(pa, pb, pc, mesh_.point(p_)) >= 0)
            continue;
        const int count = least + crossings.of_face(a, b, c);
        if (count > most) continue;
        const double flat =
            std::max({one.flatness, other.flatness, flatness_of(pa, pb, pc, mesh_.point(q_)),
                      flatness_of(pa, pb, pc, mesh_.point(p_))});
        if (best.middle == no_index || count < best.crossings ||
            (count == best.crossings && flat < best.flatness))
            best = {count, flat, static_cast<std::uint32_t>(m)};
    }
    return best;
}

// Klincsek's dynamic program (Minimal triangulations of polygonal domains, 1980).
bool RingFilling::find(std::uint32_t p, std::uint32_t q, const std::uint32_t* polygon,
                       std::size_t n, const Crossings& crossings, int most) {
    p_ = p;
    q_ = q;
    v_ = polygon;
    n_ = n;
    best_.clear();
    best_.resize(n * n, {0, 0, no_index});
    for (std::size_t i = 0; i + 1 < n; ++i) best_[i * n + i + 1].middle = 0;
    for (std::size_t length = 2; length < n; ++length)
        for (std::size_t i = 0; i + length < n; ++i) {
            const std::size_t j = i + length;
            Part best = best_part(i, j, crossings, most);
            // The new edge from i to j and the faces at it, unless it closes the polygon.
            if (best.middle != no_index && length + 1 < n)
                best.crossings += crossings.of_edge(v_[i], v_[j]) +
                                  crossings.of_face(v_[i], v_[j], p) +
                                  crossings.of_face(v_[i], v_[j], q);
            if (best.crossings > most) best.middle = no_index;
            best_[i * n + j] = best;
        }
    return best_[n - 1].middle != no_index;
}

void RingFilling::append(Buffer<FlipMesh::Corners>& to) {
    parts_.clear();
    parts_.push_back(static_cast<std::uint32_t>(n_ - 1));
    while (!parts_.empty()) {
        const std::uint32_t part = parts_.back();
        const std::size_t first = part / n_, last = part % n_;
        parts_.resize(parts_.size() - 1);
        if (last < first + 2) continue;
        const std::size_t middle = best_[part].middle;
        const std::uint32_t a = v_[first], b = v_[middle], c = v_[last];
        to.push_back({{a, b, c, q_}});
        to.push_back({{a, c, b, p_}});
        parts_.push_back(static_cast<std::uint32_t>(first * n_ + middle));
        parts_.push_back(static_cast<std::uint32_t>(middle * n_ + last));
    }
}

}  // namespace mgdt
