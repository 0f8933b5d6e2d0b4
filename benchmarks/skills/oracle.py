"""Let the oracle do generated tasks in many buildings, also from the middle of a mess.

Run: python benchmarks/skills/oracle.py DIR... [--tasks 10] [--seed 0] [--mess 12] [-o results.json]

For each building: how many drafts the oracle could not do (they are no tasks), then for each task whether its plan
does it again in a world loaded anew, and whether the oracle does it after `--mess` random skills. Folders in the
results file are not run again.
"""

import argparse
import json
import sys
import time
from pathlib import Path

import numpy as np

from mansion_msgs_py.task import SkillCall, Task
from mansion_tasks.tasks.generate import generate
from mansion_tasks.tasks.oracle import Oracle
from mansion_tasks.tasks.progress import ProgressTracker
from mansion_tasks.tasks.sandbox import SESSION, Sandbox
from mansion_tasks.tasks.solving import MAX_SKILLS, replay


def random_call(sandbox: Sandbox, rng: np.random.Generator) -> SkillCall:
    """Return a skill that may well make a mess: moves, doors, and things picked up and put anywhere."""
    world, robot = sandbox.world, sandbox.robot
    view = world.view(robot.floor)
    near = [state.id for state in world.objects.on_floor(robot.floor)]
    thing = near[int(rng.integers(len(near)))]
    mark = view.landmarks[int(rng.integers(len(view.landmarks)))].name
    door = list(view.doors)[int(rng.integers(len(view.doors)))]
    carried = [name for name in near if world.objects.kinds[name].pickupable] or near
    calls = [
        ("GoToLandmark", {"landmark": mark}),
        ("GoNearObject", {"object": carried[int(rng.integers(len(carried)))]}),
        ("GoNearObject", {"object": door}),
        ("CloseDoor", {}),
        ("OpenObject", {"object": thing}),
        ("Place", {"target": "floor"}),
        ("TakeStairs", {"direction": "Up"}),
    ]
    skill, arguments = calls[int(rng.integers(len(calls)))]
    return SkillCall(skill=skill, arguments=arguments)


def recovers(task: Task, sandbox: Sandbox, mess: int, rng: np.random.Generator) -> bool:
    """Whether the oracle does a task after random skills from its start."""
    sandbox.reset(task.start)
    tracker = ProgressTracker(task, sandbox.world, SESSION)
    for _ in range(mess):
        call = random_call(sandbox, rng)
        sandbox.run(call)
        tracker.observe()
        if call.skill == "GoNearObject" and rng.random() < 0.7:
            sandbox.run(SkillCall(skill="PickUp", arguments=call.arguments))
            tracker.observe()
    oracle = Oracle(task, sandbox.world, SESSION)
    for _ in range(MAX_SKILLS):
        if tracker.observe().success:
            return True
        step = oracle.next_call(tracker.seen)
        if step is None:
            return False
        oracle.note(step, sandbox.run(step))
    return False


def measure(folder: Path, count: int, seed: int, mess: int) -> dict[str, object]:
    """Return the figures of one building."""
    begin = time.process_time()
    unsolved: list[Task] = []
    tasks = generate(Sandbox(folder), count, seed, unsolved=unsolved.append)
    sandbox = Sandbox(folder)
    rng = np.random.default_rng(seed)
    replayed = [replay(task, task.oracle, sandbox).success for task in tasks]
    recovered = [recovers(task, sandbox, mess, rng) for task in tasks]
    return {
        "floors": len(sandbox.building.floors),
        "tasks": len(tasks),
        "kinds": [task.id.rsplit("_s", 1)[0] for task in tasks],
        "unsolved_drafts": [draft.instruction for draft in unsolved],
        "replayed": sum(replayed),
        "recovered": sum(recovered),
        "stuck": [task.id for task, fine in zip(tasks, recovered) if not fine],
        "skills": sum(len(task.oracle) for task in tasks),
        "seconds": round(time.process_time() - begin, 1),
    }


def main() -> int:
    """Run, and print one line for each building and the sums; exit status 1 when a plan failed."""
    parser = argparse.ArgumentParser()
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--tasks", type=int, default=10)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--mess", type=int, default=12)
    parser.add_argument("-o", "--output", type=Path)
    options = parser.parse_args()
    results: dict[str, dict[str, object]] = {}
    if options.output is not None and options.output.exists():
        results = json.loads(options.output.read_text())
    for folder in options.folders:
        if folder.name not in results:
            figures = measure(folder, options.tasks, options.seed, options.mess)
            results[folder.name] = figures
            if options.output is not None:
                options.output.write_text(json.dumps(results, indent=1))
        row = results[folder.name]
        print(
            f"{folder.name}: {row['floors']} floors, {row['tasks']} tasks, plans {row['replayed']}, "
            f"after a mess {row['recovered']}, drafts not solved {len(row['unsolved_drafts'])}, {row['seconds']} s",  # type: ignore[arg-type]
            flush=True,
        )
    rows = [results[folder.name] for folder in options.folders]
    sums = {k: sum(int(r[k]) for r in rows) for k in ("tasks", "replayed", "recovered", "skills")}  # type: ignore[call-overload]
    drafts = sum(len(r["unsolved_drafts"]) for r in rows)  # type: ignore[arg-type, misc]
    print(
        f"{len(rows)} buildings, {sums['tasks']} tasks: plans {sums['replayed']}, after a mess {sums['recovered']}, "
        f"{sums['skills'] / max(1, sums['tasks']):.1f} skills a plan, {drafts} drafts not solved"
    )
    return 0 if sums["replayed"] == sums["tasks"] else 1


if __name__ == "__main__":
    sys.exit(main())
