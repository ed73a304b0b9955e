# cmake -DFROM=app/web -DTO=build/web -P copy_web.cmake
# Copies the page's sources, so that nothing is built among them.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${TO}/source" "${TO}/public" "${TO}/dist")
file(COPY "${FROM}/" DESTINATION "${TO}"
  PATTERN node_modules EXCLUDE
  PATTERN dist EXCLUDE
  PATTERN tests EXCLUDE)
