! SPDX-License-Identifier: MIT
! What must stop the program with a message: the argument says which. If it does not stop, it ends
! with success, which the script takes for a failure.
program test_stop
    use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
    use checks
    use mgdt
    implicit none

    type :: model
        type(mgdt_triangulation) :: mesh
    end type
    real(real64) :: xyz(3, 20)
    type(mgdt_triangulation) :: a, b, many(2)
    type(model) :: m, other
    character(40) :: what
    character(100) :: msg

    call get_command_argument(1, what)
    call make_points(xyz)
    call a%insert(xyz)
    select case (what)
    case ('no stat')
        xyz(2, 7) = ieee_value(1._real64, ieee_quiet_nan)
        call a%insert(xyz)
    case ('errmsg alone')
        call a%set_index_base(2, errmsg=msg)
    case ('shape')
        call a%insert(xyz(:2, :))
    case ('assignment')
        b = a
    case ('assignment of an array')
        call many(2)%insert(xyz)
        many = many(2:1:-1)
    case ('assignment of a record')
        call m%mesh%insert(xyz)
        other = m
    case default
        error stop 'no such test'
    end select
    print '(a)', 'still running', b%point_count(), other%mesh%point_count()
end program
