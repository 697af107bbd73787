// SPDX-License-Identifier: MIT
// On every row, all order schemes, splits and kinds of storage give the same tetrahedra, and the
// library's own proof accepts them. This is what runs where CGAL does not, under Valgrind above
// all.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "handle.hpp"
#include "rows.hpp"

namespace {

class Schemes : public testing::TestWithParam<property::Row> {};

TEST_P(Schemes, SameTetrahedra) {
    const std::vector<double> xyz = property::points(GetParam(), is_small() ? 250 : 1500);
    property::Keys expected;
    std::vector<std::int64_t> map;
    std::size_t batches = 1;
    for (std::int32_t scheme : order_schemes) {
        const std::int32_t compact = scheme / 10 % 3 == 1;
        SCOPED_TRACE(std::string(mgdt_order_scheme_name(scheme)) + ", " + std::to_string(batches) +
                     " batches" + (compact ? ", compact" : ""));
        const property::Handle t = property::create();
        ASSERT_EQ(mgdt_set_compact(t.get(), compact), MGDT_OK);
        ASSERT_EQ(mgdt_set_order_scheme(t.get(), scheme), MGDT_OK);
        ASSERT_EQ(property::insert(t.get(), xyz, property::equal_batches(xyz.size() / 3, batches)),
                  MGDT_OK)
            << property::error_of(t.get());
        ASSERT_EQ(mgdt_check(t.get(), MGDT_CHECK_CANONICAL), MGDT_OK)
            << property::error_of(t.get());
        const property::Keys keys = property::keys(property::tetrahedra(t.get()));
        if (scheme == order_schemes[0]) {
            expected = keys;
            map = property::point_map(t.get());
        }
        ASSERT_TRUE(keys == expected);
        ASSERT_TRUE(property::point_map(t.get()) == map);
        batches = batches % 4 + 1;
    }
}

INSTANTIATE_TEST_SUITE_P(Rows, Schemes, testing::ValuesIn(property::rows),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
