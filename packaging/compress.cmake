# cmake -D PAGES=folder -D GZIP=program -P compress.cmake: every manual page of a folder, without name and time in it.
file(GLOB pages ${PAGES}/*.1)
execute_process(COMMAND ${GZIP} -9nf ${pages} COMMAND_ERROR_IS_FATAL ANY)
