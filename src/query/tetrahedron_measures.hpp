// SPDX-License-Identifier: MIT
// Volume, shape and size of tetrahedra, for all finite doubles and every tetrahedron, however flat.
#pragma once

#include "platform/stage_progress.hpp"
#include "query/mesh_view.hpp"

namespace mgdt {

enum class TetrahedronMeasure {
    volume,
    radius_ratio,
    volume_length,
    least_dihedral_angle,
    largest_dihedral_angle,
    longest_edge,
    edge_ratio
};

// Upper bound on the relative error of a measure, unless it is rounded to a subnormal number, and
// on the error of an angle. docs/theory.md, "Measures of tetrahedra", has the proof.
constexpr double tetrahedron_measure_error = 1e-12;

// A measure of the tetrahedron whose vertices are p times 2^-scale. The order of the vertices does
// not change the result.
double measure_tetrahedron(const double* const (&p)[4], int scale, TetrahedronMeasure measure,
                           Allocator& allocator);

// Writes a measure of each tetrahedron.
void export_tetrahedron_measures(const MeshView& view, TetrahedronMeasure measure,
                                 StageProgress& progress, double* x);

namespace exact {

// Computes in doubles. Returns false if the tetrahedron is so flat that the error may exceed the
// bound: if its volume is below `flatness`/6 times the cube of its longest edge.
constexpr double least_volume_in_doubles = 0x1p-5;
constexpr double least_volume_for_volumes = 0x1p-9;
bool measure_in_doubles(const double* const (&p)[4], int scale, TetrahedronMeasure measure,
                        double& x, double flatness);

}  // namespace exact
}  // namespace mgdt
