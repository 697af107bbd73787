! SPDX-License-Identifier: MIT
! OpenMP: a triangulation for each thread, and calls that only read from all threads at once.
program test_threads
    use omp_lib, only: omp_get_num_threads
    use checks
    use mgdt
    implicit none

    integer, parameter :: n = 2000, n_meshes = 8
    real(real64) :: xyz(3, n)
    type(mgdt_triangulation) :: shared, meshes(n_meshes)
    integer(int32), allocatable :: wanted(:, :)
    integer(int32) :: found(n), alone(n), vertex
    integer :: i, stat, wrong, threads

    call make_points(xyz)
    call shared%set_canonical_output(.true.)
    call shared%insert(xyz)
    allocate (wanted(4, shared%tetrahedron_count()))
    call shared%get_tetrahedra(wanted)

    wrong = 0
    threads = 1
    !$omp parallel do num_threads(4) reduction(+:wrong) reduction(max:threads)
    do i = 1, n_meshes
        threads = omp_get_num_threads()
        call meshes(i)%set_canonical_output(.true.)
        call meshes(i)%insert(xyz)
        if (.not. same(meshes(i))) wrong = wrong + 1
    end do
    !$omp end parallel do
    call expect(threads > 1, 'several threads')
    call expect(wrong == 0, 'a triangulation for each thread')

    wrong = 0
    !$omp parallel do num_threads(4) private(stat, vertex) reduction(+:wrong)
    do i = 1, n
        call shared%locate(xyz(:, i), found(i), stat=stat)
        if (stat /= mgdt_ok) wrong = wrong + 1
        call shared%nearest_vertex(xyz(:, i), vertex)
        if (any(abs(xyz(:, vertex) - xyz(:, i)) > 0)) wrong = wrong + 1
        if (mod(i, 500) == 0) then
            if (.not. same(shared)) wrong = wrong + 1
            call shared%check(4, stat=stat)
            if (stat /= mgdt_err_invalid_argument) wrong = wrong + 1
        end if
    end do
    !$omp end parallel do
    call expect(wrong == 0, 'calls that only read')
    do i = 1, n
        call shared%locate(xyz(:, i), alone(i))
    end do
    call expect(all(found > 0) .and. all(alone > 0), 'found by many threads and by one')
    call conclude()

contains

    logical function same(t)
        type(mgdt_triangulation), intent(in) :: t
        integer(int32), allocatable :: got(:, :)

        allocate (got(4, t%tetrahedron_count()))
        call t%get_tetrahedra(got)
        same = all(shape(got) == shape(wanted))
        if (same) same = all(got == wanted)
    end function
end program
