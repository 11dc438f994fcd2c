# deal.II (9.4.1 to 9.6.2), wrapped once: its own set-up macro leaks flags into dependants, wants plain-signature links and
# knows only two build types.
find_package(deal.II 9.4.1 REQUIRED QUIET) # quiet: it lists every macro file that it includes

# Only solid feet need these.
set(lacking "")
foreach(feature IN ITEMS WITH_MPI WITH_P4EST WITH_TRILINOS TRILINOS_WITH_MUMPS)
  if(NOT DEAL_II_${feature})
    list(APPEND lacking ${feature})
  endif()
endforeach()
list(JOIN lacking ", " lacking)
set(has_all ON)
if(lacking)
  set(has_all OFF)
  message(STATUS "This deal.II was built without ${lacking}: Stemware is built without solid feet")
endif()
option(STEMWARE_SOLID "Build the solid body (needs a deal.II with MPI, p4est and Trilinos)" ${has_all})
if(STEMWARE_SOLID AND lacking)
  message(FATAL_ERROR "STEMWARE_SOLID needs ${lacking}, and this deal.II was built without; "
                      "leave STEMWARE_SOLID off, or install Debian's libdeal.ii-dev.")
endif()
include(${DEAL_II_TARGET_CONFIG})

add_library(stemware_dealii INTERFACE)
target_include_directories(stemware_dealii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
target_compile_definitions(stemware_dealii INTERFACE BOOST_NO_AUTO_PTR $<$<CONFIG:Debug>:DEBUG>)
if(TARGET dealii::dealii_release) # since 9.5; the folders of MPI's and Trilinos' headers come with these
  target_link_libraries(stemware_dealii INTERFACE $<IF:$<CONFIG:Debug>,dealii::dealii_debug,dealii::dealii_release>)
else()
  target_link_libraries(stemware_dealii INTERFACE $<IF:$<CONFIG:Debug>,deal.ii.g,deal.ii>)
endif()
target_compile_features(stemware_dealii INTERFACE cxx_std_17)

# deal.II drags in over a hundred shared libraries: GNU ld takes 13 s to link them, mold or gold (in Debian 12's binutils) 1 s.
include(CheckLinkerFlag)
foreach(linker IN ITEMS mold gold)
  check_linker_flag(CXX -fuse-ld=${linker} STEMWARE_HAS_${linker})
  if(STEMWARE_HAS_${linker})
    target_link_options(stemware_dealii INTERFACE -fuse-ld=${linker})
    break()
  endif()
endforeach()
