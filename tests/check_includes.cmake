# The house has one order: a folder may include the folders above it in this list and nothing below. The ring model does
# not know the finite elements, and of these contact and bodies know its words for a load, ring_model/load, alone. What
# the live cut's sources include, and what that includes, is Eigen, Boost or standard, and knows no files. Fails with every
# include that says otherwise, or file that lies loose.
# Given: SOURCE_DIR.
cmake_policy(VERSION 3.25)
set(order
    ring_model/load
    ring_model
    fem/geometry
    fem/elasticity
    fem/matrix_free
    fem/contact
    fem/revolution
    fem/solid
    fem/pipeline/support
    fem/pipeline/study
    fem/pipeline/coupling
    fem/pipeline/modules
    fem/pipeline/variants
    fem/pipeline/analysis
    fem/pipeline/document
    fem/pipeline/report
    fem/pipeline/page
    fem/pipeline/explore
    fem/pipeline/python
    fem/pipeline/app)

# The place in `order` of the folder that a path lies in, -1 for none.
function(place_of path result)
  set(place -1)
  list(LENGTH order n)
  math(EXPR last "${n} - 1")
  foreach(i RANGE ${last})
    list(GET order ${i} folder)
    string(FIND "${path}" "${folder}/" begin)
    if(begin EQUAL 0 AND place EQUAL -1)
      set(place ${i})
    endif()
  endforeach()
  set(${result} ${place} PARENT_SCOPE)
endfunction()

set(troubles "")
file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/ring_model/*.h ${SOURCE_DIR}/ring_model/*.cc
     ${SOURCE_DIR}/fem/*.h ${SOURCE_DIR}/fem/*.cc)
foreach(file IN LISTS files)
  place_of(${file} mine)
  if(mine EQUAL -1)
    string(APPEND troubles "${file} lies in none of the folders\n")
  endif()
  file(STRINGS ${SOURCE_DIR}/${file} lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    if(NOT line MATCHES "[<\"]([^>\"]+)[>\"]")
      continue()
    endif()
    set(included ${CMAKE_MATCH_1})
    place_of(${included} other)
    if(other GREATER mine)
      string(APPEND troubles "${file} includes ${included}, which lies below it\n")
    elseif(file MATCHES "^ring_model/" AND included MATCHES "^(deal\\.II|fem|Epetra|Teuchos|ml_|Amesos)")
      string(APPEND troubles "${file} includes ${included}: the ring model needs no finite elements\n")
    elseif(file MATCHES "^ring_model/load/" AND included MATCHES "^boost/")
      string(APPEND troubles "${file} includes ${included}: a load needs Eigen alone\n")
    elseif(file MATCHES "^fem/" AND NOT file MATCHES "^fem/pipeline/" AND included MATCHES "^ring_model/"
           AND NOT (file MATCHES "^fem/(contact|revolution|solid)/" AND included MATCHES "^ring_model/load/"))
      string(APPEND troubles "${file} includes ${included}: contact and bodies know ring_model/load, and no more\n")
    elseif(file MATCHES "^fem/pipeline/" AND included MATCHES "^fem/(solid|matrix_free)/" AND NOT file STREQUAL
                                                                                    fem/pipeline/modules/solid_feet.cc)
      string(APPEND troubles "${file} includes ${included}: modules/solid_feet.cc alone makes solid feet\n")
    elseif(file MATCHES "^fem/pipeline/" AND included MATCHES "^deal\\.II/" AND NOT file MATCHES "^fem/pipeline/modules/")
      string(APPEND troubles "${file} includes ${included}: the program stands on deal.II through its modules alone\n")
    elseif(file MATCHES "^fem/solid/" AND included MATCHES "^fem/revolution/")
      string(APPEND troubles "${file} includes ${included}: the bodies do not know each other\n")
    endif()
  endforeach()
endforeach()

# The live cut: what stemware_library() makes LIVE, but for BEYOND_LIVE.
set(reached "")
foreach(folder IN LISTS order)
  file(READ ${SOURCE_DIR}/${folder}/CMakeLists.txt text)
  if(NOT text MATCHES "stemware_library\\([^)]* LIVE[^_]")
    continue()
  endif()
  string(REGEX MATCH "BEYOND_LIVE[^)]*" beyond "${text}")
  string(REGEX MATCH "EXCEPT[^)]*" except "${text}")
  foreach(file IN LISTS files)
    cmake_path(GET file PARENT_PATH place)
    cmake_path(GET file FILENAME name)
    # A part of the folder's library, if it has none of its own.
    cmake_path(GET place FILENAME part)
    if(place STREQUAL "${folder}/${part}" AND NOT EXISTS ${SOURCE_DIR}/${place}/CMakeLists.txt)
      string(FIND "${text}" "${part}/*.cc" beyond_place)
      if(beyond_place EQUAL -1)
        set(place ${folder})
      endif()
    endif()
    if(place STREQUAL folder AND name MATCHES "\\.cc$" AND NOT "${beyond} ${except}" MATCHES "[ \n]${name}[ \n]")
      list(APPEND reached ${file})
    endif()
  endforeach()
endforeach()
list(LENGTH reached n_live)
set(open ${reached})
while(open)
  list(POP_FRONT open file)
  file(STRINGS ${SOURCE_DIR}/${file} lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    if(line MATCHES "\"([^\"]+)\"")
      set(included ${CMAKE_MATCH_1})
      if(NOT included IN_LIST reached)
        list(APPEND reached ${included})
        list(APPEND open ${included})
      endif()
    elseif(line MATCHES "<([^>]+)>" AND NOT CMAKE_MATCH_1 MATCHES "^(Eigen|unsupported/Eigen|boost)/|^[a-z_]+$|^math.h$" OR line MATCHES
                                                                                         "<(filesystem|fstream|thread)>")
      string(APPEND troubles "${file}, of the live cut or included there, has ${line}\n")
    endif()
  endforeach()
endwhile()
if(n_live LESS 80)
  string(APPEND troubles "only ${n_live} sources are found to be of the live cut\n")
endif()

if(troubles)
  message(FATAL_ERROR "Includes that break the order of the folders:\n${troubles}")
endif()
list(LENGTH files n)
message("${n} files include only what lies above them; ${n_live} are of the live cut.")
