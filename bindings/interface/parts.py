# SPDX-License-Identifier: MIT
"""What the headers of parts and of MPI cannot say of their functions."""

from description import Description, Group

PARTS = Description(
    "mgdt_parts.h",
    {
        "mgdt_parts_get_option": {"value": "1"},
        "mgdt_parts_insert_points": {"xyz": "3*n", "ids": "?n"},
        "mgdt_parts_get_stat": {"value": "1"},
        "mgdt_parts_get_progress": {"fn": "1"},
        "mgdt_parts_array_info": {"columns": "1", "is_double": "1"},
        "mgdt_parts_get_size": {"size": "1"},
        "mgdt_parts_get_array": {"values": "capacity"},
        "mgdt_parts_get_coordinates": {"xyz": "capacity"},
        "mgdt_parts_get_error": {"buffer": "capacity"},
    },
    (Group("", "part", ("MGDT_PARTS_",)),
     Group("options (MGMOPT)", "option", ("MGDT_PARTS_",)),
     Group("numbers (MGMNUM)", "number", ("MGDT_PARTS_",)),
     Group("arrays (MGMARR)", "array", ("MGDT_PARTS_",))),
    {
        "MGDT_PARTS_INDEX_BASE": "MGQBAS",
        "MGDT_PARTS_THREADS": "MGQTHR",
        "MGDT_PARTS_MEMORY_LIMIT": "MGQMEM",
        "MGDT_PARTS_READ_PROGRESS": "MGQRPR",
        "MGDT_PARTS_PARTS": "MGQPRT",
        "MGDT_PARTS_FIRST_LOCAL": "MGQFLO",
        "MGDT_PARTS_LOCAL_PARTS": "MGQNLO",
        "MGDT_PARTS_POINTS": "MGQPTS",
        "MGDT_PARTS_OWN_VERTICES": "MGQOVT",
        "MGDT_PARTS_VERTICES": "MGQNVT",
        "MGDT_PARTS_ALL_VERTICES": "MGQAVT",
        "MGDT_PARTS_OWN_TETRAHEDRA": "MGQOTE",
        "MGDT_PARTS_TETRAHEDRA": "MGQNTE",
        "MGDT_PARTS_ALL_TETRAHEDRA": "MGQATE",
        "MGDT_PARTS_RECEIVED": "MGQREC",
        "MGDT_PARTS_MEMORY_BYTES": "MGQBYT",
        "MGDT_PARTS_POINT_MAP": "MGQMAP",
        "MGDT_PARTS_VERTEX_NUMBERS": "MGQVNU",
        "MGDT_PARTS_VERTEX_IDS": "MGQVID",
        "MGDT_PARTS_VERTEX_OWNERS": "MGQVOW",
        "MGDT_PARTS_VERTEX_RANGES": "MGQVRA",
        "MGDT_PARTS_CORNERS": "MGQCOR",
        "MGDT_PARTS_LOCAL_CORNERS": "MGQLCO",
        "MGDT_PARTS_TETRAHEDRON_NUMBERS": "MGQTNU",
        "MGDT_PARTS_TETRAHEDRON_OWNERS": "MGQTOW",
        "MGDT_PARTS_TETRAHEDRON_RANGES": "MGQTRA",
        "MGDT_PARTS_NEIGHBORS": "MGQNBR",
    },
    long=frozenset({"mgdt_parts_build", "mgdt_parts_build_each", "mgdt_parts_check"}),
    short=frozenset({"mgdt_parts_get_error"}))

# Its types are MPI's: MPI_Comm, which is no integer for all of them, and MPI_Fint.
MPI = Description("mgdt_mpi.h", {})
