# Whether LIBRARY, the whole runtime as a shared library, shows others what the headers under ROOT
# declare, and nothing else.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${NM} -D -C --defined-only ${LIBRARY} OUTPUT_VARIABLE listing COMMAND_ERROR_IS_FATAL ANY)
file(GLOB headers ${ROOT}/runtime/*.h ${ROOT}/luts/*.h)
set(declared)
foreach(header ${headers})
  file(READ ${header} text)
  string(REGEX MATCHALL
         "(class|struct|enum class) [A-Z][A-Za-z0-9]*|[A-Z][A-Za-z0-9]*\\(|k[A-Z][A-Za-z0-9]*" found "${text}")
  list(APPEND declared ${found})
endforeach()
list(TRANSFORM declared REPLACE "^(enum )?(class|struct) " "")
list(TRANSFORM declared REPLACE "\\($" "")
list(REMOVE_DUPLICATES declared)

set(shown)
string(REPLACE ";" "," listing "${listing}")
string(REGEX MATCHALL "[^\n]+" lines "${listing}")
foreach(line ${lines})
  if(line MATCHES "(hwy::|::State)" OR (line MATCHES "warplut::([A-Za-z0-9_]+)" AND NOT CMAKE_MATCH_1 IN_LIST declared))
    message(FATAL_ERROR "The library shows what no header declares: ${line}")
  endif()
  if(line MATCHES "warplut::([A-Za-z0-9_]+)")
    list(APPEND shown ${CMAKE_MATCH_1})
  endif()
endforeach()
foreach(name CameraFit FilterWeights FindMethod FloatEnvironment FrameGeneration FrameGenerationOptions IsWarpable
             LibraryWithPipeline MotionFilter MotionTiles Parameters PrefilterPass SuperResolution
             SuperResolutionOptions
             ThreadPool Warp WarpReference WarpRows)
  if(NOT name IN_LIST shown)
    message(FATAL_ERROR "The library hides ${name}.")
  endif()
endforeach()
