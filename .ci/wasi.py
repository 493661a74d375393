#!/usr/bin/env python3
"""Runs a program of WASI with this machine's files and variables: `wasi.py PROGRAM ARGUMENTS…`, by PyPI's wasmtime."""
import os
import sys

from wasmtime import Engine, ExitTrap, Linker, Module, Store, WasiConfig

engine = Engine()
linker = Linker(engine)
linker.define_wasi()
wasi = WasiConfig()
wasi.argv = sys.argv[1:]
# A program of WASI has no folder that it is in: what is relative it finds under the name ".".
wasi.env = os.environ.items()
wasi.inherit_stdin()
wasi.inherit_stdout()
wasi.inherit_stderr()
wasi.preopen_dir(".", ".")
wasi.preopen_dir("/", "/")
store = Store(engine)
store.set_wasi(wasi)
program = linker.instantiate(store, Module.from_file(engine, sys.argv[1]))
try:
    program.exports(store)["_start"](store)
except ExitTrap as exit:
    sys.exit(exit.code)
