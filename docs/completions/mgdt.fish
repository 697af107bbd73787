# SPDX-License-Identifier: MIT
# Completion of mgdt's commands, options and their names, for fish. Asks the program, so that it fits the
# one that is installed.

function __mgdt_command
    set -l words (commandline -opc)
    test (count $words) -ge 2; and echo $words[2]
end

function __mgdt_commands
    mgdt --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z]*\)  *\(.*\)/\1\t\2/p'
end

function __mgdt_options
    mgdt (__mgdt_command) --help 2>/dev/null | sed -n 's/^  \(-[a-z],\)*\(--[a-z-]*\).*/\2/p'
end

function __mgdt_formats
    mgdt --help 2>/dev/null | sed -n '/^Formats/,/^  \[/s/^  \([a-z][a-z0-9]*\) .*/\1/p'
end

function __mgdt_kinds
    mgdt generate --help 2>/dev/null | sed -n '/^Kinds/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p'
end

complete -c mgdt -n 'not __mgdt_command' -f -a '(__mgdt_commands)'
complete -c mgdt -n '__mgdt_command >/dev/null; and string match -q -- "-*" (commandline -ct)' -a '(__mgdt_options)'
complete -c mgdt -n 'test (__mgdt_command) = generate' -f -a '(__mgdt_kinds)'
complete -c mgdt -l from -x -a '(__mgdt_formats)'
complete -c mgdt -l to -x -a '(__mgdt_formats)'
