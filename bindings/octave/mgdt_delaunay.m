% SPDX-License-Identifier: MIT

% -- tetrahedra = mgdt_delaunay (points)
% -- [tetrahedra, neighbours, map] = mgdt_delaunay (points)
% -- ... = mgdt_delaunay (points, NAME, VALUE, ...)
%
% The exact Delaunay triangulation of points in space.
%
% points      n x 3 matrix, one point a row; read in place if it is of class double
% tetrahedra  m x 4, rows of points, positively oriented; 0 x 4 if the points do not span space
% neighbours  m x 4, rows of tetrahedra: neighbour i is opposite vertex i, 0 on the hull
% map         n x 1, for each point the first one at the same place, which stands for it
%
% No tetrahedron has zero volume, and every point that is not a duplicate is a vertex, whatever the
% points are: unlike delaunayn, it needs no options for grids or points on a sphere.
%
% NAME and VALUE are settings of mgdt_triangulation, such as "canonical", true.
%
% Errors: mgdt:not_finite (NaN or infinity; the message names the point), mgdt:invalid_argument,
% mgdt:out_of_memory, mgdt:library (libmgdt was not found).
%
% See also: mgdt_triangulation, delaunayn
function [tetrahedra, neighbours, map] = mgdt_delaunay (points, varargin)
  if (nargin < 1)
    print_usage ();
  end
  t = mgdt_triangulation (varargin{:});
  t.insert (points);
  tetrahedra = t.tetrahedra ();
  if (nargout > 1)
    neighbours = t.neighbours ();
  end
  if (nargout > 2)
    map = t.point_map ();
  end
end
