// SPDX-License-Identifier: MIT
#include "refinement/vertex_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mgdt {
namespace {

double length(const RefinedMesh& mesh, VertexId a, VertexId b) noexcept {
    const Vector<double> d = difference<double>(mesh.walled.point(a), mesh.walled.point(b));
    return std::sqrt(dot(d, d));
}

class VertexSizes {
  public:
    VertexSizes(RefinedMesh& mesh, const SolidMesh& solid, double scale)
        : mesh_(mesh), solid_(solid), scale_(scale) {
        mesh_.sizes.clear();
        mesh_.sizes.resize(mesh.walled.mesh.vertices.size(),
                           std::numeric_limits<double>::infinity());
    }

    void add_at_vertices(const SizeWishes& wishes) {
        for (std::size_t p = 0; p < wishes.of_points.size(); ++p)
            lower(mesh_.sizes[solid_.point_origins[p] == no_index ? p + 1
                                                                  : solid_.point_origins[p] + 1],
                  wishes.of_points[p]);
        if (wishes.of_tetrahedra.empty()) return;
        for (std::size_t t = 0; t < solid_.tetrahedron_count(); ++t)
            for (std::size_t k = 4 * t; k < 4 * t + 4; ++k)
                lower(mesh_.sizes[solid_.tetrahedra[k] + 1], wishes.of_tetrahedra[t]);
    }
    void add_at_places(const SizeWishes& wishes, double everywhere) {
        constexpr double none = std::numeric_limits<double>::infinity();
        PlaceSizes& places = mesh_.places;
        places.everywhere = none;
        lower(places.everywhere, everywhere);
        for (double& size : mesh_.sizes) size = std::min(size, places.everywhere);
        places.of_regions.clear();
        if (wishes.of_regions.empty()) return;
        places.of_regions.resize(wishes.of_regions.size(), none);
        for (std::size_t r = 0; r < wishes.of_regions.size(); ++r)
            lower(places.of_regions[r], wishes.of_regions[r]);
        for (std::size_t t = 0; t < solid_.tetrahedron_count(); ++t)
            for (std::size_t k = 4 * t; k < 4 * t + 4; ++k) {
                double& size = mesh_.sizes[solid_.tetrahedra[k] + 1];
                size = std::min(size, places.of_regions[solid_.regions[t]]);
            }
    }
    void add_surface();

  private:
    void lower(double& size, double wish) const noexcept {
        if (wish > 0) size = std::min(size, wish * scale_);
    }

    RefinedMesh& mesh_;
    const SolidMesh& solid_;
    const double scale_;
};

// At each vertex of faces, the mean length of their edges.
void VertexSizes::add_surface() {
    struct Mean {
        double sum;
        std::size_t count;
    };
    Buffer<Mean> means(mesh_.sizes.allocator());
    means.resize(mesh_.sizes.size(), {0, 0});
    for (std::size_t f = 0; f < solid_.face_facets.size(); ++f) {
        if (solid_.face_tetrahedra[2 * f] == no_index &&
            solid_.face_tetrahedra[2 * f + 1] == no_index)
            continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const VertexId a = solid_.faces[3 * f + k] + 1,
                           b = solid_.faces[3 * f + (k + 1) % 3] + 1;
            for (const VertexId v : {a, b}) {
                means[v].sum += length(mesh_, a, b);
                ++means[v].count;
            }
        }
    }
    for (std::size_t v = 0; v < means.size(); ++v)
        if (means[v].count > 0)
            mesh_.sizes[v] =
                std::min(mesh_.sizes[v], means[v].sum / static_cast<double>(means[v].count));
}

// The tetrahedra at each vertex.
class VertexStars {
  public:
    explicit VertexStars(const RefinedMesh& mesh)
        : begin_(mesh.sizes.allocator()), tetrahedra_(mesh.sizes.allocator()) {
        const Mesh& records = mesh.walled.mesh;
        const auto for_each = [&](const auto& f) {
            for (TetId t = 0; t < records.tetrahedra.size(); ++t) {
                const Tetrahedron& tet = records.tetrahedra[t];
                if (!tet.is_dead() && !tet.is_ghost())
                    for (const VertexId v : tet.v) f(t, v);
            }
        };
        begin_.resize(mesh.sizes.size() + 2, 0);
        for_each([&](TetId, VertexId v) { ++begin_[std::size_t{v} + 2]; });
        for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
        tetrahedra_.resize(begin_.back());
        for_each([&](TetId t, VertexId v) { tetrahedra_[begin_[std::size_t{v} + 1]++] = t; });
    }
    const TetId* begin(VertexId v) const noexcept { return tetrahedra_.begin() + begin_[v]; }
    const TetId* end(VertexId v) const noexcept {
        return tetrahedra_.begin() + begin_[std::size_t{v} + 1];
    }

  private:
    Buffer<std::size_t> begin_;
    Buffer<TetId> tetrahedra_;
};

}  // namespace

void set_sizes(RefinedMesh& mesh, const SolidMesh& solid, const SizeWishes& wishes,
               double everywhere, bool are_of_surface, double scale, StageProgress& progress) {
    VertexSizes sizes(mesh, solid, scale);
    sizes.add_at_vertices(wishes);
    if (are_of_surface) sizes.add_surface();
    mesh.interpolated.clear();
    if (are_of_surface || !wishes.of_points.empty() || !wishes.of_tetrahedra.empty()) {
        limit_sizes(mesh, mesh.sizes, 0, progress);
        mesh.interpolated.resize(mesh.sizes.size());
        std::copy(mesh.sizes.begin(), mesh.sizes.end(), mesh.interpolated.begin());
    }
    sizes.add_at_places(wishes, everywhere);
}

void add_sizes_at_vertices(RefinedMesh& mesh, SizeSampler& sampler, StageProgress& progress) {
    constexpr std::size_t most_at_once = 65536;
    Buffer<double> places(mesh.sizes.allocator()), sampled(mesh.sizes.allocator());
    for (std::size_t begin = 1; begin < mesh.sizes.size(); begin += most_at_once) {
        progress.stop_request().poll();
        const std::size_t count = std::min(mesh.sizes.size() - begin, most_at_once);
        places.clear();
        for (std::size_t v = begin; v < begin + count; ++v)
            for (int k = 0; k < 3; ++k)
                places.push_back(mesh.walled.point(static_cast<VertexId>(v))[k]);
        sampled.resize(count);
        sampler.sample(count, places.data(), sampled.data());
        for (std::size_t i = 0; i < count; ++i)
            mesh.sizes[begin + i] = std::min(mesh.sizes[begin + i], sampled[i]);
    }
}

void add_varying_sizes(RefinedMesh& mesh, SizeSampler& sampler, std::size_t most_cells,
                       StageProgress& progress) {
    Buffer<SizeTree::Seed> seeds(mesh.sizes.allocator());
    sampler.list_seeds(seeds);
    const auto sample = [&](std::size_t n, const double* places, double* sizes) {
        sampler.sample(n, places, sizes);
    };
    SizeTree& tree = mesh.places.varying;
    tree.build(mesh.walled.mesh, sample, mesh.gradation, seeds, most_cells, progress);
    for (VertexId v = 1; v < mesh.sizes.size(); ++v)
        mesh.sizes[v] = std::min(mesh.sizes[v], tree.at(mesh.walled.point(v)));
}

// Vertices are passed in ascending order of their sizes (Dijkstra's algorithm).
bool limit_sizes(const RefinedMesh& mesh, Buffer<double>& sizes, double tolerance,
                 StageProgress& progress) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double least = infinity, most = 0;
    for (const double size : sizes) {
        least = std::min(least, size);
        most = std::max(most, size);
    }
    if (!(least < most)) return false;
    const VertexStars stars(mesh);
    struct Entry {
        double size;
        VertexId vertex;
        // The order of a heap whose first element is the least.
        bool operator<(const Entry& other) const noexcept {
            return size != other.size ? size > other.size : vertex > other.vertex;
        }
    };
    Buffer<Entry> heap(sizes.allocator());
    for (VertexId v = 1; v < sizes.size(); ++v)
        if (sizes[v] < infinity) heap.push_back({sizes[v], v});
    std::make_heap(heap.begin(), heap.end());
    bool has_changed = false;
    for (std::size_t i = 0; !heap.empty(); ++i) {
        progress.step(i, 0, 4 * sizes.size());
        std::pop_heap(heap.begin(), heap.end());
        const Entry next = heap.back();
        heap.pop_back();
        if (next.size > sizes[next.vertex]) continue;
        for (const TetId* t = stars.begin(next.vertex); t != stars.end(next.vertex); ++t)
            for (const VertexId v : mesh.walled.mesh.tetrahedra[*t].v) {
                const double bound = next.size + mesh.gradation * length(mesh, next.vertex, v);
                if (!(bound < (1 - tolerance) * sizes[v])) continue;
                sizes[v] = bound;
                has_changed = true;
                heap.push_back({bound, v});
                std::push_heap(heap.begin(), heap.end());
            }
    }
    return has_changed;
}

}  // namespace mgdt
