#!/bin/sh
# Fills the folder $1 with what people and accidents leave among models.
set -eu
mkdir -p "$1/directory.off"
cd "$1"
: > empty.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n' > triangle.off
printf 'OFF\n4000000000 4000000000 0\n0 0 0\n' > billions.off
printf 'v 0 0 nan\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' > nan.obj
echo 'Dear diary, today I learned about meshes.' > diary.ply
{ printf '%80s' ''; printf '\377\000\000\000'; printf '%50s' ''; } > truncated.stl
ln -s nowhere dangling.stl
mkfifo pipe.ply
