! SPDX-License-Identifier: MIT
! Names, texts and versions: what can be asked of mgdt without a triangulation. Module mgdt puts
! mgdt_ before each name. Here the names are without it, since those with it are C's: gfortran does
! not accept both in one source file.
module mgdt_names
    use, intrinsic :: iso_c_binding, only: c_int32_t, c_null_char
    use mgdt_c, only: c_abi_version, c_order_scheme_at, c_order_scheme_from_name, &
                      c_order_scheme_name, c_stat_name, &
                      c_status_string, c_version_string
    use mgdt_constants, only: mgdt_ok
    use mgdt_support, only: c_text, report, to_c
    implicit none
    private
    public :: version, abi_version, status_string, stat_name, order_scheme_name, &
              order_scheme_from_name, order_scheme_at

contains

    ! Version of the library that is running, '1.2.0'.
    function version() result(text)
        character(:), allocatable :: text

        text = c_text(c_version_string())
    end function

    ! Version of its binary interface, 1. Programs built for it run with every library that says 1.
    function abi_version() result(version)
        integer :: version

        version = c_abi_version()
    end function

    ! One line that describes a value of stat=.
    function status_string(status) result(text)
        integer, intent(in) :: status
        character(:), allocatable :: text

        text = c_text(c_status_string(to_c(status)))
    end function

    ! Name of a statistic, 'walk steps'; empty for an unknown key.
    function stat_name(key) result(name)
        integer, intent(in) :: key
        character(:), allocatable :: name

        name = c_text(c_stat_name(to_c(key)))
    end function

    ! Name of an order scheme, 'multi-grid'; empty for an unknown one.
    function order_scheme_name(scheme) result(name)
        integer, intent(in) :: scheme
        character(:), allocatable :: name

        name = c_text(c_order_scheme_name(to_c(scheme)))
    end function

    ! The order scheme of a name; trailing blanks do not count. An unknown name leaves scheme as it
    ! is.
    subroutine order_scheme_from_name(name, scheme, stat, errmsg)
        character(*), intent(in) :: name
        integer, intent(inout) :: scheme
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status, found

        status = c_order_scheme_from_name(trim(name)//c_null_char, found)
        if (status == mgdt_ok) scheme = found
        call report('mgdt_order_scheme_from_name', status, &
                  'there is no order scheme "'//trim(name)//'"', stat, errmsg)
    end subroutine

    ! The k-th order scheme, from 1: the default first. Beyond the last, scheme stays as it is.
    subroutine order_scheme_at(k, scheme, stat, errmsg)
        integer, intent(in) :: k
        integer, intent(inout) :: scheme
        integer, intent(out), optional :: stat
        character(*), intent(inout), optional :: errmsg
        integer(c_int32_t) :: status, found

        status = c_order_scheme_at(to_c(max(k, 0) - 1), found)
        if (status == mgdt_ok) scheme = found
        call report('mgdt_order_scheme_at', status, 'there are fewer order schemes', stat, errmsg)
    end subroutine
end module mgdt_names
