# SPDX-License-Identifier: MIT
# frozen_string_literal: true

require "ffi"
require_relative "interface"

module Mgdt
  # The C interface as it is; Triangulation is made of it.
  module Library
    extend FFI::Library

    # Loads the library, and says what was tried if that fails.
    def self.load
      by_system = if FFI::Platform.windows? then "mgdt-1.dll"
                  elsif FFI::Platform.mac? then "libmgdt.1.dylib"
                  else "libmgdt.so.1"
                  end
      chosen = ENV.fetch("MGDT_LIBRARY", "")
      name, from = chosen.empty? ? [by_system, ""] : [chosen, " (from MGDT_LIBRARY)"]
      FFI::DynamicLibrary.open(name, FFI::DynamicLibrary::RTLD_LAZY |
                                     FFI::DynamicLibrary::RTLD_LOCAL)
    rescue ::LoadError => e
      raise LoadError, "mgdt: the library was not found; set MGDT_LIBRARY to its file. " \
                       "Tried:\n  #{name}#{from}: #{e.message}"
    end
    private_class_method :load

    # Refuses what is not mgdt, and an mgdt of another binary interface.
    def self.require_abi(library, needed)
      address = library.find_function("mgdt_abi_version")
      unless address
        raise LoadError, "mgdt: #{library.name} is not the mgdt library: it has no mgdt_abi_version"
      end
      version = FFI::Function.new(:int32, [], address).call
      return if version == needed

      raise LoadError, "mgdt: #{library.name} has ABI version #{version}; the gem needs #{needed}"
    end
    private_class_method :require_abi

    library = load
    require_abi(library, 1)
    @ffi_libs = [library]

    callback :progress, %i[double pointer], :int32
    callback :size, %i[int64 pointer pointer pointer], :int32

    # What can take long runs without Ruby's lock, so that other threads go on.
    INTERFACE.each do |name, parameters, result, is_long|
      attach_function name, parameters, result, blocking: is_long
    end

    # A handle that is destroyed when it is collected.
    class Handle < FFI::AutoPointer
      def self.release(pointer)
        Library.mgdt_destroy(pointer)
      end
    end
  end
  private_constant :Library
end
