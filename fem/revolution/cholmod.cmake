# Defines the target stemware_cholmod, in the build and in the installed package. It links OpenMP's library, which limits
# CHOLMOD to one thread, but does not set OpenMP's compiler flag, because with the flag Eigen would start threads.
find_path(STEMWARE_CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(STEMWARE_CHOLMOD_LIBRARY cholmod REQUIRED)
find_package(OpenMP REQUIRED COMPONENTS CXX)

add_library(stemware_cholmod INTERFACE IMPORTED GLOBAL)
target_include_directories(stemware_cholmod INTERFACE ${STEMWARE_CHOLMOD_INCLUDE_DIR})
target_link_libraries(stemware_cholmod INTERFACE ${STEMWARE_CHOLMOD_LIBRARY} ${OpenMP_CXX_LIBRARIES})
