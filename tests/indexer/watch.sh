#!/bin/sh
# Changes a folder while mdbd-index watches it, and sees the database follow.
# usage: watch.sh MDBD-INDEX MDBD-QUERY MODELS
set -eu
index=$1 query=$2
cp -r "$3" models
cube=models/cube.off

fail() {
  echo "watch: $1" >&2
  cat log errors >&2
  kill "$watcher" 2>/dev/null || true
  exit 1
}

# Waits for a line that has not been there before; half a minute is for slow machines.
expect() {
  for _ in $(seq 300); do
    grep -q "$1" log && return
    sleep 0.1
  done
  fail "no line \"$1\""
}

# What the database holds, file names only.
holds() {
  "$query" --id 1 --top 100 --csv --db mdbd.db 2>/dev/null | tail -n +2 | cut -d, -f3 |
    xargs -n 1 basename | sort | tr '\n' ' '
}

"$index" models --balls 20 --prune --watch >log 2>errors &
watcher=$!
expect "^watching: 2 indexed, 0 unchanged, 0 failed"

sed 's/^1 1 1$/2 2 2/' "$cube" >new.off
cp new.off models/new.off
expect "^indexed .*/new.off$"

sed 's/^1 1 1$/3 2 2/' "$cube" >models/new.off # changed in place
for _ in $(seq 300); do
  [ "$(grep -c '^indexed .*/new.off$' log)" = 2 ] && break
  sleep 0.1
done
[ "$(grep -c '^indexed .*/new.off$' log)" = 2 ] || fail "the change was missed"

mv models/new.off models/renamed.off
expect "^moved   .*/new.off -> .*/renamed.off$"
rm models/renamed.off
expect "^removed .*/renamed.off$"

# A folder with models in it, made elsewhere, and one that grows.
mkdir -p elsewhere/inner models/grows/deep
cp new.off elsewhere/inner/moved_in.off
mv elsewhere models/arrived
sed 's/^1 1 1$/1 5 2/' "$cube" >models/grows/deep/grown.off
expect "^indexed .*/arrived/inner/moved_in.off$"
expect "^indexed .*/grows/deep/grown.off$"

# More than one pass can take at once, while a pass runs.
for number in 1 2 3 4 5 6 7 8 9; do
  sed "s/^1 1 1\$/1 1 $number.5/" "$cube" >"models/many_$number.off"
  sleep 0.2
done
for number in 1 2 3 4 5 6 7 8 9; do expect "^indexed .*/many_$number.off$"; done

# A folder's new name is followed, and what happens in it afterwards, too.
mv models/arrived models/renamed
expect "^moved   .*/arrived/inner/moved_in.off -> .*/renamed/inner/moved_in.off$"
sed 's/^1 1 1$/1 7 2/' "$cube" >models/renamed/inner/later.off
expect "^indexed .*/renamed/inner/later.off$"
rm -r models/grows models/many_*
expect "^removed .*/grown.off$"
expect "^removed .*/many_9.off$"

echo broken >models/broken.off
for _ in $(seq 300); do
  grep -q "warning: .*/broken.off: " errors && break
  sleep 0.1
done
grep -q "warning: .*/broken.off: " errors || fail "no warning"

echo text >models/notes.md # no model
kill -TERM "$watcher"
wait "$watcher" || fail "exit code $?"
! grep -q notes.md log errors || fail "notes.md was taken for a model"
held=$(holds)
[ "$held" = "cube.off later.off moved_in.off tetrahedron.OBJ " ] || fail "the database holds $held"
cat log
