# Script: writes ${output} from ${input} with the version and the git revision of ${source_folder}.
execute_process(
  COMMAND git -C ${source_folder} describe --always --dirty --tags --abbrev=12
  OUTPUT_VARIABLE revision
  RESULT_VARIABLE result
  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT result EQUAL 0 OR revision STREQUAL "")
  set(revision unknown)
endif()
configure_file(${input} ${output} @ONLY)
