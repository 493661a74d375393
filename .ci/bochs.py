#!/usr/bin/env python3
"""Runs Rust's tests on an emulated processor with AVX-512: `bochs.py PROGRAM ARGUMENTS…`, by Debian's bochs. The program
is static; what its arguments choose runs test by test, as one that ends its process shall end no other.

The machine starts Debian's kernel from a CD image, with a file system in memory that holds busybox and the program, and
prints to a serial line. It runs some 20 million instructions a second: most of a minute to start, and minutes for a
test of a second.
"""
import glob
import os
import pty
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading
import time

CONFIGURATION = """
display_library: term
cpu: model=corei7_skylake_x, count=1, ips=20000000, reset_on_triple_fault=0, ignore_bad_msrs=1
memory: guest=1024, host=1024
romimage: file=/usr/share/bochs/BIOS-bochs-latest
vgaromimage: file=/usr/share/vgabios/vgabios.bin
vga: update_freq=1
ata0-master: type=cdrom, path=cd.iso, status=inserted
boot: cdrom
com1: enabled=1, mode=file, dev=serial
log: log
clock: sync=none
panic: action=fatal
error: action=ignore
"""
# Clocks by interrupt: those that a kernel likes better stand still. Without XSAVEC and XSAVES, whose size is told wrongly.
LOADER = """
default linux
label linux
kernel vmlinuz
append initrd=initrd console=ttyS0 quiet mitigations=off tsc=unstable clocksource=jiffies highres=off nohz=off nolapic_timer clearcpuid=321,323
"""
INIT = """#!/bin/busybox sh
/bin/busybox mount -t proc proc /proc
/bin/busybox mount -t devtmpfs dev /dev
/bin/busybox mkdir /tmp
{variables}
echo BEGIN
if /bin/busybox grep -q avx512vl /proc/cpuinfo; then
  status=0
  {command} --list 2>&1 | /bin/busybox sed -n 's/: test$//p' > /tests
  while read -r test; do
    if /program --exact "$test" > /output 2>&1; then
      echo "$test ... ok"
    else
      status=1
      echo "$test ... FAILED"
      /bin/busybox cat /output
      /bin/busybox dmesg | /bin/busybox grep trap | /bin/busybox tail -n 1
    fi
  done < /tests
else
  echo 'this kernel found no AVX-512'
  status=1
fi
echo END $status
# What is still on its way to the serial line.
/bin/busybox sleep 5
/bin/busybox poweroff -f
"""


def build(folder, program, arguments):
    """The CD image."""
    tree, disc = os.path.join(folder, "tree"), os.path.join(folder, "disc")
    for made in ["bin", "proc", "dev"]:
        os.makedirs(os.path.join(tree, made))
    os.makedirs(disc)
    shutil.copy("/bin/busybox", os.path.join(tree, "bin"))
    subprocess.run(["strip", "-o", os.path.join(tree, "program"), program], check=True)
    kept = {name: value for name, value in os.environ.items() if name.startswith(("PROPTEST_", "DETGL_", "RUST_"))}
    variables = "\n".join(f"export {name}={shlex.quote(value)}" for name, value in sorted(kept.items()))
    init = os.path.join(tree, "init")
    with open(init, "w") as file:
        file.write(INIT.format(variables=variables, command=shlex.join(["/program", *arguments])))
    os.chmod(init, 0o755)
    with open(os.path.join(disc, "initrd"), "wb") as file:
        names = subprocess.run(["find", "."], cwd=tree, check=True, capture_output=True).stdout
        made = subprocess.run(["cpio", "-o", "-H", "newc"], cwd=tree, check=True, input=names, capture_output=True)
        file.write(made.stdout)
    shutil.copy(max(glob.glob("/boot/vmlinuz-*")), os.path.join(disc, "vmlinuz"))
    shutil.copy("/usr/lib/ISOLINUX/isolinux.bin", disc)
    shutil.copy("/usr/lib/syslinux/modules/bios/ldlinux.c32", disc)
    with open(os.path.join(disc, "isolinux.cfg"), "w") as file:
        file.write(LOADER)
    boot = ["-b", "isolinux.bin", "-c", "boot.cat", "-no-emul-boot", "-boot-load-size", "4", "-boot-info-table"]
    image = os.path.join(folder, "cd.iso")
    subprocess.run(["xorriso", "-as", "mkisofs", "-quiet", "-o", image, *boot, disc], check=True, capture_output=True)


def read_all(terminal):
    """Until there is no more."""
    try:
        while os.read(terminal, 65536):
            pass
    except OSError:
        pass


def run(folder):
    """What the program printed, as it does; its exit status."""
    with open(os.path.join(folder, "bochsrc"), "w") as file:
        file.write(CONFIGURATION)
    with open(os.path.join(folder, "commands"), "w") as file:
        file.write("c\n")
    # Debian's has a debugger and draws on a terminal, which somebody has to read.
    screen, end = pty.openpty()
    command = ["bochs-bin", "-q", "-f", "bochsrc", "-rc", "commands"]
    terminal = {**os.environ, "TERM": "xterm"}
    machine = subprocess.Popen(
        command, cwd=folder, env=terminal, stdin=end, stdout=end, stderr=end, start_new_session=True
    )
    os.close(end)
    threading.Thread(target=read_all, args=[screen], daemon=True).start()
    serial, printed, text = os.path.join(folder, "serial"), 0, ""
    while True:
        time.sleep(0.5)
        alive = machine.poll() is None
        if os.path.exists(serial):
            with open(serial, errors="replace", newline="") as file:
                text = file.read().replace("\r\n", "\n")
            text = text.partition("BEGIN\n")[2]
            shown = text.partition("END ")[0]
            print(shown[printed:], end="", flush=True)
            printed = len(shown)
        if not alive or re.search(r"END \d+\n", text):
            break
    machine.kill()
    machine.wait()
    ended = re.search(r"END (\d+)\n", text)
    if ended is None:
        sys.exit("the machine stopped before the program did")
    return int(ended[1])


with tempfile.TemporaryDirectory() as folder:
    build(folder, sys.argv[1], sys.argv[2:])
    sys.exit(run(folder))
