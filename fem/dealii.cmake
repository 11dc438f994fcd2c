# Defines the target stemware_dealii for deal.II 9.4.1 to 9.6.2, in the build and in the installed package. deal.II's
# own macro leaks flags into dependent targets, requires plain-signature links and supports only two build types.
# STEMWARE_DEALII_IS_DEBUG (0 or 1) selects deal.II's debug or release library.
find_package(deal.II 9.4.1 REQUIRED QUIET) # QUIET: without it, deal.II lists every macro file
include(${DEAL_II_TARGET_CONFIG})

add_library(stemware_dealii INTERFACE IMPORTED GLOBAL)
add_library(stemware::dealii ALIAS stemware_dealii)
target_include_directories(stemware_dealii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
target_compile_definitions(stemware_dealii INTERFACE BOOST_NO_AUTO_PTR $<${STEMWARE_DEALII_IS_DEBUG}:DEBUG>)
if(TARGET dealii::dealii_release) # since 9.5; includes the directories of the MPI and Trilinos headers
  target_link_libraries(stemware_dealii INTERFACE $<IF:${STEMWARE_DEALII_IS_DEBUG},dealii::dealii_debug,dealii::dealii_release>)
else() # Debian's name of the library is deal.ii, the upstream name is deal_II
  target_link_libraries(stemware_dealii INTERFACE $<IF:${STEMWARE_DEALII_IS_DEBUG},${DEAL_II_TARGET_DEBUG},${DEAL_II_TARGET_RELEASE}>)
endif()
target_compile_features(stemware_dealii INTERFACE cxx_std_17)
