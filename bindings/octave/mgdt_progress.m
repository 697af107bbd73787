% SPDX-License-Identifier: MIT

% [stop, problem] = mgdt_progress (fn, fraction)
%
% Calls a progress function, which may give nothing back, and keeps its error as a struct that
% rethrow takes. For mgdt_mex alone: no error may pass through the library.
function [stop, problem] = mgdt_progress (fn, fraction)
  stop = false;
  problem = [];
  try
    ans = false; # stays if the function gives nothing
    fn (fraction);
    stop = any (logical (ans(:)));
  catch e
    problem = struct ("message", e.message, "identifier", e.identifier, "stack", e.stack);
  end
end
