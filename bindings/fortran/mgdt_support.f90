! SPDX-License-Identifier: MIT
! What both Fortran interfaces need to speak with C: integers, strings, and how errors are reported.
module mgdt_support
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_int32_t, &
                                           c_int64_t, c_null_char, c_ptr
    use, intrinsic :: iso_fortran_env, only: error_unit, int32, int64
    use mgdt_c, only: c_create, c_destroy, c_get_error, c_set_index_base, c_status_string, c_strlen
    use mgdt_constants, only: mgdt_err_index_range, mgdt_err_null_pointer, mgdt_ok
    implicit none
    private
    public :: to_c, c_text, text_of, last_message, make, borrow, finish, finish_on, report, narrow, decimal

    abstract interface
        function c_get_message(handle, capacity, buffer) result(status) bind(c)
            import :: c_char, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: handle
            integer(c_int64_t), value :: capacity
            character(kind=c_char), intent(inout) :: buffer(*)
            integer(c_int32_t) :: status
        end function
    end interface

contains

    ! A default integer for C. With -fdefault-integer-8 it may not fit: the nearest number that does
    ! is out of every documented range too, where wrapping round could land inside one.
    elemental function to_c(value) result(number)
        integer, intent(in) :: value
        integer(c_int32_t) :: number
        integer(int64), parameter :: most = huge(0_c_int32_t)

        number = int(max(-most - 1, min(most, int(value, int64))), c_int32_t)
    end function

    ! A Fortran string of a C one; empty for a null pointer.
    function c_text(pointer) result(text)
        type(c_ptr), intent(in) :: pointer
        character(:), allocatable :: text
        character(kind=c_char), pointer :: characters(:)
        integer(int64) :: length, i

        length = 0
        if (c_associated(pointer)) then
            length = int(c_strlen(pointer), int64)
            call c_f_pointer(pointer, characters, [length])
        end if
        allocate (character(length) :: text)
        do i = 1, length
            text(i:i) = characters(i)
        end do
    end function

    ! The message of the handle's last failure; empty if there is none.
    function last_message(handle) result(text)
        type(c_ptr), intent(in) :: handle
        character(:), allocatable :: text

        text = message_of(handle, c_get_error)
    end function

    ! The message that get_error gives; empty if there is none.
    function message_of(handle, get_error) result(text)
        type(c_ptr), intent(in) :: handle
        procedure(c_get_message) :: get_error
        character(:), allocatable :: text
        character(kind=c_char) :: buffer(256)

        text = ''
        if (get_error(handle, size(buffer, kind=c_int64_t), buffer) == mgdt_ok) text = text_of(buffer)
    end function

    ! What is in a buffer of C's, up to its NUL.
    function text_of(buffer) result(text)
        character(kind=c_char), intent(in) :: buffer(:)
        character(:), allocatable :: text
        integer :: i, length

        length = 0
        do while (buffer(length + 1) /= c_null_char)
            length = length + 1
        end do
        allocate (character(length) :: text)
        do i = 1, length
            text(i:i) = buffer(i)
        end do
    end function

    ! A handle that is there: an empty one with Fortran's index base if there is none yet.
    subroutine make(handle, status)
        type(c_ptr), intent(inout) :: handle
        integer(c_int32_t), intent(out) :: status

        status = mgdt_ok
        if (c_associated(handle)) return
        status = c_create(handle)
        if (status == mgdt_ok) status = c_set_index_base(handle, 1_c_int32_t)
    end subroutine

    ! For calls that only read: the handle, or an empty one in its stead, which finish() frees.
    subroutine borrow(owned, handle, status)
        type(c_ptr), intent(in) :: owned
        type(c_ptr), intent(out) :: handle
        integer(c_int32_t), intent(out) :: status

        handle = owned
        call make(handle, status)
    end subroutine

    ! The end of every call on a handle.
    subroutine finish(handle, procedure, status, stat, errmsg, owned)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: procedure
        integer(c_int32_t), intent(in) :: status
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(c_ptr), intent(in), optional :: owned
        character(:), allocatable :: message

        message = ''
        if (status /= mgdt_ok) message = last_message(handle)
        if (status /= mgdt_ok .and. message == '') message = c_text(c_status_string(status))
        if (present(owned)) then
            if (.not. c_associated(owned)) call c_destroy(handle)
        end if
        call report(procedure, status, message, stat, errmsg)
    end subroutine

    ! The end of every call on a handle of another kind, which get_error has messages of. `what` names
    ! the object. The handle has no message for the status `not_of_handle`.
    subroutine finish_on(handle, what, get_error, not_of_handle, procedure, status, stat, errmsg)
        type(c_ptr), intent(in) :: handle
        character(*), intent(in) :: what, procedure
        procedure(c_get_message) :: get_error
        integer, intent(in) :: not_of_handle
        integer(c_int32_t), intent(in) :: status
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        character(:), allocatable :: message

        message = ''
        if (status == mgdt_err_null_pointer .and. .not. c_associated(handle)) then
            message = 'the '//what//' has not been created'
        else if (status /= mgdt_ok .and. status /= not_of_handle) then
            message = message_of(handle, get_error)
        end if
        if (status /= mgdt_ok .and. message == '') message = c_text(c_status_string(status))
        call report(procedure, status, message, stat, errmsg)
    end subroutine

    ! Tells of an error as ALLOCATE does: stat= is always set and errmsg= on errors alone, and an
    ! error that nobody asked for stops the program.
    subroutine report(procedure, status, message, stat, errmsg)
        character(*), intent(in) :: procedure, message
        integer(c_int32_t), intent(in) :: status
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg

        if (present(stat)) stat = status
        if (status == mgdt_ok) return
        if (present(errmsg)) errmsg = message
        if (present(stat)) return
        write (error_unit, '(6a)') 'mgdt: ', procedure, ': ', message, ' (stat ', &
            decimal(int(status, int64))//')'
        flush (error_unit)
        error stop 1
    end subroutine

    ! The end of a call that has found a number, for a 32-bit integer.
    subroutine narrow(procedure, found, number, status, message, stat, errmsg)
        character(*), intent(in) :: procedure, message
        integer(int64), intent(in) :: found
        integer(int32), intent(inout) :: number
        integer(c_int32_t), intent(in) :: status
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg

        if (status == mgdt_ok .and. &
            (found > huge(number) .or. found < -int(huge(number), int64) - 1)) then
            call report(procedure, int(mgdt_err_index_range, c_int32_t), &
                      decimal(found)//' does not fit a 32-bit integer', stat, errmsg)
            return
        end if
        if (status == mgdt_ok) number = int(found, int32)
        call report(procedure, status, message, stat, errmsg)
    end subroutine

    pure function decimal(value) result(text)
        integer(int64), intent(in) :: value
        character(:), allocatable :: text
        character(20) :: digits

        write (digits, '(i0)') value
        text = trim(digits)
    end function
end module mgdt_support
