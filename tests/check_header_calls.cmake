# The calls in the doc comments of the headers that others use are compiled, so that a call which no longer fits its
# header fails. Given: SOURCE_DIR, SCRATCH (a file to write), COMPILER, INCLUDES (folders, a colon between two).
cmake_policy(VERSION 3.25)
set(headers
    ring_model/load/ring_stack.h
    ring_model/friction_kernels.h
    ring_model/friction_law.h
    ring_model/spin/load_at_spin.h
    ring_model/spin/answer.h
    fem/contact/contact_newton.h
    fem/contact/foot.h
    fem/contact/interface_law.h
    fem/revolution/revolution_foot.h
    fem/solid/solid_foot.h)

set(code "#include \"tests/header_calls.h\"\n")
foreach(header IN LISTS headers)
  file(READ ${SOURCE_DIR}/${header} text)
  string(REGEX MATCH "(\n(///| [*])     [^\n]+)+" call "${text}")
  if(NOT call)
    message(FATAL_ERROR "${header} has no call in a doc comment.")
  endif()
  string(MAKE_C_IDENTIFIER ${header} name)
  string(REGEX REPLACE "\n(///| [*])     " "\n" call "${call}")
  string(APPEND code "namespace stemware::fem\n{\nvoid ${name}()\n{${call}\n}\n}\n")
endforeach()
file(WRITE ${SCRATCH} "${code}")
string(REPLACE ":" ";-I" folders "-I${INCLUDES}")
execute_process(COMMAND ${COMPILER} -std=c++17 -fsyntax-only -w ${folders} ${SCRATCH} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "A call in a header does not compile: ${SCRATCH}")
endif()
