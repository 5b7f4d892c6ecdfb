#!/usr/bin/env python3
"""The site of the documents, made and read by another parser than the one that made it: site_links.py PROJECT FOLDER

Every link and picture leads to a file of the site, every anchor to an element of that page, every README.md has a page
that is reached from the first. Then the project's documents are damaged, and make_site.py must say where.
"""
import os
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

if not shutil.which("cmark-gfm"):
    print("left out: package cmark-gfm is not installed")
    sys.exit(77)
project, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
site = folder / "site"


def make(source, out, *more):
    command = [sys.executable, project / "app/site/make_site.py", out, "--source", source, *more]
    return subprocess.run(command, capture_output=True, text=True)


def fail(text):
    sys.exit(f"FAILED: {text}")


class Links(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.targets, self.ids = [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src"):
                self.targets.append(value)
            elif name == "id":
                self.ids.append(value)


def check(site):
    pages = {path: Links(path.read_text()) for path in site.rglob("*.html")}
    problems, reached, links, anchors = [], [site / "index.html"], 0, 0
    for page in reached:
        if page not in pages:
            continue
        ids = pages[page].ids
        problems += [f"{page}: id {i} stands twice" for i in set(ids) if ids.count(i) > 1]
        for target in pages[page].targets:
            parts = urlsplit(target)
            if parts.scheme:
                continue
            links += 1
            to = Path(os.path.normpath(page.parent / unquote(parts.path))) if parts.path else page
            if not to.is_file():
                problems.append(f"{page}: {target}: no such file")
                continue
            if parts.fragment:
                anchors += 1
                if to not in pages or unquote(parts.fragment) not in pages[to].ids:
                    problems.append(f"{page}: {target}: no such anchor")
            if to not in reached:
                reached.append(to)
    return problems, set(reached), links, anchors


made = make(project, site)
if made.returncode != 0:
    fail(made.stdout + made.stderr)
problems, reached, links, anchors = check(site)
if problems:
    fail("\n".join(problems))
files = subprocess.run(["git", "-C", project, "ls-files", "*README.md"], capture_output=True, text=True).stdout.split()
documents = [Path(f) for f in files] or [p.relative_to(project) for p in project.glob("*/**/README.md")]
for document in documents:
    if site / document.parent / "index.html" not in reached:
        fail(f"{document} has no page that is reached from the first")
if len(documents) < 20 or links < 500 or anchors < 15:
    fail(f"only {len(documents)} documents, {links} links and {anchors} anchors were checked")
first = (site / "index.html").read_text()
for wanted in ("<table>", "language-sh", 'id="two-commands"', "front.png"):
    if wanted not in first:
        fail(f"the first page has no {wanted}")

# Damaged: what is wrong is named, and the site that was there stays.
copy = folder / "copy"
for document in documents:
    (copy / document.parent).mkdir(parents=True, exist_ok=True)
    shutil.copyfile(project / document, copy / document)
for name in ("app", "data", "filters", "shaders", "tests"):
    shutil.copytree(project / name, copy / name, dirs_exist_ok=True, ignore=shutil.ignore_patterns("corpus", "regressions"))
for name in ("CHANGELOG.md", "LICENSE"):
    shutil.copyfile(project / name, copy / name)
intact = (project / "README.md").read_text()
before = {p: p.read_bytes() for p in site.rglob("*.html")}
for damage, said in (
    ("[a](app/REDME.md)", "README.md: app/REDME.md: there is no such file"),
    ("[a](app/README.md#the-widow)", "README.md: #the-widow: app/README.md has no such heading"),
    ("[a](../../etc/passwd)", "README.md: ../../etc/passwd: there is no such file"),
    ("![a](LICENSE)", "README.md: LICENSE: is no picture"),
    ("[a](javascript:alert)", "links out of the project begin with https:"),
):
    (copy / "README.md").write_text(f"{intact}\n{damage}\n")
    wrong = make(copy, site)
    if wrong.returncode != 1 or said not in wrong.stderr or "Traceback" in wrong.stderr:
        fail(f"{damage}: status {wrong.returncode}: {wrong.stderr}")
if before != {p: p.read_bytes() for p in site.rglob("*.html")}:
    fail("a site that could not be made replaced the one that was there")
kept = folder / "kept"
kept.mkdir()
(kept / "mine.txt").write_text("mine")
if make(project, kept).returncode != 1 or not (kept / "mine.txt").exists():
    fail("a folder of somebody's own was replaced")
# The check itself notices.
target = next(p for p in site.rglob("index.html") if p.parent.name == "technique")
target.unlink()
if not check(site)[0]:
    fail("a page that was taken away is not missed")
print(f"{len(documents)} documents, {len(reached)} files reached, {links} links and {anchors} anchors")
