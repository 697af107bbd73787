# SPDX-License-Identifier: MIT
# frozen_string_literal: true

module Mgdt
  # What went wrong in a call. `status` is the number that the C interface gives it.
  class Error < StandardError
    attr_reader :status

    def initialize(message, status)
      super(message)
      @status = status
    end

    # The error of a status: of the class below that stands for it.
    def self.of(status, message)
      CLASSES.fetch(status, self).new(message, status)
    end
  end

  # The library was not found, or is not one that this binding can use.
  class LoadError < ::LoadError; end

  class InvalidArgument < Error; end   # a value out of its range
  class NotFinite < Error; end         # a coordinate is NaN or infinite; which, in the message
  class UnknownName < Error; end       # no such order scheme, parameter or statistic
  class BufferTooSmall < Error; end    # the buffer given holds less than what must be written
  class IndexRange < Error; end        # an index does not fit the buffer's 32-bit integers
  class OutOfMemory < Error; end       # the system or the memory limit refused
  class TooLarge < Error; end          # more points or tetrahedra than can be numbered
  class Cancelled < Error; end         # cancel, or the progress block, asked to stop
  class Busy < Error; end              # a progress block called its own triangulation
  class CheckFailed < Error; end       # check found a defect; the message says what and where
  class Closed < Error; end            # the triangulation was closed

  class Error
    CLASSES = {
      10 => InvalidArgument, 11 => InvalidArgument, 12 => NotFinite, 13 => UnknownName,
      14 => UnknownName, 20 => BufferTooSmall, 21 => IndexRange, 30 => OutOfMemory,
      31 => TooLarge, 40 => Cancelled, 41 => Busy, 60 => CheckFailed
    }.freeze
    private_constant :CLASSES
  end
end
