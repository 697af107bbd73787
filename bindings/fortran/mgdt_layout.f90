! SPDX-License-Identifier: MIT
! Records of a few integers, as C writes them, brought into another layout: n tetrahedra of 4
! vertices become 4 columns of n, or stand at any increments.
module mgdt_layout
    use, intrinsic :: iso_fortran_env, only: int32, int64
    implicit none
    private
    public :: transpose_records, transpose_i32, transpose_i64, place_records

    ! Records that are transposed together, and the most integers in one. Both buffers fit a small
    ! stack.
    integer(int64), parameter :: block = 256, widest = 4

    ! n records of `width` integers at the front of v become `width` columns: integer k of record i
    ! goes to v(i + (k - 1)*ld). In place; ld is n or more.
    interface transpose_records
        module procedure transpose_i32, transpose_i64
    end interface

    ! Writes integer k of record i to v(1 + (i - 1)*next_record + (k - 1)*next_integer).
    interface place_records
        module procedure place_i32, place_i64
    end interface

contains

    ! The place of the block that belongs at a place, both counted from 0, where `groups` times
    ! `width` blocks are transposed.
    pure function source(place, width, groups) result(from)
        integer(int64), intent(in) :: place, width, groups
        integer(int64) :: from

        from = width*mod(place, groups) + place/groups
    end function

    ! Whether no place of its cycle comes before this one.
    pure function is_first(place, width, groups) result(first)
        integer(int64), intent(in) :: place, width, groups
        logical :: first
        integer(int64) :: other

        other = source(place, width, groups)
        do while (other > place)
            other = source(other, width, groups)
        end do
        first = other == place
    end function

    subroutine transpose_i32(v, width, n, ld)
        integer(int32), intent(inout) :: v(*)
        integer(int64), intent(in) :: width, n, ld
        integer(int32) :: rest(widest*block), buffer(widest*block)
        integer(int64) :: groups, whole, start, to, from, i, k

        groups = n/block
        whole = groups*block
        do i = 1, width*(n - whole)
            rest(i) = v(width*whole + i)
        end do
        ! Each group of records becomes blocks: the first integers, the second integers ...
        do start = 0, width*(whole - block), width*block
            do i = 1, width*block
                buffer(i) = v(start + i)
            end do
            do k = 1, width
                do i = 1, block
                    v(start + (k - 1)*block + i) = buffer(width*(i - 1) + k)
                end do
            end do
        end do
        ! The blocks go to their columns, cycle by cycle.
        do start = 1, width*groups - 2
            if (.not. is_first(start, width, groups)) cycle
            do i = 1, block
                buffer(i) = v(block*start + i)
            end do
            to = start
            from = source(to, width, groups)
            do while (from /= start)
                do i = 1, block
                    v(block*to + i) = v(block*from + i)
                end do
                to = from
                from = source(to, width, groups)
            end do
            do i = 1, block
                v(block*to + i) = buffer(i)
            end do
        end do
        ! The columns move apart, the last one first, and get the records of the rest.
        do k = width, 1, -1
            do i = whole, 1, -1
                v((k - 1)*ld + i) = v((k - 1)*whole + i)
            end do
            do i = 1, n - whole
                v((k - 1)*ld + whole + i) = rest(width*(i - 1) + k)
            end do
        end do
    end subroutine

    subroutine place_i32(records, width, n, v, next_record, next_integer)
        integer(int32), intent(in) :: records(*)
        integer(int64), intent(in) :: width, n, next_record, next_integer
        integer(int32), intent(inout) :: v(*)
        integer(int64) :: i, k

        do i = 0, n - 1
            do k = 0, width - 1
                v(1 + i*next_record + k*next_integer) = records(width*i + k + 1)
            end do
        end do
    end subroutine

    subroutine transpose_i64(v, width, n, ld)
        integer(int64), intent(inout) :: v(*)
        integer(int64), intent(in) :: width, n, ld
        integer(int64) :: rest(widest*block), buffer(widest*block)
        integer(int64) :: groups, whole, start, to, from, i, k

        groups = n/block
        whole = groups*block
        do i = 1, width*(n - whole)
            rest(i) = v(width*whole + i)
        end do
        ! Each group of records becomes blocks: the first integers, the second integers ...
        do start = 0, width*(whole - block), width*block
            do i = 1, width*block
                buffer(i) = v(start + i)
            end do
            do k = 1, width
                do i = 1, block
                    v(start + (k - 1)*block + i) = buffer(width*(i - 1) + k)
                end do
            end do
        end do
        ! The blocks go to their columns, cycle by cycle.
        do start = 1, width*groups - 2
            if (.not. is_first(start, width, groups)) cycle
            do i = 1, block
                buffer(i) = v(block*start + i)
            end do
            to = start
            from = source(to, width, groups)
            do while (from /= start)
                do i = 1, block
                    v(block*to + i) = v(block*from + i)
                end do
                to = from
                from = source(to, width, groups)
            end do
            do i = 1, block
                v(block*to + i) = buffer(i)
            end do
        end do
        ! The columns move apart, the last one first, and get the records of the rest.
        do k = width, 1, -1
            do i = whole, 1, -1
                v((k - 1)*ld + i) = v((k - 1)*whole + i)
            end do
            do i = 1, n - whole
                v((k - 1)*ld + whole + i) = rest(width*(i - 1) + k)
            end do
        end do
    end subroutine

    subroutine place_i64(records, width, n, v, next_record, next_integer)
        integer(int64), intent(in) :: records(*)
        integer(int64), intent(in) :: width, n, next_record, next_integer
        integer(int64), intent(inout) :: v(*)
        integer(int64) :: i, k

        do i = 0, n - 1
            do k = 0, width - 1
                v(1 + i*next_record + k*next_integer) = records(width*i + k + 1)
            end do
        end do
    end subroutine
end module mgdt_layout
