#!/usr/bin/env python3
"""Each `@p name` of a comment in an installed header is a name of the declaration below the comment; exit code 1 if not."""
import pathlib
import re
import sys

source = pathlib.Path(__file__).resolve().parents[2]
troubles = []
headers = [*source.glob("ring_model/**/*.h"), *(file for file in source.glob("fem/**/*.h") if "pipeline" not in file.parts)]
for header in sorted(headers):
    lines = header.read_text(encoding="utf-8").splitlines()
    start = 0
    while start < len(lines):
        if not re.match(r"\s*(///(?!<)|/\*\*)", lines[start]):
            start += 1
            continue
        end = start
        block = lines[start].lstrip().startswith("/**")
        while end + 1 < len(lines) and ("*/" not in lines[end] if block else re.match(r"\s*///(?!<)", lines[end + 1])):
            end += 1
        comment, code = "\n".join(lines[start:end + 1]), []
        for line in lines[end + 1:]:  # to the end of the declaration, with the parameters of a class behind its brace
            if re.match(r"\s*(///(?!<)|/\*\*)|\s*$", line):
                break
            code.append(line)
        for name in re.findall(r"@p (\w+)", comment):
            if not re.search(rf"\b{name}\b", "\n".join(code)):
                troubles.append(f"{header.relative_to(source)}:{start + 1}: @p {name} is no name of the declaration below")
        start = end + 1
print("\n".join(troubles) or f"@p names what there is in {len(headers)} headers.")
sys.exit(len(troubles) > 0)
