! SPDX-License-Identifier: MIT
! Module mgdt_periodic: a box whose tetrahedra fill it, a crystal's cells, a slab, steps of points,
! and what is refused.
program test_periodic
    use mgdt
    use mgdt_periodic
    use mgdt_voronoi
    use, intrinsic :: iso_c_binding, only: c_associated
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use checks
    implicit none

    real(real64), parameter :: vectors(3, 3) = reshape([real(real64) :: &
        1, 0, 0, 0.5, 1, 0, 0.25, -0.5, 1], [3, 3])
    integer :: heard = 0

    call a_box()
    call a_crystal()
    call a_slab()
    call what_is_refused()
    call conclude()

contains

    subroutine a_box()
        type(mgdt_periodic_box) :: box, again
        real(real64) :: xyz(3, 90), volume, corners(3, 4)
        integer, allocatable :: tets(:, :), offsets(:, :, :), neighbors(:, :), starts(:), map(:)
        integer, allocatable :: flat(:)
        integer(int64), allocatable :: long(:, :), long3(:, :, :), list(:)
        integer(int32), allocatable :: short(:, :, :), short2(:, :), short1(:)
        real(real64), allocatable :: points(:, :), numbers(:)
        integer :: i, k, stat
        integer(int64) :: edges
        logical :: alike

        call make_points(xyz)
        call expect(.not. box%is_created() .and. .not. c_associated(box%c_handle()), 'nothing is made yet')
        call box%set_vectors(vectors)
        call expect(box%is_created() .and. c_associated(box%c_handle()), 'made')
        call box%insert_points(xyz(:, :45))
        call box%insert_points(reshape(xyz(:, 46:), [135]))
        call box%set_option(mgdt_periodic_option_threads, 2)
        call expect(box%get_option(mgdt_periodic_option_threads) == 2, 'threads')
        call box%set_merge_distance(1d-12)
        call expect(abs(box%merge_distance() - 1d-12) < 1d-20, 'the distance within which points are equal')
        call box%set_merge_distance(0d0)
        call box%set_progress(hear)
        call box%build()
        call box%remove_progress()
        call expect(heard > 1, 'progress')
        call box%check()
        call expect(box%statistic(mgdt_periodic_stat_vertices) == 81, 'repeats are no vertices')
        call box%get(mgdt_periodic_array_points, points)
        call box%get(mgdt_periodic_array_tetrahedra, tets)
        call box%get(mgdt_periodic_array_tetrahedron_shifts, offsets)
        call box%get(mgdt_periodic_array_neighbors, neighbors)
        call expect(all(abs(points - xyz) <= 0), 'the points are on the grid')
        call expect(size(tets, 2) == box%statistic(mgdt_periodic_stat_tetrahedra), 'number of tetrahedra')
        volume = 0
        do i = 1, size(tets, 2)
            do k = 1, 4
                corners(:, k) = points(:, tets(k, i)) + matmul(vectors, offsets(:, k, i))
            end do
            volume = volume + volume6(corners(:, 1), corners(:, 2), corners(:, 3), corners(:, 4))/6
        end do
        call expect(abs(volume - 1) < 1e-12_real64, 'the tetrahedra fill the box')
        call expect(minval(neighbors) == 1 .and. maxval(neighbors) == size(tets, 2), 'neighbours')
        edges = box%statistic(mgdt_periodic_stat_edges)
        call expect(edges == 81 + size(tets, 2), 'as many edges as vertices and tetrahedra')
        call box%get(mgdt_periodic_array_vertex_neighbor_offsets, starts)
        call box%get(mgdt_periodic_array_vertex_neighbors, list)
        call expect(size(starts) == 91 .and. starts(91) == 2*edges + 1, 'lists of neighbours')
        call expect(size(list) == 2*edges, 'neighbours of vertices')
        call box%get(mgdt_periodic_array_point_map, map)
        call expect(all(map(82:) == map(:9)), 'repeats')
        ! Other kinds and ranks.
        call box%get(mgdt_periodic_array_tetrahedron_shifts, long)
        call expect(all(reshape(long, [3, 4, size(tets, 2)]) == offsets), 'rank 2')
        call box%get(mgdt_periodic_array_neighbor_shifts, long3)
        call box%get(mgdt_periodic_array_neighbor_shifts, short)
        call expect(all(short == long3), '32 and 64 bits')
        call box%get(mgdt_periodic_array_vertex_neighbor_shifts, short2)
        call box%get(mgdt_periodic_array_point_map, short1)
        call box%get(mgdt_periodic_array_tetrahedra, flat)
        call expect(all(reshape(flat, shape(tets)) == tets), 'rank 1')
        call box%get(mgdt_periodic_array_vectors, numbers)
        call expect(all(abs(numbers - reshape(vectors, [9])) <= 0), 'vectors')
        ! The same, by images of the points.
        call again%set_vectors(vectors)
        call again%insert_points(xyz)
        call again%set_option(mgdt_periodic_option_index_base, 1_int64)
        do i = 1, 90
            xyz(:, i) = xyz(:, i) + matmul(vectors, [mod(i, 3), -mod(i, 5), 1])
        end do
        call again%move_points(xyz)
        call again%build()
        call again%get(mgdt_periodic_array_tetrahedra, long)
        call expect(size(long, 2) == size(tets, 2), 'as many')
        alike = all(long == tets)
        call expect(alike, 'images give the same tetrahedra')
        call again%move_points([3, 1], reshape([xyz(:, 1), xyz(:, 3)], [3, 2]))
        call again%move_points([2_int64], xyz(:, 2:2))
        call again%build()
        call expect(again%statistic(mgdt_periodic_stat_tetrahedra) == size(tets, 2), 'two were exchanged')
        call again%cancel()
        call again%build(stat=stat)
        call expect(stat == mgdt_err_cancelled, 'cancelled')
        call again%clear()
        call again%build()
        call expect(again%statistic(mgdt_periodic_stat_points) == 0, 'cleared')
        call again%set_vectors(vectors(:, :2))
        call expect(again%statistic(mgdt_periodic_stat_dimensions) == 2, 'another box')
        call again%destroy()
        call expect(.not. again%is_created(), 'destroyed')
    end subroutine

    subroutine hear(fraction, cancel)
        real(real64), intent(in) :: fraction
        logical, intent(inout) :: cancel

        heard = heard + 1
        if (fraction > 1) cancel = .true.
    end subroutine

    ! Diamond: eight atoms, cells with sixteen faces.
    subroutine a_crystal()
        type(mgdt_periodic_box) :: box
        type(mgdt_voronoi_diagram) :: cells
        real(real64), parameter :: cube(3, 3) = reshape([real(real64) :: 4, 0, 0, 0, 4, 0, 0, 0, 4], [3, 3])
        real(real64), parameter :: atoms(3, 8) = reshape([real(real64) :: &
            0, 0, 0, 2, 2, 0, 2, 0, 2, 0, 2, 2, 1, 1, 1, 3, 3, 1, 3, 1, 3, 1, 3, 3], [3, 8])
        real(real64) :: x(8), centroids(3, 8)
        integer, allocatable :: images(:, :), sides(:, :)
        character(200) :: message
        integer :: stat

        call cells%create(box, stat=stat, errmsg=message)
        call expect(stat == mgdt_err_null_pointer, 'no box')
        call box%set_vectors(cube)
        call box%insert_points(atoms)
        call cells%create(box, stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_not_built, message, 'there is no triangulation')
        call box%build()
        call box%get_cell_measures(mgdt_measure_volume, x)
        call expect(all(abs(x - 8) < 1e-12_real64), 'volumes')
        call box%get_cell_measures(mgdt_measure_faces, x)
        call expect(all(abs(x - 16) <= 0), 'faces')
        call box%get_cell_measures(mgdt_measure_centroid, centroids)
        call expect(all(abs(centroids) < 1e-12_real64), 'centroids, from the atoms')
        call cells%create(box)
        call cells%get(mgdt_voronoi_array_face_shifts, images)
        call cells%get(mgdt_voronoi_array_face_sides, sides)
        call expect(size(images, 2) == size(sides, 2), 'an image for each face')
        call expect(any(images /= 0) .and. maxval(abs(images)) == 1, 'images')
    end subroutine

    subroutine a_slab()
        type(mgdt_periodic_box) :: slab
        real(real64) :: xyz(3, 50)
        integer, allocatable :: neighbors(:, :)

        call make_points(xyz)
        call slab%set_vectors(vectors(:, :2))
        call slab%insert_points(xyz)
        call slab%build()
        call slab%check()
        call slab%get(mgdt_periodic_array_neighbors, neighbors)
        call expect(minval(neighbors) == 0, 'a slab ends')
    end subroutine

    subroutine what_is_refused()
        type(mgdt_periodic_box) :: box
        integer, allocatable :: map(:, :), three(:, :, :)
        real(real64) :: x(3), rows(2, 2)
        character(200) :: message
        integer :: stat

        call box%build(stat=stat, errmsg=message)
        call expect(stat == mgdt_err_null_pointer, 'no box')
        call box%set_vectors(vectors(:2, :), stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'vectors has the extents 2 and 3')
        call box%set_vectors(vectors*0, stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'in a plane')
        call box%set_vectors(vectors)
        rows = 0
        call box%insert_points([1.0_real64, 2.0_real64], stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'xyz has 2 elements')
        call box%insert_points(rows, stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'the first extent of the array is 2')
        call box%insert_points([1.0_real64, 2.0_real64, 1e30_real64])
        call box%move_points([1, 2], reshape([1.0_real64, 2.0_real64, 3.0_real64], [3, 1]), stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, '2 points move to 1')
        call box%move_points([2], reshape([1.0_real64, 2.0_real64, 3.0_real64], [3, 1]), stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'there is no point 2')
        call box%build(stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'point 1 is more than')
        call box%get_cell_measures(mgdt_measure_volume, x, stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_not_built, message, 'there is no triangulation')
        call box%get(mgdt_periodic_array_point_map, map, stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'one dimension')
        call box%get(mgdt_periodic_array_points, three, stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'three dimensions')
        call expect(box%array_size(mgdt_periodic_array_points, stat=stat, errmsg=message) == 0, 'nothing')
        call expect_error(stat, mgdt_err_not_built, message, 'there is no triangulation')
    end subroutine
end program
