! SPDX-License-Identifier: MIT
! Making, freeing, moving; progress and cancelling. The allocator counts what is not freed; the
! script runs this under Valgrind too.
module life_support
    use, intrinsic :: iso_c_binding, only: c_funloc, c_funptr, c_int64_t, c_loc, c_ptr, c_size_t
    use checks
    use mgdt
    implicit none

    integer, parameter :: n = 3000
    real(real64) :: xyz(3, n)
    integer(c_int64_t), target :: held = 0

    interface
        function counting_alloc(size, align, user) result(p) bind(c)
            import :: c_ptr, c_size_t
            integer(c_size_t), value :: size, align
            type(c_ptr), value :: user
            type(c_ptr) :: p
        end function
        subroutine counting_free(p, size, align, user) bind(c)
            import :: c_ptr, c_size_t
            type(c_ptr), value :: p, user
            integer(c_size_t), value :: size, align
        end subroutine
    end interface

    type :: model
        integer :: number = 0
        type(mgdt_triangulation) :: mesh
    end type

    type, extends(mgdt_observer) :: watcher
        integer :: calls = 0
        real(real64) :: last = -1, stop_at = 2
        logical :: rising = .true.
    contains
        procedure :: report
    end type

    ! Calls its own triangulation, which is busy.
    type, extends(mgdt_observer) :: intruder
        type(mgdt_triangulation), pointer :: mesh => null()
        integer :: calls = 0, refused = 0
    contains
        procedure :: report => intrude
    end type

    integer :: plain_calls = 0

contains

    subroutine intrude(self, fraction, cancel)
        class(intruder), intent(inout) :: self
        real(real64), intent(in) :: fraction
        logical, intent(inout) :: cancel
        integer(int32) :: map(n)
        integer :: stat
        character(100) :: msg

        self%calls = self%calls + 1
        if (fraction < 0 .or. cancel) return
        msg = ''
        call self%mesh%insert(xyz, stat, msg)
        if (stat == mgdt_err_busy .and. index(msg, 'busy') > 0) self%refused = self%refused + 1
        call self%mesh%clear(stat)
        if (stat == mgdt_err_busy) self%refused = self%refused + 1
        call self%mesh%set_progress(plain_report, stat)
        if (stat == mgdt_err_busy) self%refused = self%refused + 1
        call self%mesh%remove_progress(stat)
        if (stat == mgdt_err_busy) self%refused = self%refused + 1
        call self%mesh%get_point_map(map, stat)
        if (stat == mgdt_err_busy) self%refused = self%refused + 1
        call self%mesh%destroy() ! ignored
        if (self%mesh%point_count() == 0) self%refused = self%refused + 1
    end subroutine

    subroutine report(self, fraction, cancel)
        class(watcher), intent(inout) :: self
        real(real64), intent(in) :: fraction
        logical, intent(inout) :: cancel

        self%calls = self%calls + 1
        self%rising = self%rising .and. fraction >= self%last .and. fraction <= 1
        self%last = fraction
        cancel = fraction >= self%stop_at
    end subroutine

    subroutine plain_report(fraction, cancel)
        real(real64), intent(in) :: fraction
        logical, intent(inout) :: cancel

        if (fraction >= 0 .and. .not. cancel) plain_calls = plain_calls + 1
    end subroutine

    subroutine create_counting(t)
        class(mgdt_triangulation), intent(inout) :: t
        type(c_funptr) :: alloc, release

        alloc = c_funloc(counting_alloc)
        release = c_funloc(counting_free)
        call t%create(alloc, release, c_loc(held))
    end subroutine

    subroutine fill(t)
        type(mgdt_triangulation), intent(inout) :: t

        call create_counting(t)
        call t%insert(xyz)
        call expect(held > 0, 'the allocator is used')
    end subroutine

    subroutine expect_freed(what)
        character(*), intent(in) :: what

        call expect(held == 0, 'freed: '//what)
        held = 0
    end subroutine

    subroutine local_variable()
        type(mgdt_triangulation) :: t

        call fill(t)
    end subroutine

    subroutine local_array()
        type(mgdt_triangulation) :: many(3)

        call fill(many(1))
        call fill(many(3))
    end subroutine

    subroutine local_component()
        type(model) :: m

        call fill(m%mesh)
    end subroutine

    subroutine renew(t)
        type(mgdt_triangulation), intent(out) :: t

        call expect(t%point_count() == 0, 'intent(out) gives an empty one')
    end subroutine
end module life_support

program test_life
    use life_support
    implicit none

    call make_points(xyz)
    call test_finalizer()
    call test_destroy()
    call test_move()
    call test_assignment()
    call test_half_an_allocator()
    call test_progress()
    call test_cancel()
    call test_busy()
    call conclude()

contains

    subroutine test_finalizer()
        type(mgdt_triangulation), allocatable :: one, many(:)
        class(mgdt_triangulation), allocatable :: any_one
        type(model), allocatable :: m
        type(mgdt_triangulation) :: renewed

        call local_variable()
        call expect_freed('a local variable')
        call local_array()
        call expect_freed('an array')
        call local_component()
        call expect_freed('a component')
        allocate (one, many(2), any_one, m)
        call fill(one)
        deallocate (one)
        call expect_freed('an allocatable')
        call fill(many(2))
        deallocate (many)
        call expect_freed('an allocatable array')
        call create_counting(any_one)
        call any_one%insert(xyz)
        deallocate (any_one)
        call expect_freed('a polymorphic allocatable')
        call fill(m%mesh)
        deallocate (m)
        call expect_freed('an allocatable with a component')
        call fill(renewed)
        call renew(renewed)
        call expect_freed('intent(out)')
    end subroutine

    subroutine test_destroy()
        type(mgdt_triangulation) :: t, many(2)

        call fill(t)
        call t%destroy()
        call expect_freed('destroy')
        call t%destroy()
        call expect(t%point_count() == 0, 'empty after destroy')
        call expect(t%get_error() == '', 'no error after destroy')
        call expect(t%isa_name() == '', 'no instruction set after destroy')
        call t%insert(xyz)
        call expect(t%point_count() == n, 'used again after destroy')
        call fill(many(1))
        call expect(all(many%point_count() == [n, 0]), 'counts of an array')
        call many%destroy()
        call expect_freed('destroy of an array')
    end subroutine

    subroutine test_move()
        type(mgdt_triangulation) :: a, b
        type(watcher), target :: w
        integer(c_int64_t) :: held_by_b

        call fill(b)
        call b%set_progress(w)
        held_by_b = held
        call a%insert(xyz(:, :100))
        call a%move_from(b)
        call expect(held == held_by_b .and. a%point_count() == n, 'moved')
        call expect(b%point_count() == 0, 'the source is empty')
        call a%insert(xyz(:, :50))
        call expect(w%calls > 0, 'the observer moves too')
        call b%insert(xyz(:, :100))
        call expect(b%point_count() == 100, 'the source can be used')
        call a%move_from(b)
        call expect_freed('what was there before the move')
        call b%destroy()
        call expect(a%point_count() == 100, 'the target keeps what was moved')
    end subroutine

    ! What can be assigned: triangulations that were never used, and records that hold one.
    subroutine test_assignment()
        type(mgdt_triangulation) :: a, unused
        type(model) :: m, other

        call fill(a)
        a = unused
        call expect_freed('assignment of an unused one')
        call fill(a)
        a = mgdt_triangulation()
        call expect_freed('assignment of a new one')
        call expect(a%point_count() == 0, 'empty after it')
        call fill(m%mesh)
        other%number = 3
        m = other
        call expect_freed('assignment of a record')
        call expect(m%number == 3 .and. m%mesh%point_count() == 0, 'the record')
    end subroutine

    subroutine test_half_an_allocator()
        type(mgdt_triangulation) :: t
        type(c_funptr) :: alloc
        integer :: stat
        character(100) :: msg

        alloc = c_funloc(counting_alloc)
        call t%create(alloc=alloc, stat=stat, errmsg=msg)
        call expect(stat == mgdt_err_invalid_argument .and. msg /= '', 'alloc without release')
        call t%insert(xyz)
        call expect(t%point_count() == n, 'usable after that')
    end subroutine

    subroutine test_progress()
        type(mgdt_triangulation) :: t
        type(watcher), target :: w

        call t%set_progress(plain_report)
        call t%insert(xyz)
        call expect(plain_calls >= 10, 'a procedure hears of progress')
        call t%clear()
        plain_calls = 0
        call t%set_progress(w)
        call t%insert(xyz)
        call expect(w%calls >= 10 .and. w%rising .and. plain_calls == 0, 'an observer does')
        call t%clear()
        call t%remove_progress()
        w%calls = 0
        call t%insert(xyz)
        call expect(w%calls == 0 .and. plain_calls == 0, 'nobody does')
    end subroutine

    ! What calls its own triangulation while that is being changed is refused, and harms nothing.
    subroutine test_busy()
        type(mgdt_triangulation), target :: t
        type(intruder), target :: i

        i%mesh => t
        plain_calls = 0
        call create_counting(t)
        call t%set_progress(i)
        call t%insert(xyz)
        call expect(i%calls >= 10 .and. i%refused == 6*i%calls, 'a call in a call is refused')
        call expect(t%point_count() == n .and. plain_calls == 0, 'and changes nothing')
        call t%check(mgdt_check_canonical)
        call t%destroy()
        call expect(held == 0, 'and loses nothing')
    end subroutine

    subroutine test_cancel()
        type(mgdt_triangulation) :: t
        type(watcher), target :: w
        integer(int32) :: map(2*n)
        integer :: stat
        character(100) :: msg

        w%stop_at = 0.5_real64
        call t%set_progress(w)
        call t%insert(xyz, stat, msg)
        call expect_error(stat, mgdt_err_cancelled, msg, 'cancel')
        call t%check(mgdt_check_canonical)
        call t%get_point_map(map(:n))
        call expect(any(map(:n) > 0) .and. any(map(:n) == 0), 'some are in, some are not')
        call t%remove_progress()
        call t%cancel()
        call t%insert(xyz, stat, msg)
        call expect(stat == mgdt_err_cancelled, 'cancel before an insertion')
        call t%destroy()
        call t%cancel()
        call t%insert(xyz, stat)
        call expect(stat == mgdt_err_cancelled, 'cancel before the first insertion')
        call t%insert(xyz)
        call t%check(mgdt_check_canonical)
    end subroutine
end program
