#!/usr/bin/env bash
# cmake/setup.sh against a made-up system: dpkg-query, apt-get, id and sudo are stand-ins that write down how they
# were called:  setup.sh SOURCE_DIR
set -euo pipefail
source_dir=$1
world=$(mktemp -d)
trap 'rm -rf "$world"' EXIT
mkdir "$world/bin"
for tool in bash env sed grep mktemp rm tail cat; do # sudo, where the system has one, stays out of sight
  ln -s "$(command -v $tool)" "$world/bin/$tool"
done
stand_in() {
  printf '#!/usr/bin/env bash\n%s\n' "$2" >"$world/bin/$1"
  chmod +x "$world/bin/$1"
}
# Everything is installed but what $ABSENT names; a removed package that left its settings is not installed.
stand_in dpkg-query 'for p in "${@:3}"; do [[ " $ABSENT " == *" $p "* ]] && echo "$p config-files" || echo "$p installed"; done'
stand_in apt-get 'echo "$*" >>"$WORLD/apt"; [[ $* != *install* || -z $BROKEN ]] || { echo "E: Unable to locate package x"; exit 100; }'
stand_in id 'echo "$USER_ID"'

# setup ABSENT USER_ID BROKEN GOAL: sets `status`, `said`, and `calls`, what apt-get was asked for.
setup() {
  rm -f "$world/apt"
  status=0
  said=$(env -i PATH="$world/bin" WORLD="$world" ABSENT="$1" USER_ID="$2" BROKEN="$3" \
    bash "$source_dir/cmake/setup.sh" "$4" 2>&1 </dev/null) || status=$?
  calls=$(cat "$world/apt" 2>/dev/null || true)
}
expect() {
  if ! eval "$1"; then
    echo "expected $1; status $status, calls: $calls, said: $said"
    exit 1
  fi
}
one_line='[[ -n $said && $said != *$'"'\\n'"'* ]]'

setup '' 1000 '' build # all there: no questions, no apt, no word
expect '[[ $status -eq 0 && -z $calls && -z $said ]]'
setup 'libgtest-dev' 0 '' build # the tests' packages are not the build's
expect '[[ $status -eq 0 && -z $calls ]]'
setup 'libgtest-dev ninja-build' 0 '' test # what is missing, and nothing else
expect '[[ $status -eq 0 && $calls == *update*install*" ninja-build libgtest-dev" ]]'
expect '[[ $said == "setup: installing ninja-build libgtest-dev" ]]'
setup 'libembree-dev' 0 '' bench
expect '[[ $status -eq 0 && $calls == *install*" libembree-dev" ]]'
setup 'g++' 0 yes build
expect '[[ $status -eq 1 && $said == *"cannot install g++"*"Unable to locate package x"* ]]'
setup 'g++' 1000 '' build # an ordinary user without sudo
expect '[[ $status -eq 1 && -z $calls && $said == *"apt-get install g++" ]]'
expect "$one_line"
stand_in sudo 'echo "sudo $*" >>"$WORLD/apt"; while [[ $1 == -* ]]; do shift; done; "$@"'
ln -s "$(command -v true)" "$world/bin/true"
setup 'g++' 1000 '' build
expect '[[ $status -eq 0 && $calls == *"sudo -n"*apt-get*install*g++* ]]'
stand_in sudo 'exit 1'
setup 'g++' 1000 '' build
expect '[[ $status -eq 1 && -z $calls && $said == *"sudo is refused"* ]]'
setup '' 0 '' everything
expect '[[ $status -eq 1 && $said == *"build, test or bench"* ]]'
rm "$world/bin/dpkg-query"
setup '' 0 '' build # no Debian: said, and left to CMake
expect '[[ $status -eq 0 && -z $calls && $said == *"no Debian"* ]]'
