#!/usr/bin/env python3
"""Files of tests that are compiled together: batch_tests.py ROOT OUT SIZE FILE...

Most of what a file of tests costs to compile is the reading of headers and the making of the same templates. Writes
OUT_0.cpp, OUT_1.cpp, ..., each of which includes at most SIZE of the FILEs (paths from ROOT), and prints their names
with ; between them.

Names at the outermost level of a file of tests are its own (they stand in a namespace without a name). Where two files
of a batch define the same one, the later file sees it under another name while it is read, by a macro; all headers are
read before. What cannot be renamed so (suites of tests, whose names are printed; a name that members have too) parts
the files. What comes out depends on the files alone.
"""
import pathlib
import re
import sys

COMMENTS_AND_TEXTS = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
# What a line at the outermost level defines: the word before a bracket, a value, an end.
DEFINED = re.compile(r'([A-Za-z_]\w*)\s*(?:\[[^\]]*\]\s*)*(?:[({;=]|:(?!:)|$)')
OF_MACROS = re.compile(r'([A-Z][A-Z0-9_]+)\(([^,()]*)(?:,\s*([^,()]*))?')
MEMBERS = re.compile(r'(?:\.|->|::)\s*([A-Za-z_]\w*)')
# The same in each file that has it.
SHORT_NAME = re.compile(r'using (?:\w+ = )?(?:::)?(?:\w+::)+\w+;|namespace\b')
INCLUDE = re.compile(r'#include (?:"([^"]+)"|(<[^>]+>))')
NO_NAMES = {'namespace', 'tetfarm', 'public', 'private', 'operator', 'std', 'void', 'bool', 'char', 'int', 'float',
            'double', 'auto'}


class TestFile:
    def __init__(self, root, path):
        text = (root / path).read_text(encoding='utf-8')
        bare = COMMENTS_AND_TEXTS.sub('""', text)
        self.path = path
        self.headers = self.headers_of(root, text)
        self.names = set()
        self.fixed = set()
        self.suites = set()  # files may share them
        for line in bare.splitlines():
            self.see(line)
        self.fixed |= self.names & set(MEMBERS.findall(bare))
        self.aliases = set(re.findall(r'^using (?:\w+::)*([a-z]\w*)(?: =|;)', bare, re.MULTILINE))
        self.words = set(re.findall(r'[A-Za-z_]\w*', bare))

    def headers_of(self, root, text):
        headers = []
        depth = 0
        for line in text.splitlines():
            if line.startswith('#if'):
                depth += 1
            elif line.startswith('#endif'):
                depth -= 1
            found = INCLUDE.match(line)
            if not found or depth > 0:
                continue
            quoted, angled = found.groups()
            beside = pathlib.PurePath(self.path).parent / (quoted or '')
            if quoted and (root / beside).exists():
                quoted = str(beside)
            headers.append(f'"{quoted}"' if quoted else angled)
        return headers

    def see(self, line):
        macro = OF_MACROS.match(line)
        if macro and macro.group(1).startswith(('TEST', 'TYPED_TEST')):
            self.fixed.add(f'{macro.group(2).strip()}_{(macro.group(3) or "").strip()}')
            self.suites.add(macro.group(2).strip())
        elif macro:
            self.fixed.update(word.strip() for word in macro.groups()[1:] if word)
        elif line.startswith('#define'):
            self.fixed.add(re.split(r'\W', line.split()[1])[0])
        elif line and (line[0].isalpha() or line[0] == '_') and not SHORT_NAME.match(line):
            self.names.update([name for name in DEFINED.findall(line) if name not in NO_NAMES][:1])


class Batch:
    def __init__(self):
        self.files = []
        self.names = set()
        self.fixed = set()
        self.suites = set()

    def has_room_for(self, file, size):
        return (len(self.files) < size and not file.fixed & (self.names | self.fixed)
                and not self.fixed & file.names
                and not file.suites & self.names and not self.suites & file.names)

    def add(self, file):
        self.files.append((file, sorted(file.names & self.names)))
        self.names |= file.names
        self.fixed |= file.fixed
        self.suites |= file.suites

    def has_shadows(self):
        """Whether a file may have a variable that is called like something of another file."""
        return any((a.names | a.aliases) & b.words for a, _ in self.files for b, _ in self.files if a is not b)

    def text(self):
        lines = []
        for header in dict.fromkeys(h for file, _ in self.files for h in file.headers):
            lines.append(f'#include {header}')
        if self.has_shadows():
            lines.append('#pragma GCC diagnostic ignored "-Wshadow"')
        for number, (file, renamed) in enumerate(self.files):
            lines += [f'#define {name} {name}_{number}' for name in renamed]
            lines.append(f'#include "{file.path}"')
            lines += [f'#undef {name}' for name in renamed]
        return '\n'.join(lines) + '\n'


def batches_of(files, size):
    batches = []
    for file in files:
        for batch in batches:
            if batch.has_room_for(file, size):
                break
        else:
            batch = Batch()
            batches.append(batch)
        batch.add(file)
    return batches


def main():
    root, out, size = pathlib.Path(sys.argv[1]), sys.argv[2], int(sys.argv[3])
    files = [TestFile(root, path) for path in sys.argv[4:]]
    names = []
    for number, batch in enumerate(batches_of(files, size)):
        path = pathlib.Path(f'{out}_{number}.cpp')
        if not path.exists() or path.read_text(encoding='utf-8') != batch.text():
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(batch.text(), encoding='utf-8')
        names.append(str(path))
    print(';'.join(names), end='')


if __name__ == '__main__':
    main()
