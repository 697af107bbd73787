! SPDX-License-Identifier: MIT
! mgdt with MPI: one triangulation of points that are spread over ranks. docs/mpi.md is the guide.
!
! The conventions are those of module mgdt: stat= and errmsg= as ALLOCATE has them, numbers from 1
! (set_option(mgdt_parts_index_base, 0) for 0). Parts and ranks are numbered from 0. create, build,
! check and destroy are collective; a failure on one rank is one on all, with the same message.
!
! The communicator is an integer: MPI_COMM_WORLD of mpif.h and of module mpi, and that of mpi_f08 as
! MPI_COMM_WORLD%MPI_VAL.
module mgdt_mpi
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_funloc, c_int, c_int32_t, &
                                           c_int64_t, c_loc, c_null_funptr, c_null_ptr, c_ptr
    use, intrinsic :: iso_fortran_env, only: error_unit, int32, int64, real64
    use mgdt_c, only: c_status_string
    use mgdt_callbacks, only: mgdt_progress, progress_box, relay
    use mgdt_constants
    use mgdt_mpi_c
    use mgdt_parts_constants
    use mgdt_support, only: c_text, decimal, report
    implicit none
    private

    public :: mgdt_mpi_triangulation, mgdt_progress
    ! The constants; mgdt_parts_constants.f90 says what they mean.
    public :: mgdt_parts_index_base, mgdt_parts_threads, mgdt_parts_memory_limit
    public :: mgdt_parts_parts, mgdt_parts_first_local, mgdt_parts_local_parts, &
              mgdt_parts_points, mgdt_parts_own_vertices, mgdt_parts_vertices, &
              mgdt_parts_all_vertices, mgdt_parts_own_tetrahedra, mgdt_parts_tetrahedra, &
              mgdt_parts_all_tetrahedra, mgdt_parts_received, mgdt_parts_memory_bytes
    public :: mgdt_parts_point_map, mgdt_parts_vertex_numbers, mgdt_parts_vertex_ids, &
              mgdt_parts_vertex_owners, mgdt_parts_vertex_ranges, mgdt_parts_corners, &
              mgdt_parts_local_corners, mgdt_parts_tetrahedron_numbers, &
              mgdt_parts_tetrahedron_owners, mgdt_parts_tetrahedron_ranges, mgdt_parts_neighbors
    public :: mgdt_ok, mgdt_err_null_pointer, mgdt_err_invalid_argument, mgdt_err_not_finite, &
              mgdt_err_unknown_key, mgdt_err_index_range, mgdt_err_out_of_memory, &
              mgdt_err_too_large, mgdt_err_cancelled, mgdt_err_busy, mgdt_err_transport, &
              mgdt_err_check_failed
    public :: mgdt_check_combinatorial, mgdt_check_geometric, mgdt_check_canonical

    ! The part of this rank. It frees what it holds when it goes out of scope, which has to happen on
    ! all ranks, or after MPI_Finalize. It cannot be copied.
    type :: mgdt_mpi_triangulation
        private
        type(c_ptr) :: handle = c_null_ptr
        type(progress_box), pointer :: progress => null()
    contains
        procedure :: create, destroy, clear, build, check, cancel, set_progress, remove_progress
        procedure, private :: set_option_i32, set_option_i64
        generic :: set_option => set_option_i32, set_option_i64
        procedure :: get_option, number
        procedure, private :: insert_1, insert_2, insert_ids_i32, insert_ids_i64
        generic :: insert => insert_1, insert_2, insert_ids_i32, insert_ids_i64
        procedure, private :: get_i32_1, get_i32_2, get_i64_1, get_i64_2
        generic :: get => get_i32_1, get_i32_2, get_i64_1, get_i64_2
        procedure :: get_coordinates
        procedure, private :: assign
        generic :: assignment(=) => assign
        final :: finalize
    end type

contains

    ! Collective over the communicator, which is duplicated.
    subroutine create(self, communicator, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        integer, intent(in) :: communicator
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status

        if (c_associated(self%handle)) then
            call report('create', int(mgdt_err_invalid_argument, c_int32_t), &
                        'the triangulation is made already; destroy it first', stat, errmsg)
            return
        end if
        status = c_mpi_create_f(int(communicator, c_int), self%handle)
        if (status == mgdt_ok) &
            status = c_mpi_set_option(self%handle, int(mgdt_parts_index_base, c_int32_t), &
                                      1_c_int64_t)
        call finish(self, 'create', status, stat, errmsg)
    end subroutine

    ! Collective, unless MPI is finalised. In a callback of its own nothing is freed.
    subroutine destroy(self)
        class(mgdt_mpi_triangulation), intent(inout) :: self

        if (c_mpi_set_progress(self%handle, c_null_funptr, c_null_ptr) == mgdt_err_busy) return
        call c_mpi_destroy(self%handle)
        self%handle = c_null_ptr
        if (associated(self%progress)) deallocate (self%progress)
    end subroutine

    subroutine finalize(self)
        type(mgdt_mpi_triangulation), intent(inout) :: self

        call self%destroy()
    end subroutine

    ! Intrinsic assignment would leave two owners of one handle.
    subroutine assign(self, other)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        class(mgdt_mpi_triangulation), intent(in) :: other

        if (c_associated(self%handle) .or. c_associated(other%handle)) then
            write (error_unit, '(a)') 'mgdt: a triangulation cannot be copied by assignment'
            flush (error_unit)
            error stop 1
        end if
    end subroutine

    ! Takes this rank's points out, and the triangulation.
    subroutine clear(self, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg

        call finish(self, 'clear', c_mpi_clear(self%handle), stat, errmsg)
    end subroutine

    ! option is mgdt_parts_index_base, mgdt_parts_threads or mgdt_parts_memory_limit.
    subroutine set_option_i32(self, option, value, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        integer, intent(in) :: option
        integer(int32), intent(in) :: value
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg

        call self%set_option(option, int(value, int64), stat, errmsg)
    end subroutine

    subroutine set_option_i64(self, option, value, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        integer, intent(in) :: option
        integer(int64), intent(in) :: value
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg

        call finish(self, 'set_option', &
                    c_mpi_set_option(self%handle, int(option, c_int32_t), value), stat, errmsg)
    end subroutine

    function get_option(self, option, stat, errmsg) result(value)
        class(mgdt_mpi_triangulation), intent(in) :: self
        integer, intent(in) :: option
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(int64) :: value

        value = 0
        call finish(self, 'get_option', &
                    c_mpi_get_option(self%handle, int(option, c_int32_t), value), stat, errmsg)
    end function

    ! Hears of the build on this rank, and may stop all.
    subroutine set_progress(self, heard, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        procedure(mgdt_progress) :: heard
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(progress_box), pointer :: box
        integer(c_int32_t) :: status

        allocate (box)
        box%report => heard
        status = c_mpi_set_progress(self%handle, c_funloc(relay), c_loc(box))
        if (status == mgdt_ok) then
            if (associated(self%progress)) deallocate (self%progress)
            self%progress => box
        else
            deallocate (box)
        end if
        call finish(self, 'set_progress', status, stat, errmsg)
    end subroutine

    subroutine remove_progress(self, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status

        status = c_mpi_set_progress(self%handle, c_null_funptr, c_null_ptr)
        if (status == mgdt_ok .and. associated(self%progress)) deallocate (self%progress)
        call finish(self, 'remove_progress', status, stat, errmsg)
    end subroutine

    ! Stops the running build, or the next.
    subroutine cancel(self, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(in) :: self
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status

        status = c_mpi_cancel(self%handle)
        call finish(self, 'cancel', status, stat, errmsg)
    end subroutine

    ! Points of this rank, xyz(3 n) or xyz(3, n).
    subroutine insert_1(self, xyz, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        real(real64), contiguous, intent(in) :: xyz(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg

        if (mod(size(xyz, kind=int64), 3_int64) /= 0) then
            call report('insert', int(mgdt_err_invalid_argument, c_int32_t), &
                        'xyz has '//decimal(size(xyz, kind=int64))// &
                        ' elements; they must be 3 a point', stat, errmsg)
        else
            call finish(self, 'insert', c_mpi_insert_points(self%handle, &
                        size(xyz, kind=c_int64_t)/3, xyz, c_null_ptr), stat, errmsg)
        end if
    end subroutine

    subroutine insert_2(self, xyz, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        real(real64), contiguous, intent(in) :: xyz(:, :)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg

        if (.not. are_points(xyz, size(xyz, 2, kind=int64), stat, errmsg)) return
        call finish(self, 'insert', c_mpi_insert_points(self%handle, &
                    size(xyz, 2, kind=c_int64_t), xyz, c_null_ptr), stat, errmsg)
    end subroutine

    ! With ids: numbers of the caller's, different for different points.
    subroutine insert_ids_i64(self, xyz, ids, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        real(real64), contiguous, intent(in) :: xyz(:, :)
        integer(int64), contiguous, intent(in), target :: ids(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(c_ptr) :: at_ids

        if (.not. are_points(xyz, size(ids, kind=int64), stat, errmsg)) return
        at_ids = c_null_ptr
        if (size(ids) > 0) at_ids = c_loc(ids)
        call finish(self, 'insert', c_mpi_insert_points(self%handle, size(ids, kind=c_int64_t), &
                    xyz, at_ids), stat, errmsg)
    end subroutine

    subroutine insert_ids_i32(self, xyz, ids, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        real(real64), contiguous, intent(in) :: xyz(:, :)
        integer(int32), intent(in) :: ids(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(int64), allocatable :: long(:)
        integer :: failed

        allocate (long(size(ids)), stat=failed)
        if (failed /= 0) then
            call report('insert', int(mgdt_err_out_of_memory, c_int32_t), 'out of memory', stat, &
                        errmsg)
            return
        end if
        long(:) = ids
        call self%insert(xyz, long, stat, errmsg)
    end subroutine

    function are_points(xyz, n, stat, errmsg) result(are)
        real(real64), intent(in) :: xyz(:, :)
        integer(int64), intent(in) :: n
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        logical :: are

        are = size(xyz, 1) == 3 .and. size(xyz, 2, kind=int64) == n
        if (are) return
        call report('insert', int(mgdt_err_invalid_argument, c_int32_t), 'xyz has the extents '// &
                    decimal(size(xyz, 1, kind=int64))//' and '// &
                    decimal(size(xyz, 2, kind=int64))//'; they must be 3 and '//decimal(n), &
                    stat, errmsg)
    end function

    ! Triangulates the points of all ranks. Collective.
    subroutine build(self, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg

        call finish(self, 'build', c_mpi_build(self%handle), stat, errmsg)
    end subroutine

    ! One of the numbers mgdt_parts_parts to mgdt_parts_memory_bytes.
    function number(self, key, stat, errmsg) result(value)
        class(mgdt_mpi_triangulation), intent(in) :: self
        integer, intent(in) :: key
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(int64) :: value

        value = 0
        call finish(self, 'number', c_mpi_get_stat(self%handle, int(key, c_int32_t), value), &
                    stat, errmsg)
    end function

    ! An array, mgdt_parts_point_map to mgdt_parts_neighbors, which is allocated: values(n), or
    ! values(4, n) for those of four a tetrahedron. In 32 bits all numbers have to fit.
    subroutine get_i64_1(self, array, values, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(in) :: self
        integer, intent(in) :: array
        integer(int64), allocatable, intent(inout) :: values(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int64_t) :: n
        integer(c_int32_t) :: status
        integer :: failed

        call size_of(self, array, 1, n, status)
        if (status == mgdt_ok) then
            if (allocated(values)) deallocate (values)
            allocate (values(n), stat=failed)
            if (failed /= 0) status = mgdt_err_out_of_memory
        end if
        if (status == mgdt_ok) &
            status = c_mpi_get_array(self%handle, int(array, c_int32_t), n, values)
        call finish(self, 'get', status, stat, errmsg)
    end subroutine

    subroutine get_i64_2(self, array, values, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(in) :: self
        integer, intent(in) :: array
        integer(int64), allocatable, intent(inout) :: values(:, :)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int64_t) :: n
        integer(c_int32_t) :: status
        integer :: failed

        call size_of(self, array, 4, n, status)
        if (status == mgdt_ok) then
            if (allocated(values)) deallocate (values)
            allocate (values(4, n/4), stat=failed)
            if (failed /= 0) status = mgdt_err_out_of_memory
        end if
        if (status == mgdt_ok) &
            status = c_mpi_get_array(self%handle, int(array, c_int32_t), n, values)
        call finish(self, 'get', status, stat, errmsg)
    end subroutine

    subroutine get_i32_1(self, array, values, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(in) :: self
        integer, intent(in) :: array
        integer(int32), allocatable, intent(inout) :: values(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(int64), allocatable :: long(:)
        integer(c_int32_t) :: status
        integer :: failed

        call get_short(self, array, 1, long, status)
        if (status == mgdt_ok) then
            if (allocated(values)) deallocate (values)
            allocate (values(size(long)), stat=failed)
            if (failed /= 0) status = mgdt_err_out_of_memory
        end if
        if (status == mgdt_ok) values(:) = int(long, int32)
        call finish(self, 'get', status, stat, errmsg)
    end subroutine

    subroutine get_i32_2(self, array, values, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(in) :: self
        integer, intent(in) :: array
        integer(int32), allocatable, intent(inout) :: values(:, :)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(int64), allocatable :: long(:)
        integer(c_int32_t) :: status
        integer(int64) :: i
        integer :: failed

        call get_short(self, array, 4, long, status)
        if (status == mgdt_ok) then
            if (allocated(values)) deallocate (values)
            allocate (values(4, size(long, kind=int64)/4), stat=failed)
            if (failed /= 0) status = mgdt_err_out_of_memory
        end if
        if (status == mgdt_ok) then
            do i = 1, size(values, 2, kind=int64)
                values(:, i) = int(long(4*i - 3:4*i), int32)
            end do
        end if
        call finish(self, 'get', status, stat, errmsg)
    end subroutine

    ! Coordinates of the part's vertices, xyz(3, n), which is allocated.
    subroutine get_coordinates(self, xyz, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(in) :: self
        real(real64), allocatable, intent(inout) :: xyz(:, :)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int64_t) :: n
        integer(c_int32_t) :: status
        integer :: failed

        n = 0
        status = c_mpi_get_stat(self%handle, int(mgdt_parts_vertices, c_int32_t), n)
        if (status == mgdt_ok) then
            if (allocated(xyz)) deallocate (xyz)
            allocate (xyz(3, n), stat=failed)
            if (failed /= 0) status = mgdt_err_out_of_memory
        end if
        if (status == mgdt_ok) status = c_mpi_get_coordinates(self%handle, 3*n, xyz)
        call finish(self, 'get_coordinates', status, stat, errmsg)
    end subroutine

    ! Proves the triangulation of all ranks; level is an mgdt_check_ constant, the canonical one if
    ! there is none. Collective.
    subroutine check(self, level, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(inout) :: self
        integer, intent(in), optional :: level
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: wanted

        wanted = mgdt_check_canonical
        if (present(level)) wanted = int(level, c_int32_t)
        call finish(self, 'check', c_mpi_check(self%handle, wanted), stat, errmsg)
    end subroutine

    ! The elements of an array, which has to be of `rows` a tetrahedron unless that is 1.
    subroutine size_of(self, array, rows, n, status)
        class(mgdt_mpi_triangulation), intent(in) :: self
        integer, intent(in) :: array, rows
        integer(c_int64_t), intent(out) :: n
        integer(c_int32_t), intent(out) :: status

        n = 0
        status = c_mpi_get_size(self%handle, int(array, c_int32_t), n)
        if (status == mgdt_ok .and. rows == 4 .and. &
            all(array /= [mgdt_parts_corners, mgdt_parts_local_corners, mgdt_parts_neighbors])) &
            status = mgdt_err_invalid_argument
    end subroutine

    ! An array whose numbers have 32 bits.
    subroutine get_short(self, array, rows, long, status)
        class(mgdt_mpi_triangulation), intent(in) :: self
        integer, intent(in) :: array, rows
        integer(int64), allocatable, intent(out) :: long(:)
        integer(c_int32_t), intent(out) :: status
        integer(c_int64_t) :: n
        integer :: failed

        call size_of(self, array, rows, n, status)
        if (status /= mgdt_ok) return
        allocate (long(n), stat=failed)
        if (failed /= 0) then
            status = mgdt_err_out_of_memory
            return
        end if
        status = c_mpi_get_array(self%handle, int(array, c_int32_t), n, long)
        if (status /= mgdt_ok .or. n == 0) return
        if (maxval(long) > huge(0_int32) .or. minval(long) < -huge(0_int32)) &
            status = mgdt_err_index_range
    end subroutine

    ! The end of a call.
    subroutine finish(self, procedure, status, stat, errmsg)
        class(mgdt_mpi_triangulation), intent(in) :: self
        character(*), intent(in) :: procedure
        integer(c_int32_t), intent(in) :: status
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        character(:), allocatable :: message

        message = ''
        if (status == mgdt_err_null_pointer .and. .not. c_associated(self%handle)) then
            message = 'the triangulation has not been created'
        else if (status == mgdt_err_invalid_argument .and. procedure == 'get') then
            message = 'the array has no four numbers a tetrahedron'
        else if (status /= mgdt_ok .and. status /= mgdt_err_index_range) then
            message = last_mpi_message(self%handle)
        end if
        if (status /= mgdt_ok .and. message == '') message = c_text(c_status_string(status))
        call report(procedure, status, message, stat, errmsg)
    end subroutine
end module mgdt_mpi
