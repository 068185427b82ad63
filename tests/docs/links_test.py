#!/usr/bin/env python3
"""No link of a document leads nowhere, and every page below docs/ can be reached from docs/README.md."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINK = re.compile(r'\[[^\]]*\]\(([^)#\s]+)(?:#[^)]*)?\)')


def links(page):
    """The files that a page links to; text in fences and code is no link."""
    text = re.sub(r'^```.*?^```$|`[^`\n]*`', '', page.read_text(encoding='utf-8'), flags=re.M | re.S)
    return [(page.parent / target).resolve() for target in LINK.findall(text) if '://' not in target]


def main():
    pages = [p for p in ROOT.rglob('*.md') if 'build' not in p.relative_to(ROOT).parts]
    wrong = [f'{page.relative_to(ROOT)} links to {target}, which does not exist'
             for page in pages for target in links(page) if not target.exists()]
    reached, waiting = set(), [ROOT / 'docs' / 'README.md']
    while waiting:
        page = waiting.pop()
        if page in reached or page.suffix != '.md' or not page.exists():
            continue
        reached.add(page)
        waiting += links(page)
    wrong += [f'{page.relative_to(ROOT)} cannot be reached from docs/README.md'
              for page in pages if page.is_relative_to(ROOT / 'docs') and page not in reached]
    print(*wrong, sep='\n')
    sys.exit(1 if wrong or not reached else 0)


if __name__ == '__main__':
    main()
