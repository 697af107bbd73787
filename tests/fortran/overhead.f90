! SPDX-License-Identifier: MIT
! What the Fortran calls cost over the C calls: insert, get_tetrahedra, get_neighbors. Rounds of
! both take turns; the medians are compared. See overhead.sh.
program overhead
    use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t
    use checks
    use mgdt
    implicit none

    interface
        function c_round(n, xyz) result(status) bind(c)
            import :: c_int32_t, c_int64_t, real64
            integer(c_int64_t), value :: n
            real(real64), intent(in) :: xyz(3, n)
            integer(c_int32_t) :: status
        end function
    end interface

    integer, parameter :: rounds = 9
    real(real64), allocatable :: xyz(:, :)
    real(real64) :: in_c(rounds), in_fortran(rounds), start
    character(20) :: argument
    integer :: i, n

    n = 1000000
    call get_command_argument(1, argument)
    if (argument /= '') read (argument, *) n
    allocate (xyz(3, n))
    call random_seed(put=[(i, i=1, 100)])
    call random_number(xyz)
    call fortran_round()  ! pages and caches are warm for both
    do i = 1, rounds
        start = now()
        if (c_round(size(xyz, 2, kind=c_int64_t), xyz) /= mgdt_ok) error stop 'the C calls failed'
        in_c(i) = now() - start
        start = now()
        call fortran_round()
        in_fortran(i) = now() - start
    end do
    print '(i0,a,f7.3,a,f7.3,a,f6.3)', n, ' points, medians: C ', median(in_c), ' s, Fortran ', &
        median(in_fortran), ' s, ratio ', median(in_fortran)/median(in_c)

contains

    subroutine fortran_round()
        type(mgdt_triangulation) :: t
        integer(int32), allocatable :: v(:, :)

        call t%insert(xyz)
        allocate (v(4, t%tetrahedron_count()))
        call t%get_tetrahedra(v)
        call t%get_neighbors(v)
    end subroutine

    real(real64) function now()
        integer(int64) :: ticks, rate

        call system_clock(ticks, rate)
        now = real(ticks, real64)/real(rate, real64)
    end function

    real(real64) function median(times)
        real(real64), intent(in) :: times(rounds)
        integer :: i, k

        median = times(1)
        do i = 1, rounds
            k = count(times < times(i))
            if (k == rounds/2) median = times(i)
        end do
    end function
end program
