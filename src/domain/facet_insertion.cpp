// SPDX-License-Identifier: MIT
#include "domain/facet_insertion.hpp"

#include <algorithm>
#include <cassert>

#include "domain/cavity_filling.hpp"

namespace mgdt {
namespace {

class FacetInsertion {
  public:
    FacetInsertion(ConstrainedMesh& mesh, const PlanarFacets& facets,
                   const Buffer<Subsegment>& subsegments, Allocator& allocator,
                   const StopRequest& stop)
        : mesh_(mesh),
          facets_(facets),
          subsegments_(subsegments),
          ends_(allocator),
          first_part_(allocator),
          walk_(mesh, ends_, allocator),
          filling_(mesh, allocator, stop),
          crossed_(allocator),
          component_(allocator),
          is_taken_(allocator) {
        first_part_.resize(facets.segments.size() / 2, 0u);
        for (std::uint32_t i = static_cast<std::uint32_t>(subsegments.size()); i-- > 0;)
            first_part_[subsegments[i].segment] = i;
        for (const Subsegment& s : subsegments) ends_.add(s.ends[0], s.ends[1]);
    }

    void insert(std::uint32_t facet, FacetCounts& counts) {
        const std::uint32_t(&corner)[3] = facets_.facets[facet].corner;
        const Subsegment& first = subsegments_[first_part_[segment(corner[0], corner[1])]];
        walk_.run(corner, first.ends[0], first.ends[1]);
        for (const std::uint32_t face : walk_.faces()) mesh_.mark(face, facet);
        if (walk_.crossed().empty()) return;
        ++counts.missing;
        crossed_.clear();
        for (const std::uint32_t t : walk_.crossed()) crossed_.push_back(t);
        std::sort(crossed_.begin(), crossed_.end());
        is_taken_.clear();
        is_taken_.resize(crossed_.size(), std::uint8_t{0});
        for (std::size_t i = 0; i < crossed_.size(); ++i) {
            if (is_taken_[i] != 0) continue;
            take_component(i);
            std::sort(component_.begin(), component_.end());
            filling_.replace(walk_, facet, component_);
            ++counts.cavities;
            counts.largest_cavity = std::max(counts.largest_cavity, component_.size());
        }
    }

  private:
    // The number of a segment.
    std::uint32_t segment(std::uint32_t a, std::uint32_t b) const {
        if (a > b) std::swap(a, b);
        std::size_t low = 0, high = facets_.segments.size() / 2;
        while (low < high) {
            const std::size_t middle = low + (high - low) / 2;
            const std::uint32_t* const s = facets_.segments.begin() + 2 * middle;
            if (s[0] < a || (s[0] == a && s[1] < b))
                low = middle + 1;
            else
                high = middle;
        }
        return static_cast<std::uint32_t>(low);
    }

    // Collects the crossed tetrahedra that are connected with the one at a position by faces that
    // the facet crosses, and takes them.
    void take_component(std::size_t start) {
        component_.clear();
        const auto take = [&](std::size_t at) {
            is_taken_[at] = 1;
            component_.push_back(crossed_[at]);
        };
        take(start);
        for (std::size_t i = 0; i < component_.size(); ++i) {
            const ConstrainedMesh::Tetrahedron& t = mesh_.tetrahedra[component_[i]];
            for (unsigned face = 0; face < 4; ++face) {
                if (!walk_.crosses(t, face)) continue;
                const std::uint32_t* const found =
                    std::lower_bound(crossed_.begin(), crossed_.end(), t.n[face] / 4);
                const auto at = static_cast<std::size_t>(found - crossed_.begin());
                assert(at < crossed_.size() && *found == t.n[face] / 4 &&
                       "a facet crosses a face and not both tetrahedra");
                if (is_taken_[at] == 0) take(at);
            }
        }
    }

    ConstrainedMesh& mesh_;
    const PlanarFacets& facets_;
    const Buffer<Subsegment>& subsegments_;
    PairTable ends_;
    Buffer<std::uint32_t> first_part_;  // the first subsegment of each segment
    FacetWalk walk_;
    CavityFilling filling_;
    Buffer<std::uint32_t> crossed_, component_;
    Buffer<std::uint8_t> is_taken_;  // for each of crossed_: whether it is in a component already
};

}  // namespace

FacetCounts insert_facets(ConstrainedMesh& mesh, const PlanarFacets& facets,
                          const Buffer<Subsegment>& subsegments, Allocator& allocator,
                          const StopRequest& stop) {
    FacetCounts counts;
    FacetInsertion insertion(mesh, facets, subsegments, allocator, stop);
    for (std::uint32_t f = 0; f < facets.facets.size(); ++f) {
        stop.poll_in_step(f);
        insertion.insert(f, counts);
    }
    return counts;
}

}  // namespace mgdt
