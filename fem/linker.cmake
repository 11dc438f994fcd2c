# deal.II drags in over a hundred shared libraries: GNU ld takes 13 s to link them, mold or gold (in Debian 12's binutils) 1 s.
# A choice of this build, not of those who use the installed libraries.
include(CheckLinkerFlag)
foreach(linker IN ITEMS mold gold)
  check_linker_flag(CXX -fuse-ld=${linker} STEMWARE_HAS_${linker})
  if(STEMWARE_HAS_${linker})
    target_link_options(stemware_dealii INTERFACE -fuse-ld=${linker})
    # Where thread-local data of a few bytes come last, Debian 12's mold makes a program whose pages the loader cannot
    # protect after relocation; it then does not start.
    if(linker STREQUAL mold)
      target_link_options(stemware_dealii INTERFACE LINKER:-z,norelro)
    endif()
    break()
  endif()
endforeach()
