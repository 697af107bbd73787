// SPDX-License-Identifier: MIT
#include "domain/regions.hpp"

#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

class Flood {
  public:
    Flood(const ConstrainedMesh& mesh, const RoundingGrid& grid, Allocator& allocator)
        : mesh_(mesh), grid_(grid), regions_(allocator), stack_(allocator) {
        regions_.of_tetrahedron.resize(mesh.tetrahedra.size(), unknown);
    }

    Regions run(const Buffer<DomainInput::Place>& regions,
                const Buffer<DomainInput::Place>& holes) {
        for (std::uint32_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
            const ConstrainedMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
            for (unsigned i = 0; i < 4 && !tet.is_dead(); ++i)
                if (tet.n[i] == no_index && tet.facets[i] == no_index) fill(t, Regions::outside);
        }
        for (std::uint32_t t = 0; t < mesh_.tetrahedra.size(); ++t)
            regions_.has_inside = regions_.has_inside || (!mesh_.tetrahedra[t].is_dead() &&
                                                          regions_.of_tetrahedron[t] == unknown);
        for (std::uint32_t i = 0; i < holes.size(); ++i) {
            bool is_used = false;
            for_each_at(holes[i].x, [&](std::uint32_t t) {
                is_used = is_used || regions_.of_tetrahedron[t] == unknown;
            });
            if (!is_used) regions_.unused_holes.push_back(i);
        }
        for (const DomainInput::Place& hole : holes)
            for_each_at(hole.x, [&](std::uint32_t t) { fill(t, Regions::outside); });
        for (std::uint32_t t = 0; t < mesh_.tetrahedra.size(); ++t)
            if (!mesh_.tetrahedra[t].is_dead() && regions_.of_tetrahedron[t] == unknown) {
                fill(t, static_cast<std::uint32_t>(regions_.markers.size()));
                regions_.markers.push_back(0);
            }
        for (std::uint32_t i = 0; i < regions.size(); ++i) {
            bool is_used = false;
            for_each_at(regions[i].x, [&](std::uint32_t t) {
                const std::uint32_t at = regions_.of_tetrahedron[t];
                if (at == Regions::outside) return;
                regions_.markers[at] = regions[i].marker;
                is_used = true;
            });
            if (!is_used) regions_.unused_regions.push_back(i);
        }
        return std::move(regions_);
    }

  private:
    static constexpr std::uint32_t unknown = 0xFFFFFFFEu;

    void fill(std::uint32_t start, std::uint32_t region) {
        const auto enter = [&](std::uint32_t t) {
            if (regions_.of_tetrahedron[t] != unknown) return;
            regions_.of_tetrahedron[t] = region;
            stack_.push_back(t);
        };
        enter(start);
        while (!stack_.empty()) {
            const ConstrainedMesh::Tetrahedron& t = mesh_.tetrahedra[stack_.back()];
            stack_.pop_back();
            for (unsigned i = 0; i < 4; ++i)
                if (t.n[i] != no_index && t.facets[i] == no_index) enter(t.n[i] / 4);
        }
    }

    // Calls f for each tetrahedron whose closure contains a place of the caller.
    template <class F>
    void for_each_at(const double (&place)[3], F f) const {
        double x[3];
        if (!grid_.scale_place(place, x)) return;
        for (std::uint32_t t = 0; t < mesh_.tetrahedra.size(); ++t) {
            const ConstrainedMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
            if (tet.is_dead()) continue;
            bool is_inside = true;
            for (unsigned i = 0; i < 4 && is_inside; ++i) {
                const unsigned char* const v = outer_face[i];
                is_inside = orientation(x, mesh_.point(tet.v[v[0]]), mesh_.point(tet.v[v[1]]),
                                        mesh_.point(tet.v[v[2]])) <= 0;
            }
            if (is_inside) f(t);
        }
    }

    const ConstrainedMesh& mesh_;
    const RoundingGrid& grid_;
    Regions regions_;
    Buffer<std::uint32_t> stack_;
};

}  // namespace

Regions find_regions(const ConstrainedMesh& mesh, const RoundingGrid& grid,
                     const Buffer<DomainInput::Place>& regions,
                     const Buffer<DomainInput::Place>& holes, Allocator& allocator) {
    return Flood(mesh, grid, allocator).run(regions, holes);
}

}  // namespace mgdt
