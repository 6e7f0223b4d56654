"""What a picture of `brdftab plot` says, read back from its SVG."""

import base64
import io
import json
import math
import xml.etree.ElementTree

import numpy
from PIL import Image

SVG = "{http://www.w3.org/2000/svg}"


class Picture:
    def __init__(self, path, data=True):
        self.root = xml.etree.ElementTree.parse(path).getroot()
        if data:
            self.data = json.loads(self.root.find(f"{SVG}metadata").text)

    def texts(self):
        return ["".join(element.itertext()) for element in self.root.iter(f"{SVG}text")]

    def curves(self):
        """(panel, series) of each line, in the order of `paths`."""
        return [(panel, series) for panel in self.data["panels"] for series in panel["series"] if series["marks"] == "line"]

    def paths(self):
        """The points drawn of each curve, in user units."""
        drawn = []
        for element in self.root.iter(f"{SVG}path"):
            if element.get("stroke-linejoin") == "round" and not element.get("stroke-linecap"):
                drawn.append([tuple(map(float, pair.split())) for pair in element.get("d")[1:].split("L")])
        return drawn

    def images(self):
        """Each embedded PNG as an array of RGBA, and the scale's apart."""
        maps, scale = [], None
        for element in self.root.iter(f"{SVG}image"):
            pixels = numpy.asarray(Image.open(io.BytesIO(base64.b64decode(element.get("href").split(",", 1)[1]))).convert("RGBA"))
            if element.get("class") == "scale":
                scale = pixels
            else:
                maps.append(pixels)
        return maps, scale


def place(axis, value):
    """Where an axis of the metadata puts a value, in user units."""
    if axis["logarithmic"]:
        share = math.log(value / axis["low"]) / math.log(axis["high"] / axis["low"])
    else:
        share = (value - axis["low"]) / (axis["high"] - axis["low"])
    return axis["from"] + share * (axis["to"] - axis["from"])


# This runs in the browser and returns texts that leave the picture or touch each other. A bounding box is higher than what is
# written in it.
TEXTS_IN_THE_WAY = """
(() => {
  const page = document.documentElement.getBoundingClientRect();
  const boxes = [...document.querySelectorAll('text')].map((text) => {
    const box = text.getBoundingClientRect(), turned = box.height > box.width * 1.5, trim = 0.12;
    const dx = turned ? trim * box.width : 0, dy = turned ? 0 : trim * box.height;
    return {text: text.textContent, left: box.left + dx, right: box.right - dx, top: box.top + dy, bottom: box.bottom - dy};
  });
  const found = [];
  boxes.forEach((a, k) => {
    if (a.left < page.left || a.right > page.right || a.top < page.top || a.bottom > page.bottom) found.push(`outside: ${a.text}`);
    for (const b of boxes.slice(k + 1))
      if (a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom) found.push(`${a.text} | ${b.text}`);
  });
  return found;
})()
"""
