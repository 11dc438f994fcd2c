# deal.II depends on more than a hundred shared libraries. GNU ld takes 13 s to link them, gold or mold 1 s. Debian 12
# has gold, and its mold 1.10 hangs or produces broken programs. Debian 13's binutils have no gold, but its mold works.
# The linker applies to this build only, not to users of the installed libraries.
include(CheckLinkerFlag)
foreach(linker IN ITEMS gold mold)
  check_linker_flag(CXX -fuse-ld=${linker} STEMWARE_HAS_${linker})
  if(STEMWARE_HAS_${linker})
    target_link_options(stemware_dealii INTERFACE -fuse-ld=${linker})
    break()
  endif()
endforeach()
