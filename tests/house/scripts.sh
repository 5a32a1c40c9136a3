#!/usr/bin/env bash
# Every script parses, stops at the first error, and can be started:  scripts.sh SOURCE_DIR
set -euo pipefail
cd "$1"
bad=0
for script in cmake/setup.sh cmake/run.sh cmake/test.sh .ci/run; do
  [[ -x $script ]] || { echo "$script is not executable"; bad=1; }
done
while IFS= read -r -d '' script; do
  bash -n "$script" || bad=1
  if [[ $(head -c2 "$script") == '#!' ]] && ! grep -q '^set -euo pipefail$' "$script"; then
    echo "$script does not set -euo pipefail"
    bad=1
  fi
done < <(find .ci cmake src shaders tests -type f \( -name '*.sh' -o -path .ci/run \) -print0)
exit $bad
