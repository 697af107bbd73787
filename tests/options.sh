# SPDX-License-Identifier: MIT
# Reads the options of a script, which has a function usage() and, in `known_options`, their names: "no-install" sets
# the variable no_install to yes, and "jobs=" sets the variable jobs to the next argument. The arguments that follow the
# options remain. `jobs` is the number of processors unless it is given.
jobs=$(nproc 2>/dev/null || echo 2)
while [ $# -gt 0 ]; do
    case $1 in
    -h | --help) usage; exit 0 ;;
    --?*) option=${1#--} ;;
    -*) usage >&2; exit 2 ;;
    *) break ;;
    esac
    variable=$(printf %s "$option" | tr - _)
    case " $known_options " in
    *" $option "*) eval "$variable=yes" ;;
    *" $option= "*)
        [ $# -gt 1 ] || { usage >&2; exit 2; }
        eval "$variable=\$2"
        shift
        ;;
    *) usage >&2; exit 2 ;;
    esac
    shift
done
