% SPDX-License-Identifier: MIT

% -- mesh = mgdt_domain_mesh (points, facets)
% -- mesh = mgdt_domain_mesh (points, facets, NAME, VALUE, ...)
%
% Tetrahedra that fill what facets enclose. Every facet is a union of faces of the mesh, and every
% segment a union of edges. Since 1.3.
%
% points  n x 3 matrix
% facets  m x k matrix, one facet of k corners a row, or a cell array of vectors of corners: rows of
%         points
%
% NAME and VALUE:
%
% "markers"          one for each facet
% "segments"         s x 2, rows of points: edges that the mesh has to have besides
% "segment_markers"  one for each segment
% "holes"            h x 3, places. What facets enclose around them stays empty
% "regions"          r x 4, a place and the marker of the region around it
% "rounded"          true for points that are rounded, so that facets are covered exactly
% "strict"           true to refuse a mesh that leaves out points, facets, regions or holes
% "keep_boundary"    true to put points inside only: each triangle of a facet is one face
% "clean"            true to clean facets and segments before, as mgdt_clean_surface does
% "weld"             see mgdt_clean_surface; if it is not 0, facets and segments are cleaned
% "flatness"         the same
% "threads"          0 for all cores
% "memory_limit"     bytes, 0 for none
% "progress"         a function that hears of the fraction done; true cancels
% "check"            true to prove the mesh; mgdt:check_failed says what is wrong
%
% The result is a struct: points (those given, then Steiner points) and point_origins (the point that
% was given, or 0); tetrahedra and neighbours (t x 4), tetrahedron_regions, volumes, and region_markers (of
% each region); faces (f x 3), face_tetrahedra (f x 2), face_facets and face_markers; edges (e x 2),
% edge_segments and edge_markers; steiner_edges (q x 2) and steiner_parameters; open_edges (o x 3);
% covered_facets (c x 2); is_rounded. mgdt/mgdt_mesh.h says what they mean. 0 stands for none.
%
% Errors: mgdt:invalid_boundary (facets, segments or points cross or touch where they must not;
% mgdt_offending_pairs lists them), mgdt:open_boundary (they enclose nothing), mgdt:resolution, mgdt:not_finite, mgdt:invalid_argument,
% mgdt:cancelled, mgdt:out_of_memory.
%
% See also: mgdt_clean_surface, mgdt_offending_pairs, mgdt_delaunay
function mesh = mgdt_domain_mesh (points, facets, varargin)
  if (nargin < 2)
    print_usage ();
  end
  [given_values, progress, check] = mgdt_domain_arguments (points, facets, varargin{:});
  mesh = mgdt_mex ("domain_mesh", given_values{:}, progress, check);
end
