! SPDX-License-Identifier: MIT
! Generated from mgdt/mgdt_mpi.h by bindings/interface/generate.py.
!
! The C function of libmgdt_mpi that takes a communicator of Fortran's, as it stands in
! mgdt/mgdt_mpi.h. MPI_Fint is an INTEGER of 32 bits.
module mgdt_mpi_c
    implicit none
    public

    interface
        function c_mpi_create_f(communicator, out) result(status) bind(c, name='mgdt_mpi_create_f')
            use, intrinsic :: iso_c_binding, only: c_int, c_int32_t, c_ptr
            integer(c_int), value :: communicator
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
    end interface
end module mgdt_mpi_c
