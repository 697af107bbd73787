// SPDX-License-Identifier: MIT
// A round of changes: all are found on the mesh as it is, and then applied one after the other.
#pragma once

#include "improvement/flexible_mesh.hpp"
#include "parallel/per_member.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

class ChangeRound {
  public:
    ChangeRound(FlexibleMesh& mesh, Team& team)
        : mesh_(mesh),
          team_(team),
          finders_(team, mesh.allocator(), &mesh.allocator()),
          found_(mesh.allocator()),
          order_(mesh.allocator()),
          claimed_(mesh.allocator()),
          change_(mesh.allocator()) {}

    // Calls find(k, member, change) for the candidates k from 0 to n - 1, on all threads. It
    // returns whether it has found a change. Changes with the worst tetrahedra are applied first,
    // and those whose tetrahedra another one has replaced are dropped. So the result does not
    // depend on the number of threads. Returns the number of changes that were applied.
    template <class Find>
    std::size_t run(std::size_t n, StageProgress& progress, const Find& find) {
        begin(n);
        constexpr std::size_t candidates_per_thread = 64, between_looks = 256;
        team_.split(n, candidates_per_thread,
                    [&](std::size_t first, std::size_t end, unsigned member) {
                        Finder& finder = finders_[member];
                        for (std::size_t k = first; k < end; ++k) {
                            if ((k - first) % between_looks == 0)
                                progress.look(k - first, end - first, member);
                            if (!find(k, member, finder.change)) continue;
                            found_[k] = {member, static_cast<std::uint32_t>(finder.list.size())};
                            finder.list.add(finder.change);
                        }
                    });
        return apply();
    }

  private:
    // What a thread has found.
    struct Finder {
        explicit Finder(Allocator* allocator) : change(*allocator), list(*allocator) {}
        Change change;
        ChangeList list;
    };
    struct Found {
        std::uint32_t member, number;  // the number is no_index if there is none
    };

    void begin(std::size_t n);
    std::size_t apply();
    double before(std::uint32_t candidate) const noexcept {
        return finders_[found_[candidate].member].list.before(found_[candidate].number);
    }

    FlexibleMesh& mesh_;
    Team& team_;
    PerMember<Finder> finders_;
    Buffer<Found> found_;  // for each candidate
    Buffer<std::uint32_t> order_;
    Buffer<std::uint32_t> claimed_;  // the last round that has replaced each tetrahedron
    Change change_;
};

}  // namespace mgdt
