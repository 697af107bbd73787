# SPDX-License-Identifier: MIT
"""What no test takes of src/kernel and src/predicates, and why: file, text, outcomes, reason.

The text is a condition as it stands in the source, with `true` or `false` for its outcome, or all
of a line, with `line`. With `sometimes`, tests take it by chance; what is without must not be taken,
and what is here must be in the source.
"""

NOT_COVERED = [
    ("src/query/location_tree.cpp", "!reach(root_)", "true",
     "The root is in the tree itself and private: the constructor makes it, and nothing is reached before it."),
    ("src/kernel/select.cpp", "cpu.avx512", "true false sometimes",
     "The other one is a processor's of another kind."),
    ("src/kernel/select.cpp", "cpu.avx2", "true false sometimes",
     "The other one is a processor's of another kind."),
    ("src/kernel/select.cpp", "kernel", "false sometimes",
     "Only a processor without AVX-512 lacks a kernel."),
    ("src/kernel/thread_state.cpp", "!next_.compare_exchange_weak(begin, begin + static_cast<TetId>(size), "
     "std::memory_order_relaxed)", "true sometimes",
     "Two threads take slots within some nanoseconds."),
    ("src/kernel/thread_state.hpp", "try_own(t.v[0])", "false sometimes",
     "Another thread has the block of a tetrahedron that was this one's a moment ago."),
    ("src/kernel/thread_state.hpp", "try_own(t.v[1])", "false sometimes", "As above."),
    ("src/hole/filling.cpp", "!f.is_closed", "true",
     "docs/theory.md proves that each hole is filled."),
    ("src/hole/filling.cpp", "fail(MGDT_ERR_INTERNAL, \"a hole cannot be filled; please report it\");", "line",
     "As above."),
    ("src/hole/filling.cpp", "element.v[face] == no_index", "true", "As above."),
    ("src/hole/filling.cpp", "fail(MGDT_ERR_INTERNAL, \"a hole leads out of the hull; please report it\");",
     "line", "As above."),
    ("src/kernel/walk.hpp", "access.try_own(tetrahedra[ghost])", "false sometimes",
     "Another thread has the block of a tetrahedron that was this one's a moment ago."),
    ("src/kernel/walk.hpp", "access.try_own(tetrahedra[t])", "false sometimes", "As above."),
    ("src/predicates/interior_point.hpp", "for (const double* v : v_)", "false",
     "One of four vertices that span space, as those given have to, is off any plane."),
    ("src/predicates/interior_point.hpp", "return 0;", "line", "As above."),
    ("src/predicates/perturbation.cpp", "return undecided;", "line",
     "Compilers without integers of 128 bits come here."),
]
