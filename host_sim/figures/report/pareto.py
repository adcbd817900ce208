"""Which choices are worth having: no other is as exact and as cheap."""


def front(points):
    """For each (error, work) whether no other is at most as bad in both and better in one."""
    return [not any(other[0] <= point[0] and other[1] <= point[1] and other != point for other in points) for point in points]


def mark(rows, group):
    """Sets `pareto` of every row: on the front of its group (a function of the row)."""
    groups = {}
    for row in rows:
        groups.setdefault(group(row), []).append(row)
    for members in groups.values():
        for row, on_front in zip(members, front([(row["error"], row["work"]) for row in members])):
            row["pareto"] = on_front
