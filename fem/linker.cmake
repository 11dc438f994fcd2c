# deal.II drags in over a hundred shared libraries: GNU ld takes 13 s to link them, gold or mold 1 s. Debian 12's mold 1.10
# hangs on some programs and makes others that do not start; its binutils have gold, those of Debian 13 do not.
# A choice of this build, not of those who use the installed libraries.
include(CheckLinkerFlag)
foreach(linker IN ITEMS gold mold)
  check_linker_flag(CXX -fuse-ld=${linker} STEMWARE_HAS_${linker})
  if(STEMWARE_HAS_${linker})
    target_link_options(stemware_dealii INTERFACE -fuse-ld=${linker})
    break()
  endif()
endforeach()
