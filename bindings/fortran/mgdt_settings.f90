! SPDX-License-Identifier: MIT
! The settings of a triangulation. Each makes the handle if there is none yet.
submodule (mgdt) mgdt_settings
    use, intrinsic :: iso_c_binding, only: c_char, c_funloc, c_int32_t, c_int64_t, c_loc, &
                                           c_null_char, c_null_funptr
    use mgdt_c, only: c_cancel, c_set_canonical_output, c_set_compact, c_set_index_base, &
                      c_set_isa, c_set_memory_limit, c_set_order_parameter, &
                      c_set_order_scheme, c_set_progress, c_set_seed, c_set_threads
    use mgdt_callbacks, only: relay
    use mgdt_support, only: finish, make, tell, to_c
    implicit none

contains

    module procedure set_order_scheme_number
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_set_order_scheme(self%handle, to_c(scheme))
        call finish(self%handle, 'set_order_scheme', status, stat, errmsg)
    end procedure

    module procedure set_order_scheme_name
        integer :: scheme, found
        character(100) :: message

        scheme = mgdt_order_auto
        call mgdt_order_scheme_from_name(name, scheme, found, message)
        if (found == mgdt_ok) then
            call self%set_order_scheme(scheme, stat, errmsg)
        else
            call tell('set_order_scheme', to_c(found), trim(message), stat, errmsg)
        end if
    end procedure

    module procedure set_order_parameter
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_set_order_parameter(self%handle, to_c(key), value)
        call finish(self%handle, 'set_order_parameter', status, stat, errmsg)
    end procedure

    module procedure set_seed_i32
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_set_seed(self%handle, int(seed, c_int64_t))
        call finish(self%handle, 'set_seed', status, stat, errmsg)
    end procedure

    module procedure set_seed_i64
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_set_seed(self%handle, seed)
        call finish(self%handle, 'set_seed', status, stat, errmsg)
    end procedure

    module procedure set_threads
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_set_threads(self%handle, to_c(n))
        call finish(self%handle, 'set_threads', status, stat, errmsg)
    end procedure

    module procedure set_index_base
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_set_index_base(self%handle, to_c(base))
        call finish(self%handle, 'set_index_base', status, stat, errmsg)
    end procedure

    module procedure set_memory_limit_i32
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_set_memory_limit(self%handle, int(bytes, c_int64_t))
        call finish(self%handle, 'set_memory_limit', status, stat, errmsg)
    end procedure

    module procedure set_memory_limit_i64
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_set_memory_limit(self%handle, bytes)
        call finish(self%handle, 'set_memory_limit', status, stat, errmsg)
    end procedure

    module procedure set_progress_procedure
        type(progress_box) :: box

        box%report => report
        call set_progress_box(self, box, stat, errmsg)
    end procedure

    module procedure set_progress_observer
        type(progress_box) :: box

        box%observer => observer
        call set_progress_box(self, box, stat, errmsg)
    end procedure

    subroutine set_progress_box(self, box, stat, errmsg)
        class(mgdt_triangulation), intent(inout) :: self
        type(progress_box), intent(in) :: box
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) then
            if (.not. associated(self%progress)) allocate (self%progress)
            status = c_set_progress(self%handle, c_funloc(relay), c_loc(self%progress))
            if (status == mgdt_ok) self%progress = box
        end if
        call finish(self%handle, 'set_progress', status, stat, errmsg)
    end subroutine

    module procedure remove_progress
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_set_progress(self%handle, c_null_funptr, c_null_ptr)
        if (status == mgdt_ok .and. associated(self%progress)) deallocate (self%progress)
        call finish(self%handle, 'remove_progress', status, stat, errmsg)
    end procedure

    module procedure cancel
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) status = c_cancel(self%handle)
        call finish(self%handle, 'cancel', status, stat, errmsg)
    end procedure

    module procedure set_compact
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) &
            status = c_set_compact(self%handle, merge(1_c_int32_t, 0_c_int32_t, on))
        call finish(self%handle, 'set_compact', status, stat, errmsg)
    end procedure

    module procedure set_canonical_output
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) &
            status = c_set_canonical_output(self%handle, &
                                            merge(1_c_int32_t, 0_c_int32_t, on))
        call finish(self%handle, 'set_canonical_output', status, stat, errmsg)
    end procedure

    module procedure set_isa
        character(:, c_char), allocatable, target :: c_name
        integer(c_int32_t) :: status

        call make(self%handle, status)
        if (status == mgdt_ok) then
            if (present(name)) then
                c_name = trim(name)//c_null_char
                status = c_set_isa(self%handle, c_loc(c_name))
            else
                status = c_set_isa(self%handle, c_null_ptr)
            end if
        end if
        call finish(self%handle, 'set_isa', status, stat, errmsg)
    end procedure
end submodule mgdt_settings
