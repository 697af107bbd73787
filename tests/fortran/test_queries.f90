! SPDX-License-Identifier: MIT
! Location, weights, nearest vertices against plain search; the check; figures; names; settings.
program test_queries
    use checks
    use mgdt
    implicit none

    integer, parameter :: n = 400, m = 300
    integer, allocatable :: schemes(:)
    type(mgdt_triangulation) :: t
    real(real64) :: xyz(3, n), probes(3, m)
    integer(int32), allocatable :: tets(:, :)

    call list_schemes()
    call make_points(xyz)
    call t%insert(xyz)
    allocate (tets(4, t%tetrahedron_count()))
    call t%get_tetrahedra(tets)
    call make_points(probes)
    ! Some are outside, and none on a facet, where several answers are right.
    probes = 1.25_real64*probes - 0.1250123_real64

    call test_locate_points()
    call test_traverse_segment()
    call test_sections()
    call test_nearest()
    call test_getters()
    call test_check_and_figures()
    call test_settings()
    call test_names()
    call conclude()

contains

    subroutine test_locate_points()
        integer(int32) :: found(m), found_1(m), one
        integer(int64) :: found_64(m), found_64_1(m), one_64
        real(real64) :: weights(4, m), weights_1(4*m), weights_of_one(4), weights_of_one_64(4)
        logical :: right, alike
        integer :: i

        call t%locate_points(probes, found, weights)
        call t%locate_points(probes, found_64)
        call expect(all(found == found_64), 'both kinds')
        call t%locate_points(reshape(probes, [3*m]), found_1, weights_1)
        call t%locate_points(reshape(probes, [3*m]), found_64_1)
        call expect(all(found_1 == found) .and. all(found_64_1 == found), 'rank 1')
        call expect(all(abs(weights_1 - reshape(weights, [4*m])) <= 0), 'weights of rank 1')
        call expect(any(found == 0) .and. any(found > 0), 'probes inside and outside')
        right = .true.
        alike = .true.
        do i = 1, m
            if (found(i) > 0) then
                right = right .and. abs(sum(weights(:, i)) - 1) < 1e-12_real64 &
                        .and. minval(weights(:, i)) > -1e-12_real64 &
                        .and. maxval(abs(matmul(xyz(:, tets(:, found(i))), weights(:, i)) &
                                         - probes(:, i))) < 1e-12_real64
            else
                if (is_inside(probes(:, i))) right = .false.
                right = right .and. all(abs(weights(:, i)) <= 0)
            end if
            call t%locate(probes(:, i), one, weights_of_one)
            call t%locate(probes(:, i), one_64, weights_of_one_64)
            alike = alike .and. one == found(i) .and. one_64 == one &
                    .and. all(abs(weights_of_one - weights(:, i)) <= 0) &
                    .and. all(abs(weights_of_one_64 - weights(:, i)) <= 0)
            call t%locate(probes(:, i), one)
            alike = alike .and. one == found(i)
        end do
        call expect(right, 'weights give the probe back')
        call expect(alike, 'one by one')
    end subroutine

    subroutine test_traverse_segment()
        integer(int32) :: way(400), few(3), passed
        integer(int64) :: way_64(400), passed_64
        real(real64) :: at(401), at_64(401), middle(3)
        real(real64), parameter :: a(3) = [-0.5_real64, -0.3_real64, -0.4_real64]
        real(real64), parameter :: b(3) = [1.5_real64, 1.4_real64, 1.45_real64]
        character(256) :: msg
        integer(int32) :: found
        integer :: i, stat

        call t%traverse_segment(a, b, way, at, passed)
        call t%traverse_segment(a, b, way_64, at_64, passed_64)
        call expect(passed > 5 .and. passed_64 == passed, 'tetrahedra on the way')
        call expect(all(way(:passed) == way_64(:passed)) .and. &
                    all(abs(at(:passed + 1) - at_64(:passed + 1)) <= 0), 'both kinds')
        do i = 1, passed
            middle = a + (b - a)*(at(i) + at(i + 1))/2
            call t%locate(middle, found)
            if (at(i + 1) - at(i) > 1e-9_real64) call expect(found == way(i), 'the middle of a piece')
        end do
        call t%traverse_segment(a, b, few, at, found, stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'holds 3 elements')
        call expect(found == passed, 'the count is known all the same')
        call t%traverse_segment(a, b, way, at(:3), found, stat, msg)
        call expect_error(stat, mgdt_err_buffer_too_small, msg, 'parameters holds 3 elements')
        call t%traverse_segment(a, -2 + a, way(:0), at(:0), passed)
        call expect(passed == 0, 'a segment outside')
    end subroutine

    logical function is_inside(p)
        real(real64), intent(in) :: p(3)
        integer(int32), allocatable :: facets(:, :)
        integer :: i

        allocate (facets(3, t%hull_facet_count()))
        call t%get_hull_facets(facets)
        is_inside = .true.
        do i = 1, size(facets, 2)
            is_inside = is_inside .and. volume6(xyz(:, facets(1, i)), xyz(:, facets(2, i)), &
                                                xyz(:, facets(3, i)), p) <= 0
        end do
    end function

    subroutine test_sections()
        real(real64) :: wide(3, 2*m), weights(4, m), spread_weights(4, 2*m)
        integer(int32) :: found(m), spread_found(2*m)

        call t%locate_points(probes, found, weights)
        wide = -1
        wide(:, 1::2) = probes
        spread_found = -5
        spread_weights = -5
        call t%locate_points(wide(:, 1::2), spread_found(1::2), spread_weights(:, 1::2))
        call expect(all(spread_found(1::2) == found) .and. all(spread_found(2::2) == -5), 'sections')
        call expect(all(abs(spread_weights(:, 1::2) - weights) <= 0) &
                    .and. all(spread_weights(:, 2::2) < -4), 'sections of weights')
        call t%locate_points(probes(:, 1:0), found(1:0))
    end subroutine

    subroutine test_nearest()
        integer(int32) :: vertex, found(m + 1), flat(m)
        integer(int64) :: vertex_64, found_64(m), flat_64(m)
        integer :: i, stat
        logical :: right
        character(100) :: msg

        found = -5
        call t%nearest_vertices(probes, found)
        call t%nearest_vertices(probes, found_64)
        call t%nearest_vertices(reshape(probes, [3*m]), flat)
        call t%nearest_vertices(reshape(probes, [3*m]), flat_64)
        call expect(found(m + 1) == -5, 'the rest is not touched')
        call expect(all(found(:m) == found_64) .and. all(flat == found(:m)) .and. &
                    all(flat_64 == found_64), 'both kinds, both ranks')
        call t%nearest_vertices(probes, found(:m - 1), stat, msg)
        call expect(stat == mgdt_err_buffer_too_small .and. &
                    index(msg, 'vertices holds') > 0, 'too few vertices')
        call t%nearest_vertices(probes(:2, :), found, stat)
        call expect(stat == mgdt_err_invalid_argument, 'two coordinates')
        right = .true.
        do i = 1, m
            call t%nearest_vertex(probes(:, i), vertex)
            call t%nearest_vertex(probes(:, i), vertex_64)
            right = right .and. vertex == vertex_64 .and. vertex == &
                    minloc(sum((xyz - spread(probes(:, i), 2, n))**2, dim=1), dim=1) &
                    .and. vertex == found(i)
        end do
        call expect(right, 'nearest vertices')
    end subroutine

    subroutine test_check_and_figures()
        real(real64) :: value, inserted, duplicates
        integer :: level, k
        integer, parameter :: keys(14) = [ &
            mgdt_stat_points_inserted, mgdt_stat_duplicates, mgdt_stat_walk_steps, &
            mgdt_stat_walk_tests, mgdt_stat_conflict_tests, mgdt_stat_tetrahedra_removed, &
            mgdt_stat_tetrahedra_created, mgdt_stat_exact_calls, mgdt_stat_order_seconds, &
            mgdt_stat_insert_seconds, mgdt_stat_grid_levels, mgdt_stat_rounds, &
            mgdt_stat_memory_bytes, mgdt_stat_peak_memory_bytes]

        do level = mgdt_check_combinatorial, mgdt_check_canonical
            call t%check(level)
        end do
        call t%get_stat(mgdt_stat_points_inserted, inserted)
        call t%get_stat(mgdt_stat_duplicates, duplicates)
        call expect(nint(inserted, int64) == t%vertex_count(), 'points inserted')
        call expect(nint(inserted + duplicates) == n, 'points inserted and duplicates')
        do k = 1, size(keys)
            value = -1
            call t%get_stat(keys(k), value)
            call expect(value >= 0, 'figure '//mgdt_stat_name(keys(k)))
            call expect(len(mgdt_stat_name(keys(k))) > 0, 'the name of a figure')
        end do
        call expect(mgdt_stat_name(mgdt_stat_walk_steps) == 'walk steps', 'the name of walk steps')
        call expect(mgdt_stat_name(-1) == '', 'the name of no figure')
    end subroutine

    ! Settings change the time, not the tetrahedra.
    subroutine test_settings()
        type(mgdt_triangulation) :: other
        integer(int32), allocatable :: wanted(:, :), got(:, :)
        real(real64) :: before, after
        integer :: k, stat

        call t%set_canonical_output(.true.)
        allocate (wanted(4, t%tetrahedron_count()), got(4, t%tetrahedron_count()))
        call t%get_tetrahedra(wanted)
        call other%create()
        call other%set_canonical_output(.true.)
        call other%set_seed(7)
        call other%set_seed(-7_int64)
        call other%set_threads(0)
        call other%set_threads(2)
        call other%set_memory_limit(100000000_int64)
        call other%set_memory_limit(0)
        call other%set_order_parameter(mgdt_parameter_points_per_cell, 4._real64)
        call other%set_order_parameter(mgdt_parameter_threshold, 50._real64)
        call other%set_order_parameter(mgdt_parameter_separation, 0._real64)
        call other%set_order_parameter(mgdt_parameter_round_ratio, 3._real64)
        do k = 1, size(schemes)
            call other%clear()
            call other%set_order_scheme(schemes(k))
            call other%insert(xyz(:, :n/2))
            call other%set_order_scheme(mgdt_order_scheme_name(schemes(k))//'  ')
            call other%insert(xyz(:, n/2 + 1:))
            got = 0
            call other%get_tetrahedra(got)
            call expect(all(got == wanted), 'tetrahedra with '//mgdt_order_scheme_name(schemes(k)))
        end do
        call other%get_stat(mgdt_stat_memory_bytes, before)
        call other%set_compact(.true.)
        call other%get_stat(mgdt_stat_memory_bytes, after)
        call expect(after < before - 100*n, 'compact storage takes less')
        got = 0
        call other%get_tetrahedra(got)
        call expect(all(got == wanted), 'tetrahedra in compact storage')
        call other%set_memory_limit(1)
        call other%set_compact(.false., stat)
        call expect(stat == mgdt_err_out_of_memory, 'no memory for spheres')
        call other%set_memory_limit(0)
        call other%set_compact(.false., stat)
        call other%get_stat(mgdt_stat_memory_bytes, before)
        call expect(stat == mgdt_ok .and. before > after, 'with spheres again')
        call other%set_isa('baseline')
        call expect(other%isa_name() == 'baseline', 'the baseline')
        call other%set_isa()
        call expect(other%isa_name() == t%isa_name(), 'the best instruction set')
        call t%set_canonical_output(.false.)
    end subroutine

    ! Each setting is read as it was set, and has its default before.
    subroutine test_getters()
        type(mgdt_triangulation) :: new
        integer :: scheme, threads, base, stat
        integer(int32) :: seed, limit
        integer(int64) :: seed_64, limit_64
        real(real64) :: value, before, after
        logical :: compact, canonical, reads

        call new%get_order_scheme(scheme)
        call new%get_threads(threads)
        call new%get_index_base(base)
        call new%get_compact(compact)
        call new%get_read_progress(reads)
        call new%get_canonical_output(canonical)
        call new%get_order_parameter(mgdt_parameter_separation, value)
        call new%get_seed(seed)
        call new%get_memory_limit(limit)
        call expect(scheme == mgdt_order_auto .and. threads == 1 .and. base == 1 .and. &
                    .not. (compact .or. reads) .and. .not. canonical .and. seed == 0 .and. limit == 0 .and. &
                    nint(value) == mgdt_separation_rounds, 'defaults')
        call new%set_order_scheme('kd-tree')
        call new%set_threads(3)
        call new%set_index_base(0)
        call new%set_compact(.true.)
        call new%set_read_progress(.true.)
        call new%set_canonical_output(.true.)
        call new%set_order_parameter(mgdt_parameter_separation, &
                                     real(mgdt_separation_passes, real64))
        call new%set_seed(-7)
        call new%set_memory_limit(123456789)
        call new%get_order_scheme(scheme)
        call new%get_threads(threads)
        call new%get_index_base(base)
        call new%get_compact(compact)
        call new%get_read_progress(reads)
        call new%get_canonical_output(canonical)
        call new%get_order_parameter(mgdt_parameter_separation, value)
        call new%get_seed(seed)
        call new%get_seed(seed_64)
        call new%get_memory_limit(limit)
        call new%get_memory_limit(limit_64)
        call expect(scheme == mgdt_order_kd_tree .and. threads == 3 .and. base == 0 .and. compact &
                    .and. reads .and. canonical .and. nint(value) == mgdt_separation_passes, 'settings')
        call expect(seed == -7 .and. seed_64 == -7 .and. limit == 123456789 .and. &
                    limit_64 == 123456789, 'a seed and a limit of both kinds')
        call new%get_order_parameter(11, value, stat)
        call expect(stat == mgdt_err_unknown_key .and. nint(value) == mgdt_separation_passes, &
                    'no such parameter')

        call new%set_memory_limit(0)
        call new%reserve(100*n)
        call new%insert(xyz)
        call new%get_stat(mgdt_stat_memory_bytes, before)
        call new%shrink()
        call new%get_stat(mgdt_stat_memory_bytes, after)
        call expect(after < before/2, 'shrink gives memory back')
        call new%check(mgdt_check_canonical)
    end subroutine

    ! Lists the order schemes from 1 on, until the library has no more.
    subroutine list_schemes()
        integer :: scheme, stat

        allocate (schemes(0))
        do
            scheme = -1
            call mgdt_order_scheme_at(size(schemes) + 1, scheme, stat)
            if (stat /= mgdt_ok) exit
            schemes = [schemes, scheme]
        end do
        call expect(scheme == -1 .and. stat == mgdt_err_unknown_scheme, 'no more schemes')
    end subroutine list_schemes

    subroutine test_names()
        integer :: k, scheme, stat

        call expect(size(schemes) >= 10, 'the schemes')
        call expect(schemes(1) == mgdt_order_auto, 'the first scheme')
        call expect(any(schemes == mgdt_order_brio), 'a scheme of the list')
        do k = -1, 0
            call mgdt_order_scheme_at(k, scheme, stat)
            call expect(stat == mgdt_err_unknown_scheme, 'no scheme before the first')
        end do
        do k = 1, size(schemes)
            scheme = -1
            call mgdt_order_scheme_from_name(mgdt_order_scheme_name(schemes(k)), scheme)
            call expect(scheme == schemes(k), 'there and back: '//mgdt_order_scheme_name(schemes(k)))
        end do
        call expect(mgdt_order_scheme_name(mgdt_order_multi_grid) == 'multi-grid', 'multi-grid')
        call expect(mgdt_order_scheme_name(5) == '', 'the name of no scheme')
        call expect(mgdt_version() == '1.4.0', 'version')
        call expect(mgdt_abi_version() == 1, 'version of the binary interface')
        call expect(len(mgdt_status_string(mgdt_ok)) > 0, 'success has a text')
        call expect(mgdt_status_string(mgdt_err_not_finite) /= mgdt_status_string(9999), 'texts')
        call expect(len(mgdt_status_string(9999)) > 0, 'an unknown status has a text')
    end subroutine
end program
