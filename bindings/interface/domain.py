# SPDX-License-Identifier: MIT
"""What the header of domains cannot say of its functions."""

from description import Description, Group

DOMAIN = Description(
    "mgdt_domain.h",
    {
        "mgdt_domain_get_option": {"value": "1"},
        "mgdt_domain_get_progress": {"fn": "1"},
        "mgdt_domain_set_points": {"xyz": "3*n"},
        "mgdt_domain_set_facets": {"offsets": "?n+1", "corners": "listed", "markers": "?n"},
        "mgdt_domain_set_segments": {"ends": "2*n", "markers": "?n"},
        "mgdt_domain_set_regions": {"xyz": "3*n", "markers": "?n"},
        "mgdt_domain_set_holes": {"xyz": "3*n"},
        "mgdt_domain_get_stat": {"value": "1"},
        "mgdt_domain_array_info": {"columns": "1", "is_double": "1"},
        "mgdt_domain_get_size": {"size": "1"},
        "mgdt_domain_get_array": {"values": "capacity"},
        "mgdt_domain_get_error": {"buffer": "capacity"},
    },
    (Group("kinds (MGDARR)", "domain_kind", ("MGDT_DOMAIN_KIND_",)),
     Group("options (MGDOPT)", "domain_option", ("MGDT_DOMAIN_OPTION_",)),
     Group("numbers (MGDNUM)", "domain_stat", ("MGDT_DOMAIN_STAT_",)),
     Group("arrays (MGDARR)", "domain_array", ("MGDT_DOMAIN_ARRAY_",))),
    {
        "MGDT_DOMAIN_KIND_FACET": "MGDKFA",
        "MGDT_DOMAIN_KIND_SEGMENT": "MGDKSE",
        "MGDT_DOMAIN_KIND_POINT": "MGDKPO",
        "MGDT_DOMAIN_OPTION_INDEX_BASE": "MGDBAS",
        "MGDT_DOMAIN_OPTION_THREADS": "MGDTHR",
        "MGDT_DOMAIN_OPTION_MEMORY_LIMIT": "MGDLIM",
        "MGDT_DOMAIN_OPTION_ROUND_POINTS": "MGDRND",
        "MGDT_DOMAIN_OPTION_STRICT": "MGDSTR",
        "MGDT_DOMAIN_OPTION_KEEP_BOUNDARY": "MGDKPB",
        "MGDT_DOMAIN_STAT_POINTS": "MGDNPT",
        "MGDT_DOMAIN_STAT_FACETS": "MGDNFA",
        "MGDT_DOMAIN_STAT_SEGMENTS": "MGDNSE",
        "MGDT_DOMAIN_STAT_REGIONS": "MGDNRG",
        "MGDT_DOMAIN_STAT_HOLES": "MGDNHO",
        "MGDT_DOMAIN_STAT_MEMORY_BYTES": "MGDBYT",
        "MGDT_DOMAIN_STAT_OFFENDING_PAIRS": "MGDNPA",
        "MGDT_DOMAIN_STAT_OPEN_EDGES": "MGDNOE",
        "MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS": "MGDPAI",
        "MGDT_DOMAIN_ARRAY_OPEN_EDGES": "MGDOED",
    },
    long=frozenset({"mgdt_domain_validate", "mgdt_domain_build", "mgdt_domain_check"}),
    short=frozenset({"mgdt_domain_get_error"}))
