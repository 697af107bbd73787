# SPDX-License-Identifier: MIT
"""What the header of Voronoi diagrams cannot say of its functions."""

from description import Description, Group

VORONOI = Description(
    "mgdt_voronoi.h",
    {
        "mgdt_voronoi_create": {"planes": "?4*n_planes"},
        "mgdt_voronoi_array_info": {"columns": "1", "is_double": "1"},
        "mgdt_voronoi_get_size": {"size": "1"},
        "mgdt_voronoi_get_array": {"values": "capacity"},
        "mgdt_voronoi_get_doubles": {"values": "capacity"},
        "mgdt_voronoi_get_error": {"buffer": "capacity"},
    },
    (Group("arrays of a Voronoi diagram (MGVARR)", "voronoi", ("MGDT_VORONOI_",)),),
    {
        "MGDT_VORONOI_FACE_OFFSETS": "MGVFOF",
        "MGDT_VORONOI_FACE_CORNERS": "MGVFCO",
        "MGDT_VORONOI_FACE_SIDES": "MGVFSI",
        "MGDT_VORONOI_FACE_IMAGES": "MGVFIM",
        "MGDT_VORONOI_RAY_VERTICES": "MGVRVT",
        "MGDT_VORONOI_CELL_OFFSETS": "MGVCOF",
        "MGDT_VORONOI_CELL_FACES": "MGVCFA",
        "MGDT_VORONOI_CELL_BOUNDED": "MGVCBO",
        "MGDT_VORONOI_CELL_NEIGHBORS": "MGVCNB",
        "MGDT_VORONOI_CELL_NEIGHBOR_IMAGES": "MGVCIM",
        "MGDT_VORONOI_VERTICES": "MGVVTX",
        "MGDT_VORONOI_RAY_DIRECTIONS": "MGVRDI",
        "MGDT_VORONOI_FACE_AREAS": "MGVFAR",
        "MGDT_VORONOI_FACE_NORMALS": "MGVFNO",
        "MGDT_VORONOI_FACE_CENTROIDS": "MGVFCE",
        "MGDT_VORONOI_CELL_VOLUMES": "MGVCVO",
        "MGDT_VORONOI_CELL_CENTROIDS": "MGVCCE",
        "MGDT_VORONOI_CELL_FACE_AREAS": "MGVCAR",
        "MGDT_VORONOI_CELL_NEIGHBOR_DISTANCES": "MGVCDI",
    },
    long=frozenset({"mgdt_voronoi_create", "mgdt_voronoi_drop_small_faces"}),
    short=frozenset({"mgdt_voronoi_get_error"}))
