! SPDX-License-Identifier: MIT
! What the Fortran tests share: counting checks, and points whose coordinates are multiples of
! 2^-10, so that determinants of them and sums of these are exact in doubles.
module checks
    use, intrinsic :: iso_fortran_env, only: error_unit, int32, int64, real64
    implicit none
    public

    integer :: n_checks = 0, n_failed = 0

contains

    subroutine expect(condition, what)
        logical, intent(in) :: condition
        character(*), intent(in) :: what

        n_checks = n_checks + 1
        if (condition) return
        n_failed = n_failed + 1
        write (error_unit, '(2a)') 'failed: ', what
    end subroutine

    ! A call that must fail: its status, and what its message must say.
    subroutine expect_error(stat, wanted, errmsg, part)
        integer, intent(in) :: stat, wanted
        character(*), intent(in) :: errmsg, part
        character(12) :: got, should

        write (got, '(i0)') stat
        write (should, '(i0)') wanted
        call expect(stat == wanted, 'status '//trim(got)//' instead of '//trim(should)//': '//part)
        call expect(index(errmsg, part) > 0, '"'//trim(errmsg)//'" does not say "'//part//'"')
    end subroutine

    subroutine conclude()
        print '(i0,a,i0,a)', n_checks, ' checks, ', n_failed, ' failed'
        if (n_failed > 0 .or. n_checks == 0) error stop 1
    end subroutine

    ! Random points in [0, 1); the last tenth repeats the first.
    subroutine make_points(xyz)
        real(real64), intent(out) :: xyz(:, :)
        integer(int64) :: state
        integer :: i, k, fresh

        state = 12345
        fresh = size(xyz, 2) - size(xyz, 2)/10
        do i = 1, fresh
            do k = 1, 3
                state = mod(state*1103515245_int64 + 12345_int64, 2147483648_int64)
                xyz(k, i) = real(state/2097152_int64, real64)/1024
            end do
        end do
        xyz(:, fresh + 1:) = xyz(:, :size(xyz, 2) - fresh)
    end subroutine

    pure function volume6(a, b, c, d) result(v)
        real(real64), intent(in) :: a(3), b(3), c(3), d(3)
        real(real64) :: v

        associate (p => b - a, q => c - a, r => d - a)
            v = r(1)*(p(2)*q(3) - p(3)*q(2)) + r(2)*(p(3)*q(1) - p(1)*q(3)) &
                + r(3)*(p(1)*q(2) - p(2)*q(1))
        end associate
    end function
end module checks
