#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The header, the version script and the library of MPI name the same functions.

  symbols_test.py libmgdt_mpi.so mgdt_mpi.h mgdt_mpi.map
"""
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.append(str(Path(__file__).resolve().parents[1]))
from checks import check, differences, finish, output_of

library, header, script = sys.argv[1:]
text = re.sub(r"/\*.*?\*/", " ", Path(header).read_text(encoding="utf-8"), flags=re.S)
declared = set(re.findall(r"MGDT_API\b[^;(]*?\b(mgdt_mpi_\w+)\s*\(", text))
mapped = re.findall(r"^\s+(mgdt_mpi_\w+);", Path(script).read_text(encoding="utf-8"), flags=re.M)
exported = {line.split()[-1].partition("@")[0]
            for line in output_of("nm", "-D", "--defined-only", library).splitlines() if " T " in line}

check("the header declares functions", "" if declared else "none found")
check("the version script is in order", "" if mapped == sorted(set(mapped)) else " ".join(mapped))
check("the version script names what the header declares", differences(declared, set(mapped)))
check("the library exports what the header declares", differences(declared, exported))
needed = set(re.findall(r"\(NEEDED\).*\[(.*?)\]", output_of("readelf", "-dW", library)))
check("the library needs mgdt, MPI and the C runtime alone",
      " ".join(n for n in needed if not re.match(r"lib(mgdt|mpi|mpich|open-\w+|c|pthread)\.so|ld-linux", n)))
finish()
