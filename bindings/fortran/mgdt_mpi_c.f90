! SPDX-License-Identifier: MIT
! The C functions of libmgdt_mpi as they stand in mgdt/mgdt_mpi.h; c_mpi_NAME is mgdt_mpi_NAME.
module mgdt_mpi_c
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_funptr, c_int, c_int32_t, &
                                           c_int64_t, c_ptr
    implicit none
    public

    interface
        ! MPI_Fint is the default integer of the C compiler's partner, 32 bits.
        function c_mpi_create_f(communicator, out) result(status) bind(c, name='mgdt_mpi_create_f')
            import :: c_int, c_int32_t, c_ptr
            integer(c_int), value :: communicator
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function

        subroutine c_mpi_destroy(m) bind(c, name='mgdt_mpi_destroy')
            import :: c_ptr
            type(c_ptr), value :: m
        end subroutine

        function c_mpi_clear(m) result(status) bind(c, name='mgdt_mpi_clear')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t) :: status
        end function

        function c_mpi_set_option(m, option, value) result(status) bind(c, name='mgdt_mpi_set_option')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: option
            integer(c_int64_t), value :: value
            integer(c_int32_t) :: status
        end function

        function c_mpi_get_option(m, option, value) result(status) bind(c, name='mgdt_mpi_get_option')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: option
            integer(c_int64_t), intent(inout) :: value
            integer(c_int32_t) :: status
        end function

        function c_mpi_set_progress(m, fn, user) result(status) &
            bind(c, name='mgdt_mpi_set_progress')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: m
            type(c_funptr), value :: fn
            type(c_ptr), value :: user
            integer(c_int32_t) :: status
        end function

        function c_mpi_cancel(m) result(status) bind(c, name='mgdt_mpi_cancel')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t) :: status
        end function

        ! ids may be null.
        function c_mpi_insert_points(m, n, xyz, ids) result(status) &
            bind(c, name='mgdt_mpi_insert_points')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            type(c_ptr), value :: ids
            integer(c_int32_t) :: status
        end function

        function c_mpi_build(m) result(status) bind(c, name='mgdt_mpi_build')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t) :: status
        end function

        function c_mpi_get_stat(m, key, value) result(status) bind(c, name='mgdt_mpi_get_stat')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: key
            integer(c_int64_t), intent(inout) :: value
            integer(c_int32_t) :: status
        end function

        function c_mpi_get_size(m, array, length) result(status) bind(c, name='mgdt_mpi_get_size')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: array
            integer(c_int64_t), intent(inout) :: length
            integer(c_int32_t) :: status
        end function

        function c_mpi_get_array(m, array, capacity, values) result(status) &
            bind(c, name='mgdt_mpi_get_array')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function

        function c_mpi_get_coordinates(m, capacity, xyz) result(status) &
            bind(c, name='mgdt_mpi_get_coordinates')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: capacity
            real(c_double), intent(inout) :: xyz(*)
            integer(c_int32_t) :: status
        end function

        function c_mpi_check(m, level) result(status) bind(c, name='mgdt_mpi_check')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: level
            integer(c_int32_t) :: status
        end function

        function c_mpi_get_error(m, capacity, buffer) result(status) &
            bind(c, name='mgdt_mpi_get_error')
            import :: c_char, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: capacity
            character(kind=c_char), intent(inout) :: buffer(*)
            integer(c_int32_t) :: status
        end function
    end interface

contains

    ! The message of the handle's last failure; empty if there is none.
    function last_mpi_message(handle) result(text)
        use mgdt_support, only: text_of
        type(c_ptr), intent(in) :: handle
        character(:), allocatable :: text
        character(kind=c_char) :: buffer(256)

        text = ''
        if (c_mpi_get_error(handle, size(buffer, kind=c_int64_t), buffer) == 0) &
            text = text_of(buffer)
    end function
end module mgdt_mpi_c
