# SPDX-License-Identifier: MIT
# Copyright (c) 2026 the qmesh authors
#
# The Debian and Ubuntu packages the project needs, said once; for sourcing by bash scripts.
#
# An entry is a package, or COMMAND:PACKAGE where the command from anywhere will do, or PACKAGE|PACKAGE
# where the first that this release of Debian or Ubuntu has is meant, or PACKAGE? where it may be missing.

QMESH_BUILD_PACKAGES=(
  g++:g++ cmake:cmake make:make libgdal-dev libdeflate-dev nlohmann-json3-dev libcgal-dev libeigen3-dev
)
QMESH_VIEW_PACKAGES=(python3:python3)
QMESH_TEST_PACKAGES=(
  libgtest-dev libbenchmark-dev clang:clang "libclang-rt-dev?"
  ccache:ccache ninja:ninja-build
  gdal-bin python3-gdal python3-numpy python3-scipy python3-pytest python3-pytest-xdist python3-jsonschema
  node:nodejs npm:npm "chromium|chromium-browser"
  pkg-config:pkg-config man:man-db clang-format:clang-format clang-tidy:clang-tidy
)
QMESH_DOCS_PACKAGES=(python3-sphinx python3-myst-parser furo)
QMESH_DOCS_TEST_PACKAGES=(nginx-light apache2-bin man-db)

# For the tests of the QGIS plugin: QGIS without a screen, and a screen that is none.
QMESH_QGIS_PACKAGES=(qgis python3-qgis xvfb xauth imagemagick)

qmesh_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

qmesh_known_to_apt() {
  [ -n "$(apt-cache policy "$1" 2>/dev/null | awk '/Candidate:/ && $2 != "(none)"')" ]
}

# Whether an entry needs nothing more.
qmesh_satisfied() {
  local entry=${1%\?} package
  case $entry in
    *:*) command -v "${entry%%:*}" >/dev/null || qmesh_installed "${entry#*:}" ;;
    *) for package in ${entry//|/ }; do qmesh_installed "$package" && return 0; done; return 1 ;;
  esac
}

# The package to install for an entry; nothing where apt has none and none is needed.
qmesh_package() {
  local entry=${1#*:} package
  for package in $(tr '|?' '  ' <<<"$entry"); do
    if qmesh_known_to_apt "$package"; then echo "$package"; return; fi
  done
  case $entry in *\?) ;; *) echo "${entry%%|*}" ;; esac
}

qmesh_as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; return; fi
  if ! command -v sudo >/dev/null; then
    echo "Packages are missing; run this as root, or install sudo." >&2
    return 1
  fi
  sudo "$@"
}

# qmesh_install ENTRY...: installs what is missing, and does nothing at all where nothing is.
qmesh_install() {
  local entry missing=() packages=()
  for entry in "$@"; do qmesh_satisfied "$entry" || missing+=("$entry"); done
  [ ${#missing[@]} -gt 0 ] || return 0
  if ! command -v apt-get >/dev/null; then
    echo "This machine has no apt-get. Install by hand what these Debian packages hold: ${missing[*]}" >&2
    return 1
  fi
  qmesh_as_root apt-get update -q </dev/null
  for entry in "${missing[@]}"; do packages+=($(qmesh_package "$entry")); done
  [ ${#packages[@]} -gt 0 ] || return 0
  echo "Installing ${packages[*]}"
  qmesh_as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -q --no-install-recommends "${packages[@]}" </dev/null
}
