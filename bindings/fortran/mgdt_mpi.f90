! SPDX-License-Identifier: MIT
! mgdt with MPI: one triangulation of points that are spread over ranks. docs/mpi.md is the guide.
!
! mgdt_mpi_create() makes a type(mgdt_parts_triangulation) of module mgdt_parts, all of which this
! module has too, with one part on each rank. The communicator is an integer: MPI_COMM_WORLD of mpif.h
! and of module mpi, and that of mpi_f08 as MPI_COMM_WORLD%MPI_VAL.
module mgdt_mpi
    use, intrinsic :: iso_c_binding, only: c_int, c_int32_t, c_null_ptr, c_ptr
    use mgdt_mpi_c, only: c_mpi_create_f
    use mgdt_parts
    implicit none
    public
    private :: c_int, c_int32_t, c_null_ptr, c_ptr, c_mpi_create_f

contains

    ! Makes the part of this rank. Collective over the communicator, which is duplicated.
    subroutine mgdt_mpi_create(parts, communicator, stat, errmsg)
        class(mgdt_parts_triangulation), intent(inout) :: parts
        integer, intent(in) :: communicator
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(c_int32_t) :: status

        handle = c_null_ptr
        status = mgdt_ok
        if (.not. parts%is_created()) status = c_mpi_create_f(int(communicator, c_int), handle)
        call parts%adopt('mgdt_mpi_create', handle, status, stat, errmsg)
    end subroutine
end module mgdt_mpi
