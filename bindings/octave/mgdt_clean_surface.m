% SPDX-License-Identifier: MIT

% -- surface = mgdt_clean_surface (points, facets)
% -- surface = mgdt_clean_surface (points, facets, NAME, VALUE, ...)
%
% Mends what needs no new points: repeated corners, collapsed and equal facets, points in edges and in
% facets, and edges in facets. Takes what mgdt_domain_mesh takes. Since 1.4.
%
% "weld"      the distance within which places are one, as a share of the diagonal of the points' box;
%             0 by default
% "flatness"  the distance within which facets of one marker are in one plane, as a share of the same;
%             edges inside of such facets are exchanged so that a mesh needs fewer Steiner points
%
% The result is a struct: points (n x 3, moved where they were welded); facets (a cell array of vectors of
% corners), markers and origins (of each facet its marker and the facet that it is a part of); segments
% (s x 2), segment_markers and segment_origins; covered (c x 2: a facet that was left out, and the one that
% stays in its place); and what was done: moved_points, repeated_corners, collapsed_facets, points_in_edges,
% points_in_facets, edges_in_facets, exchanged_edges. mgdt/mgdt_domain.h says more.
%
% See also: mgdt_domain_mesh, mgdt_offending_pairs
function surface = mgdt_clean_surface (points, facets, varargin)
  if (nargin < 2)
    print_usage ();
  end
  given_values = mgdt_domain_arguments (points, facets, varargin{:});
  surface = mgdt_mex ("clean_surface", given_values{:});
  sizes = diff (surface.offsets);
  surface.facets = mat2cell (surface.corners, sizes, 1)(:);
  surface = rmfield (surface, {"offsets", "corners"});
end
