"""Draws what runs gave over one of their numbers, with the true value."""

import ast
import csv
import math
import re

from rhegma.problem import Problem
from rhegma.summary import look_up, read_summary

from . import style
from .output_file import text_to
from .study_picture import group_style
from .style import plt

FUNCTIONS = {"exp": math.exp, "sqrt": math.sqrt, "tanh": math.tanh, "log": math.log}
OPERATIONS = {ast.Add: lambda a, b: a + b, ast.Sub: lambda a, b: a - b, ast.Mult: lambda a, b: a * b,
              ast.Div: lambda a, b: a / b, ast.Pow: lambda a, b: a**b}
PATH = re.compile(r"\[\[([^\[\]]+)\]\]|\[([^\[\]]+)\]")


def calculate(text, where, names):
    """The value of an expression of numbers, names, + - * / **, brackets and FUNCTIONS."""

    def value(node):
        if isinstance(node, ast.Expression):
            return value(node.body)
        if isinstance(node, ast.Constant) and type(node.value) in (int, float):
            return float(node.value)
        if isinstance(node, ast.Name) and node.id in names:
            return names[node.id]
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return -value(node.operand)
        if isinstance(node, ast.BinOp) and type(node.op) in OPERATIONS:
            return OPERATIONS[type(node.op)](value(node.left), value(node.right))
        if (isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in FUNCTIONS
                and len(node.args) == 1 and not node.keywords):
            return FUNCTIONS[node.func.id](value(node.args[0]))
        raise Problem(f"{where}: {text} has what is no number, at, [path], [[path]] or one of {', '.join(FUNCTIONS)}.")

    try:
        return value(ast.parse(text.strip(), mode="eval"))
    except SyntaxError:
        raise Problem(f"{where}: {text} is no expression.")
    except (ArithmeticError, ValueError) as error:
        raise Problem(f"{where}: {text} has no value ({error}).")


def number_of(text, what, outcome, twin_run, names):
    """An expression of names and of [path], of the run's summary, and [[path]], of the run it is compared with."""
    where = f"Sweep > {outcome.run.family} > {what}"
    names = dict(names)

    def name(match):
        twin = match.group(1) is not None
        if twin and twin_run is None:
            raise Problem(f"{where}: [[{match.group(1)}]] needs a family Compared With, whose run finished.")
        key = f"_{len(names)}"
        names[key] = look_up(read_summary((twin_run if twin else outcome).folder), (match.group(1) or match.group(2)).strip())
        return key

    return calculate(PATH.sub(name, text), where, names)


def drawn_at(outcome, twin_run):
    """Where the Value of a run is drawn."""
    run = outcome.run
    return number_of(run.drawn, "Drawn At", outcome, twin_run, {"at": run.at}) if run.drawn else run.at


def value_of(outcome, twin_run):
    """The Value of a run."""
    run = outcome.run
    names = {"at": run.at, "drawn": drawn_at(outcome, twin_run)}
    return number_of(run.value, "Value", outcome, twin_run, names)


def collect(outcomes):
    """[(outcome, where it is drawn, value, true value or None)] of the runs that finished and have a Value."""
    numbers, rows = {}, []
    for outcome in outcomes:
        own = numbers.setdefault(outcome.run.family, [])
        own.append(outcome)
    for outcome in outcomes:
        run = outcome.run
        if not (outcome.good and run.value):
            continue
        index = numbers[run.family].index(outcome)
        twin = None
        if run.twins is not None:
            if run.twins not in numbers:
                raise Problem(f"Sweep > {run.family} > Compared With: there is no family {run.twins} among those that run.")
            twins = numbers[run.twins]
            if index >= len(twins):
                raise Problem(f"Sweep > {run.family} > Compared With: {run.twins} has fewer runs.")
            twin = twins[index] if twins[index].good else None
            if twin is None:
                continue
        at = drawn_at(outcome, twin)
        true = calculate(run.true, f"Sweep > {run.family} > True", {"at": at}) if run.true else None
        rows.append((outcome, at, value_of(outcome, twin), true))
    return rows


def draw_values(study, outcomes, table, path):
    """Writes values.csv and values.png. Returns a line for each family: by how much it is off what is true."""
    rows = collect(outcomes)
    if not rows:
        return []
    with text_to(table) as file:
        writer = csv.writer(file)
        writer.writerow(["family", "at", "drawn at", "value", "true"])
        for outcome, at, value, true in rows:
            writer.writerow(
                [outcome.run.family, outcome.run.at, repr(at), repr(value), "" if true is None else repr(true)])
    styles = group_style([row[0].run for row in rows])
    figure, axes = plt.subplots(figsize=(7.2, 4.6), layout="constrained")
    lines = []
    for family in dict.fromkeys(row[0].run.family for row in rows):
        own = sorted((row[1:] for row in rows if row[0].run.family == family))
        colour, _, marker = styles[family]
        axes.plot([at for at, _, _ in own], [value for _, value, _ in own], color=colour, marker=marker, ms=6, ls="none",
                  label=family)
        text = next(row[0].run.true for row in rows if row[0].run.family == family)
        if text:
            low, high = own[0][0], own[-1][0]
            fine = [low + (high - low) * k / 200.0 for k in range(201)]
            axes.plot(fine, [calculate(text, f"Sweep > {family} > True", {"at": at}) for at in fine], color=colour, lw=1.2,
                      label=f"{family}, true")
            ratios = [value / true - 1.0 for _, value, true in own]
            mean = sum(ratios) / len(ratios)
            spread = math.sqrt(sum((r - mean) ** 2 for r in ratios) / max(len(ratios) - 1, 1))
            lines.append(f"{family}: {100.0 * mean:+.2f} % off what is true, standard deviation {100.0 * spread:.2f} %, "
                         f"{len(ratios)} runs")
    axes.set_ylim(bottom=0.0)
    axes.set_xlabel(study.at_label or "at")
    axes.set_ylabel(study.value_label or "value")
    axes.set_title(study.title, fontsize=12)
    axes.legend(loc="best")
    style.save(figure, path)
    return lines
