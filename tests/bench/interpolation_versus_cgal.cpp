// SPDX-License-Identifier: MIT
// Times values between points, mgdt and CGAL side by side: natural-neighbour weights, which CGAL
// has, and mgdt's other methods and gradients, in microseconds of processor time per place.
//
//   interpolation_versus_cgal [points [places [runs [distribution...]]]]
//
// Places are between two points drawn at random, so that they crowd where the points do and are in
// no order. mgdt has them as they are, as weights; CGAL sorts them along a curve, and each starts
// where the one before ended. "apart" is the largest difference of a weight among those that CGAL
// finds, "fails" the number of places where it finds none.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_with_circumcenter_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/natural_neighbor_coordinates_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/point_sets/distributions.hpp"
#include "measure.hpp"
#include "mgdt/mgdt.h"

namespace {

using bench::median;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Base = CGAL::Triangulation_vertex_base_with_info_3<std::int64_t, Kernel>;
// It keeps circumcentres once it has them.
using Cell = CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<Kernel>;
using Cgal =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Base, Cell>>;
using Weights = std::vector<std::pair<Cgal::Vertex_handle, double>>;

void require(mgdt_status status) {
    if (status != MGDT_OK) throw std::runtime_error(mgdt_status_string(status));
}

std::vector<double> places_among(const std::vector<double>& points, std::size_t n) {
    std::mt19937_64 random(1);
    std::uniform_int_distribution<std::size_t> one_of(0, points.size() / 3 - 1);
    std::vector<double> places;
    while (places.size() < 3 * n) {
        const double* const a = points.data() + 3 * one_of(random);
        const double* const b = points.data() + 3 * one_of(random);
        for (unsigned k = 0; k < 3; ++k) places.push_back(0.75 * a[k] + 0.25 * b[k]);
    }
    return places;
}

struct Rows {
    std::vector<std::int64_t> offsets, points;
    std::vector<double> weights;
};

class Mgdt {
  public:
    Mgdt(const std::vector<double>& points, const std::vector<double>& places)
        : places_(places), n_(static_cast<std::int64_t>(places.size() / 3)) {
        mgdt_triangulation* t = nullptr;
        require(mgdt_create(&t));
        t_.reset(t);
        require(mgdt_insert_points(t, static_cast<std::int64_t>(points.size() / 3), points.data()));
        values_.resize(points.size() / 3);
        for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = points[3 * i];
        out_.resize(places.size() / 3);
        gradients_.resize(points.size());
        rows_.offsets.resize(places.size() / 3 + 1);
    }
    double interpolate(std::int32_t method) {
        return 1e6 / static_cast<double>(n_) * bench::processor_seconds([&] {
                   require(mgdt_interpolate(t_.get(), method, MGDT_OUTSIDE_NONE, 1, values_.data(),
                                            n_, places_.data(), out_.data()));
               });
    }
    double gradients() {
        return 1e6 / static_cast<double>(values_.size()) * bench::processor_seconds([&] {
                   require(mgdt_get_gradients(t_.get(), 1, values_.data(), gradients_.data()));
               });
    }
    const Rows& weights(std::int32_t method) {
        const auto size = static_cast<std::int64_t>(rows_.offsets.size());
        const auto get = [&](std::int64_t capacity, std::int64_t* points, double* weights) {
            require(mgdt_get_interpolation_weights(t_.get(), method, MGDT_OUTSIDE_NONE, n_,
                                                   places_.data(), size, rows_.offsets.data(),
                                                   capacity, points, weights));
        };
        get(0, nullptr, nullptr);
        rows_.points.resize(static_cast<std::size_t>(rows_.offsets.back()));
        rows_.weights.resize(rows_.points.size());
        get(rows_.offsets.back(), rows_.points.data(), rows_.weights.data());
        return rows_;
    }

  private:
    struct Destroy {
        void operator()(mgdt_triangulation* t) const noexcept { mgdt_destroy(t); }
    };
    const std::vector<double>& places_;
    std::int64_t n_;
    std::unique_ptr<mgdt_triangulation, Destroy> t_;
    std::vector<double> values_, out_, gradients_;
    Rows rows_;
};

// CGAL's weights of every place, in a visitor's hands.
template <class Coordinates, class Visit>
void cgal_weights(const Cgal& t, const std::vector<double>& places, Coordinates coordinates,
                  const Visit& visit) {
    std::vector<Kernel::Point_3> q;
    for (std::size_t i = 0; i < places.size(); i += 3)
        q.emplace_back(places[i], places[i + 1], places[i + 2]);
    std::vector<std::size_t> order(q.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto map = CGAL::make_property_map(q);
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_3<Kernel, decltype(map)>(map));
    Weights weights;
    Cgal::Cell_handle start;
    for (const std::size_t i : order) {
        weights.clear();
        double norm = 0;
        start = t.locate(q[i], start);
        const bool is_good = coordinates(t, q[i], std::back_inserter(weights), norm, start).third;
        visit(i, is_good, weights, norm);
    }
}

constexpr auto sibson = [](const Cgal& t, const Kernel::Point_3& q, auto out, double& norm,
                           Cgal::Cell_handle start) {
    return CGAL::sibson_natural_neighbor_coordinates_3(t, q, out, norm, start);
};
constexpr auto laplace = [](const Cgal& t, const Kernel::Point_3& q, auto out, double& norm,
                            Cgal::Cell_handle start) {
    return CGAL::laplace_natural_neighbor_coordinates_3(t, q, out, norm, start);
};

template <class Coordinates>
double time_cgal(const Cgal& t, const std::vector<double>& places, Coordinates coordinates) {
    double sum = 0;
    const double time = bench::processor_seconds([&] {
        cgal_weights(t, places, coordinates,
                     [&](std::size_t, bool is_good, const Weights& weights, double norm) {
                         if (!is_good) return;
                         for (const auto& [v, w] : weights) sum += w / norm * v->point().x();
                     });
    });
    if (!std::isfinite(sum)) std::printf("(CGAL gives weights that are no numbers)\n");
    return 1e6 * time / static_cast<double>(places.size() / 3);
}

template <class Coordinates>
void compare(const char* name, const Cgal& t, const std::vector<double>& places,
             Coordinates coordinates, const Rows& rows) {
    double apart = 0;
    std::size_t fails = 0;
    cgal_weights(
        t, places, coordinates,
        [&](std::size_t i, bool is_good, const Weights& weights, double norm) {
            if (!is_good) {
                ++fails;
                return;
            }
            std::vector<std::pair<std::int64_t, double>> all;
            for (auto k = static_cast<std::size_t>(rows.offsets[i]);
                 k < static_cast<std::size_t>(rows.offsets[i + 1]); ++k)
                all.emplace_back(rows.points[k], rows.weights[k]);
            for (const auto& [v, w] : weights) all.emplace_back(v->info(), -w / norm);
            std::sort(all.begin(), all.end());
            for (std::size_t k = 0; k < all.size(); ++k) {
                const bool is_pair = k + 1 < all.size() && all[k].first == all[k + 1].first;
                const double difference = all[k].second + (is_pair ? all[k + 1].second : 0);
                apart = std::max(apart, std::fabs(difference));
                k += is_pair;
            }
        });
    std::printf("  %s: %.1e apart, %zu fails\n", name, apart, fails);
}

void run(const std::string& name, std::size_t n, std::size_t n_places, int runs) {
    const std::vector<double> points = mgdt::cli::generate(name, n, {});
    const std::vector<double> places = places_among(points, n_places);
    Mgdt mgdt(points, places);
    std::vector<std::pair<Cgal::Point, std::int64_t>> named;
    for (std::size_t i = 0; i < points.size() / 3; ++i)
        named.emplace_back(Cgal::Point(points[3 * i], points[3 * i + 1], points[3 * i + 2]),
                           static_cast<std::int64_t>(i));
    const Cgal cgal(named.begin(), named.end());

    const std::vector<std::pair<const char*, std::int32_t>> methods = {
        {"linear", MGDT_INTERPOLATE_LINEAR},
        {"nearest", MGDT_INTERPOLATE_NEAREST},
        {"Sibson", MGDT_INTERPOLATE_SIBSON},
        {"Laplace", MGDT_INTERPOLATE_LAPLACE},
        {"C1", MGDT_INTERPOLATE_SIBSON_C1}};
    std::vector<std::vector<double>> times(methods.size());
    std::vector<double> gradients, of_sibson, of_laplace;
    for (int k = 0; k < runs; ++k) {
        for (std::size_t m = 0; m < methods.size(); ++m)
            times[m].push_back(mgdt.interpolate(methods[m].second));
        gradients.push_back(mgdt.gradients());
        of_sibson.push_back(time_cgal(cgal, places, sibson));
        of_laplace.push_back(time_cgal(cgal, places, laplace));
    }
    std::printf("%-10s", name.c_str());
    for (const auto& t : times) std::printf(" %8.2f", median(t));
    std::printf(" %9.2f | %8.1f %8.1f | %6.1f %7.1f\n", median(gradients), median(of_sibson),
                median(of_laplace), median(of_sibson) / median(times[2]),
                median(of_laplace) / median(times[3]));
    compare("Sibson", cgal, places, sibson, mgdt.weights(MGDT_INTERPOLATE_SIBSON));
    compare("Laplace", cgal, places, laplace, mgdt.weights(MGDT_INTERPOLATE_LAPLACE));
}

}  // namespace

int main(int argc, char** argv) {
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    const auto count = [&](int i, std::size_t otherwise) {
        return argc > i ? static_cast<std::size_t>(std::strtod(argv[i], nullptr)) : otherwise;
    };
    const std::size_t n = count(1, 100000), places = count(2, 100000);
    const int runs = static_cast<int>(count(3, 3));
    std::vector<std::string> names(argv + std::min(argc, 4), argv + argc);
    if (names.empty()) names = {"uniform", "line", "cluster", "mixsphere"};
    std::printf("%zu points, %zu places, %d runs: microseconds of processor time\n", n, places,
                runs);
    std::printf("%-10s %8s %8s %8s %8s %8s %9s | %8s %8s | %6s %7s\n", "", "linear", "nearest",
                "Sibson", "Laplace", "C1", "gradients", "Sibson", "Laplace", "Sibson", "Laplace");
    for (const std::string& name : names) run(name, n, places, runs);
    std::printf("gradients a point; after the first bar CGAL, after the second CGAL / mgdt\n");
    return 0;
}
