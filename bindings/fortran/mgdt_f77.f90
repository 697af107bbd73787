! SPDX-License-Identifier: MIT
! mgdt for FORTRAN 77: external subroutines without a module, to be compiled with the flags of the
! code that calls them. docs/fortran.md lists them with their arguments.
!
! - H is INTEGER H(4) in the caller's storage. It holds the address of a triangulation and a check
!   word, so there is no table, no limit on their number and no lock: threads with handles of their
!   own do not meet. A handle that MGNEW did not fill or MGFREE emptied gets status 10.
! - INTEGER is the default integer of the flags in force; reals are 8 bytes long. A number that does
!   not fit an INTEGER gets status 21 and is not stored. MGKIND tells whether the caller's integers
!   and reals are the same. Calls that every program makes refuse integers that are seen to differ.
! - The last argument is the status: 0, or one of those in mgdt_f77.inc. The other output arguments
!   of a call that failed are as they were.
! - Points and tetrahedra are numbered from 1 (MGBASE changes it); "none" is one less.

! ------------------------------------------------------------------------------- kinds

! Whether INTEGER and DOUBLE PRECISION are of the same kind in the caller as here. The caller gives
! MGKI, an INTEGER array of 1 and 2, and MGKD, which is 1D0. The status is right for integers of
! any length: it has the caller's.
subroutine mgkind(ikind, dkind, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: ikind(*)
    real(c_double), intent(in) :: dkind
    integer, intent(inout), target :: ierr
    integer :: bits, status
    integer(c_int32_t) :: words(2)

    ! Eight bytes: two integers of 32 bits, or one of 64 with either half first.
    words = transfer(ikind(:64/bit_size(ierr)), words)
    bits = 0
    if (all(words == [1, 2])) bits = 32
    if (all(words == [1, 0]) .or. all(words == [0, 1])) bits = 64
    status = mgdt_ok
    if (bits /= bit_size(ierr)) status = mgdt_err_invalid_argument
    ! What is read of a longer real is the end of its fraction, or another number.
    if (transfer(dkind, 0_c_int64_t) /= transfer(1.0_c_double, 0_c_int64_t)) &
        status = mgdt_err_invalid_argument
    if (bits == bit_size(ierr) .or. bits == 0) then
        ierr = status
    else
        call store_status(status, c_loc(ierr), bits)
    end if
end subroutine

! ------------------------------------------------------------------------------- life

! Makes an empty triangulation.
subroutine mgnew(h, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(inout) :: h(4)
    integer, intent(inout) :: ierr
    type(c_ptr) :: pointer

    if (integers_differ(h, ierr)) return
    ierr = c_create(pointer)
    if (ierr == mgdt_ok) ierr = c_set_index_base(pointer, 1_c_int32_t)
    call pack_handle(pointer, h)
end subroutine

! Frees the triangulation and empties the handle.
subroutine mgfree(h, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(inout) :: h(4)
    integer, intent(out) :: ierr
    type(c_ptr) :: pointer

    pointer = handle_of(h)
    ! In a subroutine that hears of progress nothing is freed, neither here nor by the library.
    ierr = c_set_progress(pointer, c_null_funptr, c_null_ptr)
    if (ierr == mgdt_err_busy) return
    call c_destroy(pointer)
    call pack_handle(c_null_ptr, h)
end subroutine

! Takes all points out; settings stay.
subroutine mgclr(h, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(out) :: ierr

    ierr = c_clear(handle_of(h))
end subroutine

! Announces N points in all. Optional.
subroutine mgrsv(h, n, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: n
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, n)) return
    ierr = c_reserve(handle_of(h), int(n, c_int64_t))
end subroutine

! --------------------------------------------------------------------------- settings

! Order scheme of later insertions by name: 'multi-grid'.
subroutine mgord(h, name, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    character(*), intent(in) :: name
    integer, intent(out) :: ierr
    integer(c_int32_t) :: scheme

    ierr = c_order_scheme_from_name(trim(name)//c_null_char, scheme)
    if (ierr == mgdt_ok) ierr = c_set_order_scheme(handle_of(h), scheme)
end subroutine

! The same by number.
subroutine mgordn(h, iord, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: iord
    integer, intent(out) :: ierr

    ierr = c_set_order_scheme(handle_of(h), to_c(iord))
end subroutine

! Parameter KEY of the order schemes.
subroutine mgpar(h, key, value, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: key
    real(c_double), intent(in) :: value
    integer, intent(out) :: ierr

    ierr = c_set_order_parameter(handle_of(h), to_c(key), value)
end subroutine

! Seed of the schemes that shuffle.
subroutine mgseed(h, iseed, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: iseed
    integer, intent(out) :: ierr

    ierr = c_set_seed(handle_of(h), int(iseed, c_int64_t))
end subroutine

! Threads that a call may use; 0 for all cores.
subroutine mgthr(h, n, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: n
    integer, intent(out) :: ierr

    ierr = c_set_threads(handle_of(h), to_c(n))
end subroutine

! Number of the first point and tetrahedron: 1 or 0.
subroutine mgbase(h, ibase, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: ibase
    integer, intent(out) :: ierr

    ierr = c_set_index_base(handle_of(h), to_c(ibase))
end subroutine

! The most memory that the triangulation may hold, in bytes; 0 for no limit. A real number, since a
! limit may not fit an INTEGER.
subroutine mgmem(h, bytes, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    real(c_double), intent(in) :: bytes
    integer, intent(out) :: ierr

    ierr = mgdt_err_invalid_argument
    if (.not. (bytes >= 0 .and. bytes < 2.0_c_double**62)) return
    ierr = c_set_memory_limit(handle_of(h), int(bytes, c_int64_t))
end subroutine

! Compact storage: 1, or 0 (default) for circumspheres that are kept. Since 1.1.
subroutine mgcomp(h, ion, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: ion
    integer, intent(out) :: ierr

    ierr = c_set_compact(handle_of(h), to_c(ion))
end subroutine

! Subroutine SUB(FRAC, ICANC) hears of progress and may cancel.
subroutine mgprog(h, sub, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    procedure(f77_progress) :: sub
    integer, intent(out) :: ierr

    ierr = c_set_progress(handle_of(h), c_funloc(relay), transfer(c_funloc(sub), c_null_ptr))
end subroutine

! No progress any more.
subroutine mgnopr(h, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(out) :: ierr

    ierr = c_set_progress(handle_of(h), c_null_funptr, c_null_ptr)
end subroutine

! Stops the call that runs on the handle, or else the next insertion. From any thread.
subroutine mgcanc(h, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(out) :: ierr

    ierr = c_cancel(handle_of(h))
end subroutine

! Arrays that depend on the set of points alone: 1, or 0 (default).
subroutine mgcano(h, ion, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: ion
    integer, intent(out) :: ierr

    ierr = c_set_canonical_output(handle_of(h), to_c(ion))
end subroutine

! Instruction set: 'baseline', 'avx2', 'avx512', or ' ' for the best.
subroutine mgisa(h, name, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    character(*), intent(in) :: name
    integer, intent(out) :: ierr
    character(:, c_char), allocatable, target :: c_name

    c_name = trim(name)//c_null_char
    if (name == '') then
        ierr = c_set_isa(handle_of(h), c_null_ptr)
    else
        ierr = c_set_isa(handle_of(h), c_loc(c_name))
    end if
end subroutine

! ------------------------------------------------------------------------------ points

! Inserts N points, XYZ(3, N).
subroutine mgins(h, n, xyz, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: n
    real(c_double), intent(in) :: xyz(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, n)) return
    ierr = c_insert_points(handle_of(h), int(n, c_int64_t), xyz)
end subroutine

! Inserts N points from three arrays: elements 1, 1 + INC, 1 + 2 INC ... of each, INC of any sign.
subroutine mginss(h, n, x, y, z, inc, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: n, inc
    real(c_double), intent(in), target :: x(*), y(*), z(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, n)) return
    ierr = c_insert_points_strided(handle_of(h), int(n, c_int64_t), c_loc(x), c_loc(y), c_loc(z), &
                                   int(inc, c_int64_t))
end subroutine

! ------------------------------------------------------------------------------ counts

! Points ever given.
subroutine mgnpt(h, n, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(inout) :: n
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, n)) return
    call store_count(c_point_count(handle_of(h)), handle_of(h), n, ierr)
end subroutine

! Vertices: distinct points that are in.
subroutine mgnvt(h, n, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(inout) :: n
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, n)) return
    call store_count(c_vertex_count(handle_of(h)), handle_of(h), n, ierr)
end subroutine

! Tetrahedra.
subroutine mgntet(h, n, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(inout) :: n
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, n)) return
    call store_count(c_tetrahedron_count(handle_of(h)), handle_of(h), n, ierr)
end subroutine

! Triangles of the convex hull.
subroutine mgnhul(h, n, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(inout) :: n
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, n)) return
    call store_count(c_hull_facet_count(handle_of(h)), handle_of(h), n, ierr)
end subroutine

! Edges.
subroutine mgnedg(h, n, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(inout) :: n
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, n)) return
    call store_count(c_edge_count(handle_of(h)), handle_of(h), n, ierr)
end subroutine

! Length of the list of MGVTS.
subroutine mgnvtt(h, n, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(inout) :: n
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, n)) return
    call store_count(c_vertex_tetrahedra_count(handle_of(h)), handle_of(h), n, ierr)
end subroutine

! Dimension of the points' affine hull: -1 (empty) to 3.
subroutine mgdim(h, n, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(inout) :: n
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, n)) return
    call store_count(int(c_dimension(handle_of(h)), c_int64_t), handle_of(h), n, ierr)
end subroutine

! ------------------------------------------------------------------------------ arrays

! Vertices of the tetrahedra, ITET(4, MAXT).
subroutine mgtets(h, maxt, itet, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: maxt
    integer, intent(inout) :: itet(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, maxt)) return
    ierr = c_get_tetrahedra(handle_of(h), columns(4, maxt), itet)
end subroutine

! Neighbours of the tetrahedra, INBR(4, MAXT): the i-th is opposite vertex i.
subroutine mgnbrs(h, maxt, inbr, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: maxt
    integer, intent(inout) :: inbr(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, maxt)) return
    ierr = c_get_neighbors(handle_of(h), columns(4, maxt), inbr)
end subroutine

! Triangles of the convex hull, IFAC(3, MAXF).
subroutine mghull(h, maxf, ifac, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: maxf
    integer, intent(inout) :: ifac(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, maxf)) return
    ierr = c_get_hull_facets(handle_of(h), columns(3, maxf), ifac)
end subroutine

! Edges, IEDG(2, MAXE).
subroutine mgedgs(h, maxe, iedg, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: maxe
    integer, intent(inout) :: iedg(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, maxe)) return
    ierr = c_get_edges(handle_of(h), columns(2, maxe), iedg)
end subroutine

! Vertices of the tetrahedra at any increments: vertex K of tetrahedron I at element
! 1 + (I - 1)*INCT + (K - 1)*INCV of ITET. ITET(MAXT, 4) has INCT = 1 and INCV = MAXT, and its MAXT
! rows may all be written. ITET(LD, MAXT) has INCT = LD and INCV = 1, and nothing else of it is.
subroutine mgteti(h, maxt, itet, inct, incv, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: maxt, inct, incv
    integer, intent(inout) :: itet(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, maxt)) return
    call export_at(handle_of(h), array_tetrahedra, maxt, itet, inct, incv, ierr)
end subroutine

! Neighbours of the tetrahedra likewise.
subroutine mgnbri(h, maxt, inbr, inct, incv, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: maxt, inct, incv
    integer, intent(inout) :: inbr(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, maxt)) return
    call export_at(handle_of(h), array_neighbors, maxt, inbr, inct, incv, ierr)
end subroutine

! Triangles of the convex hull likewise.
subroutine mghuli(h, maxf, ifac, inct, incv, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: maxf, inct, incv
    integer, intent(inout) :: ifac(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, maxf)) return
    call export_at(handle_of(h), array_facets, maxf, ifac, inct, incv, ierr)
end subroutine

! Edges likewise.
subroutine mgedgi(h, maxe, iedg, inct, incv, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: maxe, inct, incv
    integer, intent(inout) :: iedg(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, maxe)) return
    call export_at(handle_of(h), array_edges, maxe, iedg, inct, incv, ierr)
end subroutine

! The point that stands for each point, MAP(MAXP).
subroutine mgmap(h, maxp, map, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: maxp
    integer, intent(inout) :: map(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, maxp)) return
    ierr = c_get_point_map(handle_of(h), columns(1, maxp), map)
end subroutine

! Tetrahedra around each point K: LIST(IOFF(K)) to LIST(IOFF(K + 1) - 1).
subroutine mgvts(h, maxo, ioff, maxl, list, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: maxo, maxl
    integer, intent(inout) :: ioff(*), list(*)
    integer, intent(inout) :: ierr

    if (integers_differ(h, ierr, maxo)) return
    ierr = c_get_vertex_tetrahedra(handle_of(h), columns(1, maxo), ioff, columns(1, maxl), list)
end subroutine

! ----------------------------------------------------------------------------- queries

! The tetrahedron that contains P(3), or none.
subroutine mgloc(h, p, itet, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    real(c_double), intent(in) :: p(3)
    integer, intent(inout) :: itet
    integer, intent(out) :: ierr
    integer :: found(1)

    ierr = c_locate_points(handle_of(h), 1_c_int64_t, p, found, c_null_ptr)
    if (ierr == mgdt_ok) itet = found(1)
end subroutine

! The same for N points XYZ(3, N): ITET(N).
subroutine mglocn(h, n, xyz, itet, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: n
    real(c_double), intent(in) :: xyz(*)
    integer, intent(inout) :: itet(*)
    integer, intent(out) :: ierr

    ierr = c_locate_points(handle_of(h), int(n, c_int64_t), xyz, itet, c_null_ptr)
end subroutine

! The same with barycentric weights W(4, N).
subroutine mglocw(h, n, xyz, itet, w, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: n
    real(c_double), intent(in) :: xyz(*)
    integer, intent(inout) :: itet(*)
    real(c_double), intent(inout), target :: w(*)
    integer, intent(out) :: ierr

    ierr = c_locate_points(handle_of(h), int(n, c_int64_t), xyz, itet, c_loc(w))
end subroutine

! The vertex nearest to P(3).
subroutine mgnear(h, p, ivert, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    real(c_double), intent(in) :: p(3)
    integer, intent(inout) :: ivert
    integer, intent(out) :: ierr
    integer(c_int64_t) :: found

    ierr = c_nearest_vertex(handle_of(h), p, found)
    if (ierr == mgdt_ok) call store_count(found, handle_of(h), ivert, ierr)
end subroutine

! ------------------------------------------------------------- trust, figures and text

! Proves the triangulation; LEVEL 1 to 3.
subroutine mgchk(h, level, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: level
    integer, intent(out) :: ierr

    ierr = c_check(handle_of(h), to_c(level))
end subroutine

! Figure KEY.
subroutine mgstat(h, key, value, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    integer, intent(in) :: key
    real(c_double), intent(inout) :: value
    integer, intent(out) :: ierr

    ierr = c_get_stat(handle_of(h), to_c(key), value)
end subroutine

! Name of figure KEY.
subroutine mgstnm(key, name, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: key
    character(*), intent(inout) :: name
    integer, intent(out) :: ierr

    call store_text(c_stat_name(to_c(key)), name, mgdt_err_unknown_key, ierr)
end subroutine

! Name of order scheme IORD.
subroutine mgsnam(iord, name, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: iord
    character(*), intent(inout) :: name
    integer, intent(out) :: ierr

    call store_text(c_order_scheme_name(to_c(iord)), name, mgdt_err_unknown_scheme, ierr)
end subroutine

! Order scheme of a name.
subroutine mgsnum(name, iord, ierr)
    use mgdt_f77_support
    implicit none
    character(*), intent(in) :: name
    integer, intent(inout) :: iord
    integer, intent(out) :: ierr
    integer(c_int32_t) :: found

    ierr = c_order_scheme_from_name(trim(name)//c_null_char, found)
    if (ierr == mgdt_ok) iord = found
end subroutine

! The K-th order scheme, from 1: the default first. Beyond the last IERR is MGESCH.
subroutine mgsat(k, iord, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: k
    integer, intent(inout) :: iord
    integer, intent(out) :: ierr
    integer(c_int32_t) :: found

    ierr = c_order_scheme_at(to_c(max(k, 0) - 1), found)
    if (ierr == mgdt_ok) iord = found
end subroutine

! Message of the last call on the handle that the library refused; blank if there is none. 256
! characters hold every message.
subroutine mgerr(h, text, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    character(*), intent(inout) :: text
    integer, intent(out) :: ierr

    ierr = mgdt_err_null_pointer
    if (.not. c_associated(handle_of(h))) return
    text = last_message(handle_of(h))
    ierr = mgdt_ok
end subroutine

! What status ISTAT says by itself.
subroutine mgtext(istat, text, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: istat
    character(*), intent(inout) :: text
    integer, intent(out) :: ierr

    call store_text(c_status_string(to_c(istat)), text, mgdt_err_null_pointer, ierr)
end subroutine

! Instruction set in use.
subroutine mgisan(h, name, ierr)
    use mgdt_f77_support
    implicit none
    integer, intent(in) :: h(4)
    character(*), intent(inout) :: name
    integer, intent(out) :: ierr

    ierr = mgdt_err_null_pointer
    if (.not. c_associated(handle_of(h))) return
    call store_text(c_isa_name(handle_of(h)), name, mgdt_err_null_pointer, ierr)
end subroutine

! Version of the library, '1.2.0', and of its binary interface, 1.
subroutine mgvers(text, iabi, ierr)
    use mgdt_f77_support
    implicit none
    character(*), intent(inout) :: text
    integer, intent(out) :: iabi
    integer, intent(out) :: ierr

    iabi = c_abi_version()
    call store_text(c_version_string(), text, mgdt_err_null_pointer, ierr)
end subroutine
