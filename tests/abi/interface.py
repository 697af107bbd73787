# SPDX-License-Identifier: MIT
"""What a C header declares, and a library of empty functions that has that interface."""
import re
import subprocess


def without_comments(text):
    return re.sub(r"/\*.*?\*/", " ", text, flags=re.S)


def normal(text):
    """One space between words, none around punctuation: layout means nothing."""
    return re.sub(r"\s*([(),*])\s*", r"\1", " ".join(text.split()))


def declarations(text):
    """Everything in a header that a program may depend on, by kind and name."""
    text = without_comments(text)
    found = {}
    for name, value in re.findall(r"^[ \t]*#[ \t]*define[ \t]+(\w+)[ \t]*(.*)$", text, flags=re.M):
        found.setdefault(("macro", name), set()).add(normal(value))
    found = {key: " | ".join(sorted(values)) for key, values in found.items()}
    text = re.sub(r"^[ \t]*#.*$", "", text, flags=re.M)
    for body in re.findall(r"\benum\b[^{;]*\{(.*?)\}", text, flags=re.S):
        for part in body.split(","):
            if part.strip():
                name, _, value = normal(part).partition("=")
                found["enumerator", name.strip()] = value.strip()
    for body, name in re.findall(r"\btypedef\s+struct\b[^{;]*\{(.*?)\}\s*(\w+)\s*;", text, flags=re.S):
        found["type", name] = normal(f"struct {{{body}}}")
    for text_ in re.findall(r"\btypedef\b([^;{]*);", text):
        name = re.search(r"\(\*(\w+)\)|(\w+)$", normal(text_))
        found["type", name.group(1) or name.group(2)] = normal(text_)
    for result, name, parameters in functions(text):
        found["function", name] = normal(f"{result} {name}({parameters})")
    return found


def functions(text):
    """Result, name and parameters of each exported function."""
    text = without_comments(text)
    return [(normal(result), name, normal(parameters)) for result, name, parameters in
            re.findall(r"^MGDT_API\s+([^;()]*?)(\w+)\s*\(([^;]*?)\)\s*;", text, flags=re.M)]


def empty_library(compiler, header_text, script_text, folder):
    """Compiles a library that has the header's functions and does nothing."""
    folder.mkdir()
    (folder / "mgdt.h").write_text(header_text)
    (folder / "mgdt.map").write_text(script_text)
    bodies = [f"{result} {name}({parameters}) {{ {'' if result == 'void' else 'return 0;'} }}"
              for result, name, parameters in functions(header_text)]
    (folder / "empty.c").write_text('#include "mgdt.h"\n' + "\n".join(bodies) + "\n")
    # By names without a path: they are written to the debug information.
    subprocess.run([*compiler, "-std=c99", "-g", "-O0", "-shared", "-fPIC", "-I.", "empty.c", "-o", "libempty.so",
                    "-Wl,-soname,libmgdt.so.1", "-Wl,--version-script=mgdt.map"],
                   check=True, cwd=folder)
    return folder / "libempty.so"


def nodes_of(headers):
    """The version node of each function, by name: that of the first of the headers, oldest first,
    that declares it. Headers are named mgdt-1.0.h and the like."""
    nodes = {}
    for path in headers:
        node = "MGDT_" + re.fullmatch(r"mgdt-([\d.]+)\.h", path.name)[1]
        for _, name, _ in functions(path.read_text()):
            nodes.setdefault(name, node)
    return nodes


LATER = "MGDT_LATER"


def version_script(header_text, nodes):
    """Every function in its node; one that has none in the node of a release to come."""
    def number(node):
        return [int(part) for part in re.findall(r"\d+", node)] or [1000000]

    placed = {name: nodes.get(name, LATER) for _, name, _ in functions(header_text)}
    text, before = "", ""
    for node in sorted(set(placed.values()), key=number):
        listed = [name for name in placed if placed[name] == node]
        text += f"{node} {{ global: {' '.join(n + ';' for n in listed)} " + \
            ("" if before else "local: *; ") + f"}} {before};\n"
        before = node
    return text
