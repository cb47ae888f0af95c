#!/usr/bin/env bash
# routing_peers.sh FAROL_BENCH_ROUTING [SIZE...]: Farol, Boost.Graph, NetworkX and pgRouting over the same campuses, doors
# and pairs, one after the other. Prints two Markdown tables.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
bench=$1
shift
sizes=("$@")
[ $# -gt 0 ] || sizes=(100 1000 10000 100000)
folder=$(mktemp -d "${TMPDIR:-/tmp}/farol-routing.XXXXXX")
trap 'rm -rf "$folder"' EXIT
"$bench" "$folder" --sizes "$(IFS=,; echo "${sizes[*]}")"
echo
chmod 755 "$folder"
FAROL_POSTGRES_OPTIONS="-c shared_buffers=512MB -c max_wal_size=4GB -c jit=off" \
  "$here/../../postgis/with_cluster.sh" python3 "$here/routing_peers.py" "$folder" "${sizes[@]}"
