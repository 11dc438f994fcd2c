#!/usr/bin/env python3
"""Makes the site: the pages of docs/ and the API of the installed headers. Debian's mkdocs-material, doxygen and libjs-katex.

    make_site.py FOLDER [--repository URL]    writes FOLDER/html; links to sources lead to URL, without URL they are plain text

On GitHub, URL is the address of the commit that the workflow checked out.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
source = here.parents[1]
pages = {"README.md": "index.md", "docs/index.md": "reading.md", "CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md",
         "meshes/README.md": "meshes.md", "docs/explore.html": "live.html"}  # explore.md becomes explore.html
katex = pathlib.Path("/usr/share/javascript/katex")


def place(path):
    """Returns the path on the site of a file of the repository, or None if the site does not have the file."""
    name = path.as_posix()
    return pages.get(name) or (name[len("docs/"):] if name.startswith("docs/") and (source / path).is_file() else None)


def linked(text, page, repository):
    """Returns the text of a page with its links converted to links on the site."""
    def link(match):
        label, target, fragment = match.group(1), match.group(2), match.group(3) or ""
        if re.match(r"[a-z]+:", target) or not target:
            return match.group(0)
        path = pathlib.Path(os.path.normpath(page.parent / target))
        there = place(path)
        if there:
            own = pathlib.PurePosixPath(place(page)).parent
            return f"{label}({os.path.relpath(there, own)}{fragment})"
        if label.startswith("!"):
            return match.group(0)
        return f"{label}({repository}/{path.as_posix()}{fragment})" if repository and path.parts[0] != ".." else label[1:-1]

    return re.sub(r"(!?\[(?:[^\[\]]|\[[^\[\]]*\])*\])\(([^()#\s]*)(#[^()\s]*)?\)", link, text)


def main():
    options = argparse.ArgumentParser(usage=__doc__)
    options.add_argument("folder", type=lambda text: pathlib.Path(text).resolve())
    options.add_argument("--repository", default=os.environ.get("STEMWARE_REPOSITORY", "").rstrip("/"))
    given = options.parse_args()
    staged, site = given.folder / "pages", given.folder / "html"
    shutil.rmtree(given.folder, ignore_errors=True)
    shutil.copytree(source / "docs", staged, ignore=shutil.ignore_patterns("site", "CMakeLists.txt", "__pycache__", "*.pyc"))
    (staged / "explore.html").rename(staged / "live.html")
    files = [pathlib.Path(name) for name in pages if name.endswith(".md")] + [file.relative_to(source) for file in (source / "docs").rglob("*.md")]
    (staged / "index.md").unlink()
    for file in files:
        text = re.sub(r"<!--.*?-->", "", (source / file).read_text(encoding="utf-8"), flags=re.S)
        (staged / place(file)).write_text(linked(text, file, given.repository), encoding="utf-8")
    shutil.copytree(here / "assets", staged / "assets")
    (staged / "assets" / "katex").mkdir()
    for name in ("katex.min.js", "katex.min.css", "contrib/auto-render.js"):
        shutil.copy(katex / name, staged / "assets" / "katex")
    shutil.copytree(katex / "fonts", staged / "assets" / "katex" / "fonts")
    warnings = given.folder / "api_warnings.txt"
    environment = {**os.environ, "SOURCE_FOLDER": str(source), "API_FOLDER": str(staged), "API_WARNINGS": str(warnings)}
    subprocess.run([sys.executable, here / "check_headers.py"], check=True)
    subprocess.run(["doxygen", here / "Doxyfile"], check=True, cwd=source, env=environment)
    # Comments are required for classes, functions, types and constants of namespaces, not for members.
    wrong = [line for line in warnings.read_text().splitlines() if not re.search(r"Member .* of (class|struct) .* is not documented", line)]
    if wrong:
        sys.exit("\n".join(wrong))
    subprocess.run(["mkdocs", "build", "--strict", "--quiet", "--config-file", here / "mkdocs.yml", "--site-dir", site], check=True,
                   env={**environment, "SITE_PAGES": str(staged)})
    print(f"{site}/index.html")


if __name__ == "__main__":
    main()
