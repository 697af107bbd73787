% SPDX-License-Identifier: MIT

% -- pairs = mgdt_offending_pairs (points, facets)
% -- pairs = mgdt_offending_pairs (points, facets, NAME, VALUE, ...)
%
% All pairs of facets, segments and points that do not meet in common corners and edges, exactly. Takes
% what mgdt_domain_mesh takes. Since 1.3.
%
% A row of the result has a kind and a number, twice: kind 0 is a facet, 1 a segment, 2 a point that is
% a corner of none. What is bad by itself, such as a flat facet, is paired with itself.
%
% See also: mgdt_domain_mesh
function pairs = mgdt_offending_pairs (points, facets, varargin)
  if (nargin < 2)
    print_usage ();
  end
  given_values = mgdt_domain_arguments (points, facets, varargin{:});
  pairs = mgdt_mex ("offending_pairs", given_values{:});
end
