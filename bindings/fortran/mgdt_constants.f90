! SPDX-License-Identifier: MIT
! The constants of mgdt's C interface, in the default integer of the flags in force.
module mgdt_constants
    implicit none
    public

    ! Values of stat=. New ones may be added; existing ones never change.
    integer, parameter :: mgdt_ok = 0                    ! success
    integer, parameter :: mgdt_err_null_pointer = 10     ! something that must be there is not
    integer, parameter :: mgdt_err_invalid_argument = 11 ! a value or shape out of its range
    integer, parameter :: mgdt_err_not_finite = 12       ! a coordinate is NaN or infinite
    integer, parameter :: mgdt_err_unknown_scheme = 13   ! not an mgdt_order_ value or name
    integer, parameter :: mgdt_err_unknown_key = 14      ! not an mgdt_stat_ or mgdt_parameter_ key
    integer, parameter :: mgdt_err_buffer_too_small = 20 ! an array is too small; not touched
    integer, parameter :: mgdt_err_index_range = 21      ! a number does not fit the integer kind
    integer, parameter :: mgdt_err_out_of_memory = 30    ! the system or the memory limit refused
    integer, parameter :: mgdt_err_too_large = 31        ! more than the format can number
    integer, parameter :: mgdt_err_cancelled = 40        ! cancel or the progress callback said so
    integer, parameter :: mgdt_err_busy = 41             ! another call is inside; since 1.2
    integer, parameter :: mgdt_err_check_failed = 60     ! check found a defect
    integer, parameter :: mgdt_err_internal = 90         ! a defect in mgdt; please report it

    ! Order schemes: in which order the points of one call are inserted. The tetrahedra do not
    ! depend on it, the time does.
    integer, parameter :: mgdt_order_auto = 0            ! what measures best; the default
    integer, parameter :: mgdt_order_input = 10          ! as given
    integer, parameter :: mgdt_order_random = 20         ! shuffled
    integer, parameter :: mgdt_order_lexicographic = 30  ! by x, then y, then z
    integer, parameter :: mgdt_order_brio = 40           ! random rounds, each along a curve
    integer, parameter :: mgdt_order_hilbert = 50        ! along a Hilbert curve
    integer, parameter :: mgdt_order_regular_grid = 60   ! cell by cell of a regular grid
    integer, parameter :: mgdt_order_kd_tree = 70        ! squarish kd-tree
    integer, parameter :: mgdt_order_enhanced_kd_tree = 80 ! a kd-tree with a grid in each cell
    integer, parameter :: mgdt_order_multi_grid = 90     ! regular grids within the cells of grids

    ! Keys of set_order_parameter.
    integer, parameter :: mgdt_parameter_points_per_cell = 10 ! mean number, 1 to 1e6; 0: default
    integer, parameter :: mgdt_parameter_threshold = 20  ! multi-grid: 1 to 1e9; 0: default
    integer, parameter :: mgdt_parameter_separation = 30 ! grids: 0, 1 or 2 (default)
    integer, parameter :: mgdt_parameter_round_ratio = 40 ! BRIO: above 1 to 1e6; 0: default (7.5)

    ! Keys of get_stat. Counts are of the whole life of the triangulation; seconds are wall-clock.
    integer, parameter :: mgdt_stat_points_inserted = 10 ! points that became vertices
    integer, parameter :: mgdt_stat_duplicates = 11      ! points equal to an earlier vertex
    integer, parameter :: mgdt_stat_walk_steps = 20      ! tetrahedra visited by walks
    integer, parameter :: mgdt_stat_walk_tests = 21      ! circumspheres evaluated by walks
    integer, parameter :: mgdt_stat_conflict_tests = 22  ! circumspheres evaluated for cavities
    integer, parameter :: mgdt_stat_tetrahedra_removed = 30
    integer, parameter :: mgdt_stat_tetrahedra_created = 31
    integer, parameter :: mgdt_stat_exact_calls = 40     ! decisions that the filter left open
    integer, parameter :: mgdt_stat_put_off = 45         ! met another thread, tried again
    integer, parameter :: mgdt_stat_inserted_alone = 46  ! while other threads had no work
    integer, parameter :: mgdt_stat_order_seconds = 50   ! time spent on schedules
    integer, parameter :: mgdt_stat_insert_seconds = 51  ! time spent inserting
    integer, parameter :: mgdt_stat_grid_levels = 60     ! deepest level of the last schedule
    integer, parameter :: mgdt_stat_rounds = 61          ! rounds in the last schedule
    integer, parameter :: mgdt_stat_threads = 62         ! threads of the last insertion
    integer, parameter :: mgdt_stat_memory_bytes = 70    ! memory held now
    integer, parameter :: mgdt_stat_peak_memory_bytes = 71 ! the most it held so far

    ! Levels of check. Each includes those below it.
    integer, parameter :: mgdt_check_combinatorial = 1   ! adjacency, Euler, no point lost
    integer, parameter :: mgdt_check_geometric = 2       ! exact orientation, exact local Delaunay
    integer, parameter :: mgdt_check_canonical = 3       ! convex hull, and how ties are broken
end module mgdt_constants
