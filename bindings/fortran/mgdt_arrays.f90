! SPDX-License-Identifier: MIT
! Exported arrays. Shapes are checked here, capacities by C.
submodule (mgdt) mgdt_arrays
    use, intrinsic :: iso_c_binding, only: c_int32_t, c_int64_t
    use mgdt_c, only: c_export_i32, c_export_i64, c_get_edges_i32, c_get_edges_i64, &
                      c_get_hull_facets_i32, c_get_hull_facets_i64, c_get_neighbors_i32, &
                      c_get_neighbors_i64, c_get_point_map_i32, c_get_point_map_i64, &
                      c_get_tetrahedra_i32, c_get_tetrahedra_i64, c_get_vertex_tetrahedra
    use mgdt_support, only: borrow, decimal, finish, tell
    implicit none

contains

    module procedure get_tetrahedra_i32_1
        call export_i32(self, c_get_tetrahedra_i32, 'get_tetrahedra', &
                        size(tetrahedra, kind=int64), tetrahedra, stat, errmsg)
    end procedure

    module procedure get_tetrahedra_i32_2
        if (fits('get_tetrahedra', shape(tetrahedra, int64), 4_int64, stat, errmsg)) &
            call export_i32(self, c_get_tetrahedra_i32, 'get_tetrahedra', &
                            size(tetrahedra, kind=int64), tetrahedra, stat, errmsg)
    end procedure

    module procedure get_tetrahedra_i64_1
        call export_i64(self, c_get_tetrahedra_i64, 'get_tetrahedra', &
                        size(tetrahedra, kind=int64), tetrahedra, stat, errmsg)
    end procedure

    module procedure get_tetrahedra_i64_2
        if (fits('get_tetrahedra', shape(tetrahedra, int64), 4_int64, stat, errmsg)) &
            call export_i64(self, c_get_tetrahedra_i64, 'get_tetrahedra', &
                            size(tetrahedra, kind=int64), tetrahedra, stat, errmsg)
    end procedure

    module procedure get_neighbors_i32_1
        call export_i32(self, c_get_neighbors_i32, 'get_neighbors', &
                        size(neighbors, kind=int64), neighbors, stat, errmsg)
    end procedure

    module procedure get_neighbors_i32_2
        if (fits('get_neighbors', shape(neighbors, int64), 4_int64, stat, errmsg)) &
            call export_i32(self, c_get_neighbors_i32, 'get_neighbors', &
                            size(neighbors, kind=int64), neighbors, stat, errmsg)
    end procedure

    module procedure get_neighbors_i64_1
        call export_i64(self, c_get_neighbors_i64, 'get_neighbors', &
                        size(neighbors, kind=int64), neighbors, stat, errmsg)
    end procedure

    module procedure get_neighbors_i64_2
        if (fits('get_neighbors', shape(neighbors, int64), 4_int64, stat, errmsg)) &
            call export_i64(self, c_get_neighbors_i64, 'get_neighbors', &
                            size(neighbors, kind=int64), neighbors, stat, errmsg)
    end procedure

    module procedure get_hull_facets_i32_1
        call export_i32(self, c_get_hull_facets_i32, 'get_hull_facets', &
                        size(facets, kind=int64), facets, stat, errmsg)
    end procedure

    module procedure get_hull_facets_i32_2
        if (fits('get_hull_facets', shape(facets, int64), 3_int64, stat, errmsg)) &
            call export_i32(self, c_get_hull_facets_i32, 'get_hull_facets', &
                            size(facets, kind=int64), facets, stat, errmsg)
    end procedure

    module procedure get_hull_facets_i64_1
        call export_i64(self, c_get_hull_facets_i64, 'get_hull_facets', &
                        size(facets, kind=int64), facets, stat, errmsg)
    end procedure

    module procedure get_hull_facets_i64_2
        if (fits('get_hull_facets', shape(facets, int64), 3_int64, stat, errmsg)) &
            call export_i64(self, c_get_hull_facets_i64, 'get_hull_facets', &
                            size(facets, kind=int64), facets, stat, errmsg)
    end procedure

    module procedure get_edges_i32_1
        call export_i32(self, c_get_edges_i32, 'get_edges', &
                        size(edges, kind=int64), edges, stat, errmsg)
    end procedure

    module procedure get_edges_i32_2
        if (fits('get_edges', shape(edges, int64), 2_int64, stat, errmsg)) &
            call export_i32(self, c_get_edges_i32, 'get_edges', &
                            size(edges, kind=int64), edges, stat, errmsg)
    end procedure

    module procedure get_edges_i64_1
        call export_i64(self, c_get_edges_i64, 'get_edges', &
                        size(edges, kind=int64), edges, stat, errmsg)
    end procedure

    module procedure get_edges_i64_2
        if (fits('get_edges', shape(edges, int64), 2_int64, stat, errmsg)) &
            call export_i64(self, c_get_edges_i64, 'get_edges', &
                            size(edges, kind=int64), edges, stat, errmsg)
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

    ! Whether the first extent is that of the array asked for. Otherwise columns would be torn.
    function fits(procedure, extents, width, stat, errmsg)
        character(*), intent(in) :: procedure
        integer(int64), intent(in) :: extents(2), width
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        logical :: fits

        fits = extents(1) == width
        if (.not. fits) &
            call tell(procedure, int(mgdt_err_invalid_argument, c_int32_t), &
                      'the array has extent '//decimal(extents(1))// &
                      ' in dimension 1; it must be '//decimal(width), stat, errmsg)
    end function
end submodule mgdt_arrays
