// SPDX-License-Identifier: MIT
// Times TetGen: its switches' default, the Delaunay tetrahedralization of points, which sorts them
// along a Hilbert curve in rounds.
#include <tetgen.h>

#include "runner.hpp"

namespace {

const char* meaning(int thrown) {
    switch (thrown) {
        case 1:
            return "out of memory";
        case 2:
            return "a defect of its own";
        case 3:
            return "facets that meet";
        case 4:
            return "a feature too small";
        case 5:
            return "facets too near";
        case 10:
            return "an input that it refuses";
        default:
            return "not documented";
    }
}

void run() {
    std::vector<double> xyz = peer::read_points();
    tetgenio in, out;
    in.numberofpoints = static_cast<int>(xyz.size() / 3);
    in.pointlist = xyz.data();
    tetgenbehavior behavior;
    char switches[] = "Qn";  // quiet, with neighbours
    behavior.parse_commandline(switches);
    try {
        peer::measure(
            "1.5", [&] { tetrahedralize(&behavior, &in, &out); },
            [&] { return out.numberoftetrahedra; });
    } catch (int thrown) {
        in.pointlist = nullptr;
        if (thrown == 1) throw std::bad_alloc();
        throw std::runtime_error("TetGen threw " + std::to_string(thrown) + ": " + meaning(thrown));
    }
    in.pointlist = nullptr;  // the vector's
}

}  // namespace

int main() {
    return peer::guarded(run);
}
