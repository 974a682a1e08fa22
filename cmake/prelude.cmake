# embed_prelude(FOLDER OUTPUT): makes the C++ source OUTPUT, which implements `prelude_files()`
# (lib/patchproof/language/prelude.hpp) with the names and texts of FOLDER/*.proof.
set(embed_script ${CMAKE_CURRENT_LIST_DIR}/embed_files.cmake)
function(embed_prelude folder output)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.proof)
  # The list of files is an argument, so that ninja also notices a file that was taken away.
  list(JOIN files "|" joined)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} "-DFILES=${joined}" -DOUTPUT=${output} -P ${embed_script}
    DEPENDS ${files} ${embed_script}
    COMMENT "Embedding the prelude"
    VERBATIM)
endfunction()
