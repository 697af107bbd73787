! SPDX-License-Identifier: MIT
! Module mgdt_mpi on ranks: what goes in and comes out, beside one triangulation, and every error.
program test_mpi
    use mpi
    use mgdt, only: mgdt_triangulation
    use mgdt_mpi
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use checks
    implicit none

    integer, parameter :: n = 600
    type(mgdt_parts_triangulation) :: t, unmade
    type(mgdt_triangulation) :: one
    real(real64) :: xyz(3, n)
    real(real64), allocatable :: at(:, :), mine(:, :)
    integer(int64), allocatable :: v(:), corners(:, :), ids(:), neighbors(:, :)
    integer(int32), allocatable :: short(:), short_corners(:, :), my_ids(:)
    integer :: ierr, rank, ranks, stat, i, k, heard
    integer(int64) :: own, owned
    real(real64) :: volume, whole
    character(200) :: message

    call MPI_Init(ierr)
    call MPI_Comm_rank(MPI_COMM_WORLD, rank, ierr)
    call MPI_Comm_size(MPI_COMM_WORLD, ranks, ierr)
    call make_points(xyz)
    my_ids = [(i, i=rank + 1, n, ranks)]
    mine = xyz(:, my_ids)
    call one%insert(xyz)

    call mgdt_mpi_create(t, MPI_COMM_WORLD)
    call t%insert(mine)
    call t%build()
    call t%check()
    call expect(t%number(mgdt_parts_all_tetrahedra) == one%tetrahedron_count(), 'as many as one has')
    call expect(t%number(mgdt_parts_all_vertices) == one%vertex_count(), 'vertices')
    call expect(t%number(mgdt_parts_points) == size(my_ids), 'points')
    own = t%number(mgdt_parts_own_vertices)
    owned = t%number(mgdt_parts_own_tetrahedra)
    call t%get(mgdt_parts_local_corners, corners)
    call t%get(mgdt_parts_local_corners, short_corners)
    call expect(all(corners == short_corners), 'short corners')
    call expect(minval(corners) >= 1 .and. &
                maxval(corners) <= t%number(mgdt_parts_vertices), 'places from 1 on')
    call t%get_coordinates(at)
    call t%get(mgdt_parts_vertex_numbers, v)
    call t%get(mgdt_parts_vertex_numbers, short)
    call expect(size(v) == size(at, 2) .and. all(v == short), 'numbers')
    call expect(all(v(2:own) == v(:own - 1) + 1), 'own ones follow one another')
    call t%get(mgdt_parts_neighbors, neighbors)
    call expect(size(neighbors, 2) == owned .and. minval(neighbors) >= 0, 'neighbours')
    volume = 0
    do k = 1, int(owned)
        volume = volume + volume6(at(:, corners(1, k)), at(:, corners(2, k)), &
                                  at(:, corners(3, k)), at(:, corners(4, k)))
    end do
    call MPI_Allreduce(volume, whole, 1, MPI_DOUBLE_PRECISION, MPI_SUM, MPI_COMM_WORLD, ierr)
    call expect(abs(whole - volume_of(one)) < 1e-12_real64*whole, 'the volume of all')
    call t%get(mgdt_parts_point_map, v)
    call expect(size(v) == size(my_ids), 'a vertex for each point')

    ! With ids of either kind, and a flat list of coordinates.
    call t%clear()
    call t%insert(mine, my_ids)
    call t%build()
    call t%get(mgdt_parts_vertex_ids, ids)
    call t%get_coordinates(at)
    call expect(all(at == xyz(:, ids)), 'the ids of vertices')
    call t%clear()
    call t%insert(mine, int(my_ids, int64))
    call t%build()
    call expect(t%number(mgdt_parts_all_tetrahedra) == one%tetrahedron_count(), 'with long ids')
    call t%clear()
    call t%insert([mine])
    call t%set_option(mgdt_parts_threads, 2)
    call expect(t%get_option(mgdt_parts_threads) == 2, 'the option')
    call t%set_option(mgdt_parts_memory_limit, 10**8)
    heard = 0
    call t%set_progress(hear)
    call t%build()
    call expect(heard > 5, 'progress')
    call t%set_progress(stop_at_once)
    call t%build(stat, message)
    call expect_error(stat, mgdt_err_cancelled, message, 'cancelled')
    call t%remove_progress()
    call t%cancel()
    call t%build(stat, message)
    call expect_error(stat, mgdt_err_cancelled, message, 'cancelled')
    call t%build(stat)
    call expect(stat == mgdt_ok, 'goes on')

    ! Errors.
    call mgdt_mpi_create(t, MPI_COMM_WORLD, stat, message)
    call expect_error(stat, mgdt_err_invalid_argument, message, 'made already')
    call t%insert(mine(:2, :), stat, message)
    call expect_error(stat, mgdt_err_invalid_argument, message, 'extents 2 and')
    call t%insert([1._real64, 2._real64], stat, message)
    call expect_error(stat, mgdt_err_invalid_argument, message, 'xyz has 2 elements')
    call t%insert(mine, my_ids(2:), stat, message)
    call expect_error(stat, mgdt_err_invalid_argument, message, 'they must be 3 and')
    call t%get(mgdt_parts_vertex_ids, corners, stat, message)
    call expect_error(stat, mgdt_err_invalid_argument, message, 'no four numbers')
    call t%get(77, v, stat, message)
    call expect_error(stat, mgdt_err_unknown_key, message, 'no array 77')
    owned = t%number(77, stat, message)
    call expect_error(stat, mgdt_err_unknown_key, message, 'no number 77')
    call t%set_option(mgdt_parts_index_base, 7, stat, message)
    call expect_error(stat, mgdt_err_invalid_argument, message, '7 is out of the range')
    call t%check(9, stat, message)
    call expect_error(stat, mgdt_err_invalid_argument, message, 'no check level 9')
    call unmade%build(stat, message)
    call expect_error(stat, mgdt_err_null_pointer, message, 'has not been created')
    ids = [(int(huge(0_int32), int64) + i, i=1, size(my_ids))] + n*rank
    call t%clear()
    call t%insert(mine, ids)
    call t%build()
    call t%get(mgdt_parts_vertex_ids, short, stat, message)
    call expect(own == 0 .or. stat == mgdt_err_index_range, 'ids that do not fit')

    call t%destroy()
    call mgdt_mpi_create(t, MPI_COMM_WORLD)
    call expect(t%number(mgdt_parts_all_vertices) == 0, 'a new one is empty')
    call t%destroy()
    call MPI_Finalize(ierr)
    call conclude()

contains

    subroutine hear(fraction, cancel)
        real(real64), intent(in) :: fraction
        logical, intent(inout) :: cancel

        if (fraction >= 0 .and. .not. cancel) heard = heard + 1
    end subroutine

    subroutine stop_at_once(fraction, cancel)
        real(real64), intent(in) :: fraction
        logical, intent(inout) :: cancel

        cancel = fraction >= 0
    end subroutine

    function volume_of(all) result(sum)
        type(mgdt_triangulation), intent(in) :: all
        real(real64) :: sum
        integer, allocatable :: v(:, :)
        integer :: i

        allocate (v(4, all%tetrahedron_count()))
        call all%get_tetrahedra(v)
        sum = 0
        do i = 1, size(v, 2)
            sum = sum + volume6(xyz(:, v(1, i)), xyz(:, v(2, i)), xyz(:, v(3, i)), xyz(:, v(4, i)))
        end do
    end function
end program
