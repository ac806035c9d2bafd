# morphe_embed(TARGET NAME FILE…): the files go into the target byte by byte, in a table of
# `struct { const char *name, *begin, *end; } NAME[NAME_count]`, which its sources may declare.
function(morphe_embed target name)
  set(texts)
  set(rows)
  set(count 0)
  foreach(file IN LISTS ARGN)
    get_filename_component(file_name ${file} NAME)
    string(APPEND texts "begin_${count}: .incbin \"${file}\"\nend_${count}: .byte 0\nname_${count}: .asciz \"${file_name}\"\n")
    string(APPEND rows "  .quad name_${count}, begin_${count}, end_${count}\n")
    math(EXPR count "${count} + 1")
  endforeach()
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/${name}.S CONTENT
"  .section .rodata
${texts}
  .section .data.rel.ro, \"aw\"
  .balign 8
  .global ${name}
  .hidden ${name}
${name}:
${rows}
  .global ${name}_count
  .hidden ${name}_count
${name}_count: .quad ${count}
  .section .note.GNU-stack, \"\", %progbits
" @ONLY)
  set_source_files_properties(${CMAKE_BINARY_DIR}/${name}.S TARGET_DIRECTORY ${target}
                              PROPERTIES OBJECT_DEPENDS "${ARGN}")
  target_sources(${target} PRIVATE ${CMAKE_BINARY_DIR}/${name}.S)
endfunction()
