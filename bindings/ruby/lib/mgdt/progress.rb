# SPDX-License-Identifier: MIT
# frozen_string_literal: true

module Mgdt
  # Lets a caller's block hear of the progress of a call.
  module Progress
    # Runs the block, whose result is a status, while `progress` hears; `set` gives the library a
    # callback, or nil. An exception of `progress` stops the call, and is raised afterwards.
    def self.watch(progress, set)
      problem = nil
      callback = FFI::Function.new(:int32, %i[double pointer]) do |fraction, _|
        ask(progress, fraction) { |raised| problem = raised }
      end
      set.call(callback)
      begin
        status = yield
      ensure
        set.call(nil)
        callback.free
      end
      raise problem if problem

      status
    end

    # What is returned to the library: 1 to stop. Nothing may leave through the library's frames, so an
    # exception is kept for later, and the `return` below ends a break, a throw or Thread#kill.
    def self.ask(progress, fraction)
      answer = 1
      answer = 0 unless progress.call(fraction) == :cancel
    rescue Exception => e # rubocop:disable Lint/RescueException
      yield e
    ensure
      return answer # rubocop:disable Lint/EnsureReturn
    end
    private_class_method :ask
  end
  private_constant :Progress
end
