# cmake -DNPM=npm -DFROM=app/web -DDRAWING=app/drawing -DTO=build/web -DFALLBACK=no_page.cpp -DOUTPUT=embedded_page.cpp -P build_page.cmake
# Fetches the page's packages, builds it and the reports' script in TO and embeds them. If the
# packages cannot be fetched (no network) the program is built without its page, with a message; a page that does not
# build is an error.
cmake_minimum_required(VERSION 3.25)
set(stamp "${TO}/packages.stamp")
set(lock "${FROM}/package-lock.json")
if(NOT EXISTS "${stamp}" OR "${lock}" IS_NEWER_THAN "${stamp}")
  file(MAKE_DIRECTORY "${TO}")
  file(COPY "${FROM}/package.json" "${lock}" DESTINATION "${TO}")
  execute_process(COMMAND ${NPM} ci --no-audit --no-fund --loglevel=error WORKING_DIRECTORY "${TO}" RESULT_VARIABLE failed)
  if(failed)
    message(WARNING "the packages of the workbench's page could not be fetched: `tubeplan serve` will have no page, reports no pictures. "
                    "To try again, delete ${OUTPUT} and build.")
    configure_file("${FALLBACK}" "${OUTPUT}" COPYONLY)
    return()
  endif()
  file(TOUCH "${stamp}")
endif()

# Copies the sources, so that nothing is built in the source tree, with the modules of app/drawing next to them as in
# the source tree. Removes copies of an earlier page first, including its tests, which would be type-checked with the
# new sources.
cmake_path(GET TO PARENT_PATH beside)
file(REMOVE_RECURSE "${TO}/source" "${TO}/public" "${TO}/tests" "${TO}/dist" "${TO}/dist-report" "${beside}/drawing")
file(COPY "${DRAWING}" DESTINATION "${beside}")
file(COPY "${FROM}/" DESTINATION "${TO}" PATTERN node_modules EXCLUDE PATTERN dist* EXCLUDE PATTERN tests EXCLUDE)
execute_process(COMMAND ${NPM} run --silent build WORKING_DIRECTORY "${TO}" COMMAND_ERROR_IS_FATAL ANY)

# Every report contains the script and the style in blocks of its HTML, so they must not close a block or request
# anything from a server.
file(READ "${TO}/dist-report/report.js" script)
file(READ "${TO}/dist-report/report.css" style)
if("${script}${style}" MATCHES "</(script|style)|<!--|/api/|[^\t\r\n -~]")
  message(FATAL_ERROR "${TO}/dist-report: ${CMAKE_MATCH_0} in a page's script or style")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} "-DPAGE=${TO}/dist" "-DREPORT=${TO}/dist-report" "-DOUTPUT=${OUTPUT}"
                        -P "${CMAKE_CURRENT_LIST_DIR}/embed_files.cmake"
                COMMAND_ERROR_IS_FATAL ANY)
