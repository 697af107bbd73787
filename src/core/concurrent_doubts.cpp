// SPDX-License-Identifier: MIT
// Whether several threads are faster than one, measured where most of their tries fail.
#include <algorithm>
#include <utility>

#include "core/concurrent_member.hpp"
#include "core/stopwatch.hpp"

namespace mgdt {
namespace {

// Points that one thread inserts to see whether it is faster than several.
constexpr std::size_t sample_size = 1024;

}  // namespace

// Inserts those that threads have put off, before others make more tetrahedra in their place.
void ConcurrentInsertion::insert_put_off() {
    const std::size_t count = std::min(put_off_, left_.size());
    std::sort(left_.begin(), left_.begin() + count);
    insert_alone({0, count, left_.data()});
    std::copy(left_.begin() + count, left_.end(), left_.begin());
    left_.resize(left_.size() - count);
}

// Whether threads are so much in each other's way that one alone may be faster: where a few
// vertices have edges to all others, all want the same tetrahedra.
bool ConcurrentInsertion::has_doubts(Member& member) const {
    if (member.doubts.tries < doubt_after_) return false;
    // A large cavity that is given up takes the time of many points.
    member.doubts.failures += std::exchange(member.members_given_up, 0) / 256;
    return member.doubts.ends_crowded();
}

// Inserts some of the list, the last ones, and takes them out. Whether that was faster a point than
// the seconds that all have taken together.
bool ConcurrentInsertion::is_faster_alone(Buffer<std::uint32_t>& list, double together,
                                          std::size_t inserted) {
    const std::size_t n = std::min(list.size(), sample_size);
    if (n == 0) return false;
    double alone = 0;
    {
        const Stopwatch watch(alone);
        insert_alone({0, n, list.end() - n});
    }
    list.resize(list.size() - n);
    // A burst may pass, so it has to be much faster, twice in a row.
    const bool is_faster =
        alone * static_cast<double>(inserted) < 0.5 * together * static_cast<double>(n);
    const bool was_faster = std::exchange(was_faster_alone_, is_faster);
    if (!is_faster) doubt_after_ *= 2;
    return is_faster && was_faster;
}

}  // namespace mgdt
