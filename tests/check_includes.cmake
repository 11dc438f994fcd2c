# Checks the order of the folders: a folder includes only folders above it in this list. The finite elements include
# only ring_model/load of the ring model, and the ring model includes no finite elements. A portable file
# (fem/portable.cmake) includes only portable files, Eigen, Boost, the JSON header and the standard library without
# files. Fails with a list of violations, and for files outside these folders. Input: SOURCE_DIR.
cmake_policy(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../fem/portable.cmake)
set(order
    ring_model/load
    ring_model
    ring_model/spin
    fem/geometry
    fem/contact
    fem/revolution
    fem/solid/simd
    fem/solid
    fem/pipeline/base
    fem/pipeline/study
    fem/pipeline/coupling
    fem/pipeline/analysis
    fem/pipeline/result
    fem/pipeline/page
    fem/pipeline/python
    fem/pipeline/app)

# Sets the result to the index in `order` of the innermost folder that contains a path; -1 if there is none.
function(place_of path result)
  set(place -1)
  set(longest 0)
  list(LENGTH order n)
  math(EXPR last "${n} - 1")
  foreach(i RANGE ${last})
    list(GET order ${i} folder)
    string(FIND "${path}" "${folder}/" begin)
    string(LENGTH "${folder}" length)
    if(begin EQUAL 0 AND length GREATER longest)
      set(place ${i})
      set(longest ${length})
    endif()
  endforeach()
  set(${result} ${place} PARENT_SCOPE)
endfunction()

set(n_portable 0)
set(troubles "")
file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/ring_model/*.h ${SOURCE_DIR}/ring_model/*.cc
     ${SOURCE_DIR}/fem/*.h ${SOURCE_DIR}/fem/*.cc)
foreach(file IN LISTS files)
  place_of(${file} mine)
  if(mine EQUAL -1)
    string(APPEND troubles "${file} lies in none of the folders\n")
    continue()
  endif()
  set(is_portable FALSE)
  if(file MATCHES "^${STEMWARE_PORTABLE}")
    set(is_portable TRUE)
    math(EXPR n_portable "${n_portable} + 1")
  endif()
  file(STRINGS ${SOURCE_DIR}/${file} lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    if(NOT line MATCHES "[<\"]([^>\"]+)[>\"]")
      continue()
    endif()
    set(included ${CMAKE_MATCH_1})
    place_of(${included} other)
    if(is_portable)
      if(other GREATER -1 AND NOT included MATCHES "^${STEMWARE_PORTABLE}")
        string(APPEND troubles "${file} includes ${included}, which is not portable\n")
      elseif(other EQUAL -1 AND NOT included MATCHES "^(Eigen|unsupported/Eigen|boost|nlohmann)/|^[a-z_]+$|^math.h$"
             OR included MATCHES "^(filesystem|fstream|thread)$")
        string(APPEND troubles "${file} includes ${included}: a portable file may include Eigen and Boost, and no file streams\n")
      endif()
    endif()
    if(other GREATER mine)
      string(APPEND troubles "${file} includes ${included}, which lies below it\n")
    elseif(file MATCHES "^ring_model/" AND included MATCHES "^(deal\\.II|fem|Epetra|Teuchos|ml_|Amesos)")
      string(APPEND troubles "${file} includes ${included}: the ring model needs no finite elements\n")
    elseif(file MATCHES "^ring_model/load/" AND included MATCHES "^boost/")
      string(APPEND troubles "${file} includes ${included}: a load needs only Eigen\n")
    elseif(file MATCHES "^fem/" AND NOT file MATCHES "^fem/pipeline/" AND included MATCHES "^ring_model/"
           AND NOT (included MATCHES "^ring_model/load/"))
      string(APPEND troubles "${file} includes ${included}: the finite elements include only ring_model/load\n")
    elseif(file MATCHES "^fem/pipeline/" AND included MATCHES "^fem/solid/" AND NOT file STREQUAL
                                                                              fem/pipeline/coupling/solid_study_foot.cc)
      string(APPEND troubles "${file} includes ${included}: a build without solid feet lacks it\n")
    endif()
  endforeach()
endforeach()

if(troubles)
  message(FATAL_ERROR "Includes that break the order of the folders:\n${troubles}")
endif()
list(LENGTH files n)
message("${n} files include only what lies above them; ${n_portable} are portable.")
