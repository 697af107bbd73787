// SPDX-License-Identifier: MIT
//
// A church, in metres: walls, roofs and floor of a cruciform plan. The nave runs along x from the
// west front at x = 0; aisles on both sides, a transept, a crossing tower with a belfry and a
// spire, an apse in the east; portal, rose window, clerestory and aisle windows, arcades.
//
// docs/data/mesh.py makes church.msh from it.
SetFactory("OpenCASCADE");

wall = 1;

// The section of a house: walls to the height `eaves`, a gable roof to the height `ridge`,
// half as wide as `half`. Built in the plane x = from and extruded along x, then turned about the
// vertical axis through (cx, 0) by `turn`.
Macro House
  p = newp;
  Point(p) = {from, -half, floor};
  Point(p + 1) = {from, half, floor};
  Point(p + 2) = {from, half, eaves};
  Point(p + 3) = {from, 0, ridge};
  Point(p + 4) = {from, -half, eaves};
  l = newl;
  For i In {0 : 4}
    Line(l + i) = {p + i, p + (i + 1) % 5};
  EndFor
  c = newll;
  Curve Loop(c) = {l : l + 4};
  s = news;
  Plane Surface(s) = {c};
  house() = Extrude {to - from, 0, 0} { Surface{s}; };
  Rotate {{0, 0, 1}, {cx, 0, 0}, turn} { Volume{house(1)}; }
Return

// An arched opening of width 2 half from the height `floor` to the springing `eaves`, through
// everything between `from` and `to` along x, turned as a house is.
Macro Arch
  v = newv;
  Box(v) = {from, -half, floor, to - from, 2 * half, eaves - floor};
  Cylinder(v + 1) = {from, 0, eaves, to - from, 0, 0, half};
  Translate {0, shift, 0} { Volume{v, v + 1}; }
  Rotate {{0, 0, 1}, {cx, 0, 0}, turn} { Volume{v, v + 1}; }
  hollow() += {v, v + 1};
Return

cx = 36;  // the crossing
solid() = {};
hollow() = {};

// Nave and choir, outside and inside.
turn = 0;
shift = 0;
from = 0; to = 52; half = 6; floor = -wall; eaves = 14; ridge = 20;
Call House;
solid() += house(1);
from = wall; half = 6 - wall; floor = 0; eaves = 13.4; ridge = 18.4;
Call House;
hollow() += house(1);

// Transept: the same section across.
turn = Pi / 2;
from = cx - 17; to = cx + 17; half = 6; floor = -wall; eaves = 14; ridge = 20;
Call House;
solid() += house(1);
from = cx - 17 + wall; to = cx + 17 - wall; half = 6 - wall; floor = 0; eaves = 13.4; ridge = 18.4;
Call House;
hollow() += house(1);

// Aisles under lean-to roofs: the section of a low, wide house that the nave cuts in two.
turn = 0;
from = 2; to = 31; half = 11; floor = -wall; eaves = 6; ridge = 13;
Call House;
solid() += house(1);
from = 2 + wall; to = 31; half = 11 - wall; floor = 0; eaves = 5.6; ridge = 11.6;
Call House;
aisles = house(1);

// Apse, with a conical roof.
v = newv;
Cylinder(v) = {52, 0, -wall, 0, 0, 12 + wall, 6};
Cone(v + 1) = {52, 0, 12, 0, 0, 5, 6, 1};
solid() += {v, v + 1};
v = newv;
Cylinder(v) = {52, 0, 0, 0, 0, 11.4, 6 - wall};
hollow() += v;

// Tower over the crossing and its spire.
v = newv;
Box(v) = {cx - 6, -6, 12, 12, 12, 20};
Cone(v + 1) = {cx, 0, 32, 0, 0, 22, 5.6, 0.4};
solid() += {v, v + 1};
v = newv;
Box(v) = {cx - 5, -5, 12, 10, 10, 9};
Box(v + 1) = {cx - 5, -5, 22, 10, 10, 9};
Cone(v + 2) = {cx, 0, 32, 0, 0, 17, 4.7, 0.6};
hollow() += {v, v + 1, v + 2};

// Belfry: two arched openings in each face of the tower.
from = cx - 7; to = cx + 7; half = 1.1; floor = 24; eaves = 27.5;
For i In {0 : 1}
  turn = i * Pi / 2;
  For side In {-1 : 1 : 2}
    shift = 2.5 * side;
    Call Arch;
  EndFor
EndFor

// West front: portal and rose window. The ends of the transept have tall windows.
turn = 0;
shift = 0;
from = -1; to = 2; half = 1.6; floor = 0; eaves = 4;
Call Arch;
v = newv;
Cylinder(v) = {-1, 0, 11, 3, 0, 0, 2.2};
hollow() += v;
turn = Pi / 2;
from = cx - 18; to = cx + 18; half = 1.2; floor = 4; eaves = 9;
Call Arch;

// Windows of the apse, through its wall only.
from = 54; to = 60; half = 0.8; floor = 3; eaves = 7;
For i In {-1 : 1}
  cx = 52;
  turn = i * Pi / 3.5;
  Call Arch;
EndFor
cx = 36;

// Bays of the nave: clerestory windows, aisle windows, arcade piers. Each is one long arch
// across the church, at y turned into x.
For i In {0 : 4}
  turn = Pi / 2;
  shift = cx - 6 - 5 * i;  // a quarter turn about the crossing takes y = shift to x = cx - shift
  from = cx - 7; to = cx + 7; half = 0.7; floor = 10.8; eaves = 12.4;
  Call Arch;
  from = cx - 12; to = cx + 12; half = 0.8; floor = 2; eaves = 4;
  Call Arch;
  from = cx - 6.5; to = cx + 6.5; half = 1.8; floor = 0; eaves = 4;
  Call Arch;
EndFor

// The aisles' inside is cut out between the nave's walls and their own.
v = newv;
Box(v) = {0, -6, -2, 31, 12, 30};
beside() = BooleanDifference { Volume{aisles}; Delete; } { Volume{v}; Delete; };
hollow() += beside();

outside() = BooleanUnion { Volume{solid(0)}; Delete; } { Volume{solid(1) : solid(1)}; Delete; };
For i In {2 : #solid() - 1}
  outside() = BooleanUnion { Volume{outside()}; Delete; } { Volume{solid(i)}; Delete; };
EndFor
church() = BooleanDifference { Volume{outside()}; Delete; } { Volume{hollow()}; Delete; };

Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeFromCurvature = 12;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeMin = 0.45;
Mesh.MeshSizeMax = 1.15;
Mesh.Algorithm3D = 1;
Mesh.Optimize = 1;
Mesh.RandomSeed = 1;
Physical Volume("masonry") = {church()};
