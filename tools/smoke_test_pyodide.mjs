// Runs tools/smoke_test_core.py on a wheel in Pyodide: smoke_test_pyodide.mjs PYODIDE.mjs WHEEL TREE
import { readFileSync } from "node:fs";

const [module, wheel, tree] = process.argv.slice(2);
const { loadPyodide } = await import(module);
const pyodide = await loadPyodide();
pyodide.unpackArchive(new Uint8Array(readFileSync(wheel)).buffer, "wheel");
pyodide.mountNodeFS("/tree", tree);
pyodide.runPython('import runpy; runpy.run_path("/tree/tools/smoke_test_core.py", run_name="__main__")');
