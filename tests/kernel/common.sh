# common.sh - a Linux board in an emulator: a stock Debian kernel for arm64 on QEMU's machine `virt`. Its PL061 is
# /dev/gpiochip0, and its SPI is spi-gpio on lines of that chip, so that every edge of the panel's wires passes through
# one chip. For I2C, i2c-gpio takes the same two lines (SCL is driven; SDA is an open drain, which the model leaves low
# once it was low, so everything is acknowledged).
#
# Sourced by kernel/run and kernel/faults, which first set `work` to a folder to build in. Neither root nor KVM is
# needed (the guest is emulated even if there is KVM), and the host's own GPIO is not touched.

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(cd "$here/../.." && pwd)

# The chip's lines, with the names of a Raspberry Pi's header. QEMU can drive line 3 from outside (its power button).
# Line 7 marks the runs in the traces; it has the same name as line 6 on purpose.
line_names='"GPIO11", "GPIO10", "GPIO8", "GPIO24", "GPIO25", "GPIO27", "GPIO18", "GPIO18"'
chip_base_name=gpiochip0

say() {
    printf '%6.1f s  %s\n' "$(awk -v start="$started" '{ print $1 - start }' /proc/uptime)" "$*"
}
started=$(awk '{ print $1 }' /proc/uptime)

die() {
    echo "$(basename "$0"): $*" >&2
    exit 1
}

# Fetches kernel, busybox and both versions of libgpiod for arm64 and unpacks them into $work/v1 and $work/v2.
fetch_packages() {
    "$here/fetch" "$work/v1" arm64 bookworm linux-image-arm64 busybox-static libgpiod-dev libgpiod2
    "$here/fetch" "$work/v2" arm64 bookworm-backports libgpiod-dev libgpiod3
}

# Builds the shipped program with the shipped CMake and one version of libgpiod, v1 or v2. A unity build with little
# optimisation takes a third of the time.
build_panel() {
    local packages=$work/$1 log=$work/panel-$1.log

    export PKG_CONFIG_LIBDIR=$packages/usr/lib/aarch64-linux-gnu/pkgconfig PKG_CONFIG_SYSROOT_DIR=$packages
    if ! { cmake -S "$top" -B "$work/panel-$1" -DCMAKE_C_FLAGS='-O1 -Werror' -DCMAKE_UNITY_BUILD=ON \
        -DCMAKE_UNITY_BUILD_BATCH_SIZE=30 \
        -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc &&
        cmake --build "$work/panel-$1" --target sheen-panel -j "$(nproc)"; } </dev/null >"$log" 2>&1; then
        cat "$log" >&2
        die "sheen-panel does not build with libgpiod $1"
    fi
    unset PKG_CONFIG_LIBDIR PKG_CONFIG_SYSROOT_DIR
}

# Writes QEMU's own device tree, with names for the lines and with the SPI and I2C devices.
make_device_tree() {
    qemu-system-aarch64 "${machine[@]}" -machine dumpdtb="$work/virt.dtb" 2>"$work/dtb.log" ||
        die "QEMU writes no device tree: $(cat "$work/dtb.log")"
    {
        dtc -q -I dtb -O dts "$work/virt.dtb"
        cat <<EOF
/ {
    /delete-node/ gpio-keys;
    pl061@9030000 { gpio-line-names = $line_names; };
    spi {
        compatible = "spi-gpio";
        #address-cells = <1>;
        #size-cells = <0>;
        sck-gpios = <&{/pl061@9030000} 0 0>;
        mosi-gpios = <&{/pl061@9030000} 1 0>;
        cs-gpios = <&{/pl061@9030000} 2 1>;
        num-chipselects = <1>;
        panel@0 { compatible = "rohm,dh2228fv"; reg = <0>; spi-max-frequency = <10000000>; };
    };
    i2c {
        compatible = "i2c-gpio";
        #address-cells = <1>;
        #size-cells = <0>;
        sda-gpios = <&{/pl061@9030000} 1 6>;
        scl-gpios = <&{/pl061@9030000} 0 0>;
        i2c-gpio,scl-output-only;
        i2c-gpio,delay-us = <2>;
    };
};
EOF
    } >"$work/board.dts"
    dtc -q -I dts -O dtb -o "$work/board.dtb" "$work/board.dts"
}

# Packs busybox, modules, the C library, both versions of libgpiod, and the files $1..., given as NAME=PATH. /init
# mounts the folder $work/share as /host and runs /host/main.
make_initrd() {
    local root=$work/initrd modules module pair

    rm -rf "$root"
    mkdir -p "$root"/{bin,lib,modules,proc,sys,dev,host,tmp,etc}
    cp "$work/v1/bin/busybox" "$root/bin/"
    modules=$(echo "$work"/v1/lib/modules/*/kernel)
    for module in drivers/virtio/virtio_mmio fs/netfs/netfs fs/fscache/fscache net/9p/9pnet net/9p/9pnet_virtio \
        fs/9p/9p drivers/spi/spi-bitbang drivers/spi/spi-gpio drivers/i2c/algos/i2c-algo-bit \
        drivers/i2c/busses/i2c-gpio drivers/i2c/i2c-dev; do
        cp "$modules/$module.ko" "$root/modules/"
    done
    cp -L /usr/aarch64-linux-gnu/lib/{ld-linux-aarch64.so.1,libc.so.6,libm.so.6} "$root/lib/"
    cp -L "$work"/v1/usr/lib/aarch64-linux-gnu/libgpiod.so.2 "$work"/v2/usr/lib/aarch64-linux-gnu/libgpiod.so.3 "$root/lib/"
    for pair in init="$here/init" "$@"; do
        cp "${pair#*=}" "$root/${pair%%=*}"
    done
    (cd "$root" && find . | cpio -o -H newc --quiet -R 0:0 | gzip -1) >"$work/initrd.gz"
}

machine=(-M virt,accel=tcg -cpu cortex-a53 -m 256 -smp 1 -nodefaults -display none)

# If that is allowed, the guest gets priority over other processes, because the emulator's threads hand over to each
# other at every timer and would have to wait each time.
urgent=(nice -n -10)
[ -z "$("${urgent[@]}" true 2>&1)" ] || urgent=() # if it is not allowed, nice prints that and goes on

# Boots and returns when the guest powers off, or after $1 seconds. The guest's output goes to $work/console. Further
# words are passed to QEMU. norandmaps: programs that are always at the same addresses need not be translated again,
# which makes short ones 5 times as fast.
boot() {
    local seconds=$1 status=0

    shift
    timeout "$seconds" "${urgent[@]}" qemu-system-aarch64 "${machine[@]}" -no-reboot -serial stdio -monitor none \
        -kernel "$work"/v1/boot/vmlinuz-* -initrd "$work/initrd.gz" -dtb "$work/board.dtb" \
        -append 'console=ttyAMA0 quiet panic=-1 norandmaps' \
        -fsdev local,id=host,path="$work/share",security_model=none -device virtio-9p-device,fsdev=host,mount_tag=host \
        "$@" </dev/null >"$work/console" 2>"$work/qemu.log" || status=$?
    tr -d '\r' <"$work/console" >"$work/console.txt"
    if [ "$status" -ne 0 ] || ! grep -q '^guest: done$' "$work/console.txt"; then
        tail -n 40 "$work/console.txt" "$work/qemu.log" >&2
        die "the guest did not come to its end (status $status, limit $seconds s)"
    fi
}
