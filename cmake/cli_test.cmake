# One test of a program's command line in one call:
#
#   mdbd_cli_test(NAME index/help COMMAND mdbd-index --help EXIT 0 REGEXP "Usage")
#
# Runs the command in an empty folder of its own and checks its exit code (0 if not given) and that
# each REGEXP (CMake's dialect) matches its output, standard output followed by standard error. The
# first word of COMMAND may be a target; its arguments cannot hold semicolons. ENVIRONMENT takes
# NAME=VALUE pairs; @DIR@ in arguments and in ENVIRONMENT stands for the folder. FILES are copied
# into the folder first. SETUP is a shell command that runs in the folder first.
set(MDBD_CLI_TEST_SCRIPT ${CMAKE_CURRENT_LIST_DIR}/run_cli_test.cmake)

function(mdbd_cli_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;EXIT;SETUP;TIMEOUT"
                        "COMMAND;REGEXP;ENVIRONMENT;FILES")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "mdbd_cli_test(${arg_NAME}): unknown ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT DEFINED arg_EXIT)
    set(arg_EXIT 0)
  endif()
  if(NOT DEFINED arg_TIMEOUT)
    set(arg_TIMEOUT 120)
  endif()
  set(directory ${CMAKE_CURRENT_BINARY_DIR}/cli_tests/${arg_NAME})
  foreach(list COMMAND REGEXP ENVIRONMENT)
    string(REPLACE "@DIR@" "${directory}" arg_${list} "${arg_${list}}")
  endforeach()
  list(POP_FRONT arg_COMMAND program)
  if(TARGET ${program})
    set(program $<TARGET_FILE:${program}>)
  endif()
  add_test(NAME cli/${arg_NAME}
    COMMAND ${CMAKE_COMMAND} -D "DIRECTORY=${directory}" -D "EXIT=${arg_EXIT}"
            -D "REGEXP=${arg_REGEXP}" -D "FILES=${arg_FILES}" -D "SETUP=${arg_SETUP}"
            -P ${MDBD_CLI_TEST_SCRIPT} -- ${program} ${arg_COMMAND})
  set_tests_properties(cli/${arg_NAME} PROPERTIES TIMEOUT ${arg_TIMEOUT}
    ENVIRONMENT "${arg_ENVIRONMENT}" LABELS cli)
endfunction()
