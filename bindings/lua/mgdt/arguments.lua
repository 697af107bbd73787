-- SPDX-License-Identifier: MIT
--- What mgdt.lua and mgdt/domain.lua share: errors, and arguments as a caller gives them.

local ffi = require "ffi"
local C = require "mgdt.library"
local constants = require "mgdt.interface"

-- ------------------------------------------------------------------------------------- errors

local status = constants.status
local status_names = {}
for name, value in pairs(status) do status_names[value] = name end

local Error = { __tostring = function(e) return "mgdt: " .. e.message end }

local function raise(value, message)
    error(setmetatable({ status = value, name = status_names[value] or "unknown",
                         message = message }, Error), 0)
end

local function bad_argument(format, ...) raise(status.invalid_argument, format:format(...)) end

--- A function that raises the error of a status, if it is one, with the message that get_error has of
--- the handle.
local function raiser(get_error)
    local function message_of(handle, value)
        local buffer = ffi.new("char[256]")
        get_error(handle, 256, buffer)
        local message = ffi.string(buffer)
        return message ~= "" and message or ffi.string(C.mgdt_status_string(value))
    end
    local function ensure(handle, value)
        if value ~= 0 then raise(value, message_of(handle, value)) end
    end
    return ensure, message_of
end

-- ---------------------------------------------------------------------------------- arguments

local function whole(value, what)
    local number = tonumber(value)
    if not number or number % 1 ~= 0 or math.abs(number) > 2 ^ 53 then
        bad_argument("%s is %s; it must be a whole number", what, tostring(value))
    end
    return number
end

local function real(value, what)
    local number = type(value) ~= "string" and tonumber(value)
    if not number then bad_argument("%s is %s; it must be a number", what, tostring(value)) end
    return number
end

-- Element type of an FFI array or pointer ("double", "int", "int64_t"), and how many elements it
-- holds, which a pointer does not say.
local function shape_of(array)
    if type(array) ~= "cdata" then return nil end
    local element, rest = tostring(ffi.typeof(array)):match("^ctype<([%w_ ]-) ?([%(%[%*&].*)>$")
    if not element then return nil end
    element = element:gsub("^const ", "")
    if rest:match("^%[") or rest:match("^%(&%)%[") then
        local size = ({ double = 8, int = 4, int64_t = 8 })[element]
        return element, size and ffi.sizeof(array) / size
    elseif rest == "*" or rest:match("^%(%*%)%[") then
        return element, nil
    end
end

-- Rows of numbers as a `const double *` and how many there are. FFI arrays are passed as they stand.
local function rows_of(points, n, what, width, row_name)
    if type(points) == "table" then
        if n ~= nil then
            bad_argument("%s is a table, which knows its length; give no number", what)
        end
        local rows = type(points[1]) == "table"
        local count = rows and #points or #points / width
        if count % 1 ~= 0 then
            bad_argument("%s holds %d numbers, which is no multiple of %d", what, #points,
                width)
        end
        local xyz = ffi.new("double[?]", width * count)
        for k = 0, count - 1 do
            local row = rows and points[k + 1] or points
            if type(row) ~= "table" or rows and #row ~= width then
                bad_argument("%s[%d] is not %s numbers", what, k + 1, width == 3 and "three" or "four")
            end
            for axis = 0, width - 1 do
                local value = row[rows and axis + 1 or width * k + axis + 1]
                if type(value) ~= "number" then
                    local place = rows and ("[%d][%d]"):format(k + 1, axis + 1)
                        or ("[%d]"):format(width * k + axis + 1)
                    bad_argument("%s%s is %s; it must be a number", what, place, tostring(value))
                end
                xyz[width * k + axis] = value
            end
        end
        return xyz, count
    end
    local element, length = shape_of(points)
    if element ~= "double" then
        bad_argument("%s is %s; it must be a table, or an FFI array or pointer of double", what,
            type(points) == "cdata" and tostring(ffi.typeof(points)) or type(points))
    end
    if n == nil then
        if not length then
            bad_argument("%s is a pointer: give the number of %s as well", what, row_name)
        end
        n = length / width
        if n % 1 ~= 0 then
            bad_argument("%s holds %d numbers, which is no multiple of %d", what, length, width)
        end
    else
        n = whole(n, "the number of " .. row_name)
        if length and width * n > length then
            bad_argument("%s holds %d numbers, too few for %d %s", what, length, n, row_name)
        end
    end
    return ffi.cast("const double *", points), n
end

local function small(value, what)
    value = whole(value, what)
    if math.abs(value) >= 2 ^ 31 then bad_argument("%s is %d, out of range", what, value) end
    return value
end

-- The number of a name, or a number that is one.
local function choice(value, names, what)
    if names[value] then return names[value] end
    if type(value) ~= "number" then
        local known = {}
        for name in pairs(names) do known[#known + 1] = name end
        table.sort(known, function(a, b) return names[a] < names[b] end)
        bad_argument("%s is %s; it must be one of %s", what, tostring(value), table.concat(known, ", "))
    end
    return small(value, what)
end

-- Whole numbers of a table, as an array of an element type.
local function list_of(values, what, element)
    local array = ffi.new(element .. "[?]", #values)
    for k, value in ipairs(values) do
        array[k - 1] = (element == "int32_t" and small or whole)(value, ("%s[%d]"):format(what, k))
    end
    return array
end

local function markers_of(markers, n, what)
    if markers == nil then return nil end
    if type(markers) ~= "table" or #markers ~= n then
        bad_argument("%s must be a table of %d numbers", what, n)
    end
    return list_of(markers, what, "int32_t")
end

return { raise = raise, bad_argument = bad_argument, raiser = raiser, whole = whole, real = real,
    small = small, choice = choice, shape_of = shape_of, rows_of = rows_of, list_of = list_of,
    markers_of = markers_of }
