// SPDX-License-Identifier: MIT
// The tetrahedra that are to be divided, roughly sorted by how bad they are.
#pragma once

#include "platform/objects.hpp"
#include "refinement/refined_mesh.hpp"

namespace mgdt {

// A tetrahedron that was in a slot when it was found. A slot never gets a second tetrahedron with
// the same newest vertex.
struct BadTetrahedron {
    TetId slot;
    VertexId newest;
};

// Lists for the classes of bad tetrahedra. The next one is the last of the worst class.
class BadTetrahedra {
  public:
    explicit BadTetrahedra(Allocator& allocator)
        : classes_(allocator, Verdict::n_classes, &allocator) {}

    bool empty() const noexcept { return occupied_ == 0; }
    void add(const BadTetrahedron& t, unsigned of_class) {
        classes_[of_class].list.push_back(t);
        occupied_ |= std::uint64_t{1} << of_class;
    }
    BadTetrahedron take() noexcept {
        const unsigned worst = bit_width(occupied_) - 1;
        Buffer<BadTetrahedron>& list = classes_[worst].list;
        const BadTetrahedron t = list.back();
        list.pop_back();
        if (list.empty()) occupied_ &= ~(std::uint64_t{1} << worst);
        return t;
    }
    void clear() noexcept {
        for (Class& c : classes_) c.list.clear();
        occupied_ = 0;
    }

  private:
    struct Class {
        explicit Class(Allocator* allocator) : list(*allocator) {}
        Buffer<BadTetrahedron> list;
    };
    Objects<Class> classes_;
    std::uint64_t occupied_ = 0;  // a bit for each class that is not empty
};

}  // namespace mgdt
