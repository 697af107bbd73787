// SPDX-License-Identifier: MIT
// The triangulation of points that are spread over parts. Each part has a triangulation of its own.
// The tetrahedra are those of one triangulation of all points, for every number of parts.
#pragma once

#include <functional>

#include "parts/collective.hpp"
#include "parts/part.hpp"
#include "parts/part_tetrahedra.hpp"
#include "platform/objects.hpp"

namespace mgdt {

class Parts {
  public:
    Parts(Collective& collective, mgdt_alloc_fn alloc, mgdt_free_fn release, void* user);
    // Sets the number of threads of each triangulation.
    void set_threads(std::int32_t threads);

    // Collective. The caller calls this function once, inside Collective::run(). Takes the points
    // of each local part, with finite coordinates, and their ids. Throws if different points have
    // the same id. If `ids` is null, the ids are consecutive numbers through all parts.
    void build(const GivenPoints* given, const std::int64_t* const* ids, StageProgress& progress);
    // Like build(), but with one triangulation in memory at a time. Calls visit(i) for each part i
    // while the triangulation of part i exists. At that time the owned tetrahedra have numbers,
    // the other tetrahedra have none. All parts must be local.
    using Visit = std::function<void(PartId)>;
    void build_each(const GivenPoints* given, const std::int64_t* const* ids,
                    StageProgress& progress, const Visit& visit);
    // Collective. Checks the triangulation, and throws MGDT_ERR_CHECK_FAILED if it is not valid
    // (parts/check.cpp).
    void check(std::int32_t level, StageProgress& progress);

    const Part& local(PartId i) const { return parts_[i]; }
    const Homes& homes() const { return homes_; }
    const PartTetrahedra& tetrahedra(PartId i) const { return tetrahedra_[i]; }
    // The number of the vertex of each point that was inserted into a local part.
    const Buffer<std::int64_t>& vertices_of_given(PartId i) const { return vertices_of_given_[i]; }
    // The vertices of part p have the numbers first_vertex(p) to first_vertex(p + 1) - 1.
    std::int64_t first_vertex(PartId p) const { return first_vertex_[p]; }
    const Buffer<std::int64_t>& first_vertices() const { return first_vertex_; }
    // Like first_vertices(), for the tetrahedra that the parts own.
    const Buffer<std::int64_t>& first_tetrahedra() const { return first_tetrahedron_; }
    // The memory that all local parts hold.
    std::size_t bytes() const;

  private:
    void settle(const GivenPoints* given, const std::int64_t* const* ids, StageProgress& progress);
    // Triangulates the own points of each local part with the skeleton. `received` gets the points
    // that the local parts need from other parts.
    void exchange(StageProgress& progress, bool one_at_a_time, Objects<Mail>& received);
    void gather_boxes();

    Allocator allocator_;
    Collective& collective_;
    Homes homes_;
    Boxes boxes_;
    Objects<Part> parts_;  // the local parts
    Objects<PartTetrahedra> tetrahedra_;
    Objects<Buffer<std::int64_t>> vertices_of_given_;
    Buffer<std::int64_t> first_vertex_, first_tetrahedron_;
};

}  // namespace mgdt
