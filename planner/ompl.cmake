# OMPL's configuration defines variables, not a target. The library itself is the first item of its list. The other
# items (Boost, ODE) are build dependencies of OMPL, which a program that only plans does not need for development.
if(NOT TARGET ompl)
  add_library(ompl INTERFACE IMPORTED GLOBAL)
  target_include_directories(ompl SYSTEM INTERFACE ${OMPL_INCLUDE_DIRS})
  list(GET OMPL_LIBRARIES 0 ompl_library)
  target_link_libraries(ompl INTERFACE ${ompl_library})
endif()
