-- SPDX-License-Identifier: MIT
--- Reads Voronoi diagrams, for mgdt.lua and mgdt/periodic.lua.

local ffi = require "ffi"
local C = require "mgdt.library"
local constants = require "mgdt.interface"
local ensure = require("mgdt.arguments").raiser(C.mgdt_voronoi_get_error)

local diagram = {}

-- The arrays of a diagram that have several numbers for a face, a ray, a vertex or a cell.
local widths = { face_sides = 2, face_images = 3, vertices = 3, ray_directions = 3, face_normals = 3,
    face_centroids = 3, cell_centroids = 3, cell_neighbor_images = 3 }

--- The arrays of a diagram, which is destroyed, without faces that are smaller.
function diagram.take(pointer, least_area, least_share)
    local handle = ffi.gc(pointer, C.mgdt_voronoi_destroy)
    if least_area ~= 0 or least_share ~= 0 then
        ensure(handle, C.mgdt_voronoi_drop_small_faces(handle, least_area, least_share))
    end
    local arrays, size = {}, ffi.new("int64_t[1]")
    for name, key in pairs(constants.voronoi) do
        local is_integer, width = key < constants.voronoi.vertices, widths[name]
        local element = is_integer and "int32_t" or "double"
        ensure(handle, C.mgdt_voronoi_get_size(handle, key, size))
        local length = tonumber(size[0])
        local array = width and ffi.new(("%s[?][%d]"):format(element, width), length / width)
            or ffi.new(element .. "[?]", length)
        local get = is_integer and C.mgdt_voronoi_get_array_i32 or C.mgdt_voronoi_get_doubles
        ensure(handle, get(handle, key, length, ffi.cast(element .. " *", array)))
        arrays[name] = array
        if name == "vertices" then arrays.vertex_count = length / 3 end
        if name == "ray_vertices" then arrays.ray_count = length end
        if name == "face_areas" then arrays.face_count = length end
        if name == "cell_volumes" then arrays.cell_count = length end
    end
    C.mgdt_voronoi_destroy(ffi.gc(handle, nil))
    return arrays
end
jit.off(diagram.take)

return diagram
