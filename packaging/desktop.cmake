# What a desktop is told about the editor: menu entry, icon, kinds of files, manual page.

set(desktop ${CMAKE_CURRENT_SOURCE_DIR}/desktop)
set(told ${CMAKE_CURRENT_BINARY_DIR}/share)
file(MAKE_DIRECTORY ${told})
configure_file(${desktop}/org.rinceau.editor.metainfo.xml.in ${told}/org.rinceau.editor.metainfo.xml @ONLY)
configure_file(${desktop}/rinceau-editor.1.in ${told}/rinceau-editor.1 @ONLY)

# The program draws its icon from the icon's rules.
set(icon_folder ${CMAKE_INSTALL_DATADIR}/icons/hicolor)
set(icons ${told}/rinceau.svg)
set(draw_icons COMMAND rinceau render ${desktop}/icon.lsys -o ${told}/rinceau.svg)
install(FILES ${told}/rinceau.svg DESTINATION ${icon_folder}/scalable/apps COMPONENT editor)
foreach(size IN ITEMS 48 64 128 256)
  list(APPEND icons ${told}/rinceau-${size}.png)
  list(APPEND draw_icons COMMAND rinceau render ${desktop}/icon.lsys -o ${told}/rinceau-${size}.png --width ${size})
  install(FILES ${told}/rinceau-${size}.png RENAME rinceau.png DESTINATION ${icon_folder}/${size}x${size}/apps COMPONENT editor)
endforeach()
add_custom_command(OUTPUT ${icons} ${draw_icons} DEPENDS rinceau ${desktop}/icon.lsys VERBATIM)

find_program(RINCEAU_GZIP gzip REQUIRED)
add_custom_command(OUTPUT ${told}/rinceau-editor.1.gz
  COMMAND ${RINCEAU_GZIP} -9nkf ${told}/rinceau-editor.1
  DEPENDS ${told}/rinceau-editor.1
  VERBATIM)
add_custom_target(desktop ALL DEPENDS ${icons} ${told}/rinceau-editor.1.gz)

install(FILES ${desktop}/org.rinceau.editor.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT editor)
install(FILES ${told}/org.rinceau.editor.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT editor)
install(FILES ${desktop}/rinceau.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT editor)
install(FILES ${told}/rinceau-editor.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT editor)
