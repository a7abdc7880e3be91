"""Fetching: layouts of tiny archives, unsafe and damaged ones, downloads from a local server."""

from __future__ import annotations

import contextlib
import hashlib
import http.server
import io
import shutil
import stat
import subprocess
import sys
import tarfile
import tempfile
import threading
import unittest
import zipfile
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "datasets_scripts"
sys.path.insert(0, str(SCRIPTS))

import fetch  # noqa: E402
from public_sets.layouts import folder_name  # noqa: E402
from public_sets.table import SETS  # noqa: E402

MESH = b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
CLOSED_PORT = "http://127.0.0.1:9/"


def run(*arguments: object) -> tuple[int, str]:
    """Runs the script in this process; returns its exit code and all that it says."""
    said = io.StringIO()
    with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
        try:
            code = fetch.main([str(a) for a in arguments])
        except SystemExit as stop:
            code = int(stop.code or 0)
    return code, said.getvalue()


def write_zip(path: Path, entries: dict[str, bytes]) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in entries.items():
            archive.writestr(name, data)
    return path


def write_tar(path: Path, entries: dict[str, bytes]) -> Path:
    with tarfile.open(path, "w:gz") as archive:
        for name, data in entries.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(data)
            archive.addfile(entry, io.BytesIO(data))
    return path


class Server:
    """A web server of one folder that counts requests and understands ranges for resuming."""

    def __init__(self, folder: Path):
        self.ranges: list[str | None] = []
        self.cut_after: int | None = None
        outer = self

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_GET(self) -> None:
                path = folder / self.path.lstrip("/")
                wanted = self.headers.get("Range")
                outer.ranges.append(wanted)
                if not path.is_file():
                    self.send_error(404)
                    return
                data = path.read_bytes()
                tag = '"' + hashlib.md5(data).hexdigest() + '"'
                start = 0
                if wanted and self.headers.get("If-Range") == tag:
                    start = int(wanted.removeprefix("bytes=").removesuffix("-"))
                self.send_response(206 if start else 200)
                self.send_header("Content-Length", str(len(data) - start))
                self.send_header("ETag", tag)
                self.end_headers()
                end = len(data) if outer.cut_after is None else start + outer.cut_after
                self.wfile.write(data[start:end])

            def log_message(self, *_: object) -> None:
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.url = f"http://127.0.0.1:{self.server.server_address[1]}"
        serve = threading.Thread(target=self.server.serve_forever, args=(0.02,), daemon=True)
        serve.start()

    def close(self) -> None:
        self.server.shutdown()
        self.server.server_close()


class FetchCase(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        self.out = self.root / "out"

    def laid_out(self) -> list[str]:
        found = sorted(str(p.relative_to(self.out)) for p in self.out.rglob("*.*"))
        self.assertIn("SOURCE.txt", found)
        found.remove("SOURCE.txt")
        return found

    def assert_failed(self, code: int, said: str, *words: str) -> None:
        self.assertEqual(code, 1, said)
        for word in words:
            self.assertIn(word, said)
        self.assertEqual(said.count("\n"), 1, "one message")
        self.assertFalse(self.out.exists())

    def assert_nothing_left(self) -> None:
        self.assertFalse((self.root / ".out.fetch").exists())


class Layouts(FetchCase):
    def fetch_from(self, name: str, source: Path, *more: str) -> list[str]:
        code, said = run(name, self.out, "--from", source, *more)
        self.assertEqual(code, 0, said)
        self.assert_nothing_left()
        return self.laid_out()

    def test_coseg_from_a_folder_of_archives(self) -> None:
        store = self.root / "store"
        store.mkdir()
        for archive in SETS["coseg_large"].archives:
            junk = {"__MACOSX/shapes/._1.off": b"", "shapes/readme.txt": b"hello"}
            write_zip(store / archive.name, {"shapes/1.off": MESH, "shapes/2.OFF": MESH} | junk)
        found = self.fetch_from("coseg_large", store)
        labels = ("chairs", "tele_aliens", "vases")
        self.assertEqual(found, [f"{label}/{n}" for label in labels for n in ("1.off", "2.OFF")])

    def test_coseg_from_an_unpacked_folder_keeps_the_originals(self) -> None:
        for label in ("chairs", "vases"):
            folder = self.root / "mine" / label / "shapes"
            folder.mkdir(parents=True)
            (folder / "1.off").write_bytes(MESH)
        found = self.fetch_from("coseg_large", self.root / "mine")
        self.assertEqual(found, ["chairs/1.off", "vases/1.off"])
        self.assertTrue((self.root / "mine/chairs/shapes/1.off").exists())

    def test_coseg_with_an_archive_missing(self) -> None:
        store = self.root / "store"
        store.mkdir()
        write_zip(store / "vases.zip", {"1.off": MESH})
        code, said = run("coseg_large", self.out, "--from", store)
        self.assert_failed(code, said, "lacks tele_aliens.zip, chairs.zip")

    def princeton_archive(self, models: tuple[int, ...] = (7, 86, 812, 900)) -> Path:
        train = b"PSB 1\n4 3\n\naircraft 0 0\n\nbiplane aircraft 1\n7\n\nanimal 0 0\n\n"
        train += b"dog animal 2\n86\n812\n"
        base = "benchmark/classification/v1/base"
        entries = {
            f"{base}/train.cla": train,
            f"{base}/test.cla": b"PSB 1\r\n1 1\r\n\r\ndog 0 1\r\n900\r\n",
            "benchmark/classification/v1/coarse1/train.cla": b"PSB 1\n1 1\nall 0 1\n7\n",
        }
        for number in models:
            entries[f"benchmark/db/{number // 100}/m{number}/m{number}.off"] = MESH
        return write_zip(self.root / "psb_v1.zip", entries)

    def test_princeton(self) -> None:
        found = self.fetch_from("psb", self.princeton_archive())
        self.assertEqual(found, ["biplane/m7.off", "dog/m812.off", "dog/m86.off", "dog/m900.off"])

    def test_princeton_split(self) -> None:
        found = self.fetch_from("psb", self.princeton_archive(), "--split", "test")
        self.assertEqual(found, ["dog/m900.off"])

    def test_princeton_with_a_model_missing(self) -> None:
        code, said = run("psb", self.out, "--from", self.princeton_archive((7, 86, 812)))
        self.assert_failed(code, said, "model m900 (dog) is missing")

    def test_princeton_with_a_damaged_classification(self) -> None:
        for text in (b"", b"PSB 1\n2 9\nchair 0 3\n1\n", b"PSB 1\nmany 9\n", b"OFF 1 2 3"):
            with self.subTest(text):
                name = "benchmark/classification/v1/base/train.cla"
                archive = write_zip(self.root / "psb.zip", {name: text, "m1.off": MESH})
                code, said = run("psb", self.out, "--from", archive, "--split", "train")
                self.assert_failed(code, said, "train.cla")

    def modelnet_archive(self) -> Path:
        entries = {
            "ModelNet10/README.txt": b"read me",
            "ModelNet10/chair/train/chair_0001.off": MESH,
            "ModelNet10/chair/test/chair_0002.off": MESH,
            "ModelNet10/night_stand/test/night_stand_0001.off": MESH,
        }
        return write_zip(self.root / "ModelNet10.zip", entries)

    def test_modelnet(self) -> None:
        found = self.fetch_from("modelnet10", self.modelnet_archive())
        names = ["chair/chair_0001.off", "chair/chair_0002.off", "night_stand/night_stand_0001.off"]
        self.assertEqual(found, names)

    def test_modelnet_split(self) -> None:
        found = self.fetch_from("modelnet10", self.modelnet_archive(), "--split", "train")
        self.assertEqual(found, ["chair/chair_0001.off"])
        self.assertIn("split: train", (self.out / "SOURCE.txt").read_text())

    def test_segmentation_benchmark_by_numbers(self) -> None:
        models = {f"LabeledDB_new/{n}.off": MESH for n in (1, 21, 281, 400)}
        archive = write_tar(self.root / "db.tar.gz", models | {"LabeledDB_new/401.off": MESH})
        names = ["Armadillo/281.off", "Cup/21.off", "FourLeg/400.off", "Human/1.off"]
        self.assertEqual(self.fetch_from("lpsb", archive), names)

    @unittest.skipUnless(any(map(shutil.which, ("7z", "7zz", "7za"))), "the program 7z is not here")
    def test_seven_zip(self) -> None:
        program = next(filter(None, map(shutil.which, ("7z", "7zz", "7za"))))
        (self.root / "Cup").mkdir()
        (self.root / "Cup/21.off").write_bytes(MESH)
        archive = self.root / "labeledDb.7z"
        command = [program, "a", archive, "Cup"]
        subprocess.run(command, cwd=self.root, check=True, capture_output=True)
        self.assertEqual(self.fetch_from("lpsb", archive), ["Cup/21.off"])
        shutil.rmtree(self.out)
        archive.write_bytes(archive.read_bytes()[:-20])
        code, said = run("lpsb", self.out, "--from", archive)
        self.assert_failed(code, said, "damaged, cut off")

    def test_thingi10k(self) -> None:
        store = self.root / "store"
        store.mkdir()
        models = {f"Thingi10K/raw_meshes/{n}.stl": MESH for n in (11, 12, 13)}
        write_tar(store / "Thingi10K.tar.gz", models)
        (store / "input_summary.csv").write_text("ID, Thing ID\n11, 5\n12, 6\n13, 7\n")
        table = 'Thing ID, Category, Sub-category\n5, Art, "Signs & Logos"\n6, Tools,\n'
        (store / "contextual_data.csv").write_text(table)
        found = self.fetch_from("thingi10k", store)
        self.assertEqual(found, ["Signs_Logos/11.stl", "Tools/12.stl", "unknown/13.stl"])

    def test_by_folder(self) -> None:
        entries = {"ESB/Gears/a.stl": MESH, "ESB/Nuts/a.stl": MESH}
        archive = write_zip(self.root / "esb.zip", entries)
        self.assertEqual(self.fetch_from("esb", archive), ["Gears/a.stl", "Nuts/a.stl"])

    def test_shapenet(self) -> None:
        model = "ShapeNetCore.v2/02691156/1a04e3/models/model_normalized.obj"
        archive = write_zip(self.root / "s.zip", {model: MESH})
        self.assertEqual(self.fetch_from("shapenet", archive), ["02691156/1a04e3.obj"])

    def test_equal_names_in_a_class_are_kept_apart(self) -> None:
        entries = {"a/Gears/1.stl": MESH, "b/Gears/1.stl": MESH}
        archive = write_zip(self.root / "esb.zip", entries)
        self.assertEqual(self.fetch_from("esb", archive), ["Gears/1.stl", "Gears/1_2.stl"])

    def test_nothing_to_lay_out(self) -> None:
        archive = write_zip(self.root / "ModelNet10.zip", {"readme.txt": b"no models"})
        code, said = run("modelnet10", self.out, "--from", archive)
        self.assert_failed(code, said, "no models")
        self.assert_nothing_left()

    def test_labels_become_safe_folder_names(self) -> None:
        self.assertEqual(folder_name("../up/Signs & Logos"), "up_Signs_Logos")
        self.assertEqual(folder_name(".."), "unknown")


class Archives(FetchCase):
    def assert_refused(self, archive: Path, *words: str, options: tuple[str, ...] = ()) -> None:
        code, said = run("modelnet10", self.out, "--from", archive, *options)
        self.assert_failed(code, said, str(archive), *words)
        self.assert_nothing_left()

    def test_paths_that_leave_the_folder(self) -> None:
        for name in ("../evil.off", "a/../../evil.off", "/evil.off", "C:/evil.off", "..\\evil.off"):
            with self.subTest(name):
                archive = write_zip(self.root / "evil.zip", {"fine.off": MESH, name: MESH})
                self.assert_refused(archive, "not safe")
                archive = write_tar(self.root / "evil.tar.gz", {"fine.off": MESH, name: MESH})
                self.assert_refused(archive, "not safe")
        self.assertEqual(list(self.root.rglob("evil.off")), [])

    def test_links_and_devices(self) -> None:
        for kind in (tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.FIFOTYPE):
            path = self.root / "links.tar"
            with tarfile.open(path, "w") as archive:
                entry = tarfile.TarInfo("link")
                entry.type, entry.linkname = kind, "/etc/passwd"
                archive.addfile(entry)
            self.assert_refused(path, "link or a device")
        path = self.root / "links.zip"
        with zipfile.ZipFile(path, "w") as archive:
            entry = zipfile.ZipInfo("link")
            entry.external_attr = (stat.S_IFLNK | 0o777) << 16
            archive.writestr(entry, "/etc/passwd")
        self.assert_refused(path, "link or a device")

    def test_size_limit(self) -> None:
        archive = write_zip(self.root / "bomb.zip", {"chair/train/a.off": b"0" * 5_000_000})
        self.assertLess(archive.stat().st_size, 100_000)
        self.assert_refused(archive, "unpacks to more than", options=("--max-size", "0.001"))

    def test_damaged_archives(self) -> None:
        whole = write_zip(self.root / "whole.zip", {"chair/train/a.off": bytes(range(256)) * 99})
        data = whole.read_bytes()
        packed = write_tar(self.root / "whole.tar.gz", {"a.off": hashlib.sha256().digest() * 999})
        flipped = bytearray(data)
        flipped[60] ^= 0xFF
        cases = {
            "cut.zip": data[: len(data) // 2],
            "flipped.zip": bytes(flipped),
            "cut.tar.gz": packed.read_bytes()[:-30],
            "empty.zip": b"",
            "noise.zip": b"\x01\x02\x03" * 300,
        }
        for name, content in cases.items():
            with self.subTest(name):
                (self.root / name).write_bytes(content)
                self.assert_refused(self.root / name, "damaged, cut off")

    def test_web_page_instead_of_an_archive(self) -> None:
        page = self.root / "psb.zip"
        page.write_text("<!DOCTYPE html><html>moved</html>")
        self.assert_refused(page, "web page")


class Checksums(FetchCase):
    def setUp(self) -> None:
        super().setUp()
        self.archive = write_zip(self.root / "ModelNet10.zip", {"x/chair/train/a.off": MESH})
        self.sums = self.root / "sums.txt"

    def fetch_with(self, text: str) -> tuple[int, str]:
        self.sums.write_text(text)
        return run("modelnet10", self.out, "--from", self.archive, "--sums", self.sums)

    def test_match(self) -> None:
        for algorithm in ("md5", "sha1", "sha256"):
            checksum = hashlib.new(algorithm, self.archive.read_bytes()).hexdigest()
            self.assertEqual(self.fetch_with(f"{checksum} *ModelNet10.zip\n")[0], 0)
            shutil.rmtree(self.out)

    def test_mismatch(self) -> None:
        code, said = self.fetch_with("0" * 64 + "  ModelNet10.zip\n")
        self.assert_failed(code, said, "does not match its checksum")
        self.assert_nothing_left()

    def test_list_that_is_none(self) -> None:
        code, said = self.fetch_with("hello\n")
        self.assert_failed(code, said, "line 1")

    def test_source_is_recorded(self) -> None:
        self.assertEqual(run("modelnet10", self.out, "--from", self.archive)[0], 0)
        text = (self.out / "SOURCE.txt").read_text()
        self.assertIn(hashlib.sha256(self.archive.read_bytes()).hexdigest(), text)

    def test_checksums_of_the_table_are_well_formed(self) -> None:
        for chosen in SETS.values():
            for archive in chosen.archives:
                self.assertIn(len(archive.checksum), (0, 32, 40, 64))


class Downloads(FetchCase):
    def setUp(self) -> None:
        super().setUp()
        self.store = self.root / "store"
        self.store.mkdir()
        self.server = Server(self.store)
        self.addCleanup(self.server.close)
        entries = {"m/chair/train/a.off": MESH, "m/noise.bin": hashlib.sha512().digest() * 500}
        self.archive = write_zip(self.store / "ModelNet10.zip", entries)

    def test_download(self) -> None:
        code, said = run("modelnet10", self.out, "--mirror", self.server.url)
        self.assertEqual(code, 0, said)
        self.assertEqual(self.laid_out(), ["chair/a.off"])
        self.assert_nothing_left()

    def test_interrupted_download_is_continued(self) -> None:
        self.server.cut_after = 300
        code, said = run("modelnet10", self.out, "--mirror", self.server.url)
        self.assert_failed(code, said, "cannot reach 127.0.0.1", "300 of")
        self.server.cut_after = None
        self.assertEqual(run("modelnet10", self.out, "--mirror", self.server.url)[0], 0)
        self.assertEqual(self.server.ranges, [None, "bytes=300-"])
        self.assertEqual(self.laid_out(), ["chair/a.off"])

    def test_changed_file_is_downloaded_from_its_beginning(self) -> None:
        self.server.cut_after = 300
        run("modelnet10", self.out, "--mirror", self.server.url)
        self.server.cut_after = None
        write_zip(self.archive, {"m/table/train/b.off": MESH})
        self.assertEqual(run("modelnet10", self.out, "--mirror", self.server.url)[0], 0)
        self.assertEqual(self.laid_out(), ["table/b.off"])

    def test_finished_downloads_are_not_repeated(self) -> None:
        write_zip(self.store / "tele_aliens.zip", {"1.off": MESH})
        self.assertEqual(run("coseg_large", self.out, "--mirror", self.server.url)[0], 1)
        write_zip(self.store / "vases.zip", {"1.off": MESH})
        write_zip(self.store / "chairs.zip", {"1.off": MESH})
        self.assertEqual(run("coseg_large", self.out, "--mirror", self.server.url)[0], 0)
        self.assertEqual(len(self.server.ranges), 4)  # tele_aliens, vases twice, chairs

    def test_too_large(self) -> None:
        arguments = ("modelnet10", self.out, "--mirror", self.server.url, "--max-size", "1e-7")
        self.assert_failed(*run(*arguments), "too large")

    def test_address_that_does_not_have_it(self) -> None:
        code, said = run("modelnet40", self.out, "--mirror", self.server.url)
        self.assert_failed(code, said, "404", "download it by hand", "--from FILE")

    def test_unreachable_host(self) -> None:
        code, said = run("psb", self.out, "--mirror", CLOSED_PORT)
        self.assert_failed(code, said, "cannot reach 127.0.0.1:9: ", "refused")
        self.assertIn(f"download it by hand from {CLOSED_PORT}psb_v1.zip and run again with", said)
        self.assert_nothing_left()

    def test_unreachable_host_of_a_set_with_several_archives(self) -> None:
        code, said = run("coseg", self.out, "--mirror", CLOSED_PORT)
        self.assert_failed(code, said, "as candelabra.zip into one folder", "--from FOLDER")

    def test_sets_that_are_fetched_by_hand(self) -> None:
        for name in ("mcgill", "esb", "shapenet", "abc"):
            code, said = run(name, self.out)
            self.assert_failed(code, said, SETS[name].page, "--from")

    def test_address_that_is_not_of_the_web(self) -> None:
        code, said = run("psb", self.out, "--mirror", "file:///etc")
        self.assert_failed(code, said, "not a web address")


class Usage(FetchCase):
    def test_list_names_every_set_its_page_and_what_is_unverified(self) -> None:
        code, said = run("--list")
        self.assertEqual(code, 0)
        for chosen in SETS.values():
            self.assertIn(chosen.name, said)
            self.assertIn(chosen.page, said)
            self.assertIn(chosen.licence, said)
        self.assertIn("could not be tried", said)

    def test_wrong_usage(self) -> None:
        for arguments in (
            [],
            ["psb"],
            ["no_such_set", self.out],
            ["coseg", self.out, "--split", "train"],
            ["psb", self.out, "--max-size", "0"],
        ):
            with self.subTest(arguments):
                self.assertEqual(run(*arguments)[0], 2)

    def test_existing_results_are_not_touched(self) -> None:
        self.out.mkdir()
        (self.out / "mine.txt").write_text("mine")
        code, said = run("psb", self.out, "--from", self.root)
        self.assertEqual(code, 1)
        self.assertIn("not an empty folder", said)
        self.assertEqual((self.out / "mine.txt").read_text(), "mine")

    def test_source_that_does_not_exist(self) -> None:
        code, said = run("psb", self.out, "--from", self.root / "nowhere.zip")
        self.assert_failed(code, said, "does not exist")
        self.assert_nothing_left()


if __name__ == "__main__":
    unittest.main()
