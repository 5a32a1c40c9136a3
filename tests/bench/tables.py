#!/usr/bin/env python3
"""Makes the README's tables of benchmarks, and the plot, from the lines of JSON that the benchmarks end with.

  tests/bench/run.sh | tests/bench/tables.py             also --errors, --scaling
  tests/bench/tables.py --check                          says whether the README is what would be made

A line is kept in tests/bench/results/, in place of the one before of that benchmark; a table stands in the README
between <!-- table NAME --> and <!-- end -->. The plot is drawn by gnuplot.
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
RESULTS = ROOT / "tests/bench/results"
PLOT = ROOT / "assets/gallery/scaling.png"
SCENES = {
    "blocks": "Cornell box with blocks",
    "spheres": "with silver and glass sphere",
    "busts": "two busts, one of Phong",
    "mesh": "with the Stanford dragon",
    "million": "with a ball of a million triangles",
    "lights": "with blocks and 1000 emissive triangles",
    "ceiling": "with blocks, all of the ceiling one lamp",
    "tiles": "with blocks, the same ceiling of 1000 emissive triangles",
}
ESTIMATORS = {
    "sobol, mis": "Sobol' points, multiple importance sampling",
    "and guided directions": "and guided directions: the default",
    "and shared paths": "and shared paths: `--path-reuse 64`",
}


def count(n):
    return str(n) if n < 1000 else f"{n / 1000:.0f} k" if n < 1e6 else f"{n / 1e6:.2g} M"


def table(head, rows):
    lines = [head, ["---"] * len(head)] + rows
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def yardstick(run):
    head = ["scene", "triangles", "samples: vkpt", "yardstick", "ratio", "rays, vkpt: primary, bounce, shadow",
            "ratios to Embree", "two threads over one"]
    rows = []
    for scene in dict.fromkeys(r["scene"] for r in run["results"]):
        of = {r["what"]: r for r in run["results"] if r["scene"] == scene}
        rays = [of[kind] for kind in ("primary", "bounce", "shadow")]
        rows.append([SCENES[scene], count(of["paths"]["triangles"]), f"{of['paths']['vkptCpu']:.2f}",
                     f"{of['paths']['yardstickCpu']:.2f}", f"{of['paths']['cpuRatio']:.2f}",
                     ", ".join(f"{r['vkptCpu']:.1f}" for r in rays), ", ".join(f"{r['cpuRatio']:.2f}" for r in rays),
                     f"{of['2 threads / 1']['cpuRatio']:.2f}"])
    return table(head, rows)


def errors(run):
    head = ["scene", "estimator", "Msamples/s", "RMSE", "of the plain one's", "efficiency", "over the plain one's"]
    rows = []
    for r in run["results"]:
        first = r["estimator"] == "plain"
        rows.append([SCENES[r["scene"]] if first else "", ESTIMATORS.get(r["estimator"], r["estimator"]),
                     f"{1e-6 * r['samplesPerSecond']:.2f}", f"{r['rmse']:.4f}", f"{r['ofPlain']:.2f}",
                     f"{float(format(r['efficiency'], '.3g')):g}", f"{r['overPlain']:.1f}"])
    return table(head, rows)


def scaling(run):
    head = ["triangles", "sample, µs", "yardstick", "bounce rays, M/s", "Embree", "build, s: one thread", "two"]
    rows = [[f"{r['triangles']:,}".replace(",", " "), f"{r['microseconds']:.2f}", f"{r['yardstickMicroseconds']:.2f}",
             f"{r['bounces']:.2f}", f"{r['yardstickBounces']:.2f}", f"{r['buildSecondsOneThread']:.3f}",
             f"{r['buildSecondsTwoThreads']:.3f}"] for r in run["rows"]]
    fit = run["fit"]
    sign = "-" if fit["a"] < 0 else "+"
    return (f"Time of a sample = {fit['b']:.2f} µs log2(triangles) {sign} {abs(fit['a']):.2f} µs, "
            f"within {100 * fit['worst']:.0f} %.\n\n" + table(head, rows))


def draw(run):
    data = "".join(f"{r['triangles']} {r['microseconds']} {r['yardstickMicroseconds']}\n" for r in run["rows"])
    fit = run["fit"]
    script = f"""
$d << EOD
{data}EOD
set encoding utf8
set terminal pngcairo size 640,400 noenhanced font 'sans-serif,11'
set output '{PLOT}'
set logscale x
set grid
set key top left
set xrange [700:1400000]
set yrange [0:*]
set xtics ('1 k' 1e3, '10 k' 1e4, '100 k' 1e5, '1 M' 1e6)
set xlabel 'triangles'
set ylabel 'time of a sample / µs'
plot $d using 1:2 with points pt 7 lc rgb '#0072B2' title 'vkpt', \\
  {fit['a']} + {fit['b']} * log(x) / log(2) with lines lc rgb '#0072B2' title 'a + b log2(triangles)', \\
  $d using 1:3 with linespoints pt 6 lc rgb '#D55E00' title 'yardstick'
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def store(text):
    RESULTS.mkdir(exist_ok=True)
    for line in text.splitlines():
        if line.startswith("{"):
            run = json.loads(line)
            (RESULTS / f"{run['benchmark']}.json").write_text(line + "\n")
            if run["benchmark"] == "scaling":
                draw(run)


def main():
    check = "--check" in sys.argv[1:]
    if not check:
        store(sys.stdin.read())
    readme = ROOT / "README.md"
    old = text = readme.read_text()
    for maker in (yardstick, errors, scaling):
        name = maker.__name__
        made = maker(json.loads((RESULTS / f"{name}.json").read_text()))
        text, times = re.subn(f"(?s)(<!-- table {name} -->\n).*?(<!-- end -->)",
                              lambda m: f"{m[1]}\n{made}\n{m[2]}", text)
        if times != 1:
            sys.exit(f"README.md has no place for the table: <!-- table {name} -->, <!-- end -->")
    if not check:
        readme.write_text(text)
    elif text != old:
        sys.exit("README.md's tables are not those of tests/bench/results: tests/bench/tables.py </dev/null")


if __name__ == "__main__":
    main()
