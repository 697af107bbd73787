// SPDX-License-Identifier: MIT
// The marks of cavities: the table, and what takes four tetrahedra in at a time in each island.

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "islands.hpp"

namespace mgdt {
namespace {

// What is in the set, and nothing of what was in it before, however it grows.
TEST(MarkTable, HasWhatWasPutIn) {
    Allocator allocator;
    MarkTable marks(allocator);
    for (const std::size_t count :
         {std::size_t{1}, std::size_t{250}, std::size_t{1000}, std::size_t{3}}) {
        marks.begin(count);
        std::vector<FacetCode> members;
        MarkTable::View view = marks.view();
        for (std::size_t i = 0; i < count; ++i) {
            // Few hashes, so that many meet.
            const TetId t = static_cast<TetId>(1 + 4096 * (i / 4) + i % 4);
            EXPECT_FALSE(view.has(t));
            EXPECT_EQ(view.put(t, 0), 1u);
            EXPECT_FALSE(view.has(t));
            EXPECT_EQ(view.put(t, 1), 1u);
            EXPECT_TRUE(view.has(t));
            EXPECT_EQ(view.put(t, 1), 0u);
            members.push_back(4 * t + 1);
        }
        for (const std::size_t room : {count, 2 * count + 300}) {
            marks.grow(room, members.data(), members.size());
            view = marks.view();
            for (const FacetCode code : members) EXPECT_TRUE(view.has(code >> 2)) << room;
            EXPECT_FALSE(view.has(0));
            EXPECT_FALSE(view.has(members.back() / 4 + 1));
        }
    }
}

// Stamps come again after some thousand cavities; what had them is gone by then.
TEST(MarkTable, ForgetsWhatHadTheStampBefore) {
    Allocator allocator;
    MarkTable marks(allocator);
    marks.begin(1);
    marks.view().put(7, 1);
    for (unsigned cavity = 0; cavity < 10000; ++cavity) {
        marks.begin(1);
        ASSERT_FALSE(marks.view().has(7)) << cavity;
    }
}

class Marks : public testing::TestWithParam<islands::Island> {
  protected:
    void SetUp() override {
        if (!GetParam().runs()) GTEST_SKIP() << "not on this processor";
    }
    const islands::Island island_ = GetParam();
};

INSTANTIATE_TEST_SUITE_P(Each, Marks, testing::ValuesIn(islands::all()),
                         [](const auto& info) { return std::string(info.param.name); });

// Few places, so that the four meet each other, and others that are in or were in another cavity.
TEST_P(Marks, PutFour) {
    Allocator allocator;
    MarkTable marks(allocator);
    std::uint64_t state = 1;
    const auto below = [&](std::uint32_t n) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<std::uint32_t>((state >> 33) % n);
    };
    std::size_t before = 0, meetings = 0;
    for (unsigned cavity = 0; cavity < 2000; ++cavity) {
        marks.begin(250);
        const MarkTable::View view = marks.view();
        std::set<TetId> in;
        for (unsigned turn = 0; turn < 20; ++turn) {
            alignas(16) FacetCode codes[4];
            std::set<TetId> four;
            while (four.size() < 4) {
                const TetId t = 1 + 4096 * below(6) + below(1 + cavity % 64);
                if (four.insert(t).second) codes[four.size() - 1] = 4 * t + below(4);
            }
            const std::uint32_t which = below(16);
            std::uint32_t expected = 0;
            for (unsigned k = 0; k < 4; ++k)
                if ((which >> k & 1) && in.insert(codes[k] >> 2).second) expected |= 1u << k;
            ASSERT_EQ(island_.put_four(view, codes, which), expected) << cavity << ' ' << turn;
            before += (which & ~expected) != 0;
            for (const TetId t : four) {
                ASSERT_EQ(view.has(t), in.count(t) != 0) << cavity << ' ' << turn;
                for (const TetId other : four) meetings += t != other && t % 4096 == other % 4096;
            }
        }
        for (const TetId t : in) ASSERT_TRUE(view.has(t)) << cavity;
    }
    EXPECT_GT(before, 1000u);
    EXPECT_GT(meetings, 1000u);
}

// Every choice, over every choice that was made before.
TEST_P(Marks, MarkFour) {
    for (std::uint32_t before = 0; before < 16; ++before)
        for (std::uint32_t which = 0; which < 16; ++which) {
            TetrahedronAndSphere records[4] = {};
            FourTetrahedra<TetrahedronAndSphere> four = {
                {records + 3, records, records + 2, records + 1}};
            const auto second = [](unsigned k) { return 0x7FFFFFF0u + k; };
            const auto mark = [](std::uint32_t bits, unsigned k) { return bits >> k << 31; };
            for (unsigned k = 0; k < 4; ++k)
                for (unsigned i = 0; i < 4; ++i)
                    four[k].v[i] = i == 1 ? second(k) | mark(before, k) : 10 * k + i;
            EXPECT_EQ(island_.mark_four(four, which), which & ~before);
            for (unsigned k = 0; k < 4; ++k)
                for (unsigned i = 0; i < 4; ++i)
                    EXPECT_EQ(four[k].v[i],
                              i == 1 ? second(k) | mark(before | which, k) : 10 * k + i);
        }
}

}  // namespace
}  // namespace mgdt
