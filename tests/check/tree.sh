#!/bin/sh
# SPDX-License-Identifier: MIT
# The files of the repository, committed or about to be: short, text, no tabs, no path of one machine; no two sources of
# the library have one name, since their objects may go to one folder.
gate=tree
. tests/check/files.sh
need git
git rev-parse --is-inside-work-tree >/dev/null || finish 1

findings=$(
    c_files core port host | xargs wc -l | awk '$2 != "total" && $1 > 900 { print $2 ": " $1 " lines, more than 900" }'
    ls core/*/*.c port/*/*.c | sed 's,.*/,,' | LC_ALL=C sort | uniq -d | while IFS= read -r name; do
        echo "$name: the name of more than one source:" $(ls core/*/"$name" port/*/"$name" 2>/dev/null)
    done
    tab=$(printf '\t')
    git ls-files --cached --others --exclude-standard | while IFS= read -r file; do
        [ -f "$file" ] || continue
        # The READMEs' pictures, small ones, are the only binaries.
        case $file in
        *.png)
            [ "$(wc -c <"$file")" -le 131072 ] && grep -q "${file##*/}" README.md port/README.md && continue
            ;;
        esac
        LC_ALL=C tr -d '\000' <"$file" | cmp -s - "$file" || { echo "$file: binary"; continue; }
        # A recipe of make begins with a tab, and a table is made of them.
        case $file in
        Makefile | *.mk | *.tsv) ;;
        *) grep -n "$tab" "$file" | sed "s,^\([0-9]*\):.*,$file:\1: tab," ;;
        esac
        # Tests may fall back to the system's folder for temporary files where QTRI_TMP is not set.
        case $file in
        tests/*.[ch]) own='work|root|home' ;;
        *) own='work|root|home|tmp' ;;
        esac
        case $file in
        *.b64) continue ;; # any letters may follow a slash there
        esac
        grep -nE "(^|[^A-Za-z0-9_.)}*])/($own)(\$|[^A-Za-z0-9_])" "$file" | sed "s,^,$file:,; s,\$, (a path of one machine),"
    done
)
[ -z "$findings" ] || printf '%s\n' "$findings"
[ -z "$findings" ]
finish $?
