"""The pictures of the documents that show plans. Each carries the rows of `morphe list` for the plans that
it was drawn from, as text in its file, so that a test can tell whether they are the plans of today."""
import zlib

# picture: pipeline, the plans that it shows (as of `morphe list --only`), the address on the page
PICTURES = {
    "report_first_page": ("pa10_dlr_hit2_obstacle", "*", ""),
    "report_repaired": ("pa10_dlr_hit2_obstacle", "ADL001AR1/000", "#ADL001AR1/000/0.59"),
    "report_infeasible": ("fr3", "ADL006DR2/000", "#ADL006DR2/000"),
    "report_from_home": ("pa10_dlr_hit2_from_home", "ADL001DR2/000", "#ADL001DR2/000/-0.8"),
}
KEYWORD = b"Plans"
SIGNATURE_LENGTH = 8


def rows_of_list(printed):
    """Of what `morphe list` prints, the table: a line for each plan with its figures, and the lines below it."""
    lines = printed.splitlines()
    return "\n".join(lines[:next(k for k, line in enumerate(lines) if line.startswith("positions "))])


def chunks(png):
    at = SIGNATURE_LENGTH
    while at < len(png):
        length = int.from_bytes(png[at:at + 4], "big")
        yield at, png[at + 4:at + 8], png[at + 8:at + 8 + length]
        at += length + 12


def with_text(png, text):
    """The picture with a text, which it carries as an international text chunk behind its header."""
    content = b"iTXt" + KEYWORD + b"\0\0\0\0\0" + text.encode()
    chunk = (len(content) - 4).to_bytes(4, "big") + content + zlib.crc32(content).to_bytes(4, "big")
    end_of_header = list(chunks(png))[1][0]
    return png[:end_of_header] + chunk + png[end_of_header:]


def text_of(png):
    """The text that with_text() put into a picture, "" without one."""
    for _, kind, content in chunks(png):
        if kind == b"iTXt" and content.startswith(KEYWORD + b"\0"):
            return content[len(KEYWORD) + 5:].decode()
    return ""
