# SPDX-License-Identifier: MIT
"""What the header of Voronoi diagrams cannot say of its functions."""

from description import Description, Group

VORONOI = Description(
    "mgdt_voronoi.h",
    {
        "mgdt_voronoi_create": {"planes": "?4*n_planes"},
        "mgdt_voronoi_get_stat": {"value": "1"},
        "mgdt_voronoi_array_info": {"columns": "1", "is_double": "1"},
        "mgdt_voronoi_get_size": {"size": "1"},
        "mgdt_voronoi_get_array": {"values": "capacity"},
        "mgdt_voronoi_get_doubles": {"values": "capacity"},
        "mgdt_voronoi_get_error": {"buffer": "capacity"},
    },
    (Group("numbers of a Voronoi diagram (MGYNUM)", "voronoi_stat", ("MGDT_VORONOI_STAT_",)),
     Group("arrays of a Voronoi diagram (MGYARR)", "voronoi_array", ("MGDT_VORONOI_ARRAY_",))),
    {
        "MGDT_VORONOI_STAT_VERTICES": "MGYNVE",
        "MGDT_VORONOI_STAT_RAYS": "MGYNRA",
        "MGDT_VORONOI_STAT_FACES": "MGYNFA",
        "MGDT_VORONOI_STAT_POINTS": "MGYNPT",
        "MGDT_VORONOI_STAT_MEMORY_BYTES": "MGYBYT",
        "MGDT_VORONOI_ARRAY_FACE_OFFSETS": "MGYFOF",
        "MGDT_VORONOI_ARRAY_FACE_CORNERS": "MGYFCO",
        "MGDT_VORONOI_ARRAY_FACE_SIDES": "MGYFSI",
        "MGDT_VORONOI_ARRAY_FACE_SHIFTS": "MGYFSH",
        "MGDT_VORONOI_ARRAY_RAY_VERTICES": "MGYRVT",
        "MGDT_VORONOI_ARRAY_CELL_OFFSETS": "MGYCOF",
        "MGDT_VORONOI_ARRAY_CELL_FACES": "MGYCFA",
        "MGDT_VORONOI_ARRAY_CELL_BOUNDED": "MGYCBO",
        "MGDT_VORONOI_ARRAY_CELL_NEIGHBORS": "MGYCNB",
        "MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_SHIFTS": "MGYCSH",
        "MGDT_VORONOI_ARRAY_VERTICES": "MGYVTX",
        "MGDT_VORONOI_ARRAY_RAY_DIRECTIONS": "MGYRDI",
        "MGDT_VORONOI_ARRAY_FACE_AREAS": "MGYFAR",
        "MGDT_VORONOI_ARRAY_FACE_NORMALS": "MGYFNO",
        "MGDT_VORONOI_ARRAY_FACE_CENTROIDS": "MGYFCE",
        "MGDT_VORONOI_ARRAY_CELL_VOLUMES": "MGYCVO",
        "MGDT_VORONOI_ARRAY_CELL_CENTROIDS": "MGYCCE",
        "MGDT_VORONOI_ARRAY_CELL_FACE_AREAS": "MGYCAR",
        "MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES": "MGYCDI",
    },
    long=frozenset({"mgdt_voronoi_create", "mgdt_voronoi_drop_small_faces"}),
    short=frozenset({"mgdt_voronoi_get_error"}))
