"""What bench/run measures: workloads and their sizes at each scale, and the peers' command lines."""

import subprocess
from dataclasses import dataclass, field
from pathlib import Path

BENCH = Path(__file__).resolve().parent
SOURCE = BENCH.parent
BUILD = SOURCE / "build" / "bench"
INSTALLED = BENCH / "peers" / ".installed"
OPERATIONS = ["intersection", "union", "difference", "symdifference"]


@dataclass
class Workload:
    name: str
    make: list  # arguments of oblast_workload, without -o
    operations: list = field(default_factory=lambda: ["default"])
    pairs: bool = False  # many small overlays: every peer works on them in as many threads
    window: bool = False  # B is convex: what can clip by a window only contends too


def generated(kind, sizes, operations=("default",), pairs=False, window=False):
    return [
        Workload(f"{kind}-{size}", ["generate", kind, str(size)], list(operations), pairs, window) for size in sizes
    ]


def dissolve(shared, stem):
    path = shared / "realworld" / f"{stem}.geojson"
    return Workload(f"dissolve-{stem}", ["layer", "--a", str(path), "--overlapping-a", "--coverage"])


def layers(shared, name, a, b, operations):
    # Layers dissolve on their way in where a peer needs it: their polygons share borders.
    files = [str(shared / "realworld" / f"{stem}.geojson") for stem in (a, b)]
    arguments = ["layer", "--a", files[0], "--b", files[1], "--overlapping-a", "--overlapping-b"]
    return Workload(name, arguments, list(operations))


def fires_folder(scale):
    return BUILD / f"fires-{scale}"


def fires(scale):
    """The folder of `oblast generate fires`, a month of them or all; made when it is not there yet."""
    folder = fires_folder(scale)
    if not folder.exists():
        program = BUILD / "apps" / "oblast" / "oblast"
        month = [] if scale == "full" else ["--month", "april"]
        subprocess.run([program, "generate", "fires", *month, "-o", folder], check=True, stdout=subprocess.DEVNULL)
    return folder


def suite(scale, shared):
    """The workloads at a scale: `small` (minutes), `full`, or `growth`: two kinds from 10^4 to 10^7 edges."""
    if scale == "growth":  # few meetings, and as many as squares
        stars = generated("stars", [5_000, 50_000, 500_000, 5_000_000])
        return stars + generated("checkerboard", [36, 112, 354, 1_119])
    full = scale == "full"

    def pick(small, large):
        return large if full else small

    result = []
    result += generated("stars", pick([100_000], [1_000_000]), OPERATIONS)
    result += generated("slabs", pick([200], [500]))
    result += generated("nested", pick([300], [1000]))
    result += generated("crossing", pick([500], [500, 2000]))
    result += generated("spiral_pair", pick([20_000], [500_000]))
    result += generated("coverage", pick([40], [300]))
    result += generated("pairs", pick([100_000], [1_000_000]), pairs=True)
    # one operand convex: the fast paths
    for kind in ("small_window", "large_window", "octagon"):
        result += generated(kind, pick([1_000, 100_000], [1_000, 1_000_000]), window=True)
    for kind in ("window_pairs", "convex_pairs"):
        result += generated(kind, pick([100_000], [1_000_000]), pairs=True, window=True)
    # iOverlay's own tests
    for kind in ("checkerboard", "not_overlap", "lines_net", "windows", "windmill"):
        result += generated(kind, pick([150], [1000 if kind != "windmill" else 500]))
    result += generated("nested_squares", pick([500], [4000]))
    result += generated("spiral", pick([20_000], [500_000]))
    result += generated("corrosion", pick([50], [400]))
    result += generated("concentric", pick([50], [300]))

    result.append(Workload("fires", ["layer", "--a", str(fires_folder(scale)), "--overlapping-a"]))

    stems = ["france-communes-normandie", "france-departements", "germany-counties-medium"]
    if full:
        stems += ["france-communes-hauts-de-france", "italy-municipalities-r5", "russia-subjects", "brazil-states"]
    result += [dissolve(shared, stem) for stem in stems]
    outline, districts, counties = "germany-outline-very-high", "germany-districts-high", "germany-counties-medium"
    result.append(layers(shared, "germany-outline-districts", outline, districts, OPERATIONS))
    if full:
        result.append(layers(shared, "germany-outline-counties", outline, counties, OPERATIONS))
        result.append(layers(shared, "germany-districts-counties", districts, counties, OPERATIONS))
    return result


@dataclass
class Peer:
    name: str
    command: object  # threads -> list of words before WORKLOAD
    threaded: bool = False  # makes use of threads within one overlay
    polygons: bool = True  # False: gives contours that nobody assigned to polygons
    window: bool = False  # contends where B is a convex window only


def peers():
    """Every peer that is installed, ourselves first."""
    cpp = INSTALLED / "cpp" / "bin"
    python = [str(INSTALLED / "venv" / "bin" / "python"), str(BENCH / "peers" / "shapely_driver.py")]

    def rust(engine):
        def command(threads):
            folder = "rust-single" if threads == 1 else "rust-multi"
            return [str(INSTALLED / folder / "release" / "ioverlay_driver"), engine]

        return command

    def program(name):
        return lambda threads: [str(cpp / name)]

    known = [
        Peer("oblast", lambda threads: [str(BUILD / "bench" / "oblast_driver")], threaded=True),
        Peer("oblast-pipeline", lambda threads: [str(BUILD / "bench" / "oblast_pipeline_driver")], True, window=True),
        Peer("oblast-window", lambda threads: [str(BUILD / "bench" / "oblast_window_driver")], window=True),
        Peer("ioverlay-int", rust("int"), threaded=True),
        Peer("ioverlay-float", rust("float"), threaded=True),
        Peer("ioverlay-float64", rust("float64"), threaded=True),
        Peer("clipper2", program("clipper2")),
        Peer("clipper2-paths", program("clipper2-paths"), polygons=False),
        Peer("clipper2-rect", program("clipper2-rect"), polygons=False, window=True),
        Peer("boost", program("boost")),
        Peer("geos", program("geos")),
        Peer("geos-coverage", program("geos-coverage")),
        Peer("geos-rect", program("geos-rect"), window=True),
        Peer("geos-newest", lambda threads: python),
        Peer("geos-newest-coverage", lambda threads: [*python]),
        Peer("cgal", program("cgal")),
    ]
    return [peer for peer in known if Path(peer.command(1)[0]).exists() and Path(peer.command(2)[0]).exists()]
