// SPDX-License-Identifier: MIT
// A program that calls every function of the C++ interface once, and needs no RTTI. Compiled by
// headers_test.py with each compiler and standard; results are the other tests' part.
#include <cmath>
#include <mgdt/mgdt.hpp>
#include <new>
#include <vector>

namespace {

struct Heap {
    void* allocate(std::size_t size, std::size_t align) {
        return ::operator new(size, std::align_val_t(align));
    }
    void deallocate(void* p, std::size_t, std::size_t align) {
        ::operator delete(p, std::align_val_t(align));
    }
};

template <class Int>
std::size_t exports(const mgdt::Triangulation& t, const std::vector<mgdt::Point>& points) {
    auto tetrahedra = t.tetrahedra<Int>();
    auto neighbors = t.neighbors<Int>();
    auto facets = t.hull_facets<Int>();
    auto edges = t.edges<Int>();
    auto map = t.point_map<Int>();
    auto around = t.vertex_tetrahedra<Int>();
    auto linked = t.vertex_neighbors<Int>();
    auto gabriel = t.gabriel_edges<Int>();
    auto tree = t.spanning_tree<Int>();
    t.vertex_neighbors(linked.offsets, linked.list);
    auto located = t.locate_with_weights<Int>(points);
    auto found = t.locate_points<Int>(points);
    t.tetrahedra(tetrahedra);
    t.neighbors(neighbors);
    t.hull_facets(facets);
    t.edges(edges);
    t.point_map(map);
    t.vertex_tetrahedra(around.offsets, around.list);
    auto nearest = t.nearest_vertices<Int>(points);
    t.nearest_vertices(points, nearest);
    t.locate_points(points, found);
    t.locate_points(points, found, located.weights);
    return tetrahedra.size() + neighbors.size() + facets.size() + edges.size() + map.size() +
           around[0].size() + linked[0].size() + gabriel.size() + tree.size() + found.size() +
           nearest.size();
}

// Whether parts do what they are asked.
bool calls_parts(const std::vector<mgdt::Point>& points) {
    Heap heap;
    mgdt::Parts parts(2, heap), one(1);
    parts.set_option(mgdt::PartsOption::index_base, 0);
    parts.set_progress([](double fraction) { return fraction > 2; });
    parts.insert(points, 0);
    std::size_t shown = 0;
    parts.build_each([&](const mgdt::Parts& p, std::int32_t part) {
        shown += p.rows(mgdt::PartsArray::corners, part).size();
    });
    parts.build();
    parts.check();
    parts.clear_progress();
    if (shown == 0 || parts.option(mgdt::PartsOption::index_base) != 0) return false;
    if (parts.number(mgdt::PartsNumber::points, 0) != static_cast<std::int64_t>(points.size()))
        return false;
    if (parts.array(mgdt::PartsArray::point_map, 0).size() != points.size()) return false;
    if (!parts || parts.coordinates(1).empty() || !parts.handle() || !parts.last_error().empty())
        return false;
    one.insert(points, std::vector<std::int64_t>(points.size(), 7));
    one.cancel();
    one.clear();
    swap(one, parts);
    mgdt::Parts again(one.release());
    one = std::move(again);
    return one.number(mgdt::PartsNumber::parts, 0) == 2;
}

// Whether a diagram does what it is asked.
bool calls_voronoi(const std::vector<mgdt::Point>& points) {
    mgdt::Triangulation t;
    t.insert(points);
    mgdt::Voronoi whole(t);
    mgdt::Voronoi cut(
        t, {{1, 0, 0, 9}, {-1, 0, 0, 9}, {0, 1, 0, 9}, {0, -1, 0, 9}, {0, 0, 1, 9}, {0, 0, -1, 9}});
    const auto sides = cut.array(mgdt::VoronoiArray::face_sides);
    const auto narrow = cut.array<std::int32_t>(mgdt::VoronoiArray::face_sides);
    const auto areas = cut.doubles(mgdt::VoronoiDoubles::face_areas);
    if (sides.size() != 2 * areas.size() || narrow.size() != sides.size()) return false;
    if (cut.points(mgdt::VoronoiDoubles::face_normals).size() != areas.size()) return false;
    if (whole.size(mgdt::VoronoiArray::ray_vertices) == 0) return false;
    if (whole.size(mgdt::VoronoiDoubles::cell_volumes) != points.size()) return false;
    cut.drop_small_faces(1e9);
    if (cut.size(mgdt::VoronoiDoubles::face_areas) != 0 || !cut.last_error().empty()) return false;
    swap(whole, cut);
    mgdt::Voronoi again(whole.release());
    return !whole && again && again.handle() != nullptr;
}

// Whether a mesh of two tetrahedra does what it is asked.
bool calls_mesh() {
    const std::vector<mgdt::Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    mgdt::Mesh mesh;
    int heard = 0;
    mesh.set_progress([&](double) { ++heard; });
    mesh.set_points(points);
    mesh.set_tetrahedra(std::vector<std::int64_t>{0, 1, 2, 3, 1, 2, 3, 4},
                        std::vector<std::int32_t>{5, 6});
    mesh.set_faces(std::vector<std::int64_t>{1, 2, 3}, std::vector<std::int32_t>{7});
    mesh.set_edges(std::vector<std::int64_t>{1, 2});
    mesh.set_fixed_points(std::vector<std::int64_t>{4});
    mesh.build();
    mesh.check();
    mesh.set_option(mgdt::MeshOption::goal, 60);
    mesh.set_option(mgdt::MeshOption::boundary, MGDT_BOUNDARY_SLIDE);
    mesh.improve();
    mesh.clear_progress();
    if (heard == 0 || mesh.statistic(mgdt::MeshStatistic::regions) != 2) return false;
    if (mesh.array(mgdt::MeshArray::reasons).size() != 2) return false;
    if (mesh.doubles(mgdt::MeshDoubles::shapes).size() != 6) return false;
    if (mesh.array<std::int32_t>(mgdt::MeshArray::face_markers).size() != 7) return false;
    try {
        mesh.set_tetrahedra(std::vector<std::int64_t>{0, 1, 2});
        return false;
    } catch (const mgdt::Error& e) {
        if (e.status() != MGDT_ERR_INVALID_ARGUMENT) return false;
    }
    try {
        mesh.set_edges(std::vector<std::int64_t>{0, 1}, std::vector<std::int32_t>{1, 2});
        return false;
    } catch (const mgdt::Error& e) {
        if (e.status() != MGDT_ERR_INVALID_ARGUMENT) return false;
    }
    const std::vector<mgdt::Point> places{{0.1, 0.2, 0.3}, {-1, 0.2, 0.3}};
    const std::vector<std::int64_t> found = mesh.locate_points(places);
    if (found[0] < 0 || found[1] != -1) return false;
    if (mesh.locate_with_weights(places, mgdt::Outside::boundary).tetrahedra[1] < 0) return false;
    if (!mesh.contains(places[0]) || mesh.contains(places[1])) return false;
    std::vector<double> heights;
    for (const mgdt::Point& p : mesh.points()) heights.push_back(p[2]);
    const std::vector<double> values = mesh.interpolate(heights, places, mgdt::Outside::boundary);
    if (std::abs(values[0] - 0.3) > 1e-15 || std::abs(values[1] - 0.3) > 1e-15) return false;
    const mgdt::ShapeSummary shapes = mesh.shape_summary();
    if (!(shapes.least_angle > 30) || shapes.angles[0] != 0) return false;
    mesh.set_option(mgdt::MeshDoubleOption::size, 0.5);
    if (mesh.option(mgdt::MeshDoubleOption::size) != 0.5) return false;
    const std::vector<double> sizes(
        static_cast<std::size_t>(mesh.statistic(mgdt::MeshStatistic::points)), 0.4);
    mesh.set_sizes(mgdt::Sizes::of_points, sizes);
    mesh.refine();
    if (mesh.array(mgdt::MeshArray::refusals).empty()) return false;
    mesh.set_size_field(std::vector<mgdt::Point>{{0, 0, 0}, {1, 1, 1}},
                        std::vector<double>{0.3, 0.5});
    int asked = 0;
    mesh.set_size_function([&](const mgdt::Point& p) { return ++asked, 0.3 + 0.1 * p[0]; });
    mesh.refine();
    if (asked == 0) return false;
    mesh.clear_size_function();
    mgdt_size_fn fn = nullptr;
    if (mgdt_mesh_get_size_function(mesh.handle(), &fn, nullptr) != MGDT_OK || fn) return false;
    try {
        mesh.set_size_field(std::vector<mgdt::Point>{{0, 0, 0}}, std::vector<double>{0.3, 0.5});
        return false;
    } catch (const mgdt::Error& e) {
        if (e.status() != MGDT_ERR_INVALID_ARGUMENT) return false;
    }
    if (mesh.doubles(mgdt::MeshDoubles::sizes).size() !=
        static_cast<std::size_t>(mesh.statistic(mgdt::MeshStatistic::points)))
        return false;
    mgdt::Mesh with_memory(nullptr, nullptr, nullptr);
    try {
        with_memory.build();
        return false;
    } catch (const mgdt::Error& e) {
        return e.status() == MGDT_ERR_INVALID_ARGUMENT;
    }
}

// Whether a domain, a tetrahedron with a point inside, does what it is asked.
bool calls_domain() {
    const std::vector<mgdt::Point> points{
        {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25, 0.25, 0.25}};
    const std::vector<std::int64_t> corners{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    int heard = 0;
    mgdt::Domain domain;
    domain.set_option(mgdt::DomainOption::threads, 2);
    if (domain.option(mgdt::DomainOption::threads) != 2) return false;
    domain.set_progress([&](double) { ++heard; });
    domain.set_points(points);
    domain.set_facets(std::vector<std::int64_t>{0, 3, 6, 9, 12}, corners,
                      std::vector<std::int32_t>{1, 2, 3, 4});
    domain.set_triangles(corners);
    domain.set_segments(std::vector<std::int64_t>{0, 4});
    const std::vector<mgdt::Point> places{{0.1, 0.1, 0.1}};
    domain.set_regions(places, std::vector<std::int32_t>{9});
    domain.set_option(mgdt::DomainDoubleOption::weld, 0.0625);
    if (domain.option(mgdt::DomainDoubleOption::weld) != 0.0625) return false;
    domain.set_option(mgdt::DomainDoubleOption::weld, 0);
    domain.clean();
    if (domain.array(mgdt::DomainArray::facet_origins) != std::vector<std::int64_t>{0, 1, 2, 3} ||
        domain.points(mgdt::DomainDoubles::points) != points)
        return false;
    domain.validate();
    mgdt::Mesh mesh = domain.build();
    int heard_of_mesh = 0;
    mesh.set_progress([&](double) { ++heard_of_mesh; });
    mesh.check();
    domain.check(mesh);
    domain.clear_progress();
    mesh.clear_progress();
    if (heard == 0 || mesh.statistic(mgdt::MeshStatistic::tetrahedra) != 4) return false;
    if (domain.statistic(mgdt::DomainStatistic::facets) != 4) return false;
    if (mesh.array(mgdt::MeshArray::tetrahedra).size() != 16) return false;
    if (mesh.columns(mgdt::MeshArray::tetrahedra) != 4) return false;
    if (mesh.columns(mgdt::MeshDoubles::steiner_parameters) != 1) return false;
    if (domain.columns(mgdt::DomainArray::open_edges) != 3) return false;
    if (mesh.array<std::int32_t>(mgdt::MeshArray::region_markers).at(0) != 9) return false;
    if (mesh.points() != points || mesh.size(mgdt::MeshDoubles::steiner_parameters) != 0)
        return false;
    if (mesh.tetrahedron_measures(mgdt::TetrahedronMeasure::volume).size() != 4) return false;
    mesh.set_option(mgdt::MeshOption::index_base, 1);
    if (mesh.option(mgdt::MeshOption::index_base) != 1) return false;
    mesh.cancel();
    mgdt::Mesh same(mesh.release());
    swap(mesh, same);
    if (!mesh || same || !mesh.last_error().empty()) return false;
    domain.set_holes(places);
    domain.set_option(mgdt::DomainOption::strict, 1);
    try {
        (void)domain.build();
        return false;
    } catch (const mgdt::Error& e) {
        if (e.status() != MGDT_ERR_OPEN_BOUNDARY) return false;
    }
    try {
        domain.set_triangles(corners, std::vector<std::int32_t>{1});
        return false;
    } catch (const mgdt::Error& e) {
        if (e.status() != MGDT_ERR_INVALID_ARGUMENT) return false;
    }
    domain.set_triangles(std::vector<std::int64_t>{0, 1, 1});
    try {
        (void)domain.build();
        return false;
    } catch (const mgdt::Error& e) {
        if (e.status() != MGDT_ERR_INVALID_BOUNDARY || domain.last_error() != e.what())
            return false;
    }
    if (domain.array(mgdt::DomainArray::offending_pairs).size() != 4) return false;
    domain.cancel();
    domain.clear();
    mgdt::Domain other;
    swap(domain, other);
    mgdt::Domain again(domain.release());
    return !domain && again && again.handle() != nullptr;
}

// Whether a box with two atoms does what it is asked.
bool calls_periodic() {
    const std::vector<mgdt::Point> vectors{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
    const std::vector<mgdt::Point> atoms{{0, 0, 0}, {1, 1, 1}};
    int heard = 0;
    mgdt::Periodic box(vectors);
    box.set_option(mgdt::PeriodicOption::threads, 2);
    if (box.option(mgdt::PeriodicOption::threads) != 2) return false;
    box.set_merge_distance(1e-9);
    if (box.merge_distance() != 1e-9) return false;
    box.set_progress([&](double) { ++heard; });
    box.insert(atoms);
    box.build();
    box.check();
    box.clear_progress();
    if (heard == 0 || box.statistic(mgdt::PeriodicStatistic::tetrahedra) != 12) return false;
    if (box.array(mgdt::PeriodicArray::tetrahedra).size() != 48) return false;
    if (box.array<std::int32_t>(mgdt::PeriodicArray::tetrahedron_shifts).size() != 144)
        return false;
    if (box.points() != atoms || box.vectors() != vectors) return false;
    if (box.cell_measures(mgdt::Measure::faces) != std::vector<double>{14, 14}) return false;
    if (box.cell_measures(mgdt::Measure::centroid).size() != 6) return false;
    const mgdt::Voronoi cells = box.voronoi();
    if (cells.array(mgdt::VoronoiArray::face_shifts).size() !=
        3 * cells.size(mgdt::VoronoiDoubles::face_areas))
        return false;
    if (cells.statistic(mgdt::VoronoiStatistic::faces) !=
        static_cast<std::int64_t>(cells.size(mgdt::VoronoiDoubles::face_areas)))
        return false;
    box.move(atoms);
    box.move(std::vector<std::int64_t>{1}, std::vector<mgdt::Point>{{1, 1, 3}});
    box.move(std::vector<std::int64_t>{}, std::vector<mgdt::Point>{});
    box.build();
    if (box.statistic(mgdt::PeriodicStatistic::tetrahedra) != 12) return false;
    try {
        box.move(std::vector<std::int64_t>{1}, atoms);
        return false;
    } catch (const mgdt::Error& e) {
        if (e.status() != MGDT_ERR_INVALID_ARGUMENT) return false;
    }
    try {
        box.insert(std::vector<mgdt::Point>{{1e30, 0, 0}});
        box.build();
        return false;
    } catch (const mgdt::Error& e) {
        if (box.last_error() != e.what()) return false;
    }
    try {
        mgdt::Periodic four(std::vector<mgdt::Point>(4));
        return false;
    } catch (const mgdt::Error& e) {
        if (e.status() != MGDT_ERR_INVALID_ARGUMENT) return false;
    }
    box.cancel();
    box.clear();
    box.set_vectors(std::vector<mgdt::Point>{{3, 0, 0}});
    if (box.statistic(mgdt::PeriodicStatistic::dimensions) != 1) return false;
    if (mgdt::Periodic().statistic(mgdt::PeriodicStatistic::dimensions) != 0) return false;
    mgdt::Periodic other(vectors);
    swap(box, other);
    mgdt::Periodic again(box.release());
    return !box && again && again.handle() != nullptr;
}

}  // namespace

int main() {
    try {
        if (!calls_parts({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 2}})) return 30;
        if (!calls_voronoi({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 2}})) return 31;
        if (!calls_mesh()) return 29;
        if (!calls_domain()) return 32;
        if (!calls_periodic()) return 33;
        Heap heap;
        mgdt::Triangulation t(heap), other;
        t.set_order_scheme(mgdt::order_from_name("brio"));
        t.set_order_scheme(mgdt::order_schemes().front());
        t.set_order_parameter(mgdt::Parameter::round_ratio, 4);
        t.set_order_parameter(mgdt::Parameter::separation, mgdt::Separation::passes);
        t.set_seed(1);
        t.set_threads(1);
        t.set_index_base(0);
        t.set_memory_limit(0);
        t.set_compact(true);
        t.set_read_progress(true);
        t.set_canonical_output(true);
        t.set_isa(nullptr);
        t.set_progress([](double fraction) { return fraction > 2; });
        t.reserve(8);
        if (t.order_scheme() != mgdt::Order::automatic || t.seed() != 1 || t.threads() != 1)
            return 19;
        if (t.order_parameter(mgdt::Parameter::round_ratio) != 4 || t.index_base() != 0) return 20;
        if (t.order_parameter(mgdt::Parameter::separation) != 1) return 21;
        if (t.memory_limit() != 0 || !t.compact() || !t.read_progress() || !t.canonical_output())
            return 22;
        std::vector<double> x{0, 1, 0, 0}, y{0, 0, 1, 0}, z{0, 0, 0, 1};
        t.insert(x, y, z);
        t.insert_strided(4, x.data(), y.data(), z.data(), 1);
        t.insert({{1, 1, 1}});
        t.insert(std::vector<double>{2, 2, 3});
        t.check(mgdt::Check::canonical);
        const std::vector<mgdt::Point> points{{0.1, 0.1, 0.1}, {5, 5, 5}};
        const std::size_t n = exports<std::int64_t>(t, points);
        if (n != exports<std::int32_t>(t, points)) return 1;
        if (t.locate(points[0]) < 0 || t.locate(points[1]) != -1) return 2;
        if (t.nearest_vertex(points[0]) != 0) return 3;
        t.shrink();
        t.insert({{3, 3, 4}, {4, 4, 5}});
        t.move({10}, std::vector<double>{3, 3, 5});
        t.move(std::vector<std::int32_t>{11}, std::vector<double>{3, 3, 6});
        t.remove({10});
        t.remove(std::vector<std::int32_t>{11});
        if (t.renumber<std::int32_t>().back() != -1 || t.renumber().back() != 9) return 23;
        if (t.point_count() != 10 || t.vertex_count() != 6 || t.dimension() != 3) return 4;
        if (t.statistic(mgdt::Statistic::duplicates) != 4) return 5;
        if (t.tetrahedron_count() * 4 != t.vertex_tetrahedra_count()) return 6;
        if (t.edge_count() * 2 != t.vertex_neighbors_count()) return 6;
        if (t.circumspheres().centers.size() != t.circumspheres().squared_radii.size()) return 6;
        if (t.alphas(0).size() != 10 || !(t.solid_alpha() > 0)) return 6;
        if (static_cast<std::int64_t>(t.alpha_surface(1e9).size()) != t.hull_facet_count())
            return 6;
        if (t.alpha_surface<std::int32_t>(0).size() != 0) return 6;
        {
            const auto way = t.traverse_segment<std::int32_t>({-9, -9, -9.5}, {9, 9, 9});
            const auto again = t.traverse_segment({-9, -9, -9.5}, {9, 9, 9});
            if (way.tetrahedra.empty() || way.parameters != again.parameters) return 6;
            if (way.parameters.size() != way.tetrahedra.size() + 1) return 6;
        }
        for (const double volume : t.tetrahedron_measures(mgdt::TetrahedronMeasure::volume))
            if (!(volume > 0)) return 6;
        if (t.cell_measures(mgdt::Measure::faces).size() != 10) return 6;
        if (t.cell_measures(mgdt::Measure::centroid, {}).size() != 30) return 6;
        const std::vector<double> values(20, 1.0);
        for (const double at :
             t.interpolate(mgdt::Method::sibson, mgdt::Outside::nearest, values, points, 2))
            if (!(at > 0.999 && at < 1.001)) return 24;
        if (t.interpolation_weights(mgdt::Method::linear, mgdt::Outside::none, points)
                .offsets.size() != 3)
            return 24;
        if (t.interpolation_weights<std::int32_t>(mgdt::Method::sibson_c1, mgdt::Outside::linear,
                                                  points)
                .weights.empty())
            return 24;
        if (t.gradients(values, 2).size() != 60) return 24;
        if (t.hull_facet_count() < 4 || t.edge_count() < 6) return 7;
        if (!mgdt::name(mgdt::Order::brio) || !mgdt::name(mgdt::Statistic::rounds)) return 8;
        if (!mgdt::version() || mgdt::abi_version() != 1 || !mgdt::status_string(0)) return 9;
        if (!t.isa()[0] || !t.last_error().empty() || !t.handle()) return 10;
        swap(t, other);
        t = std::move(other);
        t.clear_progress();
        t.clear();
        mgdt::Triangulation again(t.release());
        again.cancel();
        try {
            again.insert({{0, 0, 0}});
            return 11;
        } catch (const mgdt::Cancelled& cancelled) {
            if (cancelled.status() != MGDT_ERR_CANCELLED) return 12;
        }
        again.set_memory_limit(1);
        try {
            again.reserve(1000000);
            return 13;
        } catch (const std::bad_alloc&) {
        }
        again.set_progress([](double) -> bool { throw 42; });
        again.set_memory_limit(0);
        try {
            again.insert({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
            return 14;
        } catch (int thrown) {
            if (thrown != 42) return 15;
        }
        again.set_progress([&again](double) { again.clear(); });
        try {
            again.insert({{0, 0, 0}});
            return 17;
        } catch (const mgdt::Busy& busy) {
            if (busy.status() != MGDT_ERR_BUSY) return 18;
        }
        return 0;
    } catch (const std::exception&) {
        return 16;
    }
}
