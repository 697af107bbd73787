! SPDX-License-Identifier: MIT
! Adaptive approximation: a function that is linear on each tetrahedron follows a steep spherical
! front. Round by round, each edge in whose middle it is far off gets a point there, and all of them
! go in with one call.
program adaptive
    use, intrinsic :: iso_fortran_env, only: real64
    use mgdt
    implicit none

    integer, parameter :: dp = real64
    real(dp), parameter :: tolerance = 0.02_dp
    integer, parameter :: most_rounds = 30
    type(mgdt_triangulation) :: t
    real(dp), allocatable :: points(:, :), more(:, :), grown(:, :)
    real(dp) :: before, after
    integer :: round

    call make_grid(4, points)
    call t%insert(points)
    before = sampled_error(t, points)
    do round = 1, most_rounds
        more = middles_to_insert(t, points)
        ! Slivers keep a few long edges however many points there are.
        if (100*size(more, 2) < size(points, 2)) exit
        call t%insert(more)
        ! Points are numbered in the order in which they were given, here and in mgdt.
        allocate (grown(3, size(points, 2) + size(more, 2)))
        grown(:, :size(points, 2)) = points
        grown(:, size(points, 2) + 1:) = more
        call move_alloc(grown, points)
        print '(a,i3,2(a,i7),a)', 'round', round, ':', t%vertex_count(), ' points,', &
            t%tetrahedron_count(), ' tetrahedra'
    end do
    if (round > most_rounds) error stop 'there is no end to it'

    call t%check(mgdt_check_canonical)
    print '(a)', 'proved to be the Delaunay triangulation'
    after = sampled_error(t, points)
    print '(2(a,f6.3))', 'largest error at samples: before', before, ', after', after
    if (after > 3*tolerance) error stop 'too far off'

contains

    ! A front of thickness 1/30 around the origin.
    pure function front(p) result(f)
        real(dp), intent(in) :: p(3)
        real(dp) :: f

        f = tanh(30*(norm2(p) - 0.6_dp))
    end function

    ! The middles of the edges in which the mean of the two ends is off by more than the tolerance.
    function middles_to_insert(t, points) result(middles)
        type(mgdt_triangulation), intent(in) :: t
        real(dp), intent(in) :: points(:, :)
        real(dp), allocatable :: middles(:, :)
        real(dp), allocatable :: found(:, :)
        integer, allocatable :: edges(:, :)
        real(dp) :: middle(3)
        integer :: i, n

        allocate (edges(2, t%edge_count()))
        call t%get_edges(edges)
        allocate (found(3, size(edges, 2)))
        n = 0
        do i = 1, size(edges, 2)
            associate (p => points(:, edges(1, i)), q => points(:, edges(2, i)))
                middle = 0.5_dp*(p + q)
                if (abs(front(middle) - 0.5_dp*(front(p) + front(q))) <= tolerance) cycle
            end associate
            n = n + 1
            found(:, n) = middle
        end do
        middles = found(:, :n)
    end function

    ! The largest difference between the front and its interpolation at the points of a fine grid.
    function sampled_error(t, points) result(largest)
        type(mgdt_triangulation), intent(in) :: t
        real(dp), intent(in) :: points(:, :)
        real(dp) :: largest
        real(dp), allocatable :: samples(:, :), weights(:, :)
        integer, allocatable :: tetrahedra(:, :), found(:)
        real(dp) :: interpolated
        integer :: i, k

        call make_grid(37, samples)
        allocate (found(size(samples, 2)), weights(4, size(samples, 2)))
        allocate (tetrahedra(4, t%tetrahedron_count()))
        call t%get_tetrahedra(tetrahedra)
        call t%locate_points(samples, found, weights)
        largest = 0
        do i = 1, size(samples, 2)
            interpolated = 0
            do k = 1, 4
                interpolated = interpolated + weights(k, i)*front(points(:, tetrahedra(k, found(i))))
            end do
            largest = max(largest, abs(interpolated - front(samples(:, i))))
        end do
    end function

    ! The points of a grid of n cells a side in the unit cube.
    pure subroutine make_grid(n, points)
        integer, intent(in) :: n
        real(dp), allocatable, intent(out) :: points(:, :)
        integer :: i, j, k

        allocate (points(3, (n + 1)**3))
        do concurrent(i=0:n, j=0:n, k=0:n)
            points(:, 1 + i + (n + 1)*(j + (n + 1)*k)) = real([i, j, k], dp)/n
        end do
    end subroutine
end program
