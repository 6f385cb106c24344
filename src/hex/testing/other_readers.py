"""Reads and writes hexes with the Python packages of others, for other-readers.test.ts: JSON on stdin and stdout."""
import json
import sys

import micropython_microbit_fs as fs

try:
    from uflash import lib as uflash
except ImportError:
    uflash = None

MAIN = "print('grün')\n" * 20
FILES = [fs.File.from_text("main.py", MAIN), fs.File.from_text("way.py", "x = 1\n" * 100)]


def read(text):
    return {file.name: file.content.decode() for file in fs.get_files(text)}


asked = json.load(sys.stdin)
answer = {"read": {name: read(text) for name, text in asked.items()}, "written": {}, "firmware": {}}
for device in (1, 2):
    bare = fs.get_bundled_hex(device_version=device).content
    answer["firmware"]["v%d" % device] = bare
    answer["written"]["v%d" % device] = fs.add_files(bare, FILES)
if uflash is not None:
    from importlib import resources

    for found in resources.files("uflash").rglob("*.hex"):
        text = found.read_text()
        if text.startswith(":020000040000FA\n:0400000A"):
            answer["written"]["universal"] = uflash.embed_fs_uhex(text, MAIN.encode())
json.dump(answer, sys.stdout)
