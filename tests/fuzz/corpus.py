#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Packs the inputs of a fuzz target into one readable file, and unpacks them again.

usage: corpus.py pack FOLDER FILE
       corpus.py unpack FILE FOLDER

A packed file has a line for each input: its bytes as a string in double quotes, with the escapes
\\n, \\r, \\t, \\", \\\\ and \\xHH. An input that is kept for what it once showed has a name of words
in front of the string; libFuzzer's own names, 40 hexadecimal digits, are left out. Lines that begin
with # are comments.
"""

import hashlib
import pathlib
import re
import sys

ESCAPES = {ord("\n"): "\\n", ord("\r"): "\\r", ord("\t"): "\\t", ord('"'): '\\"', ord("\\"): "\\\\"}
BYTES = {text[1]: bytes([byte]) for byte, text in ESCAPES.items()}


def quoted(data):
    def one(byte):
        if byte in ESCAPES:
            return ESCAPES[byte]
        return chr(byte) if 32 <= byte < 127 else f"\\x{byte:02x}"

    return '"' + "".join(map(one, data)) + '"'


def unquoted(text):
    def one(match):
        escape = match.group(1)
        return bytes([int(escape[1:], 16)]) if escape[0] == "x" else BYTES[escape]

    if len(text) < 2 or text[0] != '"' or text[-1] != '"':
        raise ValueError("no string in double quotes")
    # What is not an escape is one byte a character.
    parts = re.split(r"(\\(?:x[0-9a-f]{2}|.))", text[1:-1])
    return b"".join(
        one(re.match(r"\\(.*)", part)) if part.startswith("\\") else part.encode("ascii")
        for part in parts
    )


def inputs(file):
    """Yields the name, or None, and the bytes of each input of a packed file."""
    for number, line in enumerate(pathlib.Path(file).read_text("ascii").splitlines(), 1):
        if not line or line.startswith("#"):
            continue
        name, quote, rest = line.partition('"')
        try:
            yield name.strip() or None, unquoted(quote + rest)
        except (ValueError, KeyError) as error:
            sys.exit(f"{file}:{number}: {error}")


def pack(folder, file):
    named, unnamed = [], set()
    for path in pathlib.Path(folder).iterdir():
        data = path.read_bytes()
        if re.fullmatch("[0-9a-f]{40}", path.name):
            unnamed.add(data)
        else:
            named.append((path.name, data))
    lines = ["# SPDX-License-Identifier: MIT", "# Inputs of a fuzz target: see tests/fuzz/corpus.py."]
    lines += [f"{name} {quoted(data)}" for name, data in sorted(named)]
    lines += [quoted(data) for data in sorted(unnamed, key=lambda d: (len(d), d))]
    pathlib.Path(file).write_text("\n".join(lines) + "\n", "ascii")


def unpack(file, folder):
    to = pathlib.Path(folder)
    to.mkdir(parents=True, exist_ok=True)
    for name, data in inputs(file):
        (to / (name or hashlib.sha1(data).hexdigest())).write_bytes(data)


def main(arguments):
    if len(arguments) != 3 or arguments[0] not in ("pack", "unpack"):
        sys.exit(__doc__)
    (pack if arguments[0] == "pack" else unpack)(*arguments[1:])


if __name__ == "__main__":
    main(sys.argv[1:])
