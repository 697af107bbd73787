# SPDX-License-Identifier: MIT
# frozen_string_literal: true

# The Ruby binding against what the C interface wrote (reference.c), and against geometry.
#
#   ruby ruby_test.rb REFERENCE_FOLDER
require "ffi"
require "minitest/autorun"

# What the binding attaches, to be compared with the header.
ATTACHED = {}
FFI::Library.prepend(Module.new do
  def attach_function(name, parameters, result, *)
    ATTACHED[name.to_s] = [result, *parameters]
    super
  end
end)
require "mgdt"

FOLDER = ARGV.shift or abort "usage: ruby ruby_test.rb REFERENCE_FOLDER"

class MgdtTest < Minitest::Test
  NAN = Float::NAN

  def self.bytes(name) = File.binread(File.join(FOLDER, name))
  def self.integers(name, width = 1)
    flat = bytes(name).unpack("q*")
    width == 1 ? flat : flat.each_slice(width).to_a
  end
  def self.doubles(name) = bytes(name).unpack("d*")
  PACKED = bytes("points").freeze
  POINTS = PACKED.unpack("d*").each_slice(3).to_a.freeze
  WIDTHS = { tetrahedra: 4, neighbors: 4, hull_facets: 3, edges: 2, point_map: 1 }.freeze

  def expected(name) = self.class.integers(name.to_s, WIDTHS.fetch(name))

  def triangulation(points = PACKED, **settings)
    t = Mgdt::Triangulation.new(canonical: true, **settings)
    t.insert(points)
    t
  end

  def refused(kind, *words, &block)
    error = assert_raises(kind, &block)
    words.each { |word| assert_includes error.message, word }
    error
  end

  def six_volumes(points, tetrahedron)
    a, b, c, d = tetrahedron.map { |k| points[k] }
    u, v, w = [b, c, d].map { |p| p.zip(a).map { |x, y| x - y } }
    (u[0] * (v[1] * w[2] - v[2] * w[1])) - (u[1] * (v[0] * w[2] - v[2] * w[0])) +
      (u[2] * (v[0] * w[1] - v[1] * w[0]))
  end

  def test_cube
    corners = [0, 1].product([0, 1], [0, 1])
    t = triangulation(corners)
    volumes = t.tetrahedra.map { |v| six_volumes(corners, v) }
    assert_includes [5, 6], volumes.size
    assert(volumes.all?(&:positive?))
    assert_equal 6, volumes.sum
    assert_equal 12, t.hull_facet_count
    assert_equal 3, t.dimension
    assert t.check
    assert_includes t.inspect, "8 points"
  end

  # Not a test of its own: it takes the triangulation of the next one.
  def diagrams_are_those_of_the_c_interface(t, box)
    { "cut" => box, "whole" => [] }.each do |prefix, planes|
      v = t.voronoi(planes)
      integers = ->(name, *width) { self.class.integers("#{prefix}_#{name}", *width) }
      doubles = ->(name) { self.class.doubles("#{prefix}_#{name}") }
      rows = ->(name) { doubles.call(name).each_slice(3).to_a }
      lists = lambda do |offsets, list|
        all = integers.call(list)
        integers.call(offsets).each_cons(2).map { |from, to| all[from...to] }
      end
      assert_equal lists.call("face_offsets", "face_corners"), v.faces
      assert_equal integers.call("face_sides", 2), v.sides
      assert_equal integers.call("ray_vertices"), v.ray_vertices
      assert_equal lists.call("cell_offsets", "cell_faces"), v.cells
      assert_equal integers.call("cell_bounded"), (v.bounded.map { |flag| flag ? 1 : 0 })
      { vertices: v.vertices, ray_directions: v.ray_directions, face_normals: v.normals,
        face_centroids: v.centroids, cell_centroids: v.cell_centroids }.each do |name, got|
        assert_equal rows.call(name), got, name
      end
      assert_equal doubles.call("face_areas"), v.areas
      assert_equal doubles.call("cell_volumes"), v.volumes
      assert_equal lists.call("cell_offsets", "cell_neighbors"), v.neighbors
      assert_equal doubles.call("cell_face_areas"), v.neighbor_areas.flatten
      assert_equal doubles.call("cell_neighbor_distances"), v.neighbor_distances.flatten
      assert_empty v.neighbor_shifts.flatten
    end
    all = t.voronoi(box).faces.size
    assert_operator t.voronoi(box, least_area: 0.01).faces.size, :<, all
    assert_operator t.voronoi(box, least_share: 0.05).faces.size, :<, all
    refused(Mgdt::InvalidArgument, "-1") { t.voronoi(box, least_area: -1) }
    refused(Mgdt::InvalidArgument, "planes[0] is not four numbers") { t.voronoi([[1, 2, 3]]) }
    refused(Mgdt::InvalidArgument, "no end") { t.voronoi([[1, 0, 0, 9]]) }
    one = Mgdt::Triangulation.new(index_base: 1)
    one.insert([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    diagram = one.voronoi
    assert_equal [[1, 2], [1, 3], [1, 4], [2, 3], [2, 4], [3, 4]], diagram.sides.sort
    assert_equal [1, 2, 3, 4, 5, 6], diagram.cells.flatten.uniq.sort
    assert_equal [[0.5, 0.5, 0.5]], diagram.vertices
  end

  # What the C interface was given for its domain.
  def given_domain(**changed)
    offsets = self.class.integers("domain_given_offsets")
    corners = self.class.integers("domain_given_corners")
    { points: self.class.bytes("domain_given_points"),
      facets: offsets.each_cons(2).map { |from, to| corners[from...to] },
      markers: self.class.integers("domain_given_markers"), segments: [[0, 1], [8, 9]], segment_markers: [5, 6],
      holes: [[1, 1, 3]], regions: [[[0, 0, 9.5], 7]], rounded: true }.merge(changed)
  end

  def mesh_of(points:, facets:, **given, &progress) = Mgdt::DomainMesh.new(points, facets, **given, &progress)

  def test_a_domain
    heard = 0
    mesh = mesh_of(**given_domain) { |fraction| heard += fraction }
    assert_operator heard, :>, 0
    rows = { tetrahedra: 4, neighbors: 4, faces: 3, face_tetrahedra: 2, edges: 2, steiner_edges: 2 }
    rows.each do |name, width|
      expected = self.class.integers("domain_#{name}", width)
      assert_equal expected, (mesh.public_send(name).map { |row| row.map { |k| k || -1 } }), name
    end
    %i[point_origins tetrahedron_regions region_markers face_facets face_markers edge_segments edge_markers].each do |name|
      assert_equal self.class.integers("domain_#{name}"), (mesh.public_send(name).map { |k| k || -1 }), name
    end
    assert_equal self.class.doubles("domain_points").each_slice(3).to_a, mesh.points
    assert_equal self.class.doubles("domain_steiner_parameters"), mesh.steiner_parameters
    assert_equal self.class.doubles("domain_volumes"), mesh.tetrahedron_measures(:volume)
    refused(Mgdt::InvalidArgument, "weight") { mesh.tetrahedron_measures("weight") }
    assert_predicate mesh, :rounded?
    assert_same mesh, mesh.check
    assert_includes mesh.inspect, "2 regions"
    one = Mgdt::DomainMesh.new([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
                               [[1, 3, 2], [1, 2, 4], [2, 3, 4], [3, 1, 4]], index_base: 1)
    assert_equal [[1, 2, 3, 4]], one.tetrahedra.map(&:sort)
    assert_equal [[nil] * 4], one.neighbors
    kept = Mgdt::DomainMesh.new([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
                                [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], keep_boundary: true)
    kept.check
    assert_equal [[0, 1, 2, 3]], kept.tetrahedra.map(&:sort)
    # A point in an edge of one of the facets at it.
    hanging = [[[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 0, 0]],
               [[0, 2, 1], [0, 4, 3], [4, 1, 3], [1, 2, 3], [2, 0, 3]]]
    refused(Mgdt::InvalidBoundary, "facet") { Mgdt::DomainMesh.new(*hanging) }
    cleaned = Mgdt.clean_surface(*hanging)
    assert_equal [0, 0, 1, 2, 3, 4], cleaned.origins
    assert_equal [3] * 6, cleaned.facets.map(&:size)
    assert_equal 1, cleaned.counts[:points_in_edges]
    whole = Mgdt::DomainMesh.new(*hanging, clean: true)
    whole.check
    assert_equal [0, 1, 3, 4], whole.face_facets.uniq.sort # the two in one plane are one
    assert_empty whole.covered_facets
    assert_equal whole.tetrahedra, Mgdt::DomainMesh.new(*hanging, weld: 1e-9).tetrahedra
    refused(Mgdt::InvalidArgument, "option 70") { Mgdt::DomainMesh.new(*hanging, weld: 1) }
    refused(Mgdt::InvalidArgument, "flatness") { Mgdt::DomainMesh.new(*hanging, flatness: "much") }
    refused(Mgdt::OpenBoundary, "no facets") { Mgdt::DomainMesh.new([], []) }
    refused(Mgdt::InvalidArgument, "hole 0 is in nothing") do
      Mgdt::DomainMesh.new([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
                           [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], holes: [[5, 5, 5]], strict: true)
    end
    assert_empty one.open_edges
  end

  BOX = [[4, 0, 0], [1.5, 3, 0], [-0.75, 0.5, 2.5]].freeze

  def assert_reference_box(box)
    { tetrahedra: 4, neighbors: 4, point_shifts: 3 }.each do |name, width|
      assert_equal self.class.integers("periodic_#{name}", width), box.public_send(name), name
    end
    { shifts: "tetrahedron_shifts", neighbor_shifts: "neighbor_shifts" }.each do |name, written|
      assert_equal self.class.integers("periodic_#{written}", 3).each_slice(4).to_a, box.public_send(name), name
    end
    assert_equal self.class.integers("periodic_point_map"), box.point_map
    assert_equal self.class.integers("periodic_vertex_neighbors"), box.vertex_neighbors.flatten
    assert_equal self.class.integers("periodic_vertex_neighbor_shifts"), box.vertex_neighbor_shifts.flatten
    assert_equal self.class.integers("periodic_vertex_neighbor_offsets").each_cons(2).map { |a, b| b - a },
                 box.vertex_neighbors.map(&:size)
    %i[points vectors].each do |name|
      assert_equal self.class.doubles("periodic_#{name}"), box.public_send(name).flatten, name
    end
    %i[volume area faces centroid].each do |name|
      assert_equal self.class.doubles("periodic_#{name}"), box.cell_measures(name).flatten, name
    end
  end

  def test_a_periodic_box
    points = self.class.bytes("periodic_given_points")
    heard = 0
    box = Mgdt::PeriodicBox.new(points, BOX) { |fraction| heard += fraction }
    assert_operator heard, :>, 0
    assert_reference_box(box)
    assert_same box, box.check
    assert_includes box.inspect, "40 points, 3 vectors"
    cells = box.voronoi
    assert_equal self.class.integers("periodic_cells_face_shifts", 3), cells.shifts
    assert_equal self.class.integers("periodic_cells_face_sides", 2), cells.sides
    assert_equal self.class.doubles("periodic_cells_cell_volumes"), cells.volumes
    assert_operator box.voronoi(least_area: 0.5).faces.size, :<, cells.faces.size
    assert_same box, box.move(points)
    assert_reference_box(box)
    assert_equal 2, box.move(points, BOX.first(2)).vectors.size
    assert_reference_box(box.move(points, BOX))
    one = Mgdt::PeriodicBox.new([[0, 0, 0], [1, 1, 1]], [2, 2, 2], index_base: 1, threads: 2)
    assert_equal [1, 2], one.point_map
    assert_equal [14, 14], one.cell_measures("faces")
    slab = Mgdt::PeriodicBox.new(points, BOX.first(2))
    assert_includes slab.neighbors.flatten, nil
  end

  def test_points_of_a_box_that_become_equal
    box = Mgdt::PeriodicBox.new([[0, 0, 0], [2, 2, 1.999], [1, 1, 1]], [2, 2, 2], merge_distance: 0.01)
    assert_equal [0, 0, 2], box.point_map
  end

  def test_what_periodic_boxes_refuse
    points = self.class.bytes("periodic_given_points")
    refused(Mgdt::InvalidArgument, "merge_distance") { Mgdt::PeriodicBox.new(points, BOX, merge_distance: "1") }
    refused(Mgdt::InvalidArgument, "in a plane") { Mgdt::PeriodicBox.new(points, [1, 1, 0]) }
    refused(Mgdt::InvalidArgument, "box has 4 vectors") { Mgdt::PeriodicBox.new(points, BOX + BOX.first(1)) }
    refused(Mgdt::InvalidArgument, "point 0") { Mgdt::PeriodicBox.new([[1e30, 0, 0]], [1, 1, 1]) }
    refused(Mgdt::InvalidArgument, "threads") { Mgdt::PeriodicBox.new(points, BOX, threads: 1.5) }
    refused(Mgdt::InvalidArgument, "no measure") { Mgdt::PeriodicBox.new(points, BOX).cell_measures(:colour) }
    refused(Mgdt::InvalidArgument, "2 places") { Mgdt::PeriodicBox.new(points, BOX).move([[0, 0, 0], [1, 1, 1]]) }
    refused(Mgdt::Cancelled) { Mgdt::PeriodicBox.new(points, BOX) { :cancel } }
    refused(Mgdt::OutOfMemory) { Mgdt::PeriodicBox.new(points, BOX, memory_limit: 5000) }
  end

  def given_block
    { points: self.class.bytes("block_given_points"),
      tetrahedra: self.class.integers("block_given_tetrahedra", 4), markers: self.class.integers("block_given_markers"),
      faces: self.class.integers("block_given_faces", 3), face_markers: self.class.integers("block_given_face_markers") }
  end

  def block_mesh(points:, tetrahedra:, **given, &progress) = Mgdt::Mesh.new(points, tetrahedra, **given, &progress)

  def test_a_mesh
    heard = 0
    mesh = block_mesh(**given_block) { |fraction| heard += fraction }
    assert_operator heard, :>, 0
    assert_equal "#<Mgdt::Mesh: 125 points, 384 tetrahedra, 2 regions>", mesh.check.inspect
    assert_equal [], mesh.reasons
    heard = 0
    improved = mesh.improve(goal: 30, boundary: :slide, fixed: self.class.integers("block_given_fixed")) do |fraction|
      heard += fraction
    end
    assert_same mesh, improved
    assert_operator heard, :>, 0
    assert_equal 0, mesh.check.below_goal
    { tetrahedra: 4, faces: 3, edges: 2, angle_histogram: 2, tetrahedra_below: 2 }.each do |name, width|
      assert_equal self.class.integers("block_#{name}", width), mesh.public_send(name), name
    end
    %i[tetrahedron_regions region_markers face_facets face_markers edge_markers reasons].each do |name|
      assert_equal self.class.integers("block_#{name}"), mesh.public_send(name), name
    end
    assert_equal self.class.doubles("block_points").each_slice(3).to_a, mesh.points
    assert_equal self.class.doubles("block_shapes").each_slice(2).to_a, mesh.shapes
    assert_equal [nil] * (mesh.points.size - 125), mesh.point_origins.drop(125)
    assert_in_delta 64, mesh.tetrahedron_measures(:volume).sum, 1e-9
    places = self.class.doubles("places").each_slice(3).to_a
    { none: "inside", boundary: "nearest" }.each do |outside, name|
      found, weights = mesh.locate_points(places, outside: outside)
      assert_equal self.class.integers("places_#{name}_tetrahedra"), (found.map { |t| t || -1 })
      assert_equal self.class.doubles("places_#{name}_weights").each_slice(4).to_a, weights
      values = mesh.interpolate(mesh.points, places, outside: outside).flatten
      expected = self.class.doubles("places_#{name}_values")
      assert(values.zip(expected).all? { |a, b| a == b || (a.nan? && b.nan?) })
    end
    assert_equal [nil], mesh.locate_points([[9, 9, 9]]).first
    summary = mesh.shape_summary
    assert_equal self.class.doubles("summary_shapes"), summary.values_at(:least_angle, :largest_angle, :mean_shape)
    assert_equal self.class.integers("summary_angles"), summary[:angles]
    assert_equal self.class.integers("summary_below"), summary[:below]
    refused(Mgdt::InvalidArgument, "there is no outside :beyond") { mesh.locate_points(places, outside: :beyond) }
    refused(Mgdt::InvalidArgument, "values") { mesh.interpolate([1], places) }
    assert_raises(Mgdt::Cancelled) { mesh.improve(goal: 40) { :cancel } }
    mesh.check
  end

  def test_a_refinement
    heard = 0
    mesh = block_mesh(**given_block)
    refined = mesh.refine(size: 0.75, gradation: 0.5, radius_edge: 1.5, volume: 0.125, sizes_of_surface: true,
                          most_points: 2000, region_sizes: [0.45, 0], point_sizes: [0.3] + [0] * 124,
                          tetrahedron_sizes: [0] * 383 + [0.25],
                          size_field: [[[0, 0, 0], [8, 0, 0], [0, 8, 0], [0, 0, 8]], [0.5, 0.75, 0.75, 1]],
                          size_function: ->(_, _, z) { 0.375 + 0.125 * z }) { |fraction| heard += fraction }
    assert_same mesh, refined.check
    assert_operator heard, :>, 0
    assert_equal mesh.points.size - 125, mesh.inserted_points
    assert_equal mesh.refusals.count(&:positive?), mesh.refused
    assert_equal self.class.integers("refined_tetrahedra", 4), mesh.tetrahedra
    assert_equal self.class.integers("refined_refusals"), mesh.refusals
    assert_equal self.class.doubles("refined_points").each_slice(3).to_a, mesh.points
    assert_equal self.class.doubles("refined_sizes"), mesh.sizes
    assert_raises(Mgdt::Cancelled) { mesh.refine(size: 0.2) { :cancel } }
    refused(Mgdt::InvalidArgument, "-1") { mesh.refine(size: -1) }
    refused(Mgdt::InvalidArgument, "size function gives -1") { mesh.refine(size_function: ->(*) { -1 }) }
    assert_raises(ZeroDivisionError) { mesh.refine(size_function: ->(*) { 1 / 0 }) }
    refused(Mgdt::InvalidArgument, "1 points have 2 sizes") { mesh.refine(size_field: [[[0, 0, 0]], [1, 2]]) }
    refused(Mgdt::InvalidArgument, "Array of numbers") { mesh.refine(region_sizes: [nil, 1]) }
    refused(Mgdt::InvalidArgument, "1 sizes of regions, of which there are 2") { mesh.refine(region_sizes: [1]) }
    mesh.check
  end

  def test_what_meshes_refuse
    points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    refused(Mgdt::InvalidArgument, "tetrahedron 0 has the corner 4") { Mgdt::Mesh.new(points, [[0, 1, 2, 4]]) }
    refused(Mgdt::InvalidArgument, "Arrays of 4 points") { Mgdt::Mesh.new(points, [[0, 1, 2]]) }
    refused(Mgdt::InvalidArgument, "no tetrahedra") { Mgdt::Mesh.new(points, []) }
    refused(Mgdt::InvalidArgument, "markers") { Mgdt::Mesh.new(points, [[0, 1, 2, 3]], markers: [1, 2]) }
    refused(Mgdt::InvalidArgument, "no edge") { Mgdt::Mesh.new(points + [[9, 9, 9]], [[0, 1, 2, 3]], edges: [[0, 4]]) }
    mesh = Mgdt::Mesh.new(points, [[1, 2, 3, 4]], index_base: 1)
    refused(Mgdt::InvalidArgument, "71") { mesh.improve(goal: 71) }
    refused(Mgdt::InvalidArgument, "there is no boundary :open; there are fixed, slide") { mesh.improve(boundary: :open) }
    refused(Mgdt::InvalidArgument, "fixed point 1 is 0") { mesh.improve(fixed: [0]) }
    refused(Mgdt::InvalidArgument, "Array of points") { mesh.improve(fixed: 3) }
    mesh.check
  end

  def test_what_domains_refuse
    crossing = [[[0, 0, 0], [4, 0, 0], [0, 4, 0], [1, 1, -1], [1, 1, 2], [5, 1, 1]], [[0, 1, 2], [3, 4, 5]]]
    pairs = [[:facet, 0, :facet, 1]]
    assert_equal pairs, Mgdt.offending_pairs(*crossing)
    assert_equal pairs, refused(Mgdt::InvalidBoundary, "facet") { Mgdt::DomainMesh.new(*crossing) }.pairs
    assert_empty Mgdt.offending_pairs(crossing[0], crossing[1].first(1), segments: [[4, 5]])
    { ["18"] => { facets: [[0, 1, 18]], markers: [1] }, ["markers", "19"] => { markers: [1, 2] },
      ["Array of Arrays"] => { facets: [1, 2] }, ["corner", "1.5"] => { facets: [[0, 1.5, 1]] },
      ["segments"] => { segments: [1] }, ["hole", "no multiple"] => { holes: [[1, 2]] },
      ["marker of a region"] => { regions: [[[1, 1, 1], "x"]] }, ["threads"] => { threads: 1.5 },
      ["a hole is 2 places"] => { holes: [[[1, 1, 1], [2, 2, 2]]] } }.each do |words, change|
      refused(Mgdt::InvalidArgument, *words) { mesh_of(**given_domain(**change)) }
    end
    refused(Mgdt::NotFinite, "0") { mesh_of(**given_domain(points: [[NAN, 0, 0]])) }
    refused(Mgdt::Cancelled) { mesh_of(**given_domain) { :cancel } }
    problem = assert_raises(RuntimeError) { mesh_of(**given_domain) { raise "no more" } }
    assert_equal "no more", problem.message
    assert_raises(ArgumentError) { mesh_of(**given_domain(hole: [])) }
  end

  def test_exports_are_those_of_the_c_interface
    t = triangulation
    WIDTHS.each do |name, width|
      assert_equal expected(name), t.public_send(name), name
      length = expected(name).size * width
      { int32: "l*", int64: "q*" }.each do |type, format|
        buffer = FFI::MemoryPointer.new(type, length)
        assert_same buffer, t.public_send(name, into: buffer)
        assert_equal expected(name).flatten, buffer.read_bytes(buffer.size).unpack(format), name
        refused(Mgdt::BufferTooSmall, length.to_s) do
          t.public_send(name, into: FFI::MemoryPointer.new(type, length - 1))
        end
      end
      refused(Mgdt::InvalidArgument, "int32") do
        t.public_send(name, into: FFI::MemoryPointer.new(:char, 8 * length))
      end
    end
    offsets = self.class.integers("offsets")
    list = self.class.integers("list")
    assert_equal offsets.each_cons(2).map { |from, to| list[from...to] }, t.vertex_tetrahedra
    offsets = self.class.integers("neighbor_offsets")
    list = self.class.integers("neighbor_list")
    assert_equal offsets.each_cons(2).map { |from, to| list[from...to] }, t.vertex_neighbors
    assert_equal self.class.integers("gabriel_edges", 2), t.gabriel_edges
    assert_equal self.class.integers("spanning_tree", 2), t.spanning_tree
    centers = self.class.doubles("centers").each_slice(3).to_a
    assert_equal [centers, self.class.doubles("squares")], t.circumcenters
    assert_equal self.class.doubles("facet_alphas").each_slice(4).to_a, t.alphas(2)
    assert_equal self.class.doubles("edge_alphas"), t.alphas(1)
    assert_equal self.class.integers("alpha_surface", 3), t.alpha_surface(0.01)
    assert_equal self.class.doubles("solid_alpha"), [t.solid_alpha]
    box = [[1, 0, 0, 2], [-1, 0, 0, 1], [0, 1, 0, 2], [0, -1, 0, 1], [0, 0, 1, 2], [0, 0, -1, 1]]
    assert_equal self.class.doubles("volumes"), t.cell_measures(:volume, box)
    assert_equal self.class.doubles("centroids").each_slice(3).to_a, t.cell_measures(:centroid, box)
    assert_equal self.class.doubles("faces"), t.cell_measures(:faces)
    assert_equal self.class.doubles("radius_ratios"), t.tetrahedron_measures(:radius_ratio)
    assert_equal self.class.doubles("largest_angles"), t.tetrahedron_measures(:largest_dihedral_angle)
    refused(Mgdt::InvalidArgument, "the measure is :faces", ":least_dihedral_angle") { t.tetrahedron_measures(:faces) }
    diagrams_are_those_of_the_c_interface(t, box)
    places = self.class.doubles("queries").each_slice(3).to_a
    values = self.class.doubles("values").each_slice(2).to_a
    expected = self.class.doubles("interpolated").each_slice(2).to_a
    assert_equal expected, t.interpolate(:sibson_c1, values, places, outside: :linear)
    refused(Mgdt::InvalidArgument, "the method is :sibsom; it must be one of", ":sibson_c1") do
      t.interpolate(:sibsom, values, places)
    end
    refused(Mgdt::InvalidArgument, "what is outside is :far; it must be one of", ":boundary") do
      t.interpolate(:linear, values, places, outside: :far)
    end
    refused(Mgdt::InvalidArgument, "the measure is :size; it must be one of", ":volume") { t.cell_measures(:size) }
    refused(Mgdt::InvalidArgument, "the level is :deep; it must be one of", ":canonical") { t.check(:deep) }
    gradients = self.class.doubles("gradients").each_slice(3).each_slice(2).to_a
    assert_equal gradients, t.gradients(values)
    assert_equal gradients.map(&:first), t.gradients(values.map(&:first))
    ends = self.class.integers("row_offsets")
    pairs = self.class.integers("row_points").zip(self.class.doubles("row_weights"))
    assert_equal ends.each_cons(2).map { |from, to| pairs[from...to] }, t.interpolation_weights(:sibson, places)
    # Euler's formula for a ball.
    facets = (4 * t.tetrahedron_count + t.hull_facet_count) / 2
    assert_equal 1, t.vertex_count - t.edge_count + facets - t.tetrahedron_count
    assert_equal [1010, 1000, 10], [t.point_count, t.vertex_count, t.statistic(:duplicates)]
    %i[combinatorial geometric canonical].each { |level| assert t.check(level) }
  end

  def test_every_way_to_give_points
    columns = POINTS.transpose.map { |c| FFI::MemoryPointer.new(:double, c.size).write_array_of_double(c) }
    whole = FFI::MemoryPointer.new(:double, 3 * POINTS.size).write_array_of_double(POINTS.flatten)
    bare = FFI::Pointer.new(whole.address)
    ways = {
      rows: ->(t) { t.insert(POINTS) },
      flat: ->(t) { t.insert(POINTS.flatten) },
      packed: ->(t) { t.insert(PACKED.dup) },
      memory: ->(t) { t.insert(whole) },
      bare_pointer: ->(t) { t.insert(bare, POINTS.size) },
      separate: ->(t) { t.insert_strided(POINTS.size, *columns) },
      records: ->(t) { t.insert_strided(POINTS.size, whole, whole + 8, whole + 16, 3) },
      batches: ->(t) { POINTS.each_slice(300) { |some| t.insert(some) } }
    }
    ways.each do |name, way|
      t = Mgdt::Triangulation.new(canonical: true, seed: 2**64 - 1, threads: 0)
      t.reserve(POINTS.size)
      way.call(t)
      assert_equal expected(:tetrahedra), t.tetrahedra, name
    end
    assert_operator Mgdt::Triangulation::ORDER_SCHEMES.size, :>=, 10
    Mgdt::Triangulation::ORDER_SCHEMES.each do |scheme|
      assert_equal expected(:tetrahedra), triangulation(order: scheme).tetrahedra, scheme
    end
    assert_equal expected(:tetrahedra),
                 triangulation(order: "multi-grid", points_per_cell: 3, threshold: 20).tetrahedra
  end

  def test_settings_are_read_as_they_are_set
    t = Mgdt::Triangulation.new
    assert_equal ["auto", 0, 1, nil, false, false, 2.0],
                 [t.order, t.seed, t.threads, t.memory_limit, t.compact, t.canonical,
                  t.parameter(:separation)]
    t = triangulation(order: "kd-tree", seed: 2**64 - 1, threads: 3, memory_limit: 2**40,
                      compact: true, separation: :passes, threshold: 50)
    assert_equal ["kd-tree", 2**64 - 1, 3, 2**40, true, true],
                 [t.order, t.seed, t.threads, t.memory_limit, t.compact, t.canonical]
    assert_equal [1.0, 50.0], [t.parameter(:separation), t.parameter("threshold")]
    refused(Mgdt::UnknownName) { t.parameter(:depth) }
    assert_raises(ArgumentError) { t.set_parameter(:separation, "apart") }
    refused(Mgdt::InvalidArgument) { t.set_parameter(:separation, :apart) }
    assert_equal 2.0, t.set_parameter(:separation, "2").parameter(:separation)
    before = t.statistic(:memory_bytes)
    assert_operator t.shrink.statistic(:memory_bytes), :<, before
    assert t.check
  end

  def test_location_and_nearest
    t = triangulation
    queries = self.class.bytes("queries").unpack("d*").each_slice(3).to_a
    located = self.class.integers("located").map { |k| k == -1 ? nil : k }
    found, weights = t.locate_points(queries)
    assert_equal located, found
    assert_equal self.class.doubles("weights").each_slice(4).to_a, weights
    assert_equal located, queries.map { |q| t.locate(q) }
    assert_includes 10..190, located.count(nil)
    distinct = POINTS.first(1000)
    queries.zip(self.class.integers("nearest")).each do |q, reference|
      # Brute force is the truth.
      best = distinct.each_index.min_by { |k| distinct[k].zip(q).sum { |a, b| (a - b)**2 } }
      assert_equal [best, best], [t.nearest(q), reference]
    end
    a, b = self.class.doubles("segment").each_slice(3).to_a
    assert_equal [self.class.integers("way"), self.class.doubles("way_parameters")], t.traverse_segment(a, b)
    assert_equal [[], []], t.traverse_segment([5, 5, 5], [6, 6, 6])
    refused(Mgdt::NotFinite, "x of a") { t.traverse_segment([NAN, 0, 0], b) }
    refused(Mgdt::InvalidArgument, "one point") { t.traverse_segment([a, b], b) }
    assert_equal self.class.integers("nearest"), t.nearest_points(queries)
    assert_equal [nil], Mgdt::Triangulation.new.nearest_points([[0, 0, 0]])
    assert_equal [[], []], t.locate_points([])
    assert_nil Mgdt::Triangulation.new.nearest([0, 0, 0])
    assert_nil Mgdt::Triangulation.new.locate([0, 0, 0])
  end

  def test_points_leave_and_move
    t = triangulation
    places = POINTS.map(&:dup)
    out, some = (0...POINTS.size).partition { |k| k % 3 == 0 }
    some.select! { |k| k % 3 == 1 }
    some.each { |k| places[k] = [places[k][0], places[k][1], places[k][2] + 1] }
    assert_same t, t.move(some, places.values_at(*some))
    assert_same t, t.remove(out)
    t.move_all(places.each_with_index.map { |p, k| out.include?(k) ? [NAN] * 3 : p })
    index = t.renumber
    assert_equal [nil, 0, 1, nil, 2, 3], index.first(6)
    rest = places.each_with_index.reject { |_, k| out.include?(k) }.map(&:first)
    assert_equal rest.size, t.point_count
    fresh = Mgdt::Triangulation.new(canonical: true)
    fresh.insert(rest)
    assert_equal fresh.tetrahedra, t.tetrahedra
    assert t.check
    assert_raises(Mgdt::Cancelled) { t.remove([1]) { :cancel } }
    assert_raises(Mgdt::Cancelled) { t.move([1], [[5, 5, 5]]) { :cancel } }
    refused(Mgdt::InvalidArgument, "point 3") { t.remove([3, 3]) }
    refused(Mgdt::InvalidArgument, "0.5") { t.remove([0.5]) }
    refused(Mgdt::InvalidArgument, "Array") { t.remove("3") }
    refused(Mgdt::InvalidArgument, "1 points and 2") { t.move([3], [[0, 0, 0], [1, 1, 1]]) }
    refused(Mgdt::NotFinite, "point 3") { t.move([3], [[0, NAN, 0]]) }
    assert_same t, t.remove([])
    assert_equal rest.size, t.vertex_count + t.statistic(:duplicates)
  end

  def test_index_base_one
    t = triangulation(index_base: 1)
    assert_equal(expected(:tetrahedra).map { |v| v.map { |k| k + 1 } }, t.tetrahedra)
    assert_equal 1, t.nearest(POINTS[0])
    assert_nil t.locate([5, 5, 5])
    list = self.class.integers("list")
    offsets = self.class.integers("offsets")
    assert_equal(list[offsets[7]...offsets[8]].map { |k| k + 1 }, t.vertex_tetrahedra[7])
    refused(Mgdt::NotFinite, "point 1012") { t.insert([[0, 0, 0], [NAN, 0, 0]]) }
  end

  def test_flat_sets_are_valid_and_wait
    t = Mgdt::Triangulation.new
    assert_equal [-1, []], [t.dimension, t.tetrahedra]
    t.insert([])
    10.times { |x| 10.times { |y| t.insert([x, y, 0]) } }
    assert_equal [2, 0, 100], [t.dimension, t.tetrahedron_count, t.vertex_count]
    assert_equal 34, t.nearest([3.2, 4.1, 7])
    assert_equal [[], [], []], [t.tetrahedra, t.neighbors, t.edges]
    assert t.check
    t.insert([0, 0, 1])
    assert_equal 3, t.dimension
    assert_operator t.tetrahedron_count, :>=, 162
    assert t.check
    assert_same t, t.clear
    assert_equal 0, t.point_count
    t.insert([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1])
    assert_equal 1, t.tetrahedron_count
  end

  def test_bad_values_are_refused_and_change_nothing
    t = triangulation
    assert_equal 12, refused(Mgdt::NotFinite, "point 1011", "y") { t.insert([[0, 0, 0], [0, NAN, 0]]) }.status
    refused(Mgdt::NotFinite, "point 1010", "x") { t.insert([[Float::INFINITY, 0, 0]]) }
    refused(Mgdt::InvalidArgument, "points[1]") { t.insert([[0, 0, 0], [1, 2]]) }
    refused(Mgdt::InvalidArgument, "number 5", '"z"') { t.insert([[0, 0, 0], [1, 2, "z"]]) }
    refused(Mgdt::InvalidArgument, "number 1", "nil") { t.insert([0, nil, 0]) }
    refused(Mgdt::InvalidArgument, "number 0", "i") { t.insert([Complex(0, 1), 0, 0]) }
    refused(Mgdt::InvalidArgument, "multiple of 3") { t.insert([0, 0, 0, 1]) }
    refused(Mgdt::InvalidArgument, "multiple of 3") { t.insert("0 0 0 and more") }
    refused(Mgdt::InvalidArgument, "too few") { t.insert([0, 0, 0], 2) }
    refused(Mgdt::InvalidArgument, "Hash") { t.insert({}) }
    refused(Mgdt::InvalidArgument, "NilClass") { t.insert(nil) }
    refused(Mgdt::InvalidArgument, "negative", "-1") { t.insert([], -1) }
    refused(Mgdt::InvalidArgument, "number of points") { t.insert(FFI::Pointer.new(8)) }
    refused(Mgdt::InvalidArgument, "NULL") { t.insert(FFI::Pointer::NULL, 1) }
    refused(Mgdt::InvalidArgument, "y is of class Array") { t.insert_strided(1, FFI::Pointer::NULL, [], []) }
    refused(Mgdt::UnknownName, "spiral") { t.order = "spiral" }
    refused(Mgdt::UnknownName, "speed") { t.statistic(:speed) }
    refused(Mgdt::UnknownName, "cells") { t.set_parameter(:cells, 3) }
    refused(Mgdt::InvalidArgument, "threshold", "-1") { t.set_parameter(:threshold, -1) }
    refused(Mgdt::InvalidArgument, "base") { t.index_base = 2 }
    refused(Mgdt::InvalidArgument, "base") { t.index_base = 2**40 }
    refused(Mgdt::InvalidArgument, "negative") { t.memory_limit = -1 }
    refused(Mgdt::InvalidArgument, "seed") { t.seed = -1 }
    refused(Mgdt::InvalidArgument, "threads") { t.threads = 1.5 }
    refused(Mgdt::InvalidArgument, "negative") { t.threads = -1 }
    refused(Mgdt::InvalidArgument, "level") { t.check(9) }
    refused(Mgdt::InvalidArgument, "mmx") { t.isa = "mmx" }
    refused(Mgdt::NotFinite) { t.locate([NAN, 0, 0]) }
    refused(Mgdt::NotFinite) { t.nearest([NAN, 0, 0]) }
    refused(Mgdt::NotFinite, "1") { t.locate_points([[0, 0, 0], [0, NAN, 0]]) }
    refused(Mgdt::InvalidArgument, "one point") { t.locate([[0, 0, 0], [1, 1, 1]]) }
    refused(ArgumentError, "colour") { Mgdt::Triangulation.new(colour: "red") }
    assert_equal 1010, t.point_count
    assert_equal expected(:tetrahedra), t.tetrahedra
    assert t.check
    t.isa = "baseline"
    assert_equal "baseline", t.isa
  end

  def test_memory_limit
    t = Mgdt::Triangulation.new(memory_limit: 100_000)
    assert_equal 30, refused(Mgdt::OutOfMemory, "memory") { t.insert(PACKED) }.status
    assert t.check
    assert_operator t.statistics[:peak_memory_bytes], :<=, 100_000
    t.memory_limit = nil
    t.insert(PACKED)
    assert_equal 1000, t.vertex_count
    assert t.check
  end

  def test_compact
    t = Mgdt::Triangulation.new
    t.insert(PACKED)
    before = t.statistic(:memory_bytes)
    t.compact = true
    after = t.statistic(:memory_bytes)
    assert_operator after, :<, before - 100 * 1000
    assert t.check
    t.memory_limit = 1
    refused(Mgdt::OutOfMemory, "memory") { t.compact = false }
    t.memory_limit = nil
    t.compact = false
    assert_operator t.statistic(:memory_bytes), :>, after
    t = Mgdt::Triangulation.new(compact: true, canonical: true)
    t.insert(PACKED)
    assert_operator t.statistic(:memory_bytes), :<, before - 100 * 1000
    assert_equal expected(:tetrahedra), t.tetrahedra
  end

  def test_progress
    seen = []
    Mgdt::Triangulation.new.insert(PACKED) { |fraction| seen << fraction }
    assert_equal seen.sort, seen
    assert_equal 1, seen.last
    assert_operator seen.size, :>, 50
  end

  def test_cancelling
    [->(_) { :cancel }, ->(t) { t.cancel }, ->(_) { throw :out }].each do |way|
      t = Mgdt::Triangulation.new
      error = refused(Mgdt::Cancelled, "1010 points") do
        catch(:out) { t.insert(PACKED) { |fraction| way.call(t) if fraction > 0.4 } }
      end
      assert_equal 40, error.status
      assert t.check
      assert_includes 101..999, t.vertex_count
      t.insert(PACKED)
      assert_equal 1000, t.vertex_count
      assert t.check
    end
    t = Mgdt::Triangulation.new
    assert_raises(Mgdt::Cancelled) { t.insert(PACKED) { break } }
    t.cancel
    assert_raises(Mgdt::Cancelled) { t.insert(PACKED) }
    t.insert(PACKED)
  end

  def test_cancelling_from_another_thread
    t = Mgdt::Triangulation.new
    started = Queue.new
    cancelled = Queue.new
    worker = Thread.new do
      Thread.current.report_on_exception = false
      t.insert(PACKED) do |fraction|
        if fraction.zero?
          started << true
          cancelled.pop
        end
      end
    end
    started.pop
    t.cancel
    cancelled << true
    assert_raises(Mgdt::Cancelled) { worker.value }
    assert_operator t.vertex_count, :<, 1000
    assert t.check
  end

  def test_other_threads_run_during_an_insertion
    random = Random.new(1)
    many = Array.new(3 * 200_000) { random.rand }.pack("d*")
    t = Mgdt::Triangulation.new(order: "random")
    worker = Thread.new { t.insert(many) }
    ticks = 0
    ticks += 1 while worker.join(0.001).nil?
    assert_operator ticks, :>, 10
    assert_equal 200_000, t.vertex_count
  end

  def test_what_the_block_raises_comes_out
    [0, 0.5, 1].each do |at|
      t = Mgdt::Triangulation.new
      mine = Class.new(StandardError)
      assert_raises(mine) { t.insert(PACKED) { |fraction| raise mine if fraction >= at } }
      assert t.check
    end
    t = Mgdt::Triangulation.new
    refused(Mgdt::Busy, "progress block") { t.insert(PACKED) { t.point_count } }
    refused(Mgdt::Busy, "progress block") { t.insert(PACKED) { t.close } }
    3000.times { assert_raises(IOError) { t.insert([0, 0, 0]) { raise IOError } } }
  end

  def test_threads_wait_for_each_other
    t = Mgdt::Triangulation.new(canonical: true)
    POINTS.each_slice(101).map { |some| Thread.new { 20.times { t.insert(some) } } }.each(&:join)
    assert_equal 1000, t.vertex_count
    assert_equal 20 * 1010, t.point_count
    assert t.check
  end

  def resident = File.read("/proc/self/statm").split[1].to_i * 4096

  def make(close)
    (1..1000).sum do |k|
      t = Mgdt::Triangulation.new
      t.insert(PACKED)
      held = t.statistic(:memory_bytes)
      t.close if close
      GC.start if (k % 10).zero?
      held
    end
  end

  def test_handles_are_freed
    [false, true].each do |close|
      make(close)
      GC.start
      before = resident
      held = make(close)
      GC.start
      grown = resident - before
      puts format("%d MB in 1000 handles; the process grew by %.1f MB", held / 1e6, grown / 1e6)
      assert_operator held, :>, 200e6
      assert_operator grown, :<, 40e6
    end
  end

  def test_closed
    t = triangulation
    t.close
    t.close
    assert t.closed?
    assert_includes t.inspect, "closed"
    %i[point_count tetrahedra vertex_tetrahedra cancel clear statistics].each do |name|
      refused(Mgdt::Closed, "closed") { t.public_send(name) }
    end
    refused(Mgdt::Closed) { t.insert(PACKED) }
  end

  # A C type as ffi names it.
  def ffi_type(text)
    return :string if text =~ /\Aconst char ?\*/
    return :pointer if text.include?("*")

    name = text[/\w+/]
    { "mgdt_status" => :int32, "mgdt_progress_fn" => :progress, "mgdt_size_fn" => :size, "mgdt_alloc_fn" => :pointer,
      "mgdt_free_fn" => :pointer, "void" => :void,
      "double" => :double }.fetch(name) { name.delete_suffix("_t").to_sym }
  end

  def test_declarations_are_those_of_the_header
    mgdt_h = ENV.fetch("MGDT_HEADER")
    headers = [mgdt_h, *%w[mgdt_voronoi.h mgdt_domain.h mgdt_mesh.h mgdt_periodic.h].map { |name| File.join(File.dirname(mgdt_h), name) }]
    header = headers.map { |name| File.read(name) }.join.gsub(%r{/\*.*?\*/}m, "")
    prototypes = header.scan(/MGDT_API\s+([^;()]*?)(mgdt_\w+)\(([^()]*)\);/m).to_h do |result, name, list|
      parameters = list.strip == "void" ? [] : list.split(",").map { |one| ffi_type(one.strip) }
      [name, [ffi_type(result.strip), *parameters]]
    end
    assert_equal prototypes.keys.sort, ATTACHED.keys.sort
    ATTACHED.each { |name, types| assert_equal prototypes[name], types, name }
  end

  def test_version
    assert_match(/\A\d+\.\d+\.\d+\z/, Mgdt.version)
    assert_equal Mgdt.version, Gem::Specification.load(ENV.fetch("MGDT_GEMSPEC")).version.to_s
  end
end
