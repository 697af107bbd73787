! SPDX-License-Identifier: MIT
! Numbers beyond 32 bits (overflow.c) in the module: counts are told, 32-bit results refused.
program test_overflow_module
    use checks
    use mgdt
    implicit none

    type(mgdt_triangulation) :: t
    integer(int32) :: vertex
    integer(int64) :: vertex_64
    integer :: stat
    character(100) :: msg

    call t%create()
    call expect(t%tetrahedron_count() == 3000000000_int64, 'a count of 64 bits')
    call expect(t%vertex_tetrahedra_count() == 12000000000_int64, 'another one')
    vertex = -5
    call t%nearest_vertex([0._real64, 0._real64, 0._real64], vertex, stat, msg)
    call expect_error(stat, mgdt_err_index_range, msg, 'vertex 3000000000 does not fit')
    call expect(vertex == -5, 'not touched')
    call t%nearest_vertex([0._real64, 0._real64, 0._real64], vertex_64)
    call expect(vertex_64 == 3000000000_int64, 'a vertex of 64 bits')
    call conclude()
end program
