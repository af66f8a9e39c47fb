#!/bin/sh
# SPDX-License-Identifier: MIT
# The files of the repository, committed or about to be: short, text, no tabs, no path of one machine; no two sources of
# the library have one name, since their objects may go to one folder.
gate=tree
. tests/check/files.sh
need git
git rev-parse --is-inside-work-tree >/dev/null || finish 1

# search OPTION...: lines of those files, as `file:number:line`
search() { LC_ALL=C git grep --untracked -an "$@"; }

# A regular expression of a path that begins with one of these folders.
path() { echo "(^|[^A-Za-z0-9_.)}*])/($1)(\$|[^A-Za-z0-9_])"; }

findings=$(
    c_files core port host | xargs wc -l | awk '$2 != "total" && $1 > 900 { print $2 ": " $1 " lines, more than 900" }'
    ls core/*/*.c port/*/*.c | sed 's,.*/,,' | LC_ALL=C sort | uniq -d | while IFS= read -r name; do
        echo "$name: the name of more than one source:" $(ls core/*/"$name" port/*/"$name" 2>/dev/null)
    done
    # Git's word for a binary is a file that holds a zero. The READMEs' pictures, small ones, are the only binaries.
    git ls-files --eol --cached --others --exclude-standard | awk -F '\t' '$1 ~ / w\/-text/ || $2 ~ /\.png$/ { print $2 }' | while IFS= read -r file; do
        case $file in
        *.png)
            [ "$(wc -c <"$file")" -le 131072 ] && grep -q "${file##*/}" README.md port/README.md && continue
            ;;
        esac
        echo "$file: binary"
    done
    # A recipe of make begins with a tab, and a table is made of them.
    search -F -e "$(printf '\t')" -- . ':!Makefile' ':!*.mk' ':!*.tsv' ':!*.png' | sed 's,^\([^:]*:[0-9]*\):.*,\1: tab,'
    # Any letters may follow a slash in base64. Tests may fall back to the system's folder for temporary files where QTRI_TMP
    # is not set.
    machine='work|root|home'
    search -E -e "$(path "$machine")" -- 'tests/*.[ch]' | sed 's,$, (a path of one machine),'
    search -E -e "$(path "$machine|tmp")" -- . ':!tests/*.[ch]' ':!*.b64' ':!*.png' | sed 's,$, (a path of one machine),'
)
[ -z "$findings" ] || printf '%s\n' "$findings"
[ -z "$findings" ]
finish $?
