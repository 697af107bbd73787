#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The runners that were built work, and find the tetrahedra that mgdt finds.

Usage: peers_test.py MGDT-BENCH RUNNER...
"""

import json
import os
import subprocess
import sys
import tempfile


def main():
    bench, runners = os.path.abspath(sys.argv[1]), sys.argv[2:]
    peers = [os.path.basename(r).replace("mgdt-peer-", "") for r in runners]
    with tempfile.TemporaryDirectory(prefix="mgdt-peers-") as folder:
        run = subprocess.run([bench, "--distributions", "uniform", "--sizes", "3000",
                              "--runs", "1", "--json", "-", "--peers", ",".join(peers),
                              "--peer-directory", os.path.dirname(os.path.abspath(runners[0]))],
                             cwd=folder, capture_output=True, text=True, timeout=300, check=True)
        # Nothing but the points comes in.
        refused = [subprocess.run([r], input=b"12345678", capture_output=True, timeout=60,
                                  check=False).returncode for r in runners]
    rows = json.loads(run.stdout)["rows"]
    assert [r["library"] for r in rows] == ["mgdt", *peers], rows
    for r in rows:
        assert r["status"] == "ok", r
        assert r["tetrahedra"] == rows[0]["tetrahedra"] > 15000, r
        assert r["version"] and r["total_seconds"] > 0, r
        assert 0 <= r["user_seconds"] <= r["total_seconds"] + 0.02, r
        assert 300 < r["bytes_per_point"] < 5000, r
    assert refused == [1] * len(runners), refused
    print(f"{', '.join(peers)}: {len(rows)} rows")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main()
