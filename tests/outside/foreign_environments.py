#!/usr/bin/env python3
"""What a probe sees of foreign skies, against the same files read by OpenImageIO (Radiance: here) and averaged in numpy.

    tests/outside/foreign_environments.py build/release/bin/boxprobe --from DIR -o out/environments [--only TEXT]

DIR holds the repositories of foreign_environments.tsv, checked out as OWNER+NAME at its commits. Needs python3-numpy and
python3-openimageio. Prints one line per file: what it showed, the light over the reader's (whole sphere), the largest
difference among 8 x 4 fields of the sphere over the mean light, and what `boxprobe` said. Ends with 1 if a file does not show
what the list says.
"""
import argparse
import csv
import json
import os
import subprocess
import sys

import numpy as np
import OpenImageIO as oiio

SAME_LIGHT, SAME_FIELD = 0.01, 0.04
COLUMNS, ROWS = 512, 256  # of the pictures that are compared
REC709 = [(.64, .33), (.30, .60), (.15, .06), (.3127, .3290)]
BRADFORD = np.array([[.8951, .2664, -.1614], [-.7502, 1.7135, .0367], [.0389, -.0685, 1.0296]])


def white(xy):
    return np.array([xy[0] / xy[1], 1, (1 - xy[0] - xy[1]) / xy[1]])


def to_xyz(primaries):
    columns = np.array([(x, y, 1 - x - y) for x, y in primaries[:3]]).T
    return columns * np.linalg.solve(columns, white(primaries[3]))


def to_rec709(primaries):
    adapt = np.linalg.inv(BRADFORD) @ np.diag((BRADFORD @ white(REC709[3])) / (BRADFORD @ white(primaries[3]))) @ BRADFORD
    return np.linalg.inv(to_xyz(REC709)) @ adapt @ to_xyz(primaries)


def radiance_factor(path):
    """What the header's lines ask for: a factor per channel, and whether the numbers are XYZ."""
    factor, xyz = np.ones(3), False
    with open(path, "rb") as file:
        for raw in file:
            line = raw.decode("latin-1").strip()
            if not line:
                break
            if line.startswith("EXPOSURE="):
                factor /= float(line[9:])
            if line.startswith("COLORCORR="):
                factor /= np.array([float(v) for v in line[10:].split()])
            xyz = xyz or line == "FORMAT=32-bit_rle_xyze"
    return factor, xyz


def radiance(path):
    """Pixels of a Radiance file as they are stored, of any run lengths; rows from the top, columns from the left."""
    with open(path, "rb") as file:
        data = file.read()
    at = data.index(b"\n\n") + 2
    end = data.index(b"\n", at)
    y, height, x, width = data[at:end].split()
    if (y, x) != (b"-Y", b"+X"):
        raise ValueError("another order of rows and columns")
    height, width, at = int(height), int(width), end + 1
    if len(data) - at == 4 * width * height:
        flat = np.frombuffer(data, np.uint8, offset=at).reshape(height, width, 4)
    else:
        flat = np.zeros((height, width, 4), np.uint8)
        for row in flat:
            if 8 <= width < 32768 and data[at:at + 2] == b"\2\2" and data[at + 2] < 128:
                at += 4
                for channel in range(4):
                    done = 0
                    while done < width:
                        count = data[at]
                        if count > 128:
                            row[done:done + count - 128, channel] = data[at + 1]
                            done, at = done + count - 128, at + 2
                        else:
                            row[done:done + count, channel] = np.frombuffer(data, np.uint8, count, at + 1)
                            done, at = done + count, at + 1 + count
            else:
                done, shift = 0, 0
                while done < width:
                    pixel = np.frombuffer(data, np.uint8, 4, at)
                    at += 4
                    if tuple(pixel[:3]) == (1, 1, 1):
                        count = int(pixel[3]) << shift
                        row[done:done + count] = row[done - 1]
                        done, shift = done + count, shift + 8
                    else:
                        row[done] = pixel
                        done, shift = done + 1, 0
    exponent = flat[:, :, 3:].astype("f8")
    return np.where(exponent > 0, flat[:, :, :3] * 2.0 ** (exponent - 136), 0)


def parts(path):
    buffer = oiio.ImageBuf(path)
    for part in range(max(buffer.nsubimages, 1)):
        yield oiio.ImageBuf(path, part, 0)


def layer_of(names):
    """The prefix of the picture's channels: none, else the first layer's."""
    for name in sorted(names, key=lambda n: (n.count("."), n)):
        if name.split(".")[-1] == "R" and all(name[:-1] + c in names for c in "RGB"):
            return name[:-1]
    return None


def colors(path):
    """Rec. 709 radiance of the file's picture as an array, and whether it holds six faces of a cube."""
    if path.lower().endswith(".hdr"):
        factor, xyz = radiance_factor(path)
        image = radiance(path) * factor
        return np.maximum(image @ np.linalg.inv(to_xyz(REC709)).T if xyz else image, 0), False
    chosen = None
    for part in parts(path):
        spec = part.spec()
        names = list(spec.channelnames)
        usable = not spec.deep and (layer_of(names) is not None or "Y" in names or len(names) == 1)
        environment = spec.getattribute("openexr:envmap") is not None or spec.get_string_attribute("textureformat") != ""
        if usable and (chosen is None or environment):
            chosen = part
        if usable and environment:
            break
    if chosen is None:
        raise ValueError("no picture")
    spec = chosen.spec()
    names = list(spec.channelnames)
    pixels = chosen.get_pixels(oiio.FLOAT)
    if pixels is None:
        raise ValueError(chosen.geterror() or "not read")
    pixels = np.asarray(pixels, "f8").reshape(spec.height, spec.width, len(names))
    if spec.format.basetype == oiio.UINT32:
        pixels = pixels * 4294967295.0  # the reader's 0 to 1
    layer = layer_of(names)
    if all(c in names for c in ("Y", "RY", "BY")):
        luminance, red, blue = (pixels[:, :, names.index(c)] for c in ("Y", "RY", "BY"))
        red, blue = (red + 1) * luminance, (blue + 1) * luminance
        image = np.stack([red, (luminance - .2126 * red - .0722 * blue) / .7152, blue], -1)
    elif layer is not None:
        image = pixels[:, :, [names.index(layer + c) for c in "RGB"]]
    else:
        image = np.repeat(pixels[:, :, names.index("Y") if "Y" in names else 0][:, :, None], 3, 2)
    primaries = spec.getattribute("chromaticities")
    if primaries is not None and layer is not None:
        points = [tuple(primaries[i:i + 2]) for i in range(0, 8, 2)]
        image = image @ to_rec709(points).T
    image = np.maximum(image, 0)
    kind = str(spec.getattribute("openexr:envmap") or spec.get_string_attribute("textureformat"))
    cube = "Cube" in kind or spec.height == 6 * spec.width
    known = "LatLong" in kind or cube or spec.width == 2 * spec.height and spec.full_width != 2 * spec.full_height
    if not known and (spec.width, spec.height, spec.x, spec.y) != (spec.full_width, spec.full_height, spec.full_x, spec.full_y):
        placed = np.zeros((spec.full_height, spec.full_width, 3))
        for y in range(spec.height):
            for x in range(spec.width):
                to_y, to_x = y + spec.y - spec.full_y, x + spec.x - spec.full_x
                if 0 <= to_y < spec.full_height and 0 <= to_x < spec.full_width:
                    placed[to_y, to_x] = image[y, x]
        image = placed
    return image, cube


def resampled(image):
    """A latitude-longitude picture at the size that is compared: the means of fine bilinear samples."""
    fine = max(1, int(np.ceil(image.shape[1] / COLUMNS)), 2)
    height, width = image.shape[:2]
    y = np.clip((np.arange(ROWS * fine) + .5) / (ROWS * fine) * height - .5, 0, height - 1)
    x = (np.arange(COLUMNS * fine) + .5) / (COLUMNS * fine) * width - .5
    y0, x0 = np.floor(y).astype(int), np.floor(x).astype(int)
    fy, fx = (y - y0)[:, None, None], (x - x0)[None, :, None]
    y1 = np.minimum(y0 + 1, height - 1)
    rows = lambda r: image[r][:, x0 % width] * (1 - fx) + image[r][:, (x0 + 1) % width] * fx
    whole = rows(y0) * (1 - fy) + rows(y1) * fy
    return whole.reshape(ROWS, fine, COLUMNS, fine, 3).mean((1, 3))


def sphere_mean(picture):
    weight = np.cos((.5 - (np.arange(picture.shape[0]) + .5) / picture.shape[0]) * np.pi)
    return (picture.mean(1) * weight[:, None]).sum(0) / weight.sum()


def cube_mean(strip):
    size = strip.shape[1]
    s = np.linspace(-1, 1, size)
    weight = (1 + s[:, None] ** 2 + s[None, :] ** 2) ** -1.5
    weight[[0, -1]] *= .5  # texels on the edges
    weight[:, [0, -1]] *= .5
    faces = strip.reshape(6, size, size, 3)
    return (faces * weight[None, :, :, None]).sum((0, 1, 2)) / (6 * weight.sum())


def fields(picture):
    weight = np.cos((.5 - (np.arange(ROWS) + .5) / ROWS) * np.pi)[:, None, None]
    return (picture * weight).reshape(4, ROWS // 4, 8, COLUMNS // 8, 3).sum((1, 3)) / (
        weight.reshape(4, ROWS // 4).sum(1)[:, None, None] * (COLUMNS // 8))


def seen(program, path, folder, size):
    """The sky as a probe has captured it, or None; and what the program said."""
    scene = {"format": "boxprobe-scene", "version": 1, "models": [{"file": "far.obj", "translation": [0, -1e6, 0]}],
             "sky": {"image": path}, "probes": [{"name": "p", "origin": [0, 0, 0], "faceSize": size, "filterSamples": 8,
                                                  "box": {"min": [-1, -1, -1], "max": [1, 1, 1]}}]}
    with open(os.path.join(folder, "far.obj"), "w") as file:
        file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    name = os.path.join(folder, "s.boxprobe.json")
    with open(name, "w") as file:
        json.dump(scene, file)
    out = os.path.join(folder, "export")
    if os.path.exists(os.path.join(out, "p.exr")):
        os.remove(os.path.join(out, "p.exr"))
    done = subprocess.run([program, "export", name, "-o", out, "--format", "exr", "--lossy"], capture_output=True, text=True,
                          timeout=600)
    said = " ".join(line.replace(path, os.path.basename(path)) for line in (done.stderr + done.stdout).splitlines()
                    if "boxprobe:" in line)
    if done.returncode:
        return None, said
    # The part of the scene that is not the sky is a point far away.
    return resampled(colors(os.path.join(out, "p.exr"))[0]), said


def verdict(program, path, judge, folder):
    try:
        expected, cube = colors(judge)
    except ValueError as error:
        return "not judged", 0, 0, str(error)
    # Wide pictures may have suns of a texel: as many texels around as they have.
    picture, said = seen(program, path, folder, 512 if expected.shape[1] > 512 else 256)
    if picture is None:
        return "refused", 0, 0, said
    mean = sphere_mean(picture)
    right = cube_mean(expected) if cube else sphere_mean(resampled(expected))
    light = float(np.max(np.abs(mean - right)) / max(float(right.max()), 1e-30)) if np.isfinite(right).all() else np.nan
    field = 0.0
    if not cube:
        right_fields = fields(resampled(expected))
        field = float(np.max(np.abs(fields(picture) - right_fields) / (right_fields + right.max())))
    fine = light <= SAME_LIGHT and field <= SAME_FIELD
    return "right" if fine else "other", light, field, said


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--from", dest="folder", required=True)
    parser.add_argument("-o", dest="out", required=True)
    parser.add_argument("--only", default="")
    parser.add_argument("--list", default=os.path.join(os.path.dirname(__file__), "foreign_environments.tsv"))
    options = parser.parse_args()
    os.makedirs(options.out, exist_ok=True)
    other = 0
    with open(options.list) as file:
        rows = list(csv.DictReader(file, delimiter="\t", quoting=csv.QUOTE_NONE))
    for row in rows:
        folder = os.path.join(options.folder, row["repository"].replace("/", "+"))
        path = os.path.abspath(os.path.join(folder, row["file"]))
        if options.only not in path:
            continue
        judge = os.path.join(folder, row["judged by"]) if row["judged by"] else path
        found, light, field, said = verdict(os.path.abspath(options.program), path, judge, options.out)
        listed = row["seen"].split(":")[0]
        as_listed = found == listed or listed == "named" and found == "other" and said != ""
        other += not as_listed
        print("%-10s%s %s: light %.4f, fields %.3f; %s" % (found, "" if as_listed else " (listed: %s)" % listed,
                                                        row["file"], light, field, said), flush=True)
    print("%d files, %d other than listed" % (len(rows), other))
    return 1 if other else 0


if __name__ == "__main__":
    sys.exit(main())
