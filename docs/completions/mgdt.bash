# SPDX-License-Identifier: MIT
# Completion of mgdt's commands, options and their names, for bash. Asks the program, so that it fits the
# one that is installed.

_mgdt() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
    local program=${COMP_WORDS[0]} command=${COMP_WORDS[1]} names
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        names=$("$program" --help 2>/dev/null |
            sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p; s/^ *\(-h,\)*\(--[a-z-]*\).*/\2/p')
    elif [ "$before" = --from ] || [ "$before" = --to ] || [ "$before" = --places-from ]; then
        names=$("$program" --help 2>/dev/null |
            sed -n '/^Formats/,/^  \[/s/^  \([a-z][a-z0-9]*\) .*/\1/p')
    elif [ "$before" = --scheme ] || [ "$before" = --method ] || [ "$before" = --outside ]; then
        names=$("$program" "$command" --help 2>/dev/null |
            sed -n "s/^  $before NAME:{\\(.*\\)}.*/\\1/p; s/^  $before NAME .*: \\(.*\\)/\\1/p" | tr -d ' ' | tr ',' ' ')
    elif [ "${word#-}" != "$word" ]; then
        names=$("$program" "$command" --help 2>/dev/null |
            sed -n 's/^  \(-[a-z],\)*\(--[a-z-]*\).*/\2/p')
    elif [ "$command" = generate ] && [ "$COMP_CWORD" -eq 2 ]; then
        names=$("$program" generate --help 2>/dev/null |
            sed -n '/^Kinds/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p')
    else
        compopt -o default 2>/dev/null
        return
    fi
    while IFS= read -r name; do COMPREPLY+=("$name"); done < <(compgen -W "$names" -- "$word")
}
complete -F _mgdt mgdt
