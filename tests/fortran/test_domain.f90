! SPDX-License-Identifier: MIT
! Modules mgdt_domain and mgdt_mesh: two cubes of different materials that share a square, one of them with a hole,
! a polyhedron that has no tetrahedra without further points, and what is refused.
program test_domain
    use mgdt
    use mgdt_domain
    use mgdt_mesh
    use, intrinsic :: iso_c_binding, only: c_associated
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use checks
    implicit none

    real(real64), parameter :: tower(3, 12) = reshape([real(real64) :: &
        0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 0, 0, 2, 2, 0, 2, 2, 2, 2, 0, 2, 2, &
        0, 0, 4, 2, 0, 4, 2, 2, 4, 0, 2, 4], [3, 12])
    ! The bottom, four sides, the square between the cubes, four sides, the top.
    integer, parameter :: squares(4, 11) = reshape([ &
        1, 4, 3, 2, 1, 2, 6, 5, 2, 3, 7, 6, 3, 4, 8, 7, 4, 1, 5, 8, 5, 6, 7, 8, &
        5, 6, 10, 9, 6, 7, 11, 10, 7, 8, 12, 11, 8, 5, 9, 12, 9, 10, 11, 12], [4, 11])
    integer :: heard = 0, asked = 0

    call two_cubes()
    call a_hole()
    call further_points()
    call improved_mesh()
    call what_is_refused()
    call conclude()

contains

    subroutine two_cubes()
        type(mgdt_domain_input) :: domain, again
        type(mgdt_tetrahedral_mesh) :: mesh, other
        integer :: markers(11), first(12), i, stat
        character(200) :: message
        integer, allocatable :: tets(:, :), regions(:), region_markers(:), faces(:, :)
        integer, allocatable :: face_markers(:), sides(:, :), neighbors(:, :)
        integer(int64), allocatable :: long(:, :), flat(:)
        integer(int32), allocatable :: short(:), sources(:)
        integer(int64) :: first_long(12), squares_long(44)
        real(real64), allocatable :: points(:, :), coordinates(:)
        real(real64) :: volume(9)

        markers = [(i, i=1, 11)]
        call expect(.not. c_associated(domain%c_handle()), 'nothing is made yet')
        call domain%set_points(tower)
        call expect(c_associated(domain%c_handle()), 'made')
        call domain%set_facets(squares, markers)
        call domain%set_segments(reshape([1, 2, 9, 10], [2, 2]), [5, 6])
        call domain%set_regions(reshape([real(real64) :: 1, 1, 1, 1, 1, 3], [3, 2]), [7, 9])
        call domain%set_option(mgdt_domain_option_weld, 1e-9_real64)
        call expect(abs(domain%get_double_option(mgdt_domain_option_weld)*1e9_real64 - 1) < 1e-12_real64, &
                    'a double')
        call domain%clean()
        call expect(domain%statistic(mgdt_domain_stat_moved_points) == 0, 'nothing is welded')
        call domain%get(mgdt_domain_array_facet_origins, short)
        call expect(all(short == [(i, i=1, 11)]), 'facets stay')
        call domain%get(mgdt_domain_array_points, points)
        call expect(maxval(abs(points - tower)) <= 0, 'points stay')
        call domain%validate()
        call expect(domain%array_size(mgdt_domain_array_offending_pairs) == 0, 'valid')
        call domain%set_progress(hear)
        call domain%build(mesh)
        call domain%remove_progress()
        call expect(heard > 0, 'progress')
        call mesh%check()
        call domain%check(mesh)

        ! Volumes of the regions, and the numbers of everything, from 1.
        call mesh%get(mgdt_mesh_array_points, points)
        call expect(size(points, 1) == 3 .and. size(points, 2) == 12, 'points')
        call expect(all(abs(points - tower) <= 0), 'coordinates as given')
        call mesh%get(mgdt_mesh_array_tetrahedra, tets)
        call mesh%get(mgdt_mesh_array_tetrahedron_regions, regions)
        call mesh%get(mgdt_mesh_array_region_markers, region_markers)
        call expect(mesh%statistic(mgdt_mesh_stat_tetrahedra) == size(tets, 2), 'number of tetrahedra')
        call expect(mesh%statistic(mgdt_mesh_stat_regions) == 2 .and. size(region_markers) == 2, 'two regions')
        call expect(minval(tets) == 1 .and. maxval(tets) == 12 .and. minval(regions) == 1, 'from 1')
        volume = 0
        do i = 1, size(tets, 2)
            associate (v => volume(region_markers(regions(i))))
                v = v + volume6(points(:, tets(1, i)), points(:, tets(2, i)), &
                                points(:, tets(3, i)), points(:, tets(4, i)))/6
            end associate
        end do
        call expect(abs(volume(7) - 8) < 1e-12_real64 .and. abs(volume(9) - 8) < 1e-12_real64, 'volumes')
        call expect(abs(sum(volume) - 16) < 1e-12_real64, 'both')
        call mesh%get(mgdt_mesh_array_neighbors, neighbors)
        call expect(all(shape(neighbors) == shape(tets)) .and. minval(neighbors) == 0, 'neighbours')

        ! Each square is two faces; those between the cubes have a tetrahedron on both sides.
        call mesh%get(mgdt_mesh_array_faces, faces)
        call mesh%get(mgdt_mesh_array_face_markers, face_markers)
        call mesh%get(mgdt_mesh_array_face_tetrahedra, sides)
        call expect(size(faces, 1) == 3 .and. size(faces, 2) == 22, 'faces')
        call expect(all([(count(face_markers == i) == 2, i=1, 11)]), 'two faces for each square')
        do i = 1, size(faces, 2)
            call expect((minval(sides(:, i)) == 0) .neqv. face_markers(i) == 6, 'sides of a face')
        end do
        call mesh%get(mgdt_mesh_array_face_facets, short)
        call expect(all(short == face_markers), 'facets of faces')
        call mesh%get(mgdt_mesh_array_edge_segments, sources)
        call mesh%get(mgdt_mesh_array_edge_markers, short)
        call expect(size(sources) == 20 .and. sum(sources) == 3 .and. sum(short) == 11, 'segments')

        ! The shapes of arrays, measures, and options of a mesh.
        call expect(mesh%columns(mgdt_mesh_array_face_tetrahedra) == 2, 'columns')
        call expect(domain%columns(mgdt_domain_array_open_edges) == 3, 'columns of a domain')
        call expect(mesh%columns(999) == 0, 'no such array')
        allocate (coordinates(size(tets, 2)))
        call mesh%get_tetrahedron_measures(mgdt_tetrahedron_volume, coordinates)
        call expect(abs(sum(coordinates) - 16) < 1e-12_real64, 'sum of volumes')
        deallocate (coordinates)
        call mesh%set_option(mgdt_mesh_option_index_base, 0)
        call expect(mesh%get_option(mgdt_mesh_option_index_base) == 0, 'index base of the mesh')
        call mesh%get(mgdt_mesh_array_tetrahedra, long)
        call expect(all(long == tets - 1), 'from 0')
        call mesh%set_option(mgdt_mesh_option_index_base, 1_int64)
        call mesh%get(mgdt_mesh_array_point_origins, short)
        call expect(all(short == [(i, i=1, 12)]), 'origins')
        call mesh%set_progress(hear)
        call mesh%check()
        call mesh%remove_progress()
        call mesh%cancel()
        call mesh%check(stat, message)

        ! Other kinds and ranks.
        call mesh%get(mgdt_mesh_array_tetrahedra, long)
        call mesh%get(mgdt_mesh_array_tetrahedra, flat)
        call expect(all(long == tets) .and. all(flat == reshape(tets, [size(tets)])), '64 bits, flat')
        call mesh%get(mgdt_mesh_array_points, coordinates)
        call expect(all(abs(coordinates - reshape(tower, [36])) <= 0), 'points, flat')

        ! The same as lists of corners, from 0, in both kinds of integers.
        call again%set_option(mgdt_domain_option_index_base, 0)
        call expect(again%get_option(mgdt_domain_option_index_base) == 0, 'index base')
        call again%set_points(reshape(tower, [36]))
        first = [(4*i, i=0, 11)]
        call again%set_facets(first, reshape(squares - 1, [44]), markers)
        call again%build(other)
        call other%get(mgdt_mesh_array_tetrahedra, long)
        call expect(all(long == tets - 1), 'polygons')
        first_long = first + 1
        squares_long = reshape(squares, [44])
        call again%set_option(mgdt_domain_option_index_base, 1_int64)
        call again%set_facets(first_long, squares_long)
        call again%build(other)
        call other%get(mgdt_mesh_array_tetrahedra, long)
        call expect(all(long == tets), 'polygons of 64 bits')
        call other%get(mgdt_mesh_array_face_markers, short)
        call expect(all(short == 0), 'no markers')
        call again%set_facets(int(squares, int64), markers)
        call again%set_segments(reshape([1_int64, 2_int64], [2, 1]))
        call again%build(other)
        call other%get(mgdt_mesh_array_face_markers, short)
        call expect(sum(short) == sum(face_markers), 'markers')
        call again%clear()
        call expect(again%statistic(mgdt_domain_stat_points) == 0, 'cleared')
        call again%build(other, stat, message)
        call expect_error(stat, mgdt_err_open_boundary, message, 'no facets')
        ! The mesh stays as it was.
        call expect(other%statistic(mgdt_mesh_stat_tetrahedra) == size(tets, 2), 'a mesh of its own')
        call expect_error_of_check(again, other)
        call again%destroy()
        call expect(.not. c_associated(again%c_handle()), 'destroyed')
    end subroutine

    ! A domain without points is not that of the mesh.
    subroutine expect_error_of_check(domain, mesh)
        type(mgdt_domain_input), intent(in) :: domain
        type(mgdt_tetrahedral_mesh), intent(in) :: mesh
        character(200) :: message
        integer :: stat

        call domain%check(mesh, stat, message)
        call expect_error(stat, mgdt_err_check_failed, message, 'points')
        call mesh%check()
    end subroutine

    subroutine hear(fraction, cancel)
        real(real64), intent(in) :: fraction
        logical, intent(inout) :: cancel

        heard = heard + 1
        cancel = cancel .or. fraction > 1
    end subroutine

    ! Asks to stop if `asked` is negative.
    subroutine find_sizes(xyz, sizes, cancel)
        real(real64), intent(in) :: xyz(:, :)
        real(real64), intent(inout) :: sizes(:)
        logical, intent(inout) :: cancel

        call expect(size(xyz, 1) == 3 .and. size(xyz, 2) == size(sizes), 'places of sizes')
        call expect(all(abs(sizes) <= 0), 'sizes are 0 at first')
        cancel = asked < 0
        asked = asked + size(sizes)
        sizes = 0.5_real64 + 0.1_real64*xyz(3, :)
    end subroutine

    subroutine stop_it(fraction, cancel)
        real(real64), intent(in) :: fraction
        logical, intent(inout) :: cancel

        cancel = fraction >= 0
    end subroutine

    subroutine a_hole()
        type(mgdt_domain_input) :: domain
        type(mgdt_tetrahedral_mesh) :: mesh
        integer, allocatable :: regions(:)

        call domain%set_points(tower)
        call domain%set_facets(squares)
        call domain%set_holes(reshape([1.0_real64, 1.0_real64, 3.0_real64], [3, 1]))
        call domain%build(mesh)
        call mesh%check()
        call domain%check(mesh)
        call mesh%get(mgdt_mesh_array_tetrahedron_regions, regions)
        call expect(size(regions) >= 5 .and. all(regions == 1), 'one cube is left')
    end subroutine

    ! Schoenhardt's polyhedron, a prism whose top is turned.
    subroutine further_points()
        type(mgdt_domain_input) :: domain
        type(mgdt_tetrahedral_mesh) :: mesh
        real(real64) :: xyz(3, 6), at(3)
        real(real64), allocatable :: points(:, :), t(:)
        integer, allocatable :: edges(:, :)
        integer :: i

        xyz = reshape([real(real64) :: 8, 0, 0, -4, 7, 0, -4, -7, 0, &
                       7, 4, 8, -7, 4, 8, 0, -8, 8], [3, 6])
        call domain%set_points(xyz)
        call domain%set_facets(reshape([1, 3, 2, 4, 5, 6, 1, 2, 5, 1, 5, 4, 2, 3, 6, 2, 6, 5, &
                                      3, 1, 4, 3, 4, 6], [3, 8]))
        call domain%set_option(mgdt_domain_option_round_points, 1)
        call domain%build(mesh)
        call mesh%check()
        call domain%check(mesh)
        call mesh%get(mgdt_mesh_array_points, points)
        call mesh%get(mgdt_mesh_array_steiner_edges, edges)
        call mesh%get(mgdt_mesh_array_steiner_parameters, t)
        call expect(size(t) > 0, 'further points')
        call expect(mesh%statistic(mgdt_mesh_stat_steiner_points) == size(t), 'their number')
        call expect(size(points, 2) == 6 + size(t), 'behind those that were given')
        do i = 1, size(t)
            at = points(:, edges(1, i)) + t(i)*(points(:, edges(2, i)) - points(:, edges(1, i)))
            call expect(all(abs(points(:, 6 + i) - at) <= 0), 'on its edge')
        end do
    end subroutine

    ! A mesh of the caller's tetrahedra: a cube, whose centre is moved.
    subroutine improved_mesh()
        type(mgdt_tetrahedral_mesh) :: mesh, other
        real(real64) :: xyz(3, 9), volume
        real(real64), allocatable :: shapes(:, :), points(:, :), volumes(:), sizes(:)
        integer :: corners(4, 12), i, stat
        integer, allocatable :: markers(:), below(:, :), reasons(:)
        integer(int64), allocatable :: long(:, :)
        real(real64), parameter :: places(3, 2) = reshape([real(real64) :: 1.25, 1, 0.5, 3, 0.5, 1], [3, 2])
        real(real64) :: weights(4, 2), values(3, 2), summary(3)
        integer(int64) :: found_long(2), counts(18), few(6)
        integer :: found(2)
        character(200) :: message

        xyz(:, :8) = tower(:, :8)
        xyz(:, 9) = [1.7_real64, 0.5_real64, 0.4_real64]
        do i = 1, 6
            corners(:, 2*i - 1) = [squares(1, i), squares(2, i), squares(3, i), 9]
            corners(:, 2*i) = [squares(1, i), squares(4, i), squares(3, i), 9]
        end do
        call mesh%set_points(xyz)
        call mesh%set_tetrahedra(corners, [(4, i=1, 12)])
        call mesh%set_faces(corners(:3, :2), [5, 6])
        call mesh%set_edges(reshape([1, 2], [2, 1]), [7])
        call mesh%build()
        call mesh%check()
        call expect(mesh%statistic(mgdt_mesh_stat_tetrahedra) == 12, 'all tetrahedra')
        call mesh%get(mgdt_mesh_array_face_markers, markers)
        call expect(all(markers(:2) == [5, 6]) .and. all(markers(3:) == 0), 'markers of faces')
        call mesh%get(mgdt_mesh_array_tetrahedra, long)
        call expect(all(minval(long, 1) >= 1) .and. maxval(long) == 9, 'numbers from 1')

        call mesh%set_option(mgdt_mesh_option_goal, 40)
        call mesh%set_option(mgdt_mesh_option_boundary, mgdt_boundary_slide)
        call mesh%set_progress(hear)
        heard = 0
        call mesh%improve()
        call mesh%remove_progress()
        call expect(heard > 0, 'progress of an improvement')
        call mesh%check()
        call mesh%get(mgdt_mesh_array_shapes, shapes)
        call expect(shapes(2, 1) > shapes(1, 1), 'larger angles')
        call mesh%get(mgdt_mesh_array_tetrahedra_below, below)
        call expect(size(below, 2) == 6 .and. below(1, 6) > below(2, 5), 'fewer small angles')
        call mesh%get(mgdt_mesh_array_reasons, reasons)
        call expect(count(reasons /= mgdt_reason_none) == mesh%statistic(mgdt_mesh_stat_below_goal), &
                    'reasons')
        allocate (volumes(mesh%statistic(mgdt_mesh_stat_tetrahedra)))
        call mesh%get_tetrahedron_measures(mgdt_tetrahedron_volume, volumes)
        volume = sum(volumes)
        call expect(abs(volume - 8) < 1e-12_real64, 'the volume')

        ! Places inside and outside, values there, and the shapes.
        call mesh%locate_points(places, found, weights)
        call expect(found(1) > 0 .and. found(2) == 0, 'located')
        call expect(all(abs(weights(:, 2)) <= 0) .and. abs(sum(weights(:, 1)) - 1) < 1e-12_real64, 'weights')
        call mesh%locate_points(places, found_long, outside=mgdt_outside_boundary)
        call expect(found_long(1) == found(1) .and. found_long(2) > 0, 'located at the boundary')
        call mesh%get(mgdt_mesh_array_points, points)
        call mesh%interpolate(points, places, values, mgdt_outside_boundary)
        call expect(all(abs(values(:, 1) - places(:, 1)) < 1e-12_real64), 'a value inside')
        call expect(all(abs(values(:, 2) - [2.0_real64, 0.5_real64, 1.0_real64]) < 1e-12_real64), &
                    'a value of the boundary')
        call mesh%interpolate(points, places, values)
        call expect(ibits(transfer(values(1, 2), 0_int64), 52, 11) == 2047, 'no value outside')
        call mesh%get_shape_summary(summary, counts, few)
        call expect(all(abs(summary - shapes(2, :)) <= 0), 'the shapes')
        call expect(sum(counts) == 6*size(volumes) .and. all(few == below(2, :)), 'the angles')
        call mesh%locate_points(places(:2, :), found, stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'first extent 2')
        call mesh%locate_points(places, found(:1), stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'last extent 1')
        call mesh%interpolate(points(:, :3), places, values, stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'values has the last extent 3')
        call mesh%locate_points(places, found, outside=mgdt_outside_nearest, stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_unknown_key, message, '20')

        ! Fixed points, and 64 bits.
        call other%set_option(mgdt_mesh_option_threads, 2)
        call other%set_points(reshape(xyz, [27]))
        call other%set_tetrahedra(int(corners, int64))
        call other%set_faces(int(corners(:3, :1), int64))
        call other%set_edges(reshape([1_int64, 9_int64], [2, 1]))
        call other%set_fixed_points([9_int64])
        call other%build()
        call other%set_fixed_points([9, 1])
        call other%improve()
        call other%get(mgdt_mesh_array_points, points)
        call expect(all(abs(points(:, 9) - xyz(:, 9)) <= 0), 'a fixed point')

        ! Sizes of all kinds.
        call other%set_option(mgdt_mesh_option_size, 0.75_real64)
        call expect(abs(other%get_double_option(mgdt_mesh_option_size) - 0.75_real64) <= 0, 'the size')
        call other%set_sizes(mgdt_sizes_of_regions, [0.5_real64])
        call other%set_sizes(mgdt_sizes_of_regions, [real(real64) ::])
        call other%get(mgdt_mesh_array_points, points)
        allocate (sizes(size(points, 2)), source=0.0_real64)
        sizes(1) = 0.25_real64
        call other%set_sizes(mgdt_sizes_of_points, sizes)
        call other%set_sizes(mgdt_sizes_of_points, sizes(2:), stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'sizes of points')
        call other%set_progress(hear)
        heard = 0
        call other%refine()
        call other%remove_progress()
        call expect(heard > 0, 'progress of a refinement')
        call other%check()
        call expect(other%statistic(mgdt_mesh_stat_inserted_points) > 10, 'points of a refinement')
        call other%get(mgdt_mesh_array_sizes, sizes)
        call expect(size(sizes) == other%statistic(mgdt_mesh_stat_points) .and. &
                    abs(sizes(1) - 0.25_real64) <= 0, 'the sizes')
        ! Sizes that vary in space.
        call other%set_size_field(reshape([0.0_real64, 0.0_real64, 0.0_real64, 1.0_real64, &
                                           1.0_real64, 1.0_real64], [3, 2]), [0.5_real64, 0.25_real64])
        call other%set_size_field(points(:, :2), [1.0_real64], stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'sizes')
        call other%set_size_function(find_sizes)
        asked = 0
        call other%refine()
        call expect(asked > 10, 'places of a size function')
        call other%check()
        asked = -1
        call other%refine(stat, message)
        call expect_error(stat, mgdt_err_cancelled, message, 'stop')
        call other%remove_size_function()
        call other%set_size_field(reshape([real(real64) ::], [3, 0]), [real(real64) ::])
        call other%refine()
        call other%get(mgdt_mesh_array_refusals, reasons)
        call expect(count(reasons /= mgdt_refusal_none) == other%statistic(mgdt_mesh_stat_refused), &
                    'refusals')

        call other%build(stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'no tetrahedra')
        call other%set_points(xyz)
        call other%set_tetrahedra(corners(:3, :), stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'first extent 3')
        corners(2, 5) = 10
        call other%set_tetrahedra(corners, stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'tetrahedron 5 has the corner 10')
        corners(2, 5) = corners(1, 5)
        call other%set_tetrahedra(corners)
        call other%build(stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'tetrahedron 5 has a corner twice')
    end subroutine

    subroutine what_is_refused()
        type(mgdt_domain_input) :: domain, none
        type(mgdt_tetrahedral_mesh) :: mesh, empty_mesh
        integer, allocatable :: pairs(:, :), marked(:, :)
        integer(int64) :: n
        integer :: stat
        integer :: empty(0)
        character(200) :: message

        call domain%set_points(reshape([real(real64) :: 0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1, 1, 1, 2, &
                                      5, 1, 1], [3, 6]))
        call domain%set_facets(reshape([1, 2, 3, 4, 5, 6], [3, 2]))
        call domain%validate(stat, message)
        call expect_error(stat, mgdt_err_invalid_boundary, message, 'facet')
        call domain%get(mgdt_domain_array_offending_pairs, pairs)
        call expect(size(pairs, 2) == 1, 'one pair')
        if (size(pairs, 2) == 1) call expect(all(pairs(:, 1) == [mgdt_domain_kind_facet, 1, &
                                                               mgdt_domain_kind_facet, 2]), 'the pair')
        call domain%build(mesh, stat, message)
        call expect_error(stat, mgdt_err_invalid_boundary, message, 'facet')
        call expect(.not. mesh%is_created(), 'no mesh')
        call mesh%check(stat, message)
        call expect_error(stat, mgdt_err_null_pointer, message, 'has not been created')
        call domain%check(mesh, stat, message)
        call expect(stat == mgdt_err_null_pointer, 'no mesh to compare')

        call domain%set_facets(reshape([1, 2, 7], [3, 1]), stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, '7')
        call domain%set_facets(reshape([1, 2, 3], [3, 1]), [1, 2], stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'markers has 2')
        call domain%set_facets(empty, [1, 2, 3], stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'offsets is empty')
        call domain%set_facets([1, 4], [1, 2], stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'corners has 2')
        call domain%set_segments(reshape([1, 2, 3], [3, 1]), stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'first extent 3')
        call domain%set_segments(reshape([1, 9], [2, 1]), [1], stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, '9')
        call domain%set_points(reshape([real(real64) :: 1, 2], [2, 1]), stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'first extent 2')
        call domain%set_points([real(real64) :: 1, 2], stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, '2 elements')
        call domain%set_option(mgdt_domain_option_weld, -1.0_real64, stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, '-1')
        call domain%set_option(mgdt_domain_option_threads, -1, stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, '-1')
        call mesh%get(mgdt_mesh_array_tetrahedron_regions, marked, stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'one dimension')
        n = domain%array_size(999, stat, message)
        call expect_error(stat, mgdt_err_unknown_key, message, '999')
        n = none%statistic(mgdt_domain_stat_points, stat, message)
        call expect_error(stat, mgdt_err_null_pointer, message, 'has not been created')
        call expect(n == 0, 'no number')
        n = empty_mesh%statistic(mgdt_mesh_stat_tetrahedra, stat, message)
        call expect_error(stat, mgdt_err_null_pointer, message, 'the mesh has not been created')
        call domain%set_regions(reshape([real(real64) :: 1, 2], [2, 1]), [1], stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'first extent 2')
        call domain%set_holes(reshape([real(real64) :: 1, 2], [2, 1]), stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'first extent 2')

        ! The mesh is as it was set, and a cancelled build leaves it so.
        call domain%set_points(tower)
        call domain%set_facets(squares)
        call domain%set_progress(stop_it)
        call domain%build(mesh, stat, message)
        call expect_error(stat, mgdt_err_cancelled, message, 'cancel')
        call domain%remove_progress()
        call domain%cancel()
        call domain%build(mesh, stat, message)
        call expect_error(stat, mgdt_err_cancelled, message, 'cancel')
        call domain%build(mesh)
        call expect(mesh%statistic(mgdt_mesh_stat_tetrahedra) >= 10, 'built after all')
    end subroutine
end program
