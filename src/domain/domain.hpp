// SPDX-License-Identifier: MIT
// A domain: its boundary as the caller gives it, and the mesh of its inside. A build makes a
// complex of distinct points (complex.cpp), refuses what crosses (validation.cpp), rounds the
// points to a grid (rounding_grid.cpp), joins triangles in one plane (planar_facets.cpp), divides
// the segments until all are edges of the Delaunay triangulation (segment_splitting.cpp), puts the
// facets into a copy of it (facet_insertion.cpp), and keeps what is inside (regions.cpp).
#pragma once

#include <optional>

#include "boundary/boundary_edges.hpp"
#include "boundary/complex.hpp"
#include "boundary/validation.hpp"
#include "cleaning/cleaning.hpp"
#include "domain/attempts.hpp"
#include "domain/mesh_assembly.hpp"
#include "platform/stage_progress.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

struct DomainSettings : CallSettings, CleaningDistances {
    bool rounds_points = false;
    bool keeps_boundary = false;       // every triangle of a facet is to be one face
    bool is_strict = false;            // refuses a mesh that leaves out what was set
    bool takes_open_surfaces = false;  // so that tests may have facets that enclose nothing
};

// What cleaning has done since the caller has set facets.
struct CleaningRecord {
    explicit CleaningRecord(Allocator& allocator) : covered(allocator) {}

    Buffer<CoveredFacet> covered;  // by the numbers of the caller's facets
    CleaningCounts counts;         // of the last time
};

// A pair of facets, segments or points of the caller that meet elsewhere than in a common corner or
// edge. An item that is invalid by itself is paired with itself.
struct Offence {
    enum Kind : std::uint32_t { facet, segment, point };
    struct Item {
        Kind kind;
        std::uint32_t index;
        friend bool operator<(const Item& a, const Item& b) {
            return a.kind != b.kind ? a.kind < b.kind : a.index < b.index;
        }
        friend bool operator==(const Item& a, const Item& b) {
            return a.kind == b.kind && a.index == b.index;
        }
    };
    Item first, second;
    friend bool operator<(const Offence& a, const Offence& b) {
        return a.first == b.first ? a.second < b.second : a.first < b.first;
    }
    friend bool operator==(const Offence& a, const Offence& b) {
        return a.first == b.first && a.second == b.second;
    }
};

class Domain {
  public:
    Domain(mgdt_alloc_fn alloc, mgdt_free_fn release, void* user)
        : allocator_(alloc, release, user),
          input_(allocator_),
          offences_(allocator_),
          open_edges_(allocator_),
          cleaned_(allocator_) {}

    // Setting points removes facets and segments. A change of points, facets or segments removes
    // the offences, the open edges and the record of cleaning.
    void set_points(Buffer<double>&& points) noexcept;
    void set_facets(Buffer<std::uint32_t>&& begin, Buffer<std::uint32_t>&& corners,
                    Buffer<std::int32_t>&& markers) noexcept;
    void set_segments(Buffer<std::uint32_t>&& ends, Buffer<std::int32_t>&& markers) noexcept;
    void set_regions(Buffer<DomainInput::Place>&& places) noexcept {
        input_.regions = std::move(places);
    }
    void set_holes(Buffer<DomainInput::Place>&& places) noexcept {
        input_.holes = std::move(places);
    }

    // Finds all offences. Throws MGDT_ERR_INVALID_BOUNDARY if there are any.
    void validate();
    // Cleans facets and segments (cleaning.hpp). If the call throws, nothing has changed.
    void clean();
    // Validates the boundary, and makes the mesh. If the call throws, the mesh is empty:
    // MGDT_ERR_OPEN_BOUNDARY if the facets enclose nothing, other Errors and std::bad_alloc.
    void build(SolidMesh& mesh);
    // Throws MGDT_ERR_CHECK_FAILED if the mesh is not one of the domain.
    void check(const SolidMesh& mesh, StageProgress& progress) const;
    // Removes everything but the settings.
    void clear() noexcept;
    StopFlag& stop() const noexcept { return stop_; }

    Allocator& allocator() const noexcept { return allocator_; }
    DomainSettings& settings() noexcept { return settings_; }
    const DomainSettings& settings() const noexcept { return settings_; }
    DomainInput& input() noexcept { return input_; }
    const DomainInput& input() const noexcept { return input_; }
    const Buffer<Offence>& offences() const noexcept { return offences_; }
    const Buffer<OpenEdge>& open_edges() const noexcept { return open_edges_; }
    const CleaningRecord& cleaned() const noexcept { return cleaned_; }

  private:
    // The number that the caller has for an index: it counts from the index base.
    long long number(std::uint32_t index) const noexcept {
        return static_cast<long long>(index) + settings_.index_base;
    }
    void forget_results() noexcept;
    void forget_cleaning() noexcept { cleaned_ = CleaningRecord(allocator_); }
    void run(StageProgress& progress, SolidMesh& mesh);
    void require_valid(const Complex& complex, mgdt_status otherwise, const char* where,
                       StageProgress& progress);
    [[noreturn]] void fail_open() const;
    void require_all_used(const SolidMesh& mesh) const;
    bool round(const RoundingGrid& grid, Complex& complex);
    void require_valid_on(const RoundingGrid& grid, const Complex& complex,
                          StageProgress& progress);
    // A segment that could not be divided as finely as necessary, or not in the time given.
    struct StuckSegment {
        std::uint32_t ends[2];
        bool takes_long;
        std::size_t steiner_points;  // how many there were then
    };
    using Stuck = std::optional<StuckSegment>;
    Stuck keep(const Complex& complex, StageProgress& progress, SolidMesh& mesh);
    bool make_with_fewest(Complex complex, StageProgress& progress, SolidMesh& mesh);
    bool make_delaunay(Complex complex, std::size_t most_points, StageProgress& progress,
                       SolidMesh& mesh);
    void finish(const DomainParts& parts, SolidMesh& mesh);
    Stuck mesh_on(const Attempt& attempt, Complex complex, StageProgress& progress,
                  SolidMesh& mesh);

    mutable Allocator allocator_;
    DomainSettings settings_;
    DomainInput input_;
    Buffer<Offence> offences_;
    Buffer<OpenEdge> open_edges_;
    CleaningRecord cleaned_;
    mutable StopFlag stop_;
};

}  // namespace mgdt
