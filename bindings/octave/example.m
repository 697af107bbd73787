% SPDX-License-Identifier: MIT
% A first program: the corners of a cube and its centre, and what mgdt says of them.
%
%   folder="$(pkg-config --variable=bindings_dir mgdt)/octave"
%   mkoctfile --mex $(pkg-config --cflags mgdt) "$folder/mgdt_mex.c" -o mgdt_mex.mex
%   octave-cli --path "$folder" example.m
1;

[x, y, z] = ndgrid ([0 1]);
points = [0.5 0.5 0.5; x(:) y(:) z(:)];
tetrahedra = mgdt_delaunay (points);

volume = 0;
for v = tetrahedra'
  p = points(v, :);
  volume += det (p(2:4, :) - p(1, :)) / 6;
end
printf ("%d tetrahedra, volume %g\n", rows (tetrahedra), volume);

t = mgdt_triangulation ("canonical", true);
t.insert (points);
t.check ();
printf ("nearest to (0.9, 0.1, 0.8): point %d\n", t.nearest ([0.9 0.1 0.8]));
printf ("outside: %g\n", t.locate ([2 2 2]));

try
  t.insert ([0 0 0; 0 NaN 0]);
catch
  disp (lasterr ());
end

