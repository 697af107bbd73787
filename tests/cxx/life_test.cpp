// SPDX-License-Identifier: MIT
// Life of an object: moves, handles given and taken, memory from elsewhere and its end.
#include <gtest/gtest.h>

#include <cstring>
#include <memory_resource>
#include <new>
#include <type_traits>

#include "random_points.hpp"

using namespace cxx_test;
using mgdt::Triangulation;

static_assert(!std::is_copy_constructible_v<Triangulation>);
static_assert(!std::is_copy_assignable_v<Triangulation>);
static_assert(std::is_nothrow_move_constructible_v<Triangulation>);
static_assert(std::is_nothrow_move_assignable_v<Triangulation>);
static_assert(std::is_nothrow_swappable_v<Triangulation>);
static_assert(std::is_nothrow_destructible_v<Triangulation>);
static_assert(noexcept(std::declval<const Triangulation&>().tetrahedron_count()));
static_assert(noexcept(std::declval<Triangulation&>().cancel()));
static_assert(std::is_base_of_v<std::runtime_error, mgdt::Error>);
static_assert(std::is_base_of_v<std::bad_alloc, mgdt::OutOfMemory>);
static_assert(!std::is_constructible_v<mgdt::Points, std::vector<float>>);
static_assert(!std::is_constructible_v<mgdt::Points, std::vector<std::array<double, 2>>>);
static_assert(!std::is_constructible_v<mgdt::Span<int>, const std::vector<int>&>);

namespace {

// A std::pmr::memory_resource in all but the base: what counts is allocate() and deallocate().
struct Counting {
    void* allocate(std::size_t size, std::size_t align) {
        if (calls++ == refuse_at) throw std::runtime_error("no");
        live += std::ptrdiff_t(size);
        return ::operator new(size, std::align_val_t(align));
    }
    void deallocate(void* p, std::size_t size, std::size_t align) {
        live -= std::ptrdiff_t(size);
        ::operator delete(p, std::align_val_t(align));
    }
    long calls = 0, refuse_at = -1;
    std::ptrdiff_t live = 0;
};

void expect_moved_from(Triangulation& t) {
    const Triangulation& c = t;
    EXPECT_FALSE(t);
    EXPECT_EQ(t.handle(), nullptr);
    EXPECT_EQ(c.handle(), nullptr);
    EXPECT_EQ(c.point_count(), 0);
    EXPECT_EQ(c.vertex_count(), 0);
    EXPECT_EQ(c.tetrahedron_count(), 0);
    EXPECT_EQ(c.hull_facet_count(), 0);
    EXPECT_EQ(c.edge_count(), 0);
    EXPECT_EQ(c.vertex_tetrahedra_count(), 0);
    EXPECT_EQ(c.vertex_neighbors_count(), 0);
    EXPECT_EQ(c.dimension(), -1);
    EXPECT_STREQ(c.isa(), "");
    EXPECT_EQ(c.last_error(), "");
    t.cancel();
    std::vector<std::int64_t> buffer(8);
    std::vector<double> weights(8);
    const std::vector<mgdt::Point> points(2);
    const double xyz[3] = {};
    const auto null = [](auto body) { EXPECT_EQ(status_of(body), MGDT_ERR_NULL_POINTER); };
    null([&] { t.clear(); });
    null([&] { t.reserve(1); });
    null([&] { t.set_order_scheme(mgdt::Order::brio); });
    null([&] { t.set_order_parameter(mgdt::Parameter::threshold, 5); });
    null([&] { t.set_seed(1); });
    null([&] { t.set_threads(1); });
    null([&] { t.set_index_base(0); });
    null([&] { t.set_memory_limit(0); });
    null([&] { t.set_compact(true); });
    null([&] { t.set_canonical_output(true); });
    null([&] { t.set_isa(nullptr); });
    null([&] { t.set_progress([](double) {}); });
    null([&] { t.clear_progress(); });
    null([&] { t.insert(points); });
    null([&] { t.insert({{0, 0, 0}}); });
    null([&] { t.insert(xyz, xyz, xyz); });
    null([&] { t.insert_strided(1, xyz, xyz, xyz, 1); });
    null([&] { (void)c.tetrahedra(); });
    null([&] { (void)c.neighbors<std::int32_t>(); });
    null([&] { (void)c.hull_facets(); });
    null([&] { (void)c.edges(); });
    null([&] { (void)c.point_map(); });
    null([&] { (void)c.vertex_tetrahedra(); });
    null([&] { (void)c.vertex_neighbors(); });
    null([&] { (void)c.circumspheres(); });
    null([&] { (void)c.tetrahedron_measures(mgdt::TetrahedronMeasure::volume); });
    null([&] { (void)c.traverse_segment({0, 0, 0}, {1, 1, 1}); });
    null([&] { (void)c.cell_measures(mgdt::Measure::volume); });
    null([&] {
        (void)c.interpolate(mgdt::Method::linear, mgdt::Outside::none, mgdt::Span<const double>(),
                            points);
    });
    null([&] { (void)c.interpolation_weights(mgdt::Method::linear, mgdt::Outside::none, points); });
    null([&] { (void)c.gradients(mgdt::Span<const double>()); });
    null([&] { (void)c.alphas(3); });
    null([&] { (void)c.alpha_surface(1); });
    null([&] { (void)c.solid_alpha(); });
    null([&] { (void)c.gabriel_edges(); });
    null([&] { (void)c.spanning_tree(); });
    null([&] { c.tetrahedra(buffer); });
    null([&] { c.vertex_tetrahedra(buffer, buffer); });
    null([&] { (void)c.locate({0, 0, 0}); });
    null([&] { (void)c.locate_points(points); });
    null([&] { (void)c.locate_with_weights(points); });
    null([&] { c.locate_points(points, buffer); });
    null([&] { c.locate_points(points, buffer, weights); });
    null([&] { (void)c.nearest_vertex({0, 0, 0}); });
    null([&] { c.check(); });
    null([&] { (void)c.statistic(mgdt::Statistic::rounds); });
    try {
        c.check();
    } catch (const mgdt::Error& error) {
        EXPECT_STREQ(error.what(), "the object was moved from");
    }
}

}  // namespace

TEST(CxxLife, Moves) {
    const auto points = points_in_cube(100);
    Triangulation first = triangulated(points);
    const auto expected = first.tetrahedra();
    mgdt_triangulation* const handle = first.handle();
    EXPECT_TRUE(first);

    Triangulation second(std::move(first));
    expect_moved_from(first);  // NOLINT(bugprone-use-after-move): its state is documented
    EXPECT_EQ(second.handle(), handle);
    EXPECT_EQ(second.tetrahedra(), expected);

    first = Triangulation();
    EXPECT_TRUE(first);
    EXPECT_EQ(first.point_count(), 0);
    first.insert(points);
    first = std::move(second);  // what it held is freed
    expect_moved_from(second);
    EXPECT_EQ(first.handle(), handle);

    swap(first, second);
    expect_moved_from(first);
    EXPECT_EQ(second.tetrahedra(), expected);
    std::swap(first, second);
    EXPECT_EQ(first.tetrahedra(), expected);

    std::vector<Triangulation> many;
    for (int k = 0; k < 5; ++k) many.emplace_back().insert(points);
    many.erase(many.begin());
    EXPECT_EQ(many.back().tetrahedra(), expected);
}

TEST(CxxLife, MovesWithItsCallback) {
    const auto points = points_in_cube(size(5000));
    long calls = 0;
    Triangulation first;
    first.set_progress([&calls](double) { ++calls; });
    Triangulation second(std::move(first));
    second.insert(points);
    EXPECT_GE(calls, 5);
    const long before = calls;
    first = std::move(second);
    first.insert(points_in_cube(size(5000), 4));
    EXPECT_GT(calls, before);
}

TEST(CxxLife, HandlesGivenAndTaken) {
    const auto points = points_in_cube(100);
    mgdt_triangulation* raw = nullptr;
    ASSERT_EQ(mgdt_create(&raw), MGDT_OK);
    ASSERT_EQ(mgdt_set_index_base(raw, 1), MGDT_OK);
    Triangulation t(raw);
    EXPECT_EQ(t.handle(), raw);
    long calls = 0;
    t.set_progress([&calls](double) { ++calls; });
    t.insert(points);
    EXPECT_EQ(t.point_map()[0], 1);
    EXPECT_GT(calls, 0);
    calls = 0;

    mgdt_triangulation* const released = t.release();
    EXPECT_EQ(released, raw);
    expect_moved_from(t);
    EXPECT_EQ(t.release(), nullptr);
    // The callback went with the object: the handle must not know it any more.
    EXPECT_EQ(mgdt_insert_points(released, 92, points_in_cube(100, 5)[8].data()), MGDT_OK);
    EXPECT_EQ(calls, 0);
    mgdt_destroy(released);
}

TEST(CxxMemory, FromAResource) {
    const auto points = points_in_cube(size(3000));
    Counting memory;
    {
        Triangulation t(memory);
        t.insert(points);
        t.check();
        EXPECT_GT(memory.live, 1000);
        EXPECT_EQ(double(memory.live), t.statistic(mgdt::Statistic::memory_bytes));
        Triangulation u(std::move(t));
        EXPECT_EQ(u.tetrahedra(), triangulated(points).tetrahedra());
    }
    EXPECT_EQ(memory.live, 0);

    std::pmr::unsynchronized_pool_resource pool;
    std::pmr::memory_resource& resource = pool;
    Triangulation t(resource);
    t.insert(points);
    t.check();
}

// Whatever allocation fails, by an exception at that: no leak, and a valid object if there is one.
TEST(CxxMemory, AResourceThatThrows) {
    const auto points = points_in_cube(200);
    Counting whole;
    { Triangulation(whole).insert(points); }
    ASSERT_GT(whole.calls, 5);
    long refused = 0;
    for (long k = 0; k < whole.calls; ++k) {
        Counting memory;
        memory.refuse_at = k;
        bool made = false;
        try {
            Triangulation t(memory);
            made = true;
            try {
                t.insert(points);
            } catch (const std::bad_alloc&) {
                ++refused;
                t.check();
                t.clear();
                t.insert(points);
            }
            t.check();
            EXPECT_EQ(t.vertex_count(), 200);
        } catch (const mgdt::OutOfMemory& error) {
            EXPECT_FALSE(made) << "allocation " << k;
            EXPECT_EQ(error.status(), MGDT_ERR_OUT_OF_MEMORY);
            EXPECT_NE(std::strlen(error.what()), 0u);
        }
        EXPECT_EQ(memory.live, 0);
    }
    EXPECT_GT(refused, 0);
}

TEST(CxxMemory, FunctionsOfTheCInterface) {
    const auto alloc = [](std::size_t size, std::size_t align, void* user) noexcept -> void* {
        return static_cast<Counting*>(user)->allocate(size, align);
    };
    const auto give = [](void* p, std::size_t size, std::size_t align, void* user) noexcept {
        static_cast<Counting*>(user)->deallocate(p, size, align);
    };
    Counting memory;
    {
        Triangulation t(+alloc, +give, &memory);
        t.insert(points_in_cube(100));
        EXPECT_GT(memory.live, 0);
    }
    EXPECT_EQ(memory.live, 0);
    EXPECT_EQ(status_of([&] { Triangulation(+alloc, nullptr, &memory); }),
              MGDT_ERR_INVALID_ARGUMENT);
}

TEST(CxxMemory, TheLimitIsOutOfMemory) {
    const auto points = points_in_cube(20000);
    Triangulation t;
    t.set_memory_limit(1 << 20);
    EXPECT_THROW(t.insert(points), mgdt::OutOfMemory);
    EXPECT_THROW(t.reserve(1 << 30), std::bad_alloc);
    t.check();
    EXPECT_LT(t.vertex_count(), 20000);
    t.clear();
    t.set_memory_limit(0);
    t.insert(points);
    EXPECT_EQ(t.vertex_count(), 20000);
}

TEST(CxxMemory, CompactStorageTakesLess) {
    const auto memory = [](const Triangulation& t) {
        return t.statistic(mgdt::Statistic::memory_bytes);
    };
    const auto points = points_in_cube(20000);
    Triangulation t;
    t.insert(points);
    const double before = memory(t);
    t.set_compact(true);
    EXPECT_LT(memory(t), before - 100 * 20000);
    t.check();
    const double after = memory(t);
    t.set_memory_limit(static_cast<std::int64_t>(after));
    EXPECT_THROW(t.set_compact(false), mgdt::OutOfMemory);
    t.set_memory_limit(0);
    t.set_compact(false);
    EXPECT_GT(memory(t), after + 100 * 20000);
    t.check();
}
