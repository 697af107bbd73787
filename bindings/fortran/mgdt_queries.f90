! SPDX-License-Identifier: MIT
! Location, nearest vertices, the check, statistics: calls that only read.
submodule (mgdt) mgdt_queries
    use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t, c_loc
    use mgdt_c, only: c_check, c_get_stat, c_locate_points, c_nearest_vertex
    use mgdt_support, only: borrow, decimal, finish, tell, to_c
    implicit none

contains

    module procedure locate_i32
        type(c_ptr) :: handle, where_to
        integer(c_int32_t) :: status
        integer(int32) :: found(1)

        where_to = c_null_ptr
        if (present(weights)) where_to = c_loc(weights)
        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) &
            status = c_locate_points(handle, 1_c_int64_t, point, found, where_to)
        if (status == mgdt_ok) tetrahedron = found(1)
        call finish(handle, 'locate', status, stat, errmsg, owned=self%handle)
    end procedure

    module procedure locate_i64
        type(c_ptr) :: handle, where_to
        integer(c_int32_t) :: status
        integer(int64) :: found(1)

        where_to = c_null_ptr
        if (present(weights)) where_to = c_loc(weights)
        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) &
            status = c_locate_points(handle, 1_c_int64_t, point, found, where_to)
        if (status == mgdt_ok) tetrahedron = found(1)
        call finish(handle, 'locate', status, stat, errmsg, owned=self%handle)
    end procedure

    module procedure locate_points_i32_1
        type(c_ptr) :: where_to
        integer(int64) :: n, room

        n = size(xyz, kind=int64)/3
        room = 4*n
        where_to = c_null_ptr
        if (present(weights)) then
            room = size(weights, kind=int64)
            if (room > 0) where_to = c_loc(weights)
        end if
        if (fit([3 + mod(size(xyz, kind=int64), 3_int64), n], size(tetrahedra, kind=int64), &
                [4_int64, room/4], stat, errmsg)) &
            call locate_many_i32(self, n, xyz, tetrahedra, where_to, stat, errmsg)
    end procedure

    module procedure locate_points_i32_2
        type(c_ptr) :: where_to
        integer(int64) :: room(2)

        room = [4_int64, size(xyz, 2, kind=int64)]
        where_to = c_null_ptr
        if (present(weights)) then
            room = shape(weights, int64)
            if (size(weights, kind=int64) > 0) where_to = c_loc(weights)
        end if
        if (fit(shape(xyz, int64), size(tetrahedra, kind=int64), room, stat, errmsg)) &
            call locate_many_i32(self, size(xyz, 2, kind=int64), xyz, tetrahedra, where_to, &
                                 stat, errmsg)
    end procedure

    module procedure locate_points_i64_1
        type(c_ptr) :: where_to
        integer(int64) :: n, room

        n = size(xyz, kind=int64)/3
        room = 4*n
        where_to = c_null_ptr
        if (present(weights)) then
            room = size(weights, kind=int64)
            if (room > 0) where_to = c_loc(weights)
        end if
        if (fit([3 + mod(size(xyz, kind=int64), 3_int64), n], size(tetrahedra, kind=int64), &
                [4_int64, room/4], stat, errmsg)) &
            call locate_many_i64(self, n, xyz, tetrahedra, where_to, stat, errmsg)
    end procedure

    module procedure locate_points_i64_2
        type(c_ptr) :: where_to
        integer(int64) :: room(2)

        room = [4_int64, size(xyz, 2, kind=int64)]
        where_to = c_null_ptr
        if (present(weights)) then
            room = shape(weights, int64)
            if (size(weights, kind=int64) > 0) where_to = c_loc(weights)
        end if
        if (fit(shape(xyz, int64), size(tetrahedra, kind=int64), room, stat, errmsg)) &
            call locate_many_i64(self, size(xyz, 2, kind=int64), xyz, tetrahedra, where_to, &
                                 stat, errmsg)
    end procedure

    subroutine locate_many_i32(self, n, xyz, tetrahedra, weights, stat, errmsg)
        class(mgdt_triangulation), intent(in) :: self
        integer(c_int64_t), intent(in) :: n
        real(real64), intent(in) :: xyz(*)
        integer(int32), intent(inout) :: tetrahedra(*)
        type(c_ptr), intent(in) :: weights
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(c_int32_t) :: status

        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) status = c_locate_points(handle, n, xyz, tetrahedra, weights)
        call finish(handle, 'locate_points', status, stat, errmsg, owned=self%handle)
    end subroutine

    subroutine locate_many_i64(self, n, xyz, tetrahedra, weights, stat, errmsg)
        class(mgdt_triangulation), intent(in) :: self
        integer(c_int64_t), intent(in) :: n
        real(real64), intent(in) :: xyz(*)
        integer(int64), intent(inout) :: tetrahedra(*)
        type(c_ptr), intent(in) :: weights
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(c_int32_t) :: status

        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) status = c_locate_points(handle, n, xyz, tetrahedra, weights)
        call finish(handle, 'locate_points', status, stat, errmsg, owned=self%handle)
    end subroutine

    ! Whether the arrays of locate_points go together: points (3, n), n tetrahedra, weights (4, n).
    function fit(points, n_tetrahedra, weights, stat, errmsg)
        integer(int64), intent(in) :: points(2), n_tetrahedra, weights(2)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        logical :: fit
        integer(c_int32_t) :: status
        character(:), allocatable :: message

        status = mgdt_err_invalid_argument
        message = ''
        if (points(1) /= 3) then
            message = 'xyz must hold 3 coordinates for each point'
        else if (weights(1) /= 4) then
            message = 'weights has extent '//decimal(weights(1))//' in dimension 1; it must be 4'
        else if (n_tetrahedra < points(2)) then
            status = mgdt_err_buffer_too_small
            message = 'tetrahedra holds '//decimal(n_tetrahedra)//' elements; '// &
                      decimal(points(2))//' are needed'
        else if (weights(2) < points(2)) then
            status = mgdt_err_buffer_too_small
            message = 'weights has room for '//decimal(weights(2))//' points; '// &
                      decimal(points(2))//' are needed'
        end if
        fit = message == ''
        if (.not. fit) call tell('locate_points', status, message, stat, errmsg)
    end function

    module procedure nearest_vertex_i64
        type(c_ptr) :: handle
        integer(c_int32_t) :: status

        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) status = c_nearest_vertex(handle, point, vertex)
        call finish(handle, 'nearest_vertex', status, stat, errmsg, owned=self%handle)
    end procedure

    module procedure nearest_vertex_i32
        integer(int64) :: found
        integer :: status
        character(256) :: message

        found = 0
        call self%nearest_vertex(point, found, status, message)
        if (status == mgdt_ok .and. found > huge(vertex)) then
            status = mgdt_err_index_range
            message = 'vertex '//decimal(found)//' does not fit a 32-bit integer'
        end if
        if (status == mgdt_ok) vertex = int(found, int32)
        call tell('nearest_vertex', to_c(status), trim(message), stat, errmsg)
    end procedure

    module procedure check
        type(c_ptr) :: handle
        integer(c_int32_t) :: status

        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) status = c_check(handle, to_c(level))
        call finish(handle, 'check', status, stat, errmsg, owned=self%handle)
    end procedure

    module procedure get_stat
        type(c_ptr) :: handle
        integer(c_int32_t) :: status

        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) status = c_get_stat(handle, to_c(key), value)
        call finish(handle, 'get_stat', status, stat, errmsg, owned=self%handle)
    end procedure
end submodule mgdt_queries
