! SPDX-License-Identifier: MIT
! What the subroutines of mgdt_f77.f90 share: handles in INTEGER arrays, counts, layouts of arrays,
! texts, progress, and whether the caller's integers are of the same kind.
module mgdt_f77_support
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, &
                                           c_f_procpointer, c_funloc, c_funptr, c_int32_t, &
                                           c_int64_t, c_intptr_t, c_loc, c_null_char, &
                                           c_null_funptr, c_null_ptr, c_ptr
    use mgdt_c
    use mgdt_constants
    use mgdt_layout, only: place_records, transpose_records
    use mgdt_support, only: c_text, last_message, text_of, to_c
    implicit none
    public

    ! A handle is four words of 32 bits at the front of H, whatever the kind of INTEGER, so that
    ! none is written behind an array whose integers are shorter than these. They are the halves of
    ! the address, a check word that an array of anything else will not have, and the kind.
    integer(c_int32_t), parameter, private :: seal = 1296516212_c_int32_t
    integer, parameter, private :: integer_bits = bit_size(0), handle_integers = 128/integer_bits
    ! Added to the seal of another kind of handle.
    integer(c_int32_t), parameter :: of_parts = 1, of_voronoi = 2, of_domain = 3, &
                                     of_periodic = 4, of_mesh = 5

    ! The arrays that export_at() knows.
    integer, parameter :: array_tetrahedra = 1, array_neighbors = 2, array_facets = 3, &
                          array_edges = 4

    abstract interface
        ! SUB(FRAC, ICANC) of MGPROG as C would see it: two addresses, whatever kind INTEGER has.
        subroutine f77_progress(fraction, icanc) bind(c)
            import :: c_double, c_ptr
            real(c_double), intent(inout) :: fraction
            type(c_ptr), value :: icanc
        end subroutine
        ! FIND(N, XYZ, SIZES, ICANC) of MGUSFN.
        subroutine f77_sizes(n, xyz, sizes, icanc) bind(c)
            import :: c_double, c_ptr
            type(c_ptr), value :: n
            real(c_double), intent(in) :: xyz(*)
            real(c_double), intent(inout) :: sizes(*)
            type(c_ptr), value :: icanc
        end subroutine
    end interface

contains

    subroutine pack_handle(pointer, h, other_kind)
        type(c_ptr), intent(in) :: pointer
        integer, intent(inout) :: h(4)
        integer(c_int32_t), intent(in), optional :: other_kind
        integer(c_int32_t) :: words(4)

        words = 0
        if (c_associated(pointer)) then
            words(1:2) = transfer(int(address_of(pointer), c_int64_t), words(1:2))
            words(3) = ieor(ieor(words(1), words(2)), seal_of(other_kind))
            words(4) = integer_bits
        end if
        h(:handle_integers) = transfer(words, h(:handle_integers))
    end subroutine

    ! Null for what pack_handle has not made, which C answers with MGDT_ERR_NULL_POINTER.
    function handle_of(h, other_kind) result(pointer)
        integer, intent(in) :: h(4)
        integer(c_int32_t), intent(in), optional :: other_kind
        type(c_ptr) :: pointer
        integer(c_int32_t) :: words(4)
        integer(c_int64_t) :: address

        pointer = c_null_ptr
        words = transfer(h(:handle_integers), words)
        if (all(words(1:2) == 0) .or. words(4) /= integer_bits) return
        if (words(3) /= ieor(ieor(words(1), words(2)), seal_of(other_kind))) return
        address = transfer(words(1:2), address)
        pointer = transfer(int(address, c_intptr_t), pointer)
    end function

    pure function seal_of(other_kind) result(of_kind)
        integer(c_int32_t), intent(in), optional :: other_kind
        integer(c_int32_t) :: of_kind

        of_kind = seal
        if (present(other_kind)) of_kind = seal + other_kind
    end function

    pure function address_of(pointer) result(address)
        type(c_ptr), intent(in) :: pointer
        integer(c_intptr_t) :: address

        address = transfer(pointer, address)
    end function

    ! Whether the caller's integers are seen to be of 32 bits where INTEGER here has 64: they
    ! overlap as variables of 64 bits, or do not stand where these must. ierr gets its status in 32
    ! bits then. Nothing shows the opposite case: the low half of 64 bits is all that is read.
    function integers_differ(h, ierr, n) result(differ)
        integer, intent(in), target :: h(4)
        integer, intent(inout), target :: ierr
        integer, intent(in), optional, target :: n
        logical :: differ
        integer(c_intptr_t) :: at_h, at_ierr, at_n

        differ = .false.
        if (integer_bits == 32) return
        at_h = address_of(c_loc(h))
        at_ierr = address_of(c_loc(ierr))
        at_n = at_ierr
        if (present(n)) at_n = address_of(c_loc(n))
        ! With addresses of 32 bits integers of 64 may stand anywhere.
        if (storage_size(at_h) == 64) &
            differ = any(mod([at_h, at_ierr, at_n], 8_c_intptr_t) /= 0)
        differ = differ .or. overlap(at_h, 32_c_intptr_t, at_ierr) .or. &
                 overlap(at_h, 32_c_intptr_t, at_n) .or. overlap(at_ierr, 8_c_intptr_t, at_n)
        if (differ) call store_status(mgdt_err_invalid_argument, c_loc(ierr), 32)
    end function

    ! Whether eight bytes at b overlap those at a, but are not the first of them: a caller who
    ! gives one variable twice does not make a difference of kinds.
    pure function overlap(a, bytes, b)
        integer(c_intptr_t), intent(in) :: a, bytes, b
        logical :: overlap

        overlap = b > a - 8 .and. b < a + bytes .and. b /= a
    end function

    ! A status in the caller's INTEGER of `bits` bits.
    subroutine store_status(status, address, bits)
        integer, intent(in) :: status, bits
        type(c_ptr), intent(in) :: address
        integer(c_int32_t), pointer :: short
        integer(c_int64_t), pointer :: long

        if (bits == 64) then
            call c_f_pointer(address, long)
            long = status
        else
            call c_f_pointer(address, short)
            short = to_c(status)
        end if
    end subroutine

    ! Elements in n columns.
    elemental function columns(width, n) result(elements)
        integer, intent(in) :: width, n
        integer(c_int64_t) :: elements

        elements = width*min(int(n, c_int64_t), huge(elements)/width)
    end function

    ! Integers of the caller's kind in 64 bits, at least one of them, so that C has an address.
    subroutine as_long(given, n, long, ierr)
        integer, intent(in) :: given(*)
        integer(c_int64_t), intent(in) :: n
        integer(c_int64_t), allocatable, intent(inout) :: long(:)
        integer, intent(out) :: ierr
        integer :: failed

        ierr = mgdt_err_out_of_memory
        allocate (long(max(n, 1_c_int64_t)), stat=failed)
        if (failed /= 0) return
        long(:n) = given(:n)
        ierr = mgdt_ok
    end subroutine

    ! Markers in 32 bits, at least one of them. Those that do not fit are an invalid argument.
    subroutine as_markers(given, n, markers, ierr)
        integer, intent(in) :: given(*)
        integer(c_int64_t), intent(in) :: n
        integer(c_int32_t), allocatable, intent(inout) :: markers(:)
        integer, intent(out) :: ierr
        integer(c_int64_t), parameter :: most = huge(0_c_int32_t)
        integer(c_int64_t) :: i
        integer :: failed

        ierr = mgdt_err_out_of_memory
        allocate (markers(max(n, 1_c_int64_t)), stat=failed)
        if (failed /= 0) return
        ierr = mgdt_err_invalid_argument
        do i = 1, n
            if (given(i) > most .or. given(i) < -most - 1) return
            markers(i) = to_c(given(i))
        end do
        ierr = mgdt_ok
    end subroutine

    subroutine store_count(count, pointer, n, ierr)
        integer(c_int64_t), intent(in) :: count
        type(c_ptr), intent(in) :: pointer
        integer, intent(inout) :: n
        integer, intent(out) :: ierr

        ierr = mgdt_ok
        if (.not. c_associated(pointer)) then
            ierr = mgdt_err_null_pointer
        else if (count > huge(n) .or. min(count, 0_c_int64_t) + 1 < -int(huge(n), c_int64_t)) then
            ierr = mgdt_err_index_range
        else
            n = int(count)
        end if
    end subroutine

    ! C's array with integer k of record i at v(1 + (i - 1)*inct + (k - 1)*incv); maxt records fit.
    ! Where the records are columns of maxt rows, these are all the caller's to give, and the array
    ! is transposed in place. Other layouts take a copy while this runs.
    subroutine export_at(pointer, which, maxt, v, inct, incv, ierr)
        type(c_ptr), intent(in) :: pointer
        integer, intent(in) :: which, maxt, inct, incv
        integer, intent(inout) :: v(*)
        integer, intent(out) :: ierr
        integer, allocatable :: records(:)
        integer(c_int64_t) :: width, n, rows, to_record, to_integer
        integer :: failed

        select case (which)
        case (array_facets)
            width = 3
            n = c_hull_facet_count(pointer)
        case (array_edges)
            width = 2
            n = c_edge_count(pointer)
        case default
            width = 4
            n = c_tetrahedron_count(pointer)
        end select
        rows = maxt
        to_record = inct
        to_integer = incv
        ierr = mgdt_err_invalid_argument
        if (to_record < 1 .or. to_integer < 1) return
        ! One record behind the other, or one column behind the other.
        if (to_record/width < to_integer .and. to_integer/to_record < rows) return

        if (to_record == width .and. to_integer == 1) then
            ierr = get(pointer, which, columns(int(width), maxt), v)
        else if (to_record == 1 .and. to_integer == rows) then
            ierr = get(pointer, which, columns(int(width), maxt), v)
            if (ierr == mgdt_ok) call transpose_records(v, width, n, rows)
        else
            ierr = mgdt_err_out_of_memory
            allocate (records(width*max(0_c_int64_t, min(n, rows))), stat=failed)
            if (failed /= 0) return
            ! Where maxt is too small, C refuses it before it writes.
            ierr = get(pointer, which, columns(int(width), maxt), records)
            if (ierr == mgdt_ok) call place_records(records, width, n, v, to_record, to_integer)
        end if
    end subroutine

    function get(pointer, which, capacity, v) result(status)
        type(c_ptr), intent(in) :: pointer
        integer, intent(in) :: which
        integer(c_int64_t), intent(in) :: capacity
        integer, intent(inout) :: v(*)
        integer(c_int32_t) :: status

        select case (which)
        case (array_facets)
            status = c_get_hull_facets(pointer, capacity, v)
        case (array_edges)
            status = c_get_edges(pointer, capacity, v)
        case (array_neighbors)
            status = c_get_neighbors(pointer, capacity, v)
        case default
            status = c_get_tetrahedra(pointer, capacity, v)
        end select
    end function

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

    function relay_sizes(n, xyz, sizes, user) result(stop_asked) bind(c, name='')
        integer(c_int64_t), value :: n
        real(c_double), intent(in) :: xyz(*)
        real(c_double), intent(inout) :: sizes(*)
        type(c_ptr), value :: user
        integer(c_int32_t) :: stop_asked
        procedure(f77_sizes), pointer :: sub
        type(c_funptr) :: address
        integer, target :: places, icanc

        address = transfer(user, address)
        call c_f_procpointer(address, sub)
        places = int(n)
        icanc = 0
        call sub(c_loc(places), xyz, sizes, c_loc(icanc))
        stop_asked = merge(1_c_int32_t, 0_c_int32_t, icanc /= 0)
    end function
end module mgdt_f77_support
