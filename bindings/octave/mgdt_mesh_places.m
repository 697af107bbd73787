% SPDX-License-Identifier: MIT

% -- tetrahedra = mgdt_mesh_places (mesh, places)
% -- [tetrahedra, weights] = mgdt_mesh_places (mesh, places)
% -- [tetrahedra, weights, values] = mgdt_mesh_places (mesh, places, of_points)
% -- [...] = mgdt_mesh_places (..., "nearest")
%
% The tetrahedra of a mesh that contain places, exactly, also where the mesh is not convex; 0 outside.
% Since 1.4.
%
% mesh       a struct with points (n x 3) and tetrahedra (m x 4), as of mgdt_domain_mesh or mgdt_improve
% places     k x 3
% of_points  n x f, values at the points of the mesh
%
% weights (k x 4) are barycentric coordinates, in the order of the corners. values (k x f) are linear in
% each tetrahedron, and NaN outside. With "nearest", the nearest place of the boundary stands for a place
% outside. Each call makes the mesh anew, so give all places at once.
%
% Errors: mgdt:invalid_argument (what is no mesh, with the numbers of what is wrong), mgdt:not_finite,
% mgdt:out_of_memory.
%
% See also: mgdt_domain_mesh, mgdt_improve
function [tetrahedra, weights, values] = mgdt_mesh_places (mesh, places, varargin)
  if (nargin < 2 || nargin > 4 || ! isstruct (mesh))
    print_usage ();
  end
  nearest = ! isempty (varargin) && strcmp (varargin{end}, "nearest");
  varargin = varargin(1:end - nearest);
  of_points = [];
  if (! isempty (varargin))
    of_points = varargin{1};
  elseif (nargout > 2)
    error ("mgdt:invalid_argument", "mgdt: values at the points are needed");
  end
  given = struct ("markers", [], "faces", [], "face_markers", [], "edges", [], "edge_markers", [], ...
                  "threads", 1, "memory_limit", 0);
  items = mgdt_mesh_items (mesh.points, mesh.tetrahedra, given);
  [tetrahedra, weights, values] = mgdt_mex ("mesh_places", items{:}, double (places), double (nearest), ...
                                            double (of_points));
end
