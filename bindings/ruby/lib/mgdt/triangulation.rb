# SPDX-License-Identifier: MIT
# frozen_string_literal: true

module Mgdt
  # A triangulation that grows as points are inserted.
  #
  # One call at a time works on a triangulation: others, from other threads, wait for it. Only
  # cancel does not wait. Its memory is freed when it is collected, or by close.
  class Triangulation
    PARAMETERS = CONSTANTS[:parameter]
    SEPARATIONS = CONSTANTS[:separation]
    LEVELS = CONSTANTS[:check]
    MEASURES = CONSTANTS[:measure]
    TETRAHEDRON_MEASURES = CONSTANTS[:tetrahedron]
    METHODS = CONSTANTS[:method]
    SIDES = CONSTANTS[:outside]
    TOO_SMALL = CONSTANTS[:status][:buffer_too_small]
    STATISTICS = CONSTANTS[:statistic].values.to_h do |key|
      [Library.mgdt_stat_name(key).tr(" -", "__").to_sym, key]
    end.freeze
    # Names of the order schemes.
    ORDER_SCHEMES = FFI::MemoryPointer.new(:int32) do |out|
      break (0..).lazy.take_while { |k| Library.mgdt_order_scheme_at(k, out).zero? }
                 .map { Library.mgdt_order_scheme_name(out.read_int32) }.to_a
    end.freeze
    SETTINGS = %i[order seed threads index_base memory_limit compact canonical isa].freeze
    private_constant :PARAMETERS, :SEPARATIONS, :LEVELS, :MEASURES, :TETRAHEDRON_MEASURES, :METHODS, :SIDES, :TOO_SMALL,
                     :STATISTICS, :SETTINGS

    # Makes an empty triangulation. Settings: order, seed, threads, index_base, memory_limit,
    # compact, canonical, isa, and the parameters of the order schemes: points_per_cell, threshold,
    # separation, round_ratio.
    def initialize(**settings)
      out = FFI::MemoryPointer.new(:pointer)
      status = Library.mgdt_create(out)
      raise Error.of(status, Library.mgdt_status_string(status)) unless status.zero?

      @handle = Library::Handle.new(out.read_pointer)
      @mutex = Mutex.new
      @closing = Mutex.new
      @index_base = 0
      settings.each do |name, value|
        if SETTINGS.include?(name) then public_send(:"#{name}=", value)
        elsif PARAMETERS.key?(name) then set_parameter(name, value)
        else raise ArgumentError, "unknown setting: #{name.inspect}"
        end
      end
    end

    # Frees the memory now. Every later call but close and closed? raises Closed.
    def close
      exclusively do
        @closing.synchronize do
          @handle&.free
          @handle = nil
        end
      end
    end

    def closed?
      @handle.nil?
    end

    # Takes all points out; settings stay.
    def clear
      call(:mgdt_clear)
      self
    end

    # Announces how many points will be given in all. Optional.
    def reserve(count)
      call(:mgdt_reserve, integer(count, "the number of points", 63))
      self
    end

    # Frees what is kept for speed alone; it is made again when it is wanted. Since 1.2.
    def shrink
      call(:mgdt_shrink)
      self
    end

    # ---- settings, each with its reader since 1.2

    # Order scheme by name ("brio", "multi-grid", ...: see ORDER_SCHEMES).
    def order=(name)
      out = FFI::MemoryPointer.new(:int32)
      known = name.respond_to?(:to_s) && !name.to_s.include?("\0") &&
              Library.mgdt_order_scheme_from_name(name.to_s, out).zero?
      raise UnknownName.new("there is no order scheme #{name.inspect}", 13) unless known

      call(:mgdt_set_order_scheme, out.read_int32)
    end

    def order
      Library.mgdt_order_scheme_name(setting(:mgdt_get_order_scheme, :int32))
    end

    # A parameter of the order schemes: :points_per_cell, :threshold, :separation (:none, :passes,
    # :rounds or its number), :round_ratio.
    def set_parameter(name, value)
      key = parameter_key(name)
      value = separation(value) if key == PARAMETERS[:separation]
      call(:mgdt_set_order_parameter, key, Float(value))
      self
    end

    # The value of a parameter; 0 where each scheme has a default of its own.
    def parameter(name)
      setting(:mgdt_get_order_parameter, :double, parameter_key(name))
    end

    # Seed of the schemes that shuffle, 0 to 2**64 - 1.
    def seed=(value)
      raise argument("the seed is #{value.inspect}; it must be an Integer of 64 bits") unless
        value.is_a?(Integer) && (0...2**64).cover?(value)

      call(:mgdt_set_seed, value)
    end

    def seed = setting(:mgdt_get_seed, :uint64)

    # How many threads a call may use; 0 for all cores.
    def threads=(count)
      call(:mgdt_set_threads, integer(count, "the number of threads", 31))
    end

    def threads = setting(:mgdt_get_threads, :int32)

    # Number of the first point and the first tetrahedron: 0 (default) or 1.
    attr_reader :index_base

    def index_base=(base)
      call(:mgdt_set_index_base, integer(base, "the index base", 31))
      @index_base = base
    end

    # The most memory that the triangulation may hold, in bytes; nil or 0 for no limit.
    def memory_limit=(bytes)
      call(:mgdt_set_memory_limit, integer(bytes || 0, "the memory limit", 63))
    end

    # nil for no limit.
    def memory_limit
      bytes = setting(:mgdt_get_memory_limit, :int64)
      bytes.zero? ? nil : bytes
    end

    # Whether storage is compact: 30 % less memory, 20 to 40 % more time. At any time; what
    # it gives back, false needs again. Since 1.1.
    def compact=(flag)
      call(:mgdt_set_compact, flag ? 1 : 0)
    end

    def compact = setting(:mgdt_get_compact, :int32) == 1

    # Whether the output is a function of the set of points alone.
    def canonical=(flag)
      call(:mgdt_set_canonical_output, flag ? 1 : 0)
    end

    def canonical = setting(:mgdt_get_canonical_output, :int32) == 1

    # Instruction set: "baseline", "avx2", "avx512", "neon"; nil for the best.
    def isa=(name)
      raise argument("the instruction set is #{name.inspect}; it must be a String") unless
        name.nil? || (name.is_a?(String) && !name.include?("\0"))

      call(:mgdt_set_isa, name)
    end

    def isa
      count(:mgdt_isa_name)
    end

    # ---- points

    # Inserts points: an Array of [x, y, z], a flat Array, a String of native doubles, or an
    # FFI::Pointer with the number of points. A block hears of progress: the fraction done, 0 to 1,
    # about a hundred times; it stops the insertion by returning :cancel or by raising (break and
    # throw count as :cancel).
    def insert(points, count = nil, &progress)
      given = Points.new(points, count)
      insert_by(:mgdt_insert_points, progress, given.count, given.data)
    end

    # The same for coordinates in three places or inside records: FFI::Pointers to the first point's
    # x, y and z, and the distance from one point to the next, in doubles.
    def insert_strided(count, x, y, z, stride = 1, &progress)
      { x: x, y: y, z: z }.each do |name, value|
        raise argument("#{name} is of class #{value.class}; it must be an FFI::Pointer") unless
          value.is_a?(FFI::Pointer)
      end
      insert_by(:mgdt_insert_points_strided, progress, integer(count, "the number of points", 63),
                x, y, z, integer(stride, "the stride", 63))
    end

    # Takes points out, given by an Array of their numbers, each once; the others keep theirs. A block
    # hears of progress as in insert. Since 1.2.
    def remove(points, &progress)
      list = numbers(points)
      insert_by(:mgdt_remove_points, progress, list.size, list.pack("q*"))
    end

    # Moves points, given by an Array of their numbers, each once, to as many places, given as for
    # insert. Since 1.2.
    def move(points, places, &progress)
      list = numbers(points)
      given = Points.new(places)
      raise argument("there are #{list.size} points and #{given.count} places") unless
        given.count == list.size

      insert_by(:mgdt_move_points, progress, list.size, list.pack("q*"), given.data)
    end

    # Moves all points, in their order; those that are not in stay out. Since 1.2.
    def move_all(places, &progress)
      given = Points.new(places)
      insert_by(:mgdt_move_points, progress, given.count, nil, given.data)
    end

    # Numbers the points that are in anew, in their order, from index_base on, and forgets the others.
    # An Array of the new number of each point, nil if it was not in. Since 1.2.
    def renumber
      with_handle do |handle|
        length = Library.mgdt_point_count(handle)
        out = FFI::MemoryPointer.new(:int64, [length, 1].max)
        ensure_good(handle, Library.mgdt_renumber_points(handle, length, out))
        none = @index_base - 1
        out.read_array_of_int64(length).map { |k| k == none ? nil : k }
      end
    end

    # Stops the insertion, removal or move that is running, or else the next one. From any thread, and from the
    # block; from a trap handler by Thread.new { t.cancel }, since Ruby has no locks there.
    def cancel
      @closing.synchronize do
        raise closed_error unless @handle

        Library.mgdt_cancel(@handle)
      end
      self
    end

    # ---- counts

    def point_count = count(:mgdt_point_count)
    def vertex_count = count(:mgdt_vertex_count)
    def dimension = count(:mgdt_dimension)
    def tetrahedron_count = count(:mgdt_tetrahedron_count)
    def hull_facet_count = count(:mgdt_hull_facet_count)
    def edge_count = count(:mgdt_edge_count)

    # ---- export: Arrays, or, with `into`, an FFI::MemoryPointer of :int32 or :int64 to fill

    # Vertices of each tetrahedron, positively oriented.
    def tetrahedra(into: nil) = export(:tetrahedra, :mgdt_tetrahedron_count, 4, into)

    # Neighbours of each tetrahedron: number i is opposite vertex i; index_base - 1 for none.
    def neighbors(into: nil) = export(:neighbors, :mgdt_tetrahedron_count, 4, into)

    # Triangles of the convex hull, counter-clockwise seen from outside.
    def hull_facets(into: nil) = export(:hull_facets, :mgdt_hull_facet_count, 3, into)

    # Edges, the lesser index first.
    def edges(into: nil) = export(:edges, :mgdt_edge_count, 2, into)

    # For each point the vertex that stands for it; index_base - 1 if it is not in.
    def point_map(into: nil) = export(:point_map, :mgdt_point_count, 1, into)

    # For each point an Array of the tetrahedra around it; empty for what is no vertex.
    def vertex_tetrahedra = lists(:mgdt_vertex_tetrahedra_count, :mgdt_get_vertex_tetrahedra)

    # For each point an Array of its neighbours, the vertices that edges join it to.
    def vertex_neighbors = lists(:mgdt_vertex_neighbors_count, :mgdt_get_vertex_neighbors)

    # The edges that are the diameter of a sphere with no vertex inside: pairs of indices.
    def gabriel_edges = graph(:mgdt_edge_count, :mgdt_get_gabriel_edges)

    # The edges of the Euclidean minimum spanning tree: pairs of indices.
    def spanning_tree = graph(:mgdt_vertex_count, :mgdt_get_spanning_tree)

    # The circumspheres of the tetrahedra: an Array of centres [x, y, z], and one of the squares of
    # the radii.
    def circumcenters
      with_handle do |handle|
        n = Library.mgdt_tetrahedron_count(handle)
        xyz = FFI::MemoryPointer.new(:double, [3 * n, 1].max)
        squares = FFI::MemoryPointer.new(:double, [n, 1].max)
        ensure_good(handle, Library.mgdt_get_circumcenters(handle, n, xyz, squares))
        [xyz.read_array_of_double(3 * n).each_slice(3).to_a, squares.read_array_of_double(n)]
      end
    end

    # A measure of each point's Voronoi cell: :volume, :area, :faces, or :centroid, an Array of three
    # numbers. Cells are clipped to the planes [a, b, c, d], where a x + b y + c z <= d, given as
    # points are; without any, those of hull vertices are infinite.
    def cell_measures(measure, planes = [])
      key = choice(measure, MEASURES, "the measure")
      rows = Points.new(planes, width: 4, name: "planes")
      with_handle do |handle|
        room = Library.mgdt_point_count(handle) * (key == MEASURES[:centroid] ? 3 : 1)
        x = FFI::MemoryPointer.new(:double, [room, 1].max)
        ensure_good(handle, Library.mgdt_get_cell_measures(handle, key, rows.count, rows.data, room, x))
        values = x.read_array_of_double(room)
        key == MEASURES[:centroid] ? values.each_slice(3).to_a : values
      end
    end

    # A measure of each tetrahedron: :volume, :radius_ratio, :least_dihedral_angle, :largest_dihedral_angle (dihedral, in
    # radians) or :longest_edge; since 1.4 :volume_length or :edge_ratio. Since 1.3.
    def tetrahedron_measures(measure)
      key = choice(measure, TETRAHEDRON_MEASURES, "the measure")
      with_handle do |handle|
        n = Library.mgdt_tetrahedron_count(handle)
        x = FFI::MemoryPointer.new(:double, [n, 1].max)
        ensure_good(handle, Library.mgdt_get_tetrahedron_measures(handle, key, n, x))
        x.read_array_of_double(n)
      end
    end

    # The Voronoi diagram of the points, a Mgdt::Voronoi. Cells are clipped to the planes [a, b, c, d],
    # as by cell_measures. Faces with less than least_area are left out, and those with less than
    # least_share of the area of each of their cells. Since 1.3.
    def voronoi(planes = [], least_area: 0, least_share: 0)
      rows = Points.new(planes, width: 4, name: "planes")
      with_handle do |handle|
        out = FFI::MemoryPointer.new(:pointer)
        ensure_good(handle, Library.mgdt_voronoi_create(handle, rows.count, rows.data, out))
        reader = VoronoiReader.new(out.read_pointer, @index_base)
        begin
          reader.drop_small_faces(Float(least_area), Float(least_share))
          reader.read
        ensure
          reader.free
        end
      end
    end

    # Alphas, squares of radii, of the tetrahedra (dimension 3), of the facets opposite their vertices
    # (2), four Numbers each, of the edges (1), or of the points (0).
    def alphas(dimension)
      with_handle do |handle|
        counter = { 1 => :mgdt_edge_count, 0 => :mgdt_point_count }.fetch(dimension, :mgdt_tetrahedron_count)
        n = Library.public_send(counter, handle) * (dimension == 2 ? 4 : 1)
        x = FFI::MemoryPointer.new(:double, [n, 1].max)
        key = integer(dimension, "the dimension", 31)
        ensure_good(handle, Library.mgdt_get_alphas(handle, key, n, x))
        dimension == 2 ? x.read_array_of_double(n).each_slice(4).to_a : x.read_array_of_double(n)
      end
    end

    # The surface of an alpha shape: triples of indices, counter-clockwise seen from outside.
    def alpha_surface(alpha2)
      with_handle do |handle|
        # Enough for one surface or some; the count says what others need.
        room = (2 * Library.mgdt_vertex_count(handle)) + 4
        count = FFI::MemoryPointer.new(:int64)
        loop do
          facets = FFI::MemoryPointer.new(:int64, 3 * room)
          status = Library.mgdt_get_alpha_surface(handle, alpha2, 3 * room, facets, count)
          if status != TOO_SMALL
            ensure_good(handle, status)
            break facets.read_array_of_int64(3 * count.read_int64).each_slice(3).to_a
          end
          room = count.read_int64
        end
      end
    end

    # The least alpha with all vertices in one solid.
    def solid_alpha = setting(:mgdt_get_solid_alpha, :double)

    # ---- queries

    # The tetrahedron that contains a point [x, y, z], its boundary included; nil outside the hull.
    def locate(point) = find(:mgdt_locate, point)

    # The vertex nearest to a point [x, y, z]; nil if the triangulation is empty.
    def nearest(point) = find(:mgdt_nearest_vertex, point)

    # Locates many points at once, given as for insert: an Array of numbers of tetrahedra, nil
    # outside, and an Array of the four barycentric weights of each.
    def locate_points(points, count = nil)
      given = Points.new(points, count)
      raise argument("the number of points is negative (#{given.count})") if given.count.negative?

      found = FFI::MemoryPointer.new(:int64, [given.count, 1].max)
      weights = FFI::MemoryPointer.new(:double, [4 * given.count, 1].max)
      call(:mgdt_locate_points, given.count, given.data, found, weights)
      none = @index_base - 1
      [found.read_array_of_int64(given.count).map { |k| k == none ? nil : k },
       weights.read_array_of_double(4 * given.count).each_slice(4).to_a]
    end

    # The tetrahedra that the segment from a to b, [x, y, z] each, passes through, in order, and the
    # parameters between them: tetrahedron k is entered at a + parameters[k] * (b - a) and left at
    # a + parameters[k + 1] * (b - a). Since 1.3.
    def traverse_segment(a, b)
      from, to = [a, b].map { |point| one_point(point).data }
      count = FFI::MemoryPointer.new(:int64)
      with_handle do |handle|
        # Enough for most segments; the count says what others need.
        room = 128
        loop do
          found = FFI::MemoryPointer.new(:int64, room)
          parameters = FFI::MemoryPointer.new(:double, room + 1)
          status = Library.mgdt_traverse_segment(handle, from, to, room, found, parameters, count)
          n = count.read_int64
          if status != TOO_SMALL
            ensure_good(handle, status)
            break [found.read_array_of_int64(n), parameters.read_array_of_double(n.zero? ? 0 : n + 1)]
          end
          room = n
        end
      end
    end

    # The vertices nearest to many points at once, given as for insert: an Array, nil in an empty
    # triangulation. Since 1.2.
    def nearest_points(points, count = nil)
      given = Points.new(points, count)
      raise argument("the number of points is negative (#{given.count})") if given.count.negative?

      found = FFI::MemoryPointer.new(:int64, [given.count, 1].max)
      call(:mgdt_nearest_vertices, given.count, given.data, found)
      none = @index_base - 1
      found.read_array_of_int64(given.count).map { |k| k == none ? nil : k }
    end

    # ---- values between points

    # Values at places, given as points are for insert, from values at the points: one Number for each
    # point, or an Array of as many. The method is :linear, :nearest, :sibson, :laplace or :sibson_c1;
    # outside the hull :none (NaN), :nearest, :boundary or :linear. Since 1.2.
    def interpolate(method, values, places, outside: :none)
      key, side = manner(method, outside)
      given = Points.new(places)
      with_handle do |handle|
        fields, numbers = fields_of(values, Library.mgdt_point_count(handle))
        out = FFI::MemoryPointer.new(:double, [fields * given.count, 1].max)
        ensure_good(handle, Library.mgdt_interpolate(handle, key, side, fields, numbers, given.count,
                                                     given.data, out))
        of_fields(out.read_array_of_double(fields * given.count), values, fields)
      end
    end

    # The same as weights: for each place an Array of pairs of a point and its weight. Since 1.2.
    def interpolation_weights(method, places, outside: :none)
      key, side = manner(method, outside)
      given = Points.new(places)
      n = given.count
      with_handle do |handle|
        offsets = FFI::MemoryPointer.new(:int64, n + 1)
        # Enough for most; the last offset says what others need.
        room = (24 * n) + 8
        loop do
          points = FFI::MemoryPointer.new(:int64, [room, 1].max)
          weights = FFI::MemoryPointer.new(:double, [room, 1].max)
          status = Library.mgdt_get_interpolation_weights(handle, key, side, n, given.data, n + 1,
                                                          offsets, room, points, weights)
          ends = offsets.read_array_of_int64(n + 1).map { |k| k - @index_base }
          if status != TOO_SMALL
            ensure_good(handle, status)
            pairs = points.read_array_of_int64(ends[n]).zip(weights.read_array_of_double(ends[n]))
            break (0...n).map { |k| pairs[ends[k]...ends[k + 1]] }
          end
          room = ends[n]
        end
      end
    end

    # Gradients [x, y, z] of values at the points, given as for interpolate: one for each point, or an
    # Array of them. Since 1.2.
    def gradients(values)
      with_handle do |handle|
        n = Library.mgdt_point_count(handle)
        fields, numbers = fields_of(values, n)
        out = FFI::MemoryPointer.new(:double, [3 * fields * n, 1].max)
        ensure_good(handle, Library.mgdt_get_gradients(handle, fields, numbers, out))
        of_fields(out.read_array_of_double(3 * fields * n).each_slice(3).to_a, values, fields)
      end
    end

    # ---- trust, figures

    # Proves the triangulation by exact arithmetic, at a level :combinatorial, :geometric or
    # :canonical. True, or CheckFailed is raised, which says what and where.
    def check(level = :canonical)
      call(:mgdt_check, choice(level, LEVELS, "the level"))
      true
    end

    # All figures by name, as a Hash; or one of them.
    def statistics
      STATISTICS.keys.to_h { |name| [name, statistic(name)] }
    end

    def statistic(name)
      key = STATISTICS[name.to_sym]
      raise UnknownName.new("there is no statistic #{name.inspect}", 14) unless key

      value = FFI::MemoryPointer.new(:double)
      call(:mgdt_get_stat, key, value)
      value.read_double
    end

    def inspect
      handle = @handle
      return "#<Mgdt::Triangulation closed>" unless handle

      "#<Mgdt::Triangulation #{Library.mgdt_point_count(handle)} points, " \
        "#{Library.mgdt_tetrahedron_count(handle)} tetrahedra>"
    end

    private

    def manner(method, outside)
      [choice(method, METHODS, "the method"),
       choice(outside, SIDES, "what is outside")]
    end

    # The number of fields, and the values of n points one behind the other.
    def fields_of(values, n)
      fields = values.first.is_a?(Array) ? values.first.size : 1
      numbers = values.flatten(1)
      unless values.size >= n && numbers.size == fields * values.size
        raise argument("there are #{values.size} values of #{n} points, or not as many of each")
      end

      [fields, FFI::MemoryPointer.new(:double, [numbers.size, 1].max).write_array_of_double(numbers)]
    end

    def of_fields(results, values, fields)
      values.first.is_a?(Array) ? results.each_slice(fields).to_a : results
    end

    def argument(message)
      InvalidArgument.new(message, 11)
    end

    def closed_error
      Closed.new("the triangulation is closed", 10)
    end

    def integer(value, what, bits)
      return value if value.is_a?(Integer) && value.abs < 2**bits

      raise argument("#{what} is #{value.inspect}; it must be an Integer below 2**#{bits}")
    end

    # The number of a name, or a number that is one.
    def choice(value, names, what)
      return names[value] if names.key?(value)
      return integer(value, what, 31) if value.is_a?(Integer)

      raise argument("#{what} is #{value.inspect}; it must be one of " \
                     "#{names.keys.map(&:inspect).join(', ')}")
    end

    def numbers(points)
      raise argument("points are of class #{points.class}; they must be an Array of numbers") unless
        points.is_a?(Array)

      points.map { |k| integer(k, "the number of a point", 63) }
    end

    def separation(value)
      return value unless value.is_a?(Symbol) || SEPARATIONS.key?(value.to_s.to_sym)

      SEPARATIONS[value.to_sym] ||
        raise(argument("the separation is #{value.inspect}; it must be a number or one of " \
                       "#{SEPARATIONS.keys.map(&:inspect).join(', ')}"))
    end

    def parameter_key(name)
      PARAMETERS[name.to_sym] ||
        raise(UnknownName.new("there is no order parameter #{name.inspect}", 14))
    end

    def setting(function, type, *arguments)
      value = FFI::MemoryPointer.new(type)
      call(function, *arguments, value)
      value.get(type, 0)
    end

    # Runs the block with the handle; no other thread has it meanwhile, nor has a progress block.
    def exclusively
      if @mutex.owned?
        raise Busy.new("a progress block may not call its triangulation, except cancel", 41)
      end

      @mutex.synchronize { yield @handle }
    end

    def with_handle
      exclusively do |handle|
        raise closed_error unless handle

        yield handle
      end
    end

    def count(function)
      with_handle { |handle| Library.public_send(function, handle) }
    end

    def call(function, *arguments)
      with_handle do |handle|
        ensure_good(handle, Library.public_send(function, handle, *arguments))
      end
    end

    def ensure_good(handle, status)
      return if status.zero?

      buffer = FFI::MemoryPointer.new(:char, 256)
      Library.mgdt_get_error(handle, 256, buffer)
      message = buffer.read_string
      message = Library.mgdt_status_string(status) if message.empty?
      raise Error.of(status, message)
    end

    def insert_by(function, progress, *arguments)
      with_handle do |handle|
        return watched(handle, function, progress, *arguments) if progress

        ensure_good(handle, Library.public_send(function, handle, *arguments))
      end
      self
    end

    def watched(handle, function, progress, *arguments)
      status = Progress.watch(progress, ->(fn) { Library.mgdt_set_progress(handle, fn, nil) }) do
        Library.public_send(function, handle, *arguments)
      end
      ensure_good(handle, status)
      self
    end

    def one_point(point)
      given = Points.new(point)
      raise argument("one point is asked for, not #{given.count}") unless given.count == 1

      given
    end

    def find(function, point)
      out = FFI::MemoryPointer.new(:int64)
      call(function, one_point(point).data, out)
      number = out.read_int64
      number == @index_base - 1 ? nil : number
    end

    def export(what, rows, width, into)
      with_handle do |handle|
        length = width * Library.public_send(rows, handle)
        return fill(handle, what, into) if into

        buffer = FFI::MemoryPointer.new(:int64, [length, 1].max)
        ensure_good(handle, Library.public_send(:"mgdt_get_#{what}", handle, length, buffer))
        flat = buffer.read_array_of_int64(length)
        width == 1 ? flat : flat.each_slice(width).to_a
      end
    end

    def graph(most, get)
      with_handle do |handle|
        length = 2 * Library.public_send(most, handle)
        edges = FFI::MemoryPointer.new(:int64, [length, 1].max)
        count = FFI::MemoryPointer.new(:int64)
        ensure_good(handle, Library.public_send(get, handle, length, edges, count))
        edges.read_array_of_int64(2 * count.read_int64).each_slice(2).to_a
      end
    end

    def lists(count, get)
      with_handle do |handle|
        points = Library.mgdt_point_count(handle)
        length = Library.public_send(count, handle)
        offsets = FFI::MemoryPointer.new(:int64, points + 1)
        list = FFI::MemoryPointer.new(:int64, [length, 1].max)
        ensure_good(handle, Library.public_send(get, handle, points + 1, offsets, length, list))
        all = list.read_array_of_int64(length)
        offsets.read_array_of_int64(points + 1).each_cons(2).map do |from, to|
          all[(from - @index_base)...(to - @index_base)]
        end
      end
    end

    def fill(handle, what, into)
      raise argument("into must be an FFI::MemoryPointer of :int32 or :int64") unless
        into.is_a?(FFI::MemoryPointer) && [4, 8].include?(into.type_size)

      function = into.type_size == 4 ? :"mgdt_get_#{what}_i32" : :"mgdt_get_#{what}"
      ensure_good(handle, Library.public_send(function, handle, into.size / into.type_size, into))
      into
    end
  end
end
