# SPDX-License-Identifier: MIT
# frozen_string_literal: true

module Mgdt
  # Reads the arrays and numbers of a handle whose functions are mgdt_KIND_get_size and so on.
  class ArrayReader
    def initialize(kind, handle)
      @kind = kind
      @handle = handle
      @keys = CONSTANTS.fetch(:"#{kind}_array")
    end

    # Returns an array of integers or of doubles. If several elements belong together, such as the four
    # corners of a tetrahedron, each of these rows is an Array.
    def array(name)
      columns = FFI::MemoryPointer.new(:int32)
      is_double = FFI::MemoryPointer.new(:int32)
      Library.public_send(:"mgdt_#{@kind}_array_info", @keys.fetch(name), columns, is_double)
      values = is_double.read_int32 == 1 ? doubles(name) : integers(name)
      columns.read_int32 > 1 ? values.each_slice(columns.read_int32).to_a : values
    end

    # An Array for each list: of the elements from one offset to the next.
    def lists(offsets, elements, index_base)
      all = array(elements)
      integers(offsets).each_cons(2).map { |from, to| all[(from - index_base)...(to - index_base)] || [] }
    end

    def set_option(name, value)
      call(:set_option, CONSTANTS[:"#{@kind}_option"].fetch(name), value)
    end

    def set_double_option(name, value)
      call(:set_double_option, CONSTANTS[:"#{@kind}_option"].fetch(name), value)
    end

    def statistic(name)
      value = FFI::MemoryPointer.new(:int64)
      call(:get_stat, CONSTANTS[:"#{@kind}_stat"].fetch(name), value)
      value.read_int64
    end

    def integers(name)
      length = size_of(name)
      buffer = FFI::MemoryPointer.new(:int64, [length, 1].max)
      call(:get_array, @keys.fetch(name), length, buffer)
      buffer.read_array_of_int64(length)
    end

    def doubles(name)
      length = size_of(name)
      buffer = FFI::MemoryPointer.new(:double, [length, 1].max)
      call(:get_doubles, @keys.fetch(name), length, buffer)
      buffer.read_array_of_double(length)
    end

    # Calls a function of the handle, and raises the error of its status.
    def call(function, *arguments)
      ensure_good(ask(function, *arguments))
    end

    # Calls a function of the handle; the result is its status.
    def ask(function, *arguments)
      Library.public_send(:"mgdt_#{@kind}_#{function}", @handle, *arguments)
    end

    def ensure_good(status)
      raise error_of(status) unless status.zero?
    end

    def error_of(status)
      buffer = FFI::MemoryPointer.new(:char, 256)
      ask(:get_error, 256, buffer)
      message = buffer.read_string
      Error.of(status, message.empty? ? Library.mgdt_status_string(status) : message)
    end

    private

    def size_of(name)
      size = FFI::MemoryPointer.new(:int64)
      call(:get_size, @keys.fetch(name), size)
      size.read_int64
    end
  end
  private_constant :ArrayReader
end
