// SPDX-License-Identifier: MIT
// Every routine of the kernel's islands, behind pointers, so that those of one are compared with
// those of another. A new island is written against what its table makes of these tests.
#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "kernel/thread_state.hpp"
#include "kernel/workspace.hpp"

namespace islands {

// What FourPowers gives.
struct Powers {
    double value[4], error[4];
    std::uint32_t negative, decided, ghosts, above;
    unsigned least_finite;
};

// What above() and least_finite() are asked.
struct Asked {
    double value, error, bound;
};

struct Island {
    const char* name;
    bool (*runs)();  // on this processor
    void (*powers)(const mgdt::Mesh& mesh, const mgdt::FacetCode* codes, const double* q,
                   const Asked& asked, Powers& out);
    // Of spheres that are not kept.
    void (*powers_computed)(const mgdt::Mesh& mesh, const mgdt::FacetCode* codes, const double* q,
                            const Asked& asked, Powers& out);
    // The spheres of the star in a workspace, whose facets are in w.small or in w.a, w.b and w.c.
    // The small star's link writes its facet to n[0] of each tetrahedron.
    void (*spheres_small)(mgdt::Workspace& w, const mgdt::Vertex* vertices, mgdt::VertexId q,
                          std::uint32_t count, std::uint32_t infinite,
                          mgdt::TetrahedronStore& store);
    void (*spheres)(mgdt::Workspace& w, const mgdt::Vertex* vertices, mgdt::VertexId q,
                    std::uint32_t count, std::uint32_t infinite, mgdt::TetrahedronStore& store);
    int (*perturbed_doubles)(const mgdt::Tetrahedron& t, const mgdt::Vertex* vertices,
                             const double* q);
    // A stage of it, for any integers whose determinant is below 2^63; nullptr where there is none.
    int (*decided_modulo)(const mgdt::Tetrahedron& t, const mgdt::Vertex* vertices,
                          const double* q);
    // Arguments as in kernel/cavity_marks.hpp and kernel/words.hpp.
    std::uint32_t (*put_four)(const mgdt::MarkTable::View& marks, const mgdt::FacetCode* codes,
                              std::uint32_t which);
    std::uint32_t (*mark_four)(const mgdt::FourTetrahedra<mgdt::TetrahedronAndSphere>& four,
                               std::uint32_t which);
    unsigned (*append)(std::uint32_t* to, const std::uint32_t* words, std::uint32_t bits);
    const mgdt::VertexId* (*write_vertices)(const mgdt::Tetrahedron& outside, mgdt::FacetCode code,
                                            mgdt::VertexId q, mgdt::Tetrahedron& out);
};

void PrintTo(const Island& island, std::ostream* out);

Island scalar();
Island avx2();
Island avx512();
Island neon();

int decided_modulo(const mgdt::Tetrahedron& t, const mgdt::Vertex* vertices, const double* q);

// The scalar island first, and those that the library has besides, also where they do not run.
std::vector<Island> all();

}  // namespace islands
