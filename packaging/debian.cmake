# Read by CPack when a package's files are in place: what Debian asks of a package and nobody else.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share)
file(RENAME ${share}/doc/floes/LICENSE ${share}/doc/floes/copyright)
file(MAKE_DIRECTORY ${share}/zsh/vendor-completions)
file(RENAME ${share}/zsh/site-functions/_floes ${share}/zsh/vendor-completions/_floes)
file(REMOVE ${share}/zsh/site-functions)

# The site opens from its folder alone, wherever that is taken, so it holds the few scripts that Debian has elsewhere.
if(EXISTS ${share}/doc/floes/html)
  file(WRITE ${share}/lintian/overrides/floes "embedded-javascript-library *[usr/share/doc/floes/html/_static/*]\n")
endif()

# /usr/bin/python3 imports it without further ado, if its packages are there (CPACK_DEBIAN_PACKAGE_SUGGESTS).
set(modules ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/lib/python3/dist-packages)
file(MAKE_DIRECTORY ${modules})
file(RENAME ${share}/floes/python/floes_reader ${modules}/floes_reader)
file(REMOVE ${share}/floes/python/pyproject.toml)

execute_process(COMMAND date -u -R -d ${CPACK_FLOES_RELEASE_DATE} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${share}/doc/floes/changelog
"floes (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium

  * Released. CHANGELOG.md beside this file has every change.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${date}
")
execute_process(COMMAND gzip -9nf ${share}/doc/floes/changelog COMMAND_ERROR_IS_FATAL ANY)
