# SPDX-License-Identifier: MIT
# frozen_string_literal: true

module Mgdt
  # The Voronoi diagram of the points of a triangulation, as Triangulation#voronoi gives it. Since 1.3.
  #
  # - vertices: [[x, y, z], ...]
  # - faces: the corners of each face, counter-clockwise about its normal: numbers of vertices; ray k is
  #   -1 - k. An unbounded face ends with two rays, that from its last vertex and that from its first.
  # - sides: the two points of each face; plane k of the region is -1 - k
  # - areas, normals, centroids: of the faces
  # - ray_vertices, ray_directions: where each ray begins, and its direction
  # - cells: the faces of the cell of each point; none for a point that repeats another one
  # - bounded: whether there is a bounded cell
  # - volumes, cell_centroids: of the cells
  Voronoi = Struct.new(:vertices, :faces, :sides, :areas, :normals, :centroids, :ray_vertices,
                       :ray_directions, :cells, :bounded, :volumes, :cell_centroids,
                       keyword_init: true)

  # Reads the arrays of a diagram.
  class VoronoiReader
    KEYS = CONSTANTS[:voronoi]
    private_constant :KEYS

    # A handle that is destroyed when it is collected.
    class Handle < FFI::AutoPointer
      def self.release(pointer)
        Library.mgdt_voronoi_destroy(pointer)
      end
    end

    def initialize(pointer, index_base)
      @handle = Handle.new(pointer)
      @index_base = index_base
    end

    def free
      @handle.free
    end

    def drop_small_faces(area, share)
      ensure_good(Library.mgdt_voronoi_drop_small_faces(@handle, area, share))
    end

    def read
      Voronoi.new(vertices: rows(:vertices), faces: lists(:face_offsets, :face_corners),
                  sides: integers(:face_sides).each_slice(2).to_a, areas: doubles(:face_areas),
                  normals: rows(:face_normals), centroids: rows(:face_centroids),
                  ray_vertices: integers(:ray_vertices), ray_directions: rows(:ray_directions),
                  cells: lists(:cell_offsets, :cell_faces),
                  bounded: integers(:cell_bounded).map { |flag| flag == 1 },
                  volumes: doubles(:cell_volumes), cell_centroids: rows(:cell_centroids))
    end

    private

    def size_of(name)
      size = FFI::MemoryPointer.new(:int64)
      ensure_good(Library.mgdt_voronoi_get_size(@handle, KEYS.fetch(name), size))
      size.read_int64
    end

    def integers(name)
      length = size_of(name)
      buffer = FFI::MemoryPointer.new(:int64, [length, 1].max)
      ensure_good(Library.mgdt_voronoi_get_array(@handle, KEYS.fetch(name), length, buffer))
      buffer.read_array_of_int64(length)
    end

    def doubles(name)
      length = size_of(name)
      buffer = FFI::MemoryPointer.new(:double, [length, 1].max)
      ensure_good(Library.mgdt_voronoi_get_doubles(@handle, KEYS.fetch(name), length, buffer))
      buffer.read_array_of_double(length)
    end

    def rows(name)
      doubles(name).each_slice(3).to_a
    end

    def lists(offsets, elements)
      all = integers(elements)
      integers(offsets).each_cons(2).map { |from, to| all[(from - @index_base)...(to - @index_base)] }
    end

    def ensure_good(status)
      return if status.zero?

      buffer = FFI::MemoryPointer.new(:char, 256)
      Library.mgdt_voronoi_get_error(@handle, 256, buffer)
      message = buffer.read_string
      raise Error.of(status, message.empty? ? Library.mgdt_status_string(status) : message)
    end
  end
  private_constant :VoronoiReader
end
