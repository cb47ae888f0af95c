#!/usr/bin/env bash
# with_cluster.sh COMMAND...: runs the command beside a PostgreSQL server of its own, and takes the server away again.
# The server listens on a socket in a temporary folder only, and knows the roles farol (owner of everything) and guarded
# (password "hunter2"). The command finds it by PGHOST, PGUSER and PATH, as every libpq program does.
set -euo pipefail

fail() { printf 'with_cluster: %s\n' "$*" >&2; exit 1; }

bin=$(ls -d /usr/lib/postgresql/*/bin 2>/dev/null | sort -V | tail -1 || true)
[ -n "$bin" ] || bin=$(dirname "$(command -v initdb || true)")
[ -x "$bin/initdb" ] && [ -x "$bin/postgres" ] ||
  fail "there is no PostgreSQL server here: install the package postgresql-15-postgis-3"
share=$("$bin/pg_config" --sharedir 2>/dev/null || echo "/usr/share/postgresql/$(basename "$(dirname "$bin")")")
[ -f "$share/extension/postgis.control" ] ||
  fail "PostgreSQL is here, but PostGIS is not: install the package postgresql-15-postgis-3"

# A socket's path has to be short.
folder=$(mktemp -d /tmp/farol-pg.XXXXXX)
server=""
finish() {
  trap - EXIT INT TERM
  if [ -n "$server" ]; then
    kill -INT "$server" 2>/dev/null || true # the fast shutdown
    wait "$server" 2>/dev/null || true
  fi
  rm -rf "$folder"
}
trap finish EXIT
trap 'exit 130' INT TERM

# The server refuses to be root; it ends with this script, however that ends.
as=(setpriv --pdeathsig=INT)
if [ "$(id -u)" -eq 0 ]; then
  owner=$(id -u postgres >/dev/null 2>&1 && echo postgres || echo nobody)
  chown "$owner" "$folder"
  chmod 755 "$folder"
  as+=(--reuid="$owner" --regid="$(id -g "$owner")" --clear-groups)
fi
cd "$folder"
"${as[@]}" "$bin/initdb" -D "$folder/data" -U farol -A trust -E UTF8 --locale=C.UTF-8 --no-sync >"$folder/log" 2>&1 ||
  { cat "$folder/log" >&2; fail "the cluster cannot be made"; }
printf 'local all guarded scram-sha-256\nlocal all all trust\n' >"$folder/data/pg_hba.conf"
"${as[@]}" "$bin/postgres" -D "$folder/data" -k "$folder" -c listen_addresses= -c fsync=off -c max_connections=40 \
  ${FAROL_POSTGRES_OPTIONS:-} >>"$folder/log" 2>&1 &
server=$!

export PGHOST="$folder" PGUSER=farol PATH="$bin:$PATH"
unset PGPORT PGDATABASE PGPASSWORD PGSERVICE PGOPTIONS
for ((tries = 0; ; ++tries)); do
  "$bin/pg_isready" -q -d postgres && break
  kill -0 "$server" 2>/dev/null && [ $tries -lt 600 ] || { cat "$folder/log" >&2; fail "the server does not start"; }
  read -rt 0.05 <> <(:) || true
done
"$bin/psql" -q -d postgres -c "CREATE ROLE guarded LOGIN PASSWORD 'hunter2'"

cd - >/dev/null
"$@"
