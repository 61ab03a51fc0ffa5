"""Opens the studio in a browser that nobody sees, and uses it: web_check.py FOLDER PICTURE.png

The page says in an attribute of its body how large the document is; that is read after each action.
"""

import base64
import functools
import http.server
import json
import pathlib
import re
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import urllib.parse
import urllib.request
import zlib

SIZE = (1280, 860)
SCRIPT = ["Generate polygon 40 3", "Triangulate", "Set min-angle 30", "Refine"]
DRAWING = "3 2 0 0\n0 0 0\n1 4 0\n2 0 3\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n"
# Where buttons are in a page of that size.
COPY_LINK = (136, 12)
REFINE = (434, 83)
FLAGS = [
    "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--force-device-scale-factor=1", "--hide-scrollbars",
]
TIMEOUT = 120  # Seconds; the page is not optimized, and is drawn without a graphics card.


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def serve(folder):
    """A static server on a free port of this machine; the address of the page."""
    handler = functools.partial(Quiet, directory=folder)
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f"http://127.0.0.1:{server.server_port}/index.html"


class Browser:
    """A session of chromedriver, by the protocol WebDriver."""

    def __init__(self, folder):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        self.root = f"http://127.0.0.1:{port}"
        self.downloads = pathlib.Path(folder, "downloads")
        self.downloads.mkdir()
        self.driver = subprocess.Popen(
            ["chromedriver", f"--port={port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        wait(lambda: self.is_up(), "chromedriver does not start")
        options = {
            "binary": shutil.which("chromium"),
            "args": [*FLAGS, f"--user-data-dir={folder}/profile", f"--window-size={SIZE[0]},{SIZE[1]}"],
            "prefs": {"download.default_directory": str(self.downloads), "download.prompt_for_download": False},
        }
        capabilities = {"alwaysMatch": {"goog:chromeOptions": options}}
        session = self.ask("POST", "/session", {"capabilities": capabilities})
        self.root += f"/session/{session['sessionId']}"
        # The part of the page that is seen, whatever the frame of the window takes.
        metrics = {"width": SIZE[0], "height": SIZE[1], "deviceScaleFactor": 1, "mobile": False}
        command = {"cmd": "Emulation.setDeviceMetricsOverride", "params": metrics}
        self.ask("POST", "/goog/cdp/execute", command)

    def ask(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.root + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=TIMEOUT) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            sys.exit(f"error: {path}: {json.load(error)['value']['message'].splitlines()[0]}")

    def is_up(self):
        try:
            return self.ask("GET", "/status")["ready"]
        except OSError:
            return False

    def open(self, link):
        # Another fragment alone would not load the page again.
        self.ask("POST", "/url", {"url": "about:blank"})
        self.ask("POST", "/url", {"url": link})

    def run(self, script, *arguments):
        return self.ask("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def click(self, place):
        x, y = place
        moves = [
            {"type": "pointerMove", "duration": 0, "x": x, "y": y},
            {"type": "pause", "duration": 300},
            {"type": "pointerDown", "button": 0},
            {"type": "pause", "duration": 100},
            {"type": "pointerUp", "button": 0},
        ]
        self.ask("POST", "/actions", {"actions": [{"type": "pointer", "id": "mouse", "actions": moves}]})

    def screenshot(self):
        return base64.b64decode(self.ask("GET", "/screenshot"))

    def figures(self):
        """What the page says of its document, or None while a command is at work."""
        told = self.run("return document.body.getAttribute('data-document') || ''")
        if not told.startswith("ready"):
            failed = self.run("return (document.getElementById('loading') || {}).textContent || ''")
            if "cannot" in failed:
                sys.exit(f"error: {failed}")
            return None
        return {key: float(value) for key, value in re.findall(r"([a-z-]+)=([-\d.]+)", told)}

    def close(self):
        try:
            self.ask("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()


def wait(holds, fault):
    """Waits until something holds, and returns it."""
    end = time.monotonic() + TIMEOUT
    while not (found := holds()):
        if time.monotonic() > end:
            sys.exit(f"error: {fault}")
        time.sleep(0.2)
    return found


def colours(png):
    """How many colours a picture has: 8 bits, RGB or RGBA, not interlaced."""
    at, data = 8, b""
    width, height, depth, kind = struct.unpack(">IIBB", png[16:26])
    assert depth == 8 and kind in (2, 6), "an unexpected kind of picture"
    while at < len(png):
        length, name = struct.unpack(">I4s", png[at : at + 8])
        data += png[at + 8 : at + 8 + length] if name == b"IDAT" else b""
        at += length + 12
    pixel = 3 if kind == 2 else 4
    raw, row, found = zlib.decompress(data), bytearray(width * pixel), set()
    stride = width * pixel
    for y in range(height):
        start = y * (stride + 1)
        row = unfilter(raw[start], bytearray(raw[start + 1 : start + 1 + stride]), row, pixel)
        found.update(zip(row[0::pixel], row[1::pixel], row[2::pixel]))
    return len(found)


def unfilter(kind, row, above, pixel):
    """Undoes the filter of a row of a PNG."""
    for i in range(len(row) if kind else 0):
        left = row[i - pixel] if i >= pixel else 0
        if kind == 1:
            row[i] = (row[i] + left) & 255
        elif kind == 2:
            row[i] = (row[i] + above[i]) & 255
        elif kind == 3:
            row[i] = (row[i] + (left + above[i]) // 2) & 255
        else:
            corner = above[i - pixel] if i >= pixel else 0
            estimate = left + above[i] - corner
            distances = [(abs(estimate - value), order, value) for order, value in enumerate((left, above[i], corner))]
            row[i] = (row[i] + min(distances)[2]) & 255
    return row


def link_of(page, commands):
    return page + "#script=" + ";".join(urllib.parse.quote(command) for command in commands)


def use(browser, page, picture):
    def figures_where(holds, fault):
        return wait(lambda: (found := browser.figures()) and holds(found) and found, fault)

    browser.open(link_of(page, SCRIPT[:-1]))
    drawn = figures_where(lambda found: found["commands"] == 3, "the script of the link is not run")
    assert drawn["triangles"] == 38, drawn
    browser.click(REFINE)
    refined = figures_where(lambda found: found["commands"] == 4, "a click on 'Refine' does nothing")
    assert refined["min-angle"] >= 30 and refined["triangles"] > drawn["triangles"], refined
    browser.click(COPY_LINK)
    wait(lambda: "Refine" in browser.run("return location.hash"), "'Copy link' does not change the address")
    time.sleep(1)  # The last frame is drawn.
    shot = browser.screenshot()
    pathlib.Path(picture).write_bytes(shot)
    shown = colours(shot)
    assert shown > 50, f"the page shows {shown} colours only"
    link = browser.run("return location.href")

    browser.open(link)
    again = figures_where(lambda found: found["commands"] == 4, "the copied link does not work")
    assert again == refined, f"the copied link leads to {again}, not to {refined}"

    browser.open(link_of(page, [*SCRIPT, "Save session.tri"]))
    saved = browser.downloads / "session.tri"
    wait(saved.exists, "'Save' downloads nothing")
    assert saved.read_text() == "".join(command + "\n" for command in SCRIPT), saved.read_text()

    browser.open(page)
    figures_where(lambda found: found["commands"] == 0, "the page is not empty without a script")
    browser.run(
        "const files = new DataTransfer(); files.items.add(new File([arguments[0]], 'three.poly'));"
        "const how = { dataTransfer: files, bubbles: true, cancelable: true };"
        "document.getElementById('studio').dispatchEvent(new DragEvent('drop', how));",
        DRAWING,
    )
    dropped = figures_where(lambda found: found["commands"] == 1, "a file that is dropped is not opened")
    assert dropped["vertices"] == 3, dropped
    return shown, refined


def main():
    folder, picture = sys.argv[1:]
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as temporary:
        browser = Browser(temporary)
        try:
            shown, refined = use(browser, serve(folder), picture)
        finally:
            browser.close()
    triangles = int(refined["triangles"])
    print(f"the studio in a browser: {triangles} triangles by a link and a click, {shown} colours; saved, dropped, linked")


if __name__ == "__main__":
    main()
