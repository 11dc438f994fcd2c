# Read by CTest when it starts, once for each GoogleTest program (stemware_discover_tests() in CMakeLists.txt): registers
# its tests. Given: target, program, labels, timeout, tests_dir, costs (a file), list (a file to keep the program's tests in).
#
# A test program takes a third of a second to load deal.II, so its tests share a process: those of a suite, or of the suites of
# a folder. What is named in the file of costs, a suite or a test, has an entry of its own; CTest begins with the first one.
# With STEMWARE_EACH_TEST in the environment each test is an entry: a failure of one is then alone, and ctest -R takes its
# name.
cmake_policy(VERSION 3.25)

# An entry runs the tests of a filter, with the mark "long", "ranks" or none. Those without a cost are quick.
function(add_entry entry filter cost mark)
  set(marks "${labels}")
  if(mark STREQUAL "long")
    list(APPEND marks long)
  elseif(cost EQUAL 0)
    list(APPEND marks quick)
  endif()
  set(processors 1)
  if(mark STREQUAL "ranks")
    list(APPEND marks mpi)
    set(processors 3)
  endif()
  add_test("${entry}" "${program}" "--gtest_filter=${filter}" --gtest_brief=1)
  set_tests_properties("${entry}" PROPERTIES LABELS "${marks}" COST "${cost}" TIMEOUT "${timeout}"
                                             PROCESSORS ${processors})
endfunction()

# Its variables are those of one program.
function(register_tests)
  if(NOT EXISTS "${program}")
    add_test("${target}_NOT_BUILT" "${program}")
    return()
  endif()

  if(NOT "${list}" IS_NEWER_THAN "${program}" OR NOT EXISTS "${list}")
    execute_process(COMMAND "${program}" --gtest_list_tests "--gtest_output=json:${list}" OUTPUT_QUIET
                    ERROR_VARIABLE error RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
      file(REMOVE "${list}")
      message(FATAL_ERROR "${program} does not list its tests (${result}): ${error}")
    endif()
  endif()

  # cost_NAME, higher for what is to begin earlier, and mark_NAME: "long" for those that run only when asked for, "ranks" for
  # those that start a program on two ranks. A rank waits for the other at every step: a third process on two cores makes
  # them ten times slower.
  file(STRINGS "${costs}" lines REGEX "^[^#]")
  list(LENGTH lines cost)
  foreach(line IN LISTS lines)
    if(NOT line MATCHES "^([^ ]+)( (long|ranks))?$")
      message(FATAL_ERROR "${costs} has a line that is not a name, with \"long\" or \"ranks\" behind it: ${line}")
    endif()
    set("cost_${CMAKE_MATCH_1}" "${cost}")
    set("mark_${CMAKE_MATCH_1}" "${CMAKE_MATCH_3}")
    math(EXPR cost "${cost} - 1")
  endforeach()

  # The list has one key a line; a file follows the test that stands in it, a test follows its suite.
  file(STRINGS "${list}" lines REGEX "^ +\"(name|file)\": ")
  set(suite "")
  set(suites "")
  foreach(line IN LISTS lines)
    string(REPLACE "\\/" "/" line "${line}")
    if(line MATCHES "^      \"name\": \"(.*)\"")
      set(suite "${CMAKE_MATCH_1}")
      list(APPEND suites "${suite}")
      set("except_${suite}" "")
    elseif(line MATCHES "^          \"name\": \"(.*)\"")
      set(full "${suite}.${CMAKE_MATCH_1}")
      if(DEFINED "cost_${full}")
        add_entry("${full}" "${full}" "${cost_${full}}" "${mark_${full}}")
        string(APPEND "except_${suite}" ":${full}")
      elseif(DEFINED ENV{STEMWARE_EACH_TEST})
        set(cost 0)
        if(DEFINED "cost_${suite}")
          set(cost "${cost_${suite}}")
        endif()
        add_entry("${full}" "${full}" "${cost}" "${mark_${suite}}")
      endif()
    elseif(line MATCHES "^          \"file\": \"(.*)\"" AND NOT DEFINED "folder_${suite}")
      set(file "${CMAKE_MATCH_1}")
      cmake_path(RELATIVE_PATH file BASE_DIRECTORY "${tests_dir}")
      cmake_path(GET file PARENT_PATH "folder_${suite}")
    endif()
  endforeach()
  if(DEFINED ENV{STEMWARE_EACH_TEST})
    return()
  endif()

  set(folders "")
  foreach(suite IN LISTS suites)
    if(DEFINED "cost_${suite}")
      string(REGEX REPLACE "^:" "-" except "${except_${suite}}")
      add_entry("${suite}" "${suite}.*${except}" "${cost_${suite}}" "${mark_${suite}}")
    else()
      set(folder "${folder_${suite}}")
      list(APPEND folders "${folder}")
      string(APPEND "filter_${folder}" ":${suite}.*")
      string(APPEND "without_${folder}" "${except_${suite}}")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    string(REGEX REPLACE "^:" "" filter "${filter_${folder}}")
    string(REGEX REPLACE "^:" "-" except "${without_${folder}}")
    set(entry "${target}:${folder}") # several programs may have tests of a folder
    set(cost 0)
    if(DEFINED "cost_${entry}")
      set(cost "${cost_${entry}}")
    endif()
    add_entry("${entry}" "${filter}${except}" "${cost}" "")
  endforeach()
endfunction()

register_tests()
