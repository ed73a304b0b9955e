# Ipopt's configuration names what it was built with as well. A sequential MUMPS is among it, whose functions of MPI's names
# would stand in for MPI's own in a program that links both: only Ipopt itself is linked to.
if(NOT TARGET ipopt)
  add_library(ipopt INTERFACE IMPORTED GLOBAL)
  target_include_directories(ipopt SYSTEM INTERFACE ${IPOPT_INCLUDE_DIRS})
  target_compile_options(ipopt INTERFACE ${IPOPT_CFLAGS_OTHER})
  list(GET IPOPT_LINK_LIBRARIES 0 ipopt_library)
  target_link_libraries(ipopt INTERFACE ${ipopt_library})
endif()
