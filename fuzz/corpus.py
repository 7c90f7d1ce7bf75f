#!/usr/bin/env python3
"""Unpacks the inputs kept for a fuzz target into a folder, for cargo-fuzz, and packs such a folder again.

    fuzz/corpus.py unpack TARGET     fuzz/corpus/TARGET.pack to the folder fuzz/corpus/TARGET
    fuzz/corpus.py pack TARGET       the folder to the pack

A pack is one record after another: the length of the input in four bytes, lowest byte first, and the input. Short inputs
come first, so the same inputs always make the same pack. Unpacked files are named by the number of their record.
"""

import sys
from pathlib import Path


def unpack(pack, folder):
    folder.mkdir(exist_ok=True)
    data = pack.read_bytes()
    number = 0
    while data:
        end = 4 + int.from_bytes(data[:4], "little")
        (folder / f"{number:05}").write_bytes(data[4:end])
        data = data[end:]
        number += 1
    print(f"{number} inputs in {folder}")


def pack(pack, folder):
    inputs = {file.read_bytes() for file in folder.iterdir()}
    records = sorted(inputs, key=lambda data: (len(data), data))
    pack.write_bytes(b"".join(len(data).to_bytes(4, "little") + data for data in records))
    print(f"{len(records)} inputs in {pack}")


if len(sys.argv) != 3 or sys.argv[1] not in ("pack", "unpack"):
    sys.exit(__doc__)
corpus = Path(__file__).parent / "corpus"
globals()[sys.argv[1]](corpus / f"{sys.argv[2]}.pack", corpus / sys.argv[2])
