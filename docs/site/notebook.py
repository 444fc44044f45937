"""Notebooks as pages: cells with their stored outputs, turned into the Markdown of the other pages."""
import json

from myst_parser.parsers.sphinx_ import MystParser


def fenced(text, language):
    """A block of code, behind a fence that does not occur in it."""
    fence = "```"
    while fence in text:
        fence += "`"
    return f"{fence}{language}\n{text.rstrip()}\n{fence}"


def shown(output):
    """What a cell printed, ended with or drew."""
    data = output.get("data", {})
    if "image/png" in data:
        return f"![](data:image/png;base64,{''.join(data['image/png']).replace(chr(10), '')})"
    return fenced("".join(output.get("text") or data.get("text/plain", "")), "text")


def markdown_of(notebook):
    blocks = []
    for cell in notebook["cells"]:
        source = "".join(cell["source"])
        blocks.append(fenced(source, "python") if cell["cell_type"] == "code" else source)
        blocks += [shown(output) for output in cell.get("outputs", [])]
    return "\n\n".join(blocks) + "\n"


class NotebookParser(MystParser):
    supported = ("notebook",)

    def parse(self, inputstring, document):
        super().parse(markdown_of(json.loads(inputstring)), document)
