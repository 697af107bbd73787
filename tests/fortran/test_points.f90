! SPDX-License-Identifier: MIT
! The same points from arrays of every shape and stride give the same tetrahedra.
program test_points
    use checks
    use mgdt
    implicit none

    integer, parameter :: n = 300
    type :: node
        integer :: number
        real(real64) :: x, y, z
    end type
    real(real64) :: xyz(3, n)
    integer(int32), allocatable :: wanted(:, :)
    type(mgdt_triangulation) :: t

    call make_points(xyz)
    call t%set_canonical_output(.true.)
    call t%insert(xyz)
    allocate (wanted(4, t%tetrahedron_count()))
    call t%get_tetrahedra(wanted)
    call t%check(mgdt_check_canonical)

    call test_rank_1()
    call test_sections()
    call test_separate_arrays()
    call test_records()
    call test_calls()
    call test_flat()
    call test_changes()
    call conclude()

contains

    subroutine expect_same(what)
        character(*), intent(in) :: what
        integer(int32), allocatable :: got(:, :)

        allocate (got(4, t%tetrahedron_count()))
        call t%get_tetrahedra(got)
        call expect(all(shape(got) == shape(wanted)), what//': number')
        if (all(shape(got) == shape(wanted))) call expect(all(got == wanted), what)
        call t%clear()
        call expect(t%point_count() == 0 .and. t%dimension() == -1, what//': cleared')
    end subroutine

    subroutine test_rank_1()
        real(real64) :: flat(3*n), wide(9*n)

        flat = reshape(xyz, [3*n])
        call t%clear()
        call t%insert(flat)
        call expect_same('rank 1')
        wide = 7
        wide(2::3) = flat
        call t%insert(wide(2::3))
        call expect_same('rank 1 with a stride')
        call t%insert(flat(3*n:1:-1))
        call expect(t%vertex_count() > 0, 'backwards, which are other points')
        call t%clear()
    end subroutine

    subroutine test_sections()
        real(real64) :: rows(5, n), columns(3, 2*n), backwards(3, n), transposed(n, 3)

        rows = 7
        rows(2:4, :) = xyz
        call t%insert(rows(2:4, :))
        call expect_same('a section of rows')
        rows(5:1:-2, :) = xyz
        call t%insert(rows(5:1:-2, :))
        call expect_same('rows backwards')
        columns = 7
        columns(:, 2::2) = xyz
        call t%insert(columns(:, 2::2))
        call expect_same('every other column')
        backwards = xyz(:, n:1:-1)
        call t%insert(backwards(:, n:1:-1))
        call expect_same('columns backwards')
        transposed = transpose(xyz)
        call t%insert(transpose(transposed))
        call expect_same('an expression')
    end subroutine

    subroutine test_separate_arrays()
        real(real64) :: x(n), y(2*n), z(n), transposed(n, 3)

        transposed = transpose(xyz)
        call t%insert(transposed(:, 1), transposed(:, 2), transposed(:, 3))
        call expect_same('columns of (n, 3)')
        call t%insert(xyz(1, :), xyz(2, :), xyz(3, :))
        call expect_same('rows of (3, n)')
        x = xyz(1, n:1:-1)
        y = 7
        y(2::2) = xyz(2, :)
        z = xyz(3, :)
        call t%insert(x(n:1:-1), y(2::2), z)
        call expect_same('three strides')
    end subroutine

    subroutine test_records()
        type(node) :: nodes(n)

        nodes%number = 7
        nodes%x = xyz(1, :)
        nodes%y = xyz(2, :)
        nodes%z = xyz(3, :)
        call t%insert(nodes%x, nodes%y, nodes%z)
        call expect_same('components of records')
    end subroutine

    ! In several calls, one of them of nothing, one of a single point.
    subroutine test_calls()
        call t%reserve(n)
        call t%insert(xyz(:, :1))
        call t%insert(xyz(:, 2:1))
        call t%insert(xyz(1, 2:1), xyz(2, 2:1), xyz(3, 2:1))
        call t%insert(xyz(1, 2:2), xyz(2, 2:2), xyz(3, 2:2))
        call t%insert(xyz(:, 3:100))
        call t%insert(reshape(xyz(:, 101:), [3*(n - 100)]))
        call expect_same('several calls')
        call t%reserve(1000_int64)
    end subroutine

    subroutine test_flat()
        real(real64) :: flat(3, n)

        flat = xyz
        flat(3, :) = 0.5_real64
        call t%insert(flat)
        call expect(t%dimension() == 2 .and. t%tetrahedron_count() == 0, 'points of a plane wait')
        call t%insert([0._real64, 0._real64, 1._real64])
        call expect(t%dimension() == 3 .and. t%tetrahedron_count() > 0, 'and go in with one above it')
        call t%check(mgdt_check_canonical)
    end subroutine

    ! The last third leaves, the middle one moves, and all are numbered anew: the same as without.
    subroutine test_changes()
        type(mgdt_triangulation) :: other
        real(real64) :: places(3, n)
        integer(int32) :: i, new32(n), last(n/3)
        integer(int64) :: new(n), middle(n/3)
        integer :: stat
        character(256) :: message

        last = [(int(2*n/3 + i, int32), i=1, n/3)]
        middle = [(int(n/3 + i, int64), i=1, n/3)]
        call other%set_canonical_output(.true.)
        call other%insert(xyz)
        places = xyz
        places(:, n/3 + 1:2*n/3) = 0.25_real64*xyz(:, n/3 + 1:2*n/3)
        call other%move_points(middle, places(:, n/3 + 1:2*n/3))
        call other%move_points(int(middle(:2), int32), reshape(xyz(:, n/3 + 1:n/3 + 2), [6]))
        call other%move_points(middle(:2), reshape(xyz(:, n/3 + 1:n/3 + 2), [6]))
        call other%move_points(int(middle(:2), int32), xyz(:, n/3 + 1:n/3 + 2))
        call other%remove_points(last)
        places(:, n/3 + 1:n/3 + 2) = xyz(:, n/3 + 1:n/3 + 2)
        call expect(other%point_count() == n, 'points that are out are counted')
        call other%move_points(places)
        call other%move_points(reshape(places, [3*n]))
        call other%renumber_points(new)
        call expect(all(new == [(i, i=1, 2*n/3), (0_int32, i=1, n/3)]), 'new numbers')
        call expect(other%point_count() == 2*n/3, 'and then they are not')
        call other%renumber_points(new32(:2*n/3))
        call expect(all(new32(:2*n/3) == [(i, i=1, 2*n/3)]), 'nothing to renumber')
        call other%check(mgdt_check_canonical)
        call t%clear()
        call t%insert(places(:, :2*n/3))
        deallocate (wanted)
        allocate (wanted(4, other%tetrahedron_count()))
        call other%get_tetrahedra(wanted)
        call expect_same('after removals and moves')

        call other%remove_points([1, 7, 1], stat, message)
        call expect(stat == mgdt_err_invalid_argument .and. index(message, 'point 1 is') > 0, message)
        call other%remove_points([0_int64], stat, message)
        call expect(stat == mgdt_err_invalid_argument, 'there is no point 0')
        call other%move_points([1, 2], places(:, :3), stat, message)
        call expect(stat == mgdt_err_invalid_argument .and. message == 'there are 2 points and 3 places', &
                    message)
        call other%move_points(places(:2, :), stat, message)
        call expect(stat == mgdt_err_invalid_argument, 'xyz(2, n)')
        call other%move_points(middle, places(:2, :n/3), stat, message)
        call expect(stat == mgdt_err_invalid_argument, 'two coordinates')
        call other%move_points(middle(:0), places(:, :0))
        call other%remove_points(middle(:0))
        call other%renumber_points(new(:3), stat, message)
        call expect(stat == mgdt_err_buffer_too_small, 'new_index(3)')
    end subroutine
end program
