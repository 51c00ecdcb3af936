"""squares.py COUNT OUTPUT: squares with attributes as GeoJSON; 500,000 of them are 143 MiB. Many overlap a neighbour.

    python3 bench/program/squares.py 500000 squares.geojson
    oblast union squares.geojson -o united.gpkg        # says the seconds of each stage; so do dissolve --by class, repair
"""

import random
import sys

count, output = int(sys.argv[1]), sys.argv[2]
columns = int(count**0.5) + 1
random.seed(22)
with open(output, "w") as file:
    file.write('{\n"type": "FeatureCollection",\n"name": "squares",\n"crs": {"type": "name", "properties": '
               '{"name": "urn:ogc:def:crs:EPSG::3035"}},\n"features": [\n')
    for i in range(count):
        x = 4_000_000 + i % columns * 10 + random.uniform(-3, 3)
        y = 2_000_000 + i // columns * 10 + random.uniform(-3, 3)
        side = random.uniform(6, 9)
        ring = [(x, y), (x + side, y), (x + side, y + side), (x, y + side), (x, y)]
        points = ", ".join(f"[ {a:.3f}, {b:.3f} ]" for a, b in ring)
        file.write(f'{{ "type": "Feature", "properties": {{ "number": {i}, "value": {random.random():.6f}, '
                   f'"class": "{"abcdefgh"[i % 8]}" }}, "geometry": {{ "type": "Polygon", "coordinates": '
                   f'[ [ {points} ] ] }} }}' + (",\n" if i + 1 < count else "\n"))
    file.write("]\n}\n")
