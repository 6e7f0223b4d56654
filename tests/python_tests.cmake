# Read by ctest when it starts: gives it the tests that list_tests.py finds. CMakeLists.txt sets `python` and `program`.
execute_process(
  COMMAND ${python} ${CMAKE_CURRENT_LIST_DIR}/list_tests.py
  OUTPUT_VARIABLE tests
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" tests "${tests}")
foreach(test ${tests})
  string(REPLACE " " ";" test "${test}")
  list(GET test 0 folder)
  list(GET test 1 name)
  add_test(${name} ${python} -m unittest -v ${name})
  set_tests_properties(
    ${name}
    PROPERTIES WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR}/${folder}
               ENVIRONMENT "BRDFTAB=${program};PYTHONPATH=${CMAKE_CURRENT_LIST_DIR};PYTHONDONTWRITEBYTECODE=1"
               SKIP_REGULAR_EXPRESSION "\nOK \\(skipped="
               TIMEOUT 1800)
endforeach()
