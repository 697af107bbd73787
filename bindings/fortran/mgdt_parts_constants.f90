! SPDX-License-Identifier: MIT
! Generated from mgdt/mgdt_parts.h by bindings/interface/generate.py.
!
! The options, numbers and arrays of parts. Comments are those of the header.
module mgdt_parts_constants
    implicit none
    public

    ! The part of this process. A process with several parts has to say which:
    ! MGDT_ERR_INVALID_ARGUMENT.
    integer, parameter :: mgdt_parts_this_part = -1

    ! Options.
    ! 0 (default) or 1; the same on all processes.
    integer, parameter :: mgdt_parts_index_base = 10
    ! Threads of each triangulation, see mgdt_set_threads(); default 1, 0 for all cores.
    integer, parameter :: mgdt_parts_threads = 20
    ! Bytes that this process may hold for points, and for triangulations from the next build on; 0
    ! (default) for no limit.
    integer, parameter :: mgdt_parts_memory_limit = 30

    ! Numbers.
    ! Parts in all.
    integer, parameter :: mgdt_parts_parts = 10
    ! The first part of this process.
    integer, parameter :: mgdt_parts_first_local = 11
    ! How many parts this process has.
    integer, parameter :: mgdt_parts_local_parts = 12
    ! Points inserted into the part.
    integer, parameter :: mgdt_parts_points = 20
    ! Vertices that the part owns.
    integer, parameter :: mgdt_parts_own_vertices = 30
    ! These and its ghosts.
    integer, parameter :: mgdt_parts_vertices = 31
    ! Vertices of all parts.
    integer, parameter :: mgdt_parts_all_vertices = 32
    ! Tetrahedra that the part owns.
    integer, parameter :: mgdt_parts_own_tetrahedra = 40
    ! These and the others with a corner that it owns.
    integer, parameter :: mgdt_parts_tetrahedra = 41
    ! Tetrahedra of all parts.
    integer, parameter :: mgdt_parts_all_tetrahedra = 42
    ! Points of other parts that the part was sent.
    integer, parameter :: mgdt_parts_received = 50
    ! Memory held by all parts of this process.
    integer, parameter :: mgdt_parts_memory_bytes = 60

    ! Arrays.
    ! For each point inserted into the part, in that order, the number of its vertex. Equal points
    ! have the same.
    integer, parameter :: mgdt_parts_point_map = 10
    ! The number of each vertex.
    integer, parameter :: mgdt_parts_vertex_numbers = 20
    ! The id of each vertex: the least that was given with a point there.
    integer, parameter :: mgdt_parts_vertex_ids = 21
    ! The part that owns each vertex.
    integer, parameter :: mgdt_parts_vertex_owners = 22
    ! For each part the number of its first vertex, and one more, the end of the last part's: as
    ! many as there are parts, and one.
    integer, parameter :: mgdt_parts_vertex_ranges = 23
    ! For each tetrahedron the numbers of its 4 corners, positively oriented as those of
    ! mgdt_get_tetrahedra().
    integer, parameter :: mgdt_parts_corners = 30
    ! The same, by places of the vertices in the part's order, from the index base on.
    integer, parameter :: mgdt_parts_local_corners = 31
    ! The number of each tetrahedron.
    integer, parameter :: mgdt_parts_tetrahedron_numbers = 32
    ! The part that owns each tetrahedron.
    integer, parameter :: mgdt_parts_tetrahedron_owners = 33
    ! As MGDT_PARTS_VERTEX_RANGES, for tetrahedra; in mgdt_parts_build_each() up to the part.
    integer, parameter :: mgdt_parts_tetrahedron_ranges = 34
    ! For each tetrahedron that the part owns, 4 numbers: of the tetrahedra opposite its corners, or
    ! the index base - 1 where there is none.
    integer, parameter :: mgdt_parts_neighbors = 40
end module mgdt_parts_constants
