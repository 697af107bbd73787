# SPDX-License-Identifier: MIT
# frozen_string_literal: true

module Mgdt
  # The Delaunay triangulation of points in a periodic box: of the infinite set of their images. Since
  # 1.3.
  #
  #   crystal = Mgdt::PeriodicBox.new([[0, 0, 0], [1, 1, 1]], [2, 2, 2])
  #   crystal.cell_measures(:volume)   # => [4.0, 4.0]
  #
  # mgdt/mgdt_periodic.h says what goes in and comes out.
  class PeriodicBox
    # The points, where they were put, and the vectors, rounded.
    attr_reader :points, :vectors
    # The corners of each tetrahedron, and their shifts: how often each vector is added to the point.
    attr_reader :tetrahedra, :shifts
    # The tetrahedra next to each; nil where a slab or a wire ends. And the shifts by which they are
    # moved.
    attr_reader :neighbors, :neighbor_shifts
    # The least point with the images of each point, and the shift of its image that is the point.
    attr_reader :point_map, :point_shifts
    # The points at the other ends of the edges at each point, and the shifts of these images.
    attr_reader :vertex_neighbors, :vertex_neighbor_shifts

    # A handle that is destroyed when it is collected.
    class Handle < FFI::AutoPointer
      def self.release(pointer)
        Library.mgdt_periodic_destroy(pointer)
      end
    end
    private_constant :Handle

    # Points as for Triangulation#insert; box: three lengths, or one to three vectors [x, y, z]. A block
    # hears of progress as that of Triangulation#insert does. Points that have images within merge_distance
    # of each other become equal.
    def initialize(points, box, threads: 1, memory_limit: 0, index_base: 0, merge_distance: 0, &progress)
      given = Points.new(points)
      make(box)
      @index_base = index_base
      { index_base: index_base, threads: threads, memory_limit: memory_limit }.each do |name, value|
        raise argument("#{name} is #{value.inspect}; it must be an Integer") unless
          value.is_a?(Integer) && value.abs < 1 << 63

        @reader.set_option(name, value)
      end
      raise argument("merge_distance is #{merge_distance.inspect}; it must be a number") unless
        merge_distance.is_a?(Integer) || merge_distance.is_a?(Float)

      @reader.call(:set_merge_distance, merge_distance.to_f)
      @reader.call(:insert_points, given.count, given.data)
      build(progress)
    end

    # Moves all points, as in a time step, and sets other vectors of the box, if there are any; what is
    # read afterwards is that of the new places.
    def move(points, box = nil, &progress)
      given = Points.new(points)
      vectors_are(box) if box
      @reader.call(:move_points, given.count, nil, given.data)
      build(progress)
      self
    end

    # Proves the triangulation, exactly. CheckFailed says what is wrong.
    def check
      @reader.call(:check)
      self
    end

    # A measure of the cell of each point: :volume, :area, :faces, or :centroid, which is [x, y, z] from
    # the point.
    def cell_measures(measure)
      key = CONSTANTS[:measure].fetch(measure.to_sym) { raise argument("there is no measure #{measure}") }
      width = key == CONSTANTS[:measure][:centroid] ? 3 : 1
      buffer = FFI::MemoryPointer.new(:double, [width * @points.size, 1].max)
      @reader.call(:get_cell_measures, key, width * @points.size, buffer)
      numbers = buffer.read_array_of_double(width * @points.size)
      width == 3 ? numbers.each_slice(3).to_a : numbers
    end

    # The Voronoi diagram, as Triangulation#voronoi gives it; shifts are those of the second sides.
    def voronoi(least_area: 0, least_share: 0)
      out = FFI::MemoryPointer.new(:pointer)
      @reader.call(:create_voronoi, out)
      reader = VoronoiReader.new(out.read_pointer, @index_base)
      reader.drop_small_faces(least_area, least_share) if least_area != 0 || least_share != 0
      reader.read
    ensure
      reader&.free
    end

    def inspect
      "#<Mgdt::PeriodicBox: #{@points.size} points, #{@vectors.size} vectors, #{@tetrahedra.size} tetrahedra>"
    end

    private

    def argument(message) = InvalidArgument.new(message, 11)

    def make(box)
      out = FFI::MemoryPointer.new(:pointer)
      status = Library.mgdt_periodic_create(out)
      raise Error.of(status, Library.mgdt_status_string(status)) unless status.zero?

      @handle = Handle.new(out.read_pointer)
      @reader = ArrayReader.new(:periodic, @handle)
      vectors_are(box)
    end

    def vectors_are(box)
      is_lengths = box.is_a?(Array) && box.size == 3 && box.all?(Numeric)
      rows = is_lengths ? box.each_with_index.map { |x, k| [0, 0, 0].tap { |row| row[k] = x } } : box
      vectors = Points.new(rows, name: "box")
      raise argument("box has #{vectors.count} vectors; it must have one to three") unless
        vectors.count.between?(1, 3)

      @reader.call(:set_vectors, vectors.count, vectors.data)
    end

    def build(progress)
      status = if progress
                 Progress.watch(progress, ->(fn) { @reader.ask(:set_progress, fn, nil) }) { @reader.ask(:build) }
               else
                 @reader.ask(:build)
               end
      @reader.ensure_good(status)
      read
    end

    def read
      array = @reader.method(:array)
      lists = ->(name) { @reader.lists(:vertex_neighbor_offsets, name, @index_base) }
      @points = array.call(:points)
      @vectors = array.call(:vectors)
      @tetrahedra = array.call(:tetrahedra)
      @neighbors = array.call(:neighbors).map { |row| row.map { |k| k == @index_base - 1 ? nil : k } }
      @shifts, @neighbor_shifts = %i[tetrahedron_shifts neighbor_shifts].map do |name|
        array.call(name).map { |row| row.each_slice(3).to_a }
      end
      @point_map = array.call(:point_map)
      @point_shifts = array.call(:point_shifts)
      @vertex_neighbors = lists.call(:vertex_neighbors)
      @vertex_neighbor_shifts = lists.call(:vertex_neighbor_shifts)
    end
  end
end
