#!/usr/bin/env bash
# Installs with apt the Debian 12 packages that are missing:  cmake/setup.sh [build|test|bench]
# `test` and `bench` include `build`. Asks for nothing, and needs no network, when all are there.
set -euo pipefail

# The one list of packages: group, then its packages, then why.
packages='
build g++ cmake ninja-build pkg-config                  # compiler and build
build libvulkan-dev mesa-vulkan-drivers                 # Vulkan with vulkan_raii.hpp, and lavapipe
build glslang-tools spirv-tools                         # GLSL to SPIR-V, and spirv-val
build libglm-dev libfmt-dev libspdlog-dev               # vectors, text, log
build libtinyobjloader-dev libpugixml-dev               # scenes: OBJ with MTL, Nori XML
build libstb-dev libopenexr-dev                         # images: PNG and HDR, EXR
build libcli11-dev nlohmann-json3-dev                   # command line, --stats
build gnuplot-nox                                       # the plots of vkpt study
build libboost-dev                                      # Boost.Math: distributions (headers only)
test  libgtest-dev vulkan-validationlayers              # test framework; every device test is validated
test  clang-format                                      # the formatting test
test  chromium                                          # opens the reports
test  clang libclang-rt-14-dev                          # libFuzzer
bench libbenchmark-dev libembree-dev                    # timing, and the yardstick
'

fail() {
  echo "setup: $*" >&2
  exit 1
}

goal=${1:-build}
case $goal in
build) groups='build' ;;
test) groups='build|test' ;;
bench) groups='build|bench' ;;
*) fail "unknown goal '$goal': build, test or bench" ;;
esac
read -r -d '' -a wanted < <(sed -n -E "s/^($groups) +([^#]*).*/\2/p" <<<"$packages") || true

if ! command -v dpkg-query >/dev/null; then
  echo "setup: this is no Debian; going on with what is installed (Debian's names: ${wanted[*]})" >&2
  exit 0
fi
installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true)
missing=()
for package in "${wanted[@]}"; do
  grep -qxF "$package installed" <<<"$installed" || missing+=("$package")
done
[[ ${#missing[@]} -gt 0 ]] || exit 0

asRoot=()
if [[ $(id -u) -ne 0 ]]; then
  command -v sudo >/dev/null || fail "neither root nor sudo; as root: apt-get install ${missing[*]}"
  asRoot=(sudo)
  [[ -t 0 ]] || asRoot+=(-n) # nobody there to type a password
  "${asRoot[@]}" true || fail "sudo is refused; as root: apt-get install ${missing[*]}"
fi

echo "setup: installing ${missing[*]}" >&2
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
  "${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300 "$@" \
    </dev/null >>"$log" 2>&1
}
# Without network the update fails, and the packages may lie in apt's cache all the same.
apt update || true
if ! apt install -y --no-install-recommends "${missing[@]}"; then
  cause=$(grep -m1 '^E:' "$log" || tail -n1 "$log")
  fail "apt-get cannot install ${missing[*]} (${cause:-no reason given}); is there a network?"
fi
