# embed_files(FUNCTION HEADER OUTPUT FILE...): makes the C++ source OUTPUT, which implements FUNCTION of
# HEADER, a list of the names and texts of the files, by name.
set(embed_script ${CMAKE_CURRENT_LIST_DIR}/embed_files.cmake)
function(embed_files function header output)
  # The list of files is an argument, so that ninja also notices a file that was taken away.
  list(JOIN ARGN "|" joined)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} "-DFILES=${joined}" -DFUNCTION=${function} -DHEADER=${header}
      -DOUTPUT=${output} -P ${embed_script}
    DEPENDS ${ARGN} ${embed_script}
    COMMENT "Embedding the files of ${function}"
    VERBATIM)
endfunction()
