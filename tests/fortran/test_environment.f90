! SPDX-License-Identifier: MIT
! The floating-point environment is the same after each kind of call as before it, and results do
! not depend on it. The script compiles this plainly and with -Ofast -ffpe-trap, tells it by the
! argument "armed" that traps and flush-to-zero must be on, and compares the files byte for byte.
module environment
    use, intrinsic :: iso_c_binding, only: c_int64_t
    use, intrinsic :: ieee_arithmetic, only: ieee_get_underflow_mode
    use, intrinsic :: ieee_exceptions, only: ieee_get_halting_mode, ieee_invalid, ieee_overflow, &
                                             ieee_divide_by_zero
    use checks, only: expect, real64
    implicit none

    interface
        function environment_now() result(state) bind(c)
            import :: c_int64_t
            integer(c_int64_t) :: state
        end function
    end interface

    ! The inexact flag may rise by the program's own arithmetic between calls, so each call is between
    ! two looks of its own.
    integer(c_int64_t) :: before
    integer :: calls_heard = 0

contains

    subroutine look()
        before = environment_now()
    end subroutine

    subroutine same_after(what)
        character(*), intent(in) :: what

        call expect(environment_now() == before, 'the environment after '//what)
    end subroutine

    subroutine expect_modes(armed, when)
        logical, intent(in) :: armed
        character(*), intent(in) :: when
        logical :: halting(3), gradual

        call ieee_get_halting_mode(ieee_invalid, halting(1))
        call ieee_get_halting_mode(ieee_overflow, halting(2))
        call ieee_get_halting_mode(ieee_divide_by_zero, halting(3))
        call ieee_get_underflow_mode(gradual)
        call expect(all(halting .eqv. armed), 'traps '//when)
        call expect(gradual .neqv. armed, 'subnormals '//when)
    end subroutine

    subroutine hear(fraction, cancel)
        real(real64), intent(in) :: fraction
        logical, intent(inout) :: cancel

        if (fraction >= 0) calls_heard = calls_heard + 1
        cancel = .false.
    end subroutine
end module environment

program test_environment
    use checks
    use environment
    use mgdt
    implicit none

    integer, parameter :: n = 2000
    character(200) :: argument, file
    logical :: armed
    real(real64) :: xyz(3, n)
    type(mgdt_triangulation) :: t
    integer :: unit

    call get_command_argument(1, argument)
    call get_command_argument(2, file)
    armed = argument == 'armed'
    call expect_modes(armed, 'at the beginning')
    open (newunit=unit, file=trim(file), access='stream', form='unformatted', status='replace')

    call make_points(xyz)
    call everything('random points')
    call make_lattice()
    call everything('a lattice')
    call make_points(xyz)
    xyz = tiny_copy(xyz)  ! subnormals, zero where they are flushed
    call everything('subnormal points')
    call make_points(xyz)
    xyz(:, 1::2) = huge_copy(xyz(:, 1::2))
    call everything('points of very different size')

    call expect_modes(armed, 'at the end')
    call expect(calls_heard > 0, 'progress was heard')
    close (unit)
    call conclude()

contains

    ! Many points on one sphere and many in one plane: every filter is undecided.
    subroutine make_lattice()
        integer :: i

        do i = 1, n
            xyz(:, i) = real([mod(i, 13), mod(i/13, 13), i/169], real64)
        end do
    end subroutine

    ! x as a multiple of 2^-1074 instead of 2^-10. Made of bits, which no floating-point mode changes.
    elemental function tiny_copy(x) result(y)
        real(real64), intent(in) :: x
        real(real64) :: y

        y = transfer(nint(1024*x, int64), y)
    end function

    ! x times 2^1000, by its exponent's bits.
    elemental function huge_copy(x) result(y)
        real(real64), intent(in) :: x
        real(real64) :: y

        y = x
        if (x > 0) y = transfer(transfer(x, 0_int64) + shiftl(1000_int64, 52), y)
    end function

    subroutine everything(what)
        character(*), intent(in) :: what
        integer, allocatable :: tets(:, :), facets(:, :), edges(:, :), map(:), offsets(:), list(:)
        integer :: found(n), vertex(n)
        real(real64) :: weights(4, n), value
        integer :: i, stat
        character(100) :: msg

        call look()
        call t%destroy()
        call t%create()
        call same_after('destroy and create')
        call look()
        call t%set_canonical_output(.true.)
        call t%set_order_parameter(mgdt_parameter_round_ratio, 7.5_real64)
        call t%set_progress(hear)
        call same_after('settings')
        call look()
        call t%reserve(n)
        call same_after('reserve')
        call look()
        call t%insert(xyz(:, :n/2))
        call same_after('insert, '//what)
        call look()
        call t%insert(xyz(1, n/2 + 1:), xyz(2, n/2 + 1:), xyz(3, n/2 + 1:))
        call same_after('insert of x, y, z, '//what)
        allocate (tets(4, t%tetrahedron_count()), facets(3, t%hull_facet_count()), &
                  edges(2, t%edge_count()), map(n), offsets(n + 1), &
                  list(t%vertex_tetrahedra_count()))
        call look()
        call t%get_tetrahedra(tets)
        write (unit) tets
        call t%get_neighbors(tets)
        call same_after('tetrahedra, '//what)
        write (unit) tets
        call look()
        call t%get_hull_facets(facets)
        call t%get_edges(edges)
        call t%get_point_map(map)
        call t%get_vertex_tetrahedra(offsets, list)
        call same_after('other arrays, '//what)
        write (unit) facets, edges, map, offsets, list
        call look()
        call t%locate_points(xyz, found, weights)
        call same_after('locate_points, '//what)
        write (unit) weights
        call look()
        do i = 1, n
            call t%locate(xyz(:, i), found(i))
            call t%nearest_vertex(xyz(:, i), vertex(i))
        end do
        call same_after('locate and nearest_vertex, '//what)
        call expect(all(vertex == map), 'the nearest vertex of a point is itself, '//what)
        call expect(all(found > 0), 'points are in tetrahedra, '//what)
        call look()
        call t%check(mgdt_check_canonical)
        call same_after('check, '//what)
        call look()
        call t%get_stat(mgdt_stat_exact_calls, value)
        call same_after('get_stat, '//what)
        call look()
        call t%set_index_base(2, stat, msg)
        call same_after('an error, '//what)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'index base')
        call look()
        call t%clear()
        call same_after('clear, '//what)
    end subroutine
end program
