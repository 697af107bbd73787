% SPDX-License-Identifier: MIT
classdef mgdt_triangulation < handle
  % -- t = mgdt_triangulation ()
  % -- t = mgdt_triangulation (NAME, VALUE, ...)
  %
  % A Delaunay triangulation that grows as points are inserted.
  %
  %   t = mgdt_triangulation ("canonical", true);
  %   t.insert (rand (1000, 3));
  %   tetrahedra = t.tetrahedra ();
  %   [where, weights] = t.locate ([0.5 0.5 0.5]);
  %
  % Points and tetrahedra are numbered from 1 and given in rows. t is a handle: a copy of it is the
  % same triangulation. Its memory is freed with the last copy, or by t.close ().
  %
  % Settings, as NAME and VALUE or by t.set (NAME, VALUE); t.get (NAME) gives each:
  %   "order"         scheme of insertion, by name: see mgdt_triangulation.schemes ()
  %   "points_per_cell", "threshold", "separation", "round_ratio"   its parameters; a separation
  %                   is "none", "passes", "rounds" or its number
  %   "seed"          of the schemes that shuffle
  %   "threads"       0 for all cores
  %   "memory_limit"  bytes; 0 for none
  %   "compact"       true: 30 % less memory, 20 to 40 % more time; at any time
  %   "canonical"     true: the output is a function of the set of points alone
  %   "isa"           instruction set; "" for the best
  %   "progress"      function of the fraction done, 0 to 1; a true result stops the insertion
  %
  % Errors have the identifiers mgdt:invalid_argument, mgdt:not_finite (the message names the
  % point), mgdt:unknown_scheme, mgdt:unknown_key, mgdt:out_of_memory, mgdt:too_large,
  % mgdt:cancelled, mgdt:busy (a progress function called its triangulation), mgdt:check_failed,
  % mgdt:null_pointer (closed) and mgdt:library (libmgdt was not found).
  %
  % See also: mgdt_delaunay

  properties (Access = private)
    id = [];
    progress = [];
  end

  methods
    function t = mgdt_triangulation (varargin)
      t.id = mgdt_mex ("create");
      if (mod (numel (varargin), 2) != 0)
        error ("mgdt:invalid_argument", "mgdt: a setting without a value");
      end
      for k = 1:2:numel (varargin)
        t.set (varargin{k}, varargin{k+1});
      end
    end

    % Frees the memory now. Every later call but close is an error.
    function close (t)
      if (! isempty (t.id))
        mgdt_mex ("destroy", t.id);
        t.id = [];
      end
    end

    function delete (t)
      t.close ();
    end

    function set (t, name, value)
      if (strcmp (name, "progress"))
        if (! (isempty (value) || is_function_handle (value)))
          error ("mgdt:invalid_argument", "mgdt: progress must be a function handle or []");
        end
        t.progress = value;
      else
        mgdt_mex ("set", t.handle (), name, value);
      end
    end

    % A setting as it is set. Since 1.2.
    function value = get (t, name)
      if (strcmp (name, "progress"))
        value = t.progress;
      else
        value = mgdt_mex ("get", t.handle (), name);
      end
    end

    % Name of the instruction set in use.
    function name = isa_name (t)
      name = t.get ("isa");
    end

    % Frees what is kept for speed alone; it is made again when it is wanted. Since 1.2.
    function shrink (t)
      mgdt_mex ("shrink", t.handle ());
    end

    % Inserts points, n x 3; any number of times.
    function insert (t, points)
      mgdt_mex ("insert", t.handle (), t.doubles (points, "points"), t.progress);
    end

    % Takes points out, given by their numbers, each once; the others keep theirs. Since 1.2.
    function remove (t, points)
      mgdt_mex ("remove", t.handle (), t.doubles (points, "points"), t.progress);
    end

    % Moves points, given by their numbers, each once, to the rows of an n x 3 matrix; t.move ([],
    % places) moves all in their order, where those that are not in stay out. Since 1.2.
    function move (t, points, places)
      mgdt_mex ("move", t.handle (), t.doubles (points, "points"), ...
                t.doubles (places, "places"), t.progress);
    end

    % Numbers the points that are in anew, in their order, and forgets the others: the new number of
    % each point, n x 1; 0 if it was not in. Since 1.2.
    function index = renumber (t)
      index = mgdt_mex ("renumber", t.handle ());
    end

    % Takes all points out; settings stay.
    function clear_points (t)
      mgdt_mex ("clear", t.handle ());
    end

    % Announces how many points will be given in all. Optional.
    function reserve (t, n)
      mgdt_mex ("reserve", t.handle (), n);
    end

    % Stops the insertion, removal or move that is running (from a progress function), or else the next one.
    function cancel (t)
      mgdt_mex ("cancel", t.handle ());
    end

    % Counts. The dimension is -1 (empty), 0, 1, 2 or 3; there are tetrahedra only at 3.
    function n = point_count (t)
      n = mgdt_mex ("count", t.handle (), "points");
    end
    function n = vertex_count (t)
      n = mgdt_mex ("count", t.handle (), "vertices");
    end
    function n = dimension (t)
      n = mgdt_mex ("count", t.handle (), "dimension");
    end
    function n = tetrahedron_count (t)
      n = mgdt_mex ("count", t.handle (), "tetrahedra");
    end
    function n = hull_facet_count (t)
      n = mgdt_mex ("count", t.handle (), "hull_facets");
    end
    function n = edge_count (t)
      n = mgdt_mex ("count", t.handle (), "edges");
    end

    % Vertices of each tetrahedron, m x 4, positively oriented.
    function v = tetrahedra (t)
      v = mgdt_mex ("export", t.handle (), "tetrahedra");
    end

    % Neighbours of each tetrahedron, m x 4: column i is opposite vertex i; 0 on the hull.
    function v = neighbours (t)
      v = mgdt_mex ("export", t.handle (), "neighbors");
    end

    % Triangles of the convex hull, h x 3, counter-clockwise seen from outside.
    function v = hull_facets (t)
      v = mgdt_mex ("export", t.handle (), "hull_facets");
    end

    % Edges, e x 2, the lesser number first.
    function v = edges (t)
      v = mgdt_mex ("export", t.handle (), "edges");
    end

    % For each point the number of the one that stands for it; 0 if it is not in.
    function v = point_map (t)
      v = mgdt_mex ("export", t.handle (), "point_map");
    end

    % Tetrahedra around each vertex: those of point k are list(offsets(k):offsets(k+1)-1).
    function [offsets, list] = vertex_tetrahedra (t)
      [offsets, list] = mgdt_mex ("vertex_tetrahedra", t.handle ());
    end

    % Neighbours of each vertex, those that edges join it to, in the same way.
    function [offsets, list] = vertex_neighbors (t)
      [offsets, list] = mgdt_mex ("vertex_neighbors", t.handle ());
    end

    % Edges that are the diameter of a sphere with no vertex inside, g x 2.
    function v = gabriel_edges (t)
      v = mgdt_mex ("export", t.handle (), "gabriel_edges");
    end

    % Edges of the Euclidean minimum spanning tree, s x 2.
    function v = spanning_tree (t)
      v = mgdt_mex ("export", t.handle (), "spanning_tree");
    end

    % Centres of the circumspheres of the tetrahedra, m x 3, and the squares of the radii, m x 1.
    function [centers, squares] = circumcenters (t)
      [centers, squares] = mgdt_mex ("circumcenters", t.handle ());
    end

    % Alphas, squares of radii: of the tetrahedra, m x 1 (dimension 3), of the facets opposite their
    % vertices, m x 4 (2), of the edges, e x 1 (1), or of the points, n x 1 (0).
    function x = alphas (t, dimension)
      x = mgdt_mex ("alphas", t.handle (), dimension);
    end

    % The surface of an alpha shape, f x 3, counter-clockwise seen from outside.
    function v = alpha_surface (t, alpha2)
      v = mgdt_mex ("alpha_surface", t.handle (), alpha2);
    end

    % The least alpha with all vertices in one solid.
    function alpha2 = solid_alpha (t)
      alpha2 = mgdt_mex ("solid_alpha", t.handle ());
    end

    % A measure of each tetrahedron, m x 1: "volume", "radius_ratio", "least_dihedral_angle" or "largest_dihedral_angle"
    % (dihedral, in radians), or "longest_edge"; since 1.4 "volume_length" or "edge_ratio". Since 1.3.
    function x = tetrahedron_measures (t, measure)
      names = {"volume", "radius_ratio", "least_dihedral_angle", "largest_dihedral_angle", "longest_edge", ...
               "volume_length", "edge_ratio"};
      keys = [10 20 30 31 40];
      if (! ischar (measure) || ! any (strcmp (measure, names)))
        error ("mgdt:unknown_key", "mgdt: the measure must be one of %s", strjoin (names, ", "));
      end
      x = mgdt_mex ("tetrahedron_measures", t.handle (), keys(strcmp (measure, names)));
    end

    % A measure of each point's Voronoi cell, n x 1: "volume", "area" or "faces", or "centroid", n x 3.
    % Cells are clipped to the planes a b c d of a p x 4 matrix, where a x + b y + c z <= d; without
    % any, those of hull vertices are infinite.
    function x = cell_measures (t, measure, planes)
      names = {"volume", "area", "centroid", "faces"};
      if (! ischar (measure) || ! any (strcmp (measure, names)))
        error ("mgdt:unknown_key", "mgdt: the measure must be one of %s", strjoin (names, ", "));
      end
      if (nargin < 3)
        planes = zeros (0, 4);
      end
      x = mgdt_mex ("cell_measures", t.handle (), 10 * find (strcmp (measure, names)), planes);
    end

    % The Voronoi diagram of the points, a struct of matrices with a row for each vertex, face, ray or
    % point: vertices, face_offsets, face_corners, face_sides, face_areas, face_normals,
    % face_centroids, ray_vertices, ray_directions, cell_offsets, cell_faces, cell_bounded,
    % cell_volumes, cell_centroids, cell_neighbors, cell_face_areas, cell_neighbor_distances. The corners of face
    % k are
    % v.face_corners(v.face_offsets(k):v.face_offsets(k+1)-1): rows of vertices, or rays: -r is row r
    % of ray_vertices. The faces of the cell of a point are in cell_faces in the same way. The sides
    % of a face are two points, or a point and -p, row p of the planes. cell_neighbors, cell_face_areas and
    % cell_neighbor_distances have a row for each row of cell_faces: the other side of the face, its area, and
    % the distance of the cell's point from that side. Cells are clipped as by
    % cell_measures. Faces with less area than least_area are left out, and those with less than
    % least_share of the area of each of their cells. Since 1.3.
    function v = voronoi (t, planes, least_area, least_share)
      if (nargin < 2)
        planes = zeros (0, 4);
      end
      if (nargin < 3)
        least_area = 0;
      end
      if (nargin < 4)
        least_share = 0;
      end
      v = mgdt_mex ("voronoi", t.handle (), t.doubles (planes, "planes"), least_area, least_share);
    end

    % Tetrahedra that contain the points of an n x 3 matrix, n x 1, NaN outside the hull, and the
    % barycentric weights of their vertices, n x 4: as tsearchn.
    function [where, weights] = locate (t, points)
      if (nargout < 2)
        where = mgdt_mex ("locate", t.handle (), points);
      else
        [where, weights] = mgdt_mex ("locate", t.handle (), points);
      end
    end

    % The tetrahedra that the segment from a to b passes through, in order, n x 1, and the parameters
    % between them: tetrahedron k is entered at a + parameters(k) * (b - a) and left at
    % a + parameters(k+1) * (b - a). Since 1.3.
    function [tetrahedra, parameters] = traverse_segment (t, a, b)
      [tetrahedra, parameters] = mgdt_mex ("traverse_segment", t.handle (), a, b);
    end

    % Vertices nearest to the points of an n x 3 matrix, n x 1, NaN if there are none: as dsearchn.
    function v = nearest (t, points)
      v = mgdt_mex ("nearest", t.handle (), points);
    end

    % Values at the places of an m x 3 matrix, m x f, from values at the points, n x f. The method is
    % "linear", "nearest", "sibson", "laplace" or "sibson_c1"; outside the hull "none" (NaN, the
    % default), "nearest", "boundary" or "linear".
    function x = interpolate (t, method, values, places, outside)
      if (nargin < 5)
        outside = "none";
      end
      x = mgdt_mex ("interpolate", t.handle (), t.key ("method", method), ...
                    t.key ("outside", outside), t.doubles (values, "values"), places);
    end

    % The same as weights: a sparse matrix w, m x n, for which w * values are the values. Rows of
    % places without a value are empty.
    function w = interpolation_weights (t, method, places, outside)
      if (nargin < 4)
        outside = "none";
      end
      [i, j, x] = mgdt_mex ("interpolation_weights", t.handle (), t.key ("method", method), ...
                            t.key ("outside", outside), places);
      w = sparse (i, j, x, rows (places), t.point_count ());
    end

    % Gradients of values at the points, n x f, as rows x y z: n x 3, or n x 3 x f of several fields.
    function g = gradients (t, values)
      g = mgdt_mex ("gradients", t.handle (), t.doubles (values, "values"));
      g = reshape (g, [rows(g), 3, columns(g) / 3]);
    end

    % Proves the triangulation by exact arithmetic; mgdt:check_failed says what is wrong. Levels:
    % "combinatorial", "geometric", "canonical" (default).
    function check (t, level)
      if (nargin < 2)
        level = 3;
      elseif (ischar (level))
        names = {"combinatorial", "geometric", "canonical"};
        if (! any (strcmp (level, names)))
          error ("mgdt:invalid_argument", "mgdt: there is no level %s of the check", level);
        end
        level = find (strcmp (level, names));
      end
      mgdt_mex ("check", t.handle (), level);
    end

    % All figures, as a struct.
    function s = statistics (t)
      s = mgdt_mex ("statistics", t.handle ());
    end

    function disp (t)
      if (isempty (t.id))
        printf ("  mgdt triangulation (closed)\n");
      else
        printf ("  mgdt triangulation: %d points, %d tetrahedra\n", t.point_count (), ...
                t.tetrahedron_count ());
      end
    end
  end

  methods (Static)
    % Names of the order schemes.
    function names = schemes ()
      names = mgdt_mex ("schemes");
    end

    % Version of the library that is loaded.
    function text = version ()
      text = mgdt_mex ("version");
    end
  end

  methods (Access = private)
    % The library's number of a name.
    function k = key (t, kind, name)
      if (strcmp (kind, "method"))
        names = {"linear", "nearest", "sibson", "laplace", "sibson_c1"};
      else
        names = {"none", "nearest", "boundary", "linear"};
      end
      if (! ischar (name) || ! any (strcmp (name, names)))
        error ("mgdt:unknown_key", "mgdt: %s must be one of %s", kind, strjoin (names, ", "));
      end
      k = 10 * find (strcmp (name, names));
    end

    function x = doubles (t, x, name)
      if (! isa (x, "double") || issparse (x))
        if (! (isnumeric (x) || islogical (x)))
          error ("mgdt:invalid_argument", "mgdt: %s are of class %s; they must be numeric", ...
                 name, class (x));
        end
        x = double (full (x));
      end
    end

    function id = handle (t)
      id = t.id;
      if (isempty (id))
        error ("mgdt:null_pointer", "mgdt: the triangulation is closed");
      end
    end
  end
end
