-- SPDX-License-Identifier: MIT
--- Meshes of what closed surfaces enclose, for mgdt.lua.

local ffi = require "ffi"
local C = require "mgdt.library"
local constants = require "mgdt.interface"
local arguments = require "mgdt.arguments"

local status, options, arrays = constants.status, constants.domain_option, constants.domain_array
local raise, bad_argument = arguments.raise, arguments.bad_argument
local whole, small, rows_of, shape_of = arguments.whole, arguments.small, arguments.rows_of, arguments.shape_of
local ensure, message_of = arguments.raiser(C.mgdt_domain_get_error)

-- How many elements of an array belong together, where they are more than one.
local widths = { offending_pairs = 4, open_edges = 3, tetrahedra = 4, neighbors = 4, faces = 3, face_tetrahedra = 2,
    segments = 2, steiner_edges = 2, points = 3 }

local kinds = {}
for name, value in pairs(constants.domain_kind) do kinds[value] = name end

local function get(handle, name)
    local key, size, width = arrays[name], ffi.new("int64_t[1]"), widths[name]
    local element = key < arrays.points and "int32_t" or "double"
    ensure(handle, C.mgdt_domain_get_size(handle, key, size))
    local length = tonumber(size[0])
    local array = width and ffi.new(("%s[?][%d]"):format(element, width), length / width)
        or ffi.new(element .. "[?]", length)
    local read = element == "double" and C.mgdt_domain_get_doubles or C.mgdt_domain_get_array_i32
    ensure(handle, read(handle, key, length, ffi.cast(element .. " *", array)))
    return array, length / (width or 1)
end

local function pairs_of(handle)
    local array, count = get(handle, "offending_pairs")
    local found = {}
    for k = 0, count - 1 do
        found[k + 1] = { kinds[array[k][0]], array[k][1], kinds[array[k][2]], array[k][3] }
    end
    return found
end

-- The error of a surface that cannot be meshed has all pairs.
local function ensure_valid(handle, value)
    if value ~= status.invalid_boundary then return ensure(handle, value) end
    local found = pairs_of(handle)
    local good, problem = pcall(ensure, handle, value)
    if not good then problem.pairs = found end
    error(problem, 0)
end

-- Whole numbers of a table, as an array of an element type.
local function list_of(values, what, element)
    local array = ffi.new(element .. "[?]", #values)
    for k, value in ipairs(values) do
        array[k - 1] = (element == "int32_t" and small or whole)(value, ("%s[%d]"):format(what, k))
    end
    return array
end

-- Facets: lists of corners of any lengths, or an FFI array of int32_t with three for each.
local function facets_of(facets, base)
    if type(facets) == "cdata" then
        local element, length = shape_of(facets)
        if element ~= "int" or not length or length % 3 ~= 0 then
            bad_argument("facets must be lists of corners, or an FFI array int32_t[?][3]")
        end
        local corners, from = ffi.new("int64_t[?]", length), ffi.cast("const int32_t *", facets)
        for k = 0, length - 1 do corners[k] = from[k] end
        return length / 3, nil, corners
    end
    if type(facets) ~= "table" then bad_argument("facets is %s; it must be a table", type(facets)) end
    local offsets, corners = ffi.new("int64_t[?]", #facets + 1), {}
    offsets[0] = base
    for k, facet in ipairs(facets) do
        if type(facet) ~= "table" then bad_argument("facets[%d] is no list of corners", k) end
        for i = 1, table.maxn(facet) do
            if facet[i] == nil then bad_argument("facets[%d][%d] is nil", k, i) end
            corners[#corners + 1] = facet[i]
        end
        offsets[k] = base + #corners
    end
    return #facets, offsets, list_of(corners, "the corners of facets", "int64_t")
end

local function markers_of(markers, n, what)
    if markers == nil then return nil end
    if type(markers) ~= "table" or #markers ~= n then
        bad_argument("%s must be a table of %d numbers", what, n)
    end
    return list_of(markers, what, "int32_t")
end

local function place_of(place, what)
    local xyz, count = rows_of({ place }, nil, what, 3, "places")
    if count ~= 1 then bad_argument("%s is not one place", what) end
    return xyz
end

local known = { points = true, facets = true, markers = true, segments = true, segment_markers = true,
    holes = true, regions = true, rounded = true, strict = true, threads = true, memory_limit = true, index_base = true,
    progress = true }

-- A handle with everything that the caller has given.
local function domain_of(given)
    if type(given) ~= "table" then bad_argument("a table with points and facets is needed") end
    for name in pairs(given) do
        if not known[name] then bad_argument("there is no setting %s", tostring(name)) end
    end
    local out = ffi.new("mgdt_domain *[1]")
    local value = C.mgdt_domain_create(out)
    if value ~= 0 then raise(value, ffi.string(C.mgdt_status_string(value))) end
    local handle = ffi.gc(out[0], C.mgdt_domain_destroy)
    local base = whole(given.index_base or 0, "index_base")
    ensure(handle, C.mgdt_domain_set_option(handle, options.index_base, base))
    ensure(handle, C.mgdt_domain_set_option(handle, options.threads, whole(given.threads or 1, "threads")))
    ensure(handle, C.mgdt_domain_set_option(handle, options.memory_limit,
        whole(given.memory_limit or 0, "memory_limit")))
    ensure(handle, C.mgdt_domain_set_option(handle, options.round_points, given.rounded and 1 or 0))
    ensure(handle, C.mgdt_domain_set_option(handle, options.strict, given.strict and 1 or 0))

    local xyz, count = rows_of(given.points, nil, "points", 3, "points")
    ensure(handle, C.mgdt_domain_set_points(handle, count, xyz))
    local n, offsets, corners = facets_of(given.facets or {}, base)
    ensure(handle, C.mgdt_domain_set_facets(handle, n, offsets, corners, markers_of(given.markers, n, "markers")))
    local segments, ends = given.segments or {}, {}
    for k, segment in ipairs(segments) do
        if type(segment) ~= "table" or #segment ~= 2 then bad_argument("segments[%d] is not two points", k) end
        ends[2 * k - 1], ends[2 * k] = segment[1], segment[2]
    end
    ensure(handle, C.mgdt_domain_set_segments(handle, #segments, list_of(ends, "the ends of segments", "int64_t"),
        markers_of(given.segment_markers, #segments, "segment_markers")))
    for k, hole in ipairs(given.holes or {}) do
        ensure(handle, C.mgdt_domain_add_hole(handle, place_of(hole, ("holes[%d]"):format(k))))
    end
    for k, region in ipairs(given.regions or {}) do
        if type(region) ~= "table" then bad_argument("regions[%d] is no table {place, marker}", k) end
        ensure(handle, C.mgdt_domain_add_region(handle, place_of(region[1], ("regions[%d]"):format(k)),
            small(region[2], ("the marker of regions[%d]"):format(k))))
    end
    return handle
end
-- Compiled code does not hold on to an array whose address alone is in use any more.
jit.off(domain_of, true)

local function build(handle, progress)
    if progress == nil then return ensure_valid(handle, C.mgdt_domain_build(handle)) end
    if type(progress) ~= "function" then bad_argument("the progress function is no function") end
    local failed, problem = false, nil
    local callback = ffi.cast("mgdt_progress_fn", function(fraction)
        -- Nothing may be thrown through the library.
        local good, stop = pcall(progress, fraction)
        if not good then failed, problem = true, stop end
        return (not good or stop) and 1 or 0
    end)
    C.mgdt_domain_set_progress(handle, callback, nil)
    local value = C.mgdt_domain_build(handle)
    C.mgdt_domain_set_progress(handle, nil, nil)
    callback:free()
    if failed then error(problem, 0) end
    ensure_valid(handle, value)
end
jit.off(build, true)

local Mesh = {}
Mesh.__index = Mesh

--- Proves the mesh against the facets and segments, exactly. True, or nil and what is wrong.
function Mesh:check()
    local value = C.mgdt_domain_check(self.handle)
    if value == status.check_failed then return nil, message_of(self.handle, value) end
    ensure(self.handle, value)
    return true
end

function Mesh:__tostring()
    return ("mgdt domain mesh: %d points, %d tetrahedra, %d regions"):format(self.point_count,
        self.tetrahedron_count, self.region_count)
end

local domain = {}

--- The mesh of a domain, from a table with points (as for insert()) and facets, lists of corners.
--- Optional: markers of facets, segments {a, b}, segment_markers, holes {x, y, z}, regions
--- {{x, y, z}, marker}, rounded, strict (nothing may be left out), threads, memory_limit, index_base (0), and progress, a function as for
--- set_progress().
---
--- The result has the arrays points, tetrahedra, neighbors, faces, face_tetrahedra, segments,
--- steiner_edges and open_edges, with [k][0] and so on, and regions, region_markers, face_facets, face_markers,
--- segment_sources, segment_markers and steiner_parameters; mgdt/mgdt_domain.h says what they are.
--- point_count, tetrahedron_count, region_count, face_count, segment_count and steiner_count say how
--- many there are, and is_rounded whether points are rounded. check() proves the mesh.
---
--- If facets, segments or points cross or touch where they must not, the error is named
--- "invalid_boundary" and has `pairs`, as offending_pairs() gives them. If the facets enclose nothing, it
--- is "open_boundary". Since 1.3.
function domain.domain_mesh(given)
    local handle = domain_of(given)
    build(handle, given.progress)
    local mesh = { handle = handle }
    for name in pairs(arrays) do
        if name ~= "offending_pairs" then
            local count
            mesh[name], count = get(handle, name)
            if name == "points" then mesh.point_count = count end
            if name == "tetrahedra" then mesh.tetrahedron_count = count end
            if name == "region_markers" then mesh.region_count = count end
            if name == "faces" then mesh.face_count = count end
            if name == "segments" then mesh.segment_count = count end
            if name == "steiner_edges" then mesh.steiner_count = count end
        end
    end
    local rounded = ffi.new("int64_t[1]")
    ensure(handle, C.mgdt_domain_get_stat(handle, constants.domain_number.is_rounded, rounded))
    mesh.is_rounded = rounded[0] == 1
    return setmetatable(mesh, Mesh)
end

--- All pairs of facets, segments and points that do not meet in common corners and edges, exactly:
--- {"facet", 3, "facet", 8}, for example. What is bad by itself is paired with itself. Takes what
--- domain_mesh() takes. Since 1.3.
function domain.offending_pairs(given)
    local handle = domain_of(given)
    local value = C.mgdt_domain_validate(handle)
    if value ~= status.invalid_boundary then ensure(handle, value) end
    return pairs_of(handle)
end

return domain
