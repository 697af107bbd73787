! SPDX-License-Identifier: MIT
! Module mgdt_parts in one process: parts by their numbers, all at once and one after another.
program test_parts
    use mgdt, only: mgdt_triangulation
    use mgdt_parts
    use, intrinsic :: iso_c_binding, only: c_int32_t, c_null_ptr
    use, intrinsic :: iso_fortran_env, only: int32, int64, real64
    use checks
    implicit none

    integer, parameter :: n = 600, parts = 3
    type(mgdt_triangulation) :: one
    type(mgdt_parts_triangulation) :: t, unmade
    real(real64) :: xyz(3, n)
    real(real64), allocatable :: at(:, :)
    integer(int64), allocatable :: numbers(:), ids(:), rows(:, :)
    integer(int32), allocatable :: short(:), short_rows(:, :)
    integer :: i, part, stat, looks, ends(0:parts)
    integer(int64) :: owned
    character(200) :: message

    call make_points(xyz)
    call one%insert(xyz)
    ends = [(n*i/parts, i=0, parts)]
    call expect(.not. t%is_created(), 'not created')
    call t%create(parts)
    call expect(t%is_created(), 'created')
    do part = 0, parts - 1
        associate (first => ends(part) + 1, last => ends(part + 1))
            select case (part)
            case (0)
                call t%insert(xyz(:, first:last), [(i, i=first, last)], part=part)
            case (1)
                call t%insert(xyz(:, first:last), [(int(i, int64), i=first, last)], part=part)
            case default
                call t%insert([xyz(:, first:last)], stat=stat, part=part)
                call expect(stat == mgdt_ok, 'points without ids')
                call t%build(stat, message)
                call expect_error(stat, mgdt_err_invalid_argument, message, 'no ids')
                call t%clear()
            end select
        end associate
    end do
    do part = 0, parts - 1
        call t%insert(xyz(:, ends(part) + 1:ends(part + 1)), part=part)
    end do
    call t%build()
    call t%check()
    call expect(t%number(mgdt_parts_parts, part=0) == parts, 'parts')
    owned = 0
    do part = 0, parts - 1
        owned = owned + t%number(mgdt_parts_own_tetrahedra, part=part)
        call t%get(mgdt_parts_vertex_ids, ids, part=part)
        call t%get(mgdt_parts_vertex_ids, short, part=part)
        call t%get_coordinates(at, part=part)
        call expect(all(abs(at - xyz(:, ids)) <= 0) &
                    .and. all(ids == short), 'ids of vertices')
        call t%get(mgdt_parts_corners, rows, part=part)
        call t%get(mgdt_parts_corners, short_rows, part=part)
        call expect(size(rows, 1) == 4 .and. all(rows == short_rows), 'corners')
        call t%get(mgdt_parts_point_map, numbers, part=part)
        call expect(size(numbers) == ends(part + 1) - ends(part), 'a vertex for each point')
    end do
    call expect(owned == one%tetrahedron_count(), 'each tetrahedron is owned once')

    ! One part after another.
    looks = 0
    owned = 0
    call t%build_each(look)
    call expect(looks == parts .and. owned == one%tetrahedron_count(), 'all parts were shown')
    call t%build_each(look_at_one, stat, message)
    call expect_error(stat, mgdt_err_cancelled, message, 'cancelled by the look')

    ! Which part is meant has to be said, and C's refusals come through.
    call t%insert(xyz, stat, message)
    call expect_error(stat, mgdt_err_invalid_argument, message, 'a process with one part')
    call t%insert(xyz, stat, message, part=parts)
    call expect_error(stat, mgdt_err_invalid_argument, message, 'part 3 is not among those')
    call t%get(mgdt_parts_vertex_ids, rows, stat, message, part=0)
    call expect_error(stat, mgdt_err_invalid_argument, message, 'no four numbers')
    call t%create(parts, stat, message)
    call expect_error(stat, mgdt_err_invalid_argument, message, 'made already')
    call t%adopt('taking', c_null_ptr, int(mgdt_ok, c_int32_t), stat, message)
    call expect_error(stat, mgdt_err_invalid_argument, message, 'made already')
    call unmade%create(0, stat, message)
    call expect_error(stat, mgdt_err_invalid_argument, message, 'out of its range')
    call unmade%get(mgdt_parts_vertex_ids, ids, stat, message)
    call expect_error(stat, mgdt_err_null_pointer, message, 'has not been created')
    call unmade%create(1)
    call unmade%insert(xyz)
    call unmade%build()
    call expect(unmade%number(mgdt_parts_own_tetrahedra) == one%tetrahedron_count(), &
                'a single part needs no number')
    ! What a main program holds at its end would look like a leak.
    call t%destroy()
    call unmade%destroy()
    call one%destroy()
    deallocate (at, numbers, ids, rows, short, short_rows)
    call conclude()

contains

    subroutine look(found, part, cancel)
        class(mgdt_parts_triangulation), intent(in) :: found
        integer, intent(in) :: part
        logical, intent(inout) :: cancel

        if (.not. cancel) looks = looks + 1
        owned = owned + found%number(mgdt_parts_own_tetrahedra, part=part)
    end subroutine

    subroutine look_at_one(found, part, cancel)
        class(mgdt_parts_triangulation), intent(in) :: found
        integer, intent(in) :: part
        logical, intent(inout) :: cancel

        cancel = found%is_created() .and. part == 0
    end subroutine
end program
