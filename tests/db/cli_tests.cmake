# mdbd-db from the outside, with the models that mdbd-query is tested with.
set(models ${PROJECT_SOURCE_DIR}/tests/query/models)
set(database ${CMAKE_CURRENT_BINARY_DIR}/cli_tests/db/collection/models.db)

mdbd_cli_test(NAME db/collection EXIT 3
  COMMAND mdbd-index ${models} --db @DIR@/models.db --balls 20)
set_tests_properties(cli/db/collection PROPERTIES FIXTURES_SETUP mdbd_db_collection)

function(db_test name)
  mdbd_cli_test(NAME db/${name} ${ARGN})
  set_tests_properties(cli/db/${name} PROPERTIES FIXTURES_REQUIRED mdbd_db_collection)
endfunction()

set(db "$<TARGET_FILE:mdbd-db>")
db_test(info COMMAND mdbd-db info --db ${database}
  REGEXP "models +3 indexed .[0-9]+ off" "failed +1\n" "mdbd-fused +0 without" "balls +20\n")
db_test(info_with_cache SETUP "cp '${database}' a.db && head -c 2048 /dev/zero > a.db.mdbd-100.vectors"
  COMMAND mdbd-db info --db a.db REGEXP "cache +a\\.db\\.mdbd-100\\.vectors, 2 KiB\n")
db_test(verify COMMAND mdbd-db verify --db ${database} REGEXP "^3 models verified, nothing wrong\n$")
db_test(backup REGEXP "^3 models verified"
  COMMAND sh -c "${db} backup copy.db --db ${database} && ${db} verify --db copy.db && test ! -e copy.db.unfinished")
db_test(backup_over_a_file EXIT 1 SETUP "echo text > copy.db"
  COMMAND mdbd-db backup copy.db --db ${database} REGEXP "copy\\.db: is there already")
db_test(compact SETUP "cp '${database}' a.db" COMMAND mdbd-db compact --db a.db
  REGEXP "[0-9.]+ KiB before, [0-9.]+ KiB now\n")
db_test(merge REGEXP "models\\.db: 3 added, 0 replaced, 0 kept|models\\.db: 4 added, 0 replaced, 0 kept"
  "models\\.db: 0 added, 0 replaced, 4 kept" "3 models verified"
  COMMAND sh -c "${db} merge ${database} ${database} --db all.db && ${db} verify --db all.db")
db_test(merge_of_another_recipe EXIT 1 REGEXP "made with another recipe: balls"
  COMMAND sh -c "mkdir empty && $<TARGET_FILE:mdbd-index> empty --db other.db --quiet && ${db} merge ${database} --db other.db")
db_test(export_vectors REGEXP "^v\\.csv\nv\\.models\\.csv\nv\\.npy\n$"
  COMMAND sh -c "${db} export vectors v.npy --db ${database} && ${db} export vectors v.csv --signature mdbd-fused --db ${database} && ls v.*")
db_test(export_balls REGEXP "^id,path,ball,x,y,z,r\n"
  COMMAND sh -c "${db} export balls b.npy --db ${database} && ${db} export balls b.csv --db ${database} && head -1 b.csv")
db_test(export_ending EXIT 2 COMMAND mdbd-db export balls b.txt --db ${database}
  REGEXP "b\\.txt: the ending must be \\.npy or \\.csv")
db_test(damaged_page EXIT 1 REGEXP "^[^\n]*main[^\n]*\n"
  SETUP "cp '${database}' a.db && head -c 4096 /dev/zero | dd of=a.db bs=4096 seek=2 conv=notrunc"
  COMMAND mdbd-db verify --db a.db)
db_test(damaged EXIT 1 REGEXP "a\\.db: "
  SETUP "head -c 8192 '${database}' > a.db" COMMAND mdbd-db verify --db a.db)
mdbd_cli_test(NAME db/missing COMMAND mdbd-db info EXIT 1 REGEXP "there is no such database")
mdbd_cli_test(NAME db/no_command COMMAND mdbd-db EXIT 2 REGEXP "subcommand")
mdbd_cli_test(NAME db/help COMMAND mdbd-db --help REGEXP "Usage" "Examples" "merge" "MDBD_DB")
