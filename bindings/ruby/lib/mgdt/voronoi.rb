# SPDX-License-Identifier: MIT
# frozen_string_literal: true

module Mgdt
  # The Voronoi diagram of the points of a triangulation, as Triangulation#voronoi gives it. Since 1.3.
  #
  # - vertices: [[x, y, z], ...]
  # - faces: the corners of each face, counter-clockwise about its normal: numbers of vertices; ray k is
  #   -1 - k. An unbounded face ends with two rays, that from its last vertex and that from its first.
  # - sides: the two points of each face; plane k of the region is -1 - k
  # - images: of a periodic box, which image of the second point each face is between
  # - areas, normals, centroids: of the faces
  # - ray_vertices, ray_directions: where each ray begins, and its direction
  # - cells: the faces of the cell of each point; none for a point that repeats another one
  # - bounded: whether there is a bounded cell
  # - volumes, cell_centroids: of the cells
  # - neighbors: for each cell the other sides of its faces, in the order of `cells`; neighbor_images:
  #   of a periodic box, which images they are; neighbor_areas, neighbor_distances: the areas of these
  #   faces, and the distances of the cell's point from the other sides
  Voronoi = Struct.new(:vertices, :faces, :sides, :images, :areas, :normals, :centroids, :ray_vertices,
                       :ray_directions, :cells, :bounded, :volumes, :cell_centroids, :neighbors,
                       :neighbor_images, :neighbor_areas, :neighbor_distances,
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
      @reader = ArrayReader.new(:voronoi, @handle, CONSTANTS[:voronoi])
      @index_base = index_base
    end

    def free
      @handle.free
    end

    def drop_small_faces(area, share)
      @reader.call(:drop_small_faces, area, share)
    end

    def read
      Voronoi.new(vertices: rows(:vertices), faces: lists(:face_offsets, :face_corners),
                  sides: integers(:face_sides).each_slice(2).to_a,
                  images: integers(:face_images).each_slice(3).to_a, areas: doubles(:face_areas),
                  normals: rows(:face_normals), centroids: rows(:face_centroids),
                  ray_vertices: integers(:ray_vertices), ray_directions: rows(:ray_directions),
                  cells: lists(:cell_offsets, :cell_faces),
                  bounded: integers(:cell_bounded).map { |flag| flag == 1 },
                  volumes: doubles(:cell_volumes), cell_centroids: rows(:cell_centroids),
                  **neighbors)
    end

    private

    def integers(name) = @reader.integers(name)

    def doubles(name) = @reader.doubles(name)

    def rows(name)
      doubles(name).each_slice(3).to_a
    end

    def neighbors
      { neighbors: lists(:cell_offsets, :cell_neighbors),
        neighbor_images: of_cells(integers(:cell_neighbor_images).each_slice(3).to_a),
        neighbor_areas: of_cells(doubles(:cell_face_areas)),
        neighbor_distances: of_cells(doubles(:cell_neighbor_distances)) }
    end

    def lists(offsets, elements) = cut(integers(offsets), integers(elements))

    def of_cells(elements) = cut(integers(:cell_offsets), elements)

    def cut(offsets, all)
      offsets.each_cons(2).map { |from, to| all[(from - @index_base)...(to - @index_base)] || [] }
    end
  end
  private_constant :VoronoiReader
end
