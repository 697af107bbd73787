! SPDX-License-Identifier: MIT
! Module mgdt_domain: two cubes of different materials that share a square, one of them with a hole,
! a polyhedron that has no tetrahedra without further points, and what is refused.
program test_domain
    use mgdt
    use mgdt_domain
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
    integer :: heard = 0

    call two_cubes()
    call a_hole()
    call further_points()
    call what_is_refused()
    call conclude()

contains

    subroutine two_cubes()
        type(mgdt_domain_mesh) :: mesh, again
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
        call expect(.not. c_associated(mesh%c_handle()), 'nothing is made yet')
        call mesh%set_points(tower)
        call expect(c_associated(mesh%c_handle()), 'made')
        call mesh%set_facets(squares, markers)
        call mesh%set_segments(reshape([1, 2, 9, 10], [2, 2]), [5, 6])
        call mesh%add_region([1.0_real64, 1.0_real64, 1.0_real64], 7)
        call mesh%add_region([1.0_real64, 1.0_real64, 3.0_real64], 9)
        call mesh%validate()
        call expect(mesh%array_size(mgdt_domain_array_offending_pairs) == 0, 'valid')
        call mesh%set_progress(hear)
        call mesh%build()
        call mesh%remove_progress()
        call expect(heard > 0, 'progress')
        call mesh%check()

        ! Volumes of the regions, and the numbers of everything, from 1.
        call mesh%get(mgdt_domain_array_points, points)
        call expect(size(points, 1) == 3 .and. size(points, 2) == 12, 'points')
        call expect(all(abs(points - tower) <= 0), 'coordinates as given')
        call mesh%get(mgdt_domain_array_tetrahedra, tets)
        call mesh%get(mgdt_domain_array_regions, regions)
        call mesh%get(mgdt_domain_array_region_markers, region_markers)
        call expect(mesh%number(mgdt_domain_tetrahedra) == size(tets, 2), 'number of tetrahedra')
        call expect(mesh%number(mgdt_domain_regions) == 2 .and. size(region_markers) == 2, 'two regions')
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
        call mesh%get(mgdt_domain_array_neighbors, neighbors)
        call expect(all(shape(neighbors) == shape(tets)) .and. minval(neighbors) == 0, 'neighbours')

        ! Each square is two faces; those between the cubes have a tetrahedron on both sides.
        call mesh%get(mgdt_domain_array_faces, faces)
        call mesh%get(mgdt_domain_array_face_markers, face_markers)
        call mesh%get(mgdt_domain_array_face_tetrahedra, sides)
        call expect(size(faces, 1) == 3 .and. size(faces, 2) == 22, 'faces')
        call expect(all([(count(face_markers == i) == 2, i=1, 11)]), 'two faces for each square')
        do i = 1, size(faces, 2)
            call expect((minval(sides(:, i)) == 0) .neqv. face_markers(i) == 6, 'sides of a face')
        end do
        call mesh%get(mgdt_domain_array_face_facets, short)
        call expect(all(short == face_markers), 'facets of faces')
        call mesh%get(mgdt_domain_array_segment_sources, sources)
        call mesh%get(mgdt_domain_array_segment_markers, short)
        call expect(size(sources) == 20 .and. sum(sources) == 3 .and. sum(short) == 11, 'segments')

        ! Other kinds and ranks.
        call mesh%get(mgdt_domain_array_tetrahedra, long)
        call mesh%get(mgdt_domain_array_tetrahedra, flat)
        call expect(all(long == tets) .and. all(flat == reshape(tets, [size(tets)])), '64 bits, flat')
        call mesh%get(mgdt_domain_array_points, coordinates)
        call expect(all(abs(coordinates - reshape(tower, [36])) <= 0), 'points, flat')

        ! The same as lists of corners, from 0, in both kinds of integers.
        call again%set_option(mgdt_domain_index_base, 0)
        call expect(again%get_option(mgdt_domain_index_base) == 0, 'index base')
        call again%set_points(reshape(tower, [36]))
        first = [(4*i, i=0, 11)]
        call again%set_facets(first, reshape(squares - 1, [44]), markers)
        call again%build()
        call again%get(mgdt_domain_array_tetrahedra, long)
        call expect(all(long == tets - 1), 'polygons')
        first_long = first + 1
        squares_long = reshape(squares, [44])
        call again%set_option(mgdt_domain_index_base, 1_int64)
        call again%set_facets(first_long, squares_long)
        call again%build()
        call again%get(mgdt_domain_array_tetrahedra, long)
        call expect(all(long == tets), 'polygons of 64 bits')
        call again%get(mgdt_domain_array_face_markers, short)
        call expect(all(short == 0), 'no markers')
        call again%set_facets(int(squares, int64), markers)
        call again%set_segments(reshape([1_int64, 2_int64], [2, 1]))
        call again%build()
        call again%get(mgdt_domain_array_face_markers, short)
        call expect(sum(short) == sum(face_markers), 'markers')
        call again%clear()
        call expect(again%number(mgdt_domain_given_points) == 0, 'cleared')
        call again%build(stat, message)
        call expect_error(stat, mgdt_err_open_boundary, message, 'no facets')
        call again%destroy()
        call expect(.not. c_associated(again%c_handle()), 'destroyed')
    end subroutine

    subroutine hear(fraction, cancel)
        real(real64), intent(in) :: fraction
        logical, intent(inout) :: cancel

        heard = heard + 1
        cancel = cancel .or. fraction > 1
    end subroutine

    subroutine stop_it(fraction, cancel)
        real(real64), intent(in) :: fraction
        logical, intent(inout) :: cancel

        cancel = fraction >= 0
    end subroutine

    subroutine a_hole()
        type(mgdt_domain_mesh) :: mesh
        integer, allocatable :: regions(:)

        call mesh%set_points(tower)
        call mesh%set_facets(squares)
        call mesh%add_hole([1.0_real64, 1.0_real64, 3.0_real64])
        call mesh%build()
        call mesh%check()
        call mesh%get(mgdt_domain_array_regions, regions)
        call expect(size(regions) >= 5 .and. all(regions == 1), 'one cube is left')
    end subroutine

    ! Schoenhardt's polyhedron, a prism whose top is turned.
    subroutine further_points()
        type(mgdt_domain_mesh) :: mesh
        real(real64) :: xyz(3, 6), at(3)
        real(real64), allocatable :: points(:, :), t(:)
        integer, allocatable :: edges(:, :)
        integer :: i

        xyz = reshape([real(real64) :: 8, 0, 0, -4, 7, 0, -4, -7, 0, &
                       7, 4, 8, -7, 4, 8, 0, -8, 8], [3, 6])
        call mesh%set_points(xyz)
        call mesh%set_facets(reshape([1, 3, 2, 4, 5, 6, 1, 2, 5, 1, 5, 4, 2, 3, 6, 2, 6, 5, &
                                      3, 1, 4, 3, 4, 6], [3, 8]))
        call mesh%set_option(mgdt_domain_round_points, 1)
        call mesh%build()
        call mesh%check()
        call mesh%get(mgdt_domain_array_points, points)
        call mesh%get(mgdt_domain_array_steiner_edges, edges)
        call mesh%get(mgdt_domain_array_steiner_parameters, t)
        call expect(size(t) > 0, 'further points')
        call expect(mesh%number(mgdt_domain_steiner_points) == size(t), 'their number')
        call expect(size(points, 2) == 6 + size(t), 'behind those that were given')
        do i = 1, size(t)
            at = points(:, edges(1, i)) + t(i)*(points(:, edges(2, i)) - points(:, edges(1, i)))
            call expect(all(abs(points(:, 6 + i) - at) <= 0), 'on its edge')
        end do
    end subroutine

    subroutine what_is_refused()
        type(mgdt_domain_mesh) :: mesh, none
        integer, allocatable :: pairs(:, :), marked(:, :)
        integer(int64) :: n
        integer :: stat
        integer :: empty(0)
        character(200) :: message

        call mesh%set_points(reshape([real(real64) :: 0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1, 1, 1, 2, &
                                      5, 1, 1], [3, 6]))
        call mesh%set_facets(reshape([1, 2, 3, 4, 5, 6], [3, 2]))
        call mesh%validate(stat, message)
        call expect_error(stat, mgdt_err_invalid_boundary, message, 'facet')
        call mesh%get(mgdt_domain_array_offending_pairs, pairs)
        call expect(size(pairs, 2) == 1, 'one pair')
        if (size(pairs, 2) == 1) call expect(all(pairs(:, 1) == [mgdt_domain_kind_facet, 1, &
                                                               mgdt_domain_kind_facet, 2]), 'the pair')
        call mesh%build(stat, message)
        call expect_error(stat, mgdt_err_invalid_boundary, message, 'facet')
        call mesh%check(stat, message)
        call expect_error(stat, mgdt_err_not_built, message, 'no mesh')

        call mesh%set_facets(reshape([1, 2, 7], [3, 1]), stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, '7')
        call mesh%set_facets(reshape([1, 2, 3], [3, 1]), [1, 2], stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'markers has 2')
        call mesh%set_facets(empty, [1, 2, 3], stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'offsets is empty')
        call mesh%set_facets([1, 4], [1, 2], stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'corners has 2')
        call mesh%set_segments(reshape([1, 2, 3], [3, 1]), stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'first extent 3')
        call mesh%set_segments(reshape([1, 9], [2, 1]), [1], stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, '9')
        call mesh%set_points(reshape([real(real64) :: 1, 2], [2, 1]), stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'first extent 2')
        call mesh%set_points([real(real64) :: 1, 2], stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, '2 elements')
        call mesh%set_option(mgdt_domain_threads, -1, stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, '-1')
        call mesh%get(mgdt_domain_array_regions, marked, stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'one dimension')
        n = mesh%array_size(999, stat, message)
        call expect_error(stat, mgdt_err_unknown_key, message, '999')
        n = none%number(mgdt_domain_tetrahedra, stat, message)
        call expect_error(stat, mgdt_err_null_pointer, message, 'has not been created')
        call expect(n == 0, 'no number')

        ! The mesh is as it was set, and a cancelled build leaves it so.
        call mesh%set_points(tower)
        call mesh%set_facets(squares)
        call mesh%set_progress(stop_it)
        call mesh%build(stat, message)
        call expect_error(stat, mgdt_err_cancelled, message, 'cancel')
        call mesh%remove_progress()
        call mesh%cancel()
        call mesh%build(stat, message)
        call expect_error(stat, mgdt_err_cancelled, message, 'cancel')
        call mesh%build()
        call expect(mesh%number(mgdt_domain_tetrahedra) >= 10, 'built after all')
    end subroutine
end program
