-- SPDX-License-Identifier: MIT
-- A first program: the corners of a cube and its centre, and what mgdt says of them.
--
--   LUA_PATH="$(pkg-config --variable=bindings_dir mgdt)/lua/?.lua;;" luajit example.lua
local mgdt = require "mgdt"

local points = { { 0.5, 0.5, 0.5 } }
for x = 0, 1 do
    for y = 0, 1 do
        for z = 0, 1 do table.insert(points, { x, y, z }) end
    end
end

local t = mgdt.new { canonical = true }
t:insert(points)
assert(t:check())

-- FFI arrays start at 0; so do the numbers of points. The Lua table starts at 1.
local tetrahedra, count = t:tetrahedra()
local volume = 0
for k = 0, count - 1 do
    local a, b, c, d = points[tetrahedra[k][0] + 1], points[tetrahedra[k][1] + 1],
        points[tetrahedra[k][2] + 1], points[tetrahedra[k][3] + 1]
    local u, v, w = {}, {}, {}
    for i = 1, 3 do u[i], v[i], w[i] = b[i] - a[i], c[i] - a[i], d[i] - a[i] end
    volume = volume + (u[1] * (v[2] * w[3] - v[3] * w[2]) - u[2] * (v[1] * w[3] - v[3] * w[1])
        + u[3] * (v[1] * w[2] - v[2] * w[1])) / 6
end
print(("%d tetrahedra, %d triangles on the hull, volume %g")
    :format(count, t:hull_facet_count(), volume))
print(("nearest to (0.9, 0.1, 0.8): point %d"):format(t:nearest(0.9, 0.1, 0.8)))
print(("outside: %s"):format(t:locate(2, 2, 2)))

local good, problem = pcall(t.insert, t, { { 0, 0, 0 }, { 0, 0 / 0, 0 } })
print(good, problem)
