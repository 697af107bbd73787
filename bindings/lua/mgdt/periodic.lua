-- SPDX-License-Identifier: MIT
--- Points in periodic boxes, for mgdt.lua.

local ffi = require "ffi"
local C = require "mgdt.library"
local constants = require "mgdt.interface"
local arguments = require "mgdt.arguments"
local diagram = require "mgdt.diagram"

local status, arrays = constants.status, constants.periodic_array
local raise, bad_argument = arguments.raise, arguments.bad_argument
local whole, real, rows_of, choice = arguments.whole, arguments.real, arguments.rows_of, arguments.choice
local of_box = require("mgdt.keyed").of "periodic"
local ensure, message_of = of_box.ensure, of_box.message_of

-- The vectors of a box: three lengths, or up to three vectors.
local function vectors_of(box)
    if type(box) == "table" and type(box[1]) == "number" and #box == 3 then
        box = { { box[1], 0, 0 }, { 0, box[2], 0 }, { 0, 0, box[3] } }
    end
    local xyz, count = rows_of(box, nil, "box", 3, "vectors")
    if count < 1 or count > 3 then bad_argument("box has %d vectors; it must have one to three", count) end
    return xyz, count
end

local function build(handle, progress)
    ensure(handle, of_box.watch(handle, progress, C.mgdt_periodic_build))
end

local Box = {}
Box.__index = Box

local function read(self)
    local handle = self.handle
    for name in pairs(arrays) do
        local count
        self[name], count = of_box.get(handle, name)
        if name == "points" then self.point_count = count end
        if name == "tetrahedra" then self.tetrahedron_count = count end
        if name == "vectors" then self.vector_count = count end
    end
    self.vertex_count = of_box.statistic(handle, "vertices")
    self.edge_count = of_box.statistic(handle, "edges")
end

--- Moves all points, given as for insert(), as in a time step, and sets other vectors of the box, if
--- there are any. The arrays are read anew.
function Box:move(points, n, box)
    local xyz, count = rows_of(points, n, "points", 3, "points")
    if box ~= nil then
        local vectors, dimensions = vectors_of(box)
        ensure(self.handle, C.mgdt_periodic_set_vectors(self.handle, dimensions, vectors))
    end
    ensure(self.handle, C.mgdt_periodic_move_points(self.handle, count, nil, xyz))
    build(self.handle, self.progress)
    read(self)
end
jit.off(Box.move)

--- Proves the triangulation, exactly. True, or nil and what is wrong.
function Box:check()
    local value = C.mgdt_periodic_check(self.handle)
    if value == status.check_failed then return nil, message_of(self.handle, value) end
    ensure(self.handle, value)
    return true
end

--- A measure of each point's cell, "volume", "area", "faces", or "centroid", 3 doubles each, from the
--- point; and the number of points.
function Box:cell_measures(measure)
    local key = choice(measure, constants.measure, "the measure")
    local room = (key == constants.measure.centroid and 3 or 1) * self.point_count
    local x = ffi.new("double[?]", room)
    ensure(self.handle, C.mgdt_periodic_get_cell_measures(self.handle, key, room, x))
    return x, self.point_count
end
jit.off(Box.cell_measures)

--- The Voronoi diagram of the points, a table as that of voronoi() of a triangulation. face_shifts[k][0]
--- to [k][2] say which image of the second point a face is between.
function Box:voronoi(least_area, least_share)
    least_area, least_share = real(least_area or 0, "least_area"), real(least_share or 0, "least_share")
    local out = ffi.new("mgdt_voronoi *[1]")
    ensure(self.handle, C.mgdt_periodic_create_voronoi(self.handle, out))
    return diagram.take(out[0], least_area, least_share)
end
jit.off(Box.voronoi)

function Box:__tostring()
    return ("mgdt periodic box: %d points, %d vectors, %d tetrahedra"):format(self.point_count,
        self.vector_count, self.tetrahedron_count)
end

local known = { points = true, box = true, threads = true, memory_limit = true, index_base = true,
    merge_distance = true, progress = true }

local periodic = {}

--- The triangulation of points in a periodic box, from a table with points (as for insert()) and box:
--- three lengths, or one to three vectors {x, y, z}. Optional: threads, memory_limit, index_base (0),
--- merge_distance (points that have images within this distance of each other become equal; 0), and progress, a
--- function as for set_progress().
---
--- The result has the arrays points, vectors, tetrahedra, tetrahedron_shifts, neighbors, neighbor_shifts,
--- point_shifts and vertex_neighbor_shifts, with [k][0] and so on (shifts of tetrahedra have twelve numbers
--- each), and
--- point_map, vertex_neighbor_offsets and vertex_neighbors; mgdt/mgdt_periodic.h says what they are.
--- point_count, vector_count, vertex_count, edge_count and tetrahedron_count say how many there are.
--- Since 1.3.
function periodic.periodic_box(given)
    if type(given) ~= "table" then bad_argument("a table with points and box is needed") end
    for name in pairs(given) do
        if not known[name] then bad_argument("there is no setting %s", tostring(name)) end
    end
    local vectors, dimensions = vectors_of(given.box)
    local xyz, count = rows_of(given.points, nil, "points", 3, "points")
    local out = ffi.new("mgdt_periodic *[1]")
    local value = C.mgdt_periodic_create(out)
    if value ~= 0 then raise(value, ffi.string(C.mgdt_status_string(value))) end
    local handle = ffi.gc(out[0], C.mgdt_periodic_destroy)
    ensure(handle, C.mgdt_periodic_set_vectors(handle, dimensions, vectors))
    of_box.set_option(handle, "index_base", whole(given.index_base or 0, "index_base"))
    of_box.set_option(handle, "threads", whole(given.threads or 1, "threads"))
    of_box.set_option(handle, "memory_limit", whole(given.memory_limit or 0, "memory_limit"))
    ensure(handle, C.mgdt_periodic_set_merge_distance(handle, real(given.merge_distance or 0, "merge_distance")))
    ensure(handle, C.mgdt_periodic_insert_points(handle, count, xyz))
    build(handle, given.progress)
    local box = setmetatable({ handle = handle, progress = given.progress }, Box)
    read(box)
    return box
end
-- Compiled code does not hold on to an array whose address alone is in use any more.
jit.off(periodic.periodic_box)

return periodic
