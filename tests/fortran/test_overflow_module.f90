! SPDX-License-Identifier: MIT
! Numbers beyond 32 bits (overflow.c) in the module: counts are told, 32-bit results refused.
program test_overflow_module
    use, intrinsic :: iso_c_binding, only: c_f_pointer, c_loc
    use checks
    use mgdt
    implicit none

    type(mgdt_triangulation) :: t
    integer(int32) :: vertex
    integer(int64) :: vertex_64
    integer(int32), target :: few(5)
    integer(int64), target :: few_64(5)
    integer(int32), pointer :: many(:, :), row(:)
    integer(int64), pointer :: many_64(:, :), row_64(:)
    integer :: stat
    character(100) :: msg
    interface
        subroutine limit_memory() bind(c)
        end subroutine
    end interface

    call t%create()
    call expect(t%tetrahedron_count() == 3000000000_int64, 'a count of 64 bits')
    call expect(t%vertex_tetrahedra_count() == 12000000000_int64, 'another one')
    vertex = -5
    call t%nearest_vertex([0._real64, 0._real64, 0._real64], vertex, stat, msg)
    call expect_error(stat, mgdt_err_index_range, msg, 'does not fit a 32-bit integer')
    call expect(vertex == -5, 'not touched')
    call t%nearest_vertex([0._real64, 0._real64, 0._real64], vertex_64)
    call expect(vertex_64 == 3000000000_int64, 'a vertex of 64 bits')

    call t%get_seed(vertex, stat, msg)
    call expect_error(stat, mgdt_err_index_range, msg, '3000000000 does not fit')
    call t%get_memory_limit(vertex, stat, msg)
    call expect_error(stat, mgdt_err_index_range, msg, '-3000000000 does not fit')
    call expect(vertex == -5, 'not touched either')
    call t%get_seed(vertex_64)
    call expect(vertex_64 == 3000000000_int64, 'a seed of 64 bits')

    ! Sections of arrays that are never touched, since there is no memory for a copy.
    call limit_memory()
    call c_f_pointer(c_loc(few), many, [5_int64, 3000000000_int64])
    call c_f_pointer(c_loc(few), row, [5*3000000000_int64])
    call c_f_pointer(c_loc(few_64), many_64, [5_int64, 3000000000_int64])
    call c_f_pointer(c_loc(few_64), row_64, [5*3000000000_int64])
    call t%get_tetrahedra(many(:4, :), stat, msg)
    call expect_error(stat, mgdt_err_out_of_memory, msg, 'no memory for the copy')
    call t%get_tetrahedra(row(::5), stat, msg)
    call expect_error(stat, mgdt_err_out_of_memory, msg, 'no memory for the copy')
    call t%get_tetrahedra(many_64(:4, :), stat, msg)
    call expect_error(stat, mgdt_err_out_of_memory, msg, 'no memory for the copy')
    call t%get_tetrahedra(row_64(::5), stat, msg)
    call expect_error(stat, mgdt_err_out_of_memory, msg, 'no memory for the copy')
    call conclude()
end program
