#!/bin/sh
# SPDX-License-Identifier: MIT
# One version, that of core/include/qtri/version.h, in every manifest; a licence line in every source.
gate=version
. tests/check/files.sh
need git awk
version=$(sh port/packages/version.sh) || { echo "core/include/qtri/version.h: no version"; finish 1; }
status=0

# says FILE WHERE FOUND
says()
{
    [ "$3" = "$version" ] || { echo "$1: $2 is '$3', not $version as in core/include/qtri/version.h"; status=1; }
}
says library.json '"version"' "$(sed -n 's/^ *"version": "\(.*\)",$/\1/p' library.json)"
says idf_component.yml 'version:' "$(sed -n 's/^version: "\(.*\)"$/\1/p' idf_component.yml)"
says CHANGELOG.md 'the first heading' "$(sed -n 's/^## \([^ ]*\).*/\1/p' CHANGELOG.md | head -n 1)"
says CHANGELOG.md 'a heading' "$(sed -n 's/^## \([^ ]*\).*/\1/p' CHANGELOG.md | grep -Fx "$version" | head -n 1)"

# One address, or none: port/packages/url.sh writes it.
url=$(sh port/packages/url.sh)
[ "$(sed -n 's/^ *"repository": .*"url": "\(.*\)\.git".*/\1/p' library.json)" = "$url" ] &&
    [ "$(sed -n 's/^repository: "\(.*\)\.git"$/\1/p' idf_component.yml)" = "$url" ] ||
    { echo "library.json, idf_component.yml: not one address (port/packages/url.sh)"; status=1; }

# The options of the Kconfig files are those of config.h.
options=$(sed -n 's/^#define \(QTRI_WITH_[A-Z0-9_]*\) 1$/\1/p' core/include/qtri/config.h | sort)
[ "$options" = "$(sed -n 's/^config \(QTRI_WITH_.*\)/\1/p' Kconfig | sort)" ] ||
    { echo "Kconfig: its options are not those of core/include/qtri/config.h"; status=1; }

# The manifests are JSON and YAML, as far as there is something here to read them.
if command -v jq >/dev/null; then
    jq -e '.name == "qtri" and .license == "MIT"' library.json >/dev/null || { echo "library.json: unreadable"; status=1; }
fi

unlicensed=$(git ls-files --cached --others --exclude-standard -- '*.[chS]' '*.cpp' '*.hpp' '*.inc' '*.ld' '*.sh' '*.mk' '*.awk' '*.cmake' '*.ino' \
    '*/CMakeLists.txt' CMakeLists.txt Makefile .ci/run | awk '{
        licensed = lines = 0
        while (lines < 3 && (read = getline line <$0) > 0) { lines++; if (line ~ /SPDX-License-Identifier: MIT/) licensed = 1 }
        close($0)
        if (read >= 0 && !licensed) print $0 ": no SPDX line"
    }')
[ -z "$unlicensed" ] || { printf "%s\n" "$unlicensed"; status=1; }
finish $status
