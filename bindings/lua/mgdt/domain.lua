-- SPDX-License-Identifier: MIT
--- Meshes of what closed surfaces enclose, for mgdt.lua.

local ffi = require "ffi"
local C = require "mgdt.library"
local constants = require "mgdt.interface"
local arguments = require "mgdt.arguments"
local keyed = require "mgdt.keyed"
local meshes = require "mgdt.mesh"

local status = constants.status
local raise, bad_argument = arguments.raise, arguments.bad_argument
local whole, small, rows_of, shape_of = arguments.whole, arguments.small, arguments.rows_of, arguments.shape_of
local list_of, markers_of = arguments.list_of, arguments.markers_of
local of_domain = keyed.of "domain"
local ensure = of_domain.ensure

local kinds = {}
for name, value in pairs(constants.domain_kind) do kinds[value] = name end

local function pairs_of(handle)
    local array, count = of_domain.get(handle, "offending_pairs")
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

-- Places as rows, one after another.
local function places_of(places, what)
    if #places == 0 then return nil, 0 end
    local xyz, count = rows_of(places, nil, what, 3, "places")
    return xyz, count
end

local known = { points = true, facets = true, markers = true, segments = true, segment_markers = true,
    holes = true, regions = true, rounded = true, strict = true, keep_boundary = true,
    clean = true, weld = true, flatness = true, threads = true, memory_limit = true, index_base = true,
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
    of_domain.set_option(handle, "index_base", base)
    of_domain.set_option(handle, "threads", whole(given.threads or 1, "threads"))
    of_domain.set_option(handle, "memory_limit", whole(given.memory_limit or 0, "memory_limit"))
    of_domain.set_option(handle, "round_points", given.rounded and 1 or 0)
    of_domain.set_option(handle, "strict", given.strict and 1 or 0)
    of_domain.set_option(handle, "keep_boundary", given.keep_boundary and 1 or 0)

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
    local holes, n_holes = places_of(given.holes or {}, "holes")
    ensure(handle, C.mgdt_domain_set_holes(handle, n_holes, holes))
    local places, of_regions = {}, {}
    for k, region in ipairs(given.regions or {}) do
        if type(region) ~= "table" then bad_argument("regions[%d] is no table {place, marker}", k) end
        places[k], of_regions[k] = region[1], region[2]
        small(region[2], ("the marker of regions[%d]"):format(k))
    end
    local regions, n_regions = places_of(places, "regions")
    ensure(handle, C.mgdt_domain_set_regions(handle, n_regions, regions,
        list_of(of_regions, "the markers of regions", "int32_t")))
    return handle
end
-- Compiled code does not hold on to an array whose address alone is in use any more.
jit.off(domain_of, true)

-- Cleans a domain. Returns the status.
local function clean(handle, given)
    for _, name in ipairs { "weld", "flatness" } do
        local value = given[name] or 0
        if type(value) ~= "number" then bad_argument("%s is %s; it must be a number", name, type(value)) end
        of_domain.set_double_option(handle, name, value)
    end
    return of_domain.watch(handle, given.progress, function(of) return C.mgdt_domain_clean(of) end)
end

-- A domain that is cleaned if that is asked for.
local function ready_domain_of(given)
    local handle = domain_of(given)
    if given.clean or (given.weld or 0) ~= 0 or (given.flatness or 0) ~= 0 then
        ensure(handle, clean(handle, given))
    end
    return handle
end

-- A mesh of the library, which frees itself.
local function build(handle, progress)
    local out = ffi.new("mgdt_mesh *[1]")
    local value = of_domain.watch(handle, progress, function(of) return C.mgdt_domain_build(of, out) end)
    ensure_valid(handle, value)
    return ffi.gc(out[0], C.mgdt_mesh_destroy)
end
jit.off(build, true)

-- Proves the mesh, and, until it is improved, compares it with the facets and segments.
local function check(mesh)
    local value = C.mgdt_domain_check(mesh.domain, mesh.handle)
    if value == status.check_failed then return nil, of_domain.message_of(mesh.domain, value) end
    ensure(mesh.domain, value)
    return true
end

local domain = {}

--- The mesh of a domain, from a table with points (as for insert()) and facets, lists of corners.
--- Optional: markers of facets, segments {a, b}, segment_markers, holes {x, y, z}, regions
--- {{x, y, z}, marker}, rounded, strict (nothing may be left out), keep_boundary (Steiner points are inside only),
--- clean, weld and flatness (see clean_surface()), threads, memory_limit, index_base (0), and progress, a
--- function as for set_progress().
---
--- The result has the arrays points, tetrahedra, neighbors, faces, face_tetrahedra, edges, steiner_edges,
--- open_edges and covered_facets, with [k][0] and so on, and point_origins, tetrahedron_regions, region_markers, face_facets,
--- face_markers, edge_segments, edge_markers and steiner_parameters; mgdt/mgdt_mesh.h says what they are.
--- point_count, tetrahedron_count, region_count, face_count, edge_count and steiner_count say how many
--- there are, and is_rounded whether points are rounded. check() proves the mesh, and improve() makes its tetrahedra
--- better, as that of mesh() does.
---
--- If facets, segments or points cross or touch where they must not, the error is named
--- "invalid_boundary" and has `pairs`, as offending_pairs() gives them. If the facets enclose nothing, it
--- is "open_boundary". Since 1.3.
function domain.domain_mesh(given)
    local handle = ready_domain_of(given)
    local mesh = meshes.take(build(handle, given.progress), "domain mesh", check)
    mesh.domain = handle
    mesh.open_edges = of_domain.get(handle, "open_edges")
    mesh.covered_facets = of_domain.get(handle, "covered_facets")
    return mesh
end

--- All pairs of facets, segments and points that do not meet in common corners and edges, exactly:
--- {"facet", 3, "facet", 8}, for example. What is bad by itself is paired with itself. Takes what
--- domain_mesh() takes. Since 1.3.
function domain.offending_pairs(given)
    local handle = ready_domain_of(given)
    local value = C.mgdt_domain_validate(handle)
    if value ~= status.invalid_boundary then ensure(handle, value) end
    return pairs_of(handle)
end

--- Facets and segments of which is mended what needs no new points: repeated corners, collapsed and equal
--- facets, points in edges and in facets, and edges in facets. Takes what domain_mesh() takes. weld is the
--- distance within which places are one, and flatness that within which facets of one marker are in one
--- plane, as shares of the diagonal of the points' box; both are 0 by default. mgdt/mgdt_domain.h says more.
---
--- The result has points, with [k][0] and so on, and facets, lists of corners; markers and origins, of each
--- facet its marker and the facet that it is a part of; segments, segment_markers and segment_origins; and
--- covered, rows of a facet that was left out and the one that stays in its place. facet_count, segment_count
--- and covered_count say how many there are, and moved_points, repeated_corners, collapsed_facets,
--- points_in_edges, points_in_facets, edges_in_facets and exchanged_edges what was done. Since 1.4.
function domain.clean_surface(given)
    local handle = domain_of(given)
    ensure(handle, clean(handle, given))
    local result, count = {}, nil
    result.points, result.point_count = of_domain.get(handle, "points")
    local base = given.index_base or 0
    local offsets, corners = of_domain.get(handle, "facet_offsets"), of_domain.get(handle, "facet_corners")
    result.markers, count = of_domain.get(handle, "facet_markers")
    result.facets, result.facet_count = {}, count
    for f = 1, count do
        local facet = {}
        for k = offsets[f - 1], offsets[f] - 1 do facet[#facet + 1] = corners[k - base] end
        result.facets[f] = facet
    end
    result.origins = of_domain.get(handle, "facet_origins")
    result.segments, result.segment_count = of_domain.get(handle, "segments")
    result.segment_markers = of_domain.get(handle, "segment_markers")
    result.segment_origins = of_domain.get(handle, "segment_origins")
    result.covered, result.covered_count = of_domain.get(handle, "covered_facets")
    for _, name in ipairs { "moved_points", "repeated_corners", "collapsed_facets", "points_in_edges",
        "points_in_facets", "edges_in_facets", "exchanged_edges" } do
        result[name] = of_domain.statistic(handle, name)
    end
    return result
end

return domain
