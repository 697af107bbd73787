! SPDX-License-Identifier: MIT
! What the subroutines of mgdt_f77.f90 share: handles in INTEGER arrays, counts, texts, progress.
module mgdt_f77_support
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_procpointer, &
                                           c_funloc, c_funptr, c_int32_t, c_int64_t, c_loc, &
                                           c_null_char, c_null_funptr, c_null_ptr, c_ptr
    use mgdt_c
    use mgdt_constants
    use mgdt_support, only: c_text, last_message, to_c
    implicit none
    public

    ! The low and the high half of the address in an integer each, whatever its kind, and a check
    ! word that an array of anything else will not have.
    integer(c_int32_t), parameter, private :: seal = 1296516212_c_int32_t

    abstract interface
        ! SUB(FRAC, ICANC) of MGPROG as C would see it: two addresses, whatever kind INTEGER has.
        subroutine f77_progress(fraction, icanc) bind(c)
            import :: c_double, c_ptr
            real(c_double), intent(inout) :: fraction
            type(c_ptr), value :: icanc
        end subroutine
    end interface

contains

    subroutine pack_handle(pointer, h)
        type(c_ptr), intent(in) :: pointer
        integer, intent(out) :: h(4)
        integer(c_int32_t) :: halves(2)

        h = 0
        if (.not. c_associated(pointer)) return
        halves = transfer(pointer, halves)
        h(1:2) = halves
        h(3) = ieor(ieor(halves(1), halves(2)), seal)
    end subroutine

    ! Null for what pack_handle has not made, which C answers with MGDT_ERR_NULL_POINTER.
    function handle_of(h) result(pointer)
        integer, intent(in) :: h(4)
        type(c_ptr) :: pointer
        integer(c_int32_t) :: words(3)

        pointer = c_null_ptr
        words = to_c(h(1:3))
        if (any(words /= h(1:3)) .or. all(words(1:2) == 0)) return
        if (words(3) /= ieor(ieor(words(1), words(2)), seal)) return
        pointer = transfer(words(1:2), pointer)
    end function

    ! Elements in n columns.
    elemental function columns(width, n) result(elements)
        integer, intent(in) :: width, n
        integer(c_int64_t) :: elements

        elements = width*min(int(n, c_int64_t), huge(elements)/width)
    end function

    subroutine store_count(count, pointer, n, ierr)
        integer(c_int64_t), intent(in) :: count
        type(c_ptr), intent(in) :: pointer
        integer, intent(inout) :: n
        integer, intent(out) :: ierr

        ierr = mgdt_ok
        if (.not. c_associated(pointer)) then
            ierr = mgdt_err_null_pointer
        else if (count > huge(n)) then
            ierr = mgdt_err_index_range
        else
            n = int(count)
        end if
    end subroutine

    ! C's text cut or padded with blanks to the caller's length; if_none is the status for no text.
    subroutine store_text(pointer, text, if_none, ierr)
        type(c_ptr), intent(in) :: pointer
        character(*), intent(inout) :: text
        integer, intent(in) :: if_none
        integer, intent(out) :: ierr

        ierr = if_none
        if (.not. c_associated(pointer)) return
        text = c_text(pointer)
        ierr = mgdt_ok
    end subroutine

    ! The caller's subroutine itself is what C passes as user.
    function relay(fraction, user) result(stop_asked) bind(c, name='')
        real(c_double), value :: fraction
        type(c_ptr), value :: user
        integer(c_int32_t) :: stop_asked
        procedure(f77_progress), pointer :: sub
        type(c_funptr) :: address
        real(c_double) :: told
        integer, target :: icanc

        address = transfer(user, address)
        call c_f_procpointer(address, sub)
        told = fraction
        icanc = 0
        call sub(told, c_loc(icanc))
        stop_asked = merge(1_c_int32_t, 0_c_int32_t, icanc /= 0)
    end function
end module mgdt_f77_support
