# deal.II (9.4.1 to 9.6.2) as the target stemware_dealii, for the build and, installed, for the users of its libraries:
# deal.II's own set-up macro leaks flags into dependants, wants plain-signature links and knows only two build types.
# STEMWARE_DEALII_IS_DEBUG (0 or 1): with which of deal.II's two libraries Stemware's own are built.
find_package(deal.II 9.4.1 REQUIRED QUIET) # quiet: it lists every macro file that it includes
include(${DEAL_II_TARGET_CONFIG})

add_library(stemware_dealii INTERFACE IMPORTED GLOBAL)
add_library(stemware::dealii ALIAS stemware_dealii)
target_include_directories(stemware_dealii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
target_compile_definitions(stemware_dealii INTERFACE BOOST_NO_AUTO_PTR $<${STEMWARE_DEALII_IS_DEBUG}:DEBUG>)
if(TARGET dealii::dealii_release) # since 9.5; the folders of MPI's and Trilinos' headers come with these
  target_link_libraries(stemware_dealii INTERFACE $<IF:${STEMWARE_DEALII_IS_DEBUG},dealii::dealii_debug,dealii::dealii_release>)
else() # Debian calls the library deal.ii, its makers deal_II
  target_link_libraries(stemware_dealii INTERFACE $<IF:${STEMWARE_DEALII_IS_DEBUG},${DEAL_II_TARGET_DEBUG},${DEAL_II_TARGET_RELEASE}>)
endif()
target_compile_features(stemware_dealii INTERFACE cxx_std_17)
