# SPDX-License-Identifier: MIT
# frozen_string_literal: true

module Mgdt
  # The Voronoi diagram of the points of a triangulation, as Triangulation#voronoi gives it. Since 1.3.
  #
  # - vertices: [[x, y, z], ...]
  # - faces: the corners of each face, counter-clockwise about its normal: numbers of vertices; ray k is
  #   -1 - k. An unbounded face ends with two rays, that from its last vertex and that from its first.
  # - sides: the two points of each face; plane k of the region is -1 - k
  # - shifts: of a periodic box, how often each vector is added to the second point of each face
  # - areas, normals, centroids: of the faces
  # - ray_vertices, ray_directions: where each ray begins, and its direction
  # - cells: the faces of the cell of each point; none for a point that repeats another one
  # - bounded: whether there is a bounded cell
  # - volumes, cell_centroids: of the cells
  # - neighbors: for each cell the other sides of its faces, in the order of `cells`; neighbor_shifts:
  #   of a periodic box, how often each vector is added to them; neighbor_areas, neighbor_distances: the areas of these
  #   faces, and the distances of the cell's point from the other sides
  Voronoi = Struct.new(:vertices, :faces, :sides, :shifts, :areas, :normals, :centroids, :ray_vertices,
                       :ray_directions, :cells, :bounded, :volumes, :cell_centroids, :neighbors,
                       :neighbor_shifts, :neighbor_areas, :neighbor_distances,
                       keyword_init: true)

  # Reads the arrays of a diagram.
  class VoronoiReader
    # A handle that is destroyed when it is collected.
    class Handle < FFI::AutoPointer
      def self.release(pointer)
        Library.mgdt_voronoi_destroy(pointer)
      end
    end

    def initialize(pointer, index_base)
      @handle = Handle.new(pointer)
      @reader = ArrayReader.new(:voronoi, @handle)
      @index_base = index_base
    end

    def free
      @handle.free
    end

    def drop_small_faces(area, share)
      @reader.call(:drop_small_faces, area, share)
    end

    def read
      Voronoi.new(vertices: array(:vertices), faces: lists(:face_offsets, :face_corners), **faces,
                  ray_vertices: array(:ray_vertices), ray_directions: array(:ray_directions),
                  cells: lists(:cell_offsets, :cell_faces),
                  bounded: array(:cell_bounded).map { |flag| flag == 1 },
                  volumes: array(:cell_volumes), cell_centroids: array(:cell_centroids),
                  **neighbors)
    end

    private

    def array(name) = @reader.array(name)

    def lists(offsets, elements) = @reader.lists(offsets, elements, @index_base)

    def faces
      { sides: array(:face_sides), shifts: array(:face_shifts), areas: array(:face_areas),
        normals: array(:face_normals), centroids: array(:face_centroids) }
    end

    def neighbors
      { neighbors: :cell_neighbors, neighbor_shifts: :cell_neighbor_shifts, neighbor_areas: :cell_face_areas,
        neighbor_distances: :cell_neighbor_distances }.transform_values { |name| lists(:cell_offsets, name) }
    end
  end
  private_constant :VoronoiReader
end
