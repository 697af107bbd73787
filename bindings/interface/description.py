# SPDX-License-Identifier: MIT
"""What the C headers cannot say of their functions, for the bindings that are generated from them: of
mgdt.h here, of the others in a file for each."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

# The handles of the C interface. A function that has one takes it first.
HANDLES = ("mgdt_triangulation", "mgdt_parts", "mgdt_voronoi", "mgdt_domain", "mgdt_mesh",
           "mgdt_periodic")


class Group(NamedTuple):
    """The constants of one enumeration."""

    title: str  # what FORTRAN 77 calls them; none where it does not need them
    table: str  # what the tables of the scripting languages are called
    prefixes: tuple[str, ...]  # what these leave out of their names


@dataclass
class Description:
    """What the generator has to be told of a header."""

    header: str  # its name
    # The length of each array that a function takes or fills, in elements: a number, or a product or
    # sum of numbers, of the function's counts and of what functions count. "1" is a single value. A "?" in
    # front means that NULL is allowed; "stride" an address from which the library goes on by a stride;
    # "listed" an array whose lists another one describes; "text" a string that ends with NUL. Twins, whose names end with _i32, have the arrays of the
    # function that they twin.
    lengths: dict[str, dict[str, str]]
    groups: tuple[Group, ...] = ()  # of the enumerations, in their order
    # The six characters by which FORTRAN 77 knows the constants.
    f77_names: dict[str, str] = field(default_factory=dict)
    # Functions of a handle that may take long though they take no array, and those that never do
    # though they fill one.
    long: frozenset[str] = frozenset()
    short: frozenset[str] = frozenset()


LENGTHS = {
    "mgdt_get_order_scheme": {"scheme": "1"},
    "mgdt_get_order_parameter": {"value": "1"},
    "mgdt_get_seed": {"seed": "1"},
    "mgdt_get_threads": {"n": "1"},
    "mgdt_get_index_base": {"base": "1"},
    "mgdt_get_memory_limit": {"bytes": "1"},
    "mgdt_get_compact": {"on": "1"},
    "mgdt_get_read_progress": {"on": "1"},
    "mgdt_get_progress": {"fn": "1"},
    "mgdt_get_canonical_output": {"on": "1"},
    "mgdt_set_isa": {"name": "?text"},
    "mgdt_insert_points": {"xyz": "3*n"},
    "mgdt_insert_points_strided": {"x": "stride", "y": "stride", "z": "stride"},
    "mgdt_remove_points": {"points": "n"},
    "mgdt_move_points": {"points": "?n", "xyz": "3*n"},
    "mgdt_renumber_points": {"new_index": "capacity"},
    "mgdt_get_tetrahedra": {"v": "capacity"},
    "mgdt_get_neighbors": {"v": "capacity"},
    "mgdt_get_hull_facets": {"v": "capacity"},
    "mgdt_get_edges": {"v": "capacity"},
    "mgdt_get_point_map": {"v": "capacity"},
    "mgdt_get_vertex_tetrahedra": {"offsets": "offset_capacity", "list": "capacity"},
    "mgdt_get_vertex_neighbors": {"offsets": "offset_capacity", "list": "capacity"},
    "mgdt_get_gabriel_edges": {"v": "capacity", "count": "1"},
    "mgdt_get_spanning_tree": {"v": "capacity", "count": "1"},
    "mgdt_get_circumcenters": {"xyz": "3*capacity", "radius2": "?capacity"},
    "mgdt_get_tetrahedron_measures": {"x": "capacity"},
    "mgdt_get_cell_measures": {"planes": "?4*n_planes", "x": "capacity"},
    "mgdt_get_alphas": {"alpha2": "capacity"},
    "mgdt_get_alpha_surface": {"v": "capacity", "count": "1"},
    "mgdt_get_solid_alpha": {"alpha2": "1"},
    "mgdt_interpolate": {"values": "n_fields*point_count", "xyz": "3*n", "out": "n_fields*n"},
    "mgdt_get_interpolation_weights": {"xyz": "3*n", "offsets": "offset_capacity",
                                       "points": "capacity", "weights": "capacity"},
    "mgdt_get_gradients": {"values": "n_fields*point_count",
                           "out": "3*n_fields*point_count"},
    "mgdt_locate": {"xyz": "3", "tetrahedron": "1"},
    "mgdt_locate_points": {"xyz": "3*n", "tetrahedra": "n", "weights": "?4*n"},
    "mgdt_traverse_segment": {"a": "3", "b": "3", "tetrahedra": "capacity",
                              "parameters": "?capacity+1", "count": "1"},
    "mgdt_nearest_vertex": {"xyz": "3", "vertex": "1"},
    "mgdt_nearest_vertices": {"xyz": "3*n", "vertices": "n"},
    "mgdt_get_stat": {"value": "1"},
    "mgdt_get_error": {"buffer": "capacity"},
    "mgdt_order_scheme_from_name": {"name": "text", "scheme": "1"},
    "mgdt_order_scheme_at": {"scheme": "1"},
}


class Rows(NamedTuple):
    """An export of rows of integers."""

    array: str  # what Fortran calls it
    width: int  # integers in a row
    count: str  # the function that says how many rows there are


# The exports that Fortran takes in arrays of rank 1 and 2, mgdt_get_ left out.
ROWS = {
    "tetrahedra": Rows("tetrahedra", 4, "tetrahedron_count"),
    "neighbors": Rows("neighbors", 4, "tetrahedron_count"),
    "hull_facets": Rows("facets", 3, "hull_facet_count"),
    "edges": Rows("edges", 2, "edge_count"),
}

# Compressed lists by points.
LISTS = ("vertex_tetrahedra", "vertex_neighbors")

# Graphs: exports of pairs that say themselves how many there are.
GRAPHS = ("gabriel_edges", "spanning_tree")

# Integers in a row of an export that FORTRAN 77 takes in columns.
COLUMNS = {**{name: rows.width for name, rows in ROWS.items()}, **dict.fromkeys(GRAPHS, 2),
           "alpha_surface": 3}

# The settings that are single numbers, each with mgdt_set_ and mgdt_get_.
SETTINGS = ("order_scheme", "order_parameter", "seed", "threads", "index_base", "memory_limit",
            "compact", "read_progress", "canonical_output")

F77_NAMES = {
    "MGDT_OK": "MGOK",
    "MGDT_ERR_NULL_POINTER": "MGENUL",
    "MGDT_ERR_INVALID_ARGUMENT": "MGEARG",
    "MGDT_ERR_NOT_FINITE": "MGEFIN",
    "MGDT_ERR_UNKNOWN_SCHEME": "MGESCH",
    "MGDT_ERR_UNKNOWN_KEY": "MGEKEY",
    "MGDT_ERR_NOT_BUILT": "MGENBT",
    "MGDT_ERR_BUFFER_TOO_SMALL": "MGEBUF",
    "MGDT_ERR_INDEX_RANGE": "MGERNG",
    "MGDT_ERR_OUT_OF_MEMORY": "MGEMEM",
    "MGDT_ERR_TOO_LARGE": "MGEBIG",
    "MGDT_ERR_CANCELLED": "MGECAN",
    "MGDT_ERR_BUSY": "MGEBSY",
    "MGDT_ERR_TRANSPORT": "MGETRA",
    "MGDT_ERR_CHECK_FAILED": "MGECHK",
    "MGDT_ERR_INVALID_BOUNDARY": "MGEBND",
    "MGDT_ERR_RESOLUTION": "MGERES",
    "MGDT_ERR_OPEN_BOUNDARY": "MGEOPN",
    "MGDT_ERR_INTERNAL": "MGEINT",
    "MGDT_ORDER_AUTO": "MGOAUT",
    "MGDT_ORDER_INPUT": "MGOINP",
    "MGDT_ORDER_RANDOM": "MGORAN",
    "MGDT_ORDER_LEXICOGRAPHIC": "MGOLEX",
    "MGDT_ORDER_BRIO": "MGOBRI",
    "MGDT_ORDER_HILBERT": "MGOHIL",
    "MGDT_ORDER_REGULAR_GRID": "MGOGRD",
    "MGDT_ORDER_KD_TREE": "MGOKDT",
    "MGDT_ORDER_ENHANCED_KD_TREE": "MGOEKD",
    "MGDT_ORDER_MULTI_GRID": "MGOMUL",
    "MGDT_PARAMETER_POINTS_PER_CELL": "MGPPPC",
    "MGDT_PARAMETER_THRESHOLD": "MGPTHR",
    "MGDT_PARAMETER_SEPARATION": "MGPSEP",
    "MGDT_PARAMETER_ROUND_RATIO": "MGPRAT",
    "MGDT_SEPARATION_NONE": "MGSNON",
    "MGDT_SEPARATION_PASSES": "MGSPAS",
    "MGDT_SEPARATION_ROUNDS": "MGSROU",
    "MGDT_STAT_POINTS_INSERTED": "MGFPTS",
    "MGDT_STAT_DUPLICATES": "MGFDUP",
    "MGDT_STAT_POINTS_REMOVED": "MGFOUT",
    "MGDT_STAT_POINTS_MOVED": "MGFMOV",
    "MGDT_STAT_PUT_BACK": "MGFBCK",
    "MGDT_STAT_REBUILDS": "MGFREB",
    "MGDT_STAT_WALK_STEPS": "MGFWST",
    "MGDT_STAT_WALK_TESTS": "MGFWTE",
    "MGDT_STAT_CONFLICT_TESTS": "MGFCTE",
    "MGDT_STAT_TETRAHEDRA_REMOVED": "MGFREM",
    "MGDT_STAT_TETRAHEDRA_CREATED": "MGFCRE",
    "MGDT_STAT_LINK_VERTICES": "MGFLNK",
    "MGDT_STAT_EXACT_CALLS": "MGFEXA",
    "MGDT_STAT_PUT_OFF": "MGFPUT",
    "MGDT_STAT_INSERTED_ALONE": "MGFALN",
    "MGDT_STAT_ORDER_SECONDS": "MGFOSE",
    "MGDT_STAT_INSERT_SECONDS": "MGFISE",
    "MGDT_STAT_REMOVE_SECONDS": "MGFRSE",
    "MGDT_STAT_MOVE_SECONDS": "MGFMSE",
    "MGDT_STAT_GRID_LEVELS": "MGFLEV",
    "MGDT_STAT_ROUNDS": "MGFROU",
    "MGDT_STAT_THREADS": "MGFTHR",
    "MGDT_STAT_MEMORY_BYTES": "MGFMEM",
    "MGDT_STAT_PEAK_MEMORY_BYTES": "MGFPEA",
    "MGDT_CHECK_COMBINATORIAL": "MGCCOM",
    "MGDT_CHECK_GEOMETRIC": "MGCGEO",
    "MGDT_CHECK_CANONICAL": "MGCCAN",
    "MGDT_MEASURE_VOLUME": "MGMVOL",
    "MGDT_MEASURE_AREA": "MGMARE",
    "MGDT_MEASURE_CENTROID": "MGMCEN",
    "MGDT_MEASURE_FACES": "MGMFAC",
    "MGDT_TETRAHEDRON_VOLUME": "MGTVOL",
    "MGDT_TETRAHEDRON_RADIUS_RATIO": "MGTRRT",
    "MGDT_TETRAHEDRON_LEAST_DIHEDRAL_ANGLE": "MGTLAN",
    "MGDT_TETRAHEDRON_LARGEST_DIHEDRAL_ANGLE": "MGTGAN",
    "MGDT_TETRAHEDRON_LONGEST_EDGE": "MGTEDG",
    "MGDT_TETRAHEDRON_VOLUME_LENGTH": "MGTVLN",
    "MGDT_TETRAHEDRON_EDGE_RATIO": "MGTERT",
    "MGDT_INTERPOLATE_LINEAR": "MGILIN",
    "MGDT_INTERPOLATE_NEAREST": "MGINEA",
    "MGDT_INTERPOLATE_SIBSON": "MGISIB",
    "MGDT_INTERPOLATE_LAPLACE": "MGILAP",
    "MGDT_INTERPOLATE_SIBSON_C1": "MGISC1",
    "MGDT_OUTSIDE_NONE": "MGXNON",
    "MGDT_OUTSIDE_NEAREST": "MGXNEA",
    "MGDT_OUTSIDE_BOUNDARY": "MGXBOU",
    "MGDT_OUTSIDE_LINEAR": "MGXLIN",
}

TRIANGULATION = Description(
    "mgdt.h", LENGTHS,
    (Group("error codes", "status", ("MGDT_", "MGDT_ERR_")),
     Group("order schemes", "order", ("MGDT_ORDER_",)),
     Group("parameters (MGPAR)", "parameter", ("MGDT_PARAMETER_",)),
     Group("values of MGPSEP", "separation", ("MGDT_SEPARATION_",)),
     Group("figures (MGSTAT)", "statistic", ("MGDT_STAT_",)),
     Group("levels (MGCHK)", "check", ("MGDT_CHECK_",)),
     Group("measures (MGCELL)", "measure", ("MGDT_MEASURE_",)),
     Group("measures of tetrahedra (MGTMSR)", "tetrahedron", ("MGDT_TETRAHEDRON_",)),
     Group("methods (MGINTP)", "method", ("MGDT_INTERPOLATE_",)),
     Group("what is outside (MGINTP)", "outside", ("MGDT_OUTSIDE_",))),
    F77_NAMES,
    long=frozenset({"mgdt_check", "mgdt_get_solid_alpha"}),
    short=frozenset({"mgdt_get_error"}))
