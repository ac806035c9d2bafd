# What the page of `morphe report` is made of goes into the program: pipeline/report/page and two
# libraries as Debian packages them, byte by byte, in a table that page_files.cpp reads.
set(debian_scripts /usr/share/javascript)
find_file(THREE_JS three.min.js PATHS ${debian_scripts}/three NO_DEFAULT_PATH REQUIRED)
find_file(DYGRAPHS_JS dygraph.min.js PATHS ${debian_scripts}/dygraphs NO_DEFAULT_PATH REQUIRED)
find_file(DYGRAPHS_CSS dygraph.min.css PATHS ${debian_scripts}/dygraphs NO_DEFAULT_PATH REQUIRED)

file(GLOB page_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/pipeline/report/page/*)
list(FILTER page_files EXCLUDE REGEX "\\.md$")
list(APPEND page_files ${THREE_JS} ${DYGRAPHS_JS} ${DYGRAPHS_CSS})

morphe_embed(morphe_report morphe_page_files ${page_files})
