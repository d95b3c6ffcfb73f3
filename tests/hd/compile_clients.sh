#!/bin/sh
# Installs libHD.so, libHDU.a and the headers into a new folder and uses them as a stranger would: every header alone and every sample,
# from C11, C++11 and C++20, with gcc and clang, warnings as errors; linked through pkg-config and by plain -lHDU -lHD; one is run.
#   compile_clients.sh CMAKE BUILD_FOLDER TEST_FOLDER
set -eu
cmake=$1 build=$2 tests=$3
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
"$cmake" --install "$build" --component hd --prefix "$root/usr" >"$root/install.log"
warnings="-Wall -Wextra -Werror -Wpedantic -Wshadow -Wconversion -Wno-unused"
include="$root/usr/include"
lib=$(dirname "$(find "$root/usr" -name libHD.so)")
count=0

headers() { (cd "$include" && find HD HDU HL HLU -name '*.h' | sort); }

# Every header alone and twice; with `linux` defined as some programs do.
for compiler in gcc clang; do
  command -v $compiler >/dev/null || { echo "SKIPPED: $compiler is not installed"; continue; }
  for header in $(headers); do
    case $header in HDU/hduMatrixInline.h) continue ;; esac
    printf '#include <%s>\n#include <%s>\nint main(void) { return 0; }\n' "$header" "$header" >"$root/one.c"
    for language in "c -std=c11" "c++ -std=c++11" "c++ -std=c++17" "c++ -std=c++20" "c++ -std=c++20 -Dlinux=" "c++ -std=gnu++17"; do
      # shellcheck disable=SC2086  # words
      $compiler -x $language $warnings -isystem /nowhere -I"$include" -fsyntax-only "$root/one.c" || { echo "FAIL: $compiler $language $header"; exit 1; }
      count=$((count + 1))
    done
  done
done
echo "$count header compilations"

# Every sample, linked.
ran=0
for pair in "gcc g++" "clang clang++"; do
  c=${pair% *} cxx=${pair#* }
  command -v "$cxx" >/dev/null || continue
  for source in "$tests"/samples/*.c "$tests"/samples/*.cpp; do
    case $source in
      */dlopen_client.c) continue ;;
      *.c) standards="c11 gnu17"; compiler=$c; define=-D_POSIX_C_SOURCE=200809L ;;
      *) standards="c++11 c++20"; compiler=$cxx; define= ;;
    esac
    for standard in $standards; do
      $compiler -std=$standard $define -Wall -Wextra -Werror -I"$include" "$source" -o "$root/program" -L"$lib" -lHDU -lHD -lrt -lstdc++ -lm
      ran=$((ran + 1))
    done
  done
done
if command -v pkg-config >/dev/null; then
  # shellcheck disable=SC2046
  PKG_CONFIG_PATH=$(dirname "$(find "$root/usr" -name HD.pc)") \
    sh -c "gcc -std=c11 '$tests/samples/query_device.c' -o '$root/program' \$(pkg-config --cflags --libs HD)"
else
  echo "SKIPPED: pkg-config is not installed"
  gcc -std=c11 -I"$include" "$tests/samples/query_device.c" -o "$root/program" -L"$lib" -lHDU -lHD
fi
LD_LIBRARY_PATH=$lib "$root/program" | grep -q 'handle 0 model Touch'
echo "$ran programs linked"

# The library says what it is and shows nothing else.
exported=$(nm -D --defined-only "$lib/libHD.so" | awk '{print $3}' | sort)
[ "$(echo "$exported" | wc -l)" -eq 36 ] && ! echo "$exported" | grep -qv '^hd[A-Z]' || { echo "FAIL: exports: $exported"; exit 1; }
others=$(nm -D --defined-only "$lib/libHL.so" | awk '{print $3}')
! echo "$others" | grep -qvE '^(hl[A-Z]|HL_)' || { echo "FAIL: exports of libHL.so: $others"; exit 1; }
nm -D --defined-only "$lib/libHL.so" >"$root/symbols"
nm --defined-only "$lib/libHLU.a" >>"$root/symbols" 2>/dev/null
for function in $(grep -ohE '\bhlu?[A-Z][A-Za-z0-9]*\(' "$include/HL/hl.h" "$include/HLU/hlu.h" | sort -u | tr -d '('); do
  grep -q " $function$" "$root/symbols" || { echo "FAIL: $function is declared and not there"; exit 1; }
done
readelf -d "$lib/libHD.so" | grep -q 'SONAME.*libHD.so.3.4]'
readelf -d "$lib/libHD.so" | grep NEEDED | grep -vE 'libstdc\+\+|libm|libgcc_s|libc\.so|ld-linux' && { echo "FAIL: needs more than the system"; exit 1; }
echo "36 functions exported"
