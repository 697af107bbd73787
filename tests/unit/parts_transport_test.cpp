// SPDX-License-Identifier: MIT
// Parts in processes through the C interface: threads that exchange bytes by its functions.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "../support/messages.hpp"
#include "../support/points.hpp"
#include "../support/small.h"
#include "mgdt/mgdt_parts.h"
#include "thread_transport.hpp"

namespace mgdt {
namespace {

using mgdt_tests::uniform;

using Tetrahedra = std::vector<std::array<std::int64_t, 4>>;

// A process's end of the functions. The call numbered `fails_at` fails.
struct End {
    MeetingPlace& place;
    std::int32_t process;
    std::int64_t fails_at = -1, calls = 0;
    int times_destroyed = 0;

    bool fails() { return calls++ == fails_at; }
    template <class T, class Combine>
    std::int32_t reduce(T* numbers, std::int64_t n, const Combine& combine) {
        if (fails()) return 1;
        const std::vector<T> mine(numbers, numbers + n);
        place.meet(static_cast<PartId>(process), mine.data(), [&](PartId p, const void* theirs) {
            if (static_cast<std::int32_t>(p) == process) return;
            for (std::int64_t i = 0; i < n; ++i)
                numbers[i] = combine(numbers[i], static_cast<const T*>(theirs)[i]);
        });
        return 0;
    }

    mgdt_transport functions() {
        const auto gather = [](const void* mine, void* all, const std::int64_t* begin, void* user) {
            auto& end = *static_cast<End*>(user);
            if (end.fails()) return 1;
            end.place.meet(
                static_cast<PartId>(end.process), mine, [&](PartId p, const void* theirs) {
                    copy(static_cast<char*>(all) + begin[p], theirs, begin[p + 1] - begin[p]);
                });
            return 0;
        };
        const auto exchange_numbers = [](const std::uint64_t* out, std::uint64_t* in, void* user) {
            auto& end = *static_cast<End*>(user);
            if (end.fails()) return 1;
            end.place.meet(static_cast<PartId>(end.process), out,
                           [&](PartId p, const void* theirs) {
                               in[p] = static_cast<const std::uint64_t*>(theirs)[end.process];
                           });
            return 0;
        };
        const auto exchange = [](const void* out, const std::int64_t* out_begin, void* in,
                                 const std::int64_t* in_begin, void* user) {
            auto& end = *static_cast<End*>(user);
            if (end.fails()) return 1;
            const Sent mine{static_cast<const char*>(out), out_begin};
            end.place.meet(
                static_cast<PartId>(end.process), &mine, [&](PartId p, const void* theirs) {
                    const Sent& sent = *static_cast<const Sent*>(theirs);
                    const std::int64_t bytes = in_begin[p + 1] - in_begin[p];
                    EXPECT_EQ(sent.begin[end.process + 1] - sent.begin[end.process], bytes);
                    copy(static_cast<char*>(in) + in_begin[p], sent.bytes + sent.begin[end.process],
                         bytes);
                });
            return 0;
        };
        const auto sum = [](std::uint64_t* numbers, std::int64_t n, void* user) {
            return static_cast<End*>(user)->reduce(
                numbers, n, [](std::uint64_t a, std::uint64_t b) { return a + b; });
        };
        const auto least = [](double* numbers, std::int64_t n, void* user) {
            return static_cast<End*>(user)->reduce(
                numbers, n, [](double a, double b) { return std::min(a, b); });
        };
        const auto destroy = [](void* user) { ++static_cast<End*>(user)->times_destroyed; };
        const mgdt_transport transport = {sizeof transport,
                                          static_cast<std::int32_t>(place.size()),
                                          process,
                                          gather,
                                          exchange_numbers,
                                          exchange,
                                          sum,
                                          least,
                                          destroy,
                                          this};
        return transport;
    }
    mgdt_status create(mgdt_parts** out) {
        const mgdt_transport transport = functions();
        return mgdt_parts_create_with_transport(&transport, out);
    }

  private:
    struct Sent {
        const char* bytes;
        const std::int64_t* begin;
    };
    static void copy(void* to, const void* from, std::int64_t bytes) {
        if (bytes > 0) std::memcpy(to, from, static_cast<std::size_t>(bytes));
    }
};

struct Outcome {
    mgdt_status status = MGDT_OK;
    std::string message;
    Tetrahedra owned;  // by ids, sorted
};

// Each process calls body(its handle, its number), which gives a status.
std::vector<Outcome> in_processes(PartId processes,
                                  const std::function<mgdt_status(mgdt_parts*, std::int32_t)>& body,
                                  PartId short_of = 0, std::int64_t memory_of_it = 0) {
    MeetingPlace place(processes);
    std::vector<Outcome> all(processes);
    std::vector<std::thread> threads;
    for (PartId i = 0; i < processes; ++i)
        threads.emplace_back([&, i] {
            const auto process = static_cast<std::int32_t>(i);
            End end{place, process};
            mgdt_parts* p = nullptr;
            ASSERT_EQ(end.create(&p), MGDT_OK);
            if (i == short_of) {
                ASSERT_EQ(mgdt_parts_set_option(p, MGDT_PARTS_MEMORY_LIMIT, memory_of_it), MGDT_OK);
            }
            Outcome& outcome = all[i];
            outcome.status = body(p, process);
            outcome.message = mgdt_tests::message_of(p, mgdt_parts_get_error);
            if (outcome.status == MGDT_OK) {
                std::int64_t vertices, tetrahedra, owned;
                mgdt_parts_get_stat(p, MGDT_PARTS_THIS_PART, MGDT_PARTS_VERTICES, &vertices);
                mgdt_parts_get_stat(p, process, MGDT_PARTS_TETRAHEDRA, &tetrahedra);
                mgdt_parts_get_stat(p, process, MGDT_PARTS_OWN_TETRAHEDRA, &owned);
                std::vector<std::int64_t> ids(static_cast<std::size_t>(vertices)),
                    corners(4 * static_cast<std::size_t>(tetrahedra));
                EXPECT_EQ(
                    mgdt_parts_get_array(p, process, MGDT_PARTS_VERTEX_IDS, vertices, ids.data()),
                    MGDT_OK);
                EXPECT_EQ(mgdt_parts_get_array(p, process, MGDT_PARTS_LOCAL_CORNERS, 4 * tetrahedra,
                                               corners.data()),
                          MGDT_OK);
                for (std::size_t k = 0; k < static_cast<std::size_t>(owned); ++k) {
                    std::array<std::int64_t, 4> v;
                    for (std::size_t c = 0; c < 4; ++c)
                        v[c] = ids[static_cast<std::size_t>(corners[4 * k + c])];
                    std::sort(v.begin(), v.end());
                    outcome.owned.push_back(v);
                }
            }
            EXPECT_EQ(end.times_destroyed, 0);
            mgdt_parts_destroy(p);
            EXPECT_EQ(end.times_destroyed, 1);
        });
    for (std::thread& t : threads) t.join();
    return all;
}

Tetrahedra of_one(const std::vector<double>& xyz) {
    mgdt_triangulation* t;
    EXPECT_EQ(mgdt_create(&t), MGDT_OK);
    EXPECT_EQ(mgdt_insert_points(t, static_cast<std::int64_t>(xyz.size() / 3), xyz.data()),
              MGDT_OK);
    const auto count = static_cast<std::size_t>(mgdt_tetrahedron_count(t));
    std::vector<std::int64_t> v(4 * count);
    EXPECT_EQ(mgdt_get_tetrahedra(t, static_cast<std::int64_t>(v.size()), v.data()), MGDT_OK);
    mgdt_destroy(t);
    Tetrahedra all(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::copy_n(v.begin() + static_cast<std::ptrdiff_t>(4 * i), 4, all[i].begin());
        std::sort(all[i].begin(), all[i].end());
    }
    std::sort(all.begin(), all.end());
    return all;
}

// The points from n p / processes on; those of process 1 in two calls.
mgdt_status insert_share(mgdt_parts* p, std::int32_t process, std::int32_t processes,
                         const std::vector<double>& xyz) {
    const auto n = static_cast<std::int64_t>(xyz.size() / 3);
    const std::int64_t first = n * process / processes, last = n * (process + 1) / processes,
                       middle = process == 1 ? (first + last) / 2 : last;
    const mgdt_status status = mgdt_parts_insert_points(p, MGDT_PARTS_THIS_PART, middle - first,
                                                        xyz.data() + 3 * first, nullptr);
    if (status != MGDT_OK) return status;
    return mgdt_parts_insert_points(p, process, last - middle, xyz.data() + 3 * middle, nullptr);
}

TEST(PartsTransport, HasTheTetrahedraOfOne) {
    const std::vector<double> xyz = uniform(is_small() ? 300 : 3000);
    const Tetrahedra expected = of_one(xyz);
    for (const std::int32_t processes : {1, 2, 3, 7}) {
        Tetrahedra owned;
        for (const Outcome& o :
             in_processes(static_cast<PartId>(processes), [&](mgdt_parts*p, std::int32_t process) {
                 EXPECT_EQ(insert_share(p, process, processes, xyz), MGDT_OK);
                 const mgdt_status status = mgdt_parts_build(p);
                 return status != MGDT_OK ? status : mgdt_parts_check(p, MGDT_CHECK_CANONICAL);
             })) {
            EXPECT_EQ(o.status, MGDT_OK) << o.message;
            owned.insert(owned.end(), o.owned.begin(), o.owned.end());
        }
        std::sort(owned.begin(), owned.end());
        EXPECT_EQ(owned, expected);
    }
}

// From no memory at all on: the status and the message of all are those of the one that fails.
TEST(PartsTransport, FailsTogetherWithoutMemory) {
    const std::vector<double> xyz = uniform(300);
    int failures = 0, successes = 0;
    for (std::int64_t memory = 1; memory < std::int64_t{1} << 22;
         memory += memory / (is_small() ? 2 : 16) + 64) {
        const std::vector<Outcome> all = in_processes(
            3,
            [&](mgdt_parts* p, std::int32_t process) {
                insert_share(p, process, 3, xyz);
                const mgdt_status status = mgdt_parts_build(p);
                return status != MGDT_OK ? status : mgdt_parts_check(p, MGDT_CHECK_CANONICAL);
            },
            1, memory);
        for (const Outcome& o : all) {
            EXPECT_EQ(o.status, all[0].status) << memory;
            if (all[0].status == MGDT_OK) continue;
            EXPECT_EQ(o.status, MGDT_ERR_OUT_OF_MEMORY);
            EXPECT_EQ(o.message, "part 1: out of memory") << memory;
        }
        ++(all[0].status == MGDT_OK ? successes : failures);
    }
    EXPECT_GT(failures, 10);
    EXPECT_GT(successes, 1);
}

// What is wrong on one process is known to all, which may go on.
TEST(PartsTransport, FailsTogether) {
    std::vector<double> xyz = uniform(300);
    const auto expect = [&](const std::function<void(mgdt_parts*, std::int32_t)>& wrong,
                            mgdt_status status, const char* message) {
        SCOPED_TRACE(message);
        for (const Outcome& o : in_processes(3, [&](mgdt_parts*p, std::int32_t process) {
                 EXPECT_EQ(insert_share(p, process, 3, xyz), MGDT_OK);
                 wrong(p, process);
                 const mgdt_status built = mgdt_parts_build(p);
                 const std::string text = mgdt_tests::message_of(p, mgdt_parts_get_error);
                 EXPECT_NE(text.find(message), std::string::npos) << text;
                 // Nothing is lost: without what was wrong it goes on.
                 mgdt_parts_set_progress(p, nullptr, nullptr);
                 mgdt_parts_set_option(p, MGDT_PARTS_INDEX_BASE, 0);
                 EXPECT_EQ(mgdt_parts_build(p), MGDT_OK);
                 return built;
             }))
            EXPECT_EQ(o.status, status);
    };
    expect(
        [](mgdt_parts* p, std::int32_t process) {
            const double bad[] = {1, 2, 3, 4, INFINITY, 6};
            if (process != 2) return;
            EXPECT_EQ(mgdt_parts_insert_points(p, 2, 2, bad, nullptr), MGDT_ERR_NOT_FINITE);
        },
        MGDT_ERR_NOT_FINITE, "part 2: coordinate y of point 101 is infinite");
    expect(
        [](mgdt_parts* p, std::int32_t process) {
            if (process == 1) mgdt_parts_set_option(p, MGDT_PARTS_INDEX_BASE, 1);
        },
        MGDT_ERR_INVALID_ARGUMENT, "part 1: its index base is not that of part 0");
    expect(
        [](mgdt_parts* p, std::int32_t process) {
            if (process == 1) mgdt_parts_cancel(p);
        },
        MGDT_ERR_CANCELLED, "part 1: cancelled");
    expect(
        [](mgdt_parts* p, std::int32_t process) {
            if (process == 0)
                mgdt_parts_set_progress(
                    p, [](double fraction, void*) -> std::int32_t { return fraction > 0.65; },
                    nullptr);
        },
        MGDT_ERR_CANCELLED, "part 0: cancelled");
}

// A check that one process cancels ends on all of them, also if the request came before the call.
TEST(PartsTransport, ChecksAreCancelledTogether) {
    const std::vector<double> xyz = uniform(300);
    for (const std::int32_t watches : {0, 1})
        for (const Outcome& o : in_processes(3, [&](mgdt_parts*p, std::int32_t process) {
                 EXPECT_EQ(mgdt_parts_set_option(p, MGDT_PARTS_READ_PROGRESS, watches), MGDT_OK);
                 EXPECT_EQ(insert_share(p, process, 3, xyz), MGDT_OK);
                 EXPECT_EQ(mgdt_parts_build(p), MGDT_OK);
                 if (process == 1) mgdt_parts_cancel(p);
                 const mgdt_status checked = mgdt_parts_check(p, MGDT_CHECK_CANONICAL);
                 const std::string text = mgdt_tests::message_of(p, mgdt_parts_get_error);
                 EXPECT_TRUE(watches == 0 || text == "part 1: cancelled") << text;
                 // Where the check is not watched, the request waits for the next build.
                 EXPECT_EQ(mgdt_parts_build(p), watches == 1 ? MGDT_OK : MGDT_ERR_CANCELLED);
                 EXPECT_EQ(mgdt_parts_build(p), MGDT_OK);
                 EXPECT_EQ(mgdt_parts_check(p, MGDT_CHECK_CANONICAL), MGDT_OK);
                 return checked;
             }))
            EXPECT_EQ(o.status, watches == 1 ? MGDT_ERR_CANCELLED : MGDT_OK);
}

// A transport that fails is not called again; it is alone, so nobody waits.
TEST(PartsTransport, MayFail) {
    const std::vector<double> xyz = uniform(30);
    MeetingPlace place(1);
    std::int64_t calls = 1;
    for (std::int64_t at = -1; at < calls; ++at) {
        End end{place, 0, at};
        mgdt_parts* p = nullptr;
        ASSERT_EQ(end.create(&p), MGDT_OK);
        EXPECT_EQ(insert_share(p, 0, 1, xyz), MGDT_OK);
        mgdt_status status = mgdt_parts_build(p);
        if (status == MGDT_OK) status = mgdt_parts_check(p, MGDT_CHECK_CANONICAL);
        if (at < 0) {
            EXPECT_EQ(status, MGDT_OK);
            calls = end.calls;
            EXPECT_GT(calls, 20);
        } else {
            EXPECT_EQ(status, MGDT_ERR_TRANSPORT);
            EXPECT_EQ(end.calls, at + 1);
            EXPECT_EQ(mgdt_parts_build(p), MGDT_OK);  // it works again
        }
        mgdt_parts_destroy(p);
    }
}

// A callback of the handle's frees neither the handle nor the transport.
TEST(PartsTransport, IsDestroyedWithItsHandle) {
    MeetingPlace place(1);
    End end{place, 0};
    struct Heard {
        mgdt_parts* p = nullptr;
        int times = 0;
    } heard;
    ASSERT_EQ(end.create(&heard.p), MGDT_OK);
    const auto destroy = [](double, void* user) -> std::int32_t {
        auto& h = *static_cast<Heard*>(user);
        ++h.times;
        mgdt_parts_destroy(h.p);
        return 0;
    };
    ASSERT_EQ(mgdt_parts_set_progress(heard.p, destroy, &heard), MGDT_OK);
    EXPECT_EQ(insert_share(heard.p, 0, 1, uniform(30)), MGDT_OK);
    EXPECT_EQ(mgdt_parts_build(heard.p), MGDT_OK);
    EXPECT_GT(heard.times, 0);
    EXPECT_EQ(end.times_destroyed, 0);
    mgdt_parts_destroy(heard.p);
    EXPECT_EQ(end.times_destroyed, 1);
}

// Nor does what `destroy` throws reach the caller.
TEST(PartsTransport, MayThrowWhenItIsDestroyed) {
    MeetingPlace place(1);
    End end{place, 0};
    mgdt_transport transport = end.functions();
    transport.destroy = [](void*) { throw 1; };
    mgdt_parts* p = nullptr;
    ASSERT_EQ(mgdt_parts_create_with_transport(&transport, &p), MGDT_OK);
    mgdt_parts_destroy(p);
    transport.destroy = nullptr;
    ASSERT_EQ(mgdt_parts_create_with_transport(&transport, &p), MGDT_OK);
    mgdt_parts_destroy(p);
}

// A program that was compiled with a later header gives a larger structure.
TEST(PartsTransport, MayBeOfALaterVersion) {
    MeetingPlace place(1);
    End end{place, 0};
    struct {
        mgdt_transport now;
        unsigned char later[16];
    } larger = {end.functions(), {}};
    const auto create = [&] {
        mgdt_parts* p = nullptr;
        const mgdt_status status = mgdt_parts_create_with_transport(&larger.now, &p);
        EXPECT_EQ(p != nullptr, status == MGDT_OK);
        mgdt_parts_destroy(p);
        return status;
    };
    larger.now.size = sizeof larger;
    EXPECT_EQ(create(), MGDT_OK);
    larger.later[15] = 1;
    EXPECT_EQ(create(), MGDT_ERR_INVALID_ARGUMENT);
    larger.now.size = sizeof larger - 1;
    EXPECT_EQ(create(), MGDT_OK);
    for (const std::size_t size : {std::size_t{0}, sizeof(mgdt_transport) - 1}) {
        larger.now.size = size;
        EXPECT_EQ(create(), MGDT_ERR_INVALID_ARGUMENT);
    }
    EXPECT_EQ(end.times_destroyed, 2);
}

TEST(PartsTransport, IsRefusedWhereItIsNotWhole) {
    MeetingPlace place(1);
    End end{place, 0};
    mgdt_parts* p = nullptr;
    const auto expect = [&](mgdt_status status, const std::function<void(mgdt_transport&)>& spoil) {
        mgdt_transport transport = end.functions();
        spoil(transport);
        EXPECT_EQ(mgdt_parts_create_with_transport(&transport, &p), status);
        EXPECT_EQ(p, nullptr);
    };
    expect(MGDT_ERR_NULL_POINTER, [](mgdt_transport& t) { t.gather = nullptr; });
    expect(MGDT_ERR_NULL_POINTER, [](mgdt_transport& t) { t.exchange_numbers = nullptr; });
    expect(MGDT_ERR_NULL_POINTER, [](mgdt_transport& t) { t.exchange = nullptr; });
    expect(MGDT_ERR_NULL_POINTER, [](mgdt_transport& t) { t.sum = nullptr; });
    expect(MGDT_ERR_NULL_POINTER, [](mgdt_transport& t) { t.least = nullptr; });
    expect(MGDT_ERR_INVALID_ARGUMENT, [](mgdt_transport& t) { t.processes = 0; });
    expect(MGDT_ERR_INVALID_ARGUMENT, [](mgdt_transport& t) { t.processes = (1 << 20) + 1; });
    expect(MGDT_ERR_INVALID_ARGUMENT, [](mgdt_transport& t) { t.process = -1; });
    expect(MGDT_ERR_INVALID_ARGUMENT, [](mgdt_transport& t) { t.process = 1; });
    EXPECT_EQ(end.times_destroyed, 0);
    const mgdt_transport whole = end.functions();
    EXPECT_EQ(mgdt_parts_create_with_transport(&whole, nullptr), MGDT_ERR_NULL_POINTER);
}

}  // namespace
}  // namespace mgdt
