% SPDX-License-Identifier: MIT

% [sizes, problem] = mgdt_sizes (fn, places)
%
% Calls a function that finds sizes at places, a row for each, and keeps its error as a struct that
% rethrow takes. For mgdt_mex alone: no error may pass through the library.
function [sizes, problem] = mgdt_sizes (fn, places)
  sizes = [];
  problem = [];
  try
    sizes = double (fn (places));
    if (numel (sizes) != rows (places))
      error ("mgdt:invalid_argument", "mgdt: size_function gives %d sizes for %d places", numel (sizes), rows (places));
    end
  catch e
    problem = struct ("message", e.message, "identifier", e.identifier, "stack", e.stack);
  end
end
