# SPDX-License-Identifier: MIT
# frozen_string_literal: true

# Exact 3D Delaunay triangulation of any set of points.
#
#   require "mgdt"
#   t = Mgdt::Triangulation.new
#   t.insert([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
#   t.tetrahedra   # => [[...4 numbers...], ...]
#
# Points and tetrahedra are numbered from 0. The library is the one that MGDT_LIBRARY names, or
# else libmgdt.so.1 as the loader finds it.
module Mgdt
end

require_relative "mgdt/error"
require_relative "mgdt/library"
require_relative "mgdt/points"
require_relative "mgdt/array_reader"
require_relative "mgdt/progress"
require_relative "mgdt/triangulation"
require_relative "mgdt/voronoi"
require_relative "mgdt/mesh"
require_relative "mgdt/domain"
require_relative "mgdt/periodic"

module Mgdt
  # Version of the library that is loaded, "1.2.0".
  def self.version
    Library.mgdt_version_string
  end
end
