"""What the bundle carries, what it leaves to the system, and what it leaves out, each with its
reason.
"""

# Qt loads these by name. No Wayland: VTK's libGLEW asks for GLX, which XWayland has.
PLUGINS = (
    "platforms/libqxcb.so",
    "platforms/libqoffscreen.so",
    "xcbglintegrations/libqxcb-glx-integration.so",
    "xcbglintegrations/libqxcb-egl-integration.so",
    "platforminputcontexts/libcomposeplatforminputcontextplugin.so",
    "platforminputcontexts/libibusplatforminputcontextplugin.so",
)

# The libraries that must be the system's own, and Debian's package of each. The list follows the
# excludelist of AppImage (github.com/AppImageCommunity/pkg2appimage, excludelist), which gives the
# reasons:
# - the C library and the compiler's: the system's drivers of OpenGL want theirs, which may be newer
#   than ours;
# - what talks to the graphics card, to the X server and to fontconfig's files;
# - what these load themselves, so that there are no two of them in one process.
# Other than there, libharfbuzz, libICE, libSM, libuuid and libgpg-error are carried: a bare Debian with
# a display has none of them. libudev is not: what it reads is the system's.
C_LIBRARY = {
    "ld-linux-x86-64.so.2": "libc6",
    "libc.so.6": "libc6",
    "libm.so.6": "libc6",
    "libdl.so.2": "libc6",
    "libpthread.so.0": "libc6",
    "librt.so.1": "libc6",
    "libresolv.so.2": "libc6",
    "libgcc_s.so.1": "libgcc-s1",
    "libstdc++.so.6": "libstdc++6",
    "libz.so.1": "zlib1g",
    "libudev.so.1": "libudev1",
}
DISPLAY = {
    "libGL.so.1": "libgl1",
    "libGLX.so.0": "libglx0",
    "libEGL.so.1": "libegl1",
    "libOpenGL.so.0": "libopengl0",
    "libGLdispatch.so.0": "libglvnd0",
    "libX11.so.6": "libx11-6",
    "libX11-xcb.so.1": "libx11-xcb1",
    "libxcb.so.1": "libxcb1",
    "libfontconfig.so.1": "libfontconfig1",
    "libfreetype.so.6": "libfreetype6",
    "libexpat.so.1": "libexpat1",
}
SYSTEM = {**C_LIBRARY, **DISPLAY}

# HDF5's driver of files on S3 (H5FDros3.c, H5FDs3comms.c) calls these. No program opens an
# address, and behind libcurl are Kerberos, LDAP, two kinds of TLS and twenty more.
_S3 = {
    "libcurl.so.4": {
        "curl_easy_cleanup",
        "curl_easy_init",
        "curl_easy_perform",
        "curl_easy_setopt",
        "curl_global_cleanup",
        "curl_global_init",
        "curl_slist_append",
        "curl_slist_free_all",
    },
    "libcrypto.so.3": {"EVP_sha256", "HMAC", "SHA256"},
}
# Libraries whose functions nothing in a bundle or wheel can reach: (who asks for it, which) -> the
# functions it asks for. Making it stops where one more is asked for, or where one is looked
# up before it is called, or where a program of ours calls NEVER_CALLED.
LEFT_OUT = {
    (f"libhdf5_serial.so.{number}", library): functions
    for number in (103, 310)  # of Debian 12 and 13
    for library, functions in _S3.items()
}
NEVER_CALLED = ("H5Pset_fapl_ros3", "H5FD_ros3", "H5FD_s3comms")

# Parts of packages that are under another licence than the package, as its copyright file says:
# never carried.
REFUSED = {"libvtkxdmf2-9.1.so.1": "GPL-2.0-or-later"}

# Programs that are not carried: many runs over MPI need the system's mpirun and its libraries.
PROGRAMS_LEFT_OUT = ("underact-sweep",)

# Libraries of headers only, which are in the programs all the same.
HEADERS = ("libeigen3-dev", "rapidjson-dev", "libcli11-dev", "libboost1.74-dev", "cppzmq-dev")
