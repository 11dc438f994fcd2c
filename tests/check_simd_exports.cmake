# Checks that the library of fem/solid/simd exports its own functions and no definition of deal.II, whose templates it
# compiles for another SIMD width than the program. Input: NM, LIBRARY.
execute_process(COMMAND ${NM} --dynamic --defined-only --demangle ${LIBRARY} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "\n$" "" symbols "${symbols}")
string(REPLACE ";" "," symbols "${symbols}")
string(REPLACE "\n" ";" symbols "${symbols}")
set(own ${symbols})
list(FILTER own INCLUDE REGEX " [TW] ([^(]*stemware::fem::make_elastic_operator<|stemware::fem::n_simd_lanes)")
list(FILTER symbols EXCLUDE REGEX " [TW] ([^(]*stemware::fem::make_elastic_operator<|stemware::fem::n_simd_lanes)")
list(LENGTH own n)
if(symbols OR NOT n EQUAL 3)
  list(JOIN symbols "\n" symbols)
  message(FATAL_ERROR "${LIBRARY} exports ${n} functions of elastic_operator.h instead of 3, and beside them:\n${symbols}")
endif()
