# The ring model under the name that it had as a package of its own: now find_package(Stemware COMPONENTS ring_model).
include("${CMAKE_CURRENT_LIST_DIR}/../Stemware/ring_model/dependencies.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/../Stemware/ring_model/targets.cmake")
