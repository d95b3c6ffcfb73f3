#!/bin/sh
# Installs the Debian 12 packages that Halsted is built from and tested with: the one list.
# Works as root or as a user with sudo; does nothing (and needs no network) when everything is there.
set -eu

packages="
  g++ cmake ninja-build
  libeigen3-dev
  libosmesa6-dev libgl-dev libglfw3-dev libimgui-dev fonts-dejavu-core
  libspdlog-dev libcli11-dev libtomlplusplus-dev nlohmann-json3-dev
  libsqlite3-dev libpng-dev zlib1g-dev ffmpeg
  pkg-config libusb-1.0-0-dev umockdev libumockdev-dev
  libgtest-dev libgmock-dev libbenchmark-dev
  clang libclang-rt-14-dev
  xvfb
"

missing=""
for package in $packages; do
  state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" -eq 0 ]; then
  as_root=""
elif command -v sudo >/dev/null 2>&1; then
  as_root="sudo"
else
  echo "install-packages.sh: missing$missing; run as root or install sudo" >&2
  exit 3
fi

echo "Installing:$missing"
$as_root apt-get update -q
# shellcheck disable=SC2086  # the list is meant to split into words
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
