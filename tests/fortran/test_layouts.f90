! SPDX-License-Identifier: MIT
! Exported arrays in other layouts than C's: the transposition by itself, at all sizes around its
! blocks; then arrays (n, 4), sections with strides and pointers against arrays (4, n).
program test_layouts
    use checks
    use mgdt
    use mgdt_layout, only: place_records, transpose_records
    implicit none

    integer, parameter :: n = 400
    type(mgdt_triangulation) :: t
    real(real64) :: xyz(3, n)
    integer(int64) :: nt, nf, ne

    call test_transposition()
    call make_points(xyz)
    call t%insert(xyz)
    nt = t%tetrahedron_count()
    nf = t%hull_facet_count()
    ne = t%edge_count()
    call expect(nt > 1024, 'more tetrahedra than a few blocks')
    call test_columns_i32()
    call test_columns_i64()
    call test_sections()
    call test_pointers_and_components()
    call test_rank_1()
    call test_refused()
    call conclude()

contains

    subroutine test_transposition()
        integer(int64) :: width, records, spare
        logical :: right

        right = .true.
        do width = 2, 4
            do records = 0, 1600
                if (records > 20 .and. mod(records, 256_int64) > 1 .and. &
                    mod(records, 101_int64) > 0) cycle
                do spare = 0, 700, 350
                    if (.not. transposes(width, records, records + spare)) right = .false.
                end do
            end do
        end do
        call expect(right, 'transposition of every size')
    end subroutine

    function transposes(width, records, ld) result(right)
        integer(int64), intent(in) :: width, records, ld
        logical :: right
        integer(int32), allocatable :: v(:), from(:)
        integer(int64), allocatable :: w(:)
        integer(int64) :: i, k

        allocate (v(width*ld + 5), w(width*ld + 5), from(width*records))
        v = -5
        do i = 1, width*records
            from(i) = int(i, int32)
            v(i) = from(i)
        end do
        w = v
        call transpose_records(v, width, records, ld)
        call transpose_records(w, width, records, ld)
        right = all(v(width*ld + 1:) == -5) .and. all(w == v)
        do k = 1, width
            do i = 1, records
                right = right .and. v((k - 1)*ld + i) == width*(i - 1) + k
            end do
        end do
        v = -5
        call place_records(from, width, records, v, 1_int64, ld)
        do k = 1, width
            right = right .and. all(v((k - 1)*ld + records + 1:k*ld) == -5)
            do i = 1, records
                right = right .and. v((k - 1)*ld + i) == width*(i - 1) + k
            end do
        end do
        w = -5
        call place_records(int(from, int64), width, records, w, width, 1_int64)
        right = right .and. all(w(:width*records) == from) .and. all(w(width*records + 1:) == -5)
    end function

    ! Of just the size that is needed, and larger.
    subroutine test_columns_i32()
        integer(int32), allocatable :: rows(:, :), columns(:, :), larger(:, :)

        allocate (rows(4, nt), columns(nt, 4), larger(nt + 300, 4), source=-5_int32)
        call t%get_tetrahedra(rows)
        call t%get_tetrahedra(columns, dim=2)
        call t%get_tetrahedra(larger, dim=2)
        call expect(agree(rows, columns, larger), 'tetrahedra(n, 4)')
        call t%get_neighbors(rows, dim=1)
        call t%get_neighbors(columns, dim=2)
        call t%get_neighbors(larger, dim=2)
        call expect(agree(rows, columns, larger), 'neighbors(n, 4)')
        deallocate (rows, columns, larger)
        allocate (rows(3, nf), columns(nf, 3), larger(nf + 300, 3), source=-5_int32)
        call t%get_hull_facets(rows)
        call t%get_hull_facets(columns, dim=2)
        call t%get_hull_facets(larger, dim=2)
        call expect(agree(rows, columns, larger), 'facets(n, 3)')
        deallocate (rows, columns, larger)
        allocate (rows(2, ne), columns(ne, 2), larger(ne + 300, 2), source=-5_int32)
        call t%get_edges(rows)
        call t%get_edges(columns, dim=2)
        call t%get_edges(larger, dim=2)
        call expect(agree(rows, columns, larger), 'edges(n, 2)')
    end subroutine

    logical function agree(rows, columns, larger)
        integer(int32), intent(in) :: rows(:, :), columns(:, :), larger(:, :)

        agree = all(columns == transpose(rows)) .and. all(larger(:size(rows, 2), :) == columns) &
                .and. all(larger(size(rows, 2) + 1:, :) == -5)
    end function

    subroutine test_columns_i64()
        integer(int32), allocatable :: rows(:, :)
        integer(int64), allocatable :: columns(:, :), larger(:, :)

        allocate (rows(4, nt), columns(nt, 4), larger(nt + 300, 4))
        larger = -5
        call t%get_tetrahedra(rows)
        call t%get_tetrahedra(columns, dim=2)
        call t%get_tetrahedra(larger, dim=2)
        call expect(all(columns == transpose(rows)) .and. all(larger(:nt, :) == columns) .and. &
                    all(larger(nt + 1:, :) == -5), 'tetrahedra(n, 4) of 64 bits')
        call t%get_neighbors(rows)
        call t%get_neighbors(columns, dim=2)
        call expect(all(columns == transpose(rows)), 'neighbors(n, 4) of 64 bits')
        deallocate (rows, columns)
        allocate (rows(3, nf), columns(nf, 3))
        call t%get_hull_facets(rows)
        call t%get_hull_facets(columns, dim=2)
        call expect(all(columns == transpose(rows)), 'facets(n, 3) of 64 bits')
        deallocate (rows, columns)
        allocate (rows(2, ne), columns(ne, 2))
        call t%get_edges(rows)
        call t%get_edges(columns, dim=2)
        call expect(all(columns == transpose(rows)), 'edges(n, 2) of 64 bits')
    end subroutine

    ! Rows and columns of larger arrays, backwards as well. What lies between is not touched.
    subroutine test_sections()
        integer(int32), allocatable :: rows(:, :), wide(:, :), tall(:, :)
        integer(int64), allocatable :: wide_64(:, :), tall_64(:, :)

        allocate (rows(4, nt), wide(9, 2*nt), tall(3*nt, 9))
        call t%get_tetrahedra(rows)
        wide = -5
        tall = -5
        wide_64 = wide
        tall_64 = tall
        call t%get_tetrahedra(wide(2:8:2, 2*nt:1:-2))
        call expect(all(wide(2:8:2, 2*nt:1:-2) == rows), 'every other row and column')
        call expect(count(wide == -5) == size(wide) - size(rows), 'nothing between them')
        call t%get_tetrahedra(tall(nt + 1:2*nt, 9:3:-2), dim=2)
        call expect(all(tall(nt + 1:2*nt, 9:3:-2) == transpose(rows)), 'columns of a table')
        call expect(count(tall == -5) == size(tall) - size(rows), 'nothing beside them')
        call t%get_tetrahedra(wide_64(2:8:2, 2*nt:1:-2))
        call t%get_tetrahedra(tall_64(nt + 1:2*nt, 9:3:-2), dim=2)
        call expect(all(wide_64 == wide) .and. all(tall_64 == tall), 'sections of 64 bits')
    end subroutine

    subroutine test_pointers_and_components()
        type :: element
            integer(int32) :: material
            integer(int32) :: vertex
        end type
        integer(int32), allocatable :: rows(:, :)
        integer(int32), allocatable, target :: table(:, :)
        integer(int32), pointer :: part(:, :), transposed(:, :)
        type(element), allocatable :: elements(:, :)

        allocate (rows(4, nt), table(6, nt), elements(4, nt))
        call t%get_tetrahedra(rows)
        table = -5
        part => table(2:5, :)
        call t%get_tetrahedra(part)
        call expect(all(table(2:5, :) == rows) .and. all(table([1, 6], :) == -5), 'a pointer')
        deallocate (table)
        allocate (table(nt, 6), source=-5_int32)
        transposed => table(:, 6:3:-1)
        call t%get_tetrahedra(transposed, dim=2)
        call expect(all(table(:, 6:3:-1) == transpose(rows)), 'a pointer backwards')
        elements%material = 7
        call t%get_tetrahedra(elements%vertex)
        call expect(all(elements%vertex == rows) .and. all(elements%material == 7), 'components')
    end subroutine

    subroutine test_rank_1()
        integer(int32), allocatable :: rows(:), apart(:)
        integer(int64), allocatable :: apart_64(:)

        allocate (rows(4*nt), apart(12*nt + 9), apart_64(12*nt + 9))
        call t%get_tetrahedra(rows)
        apart = -5
        apart_64 = -5
        call t%get_tetrahedra(apart(12*nt + 9:1:-3))
        call t%get_tetrahedra(apart_64(12*nt + 9:1:-3))
        call expect(all(apart(12*nt + 9:10:-3) == rows), 'every third element backwards')
        call expect(count(apart == -5) == size(apart) - size(rows), 'and no other')
        call expect(all(apart_64 == apart), 'every third element of 64 bits')
    end subroutine

    subroutine test_refused()
        integer(int32), allocatable :: v(:, :), w(:)
        integer :: stat
        character(100) :: msg

        allocate (v(nt, 6), w(8*nt))
        v = -5
        w = -5
        call t%get_tetrahedra(v(:, :4), stat, msg)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'in dimension 1; it must be 4')
        call t%get_tetrahedra(v(:, :5), stat, msg, dim=2)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'extent 5 in dimension 2; it must be 4')
        call t%get_tetrahedra(v(:, :4), stat, msg, dim=3)
        call expect_error(stat, mgdt_err_invalid_argument, msg, 'dim is 3; it must be 1 or 2')
        call t%get_tetrahedra(v(:nt - 1, :4), stat, msg, dim=2)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'are needed')
        call t%get_tetrahedra(v(:nt/2, 1:4), stat, msg, dim=2)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'are needed')
        call t%get_tetrahedra(w(1:8*nt - 8:2), stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'are needed')
        call expect(all(v == -5) .and. all(w == -5), 'not touched')
    end subroutine
end program
