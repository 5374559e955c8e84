#!/usr/bin/env bash
# From a bare Debian 12 to a working drawbead. See `./bootstrap.sh --help`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

usage() {
    cat <<'TEXT'
usage: ./bootstrap.sh                     install what the build needs, build, show one check
       ./bootstrap.sh test                install what the tests need too, build, run the tests
       ./bootstrap.sh packages SECTION…   only install these sections of packages.txt (build, test, ci, bench)

Packages come from Debian through apt, which is called only when one is missing; that takes root or sudo.
The tool is left in build/package/src/cli/drawbead (in build/release/ by `test`).
TEXT
}

# Names of the packages in the given sections of packages.txt.
packages_of() {
    local wanted=" $* " section="" line
    while read -r line; do
        case $line in
        "" | \#*) ;;
        \[*\]) section=${line:1:-1} ;;
        *) [[ $wanted != *" $section "* ]] || printf '%s\n' "$line" ;;
        esac
    done <packages.txt
}

install_packages() {
    local packages installed missing=() package
    mapfile -t packages < <(packages_of "$@")
    ((${#packages[@]})) || { echo "bootstrap: packages.txt has no section of that name: $*" >&2; exit 2; }
    if ! command -v dpkg-query >/dev/null; then
        echo "bootstrap: this is not a Debian system; install the counterparts of these packages, then use the" >&2
        echo "bootstrap: presets of cmake: ${packages[*]}" >&2
        exit 2
    fi
    installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${packages[@]}" 2>/dev/null || true)
    for package in "${packages[@]}"; do
        [[ $'\n'$installed$'\n' == *$'\n'"$package installed"$'\n'* ]] || missing+=("$package")
    done
    ((${#missing[@]})) || return 0

    local as_root=(env)
    if ((EUID != 0)); then
        if ! command -v sudo >/dev/null; then
            echo "bootstrap: packages are missing and this is neither root nor is sudo there; as root, run:" >&2
            echo "bootstrap:   apt-get update && apt-get install -y --no-install-recommends ${missing[*]}" >&2
            exit 2
        fi
        as_root=(sudo env)
    fi
    echo "bootstrap: installing ${missing[*]}"
    as_root+=(DEBIAN_FRONTEND=noninteractive apt-get -q)
    "${as_root[@]}" update
    "${as_root[@]}" install -y --no-install-recommends "${missing[@]}"
}

build() {
    cmake --preset "$1"
    cmake --build --preset "$1" --parallel "$(nproc)"
}

case ${1-} in
"")
    install_packages build
    build package
    tool=build/package/src/cli/drawbead
    deck=samples/hood_one_list_0000.rad
    printf '\n$ %s check %s\n' "$tool" "$deck"
    status=0
    "$tool" check "$deck" || status=$?
    ((status <= 1)) || exit "$status" # 1: it found what the sample is made to show
    ;;
test)
    install_packages build test
    build release
    ctest --preset release --output-on-failure --no-tests=error --parallel "$(nproc)"
    ;;
packages)
    shift
    (($#)) || { usage >&2; exit 2; }
    install_packages "$@"
    ;;
-h | --help)
    usage
    ;;
*)
    usage >&2
    exit 2
    ;;
esac
