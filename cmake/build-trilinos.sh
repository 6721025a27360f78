#!/usr/bin/env bash
# Builds the Trilinos packages that Rhegma uses, with the Kokkos OpenMP back end, from the distribution's own source
# package. Everything lands in one cache folder; a build that was stopped goes on where it stopped.
#
#   build-trilinos.sh CACHE_DIR        installs into CACHE_DIR/install
set -euo pipefail

cache=${1:?usage: build-trilinos.sh CACHE_DIR}
mkdir -p "$cache"
cache=$(cd "$cache" && pwd)
install=$cache/install
build=$cache/build
log=$cache/build.log
here=$(cd "$(dirname "$0")" && pwd)
as_root=""
[ "$(id -u)" = 0 ] || as_root=sudo

fail() { echo "trilinos: $1" >&2; exit 1; }

if [ -f "$install/.complete" ]; then
  echo "trilinos: already built in $install"
  exit 0
fi

# Repeats the binary entries of the distribution's own archives (all their options, keys above all) as source entries,
# in files of our own.
add_source_entries() {
  local hosts lists=/etc/apt/sources.list.d file
  hosts=$(apt-get indextargets --format '$(ORIGIN)|$(REPO_URI)' 'Created-By: Packages' | sed -nE 's#^(Debian|Ubuntu)\|(.*[^/])/*$#\2#p' | sort -u)
  [ -n "$hosts" ] || fail "no package archive of the distribution is configured, so its source packages can't be found"
  for file in "$lists"/*.sources; do
    [ ! -f "$file" ] || awk -v RS= -v ORS='\n\n' -v hosts="$hosts" '
      BEGIN { n = split(hosts, host, "\n") }
      { for (i = 1; i <= n; ++i) if (index($0, host[i])) { sub(/Types:[^\n]*/, "Types: deb-src"); print; break } }' "$file"
  done | $as_root tee "$lists/rhegma-source.sources" >/dev/null
  for file in /etc/apt/sources.list "$lists"/*.list; do
    [ ! -f "$file" ] || { grep -hE '^deb ' "$file" | grep -F "$hosts" | sed 's/^deb /deb-src /'; } || true
  done | $as_root tee "$lists/rhegma-source.list" >/dev/null
}

# One build at a time in one cache: a second caller waits for the first and finds its result.
exec 9>"$cache/lock"
if ! flock -n 9; then
  echo "trilinos: another build is using $cache; waiting for it"
  flock 9
  [ ! -f "$install/.complete" ] || exit 0
fi

if ! ls "$cache"/source/CMakeLists.txt >/dev/null 2>&1; then
  if ! apt-get indextargets --format '$(ORIGIN)' 'Created-By: Sources' 2>/dev/null | grep -qE '^(Debian|Ubuntu)$'; then
    echo "trilinos: adding the distribution's source packages in /etc/apt/sources.list.d/rhegma-source.*"
    add_source_entries
    $as_root apt-get update -qq || fail "apt-get update failed; see the lines above"
  fi
  echo "trilinos: fetching the source package (about 170 MB)"
  mkdir -p "$cache/download"
  (cd "$cache/download" && apt-get source --download-only trilinos >"$log" 2>&1) || { tail -n 5 "$log" >&2; fail "the source package could not be fetched"; }
  rm -rf "$cache/source.part"
  echo "trilinos: unpacking"
  (cd "$cache/download" && dpkg-source --no-check -x trilinos_*.dsc "$cache/source.part" >>"$log" 2>&1) \
    || { tail -n 5 "$log" >&2; fail "the source package could not be unpacked"; }
  mv "$cache/source.part" "$cache/source"
fi

if [ ! -f "$build/build.ninja" ]; then
  echo "trilinos: configuring"
  cmake -S "$cache/source" -B "$build" -G Ninja -C "$here/trilinos-openmp.cmake" -DCMAKE_INSTALL_PREFIX="$install" \
    >>"$log" 2>&1 || { tail -n 15 "$log" >&2; rm -f "$build/build.ninja"; fail "configuring failed; the whole log is $log"; }
fi

echo "trilinos: compiling (about 30 CPU minutes); log in $log"
# A progress line: overwritten on a terminal, every tenth of the work elsewhere.
status=0
NINJA_STATUS='@%f %t@' ninja -C "$build" 2>&1 | tee -a "$log" | awk -v terminal="$([ -t 1 ] && echo 1 || echo 0)" '
  match($0, /^@[0-9]+ [0-9]+@/) {
    split(substr($0, 2, RLENGTH - 2), n, " ")
    tenth = int(10 * n[1] / n[2])
    if (terminal) { printf "\rtrilinos: %d of %d files", n[1], n[2]; fflush() }
    else if (tenth != last) { printf "trilinos: %d of %d files\n", n[1], n[2]; fflush(); last = tenth }
  }
  END { if (terminal) print "" }' || status=$?
[ "$status" = 0 ] || { tail -n 30 "$log" >&2; fail "compiling failed; the whole log is $log"; }
ninja -C "$build" install >>"$log" 2>&1 || fail "installing failed; the whole log is $log"
touch "$install/.complete"
rm -rf "$build" "$cache/download"
echo "trilinos: installed in $install"
