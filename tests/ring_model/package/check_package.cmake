# Installs the ring model into a scratch folder and builds, against nothing else, a program that uses it.
# Given: BUILD_DIR (of Stemware), SCRATCH_DIR, COMPILER, GENERATOR.
file(REMOVE_RECURSE ${SCRATCH_DIR})
foreach(
  step
  "${CMAKE_COMMAND};--install;${BUILD_DIR};--component;ring_model;--prefix;${SCRATCH_DIR}/installed"
  "${CMAKE_COMMAND};-S;${CMAKE_CURRENT_LIST_DIR};-B;${SCRATCH_DIR}/build;-G;${GENERATOR};-DCMAKE_CXX_COMPILER=${COMPILER};-DCMAKE_PREFIX_PATH=${SCRATCH_DIR}/installed"
  "${CMAKE_COMMAND};--build;${SCRATCH_DIR}/build;--parallel;1"
  "${SCRATCH_DIR}/build/ring_model_user")
  execute_process(COMMAND ${step} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
