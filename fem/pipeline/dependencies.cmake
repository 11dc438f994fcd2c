# What the program's installed libraries stand on, beside the ring model and the finite elements.
include(CMakeFindDependencyMacro)
find_dependency(CLI11 2.1)
find_dependency(fmt 9.1)
find_dependency(nlohmann_json 3.11)
find_dependency(Threads)
