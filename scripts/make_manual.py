#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Make manual pages and completions for bash of what the applications print with -h.

Usage: scripts/make_manual.py BIN SHARE
BIN: the directory of the applications. SHARE gets man/man1/*.1 and bash-completion/completions/*.
"""
import argparse
import pathlib
import re
import subprocess

OPTION = re.compile(r"  -(\w+) ?(\S*) +(\S.*)")


def run(app, option):
    return subprocess.run([app, option], stdout=subprocess.PIPE, text=True, check=True).stdout


def parsed(text):
    """The operands, the purpose, the options (name, value, help) and what follows them."""
    usage, text = text.split("\n", 1)
    purpose, options, closing = text.split("\n\n", 2)
    found = []
    for line in options.splitlines():
        option = OPTION.fullmatch(line)
        if option:
            found.append(list(option.groups()))
        else:
            found[-1][2] += " " + line.strip()
    operands = usage.split(" ", 2)[2].removesuffix(" [options]")
    return operands, purpose.replace("\n", " "), found, " ".join(closing.split())


def roff(text):
    return re.sub(r"(?m)^\.", r"\\&.", text.replace("\\", r"\e").replace("-", r"\-"))


def manual(name, version, text):
    operands, purpose, options, closing = parsed(text)
    brief = re.split(r" ?[.:,(]", purpose)[0]
    lines = [f'.TH {name.upper()} 1 "" "pcl_shape {version}" "User Commands"',
             ".SH NAME", roff(f"{name} - {brief[0].lower()}{brief[1:]}"),
             ".SH SYNOPSIS", rf".B {name}", roff(f"{operands} [options]"),
             ".SH DESCRIPTION", roff(purpose),
             ".SH OPTIONS"]
    for option, value, help_text in options:
        lines += [".TP", rf"\fB\-{option}\fR" + (rf" \fI{roff(value)}\fR" if value else ""), roff(help_text)]
    lines += [".PP", roff(closing),
              ".SH SEE ALSO", "Files, errors and tutorials are described in the package pcl\\-shape\\-doc."]
    return "\n".join(lines) + "\n"


def completion(name, text):
    """Options after a dash, else files."""
    options = " ".join(f"-{option}" for option, _, _ in parsed(text)[2])
    return f"""# Completion of {name}.
_{name}()
{{
    if [[ ${{COMP_WORDS[COMP_CWORD]}} == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "{options}" -- "${{COMP_WORDS[COMP_CWORD]}}")
    fi
}}
complete -o bashdefault -o default -F _{name} {name}
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("bin", type=pathlib.Path, help="the directory of the applications")
    parser.add_argument("share", type=pathlib.Path, help="where man and bash-completion go")
    arguments = parser.parse_args()
    pages, completions = arguments.share / "man/man1", arguments.share / "bash-completion/completions"
    for directory in pages, completions:
        directory.mkdir(parents=True, exist_ok=True)
    apps = sorted(path for path in arguments.bin.resolve().iterdir() if re.fullmatch(r"pcl_(shape|inad)_\w+", path.name))
    for app in apps:
        text, version = run(app, "-h"), run(app, "--version").split()[-1]
        (pages / f"{app.name}.1").write_text(manual(app.name, version, text))
        (completions / app.name).write_text(completion(app.name, text))
    print(f"manual pages and completions of {len(apps)} applications")


main()
