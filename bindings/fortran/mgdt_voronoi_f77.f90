! SPDX-License-Identifier: MIT
! Voronoi diagrams for FORTRAN 77: external subroutines, to be compiled with the flags of the code
! that calls them, after those of mgdt_f77.f90. docs/fortran.md lists them. Since 1.3.
!
! HV is INTEGER HV(4), a handle as MGNEW's, but of a diagram: these subroutines alone take it. The
! last argument is the status. Points, vertices, rays and faces have numbers from 1, unless MGBASE
! changed it before the diagram was made.

! Makes the diagram of the points of triangulation H. Cells are clipped to the NP planes
! A*X + B*Y + C*Z <= D, PLANES(4, NP); NP may be 0. HV is not the handle of another diagram.
subroutine mgvnew(h, np, planes, hv, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: np
    real(c_double), intent(in), target :: planes(*)
    integer, intent(inout) :: hv(4)
    integer, intent(inout) :: ierr
    type(c_ptr) :: pointer

    if (integers_differ(h, ierr, np)) return
    ierr = c_voronoi_create(handle_of(h), int(np, c_int64_t), c_loc(planes), pointer)
    call pack_handle(pointer, hv, of_voronoi)
end subroutine

! Frees the diagram and empties the handle.
subroutine mgvfre(hv, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(inout) :: hv(4)
    integer, intent(out) :: ierr
    type(c_ptr) :: pointer

    pointer = handle_of(hv, of_voronoi)
    ierr = mgdt_err_null_pointer
    if (.not. c_associated(pointer)) return
    call c_voronoi_destroy(pointer)
    call pack_handle(c_null_ptr, hv)
    ierr = mgdt_ok
end subroutine

! Number of elements N of array KEY, such as MGVFCO.
subroutine mgvsiz(hv, key, n, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: hv(4)
    integer, intent(in) :: key
    integer, intent(inout) :: n
    integer, intent(inout) :: ierr
    type(c_ptr) :: pointer
    integer(c_int64_t) :: elements

    if (integers_differ(hv, ierr, n)) return
    pointer = handle_of(hv, of_voronoi)
    elements = 0
    ierr = c_voronoi_get_size(pointer, to_c(key), elements)
    if (ierr == mgdt_ok) call store_count(elements, pointer, n, ierr)
end subroutine

! Array KEY of integers, MGVFOF to MGVCBO: IARR(MAXN).
subroutine mgvarr(hv, key, maxn, iarr, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: hv(4)
    integer, intent(in) :: key
    integer, intent(in) :: maxn
    integer, intent(inout) :: iarr(*)
    integer, intent(inout) :: ierr

    if (integers_differ(hv, ierr, maxn)) return
    ierr = c_voronoi_get_array(handle_of(hv, of_voronoi), to_c(key), int(maxn, c_int64_t), iarr)
end subroutine

! Array KEY of reals, MGVVTX to MGVCCE: X(MAXN).
subroutine mgvdbl(hv, key, maxn, x, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: hv(4)
    integer, intent(in) :: key
    integer, intent(in) :: maxn
    real(c_double), intent(inout) :: x(*)
    integer, intent(inout) :: ierr

    if (integers_differ(hv, ierr, maxn)) return
    ierr = c_voronoi_get_doubles(handle_of(hv, of_voronoi), to_c(key), int(maxn, c_int64_t), x)
end subroutine

! Leaves out the faces whose area is less than AREA, or, for each of their cells, less than SHARE
! times the area of the cell's bounded faces.
subroutine mgvdrp(hv, area, share, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: hv(4)
    real(c_double), intent(in) :: area
    real(c_double), intent(in) :: share
    integer, intent(out) :: ierr

    ierr = c_voronoi_drop_small_faces(handle_of(hv, of_voronoi), area, share)
end subroutine

! Message of the last call that failed on diagram HV; blank if there was none. MGERR has that of
! MGVNEW, on the triangulation.
subroutine mgverr(hv, text, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: hv(4)
    character(*), intent(inout) :: text
    integer, intent(out) :: ierr
    character(kind=c_char) :: buffer(256)

    text = ' '
    ierr = c_voronoi_get_error(handle_of(hv, of_voronoi), size(buffer, kind=c_int64_t), buffer)
    if (ierr == mgdt_ok) text = text_of(buffer)
end subroutine
