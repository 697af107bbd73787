// SPDX-License-Identifier: MIT
// Generated from the headers of mgdt by bindings/interface/generate.py.
//! The C interface of mgdt as it is. Its manuals are the headers `mgdt/mgdt.h`,
//! `mgdt/mgdt_voronoi.h`, `mgdt/mgdt_domain.h`, `mgdt/mgdt_mesh.h` and `mgdt/mgdt_periodic.h`; the crate `mgdt` is the safe interface.
#![allow(non_camel_case_types)]

use std::marker::{PhantomData, PhantomPinned};
use std::os::raw::{c_char, c_void};

pub type mgdt_status = i32;

/// A triangulation; only ever behind a pointer.
#[repr(C)]
pub struct mgdt_triangulation {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A Voronoi diagram; only ever behind a pointer.
#[repr(C)]
pub struct mgdt_voronoi {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A mesh of tetrahedra; only ever behind a pointer.
#[repr(C)]
pub struct mgdt_mesh {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// A domain; only ever behind a pointer.
#[repr(C)]
pub struct mgdt_domain {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

/// Points in a periodic box; only ever behind a pointer.
#[repr(C)]
pub struct mgdt_periodic {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}

pub const MGDT_OK: mgdt_status = 0;
pub const MGDT_ERR_NULL_POINTER: mgdt_status = 10;
pub const MGDT_ERR_INVALID_ARGUMENT: mgdt_status = 11;
pub const MGDT_ERR_NOT_FINITE: mgdt_status = 12;
pub const MGDT_ERR_UNKNOWN_SCHEME: mgdt_status = 13;
pub const MGDT_ERR_UNKNOWN_KEY: mgdt_status = 14;
pub const MGDT_ERR_NOT_BUILT: mgdt_status = 15;
pub const MGDT_ERR_BUFFER_TOO_SMALL: mgdt_status = 20;
pub const MGDT_ERR_INDEX_RANGE: mgdt_status = 21;
pub const MGDT_ERR_OUT_OF_MEMORY: mgdt_status = 30;
pub const MGDT_ERR_TOO_LARGE: mgdt_status = 31;
pub const MGDT_ERR_CANCELLED: mgdt_status = 40;
pub const MGDT_ERR_BUSY: mgdt_status = 41;
pub const MGDT_ERR_TRANSPORT: mgdt_status = 50;
pub const MGDT_ERR_CHECK_FAILED: mgdt_status = 60;
pub const MGDT_ERR_INVALID_BOUNDARY: mgdt_status = 70;
pub const MGDT_ERR_RESOLUTION: mgdt_status = 71;
pub const MGDT_ERR_OPEN_BOUNDARY: mgdt_status = 72;
pub const MGDT_ERR_INTERNAL: mgdt_status = 90;

pub const MGDT_ORDER_AUTO: i32 = 0;
pub const MGDT_ORDER_INPUT: i32 = 10;
pub const MGDT_ORDER_RANDOM: i32 = 20;
pub const MGDT_ORDER_LEXICOGRAPHIC: i32 = 30;
pub const MGDT_ORDER_BRIO: i32 = 40;
pub const MGDT_ORDER_HILBERT: i32 = 50;
pub const MGDT_ORDER_REGULAR_GRID: i32 = 60;
pub const MGDT_ORDER_KD_TREE: i32 = 70;
pub const MGDT_ORDER_ENHANCED_KD_TREE: i32 = 80;
pub const MGDT_ORDER_MULTI_GRID: i32 = 90;

pub const MGDT_PARAMETER_POINTS_PER_CELL: i32 = 10;
pub const MGDT_PARAMETER_THRESHOLD: i32 = 20;
pub const MGDT_PARAMETER_SEPARATION: i32 = 30;
pub const MGDT_PARAMETER_ROUND_RATIO: i32 = 40;

pub const MGDT_SEPARATION_NONE: i32 = 0;
pub const MGDT_SEPARATION_PASSES: i32 = 1;
pub const MGDT_SEPARATION_ROUNDS: i32 = 2;

pub const MGDT_STAT_POINTS_INSERTED: i32 = 10;
pub const MGDT_STAT_DUPLICATES: i32 = 11;
pub const MGDT_STAT_POINTS_REMOVED: i32 = 12;
pub const MGDT_STAT_POINTS_MOVED: i32 = 13;
pub const MGDT_STAT_PUT_BACK: i32 = 14;
pub const MGDT_STAT_REBUILDS: i32 = 15;
pub const MGDT_STAT_WALK_STEPS: i32 = 20;
pub const MGDT_STAT_WALK_TESTS: i32 = 21;
pub const MGDT_STAT_CONFLICT_TESTS: i32 = 22;
pub const MGDT_STAT_TETRAHEDRA_REMOVED: i32 = 30;
pub const MGDT_STAT_TETRAHEDRA_CREATED: i32 = 31;
pub const MGDT_STAT_LINK_VERTICES: i32 = 32;
pub const MGDT_STAT_EXACT_CALLS: i32 = 40;
pub const MGDT_STAT_PUT_OFF: i32 = 45;
pub const MGDT_STAT_INSERTED_ALONE: i32 = 46;
pub const MGDT_STAT_ORDER_SECONDS: i32 = 50;
pub const MGDT_STAT_INSERT_SECONDS: i32 = 51;
pub const MGDT_STAT_REMOVE_SECONDS: i32 = 52;
pub const MGDT_STAT_MOVE_SECONDS: i32 = 53;
pub const MGDT_STAT_GRID_LEVELS: i32 = 60;
pub const MGDT_STAT_ROUNDS: i32 = 61;
pub const MGDT_STAT_THREADS: i32 = 62;
pub const MGDT_STAT_MEMORY_BYTES: i32 = 70;
pub const MGDT_STAT_PEAK_MEMORY_BYTES: i32 = 71;

pub const MGDT_CHECK_COMBINATORIAL: i32 = 1;
pub const MGDT_CHECK_GEOMETRIC: i32 = 2;
pub const MGDT_CHECK_CANONICAL: i32 = 3;

pub const MGDT_MEASURE_VOLUME: i32 = 10;
pub const MGDT_MEASURE_AREA: i32 = 20;
pub const MGDT_MEASURE_CENTROID: i32 = 30;
pub const MGDT_MEASURE_FACES: i32 = 40;

pub const MGDT_TETRAHEDRON_VOLUME: i32 = 10;
pub const MGDT_TETRAHEDRON_RADIUS_RATIO: i32 = 20;
pub const MGDT_TETRAHEDRON_VOLUME_LENGTH: i32 = 21;
pub const MGDT_TETRAHEDRON_EDGE_RATIO: i32 = 22;
pub const MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE: i32 = 30;
pub const MGDT_TETRAHEDRON_LARGEST_DIHEDRAL_ANGLE: i32 = 31;
pub const MGDT_TETRAHEDRON_LONGEST_EDGE: i32 = 40;

pub const MGDT_INTERPOLATE_LINEAR: i32 = 10;
pub const MGDT_INTERPOLATE_NEAREST: i32 = 20;
pub const MGDT_INTERPOLATE_SIBSON: i32 = 30;
pub const MGDT_INTERPOLATE_LAPLACE: i32 = 40;
pub const MGDT_INTERPOLATE_SIBSON_C1: i32 = 50;

pub const MGDT_OUTSIDE_NONE: i32 = 10;
pub const MGDT_OUTSIDE_NEAREST: i32 = 20;
pub const MGDT_OUTSIDE_BOUNDARY: i32 = 30;
pub const MGDT_OUTSIDE_LINEAR: i32 = 40;

pub const MGDT_VORONOI_STAT_VERTICES: i32 = 100;
pub const MGDT_VORONOI_STAT_RAYS: i32 = 101;
pub const MGDT_VORONOI_STAT_FACES: i32 = 102;
pub const MGDT_VORONOI_STAT_POINTS: i32 = 103;
pub const MGDT_VORONOI_STAT_MEMORY_BYTES: i32 = 110;

pub const MGDT_VORONOI_ARRAY_FACE_OFFSETS: i32 = 200;
pub const MGDT_VORONOI_ARRAY_FACE_CORNERS: i32 = 201;
pub const MGDT_VORONOI_ARRAY_FACE_SIDES: i32 = 202;
pub const MGDT_VORONOI_ARRAY_FACE_SHIFTS: i32 = 203;
pub const MGDT_VORONOI_ARRAY_RAY_VERTICES: i32 = 210;
pub const MGDT_VORONOI_ARRAY_CELL_OFFSETS: i32 = 220;
pub const MGDT_VORONOI_ARRAY_CELL_FACES: i32 = 221;
pub const MGDT_VORONOI_ARRAY_CELL_BOUNDED: i32 = 222;
pub const MGDT_VORONOI_ARRAY_CELL_NEIGHBORS: i32 = 223;
pub const MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_SHIFTS: i32 = 224;
pub const MGDT_VORONOI_ARRAY_VERTICES: i32 = 300;
pub const MGDT_VORONOI_ARRAY_RAY_DIRECTIONS: i32 = 310;
pub const MGDT_VORONOI_ARRAY_FACE_AREAS: i32 = 320;
pub const MGDT_VORONOI_ARRAY_FACE_NORMALS: i32 = 321;
pub const MGDT_VORONOI_ARRAY_FACE_CENTROIDS: i32 = 322;
pub const MGDT_VORONOI_ARRAY_CELL_VOLUMES: i32 = 330;
pub const MGDT_VORONOI_ARRAY_CELL_CENTROIDS: i32 = 331;
pub const MGDT_VORONOI_ARRAY_CELL_FACE_AREAS: i32 = 332;
pub const MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES: i32 = 333;

pub const MGDT_MESH_OPTION_INDEX_BASE: i32 = 10;
pub const MGDT_MESH_OPTION_THREADS: i32 = 20;
pub const MGDT_MESH_OPTION_MEMORY_LIMIT: i32 = 30;
pub const MGDT_MESH_OPTION_GOAL: i32 = 40;
pub const MGDT_MESH_OPTION_BOUNDARY: i32 = 41;
pub const MGDT_MESH_OPTION_POINTS: i32 = 42;
pub const MGDT_MESH_OPTION_MEAN_PASSES: i32 = 43;
pub const MGDT_MESH_OPTION_MOST_PASSES: i32 = 44;
pub const MGDT_MESH_OPTION_MOST_POINTS: i32 = 45;
pub const MGDT_MESH_OPTION_SIZES_OF_SURFACE: i32 = 46;
pub const MGDT_MESH_OPTION_SIZE: i32 = 61;
pub const MGDT_MESH_OPTION_GRADATION: i32 = 62;
pub const MGDT_MESH_OPTION_RADIUS_EDGE: i32 = 63;
pub const MGDT_MESH_OPTION_VOLUME: i32 = 64;

pub const MGDT_SIZES_OF_POINTS: i32 = 0;
pub const MGDT_SIZES_OF_TETRAHEDRA: i32 = 1;
pub const MGDT_SIZES_OF_REGIONS: i32 = 2;

pub const MGDT_BOUNDARY_FIXED: i32 = 0;
pub const MGDT_BOUNDARY_SLIDE: i32 = 1;

pub const MGDT_POINTS_KEEP: i32 = 0;
pub const MGDT_POINTS_MOVE: i32 = 1;
pub const MGDT_POINTS_REMOVE: i32 = 2;

pub const MGDT_MESH_STAT_POINTS: i32 = 100;
pub const MGDT_MESH_STAT_STEINER_POINTS: i32 = 101;
pub const MGDT_MESH_STAT_TETRAHEDRA: i32 = 102;
pub const MGDT_MESH_STAT_REGIONS: i32 = 103;
pub const MGDT_MESH_STAT_FACES: i32 = 104;
pub const MGDT_MESH_STAT_EDGES: i32 = 105;
pub const MGDT_MESH_STAT_MEMORY_BYTES: i32 = 110;
pub const MGDT_MESH_STAT_IS_ROUNDED: i32 = 120;
pub const MGDT_MESH_STAT_IS_DELAUNAY: i32 = 122;
pub const MGDT_MESH_STAT_IS_OF_DOMAIN: i32 = 123;
pub const MGDT_MESH_STAT_KEEPS_BOUNDARY: i32 = 124;
pub const MGDT_MESH_STAT_GRID_BITS: i32 = 121;
pub const MGDT_MESH_STAT_UNUSED_POINTS: i32 = 130;
pub const MGDT_MESH_STAT_UNUSED_FACES: i32 = 131;
pub const MGDT_MESH_STAT_UNUSED_REGIONS: i32 = 132;
pub const MGDT_MESH_STAT_UNUSED_HOLES: i32 = 133;
pub const MGDT_MESH_STAT_PLANAR_FACETS: i32 = 140;
pub const MGDT_MESH_STAT_MISSING_FACETS: i32 = 141;
pub const MGDT_MESH_STAT_CAVITIES: i32 = 142;
pub const MGDT_MESH_STAT_LARGEST_CAVITY: i32 = 143;
pub const MGDT_MESH_STAT_BELOW_GOAL: i32 = 150;
pub const MGDT_MESH_STAT_PASSES: i32 = 151;
pub const MGDT_MESH_STAT_MOVED_POINTS: i32 = 152;
pub const MGDT_MESH_STAT_REMOVED_POINTS: i32 = 153;
pub const MGDT_MESH_STAT_INSERTED_POINTS: i32 = 160;
pub const MGDT_MESH_STAT_REFUSED: i32 = 161;

pub const MGDT_REFUSAL_NONE: i32 = 0;
pub const MGDT_REFUSAL_HIDDEN: i32 = 1;
pub const MGDT_REFUSAL_NEAR_POINT: i32 = 2;
pub const MGDT_REFUSAL_NEAR_FACET: i32 = 3;
pub const MGDT_REFUSAL_NO_CAVITY: i32 = 4;
pub const MGDT_REFUSAL_MOST_POINTS: i32 = 5;

pub const MGDT_REASON_NONE: i32 = 0;
pub const MGDT_REASON_INPUT_ANGLE: i32 = 1;
pub const MGDT_REASON_THIN_FACE: i32 = 2;
pub const MGDT_REASON_FIXED_CORNERS: i32 = 3;
pub const MGDT_REASON_OTHER: i32 = 4;

pub const MGDT_MESH_ARRAY_POINT_ORIGINS: i32 = 200;
pub const MGDT_MESH_ARRAY_TETRAHEDRA: i32 = 210;
pub const MGDT_MESH_ARRAY_NEIGHBORS: i32 = 211;
pub const MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS: i32 = 212;
pub const MGDT_MESH_ARRAY_REGION_MARKERS: i32 = 220;
pub const MGDT_MESH_ARRAY_FACES: i32 = 230;
pub const MGDT_MESH_ARRAY_FACE_TETRAHEDRA: i32 = 231;
pub const MGDT_MESH_ARRAY_FACE_FACETS: i32 = 232;
pub const MGDT_MESH_ARRAY_FACE_MARKERS: i32 = 233;
pub const MGDT_MESH_ARRAY_EDGES: i32 = 240;
pub const MGDT_MESH_ARRAY_EDGE_SEGMENTS: i32 = 241;
pub const MGDT_MESH_ARRAY_EDGE_MARKERS: i32 = 242;
pub const MGDT_MESH_ARRAY_STEINER_EDGES: i32 = 250;
pub const MGDT_MESH_ARRAY_REASONS: i32 = 260;
pub const MGDT_MESH_ARRAY_ANGLE_HISTOGRAM: i32 = 261;
pub const MGDT_MESH_ARRAY_TETRAHEDRA_BELOW: i32 = 262;
pub const MGDT_MESH_ARRAY_REFUSALS: i32 = 270;
pub const MGDT_MESH_ARRAY_POINTS: i32 = 300;
pub const MGDT_MESH_ARRAY_STEINER_PARAMETERS: i32 = 310;
pub const MGDT_MESH_ARRAY_SHAPES: i32 = 320;
pub const MGDT_MESH_ARRAY_SIZES: i32 = 330;

pub const MGDT_DOMAIN_KIND_FACET: i32 = 0;
pub const MGDT_DOMAIN_KIND_SEGMENT: i32 = 1;
pub const MGDT_DOMAIN_KIND_POINT: i32 = 2;

pub const MGDT_DOMAIN_OPTION_INDEX_BASE: i32 = 10;
pub const MGDT_DOMAIN_OPTION_THREADS: i32 = 20;
pub const MGDT_DOMAIN_OPTION_MEMORY_LIMIT: i32 = 30;
pub const MGDT_DOMAIN_OPTION_ROUND_POINTS: i32 = 40;
pub const MGDT_DOMAIN_OPTION_STRICT: i32 = 50;
pub const MGDT_DOMAIN_OPTION_KEEP_BOUNDARY: i32 = 60;
pub const MGDT_DOMAIN_OPTION_WELD: i32 = 70;
pub const MGDT_DOMAIN_OPTION_FLATNESS: i32 = 80;

pub const MGDT_DOMAIN_STAT_POINTS: i32 = 100;
pub const MGDT_DOMAIN_STAT_FACETS: i32 = 101;
pub const MGDT_DOMAIN_STAT_SEGMENTS: i32 = 102;
pub const MGDT_DOMAIN_STAT_REGIONS: i32 = 103;
pub const MGDT_DOMAIN_STAT_HOLES: i32 = 104;
pub const MGDT_DOMAIN_STAT_MEMORY_BYTES: i32 = 110;
pub const MGDT_DOMAIN_STAT_OFFENDING_PAIRS: i32 = 120;
pub const MGDT_DOMAIN_STAT_OPEN_EDGES: i32 = 121;
pub const MGDT_DOMAIN_STAT_MOVED_POINTS: i32 = 130;
pub const MGDT_DOMAIN_STAT_REPEATED_CORNERS: i32 = 131;
pub const MGDT_DOMAIN_STAT_COLLAPSED_FACETS: i32 = 132;
pub const MGDT_DOMAIN_STAT_COVERED_FACETS: i32 = 133;
pub const MGDT_DOMAIN_STAT_POINTS_IN_EDGES: i32 = 134;
pub const MGDT_DOMAIN_STAT_POINTS_IN_FACETS: i32 = 135;
pub const MGDT_DOMAIN_STAT_EDGES_IN_FACETS: i32 = 136;
pub const MGDT_DOMAIN_STAT_EXCHANGED_EDGES: i32 = 137;

pub const MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS: i32 = 200;
pub const MGDT_DOMAIN_ARRAY_OPEN_EDGES: i32 = 210;
pub const MGDT_DOMAIN_ARRAY_FACET_OFFSETS: i32 = 220;
pub const MGDT_DOMAIN_ARRAY_FACET_CORNERS: i32 = 221;
pub const MGDT_DOMAIN_ARRAY_FACET_MARKERS: i32 = 222;
pub const MGDT_DOMAIN_ARRAY_FACET_ORIGINS: i32 = 223;
pub const MGDT_DOMAIN_ARRAY_COVERED_FACETS: i32 = 224;
pub const MGDT_DOMAIN_ARRAY_SEGMENTS: i32 = 230;
pub const MGDT_DOMAIN_ARRAY_SEGMENT_MARKERS: i32 = 231;
pub const MGDT_DOMAIN_ARRAY_SEGMENT_ORIGINS: i32 = 232;
pub const MGDT_DOMAIN_ARRAY_POINTS: i32 = 300;

pub const MGDT_PERIODIC_OPTION_INDEX_BASE: i32 = 10;
pub const MGDT_PERIODIC_OPTION_THREADS: i32 = 20;
pub const MGDT_PERIODIC_OPTION_MEMORY_LIMIT: i32 = 30;

pub const MGDT_PERIODIC_STAT_POINTS: i32 = 100;
pub const MGDT_PERIODIC_STAT_VERTICES: i32 = 101;
pub const MGDT_PERIODIC_STAT_TETRAHEDRA: i32 = 102;
pub const MGDT_PERIODIC_STAT_EDGES: i32 = 103;
pub const MGDT_PERIODIC_STAT_DIMENSIONS: i32 = 104;
pub const MGDT_PERIODIC_STAT_MEMORY_BYTES: i32 = 110;
pub const MGDT_PERIODIC_STAT_IMAGES: i32 = 120;
pub const MGDT_PERIODIC_STAT_ROUNDS: i32 = 121;

pub const MGDT_PERIODIC_ARRAY_POINT_MAP: i32 = 200;
pub const MGDT_PERIODIC_ARRAY_POINT_SHIFTS: i32 = 201;
pub const MGDT_PERIODIC_ARRAY_TETRAHEDRA: i32 = 210;
pub const MGDT_PERIODIC_ARRAY_TETRAHEDRON_SHIFTS: i32 = 211;
pub const MGDT_PERIODIC_ARRAY_NEIGHBORS: i32 = 212;
pub const MGDT_PERIODIC_ARRAY_NEIGHBOR_SHIFTS: i32 = 213;
pub const MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS: i32 = 220;
pub const MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS: i32 = 221;
pub const MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_SHIFTS: i32 = 222;
pub const MGDT_PERIODIC_ARRAY_POINTS: i32 = 300;
pub const MGDT_PERIODIC_ARRAY_VECTORS: i32 = 301;

pub type mgdt_alloc_fn =
    Option<unsafe extern "C" fn(size: usize, align: usize, user: *mut c_void) -> *mut c_void>;
pub type mgdt_free_fn =
    Option<unsafe extern "C" fn(p: *mut c_void, size: usize, align: usize, user: *mut c_void)>;
pub type mgdt_progress_fn = Option<unsafe extern "C" fn(fraction: f64, user: *mut c_void) -> i32>;
pub type mgdt_size_fn =
    Option<unsafe extern "C" fn(n: i64, xyz: *const f64, sizes: *mut f64, user: *mut c_void) -> i32>;

extern "C" {
    pub fn mgdt_create(out: *mut *mut mgdt_triangulation) -> mgdt_status;
    pub fn mgdt_create_with_allocator(
        alloc: mgdt_alloc_fn,
        release: mgdt_free_fn,
        user: *mut c_void,
        out: *mut *mut mgdt_triangulation,
    ) -> mgdt_status;
    pub fn mgdt_destroy(t: *mut mgdt_triangulation);
    pub fn mgdt_clear(t: *mut mgdt_triangulation) -> mgdt_status;
    pub fn mgdt_reserve(t: *mut mgdt_triangulation, n_points: i64) -> mgdt_status;
    pub fn mgdt_shrink(t: *mut mgdt_triangulation) -> mgdt_status;
    pub fn mgdt_set_order_scheme(t: *mut mgdt_triangulation, scheme: i32) -> mgdt_status;
    pub fn mgdt_get_order_scheme(t: *const mgdt_triangulation, scheme: *mut i32) -> mgdt_status;
    pub fn mgdt_set_order_parameter(
        t: *mut mgdt_triangulation,
        key: i32,
        value: f64,
    ) -> mgdt_status;
    pub fn mgdt_get_order_parameter(
        t: *const mgdt_triangulation,
        key: i32,
        value: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_set_seed(t: *mut mgdt_triangulation, seed: u64) -> mgdt_status;
    pub fn mgdt_get_seed(t: *const mgdt_triangulation, seed: *mut u64) -> mgdt_status;
    pub fn mgdt_set_threads(t: *mut mgdt_triangulation, n: i32) -> mgdt_status;
    pub fn mgdt_get_threads(t: *const mgdt_triangulation, n: *mut i32) -> mgdt_status;
    pub fn mgdt_set_index_base(t: *mut mgdt_triangulation, base: i32) -> mgdt_status;
    pub fn mgdt_get_index_base(t: *const mgdt_triangulation, base: *mut i32) -> mgdt_status;
    pub fn mgdt_set_memory_limit(t: *mut mgdt_triangulation, bytes: i64) -> mgdt_status;
    pub fn mgdt_get_memory_limit(t: *const mgdt_triangulation, bytes: *mut i64) -> mgdt_status;
    pub fn mgdt_set_compact(t: *mut mgdt_triangulation, on: i32) -> mgdt_status;
    pub fn mgdt_get_compact(t: *const mgdt_triangulation, on: *mut i32) -> mgdt_status;
    pub fn mgdt_set_progress(
        t: *mut mgdt_triangulation,
        callback: mgdt_progress_fn,
        user: *mut c_void,
    ) -> mgdt_status;
    pub fn mgdt_get_progress(
        t: *const mgdt_triangulation,
        callback: *mut mgdt_progress_fn,
        user: *mut *mut c_void,
    ) -> mgdt_status;
    pub fn mgdt_cancel(t: *mut mgdt_triangulation) -> mgdt_status;
    pub fn mgdt_set_read_progress(t: *mut mgdt_triangulation, on: i32) -> mgdt_status;
    pub fn mgdt_get_read_progress(t: *const mgdt_triangulation, on: *mut i32) -> mgdt_status;
    pub fn mgdt_set_canonical_output(t: *mut mgdt_triangulation, on: i32) -> mgdt_status;
    pub fn mgdt_get_canonical_output(t: *const mgdt_triangulation, on: *mut i32) -> mgdt_status;
    pub fn mgdt_set_isa(t: *mut mgdt_triangulation, name: *const c_char) -> mgdt_status;
    pub fn mgdt_insert_points(t: *mut mgdt_triangulation, n: i64, xyz: *const f64) -> mgdt_status;
    pub fn mgdt_insert_points_strided(
        t: *mut mgdt_triangulation,
        n: i64,
        x: *const f64,
        y: *const f64,
        z: *const f64,
        stride: i64,
    ) -> mgdt_status;
    pub fn mgdt_remove_points(
        t: *mut mgdt_triangulation,
        n: i64,
        points: *const i64,
    ) -> mgdt_status;
    pub fn mgdt_remove_points_i32(
        t: *mut mgdt_triangulation,
        n: i64,
        points: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_move_points(
        t: *mut mgdt_triangulation,
        n: i64,
        points: *const i64,
        xyz: *const f64,
    ) -> mgdt_status;
    pub fn mgdt_move_points_i32(
        t: *mut mgdt_triangulation,
        n: i64,
        points: *const i32,
        xyz: *const f64,
    ) -> mgdt_status;
    pub fn mgdt_renumber_points(
        t: *mut mgdt_triangulation,
        capacity: i64,
        new_index: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_renumber_points_i32(
        t: *mut mgdt_triangulation,
        capacity: i64,
        new_index: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_point_count(t: *const mgdt_triangulation) -> i64;
    pub fn mgdt_vertex_count(t: *const mgdt_triangulation) -> i64;
    pub fn mgdt_dimension(t: *const mgdt_triangulation) -> i32;
    pub fn mgdt_tetrahedron_count(t: *const mgdt_triangulation) -> i64;
    pub fn mgdt_hull_facet_count(t: *const mgdt_triangulation) -> i64;
    pub fn mgdt_edge_count(t: *const mgdt_triangulation) -> i64;
    pub fn mgdt_vertex_tetrahedra_count(t: *const mgdt_triangulation) -> i64;
    pub fn mgdt_vertex_neighbors_count(t: *const mgdt_triangulation) -> i64;
    pub fn mgdt_get_tetrahedra(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_get_tetrahedra_i32(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_get_neighbors(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_get_neighbors_i32(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_get_hull_facets(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_get_hull_facets_i32(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_get_edges(t: *const mgdt_triangulation, capacity: i64, v: *mut i64) -> mgdt_status;
    pub fn mgdt_get_edges_i32(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_get_point_map(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_get_point_map_i32(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_get_vertex_tetrahedra(
        t: *const mgdt_triangulation,
        offset_capacity: i64,
        offsets: *mut i64,
        capacity: i64,
        list: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_get_vertex_tetrahedra_i32(
        t: *const mgdt_triangulation,
        offset_capacity: i64,
        offsets: *mut i32,
        capacity: i64,
        list: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_get_vertex_neighbors(
        t: *const mgdt_triangulation,
        offset_capacity: i64,
        offsets: *mut i64,
        capacity: i64,
        list: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_get_vertex_neighbors_i32(
        t: *const mgdt_triangulation,
        offset_capacity: i64,
        offsets: *mut i32,
        capacity: i64,
        list: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_get_gabriel_edges(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i64,
        count: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_get_gabriel_edges_i32(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i32,
        count: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_get_spanning_tree(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i64,
        count: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_get_spanning_tree_i32(
        t: *const mgdt_triangulation,
        capacity: i64,
        v: *mut i32,
        count: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_get_circumcenters(
        t: *const mgdt_triangulation,
        capacity: i64,
        xyz: *mut f64,
        radius2: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_get_tetrahedron_measures(
        t: *const mgdt_triangulation,
        measure: i32,
        capacity: i64,
        x: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_get_cell_measures(
        t: *const mgdt_triangulation,
        measure: i32,
        n_planes: i64,
        planes: *const f64,
        capacity: i64,
        x: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_get_alphas(
        t: *const mgdt_triangulation,
        dimension: i32,
        capacity: i64,
        alpha2: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_get_alpha_surface(
        t: *const mgdt_triangulation,
        alpha2: f64,
        capacity: i64,
        v: *mut i64,
        count: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_get_alpha_surface_i32(
        t: *const mgdt_triangulation,
        alpha2: f64,
        capacity: i64,
        v: *mut i32,
        count: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_get_solid_alpha(t: *const mgdt_triangulation, alpha2: *mut f64) -> mgdt_status;
    pub fn mgdt_locate(
        t: *const mgdt_triangulation,
        xyz: *const f64,
        tetrahedron: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_locate_i32(
        t: *const mgdt_triangulation,
        xyz: *const f64,
        tetrahedron: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_locate_points(
        t: *const mgdt_triangulation,
        n: i64,
        xyz: *const f64,
        tetrahedra: *mut i64,
        weights: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_locate_points_i32(
        t: *const mgdt_triangulation,
        n: i64,
        xyz: *const f64,
        tetrahedra: *mut i32,
        weights: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_traverse_segment(
        t: *const mgdt_triangulation,
        a: *const f64,
        b: *const f64,
        capacity: i64,
        tetrahedra: *mut i64,
        parameters: *mut f64,
        count: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_traverse_segment_i32(
        t: *const mgdt_triangulation,
        a: *const f64,
        b: *const f64,
        capacity: i64,
        tetrahedra: *mut i32,
        parameters: *mut f64,
        count: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_nearest_vertex(
        t: *const mgdt_triangulation,
        xyz: *const f64,
        vertex: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_nearest_vertex_i32(
        t: *const mgdt_triangulation,
        xyz: *const f64,
        vertex: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_nearest_vertices(
        t: *const mgdt_triangulation,
        n: i64,
        xyz: *const f64,
        vertices: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_nearest_vertices_i32(
        t: *const mgdt_triangulation,
        n: i64,
        xyz: *const f64,
        vertices: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_interpolate(
        t: *const mgdt_triangulation,
        method: i32,
        outside: i32,
        n_fields: i64,
        values: *const f64,
        n: i64,
        xyz: *const f64,
        out: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_get_interpolation_weights(
        t: *const mgdt_triangulation,
        method: i32,
        outside: i32,
        n: i64,
        xyz: *const f64,
        offset_capacity: i64,
        offsets: *mut i64,
        capacity: i64,
        points: *mut i64,
        weights: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_get_interpolation_weights_i32(
        t: *const mgdt_triangulation,
        method: i32,
        outside: i32,
        n: i64,
        xyz: *const f64,
        offset_capacity: i64,
        offsets: *mut i32,
        capacity: i64,
        points: *mut i32,
        weights: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_get_gradients(
        t: *const mgdt_triangulation,
        n_fields: i64,
        values: *const f64,
        out: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_check(t: *const mgdt_triangulation, level: i32) -> mgdt_status;
    pub fn mgdt_get_stat(t: *const mgdt_triangulation, key: i32, value: *mut f64) -> mgdt_status;
    pub fn mgdt_stat_name(key: i32) -> *const c_char;
    pub fn mgdt_status_string(s: mgdt_status) -> *const c_char;
    pub fn mgdt_get_error(
        t: *const mgdt_triangulation,
        capacity: i64,
        buffer: *mut c_char,
    ) -> mgdt_status;
    pub fn mgdt_order_scheme_name(scheme: i32) -> *const c_char;
    pub fn mgdt_order_scheme_from_name(name: *const c_char, scheme: *mut i32) -> mgdt_status;
    pub fn mgdt_order_scheme_at(index: i32, scheme: *mut i32) -> mgdt_status;
    pub fn mgdt_version_string() -> *const c_char;
    pub fn mgdt_abi_version() -> i32;
    pub fn mgdt_isa_name(t: *const mgdt_triangulation) -> *const c_char;
    pub fn mgdt_voronoi_create(
        t: *const mgdt_triangulation,
        n_planes: i64,
        planes: *const f64,
        out: *mut *mut mgdt_voronoi,
    ) -> mgdt_status;
    pub fn mgdt_voronoi_destroy(v: *mut mgdt_voronoi);
    pub fn mgdt_voronoi_get_stat(v: *const mgdt_voronoi, key: i32, value: *mut i64) -> mgdt_status;
    pub fn mgdt_voronoi_array_info(
        array: i32,
        columns: *mut i32,
        is_double: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_voronoi_get_size(v: *const mgdt_voronoi, array: i32, size: *mut i64) -> mgdt_status;
    pub fn mgdt_voronoi_get_array(
        v: *const mgdt_voronoi,
        array: i32,
        capacity: i64,
        values: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_voronoi_get_array_i32(
        v: *const mgdt_voronoi,
        array: i32,
        capacity: i64,
        values: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_voronoi_get_doubles(
        v: *const mgdt_voronoi,
        array: i32,
        capacity: i64,
        values: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_voronoi_drop_small_faces(
        v: *mut mgdt_voronoi,
        least_area: f64,
        least_share: f64,
    ) -> mgdt_status;
    pub fn mgdt_voronoi_get_error(
        v: *const mgdt_voronoi,
        capacity: i64,
        buffer: *mut c_char,
    ) -> mgdt_status;
    pub fn mgdt_mesh_create(out: *mut *mut mgdt_mesh) -> mgdt_status;
    pub fn mgdt_mesh_create_with_allocator(
        alloc: mgdt_alloc_fn,
        release: mgdt_free_fn,
        user: *mut c_void,
        out: *mut *mut mgdt_mesh,
    ) -> mgdt_status;
    pub fn mgdt_mesh_destroy(m: *mut mgdt_mesh);
    pub fn mgdt_mesh_set_option(m: *mut mgdt_mesh, option: i32, value: i64) -> mgdt_status;
    pub fn mgdt_mesh_get_option(m: *const mgdt_mesh, option: i32, value: *mut i64) -> mgdt_status;
    pub fn mgdt_mesh_set_double_option(m: *mut mgdt_mesh, option: i32, value: f64) -> mgdt_status;
    pub fn mgdt_mesh_get_double_option(
        m: *const mgdt_mesh,
        option: i32,
        value: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_mesh_set_progress(
        m: *mut mgdt_mesh,
        callback: mgdt_progress_fn,
        user: *mut c_void,
    ) -> mgdt_status;
    pub fn mgdt_mesh_get_progress(
        m: *const mgdt_mesh,
        callback: *mut mgdt_progress_fn,
        user: *mut *mut c_void,
    ) -> mgdt_status;
    pub fn mgdt_mesh_cancel(m: *mut mgdt_mesh) -> mgdt_status;
    pub fn mgdt_mesh_set_points(m: *mut mgdt_mesh, n: i64, xyz: *const f64) -> mgdt_status;
    pub fn mgdt_mesh_set_tetrahedra(
        m: *mut mgdt_mesh,
        n: i64,
        corners: *const i64,
        markers: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_mesh_set_tetrahedra_i32(
        m: *mut mgdt_mesh,
        n: i64,
        corners: *const i32,
        markers: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_mesh_set_faces(
        m: *mut mgdt_mesh,
        n: i64,
        corners: *const i64,
        markers: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_mesh_set_faces_i32(
        m: *mut mgdt_mesh,
        n: i64,
        corners: *const i32,
        markers: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_mesh_set_edges(
        m: *mut mgdt_mesh,
        n: i64,
        ends: *const i64,
        markers: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_mesh_set_edges_i32(
        m: *mut mgdt_mesh,
        n: i64,
        ends: *const i32,
        markers: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_mesh_set_fixed_points(m: *mut mgdt_mesh, n: i64, points: *const i64) -> mgdt_status;
    pub fn mgdt_mesh_set_fixed_points_i32(
        m: *mut mgdt_mesh,
        n: i64,
        points: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_mesh_set_sizes(
        m: *mut mgdt_mesh,
        of: i32,
        n: i64,
        sizes: *const f64,
    ) -> mgdt_status;
    pub fn mgdt_mesh_set_size_field(
        m: *mut mgdt_mesh,
        n: i64,
        xyz: *const f64,
        sizes: *const f64,
    ) -> mgdt_status;
    pub fn mgdt_mesh_set_size_function(
        m: *mut mgdt_mesh,
        callback: mgdt_size_fn,
        user: *mut c_void,
    ) -> mgdt_status;
    pub fn mgdt_mesh_get_size_function(
        m: *const mgdt_mesh,
        callback: *mut mgdt_size_fn,
        user: *mut *mut c_void,
    ) -> mgdt_status;
    pub fn mgdt_mesh_build(m: *mut mgdt_mesh) -> mgdt_status;
    pub fn mgdt_mesh_refine(m: *mut mgdt_mesh) -> mgdt_status;
    pub fn mgdt_mesh_improve(m: *mut mgdt_mesh) -> mgdt_status;
    pub fn mgdt_mesh_get_stat(m: *const mgdt_mesh, key: i32, value: *mut i64) -> mgdt_status;
    pub fn mgdt_mesh_array_info(array: i32, columns: *mut i32, is_double: *mut i32) -> mgdt_status;
    pub fn mgdt_mesh_get_size(m: *const mgdt_mesh, array: i32, size: *mut i64) -> mgdt_status;
    pub fn mgdt_mesh_get_array(
        m: *const mgdt_mesh,
        array: i32,
        capacity: i64,
        values: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_mesh_get_array_i32(
        m: *const mgdt_mesh,
        array: i32,
        capacity: i64,
        values: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_mesh_get_doubles(
        m: *const mgdt_mesh,
        array: i32,
        capacity: i64,
        values: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_mesh_get_tetrahedron_measures(
        m: *const mgdt_mesh,
        measure: i32,
        capacity: i64,
        x: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_mesh_get_shape_summary(
        m: *const mgdt_mesh,
        shapes: *mut f64,
        angles: *mut i64,
        tetrahedra_below: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_mesh_locate_points(
        m: *const mgdt_mesh,
        outside: i32,
        n: i64,
        xyz: *const f64,
        tetrahedra: *mut i64,
        weights: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_mesh_locate_points_i32(
        m: *const mgdt_mesh,
        outside: i32,
        n: i64,
        xyz: *const f64,
        tetrahedra: *mut i32,
        weights: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_mesh_interpolate(
        m: *const mgdt_mesh,
        outside: i32,
        n_fields: i64,
        values: *const f64,
        n: i64,
        xyz: *const f64,
        out: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_mesh_check(m: *const mgdt_mesh) -> mgdt_status;
    pub fn mgdt_mesh_get_error(
        m: *const mgdt_mesh,
        capacity: i64,
        buffer: *mut c_char,
    ) -> mgdt_status;
    pub fn mgdt_domain_create(out: *mut *mut mgdt_domain) -> mgdt_status;
    pub fn mgdt_domain_create_with_allocator(
        alloc: mgdt_alloc_fn,
        release: mgdt_free_fn,
        user: *mut c_void,
        out: *mut *mut mgdt_domain,
    ) -> mgdt_status;
    pub fn mgdt_domain_destroy(d: *mut mgdt_domain);
    pub fn mgdt_domain_clear(d: *mut mgdt_domain) -> mgdt_status;
    pub fn mgdt_domain_set_option(d: *mut mgdt_domain, option: i32, value: i64) -> mgdt_status;
    pub fn mgdt_domain_get_option(
        d: *const mgdt_domain,
        option: i32,
        value: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_domain_set_double_option(
        d: *mut mgdt_domain,
        option: i32,
        value: f64,
    ) -> mgdt_status;
    pub fn mgdt_domain_get_double_option(
        d: *const mgdt_domain,
        option: i32,
        value: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_domain_set_progress(
        d: *mut mgdt_domain,
        callback: mgdt_progress_fn,
        user: *mut c_void,
    ) -> mgdt_status;
    pub fn mgdt_domain_get_progress(
        d: *const mgdt_domain,
        callback: *mut mgdt_progress_fn,
        user: *mut *mut c_void,
    ) -> mgdt_status;
    pub fn mgdt_domain_cancel(d: *mut mgdt_domain) -> mgdt_status;
    pub fn mgdt_domain_set_points(d: *mut mgdt_domain, n: i64, xyz: *const f64) -> mgdt_status;
    pub fn mgdt_domain_set_facets(
        d: *mut mgdt_domain,
        n: i64,
        offsets: *const i64,
        corners: *const i64,
        markers: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_domain_set_facets_i32(
        d: *mut mgdt_domain,
        n: i64,
        offsets: *const i32,
        corners: *const i32,
        markers: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_domain_set_segments(
        d: *mut mgdt_domain,
        n: i64,
        ends: *const i64,
        markers: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_domain_set_segments_i32(
        d: *mut mgdt_domain,
        n: i64,
        ends: *const i32,
        markers: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_domain_set_regions(
        d: *mut mgdt_domain,
        n: i64,
        xyz: *const f64,
        markers: *const i32,
    ) -> mgdt_status;
    pub fn mgdt_domain_set_holes(d: *mut mgdt_domain, n: i64, xyz: *const f64) -> mgdt_status;
    pub fn mgdt_domain_clean(d: *mut mgdt_domain) -> mgdt_status;
    pub fn mgdt_domain_validate(d: *mut mgdt_domain) -> mgdt_status;
    pub fn mgdt_domain_build(d: *mut mgdt_domain, out: *mut *mut mgdt_mesh) -> mgdt_status;
    pub fn mgdt_domain_check(d: *const mgdt_domain, mesh: *const mgdt_mesh) -> mgdt_status;
    pub fn mgdt_domain_get_stat(d: *const mgdt_domain, key: i32, value: *mut i64) -> mgdt_status;
    pub fn mgdt_domain_array_info(
        array: i32,
        columns: *mut i32,
        is_double: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_domain_get_size(d: *const mgdt_domain, array: i32, size: *mut i64) -> mgdt_status;
    pub fn mgdt_domain_get_array(
        d: *const mgdt_domain,
        array: i32,
        capacity: i64,
        values: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_domain_get_array_i32(
        d: *const mgdt_domain,
        array: i32,
        capacity: i64,
        values: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_domain_get_doubles(
        d: *const mgdt_domain,
        array: i32,
        capacity: i64,
        values: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_domain_get_error(
        d: *const mgdt_domain,
        capacity: i64,
        buffer: *mut c_char,
    ) -> mgdt_status;
    pub fn mgdt_periodic_create(out: *mut *mut mgdt_periodic) -> mgdt_status;
    pub fn mgdt_periodic_create_with_allocator(
        alloc: mgdt_alloc_fn,
        release: mgdt_free_fn,
        user: *mut c_void,
        out: *mut *mut mgdt_periodic,
    ) -> mgdt_status;
    pub fn mgdt_periodic_destroy(p: *mut mgdt_periodic);
    pub fn mgdt_periodic_clear(p: *mut mgdt_periodic) -> mgdt_status;
    pub fn mgdt_periodic_set_vectors(
        p: *mut mgdt_periodic,
        dimensions: i32,
        vectors: *const f64,
    ) -> mgdt_status;
    pub fn mgdt_periodic_set_option(p: *mut mgdt_periodic, option: i32, value: i64) -> mgdt_status;
    pub fn mgdt_periodic_get_option(
        p: *const mgdt_periodic,
        option: i32,
        value: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_periodic_set_merge_distance(p: *mut mgdt_periodic, distance: f64) -> mgdt_status;
    pub fn mgdt_periodic_get_merge_distance(
        p: *const mgdt_periodic,
        distance: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_periodic_set_progress(
        p: *mut mgdt_periodic,
        callback: mgdt_progress_fn,
        user: *mut c_void,
    ) -> mgdt_status;
    pub fn mgdt_periodic_get_progress(
        p: *const mgdt_periodic,
        callback: *mut mgdt_progress_fn,
        user: *mut *mut c_void,
    ) -> mgdt_status;
    pub fn mgdt_periodic_cancel(p: *mut mgdt_periodic) -> mgdt_status;
    pub fn mgdt_periodic_insert_points(
        p: *mut mgdt_periodic,
        n: i64,
        xyz: *const f64,
    ) -> mgdt_status;
    pub fn mgdt_periodic_move_points(
        p: *mut mgdt_periodic,
        n: i64,
        points: *const i64,
        xyz: *const f64,
    ) -> mgdt_status;
    pub fn mgdt_periodic_move_points_i32(
        p: *mut mgdt_periodic,
        n: i64,
        points: *const i32,
        xyz: *const f64,
    ) -> mgdt_status;
    pub fn mgdt_periodic_build(p: *mut mgdt_periodic) -> mgdt_status;
    pub fn mgdt_periodic_check(p: *const mgdt_periodic) -> mgdt_status;
    pub fn mgdt_periodic_get_stat(
        p: *const mgdt_periodic,
        key: i32,
        value: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_periodic_array_info(
        array: i32,
        columns: *mut i32,
        is_double: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_periodic_get_size(
        p: *const mgdt_periodic,
        array: i32,
        size: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_periodic_get_array(
        p: *const mgdt_periodic,
        array: i32,
        capacity: i64,
        values: *mut i64,
    ) -> mgdt_status;
    pub fn mgdt_periodic_get_array_i32(
        p: *const mgdt_periodic,
        array: i32,
        capacity: i64,
        values: *mut i32,
    ) -> mgdt_status;
    pub fn mgdt_periodic_get_doubles(
        p: *const mgdt_periodic,
        array: i32,
        capacity: i64,
        values: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_periodic_get_cell_measures(
        p: *const mgdt_periodic,
        measure: i32,
        capacity: i64,
        x: *mut f64,
    ) -> mgdt_status;
    pub fn mgdt_periodic_create_voronoi(
        p: *const mgdt_periodic,
        out: *mut *mut mgdt_voronoi,
    ) -> mgdt_status;
    pub fn mgdt_periodic_get_error(
        p: *const mgdt_periodic,
        capacity: i64,
        buffer: *mut c_char,
    ) -> mgdt_status;
}
