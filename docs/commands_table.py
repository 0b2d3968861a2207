"""Every command with its options, from the program itself; every public name of the library."""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from typing import Any

import typer

import viscodesign
import viscodesign.pump
from viscodesign.cli.app import app_for

HIDDEN = {"--install-completion", "--show-completion", "--help"}


def commands() -> Iterator[str]:
    """A section of the page for every command."""
    root: Any = typer.main.get_command(app_for([]))
    yield from _sections(root, "viscodesign")


def _sections(command: Any, name: str) -> Iterator[str]:
    inner = getattr(command, "commands", {})
    if not inner:
        yield _section(command, name)
    for word, own in inner.items():
        yield from _sections(own, f"{name} {word}")


def _section(command: Any, name: str) -> str:
    parameters = command.get_params(command.context_class(command))
    arguments = [p for p in parameters if p.param_type_name == "argument"]
    options = [p for p in parameters if p.param_type_name == "option"]
    usage = " ".join([name, *(_shown(p) for p in arguments), "[OPTIONS]"])
    text = inspect.cleandoc(command.help or "").replace("\b\n", "")
    parts = [f"## {name}", f"```text\n{usage}\n```", text]
    rows = [_row(p) for p in (*arguments, *options) if not HIDDEN & set(p.opts)]
    head = ["| argument or option | meaning | default |", "| --- | --- | --- |"]
    parts.append("\n".join([*head, *rows]))
    if command.epilog:
        parts.append(_example(command.epilog))
    return "\n\n".join(parts)


def _shown(argument: Any) -> str:
    name = argument.metavar or argument.name.upper()
    name = name.strip("[]").removesuffix("...") + ("..." if argument.nargs == -1 else "")
    return name if argument.required else f"[{name}]"


def _row(parameter: Any) -> str:
    is_option = parameter.param_type_name == "option"
    names = ", ".join(f"`{name}`" for name in (*parameter.opts, *parameter.secondary_opts))
    takes = is_option and not parameter.is_flag
    value = f" `{parameter.metavar or parameter.name.upper()}`" if takes else ""
    default = parameter.default
    is_shown = not callable(default) and default not in (None, False, (), [], "", ...)
    shown = f"`{default}`" if is_shown and not parameter.required else ""
    words = " ".join((parameter.help or "").split()).replace("|", "\\|")
    left = names + value if is_option else f"`{_shown(parameter)}`"
    return f"| {left} | {words} | {shown} |"


def _example(epilog: str) -> str:
    lines = [line for line in epilog.replace("\b", "").strip().splitlines()]
    return "```sh\n" + inspect.cleandoc("\n".join(["", *lines[1:]])) + "\n```"


def public_names() -> Iterator[str]:
    """A directive for every public function and class, which Sphinx fills from its docstring."""
    told: set[int] = set()
    for module in (viscodesign, viscodesign.pump):
        yield f"## {module.__name__}"
        for name in sorted(module.__all__, key=lambda name: (name[0].isupper(), name)):
            thing = getattr(module, name)
            kind = "class" if inspect.isclass(thing) else "function"
            if id(thing) not in told and (inspect.isclass(thing) or inspect.isfunction(thing)):
                told.add(id(thing))
                directive = f".. auto{kind}:: {module.__name__}.{name}"
                yield f"```{{eval-rst}}\n{directive}\n```"
