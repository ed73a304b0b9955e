# Installs the build folder BUILD below WORK, builds the project EXAMPLE with the installed libraries, and runs the
# example program.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(failed)
    message(FATAL_ERROR "${ARGN}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed)
run(${CMAKE_COMMAND} -S ${EXAMPLE} -B ${WORK}/build -D CMAKE_PREFIX_PATH=${WORK}/installed -D CMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/sag)
# Expected rotation: phi = M / k, with the moment of the load on the rotated lever, M = 50 N * 2 m * cos(phi).
string(STRIP "${output}" sag)
if(NOT sag STREQUAL "-0.002000")
  message(FATAL_ERROR "a sag of ${sag} m, expected -0.002000")
endif()
