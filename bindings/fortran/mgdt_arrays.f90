! SPDX-License-Identifier: MIT
! Exported arrays. Shapes are checked here, capacities by C.
submodule (mgdt) mgdt_arrays
    use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t
    use mgdt_c, only: c_export_i32, c_export_i64, c_get_edges_i32, c_get_edges_i64, &
                      c_get_hull_facets_i32, c_get_hull_facets_i64, c_get_neighbors_i32, &
                      c_get_neighbors_i64, c_get_point_map_i32, c_get_point_map_i64, &
                      c_get_tetrahedra_i32, c_get_tetrahedra_i64, c_get_vertex_tetrahedra
    use mgdt_layout, only: transpose_i32, transpose_i64
    use mgdt_support, only: borrow, decimal, finish, tell
    implicit none

    interface export_1
        procedure :: export_i32_1, export_i64_1
    end interface
    interface export_2
        procedure :: export_i32_2, export_i64_2
    end interface

contains

    module procedure get_tetrahedra_i32_1
        call export_1(self, c_get_tetrahedra_i32, 'get_tetrahedra', 4*self%tetrahedron_count(), &
                      tetrahedra, stat, errmsg)
    end procedure

    module procedure get_tetrahedra_i32_2
        call export_2(self, c_get_tetrahedra_i32, 'get_tetrahedra', 4_int64, self%tetrahedron_count(), &
                      tetrahedra, stat, errmsg, dim)
    end procedure

    module procedure get_tetrahedra_i64_1
        call export_1(self, c_get_tetrahedra_i64, 'get_tetrahedra', 4*self%tetrahedron_count(), &
                      tetrahedra, stat, errmsg)
    end procedure

    module procedure get_tetrahedra_i64_2
        call export_2(self, c_get_tetrahedra_i64, 'get_tetrahedra', 4_int64, self%tetrahedron_count(), &
                      tetrahedra, stat, errmsg, dim)
    end procedure

    module procedure get_neighbors_i32_1
        call export_1(self, c_get_neighbors_i32, 'get_neighbors', 4*self%tetrahedron_count(), &
                      neighbors, stat, errmsg)
    end procedure

    module procedure get_neighbors_i32_2
        call export_2(self, c_get_neighbors_i32, 'get_neighbors', 4_int64, self%tetrahedron_count(), &
                      neighbors, stat, errmsg, dim)
    end procedure

    module procedure get_neighbors_i64_1
        call export_1(self, c_get_neighbors_i64, 'get_neighbors', 4*self%tetrahedron_count(), &
                      neighbors, stat, errmsg)
    end procedure

    module procedure get_neighbors_i64_2
        call export_2(self, c_get_neighbors_i64, 'get_neighbors', 4_int64, self%tetrahedron_count(), &
                      neighbors, stat, errmsg, dim)
    end procedure

    module procedure get_hull_facets_i32_1
        call export_1(self, c_get_hull_facets_i32, 'get_hull_facets', 3*self%hull_facet_count(), &
                      facets, stat, errmsg)
    end procedure

    module procedure get_hull_facets_i32_2
        call export_2(self, c_get_hull_facets_i32, 'get_hull_facets', 3_int64, self%hull_facet_count(), &
                      facets, stat, errmsg, dim)
    end procedure

    module procedure get_hull_facets_i64_1
        call export_1(self, c_get_hull_facets_i64, 'get_hull_facets', 3*self%hull_facet_count(), &
                      facets, stat, errmsg)
    end procedure

    module procedure get_hull_facets_i64_2
        call export_2(self, c_get_hull_facets_i64, 'get_hull_facets', 3_int64, self%hull_facet_count(), &
                      facets, stat, errmsg, dim)
    end procedure

    module procedure get_edges_i32_1
        call export_1(self, c_get_edges_i32, 'get_edges', 2*self%edge_count(), &
                      edges, stat, errmsg)
    end procedure

    module procedure get_edges_i32_2
        call export_2(self, c_get_edges_i32, 'get_edges', 2_int64, self%edge_count(), &
                      edges, stat, errmsg, dim)
    end procedure

    module procedure get_edges_i64_1
        call export_1(self, c_get_edges_i64, 'get_edges', 2*self%edge_count(), &
                      edges, stat, errmsg)
    end procedure

    module procedure get_edges_i64_2
        call export_2(self, c_get_edges_i64, 'get_edges', 2_int64, self%edge_count(), &
                      edges, stat, errmsg, dim)
    end procedure

    module procedure get_point_map_i32
        call export_i32(self, c_get_point_map_i32, 'get_point_map', size(point_map, kind=int64), &
                        point_map, stat, errmsg)
    end procedure

    module procedure get_point_map_i64
        call export_i64(self, c_get_point_map_i64, 'get_point_map', size(point_map, kind=int64), &
                        point_map, stat, errmsg)
    end procedure

    module procedure get_vertex_tetrahedra_i32
        type(c_ptr) :: handle
        integer(c_int32_t) :: status

        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) &
            status = c_get_vertex_tetrahedra(handle, size(offsets, kind=c_int64_t), offsets, &
                                             size(list, kind=c_int64_t), list)
        call finish(handle, 'get_vertex_tetrahedra', status, stat, errmsg, owned=self%handle)
    end procedure

    module procedure get_vertex_tetrahedra_i64
        type(c_ptr) :: handle
        integer(c_int32_t) :: status

        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) &
            status = c_get_vertex_tetrahedra(handle, size(offsets, kind=c_int64_t), offsets, &
                                             size(list, kind=c_int64_t), list)
        call finish(handle, 'get_vertex_tetrahedra', status, stat, errmsg, owned=self%handle)
    end procedure

    subroutine export_i32(self, get, procedure, capacity, v, stat, errmsg)
        class(mgdt_triangulation), intent(in) :: self
        procedure(c_export_i32) :: get
        character(*), intent(in) :: procedure
        integer(c_int64_t), intent(in) :: capacity
        integer(int32), intent(inout) :: v(*)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(c_int32_t) :: status

        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) status = get(handle, capacity, v)
        call finish(handle, procedure, status, stat, errmsg, owned=self%handle)
    end subroutine

    subroutine export_i64(self, get, procedure, capacity, v, stat, errmsg)
        class(mgdt_triangulation), intent(in) :: self
        procedure(c_export_i64) :: get
        character(*), intent(in) :: procedure
        integer(c_int64_t), intent(in) :: capacity
        integer(int64), intent(inout) :: v(*)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        type(c_ptr) :: handle
        integer(c_int32_t) :: status

        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) status = get(handle, capacity, v)
        call finish(handle, procedure, status, stat, errmsg, owned=self%handle)
    end subroutine

    ! To any section of rank 1, which gets `count` integers. Where it is too small, C refuses its
    ! size before it writes.
    subroutine export_i32_1(self, get, procedure, count, v, stat, errmsg)
        class(mgdt_triangulation), intent(in) :: self
        procedure(c_export_i32) :: get
        character(*), intent(in) :: procedure
        integer(int64), intent(in) :: count
        integer(int32), intent(inout) :: v(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(int32), allocatable :: records(:)
        type(c_ptr) :: handle
        integer(c_int32_t) :: status
        integer :: failed

        failed = 0
        if (.not. is_contiguous(v)) &
            allocate (records(min(count, size(v, kind=int64))), stat=failed)
        if (failed /= 0) then
            call tell_no_copy(procedure, stat, errmsg)
            return
        end if
        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) then
            if (is_contiguous(v)) then
                status = get(handle, size(v, kind=c_int64_t), v)
            else
                status = get(handle, size(v, kind=c_int64_t), records)
                if (status == mgdt_ok) v(:count) = records
            end if
        end if
        call finish(handle, procedure, status, stat, errmsg, owned=self%handle)
    end subroutine

    ! To any section of rank 2, which gets `count` records of `width` integers along `dim`.
    subroutine export_i32_2(self, get, procedure, width, count, v, stat, errmsg, dim)
        class(mgdt_triangulation), intent(in) :: self
        procedure(c_export_i32) :: get
        character(*), intent(in) :: procedure
        integer(int64), intent(in) :: width, count
        integer(int32), intent(inout) :: v(:, :)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer, intent(in), optional :: dim
        integer(int32), allocatable :: records(:, :)
        type(c_ptr) :: handle
        integer(c_int32_t) :: status
        integer(int64) :: k
        integer :: along, failed
        logical :: in_place

        along = 1
        if (present(dim)) along = dim
        if (.not. fits(procedure, shape(v, int64), width, along, stat, errmsg)) return
        in_place = is_contiguous(v) .and. (along == 1 .or. size(v, 1, int64) == count)
        failed = 0
        if (.not. in_place) &
            allocate (records(width, min(count, size(v, 3 - along, int64))), stat=failed)
        if (failed /= 0) then
            call tell_no_copy(procedure, stat, errmsg)
            return
        end if
        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) then
            if (in_place) then
                status = get(handle, size(v, kind=c_int64_t), v)
                if (status == mgdt_ok .and. along == 2) &
                    call transpose_i32(v, width, count, count)
            else
                status = get(handle, size(v, kind=c_int64_t), records)
            end if
        end if
        if (status == mgdt_ok .and. .not. in_place) then
            if (along == 1) v(:, :count) = records
            if (along == 2) then
                do k = 1, width
                    v(:count, k) = records(k, :)
                end do
            end if
        end if
        call finish(handle, procedure, status, stat, errmsg, owned=self%handle)
    end subroutine

    ! To any section of rank 1, which gets `count` integers. Where it is too small, C refuses its
    ! size before it writes.
    subroutine export_i64_1(self, get, procedure, count, v, stat, errmsg)
        class(mgdt_triangulation), intent(in) :: self
        procedure(c_export_i64) :: get
        character(*), intent(in) :: procedure
        integer(int64), intent(in) :: count
        integer(int64), intent(inout) :: v(:)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(int64), allocatable :: records(:)
        type(c_ptr) :: handle
        integer(c_int32_t) :: status
        integer :: failed

        failed = 0
        if (.not. is_contiguous(v)) &
            allocate (records(min(count, size(v, kind=int64))), stat=failed)
        if (failed /= 0) then
            call tell_no_copy(procedure, stat, errmsg)
            return
        end if
        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) then
            if (is_contiguous(v)) then
                status = get(handle, size(v, kind=c_int64_t), v)
            else
                status = get(handle, size(v, kind=c_int64_t), records)
                if (status == mgdt_ok) v(:count) = records
            end if
        end if
        call finish(handle, procedure, status, stat, errmsg, owned=self%handle)
    end subroutine

    ! To any section of rank 2, which gets `count` records of `width` integers along `dim`.
    subroutine export_i64_2(self, get, procedure, width, count, v, stat, errmsg, dim)
        class(mgdt_triangulation), intent(in) :: self
        procedure(c_export_i64) :: get
        character(*), intent(in) :: procedure
        integer(int64), intent(in) :: width, count
        integer(int64), intent(inout) :: v(:, :)
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer, intent(in), optional :: dim
        integer(int64), allocatable :: records(:, :)
        type(c_ptr) :: handle
        integer(c_int32_t) :: status
        integer(int64) :: k
        integer :: along, failed
        logical :: in_place

        along = 1
        if (present(dim)) along = dim
        if (.not. fits(procedure, shape(v, int64), width, along, stat, errmsg)) return
        in_place = is_contiguous(v) .and. (along == 1 .or. size(v, 1, int64) == count)
        failed = 0
        if (.not. in_place) &
            allocate (records(width, min(count, size(v, 3 - along, int64))), stat=failed)
        if (failed /= 0) then
            call tell_no_copy(procedure, stat, errmsg)
            return
        end if
        call borrow(self%handle, handle, status)
        if (status == mgdt_ok) then
            if (in_place) then
                status = get(handle, size(v, kind=c_int64_t), v)
                if (status == mgdt_ok .and. along == 2) &
                    call transpose_i64(v, width, count, count)
            else
                status = get(handle, size(v, kind=c_int64_t), records)
            end if
        end if
        if (status == mgdt_ok .and. .not. in_place) then
            if (along == 1) v(:, :count) = records
            if (along == 2) then
                do k = 1, width
                    v(:count, k) = records(k, :)
                end do
            end if
        end if
        call finish(handle, procedure, status, stat, errmsg, owned=self%handle)
    end subroutine

    ! Whether the extent along `dim` is that of the array asked for. Otherwise records would be torn.
    function fits(procedure, extents, width, dim, stat, errmsg)
        character(*), intent(in) :: procedure
        integer(int64), intent(in) :: extents(2), width
        integer, intent(in) :: dim
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        logical :: fits

        fits = dim == 1 .or. dim == 2
        if (.not. fits) then
            call tell(procedure, int(mgdt_err_invalid_argument, c_int32_t), &
                      'dim is '//decimal(int(dim, int64))//'; it must be 1 or 2', stat, errmsg)
            return
        end if
        fits = extents(dim) == width
        if (.not. fits) &
            call tell(procedure, int(mgdt_err_invalid_argument, c_int32_t), &
                      'the array has extent '//decimal(extents(dim))//' in dimension '// &
                      decimal(int(dim, int64))//'; it must be '//decimal(width), stat, errmsg)
    end function

    subroutine tell_no_copy(procedure, stat, errmsg)
        character(*), intent(in) :: procedure
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg

        call tell(procedure, int(mgdt_err_out_of_memory, c_int32_t), &
                  'there is no memory for the copy that an array of this layout needs', stat, errmsg)
    end subroutine
end submodule mgdt_arrays
