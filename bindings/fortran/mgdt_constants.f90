! SPDX-License-Identifier: MIT
! Generated from mgdt/mgdt.h, mgdt_voronoi.h, mgdt_mesh.h, mgdt_domain.h, mgdt_periodic.h by bindings/interface/generate.py.
!
! The constants of mgdt's C interface, in the default integer of the flags in force. Comments are
! those of the header; stat= has the values of a status.
module mgdt_constants
    implicit none
    public

    ! Error codes.
    ! Success.
    integer, parameter :: mgdt_ok = 0
    ! A pointer that must not be NULL is NULL.
    integer, parameter :: mgdt_err_null_pointer = 10
    ! A value is out of its documented range.
    integer, parameter :: mgdt_err_invalid_argument = 11
    ! A coordinate is NaN or infinite.
    integer, parameter :: mgdt_err_not_finite = 12
    ! No MGDT_ORDER_ value, or no name of one.
    integer, parameter :: mgdt_err_unknown_scheme = 13
    ! There is no such key of what is asked for: a statistic, a parameter, an option, an array or a
    ! measure.
    integer, parameter :: mgdt_err_unknown_key = 14
    ! A result is asked for before the call that makes it, or after a change that has removed it.
    ! Nothing is written. Since 1.3.
    integer, parameter :: mgdt_err_not_built = 15
    ! The capacity is less than what must be written.
    integer, parameter :: mgdt_err_buffer_too_small = 20
    ! An index does not fit a 32-bit integer.
    integer, parameter :: mgdt_err_index_range = 21
    ! The allocator or the memory limit refused.
    integer, parameter :: mgdt_err_out_of_memory = 30
    ! More points or tetrahedra than can be numbered.
    integer, parameter :: mgdt_err_too_large = 31
    ! mgdt_cancel() or the progress callback asked to stop.
    integer, parameter :: mgdt_err_cancelled = 40
    ! Another call is running on the handle: a callback called its own handle, or two threads broke
    ! the thread rule. Every function that takes a handle may return it, except mgdt_cancel() and
    ! mgdt_get_error(). Since 1.2.
    integer, parameter :: mgdt_err_busy = 41
    ! A function of an mgdt_transport reported a failure. Since 1.2.
    integer, parameter :: mgdt_err_transport = 50
    ! A check, such as mgdt_check(), found a defect.
    integer, parameter :: mgdt_err_check_failed = 60
    ! Facets, segments or points of a domain cross or touch where they must not, or are flat. Since
    ! 1.3.
    integer, parameter :: mgdt_err_invalid_boundary = 70
    ! The mesh of a domain needs points nearer to each other than double precision allows, or so
    ! many on its segments that the build gives up. Since 1.3.
    integer, parameter :: mgdt_err_resolution = 71
    ! The facets of a domain enclose nothing. Since 1.3.
    integer, parameter :: mgdt_err_open_boundary = 72
    ! A defect of mgdt itself; please report it.
    integer, parameter :: mgdt_err_internal = 90

    ! Order schemes.
    ! Multi-grid with its defaults; the default.
    integer, parameter :: mgdt_order_auto = 0
    ! As given (2.1).
    integer, parameter :: mgdt_order_input = 10
    ! Shuffled (2.1).
    integer, parameter :: mgdt_order_random = 20
    ! By x, then y, then z (2.1).
    integer, parameter :: mgdt_order_lexicographic = 30
    ! Random rounds of growing size, each along a curve (2.2).
    integer, parameter :: mgdt_order_brio = 40
    ! Along a Hilbert curve (2.3).
    integer, parameter :: mgdt_order_hilbert = 50
    ! Along a path through a regular grid (4.1).
    integer, parameter :: mgdt_order_regular_grid = 60
    ! Squarish kd-tree, cell-pivot-cell (3).
    integer, parameter :: mgdt_order_kd_tree = 70
    ! A kd-tree with a regular grid in each cell (3.4).
    integer, parameter :: mgdt_order_enhanced_kd_tree = 80
    ! Regular grids within the cells of grids (4.2).
    integer, parameter :: mgdt_order_multi_grid = 90

    ! Parameters.
    ! Mean number of points in a cell. Default 8 (grids), 10 (kd-tree), 1000 (cells of the enhanced
    ! kd-tree; its inner grids use 8). Range 1 to 1e6; 0 restores the default. With
    ! MGDT_SEPARATION_ROUNDS, which is its default, multi-grid ignores this value and makes its
    ! cells as small as its sort keys can number.
    integer, parameter :: mgdt_parameter_points_per_cell = 10
    ! Multi-grid: a cell with more points than this gets a grid of its own. Default 8, or 200
    ! without MGDT_SEPARATION_ROUNDS; range 1 to 1e9; 0 restores the default.
    integer, parameter :: mgdt_parameter_threshold = 20
    ! Regular grid and multi-grid: an MGDT_SEPARATION_ value, which says how the points of one cell
    ! are kept apart in the order. The default is MGDT_SEPARATION_ROUNDS, with which multi-grid
    ! follows a Hilbert curve.
    integer, parameter :: mgdt_parameter_separation = 30
    ! BRIO: each round holds this many times the points of all rounds before it, plus one. Default
    ! 7.5, range above 1 to 1e6; 0 restores the default.
    integer, parameter :: mgdt_parameter_round_ratio = 40

    ! Values of MGPSEP.
    ! All points of a cell come before those of the next cell.
    integer, parameter :: mgdt_separation_none = 0
    ! Each pass takes one point of each cell (4.3).
    integer, parameter :: mgdt_separation_passes = 1
    ! The points along the path are divided into rounds. One of each 12 consecutive points goes to
    ! an earlier round, whose points are divided in the same way, and so on. If at most 4,096 points
    ! are divided, one of each 4 goes to an earlier round.
    integer, parameter :: mgdt_separation_rounds = 2

    ! Figures.
    ! Points that became vertices.
    integer, parameter :: mgdt_stat_points_inserted = 10
    ! Points equal to an earlier vertex.
    integer, parameter :: mgdt_stat_duplicates = 11
    ! Points removed. Since 1.2.
    integer, parameter :: mgdt_stat_points_removed = 12
    ! Points moved to other coordinates. Since 1.2.
    integer, parameter :: mgdt_stat_points_moved = 13
    ! Moves that inserted the point anew. Since 1.2.
    integer, parameter :: mgdt_stat_put_back = 14
    ! Removals and moves that rebuilt all. Since 1.2.
    integer, parameter :: mgdt_stat_rebuilds = 15
    ! Tetrahedra visited by walks (the paper's NP, summed).
    integer, parameter :: mgdt_stat_walk_steps = 20
    ! Circumspheres evaluated by walks.
    integer, parameter :: mgdt_stat_walk_tests = 21
    ! Circumspheres evaluated while cavities grew.
    integer, parameter :: mgdt_stat_conflict_tests = 22
    ! Tetrahedra removed by insertions (NR, summed).
    integer, parameter :: mgdt_stat_tetrahedra_removed = 30
    ! Tetrahedra created by insertions.
    integer, parameter :: mgdt_stat_tetrahedra_created = 31
    ! Neighbours of the vertices that removals and moves took out, summed. Since 1.2.
    integer, parameter :: mgdt_stat_link_vertices = 32
    ! Decisions that the floating-point filter left open.
    integer, parameter :: mgdt_stat_exact_calls = 40
    ! Insertions that met another thread and were tried again.
    integer, parameter :: mgdt_stat_put_off = 45
    ! Points inserted while other threads had no work.
    integer, parameter :: mgdt_stat_inserted_alone = 46
    ! Time spent ordering more than 16 points.
    integer, parameter :: mgdt_stat_order_seconds = 50
    ! Time spent inserting, rebuilds included.
    integer, parameter :: mgdt_stat_insert_seconds = 51
    ! Time spent in mgdt_remove_points(). Since 1.2.
    integer, parameter :: mgdt_stat_remove_seconds = 52
    ! Time spent in mgdt_move_points(). Since 1.2.
    integer, parameter :: mgdt_stat_move_seconds = 53
    ! Deepest level of grids or trees in the last schedule.
    integer, parameter :: mgdt_stat_grid_levels = 60
    ! Rounds in the last schedule.
    integer, parameter :: mgdt_stat_rounds = 61
    ! Threads of the last insertion.
    integer, parameter :: mgdt_stat_threads = 62
    ! Memory that the handle holds.
    integer, parameter :: mgdt_stat_memory_bytes = 70
    ! The most memory that it has held.
    integer, parameter :: mgdt_stat_peak_memory_bytes = 71

    ! Levels.
    ! Adjacency, shared facets, Euler's formula, all points.
    integer, parameter :: mgdt_check_combinatorial = 1
    ! Positive orientation and the Delaunay property, exactly.
    integer, parameter :: mgdt_check_geometric = 2
    ! Convex hull, and ties broken by the perturbation.
    integer, parameter :: mgdt_check_canonical = 3

    ! Measures.
    ! Volume of the cell.
    integer, parameter :: mgdt_measure_volume = 10
    ! Area of the cell's surface.
    integer, parameter :: mgdt_measure_area = 20
    ! The cell's centre of mass, 3 numbers.
    integer, parameter :: mgdt_measure_centroid = 30
    ! Number of the cell's faces that have an area.
    integer, parameter :: mgdt_measure_faces = 40

    ! Measures of tetrahedra.
    ! Volume of the tetrahedron.
    integer, parameter :: mgdt_tetrahedron_volume = 10
    ! 3 times the radius of the inscribed sphere over that of the circumsphere: 1 for a regular
    ! tetrahedron, near 0 for a flat one.
    integer, parameter :: mgdt_tetrahedron_radius_ratio = 20
    ! 6 sqrt(2) times the volume over the third power of the root mean square of the six edges: 1
    ! for a regular tetrahedron, near 0 for a flat one (Parthasarathy, Graichen and Hathaway, Finite
    ! Elements in Analysis and Design 15, 1994). Since 1.4.
    integer, parameter :: mgdt_tetrahedron_volume_length = 21
    ! Length of the longest edge over that of the shortest one, at least 1. Since 1.4.
    integer, parameter :: mgdt_tetrahedron_edge_ratio = 22
    ! Least of the six dihedral angles.
    integer, parameter :: mgdt_tetrahedron_least_dihedral_angle = 30
    ! Largest of the six dihedral angles.
    integer, parameter :: mgdt_tetrahedron_largest_dihedral_angle = 31
    ! Length of the longest edge.
    integer, parameter :: mgdt_tetrahedron_longest_edge = 40

    ! Methods.
    ! Linear in each tetrahedron; continuous.
    integer, parameter :: mgdt_interpolate_linear = 10
    ! The value of the nearest vertex.
    integer, parameter :: mgdt_interpolate_nearest = 20
    ! By natural neighbours. The weight of a neighbour is the volume that a new point would take
    ! from its Voronoi cell. Smooth except at the points.
    integer, parameter :: mgdt_interpolate_sibson = 30
    ! By natural neighbours. The weight of a neighbour is the area of the face that the two cells
    ! would share, divided by the distance.
    integer, parameter :: mgdt_interpolate_laplace = 40
    ! Sibson's method with the gradients of mgdt_get_gradients(). Smooth at the points too.
    integer, parameter :: mgdt_interpolate_sibson_c1 = 50

    ! What is outside.
    ! There is no value: NaN, and no weights.
    integer, parameter :: mgdt_outside_none = 10
    ! The value of the nearest vertex.
    integer, parameter :: mgdt_outside_nearest = 20
    ! The value at the nearest point of the hull, linear in the hull facet.
    integer, parameter :: mgdt_outside_boundary = 30
    ! The value of MGDT_OUTSIDE_BOUNDARY, continued linearly. The gradient is the mean of those of
    ! mgdt_get_gradients() at the corners of the hull facet.
    integer, parameter :: mgdt_outside_linear = 40

    ! Numbers of a Voronoi diagram.
    ! Vertices.
    integer, parameter :: mgdt_voronoi_stat_vertices = 100
    ! Rays.
    integer, parameter :: mgdt_voronoi_stat_rays = 101
    ! Faces, without those that were dropped.
    integer, parameter :: mgdt_voronoi_stat_faces = 102
    ! Points that were inserted: the arrays of cells have a row for each.
    integer, parameter :: mgdt_voronoi_stat_points = 103
    ! Memory that the handle holds.
    integer, parameter :: mgdt_voronoi_stat_memory_bytes = 110

    ! Arrays of a Voronoi diagram.
    ! Offsets of the faces' lists of corners.
    integer, parameter :: mgdt_voronoi_array_face_offsets = 200
    ! The corners of each face, counter-clockwise about its normal. A corner that is at least the
    ! index base is a vertex. A negative one is a ray: ray k, counted from 0, is -1 - k. The two
    ! rays of an unbounded face come last: first the ray from the last vertex, then the ray from the
    ! first one.
    integer, parameter :: mgdt_voronoi_array_face_corners = 201
    ! Two elements for each face: the lesser index of the two points that the face separates, then
    ! the other one. A face in a plane of the region has the index of the point, then -1 - k for
    ! plane k, counted from 0.
    integer, parameter :: mgdt_voronoi_array_face_sides = 202
    ! Three elements for each face of a diagram of mgdt_periodic_create_voronoi(), a shift: how
    ! often each vector of the box has to be added to the second side to get the image that the face
    ! is between. Empty for other diagrams.
    integer, parameter :: mgdt_voronoi_array_face_shifts = 203
    ! The vertex where each ray begins.
    integer, parameter :: mgdt_voronoi_array_ray_vertices = 210
    ! Offsets of the cells' lists of faces, for each point that was inserted. A point that is no
    ! vertex of the triangulation has no cell and an empty list.
    integer, parameter :: mgdt_voronoi_array_cell_offsets = 220
    ! The faces of each cell, in ascending order.
    integer, parameter :: mgdt_voronoi_array_cell_faces = 221
    ! For each point 1 if it has a cell and this cell is bounded, otherwise 0.
    integer, parameter :: mgdt_voronoi_array_cell_bounded = 222
    ! For each element of MGDT_VORONOI_ARRAY_CELL_FACES what is on the other side of the face: a
    ! point, or -1 - k for plane k. With MGDT_VORONOI_ARRAY_CELL_OFFSETS,
    ! MGDT_VORONOI_ARRAY_CELL_FACE_AREAS and MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES this is a
    ! list of neighbours with weights; a point may be in the list of a cell of a periodic box
    ! several times, as different images.
    integer, parameter :: mgdt_voronoi_array_cell_neighbors = 223
    ! Three elements for each of these, a shift: how often each vector of the box has to be added to
    ! the point to get the image that is the neighbour. Empty if there is no box.
    integer, parameter :: mgdt_voronoi_array_cell_neighbor_shifts = 224
    ! 3 coordinates of each vertex, rounded to the nearest doubles. A coordinate beyond the range of
    ! doubles is infinite.
    integer, parameter :: mgdt_voronoi_array_vertices = 300
    ! 3 coordinates of the direction of each ray, of length 1, with errors of at most 1e-15.
    integer, parameter :: mgdt_voronoi_array_ray_directions = 310
    ! The area of each face; infinite for an unbounded face, or beyond the range of doubles. The
    ! error is at most 1e-12 times the area, plus 1e-14 times the square of the distance between the
    ! two points that the face separates.
    integer, parameter :: mgdt_voronoi_array_face_areas = 320
    ! 3 coordinates of the unit normal of each face, with errors of at most 1e-15. It points from
    ! the first side to the second one: out of the cell of the first point.
    integer, parameter :: mgdt_voronoi_array_face_normals = 321
    ! 3 coordinates of the centroid of each face; infinite for an unbounded face. Besides the
    ! rounding of the coordinates, the error is at most 1e-12 times the distance of the farthest
    ! corner from the first side. If the area is at most 1e-14 times the square of the distance
    ! between the two points, the centroid may be a corner instead.
    integer, parameter :: mgdt_voronoi_array_face_centroids = 322
    ! The volume of each cell, as mgdt_get_cell_measures() gives it, but perhaps with other
    ! roundings. 0 for a point without a cell.
    integer, parameter :: mgdt_voronoi_array_cell_volumes = 330
    ! 3 coordinates of the centroid of each cell, with the accuracy of mgdt_get_cell_measures();
    ! infinite for an unbounded cell, and 0 for a point without a cell.
    integer, parameter :: mgdt_voronoi_array_cell_centroids = 331
    ! For each element of MGDT_VORONOI_ARRAY_CELL_FACES the area of the face.
    integer, parameter :: mgdt_voronoi_array_cell_face_areas = 332
    ! For each element of MGDT_VORONOI_ARRAY_CELL_FACES the distance of the cell's point from the
    ! point on the other side, with an error of at most 1e-15 times the distance; or from the plane
    ! there, with an error of at most 1e-15 times the sum of the distance and the point's largest
    ! coordinate.
    integer, parameter :: mgdt_voronoi_array_cell_neighbor_distances = 333

    ! Options.
    ! 0 or 1, at first that of the domain, or 0. It applies to indices that are passed later.
    integer, parameter :: mgdt_mesh_option_index_base = 10
    ! Threads, see mgdt_set_threads(), at first those of the domain, or 1; 0 for all cores.
    integer, parameter :: mgdt_mesh_option_threads = 20
    ! Bytes that the handle may hold, at first the limit of the domain; 0 for no limit.
    integer, parameter :: mgdt_mesh_option_memory_limit = 30
    ! The goal g of mgdt_mesh_improve() in degrees, from 0 to 70, at first 25: no dihedral angle
    ! should be below g, and no sine of an obtuse one below sin(g) / 0.7, so that the largest angle
    ! is 142.9 degrees for g = 25. Most meshes reach 25 soon and 30 later; few reach 35. Since 1.4.
    integer, parameter :: mgdt_mesh_option_goal = 40
    ! What mgdt_mesh_improve() and mgdt_mesh_refine() may do to faces and edges that the mesh lists:
    ! an MGDT_BOUNDARY_ value, at first MGDT_BOUNDARY_FIXED. Since 1.4.
    integer, parameter :: mgdt_mesh_option_boundary = 41
    ! What mgdt_mesh_improve() may do to the points that were set: an MGDT_POINTS_ value, at first
    ! MGDT_POINTS_KEEP for a mesh of a domain, and MGDT_POINTS_MOVE for one of the caller's
    ! tetrahedra. Since 1.4.
    integer, parameter :: mgdt_mesh_option_points = 42
    ! How often mgdt_mesh_improve() moves all points, after the goal, to improve the mean of the
    ! shapes: from 0 to 1000, at first 0. Three passes do most of what can be done. Since 1.4.
    integer, parameter :: mgdt_mesh_option_mean_passes = 43
    ! The most passes of mgdt_mesh_improve() over the tetrahedra below the goal, from 0 to 10000, at
    ! first 100. Few of them suffice for most meshes. Exchanges of edges and faces, which come
    ! first, and one pass of moves are not counted. Since 1.4.
    integer, parameter :: mgdt_mesh_option_most_passes = 44
    ! The most points that one mgdt_mesh_refine() inserts; 0 (at first) for no limit. Since 1.4.
    integer, parameter :: mgdt_mesh_option_most_points = 45
    ! 1 if mgdt_mesh_refine() is to take the mean length of the edges of faces at a point, of those
    ! that the mesh lists, for a size that is wanted there; 0 at first. Since 1.4.
    integer, parameter :: mgdt_mesh_option_sizes_of_surface = 46
    ! A double: the length that edges should have everywhere; 0 (at first) for none. Since 1.4.
    integer, parameter :: mgdt_mesh_option_size = 61
    ! A double: how fast sizes may grow with the distance, at first 0.3, and less than 1e6: a size
    ! at one point is at most that at another plus this times their distance. Since 1.4.
    integer, parameter :: mgdt_mesh_option_gradation = 62
    ! A double: the most that the radius of a circumsphere should be, in shortest edges of its
    ! tetrahedron, at first 1.4; 0 for no bound. Since 1.4.
    integer, parameter :: mgdt_mesh_option_radius_edge = 63
    ! A double: the most volume that a tetrahedron should have; 0 (at first) for no bound. Since
    ! 1.4.
    integer, parameter :: mgdt_mesh_option_volume = 64

    ! Kinds of sizes.
    ! At each point of the mesh.
    integer, parameter :: mgdt_sizes_of_points = 0
    ! In each tetrahedron.
    integer, parameter :: mgdt_sizes_of_tetrahedra = 1
    ! In each region.
    integer, parameter :: mgdt_sizes_of_regions = 2

    ! Values of MGUBND.
    ! Faces and edges that the mesh lists stay as they are.
    integer, parameter :: mgdt_boundary_fixed = 0
    ! The surface stays, but its points move: within the facet that they are inside of, or along a
    ! straight line of edges, but for rounding; and other faces may divide the facet. If a facet
    ! whose faces are not quite in one plane would run into another part of the surface so, the
    ! improvement is as with MGDT_BOUNDARY_FIXED. A refinement inserts points inside of facets and
    ! in the middle of edges, without moving any. These are exact if the coordinates of the facet's
    ! corners are whole numbers of a power of two that is at least 2^-36 of the largest coordinate;
    ! others are rounded.
    integer, parameter :: mgdt_boundary_slide = 1

    ! Values of MGUPNT.
    ! They stay where they are.
    integer, parameter :: mgdt_points_keep = 0
    ! They may move. Points that are equal stay equal.
    integer, parameter :: mgdt_points_move = 1
    ! They may move, and may become points of no tetrahedron.
    integer, parameter :: mgdt_points_remove = 2

    ! Numbers.
    ! Points, Steiner points included.
    integer, parameter :: mgdt_mesh_stat_points = 100
    ! Points that the library has added.
    integer, parameter :: mgdt_mesh_stat_steiner_points = 101
    ! Tetrahedra.
    integer, parameter :: mgdt_mesh_stat_tetrahedra = 102
    ! Regions.
    integer, parameter :: mgdt_mesh_stat_regions = 103
    ! Faces that are parts of facets.
    integer, parameter :: mgdt_mesh_stat_faces = 104
    ! Edges that are parts of segments or of facets' edges.
    integer, parameter :: mgdt_mesh_stat_edges = 105
    ! Memory that the handle holds.
    integer, parameter :: mgdt_mesh_stat_memory_bytes = 110
    ! 1 if the points that are returned are rounded.
    integer, parameter :: mgdt_mesh_stat_is_rounded = 120
    ! 1 if the mesh is the constrained Delaunay triangulation of its points. mgdt_domain_build()
    ! makes that mesh unless another mesh needs fewer Steiner points. Since 1.4.
    integer, parameter :: mgdt_mesh_stat_is_delaunay = 122
    ! 1 if the mesh is as mgdt_domain_build() has made it, so that mgdt_domain_check() can compare
    ! it with the domain. Since 1.4.
    integer, parameter :: mgdt_mesh_stat_is_of_domain = 123
    ! 1 if the domain's boundary is kept in such a mesh: each triangle of a facet is one face, and
    ! no Steiner point is on a facet or on a segment (MGDT_DOMAIN_OPTION_KEEP_BOUNDARY). Since 1.4.
    integer, parameter :: mgdt_mesh_stat_keeps_boundary = 124
    ! Coordinates are rounded to multiples of 2^-bits of the largest one: 36, or 44 or 40 for a
    ! surface with finer details, or 24 to 32 for one whose edges have to be divided very finely. 0
    ! if points are not rounded, because the boundary is kept.
    integer, parameter :: mgdt_mesh_stat_grid_bits = 121
    ! Points that were set and are neither a corner of a tetrahedron nor equal to one.
    integer, parameter :: mgdt_mesh_stat_unused_points = 130
    ! Faces at which there is no tetrahedron: their facets bound nothing and are outside.
    integer, parameter :: mgdt_mesh_stat_unused_faces = 131
    ! Places of mgdt_domain_set_regions() that are in no region of the mesh.
    integer, parameter :: mgdt_mesh_stat_unused_regions = 132
    ! Places of mgdt_domain_set_holes() that are in nothing that the facets enclose.
    integer, parameter :: mgdt_mesh_stat_unused_holes = 133
    ! Facets, where those in one plane are joined. This number and the next three describe steps of
    ! the algorithm; they may be 0 in later versions.
    integer, parameter :: mgdt_mesh_stat_planar_facets = 140
    ! Joined facets that the Delaunay triangulation of all points lacks.
    integer, parameter :: mgdt_mesh_stat_missing_facets = 141
    ! Parts of that triangulation that were filled anew.
    integer, parameter :: mgdt_mesh_stat_cavities = 142
    ! The most tetrahedra in one of them.
    integer, parameter :: mgdt_mesh_stat_largest_cavity = 143
    ! Tetrahedra that the last mgdt_mesh_improve() has left below the goal. This number and the next
    ! three are 0 before. Since 1.4.
    integer, parameter :: mgdt_mesh_stat_below_goal = 150
    ! Passes over tetrahedra below the goal. Since 1.4.
    integer, parameter :: mgdt_mesh_stat_passes = 151
    ! Points that were set and have moved. Since 1.4.
    integer, parameter :: mgdt_mesh_stat_moved_points = 152
    ! Points that were set and have lost all of their tetrahedra. Since 1.4.
    integer, parameter :: mgdt_mesh_stat_removed_points = 153
    ! Points that the last mgdt_mesh_refine() has inserted. Since 1.4.
    integer, parameter :: mgdt_mesh_stat_inserted_points = 160
    ! Tetrahedra that it has left beyond the sizes and bounds (MGDT_MESH_ARRAY_REFUSALS). Both are 0
    ! after mgdt_mesh_build() and mgdt_mesh_improve(). Since 1.4.
    integer, parameter :: mgdt_mesh_stat_refused = 161

    ! Elements of MGUREF.
    ! It is within the sizes and bounds.
    integer, parameter :: mgdt_refusal_none = 0
    ! A face of a facet is between it and the point that would divide it.
    integer, parameter :: mgdt_refusal_hidden = 1
    ! That point is too near to another one.
    integer, parameter :: mgdt_refusal_near_point = 2
    ! That point is near a facet, and would leave as many tetrahedra beyond the bounds.
    integer, parameter :: mgdt_refusal_near_facet = 3
    ! Around that point is no place for tetrahedra with a positive volume.
    integer, parameter :: mgdt_refusal_no_cavity = 4
    ! MGDT_MESH_OPTION_MOST_POINTS were inserted.
    integer, parameter :: mgdt_refusal_most_points = 5

    ! Elements of MGUREA.
    ! It reaches the goal.
    integer, parameter :: mgdt_reason_none = 0
    ! Two of its faces are parts of facets with a smaller angle between them.
    integer, parameter :: mgdt_reason_input_angle = 1
    ! It is at a corner of a face of a facet that has a smaller angle itself.
    integer, parameter :: mgdt_reason_thin_face = 2
    ! None of its corners may move.
    integer, parameter :: mgdt_reason_fixed_corners = 3
    integer, parameter :: mgdt_reason_other = 4

    ! Arrays.
    ! For each point the point that was set and that it is, of equal ones of a domain the first;
    ! none for a Steiner point.
    integer, parameter :: mgdt_mesh_array_point_origins = 200
    ! Four corners for each tetrahedron, positively oriented as in mgdt_get_tetrahedra(). The
    ! tetrahedra of mgdt_domain_build() and mgdt_mesh_improve() are sorted by their corners; those
    ! of mgdt_mesh_build() have the caller's order.
    integer, parameter :: mgdt_mesh_array_tetrahedra = 210
    ! For each tetrahedron the numbers of the four tetrahedra opposite its corners. None means that
    ! the domain ends there.
    integer, parameter :: mgdt_mesh_array_neighbors = 211
    ! The region of each tetrahedron.
    integer, parameter :: mgdt_mesh_array_tetrahedron_regions = 212
    ! The marker of each region: that of the last place of mgdt_domain_set_regions() inside of it,
    ! or 0; or that of the caller's tetrahedra, of which those with one marker are a region.
    integer, parameter :: mgdt_mesh_array_region_markers = 220
    ! Three corners for each face of the mesh that is a part of a facet. They turn in the same
    ! direction as those of the facet. mgdt_mesh_build() lists the caller's faces first.
    integer, parameter :: mgdt_mesh_array_faces = 230
    ! The two tetrahedra at each face: first the one from which the corners appear counter-
    ! clockwise, then the other one.
    integer, parameter :: mgdt_mesh_array_face_tetrahedra = 231
    ! The facet that each face is a part of; of facets that are joined, the first one. Of a mesh of
    ! the caller's tetrahedra facets are what its faces form in one plane; they are numbered in the
    ! order of their first faces.
    integer, parameter :: mgdt_mesh_array_face_facets = 232
    ! The marker of this facet.
    integer, parameter :: mgdt_mesh_array_face_markers = 233
    ! Two ends for each edge of the mesh that is a part of a segment, or of an edge of facets that
    ! does not lie inside of a joined facet. mgdt_mesh_build() lists the caller's edges first.
    integer, parameter :: mgdt_mesh_array_edges = 240
    ! The segment, or the edge of mgdt_mesh_set_edges(), that each of these edges is a part of, or
    ! none.
    integer, parameter :: mgdt_mesh_array_edge_segments = 241
    ! The marker of this segment, or 0.
    integer, parameter :: mgdt_mesh_array_edge_markers = 242
    ! For each Steiner point the two points a and b that it is between, or none and none for one
    ! that is inside of the domain.
    integer, parameter :: mgdt_mesh_array_steiner_edges = 250
    ! For each tetrahedron an MGDT_REASON_ value: why mgdt_mesh_improve() has left it below the
    ! goal. Empty before. Since 1.4.
    integer, parameter :: mgdt_mesh_array_reasons = 260
    ! 18 rows of two numbers, before and after mgdt_mesh_improve(): how many dihedral angles are at
    ! least 10 i and below 10 (i + 1) degrees, for i from 0 to 17; each tetrahedron has six. Empty
    ! before. Since 1.4.
    integer, parameter :: mgdt_mesh_array_angle_histogram = 261
    ! Six rows of two numbers, before and after mgdt_mesh_improve(): how many tetrahedra have a
    ! dihedral angle below 5, 10, 15, 20, 25 and 30 degrees. Empty before. Since 1.4.
    integer, parameter :: mgdt_mesh_array_tetrahedra_below = 262
    ! For each tetrahedron an MGDT_REFUSAL_ value: why mgdt_mesh_refine() has left it beyond the
    ! sizes and bounds. Empty before, and after mgdt_mesh_build() and mgdt_mesh_improve(). Since
    ! 1.4.
    integer, parameter :: mgdt_mesh_array_refusals = 270
    ! Three coordinates of each point: first the points that were set, then the Steiner points.
    integer, parameter :: mgdt_mesh_array_points = 300
    ! For each Steiner point the number t for which it is a + t (b - a); 0 if it is between no two
    ! points.
    integer, parameter :: mgdt_mesh_array_steiner_parameters = 310
    ! Three rows of two numbers, before and after mgdt_mesh_improve(): the least and the largest
    ! dihedral angle, in degrees, and the mean of MGDT_TETRAHEDRON_VOLUME_LENGTH. Empty before.
    ! Since 1.4.
    integer, parameter :: mgdt_mesh_array_shapes = 320
    ! For each point the length of edges that the last mgdt_mesh_refine() was asked for there, or 0
    ! if it was asked for none. Empty when MGDT_MESH_ARRAY_REFUSALS is. Since 1.4.
    integer, parameter :: mgdt_mesh_array_sizes = 330

    ! Kinds.
    integer, parameter :: mgdt_domain_kind_facet = 0
    integer, parameter :: mgdt_domain_kind_segment = 1
    ! A point that is a corner of no facet and of no segment.
    integer, parameter :: mgdt_domain_kind_point = 2

    ! Options.
    ! 0 (default) or 1. It applies to indices that are given or read later.
    integer, parameter :: mgdt_domain_option_index_base = 10
    ! Threads, see mgdt_set_threads(); default 1, 0 for all cores.
    integer, parameter :: mgdt_domain_option_threads = 20
    ! Bytes that the handle may hold; 0 (default) for no limit.
    integer, parameter :: mgdt_domain_option_memory_limit = 30
    ! 1 to return rounded points always, so that facets and segments are covered exactly by what is
    ! returned; 0 (default) to return the caller's points where possible (mgdt_mesh.h).
    integer, parameter :: mgdt_domain_option_round_points = 40
    ! 1 to refuse a mesh that leaves out a part of what was set; 0 (default) to count what is left
    ! out (MGDT_MESH_STAT_UNUSED_POINTS and the statistics after it).
    integer, parameter :: mgdt_domain_option_strict = 50
    ! 1 to keep the boundary as it is: each triangle of a facet is one face, each segment and each
    ! edge of a facet one edge, with the caller's coordinates, and Steiner points are inside of the
    ! domain only. 0 (default) to divide segments where that is necessary. Since 1.4.
    integer, parameter :: mgdt_domain_option_keep_boundary = 60
    ! A double: the distance within which mgdt_domain_clean() takes places for one place, as a share
    ! of the size of the points, which is the diagonal of their box. 0 (default) for equal places
    ! only, otherwise less than 0.1. Since 1.4.
    integer, parameter :: mgdt_domain_option_weld = 70
    ! A double: the distance within which mgdt_domain_clean() takes facets of one marker for facets
    ! in one plane, as a share of the same size. 0 (default) for facets that are exactly in one
    ! plane, otherwise less than 0.1. Since 1.4.
    integer, parameter :: mgdt_domain_option_flatness = 80

    ! Numbers.
    ! Points that were set.
    integer, parameter :: mgdt_domain_stat_points = 100
    ! Facets and segments that were set, or that mgdt_domain_clean() has made of them.
    integer, parameter :: mgdt_domain_stat_facets = 101
    integer, parameter :: mgdt_domain_stat_segments = 102
    ! Places of regions that were set.
    integer, parameter :: mgdt_domain_stat_regions = 103
    ! Places of holes that were set.
    integer, parameter :: mgdt_domain_stat_holes = 104
    ! Memory that the handle holds.
    integer, parameter :: mgdt_domain_stat_memory_bytes = 110
    ! Pairs in MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS.
    integer, parameter :: mgdt_domain_stat_offending_pairs = 120
    ! Edges in MGDT_DOMAIN_ARRAY_OPEN_EDGES.
    integer, parameter :: mgdt_domain_stat_open_edges = 121
    ! Points that were moved to others. Since 1.4.
    integer, parameter :: mgdt_domain_stat_moved_points = 130
    ! Corners that were left out. Since 1.4.
    integer, parameter :: mgdt_domain_stat_repeated_corners = 131
    ! Facets of which nothing is left, because their corners are on a line. Since 1.4.
    integer, parameter :: mgdt_domain_stat_collapsed_facets = 132
    ! Pairs in MGDT_DOMAIN_ARRAY_COVERED_FACETS. Since 1.4.
    integer, parameter :: mgdt_domain_stat_covered_facets = 133
    ! Pairs of an edge and a point in it that has divided it. Since 1.4.
    integer, parameter :: mgdt_domain_stat_points_in_edges = 134
    ! Pairs of a triangle of a facet and a point inside of it that has divided it. Since 1.4.
    integer, parameter :: mgdt_domain_stat_points_in_facets = 135
    ! Edges of other facets, and segments, that facets have taken in. Since 1.4.
    integer, parameter :: mgdt_domain_stat_edges_in_facets = 136
    ! Edges between two triangles in one plane that the other diagonal has replaced. Since 1.4.
    integer, parameter :: mgdt_domain_stat_exchanged_edges = 137

    ! Arrays.
    ! Four elements for each offending pair: a kind (MGDT_DOMAIN_KIND_FACET and so on) and a number,
    ! twice. What is bad by itself is paired with itself: a facet that is flat or no polygon, or a
    ! segment without length.
    integer, parameter :: mgdt_domain_array_offending_pairs = 200
    ! Three elements for each edge that one facet alone has, where a surface is open: the two ends
    ! and the facet. They are found if there are no offending pairs. Facets that bound nothing have
    ! such edges too.
    integer, parameter :: mgdt_domain_array_open_edges = 210
    ! Offsets and corners of the facets, as mgdt_domain_set_facets() takes them.
    integer, parameter :: mgdt_domain_array_facet_offsets = 220
    integer, parameter :: mgdt_domain_array_facet_corners = 221
    ! The marker of each facet.
    integer, parameter :: mgdt_domain_array_facet_markers = 222
    ! For each facet the one of the facets that were set that it is, or is a part of. Where edges
    ! between facets in one plane were exchanged, it is one of these facets.
    integer, parameter :: mgdt_domain_array_facet_origins = 223
    ! Two elements for each pair of facets that were set: one that is covered by another facet,
    ! wholly or in part, and that other facet, which stays in its place.
    integer, parameter :: mgdt_domain_array_covered_facets = 224
    ! Two points for each segment.
    integer, parameter :: mgdt_domain_array_segments = 230
    ! The marker of each segment.
    integer, parameter :: mgdt_domain_array_segment_markers = 231
    ! For each segment the one that was set that it is, or is a part of.
    integer, parameter :: mgdt_domain_array_segment_origins = 232
    ! Doubles: three coordinates for each point.
    integer, parameter :: mgdt_domain_array_points = 300

    ! Options.
    ! 0 (default) or 1. It applies to indices that are given or read later.
    integer, parameter :: mgdt_periodic_option_index_base = 10
    ! Threads, see mgdt_set_threads(); default 1, 0 for all cores.
    integer, parameter :: mgdt_periodic_option_threads = 20
    ! Bytes that the handle may hold; 0 (default) for no limit.
    integer, parameter :: mgdt_periodic_option_memory_limit = 30

    ! Numbers.
    ! Points that were inserted.
    integer, parameter :: mgdt_periodic_stat_points = 100
    ! Points without equal images.
    integer, parameter :: mgdt_periodic_stat_vertices = 101
    ! Classes of tetrahedra. With three vectors, a set has as many edges as vertices and tetrahedra
    ! together.
    integer, parameter :: mgdt_periodic_stat_tetrahedra = 102
    ! Classes of edges.
    integer, parameter :: mgdt_periodic_stat_edges = 103
    ! The number of vectors; 0 before they are set.
    integer, parameter :: mgdt_periodic_stat_dimensions = 104
    ! Memory that the handle holds.
    integer, parameter :: mgdt_periodic_stat_memory_bytes = 110
    ! Images that were triangulated with the points. May be 0 in later versions.
    integer, parameter :: mgdt_periodic_stat_images = 120
    ! Rounds in which these were found. May be 0 in later versions.
    integer, parameter :: mgdt_periodic_stat_rounds = 121

    ! Arrays.
    ! For each point the vertex that has its images: the least point that has them.
    integer, parameter :: mgdt_periodic_array_point_map = 200
    ! The shift of that vertex's image that is the point. 0 for a point that is its own vertex.
    integer, parameter :: mgdt_periodic_array_point_shifts = 201
    ! Four corners for each class of tetrahedra, positively oriented as in mgdt_get_tetrahedra().
    ! The first is the one whose image has the lexicographically least coordinates, and the
    ! tetrahedra are sorted by their first corners. Empty if a slab or a wire does not span space.
    integer, parameter :: mgdt_periodic_array_tetrahedra = 210
    ! The shift of each corner, 12 elements for a tetrahedron. The first corner's is 0.
    integer, parameter :: mgdt_periodic_array_tetrahedron_shifts = 211
    ! For each tetrahedron the numbers of the four tetrahedra opposite its corners. The index base -
    ! 1 means that there is none: the facet is on the hull of a slab or a wire.
    integer, parameter :: mgdt_periodic_array_neighbors = 212
    ! For each of these the shift by which the neighbour is moved to be there, 12 elements for a
    ! tetrahedron. It is added to the shifts of the neighbour's corners.
    integer, parameter :: mgdt_periodic_array_neighbor_shifts = 213
    ! Offsets of the lists of each point's neighbours, one more than there are points: the list of
    ! point i is from element offsets[i] to element offsets[i + 1] - 1, counted from the index base.
    ! A point that is no vertex has an empty list.
    integer, parameter :: mgdt_periodic_array_vertex_neighbor_offsets = 220
    ! The points at the other ends of the edges at each vertex, sorted. A vertex may have several
    ! images of one point as neighbours, and images of itself.
    integer, parameter :: mgdt_periodic_array_vertex_neighbors = 221
    ! The shift of each of these images.
    integer, parameter :: mgdt_periodic_array_vertex_neighbor_shifts = 222
    ! Three coordinates of each point: where the caller has put it, rounded.
    integer, parameter :: mgdt_periodic_array_points = 300
    ! Three coordinates of each vector, rounded.
    integer, parameter :: mgdt_periodic_array_vectors = 301
end module mgdt_constants
