! SPDX-License-Identifier: MIT
! Generated from mgdt/mgdt_parts.h by bindings/interface/generate.py.
!
! The C functions of parts as they stand in mgdt/mgdt_parts.h. c_parts_NAME is mgdt_parts_NAME.
module mgdt_parts_c
    implicit none
    public

    interface
        function c_parts_create(parts, out) result(status) bind(c, name='mgdt_parts_create')
            use, intrinsic :: iso_c_binding, only: c_int32_t, c_ptr
            integer(c_int32_t), value :: parts
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        function c_parts_create_with_allocator(parts, alloc, release, user, out) &
            result(status) &
            bind(c, name='mgdt_parts_create_with_allocator')
            use, intrinsic :: iso_c_binding, only: c_funptr, c_int32_t, c_ptr
            integer(c_int32_t), value :: parts
            type(c_funptr), value :: alloc
            type(c_funptr), value :: release
            type(c_ptr), value :: user
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        function c_parts_create_with_transport(transport, out) result(status) &
            bind(c, name='mgdt_parts_create_with_transport')
            use, intrinsic :: iso_c_binding, only: c_int32_t, c_ptr
            type(c_ptr), value :: transport
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        subroutine c_parts_destroy(p) bind(c, name='mgdt_parts_destroy')
            use, intrinsic :: iso_c_binding, only: c_ptr
            type(c_ptr), value :: p
        end subroutine
        function c_parts_clear(p) result(status) bind(c, name='mgdt_parts_clear')
            use, intrinsic :: iso_c_binding, only: c_int32_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t) :: status
        end function
        function c_parts_set_option(p, option, value) result(status) &
            bind(c, name='mgdt_parts_set_option')
            use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: option
            integer(c_int64_t), value :: value
            integer(c_int32_t) :: status
        end function
        function c_parts_get_option(p, option, value) result(status) &
            bind(c, name='mgdt_parts_get_option')
            use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: option
            integer(c_int64_t), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_parts_set_progress(p, fn, user) result(status) &
            bind(c, name='mgdt_parts_set_progress')
            use, intrinsic :: iso_c_binding, only: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: p
            type(c_funptr), value :: fn
            type(c_ptr), value :: user
            integer(c_int32_t) :: status
        end function
        function c_parts_get_progress(p, fn, user) result(status) &
            bind(c, name='mgdt_parts_get_progress')
            use, intrinsic :: iso_c_binding, only: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: p
            type(c_funptr), intent(out) :: fn
            type(c_ptr), intent(out) :: user
            integer(c_int32_t) :: status
        end function
        function c_parts_cancel(p) result(status) bind(c, name='mgdt_parts_cancel')
            use, intrinsic :: iso_c_binding, only: c_int32_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t) :: status
        end function
        function c_parts_insert_points(p, part, n, xyz, ids) result(status) &
            bind(c, name='mgdt_parts_insert_points')
            use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: part
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            type(c_ptr), value :: ids
            integer(c_int32_t) :: status
        end function
        function c_parts_build(p) result(status) bind(c, name='mgdt_parts_build')
            use, intrinsic :: iso_c_binding, only: c_int32_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t) :: status
        end function
        function c_parts_build_each(p, look, user) result(status) &
            bind(c, name='mgdt_parts_build_each')
            use, intrinsic :: iso_c_binding, only: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: p
            type(c_funptr), value :: look
            type(c_ptr), value :: user
            integer(c_int32_t) :: status
        end function
        function c_parts_get_stat(p, part, key, value) result(status) &
            bind(c, name='mgdt_parts_get_stat')
            use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: part
            integer(c_int32_t), value :: key
            integer(c_int64_t), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_parts_array_info(array, columns, is_double) result(status) &
            bind(c, name='mgdt_parts_array_info')
            use, intrinsic :: iso_c_binding, only: c_int32_t
            integer(c_int32_t), value :: array
            integer(c_int32_t), intent(inout) :: columns
            integer(c_int32_t), intent(inout) :: is_double
            integer(c_int32_t) :: status
        end function
        function c_parts_get_size(p, part, array, size) result(status) &
            bind(c, name='mgdt_parts_get_size')
            use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: part
            integer(c_int32_t), value :: array
            integer(c_int64_t), intent(inout) :: size
            integer(c_int32_t) :: status
        end function
        function c_parts_get_array(p, part, array, capacity, values) result(status) &
            bind(c, name='mgdt_parts_get_array')
            use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: part
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
        function c_parts_get_coordinates(p, part, capacity, xyz) result(status) &
            bind(c, name='mgdt_parts_get_coordinates')
            use, intrinsic :: iso_c_binding, only: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: part
            integer(c_int64_t), value :: capacity
            real(c_double), intent(inout) :: xyz(*)
            integer(c_int32_t) :: status
        end function
        function c_parts_check(p, level) result(status) bind(c, name='mgdt_parts_check')
            use, intrinsic :: iso_c_binding, only: c_int32_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: level
            integer(c_int32_t) :: status
        end function
        function c_parts_get_error(p, capacity, buffer) result(status) &
            bind(c, name='mgdt_parts_get_error')
            use, intrinsic :: iso_c_binding, only: c_char, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int64_t), value :: capacity
            character(kind=c_char), intent(inout) :: buffer(*)
            integer(c_int32_t) :: status
        end function
    end interface
end module mgdt_parts_c
