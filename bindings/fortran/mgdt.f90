! SPDX-License-Identifier: MIT
! mgdt: exact 3D Delaunay triangulation of any set of points.
!
! This module is the whole Fortran interface and can be read from top to bottom as a manual;
! docs/fortran.md is the guide to it. The bodies are in the submodules.
!
! Conventions, for every procedure:
!
! - A procedure that can fail takes stat= and errmsg= as ALLOCATE does: stat is mgdt_ok (0) or one
!   of the mgdt_err_ constants, errmsg is set on errors alone, and without stat an error stops the
!   program with the message. A call that fails on its arguments changes nothing.
! - Points and tetrahedra are numbered from 1, or from 0 on request (set_index_base). "None" is one
!   less than the first number.
! - Arrays are the caller's: coordinates xyz(3, n) or xyz(3 n), tetrahedra(4, n), tetrahedra(4 n),
!   or tetrahedra(n, 4) with dim=2. They may be larger than needed; the rest is not touched. Index
!   arrays are of kind int32 or int64; a number that does not fit gets mgdt_err_index_range.
! - A triangulation needs no call to be made: one that was never used is empty.
! - Calls with intent(in) may run on one triangulation from many threads at once. The others need it
!   to themselves. Different triangulations are independent.
module mgdt
    use, intrinsic :: iso_c_binding, only: c_funptr, c_null_ptr, c_ptr
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use mgdt_c, only: c_dimension, c_edge_count, c_hull_facet_count, c_isa_name, c_point_count, &
                      c_tetrahedron_count, c_vertex_count, c_vertex_tetrahedra_count
    use mgdt_callbacks, only: mgdt_observer, mgdt_progress, progress_box
    use mgdt_constants
    use mgdt_names, only: mgdt_version => version, mgdt_abi_version => abi_version, &
                          mgdt_status_string => status_string, mgdt_stat_name => stat_name, &
                          mgdt_order_scheme_name => order_scheme_name, &
                          mgdt_order_scheme_from_name => order_scheme_from_name, &
                          mgdt_order_scheme_at => order_scheme_at
    use mgdt_support, only: c_text, last_message
    implicit none
    private

    public :: mgdt_triangulation, mgdt_observer, mgdt_progress
    public :: mgdt_version, mgdt_abi_version, mgdt_status_string, mgdt_stat_name, &
              mgdt_order_scheme_name, mgdt_order_scheme_from_name, mgdt_order_scheme_at
    ! The constants; mgdt_constants.f90 says what they mean.
    public :: mgdt_ok, mgdt_err_null_pointer, mgdt_err_invalid_argument, mgdt_err_not_finite, &
              mgdt_err_unknown_scheme, mgdt_err_unknown_key, mgdt_err_buffer_too_small, &
              mgdt_err_index_range, mgdt_err_out_of_memory, mgdt_err_too_large, &
              mgdt_err_cancelled, mgdt_err_busy, mgdt_err_check_failed, mgdt_err_internal
    public :: mgdt_order_auto, mgdt_order_input, mgdt_order_random, mgdt_order_lexicographic, &
              mgdt_order_brio, mgdt_order_hilbert, mgdt_order_regular_grid, mgdt_order_kd_tree, &
              mgdt_order_enhanced_kd_tree, mgdt_order_multi_grid
    public :: mgdt_parameter_points_per_cell, mgdt_parameter_threshold, &
              mgdt_parameter_separation, mgdt_parameter_round_ratio
    public :: mgdt_stat_points_inserted, mgdt_stat_duplicates, mgdt_stat_walk_steps, &
              mgdt_stat_walk_tests, mgdt_stat_conflict_tests, mgdt_stat_tetrahedra_removed, &
              mgdt_stat_tetrahedra_created, mgdt_stat_exact_calls, mgdt_stat_put_off, &
              mgdt_stat_inserted_alone, mgdt_stat_threads, mgdt_stat_order_seconds, &
              mgdt_stat_insert_seconds, mgdt_stat_grid_levels, mgdt_stat_rounds, &
              mgdt_stat_memory_bytes, mgdt_stat_peak_memory_bytes
    public :: mgdt_check_combinatorial, mgdt_check_geometric, mgdt_check_canonical

    ! A triangulation that grows as points are inserted. It frees what it holds when it goes out of
    ! scope or is deallocated. It cannot be copied: a = b stops the program, unless b was never
    ! used, which makes a empty. call a%move_from(b) moves.
    type :: mgdt_triangulation
        private
        type(c_ptr) :: handle = c_null_ptr
        type(progress_box), pointer :: progress => null()
    contains
        ! life
        procedure :: create, destroy, clear, move_from
        generic :: reserve => reserve_i32, reserve_i64
        ! settings
        generic :: set_order_scheme => set_order_scheme_number, set_order_scheme_name
        procedure :: set_order_parameter
        generic :: set_seed => set_seed_i32, set_seed_i64
        procedure :: set_threads, set_index_base
        generic :: set_memory_limit => set_memory_limit_i32, set_memory_limit_i64
        generic :: set_progress => set_progress_procedure, set_progress_observer
        procedure :: remove_progress, cancel, set_compact, set_canonical_output, set_isa
        ! points
        generic :: insert => insert_xyz_1, insert_xyz_2, insert_x_y_z
        ! counts
        procedure :: point_count, vertex_count, dimension => dimension_of, tetrahedron_count, &
                     hull_facet_count, edge_count, vertex_tetrahedra_count
        ! arrays
        generic :: get_tetrahedra => get_tetrahedra_i32_1, get_tetrahedra_i32_2, &
            get_tetrahedra_i64_1, get_tetrahedra_i64_2
        generic :: get_neighbors => get_neighbors_i32_1, get_neighbors_i32_2, &
            get_neighbors_i64_1, get_neighbors_i64_2
        generic :: get_hull_facets => get_hull_facets_i32_1, get_hull_facets_i32_2, &
            get_hull_facets_i64_1, get_hull_facets_i64_2
        generic :: get_edges => get_edges_i32_1, get_edges_i32_2, &
            get_edges_i64_1, get_edges_i64_2
        generic :: get_point_map => get_point_map_i32, get_point_map_i64
        generic :: get_vertex_tetrahedra => get_vertex_tetrahedra_i32, get_vertex_tetrahedra_i64
        ! queries, trust, figures, text
        generic :: locate => locate_i32, locate_i64
        generic :: locate_points => locate_points_i32_1, locate_points_i32_2, &
            locate_points_i64_1, locate_points_i64_2
        generic :: nearest_vertex => nearest_vertex_i32, nearest_vertex_i64
        procedure :: check, get_stat, get_error, isa_name, c_handle

        generic :: assignment(=) => assign
        procedure, private :: assign
        final :: finalize
        procedure, private :: reserve_i32, reserve_i64, set_order_scheme_number, &
            set_order_scheme_name, set_seed_i32, set_seed_i64, set_memory_limit_i32, &
            set_memory_limit_i64, set_progress_procedure, set_progress_observer, insert_xyz_1, &
            insert_xyz_2, insert_x_y_z, &
            get_tetrahedra_i32_1, get_tetrahedra_i32_2, get_tetrahedra_i64_1, &
            get_tetrahedra_i64_2, &
            get_neighbors_i32_1, get_neighbors_i32_2, get_neighbors_i64_1, get_neighbors_i64_2, &
            get_hull_facets_i32_1, get_hull_facets_i32_2, get_hull_facets_i64_1, &
            get_hull_facets_i64_2, &
            get_edges_i32_1, get_edges_i32_2, get_edges_i64_1, get_edges_i64_2, &
            get_point_map_i32, get_point_map_i64, get_vertex_tetrahedra_i32, &
            get_vertex_tetrahedra_i64, locate_i32, locate_i64, locate_points_i32_1, &
            locate_points_i32_2, locate_points_i64_1, locate_points_i64_2, nearest_vertex_i32, &
            nearest_vertex_i64
    end type

    interface  ! life
        ! Makes the triangulation now, which the first call that changes it does otherwise; needed
        ! before cancel() from another thread. alloc and release are C functions (mgdt_alloc_fn and
        ! mgdt_free_fn in mgdt.h) that give all its memory; both or none.
        module subroutine create(self, alloc, release, user, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            type(c_funptr), intent(in), optional :: alloc, release
            type(c_ptr), intent(in), optional :: user
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Frees it. It may be used again, as one that was never used.
        impure elemental module subroutine destroy(self)
            class(mgdt_triangulation), intent(inout) :: self
        end subroutine
        ! Takes all points out; settings stay, statistics start again at zero.
        module subroutine clear(self, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Announces how many points will be given in all, so that storage grows once. Optional.
        module subroutine reserve_i32(self, n_points, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer(int32), intent(in) :: n_points
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine reserve_i64(self, n_points, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer(int64), intent(in) :: n_points
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Frees what self holds and gives it what other holds, which becomes one that was never
        ! used.
        module subroutine move_from(self, other)
            class(mgdt_triangulation), intent(inout) :: self, other
        end subroutine
        impure elemental module subroutine assign(self, other)
            class(mgdt_triangulation), intent(inout) :: self
            class(mgdt_triangulation), intent(in) :: other
        end subroutine
        impure elemental module subroutine finalize(self)
            type(mgdt_triangulation), intent(inout) :: self
        end subroutine
    end interface

    interface  ! settings
        ! The order scheme of later insertions: an mgdt_order_ constant, or its name ('multi-grid').
        module subroutine set_order_scheme_number(self, scheme, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer, intent(in) :: scheme
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine set_order_scheme_name(self, name, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            character(*), intent(in) :: name
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! A parameter of the order schemes: an mgdt_parameter_ constant.
        module subroutine set_order_parameter(self, key, value, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer, intent(in) :: key
            real(real64), intent(in) :: value
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! The seed of the schemes that shuffle. The tetrahedra are the same for every seed. Default
        ! 0.
        module subroutine set_seed_i32(self, seed, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer(int32), intent(in) :: seed
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine set_seed_i64(self, seed, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer(int64), intent(in) :: seed
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! How many threads a call may use: at least 1 (default), or 0 for all cores. Version 1.0
        ! uses one.
        module subroutine set_threads(self, n, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer, intent(in) :: n
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! The number of the first point and the first tetrahedron: 1 (default) or 0.
        module subroutine set_index_base(self, base, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer, intent(in) :: base
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! The most memory it may hold, in bytes; 0 (default) for no limit.
        module subroutine set_memory_limit_i32(self, bytes, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer(int32), intent(in) :: bytes
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine set_memory_limit_i64(self, bytes, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer(int64), intent(in) :: bytes
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Who hears of progress and may cancel: a procedure, or an object that extends
        ! mgdt_observer, which has to live until remove_progress, another set_progress, or the end
        ! of the triangulation.
        module subroutine set_progress_procedure(self, report, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            procedure(mgdt_progress) :: report
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine set_progress_observer(self, observer, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            class(mgdt_observer), intent(inout), target :: observer
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine remove_progress(self, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Asks the call that is running to stop soon; it gets mgdt_err_cancelled. Without one, the
        ! next insertion is stopped. From any thread, once the triangulation is made (see create).
        module subroutine cancel(self, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Whether to keep no circumspheres beside the tetrahedra: three tenths less memory, 20 to 40
        ! percent more time. At any time; .false. (default) computes them again, which may be
        ! refused memory. Since 1.1.
        module subroutine set_compact(self, on, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            logical, intent(in) :: on
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Whether exported arrays shall depend on the set of points alone, byte for byte: tetrahedra
        ! sorted, the least vertex of each first and the next least second. Default .false., which
        ! is faster.
        module subroutine set_canonical_output(self, on, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            logical, intent(in) :: on
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! The instruction set of the kernel, for tests and measurements: 'baseline', on x86-64
        ! 'avx2' or 'avx512'; without a name the best.
        module subroutine set_isa(self, name, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            character(*), intent(in), optional :: name
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
    end interface

    interface  ! points
        ! Inserts points, in any number of calls. Points at the place of an earlier one (0 equals
        ! -0) share its vertex. Fewer than four points, or all on a plane, are kept until they span
        ! space. Array sections with any strides are read in place; x, y, z of different strides are
        ! copied.
        module subroutine insert_xyz_1(self, xyz, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            real(real64), intent(in), target :: xyz(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine insert_xyz_2(self, xyz, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            real(real64), intent(in), target :: xyz(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine insert_x_y_z(self, x, y, z, stat, errmsg)
            class(mgdt_triangulation), intent(inout) :: self
            real(real64), intent(in), target :: x(:), y(:), z(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
    end interface

    interface  ! arrays
        ! Tetrahedra, neighbours, hull facets and edges may go to any array section. Contiguous
        ! arrays (4, n) and (4 n) are written in place, and so are arrays (n, 4) of just the size
        ! that is needed. For others the procedure holds a copy while it runs. dim is the dimension
        ! along which the vertices of one tetrahedron lie: 1 (default), or 2 for arrays (n, 4).

        ! The vertices of each tetrahedron, tetrahedra(4, tetrahedron_count()), positively oriented:
        ! (v2 - v1) x (v3 - v1) . (v4 - v1) > 0. A vertex is the first point given at its place.
        module subroutine get_tetrahedra_i32_1(self, tetrahedra, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer(int32), intent(inout) :: tetrahedra(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine get_tetrahedra_i32_2(self, tetrahedra, stat, errmsg, dim)
            class(mgdt_triangulation), intent(in) :: self
            integer(int32), intent(inout) :: tetrahedra(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
            integer, intent(in), optional :: dim
        end subroutine
        module subroutine get_tetrahedra_i64_1(self, tetrahedra, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer(int64), intent(inout) :: tetrahedra(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine get_tetrahedra_i64_2(self, tetrahedra, stat, errmsg, dim)
            class(mgdt_triangulation), intent(in) :: self
            integer(int64), intent(inout) :: tetrahedra(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
            integer, intent(in), optional :: dim
        end subroutine
        ! The neighbours of each tetrahedron, neighbors(4, tetrahedron_count()): the i-th shares the
        ! facet opposite vertex i; none on the hull.
        module subroutine get_neighbors_i32_1(self, neighbors, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer(int32), intent(inout) :: neighbors(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine get_neighbors_i32_2(self, neighbors, stat, errmsg, dim)
            class(mgdt_triangulation), intent(in) :: self
            integer(int32), intent(inout) :: neighbors(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
            integer, intent(in), optional :: dim
        end subroutine
        module subroutine get_neighbors_i64_1(self, neighbors, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer(int64), intent(inout) :: neighbors(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine get_neighbors_i64_2(self, neighbors, stat, errmsg, dim)
            class(mgdt_triangulation), intent(in) :: self
            integer(int64), intent(inout) :: neighbors(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
            integer, intent(in), optional :: dim
        end subroutine
        ! The triangles of the convex hull, facets(3, hull_facet_count()), counter-clockwise seen
        ! from outside.
        module subroutine get_hull_facets_i32_1(self, facets, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer(int32), intent(inout) :: facets(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine get_hull_facets_i32_2(self, facets, stat, errmsg, dim)
            class(mgdt_triangulation), intent(in) :: self
            integer(int32), intent(inout) :: facets(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
            integer, intent(in), optional :: dim
        end subroutine
        module subroutine get_hull_facets_i64_1(self, facets, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer(int64), intent(inout) :: facets(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine get_hull_facets_i64_2(self, facets, stat, errmsg, dim)
            class(mgdt_triangulation), intent(in) :: self
            integer(int64), intent(inout) :: facets(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
            integer, intent(in), optional :: dim
        end subroutine
        ! The edges, edges(2, edge_count()), the lesser point first; each edge once.
        module subroutine get_edges_i32_1(self, edges, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer(int32), intent(inout) :: edges(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine get_edges_i32_2(self, edges, stat, errmsg, dim)
            class(mgdt_triangulation), intent(in) :: self
            integer(int32), intent(inout) :: edges(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
            integer, intent(in), optional :: dim
        end subroutine
        module subroutine get_edges_i64_1(self, edges, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer(int64), intent(inout) :: edges(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine get_edges_i64_2(self, edges, stat, errmsg, dim)
            class(mgdt_triangulation), intent(in) :: self
            integer(int64), intent(inout) :: edges(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
            integer, intent(in), optional :: dim
        end subroutine
        ! For each point ever given the point that stands for it as a vertex,
        ! point_map(point_count()): itself, or the first one given at its place, or none if it is
        ! not in.
        module subroutine get_point_map_i32(self, point_map, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer(int32), contiguous, intent(inout) :: point_map(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine get_point_map_i64(self, point_map, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer(int64), contiguous, intent(inout) :: point_map(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! The tetrahedra around each point, as a compressed list: those of the k-th point (counted
        ! from 1) are list(offsets(k):offsets(k + 1) - 1), ascending, with index base 1.
        ! offsets(point_count() + 1), list(vertex_tetrahedra_count()).
        module subroutine get_vertex_tetrahedra_i32(self, offsets, list, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer(int32), contiguous, intent(inout) :: offsets(:), list(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine get_vertex_tetrahedra_i64(self, offsets, list, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer(int64), contiguous, intent(inout) :: offsets(:), list(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
    end interface

    interface  ! queries
        ! The tetrahedron that contains a point, its boundary included; none outside the hull. The
        ! weights are the point's barycentric coordinates in it, zeros outside. They give the point
        ! again but for some units in the last place, in every tetrahedron, however flat.
        module subroutine locate_i32(self, point, tetrahedron, weights, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            real(real64), intent(in) :: point(3)
            integer(int32), intent(inout) :: tetrahedron
            real(real64), intent(inout), optional, target :: weights(4)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine locate_i64(self, point, tetrahedron, weights, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            real(real64), intent(in) :: point(3)
            integer(int64), intent(inout) :: tetrahedron
            real(real64), intent(inout), optional, target :: weights(4)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! The same for n points, in any order: much faster than one by one. tetrahedra(n),
        ! weights(4, n).
        module subroutine locate_points_i32_1(self, xyz, tetrahedra, weights, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            real(real64), contiguous, intent(in) :: xyz(:)
            integer(int32), contiguous, intent(inout) :: tetrahedra(:)
            real(real64), contiguous, intent(inout), optional, target :: weights(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine locate_points_i32_2(self, xyz, tetrahedra, weights, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            real(real64), contiguous, intent(in) :: xyz(:, :)
            integer(int32), contiguous, intent(inout) :: tetrahedra(:)
            real(real64), contiguous, intent(inout), optional, target :: weights(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine locate_points_i64_1(self, xyz, tetrahedra, weights, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            real(real64), contiguous, intent(in) :: xyz(:)
            integer(int64), contiguous, intent(inout) :: tetrahedra(:)
            real(real64), contiguous, intent(inout), optional, target :: weights(:)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine locate_points_i64_2(self, xyz, tetrahedra, weights, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            real(real64), contiguous, intent(in) :: xyz(:, :)
            integer(int64), contiguous, intent(inout) :: tetrahedra(:)
            real(real64), contiguous, intent(inout), optional, target :: weights(:, :)
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! The vertex nearest to a point, exactly; of several as near, the lowest; none if there is
        ! none.
        module subroutine nearest_vertex_i32(self, point, vertex, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            real(real64), intent(in) :: point(3)
            integer(int32), intent(inout) :: vertex
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        module subroutine nearest_vertex_i64(self, point, vertex, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            real(real64), intent(in) :: point(3)
            integer(int64), intent(inout) :: vertex
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! Proves by exact arithmetic that the triangulation is what it claims to be. level is an
        ! mgdt_check_ constant; a defect is mgdt_err_check_failed.
        module subroutine check(self, level, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer, intent(in) :: level
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
        ! One figure: key is an mgdt_stat_ constant.
        module subroutine get_stat(self, key, value, stat, errmsg)
            class(mgdt_triangulation), intent(in) :: self
            integer, intent(in) :: key
            real(real64), intent(inout) :: value
            integer, intent(out), optional :: stat
            character(*), intent(inout), optional :: errmsg
        end subroutine
    end interface

contains

    ! Counts are of kind int64. They are elemental, and may give the bounds of automatic arrays.

    ! Points ever given; those refused whole do not count.
    elemental function point_count(self) result(count)
        class(mgdt_triangulation), intent(in) :: self
        integer(int64) :: count

        count = c_point_count(self%handle)
    end function

    ! Distinct points that are in.
    elemental function vertex_count(self) result(count)
        class(mgdt_triangulation), intent(in) :: self
        integer(int64) :: count

        count = c_vertex_count(self%handle)
    end function

    ! Tetrahedra.
    elemental function tetrahedron_count(self) result(count)
        class(mgdt_triangulation), intent(in) :: self
        integer(int64) :: count

        count = c_tetrahedron_count(self%handle)
    end function

    ! Triangles on the convex hull.
    elemental function hull_facet_count(self) result(count)
        class(mgdt_triangulation), intent(in) :: self
        integer(int64) :: count

        count = c_hull_facet_count(self%handle)
    end function

    ! Edges of the tetrahedra.
    elemental function edge_count(self) result(count)
        class(mgdt_triangulation), intent(in) :: self
        integer(int64) :: count

        count = c_edge_count(self%handle)
    end function

    ! Length of the list of get_vertex_tetrahedra: 4 times the tetrahedra.
    elemental function vertex_tetrahedra_count(self) result(count)
        class(mgdt_triangulation), intent(in) :: self
        integer(int64) :: count

        count = c_vertex_tetrahedra_count(self%handle)
    end function

    ! Dimension of the points' affine hull: -1 empty, 0 one point, 1 a line, 2 a plane, 3 space.
    ! There are tetrahedra only at 3.
    elemental function dimension_of(self) result(dimension)
        class(mgdt_triangulation), intent(in) :: self
        integer :: dimension

        dimension = c_dimension(self%handle)
    end function

    ! The message of the last call that the library refused; empty if there is none.
    function get_error(self) result(message)
        class(mgdt_triangulation), intent(in) :: self
        character(:), allocatable :: message

        message = last_message(self%handle)
    end function

    ! The instruction set in use, see set_isa; empty if the triangulation is not made yet.
    function isa_name(self) result(name)
        class(mgdt_triangulation), intent(in) :: self
        character(:), allocatable :: name

        name = c_text(c_isa_name(self%handle))
    end function

    ! The C handle, for C functions that take one; null if it is not made yet. It stays self's.
    function c_handle(self) result(handle)
        class(mgdt_triangulation), intent(in) :: self
        type(c_ptr) :: handle

        handle = self%handle
    end function
end module mgdt
