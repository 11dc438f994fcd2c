# Script: writes ${output} with the texts of all files in ${folder}, by their names.
file(GLOB files ${folder}/*)
set(entries "")
foreach(file IN LISTS files)
  file(READ ${file} text)
  cmake_path(GET file FILENAME name)
  string(APPEND entries "  { \"${name}\", R\"text(${text})text\" },\n")
endforeach()
file(
  WRITE ${output}
  "#include \"fem/pipeline/report/compiled_plots.h\"

const std::map<std::string, std::string> stemware::pipeline::compiled_plots = {
${entries}};
")
