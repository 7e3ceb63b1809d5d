#!/usr/bin/env python3
"""Write a picture with fewer colors, a smaller file.

Usage: scripts/draw/fewer_colors.py IN.png OUT.png COLORS
Needs python3-pil.
"""
import sys

from PIL import Image

if len(sys.argv) != 4:
    sys.exit(__doc__)
picture = Image.open(sys.argv[1]).convert("RGB")
few = picture.quantize(int(sys.argv[3]), method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
few.save(sys.argv[2], optimize=True)
