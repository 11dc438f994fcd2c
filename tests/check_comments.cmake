# A doc comment begins with a name of the thing or with a verb, and not with a word that points at something else: "Limit
# of the values", not "What the values tend to" or "Of the values". A comment behind a member, ///<, continues its name
# and is free. Fails with every doc comment that begins otherwise. Given: SOURCE_DIR.
cmake_policy(VERSION 3.25)
set(pointing "[ \t]+(What|Of|As|That|Those|Likewise)([^A-Za-z]|$)")

set(troubles "")
file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/ring_model/*.h ${SOURCE_DIR}/ring_model/*.cc
     ${SOURCE_DIR}/fem/*.h ${SOURCE_DIR}/fem/*.cc)
foreach(file IN LISTS files)
  file(READ ${SOURCE_DIR}/${file} text)
  if(NOT text MATCHES "[/*]${pointing}")
    continue()
  endif()
  # Brackets, semicolons and backslashes mean something in a list of CMake.
  string(REGEX REPLACE "[][;\\]" "," text "${text}")
  string(REPLACE "\n" ";" lines "${text}")
  set(n 0)
  set(before "")
  foreach(line IN LISTS lines)
    math(EXPR n "${n} + 1")
    if((line MATCHES "^[ \t]*///${pointing}" AND NOT before MATCHES "^[ \t]*///")
       OR line MATCHES "^[ \t]*/\\*\\*${pointing}"
       OR (line MATCHES "^[ \t]*\\*${pointing}" AND before MATCHES "^[ \t]*/\\*\\*[ \t]*$"))
      string(STRIP "${line}" words)
      string(APPEND troubles "  ${file}:${n}: ${words}\n")
    endif()
    set(before "${line}")
  endforeach()
endforeach()

if(troubles)
  message(FATAL_ERROR "Doc comments that do not begin with what the thing is:\n${troubles}")
endif()
list(LENGTH files n)
message("The doc comments of ${n} files begin with what the thing is.")
