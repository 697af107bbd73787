// SPDX-License-Identifier: MIT
// Meshes that are whole in themselves and yet not the Delaunay triangulation of their points: other
// triangulations, which flips lead to, parts missing, parts twice, space covered twice. Each must
// be refused at the level that promises it, and at no lower one.
#include <set>

#include "exact_reference.hpp"
#include "predicates/predicates.hpp"
#include "surgery.hpp"

namespace mgdt {
namespace {

using namespace surgery;

struct Facet {
    TetId t, m;     // on its two sides
    unsigned f, g;  // its number in each
    VertexId v[3];  // its vertices, seen from t: outer_face
    VertexId d, e;  // beyond it in t, in m
};

std::vector<Facet> inner_facets(Patient& p) {
    std::vector<Facet> all;
    const Mesh& mesh = p.mesh();
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
        const Tetrahedron& a = mesh.tetrahedra[t];
        if (a.is_dead() || a.is_ghost()) continue;
        for (unsigned f = 0; f < 4; ++f) {
            const TetId m = a.n[f] >> 2;
            const Tetrahedron& b = mesh.tetrahedra[m];
            if (m < t || b.is_ghost()) continue;
            const unsigned char* face = outer_face[f];
            all.push_back({t,
                           m,
                           f,
                           a.n[f] & 3,
                           {a.v[face[0]], a.v[face[1]], a.v[face[2]]},
                           a.v[f],
                           b.v[a.n[f] & 3]});
        }
    }
    return all;
}

bool has(const Quad& q, VertexId v) {
    return std::find(q.begin(), q.end(), v) != q.end();
}

// The tetrahedra that have both vertices.
std::vector<Quad> around(const std::vector<Quad>& quads, VertexId a, VertexId b) {
    std::vector<Quad> ring;
    for (const Quad& q : quads)
        if (has(q, a) && has(q, b)) ring.push_back(q);
    return ring;
}

void replace(std::vector<Quad>& quads, const std::vector<Quad>& old, const std::vector<Quad>& by) {
    for (const Quad& q : old) quads.erase(std::find(quads.begin(), quads.end(), q));
    quads.insert(quads.end(), by.begin(), by.end());
}

class Places {
  public:
    explicit Places(Patient& p) : mesh_(p.mesh()) {}
    int side(VertexId a, VertexId b, VertexId c, VertexId d) const {
        return orientation(mesh_.point(a), mesh_.point(b), mesh_.point(c), mesh_.point(d));
    }
    Quad turned(VertexId a, VertexId b, VertexId c, VertexId d) const {
        return side(a, b, c, d) > 0 ? Quad{a, b, c, d} : Quad{a, b, d, c};
    }
    // Of e with respect to the sphere of the tetrahedron.
    int in_sphere(const Quad& q, VertexId e) const {
        const auto point = [&](VertexId v) {
            const double* x = mesh_.point(v);
            return reference::Point{x[0], x[1], x[2]};
        };
        return reference::side_of_sphere(point(q[0]), point(q[1]), point(q[2]), point(q[3]),
                                         point(e));
    }

  private:
    const Mesh& mesh_;
};

// Two tetrahedra that share facet abc become three around de, if de passes through abc.
bool flip_2_3(const Places& at, const Facet& x, std::vector<Quad>& quads) {
    const VertexId a = x.v[0], b = x.v[1], c = x.v[2];
    const int s = at.side(x.d, x.e, a, b);
    if (s == 0 || at.side(x.d, x.e, b, c) != s || at.side(x.d, x.e, c, a) != s) return false;
    std::vector<Quad> old;
    for (const Quad& q : quads)
        if (has(q, a) && has(q, b) && has(q, c)) old.push_back(q);
    replace(quads, old,
            {at.turned(x.d, x.e, a, b), at.turned(x.d, x.e, b, c), at.turned(x.d, x.e, c, a)});
    return old.size() == 2;
}

// The other way: an edge de with three tetrahedra around it, if abc separates its ends.
bool flip_3_2(const Places& at, VertexId d, VertexId e, std::vector<Quad>& quads) {
    const std::vector<Quad> ring = around(quads, d, e);
    std::set<VertexId> others;
    for (const Quad& q : ring) others.insert(q.begin(), q.end());
    others.erase(d);
    others.erase(e);
    if (ring.size() != 3 || others.size() != 3) return false;
    const std::vector<VertexId> o(others.begin(), others.end());
    if (at.side(o[0], o[1], o[2], d) * at.side(o[0], o[1], o[2], e) >= 0) return false;
    replace(quads, ring, {at.turned(o[0], o[1], o[2], d), at.turned(o[0], o[1], o[2], e)});
    return true;
}

// An edge ab with c, d, e, f around it, of which c and e lie in a plane with it, gives way to ce.
bool flip_4_4(const Places& at, VertexId a, VertexId b, std::vector<Quad>& quads) {
    const std::vector<Quad> ring = around(quads, a, b);
    std::set<VertexId> others;
    for (const Quad& q : ring) others.insert(q.begin(), q.end());
    others.erase(a);
    others.erase(b);
    if (ring.size() != 4 || others.size() != 4) return false;
    for (const VertexId c : others)
        for (const VertexId e : others) {
            const bool together = std::any_of(
                ring.begin(), ring.end(), [&](const Quad& q) { return has(q, c) && has(q, e); });
            if (c >= e || together || at.side(a, b, c, e) != 0) continue;
            std::vector<VertexId> sides;
            for (const VertexId v : others)
                if (v != c && v != e) sides.push_back(v);
            const VertexId d = sides[0], f = sides[1];
            if (at.side(c, e, d, a) * at.side(c, e, d, b) >= 0 ||
                at.side(c, e, f, a) * at.side(c, e, f, b) >= 0 ||
                at.side(a, b, c, d) * at.side(a, b, c, f) >= 0)
                continue;
            replace(quads, ring,
                    {at.turned(c, e, d, a), at.turned(c, e, d, b), at.turned(c, e, f, a),
                     at.turned(c, e, f, b)});
            return true;
        }
    return false;
}

// Whether some vertex is strictly inside the sphere of a tetrahedron, by trying all.
bool is_delaunay(const Places& at, const std::vector<Quad>& quads, std::size_t vertices) {
    for (const Quad& q : quads)
        for (VertexId v = 1; v < vertices; ++v)
            if (!has(q, v) && at.in_sphere(q, v) > 0) return false;
    return true;
}

struct Count {
    int not_delaunay = 0, other_ties = 0;
};

// After any flip the mesh is whole, so that the level that refuses it is known: 2 if some vertex is
// inside a sphere, 3 if it is only not the canonical one.
void expect_refusal(Patient& p, const std::vector<Quad>& quads, Count& count, const char* what) {
    const bool delaunay = is_delaunay(Places(p), quads, p.mesh().vertices.size());
    p.assemble(quads);
    EXPECT_EQ(p.complaint(1), "") << what;
    if (delaunay) {
        ++count.other_ties;
        EXPECT_EQ(p.complaint(2), "") << what;
        EXPECT_NE(p.complaint(3).find("tie is not broken canonically"), std::string::npos)
            << what << ": " << p.complaint(3);
    } else {
        ++count.not_delaunay;
        EXPECT_NE(p.complaint(2).find("inside its circumsphere"), std::string::npos)
            << what << ": " << p.complaint(2);
        EXPECT_NE(p.complaint(3), "") << what;
    }
}

// `flip` is tried at every facet and edge of fresh triangulations, in random order, until some of
// each kind succeed.
template <class Flip>
Count flip_all(const std::vector<Points>& sets, Random& random, const char* what, Flip flip) {
    Count count;
    for (const Points& xyz : sets) {
        Patient p = triangulate(xyz);
        const std::vector<Quad> sound = p.finite();
        std::vector<Facet> facets = inner_facets(p);
        std::shuffle(facets.begin(), facets.end(), random);
        int left = is_small() ? 2 : 6;
        for (const Facet& x : facets) {
            std::vector<Quad> quads = sound;
            if (!flip(Places(p), x, quads)) continue;
            expect_refusal(p, quads, count, what);
            if (--left == 0) break;
        }
    }
    return count;
}

std::vector<Points> sets_to_flip(Random& random) {
    Points octahedra;  // of lattice points of one parity: 4-4 flips keep the spheres
    for (int x = 0; x < 4; ++x)
        for (int y = 0; y < 4; ++y)
            for (int z = 0; z < 4; ++z)
                if ((x + y + z) % 2 == 0)
                    octahedra.insert(octahedra.end(), {1.0 * x, 1.0 * y, 1.0 * z});
    std::vector<std::array<int, 3>> of_length;
    for (int x = -31; x <= 31; ++x)
        for (int y = -31; y <= 31; ++y)
            for (int z = -31; z <= 31; ++z)
                if (x * x + y * y + z * z == 1001) of_length.push_back({x, y, z});
    std::shuffle(of_length.begin(), of_length.end(), random);
    Points sphere;  // few of its points share a plane, and any flip keeps the sphere
    for (std::size_t i = 0; i < 30; ++i)
        for (const int x : of_length[i]) sphere.push_back(x);
    return {uniform_points(40, random), lattice(3), octahedra, sphere};
}

TEST(Flips, TwoForThree) {
    Random random(1);
    const Count count = flip_all(
        sets_to_flip(random), random, "2-3",
        [](const Places& at, const Facet& x, std::vector<Quad>& q) { return flip_2_3(at, x, q); });
    EXPECT_GT(count.not_delaunay, 0);
    EXPECT_GT(count.other_ties, 0);
}

TEST(Flips, ThreeForTwo) {
    Random random(2);
    const Count count = flip_all(sets_to_flip(random), random, "3-2",
                                 [](const Places& at, const Facet& x, std::vector<Quad>& q) {
                                     for (int i = 0; i < 3; ++i)
                                         if (flip_3_2(at, x.v[i], x.v[(i + 1) % 3], q)) return true;
                                     return false;
                                 });
    EXPECT_GT(count.not_delaunay, 0);
    EXPECT_GT(count.other_ties, 0);
}

TEST(Flips, FourForFour) {
    Random random(3);
    const Count count = flip_all(sets_to_flip(random), random, "4-4",
                                 [](const Places& at, const Facet& x, std::vector<Quad>& q) {
                                     for (int i = 0; i < 3; ++i)
                                         if (flip_4_4(at, x.v[i], x.v[(i + 1) % 3], q)) return true;
                                     return false;
                                 });
    EXPECT_GT(count.other_ties, 0);
}

// ------------------------------------------------------------------ missing, doubled, overlapping

int hull_facets_of(const Patient& p, const Tetrahedron& t) {
    int n = 0;
    for (const FacetCode c : t.n) n += p.t->mesh().tetrahedra[c >> 2].is_ghost();
    return n;
}

TEST(Surgery, RemovedTetrahedra) {
    Random random(4);
    int inner = 0, outer = 0;
    for (const Points& xyz : {uniform_points(40, random), lattice(3)})
        for (int round = 0; round < (is_small() ? 4 : 40); ++round) {
            Patient p = triangulate(xyz);
            std::vector<Quad> quads = p.finite();
            const Tetrahedron gone = p.mesh().tetrahedra[p.any(random, false)];
            replace(quads, {{gone.v[0], gone.v[1], gone.v[2], gone.v[3]}}, {});
            bool touches_hull = false;
            for (const VertexId v : p.hull())
                touches_hull |= std::find(gone.v, gone.v + 4, v) != gone.v + 4;
            const int facets = hull_facets_of(p, gone);
            p.assemble(quads);
            EXPECT_NE(p.complaint(3), "");
            if (!touches_hull) {
                // A bubble: what is around infinity falls apart.
                ++inner;
                EXPECT_NE(p.complaint(1).find("Euler"), std::string::npos) << p.complaint(1);
            } else if (facets == 1) {
                // A dent, of a sound complex if the fourth vertex was inside.
                ++outer;
            }
        }
    EXPECT_GT(inner, 0);
    EXPECT_GT(outer, 0);
}

TEST(Surgery, DentedHull) {
    Random random(5);
    int dents = 0;
    for (int round = 0; round < 60 && dents < 10; ++round) {
        Patient p = triangulate(uniform_points(40, random));
        const std::set<VertexId> on_hull = p.hull();
        std::vector<Quad> quads = p.finite();
        const Tetrahedron t = p.mesh().tetrahedra[p.any(random, false)];
        if (hull_facets_of(p, t) != 1) continue;
        int inside = 0;
        for (const VertexId v : t.v) inside += on_hull.count(v) == 0;
        if (inside != 1) continue;
        replace(quads, {{t.v[0], t.v[1], t.v[2], t.v[3]}}, {});
        p.assemble(quads);
        EXPECT_EQ(p.complaint(2), "");
        const std::string found = p.complaint(3);
        EXPECT_TRUE(found.find("not convex") != std::string::npos ||
                    found.find("seen from outside") != std::string::npos)
            << found;
        ++dents;
    }
    EXPECT_GT(dents, 0);
}

TEST(Surgery, DoubledTetrahedron) {
    Random random(6);
    for (int round = 0; round < 20; ++round) {
        Patient p = triangulate(uniform_points(40, random));
        std::vector<Quad> quads = p.finite();
        quads.push_back(quads[below(random, quads.size())]);
        p.assemble(quads);
        // Connected or not: its ghosts may have joined those of the hull.
        for (int level = 1; level <= 3; ++level) {
            const std::string found = p.complaint(level);
            EXPECT_TRUE(found.find("not connected") != std::string::npos ||
                        found.find("Euler") != std::string::npos)
                << found;
        }
    }
}

TEST(Surgery, TwoTriangulations) {
    Random random(7);
    // Apart, and one inside the other.
    for (const double shift : {10.0, 0.0}) {
        Points xyz = uniform_points(20, random), more = uniform_points(20, random);
        for (double& x : more) x = shift + (shift == 0 ? 0.5 + 0.01 * x : x);
        const std::vector<Quad> first = triangulate(xyz).finite();
        std::vector<Quad> second = triangulate(more).finite();
        xyz.insert(xyz.end(), more.begin(), more.end());
        Patient p = triangulate(xyz);
        // Vertices by index: the k-th point has number k + 1 in all three.
        const auto number = [](Patient& of, const std::vector<Quad>& quads, std::uint32_t offset) {
            std::vector<Quad> out;
            for (const Quad& q : quads) {
                Quad r;
                for (std::size_t i = 0; i < 4; ++i) r[i] = of.mesh().vertices[q[i]].index + offset;
                out.push_back(r);
            }
            return out;
        };
        Patient a = triangulate(Points(xyz.begin(), xyz.begin() + 60)), b = triangulate(more);
        std::vector<Quad> quads = number(a, first, 0), others = number(b, second, 20);
        quads.insert(quads.end(), others.begin(), others.end());
        for (Quad& q : quads)
            for (VertexId& v : q) v = p.map()[v];
        p.assemble(quads);
        for (int level = 1; level <= 3; ++level)
            EXPECT_NE(p.complaint(level).find("not connected"), std::string::npos) << level;
    }
}

// Tetrahedra around an axis, ten of them, each a fifth of the way round: the axis is encircled
// twice. Every tetrahedron is positive, every facet is locally Delaunay, every edge of the hull
// convex, every link a sphere: no test that looks at neighbours alone can tell.
TEST(Surgery, SpaceCoveredTwice) {
    const auto covered = [](double outer) {
        Points xyz = {0, 0, 0.25, 0, 0, -0.25};
        for (int i = 0; i < 10; ++i) {
            const double angle = 4 * 3.14159265358979 * i / 10, radius = i < 5 ? 1 : outer;
            xyz.insert(xyz.end(), {radius * std::cos(angle), radius * std::sin(angle), 0});
        }
        Patient p = triangulate(xyz);
        std::vector<Quad> quads;
        for (std::uint32_t i = 0; i < 10; ++i)
            quads.push_back(Places(p).turned(p.map()[0], p.map()[1], p.map()[2 + i],
                                             p.map()[2 + (i + 1) % 10]));
        p.assemble(quads);
        return p;
    };
    Patient p = covered(1.001);
    EXPECT_EQ(p.complaint(1), "");
    EXPECT_EQ(p.complaint(2), "");
    EXPECT_NE(p.complaint(3).find("seen from outside"), std::string::npos) << p.complaint(3);
    // The second round laid exactly on the first.
    for (std::size_t i = 0; i < 5; ++i)
        std::copy_n(p.mesh().point(p.map()[2 + i]), 3, p.mesh().vertices[p.map()[7 + i]].x);
    p.set_spheres();
    p.set_exponents();
    EXPECT_EQ(p.complaint(1), "");
    EXPECT_EQ(p.complaint(2), "");
    EXPECT_NE(p.complaint(3).find("overlaps"), std::string::npos) << p.complaint(3);
}

// Everything turned inside out: whole, but negative throughout.
TEST(Surgery, MirroredOrientation) {
    Random random(8);
    Patient p = triangulate(uniform_points(40, random));
    std::vector<Quad> quads = p.finite();
    for (Quad& q : quads) std::swap(q[0], q[1]);
    p.assemble(quads);
    EXPECT_EQ(p.complaint(1), "");
    EXPECT_NE(p.complaint(2).find("not positively oriented"), std::string::npos);
}

// ------------------------------------------------------------------------------- vertices moved

// A step of one ulp, where many points are on one sphere: refused exactly if some vertex is then
// inside a sphere, by level 2, or a tie is broken otherwise, by level 3.
TEST(Surgery, VertexMovedByOneUlp) {
    Random random(9);
    int refused = 0, kept = 0;
    for (int round = 0; round < 60; ++round) {
        Patient p = triangulate(lattice(3));
        Mesh& m = p.mesh();
        double& x = m.vertices[p.any_vertex(random)].x[below(random, 3)];
        if (x == 0) continue;  // the least subnormal would be another scale
        x = std::nextafter(x, below(random, 2) ? 1e300 : -1e300);
        p.set_spheres();
        p.set_exponents();
        const Places at(p);
        const std::vector<Quad> quads = p.finite();
        const bool positive = std::all_of(quads.begin(), quads.end(), [&](const Quad& q) {
            return at.side(q[0], q[1], q[2], q[3]) > 0;
        });
        const bool delaunay = positive && is_delaunay(at, quads, m.vertices.size());
        EXPECT_EQ(p.complaint(1), "");
        EXPECT_EQ(p.complaint(2).empty(), delaunay) << p.complaint(2);
        ++(delaunay ? kept : refused);
    }
    EXPECT_GT(refused, 0);
    EXPECT_GT(kept, 0);
}

// Little enough to stay Delaunay is no defect at any level, if the spheres follow.
TEST(Surgery, VertexMovedALittle) {
    Random random(10);
    for (int round = 0; round < 20; ++round) {
        Patient p = triangulate(uniform_points(40, random));
        double& x = p.mesh().vertices[p.any_vertex(random)].x[below(random, 3)];
        const double before = x;
        // A multiple of the same last bit.
        x += std::ldexp(static_cast<double>(1 + below(random, 8)), -53);
        EXPECT_EQ(std::ilogb(x), std::ilogb(before));
        p.set_spheres();
        p.set_exponents();
        for (int level = 1; level <= 3; ++level) EXPECT_EQ(p.complaint(level), "");
    }
}

}  // namespace
}  // namespace mgdt
