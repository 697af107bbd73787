% SPDX-License-Identifier: MIT

% [given_values, progress, check] = mgdt_domain_arguments (points, facets, NAME, VALUE, ...)
%
% What mgdt_domain_mesh, mgdt_clean_surface and mgdt_offending_pairs take, in the order of mgdt_mex. For these
% alone.
function [given_values, progress, check] = mgdt_domain_arguments (points, facets, varargin)
  given = struct ("markers", [], "segments", [], "segment_markers", [], "holes", [], "regions", [], ...
                  "rounded", false, "strict", false, "keep_boundary", false, "clean", false, "weld", 0, ...
                  "flatness", 0, "threads", 1, "memory_limit", 0, "progress", [], "check", false);
  if (mod (numel (varargin), 2) != 0)
    error ("mgdt:invalid_argument", "mgdt: a setting has no value");
  end
  for k = 1:2:numel (varargin)
    if (! ischar (varargin{k}) || ! isfield (given, varargin{k}))
      error ("mgdt:unknown_key", "mgdt: settings of a domain are %s", strjoin (fieldnames (given)', ", "));
    end
    given.(varargin{k}) = varargin{k + 1};
  end
  if (iscell (facets))
    corners = cellfun (@(f) double (f(:)), facets(:), "UniformOutput", false);
    offsets = 1 + [0; cumsum(cellfun (@numel, corners))];
    corners = vertcat (zeros (0, 1), corners{:});
  elseif (isnumeric (facets) && ndims (facets) == 2)
    offsets = 1 + columns (facets) * (0:rows (facets))';
    corners = double (vec (facets'));
  else
    error ("mgdt:invalid_argument", "mgdt: facets must be a matrix of their corners or a cell array of vectors");
  end
  if (! isempty (given.segments) && columns (given.segments) != 2)
    error ("mgdt:invalid_argument", "mgdt: segments must have two columns");
  end
  if (! isempty (given.regions) && columns (given.regions) != 4)
    error ("mgdt:invalid_argument", "mgdt: regions must have four columns, x, y, z and the marker");
  end
  regions = reshape (double (given.regions), [], 4);
  given_values = {double(points), offsets, corners, double(given.markers(:)), double(vec (given.segments')), ...
               double(given.segment_markers(:)), double(given.holes), regions(:,1:3), regions(:,4), ...
               double(given.rounded), double(given.strict), double(given.keep_boundary), ...
               double(given.clean), given.weld, given.flatness, given.threads, given.memory_limit};
  progress = given.progress;
  check = given.check;
end
