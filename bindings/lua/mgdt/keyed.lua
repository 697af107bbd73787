-- SPDX-License-Identifier: MIT
--- Handles whose options, statistics and arrays have keys, for the other files of this folder.

local ffi = require "ffi"
local C = require "mgdt.library"
local constants = require "mgdt.interface"
local arguments = require "mgdt.arguments"

local keyed = {}

--- The functions of a kind of handle, such as "mesh": ensure(handle, status), message_of(handle, status),
--- set_option(handle, name, value), set_double_option(handle, name, value), statistic(handle, name),
--- get(handle, name), and watch(handle, progress, call), which makes a call and reports its progress.
function keyed.of(kind)
    local prefix = "mgdt_" .. kind .. "_"
    local arrays, stats = constants[kind .. "_array"], constants[kind .. "_stat"]
    local of = {}
    of.ensure, of.message_of = arguments.raiser(C[prefix .. "get_error"])

    function of.set_option(handle, name, value)
        of.ensure(handle, C[prefix .. "set_option"](handle, constants[kind .. "_option"][name], value))
    end

    function of.set_double_option(handle, name, value)
        of.ensure(handle, C[prefix .. "set_double_option"](handle, constants[kind .. "_option"][name], value))
    end

    function of.statistic(handle, name)
        local value = ffi.new("int64_t[1]")
        of.ensure(handle, C[prefix .. "get_stat"](handle, stats[name], value))
        return tonumber(value[0])
    end

    -- An array and the number of its rows. Several elements that belong together are a row.
    function of.get(handle, name)
        local key, size = arrays[name], ffi.new("int64_t[1]")
        local columns, is_double = ffi.new("int32_t[1]"), ffi.new("int32_t[1]")
        C[prefix .. "array_info"](key, columns, is_double)
        of.ensure(handle, C[prefix .. "get_size"](handle, key, size))
        local element, width, length = is_double[0] == 1 and "double" or "int32_t", columns[0], tonumber(size[0])
        local array = width > 1 and ffi.new(("%s[?][%d]"):format(element, width), length / width)
            or ffi.new(element .. "[?]", length)
        local read = C[prefix .. (element == "double" and "get_doubles" or "get_array_i32")]
        of.ensure(handle, read(handle, key, length, ffi.cast(element .. " *", array)))
        return array, length / width
    end
    -- Compiled code does not hold on to an array whose address alone is in use any more.
    jit.off(of.get, true)

    -- Returns the status of the call.
    function of.watch(handle, progress, call)
        if progress == nil then return call(handle) end
        if type(progress) ~= "function" then
            arguments.bad_argument("the progress function is no function")
        end
        local failed, problem = false, nil
        local callback = ffi.cast("mgdt_progress_fn", function(fraction)
            -- Nothing may be thrown through the library.
            local good, stop = pcall(progress, fraction)
            if not good then failed, problem = true, stop end
            return (not good or stop) and 1 or 0
        end)
        C[prefix .. "set_progress"](handle, callback, nil)
        local value = call(handle)
        C[prefix .. "set_progress"](handle, nil, nil)
        callback:free()
        if failed then error(problem, 0) end
        return value
    end
    jit.off(of.watch, true)

    return of
end

return keyed
