# Read by CPack once for each kind of package, CPACK_GENERATOR: see underact.cmake beside.
if(CPACK_GENERATOR STREQUAL "RPM")
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_RPM_FILE_NAME RPM-DEFAULT)
  set(CPACK_RPM_PACKAGE_RELEASE 1)
  set(CPACK_RPM_PACKAGE_LICENSE BSD)
  set(CPACK_RPM_PACKAGE_GROUP Applications/Engineering)
  # rpmbuild finds the libraries that are linked. By name: what is started, the figures' Python, and the platform plugin.
  set(CPACK_RPM_PACKAGE_SUGGESTS "python3-h5py, python3-matplotlib, rtkit")
  # No name of the machine and no time but the release's, where SOURCE_DATE_EPOCH says it.
  set(CPACK_RPM_SPEC_MORE_DEFINE "%define _buildhost underact
%define use_source_date_epoch_as_buildtime 1
%define clamp_mtime_to_source_date_epoch 1
%define _build_id_links none")
  # Folders that other packages own.
  set(CPACK_RPM_EXCLUDE_FROM_AUTO_FILELIST_ADDITION /usr/lib/udev /usr/lib/udev/rules.d /usr/share/applications
      /usr/share/icons /usr/share/icons/hicolor /usr/share/icons/hicolor/scalable /usr/share/icons/hicolor/scalable/apps
      /usr/share/icons/hicolor/scalable/mimetypes /usr/share/metainfo /usr/share/mime /usr/share/mime/packages
      /usr/share/man /usr/share/man/man1 /usr/share/bash-completion /usr/share/bash-completion/completions
      /usr/share/zsh /usr/share/zsh/vendor-completions /usr/share/fish /usr/share/fish/vendor_completions.d
      /usr/libexec)
endif()

if(CPACK_GENERATOR MATCHES "NSIS")
  set(CPACK_PACKAGE_FILE_NAME "Underact-${CPACK_PACKAGE_VERSION}-win64")
  set(CPACK_NSIS_PACKAGE_NAME Underact)
  set(CPACK_NSIS_DISPLAY_NAME "Underact ${CPACK_PACKAGE_VERSION}")
  set(CPACK_NSIS_INSTALLED_ICON_NAME bin\\\\underact.exe)
  set(CPACK_NSIS_ENABLE_UNINSTALL_BEFORE_INSTALL ON)  # the user's scenes and settings lie elsewhere
  set(CPACK_NSIS_MODIFY_PATH ON)  # asked, not done: for underact-cli
  set(CPACK_NSIS_MANIFEST_DPI_AWARE ON)
endif()

if(CPACK_GENERATOR STREQUAL "DragNDrop")
  set(CPACK_PACKAGE_FILE_NAME "Underact-${CPACK_PACKAGE_VERSION}-macos")
  set(CPACK_DMG_VOLUME_NAME Underact)
  set(CPACK_DMG_FORMAT UDZO)
  set(CPACK_DMG_SLA_USE_RESOURCE_FILE_LICENSE OFF)
endif()
