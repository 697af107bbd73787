-- SPDX-License-Identifier: MIT
--- Reads Voronoi diagrams, for mgdt.lua and mgdt/periodic.lua.

local ffi = require "ffi"
local C = require "mgdt.library"
local constants = require "mgdt.interface"
local of_diagram = require("mgdt.keyed").of "voronoi"

local diagram = {}

-- The arrays by which things are counted.
local counts = { vertices = "vertex_count", ray_vertices = "ray_count", face_areas = "face_count",
    cell_volumes = "cell_count" }

--- The arrays of a diagram, which is destroyed, without faces that are smaller.
function diagram.take(pointer, least_area, least_share)
    local handle = ffi.gc(pointer, C.mgdt_voronoi_destroy)
    if least_area ~= 0 or least_share ~= 0 then
        of_diagram.ensure(handle, C.mgdt_voronoi_drop_small_faces(handle, least_area, least_share))
    end
    local arrays = {}
    for name in pairs(constants.voronoi_array) do
        local count
        arrays[name], count = of_diagram.get(handle, name)
        if counts[name] then arrays[counts[name]] = count end
    end
    C.mgdt_voronoi_destroy(ffi.gc(handle, nil))
    return arrays
end
jit.off(diagram.take)

return diagram
