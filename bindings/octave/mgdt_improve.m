% SPDX-License-Identifier: MIT

% -- mesh = mgdt_improve (points, tetrahedra)
% -- mesh = mgdt_improve (mesh)
% -- mesh = mgdt_improve (..., NAME, VALUE, ...)
%
% Makes the worst tetrahedra of a mesh better, until all dihedral angles reach a goal, or nothing helps.
% The shape of the surface stays. Since 1.4.
%
% points      n x 3 matrix
% tetrahedra  m x 4 matrix of rows of points; the corners may have any order
% mesh        a struct of this function, of mgdt_refine or of mgdt_domain_mesh, in place of both
%
% NAME and VALUE:
%
% "markers"          one for each tetrahedron; those with one marker form a region
% "faces"            f x 3, rows of points: faces with markers, and faces inside that have to stay
% "face_markers"     one for each face
% "edges"            e x 2, rows of points: edges that have to stay
% "edge_markers"     one for each edge
% "fixed"            points that stay where they are
% "goal"             the least dihedral angle, in degrees from 0 to 70; 25 at first
% "boundary"         "fixed", or "slide" if points of the surface may move within their facets
% "keep"             what happens to points: "all" leaves them where they are, "numbers" (at first) moves
%                    them, "none" may also leave some without a tetrahedron
% "mean_passes"      passes for the mean of the shapes, such as 3; 0 at first
% "most_passes"      a limit for goals that are out of reach; 100 at first
% "threads"          0 for all cores
% "memory_limit"     bytes, 0 for none
% "progress"         a function that hears of the fraction done; true cancels
% "check"            true to prove the mesh; mgdt:check_failed says what is wrong
%
% The result is a struct as that of mgdt_domain_mesh, without open_edges, and with shapes (3 x 2: the
% least and the largest angle in degrees, and the mean shape, before and after), angle_histogram (18 x 2,
% by tens of degrees), tetrahedra_below (6 x 2: with an angle below 5, 10, 15, 20, 25 and 30 degrees), and
% reasons (for each tetrahedron why it is below the goal, or 0). mgdt/mgdt_mesh.h says what they mean.
%
% Errors: mgdt:invalid_argument (what is no mesh, with the numbers of what is wrong), mgdt:not_finite,
% mgdt:cancelled, mgdt:out_of_memory.
%
% See also: mgdt_domain_mesh, mgdt_refine
function mesh = mgdt_improve (points, varargin)
  if (nargin < 1 || (! isstruct (points) && nargin < 2))
    print_usage ();
  end
  own = struct ("fixed", [], "goal", 25, "boundary", "fixed", "keep", "numbers", "mean_passes", 0, "most_passes", 100);
  [items, given] = mgdt_mesh_settings (points, varargin, own, "an improvement");
  number = @(value, names) find (strcmp (value, names)) - 1;
  boundary = number (given.boundary, {"fixed", "slide"});
  keep = number (given.keep, {"all", "numbers", "none"});
  if (isempty (boundary) || isempty (keep))
    error ("mgdt:invalid_argument", "mgdt: boundary is \"fixed\" or \"slide\"; keep is \"all\", \"numbers\" or \"none\"");
  end
  mesh = mgdt_mex ("improve", items{:}, double (given.fixed(:)), given.goal, boundary, keep, given.mean_passes, ...
                   given.most_passes, given.progress, double (given.check));
end
