// SPDX-License-Identifier: MIT
#include "solid/boundary_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/scale.hpp"
#include "mesh/tetrahedron.hpp"
#include "predicates/foot_weights.hpp"
#include "solid/corner_exponent.hpp"

namespace mgdt {
namespace {

Buffer<std::uint32_t> boundary_faces(Allocator& allocator, const SolidMesh& mesh) {
    Buffer<std::uint32_t> faces(allocator);
    for (std::size_t i = 0; i < mesh.neighbors.size(); ++i)
        if (mesh.neighbors[i] == no_index) faces.push_back(static_cast<std::uint32_t>(i));
    return faces;
}

Buffer<BoundingBox> boxes_of(Allocator& allocator, const SolidMesh& mesh, int scale,
                             const Buffer<std::uint32_t>& faces) {
    Buffer<BoundingBox> boxes(allocator, faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        boxes[f] = BoundingBox::empty();
        for (unsigned k = 0; k < 3; ++k) {
            const std::size_t v =
                mesh.tetrahedra[faces[f] / 4 * std::size_t{4} + outer_face[faces[f] % 4][k]];
            double x[3];
            for (std::size_t i = 0; i < 3; ++i) x[i] = std::ldexp(mesh.points[3 * v + i], -scale);
            boxes[f].include(x);
        }
    }
    return boxes;
}

}  // namespace

BoundaryPlaces::BoundaryPlaces(Allocator& allocator, const SolidMesh& mesh, const StopRequest& stop)
    : mesh_(mesh),
      scale_(corner_exponent(mesh)),
      faces_(boundary_faces(allocator, mesh)),
      boxes_(boxes_of(allocator, mesh, scale_, faces_)),
      tree_(allocator, boxes_, stop) {}

const double* BoundaryPlaces::corner(std::uint32_t face, unsigned k) const {
    const std::size_t t = face / 4;
    return mesh_.points.begin() +
           3 * std::size_t{mesh_.tetrahedra[4 * t + outer_face[face % 4][k]]};
}

// Compares distances from a place q. Near the mesh it is |x - q|^2; far from it, where the digits
// of |q|^2 would hide those of x, it is less by |q|^2.
class BoundaryPlaces::Distance {
  public:
    Distance(const double (&place)[3], double largest) : is_far_(largest > far) {
        std::copy_n(place, 3, place_);
    }
    double operator()(const double (&x)[3]) const {
        double sum = 0;
        for (int k = 0; k < 3; ++k) sum += term(x[k], k);
        return sum;
    }
    // A lower bound on the distances of all points of a box.
    double least(const BoundingBox& box) const {
        constexpr double rounding = 0x1p-48;
        double sum = 0, size = 0;
        for (int k = 0; k < 3; ++k) {
            const double t = term(std::clamp(place_[k], box.low[k], box.high[k]), k);
            sum += t;
            size += std::fabs(t);
        }
        return sum - rounding * size;
    }

  private:
    static constexpr double far = 4;  // the largest coordinate of the mesh is at most 1

    double term(double x, int k) const {
        return is_far_ ? x * (x - 2 * place_[k]) : (x - place_[k]) * (x - place_[k]);
    }

    double place_[3];
    bool is_far_;
};

// Replaces the best candidate by the place with these weights if that is nearer.
void BoundaryPlaces::consider(const double* const (&p)[3], const Distance& distance,
                              const double (&w)[3], Candidate& best) const {
    double x[3] = {0, 0, 0};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) x[i] += w[k] * std::ldexp(p[k][i], -scale_);
    const double found = distance(x);
    if (!(found < best.distance)) return;
    best.distance = found;
    std::copy_n(w, 3, best.weights);
}

// The nearest place of a face: the foot of the perpendicular to its plane if that is in the face,
// otherwise the nearest one of an edge.
BoundaryPlaces::Candidate BoundaryPlaces::nearest_of_face(std::uint32_t face, const double* place,
                                                          const Distance& distance) const {
    const double* const p[3] = {corner(face, 0), corner(face, 1), corner(face, 2)};
    Candidate best = {std::numeric_limits<double>::infinity(), {1, 0, 0}};
    double w[3];
    foot_weights(p[0], p[1], p[2], place, w);
    if (w[0] >= 0 && w[1] >= 0 && w[2] >= 0) {
        consider(p, distance, w, best);
        return best;
    }
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        double on_edge[2];
        foot_weights(p[k], p[next], place, on_edge);
        for (double& x : w) x = 0;
        w[k] = std::clamp(on_edge[0], 0.0, 1.0);
        w[next] = std::clamp(on_edge[1], 0.0, 1.0);
        consider(p, distance, w, best);
    }
    return best;
}

BoundaryPlaces::Place BoundaryPlaces::nearest(const double* place) const {
    // From a place that is farther than this the mesh is a point but for its direction.
    constexpr int most_exponent = 500;
    double scaled_place[3], seen[3], largest = 0;
    const int nearer = std::max(0, exponent_above(place, 3) - scale_ - most_exponent);
    for (int i = 0; i < 3; ++i) {
        scaled_place[i] = std::ldexp(place[i], -scale_ - nearer);
        largest = std::max(largest, std::fabs(scaled_place[i]));
        seen[i] = nearer > 0 ? std::ldexp(place[i], -nearer) : place[i];
    }
    const Distance distance(scaled_place, largest);
    Candidate best = {std::numeric_limits<double>::infinity(), {0, 0, 0}};
    std::uint32_t face = no_index;
    tree_.for_each_below(
        best.distance, [&](const BoundingBox& box) { return distance.least(box); },
        [&](std::uint32_t f) {
            const Candidate found = nearest_of_face(faces_[f], seen, distance);
            if (found.distance < best.distance ||
                (found.distance == best.distance && faces_[f] < face)) {
                best = found;
                face = faces_[f];
            }
            return best.distance;
        });
    Place result = {no_index, {0, 0, 0, 0}};
    if (face == no_index) return result;
    result.tetrahedron = face / 4;
    for (unsigned k = 0; k < 3; ++k) result.weights[outer_face[face % 4][k]] = best.weights[k];
    return result;
}

}  // namespace mgdt
