"""Checks the links of the guide, as a book and as files of the repository.

    links.py BOOK

In: the folder that mdbook has written, two folders below the root as `guide/src` is. Out: the same book, whose links to
pages outside of it end in `.md` again; an error with every link whose file or anchor does not exist.
"""

import pathlib
import re
import sys
from html.parser import HTMLParser
from urllib.parse import unquote

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Pages outside of the book that are read as files.
PAGES = ["*.md", "*/README.md", "examples/*/README.md", "report/**/*.md", "macros/src/*.md"]
# Pages of mdbook's own, which repeat the others.
REPEATED = {"print.html", "404.html", "toc.html", "index.html"}


class Page(HTMLParser):
    """Links and anchors of a page of the book."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key == "id":
                self.anchors.add(value)
            elif key in ("href", "src") and tag in ("a", "img"):
                self.links.append(value or "")


def without_code(text):
    return re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)


def anchors(path):
    """Anchors of a file in Markdown, as web sites make them of its headings."""
    found = set()
    for heading in re.findall(r"^#+ (.*)$", without_code(path.read_text()), re.M):
        slug = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        found.add(slug)
    return found


def fault(folder, link, pages):
    """Why a link leads nowhere; nothing if it leads somewhere."""
    if "://" in link or link.startswith("mailto:"):
        return None
    path, _, anchor = unquote(link).partition("#")
    target = (folder / path).resolve()
    if not target.exists():
        return "no such file"
    if not anchor:
        return None
    if target in pages:
        known = pages[target].anchors
    elif target.suffix == ".md":
        known = anchors(target)
    else:
        return "an anchor in a file that has none"
    return None if anchor in known else "no such anchor"


def main():
    book = pathlib.Path(sys.argv[1]).resolve()
    pages = {}
    for path in sorted(book.rglob("*.html")):
        text = path.read_text()
        # mdbook turns every link to a page in Markdown into one to HTML; outside of the book there is none.
        text = re.sub(r'(href="(?:\.\./){2}[^"#]*)\.html', r"\1.md", text)
        path.write_text(text)
        if path.name not in REPEATED:
            pages[path] = Page(text)
    links = [(path, link or path.name) for path, page in pages.items() for link in page.links]
    links = [(path, path.name + link if link.startswith("#") else link) for path, link in links]
    others = sorted({path for pattern in PAGES for path in ROOT.glob(pattern)})
    for path in others:
        for link in re.findall(r"\]\(([^)\s]+)\)", without_code(path.read_text())):
            # Pages of rustdoc, which are not made here.
            if ".html" not in link:
                links.append((path, path.name + link if link.startswith("#") else link))
    faults = [f"{path}: {link}: {why}" for path, link in links if (why := fault(path.parent, link, pages))]
    if not pages or faults:
        sys.exit("\n".join(faults or [f"{book} has no pages"]))
    print(f"{len(links)} links of {len(pages)} pages of the book and {len(others)} others lead somewhere")


main()
