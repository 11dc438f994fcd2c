# The rules of style that can be checked: a sentence of a page has at most 30 words, a doc comment of a public header
# begins with a verb or a noun, and no identifier begins with most_, least_ or fewest_. Code, tables, headings and formulas are not counted; inline code or a formula counts as one word.
# check_comments.cmake checks the first words of all other doc comments. Given: SOURCE_DIR.
cmake_policy(VERSION 3.25)
set(max_words 30)
# Pages whose long sentences are not rewritten yet, and identifiers of entries and keys. Both lists may only shrink.
set(pending_pages docs/explore.md docs/lesson.md docs/measure.md docs/python.md
                  docs/results.md)
set(allowed_names
    least_contact_fraction
    cutoff_depth
    min_jacobian
    least_load
    max_factorized_unknowns
    max_harmonics
    max_nodes
    max_rings
    max_samples
    max_steps)

set(troubles "")
macro(end_of_sentence)
  string(REGEX MATCHALL "[^ ]*[A-Za-z0-9][^ ]*" words "${sentence}")
  list(LENGTH words n)
  if(n GREATER max_words)
    string(STRIP "${sentence}" sentence)
    string(SUBSTRING "${sentence}" 0 110 start)
    string(APPEND long "  ${page}: ${n} words: ${start} ...\n")
  endif()
endmacro()

macro(end_of_paragraph)
  string(REGEX REPLACE "([.!?][*)\"_]*) " "\\1;" sentences "${paragraph} ")
  foreach(sentence IN LISTS sentences)
    end_of_sentence()
  endforeach()
  set(paragraph "")
endmacro()

file(GLOB_RECURSE pages RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/docs/*.md)
list(APPEND pages README.md CONTRIBUTING.md meshes/README.md)
foreach(page IN LISTS pages)
  file(READ ${SOURCE_DIR}/${page} text)
  string(REGEX REPLACE "[;\\]" "," text "${text}")
  string(REPLACE "[" "{" text "${text}")
  string(REPLACE "]" "}" text "${text}")
  string(REGEX REPLACE "<!--[^>]*-->" "" text "${text}")
  string(REGEX REPLACE "[$][$][^$]*[$][$]" "x" text "${text}")
  string(REGEX REPLACE "[$][^$\n]*\n?[^$\n]*[$]" "x" text "${text}")
  string(REGEX REPLACE "}[(][^)]*[)]" "}" text "${text}")
  string(REPLACE "\n" ";" lines "${text};")
  set(long "")
  set(paragraph "")
  set(fenced FALSE)
  set(after_blank TRUE)
  foreach(line IN LISTS lines)
    if(line MATCHES "^ *```")
      end_of_paragraph()
      if(fenced)
        set(fenced FALSE)
      else()
        set(fenced TRUE)
      endif()
    elseif(fenced OR (after_blank AND line MATCHES "^    "))
      # code; an indented block goes on until a line that is not indented
    elseif(line MATCHES "^ *$|^ *[|]|^#")
      end_of_paragraph()
      set(after_blank TRUE)
    else()
      set(after_blank FALSE)
      if(line MATCHES "^ *([-*]|[0-9]+[.]) ")
        end_of_paragraph()
        string(REGEX REPLACE "^ *([-*]|[0-9]+[.]) " "" line "${line}")
      endif()
      string(REGEX REPLACE "`[^`]*`" "x" line "${line}")
      string(APPEND paragraph " ${line}")
    endif()
  endforeach()
  end_of_paragraph()
  if(long AND NOT page IN_LIST pending_pages)
    string(APPEND troubles "${long}")
  elseif(NOT long AND page IN_LIST pending_pages)
    message("${page} has no long sentence any more: take it off the list.")
  endif()
  if(DEFINED LIST_PENDING AND long)
    message("${page}")
  endif()
endforeach()

# Doc comments of the public headers begin with a verb or a noun.
set(pointing "(Of|How|What|Where|Whether|Which|Whose|Between|Under|In|On|By|With|From|Into|To|For|At|It|Its|That|This|Those|These|As|When|If|Without)")
file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/ring_model/*.h ${SOURCE_DIR}/fem/contact/*.h
     ${SOURCE_DIR}/fem/revolution/*.h ${SOURCE_DIR}/fem/solid/*.h ${SOURCE_DIR}/fem/geometry/*.h
     ${SOURCE_DIR}/fem/elasticity/*.h ${SOURCE_DIR}/fem/matrix_free/*.h ${SOURCE_DIR}/fem/pipeline/*.h)
foreach(file IN LISTS files)
  file(READ ${SOURCE_DIR}/${file} text)
  string(REGEX REPLACE "[][;\\]" "," text "${text}")
  string(REGEX REPLACE "\n *///<[^\n]*" "\n" text "${text}")
  string(REGEX REPLACE "(\n *///[^\n]*)(\n *///[^\n]*)+" "\\1" text "${text}")
  string(REGEX MATCHALL "\n *(///|/[*][*]\n? *[*]?) ${pointing} [^\n]*" found "${text}")
  foreach(comment IN LISTS found)
    string(STRIP "${comment}" comment)
    string(APPEND troubles "  ${file}: ${comment}\n")
  endforeach()
endforeach()

file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/ring_model/*.h ${SOURCE_DIR}/fem/*.h)
foreach(file IN LISTS files)
  file(STRINGS ${SOURCE_DIR}/${file} lines REGEX "(most|least|fewest)_[a-z]")
  foreach(line IN LISTS lines)
    string(REGEX MATCHALL "(^|[^A-Za-z_])(most|least|fewest)_[a-z_]+" names "${line}")
    foreach(name IN LISTS names)
      string(REGEX REPLACE "^[^a-z]" "" name "${name}")
      if(NOT name IN_LIST allowed_names)
        string(APPEND troubles "  ${file}: ${name}: bounds are called max_ and min_\n")
      endif()
    endforeach()
  endforeach()
endforeach()

if(troubles)
  message(FATAL_ERROR "Words that the rules of style do not allow:\n${troubles}")
endif()
list(LENGTH pages n)
message("${n} pages have sentences of at most ${max_words} words, but for the pages on the list.")
