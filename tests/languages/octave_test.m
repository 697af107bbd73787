% SPDX-License-Identifier: MIT
% The Octave binding against what the C interface wrote (reference.c), Octave's own delaunayn, and
% geometry.
%
%   octave-cli --path BINDING --path TESTS --eval 'octave_test ("REFERENCE_FOLDER")'
function octave_test (folder)
  tests = {@cube, @exports, @as_delaunayn, @front, @ways_to_give_points, @location, @changes, @settings, ...
           @domain, @refinement, @improvement, @periodic_box, @flat, @bad_values, @memory_limit, @compact, @progress, @handles, @freed, @help_texts};
  passed = failed = 0;
  for k = 1:numel (tests)
    try
      tests{k} (folder);
      passed++;
      printf ("passed: %s\n", func2str (tests{k}));
    catch e
      failed++;
      printf ("failed: %s: %s\n", func2str (tests{k}), e.message);
      for frame = e.stack'
        printf ("    %s, line %d\n", frame.name, frame.line);
      end
    end
  end
  printf ("%d passed, %d failed\n", passed, failed);
  clear e;
  exit (! (failed == 0 && passed > 0));
end

function v = read (folder, name, class, width)
  file = fopen (fullfile (folder, name), "r");
  v = reshape (fread (file, Inf, [class "=>double"]), width, [])';
  fclose (file);
end

function points = read_points (folder)
  points = read (folder, "points", "double", 3);
end

function volumes = six_volumes (points, tetrahedra)
  a = points(tetrahedra(:, 1), :);
  u = points(tetrahedra(:, 2), :) - a;
  v = points(tetrahedra(:, 3), :) - a;
  w = points(tetrahedra(:, 4), :) - a;
  volumes = dot (cross (u, v, 2), w, 2);
end

% The call must fail with that identifier, and say each of the words.
function refused (identifier, words, call)
  try
    call ();
  catch e
    if (! strcmp (e.identifier, identifier))
      error ("the identifier is '%s' ('%s'), expected %s", e.identifier, e.message, identifier);
    end
    for k = 1:numel (words)
      if (isempty (strfind (e.message, words{k})))
        error ("'%s' does not say '%s'", e.message, words{k});
      end
    end
    return
  end
  error ("no error: expected %s", identifier);
end

function cube (folder)
  [x, y, z] = ndgrid ([0 1]);
  points = [x(:) y(:) z(:)];
  t = mgdt_triangulation ();
  t.insert (points);
  volumes = six_volumes (points, t.tetrahedra ());
  assert (any (numel (volumes) == [5 6]));
  assert (all (volumes > 0));
  assert (sum (volumes), 6);
  assert (t.hull_facet_count (), 12);
  assert (t.dimension (), 3);
  t.check ();
  assert (isempty (strfind (evalc ("disp (t)"), "8 points")), false);
end

function exports (folder)
  points = read_points (folder);
  t = mgdt_triangulation ("canonical", true);
  t.insert (points);
  assert (t.tetrahedra (), read (folder, "tetrahedra", "int64", 4) + 1);
  assert (t.neighbours (), read (folder, "neighbors", "int64", 4) + 1);
  assert (t.hull_facets (), read (folder, "hull_facets", "int64", 3) + 1);
  assert (t.edges (), read (folder, "edges", "int64", 2) + 1);
  assert (t.point_map (), read (folder, "point_map", "int64", 1) + 1);
  [offsets, list] = t.vertex_tetrahedra ();
  assert (offsets, read (folder, "offsets", "int64", 1) + 1);
  assert (list, read (folder, "list", "int64", 1) + 1);
  [neighbor_offsets, neighbors] = t.vertex_neighbors ();
  assert (neighbor_offsets, read (folder, "neighbor_offsets", "int64", 1) + 1);
  assert (neighbors, read (folder, "neighbor_list", "int64", 1) + 1);
  assert (t.gabriel_edges (), read (folder, "gabriel_edges", "int64", 2) + 1);
  assert (t.spanning_tree (), read (folder, "spanning_tree", "int64", 2) + 1);
  [centers, squares] = t.circumcenters ();
  assert (centers, read (folder, "centers", "double", 3));
  assert (squares, read (folder, "squares", "double", 1));
  assert (t.alphas (2), read (folder, "facet_alphas", "double", 4));
  assert (t.alphas (1), read (folder, "edge_alphas", "double", 1));
  assert (t.alpha_surface (0.01), read (folder, "alpha_surface", "int64", 3) + 1);
  assert (t.solid_alpha (), read (folder, "solid_alpha", "double", 1));
  box = [1 0 0 2; -1 0 0 1; 0 1 0 2; 0 -1 0 1; 0 0 1 2; 0 0 -1 1];
  assert (t.cell_measures ("volume", box), read (folder, "volumes", "double", 1));
  assert (t.cell_measures ("centroid", box), read (folder, "centroids", "double", 3));
  assert (t.cell_measures ("faces"), read (folder, "faces", "double", 1));
  assert (t.tetrahedron_measures ("radius_ratio"), read (folder, "radius_ratios", "double", 1));
  assert (t.tetrahedron_measures ("largest_dihedral_angle"), read (folder, "largest_angles", "double", 1));
  refused ("mgdt:unknown_key", {"least_dihedral_angle"}, @() t.tetrahedron_measures ("faces"));
  diagrams (folder, t, box);
  places = read (folder, "queries", "double", 3);
  values = read (folder, "values", "double", 2);
  assert (t.interpolate ("sibson_c1", values, places, "linear"), read (folder, "interpolated", "double", 2));
  gradients = read (folder, "gradients", "double", 6);
  assert (t.gradients (values), reshape (gradients, rows (values), 3, 2));
  assert (t.gradients (values(:,1)), gradients(:,1:3));
  weights = t.interpolation_weights ("sibson", places);
  row_offsets = read (folder, "row_offsets", "int64", 1);
  assert (size (weights), [rows(places), rows(values)]);
  assert (full (sum (weights != 0, 2)), diff (row_offsets));
  assert (nonzeros (weights'), read (folder, "row_weights", "double", 1));
  assert (weights * values, t.interpolate ("sibson", values, places, "nearest") .* (diff (row_offsets) > 0), 1e-14);
  tetrahedra = t.tetrahedra ();
  assert (list(offsets(8):offsets(9)-1), find (any (tetrahedra == 8, 2)));
  % Euler's formula for a ball.
  facets = (4 * t.tetrahedron_count () + t.hull_facet_count ()) / 2;
  assert (t.vertex_count () - t.edge_count () + facets - t.tetrahedron_count (), 1);
  assert ([t.point_count() t.vertex_count()], [1010 1000]);
  assert (t.statistics ().duplicates, 10);
  t.check ("combinatorial");
  t.check ("geometric");
  t.check ("canonical");
end

% The diagrams, clipped to a box and not, are those of the C interface.
function diagrams (folder, t, box)
  % Numbers from 1; rays and planes stay negative.
  from_1 = @(x) x + (x >= 0);
  for prefix = {"cut_", "whole_"}
    p = prefix{1};
    if (strcmp (p, "cut_"))
      v = t.voronoi (box);
    else
      v = t.voronoi ();
    end
    for name = {"face_offsets", "face_corners", "ray_vertices", "cell_offsets", "cell_faces"}
      assert (v.(name{1}), from_1 (read (folder, [p name{1}], "int64", 1)));
    end
    assert (v.face_sides, from_1 (read (folder, [p "face_sides"], "int64", 2)));
    assert (size (v.face_shifts), [0 3]);
    assert (v.cell_bounded, read (folder, [p "cell_bounded"], "int64", 1));
    assert (v.cell_neighbors, from_1 (read (folder, [p "cell_neighbors"], "int64", 1)));
    assert (size (v.cell_neighbor_shifts), [0 3]);
    for name = {"face_areas", "cell_volumes", "cell_face_areas", "cell_neighbor_distances"}
      assert (v.(name{1}), read (folder, [p name{1}], "double", 1));
    end
    for name = {"vertices", "ray_directions", "face_normals", "face_centroids", "cell_centroids"}
      assert (v.(name{1}), read (folder, [p name{1}], "double", 3));
    end
  end
  faces = numel (t.voronoi (box).face_areas);
  assert (all (t.voronoi (box, 0.01).face_areas >= 0.01));
  assert (numel (t.voronoi (box, 0, 0.05).face_areas) < faces);
  refused ("mgdt:invalid_argument", {"-1"}, @() t.voronoi (box, -1));
  refused ("mgdt:invalid_argument", {"no end"}, @() t.voronoi (box(1:5,:)));
  refused ("mgdt:invalid_argument", {"columns"}, @() t.voronoi ([1 2 3]));
end

function stop_with_an_error (fraction)
  error ("test:no_more", "no more");
end

function periodic_box (folder)
  from_1 = @(v) v + 1;
  points = read (folder, "periodic_given_points", "double", 3);
  vectors = [4 0 0; 1.5 3 0; -0.75 0.5 2.5];
  global heard;
  heard = 0;
  box = mgdt_periodic_box (points, vectors, "progress", @add_to_heard, "check", true, "measures", true, ...
                           "cells", true);
  assert (heard > 0);
  for name = {"point_map", "point_map", 1; "tetrahedra", "tetrahedra", 4; "neighbours", "neighbors", 4; ...
              "vertex_neighbour_offsets", "vertex_neighbor_offsets", 1; "vertex_neighbours", "vertex_neighbors", 1}'
    assert (box.(name{1}), from_1 (read (folder, ["periodic_" name{2}], "int64", name{3})));
  end
  for name = {"point_shifts", "point_shifts", 3; "shifts", "tetrahedron_shifts", 12; ...
              "neighbour_shifts", "neighbor_shifts", 12; ...
              "vertex_neighbour_shifts", "vertex_neighbor_shifts", 3}'
    assert (box.(name{1}), read (folder, ["periodic_" name{2}], "int64", name{3}));
  end
  for name = {"points", "points", 3; "vectors", "vectors", 3; "volumes", "volume", 1; "areas", "area", 1; ...
              "faces", "faces", 1; "centroids", "centroid", 3}'
    assert (box.(name{1}), read (folder, ["periodic_" name{2}], "double", name{3}));
  end
  assert (box.cells.face_shifts, read (folder, "periodic_cells_face_shifts", "int64", 3));
  assert (box.cells.face_sides, from_1 (read (folder, "periodic_cells_face_sides", "int64", 2)));
  assert (box.cells.vertices, read (folder, "periodic_cells_vertices", "double", 3));
  cube = mgdt_periodic_box ([0 0 0; 1 1 1], [2 2 2], "measures", true, "threads", 2);
  assert (cube.faces, [14; 14]);
  slab = mgdt_periodic_box (points, vectors(1:2,:));
  assert (any (slab.neighbours(:) == 0));
  fewer = mgdt_periodic_box (points, vectors, "cells", true, "least_area", 0.5);
  assert (rows (fewer.cells.face_areas) < rows (box.cells.face_areas));

  near = mgdt_periodic_box ([0 0 0; 2 2 1.999; 1 1 1], [2 2 2], "merge_distance", 0.01);
  assert (double (near.point_map(:)'), [1 1 3]);
  refused ("mgdt:invalid_argument", {"on a line"}, @() mgdt_periodic_box (points, [1 1 0; 2 2 0]));
  refused ("mgdt:invalid_argument", {"more than three"}, @() mgdt_periodic_box (points, [vectors; 1 1 1]));
  refused ("mgdt:invalid_argument", {"point 1", "boxes away"}, @() mgdt_periodic_box ([1e30 0 0], [1 1 1]));
  refused ("mgdt:invalid_argument", {"three columns"}, @() mgdt_periodic_box ([1 2; 3 4], [1 1 1]));
  refused ("mgdt:unknown_key", {"least_area"}, @() mgdt_periodic_box (points, vectors, "pbc", 1));
  refused ("mgdt:cancelled", {}, @() mgdt_periodic_box (points, vectors, "progress", @(x) true));
  refused ("mgdt:out_of_memory", {}, @() mgdt_periodic_box (points, vectors, "memory_limit", 5000));
end

function domain (folder)
  from_1 = @(v) v + 1;
  points = read (folder, "domain_given_points", "double", 3);
  offsets = read (folder, "domain_given_offsets", "int64", 1);
  corners = from_1 (read (folder, "domain_given_corners", "int64", 1));
  facets = arrayfun (@(a, b) corners(a+1:b), offsets(1:end-1), offsets(2:end), "UniformOutput", false);
  given = {points, facets, "markers", read(folder, "domain_given_markers", "int64", 1), ...
           "segments", [1 2; 9 10], "segment_markers", [5 6], "holes", [1 1 3], ...
           "regions", [0 0 9.5 7], "rounded", true};
  global heard;
  heard = 0;
  mesh = mgdt_domain_mesh (given{:}, "progress", @add_to_heard, "check", true);
  assert (heard > 0);
  for name = {"point_origins", 1; "tetrahedra", 4; "tetrahedron_regions", 1; "faces", 3; ...
              "face_tetrahedra", 2; "face_facets", 1; "edges", 2; "edge_segments", 1; "steiner_edges", 2}'
    assert (mesh.(name{1}), from_1 (read (folder, ["domain_" name{1}], "int64", name{2})));
  end
  assert (mesh.neighbours, from_1 (read (folder, "domain_neighbors", "int64", 4)));
  for name = {"region_markers", "face_markers", "edge_markers"}
    assert (mesh.(name{1}), read (folder, ["domain_" name{1}], "int64", 1));
  end
  assert (mesh.points, read (folder, "domain_points", "double", 3));
  assert (mesh.volumes, read (folder, "domain_volumes", "double", 1));
  assert (mesh.steiner_parameters, read (folder, "domain_steiner_parameters", "double", 1));
  assert (mesh.is_rounded);
  assert (size (mgdt_offending_pairs (given{:})), [0 4]);

  % Triangles as a matrix, and two that cross.
  one = mgdt_domain_mesh ([0 0 0; 1 0 0; 0 1 0; 0 0 1], [1 3 2; 1 2 4; 2 3 4; 3 1 4]);
  assert (sort (one.tetrahedra), 1:4);
  assert (one.neighbours, [0 0 0 0]);
  assert (! one.is_rounded);
  kept = mgdt_domain_mesh ([0 0 0; 1 0 0; 0 1 0; 0 0 1], [1 3 2; 1 2 4; 2 3 4; 3 1 4], ...
                           "keep_boundary", true, "check", true);
  assert (sort (kept.tetrahedra), 1:4);
  hanging = {[0 0 0; 2 0 0; 0 2 0; 0 0 2; 1 0 0], [1 3 2; 1 5 4; 5 2 4; 2 3 4; 3 1 4]};
  refused ("mgdt:invalid_boundary", {"facet"}, @() mgdt_domain_mesh (hanging{:}));
  cleaned = mgdt_clean_surface (hanging{:});
  assert (cleaned.origins', [1 1 2 3 4 5]);
  assert (cellfun (@numel, cleaned.facets)', [3 3 3 3 3 3]);
  assert (cleaned.points_in_edges, 1);
  assert (cleaned.points, hanging{1});
  whole = mgdt_domain_mesh (hanging{:}, "clean", true, "check", true);
  assert (unique (whole.face_facets)', [1 2 4 5]);  % the two in one plane are one
  assert (size (whole.covered_facets), [0 2]);
  assert (mgdt_domain_mesh (hanging{:}, "weld", 1e-9).tetrahedra, whole.tetrahedra);
  refused ("mgdt:invalid_argument", {"option 70"}, @() mgdt_domain_mesh (hanging{:}, "weld", 1));
  refused ("Octave:invalid-fun-call", {}, @() mgdt_clean_surface ([]));
  refused ("mgdt:open_boundary", {"no facets"}, @() mgdt_domain_mesh ([], []));
  refused ("mgdt:invalid_argument", {"hole 1 is in nothing"}, @() mgdt_domain_mesh ([0 0 0; 1 0 0; 0 1 0; 0 0 1], ...
           [1 3 2; 1 2 4; 2 3 4; 3 1 4], "holes", [5 5 5], "strict", true));
  assert (size (one.open_edges), [0 3]);
  crossing = {[0 0 0; 4 0 0; 0 4 0; 1 1 -1; 1 1 2; 5 1 1], [1 2 3; 4 5 6]};
  assert (mgdt_offending_pairs (crossing{:}), [0 1 0 2]);
  refused ("mgdt:invalid_boundary", {"facet"}, @() mgdt_domain_mesh (crossing{:}));

  make = @(varargin) mgdt_domain_mesh (given{:}, varargin{:});
  refused ("mgdt:invalid_argument", {"19"}, @() make ("markers", [1 2]));
  refused ("mgdt:invalid_argument", {"32-bit"}, @() make ("segment_markers", [1 2^40]));
  refused ("mgdt:invalid_argument", {"two columns"}, @() make ("segments", [1 2 3]));
  refused ("mgdt:invalid_argument", {"whole number"}, @() make ("segments", [1 2.5]));
  refused ("mgdt:invalid_argument", {"four columns"}, @() make ("regions", [1 2 3]));
  refused ("mgdt:invalid_argument", {"holes", "three columns"}, @() make ("holes", [1 2]));
  refused ("mgdt:invalid_argument", {"threads"}, @() make ("threads", 1.5));
  refused ("mgdt:invalid_argument", {"check"}, @() make ("check", [1 2]));
  refused ("mgdt:invalid_argument", {"no value"}, @() make ("threads"));
  refused ("mgdt:unknown_key", {"holes"}, @() make ("hole", []));
  refused ("mgdt:invalid_argument", {"7"}, @() mgdt_domain_mesh (crossing{1}, [1 2 7]));
  refused ("mgdt:invalid_argument", {"facets"}, @() mgdt_domain_mesh (crossing{1}, "x"));
  refused ("mgdt:not_finite", {"1"}, @() mgdt_domain_mesh ([NaN 0 0], []));
  refused ("mgdt:cancelled", {}, @() make ("progress", @(fraction) true));
  refused ("test:no_more", {"no more"}, @() make ("progress", @stop_with_an_error));
  refused ("mgdt:busy", {"progress"}, @() make ("progress", @(fraction) mgdt_offending_pairs (crossing{:})));
  refused ("Octave:invalid-fun-call", {}, @() mgdt_domain_mesh ([]));
  refused ("Octave:invalid-fun-call", {}, @() mgdt_offending_pairs ([]));
end

% The points and tetrahedra of the block, with its other settings.
function given = given_block (folder)
  given = {read(folder, "block_given_points", "double", 3), read(folder, "block_given_tetrahedra", "int64", 4) + 1, ...
           "markers", read(folder, "block_given_markers", "int64", 1), ...
           "faces", read(folder, "block_given_faces", "int64", 3) + 1, ...
           "face_markers", read(folder, "block_given_face_markers", "int64", 1)};
end

function refinement (folder)
  global heard
  from_1 = @(v) v + 1;
  given = given_block (folder);
  heard = 0;
  mesh = mgdt_refine (given{:}, "size", 0.75, "gradation", 0.5, "radius_edge", 1.5, "volume", 0.125, ...
                      "sizes_of_surface", true, "most_points", 2000, "region_sizes", [0.45 0], ...
                      "point_sizes", [0.3; zeros(124, 1)], "tetrahedron_sizes", [zeros(383, 1); 0.25], ...
                      "size_field", {[0 0 0; 8 0 0; 0 8 0; 0 0 8], [0.5 0.75 0.75 1]}, ...
                      "size_function", @(places) 0.375 + 0.125 * places(:,3), ...
                      "progress", @add_to_heard, "check", true);
  assert (heard > 0);
  assert (mesh.tetrahedra, from_1 (read (folder, "refined_tetrahedra", "int64", 4)));
  assert (mesh.points, read (folder, "refined_points", "double", 3));
  assert (mesh.refusals, read (folder, "refined_refusals", "int64", 1));
  assert (mesh.sizes, read (folder, "refined_sizes", "double", 1));
  better = mgdt_improve (mgdt_refine (mesh, "size", 0.6), "goal", 10, "check", true);
  assert (rows (better.tetrahedra) > rows (mesh.tetrahedra));
  refused ("mgdt:invalid_argument", {"-1"}, @() mgdt_refine (mesh, "size", -1));
  refused ("mgdt:invalid_argument", {"2 sizes of points"}, @() mgdt_refine (mesh, "point_sizes", [1 2]));
  refused ("mgdt:invalid_argument", {"-1"}, @() mgdt_refine (mesh, "size_function", @(x) -x(:,1) - 1));
  refused ("mgdt:invalid_argument", {"1 sizes"}, @() mgdt_refine (mesh, "size_function", @(x) 1));
  refused ("mgdt:invalid_argument", {"size_field"}, @() mgdt_refine (mesh, "size_field", {[0 0 0], [1 2]}));
  refused ("mgdt:invalid_argument", {"size_field"}, @() mgdt_refine (mesh, "size_field", 3));
  refused ("mgdt:unknown_key", {"gradation"}, @() mgdt_refine (mesh, "goal", 30));
  refused ("mgdt:cancelled", {}, @() mgdt_refine (mesh, "size", 0.2, "progress", @(f) true));
  refused ("Octave:invalid-fun-call", {}, @() mgdt_refine (given{1}));
end

function improvement (folder)
  global heard
  from_1 = @(v) v + 1;
  given = [given_block(folder), {"fixed", from_1(read (folder, "block_given_fixed", "int64", 1))}];
  heard = 0;
  mesh = mgdt_improve (given{:}, "goal", 30, "boundary", "slide", "progress", @add_to_heard, "check", true);
  assert (heard > 0);
  for name = {"tetrahedra", 4; "faces", 3; "edges", 2; "tetrahedron_regions", 1}'
    assert (mesh.(name{1}), from_1 (read (folder, ["block_" name{1}], "int64", name{2})));
  end
  for name = {"angle_histogram", 2; "tetrahedra_below", 2; "reasons", 1; "face_markers", 1}'
    assert (mesh.(name{1}), read (folder, ["block_" name{1}], "int64", name{2}));
  end
  assert (mesh.points, read (folder, "block_points", "double", 3));
  assert (mesh.shapes, read (folder, "block_shapes", "double", 2));
  assert (! isfield (mesh, "open_edges"));
  assert (sum (mesh.volumes), 64, 1e-9);
  places = read (folder, "places", "double", 3);
  for name = {"inside", {}; "nearest", {"nearest"}}'
    [tetrahedra, weights, values] = mgdt_mesh_places (mesh, places, mesh.points, name{2}{:});
    assert (tetrahedra, from_1 (read (folder, ["places_" name{1} "_tetrahedra"], "int64", 1)));
    assert (weights, read (folder, ["places_" name{1} "_weights"], "double", 4));
    assert (values, read (folder, ["places_" name{1} "_values"], "double", 3));
  end
  assert (mgdt_mesh_places (mesh, [9 9 9]), 0);
  assert (mgdt_mesh_places (mesh, zeros (0, 3)), zeros (0, 1));
  refused ("mgdt:invalid_argument", {"rows"}, @() mgdt_mesh_places (mesh, places, [1; 2]));
  refused ("mgdt:not_finite", {"1"}, @() mgdt_mesh_places (mesh, [NaN 0 0]));
  refused ("Octave:invalid-fun-call", {}, @() mgdt_mesh_places (mesh));
  same = mgdt_improve (mesh, "goal", 30, "keep", "all");
  assert (same.points, mesh.points);
  assert (sort (same.region_markers), sort (mesh.region_markers));
  again = mgdt_improve (mgdt_domain_mesh ([0 0 0; 4 0 0; 0 4 0; 0 0 4; 1 1 .1], [1 3 2; 1 2 4; 2 3 4; 3 1 4]), "check", true);
  assert (again.shapes(1,2) >= again.shapes(1,1));
  one = {[0 0 0; 1 0 0; 0 1 0; 0 0 1], [1 2 3 4]};
  refused ("mgdt:invalid_argument", {"71"}, @() mgdt_improve (one{:}, "goal", 71));
  refused ("mgdt:invalid_argument", {"boundary"}, @() mgdt_improve (one{:}, "boundary", "open"));
  refused ("mgdt:invalid_argument", {"4 columns"}, @() mgdt_improve (one{1}, [1 2 3]));
  refused ("mgdt:invalid_argument", {"corner 5"}, @() mgdt_improve (one{1}, [1 2 3 5]));
  refused ("mgdt:invalid_argument", {"no tetrahedra"}, @() mgdt_improve (one{1}, zeros (0, 4)));
  refused ("mgdt:invalid_argument", {"markers"}, @() mgdt_improve (one{:}, "markers", [1 2]));
  refused ("mgdt:invalid_argument", {"no edge"}, @() mgdt_improve ([one{1}; 9 9 9], one{2}, "edges", [1 5]));
  refused ("mgdt:invalid_argument", {"no value"}, @() mgdt_improve (one{:}, "goal"));
  refused ("mgdt:unknown_key", {"goal"}, @() mgdt_improve (one{:}, "aim", 30));
  refused ("mgdt:not_finite", {"1"}, @() mgdt_improve ([NaN 0 0], [1 1 1 1]));
  refused ("mgdt:cancelled", {}, @() mgdt_improve (given{:}, "goal", 40, "progress", @(f) true));
  refused ("Octave:invalid-fun-call", {}, @() mgdt_improve (one{1}));
end

function add_to_heard (fraction)
  global heard;
  heard += fraction;
end

% Random points have one Delaunay triangulation; Octave's is by Qhull.
function as_delaunayn (folder)
  rand ("twister", 2014);
  points = rand (1000, 3);
  theirs = sortrows (sort (delaunayn (points), 2));
  ours = sortrows (sort (mgdt_delaunay (points), 2));
  assert (ours, theirs);
end

function front (folder)
  points = read_points (folder);
  [tetrahedra, neighbours, map] = mgdt_delaunay (points, "canonical", true);
  assert (tetrahedra, read (folder, "tetrahedra", "int64", 4) + 1);
  assert (neighbours, read (folder, "neighbors", "int64", 4) + 1);
  assert (map, read (folder, "point_map", "int64", 1) + 1);
  four = single (points(1:4, :));
  assert (mgdt_delaunay (four), mgdt_delaunay (double (four)));
  assert (size (mgdt_delaunay ([])), [0 4]);
  assert (size (mgdt_delaunay (zeros (7, 3))), [0 4]);
  refused ("Octave:invalid-fun-call", {}, @() mgdt_delaunay ());
  refused ("mgdt:not_finite", {"point 2", "z"}, @() mgdt_delaunay ([0 0 0; 0 0 Inf]));
end

function ways_to_give_points (folder)
  points = read_points (folder);
  expected = read (folder, "tetrahedra", "int64", 4) + 1;
  schemes = mgdt_triangulation.schemes ();
  assert (numel (schemes) >= 10);
  for k = 1:numel (schemes)
    t = mgdt_triangulation ("canonical", true, "order", schemes{k}, "seed", 5, "threads", 0);
    t.reserve (rows (points));
    t.insert (points(1:400, :));
    t.insert ([]);
    t.insert (points(401:end, :));
    assert (t.tetrahedra (), expected);
  end
  t = mgdt_triangulation ("canonical", true, "order", "multi-grid", "points_per_cell", 3);
  t.set ("threshold", 20);
  t.insert (points);
  assert (t.tetrahedra (), expected);
  % Integers, logicals, ranges and sparse matrices are made doubles.
  [x, y, z] = ndgrid (int8 ([0 1]));
  corners = [x(:) y(:) z(:)];
  given = {corners, logical(corners), sparse(double (corners))};
  for k = 1:numel (given)
    t = mgdt_triangulation ();
    t.insert (given{k});
    assert (sum (six_volumes (double (corners), t.tetrahedra ())), 6);
  end
  t = mgdt_triangulation ();
  t.insert (1:3);
  assert (t.point_count (), 1);
end

function location (folder)
  points = read_points (folder);
  t = mgdt_triangulation ("canonical", true);
  t.insert (points);
  queries = read (folder, "queries", "double", 3);
  expected = read (folder, "located", "int64", 1) + 1;
  expected(expected == 0) = NaN;
  [where, weights] = t.locate (queries);
  assert (where, expected);
  assert (t.locate (queries), expected);
  outside = isnan (where);
  assert (sum (outside) > 10 && sum (! outside) > 10);
  reference = read (folder, "weights", "double", 4);
  reference(outside, :) = NaN;
  assert (weights, reference);
  % Octave's own search, where a point is in the inside of one tetrahedron.
  tetrahedra = t.tetrahedra ();
  [theirs, their_weights] = tsearchn (points, tetrahedra, queries);
  assert (where, theirs);
  assert (weights, their_weights, 1e-9);
  nearest = t.nearest (queries);
  assert (nearest, read (folder, "nearest", "int64", 1) + 1);
  segment = read (folder, "segment", "double", 3);
  [way, parameters] = t.traverse_segment (segment(1, :), segment(2, :));
  assert (way, read (folder, "way", "int64", 1) + 1);
  assert (parameters, read (folder, "way_parameters", "double", 1));
  [way, parameters] = t.traverse_segment ([5 5 5], [6 6 6]);
  assert (isempty (way) && isempty (parameters));
  refused ("mgdt:not_finite", {"x of a"}, @() t.traverse_segment ([NaN 0 0], [1 1 1]));
  refused ("mgdt:invalid_argument", {"3 coordinates"}, @() t.traverse_segment ([0 0 0], 1));
  refused ("mgdt:invalid_argument", {"full vectors"}, @() t.traverse_segment (sparse ([0.5 0.25 0]), [1 1 1]));
  assert (nearest, dsearchn (points(1:1000, :), queries));
  assert (mgdt_triangulation ().nearest ([0 0 0]), NaN);
  assert (mgdt_triangulation ().locate ([0 0 0]), NaN);
  assert (size (t.locate (zeros (0, 3))), [0 1]);
end

function changes (folder)
  points = read_points (folder);
  n = rows (points);
  t = mgdt_triangulation ("canonical", true);
  t.insert (points);
  out = (1:3:n)';
  some = (2:3:n)';
  places = points;
  places(some, 3) += 1;
  t.move (some, places(some, :));
  t.remove (int32 (out));
  places(out, :) = NaN;
  t.move ([], places);
  index = t.renumber ();
  assert (index(1:6), [0 1 2 0 3 4]');
  places(out, :) = [];
  assert (t.point_count (), rows (places));
  fresh = mgdt_triangulation ("canonical", true);
  fresh.insert (places);
  assert (t.tetrahedra (), fresh.tetrahedra ());
  t.check ();
  t.set ("progress", @(fraction) true);
  refused ("mgdt:cancelled", {"after 0 of 1"}, @() t.remove (1));
  refused ("mgdt:cancelled", {"after 0 of 1"}, @() t.move (1, [5 5 5]));
  t.set ("progress", []);
  refused ("mgdt:invalid_argument", {"point 3"}, @() t.remove ([3 3]));
  refused ("mgdt:invalid_argument", {"0.5"}, @() t.remove (0.5));
  refused ("mgdt:invalid_argument", {"numeric"}, @() t.remove ({}));
  refused ("mgdt:invalid_argument", {"1 points and 2 places"}, @() t.move (3, [0 0 0; 1 1 1]));
  refused ("mgdt:not_finite", {"point 3"}, @() t.move (3, [0 NaN 0]));
  t.remove ([]);
  assert (t.point_count (), rows (places));
end

function settings (folder)
  t = mgdt_triangulation ();
  assert ({t.get("order"), t.get("threads"), t.get("separation"), t.get("compact")}, ...
          {"auto", 1, 2, false});
  t = mgdt_triangulation ("order", "kd-tree", "seed", 7, "threads", 3, "memory_limit", 2^40, ...
                          "compact", true, "canonical", true, "separation", "passes", ...
                          "threshold", 50);
  assert ({t.get("order"), t.get("seed"), t.get("threads"), t.get("memory_limit")}, ...
          {"kd-tree", 7, 3, 2^40});
  assert ({t.get("compact"), t.get("canonical"), t.get("separation"), t.get("threshold")}, ...
          {true, true, 1, 50});
  assert (t.get ("isa"), t.isa_name ());
  assert (isempty (t.get ("progress")));
  refused ("mgdt:unknown_key", {}, @() t.get ("depth"));
  refused ("mgdt:invalid_argument", {"apart"}, @() t.set ("separation", "apart"));
  t.insert (rand (1000, 3));
  before = t.statistics ().memory_bytes;
  t.shrink ();
  assert (t.statistics ().memory_bytes < before);
  t.check ();
end

function flat (folder)
  t = mgdt_triangulation ();
  assert (t.dimension (), -1);
  [x, y] = ndgrid (0:9);
  t.insert ([x(:) y(:) zeros(100, 1)]);
  assert ([t.dimension() t.tetrahedron_count() t.vertex_count()], [2 0 100]);
  assert (size (t.tetrahedra ()), [0 4]);
  assert (size (t.neighbours ()), [0 4]);
  assert (t.nearest ([3.2 4.1 7]), 44);
  t.check ();
  t.insert ([0 0 1]);
  assert (t.dimension (), 3);
  assert (t.tetrahedron_count () >= 162);
  t.check ();
  t.clear_points ();
  assert (t.point_count (), 0);
  t.insert ([0 0 0; 1 0 0; 0 1 0; 0 0 1]);
  assert (t.tetrahedron_count (), 1);
end

function bad_values (folder)
  points = read_points (folder);
  t = mgdt_triangulation ("canonical", true);
  t.insert (points);
  refused ("mgdt:not_finite", {"point 1012", "y"}, @() t.insert ([0 0 0; 0 NaN 0]));
  refused ("mgdt:not_finite", {"point 1011", "x"}, @() t.insert ([-Inf 0 0]));
  refused ("mgdt:invalid_argument", {"2 x 2", "three columns"}, @() t.insert ([1 2; 3 4]));
  refused ("mgdt:invalid_argument", {"three columns"}, @() t.insert (zeros (2, 3, 2)));
  refused ("mgdt:invalid_argument", {"real"}, @() t.insert ([i 0 0]));
  refused ("mgdt:invalid_argument", {"class char"}, @() t.insert ("abc"));
  refused ("mgdt:invalid_argument", {"class cell"}, @() t.insert ({}));
  refused ("mgdt:unknown_scheme", {"spiral"}, @() t.set ("order", "spiral"));
  refused ("mgdt:invalid_argument", {"order"}, @() t.set ("order", 3));
  refused ("mgdt:unknown_key", {"colour"}, @() t.set ("colour", 1));
  refused ("mgdt:unknown_key", {"index_base"}, @() t.set ("index_base", 0));
  refused ("mgdt:invalid_argument", {"threshold", "-1"}, @() t.set ("threshold", -1));
  refused ("mgdt:invalid_argument", {"threshold"}, @() t.set ("threshold", [1 2]));
  refused ("mgdt:invalid_argument", {"threads"}, @() t.set ("threads", 1.5));
  refused ("mgdt:invalid_argument", {"threads"}, @() t.set ("threads", 1e10));
  refused ("mgdt:invalid_argument", {"negative"}, @() t.set ("memory_limit", -1));
  refused ("mgdt:invalid_argument", {"seed"}, @() t.set ("seed", -1));
  refused ("mgdt:invalid_argument", {"mmx"}, @() t.set ("isa", "mmx"));
  refused ("mgdt:invalid_argument", {"progress"}, @() t.set ("progress", 1));
  refused ("mgdt:invalid_argument", {"value"}, @() mgdt_triangulation ("seed"));
  refused ("mgdt:invalid_argument", {"level"}, @() t.check (9));
  refused ("mgdt:invalid_argument", {"whole"}, @() t.check ("whole"));
  refused ("mgdt:not_finite", {}, @() t.locate ([NaN 0 0]));
  refused ("mgdt:not_finite", {}, @() t.nearest ([NaN 0 0]));
  refused ("mgdt:invalid_argument", {"three columns"}, @() t.locate ([0 0]));
  refused ("mgdt:invalid_argument", {"double"}, @() t.locate (single ([0 0 0])));
  assert (t.point_count (), 1010);
  assert (t.tetrahedra (), read (folder, "tetrahedra", "int64", 4) + 1);
  t.check ();
  t.set ("isa", "baseline");
  assert (t.isa_name (), "baseline");
  t.set ("isa", "");
end

function memory_limit (folder)
  points = read_points (folder);
  t = mgdt_triangulation ("memory_limit", 1e5);
  refused ("mgdt:out_of_memory", {"memory"}, @() t.insert (points));
  t.check ();
  assert (t.statistics ().peak_memory_bytes <= 1e5);
  t.set ("memory_limit", 0);
  t.insert (points);
  assert (t.vertex_count (), 1000);
  t.check ();
end

function compact (folder)
  points = read_points (folder);
  t = mgdt_triangulation ();
  t.insert (points);
  before = t.statistics ().memory_bytes;
  t.set ("compact", true);
  after = t.statistics ().memory_bytes;
  assert (after < before - 100 * 1000);
  t.check ();
  t.set ("memory_limit", 1);
  refused ("mgdt:out_of_memory", {"memory"}, @() t.set ("compact", false));
  t.set ("memory_limit", 0);
  t.set ("compact", false);
  assert (t.statistics ().memory_bytes > after);
  t = mgdt_triangulation ("compact", true, "canonical", true);
  t.insert (points);
  assert (t.statistics ().memory_bytes < before - 100 * 1000);
  t.check ();
end

function stop = remember (fraction)
  global seen
  seen(end+1) = fraction;
  stop = false;
end

function stop = stop_at (at, fraction)
  stop = fraction >= at;
end

function silent (fraction)
  global seen
  seen(end+1) = fraction;
end

function fail_at (at, fraction)
  if (fraction >= at)
    error ("mine:own", "what I say");
  end
end

function progress (folder)
  global seen
  points = read_points (folder);
  for fn = {@remember, @silent, @(fraction) silent(fraction), @(fraction) remember(fraction)}
    seen = [];
    t = mgdt_triangulation ("progress", fn{1});
    t.insert (points);
    assert (numel (seen) > 50);
    assert (issorted (seen) && seen(end) == 1);
  end
  t = mgdt_triangulation ("progress", @(fraction) stop_at (0.4, fraction));
  refused ("mgdt:cancelled", {"1010 points"}, @() t.insert (points));
  t.check ();
  assert (t.vertex_count () > 100 && t.vertex_count () < 1000);
  t.set ("progress", []);
  t.insert (points);
  assert (t.vertex_count (), 1000);
  t.check ();
  t = mgdt_triangulation ();
  t.cancel ();
  refused ("mgdt:cancelled", {}, @() t.insert (points));
  t.set ("progress", @(fraction) t.cancel ());
  refused ("mgdt:cancelled", {}, @() t.insert (points));
  for at = [0 0.5 1]
    t = mgdt_triangulation ("progress", @(fraction) fail_at (at, fraction));
    refused ("mine:own", {"what I say"}, @() t.insert (points));
    t.check ();
  end
  t = mgdt_triangulation ();
  t.set ("progress", @(fraction) t.point_count ());
  refused ("mgdt:busy", {"progress function"}, @() t.insert (points));
  t.set ("progress", @(fraction) t.close ());
  refused ("mgdt:busy", {"progress function"}, @() t.insert (points));
  % Handles that a progress function makes move the table of handles.
  t.set ("progress", @(fraction) numel (arrayfun (@(k) mgdt_delaunay (rand (9, 3))(1), 1:40)) < 0);
  t.insert (points);
  t.check ();
end

function handles (folder)
  t = mgdt_triangulation ();
  u = t;
  t.insert ([0 0 0]);
  assert (u.point_count (), 1);
  v = mgdt_triangulation ();
  assert (v.point_count (), 0);
  t.close ();
  t.close ();
  refused ("mgdt:null_pointer", {"closed"}, @() u.point_count ());
  refused ("mgdt:null_pointer", {"closed"}, @() u.insert ([0 0 0]));
  refused ("mgdt:null_pointer", {"closed"}, @() u.cancel ());
  refused ("mgdt:null_pointer", {"closed"}, @() mgdt_mex ("count", [0 12345], "points"));
  refused ("mgdt:null_pointer", {"closed"}, @() mgdt_mex ("count", [1e9 1], "points"));
  refused ("mgdt:null_pointer", {"closed"}, @() mgdt_mex ("count", [NaN 1], "points"));
  refused ("mgdt:invalid_argument", {"handle"}, @() mgdt_mex ("count", "x", "points"));
  refused ("mgdt:invalid_argument", {"handle"}, @() mgdt_mex ("count"));
  refused ("mgdt:invalid_argument", {"command"}, @() mgdt_mex ());
  w = mgdt_mex ("create");
  refused ("mgdt:invalid_argument", {"command"}, @() mgdt_mex ("dance", w));
  refused ("mgdt:invalid_argument", {"setting"}, @() mgdt_mex ("set", w));
  refused ("mgdt:invalid_argument", {"matrix"}, @() mgdt_mex ("insert", w));
  refused ("mgdt:invalid_argument", {"count"}, @() mgdt_mex ("count", w));
  refused ("mgdt:invalid_argument", {"whole"}, @() mgdt_mex ("check", w, 0.5));
  mgdt_mex ("destroy", w);
  % Code that has handles stays loaded.
  clear ("mgdt_mex");
  v.insert ([0 0 0]);
  assert (v.point_count (), 1);
  assert (! isempty (regexp (mgdt_triangulation.version (), '^\d+\.\d+\.\d+$')));
end

function bytes = resident ()
  file = fopen ("/proc/self/statm", "r");
  pages = fscanf (file, "%d");
  fclose (file);
  bytes = 4096 * pages(2);
end

function held = make (points, close)
  held = 0;
  for k = 1:1000
    t = mgdt_triangulation ();
    t.insert (points);
    held += t.statistics ().memory_bytes;
    if (close)
      t.close ();
    end
  end
end

function freed (folder)
  points = read_points (folder);
  for close = [false true]
    make (points, close);
    before = resident ();
    held = make (points, close);
    grown = resident () - before;
    printf ("  %d MB in 1000 handles; the process grew by %.1f MB\n", round (held / 1e6), ...
            grown / 1e6);
    assert (held > 200e6);
    assert (grown < 40e6);
  end
end

function help_texts (folder)
  for name = {"mgdt_delaunay", "mgdt_triangulation"}
    text = help (name{1});
    assert (! isempty (strfind (text, name{1})));
    assert (! isempty (strfind (text, "Errors")));
  end
end
