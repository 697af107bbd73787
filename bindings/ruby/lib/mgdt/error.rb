# SPDX-License-Identifier: MIT
# frozen_string_literal: true

require_relative "interface"

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
  class NotBuilt < Error; end          # there is no result: the call that makes it comes first
  class BufferTooSmall < Error; end    # the buffer given holds less than what must be written
  class IndexRange < Error; end        # an index does not fit the buffer's 32-bit integers
  class OutOfMemory < Error; end       # the system or the memory limit refused
  class TooLarge < Error; end          # more points or tetrahedra than can be numbered
  class Cancelled < Error; end         # cancel, or the progress block, asked to stop
  class Busy < Error; end              # a progress block called its own triangulation
  class CheckFailed < Error; end       # check found a defect; the message says what and where
  class Closed < Error; end            # the triangulation was closed
  class OpenBoundary < Error; end      # facets enclose nothing; where they are open, in the message
  class Resolution < Error; end        # a mesh would need smaller differences than doubles have

  # Facets, segments or points cross or touch where they must not. `pairs` has all of them, as
  # Mgdt.offending_pairs gives them.
  class InvalidBoundary < Error
    attr_accessor :pairs
  end

  class Error
    CLASSES = {
      null_pointer: InvalidArgument, invalid_argument: InvalidArgument, not_finite: NotFinite,
      unknown_scheme: UnknownName, unknown_key: UnknownName, not_built: NotBuilt,
      buffer_too_small: BufferTooSmall, index_range: IndexRange, out_of_memory: OutOfMemory, too_large: TooLarge,
      cancelled: Cancelled, busy: Busy, check_failed: CheckFailed,
      invalid_boundary: InvalidBoundary, resolution: Resolution,
      open_boundary: OpenBoundary
    }.transform_keys(&CONSTANTS[:status]).freeze
    private_constant :CLASSES
  end
end
