"""Runs Triangle through its Python package, once. trimalla starts this program with `python3 -c`.

With no argument it writes the version of the package. Otherwise the arguments are Triangle's switches and a time limit in
seconds; the drawing comes on standard input and the mesh goes to standard output, both as one JSON object.
"""
import sys

sys.path = [folder for folder in sys.path if folder]  # No module is taken from the directory of the user.
import json
import os
import signal
import time

import triangle

answer = os.fdopen(os.dup(1), "w")
os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # Triangle prints its own messages there.
if len(sys.argv) == 1:
    answer.write(triangle.__version__)
else:
    switches, seconds = sys.argv[1], float(sys.argv[2])
    if hasattr(signal, "setitimer") and 0 < seconds < 1e6:
        signal.setitimer(signal.ITIMER_REAL, seconds)  # Ends this process even if nobody is left to end it.
    drawing = json.load(sys.stdin)
    start = time.perf_counter()
    mesh = triangle.triangulate(drawing, switches)
    seconds = time.perf_counter() - start
    columns = {key: mesh[key].tolist() for key in ("vertices", "triangles", "segments") if key in mesh}
    json.dump({"seconds": seconds, **columns}, answer)
answer.close()
