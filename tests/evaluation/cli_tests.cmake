# mdbd-evaluate from the outside, on a collection of two classes of boxes and pyramids.
find_package(Python3 3.11 REQUIRED COMPONENTS Interpreter)
set(models ${PROJECT_SOURCE_DIR}/tests/query/models)
set(page_check "'${Python3_EXECUTABLE}' -B '${PROJECT_SOURCE_DIR}/tests/report/check_page.py'")
set(json_check "'${Python3_EXECUTABLE}' -m json.tool")
set(evaluate "'$<TARGET_FILE:mdbd-evaluate>'")
set(retrieval "${evaluate} retrieval models --balls 20 --no-rivals")
set(make_models "mkdir -p models/box models/pyramid && \
  cp '${models}/boxes/cube.off' '${models}/boxes/long.off' models/box && \
  for name in a b c; do cp '${models}/other/tetrahedron.off' models/pyramid/$name.off; done")
set(more_models "for name in d e f; do cp '${models}/boxes/cube.off' models/box/$name.off; done")
set(add_damaged "cp '${models}/other/damaged.off' models/box")

mdbd_cli_test(NAME evaluate/help COMMAND mdbd-evaluate --help
  REGEXP "Usage" "retrieval" "noise" "invariance" "representations" "classify" "certificate" "Examples" "Exit codes")
mdbd_cli_test(NAME evaluate/command_help COMMAND mdbd-evaluate noise --help
  REGEXP "--levels" "--html" "--cache" "--model-time" "Examples")
mdbd_cli_test(NAME evaluate/version COMMAND mdbd-evaluate --version
  REGEXP "^mdbd-evaluate ${PROJECT_VERSION}\n$")

mdbd_cli_test(NAME evaluate/classify_has_its_own_number_of_balls
  COMMAND mdbd-evaluate classify --help REGEXP "--balls N=800")

mdbd_cli_test(NAME evaluate/no_command COMMAND mdbd-evaluate EXIT 2 REGEXP "required")
mdbd_cli_test(NAME evaluate/no_collection COMMAND mdbd-evaluate noise EXIT 2 REGEXP "COLLECTION")
mdbd_cli_test(NAME evaluate/unknown_option COMMAND mdbd-evaluate noise models --fast EXIT 2
  REGEXP "--fast")
mdbd_cli_test(NAME evaluate/bad_level COMMAND mdbd-evaluate noise models --levels 1,lots EXIT 2
  REGEXP "--levels" "lots")
mdbd_cli_test(NAME evaluate/no_balls COMMAND mdbd-evaluate retrieval models --balls 0 EXIT 2
  REGEXP "--balls")
mdbd_cli_test(NAME evaluate/one_file_for_two EXIT 2
  COMMAND mdbd-evaluate retrieval models --html report --json report REGEXP "--html")

mdbd_cli_test(NAME evaluate/missing_folder COMMAND mdbd-evaluate retrieval models EXIT 1
  REGEXP "^mdbd-evaluate: error: [^\n]*/models: No such file or directory\n$")
mdbd_cli_test(NAME evaluate/empty_folder COMMAND mdbd-evaluate retrieval models EXIT 1
  SETUP "mkdir models" REGEXP "^mdbd-evaluate: error: [^\n]*models: holds no models; [^\n]+\n$")
mdbd_cli_test(NAME evaluate/no_classes COMMAND mdbd-evaluate retrieval models EXIT 1
  SETUP "mkdir models && cp '${models}/boxes/cube.off' models"
  REGEXP "models: holds 1 model[^\n]* no folders of classes")
mdbd_cli_test(NAME evaluate/file_for_collection COMMAND mdbd-evaluate retrieval models EXIT 1
  SETUP "touch models" REGEXP "models: is no folder")
mdbd_cli_test(NAME evaluate/nothing_usable COMMAND mdbd-evaluate retrieval models --balls 20 EXIT 1
  SETUP "mkdir -p models/box && ${add_damaged}"
  REGEXP "error: [^\n]*none of the 1 models could be described; [^\n]*box/damaged\\.off: ")

mdbd_cli_test(NAME evaluate/retrieval SETUP "${make_models}"
  COMMAND sh -c "${retrieval} --html page.html --json report.json && ${page_check} page.html && \
    ${json_check} report.json"
  REGEXP "^Retrieval on models\n" "mdbd-100 +60\\.0" "\"version\": \"${PROJECT_VERSION}\""
         "retrieval models --balls 20 --no-rivals --html page.html --json report.json"
         "\"failures\": \\[\\]")
mdbd_cli_test(NAME evaluate/json_on_standard_output SETUP "${make_models}"
  COMMAND sh -c "${retrieval} --json - 2>/dev/null | ${json_check}"
  REGEXP "^{\n *\"title\": \"Retrieval on models\"")
mdbd_cli_test(NAME evaluate/quiet SETUP "${make_models}"
  COMMAND sh -c "${retrieval} --quiet" REGEXP "^$")
mdbd_cli_test(NAME evaluate/second_run_computes_nothing SETUP "${make_models}"
  COMMAND sh -c "${retrieval} >first 2>log && grep -q 'clean models: 5 to compute' log && \
    ${retrieval} >second 2>log && cmp first second && cat log" REGEXP "^$")
mdbd_cli_test(NAME evaluate/cache_elsewhere SETUP "${make_models} && mkdir kept"
  COMMAND sh -c "${retrieval} --cache kept/here && ls kept/here && ! test -e mdbd-cache"
  REGEXP "mdbd-[0-9a-f]+\\.db\n")
mdbd_cli_test(NAME evaluate/same_with_any_jobs SETUP "${make_models}"
  COMMAND sh -c "${retrieval} --jobs 1 --cache a >a.txt && ${retrieval} --jobs 3 --cache b >b.txt && \
    cmp a.txt b.txt")
mdbd_cli_test(NAME evaluate/sample SETUP "${make_models}"
  COMMAND sh -c "${retrieval} --sample 2" REGEXP "Note: A sample: at most 2 " "over 4 queries")

mdbd_cli_test(NAME evaluate/failed_model EXIT 3 SETUP "${make_models} && ${add_damaged}"
  COMMAND sh -c "${retrieval} --json report.json --html page.html || code=$? && \
    ${json_check} report.json && ${page_check} page.html && exit $code"
  REGEXP "warning: box/damaged\\.off: " "Note: 1 failure: box/damaged\\.off " "Retrieval on models"
         "\"model\": \"box/damaged\\.off\"")
mdbd_cli_test(NAME evaluate/known_failure EXIT 3 SETUP "${make_models} && ${add_damaged}"
  COMMAND sh -c "${retrieval} >/dev/null 2>&1 || ${retrieval}"
  REGEXP "^Retrieval on models\n" "Note: 1 failure: box/damaged\\.off ")
mdbd_cli_test(NAME evaluate/class_of_one SETUP "${make_models} && rm models/box/long.off"
  COMMAND sh -c "${retrieval}" REGEXP "Note: 1 class[^\n]* of one model: box\\.")
mdbd_cli_test(NAME evaluate/hostile_names EXIT 3
  SETUP "${make_models} && : > \"$(printf 'models/box/<b>\\n\\033[2J\\377.off')\""
  COMMAND sh -c "${retrieval} --html page.html --json report.json || code=$? && \
    ${page_check} page.html && ${json_check} report.json && exit $code"
  REGEXP "box/<b>\\\\n\\\\x1b.2J\\\\xff\\.off")

# What cannot be written is said before anything is computed.
mdbd_cli_test(NAME evaluate/no_folder_for_page EXIT 1 SETUP "${make_models}"
  COMMAND sh -c "${retrieval} --html none/page.html || code=$? && ! test -e mdbd-cache && exit $code"
  REGEXP "error: cannot write none/page\\.html: [^\n]*none: No such file or directory")
mdbd_cli_test(NAME evaluate/folder_for_json EXIT 1 SETUP "${make_models}"
  COMMAND sh -c "${retrieval} --json models" REGEXP "error: cannot write models: it is a folder")
mdbd_cli_test(NAME evaluate/file_for_cache EXIT 1 SETUP "${make_models} && touch file"
  COMMAND sh -c "${retrieval} --cache file" REGEXP "mdbd-evaluate: error: [^\n]*file")
mdbd_cli_test(NAME evaluate/output_full EXIT 1 SETUP "${make_models}"
  COMMAND sh -c "${retrieval} > /dev/full" REGEXP "cannot write to standard output: No space")
mdbd_cli_test(NAME evaluate/interrupted EXIT 1 SETUP "${make_models}"
  COMMAND sh -c "${evaluate} retrieval models --jobs 1 --balls 100000 --model-time 2s & \
    sleep 1 && kill -INT $! && wait $!"
  REGEXP "error: interrupted; run the same command to continue")

mdbd_cli_test(NAME evaluate/noise SETUP "${make_models}"
  COMMAND mdbd-evaluate noise models --balls 20 --levels 0.5%,2 --query box/long.off --html page.html
  REGEXP "^Noise on models\n" "noise 0\\.5 %" "noise 2 %")
mdbd_cli_test(NAME evaluate/noise_of_no_model EXIT 1 SETUP "${make_models}"
  COMMAND mdbd-evaluate noise models --balls 20 --query box/short.off REGEXP "box/short\\.off")
mdbd_cli_test(NAME evaluate/invariance EXIT 3 SETUP "${make_models}"
  COMMAND mdbd-evaluate invariance models --balls 20 --sample 1 REGEXP "^Invariance on models\n" "mirror")
mdbd_cli_test(NAME evaluate/classify SETUP "${make_models} && ${more_models}"
  COMMAND sh -c "${evaluate} classify models --balls 60 --runs 2 --html page.html && \
    ${page_check} page.html"
  REGEXP "^Classification of models\n")
mdbd_cli_test(NAME evaluate/certificate SETUP "${make_models}"
  COMMAND sh -c "${evaluate} certificate models --balls 20 --html page.html --json report.json && \
    ${page_check} page.html && ${json_check} report.json"
  REGEXP "^Certificate of models\n")
mdbd_cli_test(NAME evaluate/representations SETUP "${make_models}"
  COMMAND sh -c "${evaluate} representations models --sample 2 --points 1000,3000 --noisy-points 2000 \
    --balls 60 --html page.html --json report.json && ${page_check} page.html && ${json_check} report.json"
  REGEXP "^Representations on models\n" "cloud of 3000 points" "cloud of 2000 points, noise 0\\.5 %"
         "Both signatures on the same copies" "mdbd-fused:")
