# SPDX-License-Identifier: MIT
# frozen_string_literal: true

# A first program: the corners of a cube and its centre, and what mgdt says of them.
#
#   RUBYLIB="$(pkg-config --variable=bindings_dir mgdt)/ruby/lib" ruby example.rb
require "mgdt"

points = [[0.5, 0.5, 0.5], *[0, 1].product([0, 1], [0, 1])]
t = Mgdt::Triangulation.new(canonical: true)
t.insert(points)
t.check

volume = t.tetrahedra.sum do |tetrahedron|
  a, b, c, d = tetrahedron.map { |k| points[k] }
  u, v, w = [b, c, d].map { |p| p.zip(a).map { |x, y| x - y } }
  ((u[0] * (v[1] * w[2] - v[2] * w[1])) - (u[1] * (v[0] * w[2] - v[2] * w[0])) +
    (u[2] * (v[0] * w[1] - v[1] * w[0]))) / 6.0
end
puts "#{t.tetrahedron_count} tetrahedra, #{t.hull_facet_count} triangles on the hull, " \
     "volume #{volume}"
puts "nearest to (0.9, 0.1, 0.8): point #{t.nearest([0.9, 0.1, 0.8])}"
puts "outside: #{t.locate([2, 2, 2]).inspect}"

begin
  t.insert([[0, 0, 0], [0, Float::NAN, 0]])
rescue Mgdt::NotFinite => e
  puts "refused: #{e.message}"
end
