# mdbd-query from the outside: a collection of three models and one that could not be read.
set(models ${CMAKE_CURRENT_SOURCE_DIR}/models)
set(database ${CMAKE_CURRENT_BINARY_DIR}/cli_tests/query/collection/models.db)
set(empty_database ${CMAKE_CURRENT_BINARY_DIR}/cli_tests/query/empty_collection/empty.db)

mdbd_cli_test(NAME query/collection EXIT 3
  COMMAND mdbd-index ${models} --db @DIR@/models.db --balls 20)
mdbd_cli_test(NAME query/empty_collection SETUP "mkdir empty"
  COMMAND mdbd-index empty --db @DIR@/empty.db)
set_tests_properties(cli/query/collection PROPERTIES FIXTURES_SETUP mdbd_query_collection)
set_tests_properties(cli/query/empty_collection PROPERTIES FIXTURES_SETUP mdbd_query_empty)

# One test with the collection (or, as FIXTURE, another one) at hand.
function(query_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "FIXTURE" "")
  if(NOT arg_FIXTURE)
    set(arg_FIXTURE collection)
  endif()
  mdbd_cli_test(NAME query/${name} ${arg_UNPARSED_ARGUMENTS})
  set_tests_properties(cli/query/${name} PROPERTIES FIXTURES_REQUIRED mdbd_query_${arg_FIXTURE})
endfunction()

query_test(by_file COMMAND mdbd-query ${models}/boxes/cube.off --db ${database}
  REGEXP "rank +distance +model\n +1 +0\\.000000 +[^\n]*/boxes/cube\\.off\n"
         "\n +3 [^\n]*\n" "Compared with 3 models; the answer is exact\\.")
query_test(by_copy COMMAND mdbd-query CUBE.OFF --db ${database}
  SETUP "cp '${models}/boxes/cube.off' CUBE.OFF" REGEXP " 1 +0\\.000000 +[^\n]*/boxes/cube\\.off\n")
query_test(time_budget COMMAND mdbd-query ${models}/boxes/cube.off --db ${database} --model-time 1ms
  EXIT 1 REGEXP "^mdbd-query: error: [^\n]*cube\\.off: took longer than the time budget of [^\n]+\n$")
query_test(memory_budget COMMAND mdbd-query ${models}/boxes/cube.off --db ${database}
  --model-memory 4KiB EXIT 1 REGEXP "cube\\.off: needs more than the memory budget of 4 KiB")
query_test(top COMMAND mdbd-query ${models}/boxes/long.off --db ${database} --top 1 --csv
  REGEXP "^rank,id,path,distance,radii_distance,walk_distance,scale\n1,[0-9]+,[^\n]*/boxes/long\\.off,0,0,0,[0-9.]+\nCompared")
query_test(json COMMAND mdbd-query ${models}/boxes/long.off --db ${database} --top 100 --json
  REGEXP "^{\n *\"query\": \"[^\n]*/boxes/long\\.off\",\n *\"exact\": true,\n *\"matches\": .\n" "\"rank\": 3" "}\n$")
query_test(database_from_environment COMMAND mdbd-query --id 1 ENVIRONMENT MDBD_DB=${database}
  REGEXP "Compared with 3 models")
query_test(by_id COMMAND mdbd-query --id 1 --top 1 --db ${database} REGEXP " 1 +0\\.000000 ")
query_test(fused COMMAND mdbd-query ${models}/boxes/cube.off --db ${database} --signature mdbd-fused
  REGEXP "rank +distance +model\n +1 +0\\.000000 +[^\n]*/boxes/cube\\.off\n"
         "Compared with 3 models; the answer is exact\\.\n$")
query_test(fused_csv COMMAND mdbd-query --id 1 --db ${database} --signature mdbd-fused --csv
  REGEXP "^rank,id,path,distance,solid_distance,near_distance,bulk_distance,wide_distance,whole_distance,scale\n1,1,")
query_test(explain COMMAND mdbd-query --id 1 --db ${database} --signature mdbd-fused --explain
  REGEXP "rank +distance +solid% +near% +bulk% +wide% +whole%  model\n +1 +0\\.000000 +0 ")
query_test(explain_radii COMMAND mdbd-query ${models}/boxes/long.off --db ${database} --explain
  REGEXP " +radii% +walk%  model\n +1 [^\n]*\n +2 [^\n]*\n +(radius|walk sum) [0-9]+: [0-9.]+, in the query ")
query_test(explain_json COMMAND mdbd-query --id 1 --db ${database} --signature mdbd-fused --explain --json
  REGEXP "\"differences\": .\n *{\n *\"number\": \"[a-z][^\n]*\",\n *\"query\": [0-9.]+")
query_test(explain_lists COMMAND mdbd-query ${models}/boxes/long.off --db ${database} --signature mdbd-fused --explain
  REGEXP "radii      query  [^ \n]" "walk sums  query " "ball [0-9]+: 0\\.[0-9]+ R at ")
query_test(html SETUP "mkdir models && cp '${models}/boxes/cube.off' 'models/<b>&amp;.off'"
  COMMAND sh -c "'$<TARGET_FILE:mdbd-query>' models '${models}/boxes/long.off' --db '${database}' --explain \
    --html page.html && '${Python3_EXECUTABLE}' -B '${PROJECT_SOURCE_DIR}/tests/report/check_page.py' \
    page.html --scripts && ! grep -F '<b>' page.html"
  REGEXP "\n +1 [^\n]*cube\\.off\n")
query_test(html_cannot_be_written EXIT 1
  COMMAND mdbd-query --id 1 --db ${database} --html none/page.html REGEXP "error: [^\n]*none/page\\.html")
query_test(chirality COMMAND mdbd-query ${models}/boxes/cube.off --db ${database} --chirality
  REGEXP "rank +distance  hand      model\n +1 +0\\.000000  none ")
query_test(unknown_signature COMMAND mdbd-query --id 1 --signature mdbd-7 EXIT 2 REGEXP "--signature")
query_test(unknown_id COMMAND mdbd-query --id 999 --db ${database} EXIT 1
  REGEXP "mdbd-query: error: no model of the database has id 999")
query_test(id_of_failed_model EXIT 1
  COMMAND sh -c "query='$<TARGET_FILE:mdbd-query> --db ${database} --id' && \
    $query 1 && $query 2 && $query 3 && $query 4"
  REGEXP "damaged\\.off. could not be indexed: [^\n]")

query_test(batch EXIT 3
  COMMAND mdbd-query ${models}/boxes ${models}/other/damaged.off --db ${database} --top 1
  REGEXP "boxes/cube\\.off\nrank +distance +model\n +1 +0\\.000000 [^\n]*cube\\.off\n\n[^\n]*long\\.off\nrank"
         "mdbd-query: warning: [^\n]*damaged\\.off" "Compared with 3 models")
query_test(batch_csv COMMAND mdbd-query ${models}/boxes --db ${database} --csv --threshold 0
  REGEXP "^query,rank,id,path,.*,0,0,0,[0-9.]+\nCompared")
query_test(batch_json COMMAND mdbd-query ${models}/boxes --db ${database} --json --top 1
  REGEXP "^.\n  {\n    \"query\": \"[^\n]*/boxes/cube\\.off\"")
query_test(batch_of_nothing COMMAND mdbd-query empty --db ${database} EXIT 1 SETUP "mkdir empty"
  REGEXP "there are no models to search with")
query_test(filters COMMAND mdbd-query --id 1 --db ${database} --class boxes --glob "l*.off"
  REGEXP "\n +1 [^\n]*/boxes/long\\.off\nCompared with 1 model; the answer is exact\\.\n$")
query_test(filters_pass_none COMMAND mdbd-query --id 1 --db ${database} --min-scale 1000
  REGEXP "^No model of the database passes the filters\\.\n$")
query_test(same_size COMMAND mdbd-query ${models}/boxes/cube.off --db ${database} --same-size
  REGEXP "\n +1 [^\n]*/boxes/cube\\.off\nCompared with 1 model; the answer is exact\\.\n$")
query_test(same_size_of_none COMMAND mdbd-query small.off --db ${database} --same-size
  SETUP "sed 's/^1 1 1$/0.5 0.5 0.5/' '${models}/other/tetrahedron.off' > small.off"
  REGEXP "^No model of the database passes the filters\\.\n$")
query_test(duplicates COMMAND mdbd-query --duplicates --db ${database}
  REGEXP "^0 groups of the same shape among 3 models\\.\n$")
query_test(duplicates_by_surfaces COMMAND mdbd-query --duplicates --db ${database} --threshold 1000
  REGEXP "^0 groups of the same shape among 3 models\\.\nSurfaces of [23] doubtful pairs were compared\\.\n$")
query_test(duplicates_no_surfaces COMMAND mdbd-query --duplicates --no-surfaces --db ${database}
  --threshold 1000 REGEXP "1 group of the same shape among 3 models\\.\n$")
query_test(no_surfaces_alone COMMAND mdbd-query a.off --no-surfaces EXIT 2 REGEXP "requires")
query_test(duplicates_json COMMAND mdbd-query --duplicates --no-surfaces --db ${database} --json --threshold 100
  REGEXP "\"compared\": 3,\n *\"threshold\": 100.0,\n *\"surfaces_compared\": 0,\n *\"surfaces_not_compared\": 0,\n *\"groups\": .\n *{\n *\"keep\": [0-9]+,")
query_test(duplicates_csv COMMAND mdbd-query --duplicates --no-surfaces --db ${database} --csv --threshold 100
  REGEXP "^group,keep,first,first_path,second,second_path,distance,radii_distance,deviation,scale_ratio,hand,same_bytes\n1,")
query_test(duplicates_of_a_model COMMAND mdbd-query a.off --duplicates EXIT 2 REGEXP "excludes")

query_test(damaged_file COMMAND mdbd-query ${models}/other/damaged.off --db ${database} EXIT 1
  REGEXP "^mdbd-query: error: [^\n]*damaged\\.off: [^\n]+\n$")
query_test(missing_file COMMAND mdbd-query none.off --db ${database} EXIT 1
  REGEXP "^mdbd-query: error: none\\.off: [^\n]+\n$")
query_test(unknown_format COMMAND mdbd-query text.docx --db ${database} EXIT 1
  SETUP "echo text > text.docx" REGEXP "^mdbd-query: error: text\\.docx: [^\n]+\n$")

query_test(empty_database FIXTURE empty
  COMMAND mdbd-query ${models}/boxes/cube.off --db ${empty_database}
  REGEXP "^The database holds no models; add some with mdbd-index\\.\n$")
query_test(empty_database_json FIXTURE empty
  COMMAND mdbd-query ${models}/boxes/cube.off --db ${empty_database} --json
  REGEXP "\"matches\": \\[\\]\n}")

mdbd_cli_test(NAME query/database_missing COMMAND mdbd-query ${models}/boxes/cube.off EXIT 1
  REGEXP "mdbd-query: error: [^\n]*mdbd\\.db" "mdbd-index")
mdbd_cli_test(NAME query/database_foreign COMMAND mdbd-query --id 1 --db text.db EXIT 1
  SETUP "echo 'This is no database.' > text.db" REGEXP "mdbd-query: error: text\\.db")
mdbd_cli_test(NAME query/help COMMAND mdbd-query --help REGEXP "Usage" "Examples" "--top" "MDBD_DB")
mdbd_cli_test(NAME query/version COMMAND mdbd-query --version
  REGEXP "^mdbd-query ${PROJECT_VERSION}\n$")
mdbd_cli_test(NAME query/nothing_to_search COMMAND mdbd-query EXIT 2 REGEXP "MODEL or --id")
mdbd_cli_test(NAME query/file_and_id COMMAND mdbd-query a.off --id 1 EXIT 2 REGEXP "excludes --id")
mdbd_cli_test(NAME query/json_and_csv COMMAND mdbd-query a.off --json --csv EXIT 2
  REGEXP "--json excludes --csv")
mdbd_cli_test(NAME query/explain_and_csv COMMAND mdbd-query a.off --explain --csv EXIT 2
  REGEXP "--explain excludes --csv")
mdbd_cli_test(NAME query/top_zero COMMAND mdbd-query a.off --top 0 EXIT 2 REGEXP "--top")
foreach(option threshold min-scale max-scale)
  foreach(number nan -1 x)
    mdbd_cli_test(NAME query/${option}_${number} COMMAND mdbd-query --id 1 --${option} ${number} EXIT 2
      REGEXP "--${option}")
  endforeach()
endforeach()
mdbd_cli_test(NAME query/id_no_number COMMAND mdbd-query --id one EXIT 2 REGEXP "--id")
mdbd_cli_test(NAME query/unknown_option COMMAND mdbd-query a.off --nearest EXIT 2 REGEXP "--nearest")
mdbd_cli_test(NAME query/help_on_the_cache COMMAND mdbd-query --help REGEXP "--no-cache" "\\.vectors")
query_test(approximate COMMAND mdbd-query --id 1 --db ${database} --approx --top 2
  REGEXP "approximate: recall@2 1\\.000 on [0-9] sampled models of this collection .exact answer: drop --approx.")
query_test(approximate_json COMMAND mdbd-query --id 1 --db ${database} --approx --json
  REGEXP "\"exact\": false,\n *\"recall\": {\n *\"share\": 1\\.0")
mdbd_cli_test(NAME query/approximate_and_threshold COMMAND mdbd-query --id 1 --approx --threshold 1 EXIT 2
  REGEXP "--approx excludes --threshold|--threshold excludes --approx")
