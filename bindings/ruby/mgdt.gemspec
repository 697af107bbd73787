# SPDX-License-Identifier: MIT
# frozen_string_literal: true

Gem::Specification.new do |gem|
  gem.name = "mgdt"
  gem.version = "1.4.0"
  gem.summary = "Exact 3D Delaunay triangulation of any set of points"
  gem.description = "A binding of the shared library libmgdt, which must be installed."
  gem.authors = ["The mgdt authors"]
  gem.license = "MIT"
  gem.files = Dir.chdir(__dir__) { Dir["lib/**/*.rb", "example.rb"] }
  gem.required_ruby_version = ">= 3.0"
  gem.add_dependency "ffi", "~> 1.15"
end
