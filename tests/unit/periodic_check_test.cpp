// SPDX-License-Identifier: MIT
// Damaged periodic triangulations, which the check has to reject.
#include "periodic/periodic_check.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "unwatched.hpp"

namespace mgdt {
namespace {

using Record = PeriodicTetrahedra::Record;
using Records = std::vector<Record>;

const std::vector<double> cube = {1, 0, 0, 0, 1, 0, 0, 0, 1};
const std::vector<double> oblique = {1, 0, 0, 0.25, 0.75, 0, -0.25, 0.125, 0.625};
const std::vector<double> slab = {1, 0, 0, 0.25, 0.75, 0};
const std::vector<double> wire = {0.5, 0.25, 1};

std::vector<double> random_points(std::size_t n, unsigned seed, double grid = 0) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0, 1);
    std::vector<double> points;
    for (std::size_t i = 0; i < 3 * n; ++i) {
        const double x = place(random);
        points.push_back(grid > 0 ? std::floor(x * grid) / grid : x);
    }
    return points;
}

struct Built : Periodic {
    Built(const std::vector<double>& vectors, const std::vector<double>& points)
        : Periodic(nullptr, nullptr, nullptr) {
        set_vectors(static_cast<unsigned>(vectors.size() / 3), vectors.data());
        insert(points.size() / 3, points.data());
        build();
    }
    Records records() const {
        return Records(tetrahedra().records().begin(), tetrahedra().records().end());
    }
    // What the check says of tetrahedra; empty if they are right.
    std::string complaint(const Records& records) const {
        Buffer<Record> all(allocator());
        for (const Record& record : records) all.push_back(record);
        try {
            check_periodic(*this, all, Unwatched());
        } catch (const Error& e) {
            EXPECT_EQ(e.status, MGDT_ERR_CHECK_FAILED);
            EXPECT_STRNE(e.message, "");
            return e.message;
        }
        return "";
    }
};

void expect_complaint(const Built& built, const Records& records, const std::string& part) {
    const std::string complaint = built.complaint(records);
    EXPECT_NE(complaint.find(part), std::string::npos) << "'" << complaint << "'";
}

// Any field of any tetrahedron, changed to any other value.
TEST(PeriodicCheck, RejectsEveryChange) {
    struct Case {
        const std::vector<double>& box;
        std::vector<double> points;
    };
    for (const Case& c : std::vector<Case>{{cube, random_points(1, 1)},
                                           {cube, random_points(60, 2)},
                                           {oblique, random_points(60, 3, 4)},
                                           {slab, random_points(40, 4)},
                                           {wire, random_points(30, 5)}}) {
        const Built built(c.box, c.points);
        const Records right = built.records();
        ASSERT_EQ(built.complaint(right), "");
        std::mt19937 random(6);
        for (int i = 0; i < 2000; ++i) {
            Records damaged = right;
            Record& record = damaged[random() % damaged.size()];
            const auto corner = static_cast<unsigned>(random() % 4);
            const auto other = [&](std::uint32_t& number, std::size_t end) {
                const std::uint32_t before = number;
                number = static_cast<std::uint32_t>(random() % (end + 1));
                if (number == before) number = static_cast<std::uint32_t>(end + 1);
            };
            const auto shift = [&](std::int8_t& of) {
                of = static_cast<std::int8_t>(of + (random() % 2 == 0 ? 1 : -1));
            };
            const auto axis = static_cast<unsigned>(random() % built.dimensions());
            PeriodicTetrahedra::Neighbor& neighbor = record.neighbors[corner];
            switch (random() % 4) {
                case 0:
                    other(record.tetrahedron.corners[corner].point, built.point_count());
                    break;
                case 1:
                    shift(record.tetrahedron.corners[corner].of[axis]);
                    break;
                case 2:
                    other(neighbor.number, damaged.size());
                    break;
                default:
                    if (neighbor.number == no_index) continue;
                    shift(neighbor.of[axis]);
            }
            EXPECT_NE(built.complaint(damaged), "") << "change " << i;
        }
    }
}

TEST(PeriodicCheck, RejectsWhatIsNotDelaunay) {
    // The triangulation of other points is one of these points too, if they are near.
    const std::vector<double> points = random_points(100, 7);
    std::vector<double> other = points;
    std::mt19937 random(8);
    int not_delaunay = 0;
    for (int i = 0; i < 200; ++i) {
        other = points;
        other[random() % other.size()] += 0.03;
        const std::string complaint = Built(cube, points).complaint(Built(cube, other).records());
        not_delaunay += complaint.find("is in its circumsphere") != std::string::npos ? 1 : 0;
    }
    EXPECT_GT(not_delaunay, 10);
    // Ties have to be broken by the perturbation. Turned about, they are broken otherwise.
    const std::vector<double> lattice = {0, 0, 0};
    const Built built(cube, lattice);
    Records turned = built.records();
    ASSERT_EQ(turned.size(), 6u);
    for (Record& record : turned) {
        // The mirror image at a plane: the first multiple changes its sign.
        for (Image& image : record.tetrahedron.corners)
            image.of[0] = static_cast<std::int8_t>(-image.of[0]);
        for (PeriodicTetrahedra::Neighbor& n : record.neighbors)
            n.of[0] = static_cast<std::int8_t>(-n.of[0]);
    }
    EXPECT_NE(built.complaint(turned), "");
}

TEST(PeriodicCheck, RejectsWhatIsMissingOrThereTwice) {
    const std::vector<double> points = random_points(50, 9);
    const Built built(cube, points);
    const Records right = built.records();
    expect_complaint(built, {}, "point 0 is a corner of no tetrahedron");
    Records fewer = right;
    fewer.pop_back();
    expect_complaint(built, fewer, "does not exist");
    // Two triangulations, one over the other.
    Records twice = right;
    for (Record record : right) {
        for (PeriodicTetrahedra::Neighbor& n : record.neighbors)
            n.number += static_cast<std::uint32_t>(right.size());
        twice.push_back(record);
    }
    expect_complaint(built, twice, "it overlaps another one");
    // The tetrahedra of all points but the last.
    std::vector<double> more = points;
    more.insert(more.end(), {0.5, 0.25, 0.125});
    expect_complaint(Built(cube, more), right, "point 50 is a corner of no tetrahedron");
}

TEST(PeriodicCheck, RejectsOpenSides) {
    const Built full(cube, random_points(20, 10)), open(slab, random_points(20, 11));
    Records records = full.records();
    records[3].neighbors[2].number = no_index;
    expect_complaint(full, records, "tetrahedron 3: it has no neighbour");
    records = open.records();
    for (Record& record : records)
        if (PeriodicTetrahedra::Neighbor& n = record.neighbors[0]; n.number != no_index) {
            n.number = no_index;
            break;
        }
    expect_complaint(open, records, "facet of the hull");
    // No tetrahedra are right for a slab or a wire in one plane, and for no other points.
    const std::vector<double> row = {0.25, 0.5, 1, 0.75, 1.5, 3},
                              plane = {0.25, 0.5, 1, 1.5, 0.25, 1, 0.125, 0.75, 1};
    const std::vector<double> wire_along_x = {1, 0, 0};
    EXPECT_EQ(Built(slab, plane).complaint({}), "");
    EXPECT_EQ(Built(wire, row).complaint({}), "");
    EXPECT_EQ(Built(wire_along_x, plane).complaint({}), "");
    EXPECT_EQ(Built(cube, {}).complaint({}), "");
    for (const std::vector<double>* box : {&slab, &wire, &wire_along_x})
        expect_complaint(Built(*box, random_points(3, 13)), {}, "is a corner of no tetrahedron");
}

TEST(PeriodicCheck, RejectsOtherRepresentatives) {
    const Built built(cube, random_points(20, 12));
    Records records = built.records();
    const Record first = records[0];
    // An even permutation of the corners.
    for (unsigned i = 0; i < 4; ++i) {
        records[0].tetrahedron.corners[i] = first.tetrahedron.corners[(i ^ 1u)];
        records[0].neighbors[i] = first.neighbors[(i ^ 1u)];
    }
    EXPECT_NE(built.complaint(records), "");
    std::swap(records[0].tetrahedron.corners[2], records[0].tetrahedron.corners[3]);
    EXPECT_NE(built.complaint(records), "");
}

}  // namespace
}  // namespace mgdt
