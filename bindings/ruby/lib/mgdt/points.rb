# SPDX-License-Identifier: MIT
# frozen_string_literal: true

module Mgdt
  # Points as a caller gives them, ready for the C interface: what to pass, and how many.
  #
  # - an Array of [x, y, z], or a flat Array of numbers; both are copied;
  # - a String of native doubles, as of [..].pack("d*") or Numo::DFloat#to_binary: read in place;
  # - an FFI::Pointer to doubles: read in place; with `count` unless it knows its size.
  #
  # Rows of another width, four numbers of a plane each, are taken in the same way.
  class Points
    attr_reader :data, :count

    def initialize(points, count = nil, width: 3, name: "points")
      @width = width
      @name = name
      @data, length =
        case points
        when Array then from_array(points)
        # A duplicate shares the bytes and keeps them from other threads.
        when String then [points.frozen? ? points : points.dup.freeze, points.bytesize / 8.0]
        when FFI::Pointer then [points, length_of(points)]
        else
          raise argument("#{@name} are of class #{points.class}; they must be an Array, a String " \
                         "of doubles or an FFI::Pointer")
        end
      @count = count ? checked(count, length) : whole(length)
    end

    private

    def argument(message)
      InvalidArgument.new(message, 11)
    end

    def whole(length)
      raise argument("a pointer does not know its size: give the number of #{@name}") if length.nil?
      return (length / @width).to_i if (length % @width).zero?

      raise argument("#{@name} hold #{length.to_i == length ? length.to_i : length} numbers, " \
                     "which is no multiple of #{@width}")
    end

    def checked(count, length)
      raise argument("the number of #{@name} is #{count.inspect}; it must be an Integer") unless
        count.is_a?(Integer)
      raise argument("#{@name} hold #{length.to_i} numbers, too few for #{count} #{@name}") if
        length && @width * count > length

      count
    end

    def length_of(pointer)
      # What has no size of its own says the largest number there is.
      pointer.size == FFI::Pointer::NULL.size || pointer.size >= 2**62 ? nil : pointer.size / 8.0
    end

    def from_array(points)
      flat = points.first.is_a?(Array) ? flatten(points) : points
      [flat.pack("d*"), flat.size]
    rescue TypeError, RangeError
      k = flat.index { |value| !value.is_a?(Numeric) || !value.real? }
      raise argument("#{@name} hold #{k ? flat[k].inspect : 'something'} as number #{k}; " \
                     "it must be a real number")
    end

    def flatten(points)
      points.each_with_index do |point, k|
        raise argument("#{@name}[#{k}] is not #{@width == 3 ? 'three' : 'four'} numbers") unless
          point.is_a?(Array) && point.size == @width
      end
      points.flatten(1)
    end
  end
  private_constant :Points
end
