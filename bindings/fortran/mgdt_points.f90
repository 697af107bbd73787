! SPDX-License-Identifier: MIT
! Points from the caller's arrays to C, read where they are.
submodule (mgdt) mgdt_points
    use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t, c_intptr_t, c_loc
    use mgdt_c, only: c_insert_points_strided
    use mgdt_support, only: decimal, finish, make, report
    implicit none

    integer(c_int64_t), parameter :: real_bytes = 8

contains

    module procedure insert_xyz_1
        integer(int64) :: n

        n = size(xyz, kind=int64)/3
        if (3*n /= size(xyz, kind=int64)) then
            call report('insert', int(mgdt_err_invalid_argument, c_int32_t), &
                      'xyz has '//decimal(size(xyz, kind=int64))// &
                      ' elements; they must be 3 a point', stat, errmsg)
        else
            call insert_sections(self, n, xyz(1::3), xyz(2::3), xyz(3::3), stat, errmsg)
        end if
    end procedure

    module procedure insert_xyz_2
        if (size(xyz, 1) /= 3) then
            call report('insert', int(mgdt_err_invalid_argument, c_int32_t), &
                      'xyz has extent '//decimal(size(xyz, 1, kind=int64))// &
                      ' in dimension 1; it must be 3', stat, errmsg)
        else
            call insert_sections(self, size(xyz, 2, kind=int64), xyz(1, :), xyz(2, :), xyz(3, :), &
                                 stat, errmsg)
        end if
    end procedure

    module procedure insert_x_y_z
        if (any([size(y, kind=int64), size(z, kind=int64)] /= size(x, kind=int64))) then
            call report('insert', int(mgdt_err_invalid_argument, c_int32_t), &
                      'x has '//decimal(size(x, kind=int64))//' elements, y '// &
                      decimal(size(y, kind=int64))//', z '//decimal(size(z, kind=int64)), &
                      stat, errmsg)
        else
            call insert_sections(self, size(x, kind=int64), x, y, z, stat, errmsg)
        end if
    end procedure

    ! C takes one stride for all three. Sections that have it are read in place.
    subroutine insert_sections(self, n, x, y, z, stat, errmsg)
        class(mgdt_triangulation), intent(inout) :: self
        integer(int64), intent(in) :: n
        real(real64), intent(in), target :: x(:), y(:), z(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int64_t) :: bytes(3)
        integer(c_int32_t) :: status

        bytes = real_bytes
        if (n > 1) bytes = [distance(x(1), x(2)), distance(y(1), y(2)), distance(z(1), z(2))]
        call make(self%handle, status)
        if (status == mgdt_ok) then
            if (n == 0) then
                status = c_insert_points_strided(self%handle, n, c_null_ptr, c_null_ptr, &
                                                 c_null_ptr, 1_c_int64_t)
            else if (all(bytes == bytes(1)) .and. mod(bytes(1), real_bytes) == 0) then
                status = c_insert_points_strided(self%handle, n, c_loc(x(1)), c_loc(y(1)), &
                                                 c_loc(z(1)), bytes(1)/real_bytes)
            else
                status = insert_packed(self%handle, n, x, y, z)
            end if
        end if
        call finish(self%handle, 'insert', status, stat, errmsg)
    end subroutine

    ! Here the compiler packs what is not contiguous.
    function insert_packed(handle, n, x, y, z) result(status)
        type(c_ptr), intent(in) :: handle
        integer(int64), intent(in) :: n
        real(real64), contiguous, intent(in), target :: x(:), y(:), z(:)
        integer(c_int32_t) :: status

        status = c_insert_points_strided(handle, n, c_loc(x), c_loc(y), c_loc(z), 1_c_int64_t)
    end function

    function distance(a, b) result(bytes)
        real(real64), intent(in), target :: a, b
        integer(c_int64_t) :: bytes

        bytes = transfer(c_loc(b), 0_c_intptr_t) - transfer(c_loc(a), 0_c_intptr_t)
    end function
end submodule mgdt_points
