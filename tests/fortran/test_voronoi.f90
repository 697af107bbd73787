! SPDX-License-Identifier: MIT
! Module mgdt_voronoi: a diagram clipped to a cube and one that is not, in every kind of array.
program test_voronoi
    use mgdt
    use mgdt_voronoi
    use, intrinsic :: iso_c_binding, only: c_associated
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use checks
    implicit none

    call everything()
    call conclude()

contains

    ! A subroutine frees what it has; a main program does not.
    subroutine everything()
        integer, parameter :: n = 600
        type(mgdt_triangulation) :: t, none, flat
        type(mgdt_voronoi_diagram) :: cut, whole, unmade
        real(real64) :: xyz(3, n), volumes_of_t(n)
        real(real64) :: cube(4, 6) = reshape([real(real64) :: -1, 0, 0, 0, 1, 0, 0, 1, 0, -1, 0, 0, &
                                              0, 1, 0, 1, 0, 0, -1, 0, 0, 0, 1, 1], [4, 6])
        real(real64), allocatable :: volumes(:), areas(:), at(:, :), normals(:, :), flat_normals(:)
        integer(int32), allocatable :: first(:), corners(:), sides(:, :), faces(:), begins(:)
        integer(int64), allocatable :: long_first(:), long_sides(:, :), long_flat(:)
        integer, allocatable :: bounded(:)
        integer :: i, k, stat
        real(real64) :: total, far
        character(200) :: message
        logical :: yes

        call make_points(xyz)
        call t%insert(xyz)
        call expect(.not. cut%is_created() .and. .not. c_associated(cut%c_handle()), 'not created')
        call cut%create(t, cube)
        call expect(cut%is_created() .and. c_associated(cut%c_handle()), 'created')
        call whole%create(t)

        ! Cells fill the cube, and agree with the measures of the triangulation.
        call cut%get(mgdt_voronoi_array_cell_volumes, volumes)
        call expect(size(volumes) == n .and. abs(sum(volumes) - 1) < 1e-12_real64, 'cells fill the cube')
        call t%get_cell_measures(mgdt_measure_volume, volumes_of_t, cube)
        call expect(all(abs(volumes - volumes_of_t) <= 1e-12_real64), 'volumes of cells')
        call cut%get(mgdt_voronoi_array_cell_bounded, bounded)
        call expect(sum(bounded) == t%vertex_count(), 'bounded cells')

        ! Each face is as far from its two points; numbers begin at 1.
        call cut%get(mgdt_voronoi_array_face_sides, sides)
        call cut%get(mgdt_voronoi_array_face_offsets, first)
        call cut%get(mgdt_voronoi_array_face_corners, corners)
        call cut%get(mgdt_voronoi_array_vertices, at)
        call cut%get(mgdt_voronoi_array_face_normals, normals)
        call cut%get(mgdt_voronoi_array_face_areas, areas)
        call expect(first(1) == 1 .and. first(size(first)) == size(corners) + 1, 'offsets from 1')
        call expect(minval(corners) == 1 .and. maxval(corners) == size(at, 2), 'vertices from 1')
        call expect(size(sides, 1) == 2 .and. size(sides, 2) == size(areas), 'a pair for each face')
        call expect(minval(sides(1, :)) >= 1 .and. maxval(sides) <= n .and. minval(sides) == -6, 'sides')
        far = 0
        do i = 1, size(areas)
            associate (a => sides(1, i), b => sides(2, i))
                do k = first(i), first(i + 1) - 1
                    if (b < 0) then
                        far = max(far, abs(dot_product(cube(:3, -b), at(:, corners(k))) - cube(4, -b)))
                    else
                        far = max(far, abs(norm2(at(:, corners(k)) - xyz(:, a)) - &
                                           norm2(at(:, corners(k)) - xyz(:, b))))
                    end if
                end do
            end associate
        end do
        call expect(far < 1e-14_real64, 'corners are between the two points')
        call expect(all(abs(norm2(normals, 1) - 1) < 1e-15_real64), 'unit normals')

        ! The faces of each cell, and its area.
        call cut%get(mgdt_voronoi_array_cell_offsets, begins)
        call cut%get(mgdt_voronoi_array_cell_faces, faces)
        call t%get_cell_measures(mgdt_measure_area, volumes_of_t, cube)
        yes = size(begins) == n + 1
        do i = 1, n
            total = sum(areas(faces(begins(i):begins(i + 1) - 1)))
            yes = yes .and. abs(total - volumes_of_t(i)) < 1e-12_real64
        end do
        call expect(yes, 'areas of cells')

        ! Other kinds and ranks.
        call cut%get(mgdt_voronoi_array_face_offsets, long_first)
        call expect(all(long_first == first), '64 bits')
        call cut%get(mgdt_voronoi_array_face_sides, long_sides)
        call cut%get(mgdt_voronoi_array_face_sides, long_flat)
        call expect(all(long_sides == sides) .and. all(long_flat == reshape(sides, [size(sides)])), 'sides, flat')
        call cut%get(mgdt_voronoi_array_face_normals, flat_normals)
        call expect(all(abs(flat_normals - reshape(normals, [size(normals)])) <= 0), 'normals, flat')
        call expect(cut%array_size(mgdt_voronoi_array_face_areas) == size(areas), 'array_size')
        call expect(cut%statistic(mgdt_voronoi_stat_faces) == size(areas), 'statistic')
        call expect(cut%columns(mgdt_voronoi_array_face_sides) == 2, 'columns')

        ! Rays of what is not clipped.
        call whole%get(mgdt_voronoi_array_face_areas, areas)
        call whole%get(mgdt_voronoi_array_face_corners, corners)
        call whole%get(mgdt_voronoi_array_ray_directions, at)
        call expect(count(areas > huge(areas)) == count(corners < 0)/2, 'unbounded faces')
        call expect(minval(corners) == -size(at, 2) .and. size(at, 2) > 0, 'rays')

        ! A diagram outlives the triangulation and may be made again.
        i = size(areas)
        call t%destroy()
        call whole%drop_small_faces(0.001_real64, 0.0_real64)
        call whole%get(mgdt_voronoi_array_face_areas, areas)
        call expect(size(areas) < i .and. minval(areas) >= 0.001_real64, 'small faces')
        call whole%create(none)
        call whole%get(mgdt_voronoi_array_cell_volumes, volumes)
        call expect(size(volumes) == 0, 'no points')

        ! What is refused.
        call flat%insert(reshape([real(real64) :: 0, 0, 0, 1, 0, 0, 0, 1, 0], [3, 3]))
        call cut%create(flat, stat=stat, errmsg=message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'plane')
        call cut%get(mgdt_voronoi_array_cell_volumes, volumes)
        call expect(size(volumes) == n, 'the diagram stays')
        call cut%create(none, cube(:3, :), stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'first extent 3')
        call cut%get(mgdt_voronoi_array_cell_volumes, bounded, stat, message)
        call expect_error(stat, mgdt_err_unknown_key, message, '330')
        call cut%get(mgdt_voronoi_array_cell_faces, sides, stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, 'one dimension')
        call cut%drop_small_faces(-1.0_real64, 0.0_real64, stat, message)
        call expect_error(stat, mgdt_err_invalid_argument, message, '-1')
        call unmade%get(mgdt_voronoi_array_cell_volumes, volumes, stat, message)
        call expect_error(stat, mgdt_err_null_pointer, message, 'has not been created')
        call cut%destroy()
        call expect(.not. cut%is_created(), 'destroyed')
    end subroutine
end program
