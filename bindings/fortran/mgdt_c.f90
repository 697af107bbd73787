! SPDX-License-Identifier: MIT
! Generated from mgdt/mgdt.h, mgdt_voronoi.h, mgdt_mesh.h, mgdt_domain.h, mgdt_periodic.h by bindings/interface/generate.py.
!
! The C functions of mgdt as they stand in mgdt/mgdt.h, where they are documented. Module mgdt and
! mgdt_f77.f90 are built on these; programs rarely need them.
!
! c_NAME is mgdt_NAME. Functions with 32-bit and 64-bit arrays are one generic name, except where
! the array may be null: those are c_NAME_i32 and c_NAME_i64. A result that is
! a pointer is to a static string that ends with NUL, or null. Counts are pure, so that they may give
! the bounds of automatic arrays.
module mgdt_c
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_funptr, c_int32_t, c_int64_t, &
                                           c_ptr, c_size_t
    implicit none
    public

    ! What the exports of one array have in common.
    abstract interface
        function c_export_i32(t, capacity, v) result(status) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: v(*)
            integer(c_int32_t) :: status
        end function
        function c_export_i64(t, capacity, v) result(status) bind(c)
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: v(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface
        pure function c_strlen(s) result(length) bind(c, name='strlen')
            import :: c_ptr, c_size_t
            type(c_ptr), value :: s
            integer(c_size_t) :: length
        end function
        function c_create(out) result(status) bind(c, name='mgdt_create')
            import :: c_int32_t, c_ptr
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        function c_create_with_allocator(alloc, release, user, out) result(status) &
            bind(c, name='mgdt_create_with_allocator')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_funptr), value :: alloc
            type(c_funptr), value :: release
            type(c_ptr), value :: user
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        subroutine c_destroy(t) bind(c, name='mgdt_destroy')
            import :: c_ptr
            type(c_ptr), value :: t
        end subroutine
        function c_clear(t) result(status) bind(c, name='mgdt_clear')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t) :: status
        end function
        function c_reserve(t, n_points) result(status) bind(c, name='mgdt_reserve')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n_points
            integer(c_int32_t) :: status
        end function
        function c_shrink(t) result(status) bind(c, name='mgdt_shrink')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t) :: status
        end function
        function c_set_order_scheme(t, scheme) result(status) bind(c, name='mgdt_set_order_scheme')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: scheme
            integer(c_int32_t) :: status
        end function
        function c_get_order_scheme(t, scheme) result(status) bind(c, name='mgdt_get_order_scheme')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), intent(inout) :: scheme
            integer(c_int32_t) :: status
        end function
        function c_set_order_parameter(t, key, value) result(status) &
            bind(c, name='mgdt_set_order_parameter')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: key
            real(c_double), value :: value
            integer(c_int32_t) :: status
        end function
        function c_get_order_parameter(t, key, value) result(status) &
            bind(c, name='mgdt_get_order_parameter')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: key
            real(c_double), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_set_seed(t, seed) result(status) bind(c, name='mgdt_set_seed')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: seed
            integer(c_int32_t) :: status
        end function
        function c_get_seed(t, seed) result(status) bind(c, name='mgdt_get_seed')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), intent(inout) :: seed
            integer(c_int32_t) :: status
        end function
        function c_set_threads(t, n) result(status) bind(c, name='mgdt_set_threads')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: n
            integer(c_int32_t) :: status
        end function
        function c_get_threads(t, n) result(status) bind(c, name='mgdt_get_threads')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), intent(inout) :: n
            integer(c_int32_t) :: status
        end function
        function c_set_index_base(t, base) result(status) bind(c, name='mgdt_set_index_base')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: base
            integer(c_int32_t) :: status
        end function
        function c_get_index_base(t, base) result(status) bind(c, name='mgdt_get_index_base')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), intent(inout) :: base
            integer(c_int32_t) :: status
        end function
        function c_set_memory_limit(t, bytes) result(status) bind(c, name='mgdt_set_memory_limit')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: bytes
            integer(c_int32_t) :: status
        end function
        function c_get_memory_limit(t, bytes) result(status) bind(c, name='mgdt_get_memory_limit')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), intent(inout) :: bytes
            integer(c_int32_t) :: status
        end function
        function c_set_compact(t, on) result(status) bind(c, name='mgdt_set_compact')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: on
            integer(c_int32_t) :: status
        end function
        function c_get_compact(t, on) result(status) bind(c, name='mgdt_get_compact')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), intent(inout) :: on
            integer(c_int32_t) :: status
        end function
        function c_set_progress(t, fn, user) result(status) bind(c, name='mgdt_set_progress')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: t
            type(c_funptr), value :: fn
            type(c_ptr), value :: user
            integer(c_int32_t) :: status
        end function
        function c_get_progress(t, fn, user) result(status) bind(c, name='mgdt_get_progress')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: t
            type(c_funptr), intent(out) :: fn
            type(c_ptr), intent(out) :: user
            integer(c_int32_t) :: status
        end function
        function c_cancel(t) result(status) bind(c, name='mgdt_cancel')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t) :: status
        end function
        function c_set_read_progress(t, on) result(status) bind(c, name='mgdt_set_read_progress')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: on
            integer(c_int32_t) :: status
        end function
        function c_get_read_progress(t, on) result(status) bind(c, name='mgdt_get_read_progress')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), intent(inout) :: on
            integer(c_int32_t) :: status
        end function
        function c_set_canonical_output(t, on) result(status) &
            bind(c, name='mgdt_set_canonical_output')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: on
            integer(c_int32_t) :: status
        end function
        function c_get_canonical_output(t, on) result(status) &
            bind(c, name='mgdt_get_canonical_output')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), intent(inout) :: on
            integer(c_int32_t) :: status
        end function
        function c_set_isa(t, name) result(status) bind(c, name='mgdt_set_isa')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            type(c_ptr), value :: name
            integer(c_int32_t) :: status
        end function
        function c_insert_points(t, n, xyz) result(status) bind(c, name='mgdt_insert_points')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int32_t) :: status
        end function
        function c_insert_points_strided(t, n, x, y, z, stride) result(status) &
            bind(c, name='mgdt_insert_points_strided')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n
            type(c_ptr), value :: x
            type(c_ptr), value :: y
            type(c_ptr), value :: z
            integer(c_int64_t), value :: stride
            integer(c_int32_t) :: status
        end function
        function c_move_points_i32(t, n, points, xyz) result(status) &
            bind(c, name='mgdt_move_points_i32')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n
            type(c_ptr), value :: points
            real(c_double), intent(in) :: xyz(*)
            integer(c_int32_t) :: status
        end function
        function c_move_points_i64(t, n, points, xyz) result(status) &
            bind(c, name='mgdt_move_points')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n
            type(c_ptr), value :: points
            real(c_double), intent(in) :: xyz(*)
            integer(c_int32_t) :: status
        end function
        pure function c_point_count(t) result(count) bind(c, name='mgdt_point_count')
            import :: c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t) :: count
        end function
        pure function c_vertex_count(t) result(count) bind(c, name='mgdt_vertex_count')
            import :: c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t) :: count
        end function
        pure function c_dimension(t) result(count) bind(c, name='mgdt_dimension')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t) :: count
        end function
        pure function c_tetrahedron_count(t) result(count) bind(c, name='mgdt_tetrahedron_count')
            import :: c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t) :: count
        end function
        pure function c_hull_facet_count(t) result(count) bind(c, name='mgdt_hull_facet_count')
            import :: c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t) :: count
        end function
        pure function c_edge_count(t) result(count) bind(c, name='mgdt_edge_count')
            import :: c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t) :: count
        end function
        pure function c_vertex_tetrahedra_count(t) result(count) &
            bind(c, name='mgdt_vertex_tetrahedra_count')
            import :: c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t) :: count
        end function
        pure function c_vertex_neighbors_count(t) result(count) &
            bind(c, name='mgdt_vertex_neighbors_count')
            import :: c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t) :: count
        end function
        function c_get_circumcenters(t, capacity, xyz, radius2) result(status) &
            bind(c, name='mgdt_get_circumcenters')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            real(c_double), intent(inout) :: xyz(*)
            type(c_ptr), value :: radius2
            integer(c_int32_t) :: status
        end function
        function c_get_tetrahedron_measures(t, measure, capacity, x) result(status) &
            bind(c, name='mgdt_get_tetrahedron_measures')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: measure
            integer(c_int64_t), value :: capacity
            real(c_double), intent(inout) :: x(*)
            integer(c_int32_t) :: status
        end function
        function c_get_cell_measures(t, measure, n_planes, planes, capacity, x) result(status) &
            bind(c, name='mgdt_get_cell_measures')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: measure
            integer(c_int64_t), value :: n_planes
            type(c_ptr), value :: planes
            integer(c_int64_t), value :: capacity
            real(c_double), intent(inout) :: x(*)
            integer(c_int32_t) :: status
        end function
        function c_get_alphas(t, dimension, capacity, alpha2) result(status) &
            bind(c, name='mgdt_get_alphas')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: dimension
            integer(c_int64_t), value :: capacity
            real(c_double), intent(inout) :: alpha2(*)
            integer(c_int32_t) :: status
        end function
        function c_get_solid_alpha(t, alpha2) result(status) bind(c, name='mgdt_get_solid_alpha')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: t
            real(c_double), intent(inout) :: alpha2
            integer(c_int32_t) :: status
        end function
        function c_interpolate(t, method, outside, n_fields, values, n, xyz, out) &
            result(status) &
            bind(c, name='mgdt_interpolate')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: method
            integer(c_int32_t), value :: outside
            integer(c_int64_t), value :: n_fields
            real(c_double), intent(in) :: values(*)
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            real(c_double), intent(inout) :: out(*)
            integer(c_int32_t) :: status
        end function
        function c_get_gradients(t, n_fields, values, out) result(status) &
            bind(c, name='mgdt_get_gradients')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n_fields
            real(c_double), intent(in) :: values(*)
            real(c_double), intent(inout) :: out(*)
            integer(c_int32_t) :: status
        end function
        function c_check(t, level) result(status) bind(c, name='mgdt_check')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: level
            integer(c_int32_t) :: status
        end function
        function c_get_stat(t, key, value) result(status) bind(c, name='mgdt_get_stat')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: key
            real(c_double), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_stat_name(key) result(text) bind(c, name='mgdt_stat_name')
            import :: c_int32_t, c_ptr
            integer(c_int32_t), value :: key
            type(c_ptr) :: text
        end function
        function c_status_string(s) result(text) bind(c, name='mgdt_status_string')
            import :: c_int32_t, c_ptr
            integer(c_int32_t), value :: s
            type(c_ptr) :: text
        end function
        function c_get_error(t, capacity, buffer) result(status) bind(c, name='mgdt_get_error')
            import :: c_char, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            character(kind=c_char), intent(inout) :: buffer(*)
            integer(c_int32_t) :: status
        end function
        function c_order_scheme_name(scheme) result(text) bind(c, name='mgdt_order_scheme_name')
            import :: c_int32_t, c_ptr
            integer(c_int32_t), value :: scheme
            type(c_ptr) :: text
        end function
        function c_order_scheme_from_name(name, scheme) result(status) &
            bind(c, name='mgdt_order_scheme_from_name')
            import :: c_char, c_int32_t
            character(kind=c_char), intent(in) :: name(*)
            integer(c_int32_t), intent(inout) :: scheme
            integer(c_int32_t) :: status
        end function
        function c_order_scheme_at(index, scheme) result(status) &
            bind(c, name='mgdt_order_scheme_at')
            import :: c_int32_t
            integer(c_int32_t), value :: index
            integer(c_int32_t), intent(inout) :: scheme
            integer(c_int32_t) :: status
        end function
        function c_version_string() result(text) bind(c, name='mgdt_version_string')
            import :: c_ptr
            type(c_ptr) :: text
        end function
        function c_abi_version() result(answer) bind(c, name='mgdt_abi_version')
            import :: c_int32_t
            integer(c_int32_t) :: answer
        end function
        function c_isa_name(t) result(text) bind(c, name='mgdt_isa_name')
            import :: c_ptr
            type(c_ptr), value :: t
            type(c_ptr) :: text
        end function
        function c_voronoi_create(t, n_planes, planes, out) result(status) &
            bind(c, name='mgdt_voronoi_create')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n_planes
            type(c_ptr), value :: planes
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        subroutine c_voronoi_destroy(v) bind(c, name='mgdt_voronoi_destroy')
            import :: c_ptr
            type(c_ptr), value :: v
        end subroutine
        function c_voronoi_get_stat(v, key, value) result(status) &
            bind(c, name='mgdt_voronoi_get_stat')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: v
            integer(c_int32_t), value :: key
            integer(c_int64_t), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_voronoi_array_info(array, columns, is_double) result(status) &
            bind(c, name='mgdt_voronoi_array_info')
            import :: c_int32_t
            integer(c_int32_t), value :: array
            integer(c_int32_t), intent(inout) :: columns
            integer(c_int32_t), intent(inout) :: is_double
            integer(c_int32_t) :: status
        end function
        function c_voronoi_get_size(v, array, size) result(status) &
            bind(c, name='mgdt_voronoi_get_size')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: v
            integer(c_int32_t), value :: array
            integer(c_int64_t), intent(inout) :: size
            integer(c_int32_t) :: status
        end function
        function c_voronoi_get_doubles(v, array, capacity, values) result(status) &
            bind(c, name='mgdt_voronoi_get_doubles')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: v
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            real(c_double), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
        function c_voronoi_drop_small_faces(v, least_area, least_share) result(status) &
            bind(c, name='mgdt_voronoi_drop_small_faces')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: v
            real(c_double), value :: least_area
            real(c_double), value :: least_share
            integer(c_int32_t) :: status
        end function
        function c_voronoi_get_error(v, capacity, buffer) result(status) &
            bind(c, name='mgdt_voronoi_get_error')
            import :: c_char, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: v
            integer(c_int64_t), value :: capacity
            character(kind=c_char), intent(inout) :: buffer(*)
            integer(c_int32_t) :: status
        end function
        function c_mesh_create(out) result(status) bind(c, name='mgdt_mesh_create')
            import :: c_int32_t, c_ptr
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        function c_mesh_create_with_allocator(alloc, release, user, out) result(status) &
            bind(c, name='mgdt_mesh_create_with_allocator')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_funptr), value :: alloc
            type(c_funptr), value :: release
            type(c_ptr), value :: user
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        subroutine c_mesh_destroy(m) bind(c, name='mgdt_mesh_destroy')
            import :: c_ptr
            type(c_ptr), value :: m
        end subroutine
        function c_mesh_set_option(m, option, value) result(status) &
            bind(c, name='mgdt_mesh_set_option')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: option
            integer(c_int64_t), value :: value
            integer(c_int32_t) :: status
        end function
        function c_mesh_get_option(m, option, value) result(status) &
            bind(c, name='mgdt_mesh_get_option')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: option
            integer(c_int64_t), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_mesh_set_double_option(m, option, value) result(status) &
            bind(c, name='mgdt_mesh_set_double_option')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: option
            real(c_double), value :: value
            integer(c_int32_t) :: status
        end function
        function c_mesh_get_double_option(m, option, value) result(status) &
            bind(c, name='mgdt_mesh_get_double_option')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: option
            real(c_double), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_mesh_set_progress(m, fn, user) result(status) &
            bind(c, name='mgdt_mesh_set_progress')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: m
            type(c_funptr), value :: fn
            type(c_ptr), value :: user
            integer(c_int32_t) :: status
        end function
        function c_mesh_get_progress(m, fn, user) result(status) &
            bind(c, name='mgdt_mesh_get_progress')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: m
            type(c_funptr), intent(out) :: fn
            type(c_ptr), intent(out) :: user
            integer(c_int32_t) :: status
        end function
        function c_mesh_cancel(m) result(status) bind(c, name='mgdt_mesh_cancel')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t) :: status
        end function
        function c_mesh_set_points(m, n, xyz) result(status) bind(c, name='mgdt_mesh_set_points')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int32_t) :: status
        end function
        function c_mesh_set_sizes(m, of, n, sizes) result(status) &
            bind(c, name='mgdt_mesh_set_sizes')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: of
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: sizes(*)
            integer(c_int32_t) :: status
        end function
        function c_mesh_set_size_field(m, n, xyz, sizes) result(status) &
            bind(c, name='mgdt_mesh_set_size_field')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            real(c_double), intent(in) :: sizes(*)
            integer(c_int32_t) :: status
        end function
        function c_mesh_set_size_function(m, fn, user) result(status) &
            bind(c, name='mgdt_mesh_set_size_function')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: m
            type(c_funptr), value :: fn
            type(c_ptr), value :: user
            integer(c_int32_t) :: status
        end function
        function c_mesh_get_size_function(m, fn, user) result(status) &
            bind(c, name='mgdt_mesh_get_size_function')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: m
            type(c_funptr), intent(out) :: fn
            type(c_ptr), intent(out) :: user
            integer(c_int32_t) :: status
        end function
        function c_mesh_build(m) result(status) bind(c, name='mgdt_mesh_build')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t) :: status
        end function
        function c_mesh_refine(m) result(status) bind(c, name='mgdt_mesh_refine')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t) :: status
        end function
        function c_mesh_improve(m) result(status) bind(c, name='mgdt_mesh_improve')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t) :: status
        end function
        function c_mesh_get_stat(m, key, value) result(status) bind(c, name='mgdt_mesh_get_stat')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: key
            integer(c_int64_t), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_mesh_array_info(array, columns, is_double) result(status) &
            bind(c, name='mgdt_mesh_array_info')
            import :: c_int32_t
            integer(c_int32_t), value :: array
            integer(c_int32_t), intent(inout) :: columns
            integer(c_int32_t), intent(inout) :: is_double
            integer(c_int32_t) :: status
        end function
        function c_mesh_get_size(m, array, size) result(status) bind(c, name='mgdt_mesh_get_size')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: array
            integer(c_int64_t), intent(inout) :: size
            integer(c_int32_t) :: status
        end function
        function c_mesh_get_doubles(m, array, capacity, values) result(status) &
            bind(c, name='mgdt_mesh_get_doubles')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            real(c_double), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
        function c_mesh_get_tetrahedron_measures(m, measure, capacity, x) result(status) &
            bind(c, name='mgdt_mesh_get_tetrahedron_measures')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: measure
            integer(c_int64_t), value :: capacity
            real(c_double), intent(inout) :: x(*)
            integer(c_int32_t) :: status
        end function
        function c_mesh_get_shape_summary(m, shapes, angles, tetrahedra_below) result(status) &
            bind(c, name='mgdt_mesh_get_shape_summary')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: m
            type(c_ptr), value :: shapes
            type(c_ptr), value :: angles
            type(c_ptr), value :: tetrahedra_below
            integer(c_int32_t) :: status
        end function
        function c_mesh_interpolate(m, outside, n_fields, values, n, xyz, out) result(status) &
            bind(c, name='mgdt_mesh_interpolate')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: outside
            integer(c_int64_t), value :: n_fields
            real(c_double), intent(in) :: values(*)
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            real(c_double), intent(inout) :: out(*)
            integer(c_int32_t) :: status
        end function
        function c_mesh_check(m) result(status) bind(c, name='mgdt_mesh_check')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t) :: status
        end function
        function c_mesh_get_error(m, capacity, buffer) result(status) &
            bind(c, name='mgdt_mesh_get_error')
            import :: c_char, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: capacity
            character(kind=c_char), intent(inout) :: buffer(*)
            integer(c_int32_t) :: status
        end function
        function c_domain_create(out) result(status) bind(c, name='mgdt_domain_create')
            import :: c_int32_t, c_ptr
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        function c_domain_create_with_allocator(alloc, release, user, out) result(status) &
            bind(c, name='mgdt_domain_create_with_allocator')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_funptr), value :: alloc
            type(c_funptr), value :: release
            type(c_ptr), value :: user
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        subroutine c_domain_destroy(d) bind(c, name='mgdt_domain_destroy')
            import :: c_ptr
            type(c_ptr), value :: d
        end subroutine
        function c_domain_clear(d) result(status) bind(c, name='mgdt_domain_clear')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t) :: status
        end function
        function c_domain_set_option(d, option, value) result(status) &
            bind(c, name='mgdt_domain_set_option')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t), value :: option
            integer(c_int64_t), value :: value
            integer(c_int32_t) :: status
        end function
        function c_domain_get_option(d, option, value) result(status) &
            bind(c, name='mgdt_domain_get_option')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t), value :: option
            integer(c_int64_t), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_domain_set_double_option(d, option, value) result(status) &
            bind(c, name='mgdt_domain_set_double_option')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t), value :: option
            real(c_double), value :: value
            integer(c_int32_t) :: status
        end function
        function c_domain_get_double_option(d, option, value) result(status) &
            bind(c, name='mgdt_domain_get_double_option')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t), value :: option
            real(c_double), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_domain_set_progress(d, fn, user) result(status) &
            bind(c, name='mgdt_domain_set_progress')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: d
            type(c_funptr), value :: fn
            type(c_ptr), value :: user
            integer(c_int32_t) :: status
        end function
        function c_domain_get_progress(d, fn, user) result(status) &
            bind(c, name='mgdt_domain_get_progress')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: d
            type(c_funptr), intent(out) :: fn
            type(c_ptr), intent(out) :: user
            integer(c_int32_t) :: status
        end function
        function c_domain_cancel(d) result(status) bind(c, name='mgdt_domain_cancel')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t) :: status
        end function
        function c_domain_set_points(d, n, xyz) result(status) &
            bind(c, name='mgdt_domain_set_points')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int32_t) :: status
        end function
        function c_domain_set_regions(d, n, xyz, markers) result(status) &
            bind(c, name='mgdt_domain_set_regions')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            type(c_ptr), value :: markers
            integer(c_int32_t) :: status
        end function
        function c_domain_set_holes(d, n, xyz) result(status) bind(c, name='mgdt_domain_set_holes')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int32_t) :: status
        end function
        function c_domain_clean(d) result(status) bind(c, name='mgdt_domain_clean')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t) :: status
        end function
        function c_domain_validate(d) result(status) bind(c, name='mgdt_domain_validate')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t) :: status
        end function
        function c_domain_build(d, out) result(status) bind(c, name='mgdt_domain_build')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: d
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        function c_domain_check(d, mesh) result(status) bind(c, name='mgdt_domain_check')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: d
            type(c_ptr), value :: mesh
            integer(c_int32_t) :: status
        end function
        function c_domain_get_stat(d, key, value) result(status) &
            bind(c, name='mgdt_domain_get_stat')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t), value :: key
            integer(c_int64_t), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_domain_array_info(array, columns, is_double) result(status) &
            bind(c, name='mgdt_domain_array_info')
            import :: c_int32_t
            integer(c_int32_t), value :: array
            integer(c_int32_t), intent(inout) :: columns
            integer(c_int32_t), intent(inout) :: is_double
            integer(c_int32_t) :: status
        end function
        function c_domain_get_size(d, array, size) result(status) &
            bind(c, name='mgdt_domain_get_size')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t), value :: array
            integer(c_int64_t), intent(inout) :: size
            integer(c_int32_t) :: status
        end function
        function c_domain_get_doubles(d, array, capacity, values) result(status) &
            bind(c, name='mgdt_domain_get_doubles')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            real(c_double), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
        function c_domain_get_error(d, capacity, buffer) result(status) &
            bind(c, name='mgdt_domain_get_error')
            import :: c_char, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int64_t), value :: capacity
            character(kind=c_char), intent(inout) :: buffer(*)
            integer(c_int32_t) :: status
        end function
        function c_periodic_create(out) result(status) bind(c, name='mgdt_periodic_create')
            import :: c_int32_t, c_ptr
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        function c_periodic_create_with_allocator(alloc, release, user, out) result(status) &
            bind(c, name='mgdt_periodic_create_with_allocator')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_funptr), value :: alloc
            type(c_funptr), value :: release
            type(c_ptr), value :: user
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        subroutine c_periodic_destroy(p) bind(c, name='mgdt_periodic_destroy')
            import :: c_ptr
            type(c_ptr), value :: p
        end subroutine
        function c_periodic_clear(p) result(status) bind(c, name='mgdt_periodic_clear')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t) :: status
        end function
        function c_periodic_set_vectors(p, dimensions, vectors) result(status) &
            bind(c, name='mgdt_periodic_set_vectors')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: dimensions
            real(c_double), intent(in) :: vectors(*)
            integer(c_int32_t) :: status
        end function
        function c_periodic_set_option(p, option, value) result(status) &
            bind(c, name='mgdt_periodic_set_option')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: option
            integer(c_int64_t), value :: value
            integer(c_int32_t) :: status
        end function
        function c_periodic_get_option(p, option, value) result(status) &
            bind(c, name='mgdt_periodic_get_option')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: option
            integer(c_int64_t), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_periodic_set_merge_distance(p, distance) result(status) &
            bind(c, name='mgdt_periodic_set_merge_distance')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: p
            real(c_double), value :: distance
            integer(c_int32_t) :: status
        end function
        function c_periodic_get_merge_distance(p, distance) result(status) &
            bind(c, name='mgdt_periodic_get_merge_distance')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: p
            real(c_double), intent(inout) :: distance
            integer(c_int32_t) :: status
        end function
        function c_periodic_set_progress(p, fn, user) result(status) &
            bind(c, name='mgdt_periodic_set_progress')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: p
            type(c_funptr), value :: fn
            type(c_ptr), value :: user
            integer(c_int32_t) :: status
        end function
        function c_periodic_get_progress(p, fn, user) result(status) &
            bind(c, name='mgdt_periodic_get_progress')
            import :: c_funptr, c_int32_t, c_ptr
            type(c_ptr), value :: p
            type(c_funptr), intent(out) :: fn
            type(c_ptr), intent(out) :: user
            integer(c_int32_t) :: status
        end function
        function c_periodic_cancel(p) result(status) bind(c, name='mgdt_periodic_cancel')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t) :: status
        end function
        function c_periodic_insert_points(p, n, xyz) result(status) &
            bind(c, name='mgdt_periodic_insert_points')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int32_t) :: status
        end function
        function c_periodic_move_points_i32(p, n, points, xyz) result(status) &
            bind(c, name='mgdt_periodic_move_points_i32')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int64_t), value :: n
            type(c_ptr), value :: points
            real(c_double), intent(in) :: xyz(*)
            integer(c_int32_t) :: status
        end function
        function c_periodic_move_points_i64(p, n, points, xyz) result(status) &
            bind(c, name='mgdt_periodic_move_points')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int64_t), value :: n
            type(c_ptr), value :: points
            real(c_double), intent(in) :: xyz(*)
            integer(c_int32_t) :: status
        end function
        function c_periodic_build(p) result(status) bind(c, name='mgdt_periodic_build')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t) :: status
        end function
        function c_periodic_check(p) result(status) bind(c, name='mgdt_periodic_check')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t) :: status
        end function
        function c_periodic_get_stat(p, key, value) result(status) &
            bind(c, name='mgdt_periodic_get_stat')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: key
            integer(c_int64_t), intent(inout) :: value
            integer(c_int32_t) :: status
        end function
        function c_periodic_array_info(array, columns, is_double) result(status) &
            bind(c, name='mgdt_periodic_array_info')
            import :: c_int32_t
            integer(c_int32_t), value :: array
            integer(c_int32_t), intent(inout) :: columns
            integer(c_int32_t), intent(inout) :: is_double
            integer(c_int32_t) :: status
        end function
        function c_periodic_get_size(p, array, size) result(status) &
            bind(c, name='mgdt_periodic_get_size')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: array
            integer(c_int64_t), intent(inout) :: size
            integer(c_int32_t) :: status
        end function
        function c_periodic_get_doubles(p, array, capacity, values) result(status) &
            bind(c, name='mgdt_periodic_get_doubles')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            real(c_double), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
        function c_periodic_get_cell_measures(p, measure, capacity, x) result(status) &
            bind(c, name='mgdt_periodic_get_cell_measures')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: measure
            integer(c_int64_t), value :: capacity
            real(c_double), intent(inout) :: x(*)
            integer(c_int32_t) :: status
        end function
        function c_periodic_create_voronoi(p, out) result(status) &
            bind(c, name='mgdt_periodic_create_voronoi')
            import :: c_int32_t, c_ptr
            type(c_ptr), value :: p
            type(c_ptr), intent(out) :: out
            integer(c_int32_t) :: status
        end function
        function c_periodic_get_error(p, capacity, buffer) result(status) &
            bind(c, name='mgdt_periodic_get_error')
            import :: c_char, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int64_t), value :: capacity
            character(kind=c_char), intent(inout) :: buffer(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_remove_points
        function c_remove_points_i32(t, n, points) result(status) &
            bind(c, name='mgdt_remove_points_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n
            integer(c_int32_t), intent(in) :: points(*)
            integer(c_int32_t) :: status
        end function
        function c_remove_points_i64(t, n, points) result(status) bind(c, name='mgdt_remove_points')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n
            integer(c_int64_t), intent(in) :: points(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_renumber_points
        function c_renumber_points_i32(t, capacity, new_index) result(status) &
            bind(c, name='mgdt_renumber_points_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: new_index(*)
            integer(c_int32_t) :: status
        end function
        function c_renumber_points_i64(t, capacity, new_index) result(status) &
            bind(c, name='mgdt_renumber_points')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: new_index(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_get_tetrahedra
        function c_get_tetrahedra_i32(t, capacity, v) result(status) &
            bind(c, name='mgdt_get_tetrahedra_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: v(*)
            integer(c_int32_t) :: status
        end function
        function c_get_tetrahedra_i64(t, capacity, v) result(status) &
            bind(c, name='mgdt_get_tetrahedra')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: v(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_get_neighbors
        function c_get_neighbors_i32(t, capacity, v) result(status) &
            bind(c, name='mgdt_get_neighbors_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: v(*)
            integer(c_int32_t) :: status
        end function
        function c_get_neighbors_i64(t, capacity, v) result(status) &
            bind(c, name='mgdt_get_neighbors')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: v(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_get_hull_facets
        function c_get_hull_facets_i32(t, capacity, v) result(status) &
            bind(c, name='mgdt_get_hull_facets_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: v(*)
            integer(c_int32_t) :: status
        end function
        function c_get_hull_facets_i64(t, capacity, v) result(status) &
            bind(c, name='mgdt_get_hull_facets')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: v(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_get_edges
        function c_get_edges_i32(t, capacity, v) result(status) bind(c, name='mgdt_get_edges_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: v(*)
            integer(c_int32_t) :: status
        end function
        function c_get_edges_i64(t, capacity, v) result(status) bind(c, name='mgdt_get_edges')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: v(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_get_point_map
        function c_get_point_map_i32(t, capacity, v) result(status) &
            bind(c, name='mgdt_get_point_map_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: v(*)
            integer(c_int32_t) :: status
        end function
        function c_get_point_map_i64(t, capacity, v) result(status) &
            bind(c, name='mgdt_get_point_map')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: v(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_get_vertex_tetrahedra
        function c_get_vertex_tetrahedra_i32(t, offset_capacity, offsets, capacity, list) &
            result(status) &
            bind(c, name='mgdt_get_vertex_tetrahedra_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: offset_capacity
            integer(c_int32_t), intent(inout) :: offsets(*)
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: list(*)
            integer(c_int32_t) :: status
        end function
        function c_get_vertex_tetrahedra_i64(t, offset_capacity, offsets, capacity, list) &
            result(status) &
            bind(c, name='mgdt_get_vertex_tetrahedra')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: offset_capacity
            integer(c_int64_t), intent(inout) :: offsets(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: list(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_get_vertex_neighbors
        function c_get_vertex_neighbors_i32(t, offset_capacity, offsets, capacity, list) &
            result(status) &
            bind(c, name='mgdt_get_vertex_neighbors_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: offset_capacity
            integer(c_int32_t), intent(inout) :: offsets(*)
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: list(*)
            integer(c_int32_t) :: status
        end function
        function c_get_vertex_neighbors_i64(t, offset_capacity, offsets, capacity, list) &
            result(status) &
            bind(c, name='mgdt_get_vertex_neighbors')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: offset_capacity
            integer(c_int64_t), intent(inout) :: offsets(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: list(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_get_gabriel_edges
        function c_get_gabriel_edges_i32(t, capacity, v, count) result(status) &
            bind(c, name='mgdt_get_gabriel_edges_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: v(*)
            integer(c_int32_t), intent(inout) :: count
            integer(c_int32_t) :: status
        end function
        function c_get_gabriel_edges_i64(t, capacity, v, count) result(status) &
            bind(c, name='mgdt_get_gabriel_edges')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: v(*)
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_get_spanning_tree
        function c_get_spanning_tree_i32(t, capacity, v, count) result(status) &
            bind(c, name='mgdt_get_spanning_tree_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: v(*)
            integer(c_int32_t), intent(inout) :: count
            integer(c_int32_t) :: status
        end function
        function c_get_spanning_tree_i64(t, capacity, v, count) result(status) &
            bind(c, name='mgdt_get_spanning_tree')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: v(*)
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_get_alpha_surface
        function c_get_alpha_surface_i32(t, alpha2, capacity, v, count) result(status) &
            bind(c, name='mgdt_get_alpha_surface_i32')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            real(c_double), value :: alpha2
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: v(*)
            integer(c_int32_t), intent(inout) :: count
            integer(c_int32_t) :: status
        end function
        function c_get_alpha_surface_i64(t, alpha2, capacity, v, count) result(status) &
            bind(c, name='mgdt_get_alpha_surface')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            real(c_double), value :: alpha2
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: v(*)
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_locate
        function c_locate_i32(t, xyz, tetrahedron) result(status) bind(c, name='mgdt_locate_i32')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: t
            real(c_double), intent(in) :: xyz(3)
            integer(c_int32_t), intent(inout) :: tetrahedron
            integer(c_int32_t) :: status
        end function
        function c_locate_i64(t, xyz, tetrahedron) result(status) bind(c, name='mgdt_locate')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            real(c_double), intent(in) :: xyz(3)
            integer(c_int64_t), intent(inout) :: tetrahedron
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_locate_points
        function c_locate_points_i32(t, n, xyz, tetrahedra, weights) result(status) &
            bind(c, name='mgdt_locate_points_i32')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int32_t), intent(inout) :: tetrahedra(*)
            type(c_ptr), value :: weights
            integer(c_int32_t) :: status
        end function
        function c_locate_points_i64(t, n, xyz, tetrahedra, weights) result(status) &
            bind(c, name='mgdt_locate_points')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int64_t), intent(inout) :: tetrahedra(*)
            type(c_ptr), value :: weights
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_traverse_segment
        function c_traverse_segment_i32(t, a, b, capacity, tetrahedra, parameters, count) &
            result(status) &
            bind(c, name='mgdt_traverse_segment_i32')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            real(c_double), intent(in) :: a(3)
            real(c_double), intent(in) :: b(3)
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: tetrahedra(*)
            type(c_ptr), value :: parameters
            integer(c_int32_t), intent(inout) :: count
            integer(c_int32_t) :: status
        end function
        function c_traverse_segment_i64(t, a, b, capacity, tetrahedra, parameters, count) &
            result(status) &
            bind(c, name='mgdt_traverse_segment')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            real(c_double), intent(in) :: a(3)
            real(c_double), intent(in) :: b(3)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: tetrahedra(*)
            type(c_ptr), value :: parameters
            integer(c_int64_t), intent(inout) :: count
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_nearest_vertex
        function c_nearest_vertex_i32(t, xyz, vertex) result(status) &
            bind(c, name='mgdt_nearest_vertex_i32')
            import :: c_double, c_int32_t, c_ptr
            type(c_ptr), value :: t
            real(c_double), intent(in) :: xyz(3)
            integer(c_int32_t), intent(inout) :: vertex
            integer(c_int32_t) :: status
        end function
        function c_nearest_vertex_i64(t, xyz, vertex) result(status) &
            bind(c, name='mgdt_nearest_vertex')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            real(c_double), intent(in) :: xyz(3)
            integer(c_int64_t), intent(inout) :: vertex
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_nearest_vertices
        function c_nearest_vertices_i32(t, n, xyz, vertices) result(status) &
            bind(c, name='mgdt_nearest_vertices_i32')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int32_t), intent(inout) :: vertices(*)
            integer(c_int32_t) :: status
        end function
        function c_nearest_vertices_i64(t, n, xyz, vertices) result(status) &
            bind(c, name='mgdt_nearest_vertices')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int64_t), intent(inout) :: vertices(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_get_interpolation_weights
        function c_get_interpolation_weights_i32(t, method, outside, n, xyz, offset_capacity, &
            offsets, capacity, points, weights) result(status) &
            bind(c, name='mgdt_get_interpolation_weights_i32')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: method
            integer(c_int32_t), value :: outside
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int64_t), value :: offset_capacity
            integer(c_int32_t), intent(inout) :: offsets(*)
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: points(*)
            real(c_double), intent(inout) :: weights(*)
            integer(c_int32_t) :: status
        end function
        function c_get_interpolation_weights_i64(t, method, outside, n, xyz, offset_capacity, &
            offsets, capacity, points, weights) result(status) &
            bind(c, name='mgdt_get_interpolation_weights')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: t
            integer(c_int32_t), value :: method
            integer(c_int32_t), value :: outside
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int64_t), value :: offset_capacity
            integer(c_int64_t), intent(inout) :: offsets(*)
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: points(*)
            real(c_double), intent(inout) :: weights(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_voronoi_get_array
        function c_voronoi_get_array_i32(v, array, capacity, values) result(status) &
            bind(c, name='mgdt_voronoi_get_array_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: v
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
        function c_voronoi_get_array_i64(v, array, capacity, values) result(status) &
            bind(c, name='mgdt_voronoi_get_array')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: v
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_mesh_set_tetrahedra
        function c_mesh_set_tetrahedra_i32(m, n, corners, markers) result(status) &
            bind(c, name='mgdt_mesh_set_tetrahedra_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: n
            integer(c_int32_t), intent(in) :: corners(*)
            type(c_ptr), value :: markers
            integer(c_int32_t) :: status
        end function
        function c_mesh_set_tetrahedra_i64(m, n, corners, markers) result(status) &
            bind(c, name='mgdt_mesh_set_tetrahedra')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: n
            integer(c_int64_t), intent(in) :: corners(*)
            type(c_ptr), value :: markers
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_mesh_set_faces
        function c_mesh_set_faces_i32(m, n, corners, markers) result(status) &
            bind(c, name='mgdt_mesh_set_faces_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: n
            integer(c_int32_t), intent(in) :: corners(*)
            type(c_ptr), value :: markers
            integer(c_int32_t) :: status
        end function
        function c_mesh_set_faces_i64(m, n, corners, markers) result(status) &
            bind(c, name='mgdt_mesh_set_faces')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: n
            integer(c_int64_t), intent(in) :: corners(*)
            type(c_ptr), value :: markers
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_mesh_set_edges
        function c_mesh_set_edges_i32(m, n, ends, markers) result(status) &
            bind(c, name='mgdt_mesh_set_edges_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: n
            integer(c_int32_t), intent(in) :: ends(*)
            type(c_ptr), value :: markers
            integer(c_int32_t) :: status
        end function
        function c_mesh_set_edges_i64(m, n, ends, markers) result(status) &
            bind(c, name='mgdt_mesh_set_edges')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: n
            integer(c_int64_t), intent(in) :: ends(*)
            type(c_ptr), value :: markers
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_mesh_set_fixed_points
        function c_mesh_set_fixed_points_i32(m, n, points) result(status) &
            bind(c, name='mgdt_mesh_set_fixed_points_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: n
            integer(c_int32_t), intent(in) :: points(*)
            integer(c_int32_t) :: status
        end function
        function c_mesh_set_fixed_points_i64(m, n, points) result(status) &
            bind(c, name='mgdt_mesh_set_fixed_points')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int64_t), value :: n
            integer(c_int64_t), intent(in) :: points(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_mesh_get_array
        function c_mesh_get_array_i32(m, array, capacity, values) result(status) &
            bind(c, name='mgdt_mesh_get_array_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
        function c_mesh_get_array_i64(m, array, capacity, values) result(status) &
            bind(c, name='mgdt_mesh_get_array')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_mesh_locate_points
        function c_mesh_locate_points_i32(m, outside, n, xyz, tetrahedra, weights) &
            result(status) &
            bind(c, name='mgdt_mesh_locate_points_i32')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: outside
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int32_t), intent(inout) :: tetrahedra(*)
            type(c_ptr), value :: weights
            integer(c_int32_t) :: status
        end function
        function c_mesh_locate_points_i64(m, outside, n, xyz, tetrahedra, weights) &
            result(status) &
            bind(c, name='mgdt_mesh_locate_points')
            import :: c_double, c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: m
            integer(c_int32_t), value :: outside
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: xyz(*)
            integer(c_int64_t), intent(inout) :: tetrahedra(*)
            type(c_ptr), value :: weights
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_domain_set_facets
        function c_domain_set_facets_i32(d, n, offsets, corners, markers) result(status) &
            bind(c, name='mgdt_domain_set_facets_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int64_t), value :: n
            type(c_ptr), value :: offsets
            integer(c_int32_t), intent(in) :: corners(*)
            type(c_ptr), value :: markers
            integer(c_int32_t) :: status
        end function
        function c_domain_set_facets_i64(d, n, offsets, corners, markers) result(status) &
            bind(c, name='mgdt_domain_set_facets')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int64_t), value :: n
            type(c_ptr), value :: offsets
            integer(c_int64_t), intent(in) :: corners(*)
            type(c_ptr), value :: markers
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_domain_set_segments
        function c_domain_set_segments_i32(d, n, ends, markers) result(status) &
            bind(c, name='mgdt_domain_set_segments_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int64_t), value :: n
            integer(c_int32_t), intent(in) :: ends(*)
            type(c_ptr), value :: markers
            integer(c_int32_t) :: status
        end function
        function c_domain_set_segments_i64(d, n, ends, markers) result(status) &
            bind(c, name='mgdt_domain_set_segments')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int64_t), value :: n
            integer(c_int64_t), intent(in) :: ends(*)
            type(c_ptr), value :: markers
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_domain_get_array
        function c_domain_get_array_i32(d, array, capacity, values) result(status) &
            bind(c, name='mgdt_domain_get_array_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
        function c_domain_get_array_i64(d, array, capacity, values) result(status) &
            bind(c, name='mgdt_domain_get_array')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: d
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
    end interface

    interface c_periodic_get_array
        function c_periodic_get_array_i32(p, array, capacity, values) result(status) &
            bind(c, name='mgdt_periodic_get_array_i32')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            integer(c_int32_t), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
        function c_periodic_get_array_i64(p, array, capacity, values) result(status) &
            bind(c, name='mgdt_periodic_get_array')
            import :: c_int32_t, c_int64_t, c_ptr
            type(c_ptr), value :: p
            integer(c_int32_t), value :: array
            integer(c_int64_t), value :: capacity
            integer(c_int64_t), intent(inout) :: values(*)
            integer(c_int32_t) :: status
        end function
    end interface
end module mgdt_c
