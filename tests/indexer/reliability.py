"""What a database goes through, from outside: kills at random moments, several programs at once.

    reliability.py BIN_DIR kills [--models 300] [--kills 100] [--seed 1]
    reliability.py BIN_DIR crowd [--models 300] [--seconds 60] [--seed 1]

Both end with a database that must hold what an undisturbed run stores: all but ids and times.
BIN_DIR is a build folder. Exit code 0: as it should be.
"""

import argparse
import contextlib
import itertools
import pathlib
import random
import signal
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time

BALLS = "20"

# All of a database but what differs from run to run.
CONTENTS = """
SELECT s.path, s.content_hash, s.file_size, s.modified_ns, s.format, s.representation,
       s.statistics, s.scale, s.status, s.failure, s.reason, s.walk_is_defined,
       v.signature, v."values", b."values"
FROM shapes s LEFT JOIN vectors v ON v.shape_id = s.id LEFT JOIN balls b ON b.shape_id = s.id
ORDER BY s.path, v.signature
"""


class Programs:
    def __init__(self, build):
        self.build = pathlib.Path(build)

    def command(self, name, *arguments):
        room = name.removeprefix("mdbd-")
        folder = {"index": "indexer"}.get(room, room)
        return [str(self.build / folder / name), *map(str, arguments)]

    def index(self, database, *arguments):
        return self.command("mdbd-index", *arguments, "--db", database, "--balls", BALLS, "--quiet")


def write_models(folder, count, random_numbers):
    """Boxes whose corners are moved a little, so that no two are alike; one is damaged."""
    folder.mkdir(parents=True)
    faces = ["0 3 2 1", "4 5 6 7", "0 1 5 4", "1 2 6 5", "2 3 7 6", "3 0 4 7"]
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    for number in range(count):
        sides = [random_numbers.uniform(0.5, 2) for _ in range(3)]
        lines = ["OFF", "8 12 0"]
        for corner in corners:
            moved = [s * c + random_numbers.uniform(-0.1, 0.1) for s, c in zip(sides, corner)]
            lines.append(" ".join(map(repr, moved)))
        for a, b, c, d in (face.split() for face in faces):
            lines += [f"3 {a} {b} {c}", f"3 {a} {c} {d}"]
        (folder / f"{number}.off").write_text("\n".join(lines) + "\n")
    (folder / "damaged.off").write_text("OFF\n8 12 0\n")


def contents(database):
    with contextlib.closing(sqlite3.connect(database)) as connection:
        damage = connection.execute("PRAGMA integrity_check").fetchall()
        if damage != [("ok",)]:
            sys.exit(f"damaged: {damage}")
        recipe = connection.execute("SELECT name, value FROM recipe ORDER BY name").fetchall()
        return recipe, connection.execute(CONTENTS).fetchall()


def run_cleanly(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 3):  # 3: the damaged model
        sys.exit(f"{command}: exit code {done.returncode}: {done.stderr}")


def require_same(found, expected, story):
    if found != expected:
        sys.exit(f"after {story} the database differs from that of an undisturbed run: "
                 f"{len(found[1])} rows against {len(expected[1])}")
    print(f"{story}: the same contents as an undisturbed run, {len(expected[1])} rows")


def kills(programs, options, folder):
    """Some killed runs begin without a database, some continue, some compute everything again."""
    random_numbers = random.Random(options.seed)
    models, database = folder / "models", folder / "killed.db"
    write_models(models, options.models, random_numbers)
    began = time.monotonic()
    run_cleanly(programs.index(folder / "undisturbed.db", models))
    duration = time.monotonic() - began
    killed = finished = 0
    while killed < options.kills:
        if random_numbers.random() < 0.1:
            for file in folder.glob("killed.db*"):
                file.unlink()
        again = ["--force"] if random_numbers.random() < 0.7 else []
        run = subprocess.Popen(programs.index(database, models, *again),
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        # Half of the kills fall into the first instants, where the database is opened.
        scale = 1 if random_numbers.random() < 0.5 else 0.03
        time.sleep(random_numbers.uniform(0, duration * scale))
        run.kill()
        complaint = run.communicate()[1].decode()
        if run.returncode not in (-signal.SIGKILL, 0, 3):
            sys.exit(f"after {killed} kills a run failed by itself: {complaint}")
        killed += run.returncode == -signal.SIGKILL
        finished += run.returncode != -signal.SIGKILL
    run_cleanly(programs.index(database, models))
    require_same(contents(database), contents(folder / "undisturbed.db"),
                 f"{killed} killed runs and {finished} that were done before")


def crowd(programs, options, folder):
    """Two indexers that meet in one folder, four query loops and a backup loop."""
    models, database = folder / "models", folder / "shared.db"
    write_models(models / "both", options.models // 3, random.Random(options.seed))
    write_models(models / "first", options.models // 3, random.Random(options.seed + 1))
    write_models(models / "second", options.models // 3, random.Random(options.seed + 2))
    run_cleanly(programs.index(folder / "undisturbed.db", models))
    one = models / "both" / "0.off"
    run_cleanly(programs.index(database, one))
    backups = (folder / f"copy{number}.db" for number in itertools.count())
    query = ("mdbd-query", "--db", database, "--json")
    loops = [lambda: programs.index(database, models / "both", models / "first", "--force"),
             lambda: programs.index(database, models / "both", models / "second", "--force"),
             lambda: programs.command(*query, one),
             lambda: programs.command(*query, "--id", 1),
             lambda: programs.command(*query, "--id", 1, "--signature", "mdbd-fused"),
             lambda: programs.command(*query, "--duplicates"),
             lambda: programs.command("mdbd-db", "backup", next(backups), "--db", database)]
    end = time.monotonic() + options.seconds
    counts, errors = [0] * len(loops), []

    def repeat(number):
        while time.monotonic() < end and not errors:
            command = loops[number]()
            done = subprocess.run(command, capture_output=True, text=True)
            counts[number] += 1
            if done.returncode not in ((0, 3) if "mdbd-index" in command[0] else (0,)):
                errors.append(f"{command}: exit code {done.returncode}: {done.stderr}")
            for copy in folder.glob("copy*.db"):
                if "backup" in command:
                    contents(copy)
                    copy.unlink()

    threads = [threading.Thread(target=repeat, args=[number]) for number in range(len(loops))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if errors:
        sys.exit("\n".join(errors))
    run_cleanly(programs.index(database, models))
    require_same(contents(database), contents(folder / "undisturbed.db"),
                 f"{counts[0]} + {counts[1]} index runs, {sum(counts[2:6])} queries and "
                 f"{counts[6]} backups at once")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("what", choices=["kills", "crowd"])
    parser.add_argument("--models", type=int, default=300)
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        run = {"kills": kills, "crowd": crowd}[options.what]
        run(Programs(options.build), options, pathlib.Path(folder))


if __name__ == "__main__":
    main()
