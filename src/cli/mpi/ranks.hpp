// SPDX-License-Identifier: MIT
// The ranks of MPI that run the program together: what fails on one of them, fails on all.
#pragma once

#include <mpi.h>

#include <exception>

#include "cli/errors.hpp"

namespace mgdt::cli {

class Ranks {
  public:
    Ranks(int* argc, char*** argv) {
        int level = MPI_THREAD_SINGLE;
        MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &level);
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &count_);
    }
    ~Ranks() { MPI_Finalize(); }
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    int rank() const { return rank_; }
    int count() const { return count_; }
    bool is_first() const { return rank_ == 0; }

    // Does this on each rank. Where it fails on some, the exit code is the largest of theirs, and
    // one rank throws the failure of that code with its message.
    template <class Work>
    void together(const Work& work) {
        Outcome mine{exit_ok, rank_}, worst{};
        std::exception_ptr failure;
        try {
            work();
        } catch (...) {
            failure = std::current_exception();
            mine.code = report_exception(nullptr);
        }
        MPI_Allreduce(&mine, &worst, 1, MPI_2INT, MPI_MAXLOC, MPI_COMM_WORLD);
        if (worst.code == exit_ok) return;
        is_over_ = true;
        if (worst.rank == rank_) std::rethrow_exception(failure);
        throw Elsewhere{worst.code};
    }

    // On this rank nothing failed, or another one has the message.
    struct Elsewhere {
        int code;
    };

    // Whether all ranks know that one has failed, so that none waits for another.
    bool is_over() const { return is_over_; }

  private:
    struct Outcome {
        int code, rank;  // as MPI_2INT has them
    };
    int rank_ = 0, count_ = 1;
    bool is_over_ = false;
};

}  // namespace mgdt::cli
