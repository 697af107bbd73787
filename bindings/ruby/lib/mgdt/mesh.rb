# SPDX-License-Identifier: MIT
# frozen_string_literal: true

module Mgdt
  # Lists as a caller gives them, packed for the library.
  module GivenItems
    private

    def argument(message) = InvalidArgument.new(message, 11)

    def whole(value, name, bits = 63)
      return value if value.is_a?(Integer) && value >= -(1 << bits) && value < 1 << bits

      raise argument("#{name} is #{value.inspect}; it must be an Integer of #{bits + 1} bits")
    end

    def packed(values, name)
      values.each { |value| whole(value, name) }
      values.pack("q*")
    end

    def markers(values, count, name)
      return if values.nil?
      raise argument("#{name} must be an Array of #{count} numbers") unless
        values.is_a?(Array) && values.size == count

      values.each { |value| whole(value, name, 31) }
      values.pack("l*")
    end

    # The corners of rows of a width.
    def packed_rows(rows, width, name)
      raise argument("#{name} must be an Array of Arrays of #{width} points") unless
        rows.is_a?(Array) && rows.all? { |row| row.is_a?(Array) && row.size == width }

      packed(rows.flatten(1), "a corner of #{name}")
    end
  end
  private_constant :GivenItems

  # A mesh of the library, which is destroyed when it is collected.
  class MeshHandle < FFI::AutoPointer
    def self.release(pointer)
      Library.mgdt_mesh_destroy(pointer)
    end
  end
  private_constant :MeshHandle

  # A mesh of tetrahedra. Since 1.4.
  #
  #   mesh = Mgdt::Mesh.new([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2, 3]])
  #   mesh.improve(goal: 30)
  #
  # mgdt/mgdt_mesh.h says what it has.
  class Mesh
    include GivenItems

    # Arrays of rows: corners, ends, coordinates.
    attr_reader :points, :tetrahedra, :faces, :edges, :steiner_edges
    # The tetrahedra next to each tetrahedron, and to each face; nil where the domain ends.
    attr_reader :neighbors, :face_tetrahedra
    # The point that was given that each point is, of equal ones the first; nil for Steiner points.
    attr_reader :point_origins
    # The region of each tetrahedron, and the marker of each region.
    attr_reader :tetrahedron_regions, :region_markers
    # The facet of each face, and its marker.
    attr_reader :face_facets, :face_markers
    # The segment that was given, or nil, of each of the edges, and its marker, or 0.
    attr_reader :edge_segments, :edge_markers
    # The t for which a Steiner point is a + t (b - a).
    attr_reader :steiner_parameters
    # After an improvement: why each tetrahedron is below the goal, or 0; how many dihedral angles there are from
    # 0 to 10 degrees, 10 to 20 and so on, before and after; how many tetrahedra have an angle below 5, 10, 15, 20, 25
    # and 30 degrees; and the least and the largest angle, in degrees, and the mean shape.
    attr_reader :reasons, :angle_histogram, :tetrahedra_below, :shapes
    # After a refinement: why each tetrahedron was not divided, or 0; and the size that was wanted at each point.
    attr_reader :refusals, :sizes

    # Points as for Triangulation#insert; tetrahedra as Arrays of four corners. Optional: markers of
    # tetrahedra; faces, [a, b, c] each, and edges, [a, b] each, that have to stay, with face_markers and
    # edge_markers; threads; memory_limit; index_base, 0. A block hears of progress.
    def initialize(points, tetrahedra, markers: nil, faces: [], face_markers: nil, edges: [], edge_markers: nil,
                   threads: 1, memory_limit: 0, index_base: 0, &progress)
      out = FFI::MemoryPointer.new(:pointer)
      status = Library.mgdt_mesh_create(out)
      raise Error.of(status, Library.mgdt_status_string(status)) unless status.zero?

      @handle = MeshHandle.new(out.read_pointer)
      @mesh = ArrayReader.new(:mesh, @handle)
      { index_base: index_base, threads: threads, memory_limit: memory_limit }.each do |name, value|
        @mesh.set_option(name, whole(value, name))
      end
      given = Points.new(points)
      @mesh.call(:set_points, given.count, given.data)
      { tetrahedra: [tetrahedra, 4, markers, "markers"], faces: [faces, 3, face_markers, "face_markers"],
        edges: [edges, 2, edge_markers, "edge_markers"] }.each do |name, (rows, width, of_rows, what)|
        corners = packed_rows(rows, width, name)
        @mesh.call(:"set_#{name}", rows.size, corners, markers(of_rows, rows.size, what))
      end
      @mesh.ensure_good(watched(progress, :build))
      take(@handle, index_base)
    end

    # Improves the tetrahedra until all dihedral angles reach a goal, or nothing helps. boundary is :fixed or
    # :slide; points is :keep, :move or :remove, for those that were given; fixed are points that stay where they are. What is not given stays as the
    # last call has set it. A block hears of progress.
    def improve(goal: nil, boundary: nil, points: nil, fixed: nil, mean_passes: nil, most_passes: nil, &progress)
      { goal: goal, mean_passes: mean_passes, most_passes: most_passes,
        boundary: boundary && named(:boundary, boundary), points: points && named(:points, points) }.each do |name, value|
        @mesh.set_option(name, whole(value, name, 31)) unless value.nil?
      end
      if fixed
        raise argument("fixed must be an Array of points") unless fixed.is_a?(Array)

        @mesh.call(:set_fixed_points, fixed.size, packed(fixed, "a fixed point"))
      end
      begin
        status = watched(progress, :improve)
      ensure
        read
      end
      @mesh.ensure_good(status)
      self
    end

    # Inserts points until the tetrahedra have the wanted sizes and shapes. size is that of edges everywhere;
    # point_sizes, tetrahedron_sizes and region_sizes have one for each, 0 for none; size_field is an Array of points and
    # one of sizes, linear between the points; size_function is called with x, y and z and gives a size; sizes_of_surface says whether edges
    # of the surface tell how long those at their ends should be. Numbers that are not given stay as the last call has set
    # them. A block hears of progress.
    def refine(size: nil, point_sizes: nil, tetrahedron_sizes: nil, region_sizes: nil, size_field: nil,
               size_function: nil, sizes_of_surface: nil, gradation: nil, radius_edge: nil, volume: nil, most_points: nil, &progress)
      { size: size, gradation: gradation, radius_edge: radius_edge, volume: volume }.each do |name, value|
        @mesh.set_double_option(name, Float(value)) unless value.nil?
      end
      @mesh.set_option(:most_points, whole(most_points, :most_points, 31)) unless most_points.nil?
      @mesh.set_option(:sizes_of_surface, sizes_of_surface ? 1 : 0) unless sizes_of_surface.nil?
      { of_points: point_sizes, of_tetrahedra: tetrahedron_sizes, of_regions: region_sizes }.each do |name, sizes|
        next if sizes.nil?

        @mesh.call(:set_sizes, CONSTANTS[:sizes].fetch(name), sizes.size, numbers(sizes))
      end
      give_field(*size_field) unless size_field.nil?
      begin
        status = with_sizes(size_function) { watched(progress, :refine) }
      ensure
        read
      end
      @mesh.ensure_good(status)
      self
    end

    # How many points the last refinement has inserted, and how many tetrahedra it has left beyond the bounds.
    def inserted_points = @mesh.statistic(:inserted_points)
    def refused = @mesh.statistic(:refused)

    # How many tetrahedra the last improvement has left below the goal.
    def below_goal = @mesh.statistic(:below_goal)

    # Whether points are rounded.
    def rounded? = @mesh.statistic(:is_rounded) == 1

    # Proves the mesh, exactly; that of a domain also against the facets and segments, until it is improved.
    # CheckFailed says what is wrong.
    def check
      prove
      self
    end

    # A measure of each tetrahedron: :volume, :radius_ratio, :least_dihedral_angle, :largest_dihedral_angle, :longest_edge,
    # :volume_length or :edge_ratio.
    def tetrahedron_measures(measure)
      key = named(:tetrahedron, measure, "measure")
      values = FFI::MemoryPointer.new(:double, [@tetrahedra.size, 1].max)
      @mesh.call(:get_tetrahedron_measures, key, @tetrahedra.size, values)
      values.read_array_of_double(@tetrahedra.size)
    end

    # The tetrahedra that contain places, exactly, or nil; and their barycentric weights. With outside: :boundary the
    # nearest place of the boundary stands for a place outside.
    def locate_points(places, outside: :none)
      given, key = asked(places, outside)
      found = FFI::MemoryPointer.new(:int64, [given.count, 1].max)
      weights = FFI::MemoryPointer.new(:double, [4 * given.count, 1].max)
      @mesh.call(:locate_points, key, given.count, given.data, found, weights)
      tetrahedra = found.read_array_of_int64(given.count).map { |t| t unless t == @index_base - 1 }
      [tetrahedra, weights.read_array_of_double(4 * given.count).each_slice(4).to_a]
    end

    # Values at places, linear in each tetrahedron between those at the points, which are numbers or Arrays; NaN where
    # there is none.
    def interpolate(values, places, outside: :none)
      raise argument("values must be an Array with one for each of the #{@points.size} points") unless
        values.is_a?(Array) && values.size == @points.size

      given, key = asked(places, outside)
      width = values.first.is_a?(Array) ? values.first.size : 1
      numbers = values.flatten(1)
      raise argument("values must be #{width} numbers each") unless
        numbers.size == width * values.size && numbers.all?(Numeric)

      out = FFI::MemoryPointer.new(:double, [width * given.count, 1].max)
      @mesh.call(:interpolate, key, width, numbers.pack("d*"), given.count, given.data, out)
      found = out.read_array_of_double(width * given.count)
      values.first.is_a?(Array) ? found.each_slice(width).to_a : found
    end

    # The shapes of all tetrahedra: the least and the largest angle in degrees, the mean shape, angles from 0 to 10
    # degrees, 10 to 20 and so on, and tetrahedra with an angle below 5, 10, 15, 20, 25 and 30 degrees.
    def shape_summary
      shapes = FFI::MemoryPointer.new(:double, 3)
      angles = FFI::MemoryPointer.new(:int64, 18)
      below = FFI::MemoryPointer.new(:int64, 6)
      @mesh.call(:get_shape_summary, shapes, angles, below)
      least, largest, mean = shapes.read_array_of_double(3)
      { least_angle: least, largest_angle: largest, mean_shape: mean, angles: angles.read_array_of_int64(18),
        below: below.read_array_of_int64(6) }
    end

    def inspect
      "#<#{self.class}: #{@points.size} points, #{@tetrahedra.size} tetrahedra, " \
        "#{@region_markers.size} regions>"
    end

    private

    # Arrays in which the index base - 1 means none.
    WITH_NONE = %i[point_origins neighbors face_tetrahedra edge_segments steiner_edges].freeze
    private_constant :WITH_NONE

    def named(table, name, what = table)
      CONSTANTS[table].fetch(name.to_sym) do
        raise argument("there is no #{what} #{name.inspect}; there are #{CONSTANTS[table].keys.join(", ")}")
      end
    end

    def asked(places, outside)
      [Points.new(places, name: "a place"), named(:outside, outside)]
    end

    # The status of a function that may hear of progress.
    def watched(progress, function)
      return @mesh.ask(function) unless progress

      Progress.watch(progress, ->(fn) { @mesh.ask(:set_progress, fn, nil) }) { @mesh.ask(function) }
    end

    def numbers(sizes)
      raise argument("sizes must be an Array of numbers") unless sizes.is_a?(Array) && sizes.all?(Numeric)

      sizes.pack("d*")
    end

    def give_field(points, sizes)
      places = Points.new(points, name: "a point of the field")
      values = numbers(sizes)
      raise argument("#{places.count} points have #{sizes.size} sizes") unless places.count == sizes.size

      @mesh.call(:set_size_field, places.count, places.data, values)
    end

    # Runs the block while the library asks a callable of x, y and z for sizes. What it raises is raised
    # afterwards.
    def with_sizes(size_function)
      return yield if size_function.nil?

      problem = nil
      callback = FFI::Function.new(:int32, %i[int64 pointer pointer pointer]) do |n, xyz, sizes, _|
        answer(n, xyz, sizes, size_function) { |raised| problem = raised }
      end
      @mesh.call(:set_size_function, callback, nil)
      begin
        status = yield
      ensure
        @mesh.call(:set_size_function, nil, nil)
        callback.free
      end
      raise problem if problem

      status
    end

    # What is returned to the library: 1 to stop. Nothing may leave through its frames.
    def answer(count, xyz, sizes, size_function)
      stop = 1
      places = xyz.read_array_of_double(3 * count).each_slice(3)
      sizes.write_array_of_double(places.map { |x, y, z| Float(size_function.call(x, y, z)) })
      stop = 0
    rescue Exception => e # rubocop:disable Lint/RescueException
      yield e
    ensure
      return stop # rubocop:disable Lint/EnsureReturn
    end

    def take(handle, index_base)
      @handle = handle
      @mesh = ArrayReader.new(:mesh, handle)
      @index_base = index_base
      read
    end

    def prove
      @mesh.call(:check)
    end

    def read
      none = @index_base - 1
      CONSTANTS[:mesh_array].each_key do |name|
        values = @mesh.array(name)
        values = values.map { |v| v.is_a?(Array) ? v.map { |k| k unless k == none } : (v unless v == none) } if
          WITH_NONE.include?(name)
        instance_variable_set(:"@#{name}", values)
      end
    end
  end
end
