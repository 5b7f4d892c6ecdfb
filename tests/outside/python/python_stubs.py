#!/usr/bin/env python3
"""Prints the type stubs of boxprobe.vtkBoxprobe, from the signatures that VTK's wrapping leaves in the docstrings:

    ./run python tests/outside/python/python_stubs.py > filters/vtk/python/boxprobe/vtkBoxprobe.pyi
"""

import importlib
import re

from boxprobe import vtkBoxprobe

MODULES = ["vtkCommonCore", "vtkCommonDataModel", "vtkCommonExecutionModel", "vtkRenderingCore"]
PLAIN = {"self", "float", "int", "bool", "str", "None"}


def type_of(text, imports, result=False):
    text = text.strip()
    if text[:1] in "[(" and result:
        return "tuple[" + ", ".join(type_of(part, imports) for part in text[1:-1].split(",")) + "]"
    if text[:1] in "[(":
        return f"Sequence[{type_of(text[1:-1].split(',')[0], imports)}]"
    if text in PLAIN or hasattr(vtkBoxprobe, text):
        return text
    for module in MODULES:
        if hasattr(importlib.import_module("vtkmodules." + module), text):
            imports.setdefault(module, set()).add(text)
            return text
    return "Any"


def split(arguments):
    """At the commas that are not within brackets."""
    return [part for part in re.split(r",\s*(?![^\[(]*[\])])", arguments) if part]


def lines_of(name, method, imports):
    text = re.sub(r"\n +", " ", method.__doc__ or "")  # long signatures go on in the next line
    found = re.findall(rf"^(?:\w+\.)?{name}\((.*)\) +-> (.*)$", text, re.MULTILINE)
    for arguments, result in found:
        parts = []
        for part in split(arguments):
            argument, _, kind = part.partition(":")
            default = ""
            kind, equals, _ = kind.partition("=")
            if equals:
                default = " = ..."
            parts.append("self" if part == "self" else f"{argument.strip('*')}: {type_of(kind, imports)}{default}")
        if len(found) > 1:
            yield "    @overload"
        if "self" not in parts[:1]:
            yield "    @staticmethod"
        yield f"    def {name}({', '.join(parts)}) -> {type_of(result, imports, True)}: ..."


def main():
    imports, body = {}, []
    for name in sorted(n for n in dir(vtkBoxprobe) if n.startswith("vtk")):
        owner = getattr(vtkBoxprobe, name)
        base = owner.__mro__[1].__name__
        type_of(base, imports)
        body += ["", "", f"class {name}({base}):"]
        for member, value in sorted(vars(owner).items()):
            if isinstance(value, int):
                body.append(f"    {member}: int")
            elif callable(value) and member[0].isupper():
                body += lines_of(member, value, imports)
    print('"""Made by python_stubs.py from the wrapped classes."""\n')
    print("from typing import Any, Sequence, overload\n")
    for module, names in sorted(imports.items()):
        print(f"from vtkmodules.{module} import {', '.join(sorted(names))}")
    print("\n".join(body))


main()
