# Debian packages of the program, the Python package and the libraries by `cpack` (./quickstart package). Excluded from
# native builds: a package must run on every machine of its architecture.
install(
  FILES LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR}
  COMPONENT program)
if(NOT DEFINED STEMWARE_SIMD OR STEMWARE_SIMD STREQUAL "native")
  return()
endif()

# Without these programs CPack makes packages without dependencies.
find_program(STEMWARE_SHLIBDEPS dpkg-shlibdeps REQUIRED)
find_program(STEMWARE_FILE file REQUIRED)

# The manual page is made from the output of `stemware --help`. The examples are inserted line by line.
find_program(STEMWARE_HELP2MAN help2man REQUIRED)
file(READ fem/pipeline/app/help/stemware.txt examples)
string(REGEX REPLACE "^Examples:\n" "" examples "${examples}")
file(CONFIGURE OUTPUT examples.h2m CONTENT "[=EXAMPLES]\n.nf\n${examples}.fi\n" @ONLY)
add_custom_command(
  OUTPUT stemware.1
  COMMAND ${STEMWARE_HELP2MAN} --no-info "--name=contact and spin of a wine glass that is led round a table" --include
          examples.h2m --output stemware.1 $<TARGET_FILE:stemware>
  DEPENDS stemware ${CMAKE_CURRENT_BINARY_DIR}/examples.h2m
  VERBATIM)
add_custom_target(manual_page ALL DEPENDS stemware.1)
install(
  FILES ${CMAKE_CURRENT_BINARY_DIR}/stemware.1
  DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
  COMPONENT program)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Stemware authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

# The packages of different Debian releases need different versions of deal.II.
cmake_host_system_information(RESULT distribution QUERY DISTRIB_ID)
cmake_host_system_information(RESULT release QUERY DISTRIB_VERSION_ID)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1~${distribution}${release})
set(CPACK_DEBIAN_PACKAGE_VERSION ${STEMWARE_VERSION})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program ring_model fem)
if(TARGET stemware_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME stemware)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "openmpi-bin, libopenblas0-serial") # MPI for several ranks; a fast BLAS
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
    "From a glass, a table and a moving hand to the spin of the glass: contact of
its elastic foot by finite elements, friction, and what each effect does.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-stemware)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
# For the library of fem/solid/simd.
set(same_version "stemware (= ${CPACK_DEBIAN_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${same_version}, python3-numpy")
if(TARGET stemware_python) # its extensions are built for one version of Python
  set(minor ${Python_VERSION_MINOR})
  math(EXPR next "${minor} + 1")
  string(APPEND CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS ", python3 (>= 3.${minor}), python3 (<< 3.${next})")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-pandas, python3-matplotlib")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION
    "The ring and the studies of Stemware for Python: friction and limit surfaces
over numpy arrays, terminal spins, studies with the program's digits.")

set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME libstemware-dev)
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libdevel)
get_directory_property(dealii_version DIRECTORY fem DEFINITION DEAL_II_PACKAGE_VERSION)
string(
  JOIN ", " CPACK_DEBIAN_LIBRARIES_PACKAGE_DEPENDS
  "${same_version}" "libdeal.ii-dev (>= ${dealii_version})" libsuitesparse-dev libeigen3-dev libboost-dev libtbb-dev)
set(CPACK_DEBIAN_LIBRARIES_DESCRIPTION
    "Headers, archives and CMake package of the ring model and of the finite
elements.")

# Licence of the sources, and licences of the libraries linked into the program.
file(READ ${CMAKE_SOURCE_DIR}/LICENSE MIT_LICENSE)
configure_file(${CMAKE_CURRENT_LIST_DIR}/copyright.in copyright @ONLY)
foreach(package IN ITEMS program=stemware python=python3-stemware ring_model=libstemware-dev)
  string(REPLACE "=" ";" package ${package})
  list(GET package 0 component)
  list(GET package 1 package)
  install(
    FILES ${CMAKE_CURRENT_BINARY_DIR}/copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
    COMPONENT ${component})
endforeach()

include(CPack)
cpack_add_component(program)
cpack_add_component_group(libraries)
cpack_add_component(python)
foreach(component IN ITEMS ring_model fem)
  cpack_add_component(${component} GROUP libraries)
endforeach()
