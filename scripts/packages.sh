# What the project needs from the system, in one place. Sourced by run.sh and test.sh; bash.

# To build and run the program.
build_packages=(g++ cmake ninja-build pkg-config
    libtinyxml2-dev libeigen3-dev libnanoflann-dev libpolyclipping-dev libcli11-dev nlohmann-json3-dev
    librsvg2-dev libcairo2-dev zlib1g-dev
    libboost-dev libpng-dev libtinyobjloader-dev libtinygltf-dev
    libglfw3-dev libimgui-dev libglm-dev libepoxy-dev libagg2-dev libglu1-mesa-dev fonts-dejavu-core)

# To test it, on top of that.
test_packages=(catch2 libbullet-dev librsvg2-bin python3 python3-numpy python3-pil python3-jsonschema
    contextfree inkscape xvfb xauth xdotool imagemagick libgl1-mesa-dri groff-base man-db)
fuzz_packages=(clang libclang-rt-14-dev llvm)  # on top of what it takes to build

# On top of those of the tests: for the sanitizers, for the lines that run, for clang-tidy.
sanitize_packages=(clang libclang-rt-14-dev llvm)
coverage_packages=(gcovr)
tidy_packages=(clang clang-tidy python3)

# For the benchmarks (docs/benchmarks.md), on top of what it takes to build: Google Benchmark, and programs to compare with.
bench_packages=(libbenchmark-dev python3 contextfree inkscape python3-lxml python3-cssselect scour librsvg2-bin)

# node and npm often come from elsewhere.
for program in node:nodejs npm:npm; do
    command -v "${program%:*}" >/dev/null || { test_packages+=("${program#*:}"); bench_packages+=("${program#*:}"); }
done

# To make packages for Debian and to test them, on top of what a build needs.
package_packages=(dpkg-dev fakeroot file lintian desktop-file-utils shared-mime-info appstream python3)

# To make the site of the pages, alone.
docs_packages=(doxygen python3 python3-sphinx python3-myst-parser furo)

say() { printf '%s\n' "$*" >&2; }

is_debian() { command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; }

# The given packages that are not installed, one a line.
missing_packages() {
    local package
    for package in "$@"; do
        [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || printf '%s\n' "$package"
    done
}

# For systems without apt: the same things by their own names.
say_what_to_install() {
    say "Install these by your system's own means and start again (the names are Debian's):"
    say "    $*"
    say "That is: a C++20 compiler (GCC 12 or newer), CMake 3.25, Ninja, pkg-config, and the development files of tinyxml2,"
    say "Eigen 3.4, nanoflann 1.4, Clipper 6 (polyclipping), CLI11 2, nlohmann-json 3, Boost 1.74, libpng, tinyobjloader 2, TinyGLTF 2, librsvg 2, cairo, zlib, GLFW 3.3, Dear ImGui 1.86, GLM, libepoxy, GLU, AGG 2.6;"
    say "for the tests also Catch2 2.13, Bullet 3, rsvg-convert, Python 3 with numpy, Pillow and jsonschema, Inkscape 1.2 with Xvfb and xdotool,"
    say "Context Free 3, ImageMagick, node with npm, groff and man."
}

# Installs what is missing of the given packages; asks for rights only if something is.
install_packages() {
    local missing as_root=()
    if ! is_debian; then
        have_build_tools && return 0
        say_what_to_install "$@"
        return 1
    fi
    mapfile -t missing < <(missing_packages "$@")
    [ ${#missing[@]} -eq 0 ] && return 0
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            say "Some packages are missing, and only root can install them. As root:"
            say "    apt-get update && apt-get install --no-install-recommends ${missing[*]}"
            return 1
        fi
        as_root=(sudo)
    fi
    say "Installing: ${missing[*]}"
    local install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive
        apt-get install -y -qq --no-install-recommends "${missing[@]}")
    # Fresh images carry no package lists, old ones carry lists of versions that are gone.
    if compgen -G '/var/lib/apt/lists/*_Packages*' >/dev/null && "${install[@]}" >&2; then return 0; fi
    "${as_root[@]}" apt-get update -qq >&2
    "${install[@]}" >&2
}

# Whether a build can at least be tried on a system whose packages are unknown here.
have_build_tools() {
    local tool
    for tool in cmake ninja pkg-config c++; do command -v "$tool" >/dev/null || return 1; done
}
