! SPDX-License-Identifier: MIT
! Progress of a running call, and sizes that a mesh is refined to: what the caller writes, and how C
! reaches it.
module mgdt_callbacks
    use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int32_t, c_int64_t, c_ptr
    use, intrinsic :: iso_fortran_env, only: real64
    implicit none
    private
    public :: mgdt_progress, mgdt_observer, progress_box, relay
    public :: mgdt_size_function, size_box, relay_sizes

    abstract interface
        ! Hears of the running call on the thread that made it, about a hundred times; fraction goes
        ! from 0 to 1. Set cancel to .true. to stop the call. It must not touch the triangulation,
        ! except for t%cancel().
        subroutine mgdt_progress(fraction, cancel)
            import :: real64
            real(real64), intent(in) :: fraction
            logical, intent(inout) :: cancel
        end subroutine
    end interface

    ! The same with data of its own: extend this type by what report needs.
    type, abstract :: mgdt_observer
    contains
        procedure(mgdt_observer_report), deferred :: report
    end type

    abstract interface
        subroutine mgdt_observer_report(self, fraction, cancel)
            import :: mgdt_observer, real64
            class(mgdt_observer), intent(inout) :: self
            real(real64), intent(in) :: fraction
            logical, intent(inout) :: cancel
        end subroutine
    end interface

    ! Either of them, at an address that stays while the triangulation moves.
    type :: progress_box
        procedure(mgdt_progress), pointer, nopass :: report => null()
        class(mgdt_observer), pointer :: observer => null()
    end type

    abstract interface
        ! Sets the sizes(n) of edges that are wanted at places xyz(3, n); 0, which they are before,
        ! for none. Set cancel to .true. to stop the call. It must not touch the mesh, except for
        ! m%cancel(). Since 1.4.
        subroutine mgdt_size_function(xyz, sizes, cancel)
            import :: real64
            real(real64), intent(in) :: xyz(:, :)
            real(real64), intent(inout) :: sizes(:)
            logical, intent(inout) :: cancel
        end subroutine
    end interface

    type :: size_box
        procedure(mgdt_size_function), pointer, nopass :: find => null()
    end type

contains

    function relay(fraction, user) result(stop_asked) bind(c, name='')
        real(c_double), value :: fraction
        type(c_ptr), value :: user
        integer(c_int32_t) :: stop_asked
        type(progress_box), pointer :: box
        logical :: cancel

        call c_f_pointer(user, box)
        cancel = .false.
        if (associated(box%observer)) then
            call box%observer%report(fraction, cancel)
        else if (associated(box%report)) then
            call box%report(fraction, cancel)
        end if
        stop_asked = merge(1_c_int32_t, 0_c_int32_t, cancel)
    end function

    function relay_sizes(n, xyz, sizes, user) result(stop_asked) bind(c, name='')
        integer(c_int64_t), value :: n
        real(c_double), intent(in) :: xyz(3, n)
        real(c_double), intent(inout) :: sizes(n)
        type(c_ptr), value :: user
        integer(c_int32_t) :: stop_asked
        type(size_box), pointer :: box
        logical :: cancel

        call c_f_pointer(user, box)
        cancel = .false.
        call box%find(xyz, sizes, cancel)
        stop_asked = merge(1_c_int32_t, 0_c_int32_t, cancel)
    end function
end module mgdt_callbacks
