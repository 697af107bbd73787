-- SPDX-License-Identifier: MIT
--- Meshes of tetrahedra, their refinement and their improvement, for mgdt.lua.

local ffi = require "ffi"
local C = require "mgdt.library"
local constants = require "mgdt.interface"
local arguments = require "mgdt.arguments"
local keyed = require "mgdt.keyed"

local status = constants.status
local raise, bad_argument = arguments.raise, arguments.bad_argument
local whole, choice = arguments.whole, arguments.choice
local rows_of, list_of, markers_of = arguments.rows_of, arguments.list_of, arguments.markers_of
local of_mesh = keyed.of "mesh"
local ensure = of_mesh.ensure

local Mesh = {}
Mesh.__index = Mesh

-- Reads what the library has.
local function read(mesh)
    for name in pairs(constants.mesh_array) do mesh[name] = of_mesh.get(mesh.handle, name) end
    for _, name in ipairs { "point", "tetrahedron", "region", "face", "edge" } do
        local plural = name == "tetrahedron" and "tetrahedra" or name .. "s"
        mesh[name .. "_count"] = of_mesh.statistic(mesh.handle, plural)
    end
    mesh.steiner_count = of_mesh.statistic(mesh.handle, "steiner_points")
    mesh.is_rounded = of_mesh.statistic(mesh.handle, "is_rounded") == 1
    mesh.below_goal = of_mesh.statistic(mesh.handle, "below_goal")
    mesh.inserted_points = of_mesh.statistic(mesh.handle, "inserted_points")
    mesh.refused = of_mesh.statistic(mesh.handle, "refused")
end

--- Proves the mesh, exactly; that of a domain also against the facets and segments, until it is improved. True, or
--- nil and what is wrong.
function Mesh:check()
    local value = C.mgdt_mesh_check(self.handle)
    if value == status.check_failed then return nil, of_mesh.message_of(self.handle, value) end
    ensure(self.handle, value)
    if self.compare and of_mesh.statistic(self.handle, "is_of_domain") == 1 then return self.compare(self) end
    return true
end

--- A measure of each tetrahedron: "volume", "radius_ratio", "least_dihedral_angle", "largest_dihedral_angle" or
--- "longest_edge", and since 1.4 "volume_length" or "edge_ratio"; and the number of tetrahedra.
function Mesh:tetrahedron_measures(measure)
    local key = choice(measure, constants.tetrahedron, "the measure")
    local x = ffi.new("double[?]", self.tetrahedron_count)
    ensure(self.handle, C.mgdt_mesh_get_tetrahedron_measures(self.handle, key, self.tetrahedron_count, x))
    return x, self.tetrahedron_count
end
jit.off(Mesh.tetrahedron_measures)

-- Calls body() while the library asks a function of x, y and z for sizes, and raises its errors afterwards.
local function with_sizes(handle, find, body)
    if find == nil then return body() end
    if type(find) ~= "function" then bad_argument("size_function is %s; it must be a function", type(find)) end
    local failed, problem = false, nil
    local callback = ffi.cast("mgdt_size_fn", function(n, xyz, sizes)
        -- Nothing may be thrown through the library.
        local good, what = pcall(function()
            for k = 0, tonumber(n) - 1 do sizes[k] = find(xyz[3 * k], xyz[3 * k + 1], xyz[3 * k + 2]) end
        end)
        if not good then failed, problem = true, what end
        return good and 0 or 1
    end)
    C.mgdt_mesh_set_size_function(handle, callback, nil)
    local good, value = pcall(body)
    C.mgdt_mesh_set_size_function(handle, nil, nil)
    callback:free()
    if failed then error(problem, 0) end
    if not good then error(value, 0) end
    return value
end
jit.off(with_sizes, true)

-- Changes a mesh by a function of the library, and reads the new arrays, also if the call fails.
local function change(self, progress, call)
    local value = of_mesh.watch(self.handle, progress, function(of) return call(of) end)
    read(self)
    ensure(self.handle, value)
    return self
end
jit.off(change, true)

local options = { goal = whole, boundary = constants.boundary, points = constants.points, mean_passes = whole,
    most_passes = whole }

--- Improves the tetrahedra until all dihedral angles reach a goal, or nothing helps; then the mesh has the new
--- arrays. Optional, in a table: goal (25, in degrees), boundary ("fixed" or "slide"), points ("keep", "move" or
--- "remove"), fixed (a list of points), mean_passes (0), most_passes (100), and progress, a function. What is not given
--- stays as the last call has set it. `shapes`, `angle_histogram`, `tetrahedra_below` and `reasons` say what has become better, and below_goal
--- how many tetrahedra are left. Since 1.4.
function Mesh:improve(given)
    local progress
    for name, value in pairs(given or {}) do
        local kind = options[name]
        if kind == whole then
            of_mesh.set_option(self.handle, name, whole(value, name))
        elseif kind then
            of_mesh.set_option(self.handle, name, choice(value, kind, name))
        elseif name == "fixed" then
            if type(value) ~= "table" then bad_argument("fixed must be a list of points") end
            ensure(self.handle, C.mgdt_mesh_set_fixed_points(self.handle, #value, list_of(value, "fixed", "int64_t")))
        elseif name == "progress" then
            progress = value
        else
            bad_argument("there is no setting %s", tostring(name))
        end
    end
    return change(self, progress, C.mgdt_mesh_improve)
end
jit.off(Mesh.improve, true)

local function double(value, name)
    if type(value) ~= "number" then bad_argument("%s is %s; it must be a number", name, type(value)) end
    return value
end

local function switch(value, name)
    if type(value) ~= "boolean" then bad_argument("%s is %s; it must be true or false", name, type(value)) end
    return value and 1 or 0
end

local refinement = { most_points = whole, sizes_of_surface = switch, size = double, gradation = double,
    radius_edge = double, volume = double }
local sizes_of = { point_sizes = "of_points", tetrahedron_sizes = "of_tetrahedra", region_sizes = "of_regions" }

local function numbers(list, name)
    if type(list) ~= "table" then bad_argument("%s must be a list of numbers", name) end
    local to = ffi.new("double[?]", #list)
    for k, value in ipairs(list) do to[k - 1] = double(value, name) end
    return to, #list
end

--- Inserts points until the tetrahedra have the wanted sizes and shapes; then the mesh has the new arrays. Optional, in
--- a table: size (of edges everywhere), point_sizes, tetrahedron_sizes and region_sizes (a list with a size for each, 0
--- for none), size_field (a list of points and a list of sizes, linear between the points), size_function (of x, y and z,
--- which gives a size, 0 for none), sizes_of_surface (whether edges of the surface say how long those at their ends should be), gradation (0.3),
--- radius_edge (1.4, or 0), volume (0), most_points (0 for no limit), and progress, a function. Numbers that are not given stay
--- as the last call has set them. `inserted_points` and `refused` count; `refusals` and `sizes` say more. Since 1.4.
function Mesh:refine(given)
    local progress, find
    for name, value in pairs(given or {}) do
        local kind = refinement[name]
        if kind == double then
            of_mesh.set_double_option(self.handle, name, double(value, name))
        elseif kind then
            of_mesh.set_option(self.handle, name, kind(value, name))
        elseif sizes_of[name] then
            local list, count = numbers(value, name)
            ensure(self.handle, C.mgdt_mesh_set_sizes(self.handle, constants.sizes[sizes_of[name]], count, list))
        elseif name == "size_field" then
            if type(value) ~= "table" then bad_argument("size_field must be a list of points and a list of sizes") end
            local xyz, n = rows_of(value[1], nil, "size_field", 3, "points")
            local list, count = numbers(value[2], name)
            if count ~= n then bad_argument("size_field has %d points and %d sizes", n, count) end
            ensure(self.handle, C.mgdt_mesh_set_size_field(self.handle, n, xyz, list))
        elseif name == "size_function" then
            find = value
        elseif name == "progress" then
            progress = value
        else
            bad_argument("there is no setting %s", tostring(name))
        end
    end
    return with_sizes(self.handle, find, function() return change(self, progress, C.mgdt_mesh_refine) end)
end
jit.off(Mesh.refine, true)

-- Places as rows, and what is outside as the library names it.
local function asked(places, outside)
    local xyz, count = rows_of(places, nil, "places", 3, "places")
    return xyz, count, choice(outside or "none", constants.outside, "outside")
end

--- The tetrahedra that contain places, exactly, or the index base - 1; and barycentric weights, with [k][0] and so
--- on. outside is "none", or "boundary" to take the nearest place of the boundary for a place outside. Since 1.4.
function Mesh:locate_points(places, outside)
    local xyz, count, key = asked(places, outside)
    local found, weights = ffi.new("int32_t[?]", count), ffi.new("double[?][4]", count)
    ensure(self.handle, C.mgdt_mesh_locate_points_i32(self.handle, key, count, xyz, found, ffi.cast("double *", weights)))
    return found, weights
end
jit.off(Mesh.locate_points)

--- Values at places, as rows: linear in each tetrahedron between those at the points, rows of `values`; nan where there is none.
--- outside is as for locate_points(). Since 1.4.
function Mesh:interpolate(values, places, outside)
    local width = type(values) == "table" and type(values[1]) == "table" and #values[1] or 1
    local xyz, count, key = asked(places, outside)
    if type(values) ~= "table" or #values ~= self.point_count then
        bad_argument("values must be a table with one row for each of the %d points", self.point_count)
    end
    local of_points = ffi.new("double[?]", width * self.point_count)
    for k, row in ipairs(values) do
        if width > 1 and (type(row) ~= "table" or #row ~= width) then bad_argument("values[%d] is not %d numbers", k, width) end
        for i = 1, width do
            local value = width > 1 and row[i] or row
            of_points[width * (k - 1) + i - 1] = arguments.real(type(value) == "table" and value[1] or value, ("values[%d]"):format(k))
        end
    end
    local out = ffi.new("double[?]", width * count)
    ensure(self.handle, C.mgdt_mesh_interpolate(self.handle, key, width, of_points, count, xyz, out))
    local rows = {}
    for k = 0, count - 1 do
        rows[k + 1] = {}
        for i = 0, width - 1 do rows[k + 1][i + 1] = out[width * k + i] end
    end
    return rows
end
jit.off(Mesh.interpolate)

--- The shapes of all tetrahedra: least_angle and largest_angle in degrees, mean_shape, angles (from 0 to 10 degrees, 10 to
--- 20 and so on) and below (tetrahedra with an angle below 5, 10, 15, 20, 25 and 30 degrees). Since 1.4.
function Mesh:shape_summary()
    local shapes, angles, below = ffi.new("double[3]"), ffi.new("int64_t[18]"), ffi.new("int64_t[6]")
    ensure(self.handle, C.mgdt_mesh_get_shape_summary(self.handle, shapes, angles, below))
    local summary = { least_angle = shapes[0], largest_angle = shapes[1], mean_shape = shapes[2], angles = {}, below = {} }
    for k = 1, 18 do summary.angles[k] = tonumber(angles[k - 1]) end
    for k = 1, 6 do summary.below[k] = tonumber(below[k - 1]) end
    return summary
end
jit.off(Mesh.shape_summary)

function Mesh:__tostring()
    return ("mgdt %s: %d points, %d tetrahedra, %d regions"):format(self.kind, self.point_count,
        self.tetrahedron_count, self.region_count)
end

local mesh = {}

--- A mesh of the library as a table of its arrays. compare(mesh) is a further check of it.
function mesh.take(handle, kind, compare)
    local made = { handle = handle, kind = kind, compare = compare }
    read(made)
    return setmetatable(made, Mesh)
end

local known = { points = true, tetrahedra = true, markers = true, faces = true, face_markers = true, edges = true,
    edge_markers = true, threads = true, memory_limit = true, index_base = true, progress = true }

-- The corners of rows of a width, or of an FFI array int32_t[?][width].
local function corners_of(rows, width, what)
    if type(rows) == "cdata" then
        local element, length = arguments.shape_of(rows)
        if element ~= "int" or not length or length % width ~= 0 then
            bad_argument("%s must be lists of corners, or an FFI array int32_t[?][%d]", what, width)
        end
        local corners, from = ffi.new("int64_t[?]", length), ffi.cast("const int32_t *", rows)
        for k = 0, length - 1 do corners[k] = from[k] end
        return length / width, corners
    end
    if type(rows) ~= "table" then bad_argument("%s is %s; it must be a table", what, type(rows)) end
    local corners = {}
    for k, row in ipairs(rows) do
        if type(row) ~= "table" or #row ~= width then bad_argument("%s[%d] is not %d points", what, k, width) end
        for i = 1, width do corners[width * (k - 1) + i] = row[i] end
    end
    return #rows, list_of(corners, "the corners of " .. what, "int64_t")
end

--- A mesh of tetrahedra, from a table with points (as for insert()) and tetrahedra, four corners each. Optional:
--- markers of tetrahedra, faces {a, b, c} and edges {a, b} that have to stay, face_markers, edge_markers, threads,
--- memory_limit, index_base (0), and progress, a function as for set_progress(). The result is as that of domain_mesh(). Since 1.4.
function mesh.mesh(given)
    if type(given) ~= "table" then bad_argument("a table with points and tetrahedra is needed") end
    for name in pairs(given) do
        if not known[name] then bad_argument("there is no setting %s", tostring(name)) end
    end
    local out = ffi.new("mgdt_mesh *[1]")
    local value = C.mgdt_mesh_create(out)
    if value ~= 0 then raise(value, ffi.string(C.mgdt_status_string(value))) end
    local handle = ffi.gc(out[0], C.mgdt_mesh_destroy)
    of_mesh.set_option(handle, "index_base", whole(given.index_base or 0, "index_base"))
    of_mesh.set_option(handle, "threads", whole(given.threads or 1, "threads"))
    of_mesh.set_option(handle, "memory_limit", whole(given.memory_limit or 0, "memory_limit"))
    local xyz, count = rows_of(given.points, nil, "points", 3, "points")
    ensure(handle, C.mgdt_mesh_set_points(handle, count, xyz))
    local n, corners = corners_of(given.tetrahedra, 4, "tetrahedra")
    ensure(handle, C.mgdt_mesh_set_tetrahedra(handle, n, corners, markers_of(given.markers, n, "markers")))
    n, corners = corners_of(given.faces or {}, 3, "faces")
    ensure(handle, C.mgdt_mesh_set_faces(handle, n, corners, markers_of(given.face_markers, n, "face_markers")))
    n, corners = corners_of(given.edges or {}, 2, "edges")
    ensure(handle, C.mgdt_mesh_set_edges(handle, n, corners, markers_of(given.edge_markers, n, "edge_markers")))
    ensure(handle, of_mesh.watch(handle, given.progress, function(of) return C.mgdt_mesh_build(of) end))
    return mesh.take(handle, "mesh")
end
-- Compiled code does not hold on to an array whose address alone is in use any more.
jit.off(mesh.mesh, true)

return mesh
