# The page, in a headless browser.
set(web ${CMAKE_BINARY_DIR}/web)

sheen_script(web_build web COMMAND tests/web/build ${web})
set_tests_properties(web_build PROPERTIES FIXTURES_SETUP web)
sheen_script(web_cases web COMMAND tests/web/cases $<TARGET_FILE:sheen> ${web}/cases)
set_tests_properties(web_cases PROPERTIES FIXTURES_SETUP web_cases)

# web_script(NAME SCRIPT word...)
function(web_script name script)
  sheen_script(${name} web COMMAND node ${web}/test/${script}.mjs ${ARGN})
  set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED web)
endfunction()

file(MAKE_DIRECTORY ${web}/pictures ${web}/hands ${web}/fault)
set(page ${web}/page/index.html)
web_script(web_pictures pictures $<TARGET_FILE:sheen> ${page} ${web}/pictures)
web_script(web_hands hands $<TARGET_FILE:sheen> ${page} ${web}/hands ${PROJECT_SOURCE_DIR})
web_script(web_files files ${web}/cases/cases.json ${page})
set_tests_properties(web_files PROPERTIES FIXTURES_REQUIRED "web;web_cases")

# This is how the picture of host-sim/README.md is made.
sheen_script(web_picture web COMMAND bash -euc
  "rm -f '${web}/picture.png'; host-sim/web/picture '${page}' '${web}/picture.png'; grep -q PNG '${web}/picture.png'")
set_tests_properties(web_picture PROPERTIES FIXTURES_REQUIRED web)

# A page that draws another colour must be refused.
sheen_script(seeded_web_colour web COMMAND tests/checks/refuses "pixels differ"
  node ${web}/test/pictures.mjs $<TARGET_FILE:sheen> ${page} ${web}/fault --fault)
set_tests_properties(seeded_web_colour PROPERTIES FIXTURES_REQUIRED web)
