# Installs components of Stemware into a scratch folder, builds a user's project there, and runs its program `user`,
# which must succeed. Input: BUILD_DIR (of Stemware), COMPONENTS, PROJECT_DIR, SCRATCH_DIR, COMPILER, GENERATOR,
# LINKER_FLAGS (for a fast linker).
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${SCRATCH_DIR})
foreach(component IN LISTS COMPONENTS)
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --component ${component} --prefix ${SCRATCH_DIR}/installed)
endforeach()
set(configure ${CMAKE_COMMAND} -S ${PROJECT_DIR} -B ${SCRATCH_DIR}/build -G ${GENERATOR}
              -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_PREFIX_PATH=${SCRATCH_DIR}/installed)
run(${configure})

# Optimisation, threads and linker are chosen by the user of the package.
if(GENERATOR STREQUAL "Ninja")
  file(STRINGS ${SCRATCH_DIR}/build/build.ninja flags REGEX "(FLAGS|LIBRARIES) = ")
  string(REGEX MATCHALL " (-O|-g|-W[^l]|-march=|-fopenmp|-fuse-ld=|-fsanitize=)[^ ]*" leaked "${flags}")
  if(leaked)
    message(FATAL_ERROR "The package makes its users build with${leaked}.")
  endif()
endif()

run(${configure} --fresh -DCMAKE_EXE_LINKER_FLAGS=${LINKER_FLAGS})
run(${CMAKE_COMMAND} --build ${SCRATCH_DIR}/build --parallel 1)
run(${SCRATCH_DIR}/build/user)
