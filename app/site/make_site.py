#!/usr/bin/env python3
"""The documents of the project as a static site: make_site.py OUT [--source DIR] [--lessons FILE]

Every README.md becomes a page, by cmark-gfm (GitHub's own library, so that tables and lists read as they do there), with
the headings' anchors, a list of all pages at the side, and links that lead to pages. A file of source text that a
document names becomes a page, too; pictures are copied. A link that leads nowhere is an error, and nothing is written
then. `--lessons` adds the page that `boxprobe lessons -o FILE` writes.
"""
import argparse
import html
import os
import re
import shutil
import subprocess
import sys
import tempfile
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# What a reader looks for first; documents that stand in none of them follow under "More".
GROUPS = [
    ("Tour", ["", "app"]),
    ("Lessons", ["data/lessons"]),
    ("Techniques", ["shaders/technique", "shaders", "tests/bench"]),
    ("Formats", ["data/scenes", "data/environments", "filters/io", "filters/io/engines"]),
    ("Library", ["filters", "filters/vtk", "app/install"]),
    ("Accuracy", ["tests", "tests/truth", "tests/vtk"]),
]
PICTURES = {".png", ".jpg", ".jpeg", ".svg", ".webp"}
KEPT_FOLDERS = ("build", "out")


class SiteError(Exception):
    """One line: file, place and what to do."""


def anchor_of(heading):
    """As GitHub turns a heading into an anchor."""
    kept = [c.lower() for c in heading.strip() if c.isalnum() or c in "-_ "]
    return "".join(kept).replace(" ", "-")


def find_documents(source):
    found = []
    for folder, folders, files in os.walk(source):
        at = Path(folder).relative_to(source)
        folders[:] = sorted(f for f in folders if not f.startswith(".") and not (at == Path() and f.startswith(KEPT_FOLDERS)))
        if "README.md" in files:
            found.append(at / "README.md")
    return found


def to_html(path):
    command = ["cmark-gfm", "--unsafe", "-e", "table", "-e", "autolink", "-e", "strikethrough", str(path)]
    try:
        return subprocess.run(command, check=True, capture_output=True).stdout.decode()
    except FileNotFoundError:
        raise SiteError("cmark-gfm is not installed: apt-get install cmark-gfm") from None
    except subprocess.CalledProcessError as failure:
        raise SiteError(f"{path}: cmark-gfm: {failure.stderr.decode().strip()}") from None


class Page(HTMLParser):
    """One document's HTML, its headings given anchors, its links passed through `link`."""

    VOID = {"img", "br", "hr", "input"}

    def __init__(self, text, link):
        super().__init__(convert_charrefs=False)
        self.link = link
        self.out = []
        self.anchors = []
        self.title = ""
        self.heading = None  # where its tag stands in `out`, and its text
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        if re.fullmatch("h[1-6]", tag):
            self.heading = (len(self.out), [])
        parts = [tag]
        for name, value in attributes:
            if name in ("href", "src"):
                value = self.link(value, name)
            parts.append(name if value is None else f'{name}="{html.escape(value)}"')
        self.out.append(f"<{' '.join(parts)}>")

    handle_startendtag = handle_starttag

    def handle_endtag(self, tag):
        if self.heading and re.fullmatch("h[1-6]", tag):
            at, text = self.heading
            anchor = anchor_of(html.unescape("".join(text)))
            if anchor in self.anchors:
                anchor += f"-{sum(a == anchor or a.startswith(anchor + '-') for a in self.anchors)}"
            self.anchors.append(anchor)
            self.title = self.title or html.unescape("".join(text))
            self.out[at] = f'<{tag} id="{html.escape(anchor)}">'
            self.heading = None
        if tag not in self.VOID:
            self.out.append(f"</{tag}>")

    def put(self, text):
        if self.heading:
            self.heading[1].append(text)
        self.out.append(text)

    def handle_data(self, data):
        self.put(data)

    def handle_entityref(self, name):
        self.put(f"&{name};")

    def handle_charref(self, name):
        self.put(f"&#{name};")

    def text(self):
        return "".join(self.out)


class Site:
    def __init__(self, source, lessons):
        self.source = source.resolve()
        self.lessons = lessons
        self.documents = find_documents(self.source)
        self.named = set()  # other files and folders that documents link to
        self.problems = []
        self.wanted = []  # (document, page, anchor)
        self.pages = {}
        for path in self.documents:
            self.pages[path] = Page(to_html(self.source / path), lambda target, kind, path=path: self.link(path, target, kind))
        for path, page, anchor in self.wanted:
            if anchor not in self.pages[page].anchors:
                self.problems.append(f"{path}: #{anchor}: {page} has no such heading")

    @staticmethod
    def page_of(path):
        """Where a document, a file or a folder of the project stands in the site."""
        if path.name == "README.md":
            return path.parent / "index.html"
        return path if path.suffix.lower() in PICTURES else Path(f"{path}.html")

    def link(self, path, target, kind):
        parts = urlsplit(target)
        if parts.scheme or parts.netloc:
            if parts.scheme not in ("https", "mailto"):
                self.problems.append(f"{path}: {target}: links out of the project begin with https:")
            return target
        file = path
        if parts.path:
            file = Path(os.path.normpath(path.parent / unquote(parts.path)))
        if file.parts[:1] == ("..",) or not (self.source / file).exists():
            self.problems.append(f"{path}: {target}: there is no such file")
            return target
        if (self.source / file / "README.md").exists():
            file = file / "README.md"
        if parts.fragment:
            if file.name != "README.md":
                self.problems.append(f"{path}: {target}: anchors lead into README.md files alone")
                return target
            self.wanted.append((path, file, unquote(parts.fragment)))
        if file.name != "README.md":
            if kind == "src" and file.suffix.lower() not in PICTURES:
                self.problems.append(f"{path}: {target}: is no picture")
            self.named.add(file)
        to = os.path.relpath(self.page_of(file), path.parent)
        return to + (f"#{parts.fragment}" if parts.fragment else "")

    def menu(self, page):
        here = page.parent
        grouped = [d for _, folders in GROUPS for d in folders]
        more = [str(p.parent) for p in self.documents if ("" if p.parent == Path() else str(p.parent)) not in grouped]
        lines = []
        for name, folders in GROUPS + [("More", more)]:
            links = []
            for folder in folders:
                document = Path(folder) / "README.md"
                if document not in self.pages:
                    raise SiteError(f"app/site/make_site.py: GROUPS names {document}, which is not there")
                current = ' aria-current="page"' if self.page_of(document) == page else ""
                to = os.path.relpath(self.page_of(document), here)
                links.append(f'<a href="{html.escape(to)}"{current}>{html.escape(self.pages[document].title)}</a>')
            if name == "Lessons" and self.lessons:
                links.append(f'<a href="{os.path.relpath("lessons.html", here)}">All lessons, alive</a>')
            lines.append(f"<h2>{name}</h2>" + "".join(f"<p>{link}</p>" for link in links))
        return "\n".join(lines)

    def whole(self, page, title, body):
        style = os.path.relpath("style.css", page.parent)
        first = os.path.relpath("index.html", page.parent)
        name = title if title == "Boxprobe" else f"{title} - Boxprobe"
        return (
            f'<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>{html.escape(name)}</title>\n'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
            f'<link rel="stylesheet" href="{style}">\n</head>\n<body>\n<nav>\n<p class="name"><a href="{first}">Boxprobe</a></p>\n'
            f"{self.menu(page)}\n</nav>\n<main>\n{body}\n</main>\n</body>\n</html>\n"
        )

    def named_page(self, file):
        """A file of text, or what is in a folder, as the project has it."""
        at = self.source / file
        if at.is_dir():
            page = self.page_of(file)
            rows = []
            for child in sorted(at.iterdir()):
                if child.is_file():
                    to = os.path.relpath(self.page_of(file / child.name), page.parent)
                    rows.append(f'<li><a href="{html.escape(to)}">{html.escape(child.name)}</a></li>')
            body = f"<h1>{html.escape(str(file))}</h1><ul>{''.join(rows)}</ul>"
        else:
            try:
                text = at.read_text()
            except UnicodeDecodeError:
                raise SiteError(f"{file}: is no text and no picture, and cannot be a page") from None
            body = f"<h1>{html.escape(str(file))}</h1><pre><code>{html.escape(text)}</code></pre>"
        return self.whole(self.page_of(file), str(file), body)

    def write(self, out):
        for folder in [f for f in self.named if (self.source / f).is_dir()]:
            self.named.update(folder / c.name for c in (self.source / folder).iterdir() if c.is_file())
        for path, page in self.pages.items():
            self.put(out / self.page_of(path), self.whole(self.page_of(path), page.title, page.text()))
        for file in self.named:
            to = out / self.page_of(file)
            if file.suffix.lower() in PICTURES:
                to.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(self.source / file, to)
            else:
                self.put(to, self.named_page(file))
        shutil.copyfile(Path(__file__).parent / "style.css", out / "style.css")
        if self.lessons:
            shutil.copyfile(self.lessons, out / "lessons.html")

    @staticmethod
    def put(path, text):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def main():
    parser = argparse.ArgumentParser(description="Writes the project's documents as a static site.")
    parser.add_argument("out", type=Path, help="folder of the site; what an earlier call wrote there is replaced")
    parser.add_argument("--source", type=Path, default=Path(__file__).resolve().parents[2], help="the project")
    parser.add_argument("--lessons", type=Path, help="page written by `boxprobe lessons -o FILE`")
    arguments = parser.parse_args()
    out = arguments.out.resolve()
    try:
        if arguments.lessons and not arguments.lessons.is_file():
            raise SiteError(f"{arguments.lessons}: there is no such file; `boxprobe lessons -o {arguments.lessons}` writes it")
        if out.exists() and any(out.iterdir()) and not (out / "style.css").exists():
            raise SiteError(f"{out}: holds other things than a site; name an empty folder or a new one")
        site = Site(arguments.source, arguments.lessons)
        if site.problems:
            raise SiteError("\n".join(site.problems))
        out.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=out.parent, prefix=f".{out.name}-") as made:
            made = Path(made) / "site"
            made.mkdir()
            site.write(made)
            if out.exists():
                shutil.rmtree(out)
            made.rename(out)
    except (SiteError, OSError) as failure:
        sys.exit("\n".join(f"make_site.py: {line}" for line in str(failure).splitlines()))
    print(f"{out}/index.html: {len(site.pages)} documents, {len(site.named)} other files")


if __name__ == "__main__":
    main()
