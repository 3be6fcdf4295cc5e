#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
#
# From a fresh clone to terrain on a globe: installs what the build needs (Debian 12, Ubuntu), builds, turns
# the DEM in data/ into a terrain set with a preview page, and says how to look at it. May be run again.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
output=$root/quickstart-terrain
log=$root/build/quickstart.log
. "$root/utils/packages.sh"

# Runs a command silently; its words appear only if it fails.
quietly() {
  "$@" >>"$log" 2>&1 </dev/null && return
  tail -n 40 "$log" >&2
  echo "Failed: $*   (everything it said: $log)" >&2
  return 1
}

mkdir -p "$root/build"
: >"$log"

echo "1/3 Packages"
qmesh_install "${QMESH_BUILD_PACKAGES[@]}" "${QMESH_VIEW_PACKAGES[@]}"

echo "2/3 Building; a few minutes the first time"
quietly cmake -S "$root" -B "$root/build" -DCMAKE_BUILD_TYPE=Release -DQMESH_BUILD_TESTS=OFF
quietly cmake --build "$root/build" --target gdal2qmesh qmeshinfo gdal_QMESH --parallel "$(nproc)"

echo "3/3 Terrain of data/jacksboro_srtm3.tif"
"$root/build/bin/gdal2qmesh" --overwrite -w cesium -t "Jacksboro, Tennessee" -c "SRTM, NASA" \
  "$root/data/jacksboro_srtm3.tif" "$output" </dev/null | grep -v '^to look at it'

cat <<END

The terrain is in $output

To look at it, start a web server:

    python3 -m http.server 8000 --directory $(printf %q "$output")

and open http://localhost:8000/ in a browser. The page fetches CesiumJS from the internet; to keep a copy
beside the terrain instead, add --cesium DIR to gdal2qmesh.

The commands gdal2qmesh and qmeshinfo, and the driver for GDAL, work from where they were built:

    export PATH=$(printf %q "$root/build/bin"):\$PATH GDAL_DRIVER_PATH=$(printf %q "$root/build/gdalplugins")
END
