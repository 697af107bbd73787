! SPDX-License-Identifier: MIT
! mgdt with MPI for FORTRAN 77: external subroutines, to be compiled with the flags of the code that
! calls them, after those of mgdt_f77.f90. docs/mpi.md lists them.
!
! H is INTEGER H(4), as for a triangulation of one process, but these subroutines alone take it. The
! last argument is the status. Numbers start at 1 (MGMOPT changes it), parts and ranks at 0. MGMNEW,
! MGMBLD, MGMCHK and MGMFRE are collective.

! Makes the part of this rank; ICOMM is a communicator.
subroutine mgmnew(icomm, h, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    use mgdt_parts_constants
    implicit none
    integer, intent(in) :: icomm
    integer, intent(inout) :: h(4)
    integer, intent(inout) :: ierr
    type(c_ptr) :: pointer

    if (integers_differ(h, ierr)) return
    ierr = c_mpi_create_f(int(icomm, c_int), pointer)
    if (ierr == mgdt_ok) &
        ierr = c_mpi_set_option(pointer, int(mgdt_parts_index_base, c_int32_t), 1_c_int64_t)
    call pack_handle(pointer, h, of_mpi)
end subroutine

! Frees it and empties the handle.
subroutine mgmfre(h, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(inout) :: h(4)
    integer, intent(out) :: ierr
    type(c_ptr) :: pointer

    pointer = handle_of(h, of_mpi)
    ierr = c_mpi_set_progress(pointer, c_null_funptr, c_null_ptr)
    if (ierr == mgdt_err_busy) return
    call c_mpi_destroy(pointer)
    call pack_handle(c_null_ptr, h, of_mpi)
end subroutine

! Takes this rank's points out, and the triangulation.
subroutine mgmclr(h, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(out) :: ierr

    ierr = c_mpi_clear(handle_of(h, of_mpi))
end subroutine

! Sets an option, MGQBAS, MGQTHR or MGQMEM.
subroutine mgmopt(h, iopt, ival, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: iopt, ival
    integer, intent(out) :: ierr

    ierr = c_mpi_set_option(handle_of(h, of_mpi), to_c(iopt), int(ival, c_int64_t))
end subroutine

! CALL SUB(FRAC, ICANC) hears of the build on this rank, as with MGPROG.
subroutine mgmprg(h, sub, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    procedure(f77_progress) :: sub
    integer, intent(out) :: ierr

    ierr = c_mpi_set_progress(handle_of(h, of_mpi), c_funloc(relay), transfer(c_funloc(sub), c_null_ptr))
end subroutine

! Nobody hears any more.
subroutine mgmnop(h, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(out) :: ierr

    ierr = c_mpi_set_progress(handle_of(h, of_mpi), c_null_funptr, c_null_ptr)
end subroutine

! Inserts N points of this rank, XYZ(3,N).
subroutine mgmins(h, n, xyz, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: n
    real(c_double), intent(in) :: xyz(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, n)) return
    ierr = c_mpi_insert_points(handle_of(h, of_mpi), int(n, c_int64_t), xyz, c_null_ptr)
end subroutine

! The same with numbers of the caller's, IDS(N), different for different points.
subroutine mgmids(h, n, xyz, ids, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: n
    real(c_double), intent(in) :: xyz(*)
    integer, intent(in) :: ids(*)
    integer, intent(inout) :: ierr
    integer(c_int64_t), allocatable, target :: long(:)
    type(c_ptr) :: at_ids
    integer :: failed

    if (integers_differ(h, ierr, n)) return
    allocate (long(max(n, 0)), stat=failed)
    if (failed /= 0) then
        ierr = mgdt_err_out_of_memory
        return
    end if
    at_ids = c_null_ptr
    if (n > 0) then
        long(:) = ids(:n)
        at_ids = c_loc(long)
    end if
    ierr = c_mpi_insert_points(handle_of(h, of_mpi), int(n, c_int64_t), xyz, at_ids)
end subroutine

! Triangulates the points of all ranks.
subroutine mgmbld(h, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(out) :: ierr

    ierr = c_mpi_build(handle_of(h, of_mpi))
end subroutine

! One of the numbers MGQPRT to MGQBYT.
subroutine mgmnum(h, key, n, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: key
    integer, intent(inout) :: n
    integer, intent(out) :: ierr
    integer(c_int64_t) :: found

    found = 0
    ierr = c_mpi_get_stat(handle_of(h, of_mpi), to_c(key), found)
    if (ierr == mgdt_ok) call store_count(found, handle_of(h, of_mpi), n, ierr)
end subroutine

! The elements of an array, MGQMAP to MGQNBR.
subroutine mgmsiz(h, iarr, n, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: iarr
    integer, intent(inout) :: n
    integer, intent(out) :: ierr
    integer(c_int64_t) :: found

    found = 0
    ierr = c_mpi_get_size(handle_of(h, of_mpi), to_c(iarr), found)
    if (ierr == mgdt_ok) call store_count(found, handle_of(h, of_mpi), n, ierr)
end subroutine

! An array in IV, which has room for MAXV elements. Where a number does not fit an INTEGER, the
! status is 21, and nothing is written.
subroutine mgmarr(h, iarr, maxv, iv, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: iarr, maxv
    integer, intent(inout) :: iv(*)
    integer, intent(inout) :: ierr
    integer(c_int64_t), allocatable :: long(:)
    integer(c_int64_t) :: n
    integer :: failed

    if (integers_differ(h, ierr, maxv)) return
    n = 0
    ierr = c_mpi_get_size(handle_of(h, of_mpi), to_c(iarr), n)
    if (ierr /= mgdt_ok) return
    allocate (long(n), stat=failed)
    if (failed /= 0) then
        ierr = mgdt_err_out_of_memory
        return
    end if
    ! Where MAXV is too small, C refuses it before it writes.
    ierr = c_mpi_get_array(handle_of(h, of_mpi), to_c(iarr), min(n, int(maxv, c_int64_t)), long)
    if (ierr /= mgdt_ok .or. n == 0) return
    if (maxval(long) > huge(iv(1)) .or. minval(long) < -huge(iv(1))) then
        ierr = mgdt_err_index_range
        return
    end if
    iv(:n) = int(long)
end subroutine

! Coordinates of the part's vertices, XYZ(3,MAXV).
subroutine mgmxyz(h, maxv, xyz, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: maxv
    real(c_double), intent(inout) :: xyz(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, maxv)) return
    ierr = c_mpi_get_coordinates(handle_of(h, of_mpi), columns(3, maxv), xyz)
end subroutine

! Proves the triangulation of all ranks; LEVEL as for MGCHK.
subroutine mgmchk(h, level, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: level
    integer, intent(out) :: ierr

    ierr = c_mpi_check(handle_of(h, of_mpi), to_c(level))
end subroutine

! Stops the running build, or the next, on all ranks.
subroutine mgmcan(h, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(out) :: ierr

    ierr = c_mpi_cancel(handle_of(h, of_mpi))
end subroutine

! The message of the last failure, cut or padded with blanks.
subroutine mgmerr(h, text, ierr)
    use mgdt_f77_support
    use mgdt_mpi_c
    implicit none
    integer, intent(in) :: h(4)
    character(*), intent(inout) :: text
    integer, intent(out) :: ierr

    ierr = mgdt_err_null_pointer
    if (.not. c_associated(handle_of(h, of_mpi))) return
    text = last_mpi_message(handle_of(h, of_mpi))
    ierr = mgdt_ok
end subroutine
