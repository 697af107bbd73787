# SPDX-License-Identifier: MIT
# A port for vcpkg, of the library alone. The address and the checksum are those of the release that it is for.
vcpkg_download_distfile(ARCHIVE
    URLS "https://mgdt.example/mgdt-${VERSION}.tar.gz"
    FILENAME "mgdt-${VERSION}.tar.gz"
    SHA512 0)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")

vcpkg_configure_meson(
    SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS -Dtests=disabled -Dprogram=disabled -Dmpi=disabled -Ddocs=false -Dbindings=none)
vcpkg_install_meson()
vcpkg_fixup_pkgconfig()

vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/mgdt)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
