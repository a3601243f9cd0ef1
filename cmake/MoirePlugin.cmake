# moire_add_sampler(name source...) and moire_add_scene(name source...): one shared object, found by the program.
function(moire_add_plugin name)
  add_library(${name} MODULE ${ARGN})
  target_link_libraries(${name} PRIVATE moire::sdk)
  target_compile_features(${name} PRIVATE cxx_std_20)
  set_target_properties(${name} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  if(MOIRE_PLUGIN_OUTPUT)
    set_target_properties(${name} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${MOIRE_PLUGIN_OUTPUT})
  endif()
  if(TARGET moire_options)
    target_link_libraries(${name} PRIVATE moire_options)
  else()
    # Without a build type it would be compared with others at a fraction of its speed.
    target_compile_options(${name} PRIVATE -march=x86-64-v2 -ffp-contract=off $<$<CONFIG:>:-O2>)
  endif()
endfunction()

function(moire_add_sampler name)
  moire_add_plugin(${name} ${ARGN})
endfunction()

function(moire_add_scene name)
  moire_add_plugin(${name} ${ARGN})
endfunction()
