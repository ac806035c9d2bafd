#!/usr/bin/python3
"""What a change of the mapping does to its values, of two plans.h5 of one dataset and config: the sum
of the frames' objectives and the same with what the movement costs, plans that only one of them can
execute, and frames above the best sequence known (by more than 1e-3 of their objective), which a
third file holds, or else is the better of the two.

  compare_values.py BEFORE.h5 AFTER.h5 [--best BEST.h5] [--worst N]

Exit 1 if the sum is more than 0.1 % higher, a plan is no longer executable, or more frames lie above
the best sequence."""
import argparse
import sys

import h5py
import numpy

EXCESS, MORE = 1e-3, 1e-3
COST = (3e-4, 1e-5, 3e-5)  # map.movement_cost, per 10 ms


def text(value):
    return value.decode() if isinstance(value, bytes) else value


def movement_cost(plan, limits):
    """Of (velocity / limit)^2 and so on, as stages/map/movement_cost.hpp says."""
    q, time = plan["mapped/position"][()], plan["goals/time"][()]
    step, cost = (time[-1] - time[0]) / (len(time) - 1), 0.0
    for order, (weight, limit) in enumerate(zip(COST, limits), 1):
        q = numpy.diff(q, axis=0)
        cost += weight * step / 0.01 * ((q / (limit * step**order)) ** 2).sum()
    return cost


def read(file):
    """{plan: (status, objectives, movement cost)}"""
    plans = {}
    with h5py.File(file) as f:
        limits = [f["robot"][name][()] for name in ("velocity", "acceleration", "jerk")]
        for name, demonstration in f["plans"].items():
            for index, plan in demonstration.items():
                mapped = "mapped/objective" in plan and len(plan["mapped/objective"]) > 0
                plans[f"{name}/{index}"] = (
                    text(plan.attrs["status"]), plan["mapped/objective"][()] if mapped else numpy.zeros(0),
                    movement_cost(plan, limits) if mapped else 0.0)
    return plans


def compare(before, after, best=None):
    """Figures of both, and rows of the plans."""
    assert list(before) == list(after), "not the same plans"
    rows, above = [], [0, 0]
    for name, (status, values, cost) in before.items():
        status_after, values_after, cost_after = after[name]
        known = [plan for plan in (before[name], after[name], best and best[name])
                 if plan and len(plan[1]) == len(values)]
        least = min(known, key=lambda plan: plan[1].sum())[1]
        if best and len(best[name][1]) == len(values):
            least = best[name][1]
        for k, own in enumerate((values, values_after)):
            above[k] += int((own > least + EXCESS).sum()) if len(own) == len(least) else 0
        rows.append((name, status, status_after, values.sum(), values_after.sum(), values.sum() + cost,
                     values_after.sum() + cost_after))
    runs = "executable"
    return {"frames": sum(len(values) for _, values, _ in after.values()),
            "sum": [sum(row[k] for row in rows) for k in (3, 4)],
            "with_cost": [sum(row[k] for row in rows) for k in (5, 6)],
            "executable": [sum(row[k] == runs for row in rows) for k in (1, 2)],
            "lost": [row[0] for row in rows if row[1] == runs and row[2] != runs],
            "won": [row[0] for row in rows if row[1] != runs and row[2] == runs],
            "above": above, "rows": rows}


def share(pair):
    return 100 * (pair[1] / pair[0] - 1)


def line(figures):
    return (f"objectives {figures['sum'][0]:9.3f} -> {figures['sum'][1]:9.3f} ({share(figures['sum']):+.3f} %), "
            f"with motion {share(figures['with_cost']):+.3f} %, executable {figures['executable'][0]} -> "
            f"{figures['executable'][1]} (lost {len(figures['lost'])}), above the best "
            f"{figures['above'][0]} -> {figures['above'][1]} of {figures['frames']}")


def worse(figures):
    return (figures["sum"][1] > (1 + MORE) * figures["sum"][0] or bool(figures["lost"]) or
            figures["above"][1] > figures["above"][0])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("--best")
    parser.add_argument("--worst", type=int, default=0, help="plans whose values changed most")
    arguments = parser.parse_args()
    figures = compare(read(arguments.before), read(arguments.after), read(arguments.best) if arguments.best else None)
    print(line(figures))
    for kind in ("lost", "won"):
        for name in figures[kind]:
            print(f"  {kind}: {name}")
    for row in sorted(figures["rows"], key=lambda row: -abs(row[6] - row[5]))[:arguments.worst]:
        print(f"  {row[0]}: {row[1]} -> {row[2]}, objectives {row[3]:.4f} -> {row[4]:.4f}, with motion "
              f"{row[5]:.4f} -> {row[6]:.4f}")
    return 1 if worse(figures) else 0


if __name__ == "__main__":
    sys.exit(main())
