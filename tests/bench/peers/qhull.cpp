// SPDX-License-Identifier: MIT
// Times Qhull with SciPy's options for a Delaunay triangulation.
extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "runner.hpp"

namespace {

long long count_tetrahedra(qhT* qh) {
    long long count = 0;
    facetT* facet;
    FORALLfacets {
        if (!facet->upperdelaunay) ++count;
    }
    return count;
}

void run() {
    std::vector<double> xyz = peer::read_points();
    qhT state;
    qhT* qh = &state;
    qh_zero(qh, stderr);
    char options[] = "qhull d Qbb Qc Qz Q12";
    int failure = 0;
    peer::measure(
        "2020.2",
        [&] {
            failure = qh_new_qhull(qh, 3, static_cast<int>(xyz.size() / 3), xyz.data(), False,
                                   options, nullptr, stderr);
        },
        [&] { return failure == 0 ? count_tetrahedra(qh) : 0; });
    if (failure == qh_ERRmem) throw std::bad_alloc();
    if (failure != 0) throw std::runtime_error("Qhull ends with error " + std::to_string(failure));
}

}  // namespace

int main() {
    return peer::guarded(run);
}
