"""Checks a page of a report: well-formed as XML and as HTML, self-contained, with alternatives for pictures.

usage: check_page.py FILE [--scripts]     --scripts: the page may have scripts, though none from elsewhere
"""

import re
import sys
import xml.etree.ElementTree as ElementTree
from html.parser import HTMLParser
from pathlib import Path

VOID = {"img", "meta"}


class Nesting(HTMLParser):
    """Fails if an element is closed in the wrong order or not at all."""

    def __init__(self):
        super().__init__()
        self.open = []

    def handle_starttag(self, tag, attributes):
        self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        assert tag in VOID or "svg" in self.open, f"<{tag}/>, which HTML does not close there"

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, f"</{tag}> in the wrong place"


def main():
    text = Path(sys.argv[1]).read_text(encoding="utf-8")
    page = ElementTree.fromstring(text.removeprefix("<!DOCTYPE html>\n"))
    nesting = Nesting()
    nesting.feed(text)
    nesting.close()
    assert not nesting.open, nesting.open

    assert page.get("lang") == "en"
    assert page.find("head/title").text
    assert page.find("head/meta[@name='viewport']") is not None
    forbidden = {"link", "iframe"} | (set() if "--scripts" in sys.argv else {"script"})
    for element in page.iter():
        tag = element.tag.rpartition("}")[2]
        assert tag not in forbidden, tag
        for name, value in element.attrib.items():
            assert not name.startswith("on"), name
            if name in {"href", "src"}:
                assert value.startswith(("#", "data:image/png;base64,")), value
        if tag == "img":
            assert element.get("alt")
        if tag == "svg":
            assert element.get("aria-label") or element.get("aria-hidden") == "true"
    assert not re.search(r"url\(|@import|nan|inf\b", page.find("head/style").text)
    for attribute in re.findall(r' (?:d|x|y|width|height|transform)="([^"]*)"', text):
        assert not re.search(r"nan|inf", attribute), attribute


main()
