-- SPDX-License-Identifier: MIT
-- The LuaJIT binding against what the C interface wrote (reference.c), and against geometry.
--
--   luajit lua_test.lua REFERENCE_FOLDER
local ffi = require "ffi"
local mgdt = require "mgdt"
local folder = assert(arg[1], "usage: luajit lua_test.lua REFERENCE_FOLDER")

local passed, failed = 0, 0
local function test(name, body)
    local good, problem = xpcall(body, function(e)
        return type(e) == "string" and debug.traceback(e, 2) or tostring(e)
    end)
    if good then passed = passed + 1 else failed = failed + 1 end
    print((good and "passed: " or "failed: ") .. name .. (good and "" or "\n" .. problem))
end

local function equal(got, expected, what)
    if got ~= expected then
        error(("%s is %s; expected %s"):format(what or "value", tostring(got), tostring(expected)), 2)
    end
end

-- The error that a call raises; it must be one of mgdt's with that name, and say each of the words.
local function refused(name, words, call, ...)
    local good, problem = pcall(call, ...)
    if good then error("no error was raised", 2) end
    if type(problem) ~= "table" then error("not an error of mgdt: " .. tostring(problem), 2) end
    equal(problem.name, name, "the error's name")
    equal(problem.status, mgdt.status[name], "the error's status")
    for _, word in ipairs(words) do
        if not tostring(problem):find(word, 1, true) then
            error(("'%s' does not say '%s'"):format(tostring(problem), word), 2)
        end
    end
end

local function read(name, element)
    local file = assert(io.open(folder .. "/" .. name, "rb"))
    local bytes = file:read("*a")
    file:close()
    local array = ffi.new(element .. "[?]", #bytes / 8)
    ffi.copy(array, bytes, #bytes)
    return array, #bytes / 8
end

local function same(array, expected, count, what)
    local kind = tostring(ffi.typeof(array))
    local element = kind:match("double") or kind:match("int64_t") or "int32_t"
    local flat = ffi.cast(element .. " *", array)
    for k = 0, count - 1 do
        if tonumber(flat[k]) ~= tonumber(expected[k]) then
            error(("%s differs at element %d: %s, expected %s"):format(what, k,
                tostring(flat[k]), tostring(expected[k])), 2)
        end
    end
end

local points, coordinates = read("points", "double")
local n = coordinates / 3

local function six_volumes(p, v)
    local function d(i, axis) return p[3 * v[i] + axis] - p[3 * v[0] + axis] end
    return d(1, 0) * (d(2, 1) * d(3, 2) - d(2, 2) * d(3, 1))
        - d(1, 1) * (d(2, 0) * d(3, 2) - d(2, 2) * d(3, 0))
        + d(1, 2) * (d(2, 0) * d(3, 1) - d(2, 1) * d(3, 0))
end

local function cube_corners()
    local corners = {}
    for k = 0, 7 do table.insert(corners, { k % 2, math.floor(k / 2) % 2, math.floor(k / 4) }) end
    return corners
end

test("a cube: tetrahedra of positive volume that fill it", function()
    local corners = cube_corners()
    local flat = ffi.new("double[8][3]", corners)
    local t = mgdt.new()
    t:insert(corners)
    local v, count = t:tetrahedra()
    assert(count == 5 or count == 6, "5 or 6 tetrahedra, not " .. count)
    local total = 0
    for k = 0, count - 1 do
        local volume = six_volumes(ffi.cast("double *", flat), v[k])
        assert(volume > 0, "a volume is not positive")
        total = total + volume
    end
    equal(total, 6, "six times the volume")
    equal(t:hull_facet_count(), 12, "triangles on the hull")
    equal(t:dimension(), 3, "dimension")
    equal(t:check(), true, "check")
    assert(tostring(t):find("8 points", 1, true))
end)

test("random points: every export as the C interface writes it", function()
    local t = mgdt.new { canonical = true }
    t:insert(points)
    local exports = { tetrahedra = 4, neighbors = 4, hull_facets = 3, edges = 2, point_map = 1 }
    for name, width in pairs(exports) do
        local expected, length = read(name, "int64_t")
        local array, count = t[name](t)
        equal(count * width, length, "length of " .. name)
        same(array, expected, length, name)
        local given = ffi.new("int64_t[?]", length)
        equal(t[name](t, given), given, "the array given")
        same(given, expected, length, name .. " into an int64_t array")
        same(t[name](t, ffi.new("int32_t[?]", length)), expected, length, name .. " into int32_t")
        if length > width then
            refused("buffer_too_small", { tostring(length), "needed" }, t[name], t,
                ffi.new("int32_t[?]", length - 1))
        end
    end
    local offsets, list, length = t:vertex_tetrahedra()
    same(offsets, read("offsets", "int64_t"), n + 1, "offsets")
    same(list, read("list", "int64_t"), length, "list")
    equal(length, 4 * t:tetrahedron_count(), "length of list")
    offsets, list, length = t:vertex_neighbors()
    same(offsets, read("neighbor_offsets", "int64_t"), n + 1, "offsets of neighbours")
    same(list, read("neighbor_list", "int64_t"), length, "neighbours")
    equal(length, 2 * t:edge_count(), "length of the neighbours' list")
    for _, name in ipairs { "gabriel_edges", "spanning_tree" } do
        local pairs_of_points, number = t[name](t)
        local reference, size = read(name, "int64_t")
        equal(2 * number, size, "length of " .. name)
        same(ffi.cast("int32_t *", pairs_of_points), reference, size, name)
    end
    local centers, squares, count = t:circumcenters()
    same(centers, read("centers", "double"), 3 * count, "circumcentres")
    same(squares, read("squares", "double"), count, "squares of the radii")
    local facet_alphas, facet_count = t:alphas(2)
    same(facet_alphas, read("facet_alphas", "double"), facet_count, "alphas of facets")
    local edge_alphas, edge_count = t:alphas(1)
    same(edge_alphas, read("edge_alphas", "double"), edge_count, "alphas of edges")
    local surface, facets = t:alpha_surface(0.01)
    local expected, size = read("alpha_surface", "int64_t")
    equal(3 * facets, size, "facets of the surface")
    same(ffi.cast("int32_t *", surface), expected, size, "surface")
    equal(t:solid_alpha(), read("solid_alpha", "double")[0], "alpha of one solid")
    local box = { { 1, 0, 0, 2 }, { -1, 0, 0, 1 }, { 0, 1, 0, 2 }, { 0, -1, 0, 1 }, { 0, 0, 1, 2 }, { 0, 0, -1, 1 } }
    local volumes, cells = t:cell_measures("volume", box)
    same(volumes, read("volumes", "double"), cells, "volumes")
    same(t:cell_measures("centroid", box), read("centroids", "double"), 3 * cells, "centroids")
    same(t:cell_measures("faces"), read("faces", "double"), cells, "faces")
    local ratios, number_of_tetrahedra = t:tetrahedron_measures("radius_ratio")
    same(ratios, read("radius_ratios", "double"), number_of_tetrahedra, "radius ratios")
    same(t:tetrahedron_measures("largest_dihedral_angle"), read("largest_angles", "double"), number_of_tetrahedra, "angles")
    refused("invalid_argument", { "the measure is faces; it must be one of", "least_dihedral_angle" }, t.tetrahedron_measures, t,
        "faces")
    for prefix, planes in pairs { cut = box, whole = {} } do
        local v = t:voronoi(planes)
        for name in pairs(require("mgdt.interface").voronoi_array) do
            local is_integer = tostring(ffi.typeof(v[name])):match("int") ~= nil
            local reference, length = read(prefix .. "_" .. name, is_integer and "int64_t" or "double")
            equal(ffi.sizeof(v[name]) / (is_integer and 4 or 8), length, "length of " .. name)
            same(v[name], reference, length, name)
        end
        equal(v.cell_count, n, "cells")
        equal(ffi.sizeof(v.vertices), 24 * v.vertex_count, "vertices")
        equal(v.face_offsets[v.face_count] > 3 * v.face_count, true, "corners of faces")
        equal(v.ray_count > 0, prefix == "whole", "rays")
    end
    equal(t:voronoi(box, nil, 0.01).face_count < t:voronoi(box).face_count, true, "small faces")
    equal(t:voronoi(box, nil, 0, 0.05).face_count < t:voronoi(box).face_count, true, "small shares")
    refused("invalid_argument", { "-1" }, t.voronoi, t, box, nil, -1)
    refused("invalid_argument", { "least_area is x" }, t.voronoi, t, box, nil, "x")
    refused("invalid_argument", { "planes[1] is not four numbers" }, t.voronoi, t, { { 1, 2, 3 } })
    refused("invalid_argument", { "no end" }, t.voronoi, t, { { 1, 0, 0, 9 } })
    local places, values = read("queries", "double"), read("values", "double")
    local expected_values, value_count = read("interpolated", "double")
    local interpolated, place_count = t:interpolate("sibson_c1", values, places, "linear", 2, value_count / 2)
    same(interpolated, expected_values, 2 * place_count, "values between points")
    local gradients, with_gradient = t:gradients(values, 2)
    same(gradients, read("gradients", "double"), 6 * with_gradient, "gradients")
    refused("invalid_argument", { "the method is sibsom; it must be one of linear, nearest, sibson" }, t.interpolate,
            t, "sibsom", values, places, "none", 2, value_count / 2)
    refused("invalid_argument", { "what is outside is far; it must be one of none, nearest, boundary" }, t.interpolate,
            t, "linear", values, places, "far", 2, value_count / 2)
    refused("invalid_argument", { "the measure is size; it must be one of volume" }, t.cell_measures, t, "size")
    refused("invalid_argument", { "the level is deep; it must be one of" }, t.check, t, "deep")
    local row_offsets, row_points, row_weights = t:interpolation_weights("sibson", places, nil, place_count)
    same(row_offsets, read("row_offsets", "int64_t"), place_count + 1, "offsets of rows")
    same(row_points, read("row_points", "int64_t"), row_offsets[place_count], "points of rows")
    same(row_weights, read("row_weights", "double"), row_offsets[place_count], "weights of rows")
    -- Euler's formula for a ball.
    equal(t:vertex_count() - t:edge_count() + (4 * t:tetrahedron_count() + t:hull_facet_count()) / 2
        - t:tetrahedron_count(), 1, "V - E + F - T")
    equal(t:point_count(), 1010, "points")
    equal(t:vertex_count(), 1000, "vertices")
    equal(t:statistic("duplicates"), 10, "duplicates")
    equal(t:check("canonical"), true)
    equal(t:check("combinatorial"), true)
end)

test("the same tetrahedra from tables, pointers, separate arrays and batches", function()
    local expected, length = read("tetrahedra", "int64_t")
    local rows, flat = {}, {}
    local axes = { ffi.new("double[?]", n), ffi.new("double[?]", n), ffi.new("double[?]", n) }
    for k = 0, n - 1 do
        rows[k + 1] = { points[3 * k], points[3 * k + 1], points[3 * k + 2] }
        for axis = 0, 2 do
            flat[#flat + 1] = points[3 * k + axis]
            axes[axis + 1][k] = points[3 * k + axis]
        end
    end
    local half = 3 * 500
    local ways = {
        table_of_rows = function(t) t:insert(rows) end,
        flat_table = function(t) t:insert(flat) end,
        pointer = function(t) t:insert(ffi.cast("double *", points), n) end,
        constant_pointer = function(t) t:insert(ffi.cast("const double *", points), n) end,
        rows = function(t) t:insert(ffi.new("double[1010][3]", rows)) end,
        separate = function(t) t:insert_strided(n, axes[1], axes[2], axes[3]) end,
        records = function(t) t:insert_strided(n, points, points + 1, points + 2, 3) end,
        batches = function(t)
            t:insert(points, 500)
            t:insert(points + half, n - 500)
        end,
    }
    for name, way in pairs(ways) do
        for _, scheme in ipairs { "auto", "input", "multi-grid" } do
            local t = mgdt.new { canonical = true, order = scheme, seed = 5 }
            t:reserve(n)
            way(t)
            equal(4 * t:tetrahedron_count(), length, "length, " .. name)
            same(t:tetrahedra(), expected, length, name)
        end
    end
    equal(#mgdt.order_schemes >= 10, true, "order schemes")
    for _, scheme in ipairs(mgdt.order_schemes) do mgdt.new { order = scheme } end
end)

test("location and nearest vertices", function()
    local t = mgdt.new { canonical = true }
    t:insert(points)
    local queries, length = read("queries", "double")
    local located, nearest = read("located", "int64_t"), read("nearest", "int64_t")
    local expected = read("weights", "double")
    local found, weights, count = t:locate_points(queries)
    equal(count, length / 3, "queries")
    local outside = 0
    for k = 0, count - 1 do
        local x, y, z = queries[3 * k], queries[3 * k + 1], queries[3 * k + 2]
        equal(found[k], tonumber(located[k]), "a tetrahedron")
        for i = 0, 3 do equal(weights[k][i], expected[4 * k + i], "a weight") end
        if found[k] == -1 then outside = outside + 1 end
        local alone = t:locate(x, y, z)
        equal(alone or -1, found[k], "a tetrahedron located alone")
        -- Brute force is the truth.
        local best, least
        for p = 0, 999 do
            local dx, dy, dz = points[3 * p] - x, points[3 * p + 1] - y, points[3 * p + 2] - z
            local d = dx * dx + dy * dy + dz * dz
            if not least or d < least then best, least = p, d end
        end
        equal(t:nearest(x, y, z), best, "the nearest vertex")
        equal(tonumber(nearest[k]), best, "the reference's nearest vertex")
    end
    assert(outside > 10 and outside < count - 10, "queries on both sides of the hull")
    local segment, way = read("segment", "double"), read("way", "int64_t")
    local a, b = { segment[0], segment[1], segment[2] }, { segment[3], segment[4], segment[5] }
    local passed, parameters, passages = t:traverse_segment(a, b)
    for k = 0, passages - 1 do equal(passed[k], tonumber(way[k]), "a tetrahedron on the way") end
    same(parameters, read("way_parameters", "double"), passages + 1, "the parameters")
    equal(select(3, t:traverse_segment({ 5, 5, 5 }, { 6, 6, 6 })), 0, "a segment outside")
    refused("not_finite", { "x of a" }, t.traverse_segment, t, { 0 / 0, 0, 0 }, b)
    refused("invalid_argument", { "z of a is nil" }, t.traverse_segment, t, { 0, 0 }, b)
    refused("invalid_argument", { "b is nil" }, t.traverse_segment, t, a)
    refused("invalid_argument", { "a is", "table" }, t.traverse_segment, t, segment, b)
    local all, number = t:nearest_points(queries)
    equal(number, count, "places")
    for k = 0, count - 1 do equal(all[k], tonumber(nearest[k]), "one of many nearest vertices") end
    equal(mgdt.new():nearest_points({ { 0, 0, 0 } })[0], -1, "many in an empty triangulation")
    equal(mgdt.new():nearest(0, 0, 0), nil, "nearest in an empty triangulation")
    equal(mgdt.new():locate(0, 0, 0), nil, "location in an empty triangulation")
end)

test("points leave, move and get other numbers", function()
    local t = mgdt.new { canonical = true }
    local _, length = read("points", "double")
    local n = length / 3
    t:insert(points)
    local out, some, places, rest = {}, {}, {}, {}
    for k = 0, n - 1 do
        local place = { points[3 * k], points[3 * k + 1], points[3 * k + 2] }
        if k % 3 == 0 then
            out[#out + 1] = k
        else
            if k % 3 == 1 then
                place[3] = place[3] + 1
                some[#some + 1] = k
                places[#places + 1] = place
            end
            rest[#rest + 1] = place
        end
    end
    t:move(some, places)
    t:remove(ffi.new("int64_t[?]", #out, out))
    local all = ffi.new("double[?]", length, 0 / 0)
    for k, i in ipairs(some) do
        for axis = 0, 2 do all[3 * i + axis] = places[k][axis + 1] end
    end
    for k = 2, n - 1, 3 do
        for axis = 0, 2 do all[3 * k + axis] = points[3 * k + axis] end
    end
    t:move(nil, all)
    equal(t:point_count(), n, "points")
    local index, number = t:renumber()
    equal(number, n, "new numbers")
    equal(tonumber(index[0]), -1, "a point that is out")
    equal(tonumber(index[5]), 3, "a point that is in")
    equal(t:point_count(), #rest, "points that are in")
    local fresh = mgdt.new { canonical = true }
    fresh:insert(rest)
    local expected, rows = fresh:tetrahedra()
    equal(t:tetrahedron_count(), rows, "tetrahedra")
    local found = t:tetrahedra()
    for k = 0, rows - 1 do
        for i = 0, 3 do equal(found[k][i], expected[k][i], "a vertex") end
    end
    equal(t:check(), true)
    t:set_progress(function() return true end)
    refused("cancelled", { "after 0 of 1" }, t.remove, t, { 1 })
    refused("cancelled", { "after 0 of 1" }, t.move, t, { 1 }, { { 5, 5, 5 } })
    t:set_progress(nil)
    refused("invalid_argument", { "point 3" }, t.remove, t, { 3, 3 })
    refused("invalid_argument", { "an index" }, t.remove, t, { 0.5 })
    refused("invalid_argument", { "table of indices" }, t.remove, t, "3")
    refused("invalid_argument", { "1 points and 2 places" }, t.move, t, { 3 }, { { 0, 0, 0 }, { 1, 1, 1 } })
    refused("not_finite", { "point 3" }, t.move, t, { 3 }, { { 0, 0 / 0, 0 } })
    t:remove {}
    t:move({}, {})
    equal(t:point_count(), #rest, "points")
end)

test("settings are read as they are set", function()
    local t = mgdt.new()
    equal(t:get_order(), "auto", "order")
    equal(t:get_threads(), 1, "threads")
    equal(t:get_parameter("separation"), 2, "separation")
    t = mgdt.new {
        order = "kd-tree", seed = 7, threads = 3, index_base = 1, memory_limit = 2 ^ 40,
        compact = true, canonical = true, separation = "passes", threshold = 50,
    }
    equal(t:get_order(), "kd-tree", "order")
    equal(tonumber(t:get_seed()), 7, "seed")
    equal(t:get_threads(), 3, "threads")
    equal(t:get_index_base(), 1, "index base")
    equal(t:get_memory_limit(), 2 ^ 40, "memory limit")
    equal(t:get_compact(), true, "compact")
    equal(t:get_canonical(), true, "canonical")
    equal(t:get_parameter("separation"), 1, "separation")
    equal(t:get_parameter("threshold"), 50, "threshold")
    refused("unknown_key", {}, t.get_parameter, t, "depth")
    refused("invalid_argument", {}, t.set_parameter, t, "separation", "apart")
    t:insert(points)
    local before = t:statistic("memory_bytes")
    t:shrink()
    assert(t:statistic("memory_bytes") < before, "shrink gives memory back")
    equal(t:check(), true, "check")
end)

test("index base 1", function()
    local t = mgdt.new { index_base = 1, canonical = true }
    t:insert(points)
    local v = t:tetrahedra()
    local expected = read("tetrahedra", "int64_t")
    for k = 0, t:tetrahedron_count() - 1 do
        for i = 0, 3 do equal(v[k][i], tonumber(expected[4 * k + i]) + 1, "a vertex") end
    end
    equal(t:locate(5, 5, 5), nil, "outside")
    equal(mgdt.new { index_base = 1 }:nearest(0, 0, 0), nil, "nearest in an empty one")
    equal(t:nearest(points[0], points[1], points[2]), 1, "the first point")
    refused("not_finite", { "point 1012" }, t.insert, t, { { 0, 0, 0 }, { 0 / 0, 0, 0 } })
end)

test("flat and small sets are valid, and wait", function()
    local t = mgdt.new()
    equal(t:dimension(), -1, "dimension")
    equal(select(2, t:tetrahedra()), 0, "tetrahedra of none")
    t:insert {}
    for x = 0, 9 do
        for y = 0, 9 do t:insert { { x, y, 0 } } end
    end
    equal(t:dimension(), 2, "dimension")
    equal(t:tetrahedron_count(), 0, "tetrahedra")
    equal(t:vertex_count(), 100, "vertices")
    equal(t:nearest(3.2, 4.1, 7), 34, "nearest vertex of a flat set")
    equal(t:check(), true)
    t:insert { { 0, 0, 1 } }
    equal(t:dimension(), 3, "dimension")
    assert(t:tetrahedron_count() >= 2 * 81)
    equal(t:check(), true)
    t:clear()
    equal(t:point_count(), 0, "points after clear")
    t:insert { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 }
    equal(t:tetrahedron_count(), 1, "tetrahedra after clear")
end)

test("bad values are refused, with what and where, and change nothing", function()
    local t = mgdt.new { canonical = true }
    t:insert(points)
    local nan = 0 / 0
    refused("not_finite", { "point 1012", "y" }, t.insert, t, { { 0, 0, 0 }, { 1, 1, 1 }, { 0, nan, 0 } })
    refused("not_finite", { "point 1010", "x" }, t.insert, t, ffi.new("double[3]", 1 / 0, 0, 0))
    refused("invalid_argument", { "points[2]" }, t.insert, t, { { 0, 0, 0 }, { 1, 2 } })
    refused("invalid_argument", { "points[2][3]", "no number" }, t.insert, t,
        { { 0, 0, 0 }, { 1, 2, "no number" } })
    refused("invalid_argument", { "points[4]" }, t.insert, t, { 0, 0, 0, false, 0, 0 })
    refused("invalid_argument", { "multiple of 3" }, t.insert, t, { 0, 0, 0, 1 })
    refused("invalid_argument", { "multiple of 3" }, t.insert, t, ffi.new("double[4]"))
    refused("invalid_argument", { "4 numbers" }, t.insert, t, ffi.new("double[4]"), 2)
    refused("invalid_argument", { "number of points" }, t.insert, t, ffi.cast("double *", points))
    refused("invalid_argument", { "float" }, t.insert, t, ffi.new("float[3]"))
    refused("invalid_argument", { "string" }, t.insert, t, "0 0 0")
    refused("invalid_argument", { "nil" }, t.insert, t)
    refused("invalid_argument", { "negative", "-1" }, t.insert, t, points, -1)
    refused("invalid_argument", { "1.5" }, t.insert, t, points, 1.5)
    refused("invalid_argument", { "y holds 2 numbers" }, t.insert_strided, t, 3, points,
        ffi.new("double[2]"), points)
    refused("null_pointer", { "xyz" }, t.insert, t, ffi.cast("double *", nil), 1)
    refused("unknown_scheme", { "spiral" }, t.set_order, t, "spiral")
    refused("unknown_key", { "cells" }, t.set_parameter, t, "cells", 3)
    refused("invalid_argument", { "threshold", "-1" }, t.set_parameter, t, "threshold", -1)
    refused("unknown_key", { "speed" }, t.statistic, t, "speed")
    refused("invalid_argument", { "2" }, t.set_index_base, t, 2)
    refused("invalid_argument", { "negative" }, t.set_memory_limit, t, -1)
    refused("invalid_argument", { "negative" }, t.set_threads, t, -1)
    refused("invalid_argument", { "negative" }, t.set_seed, t, -1)
    refused("invalid_argument", { "level" }, t.check, t, 9)
    refused("invalid_argument", { "mmx" }, t.set_isa, t, "mmx")
    refused("invalid_argument", { "colour" }, mgdt.new, { colour = "red" })
    refused("not_finite", {}, t.locate, t, nan, 0, 0)
    refused("not_finite", {}, t.nearest, t, nan, 0, 0)
    refused("not_finite", { "1" }, t.locate_points, t, { { 0, 0, 0 }, { 0, nan, 0 } })
    refused("invalid_argument", { "x is nil" }, t.locate, t)
    refused("invalid_argument", { "int32_t" }, t.tetrahedra, t, ffi.new("double[8]"))
    refused("invalid_argument", { "capacity" }, t.tetrahedra, t, ffi.new("int32_t[8]"), 1e6)
    equal(t:point_count(), 1010, "points")
    local expected, length = read("tetrahedra", "int64_t")
    same(t:tetrahedra(), expected, length, "tetrahedra")
    equal(t:check(), true)
    t:set_isa("baseline")
    equal(t:isa(), "baseline", "instruction set")
end)

test("the memory limit", function()
    local t = mgdt.new { memory_limit = 100000 }
    refused("out_of_memory", { "memory" }, t.insert, t, points)
    equal(t:check(), true)
    assert(t:statistics().peak_memory_bytes <= 100000)
    t:set_memory_limit(0)
    t:insert(points)
    equal(t:vertex_count(), 1000, "vertices")
    equal(t:check(), true)
end)

test("compact storage", function()
    local t = mgdt.new { canonical = true }
    t:insert(points)
    local before = t:statistic("memory_bytes")
    t:set_compact(true)
    local after = t:statistic("memory_bytes")
    assert(after < before - 100 * 1000)
    equal(t:check(), true)
    t:set_memory_limit(1)
    refused("out_of_memory", { "memory" }, t.set_compact, t, false)
    t:set_memory_limit(0)
    t:set_compact(false)
    assert(t:statistic("memory_bytes") > after)
    t = mgdt.new { compact = true, canonical = true }
    t:insert(points)
    assert(t:statistic("memory_bytes") < before - 100 * 1000)
    local expected, length = read("tetrahedra", "int64_t")
    same(t:tetrahedra(), expected, length, "tetrahedra")
end)

test("progress, cancelling, errors in the progress function", function()
    local seen, last = 0, -1
    local t = mgdt.new { progress = function(fraction)
        assert(fraction >= last and fraction <= 1)
        seen, last = seen + 1, fraction
    end }
    t:insert(points)
    equal(last, 1, "the last fraction")
    assert(seen > 50)
    for _, way in ipairs {
        function() return true end,
        function(_, u) u:cancel() end,
    } do
        local u = mgdt.new()
        u:set_progress(function(fraction) if fraction > 0.4 then return way(fraction, u) end end)
        refused("cancelled", { "1010 points" }, u.insert, u, points)
        equal(u:check(), true)
        assert(u:vertex_count() > 100 and u:vertex_count() < 1000)
        u:set_progress(nil)
        u:insert(points)
        equal(u:vertex_count(), 1000, "vertices after all")
        equal(u:check(), true)
    end
    local u = mgdt.new()
    u:cancel()
    refused("cancelled", {}, u.insert, u, points)
    -- An error of one's own comes out as it went in; at the very end it does as well.
    for _, at in ipairs { 0, 0.5, 1 } do
        local mine = {}
        u = mgdt.new { progress = function(fraction) if fraction >= at then error(mine) end end }
        local good, problem = pcall(u.insert, u, points)
        assert(not good and problem == mine)
        equal(u:check(), true)
    end
    u = mgdt.new()
    u:set_progress(function() u:insert { { 0, 0, 0 } } end)
    refused("busy", { "progress function" }, u.insert, u, points)
    -- Callbacks are few: a thousand calls must not use them up, whether they fail or not.
    u = mgdt.new { progress = function() error("no") end }
    for _ = 1, 3000 do pcall(u.insert, u, { { 0, 0, 0 } }) end
    local calls = 0
    u:set_progress(function() calls = calls + 1 end)
    u:insert(points)
    assert(calls > 50)
end)

-- What the C interface was given for its domain, as tables of rows.
local function given_domain()
    local xyz, values = read("domain_given_points", "double")
    local offsets, ends = read("domain_given_offsets", "int64_t")
    local corners, markers = read("domain_given_corners", "int64_t"), read("domain_given_markers", "int64_t")
    local given = { points = {}, facets = {}, markers = {}, segments = { { 0, 1 }, { 8, 9 } },
        segment_markers = { 5, 6 }, holes = { { 1, 1, 3 } }, regions = { { { 0, 0, 9.5 }, 7 } }, rounded = true }
    for k = 0, values / 3 - 1 do given.points[k + 1] = { xyz[3 * k], xyz[3 * k + 1], xyz[3 * k + 2] } end
    for k = 0, ends - 2 do
        local facet = {}
        for i = tonumber(offsets[k]), tonumber(offsets[k + 1]) - 1 do facet[#facet + 1] = tonumber(corners[i]) end
        given.facets[k + 1], given.markers[k + 1] = facet, tonumber(markers[k])
    end
    return given
end

test("a domain", function()
    local heard, given = 0, given_domain()
    given.progress = function(fraction) heard = heard + fraction end
    local mesh = mgdt.domain_mesh(given)
    assert(heard > 0)
    for name in pairs(require("mgdt.interface").mesh_array) do
        local is_integer = tostring(ffi.typeof(mesh[name])):match("int") ~= nil
        local reference, length = read("domain_" .. name, is_integer and "int64_t" or "double")
        equal(ffi.sizeof(mesh[name]) / (is_integer and 4 or 8), length, "length of " .. name)
        same(mesh[name], reference, length, name)
    end
    equal(ffi.sizeof(mesh.open_edges), 0, "open edges")
    local volumes, n = mesh:tetrahedron_measures "volume"
    local expected, length = read("domain_volumes", "double")
    equal(n, length, "number of volumes")
    same(volumes, expected, length, "volumes")
    equal(mesh.is_rounded, true, "is_rounded")
    equal(mesh.point_count, 18 + mesh.steiner_count, "points")
    equal(mesh.region_count, 2, "regions")
    equal(mesh.edge_count > 30 and mesh.face_count > 20, true, "edges and faces")
    equal(mesh:check(), true, "check")
    equal(#mgdt.offending_pairs(given), 0, "pairs")
    assert(tostring(mesh):find("2 regions"))

    -- Triangles as an array, numbered from 1.
    local triangles = ffi.new("int32_t[4][3]", { { 1, 3, 2 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 1, 4 } })
    local corners = ffi.new("double[4][3]", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } })
    mesh = mgdt.domain_mesh { points = corners, facets = triangles, index_base = 1 }
    equal(mesh.tetrahedron_count, 1, "tetrahedra")
    equal(mesh.tetrahedra[0][0] + mesh.tetrahedra[0][1] + mesh.tetrahedra[0][2] + mesh.tetrahedra[0][3], 10, "from 1")
    equal(mesh.neighbors[0][3], 0, "none")
    mesh = mgdt.domain_mesh { points = corners, facets = triangles, index_base = 1, keep_boundary = true }
    equal(mesh.tetrahedron_count, 1, "tetrahedra of a kept boundary")
    assert(mesh:check())
    -- A point in an edge of one of the facets at it.
    local hanging = { points = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 1, 0, 0 } },
        facets = { { 0, 2, 1 }, { 0, 4, 3 }, { 4, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } } }
    refused("invalid_boundary", { "facet" }, mgdt.domain_mesh, hanging)
    local cleaned = mgdt.clean_surface(hanging)
    equal(cleaned.facet_count, 6, "facets of a clean surface")
    equal(cleaned.origins[1], 0, "origins")
    equal(cleaned.points_in_edges, 1, "points in edges")
    equal(#cleaned.facets[6], 3, "corners")
    hanging.clean = true
    local whole = mgdt.domain_mesh(hanging)
    assert(whole:check())
    equal(whole.face_facets[0] < 5, true, "facets that were given")
    hanging.clean, hanging.weld = nil, 1e-9
    equal(mgdt.domain_mesh(hanging).tetrahedron_count, whole.tetrahedron_count, "welding cleans too")
    hanging.weld = 1
    refused("invalid_argument", { "option 70" }, mgdt.domain_mesh, hanging)
    hanging.weld = "much"
    refused("invalid_argument", { "weld" }, mgdt.domain_mesh, hanging)
    refused("open_boundary", { "no facets" }, mgdt.domain_mesh, { points = {}, facets = {} })
    refused("invalid_argument", { "hole 1 is in nothing" }, mgdt.domain_mesh,
        { points = corners, facets = triangles, index_base = 1, holes = { { 5, 5, 5 } }, strict = true })

    -- Two triangles that cross, and what else is refused.
    local crossing = { points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, -1 }, { 1, 1, 2 }, { 5, 1, 1 } },
        facets = { { 0, 1, 2 }, { 3, 4, 5 } } }
    local _, problem = pcall(mgdt.domain_mesh, crossing)
    equal(problem.name, "invalid_boundary", "name")
    for _, found in ipairs { problem.pairs, mgdt.offending_pairs(crossing) } do
        equal(#found, 1, "pairs")
        equal(table.concat(found[1], " "), "facet 0 facet 1", "the pair")
    end
    local function without(change)
        local copy = given_domain()
        for name, value in pairs(change) do copy[name] = value end
        return mgdt.domain_mesh, copy
    end
    refused("invalid_argument", { "18" }, without { facets = { { 0, 1, 18 } }, markers = { 1 } })
    refused("invalid_argument", { "markers", "19" }, without { markers = { 1, 2 } })
    refused("invalid_argument", { "facets[1] is no list" }, without { facets = { 1, 2 } })
    refused("invalid_argument", { "corners of facets[2] is x" }, without { facets = { { 0, "x", 1 } } })
    refused("invalid_argument", { "facets[1][4] is nil" }, without { facets = { { 0, 1, 2, nil, 4 } } })
    refused("invalid_argument", { "int32_t" }, without { facets = ffi.new("double[3]") })
    refused("invalid_argument", { "segments[1]" }, without { segments = { 1 } })
    refused("invalid_argument", { "regions[1]" }, without { regions = { 1 } })
    refused("invalid_argument", { "holes[2]" }, without { holes = { { 1, 1, 1 }, { 2, 2 } } })
    refused("invalid_argument", { "no setting hole" }, without { hole = {} })
    refused("invalid_argument", { "threads" }, without { threads = 1.5 })
    refused("not_finite", { "0" }, without { points = { { 0 / 0, 0, 0 } } })
    refused("cancelled", {}, without { progress = function() return true end })
    local good, text = pcall(without { progress = function() error("no more", 0) end })
    equal(good, false, "an error of progress")
    equal(text, "no more", "its message")
    for _ = 1, 300 do mgdt.domain_mesh(given) end
    collectgarbage()
end)

test("a mesh", function()
    local function integers(name)
        local array, count = read("block_given_" .. name, "int64_t")
        local list = {}
        for k = 0, count - 1 do list[k + 1] = tonumber(array[k]) end
        return list
    end
    local function rows(list, width)
        local found = {}
        for k = 0, #list / width - 1 do
            found[k + 1] = {}
            for i = 1, width do found[k + 1][i] = list[width * k + i] end
        end
        return found
    end
    local heard = 0
    local given = { points = read("block_given_points", "double"), tetrahedra = rows(integers "tetrahedra", 4),
        markers = integers "markers", faces = rows(integers "faces", 3), face_markers = integers "face_markers",
        progress = function(fraction) heard = heard + fraction end }
    local mesh = mgdt.mesh(given)
    assert(heard > 0)
    equal(mesh:check(), true, "check")
    equal(mesh.region_count, 2, "regions")
    assert(tostring(mesh):find("mgdt mesh: 125 points, 384 tetrahedra, 2 regions"))
    local refined, sizes = mgdt.mesh(given), { of_points = {}, of_tetrahedra = {} }
    for k = 1, 125 do sizes.of_points[k] = k == 1 and 0.3 or 0 end
    for k = 1, 384 do sizes.of_tetrahedra[k] = k == 384 and 0.25 or 0 end
    heard = 0
    equal(refined:refine { size = 0.75, gradation = 0.5, radius_edge = 1.5, volume = 0.125, sizes_of_surface = true,
        most_points = 2000, region_sizes = { 0.45, 0 }, point_sizes = sizes.of_points,
        tetrahedron_sizes = sizes.of_tetrahedra,
        size_field = { { { 0, 0, 0 }, { 8, 0, 0 }, { 0, 8, 0 }, { 0, 0, 8 } }, { 0.5, 0.75, 0.75, 1 } },
        size_function = function(_, _, z) return 0.375 + 0.125 * z end,
        progress = function(fraction) heard = heard + fraction end }, refined, "the mesh")
    assert(heard > 0)
    equal(refined:check(), true, "check")
    equal(refined.inserted_points, refined.point_count - 125, "inserted points")
    for name in pairs(require("mgdt.interface").mesh_array) do
        local is_integer = tostring(ffi.typeof(refined[name])):match("int") ~= nil
        local reference, length = read("refined_" .. name, is_integer and "int64_t" or "double")
        equal(ffi.sizeof(refined[name]) / (is_integer and 4 or 8), length, "length of " .. name)
        same(refined[name], reference, length, name)
    end
    heard = 0
    equal(mesh:improve { goal = 30, boundary = "slide", fixed = integers "fixed",
        progress = function(fraction) heard = heard + fraction end }, mesh, "the mesh")
    assert(heard > 0)
    equal(mesh:check(), true, "check")
    equal(mesh.below_goal, 0, "below the goal")
    for name in pairs(require("mgdt.interface").mesh_array) do
        local is_integer = tostring(ffi.typeof(mesh[name])):match("int") ~= nil
        local reference, length = read("block_" .. name, is_integer and "int64_t" or "double")
        equal(ffi.sizeof(mesh[name]) / (is_integer and 4 or 8), length, "length of " .. name)
        same(mesh[name], reference, length, name)
    end
    assert(mesh.shapes[0][1] > mesh.shapes[0][0])

    local places, numbers = read("places", "double")
    local coordinates = {}
    for k = 0, mesh.point_count - 1 do coordinates[k + 1] = { mesh.points[k][0], mesh.points[k][1], mesh.points[k][2] } end
    for outside, name in pairs { none = "inside", boundary = "nearest" } do
        local found, weights = mesh:locate_points(places, outside)
        same(found, read("places_" .. name .. "_tetrahedra", "int64_t"), numbers / 3, "tetrahedra " .. name)
        same(weights, read("places_" .. name .. "_weights", "double"), numbers / 3 * 4, "weights " .. name)
        local expected, values = read("places_" .. name .. "_values", "double"), mesh:interpolate(coordinates, places, outside)
        for k = 0, numbers - 1 do
            local value = values[math.floor(k / 3) + 1][k % 3 + 1]
            assert(value == expected[k] or (value ~= value and expected[k] ~= expected[k]))
        end
    end
    equal(mesh:locate_points({ { 9, 9, 9 } })[0], -1, "outside")
    local summary = mesh:shape_summary()
    same(ffi.new("double[3]", { summary.least_angle, summary.largest_angle, summary.mean_shape }),
        read("summary_shapes", "double"), 3, "shapes")
    same(ffi.new("double[18]", summary.angles), read("summary_angles", "int64_t"), 18, "angles")
    same(ffi.new("double[6]", summary.below), read("summary_below", "int64_t"), 6, "below")
    refused("invalid_argument", { "outside" }, mesh.locate_points, mesh, places, "beyond")
    refused("invalid_argument", { "values" }, mesh.interpolate, mesh, { 1, 2 }, places)

    local one = { points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, index_base = 1,
        tetrahedra = ffi.new("int32_t[1][4]", { { 1, 2, 3, 4 } }), edges = { { 2, 3 } }, edge_markers = { 5 } }
    equal(mgdt.mesh(one).edge_markers[0], 5, "an edge")
    local function without(change)
        local copy = {}
        for name, value in pairs(one) do copy[name] = value end
        for name, value in pairs(change) do copy[name] = value end
        return mgdt.mesh, copy
    end
    refused("invalid_argument", { "tetrahedron 1 has the corner 5" }, without { tetrahedra = { { 1, 2, 3, 5 } } })
    refused("invalid_argument", { "tetrahedra[1] is not 4" }, without { tetrahedra = { { 1, 2, 3 } } })
    refused("invalid_argument", { "corners of faces[2] is x" }, without { faces = { { 1, "x", 2 } } })
    refused("invalid_argument", { "markers" }, without { markers = { 1, 2 } })
    refused("invalid_argument", { "no setting facets" }, without { facets = {} })
    refused("invalid_argument", { "no tetrahedra" }, without { tetrahedra = {} })
    refused("cancelled", {}, without { progress = function() return true end })
    local tetrahedron = mgdt.mesh(one)
    for name, value in pairs { goal = 71, boundary = "open", points = "lose", fixed = 3, mean_passes = -1, most = 1 } do
        refused("invalid_argument", {}, tetrahedron.improve, tetrahedron, { [name] = value })
    end
    for name, value in pairs { size = "1", gradation = -1, radius_edge = {}, volume = -1, most_points = -1,
        sizes_of_surface = 1, region_sizes = { 1, 2 }, point_sizes = { 1, 1, 1, "1" }, tetrahedron_sizes = 1, most = 1,
        size_field = { { { 0, 0, 0 } }, {} }, size_function = 3 } do
        refused("invalid_argument", {}, tetrahedron.refine, tetrahedron, { [name] = value })
    end
    refused("invalid_argument", { "the size function gives -1" }, tetrahedron.refine, tetrahedron,
        { size_function = function() return -1 end })
    local _, problem = pcall(tetrahedron.refine, tetrahedron, { size_function = function() error "no size" end })
    assert(tostring(problem):find "no size")
    refused("cancelled", {}, refined.refine, refined, { size = 0.2, progress = function() return true end })
    equal(refined:check(), true, "check")
    refused("cancelled", {}, mesh.improve, mesh, { goal = 40, progress = function() return true end })
    equal(mesh:check(), true, "check")
end)

test("a periodic box", function()
    local box_vectors = { { 4, 0, 0 }, { 1.5, 3, 0 }, { -0.75, 0.5, 2.5 } }
    local xyz, values = read("periodic_given_points", "double")
    local heard = 0
    local box = mgdt.periodic_box { points = xyz, box = box_vectors,
        progress = function(fraction) heard = heard + fraction end }
    assert(heard > 0)
    local function compare(found)
        for name in pairs(require("mgdt.interface").periodic_array) do
            local is_integer = tostring(ffi.typeof(found[name])):match("int") ~= nil
            local reference, length = read("periodic_" .. name, is_integer and "int64_t" or "double")
            equal(ffi.sizeof(found[name]) / (is_integer and 4 or 8), length, "length of " .. name)
            same(found[name], reference, length, name)
        end
    end
    compare(box)
    equal(box.point_count, values / 3, "points")
    equal(box.vertex_count, 38, "vertices")
    equal(box.edge_count, box.vertex_count + box.tetrahedron_count, "edges")
    equal(box:check(), true, "check")
    assert(tostring(box):find("40 points, 3 vectors"))
    for _, name in ipairs { "volume", "area", "faces", "centroid" } do
        local x = box:cell_measures(name)
        local reference, length = read("periodic_" .. name, "double")
        same(x, reference, length, name)
    end
    local cells = box:voronoi()
    for name in pairs(require("mgdt.interface").voronoi_array) do
        local is_integer = tostring(ffi.typeof(cells[name])):match("int") ~= nil
        local reference, length = read("periodic_cells_" .. name, is_integer and "int64_t" or "double")
        same(cells[name], reference, length, name)
    end
    assert(box:voronoi(0.5).face_count < cells.face_count)
    box:move(xyz)
    compare(box)
    box:move(xyz, nil, { { 4, 0, 0 }, { 1.5, 3, 0 } })
    equal(box.vector_count, 2, "other vectors")
    box:move(xyz, nil, box_vectors)
    compare(box)

    local cube = mgdt.periodic_box { points = { { 0, 0, 0 }, { 1, 1, 1 } }, box = { 2, 2, 2 }, index_base = 1, threads = 2 }
    equal(cube.tetrahedron_count, 12, "tetrahedra")
    equal(cube.point_map[1], 2, "from 1")
    local near = mgdt.periodic_box { points = { { 0, 0, 0 }, { 2, 2, 1.999 }, { 1, 1, 1 } }, box = { 2, 2, 2 }, merge_distance = 0.01 }
    equal(near.vertex_count, 2, "points that become equal")
    equal(near.point_map[1], 0, "the one that stays")
    local slab = mgdt.periodic_box { points = xyz, box = { { 4, 0, 0 }, { 1.5, 3, 0 } } }
    equal(slab.vector_count, 2, "a slab")

    refused("invalid_argument", { "in a plane" }, mgdt.periodic_box, { points = xyz, box = { 1, 1, 0 } })
    refused("invalid_argument", { "box", "4 vectors" }, mgdt.periodic_box, { points = xyz,
        box = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } } })
    refused("invalid_argument", { "no setting pbc" }, mgdt.periodic_box, { points = xyz, box = { 1, 1, 1 }, pbc = 1 })
    refused("invalid_argument", { "point 0", "boxes away" }, mgdt.periodic_box, { points = { { 1e30, 0, 0 } }, box = { 1, 1, 1 } })
    refused("cancelled", {}, mgdt.periodic_box, { points = xyz, box = box_vectors, progress = function() return true end })
    refused("out_of_memory", {}, mgdt.periodic_box, { points = xyz, box = box_vectors, memory_limit = 5000 })
    refused("invalid_argument", { "2 places" }, cube.move, slab, { { 0, 0, 0 }, { 1, 1, 1 } })
end)

test("two handles, one table of settings; the module loads twice", function()
    package.loaded.mgdt = nil
    local again = require "mgdt"
    local a, b = mgdt.new(), again.new()
    a:insert { { 0, 0, 0 } }
    equal(b:point_count(), 0, "points of the other")
    equal(again.version(), mgdt.version(), "version")
    assert(mgdt.version():match("^%d+%.%d+%.%d+$"))
end)

local function resident() -- bytes
    local file = assert(io.open("/proc/self/statm"))
    local pages = file:read("*a"):match("^%d+ (%d+)")
    file:close()
    return pages * 4096
end

test("handles are freed when collected, and when closed", function()
    local function make(close)
        local held = 0
        for k = 1, 1000 do
            local t = mgdt.new()
            t:insert(points)
            held = held + t:statistic("memory_bytes")
            if close then t:close() end
            if k % 10 == 0 then collectgarbage() end
        end
        return held
    end
    for _, close in ipairs { false, true } do
        make(close)
        collectgarbage()
        local before = resident()
        local held = make(close)
        collectgarbage()
        local grown = resident() - before
        print(("  %d MB in 1000 handles; the process grew by %.1f MB"):format(held / 1e6, grown / 1e6))
        assert(held > 200e6, "the handles held too little for this test to see a leak")
        assert(grown < 20e6, "memory was not given back")
    end
    local t = mgdt.new()
    t:close()
    t:close()
    refused("null_pointer", { "closed" }, t.point_count, t)
    refused("null_pointer", { "closed" }, t.insert, t, points)
    refused("null_pointer", { "closed" }, t.cancel, t)
    assert(tostring(t):find("closed"))
end)

print(("%d passed, %d failed"):format(passed, failed))
os.exit(failed == 0 and passed > 0 and 0 or 1)
