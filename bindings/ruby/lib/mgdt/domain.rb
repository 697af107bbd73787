# SPDX-License-Identifier: MIT
# frozen_string_literal: true

module Mgdt
  # Tetrahedra that fill what facets enclose. Every facet is a union of faces of the mesh, and every
  # segment a union of edges. Since 1.3.
  #
  #   mesh = Mgdt::DomainMesh.new([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
  #                               [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
  #   mesh.tetrahedra   # => [[0, 1, 2, 3]]
  #
  # mgdt/mgdt_domain.h says what goes in and comes out.
  class DomainMesh
    # Arrays of rows: corners, ends, coordinates.
    attr_reader :points, :tetrahedra, :faces, :segments, :steiner_edges
    # The tetrahedra next to each tetrahedron, and to each face; nil where the domain ends.
    attr_reader :neighbors, :face_tetrahedra
    # The region of each tetrahedron, and the marker of each region.
    attr_reader :regions, :region_markers
    # The facet of each face, and its marker.
    attr_reader :face_facets, :face_markers
    # The segment that was given, or nil, of each segment of the mesh, and its marker, or 0.
    attr_reader :segment_sources, :segment_markers
    # The ends of each edge that one facet alone has, and this facet.
    attr_reader :open_edges
    # The t for which a Steiner point is a + t (b - a).
    attr_reader :steiner_parameters

    # Points as for Triangulation#insert; facets as Arrays of corners. Further arguments, all optional:
    # markers of facets; segments, [a, b] each, and segment_markers; holes, [x, y, z] each; regions,
    # [[x, y, z], marker] each; rounded: true for points that are rounded, so that facets are covered
    # exactly; strict: true to refuse a mesh that leaves something out; threads; memory_limit; index_base, 0. A block hears of progress as that of
    # Triangulation#insert does.
    #
    # If facets, segments or points cross or touch where they must not, InvalidBoundary has all pairs.
    # If the facets enclose nothing, the error is OpenBoundary.
    def initialize(points, facets, rounded: false, **given, &progress)
      @domain = GivenDomain.new(points, facets, rounded: rounded, **given)
      @domain.build(progress)
      read(@domain.reader)
    end

    # Whether points are rounded.
    def rounded? = @domain.number(:is_rounded) == 1

    # Proves the mesh against the facets and segments, exactly. CheckFailed says what is wrong.
    def check
      @domain.reader.call(:check)
      self
    end

    def inspect
      "#<Mgdt::DomainMesh: #{@points.size} points, #{@tetrahedra.size} tetrahedra, " \
        "#{@region_markers.size} regions>"
    end

    private

    def read(reader)
      rows = ->(name, width) { reader.integers(name).each_slice(width).to_a }
      numbers = ->(list) { list.map { |k| k == @domain.index_base - 1 ? nil : k } }
      @points = reader.doubles(:points).each_slice(3).to_a
      @tetrahedra = rows.call(:tetrahedra, 4)
      @neighbors = rows.call(:neighbors, 4).map(&numbers)
      @faces = rows.call(:faces, 3)
      @face_tetrahedra = rows.call(:face_tetrahedra, 2).map(&numbers)
      @segments = rows.call(:segments, 2)
      @open_edges = rows.call(:open_edges, 3)
      @steiner_edges = rows.call(:steiner_edges, 2)
      %i[regions region_markers face_facets face_markers segment_markers].each do |name|
        instance_variable_set(:"@#{name}", reader.integers(name))
      end
      @segment_sources = numbers.call(reader.integers(:segment_sources))
      @steiner_parameters = reader.doubles(:steiner_parameters)
    end
  end

  # All pairs of facets, segments and points that do not meet in common corners and edges, exactly:
  # [:facet, 3, :facet, 8], for example. What is bad by itself is paired with itself. Since 1.3.
  def self.offending_pairs(points, facets, **given)
    GivenDomain.new(points, facets, **given).offending_pairs
  end

  # A handle with everything that a caller has given.
  class GivenDomain
    attr_reader :reader, :index_base

    # A handle that is destroyed when it is collected.
    class Handle < FFI::AutoPointer
      def self.release(pointer)
        Library.mgdt_domain_destroy(pointer)
      end
    end

    def initialize(points, facets, markers: nil, segments: [], segment_markers: nil, holes: [], regions: [],
                   rounded: false, strict: false, threads: 1, memory_limit: 0, index_base: 0)
      out = FFI::MemoryPointer.new(:pointer)
      status = Library.mgdt_domain_create(out)
      raise Error.of(status, Library.mgdt_status_string(status)) unless status.zero?

      @handle = Handle.new(out.read_pointer)
      @reader = ArrayReader.new(:domain, @handle, CONSTANTS[:domain_array])
      @index_base = whole(index_base, "index_base")
      { index_base: index_base, threads: threads, memory_limit: memory_limit,
        round_points: rounded ? 1 : 0, strict: strict ? 1 : 0 }.each do |name, value|
        @reader.call(:set_option, CONSTANTS[:domain_option].fetch(name), whole(value, name))
      end
      given = Points.new(points)
      @reader.call(:set_points, given.count, given.data)
      facets(facets, markers)
      segments(segments, segment_markers)
      holes.each { |place| @reader.call(:add_hole, one_place(place, "a hole")) }
      regions.each do |place, marker|
        @reader.call(:add_region, one_place(place, "a region"), whole(marker, "the marker of a region", 31))
      end
    end

    def build(progress)
      status = if progress
                 Progress.watch(progress, ->(fn) { @reader.ask(:set_progress, fn, nil) }) { @reader.ask(:build) }
               else
                 @reader.ask(:build)
               end
      return if status.zero?

      error = @reader.error_of(status)
      error.pairs = pairs if error.is_a?(InvalidBoundary)
      raise error
    end

    def offending_pairs
      status = @reader.ask(:validate)
      @reader.ensure_good(status) unless status == CONSTANTS[:status][:invalid_boundary]
      pairs
    end

    def number(name)
      value = FFI::MemoryPointer.new(:int64)
      @reader.call(:get_stat, CONSTANTS[:domain_number].fetch(name), value)
      value.read_int64
    end

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

    def facets(lists, of_facets)
      raise argument("facets must be an Array of Arrays of corners") unless
        lists.is_a?(Array) && lists.all?(Array)

      offsets = lists.each_with_object([@index_base]) { |list, ends| ends << (ends.last + list.size) }
      @reader.call(:set_facets, lists.size, offsets.pack("q*"), packed(lists.flatten(1), "a corner of a facet"),
                   markers(of_facets, lists.size, "markers"))
    end

    def segments(pairs, of_segments)
      raise argument("segments must be an Array of [a, b]") unless
        pairs.is_a?(Array) && pairs.all? { |pair| pair.is_a?(Array) && pair.size == 2 }

      @reader.call(:set_segments, pairs.size, packed(pairs.flatten(1), "an end of a segment"),
                   markers(of_segments, pairs.size, "segment_markers"))
    end

    def one_place(place, name)
      given = Points.new(place, name: name)
      raise argument("#{name} is #{given.count} places; it must be one") unless given.count == 1

      given.data
    end

    def pairs
      kinds = CONSTANTS[:domain_kind].invert
      @reader.integers(:offending_pairs).each_slice(4).map { |a, i, b, k| [kinds[a], i, kinds[b], k] }
    end
  end
  private_constant :GivenDomain
end
