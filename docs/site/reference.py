"""The reference of the libraries' headers as Markdown pages, one for each folder, from Doxygen's XML (docs/Doxyfile)."""
import pathlib
import re
import subprocess
import tempfile
import xml.etree.ElementTree as xml

FOLDERS = ["tubesheets", "deflection", "calibration", "planner"]


def text_of(node):
    """The text of a description; code in backticks, all other signs of Markdown escaped."""
    if node is None:
        return ""
    parts = [escaped(node.text or "")]
    for child in node:
        parts.append(f"`{''.join(child.itertext())}`" if child.tag == "computeroutput" else text_of(child))
        parts.append(escaped(child.tail or ""))
    return " ".join("".join(parts).split())


def escaped(text):
    return re.sub(r"([\\`*_{}\[\]<>#|$~])", r"\\\1", text)


def comment_of(node):
    return " ".join(filter(None, (text_of(node.find(part)) for part in ("briefdescription", "detaileddescription", "inbodydescription"))))


def declaration_of(member, owner):
    kind, name, arguments = member.get("kind"), owner + member.findtext("name"), member.findtext("argsstring") or ""
    if kind == "enum":
        return f"enum class {name} {{{', '.join(value.findtext('name') for value in member.findall('enumvalue'))}}}"
    type_of = "".join(member.find("type").itertext()) if member.find("type") is not None else ""
    return " ".join(re.sub(r"< | >", lambda sign: sign[0].strip(), f"{type_of} {name}{arguments}").split())


def entries_of(compound):
    """What a namespace or class declares in headers and has a comment: (file, line, declaration, comment)."""
    is_class = compound.get("kind") != "namespace"
    name = compound.findtext("compoundname").split("::")[-1]
    if is_class and comment_of(compound):
        place = compound.find("location")
        yield place.get("file"), int(place.get("line")), f"{compound.get('kind')} {name}", comment_of(compound)
    for member in compound.iter("memberdef"):
        place = member.find("location")
        if member.get("prot") == "public" and place is not None and comment_of(member):
            declaration = declaration_of(member, f"{name}::" if is_class else "")
            yield place.get("file"), int(place.get("line")), declaration, comment_of(member)


def reference_pages(source):
    """Returns pages, keyed by name, that list the declarations in the headers of each folder."""
    by_file = {}
    with tempfile.TemporaryDirectory() as folder:
        settings = (source / "docs/Doxyfile").read_text() + f"\nOUTPUT_DIRECTORY = {folder}\n"
        subprocess.run(["doxygen", "-"], input=settings, cwd=source, check=True, text=True)
        for path in pathlib.Path(folder, "xml").glob("*.xml"):
            for compound in xml.parse(path).getroot().iter("compounddef"):
                if compound.get("kind") in ("namespace", "struct", "class"):
                    for file, *entry in entries_of(compound):
                        by_file.setdefault(file, set()).add(tuple(entry))
    pages = {}
    for folder in FOLDERS:
        parts = [f"# Headers of {folder}\n"]
        for file in sorted(file for file in by_file if file.startswith(f"{folder}/")):
            parts.append(f"## {file}\n")
            parts += [f"```cpp\n{declaration}\n```\n{comment}\n" for _, declaration, comment in sorted(by_file[file])]
        pages[f"headers_{folder}"] = "\n".join(parts)
    return pages
