# Script of stemware_compiled_in(): cmake -D FILES=a;b -D FUNCTION=name -P compiled_in.cmake writes FUNCTION.cc.
set(texts "")
foreach(file IN LISTS FILES)
  file(READ ${file} text)
  cmake_path(GET file FILENAME name)
  string(APPEND texts "    { \"${name}\", R\"text(${text})text\" },\n")
endforeach()
file(
  CONFIGURE
  OUTPUT ${FUNCTION}.cc
  CONTENT
    [[// Written by CMake from files of the sources.
#include "fem/pipeline/base/text_file.h"

namespace stemware::pipeline
{

const CompiledTexts &@FUNCTION@();

const CompiledTexts &@FUNCTION@()
{
  static const CompiledTexts texts = {
@texts@  };
  return texts;
}

} // namespace stemware::pipeline
]] @ONLY)
