#!/usr/bin/env python3
"""Links a Python extension for Pyodide as Emscripten's emcc would, by the linker of Rust.

An extension is a side module: what it takes from C, from Python and for unwinding is left open, and
Pyodide's main module has it all. So neither Emscripten's libraries nor its other tools are needed.
rustc calls this with emcc's arguments.
"""

import json
import subprocess
import sys
from pathlib import Path


def command(arguments: list[str]) -> list[str]:
    """The call of wasm-ld that does what emcc would do with these arguments."""
    linker, exports, inputs = "", [], []
    for number, argument in enumerate(arguments):
        if argument.startswith("-B"):  # the folder of the linker, which rustc knows
            linker = str(Path(argument.removeprefix("-B"), "wasm-ld"))
        elif argument.startswith("EXPORTED_FUNCTIONS="):
            names = json.loads(argument.removeprefix("EXPORTED_FUNCTIONS="))
            exports = [f"--export={name.removeprefix('_')}" for name in names]
        elif argument.endswith((".o", ".rlib")):
            inputs.append(argument)
        elif argument == "-o":
            inputs += ["-o", arguments[number + 1]]
    if not linker or not exports:
        raise ValueError(f"not the arguments of a side module: {arguments}")
    module = ["-shared", "--experimental-pic", "--unresolved-symbols=import-dynamic"]
    return [linker, *module, "--gc-sections", "--strip-all", "-O2", *exports, *inputs]


if __name__ == "__main__":
    sys.exit(subprocess.run(command(sys.argv[1:])).returncode)
