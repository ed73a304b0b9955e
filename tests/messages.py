#!/usr/bin/env python3
"""messages.py ROOT [--write]: compares the error messages of the C++ sources with tests/messages.txt, where they can be
reviewed in the form that a user reads. `--write` renews the file.

Every construction of InputError, of a class derived from it, and InputError::problem is one line, as it would be
printed, below the path of its file. Literals are copied, and other expressions are shown as `<expression>`. Constants
and local variables that hold a string are replaced by the string. Both sides of a choice `a ? b : c` have separate
lines. Functions that receive the text as an argument, such as YamlNode::fail, have a line for each call, below the path
of the caller.
"""
import bisect
import difflib
import itertools
import re
import sys
from pathlib import Path

FOLDERS = ['app', 'calibration', 'deflection', 'planner', 'studies', 'tubesheets']
FEWEST = 400  # fewer messages mean that the form of errors in the sources has changed
LONGEST = 48  # characters; longer expressions are cut
MOST_CHOICES = 8  # lines of one message; beyond this number only the last side of the longest choice is shown
DEEPEST = 6  # levels of nested names and calls

STRING = r'R"(?P<raw>\w*)\(.*?\)(?P=raw)"|"(?:\\.|[^"\\])*"|(?<!\w)\'(?:\\.|[^\'\\])\''
COMMENT = re.compile(r'(?P<comment>//[^\n]*|/\*.*?\*/)|' + STRING, re.DOTALL)
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
BRACKET = re.compile(STRING + r'|[()\[\]{}]', re.DOTALL)
LITERAL = re.compile(r'R"(\w*)\((.*?)\)\1"|"((?:\\.|[^"\\])*)"', re.DOTALL)
LITERALS = re.compile(r'(?:R"(\w*)\(.*?\)\1"\s*|"(?:\\.|[^"\\])*"\s*)+', re.DOTALL)
NAME = re.compile(r'[A-Za-z_]\w*')
FIELD = re.compile(r'\{\{|\}\}|\{(\d*)(?::(?:[^{}]|\{\d*\})*)?\}')
ESCAPE = re.compile(r'\\(.)', re.DOTALL)
CONSTANT = re.compile(r'\b(?:char\s*\*\s*(?:const\s+)?|std::string(?:_view)?\s+|char\s+)(k[A-Z]\w*)(?:\[\])?\s*(=|\{)')
# Patterns of a parameter with its type, which no expression matches, and of a parameter that holds a string.
PARAMETER = re.compile(r'(?:const )?[\w:]+(?:<.*>)?(?: ?[&*]+ ?| )(\w+)(?: = .*)?', re.DOTALL)
OF_TEXT = re.compile(r'(?:const )?(?:std::string(?:_view)?|char) ?[&*]* ?(\w+)(?: = .*)?')
STATEMENTS = {'if', 'for', 'while', 'switch', 'catch', 'return'}
OPENING, CLOSING = '([{', ')]}'
# Calls that print as their argument does, with the characters that they add around it.
TRANSPARENT = {'std::string': '{}', 'std::string_view': '{}', 'std::move': '{}', 'fmt::runtime': '{}', 'fmt::join': '{}',
               'std::to_string': '{}', 'nameInLine': '{}', 'inQuotes': "'{}'"}


def end_of(text, start):
    """Returns the index after the bracket that closes the bracket at `start`."""
    depth = 0
    for token in BRACKET.finditer(text, start):
        depth += (token[0] in OPENING) - (token[0] in CLOSING)
        if depth == 0:
            return token.end()
    raise ValueError('a bracket is not closed: ' + text[start:start + 80])


def split(text, marks):
    """Splits a text at `marks` outside brackets and literals into pairs (mark before, part); `++` does not count as `+`."""
    depth, begin, mark, parts = 0, 0, '', []
    for token in re.finditer(f'{STRING}|::|\\+\\+|[()\\[\\]{{}}{marks}]', text, re.DOTALL):
        sign = token[0]
        depth += (sign in OPENING) - (sign in CLOSING)
        if depth == 0 and sign in marks:
            parts.append((mark, text[begin:token.start()].strip()))
            mark, begin = sign, token.end()
    parts.append((mark, text[begin:].strip()))
    return parts


def arguments(text, opening):
    """Returns the arguments between the bracket at `opening` and its closing bracket."""
    inside = text[opening + 1:end_of(text, opening) - 1]
    return [part for _, part in split(inside, ',')] if inside.strip() else []


def literal(text):
    return ''.join(raw or ESCAPE.sub(lambda found: ' ' if found[1] in 'nrt' else found[1], plain)
                   for _, raw, plain in LITERAL.findall(text))


def sides_of(text):
    """Returns the sides of `a ? b : c`; None for another expression."""
    parts, depth = split(text, '?:'), 0
    for k, (mark, _) in enumerate(parts):
        depth += (mark == '?') - (mark == ':')
        if mark == ':' and depth == 0:
            return [''.join(f' {mark} {part}' for mark, part in side)[3:] for side in (parts[1:k], parts[k:])]
    return None


def call_of(text):
    """Returns the name and arguments of an expression that is a single call; None for another expression."""
    found = re.match(r'([A-Za-z_][\w:]*)\s*\(', text)
    whole = found and end_of(text, found.end() - 1) == len(text)
    return (found[1], arguments(text, found.end() - 1)) if whole else None


def sample(text):
    """Returns an expression on one line, without casts and conversions."""
    text = re.sub(r'static_cast<[\w: ]+>', '', re.sub(r'\s+', ' ', text))
    text = re.sub(r'\.(string|c_str|str)\(\)|\bstd::|\bfmt::|^\*', '', text)
    text = re.sub(r'^\((\w+)\)$', r'\1', text)
    return f'<{text[:LONGEST].rstrip() + "..." if len(text) > LONGEST else text}>'


def is_sample(text):
    return text.startswith('<') and text.endswith('>') and text.count('<') == 1


def constants_of(text):
    """Returns the string constants, keyed by name."""
    return {found[1]: split(text[found.end():end_of(text, found.end() - 1) - 1], ';')[0][1] if found[2] == '{'
            else split(text[found.end():found.end() + 4000], ';')[0][1] for found in CONSTANT.finditer(text)}


class Function:
    """A function: its name, its parameters as declared, and its file."""

    def __init__(self, name, parameters, path):
        found = [PARAMETER.fullmatch(parameter) for parameter in parameters]
        self.name, self.path = name, path
        self.parameters = [parameter[1] if parameter else '' for parameter in found]
        self.texts = [text[1] for text in map(OF_TEXT.fullmatch, parameters) if text]
        self.fewest = sum(' = ' not in parameter for parameter in parameters)

    def takes(self, count):
        return self.fewest <= count <= len(self.parameters)


class Source:
    """A source file without comments."""

    def __init__(self, path):
        self.path = path
        self.text = COMMENT.sub(lambda token: ' ' if token['comment'] else token[0], path.read_text())
        self.constants = constants_of(self.text)
        self.included = INCLUDE.findall(self.text)
        self.blocks = None

    def functions_at(self, place):
        """Returns the function around a place, and named lambdas around the place, innermost first."""
        if self.blocks is None:
            self.blocks, opened, partner = [], [], {}
            for token in BRACKET.finditer(self.text):
                if token[0] in OPENING:
                    opened.append(token.start())
                elif token[0] in CLOSING and opened:
                    partner[token.start()] = opened.pop()
            for end, start in partner.items():
                if self.text[start] == '{' and (function := self.function_before(start, partner)):
                    self.blocks.append((start, end, function))
        return [function for start, end, function in sorted(self.blocks, reverse=True) if start < place < end]

    def function_before(self, brace, partner):
        """Returns the function whose body begins at a brace; None for another block."""
        head = re.sub(r'\s*(const|noexcept|override|mutable|-> ?[\w:<>&]+)?\s*$', '', self.text[:brace][-400:])
        end = brace - len(self.text[:brace][-400:]) + len(head) - 1
        if not head.endswith(')') or end not in partner:
            return None
        before = self.text[:partner[end]].rstrip()
        found = re.search(r'(\w+)$', before) or re.search(r'\bauto (\w+) = \[[^\[\]]*\]$', before)
        if not found or found[1] in STATEMENTS:
            return None
        return Function(found[1], arguments(self.text, partner[end]), self.path)

    def value_of(self, name, place, constants):
        """Returns the value of a constant or local variable, as an expression, at a place; None if the value is unknown."""
        if re.match(r'k[A-Z]', name):
            return self.constants.get(name, constants.get(name))
        function = max(self.text.rfind('\n}', 0, place), 0)
        declared = re.compile(r'\b(?:std::string|std::string_view|auto|char\s*\*)\s+(?:const\s+)?' + name + r'\s*([=(])')
        found = list(declared.finditer(self.text, function, place))
        if not found:
            return None
        if found[-1][1] == '(':
            return ', '.join(arguments(self.text, found[-1].end() - 1))
        return split(self.text[found[-1].end():place], ';')[0][1]


class Error:
    """An error: its parts, as written at the innermost of its places. Each further place calls the function around the
    previous place; `bindings` maps the parameters of that function to the arguments."""

    def __init__(self, parts, is_sentence, places, bindings):
        self.parts, self.is_sentence, self.places, self.bindings = parts, is_sentence, places, bindings

    def origin_of(self, expression, level=0):
        """Returns the outermost expression that an expression stands for if bindings alone replace it; otherwise None."""
        if level == len(self.bindings):
            return expression
        bound = self.bindings[level].get(expression)
        return None if bound is None else self.origin_of(bound, level + 1)


class Sources:
    def __init__(self, root):
        self.root = root
        paths = sorted(path for folder in FOLDERS for path in (root / folder).rglob('*')
                       if path.suffix in ('.cpp', '.hpp') and 'node_modules' not in path.parts)
        self.all = {path: Source(path) for path in paths}
        self.constants, self.classes, self.declared, self.closures = {}, ['InputError'], {}, {}
        for path, source in self.all.items():
            self.classes += re.findall(r'class (\w+) (?:final )?: public (?:\w+::)*InputError\b', source.text)
            if path.suffix == '.hpp':
                self.constants |= source.constants

    def included_by(self, path):
        """Returns a file and all files that it includes directly or indirectly."""
        if path not in self.closures:
            self.closures[path] = found = {path}
            for name in self.all[path].included if path in self.all else []:
                found |= self.included_by(self.root / name)
        return self.closures[path]

    def declarations(self, name):
        """Returns the functions of a name: the declaration in a header, or the definition if no header declares it."""
        if name not in self.declared:
            of_name = re.compile(rf'\b(?:auto {name} = \[[^\[\]]*\]|{name})\s*\(')
            found = [Function(name, parameters, path)
                     for path, source in self.all.items() if name in source.text
                     for match in of_name.finditer(source.text)
                     if (parameters := arguments(source.text, match.end() - 1))
                     and all(map(PARAMETER.fullmatch, parameters))]
            headers = {(function.path.stem, *function.parameters) for function in found if function.path.suffix == '.hpp'}
            self.declared[name] = [function for function in found if function.path.suffix == '.hpp'
                                   or (function.path.stem, *function.parameters) not in headers]
        return self.declared[name]

    def is_meant(self, function, path, count):
        """Returns True if a call of the function's name in a file means this function: the nearest one visible in the file."""
        known = self.included_by(path)
        able = [other for other in self.declarations(function.name)
                if other.takes(count) and (other.path == path or other.path.suffix == '.hpp' and other.path in known)]
        def distance(other):
            return 0 if other.path.stem == path.stem else 1 if other.path.parent == path.parent else 2
        nearest = min(map(distance, able), default=0)
        return any(other.parameters == function.parameters and other.path.stem == function.path.stem
                   for other in able if distance(other) == nearest)

    def constructions(self, source):
        names = '|'.join(self.classes)
        for found in re.finditer(rf'(?<!class )(?<!::)\b({names})(::problem)?(?: [a-z_]+)?\s*[({{]', source.text):
            given = arguments(source.text, found.end() - 1)
            if len(given) > 1 and not all(map(PARAMETER.fullmatch, given)):
                yield Error(given, bool(found[2]), [(source, found.start())], [])
        # Functions that return an error as a braced list of its parts.
        for found in re.finditer(rf'^({names}) \w+\(', source.text, re.MULTILINE):
            end = end_of(source.text, found.end() - 1)
            if body := re.compile(r'\s*\{').match(source.text, end):
                for returned in re.compile(r'\breturn \{').finditer(source.text, end, end_of(source.text, body.end() - 1)):
                    given = arguments(source.text, returned.end() - 1)
                    yield Error(given, False, [(source, returned.start())], [])

    def calls(self, error):
        """Returns an error per call of the function around an error if the text is a parameter of it; else the error."""
        source, place = error.places[-1]
        origins = {error.origin_of(part) for part in error.parts[1:]}
        for function in source.functions_at(place):
            if not origins.intersection(function.texts) or len(error.places) > DEEPEST:
                continue
            found = []
            for path, caller in self.all.items():
                if function.name not in caller.text:
                    continue
                for match in re.finditer(r'(?<!::)\b' + function.name + r'\s*\(', caller.text):
                    given = arguments(caller.text, match.end() - 1)
                    is_declared = all(map(PARAMETER.fullmatch, given))
                    if is_declared or not self.is_meant(function, path, len(given)):
                        continue
                    bound = dict(itertools.zip_longest(function.parameters, given, fillvalue='""'))
                    found += self.calls(Error(error.parts, error.is_sentence, [*error.places, (caller, match.start())],
                                              [*error.bindings, bound]))
            if found:
                return found
        return [error]

    def words(self, error, expression, level=0, depth=0):
        """Returns the possible texts of an expression at one of the places of an error."""
        text, shown = expression.strip(), [sample(expression.strip())]
        if LITERALS.fullmatch(text):
            return [literal(text)]
        if depth > DEEPEST:
            return shown
        source, place = error.places[level]
        def inner(part, to=level):
            return self.words(error, part, to, depth + 1)
        if sides := sides_of(text):
            texts = [text for side in sides for text in inner(side)]
            if all(len(text) < 5 for text in texts):
                return texts[-1:]  # for example the ending of a plural
            return shown if all(map(is_sample, texts)) else texts
        if text.startswith('(') and end_of(text, 0) == len(text):
            return inner(text[1:-1])
        if len(parts := split(text, '+')) > 1:
            texts = [inner(part) for _, part in parts]
            if all(is_sample(text) for part in texts for text in part):
                return shown
            return [''.join(chosen) for chosen in itertools.product(*texts)]
        if called := call_of(text):
            name, given = called
            if name == 'fmt::format':
                return self.formatted(inner(given[0]), [inner(part) for part in given[1:]])
            if name == 'suggestionOr':
                return [sample(f'suggestion({given[0]}, {given[1]})')] + inner(given[2])
            if name in TRANSPARENT:
                return [TRANSPARENT[name].format(text) for text in (inner(given[0]) if given else [''])]
        if NAME.fullmatch(text):
            if level < len(error.bindings) and text in error.bindings[level]:
                return inner(error.bindings[level][text], level + 1)
            value = source.value_of(text, place, self.constants)
            texts = inner(value) if value is not None else shown
            return shown if any(map(is_sample, texts)) else texts
        return shown

    def formatted(self, forms, samples):
        """Returns the possible results of fmt::format."""
        texts = []
        for form, *chosen in itertools.product(forms, *samples):
            following = itertools.count()
            def fill(field):
                if field[0] in ('{{', '}}'):
                    return field[0][0]
                place = int(field[1]) if field[1] else next(following)
                return chosen[place] if place < len(chosen) else field[0]
            texts.append(FIELD.sub(fill, form))
        return texts

    def messages(self, error):
        """Yields the lines of an error as InputError prints them."""
        texts = [self.words(error, part) for part in error.parts]
        while len(list(itertools.product(*texts))) > MOST_CHOICES:
            longest = max(texts, key=len)
            longest[:] = longest[-1:]
        for where, found, *rest in itertools.product(*texts):
            expected = '' if error.is_sentence or not rest else rest.pop(0)
            core = f'{where}: found {found}, expected {expected}' if expected else f'{where}: {found}'
            yield '; '.join(part for part in (core, *rest) if part)

    def listing(self):
        """Returns the lines of tests/messages.txt and the number of messages."""
        of_files, count = {}, 0
        for source in self.all.values():
            for made in self.constructions(source):
                for error in self.calls(made):
                    caller, place = error.places[-1]
                    bisect.insort(of_files.setdefault(caller.path, []), (place, list(self.messages(error))))
                    count += 1
        lines = []
        for path in sorted(of_files):
            messages = [line for _, of_error in of_files[path] for line in of_error]
            lines += ['', str(path.relative_to(self.root)), *('  ' + line for line in dict.fromkeys(messages))]
        return lines[1:], count


root = Path(next((word for word in sys.argv[1:] if not word.startswith('-')), '.'))
file = root / 'tests/messages.txt'
lines, count = Sources(root).listing()
if count < FEWEST:
    sys.exit(f'only {count} errors were found in the sources: is their form another one now?')
if '--write' in sys.argv:
    file.write_text('\n'.join(lines) + '\n')
reviewed = file.read_text().splitlines() if file.exists() else []
changes = list(difflib.unified_diff(reviewed, lines, 'tests/messages.txt', 'the sources', lineterm='', n=1))
print('\n'.join(changes) or f'{count} errors, as tests/messages.txt has them')
if changes:
    sys.exit(f'read the changed messages, then renew the file: python3 tests/messages.py {root} --write')
