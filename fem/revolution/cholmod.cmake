# CHOLMOD as the target stemware_cholmod, for the build and, installed, for the users of its libraries. With it OpenMP's
# library, to keep CHOLMOD to one thread, but not its compiler flag, with which Eigen would start threads too.
find_path(STEMWARE_CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
find_library(STEMWARE_CHOLMOD_LIBRARY cholmod REQUIRED)
find_package(OpenMP REQUIRED COMPONENTS CXX)

add_library(stemware_cholmod INTERFACE IMPORTED GLOBAL)
target_include_directories(stemware_cholmod INTERFACE ${STEMWARE_CHOLMOD_INCLUDE_DIR})
target_link_libraries(stemware_cholmod INTERFACE ${STEMWARE_CHOLMOD_LIBRARY} ${OpenMP_CXX_LIBRARIES})
