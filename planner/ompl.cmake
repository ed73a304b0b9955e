# OMPL's configuration gives variables, not a target. The library itself comes first in its list; the rest (Boost, ODE) is what it
# was built with, which a program that only plans need not have for development.
if(NOT TARGET ompl)
  add_library(ompl INTERFACE IMPORTED GLOBAL)
  target_include_directories(ompl SYSTEM INTERFACE ${OMPL_INCLUDE_DIRS})
  list(GET OMPL_LIBRARIES 0 ompl_library)
  target_link_libraries(ompl INTERFACE ${ompl_library})
endif()
