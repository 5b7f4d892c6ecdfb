"""Pictures of foreign models, measured and laid out by ImageMagick. For foreign_models.py."""
import subprocess
from pathlib import Path

PER_SHEET, COLUMNS = 18, 3


def pixels(path):
    """Red, green, blue of each pixel, 0 to 255."""
    return subprocess.run(["convert", str(path), "-depth", "8", "rgb:-"], capture_output=True, check=True).stdout


def display_values(path):
    """Brightness of the picture's pixels, 0 to 1, as displayed."""
    raw = pixels(path)
    return [(0.2126 * raw[i] + 0.7152 * raw[i + 1] + 0.0722 * raw[i + 2]) / 255.0 for i in range(0, len(raw) - 2, 3)]


def percentile(values, share):
    values = sorted(values)
    return values[int(share * (len(values) - 1))] if values else 0.0


def tile(row, out):
    """Ours on the left, theirs on the right, in one picture."""
    sides = []
    for picture in (row.get("ours"), row.get("theirs")):
        # The first frame of a moving picture.
        there = picture and Path(picture).is_file() and not (picture == row.get("ours") and "refused" in row)
        sides += ["(", picture + "[0]" if there else "xc:gray30", "-background", "white", "-flatten", "-resize", "256x192",
                  "-background", "gray40", "-gravity", "center", "-extent", "256x192", ")"]
    subprocess.run(["convert"] + sides + ["+append", str(out)], capture_output=True, check=True)


def font():
    """A font's file: ImageMagick without Ghostscript has none of its own."""
    found = subprocess.run(["fc-match", "-f", "%{file}", "sans"], capture_output=True, text=True, check=True).stdout
    return ["-font", found] if found else []


def sheets(rows, out):
    """sheet-1.png ... in the folder `out`; rows as foreign_models.py fills them."""
    tiles = []
    for i, row in enumerate(rows):
        path = out / ("tile-%03d.png" % i)
        tile(row, path)
        verdict = "refused" if "refused" in row else row["seen"]
        tiles.append(["-label", "%s: %s: %s" % (Path(row["file"]).stem[:24], row.get("found", "-"), verdict[:34]), str(path)])
    for page in range(0, len(tiles), PER_SHEET):
        parts = [part for entry in tiles[page:page + PER_SHEET] for part in entry]
        sheet = out / ("sheet-%d.png" % (page // PER_SHEET + 1))
        subprocess.run(["montage", "-pointsize", "13"] + font() + parts + ["-tile", "%dx" % COLUMNS, "-geometry", "+3+2", str(sheet)],
                       check=True)
        print("sheet: %s" % sheet)
