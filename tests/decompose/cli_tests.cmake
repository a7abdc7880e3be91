# mdbd-decompose from the outside.
set(cube ${PROJECT_SOURCE_DIR}/tests/query/models/boxes/cube.off)
set(damaged ${PROJECT_SOURCE_DIR}/tests/query/models/other/damaged.off)
set(number "-?[0-9.]+(e-?[0-9]+)?")

mdbd_cli_test(NAME decompose/csv COMMAND mdbd-decompose ${cube} --balls 9
  REGEXP "^x,y,z,r\n${number},${number},${number},0\\.(5|50*1|49999[0-9]*)\n(${number},${number},${number},0\\.13397[0-9]*\n)+$")
mdbd_cli_test(NAME decompose/xyzr COMMAND sh -c "$<TARGET_FILE:mdbd-decompose> '${cube}' --balls 1 -o balls.XYZR && cat balls.XYZR"
  REGEXP "^${number} ${number} ${number} ${number}\n$")
mdbd_cli_test(NAME decompose/one_solid SETUP "'$<TARGET_FILE:write_assembly>' a.step 2"
  COMMAND mdbd-decompose "a.step#2" --balls 1 REGEXP "^x,y,z,r\n20\.5,[^\n]*,0\.5\n$")
mdbd_cli_test(NAME decompose/missing_solid EXIT 1 SETUP "'$<TARGET_FILE:write_assembly>' a.step 2"
  COMMAND mdbd-decompose "a.step#3" REGEXP "a\.step#3: has no solid 3")
mdbd_cli_test(NAME decompose/json COMMAND sh -c "$<TARGET_FILE:mdbd-decompose> '${cube}' --balls 9 --tolerance 0.01 -o balls.json && cat balls.json"
  REGEXP "^{" "\"contacts\":..0,1.," "\"certificate\":{\"containment_violation\"" "\"radius_tolerance\":0\\.01" "\"faces\":12" "}\n$")
mdbd_cli_test(NAME decompose/nothing_beside_the_output COMMAND sh -c "$<TARGET_FILE:mdbd-decompose> '${cube}' --balls 1 -o balls.csv && ls -A"
  REGEXP "^balls\\.csv\n$")
mdbd_cli_test(NAME decompose/drawing
  SETUP "echo 'POLYGON((0 0,4 0,4 4,0 4),(1 1,2 1,2 2,1 2))' > plate.wkt"
  COMMAND sh -c "$<TARGET_FILE:mdbd-decompose> plate.wkt --balls 3 -o discs.svg && cat discs.svg"
  REGEXP "^<svg [^>]+>\n<path [^>]+>\n(<circle [^>]+>\n)(<circle [^>]+>\n)(<circle [^>]+>\n)</svg>\n$")
mdbd_cli_test(NAME decompose/solid_is_not_drawn COMMAND mdbd-decompose ${cube} --balls 1 -o a.svg EXIT 1
  REGEXP "cube\\.off: only domains in the plane are drawn")
mdbd_cli_test(NAME decompose/unknown_ending COMMAND mdbd-decompose ${cube} -o balls.txt EXIT 2
  REGEXP "balls\\.txt: the ending must be \\.csv, \\.xyzr, \\.json or \\.svg")
mdbd_cli_test(NAME decompose/unwritable COMMAND mdbd-decompose ${cube} --balls 1 -o none/balls.csv EXIT 1
  REGEXP "^mdbd-decompose: error: cannot write none/balls\\.csv: No such file")
mdbd_cli_test(NAME decompose/file_too_large EXIT 1
  COMMAND sh -c "ulimit -f 1 && $<TARGET_FILE:mdbd-decompose> '${cube}' --balls 50 -o balls.csv"
  REGEXP "^mdbd-decompose: error: cannot write balls\\.csv: File too large")
mdbd_cli_test(NAME decompose/name_that_steers_a_terminal EXIT 1
  COMMAND sh -c "$<TARGET_FILE:mdbd-decompose> \"$(printf 'none\\033[31m.off')\""
  REGEXP "^mdbd-decompose: error: none\\\\x1b\\[31m\\.off: ")
mdbd_cli_test(NAME decompose/damaged_file COMMAND mdbd-decompose ${damaged} EXIT 1
  REGEXP "^mdbd-decompose: error: [^\n]*damaged\\.off: [^\n]+\n$")
mdbd_cli_test(NAME decompose/missing_file COMMAND mdbd-decompose none.off EXIT 1
  REGEXP "^mdbd-decompose: error: none\\.off: [^\n]+\n$")
set(write_triangle "printf 'OFF\\n3 1 0\\n0 0 0\\n1 0 0\\n0 1 0\\n3 0 1 2\\n' > triangle.off")
mdbd_cli_test(NAME decompose/sheet SETUP "${write_triangle}"
  COMMAND sh -c "$<TARGET_FILE:mdbd-decompose> triangle.off --balls 9 -o balls.json && cat balls.json"
  REGEXP "\"solidified\": *true" "\"solidify\": *\"auto\"")
mdbd_cli_test(NAME decompose/sheet_refused SETUP "${write_triangle}" EXIT 1
  COMMAND mdbd-decompose triangle.off --solidify off
  REGEXP "^mdbd-decompose: error: triangle\\.off: the surface encloses nothing[^\n]+\n$")
mdbd_cli_test(NAME decompose/time_budget EXIT 1
  COMMAND mdbd-decompose ${cube} --balls 100000 --tolerance 1e-9 --model-time 200ms
  REGEXP "cube\\.off: took longer than the time budget of 0\\.2 s .--model-time.")
mdbd_cli_test(NAME decompose/solidify_unknown COMMAND mdbd-decompose ${cube} --solidify maybe EXIT 2
  REGEXP "--solidify: maybe not in")
mdbd_cli_test(NAME decompose/no_model COMMAND mdbd-decompose EXIT 2 REGEXP "MODEL is required")
mdbd_cli_test(NAME decompose/no_balls COMMAND mdbd-decompose ${cube} --balls 0 EXIT 2
  REGEXP "balls must be from 1")
mdbd_cli_test(NAME decompose/tolerance_too_large COMMAND mdbd-decompose ${cube} --tolerance 1 EXIT 2
  REGEXP "radius tolerance must be")
mdbd_cli_test(NAME decompose/denoise_off REGEXP "\"denoise\":\"off\"" "\"denoise_filter\":\"none\""
  COMMAND sh -c "$<TARGET_FILE:mdbd-decompose> '${cube}' --balls 1 --denoise off -o balls.json && cat balls.json")
mdbd_cli_test(NAME decompose/denoise_unknown COMMAND mdbd-decompose ${cube} --denoise maybe EXIT 2
  REGEXP "--denoise: maybe not in")
mdbd_cli_test(NAME decompose/help COMMAND mdbd-decompose --help REGEXP "Usage" "Examples" "--tolerance")
mdbd_cli_test(NAME decompose/version COMMAND mdbd-decompose --version
  REGEXP "^mdbd-decompose ${PROJECT_VERSION}\n$")
set(half "0\\.(5|49999999[0-9]+)")
mdbd_cli_test(NAME decompose/formula REGEXP "\n(2|1\\.99999999[0-9]+),${half},${half},${half}\n"
  SETUP "printf '{\"format\": \"mdbd-csg\"|\"solid\": {\"box\": {\"min\": [0|0|0]|\"max\": [2.5|1|1]}}}' | tr '|' , > box.json"
  COMMAND mdbd-decompose box.json --balls 2)
mdbd_cli_test(NAME decompose/formula_with_a_mistake EXIT 1
  SETUP "printf '{\"format\": \"mdbd-csg\"|\"solid\": {\"sphere\": {\"radius\": -1}}}' | tr '|' , > ball.json"
  COMMAND mdbd-decompose ball.json
  REGEXP "^mdbd-decompose: error: ball\\.json: /solid/sphere/radius: must be above 0\n$")
