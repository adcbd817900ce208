#!/usr/bin/env bash
# Prints the commit that measurements belong to; "-dirty" where the sources differ from it, generated documents apart.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
top=$(git rev-parse --show-toplevel)
commit=$(git describe --always)
git -C "$top" diff --quiet HEAD -- . ':!doc' ':!README.md' || commit+=-dirty
echo "$commit"
