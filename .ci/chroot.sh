#!/usr/bin/env bash
# Tries bootstrap.sh on a bare Debian 12: a minimal system with git and nothing else, and a clean clone of this
# repository's HEAD. debootstrap makes the system in FOLDER, which stays as it is; the trial runs in a copy,
# FOLDER.trial, that is made anew each time and left for inspection. Needs root.
#
#   .ci/chroot.sh FOLDER [COMMAND…]      default: ./bootstrap.sh && ./bootstrap.sh test
#
# Packages are reached the way this machine reaches them: mirror and http settings are read from its apt.
set -euo pipefail
(($#)) || { sed -n '2,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 2; }
bare=$(realpath -m "$1")
folder=$bare.trial
shift
repository=$(git -C "$(dirname "${BASH_SOURCE[0]}")" rev-parse --show-toplevel)

if [[ ! -e $bare/etc/debian_version ]]; then
    mirror=$(apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(COMPONENT)' 'Identifier: Packages' |
        awk '$2 == "bookworm" && $3 == "main" { print $1; exit }')
    [[ $mirror ]] || { echo "apt knows no mirror of Debian 12 (bookworm main)" >&2; exit 2; }
    debootstrap --variant=minbase --include=git bookworm "$bare" "$mirror"
fi
rm -rf "$folder"
cp -a "$bare" "$folder"
apt-config dump | grep -iE '^Acquire::(https?|Check-)' >"$folder/etc/apt/apt.conf.d/90-as-outside" || true
cp /etc/resolv.conf "$folder/etc/resolv.conf"
git clone --quiet --no-hardlinks "$repository" "$folder/drawbead"

if (($#)); then
    command="$*"
else
    command='./bootstrap.sh && ./bootstrap.sh test'
fi
# A mount namespace of its own: /proc goes away with it.
unshare --mount bash -c '
    mount -t proc proc "$1/proc"
    exec chroot "$1" /usr/bin/env -i HOME=/root TERM=dumb PATH=/usr/sbin:/usr/bin:/sbin:/bin \
        bash -c "cd /drawbead && $2" </dev/null
' - "$folder" "$command"
