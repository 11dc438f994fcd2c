#!/usr/bin/env python3
"""Writes docs/summary.md, the keys of summary.json, from its schema.

    keys.py SCHEMA            writes the page from build/release/share/stemware/summary.schema.json
    keys.py SCHEMA --check    exit code 1 if the page differs
"""
import json
import pathlib
import sys

here = pathlib.Path(__file__).resolve().parent
HEAD = "| key | unit | meaning |\n|---|---|---|\n"


def rows(schema, path=""):
    """Returns the table rows of a schema's properties; nested properties follow their object or list."""
    text = ""
    for key, value in schema.get("properties", {}).items() if isinstance(schema, dict) else ():
        meaning = value.get("description", "").replace("|", "\\|")
        text += f"| `{path}{key}` | {value.get('unit', '')} | {meaning} |\n"
        if key.startswith("load_at_"):  # the same keys as `load`
            continue
        text += rows(value, f"{path}{key}.") + rows(value.get("items", {}), f"{path}{key}[].")
        if isinstance(value.get("additionalProperties"), dict):
            text += rows(value["additionalProperties"], f"{path}{key}.*.")
    return text


schema = json.loads(pathlib.Path(sys.argv[1]).read_text())
page = f"""# The keys of summary.json

`summary.json` contains all numerical results of a command (a verb, e.g. `run`). Units are SI and rad; \
vectors are in the slip frame (x along the direction of travel). Missing numbers are null. \
`docs/keys.py` makes this page from `share/stemware/summary.schema.json`. Each verb writes a subset of the keys; \
`[]` represents each entry of a list, `*` any name.

`load_at_terminal` and `load_at_fall` have the keys of `load`.

{HEAD}{rows(schema)}"""
if "--check" not in sys.argv:
    (here / "summary.md").write_text(page)
elif (here / "summary.md").read_text() != page:
    sys.exit("docs/summary.md is not what the schema declares; `docs/keys.py SCHEMA` makes it again.")
