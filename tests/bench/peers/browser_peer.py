"""A page of this folder in headless Chromium: serves its files, and reads the clock of all of Chromium's processes where the page asks."""
import http.server
import json
import os
import signal
import subprocess
import tempfile
import threading
from pathlib import Path

import processes

HERE = Path(__file__).parent
TYPES = {".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript", ".json": "application/json", ".wasm": "application/wasm"}
FLAGS = ["--headless=new", "--no-sandbox", "--no-first-run", "--disable-dev-shm-usage", "--use-gl=angle", "--use-angle=gl", "--ignore-gpu-blocklist"]


class Peer:
    def __init__(self, page, folder, modules, picture):
        self.page, self.folder, self.modules, self.picture = page, folder, modules, picture
        self.marks, self.memory, self.said, self.ended = {}, 0.0, {}, threading.Event()

    def file_of(self, name):
        if name == "/":
            return HERE / "page.html"
        first, _, rest = name[1:].partition("/")
        if first == "node_modules":
            found = self.modules / rest
            return found if found.is_file() else Path(str(found) + ".js")
        if first == "scene":
            return self.folder / rest
        return HERE / (self.page if name == "/page.js" else name[1:])

    def told(self, name, body):
        if name.startswith("/mark/"):
            self.marks[name[6:]] = processes.cpu_seconds(self.browser.pid)
            self.memory = max(self.memory, processes.resident_mib(self.browser.pid))
        elif name == "/picture":
            self.picture.write_bytes(body)
        else:
            self.said = {"failed": body.decode()} if name == "/failed" else json.loads(body)
            self.ended.set()

    def handler(self):
        peer = self

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_GET(self):
                file = peer.file_of(self.path.split("?")[0])
                found = file.is_file()
                data = file.read_bytes() if found else b""
                self.send_response(200 if found else 404)
                self.send_header("Content-Type", TYPES.get(file.suffix, "application/octet-stream"))
                self.send_header("Content-Length", str(len(data)))
                self.end_headers()
                self.wfile.write(data)

            def do_POST(self):
                peer.told(self.path, self.rfile.read(int(self.headers.get("Content-Length", 0))))
                self.send_response(200)
                self.send_header("Content-Length", "0")
                self.end_headers()

            def log_message(self, *_):
                pass

        return Handler

    def measure(self, timeout=600):
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), self.handler())
        threading.Thread(target=server.serve_forever, daemon=True).start()
        with tempfile.TemporaryDirectory(prefix="boxprobe-chromium-", ignore_cleanup_errors=True) as profile:
            command = ["chromium", *FLAGS, "--user-data-dir=" + profile, "http://127.0.0.1:%d/" % server.server_port]
            self.browser = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
            try:
                if not self.ended.wait(timeout):
                    raise RuntimeError("%s: nothing drawn in %d s; last mark: %s" % (self.page, timeout, list(self.marks)[-1:]))
            finally:
                os.killpg(self.browser.pid, signal.SIGKILL)
                self.browser.wait()
                server.shutdown()
        if "failed" in self.said:
            raise RuntimeError("%s: %s" % (self.page, self.said["failed"]))
        marks = self.marks
        frame = (marks["end"] - marks["warm"]) / self.said["frames"]
        return {"start": marks["picture"], "capture": marks["captured"] - marks["capture"] - frame * self.said["inCapture"], "frame": frame,
                "memory": self.memory, "renderer": self.said["renderer"]}
