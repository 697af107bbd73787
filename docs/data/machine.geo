// SPDX-License-Identifier: MIT
//
// A bearing bracket, in millimetres: a base plate with four counterbored bolt holes, a web and two
// ribs that carry a boss, the boss bored for a bushing, with an oil hole from above. The web's
// root is filleted.
//
// docs/data/mesh.py makes machine.msh from it.
SetFactory("OpenCASCADE");

thickness = 16;  // of the plate
axis = 82;       // height of the bore

// Base plate with rounded corners.
Rectangle(1) = {-85, -45, 0, 170, 90, 16};
Extrude {0, 0, thickness} { Surface{1}; }

// Boss along y, with a flat pad on top for the oil fitting.
Cylinder(2) = {0, -38, axis, 0, 76, 0, 35};
Cylinder(3) = {0, 0, axis, 0, 0, 42, 12};

// Web in the plane y = 0: from the plate, tapering to the boss.
Point(1001) = {-66, -9, thickness / 2};
Point(1002) = {66, -9, thickness / 2};
Point(1003) = {66, -9, thickness + 6};
Point(1004) = {33, -9, axis + 2};
Point(1005) = {-33, -9, axis + 2};
Point(1006) = {-66, -9, thickness + 6};
Line(1001) = {1001, 1002};
Line(1002) = {1002, 1003};
Line(1003) = {1003, 1004};
Line(1004) = {1004, 1005};
Line(1005) = {1005, 1006};
Line(1006) = {1006, 1001};
Curve Loop(1001) = {1001, 1002, 1003, 1004, 1005, 1006};
Plane Surface(1001) = {1001};
web[] = Extrude {0, 18, 0} { Surface{1001}; };

// Ribs in the plane x = 0, under the ends of the boss.
Point(3011) = {-7, -40, thickness / 2};
Point(3012) = {-7, 40, thickness / 2};
Point(3013) = {-7, 40, thickness + 4};
Point(3014) = {-7, 30, axis - 10};
Point(3015) = {-7, -30, axis - 10};
Point(3016) = {-7, -40, thickness + 4};
Line(3011) = {3011, 3012};
Line(3012) = {3012, 3013};
Line(3013) = {3013, 3014};
Line(3014) = {3014, 3015};
Line(3015) = {3015, 3016};
Line(3016) = {3016, 3011};
Curve Loop(3011) = {3011, 3012, 3013, 3014, 3015, 3016};
Plane Surface(3011) = {3011};
rib[] = Extrude {14, 0, 0} { Surface{3011}; };

solid() = BooleanUnion { Volume{1}; Delete; } { Volume{2, 3, web[1], rib[1]}; Delete; };

// Where the web meets the plate: four straight edges at y = +-9, filleted.
root() = Curve In BoundingBox {-67, -9.5, thickness - 0.5, 67, -8.5, thickness + 0.5};
root() += Curve In BoundingBox {-67, 8.5, thickness - 0.5, 67, 9.5, thickness + 0.5};
filleted() = Fillet { solid(0) }{ root() }{ 5 };

// Bore with a bushing seat at each end, oil hole, bolt holes with counterbores.
Cylinder(200) = {0, -60, axis, 0, 120, 0, 21};
Cylinder(201) = {0, -60, axis, 0, 30, 0, 26};
Cylinder(202) = {0, 30, axis, 0, 30, 0, 26};
Cylinder(203) = {0, 0, axis, 0, 0, 60, 3.5};
k = 210;
For sx In {-1 : 1 : 2}
  For sy In {-1 : 1 : 2}
    Cylinder(k) = {68 * sx, 28 * sy, -10, 0, 0, 60, 6.5};
    Cylinder(k + 1) = {68 * sx, 28 * sy, thickness - 5, 0, 0, 20, 10.5};
    k += 2;
  EndFor
EndFor
part() = BooleanDifference { Volume{filleted(0)}; Delete; }
                           { Volume{200 : 203, 210 : k - 1}; Delete; };

// Sizes: fine around the oil hole and in small radii, coarse in the plate.
Point(2000) = {0, 0, axis + 21};
Field[1] = Distance;
Field[1].PointsList = {2000};
Field[2] = Threshold;
Field[2].InField = 1;
Field[2].SizeMin = 1.6;
Field[2].SizeMax = 4.3;
Field[2].DistMin = 6;
Field[2].DistMax = 60;
Background Field = 2;
Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeFromCurvature = 14;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeMin = 1.2;
Mesh.MeshSizeMax = 4.3;
Mesh.Algorithm3D = 1;
Mesh.Optimize = 1;
Mesh.RandomSeed = 1;
Physical Volume("bracket") = {part()};
