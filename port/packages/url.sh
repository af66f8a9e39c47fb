#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints where the library can be had, as the manifests say, or nothing. With an address it is written into them:
#   url.sh https://HOST/OWNER/qtri      library.json and idf_component.yml; library.properties gets it from here
set -eu
if [ $# = 0 ]; then
    sed -n 's/^url: "\(.*\)"$/\1/p' idf_component.yml
    exit
fi
case $1 in
*[!A-Za-z0-9:/._~-]* | *.git | */) wrong=1 ;;
https://*/*) wrong=0 ;;
*) wrong=1 ;;
esac
[ $# = 1 ] && [ $wrong = 0 ] || { echo "usage: url.sh https://HOST/OWNER/NAME, without .git" >&2; exit 2; }
sed -i -e '/^    "repository": /d' -e "s|^    \"license\": .*|&\n    \"repository\": {\"type\": \"git\", \"url\": \"$1.git\"},|" library.json
sed -i -e '/^url: /d' -e '/^repository: /d' -e "s|^license: .*|&\nurl: \"$1\"\nrepository: \"$1.git\"|" idf_component.yml
