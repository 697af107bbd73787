% SPDX-License-Identifier: MIT

% -- box = mgdt_periodic_box (points, vectors)
% -- box = mgdt_periodic_box (points, vectors, NAME, VALUE, ...)
%
% The Delaunay triangulation of points in a periodic box: of the infinite set of their images. Since
% 1.3.
%
% points   n x 3 matrix; they may lie anywhere
% vectors  one to three vectors, one a row, or a row of three lengths of a box along the axes
%
% NAME and VALUE:
%
% "measures"      true for volumes, areas, centroids (from the points) and faces of the cells
% "cells"         true for the Voronoi diagram, a struct as that of voronoi of a triangulation; its
%                 face_shifts say how often each vector is added to the second point of a face
% "least_area"    of the diagram: faces with less are left out
% "least_share"   likewise those with less than this share of the area of each of their cells
% "merge_distance"  points that have images within this distance of each other become equal
% "threads"       0 for all cores
% "memory_limit"  bytes, 0 for none
% "progress"      a function that hears of the fraction done; true cancels
% "check"         true to prove the triangulation; mgdt:check_failed says what is wrong
%
% The result is a struct: points and vectors, rounded; tetrahedra and neighbours (t x 4), shifts and
% neighbour_shifts (t x 12, three for each corner: how often each vector is added to its point);
% point_map and point_shifts; vertex_neighbour_offsets, vertex_neighbours and vertex_neighbour_shifts.
% mgdt/mgdt_periodic.h says what they mean. 0 stands for no neighbour.
%
% See also: mgdt_delaunay
function box = mgdt_periodic_box (points, vectors, varargin)
  if (nargin < 2)
    print_usage ();
  end
  given = struct ("threads", 1, "memory_limit", 0, "progress", [], "check", false, "measures", false, ...
                  "cells", false, "least_area", 0, "least_share", 0, "merge_distance", 0);
  if (mod (numel (varargin), 2) != 0)
    error ("mgdt:invalid_argument", "mgdt: a setting has no value");
  end
  for k = 1:2:numel (varargin)
    if (! ischar (varargin{k}) || ! isfield (given, varargin{k}))
      error ("mgdt:unknown_key", "mgdt: settings of a box are %s", strjoin (fieldnames (given)', ", "));
    end
    given.(varargin{k}) = varargin{k + 1};
  end
  if (rows (vectors) == 1 && columns (vectors) == 3 && all (vectors != 0))
    vectors = diag (vectors);
  end
  box = mgdt_mex ("periodic_box", double (points), full (double (vectors)), given.threads, ...
                  given.memory_limit, given.progress, given.check, given.measures, given.cells, ...
                  given.least_area, given.least_share, given.merge_distance);
end
