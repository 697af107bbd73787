% SPDX-License-Identifier: MIT

% -- mesh = mgdt_refine (points, tetrahedra)
% -- mesh = mgdt_refine (mesh)
% -- mesh = mgdt_refine (..., NAME, VALUE, ...)
%
% Inserts points into a mesh until its tetrahedra have the wanted sizes and shapes. Faces, edges, regions
% and markers stay. mgdt_improve is the next step, which removes flat tetrahedra. Since 1.4.
%
% points      n x 3 matrix
% tetrahedra  m x 4 matrix of rows of points; the corners may have any order
% mesh        a struct of mgdt_domain_mesh, of mgdt_improve or of this function, in place of both
%
% NAME and VALUE:
%
% "size"               the length of edges everywhere; 0, as in the next three, for any
% "point_sizes"        one for each point
% "tetrahedron_sizes"  one for each tetrahedron, such as an estimate of an error wants it
% "region_sizes"       one for each region, in the order of region_markers
% "size_field"         {points, sizes}: sizes at points in space, linear between them
% "size_function"      a function of an n x 3 matrix of places that gives n sizes, 0 for any
% "sizes_of_surface"   true if edges at a point are to be as long as those of the surface there
% "gradation"          how fast sizes may grow with the distance; 0.3 at first
% "radius_edge"        the most that the radius of a circumsphere should be, in shortest edges of its
%                      tetrahedron; 1.4 at first, 0 for any
% "volume"             the most volume that a tetrahedron should have, 0 for any
% "most_points"        the most points that are inserted, 0 for any number
% "markers", "faces", "face_markers", "edges", "edge_markers", "threads", "memory_limit", "progress", "check"
%                      as for mgdt_improve
%
% The result is a struct as that of mgdt_domain_mesh, without open_edges, and with refusals (for each
% tetrahedron why it was not divided, or 0) and sizes (that were wanted at each point, or 0).
% mgdt/mgdt_mesh.h says what they mean.
%
% Errors: as those of mgdt_improve.
%
% See also: mgdt_domain_mesh, mgdt_improve
function mesh = mgdt_refine (points, varargin)
  if (nargin < 1 || (! isstruct (points) && nargin < 2))
    print_usage ();
  end
  own = struct ("size", 0, "point_sizes", [], "tetrahedron_sizes", [], "region_sizes", [], ...
                "size_field", {{[], []}}, "size_function", [], ...
                "sizes_of_surface", false, "gradation", 0.3, "radius_edge", 1.4, "volume", 0, "most_points", 0);
  [items, given] = mgdt_mesh_settings (points, varargin, own, "a refinement");
  if (! iscell (given.size_field) || numel (given.size_field) != 2)
    error ("mgdt:invalid_argument", "mgdt: size_field must be a cell of points and sizes");
  end
  mesh = mgdt_mex ("refine", items{:}, double (given.point_sizes(:)), double (given.tetrahedron_sizes(:)), ...
                   double (given.region_sizes(:)), double (given.size_field{1}), double (given.size_field{2}(:)), ...
                   given.size_function, given.size, given.gradation, given.radius_edge, given.volume, ...
                   given.most_points, double (given.sizes_of_surface), given.progress, double (given.check));
end
