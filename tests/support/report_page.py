"""What a page of `morphe report` holds, read by its contract (pipeline/report/page/README.md)."""
import base64
import json
import re
import zlib

import numpy as np

SCRIPT = re.compile(r'<script type="([^"]*)" id="([^"]*)">(.*?)</script>', re.S)


class Page:
    def __init__(self, path):
        scripts = {name: text for _, name, text in SCRIPT.findall(path.read_text(encoding="utf-8"))}
        self.report, self.rows = json.loads(scripts.pop("report")), json.loads(scripts.pop("rows"))
        self.blocks = scripts

    def plan(self, name, run=0):
        row = next(row for row in self.rows if (row["run"], row["plan"]) == (run, name))
        return self.block(row["block"])

    def block(self, name):
        data = zlib.decompress(base64.b64decode(self.blocks[name]))
        length = int.from_bytes(data[:4], "little")
        return with_tables(json.loads(data[4:4 + length]), data[4 + length:])


def with_tables(node, data):
    if isinstance(node, list):
        return [with_tables(each, data) for each in node]
    if not isinstance(node, dict):
        return node
    if "array" in node:
        return table(data, *node["array"], node["step"], node["offset"])
    return {key: with_tables(value, data) for key, value in node.items()}


def table(data, rows, columns, step, at):
    codes = []
    while len(codes) < rows * columns:
        code, shift = 0, 0
        while True:
            byte = data[at]
            at += 1
            code |= (byte & 127) << shift
            shift += 7
            if byte < 128:
                break
        codes.append(code)
    values = np.full((rows, columns), np.nan)
    for column in range(columns):
        before = last = 0
        for row, code in enumerate(codes[column * rows:(column + 1) * rows]):
            if code == 0:
                continue
            zigzag = code - 1
            second = zigzag // 2 if zigzag % 2 == 0 else -(zigzag + 1) // 2
            before, last = last, second + 2 * last - before
            values[row, column] = last * step
    return values
