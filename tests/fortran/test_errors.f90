! SPDX-License-Identifier: MIT
! Bad input: the right status, a message that says what and where, nothing changed.
program test_errors
    use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
    use checks
    use mgdt
    implicit none

    integer, parameter :: n = 200
    type(mgdt_triangulation) :: t
    real(real64) :: xyz(3, n)
    integer(int64) :: nt
    integer :: stat
    character(256) :: msg

    call make_points(xyz)
    call test_before_use()
    call t%insert(xyz, stat=stat, errmsg=msg)
    call expect(stat == mgdt_ok, 'success')
    nt = t%tetrahedron_count()
    call test_points()
    call test_arrays()
    call test_settings()
    call test_queries()
    call test_memory()
    call test_arguments()
    call expect(t%point_count() == n .and. t%tetrahedron_count() == nt, 'nothing changed')
    call t%check(mgdt_check_canonical)
    call conclude()

contains

    subroutine test_before_use()
        type(mgdt_triangulation) :: other
        real(real64) :: value

        msg = 'as it was'
        call other%check(4, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'check level 4')
        call other%get_stat(-1, value, stat, msg)
        call expect_error(stat, mgdt_err_unknown_key, msg, '-1')
        call other%set_threads(-1, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'threads is negative (-1)')
        call other%create(stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'made already')
    end subroutine

    subroutine test_points()
        real(real64) :: bad(3, n), four_rows(4, n)

        bad = xyz
        bad(2, 17) = ieee_value(1._real64, ieee_quiet_nan)
        call t%insert(bad, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_not_finite, msg, 'coordinate y of point 217 is NaN')
        call expect(t%get_error() == trim(msg), 'the message stays with the triangulation')
        bad(2, 17) = ieee_value(1._real64, ieee_positive_inf)
        call t%insert(bad(1, :), bad(2, :), bad(3, :), stat, msg)
        call expect_error(stat, mgdt_err_not_finite, msg, 'y of point 217')
        four_rows = 0
        call t%insert(four_rows, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'extent 4 in dimension 1')
        call t%insert(xyz(1, :), stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, '200 elements')
        call t%insert(xyz(1, :), xyz(2, 2:), xyz(3, 3:), stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'x has 200 elements, y 199, z 198')
        call t%reserve(-1, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, '-1')
        call t%reserve(huge(1_int64), stat, msg)
        call expect(stat == mgdt_err_too_large .or. stat == mgdt_err_out_of_memory, 'too many points')
    end subroutine

    subroutine test_arrays()
        integer(int32) :: small(4, nt - 1), three(3, 2*nt), map(n - 1), none(4, 0)
        integer(int64) :: small_1(4*nt - 1), offsets(n), list(4*nt), facets(4, 10), edges(1, 10)

        small = -5
        call t%get_tetrahedra(small, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'are needed')
        call expect(all(small == -5), 'not touched')
        small_1 = -5
        call t%get_neighbors(small_1, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'are needed')
        call expect(all(small_1 == -5), 'not touched')
        call t%get_tetrahedra(three, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'extent 3 in dimension 1; it must be 4')
        call t%get_neighbors(three, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'it must be 4')
        call t%get_hull_facets(facets, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'it must be 3')
        call t%get_edges(edges, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'it must be 2')
        call t%get_tetrahedra(none, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, '0 elements')
        call t%get_point_map(map, stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, '199 elements; 200 are needed')
        call t%get_vertex_tetrahedra(offsets, list, stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, '201 are needed')
    end subroutine

    subroutine test_settings()
        integer :: scheme
        integer(int64) :: wrap

        call t%set_order_scheme(5, stat, msg)
        call expect_error(stat, mgdt_err_unknown_scheme, msg, 'order scheme 5')
        call t%set_order_scheme('multigrid', stat, msg)
        call expect_error(stat, mgdt_err_unknown_scheme, msg, '"multigrid"')
        scheme = 77
        call mgdt_order_scheme_from_name('', scheme, stat, msg)
        call expect_error(stat, mgdt_err_unknown_scheme, msg, 'no order scheme ""')
        call expect(scheme == 77, 'the scheme is not touched')
        call t%set_order_parameter(11, 1._real64, stat, msg)
        call expect_error(stat, mgdt_err_unknown_key, msg, '11')
        call t%set_order_parameter(mgdt_parameter_round_ratio, 1._real64, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'round ratio is 1')
        call t%set_index_base(2, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'is 2')
        call t%set_memory_limit(-1, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, '-1')
        call t%set_isa('abacus', stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, '"abacus"')
        ! A default integer of 8 bytes must not wrap round into a valid value.
        wrap = 2_int64**32
        if (huge(1) > wrap) then
            call t%set_order_scheme(int(wrap + mgdt_order_brio), stat, msg)
            call expect_error(stat, mgdt_err_unknown_scheme, msg, 'order scheme 2147483647')
            call t%check(int(wrap + 1), stat, msg)
            call expect_error(stat, mgdt_err_invalid_argument, msg, 'check level')
            call t%set_index_base(int(-wrap), stat, msg)
            call expect_error(stat, mgdt_err_invalid_argument, msg, 'index base')
        end if
    end subroutine

    subroutine test_queries()
        real(real64) :: bad(3, 4), weights(4, 4), three(3, 4), no_weights(0), value
        integer(int32) :: found(4), one
        integer(int64) :: one_64

        bad = 0.5_real64
        bad(3, 2) = ieee_value(1._real64, ieee_quiet_nan)
        found = -5
        weights = -5
        call t%locate_points(bad, found, weights, stat, msg)
        call expect_error(stat, mgdt_err_not_finite, msg, 'z of point 2')
        call expect(all(found == -5) .and. all(weights < -4), 'nothing written')
        call t%locate_points(xyz(:, :4), found(:3), stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'tetrahedra holds 3 elements; 4 are')
        call t%locate_points(xyz(:, :4), found, weights(:, :3), stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'room for 3 points; 4 are needed')
        call t%locate_points(xyz(:, :4), found, three, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'weights has extent 3')
        call t%locate_points(xyz(:2, :4), found, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, '3 coordinates')
        call t%locate_points(xyz(1, :4), found, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, '3 coordinates')
        call t%locate_points(reshape(xyz(:, :4), [12]), found, no_weights, stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'room for 0 points')
        one = -5
        one_64 = -5
        call t%locate(bad(:, 2), one, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_not_finite, msg, 'NaN')
        call t%nearest_vertex(bad(:, 2), one, stat, msg)
        call expect_error(stat, mgdt_err_not_finite, msg, 'NaN')
        call t%nearest_vertex(bad(:, 2), one_64, stat, msg)
        call expect_error(stat, mgdt_err_not_finite, msg, 'NaN')
        call expect(one == -5 .and. one_64 == -5, 'not touched')
        call t%check(0, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'check level 0')
        value = -5
        call t%get_stat(9, value, stat, msg)
        call expect_error(stat, mgdt_err_unknown_key, msg, '9')
        call expect(value < -4, 'the figure is not touched')
    end subroutine

    subroutine test_memory()
        type(mgdt_triangulation) :: other
        real(real64), allocatable :: many(:, :)
        integer(int32), allocatable :: map(:)

        allocate (many(3, 20000))
        call make_points(many)
        call other%insert(many(:, :50))
        call other%set_memory_limit(3000000)
        call other%insert(many, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_out_of_memory, msg, 'memory')
        ! The check takes memory too.
        call other%set_memory_limit(0)
        call other%check(mgdt_check_canonical, stat)
        call expect(stat == mgdt_ok, 'valid after running out of memory')
        call other%set_memory_limit(0)
        call other%insert(many)
        allocate (map(other%point_count()))
        call other%get_point_map(map)
        call expect(all(map(int(other%point_count()) - 19999:) > 0), 'all in after the limit is lifted')
    end subroutine

    ! stat alone, errmsg alone on success, a short errmsg.
    subroutine test_arguments()
        character(9) :: short
        character(5) :: kept

        stat = -1
        call t%set_threads(-1, stat)
        call expect(stat == mgdt_err_invalid_argument, 'stat without errmsg')
        kept = 'kept'
        call t%set_threads(1, errmsg=kept)
        call expect(kept == 'kept', 'errmsg stays on success')
        call t%set_threads(1, stat, kept)
        call expect(kept == 'kept' .and. stat == mgdt_ok, 'errmsg stays on success, with stat')
        call t%set_threads(-1, stat, short)
        call expect(short == 'the numbe', 'errmsg is cut')
    end subroutine
end program
