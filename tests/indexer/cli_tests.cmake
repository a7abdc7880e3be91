# mdbd-index from the outside.
set(models ${CMAKE_CURRENT_SOURCE_DIR}/models)
set(copy_models "cp -r '${models}' models")
set(make_damaged "sh '${CMAKE_CURRENT_SOURCE_DIR}/make_damaged_models.sh'")
set(index "'$<TARGET_FILE:mdbd-index>' --balls 20")
set(query "'$<TARGET_FILE:mdbd-query>' models/cube.off --csv")

mdbd_cli_test(NAME index/help COMMAND mdbd-index --help
  REGEXP "Usage" "Examples" "--model-time" "MDBD_DB" "Exit codes")
mdbd_cli_test(NAME index/version COMMAND mdbd-index --version
  REGEXP "^mdbd-index ${PROJECT_VERSION}\n$")
mdbd_cli_test(NAME index/no_path COMMAND mdbd-index EXIT 2 REGEXP "PATH")
mdbd_cli_test(NAME index/unknown_option COMMAND mdbd-index models --fast EXIT 2 REGEXP "--fast")
mdbd_cli_test(NAME index/no_balls COMMAND mdbd-index models --balls 0 EXIT 2 REGEXP "--balls")
mdbd_cli_test(NAME index/no_jobs COMMAND mdbd-index models --jobs 0 EXIT 2 REGEXP "--jobs")
mdbd_cli_test(NAME index/bad_size COMMAND mdbd-index models --model-memory 2GX EXIT 2
  REGEXP "--model-memory")
mdbd_cli_test(NAME index/bad_time COMMAND mdbd-index models --model-time soon EXIT 2
  REGEXP "--model-time")

mdbd_cli_test(NAME index/folder COMMAND mdbd-index ${models} --balls 20
  REGEXP "^indexed +2\nunchanged +0\nfailed +0\nDatabase mdbd.db, ")
mdbd_cli_test(NAME index/json COMMAND mdbd-index ${models} --balls 20 --json
  REGEXP "^{\n *\"indexed\": 2,\n *\"unchanged\": 0," "\"failures\": \\[\\]\n}\n$")
mdbd_cli_test(NAME index/quiet COMMAND mdbd-index ${models} --balls 20 --quiet REGEXP "^$")
mdbd_cli_test(NAME index/database_from_environment ENVIRONMENT MDBD_DB=@DIR@/other.db
  COMMAND sh -c "${index} '${models}' && test -s other.db && ! test -e mdbd.db")
mdbd_cli_test(NAME index/again SETUP "${copy_models}"
  COMMAND sh -c "${index} models && ${index} models" REGEXP "unchanged +2\n")
mdbd_cli_test(NAME index/adopts_recipe SETUP "${copy_models}"
  COMMAND sh -c "${index} models && '$<TARGET_FILE:mdbd-index>' models" REGEXP "unchanged +2\n")
mdbd_cli_test(NAME index/other_recipe EXIT 1 SETUP "${copy_models}"
  COMMAND sh -c "${index} models && '$<TARGET_FILE:mdbd-index>' models --balls 21"
  REGEXP "another recipe: balls 20 against 21" "--db")
mdbd_cli_test(NAME index/other_denoise EXIT 1 SETUP "${copy_models}"
  COMMAND sh -c "${index} models --denoise off && ${index} models && ${index} models --denoise auto"
  REGEXP "unchanged +2\n" "another recipe: denoise off against auto")
mdbd_cli_test(NAME index/moved SETUP "${copy_models}"
  COMMAND sh -c "${index} models && mv models/cube.off models/box.off && ${index} models"
  REGEXP "indexed +0\nunchanged +1\nmoved +1\n")
mdbd_cli_test(NAME index/prune SETUP "${copy_models}"
  COMMAND sh -c "${index} models && rm models/cube.off && ${index} models && ${index} models --prune"
  REGEXP "gone +1  .kept; --prune removes them" "removed +1\n")
mdbd_cli_test(NAME index/dry_run SETUP "${copy_models}"
  COMMAND sh -c "${index} models --dry-run && ! test -e mdbd.db"
  REGEXP "to index +2\n" "Nothing was written")
mdbd_cli_test(NAME index/no_thumbnails
  COMMAND sh -c "${index} '${models}' --no-thumbnails --db a.db && ${index} '${models}' --db b.db && \
    grep -c PNG b.db && ! grep PNG a.db")
mdbd_cli_test(NAME index/same_with_any_jobs SETUP "${copy_models}"
  COMMAND sh -c "${index} models --db a.db --jobs 1 && ${index} models --db b.db --jobs 2 && \
    ${query} --db a.db | cut -d, -f1,3- > a && ${query} --db b.db | cut -d, -f1,3- > b && \
    cmp a b && cat a"
  REGEXP "tetrahedron")

mdbd_cli_test(NAME index/damaged_models EXIT 3 SETUP "${copy_models} && ${make_damaged} models/bad"
  COMMAND mdbd-index models --balls 20
  REGEXP "indexed +2\n" "failed +9\n" "empty\\.off: [^\n]*empty" "triangle\\.off: [^\n]+\n"
         "billions\\.off: [^\n]+\n" "nan\\.obj: [^\n]+\n" "diary\\.ply: [^\n]+\n"
         "truncated\\.stl: [^\n]+\n" "dangling\\.stl: is a link to nothing\n"
         "pipe\\.ply: is a named pipe" "directory\\.off: is a directory, not a model file\n")
mdbd_cli_test(NAME index/old_failures EXIT 3 SETUP "${make_damaged} bad"
  COMMAND sh -c "${index} bad --quiet || ${index} bad"
  REGEXP "Failed in an earlier run[^\n]*\n  [^\n]*billions\\.off: ")
mdbd_cli_test(NAME index/time_budget EXIT 3
  COMMAND mdbd-index ${models}/cube.off --balls 100000 --tolerance 1e-9 --model-time 200ms
  REGEXP "cube\\.off: took longer than the time budget of 0\\.2 s .--model-time.")
mdbd_cli_test(NAME index/unsupported EXIT 3 SETUP "echo text > notes.md"
  COMMAND mdbd-index notes.md REGEXP "notes\\.md: unsupported ending; models end in \\.")
mdbd_cli_test(NAME index/hostile_name EXIT 3
  SETUP "mkdir models && : > \"$(printf 'models/a\\n\\033[2J\\377.off')\""
  COMMAND mdbd-index models REGEXP "a\\\\n\\\\x1b.2J\\\\xff\\.off: ")
mdbd_cli_test(NAME index/hostile_name_json EXIT 3
  SETUP "mkdir models && : > \"$(printf 'models/a\\n\\377.off')\""
  COMMAND mdbd-index models --json REGEXP "a\\\\n[^\n]+\\.off\",")
mdbd_cli_test(NAME index/interrupted EXIT 1 SETUP "${copy_models}"
  COMMAND sh -c "'$<TARGET_FILE:mdbd-index>' --jobs 1 --balls 100000 --tolerance 1e-9 --model-time 2s models & \
    sleep 1 && kill -INT $! && wait $!"
  REGEXP "interrupted: 1 model left; run the same command to continue")


set(assembly "'$<TARGET_FILE:write_assembly>'")
mdbd_cli_test(NAME index/per_solid SETUP "mkdir parts && ${assembly} parts/a.step 2 && ${assembly} parts/one.igs 1"
  COMMAND sh -c "${index} parts --per-solid && ${index} parts && \
    '$<TARGET_FILE:mdbd-query>' 'parts/a.step#2' --same-size && '$<TARGET_FILE:mdbd-query>' parts/a.step#1 parts/a.step#2 --csv"
  REGEXP "^indexed +3\n" "unchanged +3\n" "distance +model\n +1 +0\.000000 +parts/a\.step#2\n *[^\n0-9]"
         "parts/a\.step#2,1,[^\n]*parts/a\.step#2,0,0,0,1\.5\n")
mdbd_cli_test(NAME index/per_solid_changed SETUP "${assembly} a.step 3"
  COMMAND sh -c "${index} a.step --per-solid && ${assembly} a.step 2 && ${index} a.step && rm a.step && ${index} . --prune"
  REGEXP "^indexed +3\n" "\nindexed +2\nunchanged +0\nfailed +0\nremoved +1\n" "removed +2\n")
mdbd_cli_test(NAME index/whole_again SETUP "${assembly} a.step 2"
  COMMAND sh -c "${index} a.step --per-solid && ${index} a.step --whole && ${index} a.step"
  REGEXP "^indexed +2\n" "indexed +1\nunchanged +0\nfailed +0\nremoved +2\n" "\nindexed +0\nunchanged +1\n")
mdbd_cli_test(NAME index/per_solid_dry_run SETUP "${assembly} a.step 2"
  COMMAND sh -c "${index} a.step --per-solid --dry-run && ! test -e mdbd.db" REGEXP "to index +2\n")
mdbd_cli_test(NAME index/per_solid_and_whole COMMAND mdbd-index . --per-solid --whole EXIT 2 REGEXP "excludes")
mdbd_cli_test(NAME index/one_solid EXIT 1 SETUP "${assembly} a.step 2"
  COMMAND mdbd-index "a.step#2" REGEXP "a\.step#2: is one solid; name its file, with --per-solid")
mdbd_cli_test(NAME index/unit
  COMMAND sh -c "${index} '${models}' --unit inch --quiet && grep -a -o 'unit.:.inch' mdbd.db"
  REGEXP "unit.:.inch")
mdbd_cli_test(NAME index/unknown_unit EXIT 2
  COMMAND mdbd-index ${models} --unit parsec REGEXP "--unit: [^\n]*parsec")
mdbd_cli_test(NAME index/watch
  COMMAND sh ${CMAKE_CURRENT_SOURCE_DIR}/watch.sh $<TARGET_FILE:mdbd-index> $<TARGET_FILE:mdbd-query> ${models}
  REGEXP "^watching: 2 indexed")
mdbd_cli_test(NAME index/watch_and_json COMMAND mdbd-index models --watch --json EXIT 2 REGEXP "excludes")
mdbd_cli_test(NAME index/rescan_alone COMMAND mdbd-index models --rescan 5 EXIT 2 REGEXP "requires --watch")

mdbd_cli_test(NAME index/missing_path EXIT 1
  COMMAND sh -c "${index} typo || ! test -e mdbd.db || exit 2 && exit 1"
  REGEXP "mdbd-index: error: [^\n]*/typo: No such file or directory")
mdbd_cli_test(NAME index/foreign_database EXIT 1 SETUP "echo text > text.db"
  COMMAND mdbd-index ${models} --db text.db REGEXP "mdbd-index: error: text\\.db")
mdbd_cli_test(NAME index/database_is_folder EXIT 1 SETUP "mkdir folder.db"
  COMMAND mdbd-index ${models} --db folder.db REGEXP "mdbd-index: error: folder\\.db")
mdbd_cli_test(NAME index/output_full EXIT 1
  COMMAND sh -c "${index} '${models}' > /dev/full" REGEXP "cannot write to standard output: No space")
