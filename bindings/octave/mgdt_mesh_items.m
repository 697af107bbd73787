% SPDX-License-Identifier: MIT

% items = mgdt_mesh_items (points, tetrahedra, given)
%
% What makes a mesh, in the order of mgdt_mex, from a struct of settings. For mgdt_improve and
% mgdt_mesh_places alone.
function items = mgdt_mesh_items (points, tetrahedra, given)
  corners = cell (1, 3);
  rows_of = {tetrahedra, 4, "tetrahedra"; given.faces, 3, "faces"; given.edges, 2, "edges"};
  for k = 1:3
    if (! isempty (rows_of{k,1}) && columns (rows_of{k,1}) != rows_of{k,2})
      error ("mgdt:invalid_argument", "mgdt: %s must have %d columns", rows_of{k,[3 2]});
    end
    corners{k} = double (vec (rows_of{k,1}'));
  end
  items = {double(points), corners{1}, double(given.markers(:)), corners{2}, double(given.face_markers(:)), ...
           corners{3}, double(given.edge_markers(:)), given.threads, given.memory_limit};
end
