-- SPDX-License-Identifier: MIT
--- mgdt for LuaJIT: exact 3D Delaunay triangulation.
--
--     local mgdt = require "mgdt"
--     local t = mgdt.new{ canonical = true }
--     t:insert{ {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1} }
--     local tetrahedra, count = t:tetrahedra()
--     for k = 0, count - 1 do print(tetrahedra[k][0], tetrahedra[k][1]) end
--
-- The library is the one that MGDT_LIBRARY names, or else libmgdt.so.1 as the loader finds it.
--
-- Arrays are FFI arrays, which start at 0, so points and tetrahedra are numbered from 0 as well;
-- mgdt.new{ index_base = 1 } numbers them from 1, the arrays still start at 0. "None" is base - 1
-- in arrays and nil as a result. Every output array is of int32_t, which holds all numbers there
-- can be and reads as plain Lua numbers.
--
-- A call that fails raises an error object with the fields status (a value of mgdt.status), name
-- ("not_finite") and message; tostring() gives the message. A handle is freed when it is
-- collected, or by t:close(), which gives large memory back at once.

local ffi = require "ffi"
local C = require "mgdt.library"

local constants = require "mgdt.interface"
local diagram = require "mgdt.diagram"
local arguments = require "mgdt.arguments"
local status = constants.status
local raise, bad_argument = arguments.raise, arguments.bad_argument
local whole, real, small, choice = arguments.whole, arguments.real, arguments.small, arguments.choice
local shape_of, rows_of = arguments.shape_of, arguments.rows_of
local ensure, message_of = arguments.raiser(C.mgdt_get_error)

-- Coordinates of points.
local function coordinates(points, n, what)
    return rows_of(points, n, what, 3, "points")
end

-- ------------------------------------------------------------------------------ triangulation

local Triangulation = {}
Triangulation.__index = Triangulation

local function handle_of(self)
    local handle = self.handle
    if not handle then raise(status.null_pointer, "the triangulation is closed") end
    if self.busy then
        raise(status.busy,
            "a progress function may not call its triangulation, except t:cancel()")
    end
    return handle
end

--- Frees the memory now. Any later call but close() raises an error.
function Triangulation:close()
    if not self.handle then return end
    local handle = handle_of(self)
    self.handle = nil
    C.mgdt_destroy(ffi.gc(handle, nil))
end

--- Takes all points out; settings stay.
function Triangulation:clear()
    local handle = handle_of(self)
    ensure(handle, C.mgdt_clear(handle))
end

--- Announces how many points will be given in all. Optional.
function Triangulation:reserve(n)
    local handle = handle_of(self)
    ensure(handle, C.mgdt_reserve(handle, whole(n, "the number of points")))
end

-- ----------------------------------------------------------------------------------- settings

local parameters, separations = constants.parameter, constants.separation

--- Chooses the order scheme by its name ("brio", "multi-grid", ...; mgdt.order_schemes lists them).
function Triangulation:set_order(name)
    local handle = handle_of(self)
    local scheme = ffi.new("int32_t[1]")
    if type(name) ~= "string" or C.mgdt_order_scheme_from_name(name, scheme) ~= 0 then
        raise(status.unknown_scheme, ("there is no order scheme %s"):format(tostring(name)))
    end
    ensure(handle, C.mgdt_set_order_scheme(handle, scheme[0]))
end

local function key_of(name)
    local key = parameters[name]
    if not key then
        raise(status.unknown_key, ("there is no order parameter %s"):format(tostring(name)))
    end
    return key
end

--- Sets a parameter of the order schemes: "points_per_cell", "threshold", "separation" ("none",
--- "passes", "rounds" or its number) or "round_ratio".
function Triangulation:set_parameter(name, value)
    local handle = handle_of(self)
    local key = key_of(name)
    if name == "separation" then value = separations[value] or value end
    ensure(handle, C.mgdt_set_order_parameter(handle, key, real(value, name)))
end

--- Sets the seed of the schemes that shuffle: a whole number, or a uint64_t.
function Triangulation:set_seed(seed)
    local handle = handle_of(self)
    if type(seed) == "number" then
        if whole(seed, "the seed") < 0 then bad_argument("the seed is negative (%d)", seed) end
    elseif not (ffi.istype("uint64_t", seed) or ffi.istype("int64_t", seed)) then
        bad_argument("the seed is %s; it must be a whole number", tostring(seed))
    end
    ensure(handle, C.mgdt_set_seed(handle, ffi.cast("uint64_t", seed)))
end

--- Sets how many threads a call may use; 0 for all cores.
function Triangulation:set_threads(n)
    local handle = handle_of(self)
    ensure(handle, C.mgdt_set_threads(handle, small(n, "the number of threads")))
end

--- Sets the number of the first point and the first tetrahedron: 0 (default) or 1.
function Triangulation:set_index_base(base)
    local handle = handle_of(self)
    base = small(base, "the index base")
    ensure(handle, C.mgdt_set_index_base(handle, base))
    self.none = base - 1
end

--- Limits the memory that the handle may hold, in bytes; 0 for no limit.
function Triangulation:set_memory_limit(bytes)
    local handle = handle_of(self)
    ensure(handle, C.mgdt_set_memory_limit(handle, whole(bytes, "the memory limit")))
end

--- Compact storage, true or false (default): 30 % less memory, 20 to 40 % more time. At any
--- time; what it gives back, false needs again. Since 1.1.
function Triangulation:set_compact(on)
    local handle = handle_of(self)
    ensure(handle, C.mgdt_set_compact(handle, on and 1 or 0))
end

--- Makes the output arrays a function of the set of points alone.
function Triangulation:set_canonical(on)
    local handle = handle_of(self)
    ensure(handle, C.mgdt_set_canonical_output(handle, on and 1 or 0))
end

--- Chooses the instruction set ("baseline", "avx2", "avx512", "neon"); nil for the best.
function Triangulation:set_isa(name)
    local handle = handle_of(self)
    if name ~= nil and type(name) ~= "string" then
        bad_argument("the instruction set is no string")
    end
    ensure(handle, C.mgdt_set_isa(handle, name))
end

-- One setting, by the getter of the C interface.
local function setting(self, get, kind)
    local handle = handle_of(self)
    local value = ffi.new(kind .. "[1]")
    ensure(handle, get(handle, value))
    return value[0]
end

--- The settings, each as it is set: the name of the order scheme, a parameter of the order schemes
--- (0 where each scheme has a default of its own), the seed as a uint64_t, numbers, true or false.
--- Since 1.2.
function Triangulation:get_order()
    return ffi.string(C.mgdt_order_scheme_name(setting(self, C.mgdt_get_order_scheme, "int32_t")))
end
function Triangulation:get_parameter(name)
    local handle, key = handle_of(self), key_of(name)
    local value = ffi.new("double[1]")
    ensure(handle, C.mgdt_get_order_parameter(handle, key, value))
    return value[0]
end
function Triangulation:get_seed() return setting(self, C.mgdt_get_seed, "uint64_t") end
function Triangulation:get_threads() return setting(self, C.mgdt_get_threads, "int32_t") end
function Triangulation:get_index_base() return setting(self, C.mgdt_get_index_base, "int32_t") end
function Triangulation:get_memory_limit()
    return tonumber(setting(self, C.mgdt_get_memory_limit, "int64_t"))
end
function Triangulation:get_compact() return setting(self, C.mgdt_get_compact, "int32_t") ~= 0 end
function Triangulation:get_canonical()
    return setting(self, C.mgdt_get_canonical_output, "int32_t") ~= 0
end

--- Frees what is kept for speed alone; it is made again when it is wanted. Since 1.2.
function Triangulation:shrink()
    local handle = handle_of(self)
    ensure(handle, C.mgdt_shrink(handle))
end

--- Name of the instruction set in use.
function Triangulation:isa() return ffi.string(C.mgdt_isa_name(handle_of(self))) end

--- Sets the function that insertions call about a hundred times with the fraction done, 0 to 1; nil
--- for none. Return true to cancel. An error in it cancels, and insert() raises it.
function Triangulation:set_progress(fn)
    handle_of(self)
    if fn ~= nil and type(fn) ~= "function" then
        bad_argument("the progress function is no function")
    end
    self.progress = fn
end

--- Stops the insertion, removal or move that is running (from a progress function), or else the next
--- one.
function Triangulation:cancel()
    if not self.handle then handle_of(self) end
    C.mgdt_cancel(self.handle)
end

-- ------------------------------------------------------------------------------------- points

-- A callback may not be called from compiled code, and is a scarce resource: it lives for one call.
local function with_progress(self, handle, insert, ...)
    if not self.progress then return ensure(handle, insert(handle, ...)) end
    local failed, problem = false, nil
    local callback = ffi.cast("mgdt_progress_fn", function(fraction)
        -- Nothing may be thrown through the library.
        local good, stop = pcall(self.progress, fraction)
        if not good then failed, problem = true, stop end
        return (not good or stop) and 1 or 0
    end)
    C.mgdt_set_progress(handle, callback, nil)
    self.busy = true
    local value = insert(handle, ...)
    self.busy = false
    C.mgdt_set_progress(handle, nil, nil)
    callback:free()
    if failed then error(problem, 0) end
    ensure(handle, value)
end
jit.off(with_progress, true)

-- Compiled code does not hold on to an argument whose address alone is in use any more; the
-- interpreter does. So what is given as an array is read by functions that are not compiled.

--- Inserts points: a table of {x, y, z}, a flat table of numbers, or an FFI array of double
--- (double[?], double[n][3]), which is read in place; a pointer needs the number of points n.
--- May be called any number of times.
function Triangulation:insert(points, n)
    local handle = handle_of(self)
    local xyz, count = coordinates(points, n, "points")
    with_progress(self, handle, C.mgdt_insert_points, count, xyz)
end
jit.off(Triangulation.insert)

--- The same for coordinates in three FFI arrays or pointers, or inside records; `stride` is the
--- distance from one point to the next in doubles, 1 if it is left out.
function Triangulation:insert_strided(n, x, y, z, stride)
    local handle = handle_of(self)
    n = whole(n, "the number of points")
    stride = whole(stride or 1, "the stride")
    local axes = { x, y, z }
    for k, name in ipairs { "x", "y", "z" } do
        local element, length = shape_of(axes[k])
        if element ~= "double" then
            bad_argument("%s must be an FFI array or pointer of double", name)
        end
        -- A pointer is the caller's word; into an array the last point must fall.
        if length and n > 0 and (stride < 0 or (n - 1) * stride >= length) then
            bad_argument("%s holds %d numbers, too few for %d points at a stride of %d", name,
                length, n, stride)
        end
        axes[k] = ffi.cast("const double *", axes[k])
    end
    with_progress(self, handle, C.mgdt_insert_points_strided, n, axes[1], axes[2], axes[3], stride)
end
jit.off(Triangulation.insert_strided)

-- Indices of points: a table of whole numbers, or an FFI array or pointer of int64_t with n.
local function indices(points, n)
    local element, length = shape_of(points)
    if element == "int64_t" then
        n = whole(n or length, "the number of points")
        if length and n > length then
            bad_argument("points holds %d indices, too few for %d points", length, n)
        end
        return ffi.cast("const int64_t *", points), n
    end
    if type(points) ~= "table" then
        bad_argument("points must be a table of indices, or an FFI array or pointer of int64_t")
    end
    local list = ffi.new("int64_t[?]", #points)
    for k, i in ipairs(points) do list[k - 1] = whole(i, "an index") end
    return list, #points
end

--- Takes points out, given by their indices, each once; the others keep theirs. Since 1.2.
function Triangulation:remove(points, n)
    local handle = handle_of(self)
    local list, count = indices(points, n)
    with_progress(self, handle, C.mgdt_remove_points, count, list)
end
jit.off(Triangulation.remove)

--- Moves points, given by their indices, each once, to as many places, given as for insert; or, with
--- nil for the points, all of them in their order, where those that are not in stay out. n is the
--- number of points where either is a pointer. Since 1.2.
function Triangulation:move(points, places, n)
    local handle = handle_of(self)
    local list, listed
    if points ~= nil then list, listed = indices(points, n) end
    local known = type(places) == "table" or not (n or listed)
    local xyz, count = coordinates(places, not known and (n or listed) or nil, "places")
    if listed and count ~= listed then
        bad_argument("there are %d points and %d places", listed, count)
    end
    with_progress(self, handle, C.mgdt_move_points, count, list, xyz)
end
jit.off(Triangulation.move)

--- Numbers the points that are in anew, in their order from the index base on, and forgets the
--- others: a new array of int64_t with the new index of each point, or t.none, and its length. Since
--- 1.2.
function Triangulation:renumber()
    local handle = handle_of(self)
    local n = tonumber(C.mgdt_point_count(handle))
    local index = ffi.new("int64_t[?]", n)
    ensure(handle, C.mgdt_renumber_points(handle, n, index))
    return index, n
end

-- ------------------------------------------------------------------------------ counts, export

local counts = {
    point_count = C.mgdt_point_count, vertex_count = C.mgdt_vertex_count,
    dimension = C.mgdt_dimension, tetrahedron_count = C.mgdt_tetrahedron_count,
    hull_facet_count = C.mgdt_hull_facet_count, edge_count = C.mgdt_edge_count,
}
for name, count in pairs(counts) do
    Triangulation[name] = function(self) return tonumber(count(handle_of(self))) end
end

-- An export: t:name() gives a new array of rows and their number; t:name(array) fills an FFI array
-- of int32_t or int64_t, t:name(pointer, capacity) what a pointer points to.
local function exporter(count, width, get32, get64)
    local row = ffi.typeof(width == 1 and "int32_t[?]" or ("int32_t[?][%d]"):format(width))
    return function(self, into, capacity)
        local handle = handle_of(self)
        local rows = tonumber(count(handle))
        local get = get32
        if into == nil then
            into, capacity = row(rows), width * rows
        else
            local element, length = shape_of(into)
            if element == "int64_t" then
                get = get64
            elseif element ~= "int" then
                bad_argument("the output must be an FFI array or pointer of int32_t or int64_t")
            end
            capacity = whole(capacity or length, "the capacity")
            if length and capacity > length then
                bad_argument("the capacity is %d; the array holds %d", capacity, length)
            end
        end
        local pointer = ffi.cast(get == get32 and "int32_t *" or "int64_t *", into)
        ensure(handle, get(handle, capacity, pointer))
        return into, rows
    end
end

--- Vertices of each tetrahedron, positively oriented: array[k][0] to array[k][3]; and the count.
Triangulation.tetrahedra = exporter(C.mgdt_tetrahedron_count, 4, C.mgdt_get_tetrahedra_i32,
    C.mgdt_get_tetrahedra)
--- Neighbours of each tetrahedron; array[k][i] is opposite vertex i.
Triangulation.neighbors = exporter(C.mgdt_tetrahedron_count, 4, C.mgdt_get_neighbors_i32,
    C.mgdt_get_neighbors)
--- Triangles of the convex hull, counter-clockwise seen from outside.
Triangulation.hull_facets = exporter(C.mgdt_hull_facet_count, 3, C.mgdt_get_hull_facets_i32,
    C.mgdt_get_hull_facets)
--- Edges, the lesser index first.
Triangulation.edges = exporter(C.mgdt_edge_count, 2, C.mgdt_get_edges_i32, C.mgdt_get_edges)
--- For each point the vertex that stands for it: array[k].
Triangulation.point_map = exporter(C.mgdt_point_count, 1, C.mgdt_get_point_map_i32,
    C.mgdt_get_point_map)

-- Offsets and list. Those of point k (counted from 0) are list[offsets[k] - base] to
-- list[offsets[k + 1] - base - 1].
local function lists(count, get)
    return function(self)
        local handle = handle_of(self)
        local points = tonumber(C.mgdt_point_count(handle))
        local length = tonumber(count(handle))
        local offsets = ffi.new("int32_t[?]", points + 1)
        local list = ffi.new("int32_t[?]", length)
        ensure(handle, get(handle, points + 1, offsets, length, list))
        return offsets, list, length
    end
end

--- Tetrahedra around each vertex: offsets and list, and its length.
Triangulation.vertex_tetrahedra = lists(C.mgdt_vertex_tetrahedra_count,
    C.mgdt_get_vertex_tetrahedra_i32)

--- Neighbours of each vertex, those that edges join it to: offsets and list, and its length.
Triangulation.vertex_neighbors = lists(C.mgdt_vertex_neighbors_count,
    C.mgdt_get_vertex_neighbors_i32)

-- Edges as array[k][0] and array[k][1], and their number.
local function graph(most, get)
    return function(self)
        local handle = handle_of(self)
        local rows = tonumber(most(handle))
        local edges, count = ffi.new("int32_t[?][2]", rows), ffi.new("int32_t[1]")
        ensure(handle, get(handle, 2 * rows, ffi.cast("int32_t *", edges), count))
        return edges, count[0]
    end
end

--- Edges that are the diameter of a sphere with no vertex inside, and their number.
Triangulation.gabriel_edges = graph(C.mgdt_edge_count, C.mgdt_get_gabriel_edges_i32)

--- Edges of the Euclidean minimum spanning tree, and their number.
Triangulation.spanning_tree = graph(C.mgdt_vertex_count, C.mgdt_get_spanning_tree_i32)

--- The centre of each tetrahedron's circumsphere, 3 doubles each, and the square of its radius.
function Triangulation:circumcenters()
    local handle = handle_of(self)
    local n = tonumber(C.mgdt_tetrahedron_count(handle))
    local xyz, squares = ffi.new("double[?]", 3 * n), ffi.new("double[?]", n)
    ensure(handle, C.mgdt_get_circumcenters(handle, n, xyz, squares))
    return xyz, squares, n
end

local measures, tetrahedron_measures = constants.measure, constants.tetrahedron

--- A measure of each tetrahedron, "volume", "radius_ratio", "least_dihedral_angle" or "largest_dihedral_angle" (dihedral,
--- in radians) or "longest_edge", and since 1.4 "volume_length" or "edge_ratio"; and the number of tetrahedra. Since 1.3.
function Triangulation:tetrahedron_measures(measure)
    local handle = handle_of(self)
    local key = choice(measure, tetrahedron_measures, "the measure")
    local n = tonumber(C.mgdt_tetrahedron_count(handle))
    local x = ffi.new("double[?]", n)
    ensure(handle, C.mgdt_get_tetrahedron_measures(handle, key, n, x))
    return x, n
end

--- A measure of each point's Voronoi cell, "volume", "area", "faces", or "centroid", 3 doubles each;
--- and the number of points. Cells are clipped to the planes {a, b, c, d}, where
--- a x + b y + c z <= d, given as points are; without any, those of hull vertices are infinite.
function Triangulation:cell_measures(measure, planes, n)
    local handle = handle_of(self)
    local key = choice(measure, measures, "the measure")
    local rows, number = nil, 0
    if planes ~= nil then rows, number = rows_of(planes, n, "planes", 4, "planes") end
    local count = tonumber(C.mgdt_point_count(handle))
    local room = (key == measures.centroid and 3 or 1) * count
    local x = ffi.new("double[?]", room)
    ensure(handle, C.mgdt_get_cell_measures(handle, key, number, rows, room, x))
    return x, count
end
jit.off(Triangulation.cell_measures)

--- The Voronoi diagram of the points, as a table of arrays. Those of integers are int32_t:
--- face_offsets, face_corners, face_sides ([k][0] and [k][1]), ray_vertices, cell_offsets, cell_faces,
--- cell_bounded, cell_neighbors (and face_shifts and cell_neighbor_shifts, of periodic boxes only). Those of
--- doubles are vertices, ray_directions, face_areas, face_normals, face_centroids, cell_volumes,
--- cell_centroids, cell_face_areas and cell_neighbor_distances; where there are three coordinates, they are [k][0]
--- to [k][2]. vertex_count, ray_count, face_count and cell_count say how many there are.
---
--- The corners of face k are face_corners[face_offsets[k]] to face_corners[face_offsets[k + 1] - 1],
--- less the index base. A negative corner -1 - r is ray r, and a negative side -1 - p is plane p, from 0.
---
--- Cells are clipped to the planes {a, b, c, d}, where a x + b y + c z <= d, given as points are. Faces
--- with less than least_area are left out, and those with less than least_share of the area of each of
--- their cells. Since 1.3.
function Triangulation:voronoi(planes, n, least_area, least_share)
    local handle = handle_of(self)
    local rows, number = nil, 0
    if planes ~= nil then rows, number = rows_of(planes, n, "planes", 4, "planes") end
    least_area = real(least_area or 0, "least_area")
    least_share = real(least_share or 0, "least_share")
    local out = ffi.new("mgdt_voronoi *[1]")
    ensure(handle, C.mgdt_voronoi_create(handle, number, rows, out))
    return diagram.take(out[0], least_area, least_share)
end
jit.off(Triangulation.voronoi)

--- Alphas, squares of radii, of the tetrahedra (dimension 3), of their facets (2), 4 each, of the
--- edges (1), or of the points (0); and how many they are.
function Triangulation:alphas(dimension)
    local handle = handle_of(self)
    dimension = small(dimension, "the dimension")
    local count = dimension == 3 and C.mgdt_tetrahedron_count or dimension == 1 and C.mgdt_edge_count
        or C.mgdt_point_count
    local n = dimension == 2 and 4 * tonumber(C.mgdt_tetrahedron_count(handle)) or tonumber(count(handle))
    local x = ffi.new("double[?]", n)
    ensure(handle, C.mgdt_get_alphas(handle, dimension, n, x))
    return x, n
end

--- The surface of an alpha shape: array[k][0] to array[k][2], counter-clockwise seen from outside; and
--- the number of its facets.
function Triangulation:alpha_surface(alpha2)
    local handle = handle_of(self)
    alpha2 = real(alpha2, "alpha2")
    local count = ffi.new("int32_t[1]")
    -- Enough for one surface or some; the count says what others need.
    local room = 2 * tonumber(C.mgdt_vertex_count(handle)) + 4
    while true do
        local facets = ffi.new("int32_t[?][3]", room)
        local value = C.mgdt_get_alpha_surface_i32(handle, alpha2, 3 * room,
            ffi.cast("int32_t *", facets), count)
        if value ~= status.buffer_too_small then
            ensure(handle, value)
            return facets, count[0]
        end
        room = count[0]
    end
end

--- The least alpha with all vertices in one solid.
function Triangulation:solid_alpha()
    local handle = handle_of(self)
    local value = ffi.new("double[1]")
    ensure(handle, C.mgdt_get_solid_alpha(handle, value))
    return value[0]
end

-- ------------------------------------------------------------------------------------ queries

local function place(point, what)
    if type(point) ~= "table" then bad_argument("%s is %s; it must be a table {x, y, z}", what, tostring(point)) end
    return ffi.new("double[3]", real(point[1], "x of " .. what), real(point[2], "y of " .. what),
        real(point[3], "z of " .. what))
end

local function one(self, ask, x, y, z)
    local handle = handle_of(self)
    local xyz = ffi.new("double[3]", real(x, "x"), real(y, "y"), real(z, "z"))
    local found = ffi.new("int64_t[1]")
    ensure(handle, ask(handle, xyz, found))
    local number = tonumber(found[0])
    if number == self.none then return nil end
    return number
end

--- The tetrahedron that contains a point, its boundary included; nil outside the hull.
function Triangulation:locate(x, y, z) return one(self, C.mgdt_locate, x, y, z) end

--- The vertex nearest to a point; nil if the triangulation is empty.
function Triangulation:nearest(x, y, z) return one(self, C.mgdt_nearest_vertex, x, y, z) end

--- Locates many points (given as for insert()) at once: an array of tetrahedra, an array of
--- barycentric weights, weights[k][0] to weights[k][3], and the number of points.
function Triangulation:locate_points(points, n)
    local handle = handle_of(self)
    local xyz, count = coordinates(points, n, "points")
    if count < 0 then bad_argument("the number of points is negative (%d)", count) end
    local found = ffi.new("int32_t[?]", count)
    local weights = ffi.new("double[?][4]", count)
    ensure(handle, C.mgdt_locate_points_i32(handle, count, xyz, found,
        ffi.cast("double *", weights)))
    return found, weights, count
end
jit.off(Triangulation.locate_points)

--- The tetrahedra that the segment from a to b, {x, y, z} each, passes through, in order; the
--- parameters between them, tetrahedron k from parameters[k] to parameters[k + 1]; and their number.
--- Since 1.3.
function Triangulation:traverse_segment(a, b)
    local handle = handle_of(self)
    local from, to = place(a, "a"), place(b, "b")
    local count = ffi.new("int32_t[1]")
    -- Enough for most segments; the count says what others need.
    local room = 128
    while true do
        local found, parameters = ffi.new("int32_t[?]", room), ffi.new("double[?]", room + 1)
        local value = C.mgdt_traverse_segment_i32(handle, from, to, room, found, parameters, count)
        if value ~= status.buffer_too_small then
            ensure(handle, value)
            return found, parameters, count[0]
        end
        room = count[0]
    end
end

--- The vertices nearest to many points (given as for insert()): an array, and the number of points.
--- Since 1.2.
function Triangulation:nearest_points(points, n)
    local handle = handle_of(self)
    local xyz, count = coordinates(points, n, "points")
    if count < 0 then bad_argument("the number of points is negative (%d)", count) end
    local found = ffi.new("int32_t[?]", count)
    ensure(handle, C.mgdt_nearest_vertices_i32(handle, count, xyz, found))
    return found, count
end
jit.off(Triangulation.nearest_points)

-- ----------------------------------------------------------------- values between points

local methods, sides = constants.method, constants.outside

-- Numbers for each point: a table or an array of doubles, `fields` for each one behind the other.
local function values_of(handle, values, fields)
    local n = fields * tonumber(C.mgdt_point_count(handle))
    if type(values) == "cdata" then return ffi.cast("const double *", values) end
    if type(values) ~= "table" or #values < n then
        bad_argument("values must have %d numbers for each of the points, %d in all", fields, n)
    end
    local array = ffi.new("double[?]", n)
    for k = 1, n do array[k - 1] = real(values[k], "a value") end
    return array
end

local function manner(method, outside)
    return choice(method, methods, "the method"), choice(outside or "none", sides, "what is outside")
end

--- Values at places (given as points are for insert()) from values at the points: an array of doubles,
--- and the number of places. The method is "linear", "nearest", "sibson", "laplace" or "sibson_c1";
--- outside the hull "none" (NaN, the default), "nearest", "boundary" or "linear". With `fields`
--- numbers for each point, those of a place are one behind the other. Since 1.2.
function Triangulation:interpolate(method, values, places, outside, fields, n)
    local handle = handle_of(self)
    local key, side = manner(method, outside)
    fields = small(fields or 1, "the number of fields")
    local xyz, count = coordinates(places, n, "places")
    if count < 0 then bad_argument("the number of places is negative (%d)", count) end
    local given = values_of(handle, values, fields)
    local out = ffi.new("double[?]", fields * count)
    ensure(handle, C.mgdt_interpolate(handle, key, side, fields, given, count, xyz, out))
    return out, count
end
jit.off(Triangulation.interpolate)

--- The same as weights: arrays of offsets, points and weights, and the number of places. The value at
--- place k, from 0, is the sum of weights[i] times that of point points[i], i from offsets[k] to before
--- offsets[k + 1], less the index base. Since 1.2.
function Triangulation:interpolation_weights(method, places, outside, n)
    local handle = handle_of(self)
    local key, side = manner(method, outside)
    local xyz, count = coordinates(places, n, "places")
    if count < 0 then bad_argument("the number of places is negative (%d)", count) end
    local offsets = ffi.new("int32_t[?]", count + 1)
    -- Enough for most; the last offset says what others need.
    local room = 24 * count + 8
    while true do
        local points, weights = ffi.new("int32_t[?]", room), ffi.new("double[?]", room)
        local value = C.mgdt_get_interpolation_weights_i32(handle, key, side, count, xyz, count + 1,
            offsets, room, points, weights)
        if value ~= status.buffer_too_small then
            ensure(handle, value)
            return offsets, points, weights, count
        end
        room = offsets[count] - offsets[0]
    end
end
jit.off(Triangulation.interpolation_weights)

--- Gradients of values at the points: an array of 3 doubles for each field of each point, and the
--- number of points. Since 1.2.
function Triangulation:gradients(values, fields)
    local handle = handle_of(self)
    fields = small(fields or 1, "the number of fields")
    local given = values_of(handle, values, fields)
    local count = tonumber(C.mgdt_point_count(handle))
    local out = ffi.new("double[?]", 3 * fields * count)
    ensure(handle, C.mgdt_get_gradients(handle, fields, given, out))
    return out, count
end

-- ----------------------------------------------------------------------------- trust, figures

local levels = constants.check

--- Proves the triangulation by exact arithmetic, at a level "combinatorial", "geometric" or
--- "canonical" (default), or 1 to 3. True, or nil and what is wrong.
function Triangulation:check(level)
    local handle = handle_of(self)
    if level == nil then level = 3 end
    local value = C.mgdt_check(handle, choice(level, levels, "the level"))
    if value == status.check_failed then return nil, message_of(handle, value) end
    ensure(handle, value)
    return true
end

local figures = {}
for _, key in pairs(constants.statistic) do
    local name = C.mgdt_stat_name(key)
    if name ~= nil then figures[(ffi.string(name):gsub("[ -]", "_"))] = key end
end

--- One figure by its name ("walk_steps", "memory_bytes", ...).
function Triangulation:statistic(name)
    local handle = handle_of(self)
    local key = figures[name]
    if not key then
        raise(status.unknown_key, ("there is no statistic %s"):format(tostring(name)))
    end
    local value = ffi.new("double[1]")
    ensure(handle, C.mgdt_get_stat(handle, key, value))
    return value[0]
end

--- All figures, as a table by name.
function Triangulation:statistics()
    local all = {}
    for name in pairs(figures) do all[name] = self:statistic(name) end
    return all
end

function Triangulation:__tostring()
    if not self.handle then return "mgdt triangulation (closed)" end
    return ("mgdt triangulation: %d points, %d tetrahedra"):format(
        tonumber(C.mgdt_point_count(self.handle)), tonumber(C.mgdt_tetrahedron_count(self.handle)))
end

-- ------------------------------------------------------------------------------------- module

local domain = require "mgdt.domain"
local mesh = require "mgdt.mesh"
local periodic = require "mgdt.periodic"
local mgdt = { status = status, order_schemes = {}, Triangulation = Triangulation,
    domain_mesh = domain.domain_mesh, clean_surface = domain.clean_surface, mesh = mesh.mesh, offending_pairs = domain.offending_pairs,
    periodic_box = periodic.periodic_box }
do
    local scheme = ffi.new("int32_t[1]")
    while C.mgdt_order_scheme_at(#mgdt.order_schemes, scheme) == 0 do
        table.insert(mgdt.order_schemes, ffi.string(C.mgdt_order_scheme_name(scheme[0])))
    end
end

--- Version of the library that is loaded, "1.2.0".
function mgdt.version() return ffi.string(C.mgdt_version_string()) end

local setters = {
    order = "set_order", seed = "set_seed", threads = "set_threads", index_base = "set_index_base",
    memory_limit = "set_memory_limit", compact = "set_compact", canonical = "set_canonical",
    isa = "set_isa", progress = "set_progress",
}

--- Makes an empty triangulation. Settings, all optional: order, seed, threads, index_base,
--- memory_limit, compact, canonical, isa, progress, and the parameters of the order schemes.
function mgdt.new(settings)
    local out = ffi.new("mgdt_triangulation *[1]")
    local value = C.mgdt_create(out)
    if value ~= 0 then raise(value, ffi.string(C.mgdt_status_string(value))) end
    local self = setmetatable({ handle = ffi.gc(out[0], C.mgdt_destroy), none = -1, busy = false },
        Triangulation)
    for name, setting in pairs(settings or {}) do
        if setters[name] then
            self[setters[name]](self, setting)
        elseif parameters[name] then
            self:set_parameter(name, setting)
        else
            bad_argument("there is no setting %s", tostring(name))
        end
    end
    return self
end

return mgdt
