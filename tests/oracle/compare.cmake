# Makes the stream and compares the interpreter's moves with ours.
cmake_policy(VERSION 3.25)

execute_process(COMMAND ${STREAMS} ${STREAM} ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/rs274_moves.py ${FOLDER}/${STREAM}.ngc ${FOLDER}/${STREAM}.csv
                RESULT_VARIABLE result)
if(NOT result EQUAL 0 AND NOT result EQUAL 77)
    message(FATAL_ERROR "${STREAM}: the moves differ")
endif()
