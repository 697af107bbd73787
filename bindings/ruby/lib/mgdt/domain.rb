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
  # mgdt/mgdt_domain.h says what goes in, and mgdt/mgdt_mesh.h what comes out.
  class DomainMesh < Mesh
    # The ends of each edge that one facet alone has, and this facet.
    attr_reader :open_edges

    # Facets that were covered by others, which were left out, and those others: [covered, by]. Since 1.4.
    attr_reader :covered_facets

    # Points as for Triangulation#insert; facets as Arrays of corners. Further arguments, all optional:
    # markers of facets; segments, [a, b] each, and segment_markers; holes, [x, y, z] each; regions,
    # [[x, y, z], marker] each; rounded: true for points that are rounded, so that facets are covered
    # exactly; strict: true to refuse a mesh that leaves something out; keep_boundary: true to put points
    # inside only; clean: true, weld and flatness as for Mgdt.clean_surface; threads; memory_limit; index_base, 0. A block hears of progress as that of
    # Triangulation#insert does.
    #
    # If facets, segments or points cross or touch where they must not, InvalidBoundary has all pairs.
    # If the facets enclose nothing, the error is OpenBoundary.
    def initialize(points, facets, rounded: false, clean: false, weld: 0, flatness: 0, **given, &progress)
      @domain = GivenDomain.new(points, facets, rounded: rounded, **given)
      @domain.clean(weld, flatness) if clean || weld != 0 || flatness != 0
      take(@domain.build(progress), @domain.index_base)
      @open_edges = @domain.reader.array(:open_edges)
      @covered_facets = @domain.reader.array(:covered_facets)
    end

    private

    def prove
      super
      # What has been improved is no longer the mesh of the domain alone.
      @domain.reader.call(:check, @handle) if @mesh.statistic(:is_of_domain) == 1
    end
  end

  # All pairs of facets, segments and points that do not meet in common corners and edges, exactly:
  # [:facet, 3, :facet, 8], for example. What is bad by itself is paired with itself. Since 1.3.
  def self.offending_pairs(points, facets, **given)
    GivenDomain.new(points, facets, **given).offending_pairs
  end

  # Facets and segments that have been cleaned; see Mgdt.clean_surface. `origins` has the facet that each
  # facet is, or is a part of; `covered` has pairs of a facet that was left out and the one that stays in its
  # place; `counts` says what was done.
  CleanSurface = Struct.new(:points, :facets, :markers, :origins, :segments, :segment_markers,
                            :segment_origins, :covered, :counts)

  # Mends what needs no new points: repeated corners, collapsed and equal facets, points in edges and in
  # facets, and edges in facets. weld is the distance within which places are one, and flatness that within
  # which facets of one marker are in one plane, as shares of the diagonal of the points' box. Takes markers,
  # segments and segment_markers as DomainMesh does. mgdt/mgdt_domain.h says more. Since 1.4.
  def self.clean_surface(points, facets, weld: 0, flatness: 0, **given)
    domain = GivenDomain.new(points, facets, **given)
    domain.clean(weld, flatness)
    read = domain.reader
    counts = %i[moved_points repeated_corners collapsed_facets points_in_edges points_in_facets edges_in_facets
                exchanged_edges]
    CleanSurface.new(read.array(:points), read.lists(:facet_offsets, :facet_corners, domain.index_base),
                     *%i[facet_markers facet_origins segments segment_markers segment_origins
                         covered_facets].map { |name| read.array(name) },
                     counts.to_h { |name| [name, read.statistic(name)] })
  end

  # A handle with everything that a caller has given.
  class GivenDomain
    include GivenItems

    attr_reader :reader, :index_base

    # A handle that is destroyed when it is collected.
    class Handle < FFI::AutoPointer
      def self.release(pointer)
        Library.mgdt_domain_destroy(pointer)
      end
    end

    def initialize(points, facets, markers: nil, segments: [], segment_markers: nil, holes: [], regions: [],
                   rounded: false, strict: false, keep_boundary: false, threads: 1, memory_limit: 0, index_base: 0)
      out = FFI::MemoryPointer.new(:pointer)
      status = Library.mgdt_domain_create(out)
      raise Error.of(status, Library.mgdt_status_string(status)) unless status.zero?

      @handle = Handle.new(out.read_pointer)
      @reader = ArrayReader.new(:domain, @handle)
      @index_base = whole(index_base, "index_base")
      { index_base: index_base, threads: threads, memory_limit: memory_limit,
        round_points: rounded ? 1 : 0, strict: strict ? 1 : 0, keep_boundary: keep_boundary ? 1 : 0 }.each do |name, value|
        @reader.call(:set_option, CONSTANTS[:domain_option].fetch(name), whole(value, name))
      end
      given = Points.new(points)
      @reader.call(:set_points, given.count, given.data)
      facets(facets, markers)
      segments(segments, segment_markers)
      places(:set_holes, holes, "a hole")
      places(:set_regions, regions.map(&:first), "a region",
             markers(regions.map { |_, marker| marker }, regions.size, "the marker of a region"))
    end

    def clean(weld, flatness)
      { weld: weld, flatness: flatness }.each do |name, value|
        raise argument("#{name} is #{value.inspect}; it must be a number") unless value.is_a?(Numeric)

        @reader.set_double_option(name, value.to_f)
      end
      @reader.call(:clean)
    end

    # The mesh, a handle.
    def build(progress)
      out = FFI::MemoryPointer.new(:pointer)
      status = if progress
                 Progress.watch(progress, ->(fn) { @reader.ask(:set_progress, fn, nil) }) { @reader.ask(:build, out) }
               else
                 @reader.ask(:build, out)
               end
      return MeshHandle.new(out.read_pointer) if status.zero?

      error = @reader.error_of(status)
      error.pairs = pairs if error.is_a?(InvalidBoundary)
      raise error
    end

    def offending_pairs
      status = @reader.ask(:validate)
      @reader.ensure_good(status) unless status == CONSTANTS[:status][:invalid_boundary]
      pairs
    end

    private

    def facets(lists, of_facets)
      raise argument("facets must be an Array of Arrays of corners") unless
        lists.is_a?(Array) && lists.all?(Array)

      offsets = lists.each_with_object([@index_base]) { |list, ends| ends << (ends.last + list.size) }
      @reader.call(:set_facets, lists.size, offsets.pack("q*"), packed(lists.flatten(1), "a corner of a facet"),
                   markers(of_facets, lists.size, "markers"))
    end

    def segments(pairs, of_segments)
      @reader.call(:set_segments, pairs.size, packed_rows(pairs, 2, "segments"),
                   markers(of_segments, pairs.size, "segment_markers"))
    end

    def places(function, list, name, *arguments)
      packed = list.map do |place|
        given = Points.new(place, name: name)
        raise argument("#{name} is #{given.count} places; it must be one") unless given.count == 1

        given.data.is_a?(FFI::Pointer) ? given.data.read_bytes(24) : given.data
      end
      @reader.call(function, list.size, packed.join, *arguments)
    end

    def pairs
      kinds = CONSTANTS[:domain_kind].invert
      @reader.integers(:offending_pairs).each_slice(4).map { |a, i, b, k| [kinds[a], i, kinds[b], k] }
    end
  end
  private_constant :GivenDomain
end
