#!/bin/sh
# Installs what the build needs from Debian, if any of it is missing. Needs no network when nothing
# is missing. usage: tools/install_dependencies.sh [--list | --arm64]
#   --list    prints the packages and installs nothing
#   --arm64   instead installs what builds the runtime for 64-bit ARM and runs its tests
# shellcheck disable=SC2086  # lists of packages are split on purpose
set -eu

# The one list of packages. openimageio-tools: the CMake package of libopenimageio-dev names its
# programs. Those from glslang-tools on are of the GPU passes, which are left out without them, and
# of their tests, which run on a processor by lavapipe and llvmpipe.
packages="
  g++ cmake ninja-build
  libceres-dev libeigen3-dev
  libopencv-dev
  libopenimageio-dev openimageio-tools zlib1g-dev
  libembree-dev libtbb-dev
  libhwy-dev
  libopenmpi-dev openmpi-bin
  libcli11-dev nlohmann-json3-dev libfmt-dev
  libgtest-dev libgmock-dev libbenchmark-dev
  gnuplot-nox
  glslang-tools spirv-tools spirv-cross
  libvulkan-dev libvulkan-volk-dev
  mesa-vulkan-drivers vulkan-validationlayers
  libegl-dev libgles-dev libgl1-mesa-dri
"

arm64_packages="
  g++-aarch64-linux-gnu cmake ninja-build
  qemu-user
  libhwy-dev:arm64
  libgtest-dev:arm64
"

foreign=
case "${1:-}" in
  --list)
    printf '%s\n' $packages
    exit 0
    ;;
  --arm64)
    packages=$arm64_packages
    foreign=arm64
    ;;
  '') ;;
  *)
    echo "install_dependencies.sh: '$1' is not an option; those are --list and --arm64." >&2
    exit 1
    ;;
esac

if ! command -v dpkg-query > /dev/null; then
  echo "install_dependencies.sh: this is not Debian or a relative of it, so install these packages yourself:" \
    $packages >&2
  exit 1
fi

# is_installed PACKAGE[:ARCHITECTURE]; one package may be there for several architectures.
native=$(dpkg --print-architecture)
is_installed() {
  case "$1" in
    *:*) architecture=${1#*:} ;;
    *) architecture=$native ;;
  esac
  dpkg-query --show --showformat='${db:Status-Status} ${Architecture}\n' "$1" 2> /dev/null |
    grep --quiet --extended-regexp "^installed ($architecture|all)\$"
}

missing=
for package in $packages; do
  if ! is_installed "$package"; then missing="$missing $package"; fi
done
if [ -z "$missing" ]; then exit 0; fi

as_root=
if [ "$(id -u)" -ne 0 ]; then
  if command -v sudo > /dev/null && { [ -t 0 ] || sudo --non-interactive true 2> /dev/null; }; then
    as_root=sudo
  else
    echo "install_dependencies.sh: these Debian packages are missing and need root to install:$missing" >&2
    exit 1
  fi
fi

echo "Installing from Debian:$missing"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
if [ -n "$foreign" ]; then $as_root dpkg --add-architecture "$foreign"; fi
if ! { $as_root apt-get update &&
  $as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --no-install-recommends $missing; } > "$log" 2>&1; then
  tail -n 20 "$log" >&2
  echo "install_dependencies.sh: apt-get could not install:$missing" >&2
  exit 1
fi
