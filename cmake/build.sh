# Sourced by run.sh and test.sh, which set `root`: configures and builds a tree. All it says goes to stderr, and it
# says nothing when there is nothing to do.

# One build at a time in a checkout: two renderings may be started side by side. Held until unlockBuild or exit.
lockBuild() {
  mkdir -p "$root/build"
  exec 9>"$root/build/.lock"
  flock 9
}
unlockBuild() { exec 9>&-; }

# configure FOLDER PRESET [-DNAME=VALUE...]: a new folder is made by the preset; one that is there keeps its
# generator and settings, but for those named. One made for another place (a copied checkout) is made anew.
configure() {
  local folder=$1 preset=$2 setting arguments=()
  shift 2
  local cache=$root/$folder/CMakeCache.txt
  if ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    arguments=(--preset "$preset" --fresh)
  elif [[ ! -e $root/$folder/build.ninja && ! -e $root/$folder/Makefile ]]; then
    arguments=(-B "$root/$folder")
  else
    for setting in "$@"; do
      local name=${setting%%=*}
      grep -qE "^${name#-D}:[A-Z]+=${setting#*=}\$" "$cache" || arguments=(-B "$root/$folder")
    done
  fi
  [[ ${#arguments[@]} -gt 0 ]] || return 0
  echo "configuring $folder/" >&2
  cmake -S "$root" "${arguments[@]}" "$@" >/dev/null # errors and warnings go to stderr
}

# build FOLDER TARGET
build() {
  local folder=$root/$1 target=$2 quiet=()
  if [[ -e $folder/build.ninja ]]; then
    [[ $(ninja -C "$folder" -n "$target" 2>&1) != *'no work to do'* ]] || return 0
    [[ -t 2 ]] || quiet=(-- --quiet) # progress is for a terminal, not for a log
  fi
  echo "building $1/" >&2
  cmake --build "$folder" --target "$target" "${quiet[@]}" >&2
}
