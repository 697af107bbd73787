! SPDX-License-Identifier: MIT
! Making, freeing and moving triangulations.
submodule (mgdt) mgdt_life
    use, intrinsic :: iso_c_binding, only: c_associated, c_int32_t, c_int64_t, c_null_funptr
    use, intrinsic :: iso_fortran_env, only: error_unit
    use mgdt_c, only: c_clear, c_create_with_allocator, c_destroy, c_reserve, c_set_index_base, &
                      c_set_progress
    use mgdt_support, only: finish, make, tell
    implicit none

contains

    module procedure create
        type(c_funptr) :: alloc_or_null, release_or_null
        type(c_ptr) :: user_or_null
        integer(c_int32_t) :: status

        if (c_associated(self%handle)) then
            call tell('create', int(mgdt_err_invalid_argument, c_int32_t), &
                      'the triangulation is made already; destroy it first', stat, errmsg)
            return
        end if
        alloc_or_null = c_null_funptr
        release_or_null = c_null_funptr
        user_or_null = c_null_ptr
        if (present(alloc)) alloc_or_null = alloc
        if (present(release)) release_or_null = release
        if (present(user)) user_or_null = user
        status = c_create_with_allocator(alloc_or_null, release_or_null, user_or_null, self%handle)
        if (status == mgdt_ok) status = c_set_index_base(self%handle, 1_c_int32_t)
        call finish(self%handle, 'create', status, stat, errmsg)
    end procedure

    ! In a callback of the triangulation's own nothing is freed, neither here nor by the library: the
    ! call that is inside the handle goes on, and this is as it was.
    module procedure destroy
        if (c_set_progress(self%handle, c_null_funptr, c_null_ptr) == mgdt_err_busy) return
        call c_destroy(self%handle)
        self%handle = c_null_ptr
        if (associated(self%progress)) deallocate (self%progress)
    end procedure

    module procedure finalize
        call self%destroy()
    end procedure

    module procedure clear
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_clear(self%handle)
        call finish(self%handle, 'clear', status, stat, errmsg)
    end procedure

    module procedure reserve_i32
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_reserve(self%handle, int(n_points, c_int64_t))
        call finish(self%handle, 'reserve', status, stat, errmsg)
    end procedure

    module procedure reserve_i64
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_reserve(self%handle, n_points)
        call finish(self%handle, 'reserve', status, stat, errmsg)
    end procedure

    module procedure move_from
        if (c_associated(self%handle, other%handle)) return
        call self%destroy()
        self%handle = other%handle
        self%progress => other%progress
        other%handle = c_null_ptr
        other%progress => null()
    end procedure

    ! Intrinsic assignment would leave two owners of one handle.
    module procedure assign
        if (c_associated(other%handle)) then
            write (error_unit, '(a)') 'mgdt: a triangulation cannot be copied by assignment; '// &
                'call a%move_from(b) moves it'
            flush (error_unit)
            error stop 1
        end if
        call self%destroy()
    end procedure
end submodule mgdt_life
