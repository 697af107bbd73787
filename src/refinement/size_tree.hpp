// SPDX-License-Identifier: MIT
// Sizes that vary in space, sampled at the corners of an octree.
#pragma once

#include "mesh/mesh.hpp"
#include "platform/function_ref.hpp"
#include "platform/number_table.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

// Cells that touch no tetrahedron of the mesh have no sizes. The other ones are divided until their
// edges are at most twice the least size at their corners, and shorter where the size is not linear
// (docs/theory/refining.md, "Sizes that vary in space").
class SizeTree {
  public:
    // Writes the sizes at n places, three coordinates each; infinity means none.
    using Sample = FunctionRef<void(std::size_t n, const double* places, double* sizes)>;
    // A place where a size is known: cells are divided there, too.
    struct Seed {
        double x[3];
        double size;
    };

    explicit SizeTree(Allocator& allocator)
        : cells_(allocator), corners_(allocator), numbers_(allocator), touching_(allocator) {}

    // Makes a tree of at most about `most_cells` cells around the tetrahedra of the mesh. Sizes are
    // lowered until none exceeds another one by more than the gradation times their distance.
    // Removes the seeds whose cells are small enough.
    void build(const Mesh& mesh, Sample sample, double gradation, Buffer<Seed>& seeds,
               std::size_t most_cells, StageProgress& progress);

    bool empty() const noexcept { return cells_.empty(); }
    std::size_t cell_count() const noexcept { return cells_.size(); }
    // The size at a place in the mesh, or infinity.
    double at(const double* x) const noexcept;
    // Roughly, how many points a mesh with these sizes has.
    double wanted_points() const noexcept;

  private:
    static constexpr unsigned deepest = 19, first_level = 4;
    static constexpr std::uint32_t root_edge = std::uint32_t{2} << deepest;

    struct Corner {
        std::uint64_t key;
        double size;
    };
    // Coordinates are whole numbers of the shortest edge's halves.
    struct Cell {
        std::uint32_t x[3], edge;
        std::uint32_t child = 0;   // the first of eight, or 0 for a leaf
        std::uint32_t begin, end;  // of the tetrahedra that may touch it
        std::uint32_t corners[8];  // no_index for a cell that touches none
        std::uint32_t centre;

        bool is_leaf() const noexcept { return child == 0 && begin != end; }
    };

    double length(const Cell& cell) const noexcept { return cell.edge * unit_; }
    std::uint32_t corner(std::uint32_t x, std::uint32_t y, std::uint32_t z);
    void add_cell(const std::uint32_t (&x)[3], std::uint32_t edge);
    bool touches(const Mesh& mesh, const Cell& cell, TetId t) const noexcept;
    void divide(const Mesh& mesh, std::uint32_t i);
    void sample_new(Sample sample, StageProgress& progress);
    bool is_coarse(const Cell& cell) const noexcept;
    std::size_t divide_at_seeds(const Mesh& mesh, Buffer<Seed>& seeds, std::size_t most_cells);
    bool limit(Cell& cell, double gradation) noexcept;
    void limit_all(double gradation, StageProgress& progress);
    std::uint32_t leaf_at(const double* x) const noexcept;

    double origin_[3], unit_ = 0;
    Buffer<Cell> cells_;
    Buffer<Corner> corners_;
    NumberTable numbers_;  // of corners
    Buffer<TetId> touching_;
    std::size_t sampled_ = 0;
    double far_ = 0;  // a size that stands for none
};

}  // namespace mgdt
