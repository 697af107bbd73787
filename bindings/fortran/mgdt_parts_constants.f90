! SPDX-License-Identifier: MIT
! Generated from mgdt/mgdt_parts.h by bindings/interface/generate.py.
!
! The options, numbers and arrays of parts. Comments are those of the header.
module mgdt_parts_constants
    implicit none
    public

    ! The only part of the calling process. If the process has several parts, a call with this value
    ! returns MGDT_ERR_INVALID_ARGUMENT.
    integer, parameter :: mgdt_parts_this_part = -1

    ! Options.
    ! 0 (default) or 1; the same on all processes.
    integer, parameter :: mgdt_parts_index_base = 10
    ! Threads that triangulate each part, see mgdt_set_threads(); default 1, 0 for all cores.
    integer, parameter :: mgdt_parts_threads = 20
    ! Bytes that this process may hold for points and triangulations; 0 (default) for no limit. For
    ! triangulations a new limit applies from the next build on.
    integer, parameter :: mgdt_parts_memory_limit = 30
    ! 1 if mgdt_parts_check() reports progress and can be cancelled, as mgdt_parts_build(); default
    ! 0. The same on all processes. Since 1.3.
    integer, parameter :: mgdt_parts_read_progress = 40

    ! Numbers.
    ! Number of parts of all processes.
    integer, parameter :: mgdt_parts_parts = 10
    ! The first part of this process.
    integer, parameter :: mgdt_parts_first_local = 11
    ! Number of parts of this process.
    integer, parameter :: mgdt_parts_local_parts = 12
    ! Points inserted into the part.
    integer, parameter :: mgdt_parts_points = 20
    ! Vertices that the part owns.
    integer, parameter :: mgdt_parts_own_vertices = 30
    ! Vertices of the part, ghosts included.
    integer, parameter :: mgdt_parts_vertices = 31
    ! Vertices of all parts.
    integer, parameter :: mgdt_parts_all_vertices = 32
    ! Tetrahedra that the part owns.
    integer, parameter :: mgdt_parts_own_tetrahedra = 40
    ! Tetrahedra of the part.
    integer, parameter :: mgdt_parts_tetrahedra = 41
    ! Tetrahedra of all parts.
    integer, parameter :: mgdt_parts_all_tetrahedra = 42
    ! Points that other parts sent to the part.
    integer, parameter :: mgdt_parts_received = 50
    ! Memory held by all parts of this process.
    integer, parameter :: mgdt_parts_memory_bytes = 60

    ! Arrays.
    ! For each point inserted into the part, in the order of insertion, the number of its vertex.
    ! Equal points have the same vertex.
    integer, parameter :: mgdt_parts_point_map = 10
    ! The number of each vertex.
    integer, parameter :: mgdt_parts_vertex_numbers = 20
    ! The id of each vertex: the least id of the points that share it.
    integer, parameter :: mgdt_parts_vertex_ids = 21
    ! The part that owns each vertex.
    integer, parameter :: mgdt_parts_vertex_owners = 22
    ! For each part the number of the first vertex that it owns, and one element more: the end of
    ! the last part's numbers.
    integer, parameter :: mgdt_parts_vertex_ranges = 23
    ! For each tetrahedron the numbers of its 4 vertices, positively oriented as in
    ! mgdt_get_tetrahedra().
    integer, parameter :: mgdt_parts_corners = 30
    ! For each tetrahedron its 4 vertices, each as its index in the part's order of vertices, from
    ! the index base on.
    integer, parameter :: mgdt_parts_local_corners = 31
    ! The number of each tetrahedron.
    integer, parameter :: mgdt_parts_tetrahedron_numbers = 32
    ! The part that owns each tetrahedron.
    integer, parameter :: mgdt_parts_tetrahedron_owners = 33
    ! For each part the number of the first tetrahedron that it owns, and one element more: the end
    ! of the last part's numbers. During mgdt_parts_build_each() the array ends with the part that
    ! was finished last.
    integer, parameter :: mgdt_parts_tetrahedron_ranges = 34
    ! For each tetrahedron that the part owns, the numbers of the 4 tetrahedra opposite its
    ! vertices. On the hull the number is the index base - 1.
    integer, parameter :: mgdt_parts_neighbors = 40
end module mgdt_parts_constants
