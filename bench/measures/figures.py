"""Figures that are kept: what was measured, of what size, how often, by which command. A list of plain dictionaries, so that
it can be written as JSON and compared with another one."""


def figure(group, name, unit, runs, **more):
    """`runs`: the values of all runs, of which the least counts. More: size, command, note."""
    return {"group": group, "name": name, "unit": unit, "runs": [float(f"{run:.6g}") for run in runs], **more}


def of_taken(group, name, result, **more):
    """Two figures, seconds and MiB, of what measure.taken() gives."""
    return [figure(group, name, "s", result.runs, command=result.command, **more),
            figure(group, name, "MiB", [result.peak_mib], command=result.command, **more)]


def key(one):
    return one["group"], one["name"], one["unit"]


def least(one):
    return min(one["runs"])
