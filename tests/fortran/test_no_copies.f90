! SPDX-License-Identifier: MIT
! The library gets the caller's own arrays: spy.c tells the address that it was given.
program test_no_copies
    use, intrinsic :: iso_c_binding, only: c_associated, c_loc, c_ptr
    use checks
    use mgdt
    implicit none

    interface
        function spy_seen() result(address) bind(c)
            import :: c_ptr
            type(c_ptr) :: address
        end function
    end interface

    integer, parameter :: n = 100
    type(mgdt_triangulation) :: t
    real(real64), target :: xyz(3, n), flat(3*n), wide(3, 2*n), columns(n, 3), weights(4, n)
    integer(int32), allocatable, target :: tets(:, :)
    integer(int64), allocatable, target :: tets_1(:)
    integer(int32), allocatable, target :: rows(:, :)
    integer(int64), allocatable, target :: rows_64(:, :)
    integer, allocatable, target :: columns_77(:, :)
    integer :: h(4), ierr
    integer(int64) :: found(n)

    call make_points(xyz)
    flat = reshape(xyz, [3*n])
    columns = transpose(xyz)
    wide(:, 1::2) = xyz
    call t%insert(xyz)
    call expect(c_associated(spy_seen(), c_loc(xyz)), 'xyz(3, n)')
    call t%insert(flat)
    call expect(c_associated(spy_seen(), c_loc(flat)), 'xyz(3 n)')
    call t%insert(wide(:, 1::2))
    call expect(c_associated(spy_seen(), c_loc(wide)), 'every other column')
    call t%insert(columns(:, 1), columns(:, 2), columns(:, 3))
    call expect(c_associated(spy_seen(), c_loc(columns)), 'columns of (n, 3)')
    call t%insert(xyz(1, n:1:-1), xyz(2, n:1:-1), xyz(3, n:1:-1))
    call expect(c_associated(spy_seen(), c_loc(xyz(1, n))), 'rows of (3, n) backwards')
    call t%insert(flat(1::3), columns(:, 2), columns(:, 3))
    call expect(.not. c_associated(spy_seen(), c_loc(flat)), 'different strides are packed')
    call expect(t%vertex_count() == n - n/10 .and. t%point_count() == 6*n, 'the same points')

    allocate (tets(4, t%tetrahedron_count()), tets_1(4*t%tetrahedron_count()))
    call t%get_tetrahedra(tets)
    call expect(c_associated(spy_seen(), c_loc(tets)), 'tetrahedra(4, n)')
    call t%get_tetrahedra(tets_1)
    call expect(c_associated(spy_seen(), c_loc(tets_1)), 'tetrahedra(4 n)')
    allocate (rows(t%tetrahedron_count(), 4), rows_64(t%tetrahedron_count(), 4))
    call t%get_tetrahedra(rows, dim=2)
    call expect(c_associated(spy_seen(), c_loc(rows)), 'tetrahedra(n, 4)')
    call t%get_tetrahedra(rows_64, dim=2)
    call expect(c_associated(spy_seen(), c_loc(rows_64)), 'tetrahedra(n, 4) of 64 bits')
    allocate (columns_77(1000, 4))
    call t%get_tetrahedra(columns_77, dim=2) ! else the compiler may take its address for its own
    call mgnew(h, ierr)
    call mgins(h, n, xyz, ierr)
    call mgteti(h, size(columns_77, 1), columns_77, 1, size(columns_77, 1), ierr)
    call expect(ierr == 0, 'MGTETI')
    call expect(c_associated(spy_seen(), c_loc(columns_77)), 'ITET(MAXT, 4)')
    call mgfree(h, ierr)
    call t%locate_points(xyz, found)
    call expect(c_associated(spy_seen(), c_loc(xyz)), 'points to be located')
    call t%locate_points(xyz, found, weights)
    call expect(c_associated(spy_seen(), c_loc(weights)), 'weights')
    call conclude()
end program
