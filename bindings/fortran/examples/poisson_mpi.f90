! SPDX-License-Identifier: MIT
! Poisson's equation on ranks of MPI: linear elements on the tetrahedra of points that are spread
! over the ranks, solved by conjugate gradients with the diagonal as preconditioner, which slivers need.
!
!   -(u_xx + u_yy + u_zz) = f in the unit cube, u = 0 on its faces,
!   u = sin(pi x) sin(pi y) sin(pi z)
!
! Each rank has all tetrahedra at its own vertices, so it assembles its own rows without a message.
! Before each product with the matrix the ranks tell each other the values of ghosts.
module ghosts
    use mpi_f08
    use, intrinsic :: iso_fortran_env, only: int64, real64
    implicit none

    ! Whom this rank sends which of its vertices, and from whom its ghosts come: they are in
    ! ascending order of their numbers, so those of one owner follow one another.
    type :: halo
        integer, allocatable :: out_count(:), out_place(:), in_count(:), in_place(:), sent(:)
    end type

contains

    subroutine find_halo(numbers, ranges, own, h)
        integer(int64), intent(in) :: numbers(:), ranges(0:)
        integer, intent(in) :: own
        type(halo), intent(out) :: h
        integer(int64), allocatable :: wanted(:)
        integer :: ranks, rank, r, i

        ranks = size(ranges) - 1
        call MPI_Comm_rank(MPI_COMM_WORLD, rank)
        allocate (h%in_count(ranks), h%in_place(ranks), h%out_count(ranks), h%out_place(ranks))
        h%in_count = 0
        r = 1
        do i = own + 1, size(numbers)
            do while (numbers(i) >= ranges(r))
                r = r + 1
            end do
            h%in_count(r) = h%in_count(r) + 1
        end do
        call MPI_Alltoall(h%in_count, 1, MPI_INTEGER, h%out_count, 1, MPI_INTEGER, MPI_COMM_WORLD)
        h%in_place(1) = 0
        h%out_place(1) = 0
        do r = 2, ranks
            h%in_place(r) = h%in_place(r - 1) + h%in_count(r - 1)
            h%out_place(r) = h%out_place(r - 1) + h%out_count(r - 1)
        end do
        allocate (wanted(sum(h%out_count)), h%sent(sum(h%out_count)))
        call MPI_Alltoallv(numbers(own + 1:), h%in_count, h%in_place, MPI_INTEGER8, &
                           wanted, h%out_count, h%out_place, MPI_INTEGER8, MPI_COMM_WORLD)
        h%sent = int(wanted - ranges(rank)) + 1
    end subroutine

    ! Values of own vertices come first in v; those of ghosts are filled in.
    subroutine update(v, own, h)
        real(real64), intent(inout) :: v(:)
        integer, intent(in) :: own
        type(halo), intent(in) :: h
        real(real64), allocatable :: out(:), in(:)

        allocate (out(size(h%sent)), in(size(v) - own))
        out = v(h%sent)
        call MPI_Alltoallv(out, h%out_count, h%out_place, MPI_DOUBLE_PRECISION, &
                           in, h%in_count, h%in_place, MPI_DOUBLE_PRECISION, MPI_COMM_WORLD)
        v(own + 1:) = in
    end subroutine

    function product_of(a, b) result(all)
        real(real64), intent(in) :: a(:), b(:)
        real(real64) :: all, mine

        mine = dot_product(a, b)
        call MPI_Allreduce(mine, all, 1, MPI_DOUBLE_PRECISION, MPI_SUM, MPI_COMM_WORLD)
    end function
end module ghosts

program poisson_mpi
    use mpi_f08
    use mgdt_mpi
    use ghosts
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    implicit none

    integer, parameter :: n = 12000
    real(real64), parameter :: pi = acos(-1d0)
    type(mgdt_parts_triangulation) :: mesh
    type(halo) :: h
    integer(int64), allocatable :: numbers(:), ranges(:)
    integer(int32), allocatable :: corners(:, :)
    real(real64), allocatable :: points(:, :), xyz(:, :), gradients(:, :, :), volume(:), b(:), &
                                 diagonal(:), u(:), r(:), p(:), q(:)
    logical, allocatable :: is_fixed(:)
    integer :: rank, ranks, own, i, k, t, iteration
    real(real64) :: rz, before, alpha, error, x(3)

    call MPI_Init()
    call MPI_Comm_rank(MPI_COMM_WORLD, rank)
    call MPI_Comm_size(MPI_COMM_WORLD, ranks)

    ! Every rank gives some of the points: a third is on the faces of the cube.
    allocate (points(3, n/ranks + 1))
    k = 0
    do i = 1, n
        x = [spread_out(i, 2), spread_out(i, 3), spread_out(i, 5)]
        if (i <= 8) x = merge(1d0, 0d0, btest(i, [0, 1, 2]))
        if (i > 8 .and. mod(i, 3) == 0) x(1 + mod(i/3, 3)) = merge(0d0, 1d0, btest(i/9, 0))
        if (mod(i, ranks) /= rank) cycle
        k = k + 1
        points(:, k) = x
    end do

    call mgdt_mpi_create(mesh, MPI_COMM_WORLD%MPI_VAL)
    call mesh%insert(points(:, :k))
    call mesh%build()
    call mesh%get(mgdt_parts_local_corners, corners)
    call mesh%get(mgdt_parts_vertex_numbers, numbers)
    call mesh%get(mgdt_parts_vertex_ranges, ranges)
    call mesh%get_coordinates(xyz)
    own = int(mesh%number(mgdt_parts_own_vertices))
    call find_halo(numbers, ranges, own, h)

    ! Gradients of the linear functions, and a load that is equal in parts at the corners.
    allocate (gradients(3, 4, size(corners, 2)), volume(size(corners, 2)))
    allocate (b(size(numbers)), diagonal(size(numbers)), is_fixed(size(numbers)))
    b = 0
    diagonal = 0
    do i = 1, size(numbers)
        is_fixed(i) = any(xyz(:, i) == 0) .or. any(xyz(:, i) == 1)
    end do
    do t = 1, size(corners, 2)
        call element(xyz(:, corners(:, t)), gradients(:, :, t), volume(t))
        b(corners(:, t)) = b(corners(:, t)) + volume(t)/4* &
                           3*pi**2*product(sin(pi*xyz(:, corners(:, t))), 1)
        diagonal(corners(:, t)) = diagonal(corners(:, t)) + &
                                  volume(t)*sum(gradients(:, :, t)**2, 1)
    end do
    where (is_fixed) b = 0

    ! Conjugate gradients, for the own vertices.
    allocate (u(size(numbers)), p(size(numbers)), q(size(numbers)), r(own))
    u = 0
    r = b(:own)
    p = 0
    p(:own) = r/diagonal(:own)
    rz = product_of(r, p(:own))
    do iteration = 1, 1000
        call update(p, own, h)
        q = 0
        do t = 1, size(corners, 2)
            x = matmul(gradients(:, :, t), p(corners(:, t)))*volume(t)
            q(corners(:, t)) = q(corners(:, t)) + matmul(x, gradients(:, :, t))
        end do
        where (is_fixed) q = 0
        alpha = rz/product_of(p(:own), q(:own))
        u(:own) = u(:own) + alpha*p(:own)
        r = r - alpha*q(:own)
        before = rz
        rz = product_of(r, r/diagonal(:own))
        if (rz < 1d-24) exit
        p(:own) = r/diagonal(:own) + rz/before*p(:own)
    end do

    do i = 1, own
        r(i) = u(i) - product(sin(pi*xyz(:, i)))
    end do
    error = sqrt(product_of(r, r)/mesh%number(mgdt_parts_all_vertices))
    if (rank == 0) print '(i0, a, i0, a, f10.8)', ranks, ' ranks: ', &
        mesh%number(mgdt_parts_all_tetrahedra), ' tetrahedra, mean error ', error
    call mesh%destroy()
    call MPI_Finalize()

contains

    ! The digits of i behind the point, in reverse.
    pure function spread_out(i, base) result(x)
        integer, intent(in) :: i, base
        real(real64) :: x, digit
        integer :: rest

        x = 0
        digit = 1
        rest = i
        do while (rest > 0)
            digit = digit/base
            x = x + digit*mod(rest, base)
            rest = rest/base
        end do
    end function

    ! The gradients of the four functions that are 1 at a corner and 0 at the others.
    pure subroutine element(x, g, v)
        real(real64), intent(in) :: x(3, 4)
        real(real64), intent(out) :: g(3, 4), v
        real(real64) :: a(3), b(3), c(3), six

        a = x(:, 2) - x(:, 1)
        b = x(:, 3) - x(:, 1)
        c = x(:, 4) - x(:, 1)
        six = dot_product(cross(a, b), c)
        v = six/6
        g(:, 2) = cross(b, c)/six
        g(:, 3) = cross(c, a)/six
        g(:, 4) = cross(a, b)/six
        g(:, 1) = -g(:, 2) - g(:, 3) - g(:, 4)
    end subroutine

    pure function cross(a, b) result(c)
        real(real64), intent(in) :: a(3), b(3)
        real(real64) :: c(3)

        c = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
    end function
end program
