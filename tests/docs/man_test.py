#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The manual page and the program say the same: subcommands, options, formats, kinds of points,
order schemes, exit statuses. And mandoc and groff have nothing to say about the page.

  man_test.py PROGRAM PAGE        the program mgdt
  man_test.py PROGRAM PAGE --one  one that has no subcommands
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.append(str(Path(__file__).resolve().parents[1]))
from checks import check, differences, finish, output_of


def lacking(program, page):
    return differences(program, page, "the page lacks", "the program lacks")


def options_in_help(text):
    """Each option with its names, `-o,--output`, as one set."""
    lines = re.findall(r"^  (-[-\w]+(?:,-[-\w]+)*)", text, flags=re.M)
    return {frozenset(line.split(",")) for line in lines}


def part(text, title):
    """A list that the help ends with: first words of the lines under `Title`."""
    body = re.search(rf"^{title}[^\n]*:\n((?:  [^\n]*\n)+)", text, flags=re.M)
    return [line.split() for line in body.group(1).splitlines() if not line.startswith("  [")] if body else []


class Page:
    def __init__(self, text):
        text = "\n".join(line for line in text.split("\n") if not line.startswith('.\\"'))
        parts = re.split(r"^\.Sh (.*)\n", text, flags=re.M)
        self.sections = dict(zip(parts[1::2], parts[2::2]))

    @staticmethod
    def flags(line):
        """`.It Fl o Ar file , Fl -output Ar file` has -o and --output."""
        return frozenset("-" + flag for flag in re.findall(r"\bFl (-?[-\w]+)", line))

    def described(self):
        """Options with an entry of their own, as sets of names."""
        return [self.flags(line) for line in re.findall(r"^\.It (.*\bFl .*)$", self.sections["DESCRIPTION"], flags=re.M)]

    def synopsis(self):
        """Names of options by subcommand."""
        found = {}
        for usage in re.split(r"^\.Nm\n", self.sections["SYNOPSIS"], flags=re.M):
            command = re.search(r"^\.Cm (\w+)", usage, flags=re.M)
            if command:
                arguments = re.findall(r"^\.Ar (\w+)", usage, flags=re.M)
                found[command.group(1)] = (set().union(*map(self.flags, usage.split("\n"))), arguments)
        return found

    def entries(self, section):
        return re.findall(r"^\.It (?:Cm |Ev )?([-\w]+)\s*$", self.sections[section], flags=re.M)


def compare(program, page):
    help_of = {"": output_of(program, "--help")}
    commands = [words[0] for words in part(help_of[""], "Subcommands")]
    check("the program has subcommands", "" if len(commands) >= 4 else str(commands))
    for command in commands:
        help_of[command] = output_of(program, command, "--help")

    synopsis = page.synopsis()
    check("subcommands in the synopsis", lacking(set(commands), set(synopsis)))
    check("subcommands described", lacking(set(commands), set(page.entries("DESCRIPTION"))))

    everywhere = options_in_help(help_of[""])
    help_option = frozenset(("-h", "--help"))
    for command in commands:
        options = options_in_help(help_of[command])
        everywhere |= options
        used, arguments = synopsis.get(command, (set(), []))
        # The synopsis has one name of each, the short one if there is one.
        names = {min(option, key=len) for option in options if option != help_option}
        check(f"options of {command} in the synopsis", lacking(names, used))
        positionals = re.search(r"^Positionals:\n((?:  [^\n]*\n)+)", help_of[command], flags=re.M)
        lines = positionals.group(1).splitlines() if positionals else []
        wanted = [line.split()[0] for line in lines if re.match(r"  \w", line)]
        check(f"arguments of {command}", "" if wanted == arguments else f"{arguments}, not {wanted}")
    show = lambda options: {"/".join(sorted(o)) for o in options}
    described = page.described()
    check("each option described", lacking(show(everywhere), show(described)))
    check("and once", " ".join(show({d for d in described if described.count(d) > 1})))

    formats = part(help_of["triangulate"], "Formats")
    check("formats", lacking({f[0] for f in formats}, set(page.entries("FORMATS"))))
    check("extensions", lacking({e for f in formats for e in f if re.fullmatch(r"\.\w+", e)},
                                set(re.findall(r"\.\w+\b", " ".join(re.findall(r"^\.Pa (.*)$", page.sections["FORMATS"], flags=re.M))))))
    check("kinds of points", lacking({k[0] for k in part(help_of["generate"], "Kinds")}, set(page.entries("KINDS OF POINTS"))))
    statuses = {words[0] for words in part(help_of[""], "Exit codes")}
    check("exit statuses", lacking(statuses, set(page.entries("EXIT STATUS"))))
    schemes = re.search(r"Order of insertion: (.*)", help_of["triangulate"]).group(1).split(", ")
    entry = re.search(r"^\.It Fl -scheme.*?(?=^\.It)", page.sections["DESCRIPTION"], flags=re.M | re.S).group(0)
    check("order schemes", lacking(set(schemes), set(re.findall(r"^\.Cm ([-\w]+)", entry, flags=re.M))))
    variables = {"MGDT_ISA"} | set(re.findall(r"Env:(\w+)", "".join(help_of.values())))
    check("environment", lacking(variables, set(page.entries("ENVIRONMENT"))))


def compare_one(program, page):
    show = lambda options: {"/".join(sorted(o)) for o in options}
    options = options_in_help(output_of(program, "--help"))
    check("the program has options", "" if len(options) >= 5 else str(options))
    check("each option described", lacking(show(options), show(page.described())))
    used = set().union(*map(page.flags, page.sections["SYNOPSIS"].split(f".Nm {Path(program).name}\n")[1].split("\n")))
    asks = frozenset(("-h", "--help")), frozenset(("--version",))
    check("options in the synopsis", lacking({min(option, key=len) for option in options if option not in asks}, used))


def lint(path):
    environment = dict(os.environ, LC_ALL="C.UTF-8")
    run = subprocess.run(["mandoc", "-Tlint", str(path)], capture_output=True, text=True, env=environment)
    # Our other page is not installed here.
    report = [line for line in (run.stdout + run.stderr).splitlines() if "manual not found: Xr mgdt 1" not in line]
    check("mandoc has nothing to say", "\n".join(report) or ("" if run.returncode in (0, 1) else f"status {run.returncode}"))
    run = subprocess.run(["groff", "-mdoc", "-ww", "-z", "-Tutf8", str(path)], capture_output=True, text=True, env=environment)
    check("groff has nothing to say", run.stdout + run.stderr or ("" if run.returncode == 0 else f"status {run.returncode}"))


def examples(program, page):
    """The examples of the page run as they stand."""
    text = page.sections["EXAMPLES"]
    # The last one is of a file that another program wrote: here TetGen's format stands in for it.
    # The samples are of the reader's own.
    blocks = re.findall(r"^\.Bd -literal.*?\n(.*?)^\.Ed", text, flags=re.M | re.S)
    check("there are examples", "" if len(blocks) >= 3 else str(blocks))
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, PATH=f"{Path(program).resolve().parent}:{os.environ['PATH']}")
        setup = "mgdt generate uniform 100 -o p.npy\nmgdt triangulate -q p.npy -o mesh.ele\n"
        setup += "printf 'x,y,z,t\\n0,0,0,1\\n2,0,0,2\\n0,2,0,3\\n0,0,2,4\\n' >samples.csv\n"
        setup += "mgdt generate uniform 100 -o atoms.xyz\nmgdt generate uniform 100 -o scan.ply\n"
        for block in (setup, *blocks):
            run = subprocess.run(["sh", "-eu", "-c", block], cwd=folder, env=environment, capture_output=True, text=True)
            check(f"example '{block.splitlines()[0].strip()}'", run.stdout + run.stderr if run.returncode else "")


def main():
    program, path = sys.argv[1], Path(sys.argv[2])
    page = Page(path.read_text())
    if sys.argv[3:] == ["--one"]:
        compare_one(program, page)
        lint(path)
    else:
        compare(program, page)
        lint(path)
        examples(program, page)
    finish()


if __name__ == "__main__":
    main()
