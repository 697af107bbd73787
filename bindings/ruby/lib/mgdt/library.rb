# SPDX-License-Identifier: MIT
# frozen_string_literal: true

require "ffi"

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

    # What can take long runs without Ruby's lock, so that other threads go on.
    LONG = { blocking: true }.freeze
    private_constant :LONG

    attach_function :mgdt_create, [:pointer], :int32
    attach_function :mgdt_destroy, [:pointer], :void
    attach_function :mgdt_clear, [:pointer], :int32
    attach_function :mgdt_reserve, %i[pointer int64], :int32
    attach_function :mgdt_set_order_scheme, %i[pointer int32], :int32
    attach_function :mgdt_set_order_parameter, %i[pointer int32 double], :int32
    attach_function :mgdt_set_seed, %i[pointer uint64], :int32
    attach_function :mgdt_set_threads, %i[pointer int32], :int32
    attach_function :mgdt_set_index_base, %i[pointer int32], :int32
    attach_function :mgdt_set_memory_limit, %i[pointer int64], :int32
    attach_function :mgdt_set_compact, %i[pointer int32], :int32
    attach_function :mgdt_set_progress, %i[pointer progress pointer], :int32
    attach_function :mgdt_cancel, [:pointer], :int32
    attach_function :mgdt_set_canonical_output, %i[pointer int32], :int32
    attach_function :mgdt_set_isa, %i[pointer string], :int32
    attach_function :mgdt_insert_points, %i[pointer int64 pointer], :int32, LONG
    attach_function :mgdt_insert_points_strided,
                    %i[pointer int64 pointer pointer pointer int64], :int32, LONG
    %i[point vertex tetrahedron hull_facet edge vertex_tetrahedra].each do |what|
      attach_function :"mgdt_#{what}_count", [:pointer], :int64
    end
    attach_function :mgdt_dimension, [:pointer], :int32
    %i[tetrahedra neighbors hull_facets edges point_map].each do |what|
      attach_function :"mgdt_get_#{what}", %i[pointer int64 pointer], :int32, LONG
      attach_function :"mgdt_get_#{what}_i32", %i[pointer int64 pointer], :int32, LONG
    end
    attach_function :mgdt_get_vertex_tetrahedra,
                    %i[pointer int64 pointer int64 pointer], :int32, LONG
    attach_function :mgdt_locate, %i[pointer pointer pointer], :int32
    attach_function :mgdt_locate_points, %i[pointer int64 pointer pointer pointer], :int32, LONG
    attach_function :mgdt_nearest_vertex, %i[pointer pointer pointer], :int32
    attach_function :mgdt_check, %i[pointer int32], :int32, LONG
    attach_function :mgdt_get_stat, %i[pointer int32 pointer], :int32
    attach_function :mgdt_stat_name, [:int32], :string
    attach_function :mgdt_status_string, [:int32], :string
    attach_function :mgdt_get_error, %i[pointer int64 pointer], :int32
    attach_function :mgdt_order_scheme_name, [:int32], :string
    attach_function :mgdt_order_scheme_from_name, %i[string pointer], :int32
    attach_function :mgdt_version_string, [], :string
    attach_function :mgdt_abi_version, [], :int32
    attach_function :mgdt_isa_name, [:pointer], :string

    # A handle that is destroyed when it is collected.
    class Handle < FFI::AutoPointer
      def self.release(pointer)
        Library.mgdt_destroy(pointer)
      end
    end
  end
  private_constant :Library
end
