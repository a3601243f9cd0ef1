# What `find_package(moire)` gives: the target moire::sdk, moire_add_sampler and moire_add_scene.
include(${CMAKE_CURRENT_LIST_DIR}/moireTargets.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/MoirePlugin.cmake)
