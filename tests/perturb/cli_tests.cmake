# mdbd-perturb from the outside.
set(boxes ${PROJECT_SOURCE_DIR}/tests/query/models)
set(cube ${boxes}/boxes/cube.off)
set(perturb $<TARGET_FILE:mdbd-perturb>)

mdbd_cli_test(NAME perturb/help COMMAND mdbd-perturb --help
  REGEXP "Usage" "Examples" "noise" "decimate" "rotate" "translate" "scale" "mirror" "subdivide" "shuffle" "convert")
mdbd_cli_test(NAME perturb/help_of_a_command COMMAND mdbd-perturb noise --help REGEXP "--level" "--seed")
mdbd_cli_test(NAME perturb/version COMMAND mdbd-perturb --version
  REGEXP "^mdbd-perturb ${PROJECT_VERSION}\n$")

mdbd_cli_test(NAME perturb/file COMMAND sh -c "${perturb} noise --level 1 --seed 3 '${cube}' a.off && head -n 2 a.off && ls -A"
  REGEXP "^noise 1 %: 1 model written to a\\.off\nOFF\n8 12 0\na\\.off\n$")
mdbd_cli_test(NAME perturb/file_into_a_folder COMMAND sh -c "mkdir out && ${perturb} subdivide '${cube}' out && head -n 2 out/cube.off"
  REGEXP "26 48 0\n$")
mdbd_cli_test(NAME perturb/format_by_the_ending COMMAND sh -c "${perturb} convert '${cube}' a.ply && head -c 3 a.ply"
  REGEXP "ply$")
mdbd_cli_test(NAME perturb/scale COMMAND sh -c "${perturb} scale --factor 4 '${cube}' a.obj && ${perturb} scale --factor 0.25 a.obj b.off && ${perturb} convert '${cube}' c.off && cmp b.off c.off"
  REGEXP "scale by 4: 1 model")
mdbd_cli_test(NAME perturb/decimate COMMAND sh -c "${perturb} subdivide '${cube}' a.off && ${perturb} decimate --keep 25 a.off b.off && sed -n 2p b.off"
  REGEXP "8 12 0\n$")
mdbd_cli_test(NAME perturb/decimate_no_further COMMAND mdbd-perturb decimate --keep 10 two.off a.off
  SETUP "printf 'OFF\\n8 8 0\\n0 0 0\\n1 0 0\\n0 1 0\\n0 0 1\\n5 0 0\\n6 0 0\\n5 1 0\\n5 0 1\\n3 0 2 1\\n3 0 1 3\\n3 0 3 2\\n3 1 2 3\\n3 4 6 5\\n3 4 5 7\\n3 4 7 6\\n3 5 6 7\\n' > two.off"
  REGEXP "warning: two\\.off: 8 of 8 faces are left, 100\\.0 %")
mdbd_cli_test(NAME perturb/same_seed_same_bytes
  COMMAND sh -c "cp '${cube}' other.off && printf '%s\\n' noise rotate translate mirror shuffle | \
    xargs -I@ sh -ec \"${perturb} @ --seed 5 '${cube}' a.off && ${perturb} @ --seed 5 other.off b.off && \
    cmp a.off b.off && ${perturb} @ --seed 6 '${cube}' c.off && ! cmp -s a.off c.off\""
  REGEXP "noise" "rotation" "translation" "mirror" "shuffled")

mdbd_cli_test(NAME perturb/folder EXIT 3
  COMMAND sh -c "${perturb} noise --jobs 2 '${boxes}' out && exit 9 || find out -type f | sort && exit 3"
  REGEXP "noise 0\\.5 %: 3 models written to out, 1 failed\nout/boxes/cube\\.off\nout/boxes/long\\.off\nout/other/tetrahedron\\.off\n"
    "warning: other/damaged\\.off: [^\n]+\n")
mdbd_cli_test(NAME perturb/folder_is_the_files
  COMMAND sh -c "${perturb} noise '${boxes}/boxes' out && ${perturb} noise '${cube}' a.off && cmp a.off out/cube.off && ${perturb} noise --jobs 1 '${boxes}/boxes' one && cmp out/long.off one/long.off")
mdbd_cli_test(NAME perturb/folder_format COMMAND sh -c "${perturb} convert --format STL '${boxes}/boxes' out && ls out"
  REGEXP "cube\\.stl\nlong\\.stl\n$")
mdbd_cli_test(NAME perturb/one_copy_for_two_models EXIT 3
  COMMAND sh -c "mkdir in && cp '${cube}' in/a.off && ${perturb} convert in/a.off in/a.obj && ${perturb} convert --format ply in out"
  REGEXP "warning: a\\.off: the copy of another model is out/a\\.ply, too")
mdbd_cli_test(NAME perturb/format_that_is_not_written EXIT 3
  COMMAND sh -c "mkdir in && cp '${cube}' in/a.off && cp '${cube}' in/b.glb && ${perturb} convert in out"
  REGEXP "warning: b\.glb: \.glb is not written; --format names another")
mdbd_cli_test(NAME perturb/quiet COMMAND mdbd-perturb mirror --quiet ${cube} a.off REGEXP "^$")

mdbd_cli_test(NAME perturb/onto_itself EXIT 1
  COMMAND sh -c "cp '${cube}' a.off && ${perturb} mirror a.off ./a.off" REGEXP "neither may be or lie within")
mdbd_cli_test(NAME perturb/into_itself EXIT 1
  COMMAND sh -c "mkdir in && cp '${cube}' in && ${perturb} mirror in in/out" REGEXP "neither may be or lie within")
mdbd_cli_test(NAME perturb/link_to_itself EXIT 1
  COMMAND sh -c "mkdir in && cp '${cube}' in && ln -s in link && ${perturb} mirror in link" REGEXP "neither may be or lie within")
mdbd_cli_test(NAME perturb/damaged_file COMMAND mdbd-perturb mirror ${boxes}/other/damaged.off a.off EXIT 1
  REGEXP "warning: damaged\\.off: [^\n]+\n")
mdbd_cli_test(NAME perturb/missing_file COMMAND mdbd-perturb mirror none.off a.off EXIT 1
  REGEXP "^mdbd-perturb: error: [^\n]*none\\.off[^\n]*\n$")
mdbd_cli_test(NAME perturb/empty_folder COMMAND mdbd-perturb mirror in out EXIT 1 SETUP "mkdir in"
  REGEXP "error: in: no models in this folder")
mdbd_cli_test(NAME perturb/unwritable COMMAND mdbd-perturb mirror ${cube} none.off/a.off EXIT 1 SETUP "touch none.off"
  REGEXP "warning: cube\\.off: [^\n]+\n")
mdbd_cli_test(NAME perturb/unknown_ending COMMAND mdbd-perturb mirror ${cube} a.txt EXIT 1
  REGEXP "a\\.txt: the name of a copy ends in \\.off, \\.obj, \\.ply or \\.stl")
mdbd_cli_test(NAME perturb/format_against_ending COMMAND mdbd-perturb mirror --format ply ${cube} a.stl EXIT 1
  REGEXP "a\\.stl: the name of a copy ends in \\.ply")
mdbd_cli_test(NAME perturb/no_command COMMAND mdbd-perturb EXIT 2 REGEXP "subcommand is required")
mdbd_cli_test(NAME perturb/unknown_command COMMAND mdbd-perturb melt a b EXIT 2 REGEXP "error")
mdbd_cli_test(NAME perturb/no_output COMMAND mdbd-perturb mirror a.off EXIT 2 REGEXP "OUT is required")
mdbd_cli_test(NAME perturb/nothing_to_keep COMMAND mdbd-perturb decimate a.off b.off EXIT 2 REGEXP "--keep is required")
mdbd_cli_test(NAME perturb/level_too_high COMMAND mdbd-perturb noise --level 101 a.off b.off EXIT 2 REGEXP "--level")
mdbd_cli_test(NAME perturb/no_seed_where_nothing_is_random COMMAND mdbd-perturb scale --seed 1 a.off b.off EXIT 2 REGEXP "--seed")
mdbd_cli_test(NAME perturb/unknown_format COMMAND mdbd-perturb convert --format docx a b EXIT 2 REGEXP "--format")
