# Run by cpack over what it is about to pack: copyright and changelog, and the pages of the manual gzipped.
# SOURCE_DATE_EPOCH, where it is set, dates them.
set(documents ${CPACK_TEMPORARY_DIRECTORY}/usr/share/doc/sheen)
file(READ ${CPACK_SHEEN_SOURCE}/LICENSE licence)
string(REGEX MATCH "Copyright [^\n]*" copyright "${licence}")
file(WRITE ${documents}/copyright "sheen, shaded 3D with integers only.\n\n${licence}")
if(NOT copyright)
  message(FATAL_ERROR "LICENSE names no copyright")
endif()

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${documents}/changelog "sheen (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * What is new and what programs have to change: CHANGELOG.md of the sources.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
file(GLOB pages ${CPACK_TEMPORARY_DIRECTORY}/usr/share/man/man*/*.[1-8])
foreach(file IN LISTS pages ITEMS ${documents}/changelog)
  execute_process(COMMAND gzip -9 -n ${file} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "gzip ${file}: ${status}")
  endif()
endforeach()
# The sources' modes may be a stranger's umask; a package's are not.
file(GLOB_RECURSE files ${CPACK_TEMPORARY_DIRECTORY}/usr/share/* ${CPACK_TEMPORARY_DIRECTORY}/usr/include/*
  ${CPACK_TEMPORARY_DIRECTORY}/usr/lib/*)
execute_process(COMMAND chmod 644 ${files} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "chmod: ${status}")
endif()
