// SPDX-License-Identifier: MIT
use crate::{Error, ErrorKind};
use mgdt_sys as sys;
use std::ffi::{CStr, CString};
use std::fmt;
use std::os::raw::c_char;
use std::str::FromStr;

/// A static string of the library's; None for NULL.
pub(crate) fn text(s: *const c_char) -> Option<&'static str> {
    if s.is_null() {
        return None;
    }
    // The library's strings are plain ASCII, and static.
    unsafe { CStr::from_ptr(s) }.to_str().ok()
}

/// In which order the points of one call are inserted. The tetrahedra do not depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum Order {
    /// What measures best; the default.
    Auto = sys::MGDT_ORDER_AUTO,
    /// As given.
    Input = sys::MGDT_ORDER_INPUT,
    /// Shuffled.
    Random = sys::MGDT_ORDER_RANDOM,
    /// By x, then y, then z.
    Lexicographic = sys::MGDT_ORDER_LEXICOGRAPHIC,
    /// Random rounds of growing size, each along a curve.
    Brio = sys::MGDT_ORDER_BRIO,
    /// Along a Hilbert curve.
    Hilbert = sys::MGDT_ORDER_HILBERT,
    /// Cell by cell of a regular grid.
    RegularGrid = sys::MGDT_ORDER_REGULAR_GRID,
    /// Leaves of a squarish kd-tree.
    KdTree = sys::MGDT_ORDER_KD_TREE,
    /// A kd-tree with a regular grid in each crowded leaf.
    EnhancedKdTree = sys::MGDT_ORDER_ENHANCED_KD_TREE,
    /// Regular grids within the crowded cells of grids.
    MultiGrid = sys::MGDT_ORDER_MULTI_GRID,
}

impl Order {
    /// All order schemes.
    pub const ALL: [Order; 10] = [
        Order::Auto,
        Order::Input,
        Order::Random,
        Order::Lexicographic,
        Order::Brio,
        Order::Hilbert,
        Order::RegularGrid,
        Order::KdTree,
        Order::EnhancedKdTree,
        Order::MultiGrid,
    ];

    /// The order schemes that the library has, the default first. Those of a later version than
    /// this crate's are left out.
    pub fn available() -> Vec<Order> {
        let at = |k| {
            let mut scheme = -1;
            let status = unsafe { sys::mgdt_order_scheme_at(k, &mut scheme) };
            if status == sys::MGDT_OK {
                Some(scheme)
            } else {
                None
            }
        };
        (0..)
            .map_while(at)
            .filter_map(|scheme| Order::ALL.into_iter().find(|&order| order as i32 == scheme))
            .collect()
    }

    /// The scheme's name, "multi-grid".
    pub fn name(self) -> &'static str {
        text(unsafe { sys::mgdt_order_scheme_name(self as i32) }).unwrap_or("")
    }
}

impl fmt::Display for Order {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Order {
    type Err = Error;

    fn from_str(name: &str) -> Result<Order, Error> {
        let mut scheme = -1;
        let known = CString::new(name).map_or(false, |s| unsafe {
            sys::mgdt_order_scheme_from_name(s.as_ptr(), &mut scheme) == sys::MGDT_OK
        });
        Order::ALL
            .iter()
            .copied()
            .find(|&order| known && order as i32 == scheme)
            .ok_or_else(|| {
                Error::new(
                    ErrorKind::UnknownScheme,
                    format!("there is no order scheme {:?}", name),
                )
            })
    }
}

/// Parameters of the order schemes. 0 gives a parameter its default back, except `Separation`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum Parameter {
    /// Mean number of points in a cell: 1 to 1e6.
    PointsPerCell = sys::MGDT_PARAMETER_POINTS_PER_CELL,
    /// Multi-grid: a cell with more points gets a grid of its own; 1 to 1e9, default 200.
    Threshold = sys::MGDT_PARAMETER_THRESHOLD,
    /// Regular grid and multi-grid: how points of a cell are kept apart, a [`Separation`].
    Separation = sys::MGDT_PARAMETER_SEPARATION,
    /// BRIO: size of each round against all before it; above 1 to 1e6, default 7.5.
    RoundRatio = sys::MGDT_PARAMETER_ROUND_RATIO,
}

/// How points of a cell are kept apart: values of [`Parameter::Separation`]. Since 1.2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum Separation {
    /// A cell is emptied before the next one.
    None = sys::MGDT_SEPARATION_NONE,
    /// One point from each cell at a time.
    Passes = sys::MGDT_SEPARATION_PASSES,
    /// Points along the path through the cells are dealt into rounds; the default.
    Rounds = sys::MGDT_SEPARATION_ROUNDS,
}

impl From<Separation> for f64 {
    fn from(separation: Separation) -> f64 {
        f64::from(separation as i32)
    }
}

/// How far [`check`](crate::Triangulation::check) goes. Each level includes those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(i32)]
pub enum Check {
    /// Adjacency, shared facets, Euler's formula, every point accounted for.
    Combinatorial = sys::MGDT_CHECK_COMBINATORIAL,
    /// Exact positive orientation, exact local Delaunay property.
    Geometric = sys::MGDT_CHECK_GEOMETRIC,
    /// Convex hull, and ties broken by the perturbation.
    Canonical = sys::MGDT_CHECK_CANONICAL,
}

/// What [`tetrahedron_measures`](crate::Triangulation::tetrahedron_measures) measures. Since 1.3.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum TetrahedronMeasure {
    /// Volume.
    Volume = sys::MGDT_TETRAHEDRON_VOLUME,
    /// 3 times the radius of the inscribed sphere over that of the circumsphere: 1 if regular.
    RadiusRatio = sys::MGDT_TETRAHEDRON_RADIUS_RATIO,
    /// Least dihedral angle, in radians.
    LeastDihedralAngle = sys::MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE,
    /// Largest dihedral angle, in radians.
    LargestDihedralAngle = sys::MGDT_TETRAHEDRON_LARGEST_DIHEDRAL_ANGLE,
    /// Length of the longest edge.
    LongestEdge = sys::MGDT_TETRAHEDRON_LONGEST_EDGE,
    /// 6 sqrt(2) times the volume over the third power of the root mean square of the edges. Since 1.4.
    VolumeLength = sys::MGDT_TETRAHEDRON_VOLUME_LENGTH,
    /// Length of the longest edge over that of the shortest one. Since 1.4.
    EdgeRatio = sys::MGDT_TETRAHEDRON_EDGE_RATIO,
}

/// What [`cell_measures`](crate::Triangulation::cell_measures) measures of a Voronoi cell. Since 1.2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum Measure {
    /// Volume.
    Volume = sys::MGDT_MEASURE_VOLUME,
    /// Area of the surface.
    Area = sys::MGDT_MEASURE_AREA,
    /// Centre of mass.
    Centroid = sys::MGDT_MEASURE_CENTROID,
    /// Number of faces that have an area.
    Faces = sys::MGDT_MEASURE_FACES,
}

/// How a value between points is made. Since 1.2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum Method {
    /// Linear in each tetrahedron: continuous.
    Linear = sys::MGDT_INTERPOLATE_LINEAR,
    /// The value of the nearest vertex.
    Nearest = sys::MGDT_INTERPOLATE_NEAREST,
    /// By natural neighbours: each weighs what its Voronoi cell would lose.
    Sibson = sys::MGDT_INTERPOLATE_SIBSON,
    /// By natural neighbours: areas of faces over distances.
    Laplace = sys::MGDT_INTERPOLATE_LAPLACE,
    /// Sibson's with gradients: smooth at the points too.
    SibsonC1 = sys::MGDT_INTERPOLATE_SIBSON_C1,
}

/// What a value outside the hull is. Since 1.2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum Outside {
    /// NaN, and no weights.
    None = sys::MGDT_OUTSIDE_NONE,
    /// That of the nearest vertex.
    Nearest = sys::MGDT_OUTSIDE_NEAREST,
    /// That of the nearest place of the hull, linear in its facet.
    Boundary = sys::MGDT_OUTSIDE_BOUNDARY,
    /// The same, and on with the gradient there.
    Linear = sys::MGDT_OUTSIDE_LINEAR,
}

/// Figures about a triangulation, of its whole life.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum Statistic {
    /// Points that became vertices.
    PointsInserted = sys::MGDT_STAT_POINTS_INSERTED,
    /// Points equal to an earlier vertex.
    Duplicates = sys::MGDT_STAT_DUPLICATES,
    /// Points taken out. Since 1.2.
    PointsRemoved = sys::MGDT_STAT_POINTS_REMOVED,
    /// Moves to other coordinates. Since 1.2.
    PointsMoved = sys::MGDT_STAT_POINTS_MOVED,
    /// Moves that were a removal and an insertion. Since 1.2.
    PutBack = sys::MGDT_STAT_PUT_BACK,
    /// Removals and moves that triangulated anew. Since 1.2.
    Rebuilds = sys::MGDT_STAT_REBUILDS,
    /// Tetrahedra visited by walks.
    WalkSteps = sys::MGDT_STAT_WALK_STEPS,
    /// Circumspheres evaluated by walks.
    WalkTests = sys::MGDT_STAT_WALK_TESTS,
    /// Circumspheres evaluated while cavities grew.
    ConflictTests = sys::MGDT_STAT_CONFLICT_TESTS,
    /// Tetrahedra removed by insertions.
    TetrahedraRemoved = sys::MGDT_STAT_TETRAHEDRA_REMOVED,
    /// Tetrahedra created by insertions.
    TetrahedraCreated = sys::MGDT_STAT_TETRAHEDRA_CREATED,
    /// Vertices around those that removals and moves took out. Since 1.2.
    LinkVertices = sys::MGDT_STAT_LINK_VERTICES,
    /// Decisions that the floating-point filter left open.
    ExactCalls = sys::MGDT_STAT_EXACT_CALLS,
    /// Insertions that met another thread, and were tried again.
    PutOff = sys::MGDT_STAT_PUT_OFF,
    /// Points inserted while other threads had no work.
    InsertedAlone = sys::MGDT_STAT_INSERTED_ALONE,
    /// Wall-clock seconds spent on schedules.
    OrderSeconds = sys::MGDT_STAT_ORDER_SECONDS,
    /// Wall-clock seconds spent inserting.
    InsertSeconds = sys::MGDT_STAT_INSERT_SECONDS,
    /// Wall-clock seconds spent removing points. Since 1.2.
    RemoveSeconds = sys::MGDT_STAT_REMOVE_SECONDS,
    /// Wall-clock seconds spent moving points. Since 1.2.
    MoveSeconds = sys::MGDT_STAT_MOVE_SECONDS,
    /// Deepest level of grids or trees in the last schedule.
    GridLevels = sys::MGDT_STAT_GRID_LEVELS,
    /// Rounds in the last schedule.
    Rounds = sys::MGDT_STAT_ROUNDS,
    /// Threads of the last insertion.
    Threads = sys::MGDT_STAT_THREADS,
    /// Bytes held now.
    MemoryBytes = sys::MGDT_STAT_MEMORY_BYTES,
    /// The most bytes held so far.
    PeakMemoryBytes = sys::MGDT_STAT_PEAK_MEMORY_BYTES,
}

impl Statistic {
    /// All statistics.
    pub const ALL: [Statistic; 24] = [
        Statistic::PointsInserted,
        Statistic::Duplicates,
        Statistic::PointsRemoved,
        Statistic::PointsMoved,
        Statistic::PutBack,
        Statistic::Rebuilds,
        Statistic::WalkSteps,
        Statistic::WalkTests,
        Statistic::ConflictTests,
        Statistic::TetrahedraRemoved,
        Statistic::TetrahedraCreated,
        Statistic::LinkVertices,
        Statistic::ExactCalls,
        Statistic::PutOff,
        Statistic::InsertedAlone,
        Statistic::OrderSeconds,
        Statistic::InsertSeconds,
        Statistic::RemoveSeconds,
        Statistic::MoveSeconds,
        Statistic::GridLevels,
        Statistic::Rounds,
        Statistic::Threads,
        Statistic::MemoryBytes,
        Statistic::PeakMemoryBytes,
    ];

    /// The statistic's name, "walk steps".
    pub fn name(self) -> &'static str {
        text(unsafe { sys::mgdt_stat_name(self as i32) }).unwrap_or("")
    }
}

impl fmt::Display for Statistic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
