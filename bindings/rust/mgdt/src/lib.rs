// SPDX-License-Identifier: MIT
//! mgdt: exact 3D Delaunay triangulation of any set of points, by the shared library `libmgdt`.
//!
//! ```
//! # fn main() -> Result<(), mgdt::Error> {
//! let mut t = mgdt::Triangulation::new()?;
//! t.insert(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0; 3]])?;
//! for tetrahedron in t.tetrahedra()? {
//!     println!("{:?}", tetrahedron); // four numbers of points, counted from 0
//! }
//! t.check(mgdt::Check::Canonical)?; // proves it
//! # Ok(())
//! # }
//! ```
//!
//! Points and tetrahedra are numbered from 0, and "none" is `None`; in the plain integers of the
//! functions that end in `_into` it is [`NONE`].
//!
//! A [`Triangulation`] may be sent to another thread, and shared: what takes `&self` runs on many
//! threads at once.

mod domain;
mod error;
mod export;
mod keyed;
mod mesh;
mod names;
mod periodic;
mod triangulation;
mod voronoi;

pub use domain::{Domain, DomainArray, DomainPart, DomainStatistic};
pub use error::{Error, ErrorKind};
pub use export::{Circumsphere, Int, Location, PointLists, VertexTetrahedra};
pub use mesh::{
    Boundary, GivenPoints, Mesh, MeshArray, MeshDoubles, MeshStatistic, Reason, Refusal, ShapeSummary, SizesOf,
};
pub use names::{Check, Measure, Method, Order, Outside, Parameter, Separation, Statistic, TetrahedronMeasure};
pub use periodic::{Periodic, PeriodicArray, PeriodicStatistic};
pub use triangulation::{Canceller, Triangulation};
pub use voronoi::{Voronoi, VoronoiArray, VoronoiDoubles, VoronoiStatistic};

/// What stands for "none" among plain integers: the neighbour of a facet on the hull, the vertex of
/// a point that is not in, the tetrahedron of a point outside.
pub const NONE: i64 = -1;

/// Version of the library that is loaded, "1.2.0".
pub fn version() -> &'static str {
    names::text(unsafe { mgdt_sys::mgdt_version_string() }).unwrap_or("")
}
