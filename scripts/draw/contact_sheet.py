#!/usr/bin/env python3
"""Put pictures beside and below each other, each below its title, in few colors.

Usage: scripts/draw/contact_sheet.py OUT.png COLUMNS WIDTH COLORS TITLE=PICTURE.png ...
WIDTH is that of each picture, pixels. Needs python3-pil.
"""
import sys

from PIL import Image, ImageDraw, ImageFont

BAND = 22
GAP = 4


def font():
    try:
        return ImageFont.truetype("DejaVuSans.ttf", 14)
    except OSError:
        return ImageFont.load_default()


def scaled(path, width):
    picture = Image.open(path).convert("RGB")
    height = round(picture.height * width / picture.width)
    return picture.resize((width, height), Image.LANCZOS)


def main(out, columns, width, colors, *entries):
    columns, width = int(columns), int(width)
    titles, paths = zip(*(entry.rsplit("=", 1) for entry in entries))
    pictures = [scaled(path, width) for path in paths]
    rows = -(-len(pictures) // columns)
    cell_width = width + GAP
    cell_height = max(picture.height for picture in pictures) + BAND + GAP
    sheet = Image.new("RGB", (columns * cell_width - GAP, rows * cell_height - GAP), "white")
    draw = ImageDraw.Draw(sheet)
    for place, (title, picture) in enumerate(zip(titles, pictures)):
        x, y = place % columns * cell_width, place // columns * cell_height
        draw.text((x + 4, y + 3), title, fill="black", font=font())
        sheet.paste(picture, (x, y + BAND))
    few = sheet.quantize(int(colors), method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    few.save(out, optimize=True)


if __name__ == "__main__":
    if len(sys.argv) < 6:
        sys.exit(__doc__)
    main(*sys.argv[1:])
