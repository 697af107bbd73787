-- SPDX-License-Identifier: MIT
--- The C interface of mgdt, for mgdt.lua: loaded, and its binary interface compared.

local ffi = require "ffi"

require "mgdt.interface"

-- ------------------------------------------------------------------------------------ loading

local function load_library()
    local by_system = { Windows = "mgdt-1.dll", OSX = "libmgdt.1.dylib" }
    local name, from = by_system[ffi.os] or "libmgdt.so.1", ""
    local chosen = os.getenv("MGDT_LIBRARY")
    if chosen and chosen ~= "" then name, from = chosen, " (from MGDT_LIBRARY)" end
    local found, library = pcall(ffi.load, name)
    if not found then
        error(("mgdt: the library was not found; set MGDT_LIBRARY to its file. Tried:\n  %s%s: %s")
            :format(name, from, tostring(library)), 0)
    end
    local is_mgdt, version = pcall(function() return library.mgdt_abi_version() end)
    if not is_mgdt then
        error(("mgdt: %s is not the mgdt library: it has no mgdt_abi_version"):format(name), 0)
    elseif version ~= 1 then
        error(("mgdt: %s has ABI version %d; mgdt.lua needs 1"):format(name, version), 0)
    end
    return library
end

local library = load_library()
-- Finalisers may run after all modules are gone from package.loaded; the library must not be.
debug.getregistry()["mgdt.library"] = library
return library
