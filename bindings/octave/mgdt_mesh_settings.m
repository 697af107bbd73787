% SPDX-License-Identifier: MIT

% [items, given] = mgdt_mesh_settings (points, others, own, what)
%
% What makes a mesh, in the order of mgdt_mex, and the settings of what changes it: points and others are
% the arguments of mgdt_improve or mgdt_refine, which have the settings in own beside those of all meshes.
function [items, given] = mgdt_mesh_settings (points, others, own, what)
  given = struct ("markers", [], "faces", [], "face_markers", [], "edges", [], "edge_markers", [], ...
                  "threads", 1, "memory_limit", 0, "progress", [], "check", false);
  for name = fieldnames (own)'
    given.(name{1}) = own.(name{1});
  end
  if (isstruct (points))
    before = points;
    points = before.points;
    tetrahedra = before.tetrahedra;
    given.markers = before.region_markers(before.tetrahedron_regions);
    % Faces without a tetrahedron belong to no mesh.
    is_at_one = any (before.face_tetrahedra > 0, 2);
    given.faces = before.faces(is_at_one,:);
    given.face_markers = before.face_markers(is_at_one);
    given.edges = before.edges(before.edge_segments > 0,:);
    given.edge_markers = before.edge_markers(before.edge_segments > 0);
    settings = others;
  else
    tetrahedra = others{1};
    settings = others(2:end);
  end
  if (mod (numel (settings), 2) != 0)
    error ("mgdt:invalid_argument", "mgdt: a setting has no value");
  end
  for k = 1:2:numel (settings)
    if (! ischar (settings{k}) || ! isfield (given, settings{k}))
      error ("mgdt:unknown_key", "mgdt: settings of %s are %s", what, strjoin (fieldnames (given)', ", "));
    end
    given.(settings{k}) = settings{k + 1};
  end
  items = mgdt_mesh_items (points, tetrahedra, given);
end
