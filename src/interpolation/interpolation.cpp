// SPDX-License-Identifier: MIT
#include "interpolation/interpolation.hpp"

#include <algorithm>
#include <functional>
#include <limits>

#include "mesh/scale.hpp"
#include "parallel/per_member.hpp"
#include "platform/error.hpp"

namespace mgdt {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The scalar product of a displacement and a gradient or direction. Only large gradients have lower
// parts; for others, doubles suffice.
double product(const Vector<Twofold>& way, const Twofold* g) {
    if (g[0].low == 0 && g[1].low == 0 && g[2].low == 0)
        return (way.x[0].high * g[0].high + way.x[1].high * g[1].high) + way.x[2].high * g[2].high;
    return ((way.x[0] * g[0] + way.x[1] * g[1]) + way.x[2] * g[2]).high;
}

// Gradients at vertices, in units of the mesh's scale.
class GradientsOf {
  public:
    GradientsOf(const Locator& where, const Values& values, Allocator& allocator)
        : where_(where), values_(values), stencil_(allocator) {}
    // Writes three numbers for each field.
    void write(VertexId v, Twofold* out) {
        const Mesh& mesh = where_.mesh;
        stencil_.find(where_, v);
        std::fill_n(out, 3 * values_.fields, Twofold{0, 0});
        const double* const here = values_.of(mesh.vertices[v].index);
        for (std::size_t j = 0; j < stencil_.size(); ++j) {
            const double* const there = values_.of(mesh.vertices[stencil_.neighbor(j)].index);
            const Vector<Twofold>& direction = stencil_.direction(j);
            for (std::size_t f = 0; f < values_.fields; ++f) {
                const double rise = (there[f] - here[f]) / stencil_.distance(j);
                for (int k = 0; k < 3; ++k) {
                    Twofold& to = out[3 * f + static_cast<std::size_t>(k)];
                    if (stencil_.is_thin())
                        to = to + Twofold{rise, 0} * direction.x[k];
                    else
                        to.high += rise * direction.x[k].high;
                }
            }
        }
    }

  private:
    const Locator where_;
    const Values values_;
    Gradient stencil_;
};

constexpr std::size_t vertices_per_thread = 1024;

// Calls write(vertex, worker, scratch) for each vertex. The worker can write the gradients of the
// vertex, for which `scratch` has room.
template <class Write>
void for_each_gradient(const MeshView& view, const Locator& where, const Values& values,
                       StageProgress& progress, Write write) {
    PerMember<GradientsOf> workers(view.team, view.allocator, where, values,
                                   std::ref(view.allocator));
    view.team.split(view.mesh.vertices.size() - 1, vertices_per_thread,
                    [&](std::size_t begin, std::size_t end, unsigned m) {
                        Buffer<Twofold> scratch(view.allocator);
                        scratch.resize(3 * values.fields);
                        for (std::size_t v = begin; v < end; ++v) {
                            progress.step(v, begin, end, m);
                            write(static_cast<VertexId>(v + 1), workers[m], scratch.data());
                        }
                    });
}

// Evaluates the rows of places to values; each thread has its own evaluator.
class Evaluator {
  public:
    // If `gradients` is empty, gradients are computed as they are needed.
    Evaluator(const Locator& where, Allocator& allocator, const Manner& manner,
              const Values& values, const Buffer<Twofold>& gradients)
        : mesh_(where.mesh),
          values_(values),
          gradients_(gradients),
          interpolator_(where, allocator, manner.method, manner.outside),
          gradients_of_(where, values, allocator),
          gradient_(allocator) {}

    void write(const double* q, TetId t, TetId near, double* out) {
        const PlaceRow& row = interpolator_.row(q, t, near);
        std::fill_n(out, values_.fields, row.weights.empty() ? nan : 0.0);
        for (const PlaceRow::Weight& w : row.weights) {
            const double* const value = values_.of(mesh_.vertices[w.vertex].index);
            for (std::size_t f = 0; f < values_.fields; ++f) out[f] += w.weight * value[f];
        }
        for (const PlaceRow::Slope& s : row.slopes) {
            const Twofold* const g = gradient(s.vertex);
            for (std::size_t f = 0; f < values_.fields; ++f)
                out[f] += s.factor * product(s.way, g + 3 * f);
        }
    }

  private:
    const Twofold* gradient(VertexId v) {
        const std::size_t width = 3 * values_.fields;
        if (!gradients_.empty()) return gradients_.data() + width * v;
        gradient_.clear();
        gradient_.resize(width);
        gradients_of_.write(v, gradient_.data());
        return gradient_.data();
    }

    const Mesh& mesh_;
    const Values values_;
    const Buffer<Twofold>& gradients_;
    Interpolator interpolator_;
    GradientsOf gradients_of_;
    Buffer<Twofold> gradient_;
};

// Collects rows of weights, where points have the caller's indices. The weights that come from
// gradients are added to the weights of values.
class RowWriter {
  public:
    struct Entry {
        std::uint32_t point;
        double weight;
    };
    RowWriter(const Locator& where, Allocator& allocator, const Manner& manner)
        : entries(allocator),
          where_(where),
          interpolator_(where, allocator, manner.method, manner.outside),
          gradient_(allocator) {}

    // Adds the row of a place to `entries`.
    void add(const double* q, TetId t, TetId near) {
        const Buffer<Vertex>& vertices = where_.mesh.vertices;
        const PlaceRow& row = interpolator_.row(q, t, near);
        const std::size_t begin = entries.size();
        for (const PlaceRow::Weight& w : row.weights)
            entries.push_back({vertices[w.vertex].index, w.weight});
        if (row.slopes.empty()) return;
        for (const PlaceRow::Slope& s : row.slopes) {
            gradient_.find(where_, s.vertex);
            double sum = 0;
            for (std::size_t j = 0; j < gradient_.size(); ++j) {
                const double weight =
                    s.factor * (product(s.way, gradient_.direction(j).x) / gradient_.distance(j));
                sum += weight;
                entries.push_back({vertices[gradient_.neighbor(j)].index, weight});
            }
            entries.push_back({vertices[s.vertex].index, -sum});
        }
        merge(begin);
    }
    void clear() noexcept { entries.clear(); }

    Buffer<Entry> entries;

  private:
    // Merges the entries of the row that starts at `begin`, so that each point has one entry.
    void merge(std::size_t begin) {
        std::stable_sort(entries.begin() + begin, entries.end(),
                         [](const Entry& a, const Entry& b) { return a.point < b.point; });
        std::size_t kept = begin;
        for (std::size_t i = begin + 1; i < entries.size(); ++i)
            if (entries[i].point == entries[kept].point)
                entries[kept].weight += entries[i].weight;
            else
                entries[++kept] = entries[i];
        entries.resize(kept + 1);
    }

    const Locator where_;
    Interpolator interpolator_;
    Gradient gradient_;
};

}  // namespace

void interpolate(const MeshView& view, const Locator& where, Manner manner, const Values& values,
                 const PointSet& places, StageProgress& progress, double* out) {
    Buffer<Twofold> gradients(view.allocator);
    // A place needs the gradients of about sixteen vertices. With 1/8 as many places as vertices,
    // each gradient is needed twice on average, so all gradients are computed in advance.
    if (manner.method == Method::sibson_c1 && places.size >= view.mesh.vertices.size() / 8) {
        const std::size_t width = 3 * values.fields;
        gradients.resize(width * view.mesh.vertices.size());
        StageProgress of_gradients = progress.within(0, 0.5);
        for_each_gradient(view, where, values, of_gradients,
                          [&](VertexId v, GradientsOf& worker, Twofold*) {
                              worker.write(v, gradients.data() + width * v);
                          });
        progress.leave_behind(0.5);
    }
    PerMember<Evaluator> workers(view.team, view.allocator, where, std::ref(view.allocator), manner,
                                 values, std::ref(gradients));
    const double* const xyz = places.axis[0];
    locate_each(view, where, places, manner.outside == Outside::none, progress, [&](unsigned m) {
        return [&, m](std::size_t i, TetId t, TetId near) {
            workers[m].write(xyz + 3 * i, t, near, out + values.fields * i);
        };
    });
}

template <class Int>
std::size_t interpolation_weights(const MeshView& view, const Locator& where, Manner manner,
                                  const PointSet& places, const StageProgress& progress,
                                  const WeightRows<Int>& rows) {
    struct Row {
        std::size_t begin;
        std::uint32_t size, member;
    };
    // Rows are computed in the order of a space-filling curve and written in the order of the
    // places, in blocks of at most this many places.
    constexpr std::size_t most = std::size_t{1} << 17;
    PerMember<RowWriter> workers(view.team, view.allocator, where, std::ref(view.allocator),
                                 manner);
    Buffer<Row> found(view.allocator, std::min(most, places.size));
    const auto base = static_cast<std::size_t>(view.base);
    std::size_t total = 0;
    rows.offsets[0] = static_cast<Int>(base);
    for (std::size_t begin = 0; begin < places.size; begin += most) {
        PointSet block = places;
        block.size = std::min(most, places.size - begin);
        for (const double*& axis : block.axis) axis += 3 * begin;
        for (unsigned m = 0; m < view.team.size(); ++m) workers[m].clear();
        const StageProgress of_block =
            progress.within_items(begin, begin + block.size, places.size);
        locate_each(view, where, block, manner.outside == Outside::none, of_block, [&](unsigned m) {
            return [&, m](std::size_t i, TetId t, TetId near) {
                RowWriter& writer = workers[m];
                const std::size_t first = writer.entries.size();
                writer.add(block.axis[0] + 3 * i, t, near);
                found[i] = {first, static_cast<std::uint32_t>(writer.entries.size() - first), m};
            };
        });
        const std::size_t before = total;
        for (std::size_t i = 0; i < block.size; ++i) {
            total += found[i].size;
            if (total + base > static_cast<std::uint64_t>(std::numeric_limits<Int>::max()))
                fail(MGDT_ERR_INDEX_RANGE, "there are too many weights for a 32-bit offset");
            rows.offsets[begin + i + 1] = static_cast<Int>(total + base);
        }
        if (total > rows.capacity) continue;
        view.team.split(
            block.size, places_per_thread, [&](std::size_t first, std::size_t last, unsigned) {
                std::size_t to = first == 0
                                     ? before
                                     : static_cast<std::size_t>(rows.offsets[begin + first]) - base;
                for (std::size_t i = first; i < last; ++i)
                    for (std::uint32_t k = 0; k < found[i].size; ++k, ++to) {
                        const RowWriter::Entry& e =
                            workers[found[i].member].entries[found[i].begin + k];
                        rows.points[to] = static_cast<Int>(e.point + base);
                        rows.weights[to] = e.weight;
                    }
            });
    }
    return total;
}
template std::size_t interpolation_weights(const MeshView&, const Locator&, Manner, const PointSet&,
                                           const StageProgress&, const WeightRows<std::int64_t>&);
template std::size_t interpolation_weights(const MeshView&, const Locator&, Manner, const PointSet&,
                                           const StageProgress&, const WeightRows<std::int32_t>&);

void gradients(const MeshView& view, const Locator& where, const Buffer<VertexId>& point_map,
               const Values& values, StageProgress& progress, double* out) {
    const Mesh& mesh = view.mesh;
    const std::size_t width = 3 * values.fields;
    for_each_gradient(view, where, values, progress,
                      [&](VertexId v, GradientsOf& worker, Twofold* scratch) {
                          worker.write(v, scratch);
                          double* const to = out + width * mesh.vertices[v].index;
                          for (std::size_t i = 0; i < width; ++i)
                              to[i] = scaled(scratch[i].high, mesh.scale);
                      });
    constexpr std::size_t points_per_thread = 65536;
    view.team.split(point_map.size(), points_per_thread,
                    [&](std::size_t begin, std::size_t end, unsigned) {
                        for (std::size_t p = begin; p < end; ++p) {
                            const VertexId v = point_map[p];
                            double* const to = out + width * p;
                            if (v == infinite_vertex)
                                std::fill_n(to, width, nan);
                            else if (mesh.vertices[v].index != p)
                                std::copy_n(out + width * mesh.vertices[v].index, width, to);
                        }
                    });
}

}  // namespace mgdt
