! SPDX-License-Identifier: MIT
! Exported arrays against what must hold of any triangulation: volumes, Euler's formula, mutual
! neighbours; each kind and rank; larger arrays, sections, index base 0.
program test_arrays
    use checks
    use mgdt
    implicit none

    integer, parameter :: n = 600
    type(mgdt_triangulation) :: t
    real(real64) :: xyz(3, n)
    integer(int64) :: nt, nf, ne
    integer(int32), allocatable :: tets(:, :)

    call make_points(xyz)
    call expect(t%dimension() == -1, 'the dimension of nothing')
    call t%insert(xyz)
    call expect(t%point_count() == n, 'points')
    call expect(t%dimension() == 3, 'dimension')
    nt = t%tetrahedron_count()
    nf = t%hull_facet_count()
    ne = t%edge_count()
    call expect(t%vertex_count() - ne + (4*nt + nf)/2 - nt == 1, 'Euler')
    call expect(t%vertex_tetrahedra_count() == 4*nt, 'length of the list')
    allocate (tets(4, nt))
    call t%get_tetrahedra(tets)

    call test_point_map()
    call test_volumes()
    call test_neighbors()
    call test_edges()
    call test_vertex_tetrahedra()
    call test_vertex_neighbors()
    call test_graphs()
    call test_circumcenters()
    call test_tetrahedron_measures()
    call test_cell_measures()
    call test_interpolation()
    call test_alphas()
    call test_kinds_and_ranks()
    call test_larger_arrays_and_sections()
    call test_base_0()
    call test_empty()
    call conclude()

contains

    subroutine test_point_map()
        integer(int32) :: map(n)
        integer(int64) :: map_64(n)
        integer :: i, j
        logical :: right

        call t%get_point_map(map)
        call t%get_point_map(map_64)
        call expect(all(map == map_64), 'point map of both kinds')
        right = .true.
        do i = 1, n
            do j = 1, i
                if (all(abs(xyz(:, j) - xyz(:, i)) <= 0)) exit
            end do
            right = right .and. map(i) == j
        end do
        call expect(right, 'each point is mapped to the first at its place')
        call expect(count(map == [(i, i=1, n)]) == t%vertex_count(), 'vertices')
        call expect(count(map /= [(i, i=1, n)]) >= n/10, 'there are duplicates to be found')
    end subroutine

    subroutine test_volumes()
        integer(int64) :: facets(3, nf)
        real(real64) :: volume, sum_of_volumes
        logical :: positive
        integer(int64) :: i

        sum_of_volumes = 0
        positive = .true.
        do i = 1, nt
            associate (v => tets(:, i))
                volume = volume6(xyz(:, v(1)), xyz(:, v(2)), xyz(:, v(3)), xyz(:, v(4)))
            end associate
            positive = positive .and. volume > 0
            sum_of_volumes = sum_of_volumes + volume
        end do
        call expect(positive, 'positive orientation')
        call t%get_hull_facets(facets)
        volume = 0
        do i = 1, nf
            volume = volume + volume6([0._real64, 0._real64, 0._real64], xyz(:, facets(1, i)), &
                                      xyz(:, facets(2, i)), xyz(:, facets(3, i)))
        end do
        call expect(abs(volume - sum_of_volumes) <= 0, 'the hull encloses the tetrahedra exactly')
    end subroutine

    subroutine test_neighbors()
        integer(int64) :: neighbors(4, nt)
        integer(int64) :: i
        integer :: k
        logical :: mutual, shared

        call t%get_neighbors(neighbors)
        call expect(count(neighbors == 0) == nf, 'a missing neighbour for each facet of the hull')
        mutual = .true.
        shared = .true.
        do i = 1, nt
            do k = 1, 4
                if (neighbors(k, i) == 0) cycle
                associate (other => neighbors(k, i))
                    mutual = mutual .and. any(neighbors(:, other) == i)
                    shared = shared .and. common(tets(:, i), tets(:, other)) == 3 &
                             .and. all(tets(:, other) /= tets(k, i))
                end associate
            end do
        end do
        call expect(mutual, 'neighbours know each other')
        call expect(shared, 'neighbour k shares the facet opposite vertex k')
    end subroutine

    pure integer function common(a, b)
        integer(int32), intent(in) :: a(4), b(4)
        integer :: i

        common = count([(any(b == a(i)), i=1, 4)])
    end function

    subroutine test_edges()
        integer(int32) :: edges(2, ne)
        logical, allocatable :: wanted(:, :)
        integer(int64) :: i
        integer :: j, k
        logical :: each_once

        allocate (wanted(n, n))
        wanted = .false.
        do i = 1, nt
            do j = 1, 4
                do k = 1, 4
                    if (tets(j, i) < tets(k, i)) wanted(tets(j, i), tets(k, i)) = .true.
                end do
            end do
        end do
        call t%get_edges(edges)
        call expect(count(wanted) == ne, 'number of edges')
        each_once = .true.
        do i = 1, ne
            each_once = each_once .and. wanted(edges(1, i), edges(2, i))
            wanted(edges(1, i), edges(2, i)) = .false.
        end do
        call expect(each_once .and. .not. any(wanted), 'each edge once, the lesser point first')
    end subroutine

    subroutine test_vertex_neighbors()
        integer(int32) :: offsets(n + 1), list(2*ne), edges(2, ne), k
        integer(int64) :: offsets_64(n + 1), list_64(2*ne)
        logical :: found

        call expect(t%vertex_neighbors_count() == 2*ne, 'length of the neighbours'' list')
        call t%get_vertex_neighbors(offsets, list)
        call t%get_vertex_neighbors(offsets_64, list_64)
        call expect(all(offsets == offsets_64) .and. all(list == list_64), 'neighbours, both kinds')
        call expect(offsets(1) == 1 .and. offsets(n + 1) == 2*ne + 1, 'ends of the neighbours')
        call t%get_edges(edges)
        found = .true.
        do k = 1, int(ne, int32)
            found = found .and. any(list(offsets(edges(1, k)):offsets(edges(1, k) + 1) - 1) == edges(2, k))
            found = found .and. any(list(offsets(edges(2, k)):offsets(edges(2, k) + 1) - 1) == edges(1, k))
        end do
        call expect(found, 'the ends of an edge are neighbours')
    end subroutine

    subroutine test_graphs()
        integer(int32) :: edges(2, ne), count, parts(n), map(n), k
        integer(int64) :: edges_64(2, ne), count_64
        integer :: stat
        character(256) :: msg

        call t%get_gabriel_edges(edges, count)
        call t%get_gabriel_edges(edges_64, count_64)
        call expect(count == count_64 .and. count < ne .and. count >= n - 1, 'Gabriel edges')
        call expect(all(edges(:, :count) == edges_64(:, :count)), 'Gabriel edges of both kinds')
        call t%get_spanning_tree(edges, count)
        call t%get_spanning_tree(edges_64, count_64)
        call expect(count == t%vertex_count() - 1 .and. count_64 == count, 'edges of the tree')
        call expect(all(edges(:, :count) == edges_64(:, :count)), 'trees of both kinds')
        call t%get_point_map(map)
        parts = [(k, k = 1, n)]
        do k = 1, count
            where (parts == parts(edges(2, k))) parts = parts(edges(1, k))
        end do
        call expect(all(parts(map) == parts(map(1))), 'the tree joins all')
        call t%get_spanning_tree(edges(:, :3), count, stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'are needed')
        call t%get_gabriel_edges(edges(:1, :3), count, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'must be 2')
    end subroutine

    subroutine test_circumcenters()
        real(real64) :: centers(3, nt), squares(nt), more(3, nt), small(3, nt - 1), flat(2, nt), d
        integer :: i, k, stat
        character(256) :: msg
        logical :: equal

        call t%get_circumcenters(centers, squares)
        call t%get_circumcenters(more)
        call expect(maxval(abs(more - centers)) <= 0, 'centres alone')
        equal = .true.
        do i = 1, int(nt)
            do k = 1, 4
                d = sum((xyz(:, tets(k, i)) - centers(:, i))**2)
                equal = equal .and. abs(d - squares(i)) <= 1e-9_real64*(1 + squares(i))
            end do
        end do
        call expect(equal, 'vertices are on the sphere')
        call t%get_circumcenters(small, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'room for')
        call t%get_circumcenters(centers, squares(:nt - 1), stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'room for')
        call t%get_circumcenters(flat, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'must be 3')
    end subroutine

    subroutine test_tetrahedron_measures()
        real(real64) :: x(nt), total
        integer :: i, stat
        character(256) :: msg

        total = 0
        do i = 1, int(nt)
            total = total + volume6(xyz(:, tets(1, i)), xyz(:, tets(2, i)), xyz(:, tets(3, i)), &
                                    xyz(:, tets(4, i)))/6
        end do
        call t%get_tetrahedron_measures(mgdt_tetrahedron_volume, x)
        call expect(abs(sum(x) - total) <= 1e-12_real64*total, 'volumes')
        call t%get_tetrahedron_measures(mgdt_tetrahedron_radius_ratio, x)
        call expect(minval(x) > 0 .and. maxval(x) < 1, 'radius ratios')
        call t%get_tetrahedron_measures(mgdt_tetrahedron_longest_edge, x(:nt - 1), stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'needed')
        call t%get_tetrahedron_measures(11, x, stat, msg)
        call expect_error(stat, mgdt_err_unknown_key, msg, 'no measure 11')
    end subroutine

    subroutine test_alphas()
        real(real64) :: of_tets(nt), of_facets(4, nt), of_edges(ne), of_points(n), wide(3, nt), alpha2
        integer(int32) :: facets(3, 4*nt), count
        integer(int64) :: facets_64(3, 4*nt), count_64
        integer :: k, stat
        character(256) :: msg

        call t%get_alphas(3, of_tets)
        call t%get_alphas(2, of_facets)
        call t%get_alphas(1, of_edges)
        call t%get_alphas(0, of_points)
        do k = 1, 4
            call expect(all(of_facets(k, :) <= of_tets), 'facets come before their tetrahedra')
        end do
        call expect(minval(of_edges) <= minval(of_facets), 'edges come first')
        call expect(count_of_zeros(of_points) == t%vertex_count(), 'vertices')
        call t%get_alpha_surface(0.02_real64, facets, count)
        call t%get_alpha_surface(0.02_real64, facets_64, count_64)
        call expect(count == count_64 .and. all(facets(:, :count) == facets_64(:, :count)), 'surfaces')
        call t%get_solid_alpha(alpha2)
        call expect(any(abs(of_tets - alpha2) <= 0), 'alpha of one solid')
        call t%get_alphas(2, wide, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'must be 4')
        call t%get_alphas(5, of_tets, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'dimension 5')
        call t%get_alpha_surface(0.02_real64, facets(:, :1), count, stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'are needed')
    end subroutine

    ! By its bits, as a comparison may trap.
    logical function is_nan(x)
        real(real64), intent(in) :: x

        is_nan = ibits(transfer(x, 0_int64), 51, 12) == 4095
    end function

    integer function count_of_zeros(x)
        real(real64), intent(in) :: x(:)

        count_of_zeros = count(x <= 0)
    end function

    subroutine test_cell_measures()
        real(real64) :: volumes(n), faces(n), centroids(3, n), few(n - 1), wide(4, n), box(4, 6)
        integer :: k, stat
        character(256) :: msg

        box = 0
        do k = 1, 3
            box(k, 2*k - 1) = 1
            box(k, 2*k) = -1
        end do
        box(4, 1::2) = 2
        box(4, 2::2) = 1
        call t%get_cell_measures(mgdt_measure_volume, volumes, box)
        call expect(abs(sum(volumes) - 27) < 1e-12_real64, 'cells fill the box')
        call t%get_cell_measures(mgdt_measure_centroid, centroids, box)
        do k = 1, 3
            call expect(abs(sum(volumes*centroids(k, :)) - 13.5_real64) < 1e-11_real64, 'centroids')
        end do
        call t%get_cell_measures(mgdt_measure_faces, faces)
        call expect(nint(sum(faces), int64) == t%vertex_neighbors_count(), 'faces')
        call t%get_cell_measures(mgdt_measure_volume, few, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'are needed')
        call t%get_cell_measures(mgdt_measure_centroid, wide, stat=stat, errmsg=msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'must be 3')
        call t%get_cell_measures(mgdt_measure_volume, volumes, box(:3, :), stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'must be 4')
        call t%get_cell_measures(mgdt_measure_volume, volumes, box(:, :5), stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'do not bound')
    end subroutine

    subroutine test_interpolation()
        real(real64) :: places(3, 3), one(n), two(2, n), at(3), two_at(2, 3), slopes(3, n), two_slopes(3, 2, n)
        real(real64) :: weights(100), total
        integer(int32) :: offsets(4), points(100)
        integer(int64) :: offsets_64(4), points_64(100)
        integer :: i, k, stat
        character(256) :: msg

        places(:, 1) = [0.5_real64, 0.25_real64, 0.75_real64]
        places(:, 2) = [0.4_real64, 0.6_real64, 0.5_real64]
        places(:, 3) = [5.0_real64, 0.5_real64, 0.5_real64]
        do k = 1, n
            one(k) = xyz(1, k) + 2*xyz(3, k)
        end do
        two(1, :) = one
        two(2, :) = 1
        call t%interpolate(mgdt_interpolate_sibson, mgdt_outside_linear, one, places, at)
        call expect(maxval(abs(at - places(1, :) - 2*places(3, :))) < 1e-13_real64, 'a linear function')
        call t%interpolate(mgdt_interpolate_linear, mgdt_outside_none, two, places, two_at)
        call expect(maxval(abs(two_at(1, :2) - at(:2))) < 1e-13_real64, 'the first of two fields')
        call expect(maxval(abs(two_at(2, :2) - 1)) < 1e-14_real64, 'the second of two fields')
        call expect(is_nan(two_at(1, 3)), 'no value outside')
        call t%get_interpolation_weights(mgdt_interpolate_laplace, mgdt_outside_boundary, places, offsets, &
                                         points, weights)
        call expect(offsets(1) == 1, 'offsets begin at 1')
        do i = 1, 3
            total = 0
            do k = offsets(i), offsets(i + 1) - 1
                total = total + weights(k)*one(points(k))
            end do
            if (i < 3) call expect(abs(total - at(i)) < 1e-13_real64, 'weights')
        end do
        call t%get_interpolation_weights(mgdt_interpolate_laplace, mgdt_outside_boundary, places, &
                                         offsets_64, points_64, weights)
        call expect(all(offsets_64 == offsets), 'offsets of both kinds')
        call expect(all(points_64(:offsets(4) - 1) == points(:offsets(4) - 1)), 'points of both kinds')
        offsets_64 = 0
        call t%get_interpolation_weights(mgdt_interpolate_laplace, mgdt_outside_boundary, places, &
                                         offsets_64, points_64(:2), weights, stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'are needed')
        call expect(all(offsets_64 == offsets), 'offsets say what is needed')
        call t%get_gradients(one, slopes)
        call expect(maxval(abs(slopes(1, :) - 1)) < 1e-12_real64, 'gradients by x')
        call expect(maxval(abs(slopes(2, :))) < 1e-12_real64, 'gradients by y')
        call t%get_gradients(two, two_slopes)
        call expect(maxval(abs(two_slopes(:, 1, :) - slopes)) <= 0, 'gradients of two fields')
        call t%interpolate(mgdt_interpolate_linear, mgdt_outside_none, one(:n - 1), places, at, stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'values has room for')
        call t%interpolate(mgdt_interpolate_linear, mgdt_outside_none, one, places, at(:2), stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'out has room for 2 points')
        call t%interpolate(mgdt_interpolate_linear, mgdt_outside_none, two(:1, :), places, two_at, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'it must be 1')
        call t%interpolate(mgdt_interpolate_linear, mgdt_outside_none, one, places(:2, :), at, stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'xyz has extent 2')
        call t%interpolate(11, mgdt_outside_none, one, places, at, stat, msg)
        call expect_error(stat, mgdt_err_unknown_key, msg, 'there is no method 11')
        call t%get_gradients(two, two_slopes(:, :1, :), stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'in dimension 2')
        call t%get_gradients(one, slopes(:, :n - 1), stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'gradients has room for')
    end subroutine

    subroutine test_vertex_tetrahedra()
        integer(int32) :: offsets(n + 1), list(4*nt)
        integer(int64) :: offsets_64(n + 1), list_64(4*nt)
        integer :: i, k
        logical :: around, ascending

        call t%get_vertex_tetrahedra(offsets, list)
        call t%get_vertex_tetrahedra(offsets_64, list_64)
        call expect(all(offsets == offsets_64) .and. all(list == list_64), 'lists of both kinds')
        call expect(offsets(1) == 1 .and. offsets(n + 1) == 4*nt + 1, 'ends of the list')
        around = .true.
        ascending = .true.
        do i = 1, n
            do k = offsets(i), offsets(i + 1) - 1
                around = around .and. any(tets(:, list(k)) == i)
                if (k > offsets(i)) ascending = ascending .and. list(k - 1) < list(k)
            end do
        end do
        call expect(around, 'the tetrahedra of a point have it as a vertex')
        call expect(ascending, 'the list is ascending')
    end subroutine

    subroutine test_kinds_and_ranks()
        integer(int32), allocatable :: a2(:, :), a1(:)
        integer(int64), allocatable :: b2(:, :), b1(:)

        allocate (a2(4, nt), a1(4*nt), b2(4, nt), b1(4*nt))
        call t%get_tetrahedra(a2)
        call t%get_tetrahedra(a1)
        call t%get_tetrahedra(b2)
        call t%get_tetrahedra(b1)
        call expect(same(a2, a1, b2, b1), 'tetrahedra of each kind and rank')
        call t%get_neighbors(a2)
        call t%get_neighbors(a1)
        call t%get_neighbors(b2)
        call t%get_neighbors(b1)
        call expect(same(a2, a1, b2, b1), 'neighbours of each kind and rank')
        deallocate (a2, a1, b2, b1)
        allocate (a2(3, nf), a1(3*nf), b2(3, nf), b1(3*nf))
        call t%get_hull_facets(a2)
        call t%get_hull_facets(a1)
        call t%get_hull_facets(b2)
        call t%get_hull_facets(b1)
        call expect(same(a2, a1, b2, b1), 'hull facets of each kind and rank')
        deallocate (a2, a1, b2, b1)
        allocate (a2(2, ne), a1(2*ne), b2(2, ne), b1(2*ne))
        call t%get_edges(a2)
        call t%get_edges(a1)
        call t%get_edges(b2)
        call t%get_edges(b1)
        call expect(same(a2, a1, b2, b1), 'edges of each kind and rank')
    end subroutine

    logical function same(a2, a1, b2, b1)
        integer(int32), intent(in) :: a2(:, :), a1(:)
        integer(int64), intent(in) :: b2(:, :), b1(:)

        same = minval(a2) >= 0 .and. maxval(a2) > 1 .and. all(reshape(a2, shape(a1)) == a1) &
               .and. all(a2 == b2) .and. all(a1 == b1)
    end function

    ! Sections that are not contiguous come back through a copy that the compiler makes.
    subroutine test_larger_arrays_and_sections()
        integer(int32), allocatable :: rows(:, :), columns(:, :), one(:)
        integer(int64), allocatable :: larger(:, :)
        integer :: stat

        allocate (larger(4, nt + 7), source=-5_int64)
        call t%get_tetrahedra(larger)
        call expect(all(larger(:, :nt) == tets), 'a larger array')
        call expect(all(larger(:, nt + 1:) == -5), 'the rest of a larger array is not touched')

        allocate (rows(6, nt), source=-5_int32)
        call t%get_tetrahedra(rows(2:5, :))
        call expect(all(rows(2:5, :) == tets) .and. all(rows([1, 6], :) == -5), 'a section of rows')
        allocate (columns(4, 2*nt), source=-5_int32)
        call t%get_tetrahedra(columns(:, 2::2))
        call expect(all(columns(:, 2::2) == tets) .and. all(columns(:, 1::2) == -5), 'every other column')
        allocate (one(8*nt), source=-5_int32)
        call t%get_tetrahedra(one(1::2))
        call expect(all(one(1::2) == reshape(tets, [4*nt])) .and. all(one(2::2) == -5), &
                    'every other element')
        one = -5
        call t%get_tetrahedra(one(1:8*int(nt) - 8:2), stat=stat)
        call expect(stat == mgdt_err_buffer_too_small .and. all(one == -5), &
                    'a section that is too small is not touched')
    end subroutine

    subroutine test_base_0()
        integer(int32) :: from_0(4, nt), neighbors(4, nt), map(n)

        call t%set_index_base(0)
        call t%get_tetrahedra(from_0)
        call expect(all(from_0 == tets - 1), 'tetrahedra with base 0')
        call t%get_neighbors(neighbors)
        call expect(minval(neighbors) == -1 .and. count(neighbors == -1) == nf, 'none with base 0')
        call t%get_point_map(map)
        call expect(minval(map) == 0, 'point map with base 0')
        call t%set_index_base(1)
    end subroutine

    ! One that was never used exports what an empty one does.
    subroutine test_empty()
        type(mgdt_triangulation) :: empty
        integer(int32) :: none(4, 0), offsets(1), list(0), found
        integer(int64) :: map(0)
        integer :: stats(6)

        call empty%get_tetrahedra(none, stat=stats(1))
        call empty%get_point_map(map, stat=stats(2))
        offsets = -5
        call empty%get_vertex_tetrahedra(offsets, list, stat=stats(3))
        call expect(offsets(1) == 1, 'the empty list')
        call empty%check(mgdt_check_canonical, stat=stats(4))
        found = -5
        call empty%locate(xyz(:, 1), found, stat=stats(5))
        call expect(found == 0, 'nothing is found in an empty triangulation')
        found = -5
        call empty%nearest_vertex(xyz(:, 1), found, stat=stats(6))
        call expect(found == 0, 'nothing is near in an empty triangulation')
        call expect(all(stats == mgdt_ok), 'an empty triangulation')
        call expect(empty%tetrahedron_count() == 0 .and. empty%edge_count() == 0, 'counts of nothing')
    end subroutine
end program
