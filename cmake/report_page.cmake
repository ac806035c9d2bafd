# What the page of `morphe report` is made of goes into the program: stages/report/page and two
# libraries as Debian packages them, byte by byte, in a table that page_files.cpp reads.
set(debian_scripts /usr/share/javascript)
find_file(THREE_JS three.min.js PATHS ${debian_scripts}/three NO_DEFAULT_PATH REQUIRED)
find_file(DYGRAPHS_JS dygraph.min.js PATHS ${debian_scripts}/dygraphs NO_DEFAULT_PATH REQUIRED)
find_file(DYGRAPHS_CSS dygraph.min.css PATHS ${debian_scripts}/dygraphs NO_DEFAULT_PATH REQUIRED)

file(GLOB page_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/stages/report/page/*)
list(FILTER page_files EXCLUDE REGEX "\\.md$")
list(APPEND page_files ${THREE_JS} ${DYGRAPHS_JS} ${DYGRAPHS_CSS})

set(texts)
set(rows)
set(count 0)
foreach(file IN LISTS page_files)
  get_filename_component(name ${file} NAME)
  string(APPEND texts "begin_${count}: .incbin \"${file}\"\nend_${count}: .byte 0\nname_${count}: .asciz \"${name}\"\n")
  string(APPEND rows "  .quad name_${count}, begin_${count}, end_${count}\n")
  math(EXPR count "${count} + 1")
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/page_files.S CONTENT
"  .section .rodata
${texts}
  .section .data.rel.ro, \"aw\"
  .balign 8
  .global morphe_page_files
  .hidden morphe_page_files
morphe_page_files:
${rows}
  .global morphe_page_file_count
  .hidden morphe_page_file_count
morphe_page_file_count: .quad ${count}
  .section .note.GNU-stack, \"\", %progbits
" @ONLY)
set_source_files_properties(${CMAKE_BINARY_DIR}/page_files.S TARGET_DIRECTORY morphe_report
                            PROPERTIES OBJECT_DEPENDS "${page_files}")
target_sources(morphe_report PRIVATE ${CMAKE_BINARY_DIR}/page_files.S)
